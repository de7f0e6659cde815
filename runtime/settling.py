"""Runs continued until the aircraft moves steadily: the responses that metrics are read off."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from .arrays import FloatArray
from .curve import Curve
from .errors import GroundrollError
from .evaluate import columns
from .gusts import Gust
from .integration import integrate_varying, integrator
from .linearization import linearize
from .models import ModelLike, as_model
from .simulation import Trajectory

IntArray = npt.NDArray[np.intp]

#: Steady when v and r change within a window by no more than this fraction of their peak.
_REST = 1e-10
#: Unstable, or too slow to tell, when that takes more windows of `_WINDOW` samples than this.
_WINDOWS = 100
_WINDOW = 500
_STEP = 0.01  # s
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
    names, shape = as_model(run.model), run["v"].shape[:-1]
    gust = _gust(run)
    p, flat, _ = run.aircraft.columns(run.model, **{s: run[s][..., 0] for s in run.values})
    x0 = np.stack([flat[s] for s in names.states])
    begin, end = (
        np.maximum(np.broadcast_to(t, shape).ravel(), 0.0) for t in (gust.start, gust.end)
    )
    t = _grid(np.concatenate([begin, end, gust.breaks]), end.max())
    # what acts just before and just after each sample
    sides = np.stack([gust.on_runs(run.model, shape, np.nextafter(t, to)) for to in (0.0, np.inf)])
    final = sides[1, :, :, -1]
    decay_rate = np.broadcast_to(linearize(run.aircraft, run.model).decay_rate, shape).ravel()
    hopeful = np.flatnonzero(decay_rate >= -_NEUTRAL)
    found: list[Response | None] = [None] * begin.size
    varied = _under(gust, shape, hopeful, run.model, t, x0, p)
    for k, x in zip(hopeful.tolist(), varied, strict=True):
        states = _until_steady(run.model, x, final[:, k], p[:, k])
        if states is not None:
            curves = _curves(run.model, t, states, sides[:, :, k], p[:, k], begin[k])
            found[k] = Response(curves, float(end[k] - begin[k]))
    return found


def _gust(run: Trajectory) -> Gust:
    """The disturbance of a run, also a constant one, as a gust with an end."""
    if run.gust is None:
        return Gust(
            lambda t: np.repeat(run.disturbance[..., None], t.size, axis=-1), end=np.zeros(())
        )
    if not np.isfinite(run.gust.end).all():
        raise GroundrollError(
            f"metrics follow a response until it is steady, and the {run.gust.label} has no end"
            " that is known: say from when on it is constant, as gusts.of_time(force, end=3.0)"
            " does, or read the series instead, e.g. abs(run['Y']).max()"
        )
    run.gust.refuse_jumps(float(run.gust.end.max()))
    return run.gust


def _grid(marks: FloatArray, last: float) -> FloatArray:
    """Times from 0 to the last one: all marks, and steps between them."""
    inner = np.unique(marks[(marks > 0) & (marks < last)])
    parts = [
        np.linspace(a, b, max(1, math.ceil((b - a) / _STEP - 1e-9)), endpoint=False)
        for a, b in pairwise([0.0, *inner.tolist(), last])
    ]
    return np.concatenate([*(parts if last > 0 else []), [last]])


def _under(
    gust: Gust,
    shape: tuple[int, ...],
    which: IntArray,
    model: ModelLike,
    t: FloatArray,
    x0: FloatArray,
    p: FloatArray,
) -> FloatArray:
    """States of some runs while the gust varies, shape (runs, n, times)."""
    start = x0[:, which].T[:, :, None]
    if t.size == 1 or which.size == 0:
        return start

    def inputs(t: FloatArray) -> FloatArray:
        return gust.on_runs(model, shape, t)[:, which]

    after = integrate_varying(model, "rk45", t[1:], x0[:, which], inputs, p[:, which], gust.breaks)
    return np.concatenate([start, after], axis=2)


def _until_steady(
    model: ModelLike, x: FloatArray, u: FloatArray, p: FloatArray
) -> FloatArray | None:
    """States continued under a constant input until v and r are steady; None if they never are."""
    window = integrator(model, "rk45", _STEP * np.arange(1.0, _WINDOW + 1))
    names = as_model(model)
    moving = [names.states.index(s) for s in names.dynamic]
    parts = [x]
    peak = np.abs(x[moving]).max(axis=1)
    for _ in range(_WINDOWS):
        try:
            x = np.array(window(x[:, -1], u, p), dtype=np.float64)
        except RuntimeError:
            return None
        if not np.isfinite(x).all():
            return None
        parts.append(x)
        peak = np.maximum(peak, np.abs(x[moving]).max(axis=1))
        if (np.ptp(x[moving], axis=1) <= _REST * peak).all():
            return np.concatenate(parts, axis=1)
    return None


def _curves(
    model: ModelLike, t: FloatArray, x: FloatArray, sides: FloatArray, p: FloatArray, begin: float
) -> dict[str, Curve]:
    """States over the time since `begin`; after the times `t` the last input goes on."""
    count, more = t.size, x.shape[1] - t.size
    times = np.concatenate([t, t[-1] + _STEP * np.arange(1, more + 1)]) - begin
    rest = _rates(model, x[:, count:], np.tile(sides[1, :, -1:], more), p)
    before, after = (
        np.concatenate([_rates(model, x[:, :count], u, p), rest], axis=1) for u in sides
    )
    rows = np.stack([x, before, after], axis=1)[:, :, times >= 0]
    return {
        s: Curve(times[times >= 0], *row)
        for s, row in zip(as_model(model).states, rows, strict=True)
    }


def _rates(model: ModelLike, x: FloatArray, u: FloatArray, p: FloatArray) -> FloatArray:
    (rates,) = columns(
        as_model(model).function("rhs"), x, u, np.repeat(p[:, None], x.shape[1], axis=1)
    )
    return rates[:, :, 0].T
