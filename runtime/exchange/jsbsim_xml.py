"""JSBSim's XML: numbers with their units, and what its functions are proportional to."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

from groundroll.base.errors import GroundrollError, unknown
from groundroll.base.files import text_of
from groundroll.base.units import from_si, to_si

#: Bytes that a file may have: the largest that JSBSim comes with has half a million.
_MOST = 2**23
#: What may stand in a file beside it.
_SECTIONS = ("metrics", "mass_balance", "ground_reactions", "aerodynamics")


@cache
def words() -> Mapping[str, Any]:
    """What JSBSim calls things."""
    path = Path(__file__).parent / "jsbsim_import.toml"
    return tomllib.loads(path.read_text(encoding="utf-8"))


def document(path: Path) -> tuple[ET.Element, str]:
    """The aircraft in a file, with the sections that stand in files beside it, and the text.

    Raises
    ------
    GroundrollError
        If the file cannot be read or holds no aircraft.
    """
    root, text = _parsed(path)
    if root.tag != "fdm_config":
        raise GroundrollError(
            f"{path} is no aircraft of JSBSim: found <{root.tag}>; expected <fdm_config>"
        )
    for k, section in enumerate(root):
        beside = section.get("file")
        if beside and section.tag in (
            "metrics",
            "mass_balance",
            "ground_reactions",
            "aerodynamics",
        ):
            name = beside if beside.endswith(".xml") else f"{beside}.xml"
            root[k] = _parsed(path.parent / name)[0]
    return root, text


def _parsed(path: Path) -> tuple[ET.Element, str]:
    text = text_of(path, _MOST, "latin-1")
    try:
        return ET.fromstring(text), text
    except (ET.ParseError, ValueError) as problem:
        raise GroundrollError(f"cannot read {path}: {problem}; expected XML of JSBSim") from None


def number(element: ET.Element, where: str) -> float:
    """The number in an element.

    Raises
    ------
    GroundrollError
        If there is none.
    """
    found = (element.text or "").strip()
    try:
        return to_si(found, "1", where)
    except ValueError:
        raise GroundrollError(f"{where}: found {found!r}; expected a number") from None


def unit_of(element: ET.Element, si: str, where: str) -> str:
    """The unit of an element in our spelling.

    Raises
    ------
    GroundrollError
        If the file names one that does not fit.
    """
    known = words()["units"][si]
    name = element.get("unit", words()["default"][si]).upper()
    if name not in known:
        raise unknown("unit", name, known, where)
    return str(known[name])


def measured(parent: ET.Element, tag: str, si: str, where: str) -> tuple[float, str] | None:
    """Number and unit of a child; None if there is none."""
    element = parent.find(tag)
    if element is None or not (element.text or "").strip():
        return None
    place = f"{where}, {tag}"
    return number(element, place), unit_of(element, si, place)


def place(location: ET.Element, where: str) -> tuple[tuple[float, ...], str]:
    """A location as x (aft), y (right), z (up) in m, and the unit that it is given in."""
    unit = "in" if location.get("unit") is None else unit_of(location, "m", where)
    found = []
    for axis in "xyz":
        element = location.find(axis)
        if element is None:
            raise GroundrollError(f"{where}: no <{axis}>")
        found.append(to_si(f"{number(element, where)!r} {unit}", "m", where))
    return tuple(found), unit


def shown_in(value: float, si: str, unit: str) -> float:
    """An SI number in another unit, without the noise of its conversion."""
    return float(f"{from_si(value, si, unit):.10g}") if unit != si else value
