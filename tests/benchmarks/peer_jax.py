"""diffrax (JAX): Dopri8 and Tsit5 under vmap."""

from __future__ import annotations

import sys
from importlib.metadata import version
from pathlib import Path

import common
import diffrax
import jax
import jax.numpy as jnp
import numpy as np

jax.config.update("jax_enable_x64", True)
FOLDER = Path(sys.argv[1])


class Arrays:
    atan, sin = jnp.arctan, jnp.sin


def f(t, x, p):
    return jnp.stack(common.rates(x, p[0], p[1], p[2], Arrays))


def solve(solver, times):
    """(p, v0, tol) -> states at the times, or at the end."""

    def run(p, v0, tol):
        found = diffrax.diffeqsolve(
            diffrax.ODETerm(f), solver, 0.0, common.T_END, None,
            jnp.zeros(4).at[0].set(v0), p,
            saveat=diffrax.SaveAt(t1=True) if times is None else diffrax.SaveAt(ts=times),
            stepsize_controller=diffrax.PIDController(rtol=tol, atol=1e-3 * tol),
            max_steps=20_000,
        )  # fmt: skip
        return found.ys

    return run


def main() -> None:
    bench = common.Bench(FOLDER, "diffrax", f"{version('diffrax')}, JAX {jax.__version__}")
    s = common.SINGLE
    p1, v1 = jnp.array([s["a"], s["Ct"], s["u"]]), s["v0"]
    a, Ct, u, v0 = common.draw(10_000)
    P = jnp.stack([a, Ct, u], axis=1)
    for name, solver in (("Dopri8", diffrax.Dopri8()), ("Tsit5", diffrax.Tsit5())):
        one = jax.jit(solve(solver, jnp.array(common.TIMES)))
        many = jax.jit(jax.vmap(solve(solver, None), (0, 0, None)))

        def single(tol: float, one=one) -> np.ndarray:
            return np.asarray(one(p1, v1, tol).block_until_ready())

        def ensemble(tol: float, many=many) -> np.ndarray:
            return np.asarray(many(P, v0, tol).block_until_ready()[:, 0])

        for target in common.TARGETS:
            if found := common.tolerance(
                single, lambda x: common.single_error(FOLDER, x), target, coarsest=1e-4
            ):
                bench.row(
                    "S", target, name, lambda t=found[0], f=single: f(t), found[1],
                    f"rtol {found[0]:.1e}", inner=10,
                )  # fmt: skip
            if found := common.tolerance(
                ensemble, lambda x: common.ensemble_error(FOLDER, x), target, coarsest=1e-5
            ):
                bench.row(
                    "E10000", target, f"{name}, vmap", lambda t=found[0], f=ensemble: f(t),
                    found[1], f"rtol {found[0]:.1e}", repeats=7,
                )  # fmt: skip


if __name__ == "__main__":
    main()
