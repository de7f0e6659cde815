"""Results as tables: for xarray and for pandas."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

import numpy as np

from groundroll.base.errors import GroundrollError

from .records import Column, Record

if TYPE_CHECKING:
    from pandas import DataFrame
    from xarray import Dataset


def to_xarray(record: Record) -> Dataset:
    """The arrays of a record along their named dimensions, with units and meanings."""
    columns = {**record.varied, **record.results}
    variables = {name: (c.dims, c.values, _attributes(c)) for name, c in columns.items()}
    axes = {name: variables.pop(name) for name, c in columns.items() if _is_axis(name, c)}
    inputs = {name: variables.pop(name) for name in record.varied if name not in axes}
    xarray = needed("xarray", "to_xarray()")
    dataset: Dataset = xarray.Dataset(variables, coords={**axes, **inputs}, attrs=_about(record))
    return dataset


def to_pandas(record: Record) -> DataFrame:
    """The arrays of a record that have a value for each of its rows.

    What varies of the aircraft and of the start comes first.
    """
    pandas = needed("pandas", "to_pandas()")
    rows = (*record.runs, *record.per)
    columns = {**record.varied, **record.results}
    sizes = {d: n for column in columns.values() for d, n in column.sizes.items()}
    shape = tuple(sizes.get(d, 1) for d in rows)
    data, units = {}, {}
    for name, column in columns.items():
        if not _is_axis(name, column) and set(column.dims) <= set(rows):
            own = [n if d in column.dims else 1 for d, n in zip(rows, shape, strict=True)]
            flat = np.broadcast_to(column.values.reshape(own), shape).ravel()
            names = column.names
            data[name] = pandas.Categorical.from_codes(flat, names) if names else flat
            units[name] = column.unit
    levels = [
        columns[d].values if d in columns else range(n) for d, n in zip(rows, shape, strict=True)
    ]
    index = None
    if rows:
        index = pandas.MultiIndex.from_product(levels, names=rows)
        index = index if len(rows) > 1 else index.get_level_values(0)
    frame: DataFrame = pandas.DataFrame(data, index=index)
    frame.attrs = {**_about(record), "units": units}
    return frame


def needed(package: str, caller: str, extra: str = "") -> Any:
    """An optional package, or a word on how to get it."""
    try:
        return importlib.import_module(package)
    except ImportError:
        raise GroundrollError(
            f"{caller} needs the package {package}: pip install 'groundroll[{extra or package}]'"
        ) from None


def _is_axis(name: str, column: Column) -> bool:
    return column.dims == (name,)


def _attributes(column: Column) -> dict[str, Any]:
    found: dict[str, Any] = {
        "units": column.unit,
        "long_name": column.words,
        "description": column.meaning,
    }
    if column.names:  # as the CF conventions have it
        found["flag_values"] = np.arange(len(column.names), dtype=column.values.dtype)
        found["flag_meanings"] = " ".join(name.replace(" ", "_") for name in column.names)
    return {key: value for key, value in found.items() if len(value)}


def _about(record: Record) -> dict[str, Any]:
    """What there is to say in one word."""
    words = {key: value for key, value in record.about.items() if isinstance(value, str | float)}
    return {"aircraft": record.aircraft.name, **words, **record.provenance}
