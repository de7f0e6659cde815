"""What fits into memory: asked before it is taken."""

from __future__ import annotations

import math
import os
from pathlib import Path

import numpy as np
import numpy.typing as npt

from .errors import GroundrollError

FloatArray = npt.NDArray[np.float64]

#: Bytes that are there in any case.
_LITTLE = 2**24


def check_memory(needed: int, what: str) -> None:
    """Refuse what does not fit into memory, before any work starts."""
    if needed > _LITTLE and needed > (there := _available()):
        raise GroundrollError(
            f"not enough memory for {what}: {_gigabytes(needed)} are needed, but there are only"
            f" {_gigabytes(there)}; ask for fewer names or times, or run parts one after the other"
        )


def room(*shapes: tuple[int, ...]) -> list[FloatArray]:
    """Arrays of float64 in one piece of memory, which the system gives much sooner than several."""
    sizes = [math.prod(shape) for shape in shapes]
    pieces = np.split(np.empty(sum(sizes)), np.cumsum(sizes)[:-1])
    return [piece.reshape(shape) for piece, shape in zip(pieces, shapes, strict=True)]


def _gigabytes(size: int) -> str:
    return f"{min(size, 2**1000) / 2**30:.4g} GiB"


def _available() -> int:
    """Bytes that can still be had: what the system says, or the limit of its container."""
    found = [os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")]
    try:
        lines = Path("/proc/meminfo").read_text().splitlines()
        found += [int(x.split()[1]) * 1024 for x in lines if x.startswith("MemAvailable")]
        found.append(int(Path("/sys/fs/cgroup/memory.max").read_text()))
    except (OSError, ValueError):
        pass
    return min(found)
