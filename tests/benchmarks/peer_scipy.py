"""SciPy's solve_ivp with Python and numba right-hand sides, one by one and all stacked."""

from __future__ import annotations

import sys
from pathlib import Path

import common
import numba
import numpy as np
import scipy
from scipy.integrate import solve_ivp

FOLDER = Path(sys.argv[1])
C = common.CONSTANTS
MASS, IZZ, B, RHO = (C[k] for k in ("MASS", "IZZ", "ARM_B", "RHO"))
AP, CL, FZ = (C[k] for k in ("AP", "CL_GAMMA", "FZ"))
B3, C3, B5, C5, B1, C1, D1, E1 = (C[k] for k in ("B3", "C3", "B5", "C5", "B1", "C1", "D1", "E1"))


def plain(t: float, x: np.ndarray, a: float, Ct: float, u: float) -> list[float]:
    return common.rates(x, a, Ct, u)


@numba.njit(cache=False)
def fast(t, x, a, Ct, u):
    mu = B5 + C5 * FZ
    slip = (B3 + C3 * FZ) * ((x[0] + a * x[1]) / u) / mu
    psi = (1 - E1) * slip + E1 / B1 * np.arctan(B1 * slip)
    main = 2 * D1 * np.sin(C1 * np.arctan(B1 * psi)) * mu * FZ
    side = (0.5 * RHO * u * u * AP * CL + Ct) * np.arctan((x[0] - B * x[1]) / u)
    out = np.empty(4)
    out[0] = (-main - side) / MASS - u * x[1]
    out[1] = (-a * main + B * side) / IZZ
    out[2] = x[0]
    out[3] = x[1]
    return out


def solve(f, method: str, tol: float, s: dict[str, float], times) -> np.ndarray:
    run = solve_ivp(
        f, (0.0, common.T_END), [s["v0"], 0.0, 0.0, 0.0], method, times, rtol=tol,
        atol=1e-3 * tol, args=(s["a"], s["Ct"], s["u"]),
    )  # fmt: skip
    return run.y.T


def single(bench: common.Bench) -> None:
    for method in ("RK45", "DOP853", "LSODA"):
        for target in common.TARGETS:
            found = common.tolerance(
                lambda tol, m=method: solve(fast, m, tol, common.SINGLE, common.TIMES),
                lambda x: common.single_error(FOLDER, x),
                target,
            )
            if not found:
                continue
            for name, f in (("numba", fast), ("Python", plain)):
                bench.row(
                    "S", target, f"{method}, {name}",
                    lambda f=f, m=method, t=found[0]: solve(f, m, t, common.SINGLE, common.TIMES),
                    found[1], f"rtol {found[0]:.1e}", inner=3,
                )  # fmt: skip


def ensembles(bench: common.Bench) -> None:
    few = 40
    a, Ct, u, v0 = common.draw(10_000)

    def one_by_one(method: str, tol: float) -> np.ndarray:
        rows = [
            solve(fast, method, tol, {"a": a[k], "Ct": Ct[k], "u": u[k], "v0": v0[k]}, None)[-1]
            for k in range(few)
        ]
        return np.array(rows)

    def stacked(tol: float) -> np.ndarray:
        n = len(v0)
        x0 = np.concatenate([v0, np.zeros(3 * n)])

        class Arrays:
            atan, sin = np.arctan, np.sin

        def f(t: float, x: np.ndarray) -> np.ndarray:
            return np.concatenate(common.rates(x.reshape(4, n), a, Ct, u, Arrays))

        run = solve_ivp(f, (0.0, common.T_END), x0, "DOP853", rtol=tol, atol=1e-3 * tol)
        return run.y[:, -1].reshape(4, n).T

    for target in common.TARGETS:
        for method in ("RK45", "DOP853", "LSODA"):
            found = common.tolerance(
                lambda tol, m=method: one_by_one(m, tol),
                lambda x: common.ensemble_error(FOLDER, x, np.arange(few)),
                target,
            )
            if found:
                bench.row(
                    "E10000", target, f"{method}, numba, in a loop",
                    lambda m=method, t=found[0]: one_by_one(m, t), found[1],
                    f"rtol {found[0]:.1e}, 40 of them", share=few / 10_000, repeats=7,
                )  # fmt: skip
        found = common.tolerance(stacked, lambda x: common.ensemble_error(FOLDER, x), target)
        if found:
            bench.row(
                "E10000", target, "DOP853, all in one system", lambda t=found[0]: stacked(t),
                found[1], f"rtol {found[0]:.1e}", repeats=7,
            )  # fmt: skip


if __name__ == "__main__":
    name = f"{scipy.__version__}, numba {numba.__version__}"
    for job in (single, ensembles):
        job(common.Bench(FOLDER, "SciPy", name))
