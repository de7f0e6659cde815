"""``groundroll import``."""

from __future__ import annotations

import os
from pathlib import Path

import click

from .options import example
from .output import say


@click.command(name="import", epilog=example("groundroll import J3Cub.xml --out j3.toml"))
@click.argument("file", type=click.Path(dir_okay=False, path_type=Path))
@click.option(
    "--out",
    required=True,
    type=click.Path(dir_okay=False, path_type=Path),
    help="The aircraft file: a name that ends in .toml.",
)
@click.option(
    "--with",
    "derivatives",
    type=click.Path(dir_okay=False, path_type=Path),
    help="Stability derivatives of AVL, a .st file, instead of those of FILE.",
)
@click.option("--force", is_flag=True, help="Overwrite the file if there is one.")
def command(file: Path, out: Path, derivatives: Path | None, force: bool) -> None:
    """Write an aircraft file from FILE, an aircraft of JSBSim.

    Every number keeps its unit and says where it stands in FILE. What was not taken is listed, and
    `groundroll check` says what is missing.
    """
    from groundroll.exchange.importing import import_aircraft

    if os.path.lexists(out) and not force:
        raise click.BadParameter(f"{out} exists; --force overwrites it")
    made = import_aircraft(file, out, derivatives)
    if made.left:
        say("\n".join(["not taken:", *(f"  {text}" for text in made.left)]))
    say(f"wrote {out}; now: groundroll check {out}")
