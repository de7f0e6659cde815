"""Records kept in files, and whether they are whole when they come back."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import asdict, fields
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from groundroll.aircraft.aircraft import Aircraft
from groundroll.aircraft.source import Source
from groundroll.base.errors import GroundrollError
from groundroll.base.files import as_path, complete
from groundroll.model.models import Model, ModelLike, as_model

from .records import Column, Record

#: Raised when the layout changes.
_LAYOUT = 3


def write(record: Record, path: str | Path) -> Path:
    """Write a record; the file appears when it is complete.

    Parameters
    ----------
    record : Record
        What to keep.
    path : str or Path
        Where to, ending in ``.npz`` or ``.nc``.

    Raises
    ------
    GroundrollError
        If the path ends in anything else or cannot be written.
    """
    target = as_path(path)
    store, _ = _format(target)
    with complete(target) as draft:
        store(draft, record, _text(record))
    return target


def read(
    path: str | Path, *, model: ModelLike | None = None, other_equations: bool = False
) -> Record:
    """Read a record and check that it is whole.

    Parameters
    ----------
    path : str or Path
        The file.
    model : str, Path or Model, optional
        Whose result it is; found by the name or the folder that is in the file if omitted.
    other_equations : bool
        Whether to accept results of other equations than those of the model as it is now.

    Raises
    ------
    GroundrollError
        If the file cannot be read, is damaged or no record, its model is not found, or the
        equations of that are others.
    """
    about, arrays, made = _fetched(path)
    try:
        found = as_model(made.model if model is None else model)
    except GroundrollError as problem:
        if model is not None:
            raise
        raise GroundrollError(
            f"{path} is a result of the model {made.model}, which is not found ({problem});"
            " say where it is: load(path, model=...)"
        ) from None
    if made.equations != found.digest and not other_equations:
        raise GroundrollError(
            f"{path} was computed from other equations (digest {made.equations}, groundroll"
            f" {made.groundroll}) than those of the model {found.name} ({found.digest});"
            " compute it again, or accept it with other_equations=True"
        )
    try:
        return _put_together(about, arrays, found)
    except (LookupError, TypeError, ValueError, AttributeError) as problem:
        raise _damaged(path) from problem


def about(path: str | Path) -> Mapping[str, Any]:
    """All but the arrays of a record; errors as for `read`, but for those of its model."""
    return _fetched(path)[0]


class _Made(NamedTuple):
    """By what a result was made."""

    model: str
    equations: str
    groundroll: str


def _fetched(path: str | Path) -> tuple[dict[str, Any], dict[str, npt.NDArray[Any]], _Made]:
    source = as_path(path)
    _, fetch = _format(source)
    if not os.path.isfile(source):
        raise GroundrollError(f"cannot read {source}: there is no such file")
    try:
        text, arrays = fetch(source)
        found = json.loads(text)
        layout = found["layout"]
        made = _Made(*(str(found["provenance"][name]) for name in _Made._fields))
    except GroundrollError:
        raise
    except Exception as problem:  # zip, NumPy and NetCDF each have their own, and many
        raise _damaged(source) from problem
    if layout != _LAYOUT:
        raise GroundrollError(f"{source} has the layout {layout}; this reads the layout {_LAYOUT}")
    return found, arrays, made


def _damaged(path: str | Path) -> GroundrollError:
    return GroundrollError(f"{path} is no record of groundroll, or is damaged")


def _format(path: Path) -> Any:
    """How to write and how to read a file, by its suffix."""
    if path.suffix == ".npz":
        from . import npz

        return npz.write, npz.read
    if path.suffix == ".nc":
        from . import netcdf

        return netcdf.write, netcdf.read
    raise GroundrollError(f"{path} must end in .npz or in .nc (NetCDF): results are kept in these")


def _text(record: Record) -> str:
    """All but the arrays, as JSON."""
    plane = record.aircraft
    words = {f.name: getattr(plane, f.name) for f in fields(plane)}
    inputs: dict[str, dict[str, Any]] = {"given": {}, "own": {}, "aircraft": {}}
    for key, (place, name, column) in record.inputs.items():
        varies = {"varies": key, "shape": column.values.shape}
        inputs[place][name] = varies if key in record.varied else column.values.tolist()
    inputs["own"] |= {s: value for s, value in plane.own.items() if isinstance(value, str)}
    about = {
        "layout": _LAYOUT,
        "kind": record.kind,
        "runs": record.runs,
        "per": record.per,
        "results": {name: column.dims for name, column in record.results.items()},
        "inputs": inputs,
        "about": dict(record.about),
        "aircraft": {key: value for key, value in words.items() if isinstance(value, str)},
        "sources": {s: asdict(source) for s, source in plane.sources.items()},
        "provenance": dict(record.provenance),
    }
    return json.dumps(about, indent=1)


def _put_together(
    about: Mapping[str, Any], arrays: Mapping[str, npt.NDArray[Any]], model: Model
) -> Record:
    def restored(value: Any) -> Any:
        if isinstance(value, str):
            return value
        if isinstance(value, dict):
            return arrays[value["varies"]].reshape(value["shape"])
        return np.asarray(value, np.float64)

    inputs = {
        place: {name: restored(value) for name, value in values.items()}
        for place, values in about["inputs"].items()
    }
    sources = {s: Source(**source) for s, source in about["sources"].items()}
    texts = [*about["aircraft"].values(), *(x for s in sources.values() for x in (s.text, s.entry))]
    if not all(isinstance(text, str) for text in texts):
        raise TypeError("no text where one belongs")
    results = {s: Column(_names(dims), arrays[s]) for s, dims in about["results"].items()}
    sizes = {size for column in results.values() for size in column.sizes.items()}
    if len(sizes) > len(dict(sizes)):
        raise ValueError("a dimension has two sizes")
    return Record(
        kind=about["kind"],
        aircraft=Aircraft(
            given=inputs["aircraft"], own=inputs["own"], sources=sources, **about["aircraft"]
        ),
        model=model,
        runs=_names(about["runs"]),
        results=results,
        per=_names(about["per"]),
        given=inputs["given"],
        about=dict(about["about"]),
        made_with=dict(about["provenance"]),
    )


def _names(found: Any) -> tuple[str, ...]:
    if not isinstance(found, list) or not all(isinstance(name, str) for name in found):
        raise TypeError("no list of names")
    return tuple(found)
