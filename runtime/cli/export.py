"""``groundroll export``."""

from __future__ import annotations

from pathlib import Path

import click

from groundroll.model.models import ModelLike

from . import options
from .output import say


def _target(context: click.Context, parameter: click.Parameter, value: str) -> str:
    from groundroll.base.errors import GroundrollError, unknown
    from groundroll.exchange.exporting import TARGETS

    if value not in TARGETS:
        problem: GroundrollError = unknown("target", value, TARGETS)
        raise click.BadParameter(str(problem), context, parameter)
    return value


@click.command(
    name="export",
    epilog=options.example("groundroll export cessna-170 --to c --model nonlinear --out plane/"),
)
@options.aircraft
@click.option(
    "--to",
    required=True,
    callback=_target,
    metavar="TARGET",
    help="c: a folder of plain C, with an integrator, an example and a Makefile. fmu: a component"
    " of the Functional Mock-up Interface 3.0, in one file; fmu2: of version 2.0. jsbsim: the"
    " aircraft as a file of the flight dynamics code JSBSim.",
)
@options.model(None, "nonlinear; landing_roll for jsbsim")
@click.option("--out", required=True, type=click.Path(path_type=Path), help="Where to write it.")
def command(
    plane: str, changes: options.Changes, to: str, model: ModelLike | None, out: Path
) -> None:
    """Write a model with the numbers of an aircraft for programs without Python.

    --set may change anything that the model knows: parameters, inputs, and states at the start
    (v0).
    """
    from groundroll.exchange.exporting import written

    aircraft, values = options.with_values(plane, changes)
    path, lost = written(aircraft, to, out, model, values)
    say(f"wrote {path}")
    if lost:
        say("It does not carry:")
    for each in lost:
        say(f"- {each}")
