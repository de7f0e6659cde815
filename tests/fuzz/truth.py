"""Numbers with units, read without the package or what it is built upon."""

from __future__ import annotations

import math
import re

#: Of each unit of a parameter, some that people write.
WRITTEN = {
    "kg": ("kg", "lb", "slug", "g"),
    "m": ("m", "in", "ft", "mm"),
    "m^2": ("m^2", "ft^2", "in**2"),
    "m/s": ("m/s", "kt", "km/h", "mph", "ft/s"),
    "N": ("N", "lbf", "kN"),
    "N/rad": ("N/rad", "N/deg", "lbf/deg"),
    "kg m^2": ("kg m^2", "slug ft^2", "kg*m^2"),
    "rad": ("rad", "deg", "mrad"),
    "1/rad": ("1/rad", "1/deg"),
}
#: Unit -> how many of kg, m, s and rad, and the powers of these.
_UNITS: dict[str, tuple[float, tuple[int, int, int, int]]] = {
    **{n: (f, (0, 1, 0, 0)) for n, f in {"m": 1.0, "in": 0.0254, "ft": 0.3048}.items()},
    **{
        n: (f, (1, 0, 0, 0))
        for n, f in {"g": 1e-3, "lb": 0.45359237, "slug": 14.5939029372}.items()
    },
    **{n: (f, (0, 0, 1, 0)) for n, f in {"s": 1.0, "min": 60.0, "h": 3600.0}.items()},
    **{n: (f, (0, 0, 0, 1)) for n, f in {"rad": 1.0, "deg": math.pi / 180}.items()},
    **{n: (f, (0, 1, -1, 0)) for n, f in {"kt": 1852 / 3600, "mph": 1609.344 / 3600}.items()},
    **{
        n: (f, (1, 1, -2, 0)) for n, f in {"N": 1.0, "lbf": 4.4482216152605, "kgf": 9.80665}.items()
    },
    **{
        n: (f, (1, -1, -2, 0)) for n, f in {"Pa": 1.0, "psi": 6894.757293168361, "bar": 1e5}.items()
    },
}
_PREFIXES = {"k": 1e3, "c": 1e-2, "m": 1e-3, "d": 1e-1, "M": 1e6, "u": 1e-6, "n": 1e-9, "h": 1e2}
_PREFIXED = ("m", "g", "s", "N", "Pa", "rad", "bar")
_NUMBER = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*?)\s*", re.ASCII | re.S)
_FACTOR = re.compile(r"\s*([*/]?)\s*([A-Za-z]+|1)(?:(?:\*\*|\^)([+-]?\d))?\s*", re.ASCII)

Dimension = tuple[float, ...]


def value(text: str, unit: str) -> float | None:
    """What a text means in a unit; None if it is not known here that it means anything."""
    match = _NUMBER.fullmatch(text)
    if match is None:
        return None
    if not match[2]:
        return float(match[1])
    given, wanted = factor(match[2]), factor(unit)
    if given is None or wanted is None or given[1] != wanted[1]:
        return None
    return float(match[1]) * given[0] / wanted[0]


def factor(text: str) -> tuple[float, Dimension] | None:
    """A unit as a multiple of its SI unit, and its dimension; products from left to right."""
    above, bracket, below = text.partition("/(")
    if bracket and below.endswith(")"):
        over, under = factor(above), factor(below[:-1])
        if over is None or under is None:
            return None
        return over[0] / under[0], tuple(a - b for a, b in zip(over[1], under[1], strict=True))
    if text == "1":
        return 1.0, (0, 0, 0, 0)
    size, dimension, end = 1.0, (0.0, 0.0, 0.0, 0.0), 0
    while end < len(text):
        match = _FACTOR.match(text, end)
        if match is None or (match[1] and not end) or (found := _named(match[2])) is None:
            return None
        power = int(match[3] or 1) * (-1 if match[1] == "/" else 1)
        size *= found[0] ** power
        dimension = tuple(d + power * e for d, e in zip(dimension, found[1], strict=True))
        end = match.end()
    return size, dimension


def _named(name: str) -> tuple[float, Dimension] | None:
    if name == "1":
        return 1.0, (0, 0, 0, 0)
    if name in _UNITS:
        return _UNITS[name]
    prefix, rest = name[0], name[1:]
    if prefix in _PREFIXES and rest in _PREFIXED:
        return _PREFIXES[prefix] * _UNITS[rest][0], _UNITS[rest][1]
    return None


def close(found: object, expected: float) -> bool:
    """Whether a number is another one, but for rounding on the way through units."""
    return math.isclose(float(found), expected, rel_tol=1e-9, abs_tol=1e-300)  # type: ignore[arg-type]
