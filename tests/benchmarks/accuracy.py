"""How well `tol` is kept: measured error over tol on clouds of random trajectories.

Ensembles (Runge-Kutta) are measured against the solver of single trajectories (collocation), and
the solver against ensembles, each at 1e-13, far below what is offered: two methods that share
nothing but the model. An error is relative to the state's largest magnitude on its trajectory.

It writes the table `results/accuracy.md` and the picture `docs/images/accuracy.png`.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

import groundroll as gr
from groundroll.ensemble_plan import plan
from groundroll.model.models import as_model
from groundroll.motion import lanes

COUNT, TIMES, REFERENCE = 50_000, 101, 1e-13
TOLERANCES = (1e-4, 1e-6, 1e-9)
BODY, PATH = ("v", "r", "y", "theta"), ("v", "r", "X", "Y", "psi")
LARGE_SLIP = {"B1": 0.7587, "C1": 1.187, "D1": 1.017, "E1": 0.387}
HEAVY = {"m": 2500.0, "Izz": 9000.0, "b": 6.0, "Fz": 2500 * 9.81 / 2, **LARGE_SLIP}
STIFF = {"Izz": 900.0, "D1": 9.0, "b": 5.0, "CL_gamma": 9.0}


HERE = Path(__file__).resolve().parent


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


def draw(cloud: Cloud, seed: int) -> tuple[gr.Aircraft, dict[str, np.ndarray]]:
    """Aircraft and initial states."""
    rng = np.random.default_rng(seed)
    a, Ct, u = rng.uniform((-1, 0, 15), (1, 8000, 40), (COUNT, 3)).T
    plane = gr.Aircraft.load("brott").replace(**{"b": 3.92176, "C5": -8.81055e-6} | cloud.changes)
    start = {"v0": rng.uniform(0.01, cloud.v0, COUNT), "r0": rng.uniform(-1, 1, COUNT) * cloud.r0}
    return plane.replace(a=a, Ct=Ct, speed=u), start


class Found(NamedTuple):
    """Rows at the times, whether each trajectory is sound, its estimated error, steps."""

    rows: np.ndarray
    sound: np.ndarray
    estimate: np.ndarray
    steps: np.ndarray


def by_ensemble(cloud: Cloud, plane: gr.Aircraft, start: dict[str, Any], tol: float) -> Found:
    at = np.linspace(0.0, cloud.t, TIMES)
    planned = plan(plane, cloud.t, "nonlinear", at, cloud.states, 1e-6, COUNT, start)
    task = dataclasses.replace(planned.task(range(COUNT)), tol=tol)
    done = lanes.integrate(task, threads=2)
    rows = np.stack([done.samples[s] for s in cloud.states], axis=1)
    return Found(rows, done.status == 0, done.estimate, done.steps)


def by_ensemble_end(cloud: Cloud, plane: gr.Aircraft, start: dict[str, Any], tol: float) -> Found:
    planned = plan(plane, cloud.t, "nonlinear", None, cloud.states, 1e-6, COUNT, start)
    done = lanes.integrate(dataclasses.replace(planned.task(range(COUNT)), tol=tol), threads=2)
    rows = np.stack([done.final[s] for s in cloud.states], axis=1)[:, :, None]
    return Found(rows, done.status == 0, done.estimate, done.steps)


def by_solver(cloud: Cloud, plane: gr.Aircraft, start: dict[str, Any], tol: float) -> Found:
    model, at = as_model("nonlinear"), np.linspace(0.0, cloud.t, TIMES)
    solve = lanes.Stepper(model, at, tol, cloud.states)
    states, u = model.states, np.zeros(1)
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


class Row(NamedTuple):
    """Errors over tol of one cloud, and how many were left out and why."""

    way: str
    cloud: str
    tol: float
    steps: float
    errors: np.ndarray
    unsound: int
    unknown: int

    def __str__(self) -> str:
        e = self.errors
        worst = f"{np.median(e):.1g} | {np.quantile(e, 0.999):.1g} | {e.max():.2g}"
        counts = f"{np.sum(e > 1)} | {self.unsound} | {self.unknown}"
        return f"| {self.cloud} | {self.tol:.0e} | {self.steps:.1f} | {worst} | {counts} |"


def study(way: str, seed: int) -> Iterator[Row]:
    """Every cloud at every tolerance."""
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
            errors = error[found.sound & known]
            counts = int(np.sum(~found.sound)), int(np.sum(~known))
            yield Row(way, cloud.name, tol, float(found.steps.mean()), errors, *counts)


def picture(rows: list[Row], path: Path) -> None:
    """Share of the trajectories whose error is larger, for the final states of ensembles."""
    import matplotlib as mpl

    mpl.use("Agg")
    from matplotlib import pyplot

    from groundroll.view.plots import INK, style

    share = np.geomspace(1.0 / COUNT, 1.0, 300)
    with style():
        figure, axes = pyplot.subplots(1, 2, figsize=(8.4, 3.6), sharex=True, sharey=True)
        for ax, tol in zip(axes, (1e-6, 1e-9), strict=True):
            shown = [row for row in rows if row.way == next(iter(WAYS)) and row.tol == tol]
            for row, line in zip(shown, [*"------", "--"], strict=True):
                ax.loglog(np.quantile(row.errors, 1.0 - share), share, line, label=row.cloud)
            ax.set_xlim(1e-5, 3.0)
            ax.axvline(1.0, color=INK, linewidth=0.9)
            ax.set_title(f"tol = {tol:g}")
            ax.set_xlabel("error / tol")
        axes[0].set_ylabel("share of trajectories with more")
        figure.legend(*axes[0].get_legend_handles_labels(), loc="outside lower center", ncols=2)
        figure.savefig(path, dpi=110)


def main() -> None:
    head = "trajectories | tol | steps | median | 99.9 % | largest | above tol | not ok | unknown"
    lines, rows = [f"# Error over `tol`, {COUNT:,} random trajectories of each kind", ""], []
    for number, way in enumerate(WAYS):
        lines += [f"## {way}", "", f"| {head} |", "|---" * 9 + "|"]
        for row in study(way, 1000 * (number + 7)):
            print(row, flush=True)
            lines.append(str(row))
            rows.append(row)
        lines.append("")
    (HERE / "results" / "accuracy.md").write_text("\n".join(lines))
    picture(rows, HERE.parents[1] / "docs" / "images" / "accuracy.png")


if __name__ == "__main__":
    main()
