"""Units at the edge: strings such as ``"441.63 N/deg"`` become SI numbers with radians."""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable
from functools import cache, lru_cache
from typing import Any

from .errors import UnexpectedError

#: A number, and what follows it.
_NUMBER = re.compile(r"([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|[+-]?(?:inf|nan)\b)\s*(.*)", re.S)
#: Between the parts of "17 ft 2 in".
_NEXT = re.compile(r"(?<=[^\W\d])\s+(?=\d[\d.]*\s*[^\W\d])")
#: What units are made of. A power has one digit, and none of its own: pint computes any.
_TOKEN = re.compile(
    r"\s*(?:(?P<name>[^\W\d]\w*|[%\u2030\u00b0])(?:\^(?P<power>[+-]?\d(?:\.\d{1,3})?)(?![\w.^]))?"
    r"|(?P<sign>1(?![\w.^])|[*/()]))\s*"
)
#: Spellings of a product and of powers.
_SPELT = (
    (re.compile(r"\s*(?:\*\*|\^)\s*"), "^"),
    (re.compile(r"\bper\b"), "/"),
    (re.compile(r"(?i)\bsq(?:uare\b|\.|\b)\s*(\w+)"), r"\1^2"),
    (re.compile(r"[\u00b7\u22c5\u00d7]|(?<=[^\W\d])-(?=[^\W\d])"), "*"),
    (re.compile(r"\^\(([^()]*)\)"), r"^\1"),
    (re.compile(r"([\u207b]?)([\u00b9\u00b2\u00b3\u2074])"), r"^\1\2"),
)
_RAISED = str.maketrans("\u207b\u00b9\u00b2\u00b3\u2074", "-1234")
_LONGEST = 100

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
    "N/m^2": "a pressure",
    "1": "a pure number",
}

#: Names worth suggesting for a misspelt unit, and read in capitals too.
_COMMON = (
    *("m", "cm", "mm", "km", "in", "ft", "kg", "g", "lb", "lbs", "slug", "N", "kN", "lbf", "kgf"),
    *("s", "sec", "min", "h", "km/h", "kt", "kts", "mph", "m/s", "ft/s", "deg", "rad", "deg/s"),
    *("rad/s", "psi", "Pa", "kPa", "bar"),
)
_CAPITALS = {name.lower(): name for name in _COMMON}

#: A mass where a force belongs is mostly a slip of the unit's name.
_FORCE_OF = {"lb": "lbf", "kg": "kgf"}


class UnitError(UnexpectedError):
    """A text that is no number in a fitting unit."""


def to_si(text: str, unit: str, where: str) -> float:
    """A number with a unit in the SI unit of a quantity.

    Parameters
    ----------
    text : str
        E.g. ``"100 km/h"`` or ``"17 ft 2 in"``; a number alone is taken to be in `unit`.
    unit : str
        SI unit of the quantity, e.g. ``"m/s"``.
    where : str
        What is being read, for the error message.

    Raises
    ------
    UnitError
        If the text is no number with a unit, or the unit does not fit. An angle counts: N is
        not N/rad. Nor does a unit with a zero of its own (dB, degC).
    """
    shown = repr(text if len(text) <= 60 else f"{text[:57]}...")
    pieces = [_split(piece) for piece in _pieces(text)]
    if not all(number for number, _ in pieces):
        raise UnitError(where, f"{shown}, which is not a number with a unit", expected(unit))
    try:
        return _sum(pieces, unit)
    except UnitError as problem:
        raise UnitError(where, f"{shown}, {problem.found}", problem.expected) from None


def parts(text: str) -> tuple[str, str]:
    """Number and unit of a text, both as they are written; nothing for what it does not have.

    The number of "17 ft 2 in" is "17 ft 2".
    """
    *above, last = _pieces(text)
    number, unit = _split(last)
    return " ".join([*above, number]) if number else "", unit


def from_si(value: float, unit: str, wanted: str) -> float:
    """A number in an SI unit, expressed in another unit of the same dimension."""
    return value / _factor(wanted, unit)


def kind(unit: str) -> str:
    """What a quantity in an SI unit is, in words; nothing if there is no word for it."""
    return _KINDS.get(unit, "")


def exponents(unit: str) -> dict[str, int]:
    """Powers of kg, m, s and rad in an SI unit, those that are not zero."""
    names = {"gram": "kg", "meter": "m", "second": "s", "radian": "rad"}
    items = _registry().Quantity(1.0, _own(unit)[1]).unit_items()
    return {names[name]: int(power) for name, power in items}


def expected(unit: str) -> str:
    """What to write for a quantity, e.g. ``"a speed, such as '1.5 m/s'"``."""
    if unit == "1":
        return "a pure number, such as 1.5"
    example = "42 psi" if unit == "N/m^2" else f"1.5 {unit}"
    return f"{_KINDS.get(unit, f'a number in {unit}')}, such as '{example}'"


def _pieces(text: str) -> list[str]:
    """A text, or the parts of one such as "17 ft 2 in"; one that is no text for a number is one."""
    if len(text) > _LONGEST:
        return [""]
    return _NEXT.split(text.replace("\N{MINUS SIGN}", "-").strip())


def _split(piece: str) -> tuple[str, str]:
    match = _NUMBER.fullmatch(piece)
    return (match[1], match[2]) if match else ("", "")


def _sum(pieces: list[tuple[str, str]], unit: str) -> float:
    """A number with its unit, or several, each of less than one of the unit before it."""
    (number, given), *more = pieces
    value, last = abs(float(number)), _factor(given, unit) if given or more else 1.0
    value *= last
    for smaller, name in more:
        factor = _factor(name, unit)
        part = float(smaller) * factor
        if not part < last:
            raise UnitError("unit", f"of which {smaller} {name} is too much", expected(unit))
        value, last = value + part, factor
    return -value if number.startswith("-") else value


@lru_cache(maxsize=1024)
def _factor(given: str, unit: str) -> float:
    """How many of an SI unit one of a given unit is."""
    parsed = _parsed(given)
    if parsed is None:
        raise UnitError("unit", _unknown(given), expected(unit))
    factor, dimension = parsed
    target, wanted = _own(unit)
    if dimension != wanted:
        raise UnitError("unit", _kind(dimension), expected(unit) + _hint(given, wanted))
    return factor if unit == "1" else factor / target


@cache
def _registry() -> Any:
    import pint

    registry = pint.UnitRegistry(on_redefinition="ignore")
    registry.define("mil = pi / 3200 * radian")  # pint has a tenth of it
    return registry


@cache
def _own(unit: str) -> tuple[float, Any]:
    """Factor and dimension of a unit of this package."""
    parsed = _root("" if unit == "1" else unit.replace(" ", "*"))
    assert parsed is not None, unit
    return parsed


def _root(text: str) -> tuple[float, Any] | None:
    """A unit as a multiple of pint's root units; None if it is none.

    Root units keep the radian, which pint counts as a pure number, so that N is not N/rad. What
    is not zero at zero is no multiple: a logarithm, or a temperature.
    """
    unit = _of_pint(text)
    if unit is None:
        return None
    try:
        zero, root = (_registry().Quantity(x, unit).to_root_units() for x in (0.0, 1.0))
    except Exception:  # an offset within a product
        return None
    return None if zero.magnitude else (float(root.magnitude), root.units)


def _of_pint(text: str) -> Any:
    try:
        return _registry().parse_units(text)
    except Exception:  # pint raises half a dozen kinds, AssertionError among them
        return None


def _parsed(text: str) -> tuple[float, Any] | None:
    """The unit that a text means: as it is written, or else as JSBSim would write it."""
    for pattern, plain in _SPELT:
        text = pattern.sub(plain, text)
    text = text.translate(_RAISED)
    return _root(_written(text)) or _root(_written(text, _in_capitals))


def _written(text: str, spell: Callable[[str], str] = str) -> str:
    """A unit for pint, which is not trusted with texts that are no units; they become "?"."""
    written, end = "", 0
    for token in _TOKEN.finditer(text):
        power = f"**({token['power']})" if token["power"] else ""
        piece = token["sign"] or spell(token["name"]) + power
        touches = written and piece not in "*/)" and written[-1] not in "*/("
        written += f"*{piece}" if touches else piece
        if token.start() != end:
            return "?"
        end = token.end()
    return written if end == len(text) else "?"


def _in_capitals(name: str) -> str:
    """A common unit in capitals or with its power behind it, as in SLUG*FT2."""
    plain = name.rstrip("234")
    found = _CAPITALS.get(plain.lower(), plain)
    return f"({found})**{name[len(plain) :]}" if plain != name else found


def _kind(dimension: Any) -> str:
    """What a known unit measures, in words."""
    kinds = (words for unit, words in _KINDS.items() if _own(unit)[1] == dimension)
    return next(kinds, "which measures something else")


def _hint(given: str, wanted: Any) -> str:
    for mass, force in _FORCE_OF.items():
        meant = _parsed(re.sub(rf"\b{mass}\b", force, given))
        if meant and meant[1] == wanted:
            return f" (as a force, {mass} is {force})"
    meant = _parsed(given.lower())
    return f" (did you mean {given.lower()}?)" if meant and meant[1] == wanted else ""


def _unknown(given: str) -> str:
    if given.startswith(","):
        return "with a comma (none between thousands, a point before decimals)"
    for name in re.findall(r"[^\W\d]\w*", given):
        if _of_pint(name) is not None and _parsed(name) is None:
            return f"with {name!r}, which is no multiple of an SI unit (a logarithm, a temperature)"
    near = difflib.get_close_matches(given, _COMMON, n=2, cutoff=0.6)
    hint = f" (did you mean {' or '.join(near)}?)" if near else ""
    return f"with an unknown unit {given!r}{hint}"
