"""Records as npz, which NumPy alone can read; read back without trust in what they say."""

from __future__ import annotations

import json
import math
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
from numpy.lib import format as npy

from groundroll.base.memory import check_memory

from .records import Record

#: Kinds of elements that results have, and most bytes of the text that goes with them.
_ELEMENTS, _MOST_TEXT = "biufcU", 2**26


def write(path: Path, record: Record, text: str) -> None:
    """Write the arrays of a record and the text that goes with them."""
    arrays = {name: c.values for name, c in {**record.varied, **record.results}.items()}
    with path.open("wb") as file:
        np.savez_compressed(file, record=np.array(text), **arrays)  # type: ignore[arg-type]


def read(path: Path) -> tuple[str, dict[str, npt.NDArray[Any]]]:
    """The text and the arrays of a record; an error if they do not belong together.

    A small archive may hold gigabytes of zeros: nothing is unpacked before it is known to be an
    array that the text names, of the size that it claims.
    """
    with zipfile.ZipFile(path) as archive:
        members = {info.filename.removesuffix(".npy"): info for info in archive.infolist()}
        record = members.pop("record")
        if record.file_size > _MOST_TEXT:
            raise ValueError("too long a text")
        text = str(_array(archive, record))
        about = json.loads(text)
        inputs = (value for place in about["inputs"].values() for value in place.values())
        varied = {value["varies"] for value in inputs if isinstance(value, dict)}
        if members.keys() != {*varied, *about["results"]}:
            raise ValueError("other arrays than the text names")
        check_memory(sum(info.file_size for info in members.values()), f"what is in {path}")
        return text, {name: _array(archive, info) for name, info in members.items()}


def _array(archive: zipfile.ZipFile, info: zipfile.ZipInfo) -> npt.NDArray[Any]:
    with archive.open(info) as member:
        version = npy.read_magic(member)
        header = npy.read_array_header_1_0 if version == (1, 0) else npy.read_array_header_2_0
        shape, _, kind = header(member)
        size = member.tell() + math.prod(shape) * kind.itemsize
        if kind.kind not in _ELEMENTS or size != info.file_size:
            raise ValueError("no array of numbers")
    with archive.open(info) as member:
        array: npt.NDArray[Any] = npy.read_array(member, allow_pickle=False)
        if member.read(1):  # only at its end is a checksum looked at
            raise ValueError("more than an array")
    return array
