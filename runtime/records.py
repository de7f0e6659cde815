"""Results taken apart into named arrays, and on disk: as npz or as NetCDF.

A file holds every array by name, and under ``record`` a text in JSON with all the rest: what it is,
of which aircraft, with the source of each number, and from which equations. NumPy alone can read
the one; what reads NetCDF finds dimensions, units and meanings in the other.
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, fields, replace
from functools import cached_property
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from .aircraft import Aircraft, Source
from .arrays import FloatArray
from .errors import GroundrollError
from .files import as_path, complete
from .generated import Quantity
from .models import Model, ModelLike, as_model
from .names import PARAMETERS

#: Raised when the layout changes.
_LAYOUT = 3
_PACKAGES = ("groundroll", "casadi", "numpy")


@dataclass(frozen=True)
class Column:
    """An array with the names of its dimensions.

    Attributes
    ----------
    dims : tuple of str
        One for each dimension.
    values : ndarray
        SI units with radians.
    unit, words, meaning : str
        What it is, for people.
    names : tuple of str
        What its numbers stand for if they are indices.
    """

    dims: tuple[str, ...]
    values: npt.NDArray[Any]
    unit: str = ""
    words: str = ""
    meaning: str = ""
    names: tuple[str, ...] = ()

    @property
    def sizes(self) -> dict[str, int]:
        """Size of each dimension."""
        return dict(zip(self.dims, self.values.shape, strict=True))


def measured(dims: tuple[str, ...], values: npt.NDArray[Any], q: Quantity) -> Column:
    """An array of a quantity."""
    return Column(dims, values, q.unit, q.name.replace("_", " "), q.meaning)


def time_axis(t: FloatArray) -> Column:
    """Times as an axis of their own."""
    return Column(("t",), t, "s", "time")


def run_dims(shape: tuple[int, ...]) -> tuple[str, ...]:
    """Names of the dimensions along which aircraft or runs vary."""
    return ("run",) if len(shape) == 1 else tuple(f"run_{k}" for k in range(len(shape)))


def provenance(model: Model) -> dict[str, str]:
    """What results of a model come from: its equations, by digest, and versions of packages."""
    from importlib.metadata import version  # takes as long to import as all the rest

    made_with = {name: version(name) for name in _PACKAGES}
    return {"model": model.key, "equations": model.digest, **made_with}


class Input(NamedTuple):
    """Something that went in: where it was given (``"given"``, ``"own"``, ``"aircraft"``)."""

    place: str
    name: str
    column: Column


@dataclass(frozen=True)
class Record:
    """What a result consists of.

    Attributes
    ----------
    kind : str
        What it is, e.g. ``"trajectory"``.
    aircraft : Aircraft
        The aircraft it belongs to, with the source of each number.
    model : Model
        Whose equations it comes from; its quantities say what the arrays are.
    runs : tuple of str
        Dimensions along which aircraft and what is `given` may vary.
    results : mapping of str to Column
        Its arrays.
    per : tuple of str
        Further dimensions of which a table has a row for each point.
    given : mapping of str to ndarray
        What went in beside the aircraft, by symbol of the model or by symbol and zero (``v0``);
        broadcasts along `runs`.
    about : mapping
        Its other attributes, anything that JSON can hold.
    made_with : mapping of str to str
        What it was computed with if that was in another process: see `provenance`.
    """

    kind: str
    aircraft: Aircraft
    model: Model
    runs: tuple[str, ...]
    results: Mapping[str, Column]
    per: tuple[str, ...] = ()
    given: Mapping[str, FloatArray] = field(default_factory=dict)
    about: Mapping[str, Any] = field(default_factory=dict)
    made_with: Mapping[str, str] = field(default_factory=dict)

    def __getitem__(self, name: str) -> npt.NDArray[Any]:
        return self.results[name].values

    @property
    def provenance(self) -> Mapping[str, str]:
        """``"model"`` and ``"equations"``, its digest, and the version of each package."""
        return self.made_with or provenance(self.model)

    @cached_property
    def inputs(self) -> dict[str, Input]:
        """All that went in, by a name that nothing else in the record has."""
        own = {s: v for s, v in self.aircraft.own.items() if not isinstance(v, str)}
        places: dict[str, Mapping[str, Any]] = {
            "given": self.given,
            "own": own,
            "aircraft": self.aircraft.given,
        }
        found: dict[str, Input] = {}
        for place, values in places.items():
            for name, value in values.items():
                is_free = name not in found and name not in self.results
                key = name if is_free else f"{place}_{name}"
                found[key] = Input(place, name, self._column(place, name, np.asarray(value, float)))
        return found

    def _column(self, place: str, name: str, value: FloatArray) -> Column:
        own = self.runs[len(self.runs) - value.ndim :]
        q = _quantity(PARAMETERS if place == "aircraft" else self.model.quantities, name)
        return Column(own, value) if q is None else measured(own, value, q)

    @cached_property
    def varied(self) -> dict[str, Column]:
        """What varies of it, each along the dimensions in which it does."""
        found = {}
        for key, (_, _, column) in self.inputs.items():
            along = tuple(d for d, n in column.sizes.items() if n > 1)
            if along:
                found[key] = replace(column, dims=along, values=np.squeeze(column.values))
        return found


def _quantity(quantities: Mapping[str, Quantity], name: str) -> Quantity | None:
    """What a name stands for: a symbol, a symbol and a zero, or a full name."""
    key = name if name in quantities else name.removesuffix("0")
    return quantities.get(key) or next((q for q in quantities.values() if q.name == name), None)


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
