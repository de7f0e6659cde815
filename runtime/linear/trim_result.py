"""What `trim` finds: equilibria, and why there are none."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from groundroll.aircraft.aircraft import Aircraft
from groundroll.aircraft.validity import extrapolated_in
from groundroll.base.arrays import FloatArray
from groundroll.base.errors import GroundrollError
from groundroll.base.listing import Listed, unit_of
from groundroll.model.models import ModelLike, as_model
from groundroll.results.records import Column, Record, measured, run_dims
from groundroll.results.results import Result
from groundroll.stability.closed_forms import quantity_of

from .operating_point import OperatingPoint

BoolArray = npt.NDArray[np.bool_]

#: What is said of each case.
_COUNTED = ("count", "left_out", "singular")


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
