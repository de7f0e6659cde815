"""Records as NetCDF: dimensions, units and meanings for whatever reads it."""

from __future__ import annotations

import zlib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from groundroll.base.errors import GroundrollError
from groundroll.base.memory import check_memory

from .records import Record
from .tables import needed, to_xarray

#: NetCDF knows no complex numbers: real and imaginary parts stand along this dimension.
_PARTS = "re_im"


def write(path: Path, record: Record, text: str) -> None:
    """Write the arrays of a record and the text that goes with them."""
    needed("xarray", "NetCDF", "netcdf")
    dataset = to_xarray(record)
    arrays = {str(name): variable.values for name, variable in dataset.variables.items()}
    check = _checksum(text, arrays)
    for name, values in arrays.items():
        if np.iscomplexobj(values):
            parts = np.stack([values.real, values.imag], axis=-1)
            dataset[name] = ((*dataset[name].dims, _PARTS), parts, dataset[name].attrs)
    plain: dict[Any, Any] = {name: {"_FillValue": None} for name in dataset.variables}
    try:
        dataset.assign_attrs(record=text, checksum=check).to_netcdf(path, encoding=plain)
    except (ImportError, ValueError) as problem:
        raise GroundrollError(
            f"cannot write NetCDF ({problem}): pip install 'groundroll[netcdf]'"
        ) from problem


def read(path: Path) -> tuple[str, dict[str, npt.NDArray[Any]]]:
    """The text and the arrays of a record; ValueError if they do not belong together."""
    xarray = needed("xarray", "NetCDF", "netcdf")
    with xarray.open_dataset(path, decode_times=False, decode_timedelta=False) as stored:
        check_memory(stored.nbytes, f"what is in {path}")  # compressed it may be small
        dataset = stored.load()
    arrays = {name: _whole(variable) for name, variable in dataset.variables.items()}
    text = dataset.attrs["record"]
    if dataset.attrs["checksum"] != _checksum(text, arrays):
        raise ValueError("checksum")
    return text, arrays


def _whole(variable: Any) -> npt.NDArray[Any]:
    values: npt.NDArray[Any] = variable.values
    if variable.dims[-1:] == (_PARTS,):
        return np.ascontiguousarray(values).view(np.complex128)[..., 0]
    return values.astype(str) if values.dtype.kind == "O" else values


def _checksum(text: str, arrays: Mapping[str, npt.NDArray[Any]]) -> str:
    """Of what comes back as it was, whatever the type it is stored in: NetCDF has none itself."""
    total = zlib.crc32(text.encode())
    for _, values in sorted(arrays.items()):
        kind = np.complex128 if np.iscomplexobj(values) else np.float64
        words = values.dtype.kind == "U"
        plain: Any = (
            "\0".join(values.flat).encode() if words else np.asarray(values, kind, order="C")
        )
        total = zlib.crc32(plain, total)
    return f"{total:08x}"
