"""What the study is about, read from the data files beside it: trials, tables, errata, figures."""

from __future__ import annotations

import csv
import hashlib
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from importlib import resources
from typing import Any

#: In the data files: this parameter follows from others instead of being given.
_FOLLOWS = "follows"


@dataclass(frozen=True)
class Trial:
    """A configuration of the thesis.

    Attributes
    ----------
    number : int
        The thesis's number, 1 to 22.
    configuration : str
        Which components act, in words.
    changes : mapping
        What `Aircraft.replace` is given.
    readings : mapping of str to mapping
        For each model of which the thesis prints a run (``"linear"``, ``"nonlinear"``): the
        reading of the time constant, and further changes to the aircraft.
    tail_load : float or None
        Load on the tail wheel over its static load.
    """

    number: int
    configuration: str
    changes: Mapping[str, Any]
    readings: Mapping[str, Mapping[str, Any]]
    tail_load: float | None = None


@dataclass(frozen=True)
class Setup:
    """What all trials share: aircraft, start, duration (s) and samples of a run."""

    aircraft: str
    lateral_velocity: float
    duration: float
    samples: int


@dataclass(frozen=True)
class Tolerance:
    """How far a computed value may be from a printed one; the largest of three."""

    digits: float = 0.0
    relative: float = 0.0
    absolute: float = 0.0

    def allows(self, printed: float, computed: float, last_digit: float) -> bool:
        """Whether two values agree, given the worth of the last printed digit."""
        room = max(self.digits * last_digit, self.relative * abs(computed), self.absolute)
        return abs(computed - printed) <= room * (1 + 1e-9)


@dataclass(frozen=True)
class Column:
    """A column of a printed table of trials."""

    key: str
    quantity: str
    label: str
    unit: str
    tolerance: Tolerance


@dataclass(frozen=True)
class Table:
    """A printed table.

    Attributes
    ----------
    number, title, section, note : str
        As in the thesis, and what to know about the computed values.
    kind : str
        ``"trials"``: a row for each trial; ``"aircraft"``, ``"tire-fit"``: one for each symbol.
    rows : tuple of mapping
        The typed rows, texts by column.
    columns : tuple of Column
        Of a table of trials.
    model : str
        Which tire the trials have.
    changes, symbols, labels, multiples : mapping
        Of a table of symbols: changes to the aircraft, our symbols where the typed rows have
        others, the thesis's symbols where they are others, factors.
    tolerance : Tolerance
        Of a table of symbols.
    """

    number: str
    title: str
    section: str
    kind: str
    rows: tuple[Mapping[str, str], ...]
    tolerance: Tolerance
    columns: tuple[Column, ...] = ()
    model: str = ""
    note: str = ""
    changes: Mapping[str, Any] = field(default_factory=dict)
    symbols: Mapping[str, str] = field(default_factory=dict)
    labels: Mapping[str, str] = field(default_factory=dict)
    multiples: Mapping[str, float] = field(default_factory=dict)


@dataclass(frozen=True)
class Coverage:
    """Cells that an erratum speaks of.

    Attributes
    ----------
    table, quantity : str
        Which table, and which quantity if not all.
    right : mapping of str to str
        The right value by row.
    reading : str
        Name of the reading that reproduces the print; empty if none is known.
    """

    table: str
    right: Mapping[str, str]
    quantity: str = ""
    reading: str = ""

    def covers(self, table: str, row: str, quantity: str) -> bool:
        """Whether a cell is one of them."""
        return self.table == table and row in self.right and self.quantity in ("", quantity)


@dataclass(frozen=True)
class Erratum:
    """A mistake or trap of the print."""

    number: int
    where: str
    printed: str
    right: str
    evidence: str
    cells: tuple[Coverage, ...] = ()

    def coverage(self, table: str, row: str, quantity: str) -> Coverage | None:
        """The entry that speaks of a cell, if any."""
        return next((c for c in self.cells if c.covers(table, row, quantity)), None)


@dataclass(frozen=True)
class Section:
    """A section of the thesis that holds tables or figures."""

    number: str
    title: str


@dataclass(frozen=True)
class FigureSpec:
    """A figure of the thesis: number, caption as printed, and what is drawn."""

    number: str
    caption: str
    kind: str
    title: str
    section: str
    note: str = ""
    wide: bool = False
    options: Mapping[str, Any] = field(default_factory=dict)


@cache
def setup() -> Setup:
    """What all trials share."""
    data = _toml("trials")
    return Setup(
        aircraft=data["aircraft"],
        lateral_velocity=data["lateral_velocity"],
        duration=data["duration"],
        samples=data["samples"],
    )


@cache
def trials() -> Mapping[int, Trial]:
    """The trials by number."""
    data = _toml("trials")
    found = {}
    for entry in data["trial"]:
        configuration = data["configurations"][entry["configuration"]]
        found[entry["number"]] = Trial(
            number=entry["number"],
            configuration=configuration["title"],
            changes=changes({**configuration["changes"], **entry["changes"]}),
            readings={model: entry[model] for model in ("linear", "nonlinear") if model in entry},
            tail_load=entry.get("tail_load"),
        )
    return found


@cache
def readings() -> Mapping[str, str]:
    """The readings of the time constant, in words."""
    return dict(_toml("trials")["readings"])


@cache
def tables() -> Mapping[str, Table]:
    """The printed tables by number."""
    data = _toml("tables")
    tolerances = {name: Tolerance(**entry) for name, entry in data["tolerances"].items()}
    return {entry["number"]: _table(entry, data, tolerances) for entry in data["table"]}


@cache
def errata() -> Mapping[int, Erratum]:
    """The errata by number."""
    return {entry["number"]: _erratum(entry) for entry in _toml("errata")["erratum"]}


@cache
def figures() -> Mapping[str, FigureSpec]:
    """The figures by number."""
    named = FigureSpec.__dataclass_fields__
    found = {}
    for entry in _toml("figures")["figure"]:
        options = {key: value for key, value in entry.items() if key not in named}
        fields = {key: value for key, value in entry.items() if key in named}
        found[entry["number"]] = FigureSpec(**fields, options=options)
    return found


@cache
def sections() -> tuple[Section, ...]:
    """The sections that hold tables or figures, in order."""
    return tuple(Section(**entry) for entry in _toml("report")["section"])


@cache
def citation() -> str:
    """The thesis."""
    return str(_toml("report")["citation"])


@cache
def digest() -> str:
    """A digest of every data file of the study."""
    folder = resources.files("groundroll.study") / "data"
    found = hashlib.sha256()
    for path in sorted(folder.iterdir(), key=lambda p: p.name):
        found.update(path.name.encode() + b"\0" + path.read_bytes() + b"\0")
    return found.hexdigest()[:16]


@cache
def figure_words(kind: str) -> Mapping[str, str]:
    """What legends call things: ``"labels"``, ``"models"`` or ``"sets"``."""
    return dict(_toml("figures")[kind])


def changes(given: Mapping[str, Any]) -> dict[str, Any]:
    """Changes to an aircraft as `Aircraft.replace` takes them."""
    return {name: None if value == _FOLLOWS else value for name, value in given.items()}


def _table(
    entry: Mapping[str, Any], data: Mapping[str, Any], tolerances: Mapping[str, Tolerance]
) -> Table:
    wanted = entry.get("trials")
    rows = [row for row in _csv(entry["file"]) if not wanted or int(row["trial"]) in wanted]
    columns = []
    for name in entry.get("columns", ()):
        for key in data["groups"].get(name, [name]):
            column = data["columns"][key]
            own = entry.get("tolerances", {}).get(name, column["tolerance"])
            columns.append(
                Column(key, column["quantity"], column["label"], column["unit"], tolerances[own])
            )
    return Table(
        number=entry["number"],
        title=entry["title"],
        section=entry["section"],
        kind=entry["kind"],
        rows=tuple(rows),
        tolerance=tolerances["digit"],
        columns=tuple(columns),
        model=entry.get("model", ""),
        note=entry.get("note", ""),
        changes=changes(entry.get("changes", {})),
        symbols=entry.get("symbols", {}),
        labels=entry.get("labels", {}),
        multiples=entry.get("multiples", {}),
    )


def _erratum(entry: Mapping[str, Any]) -> Erratum:
    cells = tuple(Coverage(**cell) for cell in entry.get("cells", ()))
    return Erratum(**{**entry, "cells": cells})


def _toml(name: str) -> dict[str, Any]:
    return tomllib.loads(_text(f"{name}.toml"))


def _csv(name: str) -> list[dict[str, str]]:
    lines = [line for line in _text(name).splitlines() if not line.startswith("#")]
    return [dict(row) for row in csv.DictReader(lines)]


def _text(name: str) -> str:
    path = resources.files("groundroll.study") / "data" / name
    return path.read_text(encoding="utf-8")


@cache
def placement_captions() -> dict[str, str]:
    """Captions of the pictures of the gear placement, by name."""
    return {name: str(caption) for name, caption in _toml("report")["placement"].items()}
