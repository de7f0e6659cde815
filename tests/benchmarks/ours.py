"""groundroll itself."""

from __future__ import annotations

import sys
from importlib.metadata import version
from pathlib import Path

import common
import numpy as np

import groundroll as gr

FOLDER = Path(sys.argv[1])
TARGETS = common.TARGETS
NAMES = ("v", "r", "y", "theta")


def aircraft(**changes: object) -> gr.Aircraft:
    c = common.CONSTANTS
    own = {"b": c["ARM_B"], "C5": c["C5"], "Fz": c["FZ"], "C_alpha": c["C_ALPHA"]}
    return gr.Aircraft.load("brott").replace(**own, **changes)


def ensembles(bench: common.Bench) -> None:
    plane = aircraft()
    for n in (10_000, 100_000):
        a, Ct, u, v0 = common.draw(n)

        def run(tol: float, threads: int = 1, values=(a, Ct, u, v0)) -> gr.Ensemble:
            a, Ct, u, v0 = values
            return gr.ensemble(
                plane, 5.0, names=NAMES, tol=tol, threads=threads, a=a, Ct=Ct, speed=u, v0=v0
            )

        def error(ens: gr.Ensemble) -> float:
            states = np.stack([ens[name] for name in NAMES], axis=1)
            return common.ensemble_error(FOLDER, states)

        for target in TARGETS:
            best = common.tolerance(run, error, target, 1e-11)
            for name, tol in (("tol = error", target), ("tuned", best[0] if best else target)):
                found = error(run(tol))
                for threads in (1, 2):
                    bench.row(
                        f"E{n}", target, name, lambda t=tol, k=threads: run(t, k), found,
                        f"tol {tol:.1e}", threads=threads,
                    )  # fmt: skip


def single(bench: common.Bench) -> None:
    s = common.SINGLE
    p = aircraft(a=s["a"], Ct=s["Ct"], u=s["u"]).parameters("nonlinear")
    x0, u = np.zeros(7), np.zeros(1)
    x0[0] = s["v0"]

    def error(x: np.ndarray) -> float:
        return common.single_error(FOLDER, x.T)

    def run(tol: float) -> np.ndarray:
        return gr.solver(t=common.TIMES, names=NAMES, tol=tol)(x0, u, p)

    for target in TARGETS:
        best = common.tolerance(run, error, target, 1e-11)
        for name, tol in (("tol = error", target), ("tuned", best[0] if best else target)):
            solve = gr.solver(t=common.TIMES, names=NAMES, tol=tol)
            found = error(solve(x0, u, p))
            bench.row(
                "S", target, name, lambda f=solve: f(x0, u, p), found, f"tol {tol:.1e}", inner=300
            )


def linear(bench: common.Bench) -> None:
    a, Ct, u = common.linear_draw(1_000_000)
    plain, plane = aircraft(), aircraft(a=a, Ct=Ct, u=u)
    out = gr.sweep(plane)
    exact = bench.limit.linear(1_000_000)()
    error = float(np.max(np.abs(out["re_1"] - exact[0])) / np.abs(exact[0]).max())

    def into(kept: gr.Sweep | None, threads: int) -> gr.Sweep:
        return gr.sweep(plane, out=kept, threads=threads)

    def checked(kept: gr.Sweep | None, threads: int) -> gr.Sweep:
        return gr.sweep(plain, out=kept, threads=threads, a=a, Ct=Ct, speed=u)

    for job, kept in (("L", out), ("N", None)):
        for how, run in (("aircraft made before", into), ("values checked and copied", checked)):
            for threads in (1, 2):
                bench.row(
                    job, TARGETS[0], "sweep", lambda f=run, o=kept, k=threads: f(o, k), error, how,
                    threads=threads, repeats=21,
                )  # fmt: skip
    few = 20_000
    A = gr.linearize(aircraft(a=a[:few], Ct=Ct[:few], u=u[:few]), "linear").A
    bench.tool, bench.version = "NumPy eigvals", np.__version__
    bench.row(
        "L", TARGETS[0], "batched", lambda: np.linalg.eigvals(A), None, share=few / 1e6, repeats=7
    )


if __name__ == "__main__":
    for job in (ensembles, single, linear):
        job(common.Bench(FOLDER, "groundroll", version("groundroll")))
