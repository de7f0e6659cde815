"""A smooth curve through samples: its extremes, and where it passes a level."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from groundroll.base.arrays import FloatArray

#: Halvings of the interval between two samples before a straight line is good enough.
_BISECTIONS = 16


@dataclass(frozen=True)
class Curve:
    """Cubics through samples and their slopes.

    Attributes
    ----------
    t, f : ndarray, shape (n,)
        Samples; times increase.
    before, after : ndarray, shape (n,)
        Slopes on either side of each sample, which differ at a kink.
    """

    t: FloatArray
    f: FloatArray
    before: FloatArray
    after: FloatArray

    def extremes(self) -> tuple[FloatArray, FloatArray]:
        """Times and values of the samples and of every extremum between two of them."""
        turns = np.flatnonzero(self.after[:-1] * self.before[1:] < 0)
        cubics = self._cubics(turns)
        s = _zero(cubics[1:] * np.arange(1.0, 4.0)[:, None])
        times = self.t[turns] + s * np.diff(self.t)[turns]
        values = _polynomial(cubics, s)
        return np.concatenate([self.t, times]), np.concatenate([self.f, values])

    def crossings(self, level: float) -> FloatArray:
        """Times at which the curve passes a level from one sample to the next, in order."""
        below = self.f < level
        passes = np.flatnonzero(below[1:] != below[:-1])
        cubics = self._cubics(passes)
        cubics[0] -= level
        return np.asarray(self.t[passes] + _zero(cubics) * np.diff(self.t)[passes])

    def _cubics(self, k: np.typing.NDArray[np.intp]) -> FloatArray:
        """Coefficients in s, from 0 at sample k to 1 at the next, the constant term first."""
        h, rise = self.t[k + 1] - self.t[k], self.f[k + 1] - self.f[k]
        begin, end = h * self.after[k], h * self.before[k + 1]
        return np.stack([self.f[k], begin, 3 * rise - 2 * begin - end, begin + end - 2 * rise])


def _zero(coefficients: FloatArray) -> FloatArray:
    """Where polynomials that change sign between 0 and 1 do so."""
    low, width = np.zeros(coefficients.shape[1:]), 1.0
    sign = np.sign(coefficients[0])
    for _ in range(_BISECTIONS):
        width /= 2
        low += width * (np.sign(_polynomial(coefficients, low + width)) == sign)
    begin, end = _polynomial(coefficients, low), _polynomial(coefficients, low + width)
    return low + width * begin / np.where(begin == end, 1.0, begin - end)


def _polynomial(coefficients: FloatArray, s: FloatArray) -> FloatArray:
    value = np.zeros_like(s)
    for coefficient in coefficients[::-1]:
        value = value * s + coefficient
    return value
