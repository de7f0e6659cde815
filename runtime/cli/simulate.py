"""``groundroll simulate``."""

from __future__ import annotations

import math
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from groundroll.base.bar import bar
from groundroll.model.models import ModelLike, as_model
from groundroll.model.names import MODELS, QUANTITIES

from . import options
from .output import Output, emit, number, say, shown, table

if TYPE_CHECKING:
    from groundroll.runs.metrics import Metrics
    from groundroll.runs.simulation import Trajectory

_STATES = MODELS["nonlinear"].states
#: Whose metrics are shown.
_MEASURED = ("v", "r", "y", "theta")


def _initial(command: Any) -> Any:
    """--v0, --r0, ...: one option for each state."""
    for s in reversed(_STATES):
        q = QUANTITIES[s]
        text = f"{q.name.replace('_', ' ').capitalize()} at the start."
        command = options.quantity(f"{s}0", q.unit, text)(command)
    return command


def _gust(command: Any) -> Any:
    """--gust, --gust-start and --gust-length."""
    length = "How long it lasts; a step stays, and a cosine takes 1 s, if omitted."
    command = options.quantity("gust-length", "s", length)(command)
    command = options.quantity("gust-start", "s", "When it begins; 0 if omitted.")(command)
    text = "Let the disturbance be a gust, of this form and with --disturbance as its peak."
    return click.option("--gust", type=click.Choice(["step", "one_minus_cosine"]), help=text)(
        command
    )


@click.command(
    name="simulate",
    epilog=options.example(
        "groundroll simulate brott --v0 '0.1 m/s' --speed '100 km/h' --plot run.png"
    ),
)
@options.aircraft
@options.model()
@_initial
@options.named("start", "A state at the start, of any model, e.g. --start u='60 kt'.", "start")
@options.inputs
@options.quantity("t", "s", "Duration.", default=5.0)
@click.option("--samples", type=int, default=501, show_default=True, help="How many to keep.")
@options.speed
@options.disturbance
@_gust
@click.option(
    "--tol",
    type=float,
    default=1e-9,
    show_default=True,
    help="Error relative to the largest magnitude of each state.",
)
@click.option(
    "--view",
    type=click.Choice(["history", "runway"]),
    default="history",
    show_default=True,
    help="Picture of quantities over time, or of the runway from above.",
)
@click.option(
    "--show",
    help="States, inputs and outputs over time to draw, such as y,theta. Default: where the"
    " aircraft goes and which way it points.",
)
@options.result
@options.picture
def command(
    plane: str,
    changes: options.Changes,
    model: ModelLike,
    start: options.Values,
    inputs: options.Values,
    t: float,
    samples: int,
    speed: float | None,
    disturbance: float | None,
    gust: str | None,
    gust_start: float | None,
    gust_length: float | None,
    tol: float,
    view: str,
    show: str | None,
    form: str,
    out: Path | None,
    plot: Path | None,
    plotless: bool,
    **initial: float | None,
) -> None:
    """Simulate the ground roll after a disturbance, hands off.

    The table tells the largest and the last value of each quantity, and the metrics of the
    response of v, r, y and theta where the model has them; csv and json hold them over time.
    """
    from groundroll.runs.simulation import simulate

    aircraft, known = options.loaded(plane, changes, model), as_model(model)
    push = _over_time(disturbance, gust, gust_start, gust_length)
    states = {f"{name}0" if name in known.states else name: value for name, value in start}
    values = options.by_name(initial, states, inputs, {"speed": speed, "disturbance": push})
    if not values.keys() - {"speed"} and known.roles.get("speed") not in known.states:
        say("nothing disturbs the aircraft: give --v0, --r0, --start, --disturbance or --input")
    with bar():
        run = simulate(aircraft, model, t=t, samples=samples, tol=tol, **values)
        metrics = run.metrics(_MEASURED) if set(_MEASURED) <= set(known.states) else None
    emit(Output(_text(run, metrics), _rows(run), _data(run, metrics), run), form, out)
    options.tell(run.aircraft, run.values)
    names = None if show is None else tuple(name.strip() for name in show.split(","))
    figure = partial(_runway, run) if view == "runway" else partial(_history, run, names)
    options.draw(figure, f"{run.aircraft.name}-simulate", form, plot, plotless)


def _over_time(
    force: float | None, gust: str | None, start: float | None, length: float | None
) -> Any:
    """The disturbance as `simulate` takes it."""
    from groundroll.motion import gusts

    if gust is None:
        if start is not None or length is not None:
            raise click.UsageError("--gust-start and --gust-length need --gust")
        return force
    force, begin = force or 0.0, start or 0.0
    if gust == "step":
        return gusts.step(force, begin, None if length is None else begin + length)
    return gusts.one_minus_cosine(force, begin, 1.0 if length is None else length)


def _runway(run: Trajectory) -> Any:
    from groundroll.view.runway import runway_view

    return runway_view(run).figure


def _text(run: Trajectory, metrics: Metrics | None) -> str:
    rows = []
    for s, series in run.values.items():
        q = as_model(run.model).quantities[s]
        peak, unit = shown(abs(series).max(), q.unit)
        last, _ = shown(series[-1], q.unit)
        rows.append([q.name, s, number(peak), number(last), unit])
    head = (
        f"{run.aircraft.name}, {as_model(run.model).name} model, {number(_speed(run))} m/s,"
        f" {number(run.t[-1])} s"
    )
    over_time = table(["quantity", "symbol", "largest", "at the end", "unit"], rows, right=(2, 3))
    response = "" if metrics is None else f"\n\nResponse\n{_metrics_table(metrics)}"
    return f"{head}\n\n{over_time}{response}"


def _speed(run: Trajectory) -> float:
    return options.speed_at(run.aircraft, run.model, run.values)


def _metrics_table(metrics: Metrics) -> str:
    rows = []
    for name, unit in _units(metrics):
        cells = zip(getattr(metrics, name), _MEASURED, strict=True)
        rows.append([name, *(_cell(value, unit or QUANTITIES[s].unit) for value, s in cells)])
    return table(["metric", *_MEASURED], rows, right=range(1, len(_MEASURED) + 1))


def _units(metrics: Metrics) -> list[tuple[str, str]]:
    """The metrics of each state, with their units."""
    return [(name, u) for name, u in metrics.units.items() if getattr(metrics, name).ndim]


def _cell(value: Any, unit: str) -> str:
    """A value with its unit; what has no unit in percent."""
    if unit == "1":
        value, text = 100 * value, "%"
    else:
        value, text = shown(value, unit)
    return number(value) if not math.isfinite(value) else f"{number(value)} {text}"


def _rows(run: Trajectory) -> list[list[Any]]:
    quantities = as_model(run.model).quantities
    header = ["t [s]", *(options.with_unit(s, quantities[s].unit) for s in run.values)]
    columns = [run.t, *run.values.values()]
    return [header, *([float(x) for x in row] for row in zip(*columns, strict=True))]


def _data(run: Trajectory, metrics: Metrics | None) -> dict[str, Any]:
    quantities = as_model(run.model).quantities
    found = {
        **options.about(run.aircraft, model=run.model, speed=_speed(run)),
        "units": {"t": "s", **{s: quantities[s].unit for s in run.values}},
        "t": run.t,
        **run.values,
        "gust": run.gust and run.gust.label,
    }
    return found if metrics is None else {**found, "metrics": _measured(metrics)}


def _measured(metrics: Metrics) -> dict[str, Any]:
    return {
        "displacement": metrics.displacement,
        "rotation": metrics.rotation,
        **{
            s: {name: getattr(metrics, name)[k] for name, _ in _units(metrics)}
            for k, s in enumerate(_MEASURED)
        },
    }


def _history(run: Trajectory, names: tuple[str, ...] | None) -> Any:
    return run.plot(names)[0].figure
