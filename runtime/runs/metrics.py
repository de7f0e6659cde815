"""What is read off a response: the words of Sections 4.5.6 to 4.6.4, and those for gusts."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from groundroll.base.arrays import FloatArray
from groundroll.base.listing import Listed, span
from groundroll.model.models import ModelLike, as_model

from .curve import Curve
from .settling import responses

if TYPE_CHECKING:
    from .simulation import Trajectory

#: What is smaller than this fraction of the largest it has been counts as zero.
_ZERO = 1e-8
_BAND = 0.05
_NOTHING = (np.nan,) * 8


@dataclass(frozen=True, repr=False)
class Metrics(Listed):
    """Read-outs of the response of a state, y if no other is named, to a start or a disturbance.

    The response begins with the gust, or at t = 0 if the disturbance is constant; times count
    from there. It ends when v and r are steady, long after the run if need be. What has no
    meaning is NaN: everything if the state does not become steady (as y under a force that
    stays) or the aircraft is unstable when running straight, and the words for the way to a new
    value (the last four) if the state returns to where it began (as v after a gust).

    With several runs every attribute has their shape; with several states, beside `displacement`
    and `rotation`, one more axis before it.

    Attributes
    ----------
    of : str or tuple of str
        Which state, by symbol.
    model : str or Model
        Whose it is.
    displacement : ndarray
        Steady y, m, in aircraft coordinates.
    rotation : ndarray
        Steady theta, rad.
    steady : ndarray
        Steady value of the state, in its SI unit.
    peak : ndarray
        Its value of largest magnitude, with its sign.
    peak_time : ndarray
        When it has that value, s; infinite if it is the steady value, which is never reached.
    recovery_time : ndarray
        From when the disturbance is constant (after a gust: from its end) to the last time at
        which the state enters a band around its steady value, s: 5 % of its largest distance
        from it. 0 if it is in the band by then.
    time_constant : ndarray
        First time at which the state has gone 63.2 % of the way to its steady value, s.
    rise_time : ndarray
        From the first 10 % to the first 90 % of that way, s.
    settling_time : ndarray
        Last time at which it enters the band of 5 % of that way around its steady value, s.
    overshoot : ndarray
        How far it goes beyond, over that way.
    """

    of: str | tuple[str, ...]
    model: ModelLike
    displacement: FloatArray
    rotation: FloatArray
    steady: FloatArray
    peak: FloatArray
    peak_time: FloatArray
    recovery_time: FloatArray
    time_constant: FloatArray
    rise_time: FloatArray
    settling_time: FloatArray
    overshoot: FloatArray

    #: SI unit of each attribute; an empty one is the state's.
    units: ClassVar[dict[str, str]] = {
        "displacement": "m",
        "rotation": "rad",
        "steady": "",
        "peak": "",
        "peak_time": "s",
        "recovery_time": "s",
        "time_constant": "s",
        "rise_time": "s",
        "settling_time": "s",
        "overshoot": "1",
    }

    def _title(self) -> str:
        states = [self.of] if isinstance(self.of, str) else self.of
        q = as_model(self.model).quantities
        return f"Metrics of {', '.join(f'{s} ({q[s].name})' for s in states)}"

    def _rows(self) -> Iterable[Sequence[str]]:
        q = as_model(self.model).quantities
        for name, unit in self.units.items():
            own = unit or (q[self.of].unit if isinstance(self.of, str) else "")
            yield name, span(getattr(self, name)), "" if own == "1" else own


def metrics(run: Trajectory, of: str | Sequence[str] = "y") -> Metrics:
    """Metrics of a simulated run, which is continued until the aircraft moves steadily.

    Parameters
    ----------
    run : Trajectory
        One run or several.
    of : str or sequence of str
        Which state, or states, by symbol or full name.

    Returns
    -------
    Metrics
        Read off cubics through the states and their rates at samples of 0.01 s.

    Raises
    ------
    GroundrollError
        If there is no such state, or it is not known when the gust of the run ends.
    """
    model = as_model(run.model)
    shape = next(iter(run.values.values())).shape[:-1]
    names = [of] if isinstance(of, str) else list(of)
    wanted = tuple(model.symbol(name, "state", model.states, "metrics") for name in names)
    found = responses(run)
    at_rest = [
        [np.nan if each is None else _steady(each.curves[s]) for each in found]
        for s in ("y", "theta")
    ]
    read = [
        [_NOTHING if each is None else _read(each.curves[s], each.constant) for each in found]
        for s in wanted
    ]
    by_word = np.moveaxis(np.array(read), -1, 0).reshape(len(_NOTHING), len(wanted), *shape)
    one = isinstance(of, str)
    return Metrics(
        wanted[0] if one else wanted,
        run.model,
        *np.reshape(at_rest, (2, *shape)),
        *(by_word[:, 0] if one else by_word),
    )


def _steady(curve: Curve) -> float:
    """The last value of a state; NaN if it is not steady."""
    if not _is_zero(curve.before[-1], curve.after):
        return math.nan
    return 0.0 if _is_zero(curve.f[-1], curve.f) else float(curve.f[-1])


def _read(curve: Curve, constant: float) -> tuple[float, ...]:
    """Steady value and everything after it in `Metrics`, of one state."""
    steady = _steady(curve)
    if math.isnan(steady):
        return _NOTHING
    times, values = curve.extremes()
    begin, largest = curve.f[0], np.abs(values).argmax()
    peak, when = values[largest], times[largest]
    if _is_zero(peak - steady, values):
        when = 0.0 if _is_zero(begin - steady, values) else math.inf
    band = _BAND * np.abs(values - steady).max()
    entries = [constant, *curve.crossings(steady - band), *curve.crossings(steady + band)]
    at_peak = (steady, peak, when, max(entries) - constant)
    way = steady - begin
    if _is_zero(way, values - begin):
        return (*at_peak, *_NOTHING[len(at_peak) :])
    share = Curve(curve.t, (curve.f - begin) / way, curve.before / way, curve.after / way)
    first = [share.crossings(level)[0] for level in (1 - np.exp(-1), 0.1, 0.9)]
    settled = max([*share.crossings(1 - _BAND), *share.crossings(1 + _BAND)])
    beyond = float(((values - begin) / way).max()) - 1
    return (*at_peak, first[0], first[2] - first[1], settled, max(beyond, 0.0))


def _is_zero(value: float, beside: FloatArray) -> bool:
    return bool(abs(value) <= _ZERO * np.abs(beside).max())
