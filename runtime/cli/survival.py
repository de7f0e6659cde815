"""``groundroll survival``."""

from __future__ import annotations

import math
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import numpy as np

from groundroll.base.bar import bar
from groundroll.model.models import ModelLike

from . import options
from .output import Output, emit, filled, number, shown, table

if TYPE_CHECKING:
    from groundroll.aircraft.aircraft import Aircraft
    from groundroll.fates.kicks import Survival

#: Cases along a range that names no number of points, and points along an axis of the picture.
_POINTS, _PICTURE = 8, 121
#: The picture goes to so many times the threshold, and over these shares of the speed.
_BEYOND, _SPEEDS = 1.5, (0.5, 1.5)

#: Columns: of a result, its unit.
_COLUMNS = {
    "station": "m",
    "speed": "m/s",
    "impulse": "N s",
    "velocity_change": "m/s",
    "yaw_rate_change": "rad/s",
    "island": "N s",
    "decay_rate": "1/s",
}


@click.command(
    name="survival",
    epilog=options.example(
        "groundroll survival brott-physical --station=-3.88 --speed '60 km/h:160 km/h'"
    ),
)
@options.aircraft
@options.model()
@options.inputs
@options.varied(
    "station",
    "station",
    "m",
    "Where the impulse acts, ahead of the CG (behind it: --station=-3).",
    default=0.0,
    show_default=True,
)
@options.varied("speed", "u", "m/s", "Forward speed; default the aircraft's own.")
@options.quantity(
    "half-width", "m", "Half the width of the runway.", default=15.0, show_default=True
)
@options.quantity(
    "heading",
    "rad",
    "Heading it must stay within.",
    default=math.radians(45),
    show_default="45 deg",
)
@click.option(
    "--settled",
    type=float,
    default=0.1,
    show_default=True,
    help="It has straightened out when motion has fallen to this share of its largest (where the"
    " speed is held; else it must stop).",
)
@options.quantity("t", "s", "Time in which it must; default 20 s, 300 s where the speed falls.")
@options.quantity("largest", "N s", "Largest impulse tried. Default: what v = speed takes.")
@click.option("--threads", type=click.IntRange(min=1), help="Default: every processor.")
@options.result
@options.picture
def command(
    plane: str,
    changes: options.Changes,
    model: ModelLike,
    inputs: options.Values,
    station: float | options.Grid,
    speed: float | options.Grid | None,
    settled: float,
    t: float | None,
    largest: float | None,
    threads: int | None,
    form: str,
    out: Path | None,
    plot: Path | None,
    plotless: bool,
    **limits: float,
) -> None:
    """How hard a side kick an aircraft survives, hands off.

    It survives if it straightens out, or in a model whose speed falls comes to a stop, on the
    runway and without turning too far. Right and left are the same. The picture is of what becomes
    of it over speed and impulse; of a range of stations, the threshold over them.
    """
    from groundroll.fates.kicks import survival

    aircraft = options.loaded(plane, changes, model)
    asked: dict[str, Any] = {**limits, "settled": settled, "t": t, "threads": threads}
    asked |= {"model": model, **options.by_name(inputs)}
    stations, speeds = _values(station), _values(aircraft["u"] if speed is None else speed)
    grid = {"station": stations[:, None], "speed": speeds[None, :]}
    with bar("kicks") as show:
        found = survival(aircraft, **grid, largest=largest, **asked, progress=show)
    cases = _cases(found, speeds)
    data = _data(found, stations, speeds)
    emit(Output(_text(found, cases), _rows(found, cases), data, found), form, out)
    options.tell(found.aircraft)
    draw = partial(_over_stations, found) if stations.size > 1 else None
    draw = draw or partial(_basin, found, aircraft, speeds, asked)
    options.draw(draw, f"{aircraft.name}-survival", form, plot, plotless)


def _values(given: Any) -> Any:
    if isinstance(given, options.Grid):
        return given.spread(_POINTS)
    return np.atleast_1d(np.asarray(given, dtype=float))


def _cases(found: Survival, speeds: Any) -> dict[str, Any]:
    """Every column, flat."""
    arrays = {name: speeds if name == "speed" else getattr(found, name) for name in _COLUMNS}
    return {
        name: np.broadcast_to(values, found.impulse.shape).reshape(-1)
        for name, values in arrays.items()
    }


def _text(found: Survival, cases: dict[str, Any]) -> str:
    c = found.criterion
    head = (
        f"{found.aircraft.name}: the largest side impulse, right or left, after which it"
        f" stays within {number(c.half_width)} m of the centre line and"
        f" {number(math.degrees(c.heading))} deg of heading"
    )
    columns = [name for name in cases if name != "island" or np.isfinite(cases[name]).any()]
    header = [
        options.with_unit(name.replace("_", " "), shown(0.0, _COLUMNS[name])[1] or "1")
        for name in columns
    ]
    fates = [found.FATES[k] if k else "nothing tried" for k in found.fate.reshape(-1).tolist()]
    rows = [
        [*(number(shown(cases[name][k], _COLUMNS[name])[0]) for name in columns), fate]
        for k, fate in enumerate(fates)
    ]
    parts = [filled(head), table([*header, "beyond it"], rows, right=range(len(columns)))]
    if "island" in columns:
        parts.append(
            filled("island: some larger impulses are survived again, the largest found being this")
        )
    return "\n\n".join(parts)


def _rows(found: Survival, cases: dict[str, Any]) -> list[list[Any]]:
    heads = [options.with_unit(name, unit) for name, unit in _COLUMNS.items()]
    fates = found.fate.reshape(-1).tolist()
    columns = (values.tolist() for values in cases.values())
    each = zip(zip(*columns, strict=True), fates, strict=True)
    return [[*heads, "fate"], *([*values, found.FATES[fate]] for values, fate in each)]


def _data(found: Survival, stations: Any, speeds: Any) -> dict[str, Any]:
    return {
        **options.about(found.aircraft),
        "criterion": vars(found.criterion),
        "station": stations,
        "speed": speeds,
        "fates": found.FATES,
        "fate": found.fate,
        **{n: getattr(found, n) for n in _COLUMNS if n not in ("station", "speed")},
    }


def _basin(found: Survival, aircraft: Aircraft, speeds: Any, asked: dict[str, Any]) -> Any:
    """What becomes of it over speed and impulse, with the threshold of the table."""
    from groundroll.fates.basins import basin
    from groundroll.view.plots import INK

    low, high = (1.0, 1.0) if speeds.size > 1 else _SPEEDS
    reach = np.nanmax([found.impulse, np.nan_to_num(found.island)])
    top = _BEYOND * reach or float(aircraft["m"] * speeds.max()) / 2
    station = float(found.station.flat[0])
    x = ("speed", np.linspace(low * speeds[0], high * speeds[-1], _PICTURE))
    y = ("impulse", np.linspace(0.0, top, _PICTURE))
    with bar("kicks") as show:
        chart = basin(aircraft, x, y, station=station, **asked, progress=show)
    ax = chart.plot()
    ax.plot(speeds, found.impulse[0], "o", color=INK, markersize=4, clip_on=False)
    return ax.figure


def _over_stations(found: Survival) -> Any:
    """Threshold over the station, a line for each speed."""
    from matplotlib import pyplot

    from groundroll.view.plots import COLOURS, DASHES, style

    with style():
        figure, ax = pyplot.subplots(figsize=(5.6, 4.0))
        speeds = np.broadcast_to(found.aircraft["u"], found.impulse.shape)[0]
        for k, u in enumerate(speeds):
            look: Any = {"color": COLOURS[k % len(COLOURS)], "linestyle": DASHES[k % len(DASHES)]}
            ax.plot(found.station[:, k], found.impulse[:, k], label=f"{u:.3g} m/s", **look)
        ax.axvline(0.0, color="#666666", linewidth=0.8)
        ax.annotate(" CG", (0.0, 1.0), xycoords=("data", "axes fraction"), va="top", fontsize=8)
        ax.set_ylim(bottom=0.0)
        ax.set_xlabel("station of the impulse, ahead of the CG (m)")
        ax.set_ylabel("largest impulse survived (N s)")
        ax.legend()
    return figure
