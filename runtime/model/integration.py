"""Compiled integrators on any time grid."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import casadi as ca
import numpy as np

from groundroll.base.arrays import FloatArray, finite, single
from groundroll.base.errors import GroundrollError, one_of
from groundroll.base.memory import check_memory

from .models import ModelLike, as_model

METHODS = ("rk45", "rk4")

#: Longest stretch of time given to one call of the compiled integrator, s. The adaptive one keeps
#: a tape of its steps for the adjoint; this keeps it short.
_LONGEST = {"rk45": 1.0, "rk4": 0.01}

#: Bytes that CasADi takes for each call of the compiled integrator in a path, as measured.
_CALL_BYTES = 8_000


def integrator(
    model: ModelLike = "nonlinear",
    method: str = "rk45",
    t: Sequence[float] | FloatArray | float = 5.0,
    *,
    step: float | None = None,
    piecewise: bool = False,
) -> ca.Function:
    """A compiled integrator as a CasADi function (x0, u, p) -> xf.

    The function can be called with numbers or put into any CasADi expression: it has exact
    forward, adjoint and second derivatives, compiled too. Neither parameters nor the time grid
    are part of the compiled code.

    Parameters
    ----------
    model : str or Model
        ``"linear"`` or ``"nonlinear"``.
    method : str
        ``"rk45"``: adaptive steps with an error below about 1e-9 of each state's scale;
        ``"rk4"``: classical Runge-Kutta with fixed steps.
    t : float or sequence of float
        Output times, s, positive and increasing; the start is at 0.
    step : float, optional
        Longest step of ``rk4``, s (default 0.01); for ``rk45`` the longest stretch between
        restarts of the step control (default 1).
    piecewise : bool
        If true, u has one column for each output interval instead of one for all.

    Returns
    -------
    casadi.Function
        x0 : (7, 1) initial state; u : (1, 1) or (1, N) inputs; p : (n, 1) parameters, in the
        order of ``generated.PACKS[model]``; xf : (7, N) states at the times `t`. CasADi's own
        rules hold for its arguments: a scalar stands for every element, and what is left out is
        zero. `simulate` is the checked way in.

    Raises
    ------
    GroundrollError
        For an unknown model or method, or times that do not increase from above zero.
    """
    as_model(model)
    one_of("method", method, METHODS)
    longest = _LONGEST[method] if step is None else single("step", step, "s")
    if longest <= 0:
        raise GroundrollError(f"step must be positive, not {longest}")
    return _integrator(model, method, tuple(_grid(t).tolist()), longest, bool(piecewise))


@lru_cache(maxsize=32)
def _integrator(
    model: ModelLike, method: str, times: tuple[float, ...], longest: float, piecewise: bool
) -> ca.Function:
    names = as_model(model)
    intervals = np.diff(times, prepend=0.0)
    pieces = [max(1, math.ceil(h / longest - 1e-9)) for h in intervals]
    _check_room(sum(pieces))
    lengths = np.repeat(intervals / pieces, pieces)

    advance = as_model(model).function(method)
    x0 = ca.MX.sym("x0", len(names.states))
    u = ca.MX.sym("u", len(names.inputs), len(times) if piecewise else 1)
    p = ca.MX.sym("p", len(names.parameters))
    count = len(lengths)
    inputs = u[:, _repeat(pieces)] if piecewise else ca.repmat(u, 1, count)
    states = advance.mapaccum(f"{model}_{method}_path", count)(
        x0, inputs, ca.repmat(p, 1, count), ca.DM(lengths).T
    )
    ends = (np.cumsum(pieces) - 1).tolist()
    return ca.Function(
        f"{model}_{method}_integrator",
        [x0, u, p],
        [states[:, ends]],
        ["x0", "u", "p"],
        ["xf"],
    )


def _check_room(calls: int) -> None:
    check_memory(_CALL_BYTES * calls, "the calls of the integrator for a run so long")


def _repeat(counts: Sequence[int]) -> list[int]:
    return [k for k, count in enumerate(counts) for _ in range(count)]


def _grid(t: Any) -> FloatArray:
    times = np.atleast_1d(finite("t", t, "s"))
    if times.ndim != 1 or times.size == 0:
        raise GroundrollError(
            f"t must be a number or a list of numbers, not of shape {times.shape}"
        )
    if times[0] <= 0 or (np.diff(times) <= 0).any():
        raise GroundrollError("t must be positive and increasing; the start, t = 0, is left out")
    return times
