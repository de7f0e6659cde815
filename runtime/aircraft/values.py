"""What is given to a call by name, sorted by what it is in a model.

A parameter, an input and an initial state are all given alike: by symbol or full name, as a number
in SI units, an array, a text with a unit, or (an input) as something over time.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from groundroll.base.arrays import FloatArray, finite, physical_of
from groundroll.base.errors import GroundrollError, unknown
from groundroll.model.models import Model
from groundroll.model.names import PARAMETERS

from .aircraft import Aircraft


@dataclass(frozen=True)
class Given:
    """What a call was given.

    Attributes
    ----------
    aircraft : Aircraft
        With the parameters that the call changed.
    inputs : mapping of str to ndarray or callable
        By symbol: SI units with radians, or over time; what is not given is not here.
    states : mapping of str to ndarray
        By symbol, SI units with radians; what is not given is not here.
    """

    aircraft: Aircraft
    inputs: Mapping[str, Any]
    states: Mapping[str, FloatArray]


def given(
    plane: Aircraft,
    model: Model,
    values: Mapping[str, Any],
    where: str,
    *,
    others: tuple[str, ...] = (),
    over_time: bool = False,
    bare_states: bool = False,
) -> Given:
    """Sort values by what they are in a model.

    Parameters
    ----------
    plane : Aircraft
    model : Model
    values : mapping of str to anything
        By symbol or full name; an initial state also by symbol and a zero (``v0``). A value that
        is None is not given.
    where : str
        The function that was called, for messages.
    others : tuple of str
        Further arguments of that function, to be named in hints.
    over_time : bool
        Whether an input may be a function of time.
    bare_states : bool
        Whether a state may be called by its symbol alone, as at an operating point.

    Raises
    ------
    GroundrollError
        For an unknown name, naming the nearest, one given twice, or a value that cannot be.
    """
    table = _table(model, bare_states)
    found: dict[str, dict[str, Any]] = {"input": {}, "parameter": {}, "state": {}}
    names: dict[tuple[str, str], str] = {}
    own = dict(plane.own)
    for name, value in values.items():
        if value is None:
            continue
        if name not in table:
            raise unknown("argument", name, [*table, *others], where)
        kind, symbol = table[name]
        if (kind, symbol) in names:
            first = names[kind, symbol]
            raise GroundrollError(f"{first} and {name} are the same {kind}; give one of them")
        names[kind, symbol] = name
        found[kind][symbol] = value
    changes, of_its_own = {}, {}
    for s, value in found["parameter"].items():
        if s in PARAMETERS and PARAMETERS[s].unit == _unit(model, s) and s not in own:
            changes[s] = value
        else:
            of_its_own[s] = physical_of(model.quantities[s], value)
    aircraft = plane.replace(**changes) if changes else plane
    if of_its_own:
        aircraft = aircraft.with_own({**own, **of_its_own})
    return Given(
        aircraft,
        {s: _input(model, s, v, over_time, names) for s, v in found["input"].items()},
        {
            s: finite(names["state", s], v, model.quantities[s].unit)
            for s, v in found["state"].items()
        },
    )


def kind_of(model: Model, name: str, where: str) -> tuple[str, str]:
    """What a name is in a model, ``"input"``, ``"parameter"`` or ``"state"``, and its symbol.

    An initial state is called by its symbol and a zero, or its full name.

    Raises
    ------
    UnknownNameError
        If it is none of these; the message names the nearest.
    """
    table = _table(model, bare_states=False)
    if name not in table:
        raise unknown("argument", name, table, where)
    return table[name]


def _table(model: Model, bare_states: bool) -> dict[str, tuple[str, str]]:
    """Name -> what it is and its symbol: an input before a parameter, that before a state.

    Whatever may be given to an aircraft may be given here too: parameters follow from it.
    """
    q = model.quantities
    table: dict[str, tuple[str, str]] = {}
    for s, known in PARAMETERS.items():
        if s not in model.states:
            table |= dict.fromkeys((known.name, s), ("parameter", s))
    for s in model.states:
        table |= dict.fromkeys((q[s].name, f"{s}0"), ("state", s))
        if bare_states:
            table[s] = ("state", s)
    for s in model.parameters:
        table |= dict.fromkeys((q[s].name, s), ("parameter", s))
    for s in model.inputs:
        table |= dict.fromkeys((q[s].name, s), ("input", s))
    return table


def _unit(model: Model, s: str) -> str:
    return model.quantities[s].unit if s in model.quantities else PARAMETERS[s].unit


def _input(
    model: Model, s: str, value: Any, over_time: bool, names: Mapping[tuple[str, str], str]
) -> Any:
    if callable(value):
        if over_time:
            return value
        raise GroundrollError(f"{names['input', s]} must be constant here, not a function of time")
    array = finite(names["input", s], value, model.quantities[s].unit)
    refuse_beyond(model, s, array)
    return array


def refuse_beyond(model: Model, s: str, value: FloatArray, rounding: float = 1e-9) -> None:
    """Refuse what an input of a model cannot be, such as a brake that is more than locked.

    Raises
    ------
    GroundrollError
        If a value is beyond the input's range by more than a rounding.
    """
    low, high = model.ranges.get(s, (-np.inf, np.inf))
    beyond = np.maximum(low - value, value - high)
    if beyond.max() > rounding:
        q = model.quantities[s]
        span = f"from {low:g} to {high:g}" if np.isfinite(high) else f"at least {low:g}"
        unit = "" if q.unit == "1" else f" {q.unit}"
        label = q.name if q.name == s else f"{q.name} ({s})"
        worst = value.ravel()[beyond.argmax()]
        raise GroundrollError(f"{label} must be {span}{unit}, but it is {worst:g}: {q.meaning}")
