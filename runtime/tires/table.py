"""Measured tire forces in text files, as people have them.

A table has slip angles in its first column and loads in its header; a long file has a point in each
line, and names of its columns with units: ``slip angle [deg]; vertical load [N]; lateral force
[N]``. Columns are separated by commas, semicolons or tabs; decimals have a point or, where columns
are not separated by commas, a comma. Lines that begin with ``#`` are comments. A number may have
its unit behind it; loads and forces without any are in N, slip angles in degrees. Where the loads
of a table have a unit, the forces are in the same one, or in N if only that can be.
"""

from __future__ import annotations

import csv
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from groundroll.base.arrays import FloatArray
from groundroll.base.errors import GroundrollError, listed
from groundroll.base.files import text_of
from groundroll.base.units import UnitError, parts, to_si
from groundroll.base.wording import encodable

if TYPE_CHECKING:
    from .data import TireData


#: Largest file that is read, bytes: some ten thousand points.
_LARGEST = 2**20
#: What the columns of a long file are called.
_COLUMNS = {
    "load": re.compile(r"load|\bf_?z|vertical|normal|radlast", re.IGNORECASE),
    "force": re.compile(r"force|\bf_?y|lateral|side|kraft", re.IGNORECASE),
    "angle": re.compile(r"angle|slip|alpha|\bsa\b|winkel|α", re.IGNORECASE),
}
_UNITS = {"angle": "rad", "load": "N", "force": "N"}
#: Units of what has none, and the factor of that unit.
_BARE = {"angle": "deg", "load": "N", "force": "N"}
#: Largest force over load by which a unit of forces is believed.
_BELIEVED = (0.1, 2.5)
_WORD_UNIT = re.compile(r"(?:[\[(]\s*([^\])]*?)\s*[\])]|[_/\s,]\s*([^\W\d_]+))\s*$")


@dataclass
class _Reading:
    """A file while it is read: its lines, how numbers are written, and what is wrong."""

    lines: list[tuple[int, list[str]]]
    has_decimal_comma: bool
    mistakes: list[str] = field(default_factory=list)

    def plain(self, cell: str) -> str:
        """A cell with a point before decimals."""
        text = cell.replace("\N{MINUS SIGN}", "-")
        is_decimal = self.has_decimal_comma and "." not in text and text.count(",") == 1
        return text.replace(",", ".") if is_decimal else text

    def number(self, cell: str, kind: str, unit: str, line: int, column: int) -> float:
        """A cell in its SI unit, the bare number in `unit`; NaN and a mistake if it is none."""
        text = self.plain(cell)
        where = f"line {line}, column {column}"
        number, given = parts(text)
        try:
            value = to_si(text if given or not number else f"{text} {unit}", _UNITS[kind], where)
        except UnitError as problem:
            words = str(problem) if given else f"{where}: {cell[:40]!r} is not a finite number"
            self.mistakes.append(words)
            return float("nan")
        if not np.isfinite(value):
            self.mistakes.append(f"{where}: {cell[:40]!r} is not a finite number")
        return value


def read(path: Path, make: Callable[..., TireData]) -> TireData:
    """Read measured forces from a text file.

    Parameters
    ----------
    path : Path
        The file; how it may look is said above.

    Raises
    ------
    GroundrollError
        If it cannot be read, or has mistakes: they are listed, each with its line.
    """
    reading = _reading(text_of(path, most=_LARGEST, otherwise="cp1252"), path)
    if len(reading.lines) < 2:
        raise GroundrollError(f"{path} has no data: a header and rows of numbers are needed")
    kinds = [_kind(cell) for cell in reading.lines[0][1]]
    is_long = "load" in kinds and "force" in kinds
    notes: list[str] = []
    _check_decimals(reading)
    try:
        alpha, Fz, F = map(np.array, (_long if is_long else _wide)(reading, kinds, notes))
        if not reading.mistakes:
            return make(encodable(path.stem), alpha, Fz, F, tuple(notes))
    except GroundrollError as problem:
        raise GroundrollError(f"{path}: {problem}") from None
    raise GroundrollError(listed(str(path), reading.mistakes))


def _reading(text: str, path: Path) -> _Reading:
    """The cells of each line that is not empty or a comment."""
    lines = [
        (number, line)
        for number, line in enumerate(text.splitlines(), start=1)
        if line.strip() and not line.lstrip().startswith("#")
    ]
    header = lines[0][1] if lines else ""
    separator = next((s for s in ";\t" if s in header), ",")
    try:
        rows = [
            (number, [cell.strip() for cell in next(csv.reader([line], delimiter=separator))])
            for number, line in lines
        ]
    except (csv.Error, StopIteration) as problem:
        raise GroundrollError(f"{path}: {problem}") from None
    if rows and not rows[0][1][-1]:  # a trailing comma in every line
        width = len(rows[0][1]) - 1
        rows = [
            (n, cells[:-1] if len(cells) > width and not cells[-1] else cells) for n, cells in rows
        ]
    return _Reading(rows, separator != ",")


def _check_decimals(reading: _Reading) -> None:
    """Refuse points beside commas: one of them would stand between thousands."""
    if not reading.has_decimal_comma:
        return
    cells = [(n, cell) for n, row in reading.lines[1:] for cell in row]
    points = [n for n, cell in cells if "." in cell]
    if points and any("," in cell for _, cell in cells):
        reading.mistakes.append(
            f"line {points[0]}: decimals have a point here, and a comma elsewhere in the file"
        )


def _kind(cell: str) -> str:
    """What a column of a long file holds, by its name; nothing for the load of a table."""
    if not cell or cell[0].isdigit():
        return ""
    return next((kind for kind, pattern in _COLUMNS.items() if pattern.search(cell)), "")


def _long(
    reading: _Reading, kinds: list[str], notes: list[str]
) -> tuple[list[float], list[float], list[float]]:
    """Slip angles, loads and forces of a file with a point in each line."""
    (first, header), *body = reading.lines
    for kind in _COLUMNS:
        if kinds.count(kind) != 1:
            found = "no column" if kind not in kinds else f"{kinds.count(kind)} columns"
            reading.mistakes.append(f"line {first}: {found} of the {kind}, where one is needed")
    if unused := [cell for cell, kind in zip(header, kinds, strict=True) if not kind]:
        notes.append(f"columns that are not used: {', '.join(unused)}")
    columns = {kind: (k, _unit(header[k], kind, notes)) for k, kind in enumerate(kinds) if kind}
    points: dict[str, list[float]] = {"angle": [], "load": [], "force": []}
    for line, cells in body:
        if len(cells) != len(header):
            reading.mistakes.append(_wrong_width(line, cells, header))
            continue
        for kind, (k, unit) in columns.items():
            points[kind].append(reading.number(cells[k], kind, unit, line, k + 1))
    return points["angle"], points["load"], points["force"]


def _unit(cell: str, kind: str, notes: list[str]) -> str:
    """The unit in the name of a column, or the one that is taken where it has none."""
    match = _WORD_UNIT.search(cell)
    unit = (match[1] or match[2] or "") if match else ""
    try:
        to_si(f"1 {unit}", _UNITS[kind], f"column {cell[:40]!r}")
    except UnitError:
        if match and match[1]:
            raise
        unit = ""
    if not unit:
        notes.append(f"column {cell[:40]!r} has no unit, and is read in {_BARE[kind]}")
    return unit or _BARE[kind]


def _wrong_width(line: int, cells: Sequence[str], header: Sequence[str]) -> str:
    return f"line {line}: {len(cells)} columns, but the header has {len(header)}"


def _wide(
    reading: _Reading, kinds: list[str], notes: list[str]
) -> tuple[list[float], list[float], list[float]]:
    """The same of a table of slip angles by loads."""
    (first, header), *body = reading.lines
    if kinds[0] != "angle":
        reading.mistakes.append(
            f"line {first}: the header must be slip_angle_deg and the loads, such as"
            f" slip_angle_deg,400 lbf,800 lbf (bare loads are in N), or name columns of slip"
            f" angle, load and force, but begins with {header[0][:40]!r}"
        )
    units = {parts(reading.plain(cell))[1] for cell in header[1:]}
    if "" in units and len(units) > 1:
        given = " and ".join(sorted(unit or "none" for unit in units))
        reading.mistakes.append(f"line {first}: all loads must have a unit, but there is {given}")
    loads = [
        reading.number(cell, "load", "N", first, k) for k, cell in enumerate(header[1:], start=2)
    ]
    angle_unit = _unit(header[0], "angle", notes)
    own: set[str] = set()
    points: list[tuple[float, float, float]] = []
    for line, cells in body:
        if len(cells) != len(header):
            reading.mistakes.append(_wrong_width(line, cells, header))
            continue
        angle = reading.number(cells[0], "angle", angle_unit, line, 1)
        for k, (load, cell) in enumerate(zip(loads, cells[1:], strict=True), start=2):
            own.add(parts(reading.plain(cell))[1])
            points.append((angle, load, reading.number(cell, "force", "N", line, k)))
    if len(own) > 1 and "" in own:
        reading.mistakes.append("some forces have a unit and some have none")
    if reading.mistakes or not points:
        return [], [], []
    angles, weights, forces = map(list, zip(*points, strict=True))
    if min(weights) <= 0 or own != {""}:  # the former is a mistake that is told with the points
        return angles, weights, forces
    factor = _force_unit(units, np.array(forces) / weights, notes)
    return angles, weights, [factor * F for F in forces]


def _force_unit(units: set[str], ratios: FloatArray, notes: list[str]) -> float:
    """How many N the unit of forces is: that of the loads, or 1 if only that can be."""
    if len(units) != 1 or units == {""}:
        return 1.0
    (unit,) = units
    factor = to_si(f"1 {unit}", "N", "loads")
    low, high = _BELIEVED
    friction = float(np.abs(ratios).max())
    if low <= friction * factor <= high or not low <= friction <= high:
        return factor
    notes.append(
        f"forces are read in N: in {unit}, as the loads are, they would be {friction * factor:.3g}"
        " times the loads"
    )
    return 1.0
