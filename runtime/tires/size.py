"""Tires by size and pressure, and friction by surface: what is known of them, as estimates.

The numbers are in ``tires.toml`` and ``surfaces.toml``; what follows from them is generated.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from importlib import resources
from typing import Any

import numpy as np

from groundroll.base.errors import UnexpectedError
from groundroll.base.units import to_si
from groundroll.model.evaluate import elementwise

_INCH, _MILLIMETRE = 0.0254, 0.001

#: Two or three numbers, and behind them perhaps the number of plies.
_SIZE = re.compile(
    r"H?(?P<first>\d+(?:\.\d+)?)\s*[-x/×]\s*(?P<second>\d+(?:\.\d+)?)"
    r"(?:\s*[-xR/×]\s*(?P<third>\d+(?:\.\d+)?))?"
    r"(?:[\s,]+\d+[\s-]*(?:PR|ply(?:[\s-]rating)?))?",
    re.IGNORECASE,
)
_EXPECTED = "a size, such as '6.00-6', '8.00x4', '15x6.00-6', '380x150-5' or '2.80/2.50-4'"


@dataclass(frozen=True)
class Implied:
    """What an entry of an aircraft file says of a quantity without naming it.

    Attributes
    ----------
    symbol : str
    value : float
        SI unit.
    text : str
        Where it comes from.
    """

    symbol: str
    value: float
    text: str


@dataclass(frozen=True)
class TireSize:
    """A size as its name has it.

    Attributes
    ----------
    width : float
        m.
    diameter : float or None
        Outside diameter, m, if the name has it.
    rim : float or None
        Its diameter, m, if the name has it.
    """

    width: float
    diameter: float | None = None
    rim: float | None = None

    def is_like(self, other: TireSize) -> bool:
        """Whether two names mean one size, to a hundredth of an inch."""
        pairs = zip(vars(self).values(), vars(other).values(), strict=True)
        return all(a == b or (a and b and abs(a - b) < 3e-4) for a, b in pairs)


def tire_size(text: str) -> TireSize:
    """Read the name of a tire size.

    Parameters
    ----------
    text : str
        Width and rim in inches (``6.00-6``, ``8.00x4``, ``600-6``), diameter, width and rim
        (``15x6.00-6``, in mm but for the rim ``380x150-5``), diameter and width (``8x3.00``,
        ``380/150``), or the width in two standards and the rim (``2.80/2.50-4``); a ply rating
        behind it says nothing of the size.

    Raises
    ------
    UnexpectedError
        If it is none of these.
    """
    match = _SIZE.fullmatch(text.strip())
    if not match:
        raise UnexpectedError("size", repr(text), _EXPECTED)
    first, second, third = (float(x) if x else None for x in match.groups())
    assert first is not None
    assert second is not None
    if third is not None:
        size = _of_three(first, second, third)
    elif first >= 100 and second >= 50:
        size = TireSize(second * _MILLIMETRE, first * _MILLIMETRE)
    elif first >= 100 or "." in match["first"] or "-" in text:
        size = TireSize(_inches(first), rim=second * _INCH)
    else:
        size = TireSize(second * _INCH, first * _INCH)
    within = size.diameter or np.inf
    if not 0.02 < size.width < min(within, 1.0) or not (size.rim or 0.05) < min(within, 1.0):
        raise UnexpectedError("size", f"{text!r}, which cannot be", _EXPECTED)
    return size


def _of_three(first: float, second: float, third: float) -> TireSize:
    rim = third * _INCH
    if first >= 100 and second >= 50:
        return TireSize(second * _MILLIMETRE, first * _MILLIMETRE, rim)
    if first > third:
        return TireSize(_inches(second), first * _INCH, rim)
    return TireSize(_inches(first), rim=rim)


def _inches(number: float) -> float:
    """Inches, or hundredths of them as on the side of many a tire, in m."""
    return number / (100 if number >= 100 else 1) * _INCH


def dimensions(text: str) -> tuple[float, float, str]:
    """Width and outside diameter of a tire in m by the name of its size, and where they are from.

    Raises
    ------
    UnexpectedError
        If the size cannot be read.
    """
    size = tire_size(text)
    for row in tires()["size"]:
        if size.is_like(tire_size(row["size"])):
            width, diameter = (to_si(row[key], "m", "size") for key in ("width", "diameter"))
            return width, diameter, row["source"]
    if size.diameter is not None:
        return size.width, size.diameter, "nominal, by the name of the size"
    arguments = {"d_rim": np.asarray(size.rim), "w_tire": np.asarray(size.width)}
    diameter = float(elementwise("outside_diameter", arguments)["d_tire"])
    return size.width, diameter, "width nominal; a section 0.92 times as high as wide, within 5 %"


def of_main_tires(text: str) -> Iterator[Implied]:
    """What a size says of the main tires, with what is known of tires that nobody has measured.

    Raises
    ------
    UnexpectedError
        If the size cannot be read.
    """
    width, diameter, source = dimensions(text)
    yield Implied("w_tire", width, f"size {text}: {source}")
    yield Implied("d_tire", diameter, f"size {text}: {source}")
    yield from _constants("type")
    yield from _constants("curve")
    curve = {s: entry["value"] for s, entry in tires()["curve"].items()}
    factors = elementwise("magic_formula_of_shape", {"C1": np.asarray(curve["C1"])})
    for s, value in factors.items():
        yield Implied(s, float(value), "slope and peak of the normalised curve are 1")
    dry = surfaces()["dry"]
    yield Implied("B5", dry["friction"], f"dry: {dry['source']}")


def of_tail_tire(text: str) -> Iterator[Implied]:
    """What a size says of the tire of the tail wheel; errors as for `of_main_tires`."""
    width, diameter, source = dimensions(text)
    yield Implied("w_tail", width, f"size {text}: {source}")
    yield Implied("d_tail", diameter, f"size {text}: {source}")
    yield from _constants("type")


def friction_on(surface: str) -> tuple[float, str]:
    """How many times the friction of a dry runway a surface has, and where that is from.

    Raises
    ------
    UnexpectedError
        If the surface is unknown.
    """
    if surface not in surfaces():
        raise UnexpectedError("surface", repr(surface), ", ".join(surfaces()))
    wanted, dry = surfaces()[surface], surfaces()["dry"]
    return wanted["friction"] / dry["friction"], f"{surface}: {wanted['source']}"


def _constants(table: str) -> Iterator[Implied]:
    for s, entry in tires()[table].items():
        yield Implied(s, float(entry["value"]), entry["source"])


@cache
def tires() -> Mapping[str, Any]:
    """What ``tires.toml`` holds."""
    return _data("tires.toml")


@cache
def surfaces() -> Mapping[str, Any]:
    """What ``surfaces.toml`` holds: friction, range and source by surface."""
    return _data("surfaces.toml")


def _data(name: str) -> Mapping[str, Any]:
    return tomllib.loads((resources.files(__package__) / name).read_text(encoding="utf-8"))
