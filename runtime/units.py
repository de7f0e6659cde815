"""Units at the edge: strings such as ``"441.63 N/deg"`` become SI numbers with radians."""

from __future__ import annotations

import re
from functools import cache
from typing import Any

from .errors import GroundloopError

_NUMBER = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|[+-]?(?:inf|nan))\s*(.*?)\s*$")


@cache
def _registry() -> Any:
    import pint

    return pint.UnitRegistry()


def to_si(text: str, unit: str, where: str) -> float:
    """A number with a unit in the SI unit of a quantity.

    Parameters
    ----------
    text : str
        E.g. ``"100 km/h"``; a number alone is taken to be in `unit`.
    unit : str
        SI unit of the quantity, e.g. ``"m/s"``.
    where : str
        What is being read, for the error message.

    Raises
    ------
    GroundloopError
        If the text is no number with a unit, or the unit does not fit.
    """
    match = _NUMBER.match(text)
    if match is None:
        raise GroundloopError(
            f"{where}: {text!r} is not a number with a unit, such as '1.5 {unit}'"
        )
    number, given = float(match[1]), match[2]
    if not given:
        return number
    return number * _factor(given, unit, where)


def from_si(value: float, unit: str, wanted: str) -> float:
    """A number in an SI unit, expressed in another unit of the same dimension."""
    return value / _factor(wanted, unit, "unit")


@cache
def _factor(given: str, unit: str, where: str) -> float:
    import pint

    registry = _registry()
    try:
        found = registry.parse_units(given)
        return float(registry.Quantity(1.0, found).to(_parsed(unit)).magnitude)
    except pint.DimensionalityError:
        raise GroundloopError(f"{where}: {given!r} does not measure what {unit} measures") from None
    except Exception:
        raise GroundloopError(
            f"{where}: unknown unit {given!r}; expected one like {unit}"
        ) from None


def _parsed(unit: str) -> Any:
    return _registry().parse_units("" if unit == "1" else unit.replace(" ", "*"))
