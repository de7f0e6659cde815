"""What a design is worth over the whole envelope, and what a change of anything would buy."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

import numpy as np

from groundloop.arrays import FloatArray
from groundloop.generated.names import QUANTITIES

from .case import DESIGN, VARIABLES, Case
from .envelope import AXES
from .limits import ANGLE, KINDS, LOAD, Bound, shown
from .problem import CORNER, Problem
from .program import LEVELS, Program, Solution
from .search import BUDGET, PATH_BUDGET, Points, least

#: Where a price is below this share of the objective's scale, it is noise of the solver.
_NOISE = 1e-7


@dataclass(frozen=True)
class Worst:
    """The worst value of something over the envelope, and the corner where it is.

    Attributes
    ----------
    value : float
        SI units.
    corner : mapping of str to float
        By symbol, SI units.
    """

    value: float
    corner: Mapping[str, float]


@dataclass(frozen=True)
class Standing:
    """How a limit stands: its worst value over the envelope and the room that is left.

    Attributes
    ----------
    bound : Bound
        The limit.
    worst : Worst
        The value nearest to the bound, or furthest beyond it.
    room : float
        SI units; negative if the limit is broken.
    """

    bound: Bound
    worst: Worst
    room: float


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


@dataclass(frozen=True)
class Assessment:
    """A design over the whole envelope.

    Attributes
    ----------
    design : mapping of str to float
        By symbol, SI units.
    decay_rate, damping_ratio : Worst
        The worst of each, 1/s and 1; the damping ratio is NaN where it means nothing, because
        the aircraft is unstable.
    displacement : Worst or None
        Largest |Y| of the simulated run, m; None if unstable, or if nobody asked.
    standings : tuple of Standing
        Every limit.
    prices : tuple of Price
        What a small change of the design would buy.
    """

    design: Mapping[str, float]
    decay_rate: Worst
    damping_ratio: Worst
    displacement: Worst | None
    standings: tuple[Standing, ...]
    prices: tuple[Price, ...] = ()

    def objective(self, name: str) -> Worst | None:
        """The worst value of an objective; of a change, the decay rate that it is made for."""
        return {
            "damping_ratio": self.damping_ratio,
            "displacement": self.displacement,
        }.get(name, self.decay_rate)


def assess(problem: Problem, design: Mapping[str, float]) -> Assessment:
    """A design over the whole envelope, without prices."""
    case = problem.case

    measured = [b for b in case.bounds if b.limit != "displacement"]

    def rows(points: Points) -> FloatArray:
        values = case.values(design, points)
        damping = np.nan_to_num(values["damping_ratio"], nan=np.inf)
        found = [values["decay_rate"], damping]
        found += [b.sign * values[b.kind.symbol] for b in measured]
        return np.stack([np.broadcast_to(x, points["u"].shape) for x in found])

    decay, damping, *others = (Worst(*found) for found in least(rows, case.axes, BUDGET))
    if decay.value < 0:
        damping = Worst(np.nan, damping.corner)
    displacement = None
    if decay.value > 0 and problem.rows[2] is not None:
        displacement = worst_displacement(problem, design)
    standings = [
        _standing(b, Worst(b.sign * worst.value, worst.corner))
        for b, worst in zip(measured, others, strict=True)
    ]
    if displacement is not None:
        standings += [_standing(b, displacement) for b in case.bounds if b not in measured]
    return Assessment(design, decay, damping, displacement, tuple(standings))


def _standing(bound: Bound, worst: Worst) -> Standing:
    return Standing(bound, worst, bound.sign * (worst.value - bound.value))


def worst_displacement(problem: Problem, design: Mapping[str, float]) -> Worst:
    """Largest |Y| over the envelope."""

    def rows(points: Points) -> FloatArray:
        return -problem.displacement(design, points)[None]

    ((value, corner),) = least(rows, problem.case.axes, PATH_BUDGET)
    return Worst(-value, corner)


def prices(problem: Problem, solution: Solution, corners: Points) -> tuple[Price, ...]:
    """What a small change of anything given would buy at an optimum, the design re-optimised.

    Changes of the envelope's ends, of the aircraft's numbers and of what the design holds fixed.
    Limits and bounds of variables are in `binding`.
    """
    case = problem.case
    slopes = solution.slopes
    free = {v.symbol for v in case.variables}
    found = [
        _price(s, slope)
        for s, slope in zip(DESIGN, slopes["design"], strict=True)
        if s not in free and np.isfinite(case.today[s]) and case.today[s] != 0
    ]
    found += list(_of_envelope(case, slopes["corners"], corners))
    found += [_price(s, slope) for s, slope in zip(case.numbers, slopes["numbers"], strict=True)]
    return _worth_a_line(problem, found)


def design_prices(problem: Problem, design: Mapping[str, float], corners: Points) -> Solution:
    """The slopes of the objective's level at a fixed design, over the corners given."""
    bare = replace(problem.case, bounds=())
    return Program(Problem(bare), corners, fixed=True).solve(design, _level(bare, design, corners))


def _level(case: Case, design: Mapping[str, float], corners: Points) -> float:
    if case.objective == "displacement":
        return 1.0
    worst = float(case.values(design, corners)["decay_rate"].min())
    return worst if case.objective == "decay_rate" else 0.5


def here(problem: Problem, assessment: Assessment, corners: Points) -> Assessment:
    """An assessment with the prices of each part of its design."""
    case = problem.case
    stable = assessment.decay_rate.value > 0
    if case.objective not in LEVELS or not (stable or case.objective == "decay_rate"):
        return assessment
    worst = assessment.objective(case.objective)
    assert worst is not None
    points = {s: np.append(values, worst.corner[s]) for s, values in corners.items()}
    solution = design_prices(problem, assessment.design, points)
    if not solution.ok:
        return assessment
    of = {v.symbol for v in case.variables}
    found = [
        _price(s, slope)
        for s, slope in zip(DESIGN, solution.slopes["design"], strict=True)
        if s in of
    ]
    return replace(assessment, prices=tuple(found))


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


def _price(symbol: str, slope: float) -> Price:
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


def describe(corner: Mapping[str, float], axes: Mapping[str, object]) -> str:
    """A corner in words, of the axes that range over more than one value."""
    units = {"u": "km/h", "x_cg": "mm", "m": "kg"}
    names = {symbol: name for name, symbol in AXES.items()}
    return ", ".join(
        f"{names[s].replace('_', ' ')} {shown(corner[s], units.get(s, '1'))}"
        for s in CORNER
        if s in axes
    )


__all__ = [
    "ANGLE",
    "KINDS",
    "LOAD",
    "VARIABLES",
    "Assessment",
    "Price",
    "Standing",
    "Worst",
    "assess",
    "binding",
    "describe",
    "here",
    "prices",
]
