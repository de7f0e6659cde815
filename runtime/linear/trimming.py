"""Equilibria: states, and inputs that are asked for, at which nothing accelerates."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import numpy.typing as npt

from groundroll.aircraft.aircraft import Aircraft, of_aircraft
from groundroll.aircraft.values import Given
from groundroll.base.arrays import FloatArray, single, whole
from groundroll.base.errors import GroundrollError, shown
from groundroll.linear.conditions import named, question_of, ranges_of, sought
from groundroll.linear.equilibria import solve
from groundroll.linear.operating_point import points_of, sorted_at
from groundroll.linear.points import Points
from groundroll.linear.turns import Balance, every_turn
from groundroll.model.models import Model, ModelLike, as_model
from groundroll.stability.modes import modes_of

from .trim_result import Trim

BoolArray = npt.NDArray[np.bool_]

#: Slip angle of the main tires up to which equilibria are sought: the tire data end there.
SLIP = math.radians(20.0)
#: Starts of the search for equilibria of a model that has no closed form for them.
STARTS = 16
#: How the names of events begin after which a model does not hold: it lets a place go through the
#: ground.
_THROUGH = "struck_"


@of_aircraft
def trim(
    plane: Aircraft,
    model: ModelLike = "nonlinear",
    at: Mapping[str, Any] | None = None,
    *,
    solve_for: Iterable[str] = (),
    within: Mapping[str, Any] | None = None,
    slip: float | str = SLIP,
    starts: int = STARTS,
    **values: Any,
) -> Trim:
    """Find the equilibria of an aircraft: nothing accelerates, and the path is steady.

    What is named is given: a state, an input, a parameter; of what is not, inputs are zero, and a
    free speed is the aircraft's own. The other dynamic states are found, and so are the inputs in
    `solve_for`. A heading on which nothing depends stays open, so that steady turns are
    equilibria; with an unknown more the path is straight. Where a wind makes the heading matter
    it is found, too, and with an unknown more the path runs along the runway. If the speed is
    given and no unknown is left to hold it, it is held by something else (`Trim.held`), and
    ``a_x`` tells what that would have to do.

    At a speed of zero an aircraft stands where friction holds it, in the heading that is given:
    friction near rest takes a creep, below `rest_speed`, and v, r and u are that. If there is no
    such equilibrium it slides, rolls or turns.

    The thesis's models are reduced to one equation in the slip angle of the main tires (see the
    equation sheet), and it is proved by interval arithmetic that no equilibrium in the range is
    missed. Of other models those are given that Newton's method finds from `starts` places.

    Parameters
    ----------
    plane : Aircraft
        The aircraft; its parameters may be arrays.
    model : str or Model
        A model that ships, a folder, or what `Model.load` gives.
    at : mapping of str to anything, optional
        States, inputs and parameters by symbol or full name, with units.
    solve_for : list of str, optional
        Inputs to be found, as many as states are given: ``("pedal", "thrust")``.
    within : mapping of str to pair, optional
        Between what an unknown may be: ``{"elevator": ("-25 deg", "15 deg")}``. Inputs that can
        be moved only so far (a pedal, a brake, a thrust) are within their own range anyway.
    slip : float
        Largest slip angle of the main tires to search in the thesis's models, rad, below a right
        angle; by default 20 degrees, where the tire data (Table 3.1) end. The linear tire has one
        equilibrium, which is given wherever it is. The angle at the tail may be any.
    starts : int
        From how many places equilibria are sought where there is no proof.
    **values : float, array or str
        The same as `at`, as keywords: ``speed="30 kt", crosswind="8 kt"``.

    Returns
    -------
    Trim
        The equilibria, and the stability of each. There may be none; then it says why.

    Raises
    ------
    GroundrollError
        For unknown names, values that cannot be, or more or fewer unknowns than conditions.
    """
    chosen = as_model(model)
    found = sorted_at(plane, chosen, at, values, "trim")
    inputs, ranges = sought(chosen, found, solve_for), ranges_of(chosen, within)
    widest, count = _widest(slip), whole("starts", starts, 1)  # whether they count here or not
    if "turns" in chosen.abilities and not (inputs or found.states or within):
        return _turns(chosen, found, plane, widest)
    points = points_of(chosen, found)
    question, held, idle = question_of(points, found, inputs, ranges)
    answer = solve(question, count)
    told = _told(
        points,
        {s: answer.values[..., k] for k, s in enumerate(question.unknown)},
        tuple(s for s in chosen.dynamic if s not in (*held, *idle)),
        singular=np.zeros(points.shape, bool),
        searched={s: ranges.get(s, (-math.inf, math.inf)) for s in question.unknown},
        complete=False,
        held=held,
        reasons=(),
        given=named(plane, found),
    )
    counts = enumerate(told.count.flat)
    return replace(told, reasons=tuple("" if n else answer.reason(i) for i, n in counts))


def _widest(slip: float | str) -> float:
    widest = single("slip", slip, "rad")
    if not 0 < widest < math.pi / 2:
        raise GroundrollError(f"slip must be between 0 and a right angle (pi/2), not {shown(slip)}")
    return widest


def _turns(model: Model, found: Given, plane: Aircraft, widest: float) -> Trim:
    """Steady turns of a model that reduces them to one equation."""
    widest = math.inf if model.name == "linear" else widest
    points = points_of(model, found)
    columns = dict(zip(points.values, points.columns, strict=True))
    given = {s: columns[s] for s in (*model.inputs, *model.parameters)}
    turns = every_turn(Balance(model, given, points.count), widest)
    branch = np.arange(turns.case.size) - np.searchsorted(turns.case, turns.case)
    at = {}
    for s, column in (("v", turns.v), ("r", turns.r)):
        at[s] = np.full((points.count, int(branch.max(initial=-1)) + 1), np.nan)
        at[s][turns.case, branch] = column + 0.0  # no negative zeros
    return _told(
        points,
        at,
        model.dynamic,
        singular=turns.singular.reshape(points.shape),
        searched={"alpha": (-widest, widest)},
        complete=True,
        held=(),
        reasons=("",) * points.count,
        given=named(plane, found),
    )


def _told(
    points: Points, at: Mapping[str, FloatArray], moving: tuple[str, ...], **about: Any
) -> Trim:
    """The result, from the unknowns of each case and branch, (cases, branches), NaN where none.

    `moving` are the states whose motion about the equilibrium decides whether it is stable.
    """
    model, shape = points.model, points.shape
    first = next(iter(at.values()))
    case, branch = np.nonzero(np.isfinite(first))
    given = dict(zip(points.values, points.columns, strict=True))
    values = {s: x[case] if x.size > 1 else x.reshape(()) for s, x in given.items()}
    values |= {s: x[case, branch] for s, x in at.items()}
    each = replace(points, values=values, shape=case.shape)
    columns = {s: np.broadcast_to(each.values[s], case.shape) for s in model.dynamic}
    columns |= {s: x[case, branch] for s, x in at.items()}
    columns |= dict.fromkeys((*model.outputs, "decay_rate"), np.empty(0))
    if case.size:
        results = each.evaluate("g", "fx", over=moving)
        columns |= dict(zip(model.outputs, results["g"].T, strict=True))
        columns["decay_rate"] = modes_of(results["fx"]).decay_rate
    clear = is_clear(model, columns)
    left_out = np.bincount(case[~clear], minlength=points.count)
    case, count = case[clear], np.bincount(case[clear], minlength=points.count)
    branch = np.arange(case.size) - np.searchsorted(case, case)
    tables = {}
    for s, column in columns.items():
        table = np.full((points.count, int(count.max(initial=0))), np.nan)
        table[case, branch] = column[clear]
        tables[s] = table.reshape(*shape, -1)
    decay = tables.pop("decay_rate")
    return Trim(
        values=tables,
        count=count.reshape(shape),
        left_out=left_out.reshape(shape),
        stable=decay > 0,
        decay_rate=decay,
        aircraft=points.aircraft,
        model=model.key,
        **about,
    )


def is_clear(model: Model, columns: Mapping[str, FloatArray]) -> BoolArray:
    """Where nothing is through the ground that should not be."""
    clear = np.ones(next(iter(columns.values())).shape, bool)
    for event in model.events:
        if event.name.startswith(_THROUGH):
            value = columns[event.output]
            clear &= ~(value > 0 if event.rising else value < 0)
    return clear
