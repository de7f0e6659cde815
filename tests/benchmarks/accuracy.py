"""How well `tol` is kept: measured error over tol on clouds of random trajectories.

Ensembles (Runge-Kutta) are measured against the solver of single trajectories (collocation), and
the solver against ensembles, each at 1e-13, far below what is offered: two methods that share
nothing but the model. An error is relative to the state's largest magnitude on its trajectory.

    python tests/benchmarks/accuracy.py > tests/benchmarks/results/accuracy.md
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

import groundloop as gl
from groundloop.ensemble_plan import plan, smallest_kernel
from groundloop.generated import kernels
from groundloop.names import signature

COUNT, TIMES, REFERENCE = 50_000, 101, 1e-13
TOLERANCES = (1e-4, 1e-6, 1e-9)
BODY, PATH = ("v", "r", "y", "theta"), ("v", "r", "X", "Y", "psi")
LARGE_SLIP = {"B1": 0.7587, "C1": 1.187, "D1": 1.017, "E1": 0.387}
HEAVY = {"m": 2500.0, "Izz": 9000.0, "b": 6.0, "Fz": 2500 * 9.81 / 2, **LARGE_SLIP}
STIFF = {"Izz": 900.0, "D1": 9.0, "b": 5.0, "CL_gamma": 9.0}


class Cloud(NamedTuple):
    """Random trajectories: fastest v0 and r0, duration, changes of the aircraft, states."""

    name: str
    v0: float
    r0: float
    t: float
    changes: dict[str, float]
    states: tuple[str, ...] = BODY


CLOUDS = (
    Cloud("like the benchmark's: v0 to 2 m/s, 5 s", 2.0, 0.0, 5.0, {}),
    Cloud("v0 to 8 m/s, r0 to 0.5 rad/s, 5 s", 8.0, 0.5, 5.0, {}),
    Cloud("the same with the large-slip tire", 8.0, 0.5, 5.0, LARGE_SLIP),
    Cloud("large-slip, v0 to 15 m/s, r0 to 1.5 rad/s, 10 s", 15.0, 1.5, 10.0, LARGE_SLIP),
    Cloud("heavier and mostly unstable, 8 s", 5.0, 0.3, 8.0, HEAVY),
    Cloud("light and stiff, v0 to 3 m/s, 4 s", 3.0, 1.0, 4.0, STIFF),
    Cloud("path over the ground, v0 to 4 m/s, 5 s", 4.0, 0.2, 5.0, LARGE_SLIP, PATH),
)


def draw(cloud: Cloud, seed: int) -> tuple[gl.Aircraft, dict[str, np.ndarray]]:
    """Aircraft and initial states."""
    rng = np.random.default_rng(seed)
    a, Ct, u = rng.uniform((-1, 0, 15), (1, 8000, 40), (COUNT, 3)).T
    plane = gl.Aircraft.load("brott").replace(**{"b": 3.92176, "C5": -8.81055e-6} | cloud.changes)
    start = {"v0": rng.uniform(0.01, cloud.v0, COUNT), "r0": rng.uniform(-1, 1, COUNT) * cloud.r0}
    return plane.replace(a=a, Ct=Ct, speed=u), start


class Found(NamedTuple):
    """Rows at the times, whether each trajectory is sound, its estimated error, steps."""

    rows: np.ndarray
    sound: np.ndarray
    estimate: np.ndarray
    steps: np.ndarray


def by_ensemble(cloud: Cloud, plane: gl.Aircraft, start: dict[str, Any], tol: float) -> Found:
    at = np.linspace(0.0, cloud.t, TIMES)
    planned = plan(plane, cloud.t, "nonlinear", at, cloud.states, 1e-6, COUNT, start)
    task = dataclasses.replace(planned.task(range(COUNT)), tol=tol)
    done = kernels.integrate(task, threads=2)
    rows = np.stack([done.samples[s] for s in cloud.states], axis=1)
    return Found(rows, done.status == 0, done.estimate, done.steps)


def by_ensemble_end(cloud: Cloud, plane: gl.Aircraft, start: dict[str, Any], tol: float) -> Found:
    planned = plan(plane, cloud.t, "nonlinear", None, cloud.states, 1e-6, COUNT, start)
    done = kernels.integrate(dataclasses.replace(planned.task(range(COUNT)), tol=tol), threads=2)
    rows = np.stack([done.final[s] for s in cloud.states], axis=1)[:, :, None]
    return Found(rows, done.status == 0, done.estimate, done.steps)


def by_solver(cloud: Cloud, plane: gl.Aircraft, start: dict[str, Any], tol: float) -> Found:
    kernel = smallest_kernel("nonlinear", cloud.states)
    at = np.linspace(0.0, cloud.t, TIMES)
    solve = kernels.Stepper(kernel, at, tol, cloud.states)
    states, u = signature("nonlinear").states, np.zeros(1)
    x0 = np.zeros((COUNT, len(states)))
    for name, value in start.items():
        x0[:, states.index(name[:-1])] = value
    parameters = np.ascontiguousarray(plane.parameters("nonlinear").T)
    rows = np.empty((COUNT, len(cloud.states), TIMES))
    sound, estimate, steps = np.empty(COUNT, bool), np.empty(COUNT), np.empty(COUNT)
    for i in range(COUNT):
        rows[i] = solve(x0[i], u, parameters[i])
        sound[i], estimate[i], steps[i] = solve.status == "ok", solve.estimate, solve.steps
    return Found(rows, sound, estimate, steps)


WAYS = {
    "ensemble, final state": (by_ensemble_end, by_solver),
    "ensemble, 101 times": (by_ensemble, by_solver),
    "solver, 101 times": (by_solver, by_ensemble),
}


def lines(way: str, seed: int) -> Iterator[str]:
    """Rows of the table."""
    measured, reference = WAYS[way]
    for number, cloud in enumerate(CLOUDS):
        plane, start = draw(cloud, seed + number)
        exact = reference(cloud, plane, start, REFERENCE)
        scale = np.maximum(np.abs(exact.rows).max(axis=2), 1e-6)
        for tol in TOLERANCES:
            found = measured(cloud, plane, start, tol)
            last = exact.rows[:, :, -found.rows.shape[2] :]
            error = (np.abs(found.rows - last).max(axis=2) / scale).max(axis=1) / tol
            known = np.isfinite(scale).all(axis=1) & (exact.estimate < 0.1 * tol)
            e = error[found.sound & known]
            worst = f"{np.median(e):.1g} | {np.quantile(e, 0.999):.1g} | {e.max():.2g}"
            doubts = f"{np.sum(e > 1)} | {np.sum(~found.sound)} | {np.sum(~known)}"
            yield f"| {cloud.name} | {tol:.0e} | {found.steps.mean():.1f} | {worst} | {doubts} |"


def main() -> None:
    print(f"# Error over `tol`, {COUNT:,} random trajectories of each kind\n")
    head = "trajectories | tol | steps | median | 99.9 % | largest | above tol | not ok | unknown"
    for number, way in enumerate(WAYS):
        print(f"## {way}\n\n| {head} |\n|{'---|' * 9}", flush=True)
        for line in lines(way, 1000 * (number + 7)):
            print(line, flush=True)
        print()


if __name__ == "__main__":
    main()
