"""Compiled integrators on any time grid."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import casadi as ca
import numpy as np

from . import generated
from .arrays import FloatArray, finite
from .errors import GroundloopError, unknown
from .names import signature

METHODS = ("rk45", "rk4")

#: Longest stretch of time given to one call of the compiled integrator, s. The adaptive one keeps
#: a tape of its steps for the adjoint; this keeps it short.
_LONGEST = {"rk45": 1.0, "rk4": 0.01}


def integrator(
    tire: str = "nonlinear",
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
    tire : str
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
        order of ``generated.MODELS[tire]``; xf : (7, N) states at the times `t`.

    Raises
    ------
    GroundloopError
        For an unknown tire or method, or times that do not increase from above zero.
    """
    names = signature(tire)
    if method not in METHODS:
        raise unknown("method", method, METHODS)
    times = _grid(t)
    longest = _LONGEST[method] if step is None else float(finite("step", step))
    if longest <= 0:
        raise GroundloopError(f"step must be positive, not {longest}")
    intervals = np.diff(times, prepend=0.0)
    pieces = [max(1, math.ceil(h / longest - 1e-9)) for h in intervals]
    lengths = np.repeat(intervals / pieces, pieces)

    advance = generated.load(f"{tire}_{method}")
    x0 = ca.MX.sym("x0", len(names.states))
    u = ca.MX.sym("u", len(names.inputs), len(times) if piecewise else 1)
    p = ca.MX.sym("p", len(names.parameters))
    count = len(lengths)
    inputs = ca.horzcat(*_repeat_columns(u, pieces)) if piecewise else ca.repmat(u, 1, count)
    states = advance.mapaccum(f"{tire}_{method}_path", count)(
        x0, inputs, ca.repmat(p, 1, count), ca.DM(lengths).T
    )
    ends = (np.cumsum(pieces) - 1).tolist()
    return ca.Function(
        f"{tire}_{method}_integrator",
        [x0, u, p],
        [states[:, ends]],
        ["x0", "u", "p"],
        ["xf"],
    )


def _repeat_columns(u: Any, counts: Sequence[int]) -> list[Any]:
    return [ca.repmat(u[:, k], 1, count) for k, count in enumerate(counts)]


def _grid(t: Any) -> FloatArray:
    times = np.atleast_1d(finite("t", t))
    if times.ndim != 1 or times.size == 0:
        raise GroundloopError(
            f"t must be a number or a list of numbers, not of shape {times.shape}"
        )
    if times[0] <= 0 or (np.diff(times) <= 0).any():
        raise GroundloopError("t must be positive and increasing; the start, t = 0, is left out")
    return times
