"""``groundroll fit-tire``."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from click.shell_completion import CompletionItem

from . import options
from .output import Output, emit, filled, number, shown, table
from .progress import bar

if TYPE_CHECKING:
    from groundroll.tire_fit import TireFit


class _TireData(options.ParamType):
    """A packaged tire table by name, or a CSV file."""

    name = "data"

    def shell_complete(self, ctx: Any, param: Any, incomplete: str) -> list[CompletionItem]:
        from groundroll.aircraft_file import packaged_files

        names = [n for n in packaged_files(".csv") if n.startswith(incomplete)]
        return [*map(CompletionItem, names), CompletionItem(incomplete, type="file")]


@click.command(
    name="fit-tire", epilog=options.example("groundroll fit-tire goodyear-6.00-6 --format csv")
)
@click.argument("data", type=_TireData(), default="goodyear-6.00-6")
@options.output
def command(data: str, form: str, out: Path | None) -> None:
    """Fit the non-linear tire to measured forces: a CSV file, or a packaged table by name.

    An aircraft file can name the table itself: table = "file.csv" in [main_tires].
    """
    from groundroll.tire_fit import fit_tire

    with bar():
        fit = fit_tire(data)
    emit(Output(_text(fit), _rows(fit), _data(fit)), form, out)


def _text(fit: TireFit) -> str:
    rows = []
    for symbol, name, value, unit in _rows(fit)[1:]:
        shown_value, shown_unit = shown(value, str(unit))
        rows.append([str(name), str(symbol), number(shown_value), shown_unit])
    loads = fit.data.loads
    edge = [
        f"{symbol} is at the end of what is possible: the best fit would lie beyond. Do the forces"
        " level off within the measured slip angles?"
        for symbol in fit.at_edge
    ]
    return "\n\n".join(
        (
            f"{fit.data.name}: {fit.data.slip_angles.size} slip angles, {loads.size} loads from"
            f" {number(loads[0])} to {number(loads[-1])} N",
            table(["parameter", "symbol", "value", "unit"], rows, right=(2,)),
            f"Root mean square error: {fit.force_rms:.1f} N; of the normalised force {fit.rms:.4f}",
            *map(filled, edge),
        )
    )


def _rows(fit: TireFit) -> list[list[Any]]:
    from groundroll.names import QUANTITIES

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
        "force_rms": fit.force_rms,
        "rms": fit.rms,
        "conditioning": fit.conditioning,
        "at_edge": fit.at_edge,
    }
