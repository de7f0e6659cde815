"""Compiled integrators on any time grid."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import lru_cache
from itertools import pairwise
from typing import Any

import casadi as ca
import numpy as np

from .arrays import FloatArray, finite
from .errors import GroundrollError, one_of
from .memory import check_memory
from .models import ModelLike, as_model

METHODS = ("rk45", "rk4")

#: Longest stretch of time given to one call of the compiled integrator, s. The adaptive one keeps
#: a tape of its steps for the adjoint; this keeps it short.
_LONGEST = {"rk45": 1.0, "rk4": 0.01}

#: Bytes that CasADi takes for each call of the compiled integrator in a path, as measured.
_CALL_BYTES = 8_000

#: Steps under an input that varies start at this length, s, or at what lies between outputs and
#: breaks if that is less, and are halved until they agree.
_FIRST_STEP = 0.02
_HALVINGS = 8
#: They agree when no state changes by more than this share of its largest magnitude: as the error
#: falls with the fourth power of the step, that of the finer ones is then a fifteenth of it.
_AGREED = 1e-9
#: A step samples the input at the two Gauss points; the held values of its two halves are these
#: means of the samples.
_POINTS = 0.5 + np.array([-1.0, 1.0]) / math.sqrt(12.0)
_MEANS = 0.5 + np.array([[1.0, -1.0], [-1.0, 1.0]]) / math.sqrt(3.0)


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
    longest = _LONGEST[method] if step is None else float(finite("step", step, "s"))
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


def integrate(
    model: ModelLike, method: str, t: FloatArray, x0: FloatArray, u: FloatArray, p: FloatArray
) -> FloatArray:
    """States of several runs, each under a constant input.

    Parameters
    ----------
    model, method : str
        As for `integrator`.
    t : ndarray, shape (N,)
        Output times, s, positive and increasing.
    x0, u, p : ndarray, shapes (n, runs), (inputs, runs), (m, runs)
        Initial states, inputs and parameters, one column for each run.

    Returns
    -------
    ndarray, shape (runs, n, N)

    Raises
    ------
    GroundrollError
        If a run leaves the numbers; the message says which.
    """
    F = integrator(model, method, t)
    runs = range(x0.shape[1])
    return np.stack([_advance(F, x0[:, k], u[:, k], p[:, k], k, len(runs)) for k in runs])


def integrate_varying(
    model: ModelLike,
    method: str,
    t: FloatArray,
    x0: FloatArray,
    u: Callable[[FloatArray], FloatArray],
    p: FloatArray,
    breaks: Sequence[float] = (),
) -> FloatArray:
    """States of several runs under inputs that vary over time.

    The compiled integrators hold their input over an interval. Each step here is two such
    intervals whose held inputs are means of two samples, so chosen that the result is of fourth
    order in the step for every input that enters the equations linearly, as forces do (a
    commutator-free Magnus method: Blanes and Moan, Appl. Numer. Math. 56, 2006, 1519). Steps end
    at each break. For ``rk45`` they are halved until no state changes by more than 1e-9 of its
    largest magnitude, which leaves an error below that (1e-13 to 1e-10 in the tests, against
    SciPy with the input as it is); for ``rk4`` they are 0.01 s.

    Parameters
    ----------
    model, method, t, x0, p
        As for `integrate`.
    u : callable
        From times, s, shape (k,), to inputs, shape (inputs, runs, k).
    breaks : sequence of float
        Times, s, at which an input or one of its derivatives jumps.

    Returns
    -------
    ndarray, shape (runs, n, N)

    Raises
    ------
    GroundrollError
        If a run leaves the numbers, or halving the steps doesn't settle it.
    """
    runs = x0.shape[1]

    def states(longest: float, halvings: int, which: Sequence[int]) -> FloatArray:
        edges = _edges(t, breaks, longest, 2**halvings)
        ends = np.stack([(edges[:-1] + edges[1:]) / 2, edges[1:]], axis=1).ravel()
        F = integrator(model, method, ends, piecewise=True)
        held, outputs = _held(u, edges), np.searchsorted(ends, t)
        paths = [_advance(F, x0[:, k], held[:, k], p[:, k], k, runs) for k in which]
        return np.stack(paths)[:, :, outputs]

    if method != "rk45":
        return states(_LONGEST[method], 0, range(runs))
    x = states(_FIRST_STEP, 0, range(runs))
    unsettled = np.arange(runs)
    for halvings in range(1, _HALVINGS + 1):
        fine = states(_FIRST_STEP, halvings, unsettled.tolist())
        change, size = np.abs(fine - x[unsettled]).max(axis=2), np.abs(fine).max(axis=2)
        x[unsettled] = fine
        unsettled = unsettled[(change > _AGREED * size).any(axis=1)]
        if unsettled.size == 0:
            return x
    raise GroundrollError(
        f"run {unsettled[0]} of {runs}: the disturbance varies too quickly to be resolved in steps"
        f" of {_FIRST_STEP / 2**_HALVINGS * 1e3:.2g} ms"
    )


def _advance(
    F: ca.Function, x0: FloatArray, u: FloatArray, p: FloatArray, run: int, runs: int
) -> FloatArray:
    try:
        x = np.array(F(x0, u, p), dtype=np.float64)
    except RuntimeError as problem:
        raise GroundrollError(
            f"run {run} of {runs}: the integration failed; the motion grows without bound"
        ) from problem
    if not np.isfinite(x).all():
        raise GroundrollError(
            f"run {run} of {runs}: the motion grows beyond what a number can hold"
        )
    return x


def _edges(times: FloatArray, breaks: Sequence[float], longest: float, parts: int) -> FloatArray:
    """Ends of the steps, from 0 to the last output time: all outputs, all breaks, and between.

    Steps no longer than `longest` are divided into so many parts.
    """
    tiny = 1e-12 * times[-1]
    inner = np.array([b for b in breaks if tiny < b < times[-1] and np.abs(times - b).min() > tiny])
    marks = np.union1d(np.concatenate([[0.0], times]), inner)
    pieces = parts * np.maximum(1, np.ceil(np.diff(marks) / longest - 1e-9)).astype(int)
    _check_room(2 * sum(pieces.tolist()))
    steps = [
        np.linspace(begin, end, n, endpoint=False)
        for (begin, end), n in zip(pairwise(marks.tolist()), pieces.tolist(), strict=True)
    ]
    return np.concatenate([*steps, times[-1:]])


def _held(u: Callable[[FloatArray], FloatArray], edges: FloatArray) -> FloatArray:
    """What to hold over the two halves of each step, shape (inputs, runs, 2 steps)."""
    points = edges[:-1, None] + np.diff(edges)[:, None] * _POINTS
    samples = u(points.ravel())
    halves = samples.reshape(*samples.shape[:2], -1, 2) @ _MEANS
    return np.asarray(halves.reshape(samples.shape))


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
