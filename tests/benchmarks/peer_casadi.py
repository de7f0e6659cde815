"""CasADi's cvodes (SUNDIALS) in its virtual machine."""

from __future__ import annotations

import sys
from pathlib import Path

import casadi as ca
import common
import numpy as np

FOLDER = Path(sys.argv[1])


def integrator(tol: float, times: list[float]) -> ca.Function:
    x, p = ca.SX.sym("x", 4), ca.SX.sym("p", 3)
    rates = common.rates(ca.vertsplit(x), p[0], p[1], p[2], ca)
    ode = {"x": x, "p": p, "ode": ca.vertcat(*rates)}
    options = {"reltol": tol, "abstol": 1e-3 * tol, "linear_multistep_method": "adams",
               "nonlinear_solver_iteration": "functional", "max_num_steps": 100_000}  # fmt: skip
    return ca.integrator("F", "cvodes", ode, 0.0, times, options)


def main() -> None:
    bench = common.Bench(FOLDER, "CasADi", ca.CasadiMeta.version())
    s, few = common.SINGLE, 100
    p1, x1 = [s["a"], s["Ct"], s["u"]], [s["v0"], 0, 0, 0]
    a, Ct, u, v0 = (column[:few] for column in common.draw(10_000))
    P, X = np.stack([a, Ct, u]), np.concatenate([v0[None], np.zeros((3, few))])
    times = common.TIMES[1:].tolist()
    for target in common.TARGETS:

        def single(F: ca.Function) -> np.ndarray:
            return np.concatenate([[x1], np.array(F(x0=x1, p=p1)["xf"]).T])

        def ensemble(F: ca.Function) -> np.ndarray:
            return np.array(F(x0=X, p=P)["xf"]).T

        if found := common.tolerance(
            lambda tol: single(integrator(tol, times)),
            lambda x: common.single_error(FOLDER, x),
            target,
            coarsest=1e-5,
        ):
            F = integrator(found[0], times)
            bench.row("S", target, "cvodes", lambda F=F: single(F), found[1],
                      f"reltol {found[0]:.1e}", inner=5)  # fmt: skip
        if found := common.tolerance(
            lambda tol: ensemble(integrator(tol, [5.0])),
            lambda x: common.ensemble_error(FOLDER, x, np.arange(few)),
            target,
            coarsest=1e-5,
        ):
            F = integrator(found[0], [5.0])
            bench.row(
                "E10000", target, "cvodes, map", lambda F=F: ensemble(F), found[1],
                f"reltol {found[0]:.1e}, 100 of them", share=few / 10_000, repeats=7,
            )  # fmt: skip


if __name__ == "__main__":
    main()
