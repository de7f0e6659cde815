"""``groundroll hold``."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from groundroll.base.bar import bar

from . import options
from .output import Output, emit, number, table

if TYPE_CHECKING:
    from groundroll.control.page import Held

_HEADS = ("speed [kt]", "wind [kt]", "binds", "delay [s]", "doubles in [s]", "pedal", "brake")


@click.command(
    name="hold", epilog=options.example("groundroll hold cessna-170 --surface wet --brake 0.3")
)
@options.aircraft
@click.option("--surface", default="", help="dry, wet, grass, snow, ice; default: the aircraft's.")
@click.option(
    "--brake",
    type=click.FloatRange(0.0, 1.0),
    default=0.0,
    show_default=True,
    help="The most that one brake may do once the pedal is at its stop.",
)
@options.output
@options.picture
def command(
    plane: str,
    changes: options.Changes,
    surface: str,
    brake: float,
    form: str,
    out: Path | None,
    plot: Path | None,
    plotless: bool,
) -> None:
    """What can be held at each speed: the strongest wind, and how late a pilot may be.

    Wind is steady and from the side; gusts are left out. It certifies nothing.
    """
    from groundroll.control.page import held

    aircraft = options.loaded(plane, changes)
    with bar():
        found = held(aircraft, surface, brake)
    rows = _rows(found)
    cells = table(_HEADS, _cells(rows), right=(0, 1, 3, 4, 5, 6))
    text = f"{found.clause!r}\n\n{cells}"
    emit(Output(text, [list(_HEADS), *rows], _data(found, rows)), form, out)
    options.tell(aircraft)
    options.draw(found.plot, f"{aircraft.name}-hold", form, plot, plotless)


def _rows(found: Held) -> list[list[Any]]:
    from groundroll.base.units import from_si

    knots = from_si(1.0, "m/s", "kt")
    limit, still = found.limit, found.still
    columns = (
        (limit.speed * knots).tolist(),
        (limit.wind * knots).tolist(),
        limit.what.tolist(),
        still.delay.tolist(),
        still.doubling_time.tolist(),
        limit.pedal.tolist(),
        limit.brake.tolist(),
    )
    return [list(row) for row in zip(*columns, strict=True)]


def _cells(rows: list[list[Any]]) -> list[list[str]]:
    return [[x if isinstance(x, str) else number(x, 3) for x in row] for row in rows]


def _data(found: Held, rows: list[list[Any]]) -> dict[str, Any]:
    clause = found.clause
    return {
        **options.about(found.limit.aircraft, surface=found.surface),
        "columns": list(_HEADS),
        "rows": rows,
        "asked": clause.asked,
        "held": clause.wind,
    }
