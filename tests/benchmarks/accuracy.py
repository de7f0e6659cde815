"""How well `tol` is kept: measured error over tol on clouds of random trajectories.

Ensembles (Runge-Kutta) are measured against the solver of single trajectories (collocation), and
the solver against ensembles, each at 1e-13, far below what is offered: two methods that share
nothing but the model. An error is relative to the state's largest magnitude on its trajectory.

It writes the table `results/accuracy.md` and the picture `docs/images/accuracy.png`.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

import groundroll as gr
from groundroll.aircraft.values import given
from groundroll.model.models import as_model
from groundroll.motion import lanes
from groundroll.motion.plan import Plan, planned

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from clouds import CLOUDS, Cloud  # noqa: E402

TIMES, REFERENCE = 101, 1e-13
TOLERANCES = (1e-4, 1e-6, 1e-9)


class Found(NamedTuple):
    """Rows at the times, whether each trajectory is sound, its estimated error, steps."""

    rows: np.ndarray
    sound: np.ndarray
    estimate: np.ndarray
    steps: np.ndarray


def plan(cloud: Cloud, plane: gr.Aircraft, start: dict[str, Any], at: np.ndarray) -> Plan:
    model = as_model("nonlinear")
    return planned(given(plane, model, start, "accuracy"), model, cloud.t, 1e-6, at)


def times(cloud: Cloud) -> np.ndarray:
    return np.linspace(0.0, cloud.t, TIMES)


def by_ensemble(cloud: Cloud, plane: gr.Aircraft, start: dict[str, Any], tol: float) -> Found:
    made = replace(plan(cloud, plane, start, times(cloud)), sampled=cloud.states)
    done = lanes.integrate(replace(made.task(range(made.count)), tol=tol), threads=2)
    rows = np.stack([done.samples[s] for s in cloud.states], axis=1)
    return Found(rows, done.status == 0, done.estimate, done.steps)


def by_ensemble_end(cloud: Cloud, plane: gr.Aircraft, start: dict[str, Any], tol: float) -> Found:
    made = replace(plan(cloud, plane, start, np.empty(0)), final=cloud.states)
    done = lanes.integrate(replace(made.task(range(made.count)), tol=tol), threads=2)
    rows = np.stack([done.final[s] for s in cloud.states], axis=1)[:, :, None]
    return Found(rows, done.status == 0, done.estimate, done.steps)


def by_solver(cloud: Cloud, plane: gr.Aircraft, start: dict[str, Any], tol: float) -> Found:
    model, count = as_model("nonlinear"), start["v0"].size
    solve = lanes.Stepper(model, times(cloud), tol, cloud.states)
    states, u = model.states, np.zeros(1)
    x0 = np.zeros((count, len(states)))
    for name, value in start.items():
        x0[:, states.index(name[:-1])] = value
    parameters = np.ascontiguousarray(plane.parameters("nonlinear").T)
    rows = np.empty((count, len(cloud.states), TIMES))
    sound, estimate, steps = np.empty(count, bool), np.empty(count), np.empty(count)
    for i in range(count):
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


def study(way: str, seed: int, count: int) -> Iterator[Row]:
    """Every cloud at every tolerance."""
    measured, reference = WAYS[way]
    for number, (name, cloud) in enumerate(CLOUDS.items()):
        plane, start = cloud.drawn(np.random.default_rng(seed + number), count)
        exact = reference(cloud, plane, start, REFERENCE)
        scale = np.maximum(np.abs(exact.rows).max(axis=2), 1e-6)
        for tol in TOLERANCES:
            found = measured(cloud, plane, start, tol)
            last = exact.rows[:, :, -found.rows.shape[2] :]
            error = (np.abs(found.rows - last).max(axis=2) / scale).max(axis=1) / tol
            known = np.isfinite(scale).all(axis=1) & (exact.estimate < 0.1 * tol)
            errors = error[found.sound & known]
            counts = int(np.sum(~found.sound)), int(np.sum(~known))
            yield Row(way, name, tol, float(found.steps.mean()), errors, *counts)


def picture(rows: list[Row], path: Path) -> None:
    """Share of the trajectories whose error is larger, for the final states of ensembles."""
    import matplotlib as mpl

    mpl.use("Agg")
    from matplotlib import pyplot

    from groundroll.view.plots import INK, style

    count = max(row.errors.size for row in rows)
    share = np.geomspace(1.0 / count, 1.0, 300)
    with style():
        figure, axes = pyplot.subplots(1, 2, figsize=(8.4, 4.2), sharex=True, sharey=True)
        for ax, tol in zip(axes, (1e-6, 1e-9), strict=True):
            shown = [row for row in rows if row.way == next(iter(WAYS)) and row.tol == tol]
            for row, line in zip(shown, ["-"] * 6 + ["--"] * 5, strict=True):
                ax.loglog(np.quantile(row.errors, 1.0 - share), share, line, label=row.cloud)
            ax.set_xlim(1e-5, 3.0)
            ax.axvline(1.0, color=INK, linewidth=0.9)
            ax.set_title(f"tol = {tol:g}")
            ax.set_xlabel("error / tol")
        axes[0].set_ylabel("share of trajectories with more")
        figure.legend(*axes[0].get_legend_handles_labels(), loc="outside lower center", ncols=2)
        figure.savefig(path, dpi=110)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=50_000, help="trajectories of each kind")
    parser.add_argument("--results", type=Path, default=HERE / "results" / "accuracy.md")
    parser.add_argument(
        "--picture", type=Path, default=HERE.parents[1] / "docs/images/accuracy.png"
    )
    asked = parser.parse_args()
    head = "trajectories | tol | steps | median | 99.9 % | largest | above tol | not ok | unknown"
    lines, rows = [f"# Error over `tol`, {asked.count:,} random trajectories of each kind", ""], []
    for number, way in enumerate(WAYS):
        lines += [f"## {way}", "", f"| {head} |", "|---" * 9 + "|"]
        for row in study(way, 1000 * (number + 27), asked.count):
            print(row, flush=True)
            lines.append(str(row))
            rows.append(row)
        lines.append("")
    asked.results.write_text("\n".join(lines))
    picture(rows, asked.picture)


if __name__ == "__main__":
    main()
