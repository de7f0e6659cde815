"""What results have in common: the ways out of them, and back."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Self

import numpy as np

from groundroll.base.errors import GroundrollError
from groundroll.model.models import ModelLike

from . import doors, store
from .records import Column, Record

if TYPE_CHECKING:
    import pandas
    import xarray


class Result:
    """A result that goes into tables and files, with its aircraft and provenance."""

    def to_xarray(self) -> xarray.Dataset:
        """All arrays as an xarray.Dataset, with units and meanings.

        Dimensions are called by what they are, runs and aircraft ``run`` or ``run_0``, ``run_1``,
        ...; whatever varies of parameters and initial states is a coordinate; name of the
        aircraft, settings and provenance are attributes.
        """
        from .tables import to_xarray

        return to_xarray(self._record())

    def to_pandas(self) -> pandas.DataFrame:
        """What there is for each run, point or time as a pandas.DataFrame, a row for each.

        Whatever varies of parameters and initial states comes first. Name of the aircraft,
        settings, provenance and units are in ``attrs``.
        """
        from .tables import to_pandas

        return to_pandas(self._record())

    def save(self, path: str | Path) -> Path:
        """Write to a file with the aircraft, all that went in, and the provenance.

        Parameters
        ----------
        path : str or Path
            Where to: ``.npz``, or ``.nc`` (NetCDF, which needs the extra ``netcdf``). The file
            appears when it is complete.

        Raises
        ------
        GroundrollError
            If the path ends in anything else or cannot be written.
        """
        return store.write(self._record(), path)

    @classmethod
    def load(
        cls,
        path: str | Path,
        *,
        model: ModelLike | None = None,
        other_equations: bool = False,
    ) -> Self:
        """Read what `save` wrote: ``Ensemble.load`` an ensemble, ``Result.load`` whatever it is.

        Parameters
        ----------
        path : str or Path
            The file.
        model : str, Path or Model, optional
            The model it is a result of. It is found by name, or in the folder where it was, if
            omitted.
        other_equations : bool
            Whether to accept results of other equations than those of the model as it is now.

        Raises
        ------
        GroundrollError
            If the file is no such thing, is damaged, or comes from other equations; if its model
            is not found.
        """
        record = store.read(path, model=model, other_equations=other_equations)
        result = restored(record)
        if not isinstance(result, cls):
            words = f"{path} holds a {type(result).__name__}, not a {cls.__name__}"
            raise GroundrollError(words)
        return result

    def _record(self) -> Record:
        """What this consists of."""
        raise NotImplementedError

    @classmethod
    def _of(cls, record: Record) -> Self:
        """The result that consists of this."""
        raise NotImplementedError


def restored(record: Record) -> Result:
    """The result that consists of what a file held."""
    kind: type[Result] = doors.kind(record.kind)
    try:
        with np.errstate(invalid="raise"):
            result = kind._of(record)
        repr(result)  # whatever is missing is missed here
        _compare(result._record().results, record.results)
    except (LookupError, TypeError, ValueError, AttributeError, ArithmeticError) as problem:
        raise GroundrollError(f"the record holds no whole {kind.__name__}") from problem
    return result


def _compare(found: Mapping[str, Column], given: Mapping[str, Column]) -> None:
    """Raise `ValueError` unless a result consists of just what it was put together from."""
    for name in found.keys() | given.keys():
        mine, other = found[name], given[name]
        has_nan = mine.values.dtype.kind in "fc"
        same = np.array_equal(mine.values, other.values, equal_nan=has_nan)
        if mine.dims != other.dims or not same:
            raise ValueError(f"{name} is not what it may be")
