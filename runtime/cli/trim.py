"""``groundroll trim``."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from groundroll.models import ModelLike, as_model

from . import options
from .output import Output, emit, number, shown, table
from .progress import bar

if TYPE_CHECKING:
    from groundroll.trimming import Trim


@click.command(
    name="trim",
    epilog=options.example("groundroll trim brott --disturbance '100 lbf' --speed '60 km/h'"),
)
@options.aircraft
@options.model()
@options.speed
@options.disturbance
@options.result
def command(
    plane: str,
    changes: options.Changes,
    model: ModelLike,
    speed: float | None,
    disturbance: float | None,
    form: str,
    out: Path | None,
) -> None:
    """Every steady turn under a steady side force, and whether it is stable.

    That there is none is an answer too: the exit code is 0.
    """
    from groundroll.trimming import trim

    with bar():
        found = trim(
            options.loaded(plane, changes), model, speed=speed, disturbance=disturbance or 0.0
        )
    emit(Output(_text(found), _rows(found), _data(found), found), form, out)
    options.tell(found.aircraft, found.values)


def _text(found: Trim) -> str:
    from groundroll.names import QUANTITIES

    head = repr(found).partition("\n")[0].removeprefix("Trim of ").replace("'", "")
    if not found.count:
        return head
    names = [f"branch {k}" for k in range(1, int(found.count) + 1)]
    rows = []
    for s, branches in found.values.items():
        q = QUANTITIES[s]
        values = [number(shown(value, q.unit)[0]) for value in branches]
        rows.append([q.name, s, *values, shown(0.0, q.unit)[1]])
    rows.append(["decay_rate", "", *map(number, found.decay_rate), "1/s"])
    rows.append(["", "", *("stable" if s else "unstable" for s in found.stable), ""])
    header = ["quantity", "symbol", *names, "unit"]
    return f"{head}\n\n{table(header, rows, right=range(2, 2 + len(names)))}"


def _rows(found: Trim) -> list[list[Any]]:
    from groundroll.names import QUANTITIES

    heads = [options.with_unit(s, QUANTITIES[s].unit) for s in found.values]
    rows: list[list[Any]] = [["branch", *heads, "decay_rate [1/s]", "stable"]]
    for k in range(int(found.count)):
        values = [float(branches[k]) for branches in found.values.values()]
        rows.append([k + 1, *values, float(found.decay_rate[k]), bool(found.stable[k])])
    return rows


def _data(found: Trim) -> dict[str, Any]:
    return {
        **options.about(found.aircraft, model=found.model, speed=found.aircraft["u"]),
        **{s: x for s, x in found.given.items() if s in as_model(found.model).inputs},
        "count": found.count,
        "singular": found.singular,
        **found.values,
        "decay_rate": found.decay_rate,
        "stable": found.stable,
    }
