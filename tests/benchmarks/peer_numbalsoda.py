"""numbalsoda: LSODA and DOP853 behind numba."""

from __future__ import annotations

import math
import sys
from importlib.metadata import version
from pathlib import Path

import common
import numba
import numpy as np
from numbalsoda import dop853, lsoda, lsoda_sig

FOLDER = Path(sys.argv[1])
C = common.CONSTANTS
MASS, IZZ, B, RHO = (C[k] for k in ("MASS", "IZZ", "ARM_B", "RHO"))
AP, CL, FZ = (C[k] for k in ("AP", "CL_GAMMA", "FZ"))
B3, C3, B5, C5, B1, C1, D1, E1 = (C[k] for k in ("B3", "C3", "B5", "C5", "B1", "C1", "D1", "E1"))


@numba.cfunc(lsoda_sig)
def f(t, x, out, p):
    mu = B5 + C5 * FZ
    slip = (B3 + C3 * FZ) * ((x[0] + p[0] * x[1]) / p[2]) / mu
    psi = (1 - E1) * slip + E1 / B1 * math.atan(B1 * slip)
    main = 2 * D1 * math.sin(C1 * math.atan(B1 * psi)) * mu * FZ
    side = (0.5 * RHO * p[2] * p[2] * AP * CL + p[1]) * math.atan((x[0] - B * x[1]) / p[2])
    out[0] = (-main - side) / MASS - p[2] * x[1]
    out[1] = (-p[0] * main + B * side) / IZZ
    out[2] = x[0]
    out[3] = x[1]


POINTER = f.address


def ensemble(solver):
    @numba.njit
    def run(a, Ct, u, v0, tol, out):
        for k in range(len(a)):
            x, p, ends = np.zeros(4), np.empty(3), np.empty(2)
            x[0], p[0], p[1], p[2], ends[0], ends[1] = v0[k], a[k], Ct[k], u[k], 0.0, 5.0
            found, _ = solver(POINTER, x, ends, p, tol, 1e-3 * tol, 100000)
            out[k] = found[1]

    return run


def main() -> None:
    name = f"{version('numbalsoda')}, numba {numba.__version__}"
    bench = common.Bench(FOLDER, "numbalsoda", name)
    s = common.SINGLE
    x0, p = np.array([s["v0"], 0.0, 0.0, 0.0]), np.array([s["a"], s["Ct"], s["u"]])
    draw, out = common.draw(10_000), np.empty((10_000, 4))
    for label, solver in (("LSODA", lsoda), ("DOP853", dop853)):
        many = ensemble(solver)

        def single(tol: float, solver=solver) -> np.ndarray:
            return solver(POINTER, x0, common.TIMES, p, tol, 1e-3 * tol, 100000)[0]

        def all_of_them(tol: float, many=many) -> np.ndarray:
            many(*draw, tol, out)
            return out

        for target in common.TARGETS:
            if found := common.tolerance(
                single, lambda x: common.single_error(FOLDER, x), target, coarsest=1e-4
            ):
                bench.row(
                    "S", target, label, lambda t=found[0], g=single: g(t), found[1],
                    f"rtol {found[0]:.1e}", inner=50,
                )  # fmt: skip
            if found := common.tolerance(
                all_of_them, lambda x: common.ensemble_error(FOLDER, x), target, coarsest=1e-5
            ):
                bench.row(
                    "E10000", target, label, lambda t=found[0], g=all_of_them: g(t), found[1],
                    f"rtol {found[0]:.1e}", repeats=7,
                )  # fmt: skip


if __name__ == "__main__":
    main()
