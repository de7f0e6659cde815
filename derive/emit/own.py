"""A pack of a user's own model: one Python file in, one folder out."""

from __future__ import annotations

import importlib.util
import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import ModuleType

from groundroll.derive.core.model import Model, ModelError

from .catalogue import SHIPPED, Pack
from .pack import pack_files, write


def derive_file(path: Path, out: Path, name: str = "") -> Pack:
    """Derive the model in a Python file and write its pack.

    Parameters
    ----------
    path : Path
        A Python file with a `Model` at its top level.
    out : Path
        Folder of the pack; made if it is not there.
    name : str, optional
        Which model, where the file has several.

    Raises
    ------
    ModelError
        If the file cannot be run, has no such model, or the model cannot be; or if the folder
        holds something else than a pack.
    """
    model = find_model(path, name)
    if model.name in SHIPPED:
        raise ModelError(f"{path}: {model.name!r} is a model that ships; call yours otherwise")
    if out.exists() and not out.is_dir():
        raise ModelError(f"{out} is a file; a pack is a folder")
    if out.is_dir() and any(out.iterdir()) and not (out / "facts.json").is_file():
        raise ModelError(f"{out} holds other things than a pack; give an empty folder or a new one")
    with _teaching(path):
        pack = own_pack(model)
        files = pack_files(pack)
    write(out, files)
    return pack


def own_pack(model: Model) -> Pack:
    """The pack of a model that does not ship."""
    return Pack(model.name, model.summary, model=model.derive())


def find_model(path: Path, name: str = "") -> Model:
    """The model at the top level of a Python file."""
    if not path.is_file():
        raise ModelError(f"there is no file {path}")
    found: dict[int, Model] = {
        id(value): value for value in vars(_run(path)).values() if isinstance(value, Model)
    }
    models = [model for model in found.values() if not name or model.name == name]
    if len(models) == 1:
        return models[0]
    if models:
        names = ", ".join(model.name for model in models)
        raise ModelError(f"{path} has several models, {names}: say which with --name")
    if name and found:
        names = ", ".join(model.name for model in found.values())
        raise ModelError(f"{path} has no model {name!r}; it has {names}")
    raise ModelError(
        f"{path} has no model at its top level: name one there, as in car = Model('car', ...)"
    )


def _run(path: Path) -> ModuleType:
    spec = importlib.util.spec_from_file_location(f"groundroll_model_{path.stem}", path)
    if spec is None or spec.loader is None:
        raise ModelError(f"{path} is no Python file; its name must end in .py")
    module = importlib.util.module_from_spec(spec)
    with _teaching(path):
        spec.loader.exec_module(module)
    return module


@contextmanager
def _teaching(path: Path) -> Iterator[None]:
    """Errors, as far as a file has caused them, with the line of it where they begin."""
    try:
        yield
    except (Exception, SystemExit) as problem:
        lines = [f for f in traceback.extract_tb(problem.__traceback__) if f.filename == str(path)]
        line = getattr(problem, "lineno", None) or (lines[-1].lineno if lines else None)
        is_told = isinstance(problem, ValueError | NotImplementedError)
        what = f"{problem}" if is_told else f"{type(problem).__name__}: {problem}"
        where = f"{path}, line {line}" if line else f"{path}"
        raise ModelError(f"{where}: {what}") from problem
