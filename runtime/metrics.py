"""What is read off the displacement y(t) after a disturbance (Sections 4.5.6 to 4.6.4)."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from .arrays import FloatArray
from .errors import GroundloopError
from .integration import integrator
from .linearization import linearize
from .names import signature

if TYPE_CHECKING:
    from .simulation import Trajectory

#: Settled when v and r have fallen to this fraction of their peak.
_REST = 1e-10
#: Unstable, or too slow to tell, when that takes more windows of `_WINDOW` samples than this.
_WINDOWS = 100
_WINDOW = 500
_STEP = 0.01  # s
#: What is unstable when running straight never comes to rest: a growth rate, 1/s, beyond rounding.
_NEUTRAL = 1e-9
_NOTHING = (np.nan,) * 6


@dataclass(frozen=True)
class Metrics:
    """Read-outs of a response; NaN where the aircraft does not come to rest at a steady y.

    With several runs every attribute has their shape.

    Attributes
    ----------
    displacement : ndarray
        Steady y, m, in aircraft coordinates.
    rotation : ndarray
        Steady theta, rad.
    time_constant : ndarray
        First time at which y reaches 63.2 % of its steady value, s.
    settling_time : ndarray
        Last time at which y enters the band of 5 % around its steady value, s.
    rise_time : ndarray
        From the first 10 % to the first 90 % of the steady value, s.
    overshoot : ndarray
        Peak over steady value, minus 1.
    """

    displacement: FloatArray
    rotation: FloatArray
    time_constant: FloatArray
    settling_time: FloatArray
    rise_time: FloatArray
    overshoot: FloatArray


def metrics(run: Trajectory) -> Metrics:
    """Metrics of a simulated run, which is continued until the aircraft is at rest sideways.

    Parameters
    ----------
    run : Trajectory
        One run or several.

    Returns
    -------
    Metrics
        Read off a cubic through y and its derivative v at samples of 0.01 s.

    Raises
    ------
    GroundloopError
        If the disturbance of the run varies over time: these words describe the way from one
        state to a steady one under a constant force.
    """
    if run.gust is not None:
        raise GroundloopError(
            f"metrics describe the response to an initial state under a constant disturbance, and"
            f" this run has a {run.gust.label}; read the series instead, e.g. abs(run['Y']).max()"
        )
    start = {s: run[s][..., 0] for s in signature(run.tire).states}
    p, flat, shape = run.aircraft.columns(run.tire, disturbance=run.disturbance, **start)
    x0, u = np.stack([flat[s] for s in start]), flat["disturbance"][None]
    decay_rate = np.broadcast_to(linearize(run.aircraft, run.tire).decay_rate, shape).ravel()
    rows = [
        _NOTHING if decay_rate[k] < -_NEUTRAL else _read(run.tire, x0[:, k], u[:, k], p[:, k])
        for k in range(p.shape[1])
    ]
    return Metrics(*(np.array(column).reshape(shape) for column in zip(*rows, strict=True)))


def _read(tire: str, x0: FloatArray, u: FloatArray, p: FloatArray) -> tuple[float, ...]:
    x = _until_rest(tire, x0, u, p)
    if x is None:
        return _NOTHING
    names = signature(tire).states
    v, y, theta = (x[names.index(s)] for s in ("v", "y", "theta"))
    if y[-1] == y[0]:
        return _NOTHING
    t = _STEP * np.arange(y.size)
    share, rate = (y - y[0]) / (y[-1] - y[0]), v / (y[-1] - y[0])
    outside = np.flatnonzero(np.abs(share - 1) > 0.05)
    settled = t[0] if outside.size == 0 else _last_entry(t, share, rate, int(outside[-1]))
    ten, ninety = (_first(t, share, rate, level) for level in (0.1, 0.9))
    return (
        float(y[-1]),
        float(theta[-1]),
        _first(t, share, rate, 1 - np.exp(-1)),
        settled,
        ninety - ten,
        max(float(share.max()) - 1, 0.0),
    )


def _until_rest(tire: str, x0: FloatArray, u: FloatArray, p: FloatArray) -> FloatArray | None:
    """States at every step until v and r have died out; None if they don't."""
    window = integrator(tire, "rk45", _STEP * np.arange(1.0, _WINDOW + 1))
    names = signature(tire)
    moving = [names.states.index(s) for s in names.dynamic]
    parts = [x0[:, None]]
    peak = np.zeros(len(moving))
    for _ in range(_WINDOWS):
        try:
            x = np.array(window(parts[-1][:, -1], u, p), dtype=np.float64)
        except RuntimeError:
            return None
        if not np.isfinite(x).all():
            return None
        parts.append(x)
        magnitude = np.abs(x[moving])
        peak = np.maximum(peak, np.maximum(magnitude.max(axis=1), np.abs(x0[moving])))
        if (magnitude[:, -1] <= _REST * peak).all():
            return np.concatenate(parts, axis=1)
    return None


def _first(t: FloatArray, f: FloatArray, rate: FloatArray, level: float) -> float:
    """First time at which f passes a level."""
    above = np.flatnonzero(f >= level)
    if above.size == 0:
        return float("nan")
    k = int(above[0])
    return float(t[0]) if k == 0 else _crossing(t, f, rate, k - 1, level)


def _last_entry(t: FloatArray, f: FloatArray, rate: FloatArray, k: int) -> float:
    """Time after sample k at which f enters the band around 1 for good."""
    return _crossing(t, f, rate, k, 1.05 if f[k] > 1 else 0.95)


def _crossing(t: FloatArray, f: FloatArray, rate: FloatArray, k: int, level: float) -> float:
    """Where the cubic through samples k and k + 1 and their slopes passes a level."""
    h = t[k + 1] - t[k]
    s = np.linspace(0.0, 1.0, 65)
    cubic = (
        f[k] * (1 + 2 * s) * (1 - s) ** 2
        + f[k + 1] * s**2 * (3 - 2 * s)
        + h * rate[k] * s * (1 - s) ** 2
        + h * rate[k + 1] * s**2 * (s - 1)
    )
    for i, j in pairwise(range(s.size)):
        if (cubic[i] - level) * (cubic[j] - level) <= 0 and cubic[i] != cubic[j]:
            return float(
                t[k] + h * (s[i] + (level - cubic[i]) / (cubic[j] - cubic[i]) * (s[j] - s[i]))
            )
    return float(t[k + 1])
