"""Where a model is linearised: states, inputs and parameters by name."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from groundroll.aircraft.aircraft import Aircraft
from groundroll.aircraft.parameters import parameters_of
from groundroll.aircraft.values import Given, given
from groundroll.base.arrays import FloatArray, common_shape
from groundroll.base.errors import GroundrollError
from groundroll.model.models import Model
from groundroll.motion.rest import start_of

from .points import Points


class OperatingPoint(Mapping[str, Any]):
    """A state of motion and what acts on it, by symbol or full name; the rest is zero.

    ``OperatingPoint(v=0.4, r="2 deg/s", disturbance="70 lbf")``; an entry is an attribute too.
    A free speed that is not named is the aircraft's own.
    """

    def __init__(self, **values: Any) -> None:
        self._values = dict(values)

    def __getitem__(self, name: str) -> Any:
        return self._values[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name not in self._values:
            raise AttributeError(f"this operating point has no {name!r}; it has {list(self)}")
        return self._values[name]

    def __hash__(self) -> int:
        return hash(tuple(self._values))

    def __reduce__(self) -> tuple[Any, ...]:
        return _operating_point, (self._values,)

    def __repr__(self) -> str:
        said = ", ".join(f"{name}={_said(value)}" for name, value in self._values.items())
        return f"OperatingPoint({said})"


def _operating_point(values: dict[str, Any]) -> OperatingPoint:
    return OperatingPoint(**values)


def _said(value: Any) -> str:
    array = np.asarray(value)
    return f"{float(array)!r}" if array.ndim == 0 else f"array {array.shape}"


def operating_point(points: Points) -> OperatingPoint:
    """Dynamic states by symbol and inputs by full name, SI units with radians."""
    q, model = points.model.quantities, points.model
    named = {s: points.values[s] for s in model.dynamic}
    named |= {s: points.values[s] for s in model.states if np.any(points.values[s])}
    named |= {q[s].name: points.values[s] for s in model.inputs}
    return OperatingPoint(**{s: x if x.ndim else float(x) for s, x in named.items()})


def sorted_at(
    plane: Aircraft,
    model: Model,
    at: Any,
    values: Mapping[str, Any],
    where: str,
) -> Given:
    """What a call was given, sorted.

    Parameters
    ----------
    plane : Aircraft
    model : Model
    at : mapping of str to anything, or Trim, optional
        States, inputs and parameters by symbol or full name.
    values : mapping of str to anything
        The same, given as keywords; they come before `at`.
    where : str
        The function that was called, for messages.
    """
    at = getattr(at, "point", at)  # of a trim
    if at is not None and not isinstance(at, Mapping):
        raise GroundrollError(
            f"at must be an OperatingPoint, or values by name, not {type(at).__name__}"
        )
    merged = {**(at or {}), **{k: x for k, x in values.items() if x is not None}}
    return given(plane, model, merged, where, bare_states=True)


def points_at(
    plane: Aircraft, model: Model, at: Any, values: Mapping[str, Any], where: str
) -> Points:
    """Operating points from what a call was given: see `sorted_at`."""
    return points_of(model, sorted_at(plane, model, at, values, where))


def points_of(model: Model, found: Given) -> Points:
    """Operating points from values that are sorted.

    A state that is not given is where a motion starts: the aircraft's own speed where that is
    free, the rest of a body on its legs, or zero.
    """
    zero = np.asarray(0.0)
    known = parameters_of(found.aircraft, model)
    values: dict[str, FloatArray] = dict(start_of(found.aircraft, model, found.states))
    for s in model.inputs:
        values[s] = found.inputs.get(s, zero)
    shape = common_shape({**values, **known})
    if 0 in shape:
        raise GroundrollError(f"nothing is given: the arrays broadcast to {shape}")
    # a state may share its symbol with a parameter of another model, never of its own
    return Points(model, found.aircraft, {**values, **known}, shape)
