"""``groundroll ensemble``."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import numpy as np

from groundroll.base.bar import bar
from groundroll.model.models import Model, ModelLike, as_model
from groundroll.model.names import MODELS, QUANTITIES

from . import options
from .output import Output, emit, filled, number, say, shown, table

if TYPE_CHECKING:
    from groundroll.runs.ensemble_result import Ensemble

_STATES = MODELS["nonlinear"].states
_STARTS = {f"{s}0": QUANTITIES[s].unit for s in _STATES}
#: Trajectories of a grid whose ranges name no number of points, and most points of one range.
_TRAJECTORIES, _MOST = 40_000, 201


#: A magnitude of a state or an output; the model knows its unit.
_limit = partial(click.option, type=options.Named(), multiple=True)


def _magnitudes(model: Model, given: options.Values, option: str) -> dict[str, float]:
    from groundroll.base.arrays import single
    from groundroll.base.errors import GroundrollError

    found = {}
    for name, text in given:
        try:
            s = model.symbol(name, "name", (*model.states, *model.outputs))
            found[s] = single(name, text, model.quantities[s].unit)
        except GroundrollError as problem:
            raise click.BadParameter(str(problem), param_hint=option) from problem
    return found


def _initial(command: Any) -> Any:
    """--v0, --r0, ...: one option for each state."""
    for name, unit in reversed(_STARTS.items()):
        q = QUANTITIES[name.removesuffix("0")]
        text = f"{q.name.replace('_', ' ').capitalize()} at the start; default 0."
        command = options.varied(name, name, unit, text)(command)
    return command


@click.command(
    name="ensemble",
    epilog=options.example(
        "groundroll ensemble brott-physical --v0 2 --vary 'speed=10 m/s:40 m/s'"
        " --vary 'Ct=0 N/deg:150 N/deg' --limits 'psi=45 deg'"
    ),
)
@options.aircraft
@click.option(
    "--vary",
    metavar="NAME=LOW:HIGH[:POINTS]",
    multiple=True,
    help="Parameter, input or initial state (v0) of the model and its range. May repeat: every"
    " combination is simulated.",
)
@click.option(
    "--random",
    type=click.IntRange(min=1),
    help="Draw so many trajectories from the ranges, evenly, instead of a grid.",
)
@click.option("--seed", type=int, default=0, show_default=True, help="Of the draw.")
@options.model()
@_initial
@options.named("start", "A state at the start, of any model, e.g. --start u='60 kt'.", "start")
@options.inputs
@options.quantity("t", "s", "Duration.", default=5.0)
@options.varied("speed", "u", "m/s", "Forward speed; default the aircraft's own.")
@options.varied(
    "disturbance",
    "disturbance",
    "N",
    "Side force on the vertical tail, to the right; default 0.",
)
@click.option(
    "--extremes",
    help="States and outputs whose largest magnitude is wanted; the first is drawn. Default: the"
    " heading.",
)
@_limit("--limits", help="Magnitude whose first passing is wanted, e.g. Y='7.5 m'. May repeat.")
@_limit("--within", help="Magnitude beyond which a trajectory ends. May repeat.")
@click.option(
    "--tol",
    type=float,
    default=1e-6,
    show_default=True,
    help="Error of every state, relative to its largest magnitude.",
)
@click.option("--threads", type=click.IntRange(min=1), help="Default: every processor.")
@options.result
@options.picture
def command(
    plane: str,
    changes: options.Changes,
    vary: tuple[str, ...],
    random: int | None,
    seed: int,
    model: ModelLike,
    start: options.Values,
    inputs: options.Values,
    t: float,
    extremes: str | None,
    limits: options.Values,
    within: options.Values,
    tol: float,
    threads: int | None,
    form: str,
    out: Path | None,
    plot: Path | None,
    plotless: bool,
    **either: Any,
) -> None:
    """Many ground rolls at once, hands off: every point of a grid, or a random draw.

    A range is name=low:high or name=low:high:points, with units. The table tells how the results
    are spread; csv and json hold every trajectory.
    """
    from groundroll.runs.ensembles import ensemble

    aircraft, known = options.loaded(plane, changes, model), as_model(model)
    of = extremes or known.roles.get("heading", known.dynamic[0])
    grids = [options.range_of(known, text, "--vary", "the model") for text in vary]
    grids += [each for each in either.values() if isinstance(each, options.Grid)]
    ranges = _ranges(grids)
    axes = _drawn(ranges, random, seed) if random else _spread(ranges)
    states = {f"{name}0" if name in known.states else name: value for name, value in start}
    constant = {k: x for k, x in either.items() if not isinstance(x, options.Grid)}
    numbers = options.by_name(constant, states, inputs)
    if both := numbers.keys() & axes.keys():
        raise click.UsageError(f"{', '.join(sorted(both))} is given and varied")
    with bar("trajectories") as show:
        ens = ensemble(
            aircraft,
            t,
            model,
            extremes=[name.strip() for name in of.split(",")],
            limits=_magnitudes(known, limits, "--limits"),
            within=_magnitudes(known, within, "--within"),
            tol=tol,
            threads=threads,
            progress=show,
            **numbers,
            **(axes if random else _crossed(axes)),
        )
    options.tell(ens.aircraft, ens.largest)
    if not ens.ok.all():
        lost = ", ".join(f"{n} {name}" for name, n in ens.counts.items() if name != "ok")
        say(f"not every trajectory is ok: {lost}")
    rows = _rows(ens, axes, bool(random))
    data = _data(ens, axes, seed if random else None)
    emit(Output(_text(ens, ranges, random), rows, data, ens), form, out)
    units = {s: grid.unit for s, grid in ranges.items()}
    figure = partial(_figure, ens, {} if random else axes, units)
    options.draw(figure, f"{aircraft.name}-ensemble", form, plot, plotless)


def _ranges(given: list[options.Grid]) -> dict[str, options.Grid]:
    if not given:
        raise click.UsageError("nothing varies: give --vary or a range of --v0, --speed, ...")
    names = [grid.symbol for grid in given]
    if twice := {name for name in names if names.count(name) > 1}:
        raise click.UsageError(f"{', '.join(sorted(twice))} is varied twice")
    return dict(zip(names, given, strict=True))


def _spread(ranges: Mapping[str, options.Grid]) -> dict[str, Any]:
    """Values of each range; those that name no number share what a grid has."""
    named = np.prod([grid.points for grid in ranges.values() if grid.points] or [1])
    free = sum(not grid.points for grid in ranges.values())
    points = int((_TRAJECTORIES / named) ** (1 / free) + 1e-9) if free else 2
    return {s: grid.spread(max(2, min(points, _MOST))) for s, grid in ranges.items()}


def _drawn(ranges: Mapping[str, options.Grid], count: int, seed: int) -> dict[str, Any]:
    if named := [s for s, grid in ranges.items() if grid.points]:
        raise click.UsageError(
            f"a random draw takes no number of points, but {', '.join(named)} names one"
        )
    if seed < 0:
        raise click.BadParameter("expected 0 or more", param_hint="--seed")
    rng = np.random.default_rng(seed)
    return {
        s: rng.uniform(grid.values[1][0], grid.values[1][-1], count) for s, grid in ranges.items()
    }


def _crossed(axes: Mapping[str, Any]) -> dict[str, Any]:
    """Each axis in a dimension of its own."""
    return dict(zip(axes, np.meshgrid(*axes.values(), indexing="ij", sparse=True), strict=True))


def _figure(ens: Ensemble, axes: dict[str, Any], units: Mapping[str, str]) -> Any:
    from groundroll.view.ensembles import plot_over, plot_spread

    of = next(iter(ens.largest))
    units = {name: unit for name, unit in units.items() if unit}  # a bare number has none
    return (plot_over(ens, of, axes, units) if axes else plot_spread(ens, of)).figure


def _text(ens: Ensemble, ranges: Mapping[str, options.Grid], random: int | None) -> str:
    over = ", ".join(_range(ens, each) for each in ranges.values())
    kind = "drawn evenly" if random else " x ".join(map(str, ens.status.shape))
    head = (
        f"{ens.aircraft.name}, {as_model(ens.model).name} model: {ens.status.size} trajectories of"
        f" {number(ens.t)} s ({kind}) over {over}"
    )
    counts = ", ".join(f"{n} {name}" for name, n in ens.counts.items())
    parts = [filled(head), f"tol {ens.tol:g}: {counts}", _spread_table(ens)]
    if ens.limits:
        parts.append("\n".join(_passed(ens)))
    return "\n\n".join(parts)


def _range(ens: Ensemble, grid: options.Grid) -> str:
    from groundroll.view.ensembles import varied

    q, before = varied(ens, grid.symbol)
    values = grid.values[1]
    low, unit = shown(values[0], q.unit)
    return (
        f"{before}{q.name} {number(low)} to {number(shown(values[-1], q.unit)[0])} {unit}".rstrip()
    )


def _spread_table(ens: Ensemble) -> str:
    rows = []
    for title, arrays in (("at the end", ens.final), ("largest", ens.largest)):
        for s, values in arrays.items():
            q = as_model(ens.model).quantities[s]
            good = values[np.isfinite(values)]
            shares = np.percentile(good, (0, 50, 99, 100)) if good.size else [np.nan] * 4
            cells = [number(shown(x, q.unit)[0]) for x in shares]
            rows.append([q.name, s, title, *cells, shown(0.0, q.unit)[1]])
    header = ["quantity", "symbol", "", "least", "median", "99 % below", "most", "unit"]
    return table(header, rows, right=(3, 4, 5, 6))


def _passed(ens: Ensemble) -> Iterator[str]:
    for s, limit in ens.limits.items():
        q = as_model(ens.model).quantities[s]
        value, unit = shown(limit, q.unit)
        first = ens.first[s]
        passed = first[np.isfinite(first)]
        text = (
            f"{100 * passed.size / first.size:.3g} % pass {q.name} {number(value)} {unit}".rstrip()
        )
        if passed.size:
            text += f", the first of them after {number(passed.min())} s"
        yield text


def _columns(ens: Ensemble) -> dict[str, tuple[str, Any]]:
    """Results by name, with units."""
    q = as_model(ens.model).quantities
    columns = {f"{s}_end": (q[s].unit, x) for s, x in ens.final.items()}
    columns |= {f"{s}_largest": (q[s].unit, x) for s, x in ens.largest.items()}
    columns |= {f"{s}_first": ("s", x) for s, x in ens.first.items()}
    return columns


def _rows(ens: Ensemble, axes: Mapping[str, Any], drawn: bool) -> Iterator[list[Any]]:
    from groundroll.view.ensembles import varied

    columns = _columns(ens)
    heads = [options.with_unit(s, varied(ens, s)[0].unit) for s in axes]
    heads += [options.with_unit(name, unit) for name, (unit, _) in columns.items()]
    yield [*heads, "status"]
    grid = axes.values() if drawn else np.meshgrid(*axes.values(), indexing="ij")
    arrays = [*grid, *(values for _, values in columns.values())]
    each = zip(*(values.reshape(-1).tolist() for values in arrays), strict=True)
    for values, status in zip(each, ens.status.reshape(-1).tolist(), strict=True):
        yield [*values, ens.STATUS[status]]


def _data(ens: Ensemble, axes: Mapping[str, Any], seed: int | None) -> dict[str, Any]:
    return {
        **options.about(ens.aircraft, model=ens.model, t=ens.t, tol=ens.tol, seed=seed),
        "varied": axes,
        "shape": ens.status.shape,
        "statuses": ens.STATUS,
        "status": ens.status,
        "limits": ens.limits,
        "within": ens.within,
        "final": ens.final,
        "largest": ens.largest,
        "first": ens.first,
    }
