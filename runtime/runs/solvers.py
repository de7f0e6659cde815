"""One trajectory, again and again: arrays in, arrays out, in tens of microseconds."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial
from typing import Any

import numpy as np

from groundroll.base.arrays import FloatArray, finite
from groundroll.base.errors import GroundrollError
from groundroll.generated import Pack
from groundroll.model.models import ModelLike, as_model
from groundroll.model.names import listed, symbol
from groundroll.motion import lanes
from groundroll.motion.lanes import Stepper, Task
from groundroll.motion.plan import tolerance
from groundroll.motion.virtual import integrate_in_vm

Solver = Callable[[FloatArray, FloatArray, FloatArray], FloatArray]


def solver(
    model: ModelLike = "nonlinear",
    t: Any = 5.0,
    *,
    names: Iterable[str] = ("v", "r", "y", "theta"),
    tol: float = 1e-6,
) -> Solver:
    """A function (x0, u, p) -> states over time, for loops in Python that call it often.

    `groundroll.simulate` checks and names everything; this is a kernel for single trajectories
    with nothing around it, which sweeps towards the collocation solution. Arguments are not
    checked.

    Parameters
    ----------
    model : str or Model
        ``"linear"`` or ``"nonlinear"``.
    t : float or sequence of float
        Increasing output times, s, from 0 on; the last ends the integration.
    names : iterable of str
        States (and outputs) that are wanted, one row each.
    tol : float
        As for `groundroll.ensemble`.

    Returns
    -------
    callable
        x0, u, p : initial states, inputs and parameters in the order of
        ``generated.PACKS[model]``; returns an array of shape (names, times), NaN where the
        motion grows without bound. It can be pickled, and called by several threads at once.

    Raises
    ------
    GroundrollError
        For unknown names, times that do not increase, or `tol` outside what is offered.
    """
    model = as_model(model)
    times = np.atleast_1d(finite("t", t, "s"))
    if (
        times.ndim != 1
        or times.size == 0
        or times[0] < 0
        or times[-1] <= 0
        or (np.diff(times) <= 0).any()
    ):
        raise GroundrollError("t must be a positive number or increasing times from 0 on")
    allowed = (*model.states, *model.outputs)
    wanted = tuple(
        dict.fromkeys(symbol(n, "name", allowed, "names") for n in listed("names", names))
    )
    accuracy = tolerance(tol)
    if lanes.can_compile(model):
        return Stepper(model, times, accuracy, wanted)
    return partial(_solve_in_vm, model, times, accuracy, wanted)


def _solve_in_vm(
    model: Pack,
    times: FloatArray,
    tol: float,
    names: tuple[str, ...],
    x0: FloatArray,
    u: FloatArray,
    p: FloatArray,
) -> FloatArray:
    def named(symbols: tuple[str, ...], values: FloatArray) -> dict[str, FloatArray]:
        return {s: np.atleast_1d(value) for s, value in zip(symbols, values, strict=True)}

    task = Task(
        model=model,
        x0=named(model.states, x0),
        inputs=named(model.inputs, u),
        parameters=named(model.parameters, p),
        count=1,
        t=float(times[-1]),
        tol=tol,
        times=times,
        sampled=names,
    )
    samples = integrate_in_vm(task).samples
    return np.concatenate([samples[name] for name in names])
