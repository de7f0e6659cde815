"""``groundroll fit-tire``."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from click.shell_completion import CompletionItem

from groundroll.base.bar import bar

from . import options
from .output import Output, emit, number, paragraph, shown, table

if TYPE_CHECKING:
    from groundroll.tires.fit import TireFit


class _TireData(options.ParamType):
    """A packaged tire table by name, or a file."""

    name = "data"

    def shell_complete(self, ctx: Any, param: Any, incomplete: str) -> list[CompletionItem]:
        from groundroll.tires.data import packaged_tables

        names = [n for n in packaged_tables() if n.startswith(incomplete)]
        return [*map(CompletionItem, names), CompletionItem(incomplete, type="file")]


@click.command(
    name="fit-tire", epilog=options.example("groundroll fit-tire goodyear-6.00-6 --format csv")
)
@click.argument("data", type=_TireData(), default="goodyear-6.00-6")
@options.output
def command(data: str, form: str, out: Path | None) -> None:
    """Fit the non-linear tire to measured forces: a CSV or .tir file, or a packaged table by name.

    A CSV file is a table of slip angles by loads, or has a point (angle, load, force) in each line.

    An aircraft file can name the table itself: table = "file.csv" in [main_tires].
    """
    from groundroll.tires.fit import fit_tire

    with bar():
        fit = fit_tire(data)
    emit(Output(_text(fit), _rows(fit), _data(fit)), form, out)


def _text(fit: TireFit) -> str:
    rows = []
    for symbol, name, value, unit in _rows(fit)[1:]:
        shown_value, shown_unit = shown(value, str(unit))
        rows.append([str(name), str(symbol), number(shown_value), shown_unit])
    notes = "\n".join(["Worth knowing", *map(paragraph, fit.notes)]) if fit.notes else ""
    error = f"Root mean square error: {fit.force_rms:.1f} N, {100 * fit.rms:.2g} % of friction"
    head = f"{fit.data.name}: {fit.data!r}".replace(f"TireData {fit.data.name!r}: ", "")
    parameters = table(["parameter", "symbol", "value", "unit"], rows, right=(2,))
    return "\n\n".join(filter(None, (head, parameters, error, notes)))


def _rows(fit: TireFit) -> list[list[Any]]:
    from groundroll.model.names import QUANTITIES

    found = [
        [s, QUANTITIES[s].name, float(value), QUANTITIES[s].unit]
        for s, value in fit.parameters.items()
    ]
    return [["symbol", "name", "value", "unit"], *found]


def _data(fit: TireFit) -> dict[str, Any]:
    header, *rows = _rows(fit)
    return {
        "data": fit.data.name,
        "parameters": [dict(zip(header, row, strict=True)) for row in rows],
        "offsets": [{"load": load, "force": force} for load, force in fit.offsets.items()],
        "force_rms": fit.force_rms,
        "rms": fit.rms,
        "notes": list(fit.notes),
    }
