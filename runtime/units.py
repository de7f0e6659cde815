"""Units at the edge: strings such as ``"441.63 N/deg"`` become SI numbers with radians."""

from __future__ import annotations

import difflib
import re
from functools import cache
from typing import Any

from .errors import UnexpectedError

_NUMBER = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|[+-]?(?:inf|nan))\s*(.*?)\s*$")

#: What a unit measures, in words.
_KINDS = {
    "kg": "a mass",
    "m": "a length",
    "m^2": "an area",
    "s": "a time",
    "m/s": "a speed",
    "m/s^2": "an acceleration",
    "kg m^2": "a moment of inertia",
    "kg/m^3": "a density",
    "N": "a force",
    "N m": "a moment",
    "N s": "an impulse",
    "N/rad": "a stiffness",
    "1/rad": "a slope over angle",
    "rad": "an angle",
    "rad/s": "a rate of turn",
    "1/s": "a rate",
    "1/N": "a slope over force",
    "1": "a pure number",
}

#: Names worth suggesting for a misspelt unit.
_COMMON = (
    *("m", "cm", "mm", "in", "ft", "kg", "g", "lb", "slug", "N", "kN", "lbf", "kgf", "s"),
    *("km/h", "kt", "mph", "m/s", "ft/s", "deg", "rad", "deg/s", "rad/s"),
)

#: Pint counts an angle as a pure number; a stiffness in N would pass for one in N/rad.
_ANGLES = frozenset(
    (
        *("radian", "milliradian", "degree", "arcminute", "arcsecond", "grade", "turn"),
        "revolutions_per_minute",
    )
)

#: A mass where a force belongs is mostly a slip of the unit's name.
_FORCE_OF = {"lb": "lbf", "kg": "kgf"}


class UnitError(UnexpectedError):
    """A text that is no number in a fitting unit."""


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
    UnitError
        If the text is no number with a unit, or the unit does not fit. An angle counts: N is
        not N/rad.
    """
    number, given = parts(text)
    if not number:
        raise UnitError(where, f"{text!r}, which is not a number with a unit", expected(unit))
    if not given:
        return float(number)
    try:
        return float(number) * _factor(given, unit)
    except UnitError as problem:
        raise UnitError(where, f"{text!r}, {problem.found}", problem.expected) from None


def parts(text: str) -> tuple[str, str]:
    """Number and unit of a text, both as they are written; nothing for what it does not have."""
    match = _NUMBER.match(text.replace("\N{MINUS SIGN}", "-"))
    return (match[1], match[2]) if match else ("", "")


def from_si(value: float, unit: str, wanted: str) -> float:
    """A number in an SI unit, expressed in another unit of the same dimension."""
    return value / _factor(wanted, unit)


def expected(unit: str) -> str:
    """What to write for a quantity, e.g. ``"a speed, such as '1.5 m/s'"``."""
    if unit == "1":
        return "a pure number, such as 1.5"
    return f"{_KINDS.get(unit, f'a number in {unit}')}, such as '1.5 {unit}'"


@cache
def _factor(given: str, unit: str) -> float:
    parsed = _parsed(given)
    if parsed is None:
        raise UnitError("unit", _unknown(given), expected(unit))
    target = _parsed("" if unit == "1" else unit.replace(" ", "*"))
    if _dimension(parsed) != _dimension(target):
        raise UnitError("unit", _kind(given), expected(unit) + _hint(given, target))
    return float(_registry().Quantity(1.0, parsed).to(target).magnitude)


@cache
def _registry() -> Any:
    import pint

    return pint.UnitRegistry()


def _parsed(text: str) -> Any:
    """The unit that pint reads in a text; None if it is none."""
    try:
        return _registry().parse_units(text)
    except Exception:  # pint raises half a dozen kinds, AssertionError among them
        return None


def _dimension(unit: Any) -> tuple[Any, float]:
    """Dimension and power of angle."""
    names = _registry().Quantity(1.0, unit).unit_items()
    return unit.dimensionality, sum(power for name, power in names if name in _ANGLES)


def _kind(given: str) -> str:
    """What a known unit measures, in words."""
    dimension = _dimension(_parsed(given))
    for unit, words in _KINDS.items():
        if _dimension(_parsed("" if unit == "1" else unit.replace(" ", "*"))) == dimension:
            return words
    return "which measures something else"


def _hint(given: str, target: Any) -> str:
    for mass, force in _FORCE_OF.items():
        meant = re.sub(rf"\b{mass}\b", force, given)
        if meant != given and _dimension(_parsed(meant)) == _dimension(target):
            return f" (as a force, {mass} is {force})"
    return ""


def _unknown(given: str) -> str:
    if given.startswith(","):
        return "with a comma (none between thousands, a point before decimals)"
    near = difflib.get_close_matches(given, _COMMON, n=2, cutoff=0.6)
    hint = f" (did you mean {' or '.join(near)}?)" if near else ""
    return f"with an unknown unit {given!r}{hint}"
