"""``groundroll derive``."""

from __future__ import annotations

from pathlib import Path

import click

from .options import example
from .output import say


@click.command(name="derive", epilog=example("groundroll derive mine.py --out mine/"))
@click.argument("file", type=click.Path(dir_okay=False, path_type=Path))
@click.option("--out", type=click.Path(path_type=Path), required=True, help="Folder of the pack.")
@click.option("--name", default="", help="Which model, where the file has several.")
def command(file: Path, out: Path, name: str) -> None:
    """Derive a model of your own: equations, C, kernels and sheet, in a folder.

    FILE is a Python file with a model: a body and a list of parts. The folder is what --model and
    gr.Model.load take.
    """
    from groundroll.base.errors import GroundrollError

    try:
        from groundroll.derive.core.model import ModelError
        from groundroll.derive.emit.own import derive_file
    except ImportError as problem:
        raise GroundrollError(
            f"deriving needs {problem.name}: pip install 'groundroll[derive]'"
        ) from None
    try:
        pack = derive_file(file.resolve(), out, name)
    except (ModelError, OSError) as problem:
        raise GroundrollError(str(problem)) from problem
    model = pack.model
    assert model is not None  # of a user's own
    say(
        f"wrote {out}: the model {pack.name}, states {', '.join(map(str, model.states))}; inputs"
        f" {', '.join(map(str, model.inputs)) or 'none'}; parameters"
        f" {', '.join(map(str, model.parameters))}"
    )
