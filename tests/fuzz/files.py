"""Aircraft files and tables of tires, as they are written and with mistakes in them."""

from __future__ import annotations

import csv
import math
import tomllib
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

import groundroll as gr
from groundroll.aircraft.aircraft import packaged
from groundroll.aircraft.file import packaged_files
from groundroll.model.names import MODELS, PARAMETERS
from groundroll.tires.data import packaged_tables

from . import mutation, truth
from .harness import Case

_NAMES = {name: q for s, q in PARAMETERS.items() for name in (s, q.name)}
#: What stands for many parameters at once, and is not judged here.
_WORDS = frozenset(("table", "size", "pressure", "rated_pressure", "surface"))
_FIELDS = frozenset(("value", "source", "estimate"))


def files(rng: np.random.Generator, model: str, folder: Path) -> Case:
    """A file of either kind."""
    if rng.random() < 0.3:
        return _table(rng, folder)
    return _aircraft(rng, model, folder)


# --- Aircraft --------------------------------------------------------------------------------


def _aircraft(rng: np.random.Generator, model: str, folder: Path) -> Case:
    plain = _packaged(rng) if rng.random() < 0.5 else _drawn(rng, model)
    content = mutation.text(rng, plain) if rng.random() < 0.8 else plain
    path = folder / "plane.toml"
    written = content.encode("utf-8", "surrogatepass")
    if rng.random() < 0.1:
        written = mutation.data(rng, written)
    path.write_bytes(written)
    return Case(f"aircraft file {written!r}", lambda: _loaded(path), lambda p: _judged(written, p))


def _loaded(path: Path) -> gr.Aircraft:
    plane = gr.Aircraft.load(path)
    repr(plane), plane._repr_html_()
    return plane


@cache
def _texts() -> tuple[str, ...]:
    files = packaged_files()
    return tuple(files[name].read_text(encoding="utf-8") for name in packaged())


def _packaged(rng: np.random.Generator) -> str:
    return str(mutation.pick(rng, _texts()))


def _drawn(rng: np.random.Generator, model: str) -> str:
    """A file with some parameters of a model."""
    known = [s for s in MODELS[model].parameters if s in PARAMETERS]
    chosen = rng.permutation(known)[: int(rng.integers(1, 12))]
    lines = [f'title = "{model}"', f"[{mutation.pick(rng, ('airframe', 'any', 'a.b'))}]"]
    for s in map(str, chosen):
        q = PARAMETERS[s]
        unit = str(mutation.pick(rng, truth.WRITTEN.get(q.unit, (q.unit,))))
        number = f"{float(rng.uniform(0.1, 50)):.4g}"
        written = number if rng.random() < 0.2 else f'"{number} {unit}"'
        if unit == "1":
            written = number
        if rng.random() < 0.3:
            written = f'{{ value = {written}, source = "s", estimate = true }}'
        lines.append(f"{mutation.pick(rng, (s, q.name))} = {written}")
    return "\n".join(lines) + "\n"


def _judged(written: bytes, plane: gr.Aircraft) -> str | None:
    """Whether an aircraft is what another reading of its file gives."""
    data = tomllib.loads(written.decode("utf-8-sig"))
    data.pop("parameters", None)
    expected: dict[str, float] = {}
    implied = False
    for key, content in _leaves(data):
        if key in _WORDS:
            implied = True
            continue
        value = _value(content, _NAMES[key].unit)
        if value is None:
            return None if _exotic(content) else f"{key}: {content!r} means nothing"
        expected[_NAMES[key].symbol] = value
    if set(expected) != set(plane.given) and not (implied and set(expected) < set(plane.given)):
        return f"given are {sorted(plane.given)}, written are {sorted(expected)}"
    wrong = [s for s, v in expected.items() if not truth.close(plane.given[s], v)]
    return "; ".join(f"{s}: {plane.given[s]} for {expected[s]}" for s in wrong)


def _leaves(data: Mapping[str, Any]) -> Iterator[tuple[str, Any]]:
    """Every key with a value, in whatever table it stands."""
    for key, content in data.items():
        if key in ("title", "description", "source") and isinstance(content, str):
            continue
        if isinstance(content, dict) and "value" not in content:
            yield from _leaves(content)
        else:
            yield key, content["value"] if isinstance(content, dict) else content


def _value(content: Any, unit: str) -> float | None:
    if isinstance(content, bool):
        return None
    if isinstance(content, int | float):
        return float(content) if math.isfinite(content) else None
    return truth.value(content, unit) if isinstance(content, str) else None


def _exotic(content: Any) -> bool:
    """Whether a text may have a meaning that is not known here: another unit, or two."""
    return isinstance(content, str) and any(c.isalpha() for c in content)


# --- Tables ----------------------------------------------------------------------------------


def _table(rng: np.random.Generator, folder: Path) -> Case:
    plain = _drawn_table(rng) if rng.random() < 0.7 else _packaged_table()
    content = mutation.text(rng, plain) if rng.random() < 0.8 else plain
    path = folder / "tire.csv"
    written = content.encode("utf-8", "surrogatepass")
    path.write_bytes(written)
    return Case(
        f"table {written!r}", lambda: gr.TireData.load(path), lambda d: _judged_table(written, d)
    )


@cache
def _packaged_table() -> str:
    return packaged_tables()["goodyear-6.00-6"].read_text(encoding="utf-8")


def _drawn_table(rng: np.random.Generator) -> str:
    loads = np.cumsum(rng.integers(100, 900, int(rng.integers(2, 6))))
    angles = [0, 1, *sorted(set(rng.integers(2, 40, int(rng.integers(3, 9))).tolist()))]
    unit = str(mutation.pick(rng, ("", " lbf", " N")))
    lines = ["slip_angle_deg," + ",".join(f"{load}{unit}" for load in loads)]
    for angle in angles:
        forces = np.sin(np.arctan(0.2 * angle)) * loads * rng.uniform(0.6, 0.9)
        lines.append(f"{angle}," + ",".join(f"{force:.2f}" for force in forces))
    return "\n".join(lines) + "\n"


def _judged_table(written: bytes, data: gr.TireData) -> str | None:
    """Whether a table is what a plain reading gives; None if it is written in another way."""
    try:
        text = written.decode("utf-8-sig")
        lines = [x for x in text.splitlines() if x.strip() and not x.lstrip().startswith("#")]
        header, *rows = [[c.strip() for c in row] for row in csv.reader(lines, strict=True)]
        numbers = [[float(c) for c in row] for row in rows]
        loads = [truth.value(c, "N") for c in header[1:]]
        units = {c.partition(" ")[2].strip() for c in header[1:]}
        force = truth.value(f"1 {units.pop()}", "N")
    except (ValueError, csv.Error, UnicodeDecodeError):
        return None
    plain = header[0] == "slip_angle_deg" and all(len(row) == len(header) for row in rows)
    if not plain or units or force is None or None in loads or data.notes:
        return None
    right = [
        (load, row[0], f * force) for row in numbers for load, f in zip(loads, row[1:], strict=True)
    ]
    found = zip(data.loads, np.degrees(data.slip_angles), data.forces, strict=True)
    pairs = zip(sorted(found), sorted(right), strict=True)
    wrong = [pair for pair in pairs if not np.allclose(*pair, 1e-9, 1e-9)]
    return f"{wrong[0][0]} for {wrong[0][1]}" if wrong else ""
