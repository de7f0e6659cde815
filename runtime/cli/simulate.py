"""``groundloop simulate``."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from groundloop.generated.names import MODELS, QUANTITIES

from . import options
from .output import Output, emit, number, say, shown, table
from .progress import bar

if TYPE_CHECKING:
    from groundloop.metrics import Metrics
    from groundloop.simulation import Trajectory

_STATES = MODELS["nonlinear"].states


def _initial(command: Any) -> Any:
    """--v0, --r0, ...: one option for each state."""
    for s in reversed(_STATES):
        q = QUANTITIES[s]
        text = f"{q.name.replace('_', ' ').capitalize()} at the start."
        command = options.quantity(f"{s}0", q.unit, text, default=0.0)(command)
    return command


@click.command(
    name="simulate",
    epilog=options.example(
        "groundloop simulate brott --v0 '0.1 m/s' --speed '100 km/h' --plot run.png"
    ),
)
@options.aircraft
@options.tire()
@_initial
@options.quantity("t", "s", "Duration.", default=5.0)
@click.option("--samples", type=int, default=501, show_default=True, help="How many to keep.")
@options.speed
@options.disturbance
@click.option(
    "--method",
    type=click.Choice(["rk45", "rk4"]),
    default="rk45",
    show_default=True,
    help="Integrator: adaptive steps, or fixed ones.",
)
@click.option(
    "--view",
    type=click.Choice(["history", "runway"]),
    default="history",
    show_default=True,
    help="Picture of quantities over time, or of the runway from above.",
)
@click.option(
    "--show", default="y,theta", show_default=True, help="States and outputs over time to draw."
)
@options.output
@options.picture
def command(
    plane: str,
    changes: options.Changes,
    tire: str,
    t: float,
    samples: int,
    speed: float | None,
    disturbance: float,
    method: str,
    view: str,
    show: str,
    form: str,
    out: Path | None,
    plot: Path | None,
    plotless: bool,
    **initial: float,
) -> None:
    """Simulate the ground roll after a disturbance, hands off.

    The table tells the largest and the last value of each quantity; csv and json hold them over
    time.
    """
    from groundloop.simulation import simulate

    aircraft = options.loaded(plane, changes)
    if not any(initial.values()) and not disturbance:
        say("nothing disturbs the aircraft: give --v0, --r0 or --disturbance")
    with bar():
        run = simulate(
            aircraft,
            tire,
            t=t,
            samples=samples,
            speed=speed,
            disturbance=disturbance,
            method=method,
            **initial,
        )
        metrics = run.metrics()
    emit(Output(_text(run, metrics), _rows(run), _data(run, metrics)), form, out)
    names = tuple(name.strip() for name in show.split(","))
    figure = partial(_runway, run) if view == "runway" else partial(_history, run, names)
    options.draw(figure, f"{run.aircraft.name}-simulate", form, plot, plotless)


def _runway(run: Trajectory) -> Any:
    from groundloop.runway import runway_view

    return runway_view(run).figure


def _text(run: Trajectory, metrics: Metrics) -> str:
    rows = []
    for s, series in run.values.items():
        q = QUANTITIES[s]
        peak, unit = shown(abs(series).max(), q.unit)
        last, _ = shown(series[-1], q.unit)
        rows.append([q.name, s, number(peak), number(last), unit])
    head = (
        f"{run.aircraft.name}, {run.tire} tire, {number(run.aircraft['u'])} m/s,"
        f" {number(run.t[-1])} s"
    )
    over_time = table(["quantity", "symbol", "largest", "at the end", "unit"], rows, right=(2, 3))
    return f"{head}\n\n{over_time}\n\nResponse of y\n{_metrics_table(metrics)}"


_METRICS = {
    "displacement": "m",
    "rotation": "rad",
    "time_constant": "s",
    "rise_time": "s",
    "settling_time": "s",
    "overshoot": "1",
}


def _metrics_table(metrics: Metrics) -> str:
    rows = []
    for name, unit in _METRICS.items():
        value, unit_shown = shown(getattr(metrics, name), unit)
        if name == "overshoot":
            value, unit_shown = 100 * value, "%"
        rows.append([name, number(value), unit_shown])
    return table(["metric", "value", "unit"], rows, right=(1,))


def _rows(run: Trajectory) -> list[list[Any]]:
    header = ["t [s]", *(options.with_unit(s, QUANTITIES[s].unit) for s in run.values)]
    columns = [run.t, *run.values.values()]
    return [header, *([float(x) for x in row] for row in zip(*columns, strict=True))]


def _data(run: Trajectory, metrics: Metrics) -> dict[str, Any]:
    return {
        **options.about(run.aircraft, tire=run.tire, speed=run.aircraft["u"]),
        "units": {"t": "s", **{s: QUANTITIES[s].unit for s in run.values}},
        "t": run.t,
        **run.values,
        "metrics": {name: getattr(metrics, name) for name in _METRICS},
    }


def _history(run: Trajectory, names: tuple[str, ...]) -> Any:
    return run.plot(names)[0].figure
