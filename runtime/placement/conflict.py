"""What to say when no placement satisfies every limit."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from groundroll.base.errors import GroundrollError

from .assess import assess
from .limits import Bound, shown
from .prices import describe
from .problem import Problem
from .search import Found, exchange
from .starts import begin

#: What depends on more of a corner than the CG.
_DYNAMIC = ("decay_rate", "damping_ratio", "displacement")
#: Slack below this, in steps, is none.
_NOTHING = 1e-6


@dataclass(frozen=True)
class Conflict:
    """A limit that takes part in a conflict.

    Attributes
    ----------
    bound : Bound
        The limit.
    short : float
        By how much it is missed at the nearest design, SI units; 0 if it holds there.
    alone : float
        By how much it would have to give way if no other limit did, SI units; infinite if that
        would not be enough.
    """

    bound: Bound
    short: float
    alone: float


class InfeasibleError(GroundrollError):
    """No placement satisfies every limit over the envelope.

    Attributes
    ----------
    conflicts : tuple of Conflict
        The limits that cannot hold together, and by how much.
    nearest : dict of str to float
        The design that misses them by least, by symbol.
    """

    def __init__(
        self, message: str, conflicts: tuple[Conflict, ...], nearest: Mapping[str, float]
    ) -> None:
        super().__init__(message)
        self.conflicts = conflicts
        self.nearest = dict(nearest)


def infeasible(unsolved: Problem) -> GroundrollError:
    """Which limits conflict and by how much: the least violation, and each limit alone."""
    case = unsolved.case
    bare = replace(case, objective="smallest_change")
    problem = replace(unsolved, case=bare)
    starts = begin(bare)
    found = exchange(problem, starts, elastic=True)
    solution = found.solution
    steps = np.array([b.kind.step for b in case.bounds])
    if not solution.ok or (solution.slack / steps < _NOTHING).all():
        return GroundrollError(
            "no start led to an optimum although the limits can be met; narrow the bounds of the"
            " variables or the envelope"
        )
    weights = np.abs(solution.slopes["bounds"]) * steps
    taking_part = [
        k
        for k in range(len(case.bounds))
        if weights[k] > 1e-4 or solution.slack[k] / steps[k] > _NOTHING
    ]
    conflicts = tuple(
        Conflict(case.bounds[k], float(solution.slack[k]), _alone(problem, found, k))
        for k in taking_part
    )
    design = case.design(solution.chosen)
    return InfeasibleError(_message(problem, design, conflicts, solution.slopes), conflicts, design)


def _alone(problem: Problem, found: Found, index: int) -> float:
    """By how much one limit has to give way if the others do not."""
    case = problem.case
    giving = [k == index for k in range(len(case.bounds))]
    starts = [case.design(found.solution.chosen), *begin(case)]
    alone = exchange(problem, starts, elastic=True, giving=giving, known=found.corners)
    return float(alone.solution.slack[index]) if alone.solution.ok else np.inf


def _message(
    problem: Problem,
    design: Mapping[str, float],
    conflicts: tuple[Conflict, ...],
    slopes: Mapping[str, Any],
) -> str:
    case = problem.case
    standings = {s.bound: s for s in assess(problem, design).standings}
    ranging = [s for s, axis in case.axes.items() if axis.low != axis.high]
    where = ", ".join(
        f"{v.name} {shown(design[v.symbol], 'mm')}"
        for v in case.variables
        if v.symbol.startswith("x_")
    )
    lines = [
        "no placement satisfies every limit over the envelope; the nearest has"
        f" {where} and these limits are in conflict:"
    ]
    for c in conflicts:
        unit = c.bound.kind.shown
        counts = ranging if c.bound.kind.symbol in _DYNAMIC else ("x_cg",)
        at = describe(standings[c.bound].worst.corner, counts) if c.bound in standings else ""
        place_ = f" at {at}" if at else ""
        missed = f"missed by {shown(c.short, unit)}{place_}" if c.short > 0 else "just met"
        missed = missed if c.short / c.bound.kind.step > _NOTHING else f"just met{place_}"
        way = (
            f"alone it would have to give way by {shown(c.alone, unit)}"
            if np.isfinite(c.alone)
            else "giving way alone would not do"
        )
        lines.append(f"  {c.bound}: {missed}; {way}")
    for v in case.variables:
        for side, value in (("low", v.low), ("high", v.high)):
            if abs(design[v.symbol] - value) < 1e-6 * (v.high - v.low):
                words = "at least" if side == "low" else "at most"
                lines.append(f"  and {v.name} is {words} {value:g}, where it stands")
    return "\n".join(lines)


def solve(problem: Problem, starts: list[dict[str, float]] | None = None) -> Found:
    """The best design over the envelope.

    Raises
    ------
    InfeasibleError
        If there is none.
    """
    found = exchange(problem, starts or begin(problem.case))
    if not found.solution.ok:
        # what is infeasible over some corners is so over all
        raise infeasible(problem)
    return found
