"""Aircraft files: TOML with units, checked against the table of quantities, all at once.

The schema of an aircraft file is `generated.names.QUANTITIES`, which the derivation writes: names,
units and signs of everything an aircraft may be given. What is left to check here are three
fields per value, so TOML is read by the standard library and units by pint; a validation library
would need the table a second time as a schema, and could not name the line.
"""

from __future__ import annotations

import difflib
import math
import re
import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from importlib import resources
from pathlib import Path
from typing import Any

from .aircraft import Aircraft, Source, in_si, parameter_symbols
from .consistency import contradictions
from .errors import GroundloopError, UnknownNameError, unknown
from .generated.names import QUANTITIES
from .names import symbol
from .units import UnitError, expected

_ABOUT = ("title", "description", "source")
_FIELDS = ("value", "source", "estimate")

#: The one key that is no quantity: measured tire forces, in a CSV file.
_TABLE = "main_tires.table"

_SIGNS = {">0": "a positive number", ">=0": "zero or a positive number", "": "a finite number"}

_KEY = r"[\w.\-\"' ]+?"
_HEADER = re.compile(rf"\s*\[({_KEY})\]")
_ASSIGNMENT = re.compile(rf"\s*({_KEY})\s*=")
_QUOTES = ('"""', "'" * 3)


@dataclass(frozen=True)
class Mistake:
    """Something wrong in an aircraft file.

    Attributes
    ----------
    key : str
        Where, with the names of its tables: ``airframe.mass``.
    line : int or None
        Its line in the file, counted from 1; None for what is missing from it.
    found, expected : str
        In words.
    """

    key: str
    line: int | None
    found: str
    expected: str

    def __str__(self) -> str:
        place = "" if self.line is None else f"line {self.line}, "
        return f"{place}{self.key}: found {self.found}; expected {self.expected}"


class AircraftFileError(GroundloopError):
    """An aircraft file with mistakes.

    Attributes
    ----------
    path : Path
        The file.
    mistakes : tuple of Mistake
        All of them.
    """

    def __init__(self, path: Path, mistakes: list[Mistake]) -> None:
        count = "1 mistake" if len(mistakes) == 1 else f"{len(mistakes)} mistakes"
        super().__init__("\n  ".join([f"{path} has {count}:", *map(str, mistakes)]))
        self.path = path
        self.mistakes = tuple(mistakes)


@dataclass(frozen=True)
class _Entry:
    """One value of a file, as written."""

    key: str
    line: int | None
    content: Any

    @property
    def name(self) -> str:
        return self.key.rpartition(".")[2]

    def mistake(self, found: str, expected: str) -> Mistake:
        return Mistake(self.key, self.line, found, expected)


def load(name: str | Path) -> Aircraft:
    """Read a packaged aircraft by name, or an aircraft file by path; see `Aircraft.load`."""
    path = locate(name)
    try:
        text = path.read_text(encoding="utf-8-sig")
        data = tomllib.loads(text)
    except OSError as problem:
        raise GroundloopError(f"cannot read {path}: {problem.strerror}") from problem
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as problem:
        raise GroundloopError(f"{path} is not valid TOML: {problem}") from problem
    return _aircraft(path, data, _lines(text))


def packaged_files(suffix: str = ".toml") -> dict[str, Path]:
    """The packaged aircraft, or with ``".csv"`` the packaged tire tables, by name."""
    folder = resources.files("groundloop") / "fleet"
    files = sorted(Path(str(p)) for p in folder.iterdir() if p.name.endswith(suffix))
    return {p.name.removesuffix(suffix): p for p in files}


def locate(name: str | Path) -> Path:
    """The file of a packaged aircraft by name, or a path as it is."""
    path = Path(name)
    if path.suffix == ".toml":
        return path
    files = packaged_files()
    if str(name) not in files:
        raise unknown("aircraft", str(name), files, "the packaged ones (a file ends in .toml)")
    return files[str(name)]


def _aircraft(path: Path, data: Mapping[str, Any], lines: Mapping[str, int]) -> Aircraft:
    mistakes: list[Mistake] = []
    entries: dict[str, _Entry] = {}
    given: dict[str, Any] = {}
    sources: dict[str, Source] = {}
    for entry in _entries(data, lines):
        try:
            values = _read(entry, path, mistakes)
        except UnknownNameError:
            mistakes.append(entry.mistake("an unknown key", _nearest(entry)))
            continue
        for key, (value, source) in values.items():
            if key in given:
                again = f"{QUANTITIES[key].name} a second time"
                mistakes.append(entry.mistake(again, f"it once: it is in {entries[key].key} too"))
            given[key], sources[key], entries[key] = value, source, entry
    about = {key: _about(data, key, lines, mistakes) for key in _ABOUT}
    plane = Aircraft(
        name=path.stem,
        given=given,
        title=about["title"] or path.stem,
        description=about["description"],
        sources=sources,
        source=about["source"],
    )
    for problem in contradictions(plane):
        where = entries.get(problem.symbol, _Entry(QUANTITIES[problem.symbol].name, None, None))
        mistakes.append(where.mistake(problem.found, problem.expected))
    if mistakes:
        raise AircraftFileError(path, sorted(mistakes, key=lambda m: m.line or math.inf))
    return plane


def _entries(
    data: Mapping[str, Any], lines: Mapping[str, int], prefix: str = ""
) -> Iterator[_Entry]:
    """The values of a file, from all its tables."""
    for name, content in data.items():
        key = f"{prefix}{name}"
        if key in _ABOUT:
            continue
        if isinstance(content, Mapping) and not _is_value(key, content):
            yield from _entries(content, lines, f"{key}.")
        else:
            yield _Entry(key, lines.get(key), content)


def _is_value(key: str, content: Mapping[str, Any]) -> bool:
    """Whether a TOML table is a value with a source rather than a group of values."""
    return "value" in content or key == _TABLE or key.rpartition(".")[2] in _known()


def _known() -> tuple[str, ...]:
    """Names and symbols that a key may have."""
    return (*(QUANTITIES[s].name for s in parameter_symbols()), *parameter_symbols())


def _nearest(entry: _Entry) -> str:
    near = difflib.get_close_matches(entry.name, _known(), n=3, cutoff=0.6)
    if entry.name == "table":
        near = [_TABLE]
    return " or ".join(near) or "one of those that `groundloop new` writes"


def _read(entry: _Entry, path: Path, mistakes: list[Mistake]) -> dict[str, tuple[Any, Source]]:
    """What an entry gives, by symbol; what is wrong with it goes to the mistakes."""
    count = len(mistakes)
    if entry.key == _TABLE:
        value, source = _fields(entry, "a file name, such as 'tire.csv'", mistakes)
        return {} if len(mistakes) > count else _tire(entry, value, source, path, mistakes)
    key = symbol(entry.name, "key", parameter_symbols())
    unit = QUANTITIES[key].unit
    value, source = _fields(entry, expected(unit), mistakes)
    if len(mistakes) > count:
        return {}
    if isinstance(value, bool) or not isinstance(value, (int, float, str)):
        mistakes.append(entry.mistake(f"{value!r}", expected(unit)))
        return {}
    try:
        number = float(in_si(value, key, entry.key))
    except UnitError as problem:
        mistakes.append(entry.mistake(problem.found, problem.expected))
        return {}
    if not _is_possible(number, QUANTITIES[key].sign):
        mistakes.append(entry.mistake(repr(value), _SIGNS[QUANTITIES[key].sign]))
        return {}
    if not isinstance(value, str) and unit != "1":
        source = replace(source, entry=f"{source.entry} {unit}")
    return {key: (number, source)}


def _is_possible(number: float, sign: str) -> bool:
    if not math.isfinite(number):
        return False
    return {">0": number > 0, ">=0": number >= 0, "": True}[sign]


def _fields(entry: _Entry, wanted: str, mistakes: list[Mistake]) -> tuple[Any, Source]:
    """Value and source of an entry, written ``key = value`` or with its fields."""
    content = entry.content
    if not isinstance(content, Mapping):
        return content, Source(entry=str(content))
    for name in content:
        if name not in _FIELDS:
            near = difflib.get_close_matches(name, _FIELDS, n=1) or _FIELDS
            mistakes.append(entry.mistake(f"an unknown field {name!r}", ", ".join(near)))
    if "value" not in content:
        mistakes.append(entry.mistake("no value", f"value = {wanted}"))
    source, estimate = content.get("source", ""), content.get("estimate", False)
    if not isinstance(source, str):
        mistakes.append(entry.mistake(f"source = {source!r}", "a text"))
    if not isinstance(estimate, bool):
        mistakes.append(entry.mistake(f"estimate = {estimate!r}", "true or false"))
    return content.get("value"), Source(str(source), bool(estimate), str(content.get("value")))


def _tire(
    entry: _Entry, value: Any, source: Source, path: Path, mistakes: list[Mistake]
) -> dict[str, tuple[Any, Source]]:
    """Tire parameters fitted to the table that an entry names."""
    tables = packaged_files(".csv")
    beside = path.parent / str(value)
    table = beside if beside.is_file() else tables.get(str(value).removesuffix(".csv"))
    if not isinstance(value, str) or table is None:
        wanted = f"a CSV file beside {path.name}, or a packaged one: {', '.join(tables)}"
        mistakes.append(entry.mistake(repr(value), wanted))
        return {}
    from .tire_data import TireData
    from .tire_fit import fit_tire

    try:
        fit = fit_tire(TireData.load(table))
    except GroundloopError as problem:
        mistakes.append(entry.mistake(f"{value!r}: {problem}", "a table that can be fitted"))
        return {}
    text = "; ".join(filter(None, (f"fitted to {value}", source.text)))
    fitted = Source(text, source.estimate)
    return {key: (number, fitted) for key, number in fit.parameters.items()}


def _about(
    data: Mapping[str, Any], key: str, lines: Mapping[str, int], mistakes: list[Mistake]
) -> str:
    text = data.get(key, "")
    if not isinstance(text, str):
        mistakes.append(Mistake(key, lines.get(key), repr(text), "a text"))
    return str(text).strip()


def _lines(text: str) -> dict[str, int]:
    """Line of each key, with the names of its tables; the inside of long texts is skipped."""
    found: dict[str, int] = {}
    table, closing = "", ""
    for number, line in enumerate(text.splitlines(), start=1):
        if closing:
            closing = "" if closing in line else closing
            continue
        if header := _HEADER.match(line):
            table = f"{_bare(header[1])}."
        elif assignment := _ASSIGNMENT.match(line):
            found.setdefault(table + _bare(assignment[1]), number)
        closing = next((quote for quote in _QUOTES if line.count(quote) == 1), "")
    return found


def _bare(key: str) -> str:
    """A dotted key without quotes and blanks."""
    return ".".join(part.strip().strip("\"'") for part in key.split("."))
