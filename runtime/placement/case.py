"""A placement problem with every number resolved, and what a design is worth at a corner."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import casadi as ca
import numpy as np

from groundroll import generated
from groundroll.aircraft.aircraft import Aircraft
from groundroll.base.arrays import FloatArray, broadcast
from groundroll.model.models import ModelLike

from .envelope import AXES, Axis
from .limits import Bound

#: What may be placed or sized, by the name that people use.
VARIABLES = {
    "main_gear_station": "x_main",
    "nose_wheel_station": "x_nose",
    "tail_station": "x_tail",
    "tail_area": "Ap",
    "tail_wheel_scale": "kappa",
}
DESIGN = tuple(VARIABLES.values())
#: Layout -> where the third wheel is.
THIRD = {"taildragger": "x_tail", "tricycle": "x_nose"}

Corner = Mapping[str, Any]
_GIVEN = (*DESIGN, *AXES.values())


@dataclass(frozen=True)
class Variable:
    """What the placement may choose, between bounds in SI units."""

    name: str
    symbol: str
    low: float
    high: float


@dataclass(frozen=True)
class Case:
    """A placement problem in numbers.

    Attributes
    ----------
    plane : Aircraft
        The aircraft as it is today.
    layout : str
        ``"taildragger"`` or ``"tricycle"``.
    stiffness : str
        ``"constant"`` or ``"following"``.
    objective : str
        One of `OBJECTIVES`.
    axes : mapping of str to Axis
        The envelope.
    variables : tuple of Variable
        What is chosen.
    bounds : tuple of Bound
        The limits.
    today : mapping of str to float
        Today's design by symbol; NaN for a nose wheel that there is not.
    numbers : mapping of str to float
        Whatever else the equations need, by symbol; NaN for what is not known.
    model, v0, duration
        The run that the displacement is read off: model, initial lateral velocity in m/s, s.
    """

    plane: Aircraft
    layout: str
    stiffness: str
    objective: str
    axes: Mapping[str, Axis]
    variables: tuple[Variable, ...]
    bounds: tuple[Bound, ...]
    today: Mapping[str, float]
    numbers: Mapping[str, float]
    model: ModelLike
    v0: float
    duration: float

    def design(self, chosen: Mapping[str, float]) -> dict[str, float]:
        """A whole design from what is chosen."""
        return {**self.today, **chosen}

    def values(self, design: Mapping[str, Any], corner: Corner) -> dict[str, FloatArray]:
        """Everything that follows from a design at a corner, element by element.

        Arms, loads, stiffnesses, angles, eigenvalues, decay rate and damping ratio (NaN where
        det A < 0), by symbol.
        """
        given = {**design, **corner}
        arrays, shape = broadcast({s: np.asarray(given[s], dtype=np.float64) for s in _GIVEN})
        columns = np.stack([array.ravel() for array in arrays.values()])
        count = columns.shape[1]
        if count not in self._maps:
            self._maps[count] = self._everything.map("all", "serial", count, [1], [])
        rows = np.array(self._maps[count](columns, list(self.numbers.values())))
        names = self._names
        return {s: row.reshape(shape) for s, row in zip(names, rows, strict=True)}

    @cached_property
    def _maps(self) -> dict[int, ca.Function]:
        """`_everything` by the number of points: making a map costs more than a few calls."""
        return {}

    @cached_property
    def _everything(self) -> ca.Function:
        """One function for all that `values` gives: CasADi is quick per point, not per call."""
        given = ca.SX.sym("given", len(_GIVEN))
        numbers = ca.SX.sym("numbers", len(self.numbers))
        named = {**split(numbers, tuple(self.numbers)), **split(given, _GIVEN)}
        values = self._linked(named)
        results = ca.vertcat(*(values[s] for s in self._names))
        return ca.Function("everything", [given, numbers], [results])

    @cached_property
    def _names(self) -> tuple[str, ...]:
        return tuple(self._linked({s: ca.SX.sym(s) for s in (*self.numbers, *_GIVEN)}))

    def _linked(self, named: Mapping[str, Any]) -> dict[str, Any]:
        values = self.link(named)
        for function in ("state_matrix", "modes"):
            values |= symbolic(function, values)
        return values

    def link(self, named: Mapping[str, Any]) -> dict[str, Any]:
        """Stations to loads, stiffnesses and angles, as CasADi expressions by symbol."""
        values = {**named, "x_third": named[THIRD[self.layout]]}
        for function in (f"placement_{self.stiffness}", "placement_tire", "placement_limits"):
            values |= symbolic(function, values)
        return values

    def aircraft(self, design: Mapping[str, float], corner: Corner) -> Aircraft:
        """The aircraft of a design at a corner, ready to be simulated."""
        values = self.values(design, corner)
        changes: dict[str, Any] = {
            s: values[s] for s in ("x_main", "x_tail", "x_cg", "Ap", "u", "m")
        }
        changes |= {s: values[s] for s in ("a", "b", "C_alpha", "Ct", "Fz")}
        changes |= {"B3": values["B3_worn"], "C3": values["C3_worn"], "f": None}
        return self.plane.replace(**changes)


def symbolic(name: str, values: Mapping[str, Any]) -> dict[str, Any]:
    """A generated function put into CasADi expressions, results by name."""
    function = generated.build(name)
    results = function.call([values[s] for s in function.name_in()])
    return dict(zip(function.name_out(), results, strict=True))


def vector(values: Mapping[str, float], names: tuple[str, ...]) -> FloatArray:
    """Values in the order of names."""
    return np.array([values[s] for s in names], dtype=np.float64)


def split(symbols: Any, names: tuple[str, ...]) -> dict[str, Any]:
    """A CasADi vector as named scalars."""
    return dict(zip(names, ca.vertsplit(symbols), strict=True))
