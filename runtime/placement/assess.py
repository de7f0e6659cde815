"""What a design is worth over the whole envelope, and what a change of anything would buy."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from groundroll.base.arrays import FloatArray

from .case import DESIGN, Case
from .limits import Bound
from .prices import Price, price
from .problem import Problem
from .program import LEVELS, Program, Solution
from .search import BUDGET, PATH_BUDGET, Points, least


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

    def worst(found: tuple[float, Mapping[str, float]]) -> Worst:
        problem.callback()
        return Worst(*found)

    decay, damping, *others = map(worst, least(rows, case.axes, BUDGET))
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
    problem.callback()
    return Worst(-value, corner)


def design_prices(problem: Problem, design: Mapping[str, float], corners: Points) -> Solution:
    """The slopes of the objective's level at a fixed design, over the corners given."""
    bare = replace(problem, case=replace(problem.case, bounds=()))
    level = _level(bare.case, design, corners)
    return Program(bare, corners, fixed=True).solve(design, level)


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
        price(s, slope)
        for s, slope in zip(DESIGN, solution.slopes["design"], strict=True)
        if s in of
    ]
    return replace(assessment, prices=tuple(found))
