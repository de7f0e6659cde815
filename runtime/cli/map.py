"""``groundroll map``."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import numpy as np

from groundroll.base.bar import bar

from . import options
from .output import Output, emit, filled, number, shown, table

if TYPE_CHECKING:
    from groundroll.stability.maps import StabilityMap


@click.command(
    name="map",
    epilog=options.example(
        "groundroll map cessna-170 --x 'speed=10 kt:60 kt' --y 'main_gear_station=0 in:40 in'"
    ),
)
@options.aircraft
@click.option("--x", type=options.Range(), required=True, help="Parameter and range across.")
@click.option("--y", type=options.Range(), required=True, help="Parameter and range upwards.")
@click.option(
    "--of",
    default="decay_rate",
    show_default=True,
    help="What to map, e.g. damping_ratio, static_margin, upper_critical_speed.",
)
@options.result
@options.picture
def command(
    plane: str,
    changes: options.Changes,
    x: options.Grid,
    y: options.Grid,
    of: str,
    form: str,
    out: Path | None,
    plot: Path | None,
    plotless: bool,
) -> None:
    """A margin of the linear model over any two parameters, with the boundary of stability.

    A range is name=low:high or name=low:high:points, with units.
    """
    from groundroll.stability.maps import stability_map

    with bar():
        chart = stability_map(options.loaded(plane, changes), x.values, y.values, of)
    emit(Output(_text(chart), _rows(chart), _data(chart), chart), form, out)
    options.tell(chart.aircraft)
    units = {grid.symbol: grid.unit for grid in (x, y) if grid.unit}
    default = f"{chart.aircraft.name}-map"
    options.draw(lambda: chart.plot(units=units).figure, default, form, plot, plotless)


def _text(chart: StabilityMap) -> str:
    axes = [_axis(s, values) for s, values in ((chart.x_name, chart.x), (chart.y_name, chart.y))]
    head = filled(f"{chart.aircraft.name}: {chart.of} over {axes[0]} and {axes[1]}")
    share = np.count_nonzero(chart.stable) / chart.stable.size
    parts = [head, f"{100 * share:.1f} % of {chart.values.size} points are stable"]
    if np.isfinite(chart.values).any():
        parts.append(_extremes(chart))
    return "\n\n".join(parts)


def _axis(symbol: str, values: Any) -> str:
    from groundroll.model.names import QUANTITIES

    q = QUANTITIES[symbol]
    low, unit = shown(values[0], q.unit)
    return f"{q.name} from {number(low)} to {number(shown(values[-1], q.unit)[0])} {unit}".rstrip()


def _extremes(chart: StabilityMap) -> str:
    from groundroll.model.names import QUANTITIES

    axes = [(s, QUANTITIES[s].unit) for s in (chart.x_name, chart.y_name)]
    heads = [options.with_unit(s, shown(0.0, unit)[1] or "1") for s, unit in axes]
    finite = np.where(np.isfinite(chart.values), chart.values, np.nan)
    rows = []
    for word, place in (("least", np.nanargmin(finite)), ("largest", np.nanargmax(finite))):
        i, j = np.unravel_index(int(place), finite.shape)
        at = [chart.x[j], chart.y[i]]
        where = [number(shown(value, unit)[0]) for value, (_, unit) in zip(at, axes, strict=True)]
        rows.append([word, number(finite[i, j]), *where])
    header = ["", options.with_unit(chart.of, chart.unit), *heads]
    return table(header, rows, right=(1, 2, 3))


def _rows(chart: StabilityMap) -> Iterator[list[Any]]:
    from groundroll.model.names import QUANTITIES

    axes = [options.with_unit(s, QUANTITIES[s].unit) for s in (chart.x_name, chart.y_name)]
    yield [*axes, options.with_unit(chart.of, chart.unit), "stable"]
    grid = np.meshgrid(chart.x, chart.y)
    columns = (each.reshape(-1).tolist() for each in (*grid, chart.values, chart.stable))
    yield from map(list, zip(*columns, strict=True))


def _data(chart: StabilityMap) -> dict[str, Any]:
    return {
        **options.about(chart.aircraft),
        "of": chart.of,
        "unit": chart.unit,
        "x_name": chart.x_name,
        "y_name": chart.y_name,
        "x": chart.x,
        "y": chart.y,
        "values": chart.values,
        "stable": chart.stable,
    }
