"""Forces over time as data, so that they can be compared, copied and sent to other processes.

Each is called with times, s, shape (samples,), and gives forces, N, shape (..., samples).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import reduce
from operator import add
from typing import Any

import numpy as np

from .arrays import FloatArray


@dataclass(frozen=True, eq=False)
class OneMinusCosine:
    peak: FloatArray
    start: FloatArray
    length: FloatArray

    def __call__(self, t: FloatArray) -> FloatArray:
        share = np.clip((t - self.start[..., None]) / self.length[..., None], 0.0, 1.0)
        return np.asarray(self.peak[..., None] / 2 * (1 - np.cos(2 * np.pi * share)))


@dataclass(frozen=True, eq=False)
class Step:
    size: FloatArray
    start: FloatArray
    end: FloatArray

    def __call__(self, t: FloatArray) -> FloatArray:
        on = (t >= self.start[..., None]) & (t < self.end[..., None])
        return np.asarray(self.size[..., None] * on)


@dataclass(frozen=True, eq=False)
class Samples:
    t: FloatArray
    force: FloatArray
    hold: bool

    def __call__(self, t: FloatArray) -> FloatArray:
        if self.hold:
            before = np.maximum(np.searchsorted(self.t, t, side="right") - 1, 0)
            return self.force[..., before]
        rows = [np.interp(t, self.t, row) for row in self.force.reshape(-1, self.t.size)]
        return np.array(rows).reshape(*self.force.shape[:-1], t.size)


@dataclass(frozen=True, eq=False)
class Until:
    force: Callable[[FloatArray], Any]
    end: FloatArray

    def __call__(self, t: FloatArray) -> Any:
        return self.force(np.minimum(t, self.end))


@dataclass(frozen=True, eq=False)
class Sum:
    parts: tuple[Callable[[FloatArray], Any], ...]

    def __call__(self, t: FloatArray) -> Any:
        return reduce(add, (part(t) for part in self.parts))
