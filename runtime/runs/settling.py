"""Runs continued until the aircraft moves steadily: the responses that metrics are read off."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from groundroll.base.arrays import FloatArray
from groundroll.base.errors import GroundrollError
from groundroll.linear.linearization import linearize
from groundroll.model.evaluate import columns
from groundroll.model.models import Model, as_model
from groundroll.motion.engine import integrate
from groundroll.motion.lanes import Pieces, Task
from groundroll.motion.signals import Polynomials

from .curve import Curve

if TYPE_CHECKING:
    from .simulation import Trajectory

IntArray = npt.NDArray[np.intp]

#: Steady when v and r change within a window by no more than this fraction of their peak.
_REST = 1e-10
#: Unstable, or too slow to tell, when that takes more windows of `_WINDOW` samples than this.
_WINDOWS = 100
_WINDOW = 500
_STEP = 0.01  # s
_TOLERANCE = 1e-11
#: What is unstable when running straight never comes to rest: a growth rate, 1/s, beyond rounding.
_NEUTRAL = 1e-9


@dataclass(frozen=True)
class Response:
    """A run from the start of its disturbance until v and r are steady.

    Attributes
    ----------
    curves : dict of str to Curve
        Each state over the time since the start of the disturbance, s.
    constant : float
        Time since which the disturbance is constant, s.
    """

    curves: dict[str, Curve]
    constant: float


def responses(run: Trajectory) -> list[Response | None]:
    """The response of each run, flattened; None where it never becomes steady.

    Raises
    ------
    GroundrollError
        If it is not known when the gust of the run ends.
    """
    model, shape = as_model(run.model), run["v"].shape[:-1]
    signals = _ending(run)
    p, flat, _ = run.aircraft.columns(model, **{s: run[s][..., 0] for s in run.values})
    ends = [np.broadcast_to(s.end, shape).ravel() for s in signals.values()]
    starts = [np.broadcast_to(s.start, shape).ravel() for s in signals.values()]
    n = p.shape[1]
    begin = np.maximum(np.min(starts, axis=0), 0.0) if starts else np.zeros(n)
    end = np.maximum(np.max(ends, axis=0), 0.0) if ends else np.zeros(n)
    breaks = [s.breaks for s in signals.values()]
    t = _grid(np.concatenate([begin, end, *breaks]), end.max())
    # what acts just before and just after each sample
    sides = np.stack([_inputs(model, signals, flat, np.nextafter(t, to), shape) for to in _SIDES])
    decay_rate = np.broadcast_to(linearize(run.aircraft, run.model).decay_rate, shape).ravel()
    hopeful = np.flatnonzero(decay_rate >= -_NEUTRAL)
    found: list[Response | None] = [None] * n
    if hopeful.size == 0:
        return found
    task = Task(
        model=model,
        x0={s: flat[s][hopeful] for s in model.states},
        inputs={s: flat[s][hopeful] for s in model.inputs if s not in signals},
        parameters=dict(zip(model.parameters, p[:, hopeful], strict=True)),
        signals={s: _of_runs(signal, shape, hopeful) for s, signal in signals.items()},
        count=hopeful.size,
        t=float(t[-1]),
        tol=_TOLERANCE,
        times=t,
        sampled=model.states,
    )
    for k, x in zip(hopeful.tolist(), _until_steady(task, sides[1][:, hopeful, -1]), strict=True):
        if x is not None:
            curves = _curves(model, t, x, sides[:, :, k], p[:, k], begin[k])
            found[k] = Response(curves, float(end[k] - begin[k]))
    return found


#: Just before and just after.
_SIDES = (-np.inf, np.inf)


def _ending(run: Trajectory) -> Mapping[str, Polynomials]:
    """The inputs of a run that varied, each with an end."""
    signals = {s: signal.over(float(run.t[-1])) for s, signal in run.signals.items()}
    for signal in signals.values():
        if not np.isfinite(signal.end).all():
            raise GroundrollError(
                f"metrics follow a response until it is steady, and the {signal.label} has no end"
                " that is known: say from when on it is constant, as gusts.of_time(force, end=3.0)"
                " does, or read the series instead, e.g. abs(run['Y']).max()"
            )
    return signals


def _inputs(
    model: Model,
    signals: Mapping[str, Polynomials],
    constant: Mapping[str, FloatArray],
    t: FloatArray,
    shape: tuple[int, ...],
) -> FloatArray:
    """Inputs of all runs at times, shape (inputs, runs, times)."""
    rows = (
        np.broadcast_to(signals[s](t), (*shape, t.size)).reshape(-1, t.size)
        if s in signals
        else np.repeat(constant[s][:, None], t.size, axis=1)
        for s in model.inputs
    )
    return np.stack([*rows])


def _grid(marks: FloatArray, last: float) -> FloatArray:
    """Times from 0 to the last one: all marks, and steps between them."""
    inner = np.unique(marks[(marks > 0) & (marks < last)])
    parts = [
        np.linspace(a, b, max(1, math.ceil((b - a) / _STEP - 1e-9)), endpoint=False)
        for a, b in pairwise([0.0, *inner.tolist(), last])
    ]
    return np.concatenate([*(parts if last > 0 else []), [last]])


def _of_runs(signal: Polynomials, shape: tuple[int, ...], which: IntArray) -> Pieces:
    """A signal of some of the runs."""
    every = signal.pieces(shape, range(math.prod(shape)))
    rows = (each[which] if len(each) > 1 else each for each in (every.start, every.value))
    return Pieces(*rows)


def _until_steady(task: Task, final: FloatArray) -> list[FloatArray | None]:
    """States while inputs vary and on under the last ones until v and r are steady, for each run.

    None where they never are.
    """
    model, count = task.model, task.count
    moving = [model.states.index(s) for s in model.dynamic]
    if task.t > 0:
        varied = integrate(task, 1).samples
        x = np.stack([varied[s] for s in model.states], axis=1)
    else:
        x = np.stack([task.x0[s] for s in model.states], axis=1)[:, :, None]
    parts = [[states] for states in x]
    peak, last = np.abs(x[:, moving]).max(axis=2), x[:, :, -1]
    found: list[FloatArray | None] = [None] * count
    left = np.arange(count)
    for _ in range(_WINDOWS):
        if left.size == 0:
            break
        window = integrate(_next(task, left, last, final[:, left]), 1)
        x = np.stack([window.samples[s] for s in model.states], axis=1)
        peak = np.maximum(peak, np.abs(x[:, moving]).max(axis=2))
        steady = (np.ptp(x[:, moving], axis=2) <= _REST * peak).all(axis=1)
        for k, states, is_steady in zip(left.tolist(), x, steady.tolist(), strict=True):
            parts[k].append(states)
            found[k] = np.concatenate(parts[k], axis=1) if is_steady else None
        going = ~steady & np.isfinite(x).all(axis=(1, 2))
        left, last, peak = left[going], x[going, :, -1], peak[going]
    return found


def _next(task: Task, which: IntArray, x: FloatArray, u: FloatArray) -> Task:
    """Some of the runs from where they have come to, over a window."""
    model = task.model
    return replace(
        task,
        x0=dict(zip(model.states, x.T, strict=True)),
        inputs=dict(zip(model.inputs, u, strict=True)),
        parameters={s: value[which] for s, value in task.parameters.items()},
        signals={},
        count=which.size,
        t=_STEP * _WINDOW,
        times=_STEP * np.arange(1.0, _WINDOW + 1),
    )


def _curves(
    model: Model, t: FloatArray, x: FloatArray, sides: FloatArray, p: FloatArray, begin: float
) -> dict[str, Curve]:
    """States over the time since `begin`; after the times `t` the last input goes on."""
    count, more = t.size, x.shape[1] - t.size
    times = np.concatenate([t, t[-1] + _STEP * np.arange(1, more + 1)]) - begin
    rest = _rates(model, x[:, count:], np.tile(sides[1, :, -1:], more), p)
    before, after = (
        np.concatenate([_rates(model, x[:, :count], u, p), rest], axis=1) for u in sides
    )
    rows = np.stack([x, before, after], axis=1)[:, :, times >= 0]
    return {s: Curve(times[times >= 0], *row) for s, row in zip(model.states, rows, strict=True)}


def _rates(model: Model, x: FloatArray, u: FloatArray, p: FloatArray) -> FloatArray:
    every = np.repeat(p[:, None], x.shape[1], axis=1)
    (rates,) = columns(model.function("rhs"), x, u, every)
    return np.asarray(rates[:, :, 0].T)
