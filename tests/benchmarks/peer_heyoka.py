"""heyoka: one integrator, and batches in a Python loop (faster here than its own ensembles)."""

from __future__ import annotations

import sys
from pathlib import Path

import common
import heyoka as hy
import numpy as np

FOLDER = Path(sys.argv[1])


def system() -> list:
    v, r, y, q = hy.make_vars("v", "r", "y", "theta")
    a, Ct, u = hy.par[0], hy.par[1], hy.par[2]
    return list(zip((v, r, y, q), common.rates([v, r], a, Ct, u, hy), strict=True))


def tuned() -> list:
    """The same with everything that is constant in time folded into parameters."""
    v, r, y, q = hy.make_vars("v", "r", "y", "theta")
    p, c = hy.par, common.CONSTANTS
    x = p[0] * v + p[1] * r
    s = hy.sin(c["C1"] * hy.atan((1 - c["E1"]) * x + c["E1"] * hy.atan(x)))
    g = hy.atan(p[2] * v - p[3] * r)
    rates = (-p[4] * s - p[5] * g - p[7] * r, -p[6] * s + p[8] * g, v, r)
    return list(zip((v, r, y, q), rates, strict=True))


def folded(a, Ct, u) -> np.ndarray:
    c = common.CONSTANTS
    mu = c["B5"] + c["C5"] * c["FZ"]
    slope = c["B1"] * (c["B3"] + c["C3"] * c["FZ"]) / (u * mu)
    force = 2 * c["D1"] * mu * c["FZ"]
    tail = 0.5 * c["RHO"] * u * u * c["AP"] * c["CL_GAMMA"] + Ct
    rows = (slope, slope * a, 1 / u, c["ARM_B"] / u, force / c["MASS"] + 0 * u, tail / c["MASS"],
            a * force / c["IZZ"], u, c["ARM_B"] * tail / c["IZZ"])  # fmt: skip
    return np.array(rows)


def loop(integrator, parameters: np.ndarray, v0: np.ndarray, batch: int) -> np.ndarray:
    n = len(v0) // batch
    out = np.empty((n, batch, 4))
    rows, starts = parameters.reshape(-1, n, batch), v0.reshape(n, batch)
    state, given = integrator.state, integrator.pars
    for k in range(n):
        state[0], state[1:], given[:] = starts[k], 0.0, rows[:, k]
        integrator.set_time(0.0)
        integrator.propagate_until(common.T_END)
        out[k] = state.T
    return out.reshape(-1, 4)


def single(bench: common.Bench) -> None:
    s = common.SINGLE
    columns = [np.array(s[k]) for k in ("a", "Ct", "u")]
    for name, equations, given in (
        ("scalar", system(), [float(c) for c in columns]),
        ("scalar, folded", tuned(), folded(*columns).tolist()),
    ):
        for target in common.TARGETS:

            def made(tol: float, equations=equations, given=given):
                return hy.taylor_adaptive(equations, [s["v0"], 0, 0, 0], pars=given, tol=tol)

            def run(ta) -> np.ndarray:
                ta.time = 0.0
                ta.state[:] = (s["v0"], 0, 0, 0)
                return ta.propagate_grid(common.TIMES)[-1]

            found = common.tolerance(
                lambda tol, made=made: run(made(tol)),
                lambda x: common.single_error(FOLDER, x),
                target,
            )
            if found:
                ta = made(found[0])
                bench.row(
                    "S", target, name, lambda ta=ta: run(ta), found[1], f"tol {found[0]:.1e}",
                    inner=300,
                )  # fmt: skip


def ensembles(bench: common.Bench) -> None:
    for n, batches in ((10_000, (4, 8, 16)), (100_000, (8,))):
        a, Ct, u, v0 = common.draw(n)
        given = folded(a, Ct, u)
        for batch in batches:
            for target in common.TARGETS:

                def made(tol: float, batch=batch):
                    start, pars = np.zeros((4, batch)), np.zeros((9, batch))
                    return hy.taylor_adaptive_batch(tuned(), start, pars=pars, tol=tol)

                found = common.tolerance(
                    lambda tol, made=made, b=batch, given=given, v0=v0: loop(
                        made(tol), given, v0, b
                    ),
                    lambda x: common.ensemble_error(FOLDER, x),
                    target,
                    finest=3e-16,  # it goes as far as arithmetic does
                    coarsest=1e-5,
                )
                if found:
                    ta = made(found[0])
                    bench.row(
                        f"E{n}", target, f"batch {batch}, folded",
                        lambda ta=ta, b=batch, given=given, v0=v0: loop(ta, given, v0, b), found[1],
                        f"tol {found[0]:.1e}", repeats=7,
                    )  # fmt: skip


if __name__ == "__main__":
    for job in (single, ensembles):
        job(common.Bench(FOLDER, "heyoka", hy.__version__))
