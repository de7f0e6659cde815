"""`place_gear`: the best place for the wheels over an envelope, within limits."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from groundloop.aircraft import Aircraft
from groundloop.errors import GroundloopError

from .assess import Assessment, assess, binding, describe, here, prices
from .case import Case, resolve
from .envelope import Envelope
from .limits import LOAD, Bound, Limits, shown
from .problem import Problem
from .result import Placement
from .search import Found, exchange

#: What depends on more of a corner than the CG.
_DYNAMIC = ("decay_rate", "damping_ratio", "displacement")
#: Slack below this, in steps, is none.
_NOTHING = 1e-6
#: An eigenvalue below this share of the other is none: A is singular to rounding.
_SINGULAR = 1e-9


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


class InfeasibleError(GroundloopError):
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


def place_gear(
    plane: Aircraft,
    envelope: Envelope | None = None,
    limits: Limits | None = None,
    objective: str = "decay_rate",
    *,
    variables: Mapping[str, Any] | None = None,
    layout: str | None = None,
    stiffness: str | None = None,
    tail_wheel: str = "locked",
    tire: str = "nonlinear",
    v0: float = 0.1,
    t: float = 5.0,
) -> Placement:
    """Where the main gear should stand, at the worst of everything the aircraft will meet.

    Parameters
    ----------
    plane : Aircraft
        The aircraft as it is, with stations: `cg_station` or its limits, `main_gear_station`,
        `tail_station`; for a tricycle `nose_wheel_station`; for angles `cg_height`.
    envelope : Envelope, optional
        What it will meet; default its CG range at its own speed.
    limits : Limits, optional
        What must hold everywhere in the envelope; default stability.
    objective : str
        ``"decay_rate"`` or ``"damping_ratio"``: the largest worst case of the linear model.
        ``"displacement"``: the smallest worst-case offset from the runway's centre line over a
        run, |Y| in m. It is simulated: the closed form -A^-1 x0 gives y in aircraft coordinates
        after infinite time, while over the ground the aircraft keeps rolling off in whatever
        direction it has turned to; that form also fails where A is singular.
        ``"smallest_change"``: the design nearest to today's that meets the limits, such as a
        target `decay_rate`. Of several variables each counts by the width of its bounds.
    variables : mapping of str to (low, high), optional
        What may be chosen, by name: ``main_gear_station`` (always; default 1 m from the CG range
        to the layout's side), ``nose_wheel_station``, ``tail_station``, ``tail_area``,
        ``tail_wheel_scale`` (stiffness of the tail wheel over that of the aircraft file). SI
        units or strings with units.
    layout : str, optional
        ``"taildragger"`` or ``"tricycle"``; default what the aircraft is.
    stiffness : str, optional
        ``"constant"``: as in the thesis, no stiffness knows where the gear is; default where the
        aircraft gives `cornering_stiffness`. ``"following"``: axle loads follow from CG and
        gear, stiffnesses from the loads.
    tail_wheel : str
        ``"locked"`` or ``"free"``: a free one casters and makes no side force.
    tire, v0, t
        Of the run that the displacement and the proof are read off: the model, the initial
        lateral velocity in m/s and the duration in s.

    Returns
    -------
    Placement
        The design, its worst corner, what binds and what a change would buy.

    Raises
    ------
    InfeasibleError
        If nothing satisfies every limit; it says which conflict, and by how much.
    GroundloopError
        For anything that is missing, unknown, crossed, empty or at odds.
    """
    case = resolve(
        plane,
        envelope or Envelope(),
        limits or Limits(),
        objective,
        variables=variables,
        layout=layout,
        stiffness=stiffness,
        tail_wheel=tail_wheel,
        tire=tire,
        v0=v0,
        duration=t,
    )
    return place(case)


def place(case: Case) -> Placement:
    """Solve a resolved case; see `place_gear`."""
    problem = Problem(case)
    found = solve(problem)
    solution = found.solution
    if case.objective == "damping_ratio" and solution.level > 1 - 1e-7:
        return _beyond_damping(case)
    design = case.design(solution.chosen)
    result = Placement(
        case=case,
        design=design,
        assessment=here(problem, assess(problem, design), found.corners),
        today=_today(problem, found),
        binding=binding(problem, solution),
        prices=prices(problem, solution, found.corners),
        corners=found.corners,
        rounds=found.rounds,
    )
    return replace(result, notes=tuple(_notes(result)))


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
        raise _infeasible(problem.case)
    return found


def begin(case: Case) -> list[dict[str, float]]:
    """Designs to start from: today's, and a spread over the box with the stablest first."""
    count = 5 if len(case.variables) == 1 else 9
    spread = _halton(count, len(case.variables))
    designs = [
        case.design(
            {v.symbol: v.low + x * (v.high - v.low) for v, x in zip(case.variables, z, strict=True)}
        )
        for z in spread
    ]
    inside = all(v.low <= case.today[v.symbol] <= v.high for v in case.variables)
    if inside:
        designs.append(dict(case.today))
    middle = {s: axis.values.mean() for s, axis in case.axes.items()}
    designs.sort(key=lambda d: -float(case.values(d, middle)["decay_rate"]))
    # each start of a simulated objective costs many runs
    return designs[:3] if _simulates(case) else designs


def _simulates(case: Case) -> bool:
    return case.objective == "displacement" or any(b.limit == "displacement" for b in case.bounds)


def _halton(count: int, dimensions: int) -> np.ndarray[Any, np.dtype[np.float64]]:
    """Points spread evenly over the unit box, the same each time."""
    bases = (2, 3, 5, 7, 11)[:dimensions]
    points = np.zeros((count, dimensions))
    for column, base in enumerate(bases):
        for row in range(count):
            index, fraction = row + 1, 1.0
            while index:
                fraction /= base
                points[row, column] += fraction * (index % base)
                index //= base
    return points


def _beyond_damping(case: Case) -> Placement:
    """Where no mode oscillates anywhere in the envelope, the fastest decay is best."""
    bounds = tuple(b for b in case.bounds if b.limit != "damping_ratio")
    best = place(
        replace(
            case,
            objective="decay_rate",
            bounds=(*bounds, Bound("damping_ratio", "at least", 1.0)),
        )
    )
    note = (
        "a damping ratio of 1 is reached everywhere in the envelope: of all such placements this"
        " one has the largest worst-case decay rate"
    )
    return replace(best, notes=(note, *best.notes))


def _today(problem: Problem, found: Found) -> Assessment | None:
    """Today's design over the envelope, if its third wheel stands on the ground."""
    case = problem.case
    today = case.today
    if not all(np.isfinite(today[v.symbol]) for v in case.variables):
        return None
    corners = {s: np.array([axis.low, axis.high]) for s, axis in case.axes.items()}
    share = case.values(today, corners)["third_load"]
    if (share < 0).any() or (share > 1).any():
        return None
    return here(problem, assess(problem, today), found.corners)


def _infeasible(case: Case) -> GroundloopError:
    """Which limits conflict and by how much: the least violation, and each limit alone."""
    bare = replace(case, objective="smallest_change")
    problem = Problem(bare)
    starts = begin(bare)
    found = exchange(problem, starts, elastic=True)
    solution = found.solution
    steps = np.array([b.kind.step for b in case.bounds])
    if not solution.ok or (solution.slack / steps < _NOTHING).all():
        return GroundloopError(
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
    ranging = dict.fromkeys(s for s, axis in case.axes.items() if axis.low != axis.high)
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
        counts = ranging if c.bound.kind.symbol in _DYNAMIC else {"x_cg": None}
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


def _notes(found: Placement) -> Iterator[str]:
    """What to know before using a placement."""
    case = found.case
    if found.assessment.decay_rate.value < -1e-9:
        yield "it is unstable at its worst corner; nothing in these bounds is better"
    values = case.values(found.design, found.assessment.decay_rate.corner)
    if abs(values["re_1"]) <= _SINGULAR * abs(values["re_2"]):
        yield (
            "A is singular at the worst corner: the gear stands at the CG and nothing at the tail"
            " holds it, so a heading once lost is not regained"
        )
    load = LOAD[case.layout]
    for standing in found.assessment.standings:
        if standing.bound.limit == load and standing.worst.value < 1e-6:
            at = describe(standing.worst.corner, {"x_cg": None})
            yield f"the third wheel carries nothing at {at}, and has no stiffness there"
