"""Branches of equilibria over a speed, a wind, a control or a design parameter."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import numpy.typing as npt

from groundroll.aircraft.aircraft import Aircraft, of_aircraft
from groundroll.aircraft.values import kind_of
from groundroll.base.arrays import FloatArray, whole
from groundroll.base.errors import GroundrollError
from groundroll.base.listing import Listed, unit_of
from groundroll.base.wording import number
from groundroll.generated import Quantity
from groundroll.model.models import Model, ModelLike, as_model
from groundroll.model.names import PARAMETERS
from groundroll.results.doors import drawn
from groundroll.results.records import Column, Record, measured
from groundroll.results.results import Result
from groundroll.stability.closed_forms import quantity_of
from groundroll.stability.modes import modes_of

from .conditions import named, pair_of, question_of, ranges_of, sought
from .continuation import Curve, Follower
from .operating_point import OperatingPoint, points_of, sorted_at
from .points import Points
from .scaled_system import SPAN, ScaledSystem, placed
from .trimming import STARTS, is_clear, trim

if TYPE_CHECKING:
    from matplotlib.axes import Axes

BoolArray = npt.NDArray[np.bool_]

#: At how many values of the parameter equilibria are sought from which branches are followed.
SEEDS = 9
_WORDS = {"fold": "fold", "hopf": "Hopf point", "branch_point": "branch point"}


class Mark(NamedTuple):
    """What a point of a branch is: ``fold``, ``hopf`` or ``branch_point``.

    At a fold two equilibria meet and vanish; at a Hopf point an oscillation stops decaying; at a
    branch point two branches cross.
    """

    kind: str
    branch: int
    point: int


@dataclass(frozen=True, repr=False)
class Branches(Listed, Result):
    """Branches of equilibria; ``branches["r"]`` holds that quantity along all of them.

    Attributes
    ----------
    over : str
        Symbol of what is varied: a state that is given, an input or a parameter.
    values : mapping of str to ndarray, shape (branches, points)
        What is varied, dynamic states, inputs that were asked for and every output by symbol, in
        order along each branch, SI units with radians; NaN behind the last point.
    stable : bool ndarray, shape (branches, points)
        Whether the motion about the equilibrium decays.
    decay_rate : ndarray, shape (branches, points)
        -max Re(eigenvalue), 1/s, as in `Trim`.
    marks : tuple of Mark
        Folds, Hopf points and branch points, in order.
    ends : tuple of (str, str)
        For each branch why it begins and ends: ``range`` (of what is varied), ``closed`` (it comes
        back to where it began), the symbol of an unknown that reaches its limit, ``far`` (a
        coordinate grows beyond all bounds), ``struck`` (a wing tip or the propeller meets the
        ground), or ``lost`` (no equilibrium was found farther on).
    held : tuple of str
        States that something else holds: their rates need not vanish.
    given : mapping of str to ndarray
        States, inputs and parameters that the call named, by symbol.
    aircraft, model
        Whose equilibria these are.
    """

    over: str
    values: Mapping[str, FloatArray]
    stable: BoolArray
    decay_rate: FloatArray
    marks: tuple[Mark, ...]
    ends: tuple[tuple[str, str], ...]
    held: tuple[str, ...]
    given: Mapping[str, FloatArray]
    aircraft: Aircraft
    model: ModelLike

    def __getitem__(self, name: str) -> FloatArray:
        allowed = tuple(self.values)
        if name in (self.over, self._quantity.name):
            return self.values[self.over]
        return self.values[
            as_model(self.model).symbol(name, "state or output", allowed, "these branches")
        ]

    def __len__(self) -> int:
        return len(self.ends)

    @property
    def _quantity(self) -> Quantity:
        return _known(as_model(self.model))[self.over]

    def at(self, branch: int, point: int) -> OperatingPoint:
        """One of the equilibria as an operating point for `linearize`."""
        model = as_model(self.model)
        known = {**self.given, self.over: self.values[self.over][branch, point]}
        for s in (*model.states, *model.inputs):
            if s in self.values:
                known[s] = self.values[s][branch, point]
        names = {s: model.quantities[s].name if s in model.inputs else s for s in known}
        return OperatingPoint(**{names[s]: float(x) for s, x in known.items()})

    def plot(self, of: str | None = None, ax: Axes | None = None) -> Axes:
        """Draw a quantity over what is varied: stable branches as full lines, others dashed.

        Parameters
        ----------
        of : str, optional
            Symbol or full name; by default the yaw rate, or the first unknown of the model.
        ax : matplotlib Axes, optional
            Where to draw; new axes if omitted.
        """
        axes: Axes = drawn("branches", self, of, ax)
        return axes

    def _record(self) -> Record:
        model, dims = as_model(self.model), ("branch", "point")
        q = {**_known(model), "decay_rate": quantity_of("decay_rate")}
        every = {**self.values, "decay_rate": self.decay_rate}
        results = {s: measured(dims, x, q[s]) for s, x in every.items()}
        results["stable"] = Column(dims, self.stable)
        given = {s: np.asarray(x) for s, x in self.given.items() if s not in PARAMETERS}
        about = {
            "over": self.over,
            "marks": [list(mark) for mark in self.marks],
            "ends": [list(pair) for pair in self.ends],
            "held": list(self.held),
        }
        return Record("branches", self.aircraft, model, (), results, dims, given, about)

    @classmethod
    def _of(cls, record: Record) -> Branches:
        results: dict[str, Any] = {s: column.values for s, column in record.results.items()}
        own = {name: results.pop(name) for name in ("stable", "decay_rate")}
        about = record.about
        return cls(
            over=str(about["over"]),
            values=results,
            marks=tuple(Mark(str(s), int(b), int(k)) for s, b, k in about["marks"]),
            ends=tuple((str(a), str(b)) for a, b in about["ends"]),
            held=tuple(about["held"]),
            given=dict(record.given),
            aircraft=record.aircraft,
            model=record.model.key,
            **own,
        )

    def _title(self) -> str:
        model = as_model(self.model)
        head = f"Branches of {self.aircraft.name!r}, {model.name} model"
        if self.held:
            names = " and ".join(model.quantities[s].name for s in self.held)
            head += f", {names} held by something else"
        noun = "branch" if len(self) == 1 else "branches"
        return f"{head}, over {self._quantity.name}: {len(self) or 'no'} {noun}"

    def _rows(self) -> Iterable[Sequence[str]]:
        unit = unit_of(self._quantity)
        for b, (begin, end) in enumerate(self.ends):
            along = self.values[self.over][b]
            last = int(np.isfinite(along).sum()) - 1
            share = self.stable[b, : last + 1].mean()
            how = "stable" if share == 1 else "unstable" if share == 0 else "stable in part"
            ends = f"{number(along[0])} ({begin}) to {number(along[last])} {unit} ({end})"
            marks = [
                f"{_WORDS[mark.kind]} at {number(along[mark.point])} {unit}".rstrip()
                for mark in self.marks
                if mark.branch == b
            ]
            yield f"branch {b}", ends, how, ", ".join(marks)


@of_aircraft
def branches(
    plane: Aircraft,
    over: str,
    between: Sequence[Any],
    model: ModelLike = "nonlinear",
    at: Mapping[str, Any] | None = None,
    *,
    solve_for: Iterable[str] = (),
    within: Mapping[str, Any] | None = None,
    seeds: int = SEEDS,
    starts: int = STARTS,
    **values: Any,
) -> Branches:
    """Follow the equilibria of an aircraft over a speed, a wind, a control or a parameter.

    Equilibria are sought by `trim` at some values in the range; from each its branch is followed
    to both sides by pseudo-arclength, around folds and onto the branches that it crosses. Folds,
    Hopf points and branch points are found to about 1e-6 of the range.

    Parameters
    ----------
    plane : Aircraft
        The aircraft; none of its parameters may be an array.
    over : str
        Symbol or full name of what is varied: ``"speed"``, ``"crosswind"``, ``"pedal"``, any
        parameter of the aircraft; what follows from that follows.
    between : pair of float or str
        From where to where.
    model : str or Model
        A model that ships, a folder, or what `Model.load` gives.
    at, **values
        What else is given, as for `trim`.
    solve_for, within, starts
        As for `trim`. A branch ends where an unknown leaves its range.
    seeds : int
        At how many values, both ends among them, equilibria are sought at first. A branch that
        crosses no other and lies between two of them is missed.

    Returns
    -------
    Branches
        There may be none.

    Raises
    ------
    GroundrollError
        For unknown names, values that cannot be, or more or fewer unknowns than conditions.
    """
    chosen = as_model(model)
    s = _symbol(chosen, over)
    q = _known(chosen)[s]
    low, high = pair_of(f"the range of {q.name}", between, q.unit)
    given = {**(at or {}), **values}
    grid = np.linspace(low, high, whole("seeds", seeds, 2))
    found = sorted_at(plane, chosen, {**given, over: grid}, {}, "branches")
    ranges, inputs = ranges_of(chosen, within), sought(chosen, found, solve_for)
    points = points_of(chosen, found)
    if points.shape != grid.shape:
        raise GroundrollError(
            "branches are those of one aircraft under one set of values, but arrays give them the"
            f" shape {points.shape[:-1]}"
        )
    question, held, idle = question_of(points, found, inputs, ranges)
    moving = tuple(x for x in chosen.dynamic if x not in (*held, *idle))

    def each(at: FloatArray) -> Points:
        here = sorted_at(plane, chosen, {**given, over: at}, {}, "branches")
        return replace(points_of(chosen, here), shape=at.shape)

    place = placed(points, s, question.unknown, each)
    begin = trim(
        plane, chosen, {**given, over: grid}, solve_for=inputs, within=within, starts=starts
    )
    steps = ScaledSystem(place, question, moving, low, high)
    first = [
        np.append([begin.values[x][i, k] for x in question.unknown] / steps.widths, share)
        for i, share in enumerate(np.linspace(0.0, SPAN, grid.size))
        for k in range(int(begin.count[i]))
    ]
    limits = {
        x: (k, end / steps.widths[k])
        for k, x in enumerate(question.unknown)
        for end in ranges.get(x, ())
        if math.isfinite(end)
    }
    curves = Follower(steps, SPAN, limits).curves(first)
    alone = sorted_at(plane, chosen, given, {}, "branches")
    return _told(steps, curves, over=s, held=held, given=named(plane, alone), aircraft=plane)


def _known(model: Model) -> dict[str, Quantity]:
    return {**PARAMETERS, **model.quantities}


def _symbol(model: Model, name: str) -> str:
    return name if name in model.states else kind_of(model, name, "branches")[1]


def _told(steps: ScaledSystem, curves: Sequence[Curve], over: str, **about: Any) -> Branches:
    model = steps.model
    every = np.concatenate([c.points for c in curves]) if curves else np.empty((0, 1))
    names = dict.fromkeys((over, *model.dynamic, *steps.question.unknown, *model.outputs))
    columns: dict[str, FloatArray] = {s: np.empty(0) for s in (*names, "decay_rate")}
    if len(every):
        points = steps.points(every[:, :-1], every[:, -1])
        found = points.evaluate("g", "fx", over=steps.moving)
        known = {**points.values, **dict(zip(model.outputs, found["g"].T, strict=True))}
        known[over] = steps.over(every[:, -1])
        columns = {s: np.broadcast_to(known[s], len(every)) + 0.0 for s in names}
        columns["decay_rate"] = modes_of(found["fx"]).decay_rate
    pieces = list(_pieces(curves, is_clear(model, columns)))
    longest = max((piece.stop - piece.start for piece in pieces), default=0)
    tables = {s: np.full((len(pieces), longest), np.nan) for s in columns}
    for b, piece in enumerate(pieces):
        for s, column in columns.items():
            tables[s][b, : piece.stop - piece.start] = column[piece.start : piece.stop]
    decay = tables.pop("decay_rate")
    return Branches(
        over=over,
        values=tables,
        stable=decay > 0,
        decay_rate=decay,
        marks=tuple(Mark(kind, b, k) for b, piece in enumerate(pieces) for kind, k in piece.marks),
        ends=tuple(piece.ends for piece in pieces),
        model=model.key,
        **about,
    )


class _Piece(NamedTuple):
    """A part of a curve, from where to where in the list of all points."""

    start: int
    stop: int
    marks: tuple[tuple[str, int], ...]
    ends: tuple[str, str]


def _pieces(curves: Sequence[Curve], clear: BoolArray) -> Iterator[_Piece]:
    """The parts of curves on which nothing is through the ground that should not be."""
    begin = 0
    for curve in curves:
        end = begin + len(curve.points)
        edges = np.flatnonzero(np.diff(np.concatenate([[0], clear[begin:end], [0]])))
        for first, last in edges.reshape(-1, 2):
            marks = tuple((kind, k - first) for kind, k in curve.marks if first <= k < last)
            ends = (
                curve.ends[0] if first == 0 else "struck",
                curve.ends[1] if last == len(curve.points) else "struck",
            )
            yield _Piece(begin + int(first), begin + int(last), marks, ends)
        begin = end
