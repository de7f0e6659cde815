"""What the aircraft will meet on the ground: speeds, CG, weight on the wheels, tires."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from groundroll.aircraft.aircraft import Aircraft
from groundroll.base.arrays import FloatArray, in_si
from groundroll.base.errors import GroundrollError
from groundroll.model.names import QUANTITIES, physical

#: Field of an envelope -> symbol.
AXES = {
    "speed": "u",
    "cg": "x_cg",
    "mass": "m",
    "weight_on_wheels": "w",
    "tail_load": "tau",
    "tire_wear": "eta",
}


@dataclass(frozen=True)
class Axis:
    """The values of one quantity that count: the ends of a range, or a set.

    Attributes
    ----------
    symbol : str
        Which quantity.
    values : ndarray
        SI units, increasing.
    is_range : bool
        Whether everything between the first and the last value counts too.
    """

    symbol: str
    values: FloatArray
    is_range: bool

    @property
    def low(self) -> float:
        """The least value."""
        return float(self.values[0])

    @property
    def high(self) -> float:
        """The greatest value."""
        return float(self.values[-1])

    def dense(self, count: int) -> FloatArray:
        """`count` values of a range, or the set."""
        return np.linspace(self.low, self.high, count) if self.is_range else self.values


@dataclass(frozen=True)
class Envelope:
    """Everything that the aircraft must cope with; the worst combination counts.

    Each field is a number, a *tuple of two* for a range with all that lies between, or a list,
    set or array for just these values. Strings with units are fine: ``("20 km/h", "110 km/h")``.

    Attributes
    ----------
    speed : optional
        Forward speed, m/s; default the aircraft's own.
    cg : optional
        Station of the CG behind the datum, m; default from `x_forward` to `x_aft` of the
        aircraft, or its one CG station if it has no limits.
    weight_on_wheels : optional
        Share of the weight on the wheels, above 0. With constant stiffness the main tires'
        goes in proportion (the thesis's half-static load is 0.5).
    tail_load : optional
        Load on the tail wheel over the one that follows from CG and gear: an elevator held back
        is above 1, held forward below 1 (Table 4.7 has 0.5, 1 and 2).
    tire_wear : optional
        Cornering stiffness of the tires over that of new ones.
    mass : optional
        Total mass, kg; default the aircraft's own. The yaw inertia does not follow it.
    lift : bool
        Whether lift takes weight off the wheels, by the square of speed over the aircraft's
        `lift_off_speed`.
    """

    speed: Any = None
    cg: Any = None
    weight_on_wheels: Any = 1.0
    tail_load: Any = 1.0
    tire_wear: Any = 1.0
    mass: Any = None
    lift: bool = False

    def __post_init__(self) -> None:
        for field in fields(self):
            value = getattr(self, field.name)
            if field.name in AXES and value is not None:
                _axis(field.name, value)

    def axes(self, plane: Aircraft) -> dict[str, Axis]:
        """The axes by symbol, with what is not given taken from an aircraft.

        Raises
        ------
        GroundrollError
            If the aircraft has not what is needed, or lift leaves no weight on the wheels.
        """
        given = {name: getattr(self, name) for name in AXES}
        defaults = {"speed": "u", "mass": "m"}
        for name, symbol in defaults.items():
            if given[name] is None:
                given[name] = _single(plane, symbol)
        if given["cg"] is None:
            given["cg"] = (
                (_single(plane, "x_forward"), _single(plane, "x_aft"))
                if "x_forward" in plane and "x_aft" in plane
                else _single(plane, "x_cg")
            )
        axes = {AXES[name]: _axis(name, value) for name, value in given.items()}
        if self.lift and axes["u"].high >= (limit := _single(plane, "u_lift")):
            raise GroundrollError(
                f"Envelope.speed goes to {axes['u'].high:g} m/s, but at lift_off_speed ="
                f" {limit:g} m/s no weight is left on the wheels: end the range below it"
            )
        return axes


def grid(axes: Mapping[str, Axis], budget: int) -> dict[str, FloatArray]:
    """All combinations, ranges filled with as many values as a budget of points allows.

    Returns
    -------
    dict of ndarray, shape (N,)
        One array for each axis.
    """
    ranges = [axis for axis in axes.values() if axis.is_range]
    fixed = np.prod([axis.values.size for axis in axes.values() if not axis.is_range])
    count = int((budget / fixed) ** (1 / len(ranges))) if ranges else 1
    # an odd number of points has the middle among them
    count = min(max(count | 1, 3), 801)
    return product({s: axis.dense(count) for s, axis in axes.items()})


def corners(axes: Mapping[str, Axis]) -> dict[str, FloatArray]:
    """Least and greatest values in all combinations, and the middle of a range of speeds."""
    values = {s: np.unique([axis.low, axis.high]) for s, axis in axes.items()}
    if axes["u"].is_range:
        values["u"] = axes["u"].dense(3)
    return product(values)


def product(values: Mapping[str, FloatArray]) -> dict[str, FloatArray]:
    """All combinations of values, as one flat array for each name."""
    mesh = np.meshgrid(*values.values(), indexing="ij")
    return {name: part.ravel() for name, part in zip(values, mesh, strict=True)}


def _single(plane: Aircraft, symbol: str) -> float:
    value = plane[symbol]
    if value.ndim:
        raise GroundrollError(
            f"place_gear places one gear: {QUANTITIES[symbol].name} ({symbol}) of aircraft"
            f" {plane.name} is an array of shape {value.shape}; give ranges in the Envelope"
        )
    return float(value)


def _axis(name: str, value: Any) -> Axis:
    symbol, label = AXES[name], f"Envelope.{name}"
    is_range = isinstance(value, tuple)
    members = value if isinstance(value, tuple | list | set | frozenset | np.ndarray) else [value]
    values = numbers(members, QUANTITIES[symbol].unit, label)
    if values.size == 0:
        raise GroundrollError(f"{label} is empty; give at least one value")
    if is_range and values.size != 2:
        raise GroundrollError(
            f"{label}: a tuple is a range and has two ends, not {values.size}; use a list for a set"
        )
    if is_range and values[0] > values[1]:
        raise GroundrollError(
            f"{label}: the range runs backwards, from {values[0]:g} to {values[1]:g}"
            f" {QUANTITIES[symbol].unit}; write the lower end first"
        )
    if symbol == "w" and values.min() <= 0:
        raise GroundrollError(
            f"{label} must stay above 0, but {values.min():g} is in it: a tire without load has"
            " no stiffness, and an aircraft without weight on its wheels is flying"
        )
    values = np.unique(physical(symbol, values))
    return Axis(symbol, values, is_range and values.size == 2)


def numbers(members: Any, unit: str, where: str) -> FloatArray:
    """Numbers, or strings with units, in an SI unit.

    Raises
    ------
    GroundrollError
        For anything that is neither.
    """
    return in_si(where, list(members), unit).reshape(-1)
