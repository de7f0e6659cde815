"""``groundroll study``."""

from __future__ import annotations

from pathlib import Path

import click

from groundroll.base.bar import bar

from .options import example
from .output import show


@click.command(name="study", epilog=example("groundroll study --out study"))
@click.option(
    "--out",
    type=click.Path(file_okay=False, path_type=Path),
    default=Path("study"),
    show_default=True,
    help="Folder for report, tables, figures and ledger.",
)
def command(out: Path) -> None:
    """Compute every table and figure of Brott's thesis and compare with the print.

    Exits with 1 if a printed number neither agrees nor is explained.
    """
    from groundroll import study

    with bar("steps") as progress:
        summary = study.run(out, progress)
    show(f"{summary}\n")
    if summary.differs:
        raise click.exceptions.Exit(1)
