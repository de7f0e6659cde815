"""``groundroll trim``."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from groundroll.base.bar import bar
from groundroll.model.models import ModelLike, as_model

from . import options
from .output import Output, emit, number, shown, table

if TYPE_CHECKING:
    from groundroll.linear.trim_result import Trim


@click.command(
    name="trim",
    epilog=options.example(
        "groundroll trim cessna-170 --model landing_roll --speed '30 kt' --input 'crosswind=8 kt'"
        " --solve-for pedal --solve-for thrust"
    ),
)
@options.aircraft
@options.model()
@options.named("at", "A state that is given, of any model, e.g. --at u='30 kt'.", "states")
@options.inputs
@click.option(
    "--solve-for",
    "unknowns",
    multiple=True,
    help="An input to be found, such as pedal; as many as states are given. May be repeated.",
)
@options.named(
    "within",
    "Between what an unknown may be, low:high, e.g. --within elevator='-25 deg:15 deg'.",
    "within",
)
@options.speed
@options.disturbance
@options.result
def command(
    plane: str,
    changes: options.Changes,
    model: ModelLike,
    states: options.Values,
    inputs: options.Values,
    unknowns: tuple[str, ...],
    within: options.Values,
    speed: float | None,
    disturbance: float | None,
    form: str,
    out: Path | None,
) -> None:
    """Every equilibrium, such as a steady turn, and whether it is stable.

    What is not given and not to be found is zero, of a free speed the aircraft's own. That there
    is none is an answer too: the exit code is 0.
    """
    from groundroll.linear.trimming import trim

    given = options.by_name({"speed": speed, "disturbance": disturbance}, states, inputs)
    with bar():
        found = trim(
            options.loaded(plane, changes, model),
            model,
            given,
            solve_for=unknowns,
            within=options.by_name([(name, tuple(text.split(":"))) for name, text in within]),
        )
    emit(Output(_text(found), _rows(found), _data(found), found), form, out)
    options.tell(found.aircraft, found.values)


def _text(found: Trim) -> str:
    head = repr(found).partition("\n")[0].removeprefix("Trim of ").replace("'", "")
    if not found.count:
        return head
    quantities = as_model(found.model).quantities
    names = [f"branch {k}" for k in range(1, int(found.count) + 1)]
    rows = []
    for s, branches in found.values.items():
        q = quantities[s]
        values = [number(shown(value, q.unit)[0]) for value in branches]
        rows.append([q.name, s, *values, shown(0.0, q.unit)[1]])
    rows.append(["decay_rate", "", *map(number, found.decay_rate), "1/s"])
    rows.append(["", "", *("stable" if s else "unstable" for s in found.stable), ""])
    header = ["quantity", "symbol", *names, "unit"]
    return f"{head}\n\n{table(header, rows, right=range(2, 2 + len(names)))}"


def _rows(found: Trim) -> list[list[Any]]:
    quantities = as_model(found.model).quantities
    heads = [options.with_unit(s, quantities[s].unit) for s in found.values]
    rows: list[list[Any]] = [["branch", *heads, "decay_rate [1/s]", "stable"]]
    for k in range(int(found.count)):
        values = [float(branches[k]) for branches in found.values.values()]
        rows.append([k + 1, *values, float(found.decay_rate[k]), bool(found.stable[k])])
    return rows


def _data(found: Trim) -> dict[str, Any]:
    speed = options.speed_at(found.aircraft, found.model, found.given)
    return {
        **options.about(found.aircraft, model=found.model, speed=speed),
        **{s: x for s, x in found.given.items() if s in as_model(found.model).inputs},
        "count": found.count,
        "singular": found.singular,
        "reason": found.reasons[0],
        "complete": found.complete,
        **found.values,
        "decay_rate": found.decay_rate,
        "stable": found.stable,
    }
