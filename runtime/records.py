"""Results taken apart into named arrays, and on disk: as npz or as NetCDF.

A file holds every array by name, and under ``record`` a text in JSON with all the rest: what it is,
of which aircraft, with the source of each number, and from which equations. NumPy alone can read
the one; what reads NetCDF finds dimensions, units and meanings in the other.
"""

from __future__ import annotations

import json
import zlib
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, fields
from functools import cached_property
from pathlib import Path
from typing import Any
from zipfile import BadZipFile

import numpy as np
import numpy.typing as npt

from .aircraft import Aircraft, Source
from .arrays import FloatArray
from .errors import GroundrollError
from .files import complete
from .names import DIGEST, QUANTITIES

#: Raised when the layout changes.
_LAYOUT = 2
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


def measured(dims: tuple[str, ...], values: npt.NDArray[Any], symbol: str) -> Column:
    """An array of a quantity of the model."""
    q = QUANTITIES[symbol]
    return Column(dims, values, q.unit, q.name.replace("_", " "), q.meaning)


def time_axis(t: FloatArray) -> Column:
    """Times as an axis of their own."""
    return Column(("t",), t, "s", "time")


def run_dims(shape: tuple[int, ...]) -> tuple[str, ...]:
    """Names of the dimensions along which aircraft or runs vary."""
    return ("run",) if len(shape) == 1 else tuple(f"run_{k}" for k in range(len(shape)))


def provenance() -> dict[str, str]:
    """What results of this process come from: digest of the equations, versions of packages."""
    from importlib.metadata import version  # takes as long to import as all the rest

    return {"equations": DIGEST, **{name: version(name) for name in _PACKAGES}}


@dataclass(frozen=True)
class Record:
    """What a result consists of.

    Attributes
    ----------
    kind : str
        What it is, e.g. ``"trajectory"``.
    aircraft : Aircraft
        The aircraft it belongs to, with the source of each number.
    runs : tuple of str
        Dimensions along which aircraft and what is `given` may vary.
    results : mapping of str to Column
        Its arrays.
    per : tuple of str
        Further dimensions of which a table has a row for each point.
    given : mapping of str to ndarray
        What went in beside the aircraft, by symbol or by symbol and zero (``v0``); broadcasts
        along `runs`.
    about : mapping
        Its other attributes, anything that JSON can hold.
    provenance : mapping of str to str
        ``"equations"``, the digest of the derivation, and the version of each package.
    """

    kind: str
    aircraft: Aircraft
    runs: tuple[str, ...]
    results: Mapping[str, Column]
    per: tuple[str, ...] = ()
    given: Mapping[str, FloatArray] = field(default_factory=dict)
    about: Mapping[str, Any] = field(default_factory=dict)
    provenance: Mapping[str, str] = field(default_factory=provenance)

    def __getitem__(self, name: str) -> npt.NDArray[Any]:
        return self.results[name].values

    @property
    def inputs(self) -> dict[str, FloatArray]:
        """All that went in, by name."""
        return {**self.aircraft.given, **self.given}

    @cached_property
    def varied(self) -> dict[str, Column]:
        """What varies of it, each along the dimensions in which it does."""
        found = {}
        for name, value in self.inputs.items():
            own = self.runs[len(self.runs) - value.ndim :]
            along = tuple(d for d, n in zip(own, value.shape, strict=True) if n > 1)
            if along:
                symbol = name if name in QUANTITIES else name.removesuffix("0")
                found[name] = measured(along, np.squeeze(value), symbol)
        return found


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
    target = Path(path)
    store, _ = _format(target)
    with complete(target) as draft:
        store(draft, record, _text(record))
    return target


def read(path: str | Path, *, other_equations: bool = False) -> Record:
    """Read a record and check that it is whole.

    Parameters
    ----------
    path : str or Path
        The file.
    other_equations : bool
        Whether to accept results of other equations than those that are installed.

    Raises
    ------
    GroundrollError
        If the file cannot be read, is damaged or no record, or comes from other equations.
    """
    _, fetch = _format(Path(path))
    if not Path(path).is_file():
        raise GroundrollError(f"cannot read {path}: there is no such file")
    try:
        text, arrays = fetch(Path(path))
        about = json.loads(text)
        layout = about["layout"]
    except (OSError, ValueError, LookupError, AttributeError, BadZipFile, zlib.error) as problem:
        raise GroundrollError(f"{path} is no record of groundroll, or is damaged") from problem
    if layout != _LAYOUT:
        raise GroundrollError(f"{path} has the layout {layout}; this reads the layout {_LAYOUT}")
    equations = about["provenance"]["equations"]
    if equations != DIGEST and not other_equations:
        raise GroundrollError(
            f"{path} was computed from other equations (digest {equations}, groundroll"
            f" {about['provenance']['groundroll']}) than those installed ({DIGEST}); compute it"
            " again, or accept it with other_equations=True"
        )
    return _put_together(about, arrays)


def _format(path: Path) -> Any:
    """How to write and how to read a file, by its suffix."""
    if path.suffix == ".npz":
        return _write_npz, _read_npz
    if path.suffix == ".nc":
        from . import netcdf

        return netcdf.write, netcdf.read
    raise GroundrollError(f"{path} must end in .npz or in .nc (NetCDF): results are kept in these")


def _text(record: Record) -> str:
    """All but the arrays, as JSON."""
    plane, inputs = record.aircraft, record.inputs
    words = {f.name: getattr(plane, f.name) for f in fields(plane)}
    about = {
        "layout": _LAYOUT,
        "kind": record.kind,
        "runs": record.runs,
        "per": record.per,
        "results": {name: column.dims for name, column in record.results.items()},
        "varied": {name: inputs[name].shape for name in record.varied},
        "fixed": {s: value.tolist() for s, value in inputs.items() if s not in record.varied},
        "given": list(record.given),
        "about": dict(record.about),
        "aircraft": {key: value for key, value in words.items() if isinstance(value, str)},
        "sources": {s: asdict(source) for s, source in plane.sources.items()},
        "provenance": dict(record.provenance),
    }
    return json.dumps(about, indent=1)


def _put_together(about: Mapping[str, Any], arrays: Mapping[str, npt.NDArray[Any]]) -> Record:
    inputs = {s: np.asarray(value, np.float64) for s, value in about["fixed"].items()}
    inputs |= {s: arrays[s].reshape(shape) for s, shape in about["varied"].items()}
    given = {s: inputs.pop(s) for s in about["given"]}
    sources = {s: Source(**source) for s, source in about["sources"].items()}
    return Record(
        kind=about["kind"],
        aircraft=Aircraft(given=inputs, sources=sources, **about["aircraft"]),
        runs=tuple(about["runs"]),
        results={s: Column(tuple(dims), arrays[s]) for s, dims in about["results"].items()},
        per=tuple(about["per"]),
        given=given,
        about=about["about"],
        provenance=about["provenance"],
    )


def _write_npz(path: Path, record: Record, text: str) -> None:
    arrays = {name: c.values for name, c in {**record.varied, **record.results}.items()}
    with path.open("wb") as file:
        np.savez_compressed(file, record=np.array(text), **arrays)  # type: ignore[arg-type]


def _read_npz(path: Path) -> tuple[str, dict[str, npt.NDArray[Any]]]:
    with path.open("rb") as file, np.load(file, allow_pickle=False) as archive:
        if archive.zip.testzip() is not None:  # reading an array doesn't look at checksums
            raise BadZipFile
        arrays = {name: archive[name] for name in archive.files}
    return str(arrays.pop("record")), arrays
