"""What a small change of anything would buy, from the multipliers of an optimum."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from groundroll.base.arrays import FloatArray
from groundroll.model.names import QUANTITIES

from .case import DESIGN, Case
from .envelope import AXES
from .limits import SHOWN, shown
from .problem import CORNER, Problem
from .program import Solution
from .search import Points

#: Where a price is below this share of the objective's scale, it is noise of the solver.
_NOISE = 1e-7


@dataclass(frozen=True)
class Price:
    """What a small change would buy.

    Attributes
    ----------
    of : str
        What changes.
    step : str
        By how much, e.g. ``"1 mm"``.
    gain : float
        What that adds to the objective's worst case, in its unit, to first order. For the
        displacement and the smallest change, which are better if less, a negative gain is good.
    """

    of: str
    step: str
    gain: float


def prices(problem: Problem, solution: Solution, corners: Points) -> tuple[Price, ...]:
    """What a small change of anything given would buy at an optimum, the design re-optimised.

    Changes of the envelope's ends, of the aircraft's numbers and of what the design holds fixed.
    Limits and bounds of variables are in `binding`.
    """
    case = problem.case
    slopes = solution.slopes
    free = {v.symbol for v in case.variables}
    found = [
        price(s, slope)
        for s, slope in zip(DESIGN, slopes["design"], strict=True)
        if s not in free and np.isfinite(case.today[s]) and case.today[s] != 0
    ]
    found += list(_of_envelope(case, slopes["corners"], corners))
    found += [price(s, slope) for s, slope in zip(case.numbers, slopes["numbers"], strict=True)]
    return _worth_a_line(problem, found)


def binding(problem: Problem, solution: Solution) -> tuple[Price, ...]:
    """What giving way at each limit and each bound of a variable would buy, where that is much."""
    case = problem.case
    found = []
    for b, slope in zip(case.bounds, solution.slopes["bounds"], strict=True):
        step, label = _STEPS[b.kind.shown]
        found.append(Price(str(b), f"{label} {_LESS[b.side]}", -b.sign * slope * step))
    for k, v in enumerate(case.variables):
        step, label = _step(v.symbol)
        for side, value in (("low", v.low), ("high", v.high)):
            slope = float(solution.slopes[side][k])
            sign = 1.0 if side == "high" else -1.0
            if abs(solution.chosen[v.symbol] - value) > 1e-6 * (v.high - v.low):
                continue
            words = f"{v.name} {'at most' if sign > 0 else 'at least'} {_value(v.symbol, value)}"
            found.append(
                Price(words, f"{label} {'more' if sign > 0 else 'less'}", sign * slope * step)
            )
    return _worth_a_line(problem, found)


_LESS = {"at least": "less", "at most": "more"}
#: Shown unit -> a small step of it in SI and in words.
_STEPS = {
    "1/s": (0.1, "0.1 1/s"),
    "1": (0.01, "0.01"),
    "%": (0.01, "1 %"),
    "deg": (np.radians(1.0), "1 deg"),
    "mm": (1e-3, "1 mm"),
    "m": (1e-3, "1 mm"),
}
#: SI unit -> the same; other numbers change by 1 % of themselves.
_UNITS = {
    "m": (1e-3, "1 mm"),
    "kg": (1.0, "1 kg"),
    "kg m^2": (1.0, "1 kg m^2"),
    "m^2": (0.01, "1 dm^2"),
    "m/s": (1 / 3.6, "1 km/h"),
    "1": (0.01, "0.01"),
}
#: Numbers of nature and of fits: nobody buys a change of them.
_NOT_FOR_SALE = (
    "g",
    "rho",
    "K1",
    "K2",
    "K3",
    "K4",
    "C3",
    "B5",
    "C5",
    "B1",
    "C1",
    "D1",
    "E1",
    "F_0",
)


def _step(symbol: str) -> tuple[float, str]:
    return _UNITS.get(QUANTITIES[symbol].unit, (0.0, ""))


def price(symbol: str, slope: float) -> Price:
    step, label = _step(symbol)
    if symbol in _NOT_FOR_SALE or not step:
        return Price("", "", 0.0)
    return Price(QUANTITIES[symbol].name, label, float(slope) * step)


def _of_envelope(case: Case, slopes: FloatArray, corners: Points) -> Iterator[Price]:
    """Slopes by the ends of each axis: the sum over the corners that stand there."""
    for row, (name, symbol) in zip(slopes, AXES.items(), strict=True):
        axis = case.axes[symbol]
        step, label = _step(symbol)
        ends = {"": axis.low} if axis.low == axis.high else {"least ": axis.low, "most ": axis.high}
        if symbol == "x_cg" and len(ends) == 2:
            ends = {"forward ": axis.low, "aft ": axis.high}
        for words, end in ends.items():
            slope = float(row[np.isclose(corners[symbol], end, rtol=0, atol=1e-9)].sum())
            yield Price(f"{words}{name}", label, slope * step)


def _worth_a_line(problem: Problem, found: list[Price]) -> tuple[Price, ...]:
    return tuple(p for p in found if abs(p.gain) > _NOISE * problem.scale)


def _value(symbol: str, value: float) -> str:
    unit = QUANTITIES[symbol].unit
    return shown(value, {"m": "mm", "m^2": "m^2"}.get(unit, "1"))


def describe(corner: Mapping[str, float], axes: Iterable[str]) -> str:
    """A corner in words, as far as some axes go."""
    names = {symbol: name.replace("_", " ") for name, symbol in AXES.items()}
    wanted = [s for s in CORNER if s in axes]
    return ", ".join(f"{_NAMED.get(s, names[s])} {_coordinate(s, corner[s])}" for s in wanted)


_NAMED = {"x_cg": "CG"}
_COORDINATES = {"u": ("km/h", 1), "x_cg": ("mm", 1), "m": ("kg", 1)}


def _coordinate(symbol: str, value: float) -> str:
    if symbol not in _COORDINATES:
        return f"{value:.3g}"
    unit, digits = _COORDINATES[symbol]
    return f"{round(value * SHOWN[unit][0], digits):g} {unit}"
