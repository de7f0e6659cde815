"""``groundroll linearize``."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from groundroll.base.bar import bar
from groundroll.model.models import ModelLike, as_model

from . import options
from .output import Output, emit, number, table

if TYPE_CHECKING:
    from groundroll.linear.linearization import Linearization

_SCALARS = {
    "decay_rate": "1/s",
    "damping_ratio": "1",
    "natural_frequency": "rad/s",
    "damped_frequency": "rad/s",
}


@click.command(
    name="linearize",
    epilog=options.example("groundroll linearize brott --v '0.4 m/s' --r '1 deg/s' --format json"),
)
@options.aircraft
@options.model()
@options.quantity("v", "m/s", "Lateral velocity at the operating point.")
@options.quantity("r", "rad/s", "Yaw rate at the operating point.")
@options.named("at", "A state at the operating point, of any model, e.g. --at u='60 kt'.", "states")
@options.inputs
@options.speed
@options.disturbance
@options.result
def command(
    plane: str,
    changes: options.Changes,
    model: ModelLike,
    v: float | None,
    r: float | None,
    states: options.Values,
    inputs: options.Values,
    speed: float | None,
    disturbance: float | None,
    form: str,
    out: Path | None,
) -> None:
    """State-space matrices and modes at an operating point.

    It need not be an equilibrium: the drift holds the rates of the states there.
    """
    from groundroll.linear.linearization import linearize

    own = {"v": v, "r": r, "disturbance": disturbance, "speed": speed}
    point = options.by_name(own, states, inputs)
    with bar():
        lin = linearize(options.loaded(plane, changes, model), model, point)
    emit(Output(_text(lin), _rows(lin), _data(lin), lin), form, out)
    options.tell(lin.aircraft)


def _text(lin: Linearization) -> str:
    verdict = "stable" if lin.decay_rate > 0 else "unstable"
    head = (
        f"{lin.aircraft.name}, {as_model(lin.model).name} model, {number(_speed(lin))} m/s,"
        f" {_at(lin)}: {verdict}"
    )
    modes = [["eigenvalues", _spread(lin.eigenvalues), "1/s"]]
    for name, unit in _SCALARS.items():
        modes.append([name, number(getattr(lin, name)), "" if unit == "1" else unit])
    parts = [head, table(["mode", "value", "unit"], modes)]
    for name, rows, columns in _matrices(lin):
        header = [name, *columns]
        body = [
            [row, *map(number, line)] for row, line in zip(rows, getattr(lin, name), strict=True)
        ]
        parts.append(table(header, body, right=range(1, len(header))))
    drift = [["", *map(number, lin.drift)]]
    parts.append(table(["drift", *lin.states], drift, right=range(1, len(lin.states) + 1)))
    return "\n\n".join(parts)


def _speed(lin: Linearization) -> float:
    return options.speed_at(lin.aircraft, lin.model, lin.at)


def _at(lin: Linearization) -> str:
    """What the operating point is told by: v and r, and whatever else is not zero there."""
    q = as_model(lin.model).quantities
    by_name = {x.name: s for s, x in q.items()}
    told = []
    for name, value in lin.at.items():
        s = name if name in q else by_name[name]
        if s in ("v", "r") or (value and s != as_model(lin.model).roles.get("speed")):
            told.append(f"{name} = {number(value)} {q[s].unit}".removesuffix(" 1"))
    return ", ".join(told)


def _matrices(lin: Linearization) -> list[tuple[str, list[str], tuple[str, ...]]]:
    rates = [f"{s}_dot" for s in lin.states]
    return [
        ("A", rates, lin.states),
        ("B", rates, lin.inputs),
        ("C", list(lin.outputs), lin.states),
        ("D", list(lin.outputs), lin.inputs),
    ]


def _spread(eigenvalues: Any) -> str:
    """Eigenvalues in a row; of a complex pair, whose first has the positive part, both at once."""
    real = [number(x.real) for x in eigenvalues if not x.imag]
    pairs = [f"{number(x.real)} ± {number(x.imag)} i" for x in eigenvalues if x.imag > 0]
    return ", ".join([*pairs, *real])


def _rows(lin: Linearization) -> list[list[Any]]:
    rows: list[list[Any]] = [["quantity", "row", "column", "value"]]
    for name, heads, columns in _matrices(lin):
        matrix = getattr(lin, name)
        rows += [
            [name, head, column, float(matrix[i, j])]
            for i, head in enumerate(heads)
            for j, column in enumerate(columns)
        ]
    rows += [
        ["drift", f"{s}_dot", "", float(x)] for s, x in zip(lin.states, lin.drift, strict=True)
    ]
    for k, eigenvalue in enumerate(lin.eigenvalues, start=1):
        rows += [["eigenvalue", k, "re", eigenvalue.real], ["eigenvalue", k, "im", eigenvalue.imag]]
    return rows + [[name, "", "", float(getattr(lin, name))] for name in _SCALARS]


def _data(lin: Linearization) -> dict[str, Any]:
    names = ("states", "inputs", "outputs", "A", "B", "C", "D", "drift", "eigenvalues")
    return {
        **options.about(lin.aircraft, model=lin.model, speed=_speed(lin), at=dict(lin.at)),
        **{name: getattr(lin, name) for name in (*names, *_SCALARS)},
    }
