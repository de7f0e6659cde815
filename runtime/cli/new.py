"""``groundroll new``."""

from __future__ import annotations

import os
from pathlib import Path

import click

from .options import AircraftName, example
from .output import say, write


@click.command(name="new", epilog=example("groundroll new my-plane.toml --like cessna-170"))
@click.argument("file", type=click.Path(dir_okay=False, path_type=Path))
@click.option("--like", type=AircraftName(), help="Begin with a copy of this aircraft instead.")
@click.option("--force", is_flag=True, help="Overwrite the file if there is one.")
def command(file: Path, like: str | None, force: bool) -> None:
    """Write an aircraft file to fill in: every key with its unit and meaning.

    Fill in what you know and ask `groundroll check` what is missing.
    """
    if file.suffix != ".toml":
        raise click.BadParameter(f"found {file.name!r}; expected a name ending in .toml")
    if os.path.lexists(file) and not force:
        raise click.BadParameter(f"{file} exists; --force overwrites it")
    write(file, _content(file, like))
    task = "change what is different" if like else "fill it in"
    say(f"wrote {file}; {task}, then: groundroll check {file}")


def _content(file: Path, like: str | None) -> str:
    if like is None:
        from groundroll.aircraft.template import template

        return template(file.stem, file.name)
    from groundroll.aircraft.file import locate
    from groundroll.base.files import text_of

    return text_of(locate(like))
