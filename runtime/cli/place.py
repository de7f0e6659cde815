"""``groundroll place``."""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import fields
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from groundroll.base.bar import bar
from groundroll.model.models import ModelLike

from . import options
from .output import Output, emit, hanging

if TYPE_CHECKING:
    from groundroll.placement import Envelope, Limits, Placement


class _Bounds(options.ParamType):
    """``name=value``, ``name=low:high`` or ``name=value,value``, with units."""

    name = "name=low:high"

    def convert(self, value: Any, param: Any, ctx: Any) -> tuple[str, Any]:
        name, _, text = str(value).partition("=")
        if not text:
            self.fail(f"found {value!r}; expected name=value or name=low:high", param, ctx)
        if ":" in text:
            low, _, high = text.partition(":")
            return name.strip(), (low.strip() or None, high.strip() or None)
        values = [part.strip() for part in text.split(",")]
        return name.strip(), values if len(values) > 1 else values[0]


_bounds = partial(click.option, type=_Bounds(), multiple=True)


@click.command(
    name="place",
    epilog=options.example("groundroll place cessna-170 --envelope 'speed=20 kt:50 kt' --textbook"),
)
@options.aircraft
@_bounds("--envelope", help="What the aircraft meets: speed, cg, mass, tire_wear, ... May repeat.")
@_bounds("--limit", help="What must hold: nose_over, tip_back, decay_rate, ... May repeat.")
@_bounds("--variable", help="What may be chosen beside the station of the main gear. May repeat.")
@click.option("--textbook", is_flag=True, help="Begin with the rules of thumb of Raymer, ch. 11.")
@click.option("--lift", is_flag=True, help="Lift takes weight off the wheels with speed.")
@click.option(
    "--objective",
    type=click.Choice(["decay_rate", "damping_ratio", "displacement", "smallest_change"]),
    default="decay_rate",
    show_default=True,
    help="What to make as good as can be in the worst case.",
)
@click.option(
    "--layout",
    type=click.Choice(["taildragger", "tricycle"]),
    help="Default: what the aircraft is.",
)
@click.option(
    "--stiffness",
    type=click.Choice(["constant", "following"]),
    help="Whether stiffness follows the load. Default: constant where it is given.",
)
@click.option(
    "--tail-wheel",
    type=click.Choice(["locked", "free"]),
    default="locked",
    show_default=True,
    help="A free one casters.",
)
@options.model()
@options.output
@options.picture
def command(
    plane: str,
    changes: options.Changes,
    envelope: Iterable[tuple[str, Any]],
    limit: Iterable[tuple[str, Any]],
    variable: Iterable[tuple[str, Any]],
    textbook: bool,
    lift: bool,
    objective: str,
    layout: str | None,
    stiffness: str | None,
    tail_wheel: str,
    model: ModelLike,
    form: str,
    out: Path | None,
    plot: Path | None,
    plotless: bool,
) -> None:
    """Where the main gear should stand, for the worst of everything the aircraft will meet.

    A range is name=low:high, a set name=value,value, each with units; of a limit one end may be
    left out. Without any: the CG range at the aircraft's own speed, and stability.
    """
    from groundroll.placement import place_gear

    aircraft = options.loaded(plane, changes)
    with bar("steps") as show:
        found = place_gear(
            aircraft,
            _envelope(dict(envelope), lift),
            _limits(dict(limit), layout or _layout(aircraft) if textbook else None),
            objective,
            variables=dict(variable) or None,
            layout=layout,
            stiffness=stiffness,
            tail_wheel=tail_wheel,
            model=model,
            progress=show,
        )
    data = {**options.about(aircraft), **json.loads(found.to_json())}
    emit(Output(hanging(repr(found)), _rows(found), data), form, out)
    options.draw(found.plot, f"{aircraft.name}-place", form, plot, plotless)


def _envelope(given: dict[str, Any], lift: bool) -> Envelope:
    from groundroll.placement import Envelope

    _known(given, Envelope, "--envelope")
    return Envelope(**given, lift=lift)


def _limits(given: dict[str, Any], layout: str | None) -> Limits:
    from groundroll.placement import Limits

    _known(given, Limits, "--limit")
    return Limits(**given) if layout is None else Limits.textbook(layout, **given)


def _layout(aircraft: Any) -> str:
    return "taildragger" if aircraft["a"] > 0 else "tricycle"


def _known(given: dict[str, Any], kind: Any, option: str) -> None:
    from groundroll.base.errors import unknown

    names = [field.name for field in fields(kind) if field.name != "lift"]
    for name in given:
        if name not in names:
            raise click.BadParameter(str(unknown("name", name, names)), param_hint=option)


def _rows(found: Placement) -> list[list[Any]]:
    data = json.loads(found.to_json())
    rows: list[list[Any]] = [["kind", "name", "value"]]
    rows += [["design", name, value] for name, value in data["design"].items()]
    rows += [["worst", found.case.objective, found.value]]
    for kind in ("binding", "prices"):
        rows += [[kind, f"{price['of']}: {price['step']}", price["gain"]] for price in data[kind]]
    return rows
