"""Aircraft files: TOML with units, every mistake in one reported at once with its line.

What a file may say is in `aircraft_schema`, which is imported when a file is read: lists of the
packaged ones need no pydantic. tomllib keeps no lines, so they are looked up in the text.
"""

from __future__ import annotations

import math
import re
import tomllib
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from groundroll.base.errors import GroundrollError, listed, one_of
from groundroll.base.files import as_path, packaged, text_of
from groundroll.base.wording import encodable
from groundroll.model.names import QUANTITIES
from groundroll.tires.size import friction_on

from .consistency import contradictions
from .source import Place, Source

if TYPE_CHECKING:
    from .aircraft import Aircraft

#: A text over several lines, and the key or the table that a line begins with.
_LONG = re.compile(r'("""|\'\'\').*?\1', re.DOTALL)
_TABLE = re.compile(r"\[([^\[\]]+)\]")
_KEY = re.compile(r"([\w.\-\"' ]+)=")


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


class AircraftFileError(GroundrollError):
    """An aircraft file with mistakes.

    Attributes
    ----------
    path : Path
        The file.
    mistakes : tuple of Mistake
        The first fifty of them.
    """

    def __init__(self, path: Path, mistakes: list[Mistake], more: int = 0) -> None:
        super().__init__(listed(str(path), mistakes, more))
        self.path = path
        self.mistakes = tuple(mistakes)


def load(name: str | Path, make: Callable[..., Aircraft]) -> Aircraft:
    """What `make` makes of a packaged aircraft or an aircraft file; see `Aircraft.load`."""
    path = locate(name)
    text = text_of(path)
    try:
        return _aircraft(path, tomllib.loads(text), _lines(text), make)
    except GroundrollError:
        raise
    except ValueError as problem:
        raise GroundrollError(f"{path} is not valid TOML: {problem}") from problem
    except RecursionError as problem:
        raise GroundrollError(f"{path} is nested too deeply for an aircraft file") from problem


def packaged_files() -> dict[str, Path]:
    """The packaged aircraft by name."""
    return packaged("aircraft/fleet", ".toml")


def locate(name: str | Path) -> Path:
    """The file of a packaged aircraft by name, or a path as it is."""
    path = as_path(name)
    if path.suffix == ".toml":
        return path
    files = packaged_files()
    where = "the packaged ones (a file ends in .toml)"
    return files[one_of("aircraft", str(name), files, where)]


def _aircraft(
    path: Path,
    data: dict[str, Any],
    lines: Mapping[Place, int],
    make: Callable[..., Aircraft],
) -> Aircraft:
    from .schema import entries, implied, surface, validate

    file, wrong, more = validate(data, path)
    given: dict[str, Any] = {}
    sources: dict[str, Source] = {}
    places: dict[str, Place] = {}
    in_order = sorted(entries(file, data), key=lambda entry: _line(entry[0], lines) or 0)
    for place, s, value, source in in_order:
        if s in given:
            again = f"{QUANTITIES[s].name} a second time"
            wrong.append((place, again, f"it once: it is in {'.'.join(places[s])} too"))
        given[s], sources[s], places[s] = value, source, place
    for place, s, value, source in implied(file):
        if s not in given:
            given[s], sources[s], places[s] = value, source, place
    if on := surface(file):
        _scale_friction(given, sources, on)
    name = encodable(path.stem)
    title = file.title or name
    own = {name: entry.value for name, entry in file.parameters.items()}
    plane = make(name, given, title, file.description, sources, file.source, own)
    for problem in contradictions(plane):
        place = places.get(problem.symbol, (QUANTITIES[problem.symbol].name,))
        wrong.append((place, problem.found, problem.expected))
    if wrong:
        mistakes = [Mistake(".".join(p), _line(p, lines), *words) for p, *words in wrong]
        raise AircraftFileError(path, sorted(mistakes, key=lambda m: m.line or math.inf), more)
    return plane


def _scale_friction(given: dict[str, Any], sources: dict[str, Source], surface: str) -> None:
    """Turn the friction of a dry runway into that of another surface."""
    factor, text = friction_on(surface)
    for s in ("B5", "C5"):
        if s in given and surface != "dry":
            given[s] *= factor
            words = f"{sources[s].text}; times {factor:.3g} on {text}"
            sources[s] = Source(words.removeprefix("; "), estimate=True)


def _line(place: Place, lines: Mapping[Place, int]) -> int | None:
    """Line of a name, or of the innermost table around it that has one."""
    return next((lines[place[:n]] for n in range(len(place), 0, -1) if place[:n] in lines), None)


def _lines(text: str) -> dict[Place, int]:
    """Line of each table and key."""
    found: dict[Place, int] = {}
    table: Place = ()
    without = _LONG.sub(lambda long: "\n" * long[0].count("\n"), text)
    for number, line in enumerate(map(str.strip, without.split("\n")), start=1):
        new = _TABLE.match(line)
        if match := new or _KEY.match(line):
            names = (name.strip(" \t\"'") for name in match[1].split("."))
            place = (*(() if new else table), *names)
            table = place if new else table
            found.setdefault(place, number)
    return found
