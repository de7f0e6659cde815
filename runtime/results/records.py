"""Results taken apart into named arrays, and on disk: as npz or as NetCDF.

A file holds every array by name, and under ``record`` a text in JSON with all the rest: what it is,
of which aircraft, with the source of each number, and from which equations. NumPy alone can read
the one; what reads NetCDF finds dimensions, units and meanings in the other.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from groundroll.aircraft.aircraft import Aircraft
from groundroll.base.arrays import FloatArray
from groundroll.generated import Quantity
from groundroll.model.models import Model
from groundroll.model.names import PARAMETERS

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
