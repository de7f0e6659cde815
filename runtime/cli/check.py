"""``groundroll check``."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import click

from groundroll.base.bar import bar

from . import options
from .output import Output, emit, filled, number, paragraph, shown, table

if TYPE_CHECKING:
    from groundroll.aircraft.aircraft import Aircraft
    from groundroll.stability.checking import Check, Known

#: Whoever weighs in these reads forces in pounds too.
_POUNDS = frozenset(("lb", "lbs", "pound", "pounds"))


@click.command(name="check", epilog=options.example("groundroll check cessna-170"))
@options.aircraft
@click.option("--strict", is_flag=True, help="Exit with 1 if there are warnings.")
@options.output
def command(
    plane: str,
    changes: options.Changes,
    strict: bool,
    form: str,
    out: Path | None,
) -> None:
    """Explain what an aircraft file says, what follows from it and what is missing.

    Exits with 1 if the file has mistakes or no model can be run with it.
    """
    from groundroll.stability.checking import check

    with bar():
        found = check(options.loaded(plane, changes))
    emit(Output(_text(found), _rows(found), _data(found)), form, out)
    if all(found.missing.values()) or (strict and found.warnings):
        raise click.exceptions.Exit(1)


def _text(found: Check) -> str:
    plane = found.aircraft
    parts = [f"{plane.name}: {plane.title}"]
    parts += [filled(plane.description)] if plane.description else []
    parts += [filled(f"Source: {plane.source}")] if plane.source else []
    given = [k for k in found.known if not k.follows_from]
    follows = [k for k in found.known if k.follows_from]
    cited = list(dict.fromkeys(k.source.text for k in given if k.source.text))
    notes = {text: f"[{n}]" for n, text in enumerate(cited, start=1)}
    if given:
        marks = [notes.get(k.source.text, "") for k in given]
        parts.append("Given (~ is an estimate)\n" + _table(given, "source", marks))
    if notes:
        listed = "\n".join(paragraph(text, note) for text, note in notes.items())
        parts.append(f"Sources\n{listed}")
    if follows:
        origins = [", ".join(k.follows_from) for k in follows]
        parts.append("Follows\n" + _table(follows, "from", origins, _sheet(plane)))
    for title, texts in (
        *_missing(found),
        ("Look twice", found.warnings),
        ("Worth knowing", found.notes),
    ):
        if texts:
            parts.append("\n".join([title, *map(paragraph, texts)]))
    return "\n\n".join(parts)


def _missing(found: Check) -> Iterator[tuple[str, tuple[str, ...]]]:
    """What every model lacks, then what each lacks beside."""
    lists = list(found.missing.values())
    every = set(lists[0]).intersection(*lists[1:])
    yield "Missing", tuple(text for text in lists[0] if text in every)
    for model, missing in found.missing.items():
        yield f"Missing for the {model} model", tuple(t for t in missing if t not in every)


def _sheet(plane: Aircraft) -> dict[str, str]:
    """Units for what follows, by SI unit: those of the sheet it follows from."""
    from groundroll.aircraft.consistency import as_written

    units: dict[str, str] = {}
    if as_written(plane, "m")[1] in _POUNDS:
        units |= {"N": "lbf", "N/rad": "lbf/deg"}
    if "x_cg" in plane.given:
        units["m"] = as_written(plane, "x_cg")[1]
    if "p_tire" in plane.given:
        units["N/m^2"] = as_written(plane, "p_tire")[1]
    return units


def _table(
    known: list[Known], last: str, origins: list[str], units: Mapping[str, str] | None = None
) -> str:
    rows = []
    for k, origin in zip(known, origins, strict=True):
        mark = "~" if k.source.estimate else ""
        value, unit = _value(k, units or {})
        rows.append([k.name, k.symbol, mark + value, unit, origin])
    return table(["quantity", "symbol", "value", "unit", last], rows, right=(2,))


def _value(k: Known, units: Mapping[str, str]) -> tuple[str, str]:
    """Value and unit as written, or as people read them."""
    from groundroll.base.units import from_si, parts

    text, unit = parts(k.source.entry)
    if text:
        return text, unit or ("" if k.unit == "1" else k.unit)
    if k.value.ndim:
        return f"{k.value.size} values", k.unit
    if k.unit in units:
        return number(from_si(float(k.value), k.unit, units[k.unit])), units[k.unit]
    value, unit = shown(k.value, k.unit)
    return number(value), unit


def _rows(found: Check) -> list[list[object]]:
    header = ["symbol", "name", "value", "unit", "given", "estimate", "source", "follows_from"]
    rows: list[list[object]] = [list(header)]
    for k in found.known:
        given = not k.follows_from
        origin = [k.source.estimate, k.source.text, " ".join(k.follows_from)]
        rows.append([k.symbol, k.name, k.value.tolist(), k.unit, given, *origin])
    return rows


def _data(found: Check) -> dict[str, object]:
    header, *rows = _rows(found)
    return {
        **options.about(found.aircraft),
        "quantities": [dict(zip(map(str, header), row, strict=True)) for row in rows],
        "missing": found.missing,
        "warnings": found.warnings,
        "notes": found.notes,
    }
