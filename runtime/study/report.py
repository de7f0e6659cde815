"""The study for people: one HTML page that needs nothing else, and tables as text."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterable, Mapping, Sequence
from importlib import resources
from typing import TYPE_CHECKING

import jinja2
from markupsafe import Markup, escape

from .ledger import Cell, count, decimals, rows
from .provenance import provenance
from .sources import Table, citation, errata, figures, placement_captions, sections, tables

if TYPE_CHECKING:
    from groundroll.placement.worked import WorkedStudy

_MARKS = {"agrees": "✓", "explained": "E", "differs": "✗"}


def html(cells: Sequence[Cell], drawings: Mapping[str, str], placement: WorkedStudy) -> str:
    """The report.

    Parameters
    ----------
    cells : sequence of Cell
        The ledger.
    drawings : mapping of str to str
        SVG by figure number or name.
    placement : WorkedStudy
        Where the wheels should stand.
    """
    folder = resources.files("groundroll.study")
    environment = jinja2.Environment(
        autoescape=True, trim_blocks=True, lstrip_blocks=True, undefined=jinja2.StrictUndefined
    )
    environment.filters |= {
        "computed": computed_text,
        "linked": linked,
        "mark": mark,
        "symbol": symbol,
    }
    template = environment.from_string((folder / "report.html.j2").read_text(encoding="utf-8"))
    style = (folder / "report.css").read_text(encoding="utf-8")
    return template.render(
        style=Markup(style),
        citation=citation(),
        counts=count(cells),
        total=len(cells),
        sections=sections(),
        tables=tables(),
        grids={number: grid(table, cells) for number, table in tables().items()},
        figures=figures(),
        drawings={number: Markup(drawing) for number, drawing in drawings.items()},
        errata=errata(),
        explained=explained(cells),
        placement=placement,
        placement_figures=placement_captions(),
        provenance=provenance(),
    )


def grid(table: Table, cells: Sequence[Cell]) -> dict[str, list[Cell]]:
    """The cells of a table by row."""
    found: dict[str, list[Cell]] = {}
    for cell in cells:
        if cell.table == table.number:
            found.setdefault(cell.row, []).append(cell)
    return found


def explained(cells: Iterable[Cell]) -> dict[int, list[Cell]]:
    """Explained cells by erratum."""
    found: dict[int, list[Cell]] = {}
    for cell in cells:
        if cell.erratum is not None:
            found.setdefault(cell.erratum, []).append(cell)
    return found


def computed_text(cell: Cell) -> str:
    """The computed value with one digit more than the print."""
    return "—" if cell.computed is None else _like(cell.as_printed, cell.computed)


def mark(cell: Cell) -> str:
    """Tick, erratum number or cross."""
    return f"E{cell.erratum}" if cell.verdict == "explained" else _MARKS[cell.verdict]


def symbol(label: str) -> Markup:
    """A symbol such as ``C_f`` with its subscript."""
    base, _, below = label.partition("_")
    return Markup("<i>{}</i>").format(base) + (
        Markup("<sub>{}</sub>").format(below) if below else ""
    )


def linked(text: str) -> Markup:
    """A text in which each "erratum 3" leads to the erratum."""
    return Markup(
        re.sub(r"erratum (\d+)", r'<a href="#erratum-\1">erratum \1</a>', str(escape(text)))
    )


def markdown(cells: Sequence[Cell]) -> str:
    """All tables as text: printed, computed and verdict in each cell."""
    counts = count(cells)
    parts = [
        "# Brott 1998, printed and computed",
        f"{citation()}.",
        f"{len(cells)} cells: {counts['agrees']} agree, {counts['explained']} are explained by an"
        f" erratum, {counts['differs']} differ. Each cell: printed / computed, then ✓ (agrees),"
        " E and the number of an erratum in the report, or ✗ (differs).",
    ]
    for table in tables().values():
        parts += [f"## Table {table.number}: {table.title}", _markdown_table(table, cells)]
        parts += [table.note] if table.note else []
    return "\n\n".join(parts) + "\n"


def as_csv(cells: Sequence[Cell]) -> str:
    """The ledger for a spreadsheet."""
    target = io.StringIO()
    plain = rows(cells)
    writer = csv.DictWriter(target, list(plain[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows(plain)
    return target.getvalue()


def _markdown_table(table: Table, cells: Sequence[Cell]) -> str:
    found = grid(table, cells)
    if table.kind == "trials":
        first = next(iter(found.values()))
        head = ["Trial", *(f"{cell.label} ({cell.unit})" for cell in first)]
        body = [[row, *map(_in_one, line)] for row, line in found.items()]
    else:
        head = ["Symbol", "Quantity", "Value", "Unit"]
        body = [
            [cell.label, cell.quantity.replace("_", " "), _in_one(cell), cell.unit]
            for line in found.values()
            for cell in line
        ]
    lines = [head, ["---"] * len(head), *body]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def _in_one(cell: Cell) -> str:
    return f"{cell.as_printed} / {computed_text(cell)} {mark(cell)}"


def _like(as_printed: str, value: float) -> str:
    """A number in the form of a printed one, with one digit more."""
    if "e" in as_printed:
        digits = len(as_printed.partition("e")[0].partition(".")[2])
        mantissa, _, exponent = f"{value:.{digits}e}".partition("e")
        text = f"{mantissa}e{int(exponent)}"
    else:
        digits = decimals(as_printed) if as_printed != "N/A" else 0
        text = f"{value:.{digits + 1}f}"
    return "0" if float(text) == 0 else text
