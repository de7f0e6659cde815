"""``groundroll explore``."""

from __future__ import annotations

from pathlib import Path

import click

from groundroll.model.models import ModelLike

from . import options
from .output import say


@click.command(
    name="explore",
    epilog=options.example("groundroll explore cessna-170 --model landing_roll --out plane.html"),
)
@options.aircraft
@options.model()
@click.option(
    "--out",
    required=True,
    type=click.Path(dir_okay=False, path_type=Path),
    help="The page: one HTML file, which needs no network.",
)
def command(plane: str, changes: options.Changes, model: ModelLike, out: Path) -> None:
    """Write a page to play with an aircraft: wheels to drag, sliders, stability and the roll.

    --set may change anything that the model knows: parameters, inputs, and states at the start
    (v0); there the page begins.
    """
    from groundroll.exchange.explorer import explore

    aircraft, values = options.with_values(plane, changes)
    say(f"wrote {explore(aircraft, out, model, **values)}")
