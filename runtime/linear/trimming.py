"""Equilibria: states, and inputs that are asked for, at which nothing accelerates."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import numpy.typing as npt

from groundroll.aircraft.aircraft import Aircraft, of_aircraft
from groundroll.aircraft.validity import extrapolated_in
from groundroll.aircraft.values import Given
from groundroll.base.arrays import FloatArray, single, whole
from groundroll.base.errors import GroundrollError, shown
from groundroll.base.listing import Listed, unit_of
from groundroll.linear.conditions import named, question_of, ranges_of, sought
from groundroll.linear.equilibria import solve
from groundroll.linear.operating_point import points_of, sorted_at
from groundroll.linear.points import Points
from groundroll.linear.turns import Balance, every_turn
from groundroll.model.models import Model, ModelLike, as_model
from groundroll.results.records import Column, Record, measured, run_dims
from groundroll.results.results import Result
from groundroll.stability.closed_forms import quantity_of
from groundroll.stability.modes import modes_of

from .operating_point import OperatingPoint

BoolArray = npt.NDArray[np.bool_]

#: Slip angle of the main tires up to which equilibria are sought: the tire data end there.
SLIP = math.radians(20.0)
#: Starts of the search for equilibria of a model that has no closed form for them.
STARTS = 16
#: What is said of each case.
_COUNTED = ("count", "left_out", "singular")
#: How the names of events begin after which a model does not hold: it lets a place go through the
#: ground.
_THROUGH = "struck_"


@dataclass(frozen=True, repr=False)
class Trim(Listed, Result):
    """Equilibria; ``trim["v"]`` or ``trim["alpha"]`` holds all branches.

    Attributes
    ----------
    values : mapping of str to ndarray, shape (*shape, branches)
        Dynamic states, inputs that were asked for and every output by symbol, SI units with
        radians; NaN where a case has fewer branches than another. Steady turns are in order of
        the slip angle of the main tires, others in that of the first unknown.
    count : int ndarray, shape `shape`
        Number of equilibria found; zero is an answer.
    stable : bool ndarray, shape (*shape, branches)
        Whether the motion about the equilibrium decays; False where there is none.
    decay_rate : ndarray, shape (*shape, branches)
        -max Re(eigenvalue) there, 1/s, of all that does not stay as it is (see `held`) and on
        which something depends.
    singular : bool ndarray, shape `shape`
        Where a balance of moments does not depend on the slip angle (main gear at the CG and
        nothing at the tail): there is no equilibrium under a force, and without one every
        sideslip is an equilibrium. None is listed.
    searched : mapping of str to tuple of float
        Between what each unknown was sought, SI.
    complete : bool
        Whether it is proved that these are all equilibria in that range.
    left_out : int ndarray, shape `shape`
        Equilibria that are not given because a place that is to stay clear of the ground (a wing
        tip, the propeller) is through it.
    held : tuple of str
        States that something else holds: their rates need not vanish.
    reasons : tuple of str
        For each case why it has no equilibrium; empty if it has.
    given : mapping of str to ndarray
        States, inputs and parameters that the call named, by symbol.
    aircraft, model
        What was trimmed.
    """

    values: Mapping[str, FloatArray]
    count: npt.NDArray[np.int64]
    stable: BoolArray
    decay_rate: FloatArray
    singular: BoolArray
    searched: Mapping[str, tuple[float, float]]
    complete: bool
    left_out: npt.NDArray[np.int64]
    held: tuple[str, ...]
    reasons: tuple[str, ...]
    given: Mapping[str, FloatArray]
    aircraft: Aircraft
    model: ModelLike

    def __getitem__(self, name: str) -> FloatArray:
        return self.values[
            as_model(self.model).symbol(name, "state or output", tuple(self.values), "this trim")
        ]

    @property
    def slip(self) -> float:
        """Largest slip angle of the main tires that was searched, rad; infinite if that is any."""
        return self.searched.get("alpha", (-math.inf, math.inf))[1]

    @property
    def points(self) -> tuple[OperatingPoint, ...]:
        """Each equilibrium of a single case as an operating point for `linearize`.

        Raises
        ------
        GroundrollError
            If there are several cases; take their numbers from the arrays.
        """
        if self.count.ndim:
            raise GroundrollError(
                f"points are those of one aircraft, not of {self.count.shape}; the arrays"
                f" {' and '.join(self._moving)} hold all of them, and trim.point those of cases"
                " with one equilibrium"
            )
        return tuple(self._at(k) for k in range(int(self.count)))

    @property
    def point(self) -> OperatingPoint:
        """The equilibrium of each case, for `linearize`.

        Raises
        ------
        GroundrollError
            Unless every case has exactly one.
        """
        if (self.count == 1).all():
            return self._at(0)
        if self.count.ndim:
            where = tuple(int(i) for i in np.argwhere(self.count != 1)[0])
            which = f"case {where} has {self.count[where]}: choose from the arrays of the trim"
        elif self.count:
            which = f"there are {self.count}: choose one of trim.points"
        else:
            which = f"there is none: {self.reasons[0] or 'nothing balances'}"
        raise GroundrollError(f"a point needs one equilibrium, but {which}")

    @property
    def _moving(self) -> tuple[str, ...]:
        model = as_model(self.model)
        return tuple(s for s in (*model.states, *model.inputs) if s in self.values)

    def _at(self, branch: int) -> OperatingPoint:
        model = as_model(self.model)
        known = {**self.given, **{s: self.values[s][..., branch] for s in self._moving}}
        named = {s: model.quantities[s].name if s in model.inputs else s for s in known}
        return OperatingPoint(**{named[s]: x if np.ndim(x) else float(x) for s, x in known.items()})

    def _record(self) -> Record:
        runs, per = run_dims(self.count.shape), ("branch",)
        model, dims = as_model(self.model), (*runs, *per)
        q = {**model.quantities, "decay_rate": quantity_of("decay_rate")}
        rates = {"decay_rate": self.decay_rate}
        results = {s: measured(dims, v, q[s]) for s, v in {**self.values, **rates}.items()}
        results["stable"] = Column(dims, self.stable)
        results |= {name: Column(runs, getattr(self, name)) for name in _COUNTED}
        given = {s: np.asarray(x) for s, x in self.given.items() if s not in model.parameters}
        about = {
            "searched": {s: [str(end) for end in ends] for s, ends in self.searched.items()},
            "complete": self.complete,
            "held": list(self.held),
            "reasons": list(self.reasons),
        }
        return Record("trim", self.aircraft, model, runs, results, per, given, about)

    @classmethod
    def _of(cls, record: Record) -> Trim:
        results: dict[str, Any] = {s: column.values for s, column in record.results.items()}
        own = {name: results.pop(name) for name in ("stable", "decay_rate", *_COUNTED)}
        own |= {name: own[name].astype(np.int64) for name in ("count", "left_out")}
        about = record.about
        return cls(
            results,
            searched={s: (float(a), float(b)) for s, (a, b) in about["searched"].items()},
            complete=bool(about["complete"]),
            held=tuple(about["held"]),
            reasons=tuple(about["reasons"]),
            given=dict(record.given),
            aircraft=record.aircraft,
            model=record.model.key,
            **own,
        )

    def _title(self) -> str:
        model = as_model(self.model)
        head = f"Trim of {self.aircraft.name!r}, {model.name} model"
        if self.held:
            names = " and ".join(model.quantities[s].name for s in self.held)
            head += f", {names} held by something else"
        if self.count.ndim:
            few, many = self.count.min(), self.count.max()
            return f"{head}: {self.count.shape} cases with {few} to {many} equilibria"
        if self.singular:
            return (
                f"{head}: the balance of moments does not depend on the slip angle; no equilibrium"
                " under a side force, and any sideslip is one without"
            )
        noun = "equilibrium" if self.count <= 1 else "equilibria"
        where = "" if math.isinf(self.slip) else f" with |alpha| <= {math.degrees(self.slip):g} deg"
        why = f": {self.reasons[0]}" if self.reasons[0] else ""
        if self.left_out:
            why += f"; {self.left_out} left out, with a wing tip or the propeller in the ground"
        return f"{head}: {self.count or 'no'} {noun}{where}{why}"

    def _notes(self) -> Iterable[str]:
        return extrapolated_in(self.aircraft, self.values)

    def _rows(self) -> Iterable[Sequence[str]]:
        q = as_model(self.model).quantities
        for k in range(0 if self.count.ndim else int(self.count)):
            some = [s for s in self._moving if (self.values[s] != 0).any()]
            shown_ = [f"{s} {self.values[s][k]:.5g} {unit_of(q[s])}".rstrip() for s in some]
            if "alpha" in self.values:
                shown_.append(f"alpha {math.degrees(self['alpha'][k]):.4g} deg")
            yield (*shown_, "stable" if self.stable[k] else "unstable")


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
