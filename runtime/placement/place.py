"""`place_gear`: the best place for the wheels over an envelope, within limits."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from groundroll.aircraft.aircraft import Aircraft, of_aircraft
from groundroll.aircraft.validity import extrapolated
from groundroll.base.errors import GroundrollError, of_kind
from groundroll.base.progress import Progress, counted
from groundroll.model.models import ModelLike

from .assess import Assessment, assess, here
from .case import Case
from .conflict import solve
from .envelope import Envelope, corners
from .limits import LOAD, Bound, Limits
from .prices import binding, describe, prices
from .problem import Problem
from .resolve import resolve
from .result import Placement
from .search import Found

#: An eigenvalue below this share of the other is none: A is singular to rounding.
_SINGULAR = 1e-9


@of_aircraft
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
    model: ModelLike = "nonlinear",
    v0: float = 0.1,
    t: float = 5.0,
    progress: Progress = None,
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
        aircraft gives `cornering_stiffness`, or `tail_wheel_stiffness` of a tail wheel that is
        locked. ``"following"``: axle loads follow from CG and gear, stiffnesses from the loads.
    tail_wheel : str
        ``"locked"`` or ``"free"``: a free one casters and makes no side force.
    model, v0, t
        Of the run that the displacement and the proof are read off: the model, the initial
        lateral velocity in m/s and the duration in s.
    progress : callable or bool, optional
        Called with the number of steps done (a program solved, an envelope looked over) and with
        None, as nobody knows how many it takes; with that number twice at the end. True shows the
        count on a terminal.

    Returns
    -------
    Placement
        The design, its worst corner, what binds and what a change would buy.

    Raises
    ------
    InfeasibleError
        If nothing satisfies every limit; it says which conflict, and by how much.
    GroundrollError
        For anything that is missing, unknown, crossed, empty or at odds.
    """
    case = resolve(
        plane,
        Envelope() if envelope is None else of_kind("envelope", envelope, Envelope),
        Limits() if limits is None else of_kind("limits", limits, Limits),
        objective,
        variables=variables,
        layout=layout,
        stiffness=stiffness,
        tail_wheel=tail_wheel,
        model=model,
        v0=v0,
        duration=t,
    )
    with counted(progress, "steps") as done:
        return place(Problem(case, done.add))


def place(problem: Problem) -> Placement:
    """Solve a resolved case; see `place_gear`."""
    case = problem.case
    _refuse_impossible_tires(case, case.today)
    found = solve(problem)
    solution = found.solution
    if case.objective == "damping_ratio" and solution.level > 1 - 1e-7:
        return _beyond_damping(problem)
    design = case.design(solution.chosen)
    _refuse_impossible_tires(case, design)
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


def _refuse_impossible_tires(case: Case, design: Mapping[str, float]) -> None:
    """Refuse a tire that pushes the way it slides at a load within the envelope."""
    at = corners(case.axes)
    stiffness = case.values(design, at)["C_alpha"]
    if (stiffness < 0).any():
        corner = {s: float(values[stiffness.argmin()]) for s, values in at.items()}
        ranging = [s for s, axis in case.axes.items() if axis.is_range] or ["x_cg"]
        raise GroundrollError(
            f"aircraft {case.plane.name}: at {describe(corner, ranging)} a main tire has a negative"
            " cornering stiffness: B3 + C3 Fz is a line over load, which holds near the loads that"
            " were measured"
        )


def _beyond_damping(problem: Problem) -> Placement:
    """Where no mode oscillates anywhere in the envelope, the fastest decay is best."""
    case = problem.case
    bounds = tuple(b for b in case.bounds if b.limit != "damping_ratio")
    bounds = (*bounds, Bound("damping_ratio", "at least", 1.0))
    best = place(replace(problem, case=replace(case, objective="decay_rate", bounds=bounds)))
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
    ends = {s: np.array([axis.low, axis.high]) for s, axis in case.axes.items()}
    share = case.values(today, ends)["third_load"]
    if (share < 0).any() or (share > 1).any():
        return None
    return here(problem, assess(problem, today), found.corners)


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
    loads = case.values(found.design, corners(case.axes))["Fz"]
    yield from extrapolated(case.plane, loads=loads)
    load = LOAD[case.layout]
    for standing in found.assessment.standings:
        if standing.bound.limit == load and standing.worst.value < 1e-6:
            at = describe(standing.worst.corner, ("x_cg",))
            yield f"the third wheel carries nothing at {at}, and has no stiffness there"
