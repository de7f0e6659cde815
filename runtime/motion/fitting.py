"""Polynomials for a function of time, as good as rounding allows."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.polynomial import chebyshev

from groundroll.base.arrays import FloatArray
from groundroll.base.errors import GroundrollError
from groundroll.base.memory import check_memory

from .lanes import TERMS

#: Where a piece is sampled, from -1 to 1: the nodes of its polynomial, and what it is checked at.
NODES = chebyshev.chebpts1(TERMS)
_CHECKS = np.linspace(-1.0, 1.0, 2 * TERMS + 1)[1:-1]
#: The same close to its ends, where a jump would hide.
_ENDS = 1.0 - 0.1 ** np.arange(3, 15)
_CHECKS = np.concatenate([-_ENDS, _CHECKS, _ENDS])
#: What passes narrower than this, s, may be missed.
_SEEN = 2.5e-4
#: Largest error, relative to the largest value; and most pieces.
_ERROR, _MOST = 1e-12, 4000
#: Intervals, relative to the whole, at which halving ends, and what is narrow beside it: there the
#: function jumps or has a kink.
_POINT, _NARROW = 1e-12, 64
#: Jumps that are no further apart are one.
_CLOSE = 1e-9
#: Bytes for each time in which a function is looked at.
_BYTES = 3 * 8

Function = Callable[[FloatArray], FloatArray]


def fit(f: Function, marks: FloatArray, label: str) -> tuple[FloatArray, FloatArray]:
    """Polynomials between marks.

    Intervals are halved until each polynomial is good. That closes in on jumps and kinks, too;
    where they are is then known, and the polynomials reach up to them.

    Parameters
    ----------
    f : callable
        From times, s, shape (k,), to values, shape (..., k).
    marks : ndarray
        Ascending times, s: the ends, and where it is known that the function jumps.
    label : str
        What it is, for messages.

    Returns
    -------
    starts : ndarray, shape (pieces,)
        When each piece begins, s.
    values : ndarray, shape (..., pieces, 1 + terms)
        Of each its middle, s, and coefficients of powers of the time from there.

    Raises
    ------
    GroundrollError
        If it takes too many pieces.
    """
    whole = float(marks[-1] - marks[0])
    count = int(np.ceil(whole / _SEEN)) + 1
    check_memory(_BYTES * count, f"the times at which {label} is looked at")
    dense = np.linspace(marks[0], marks[-1], count)
    halving = _Halving(f, label, whole, dense, f(dense))
    begin, end = marks[:-1], marks[1:]
    starts, values, first, last = halving.run(begin, end)
    if first.size:
        begin, end = np.sort(np.append(begin, last)), np.sort(np.append(end, first))
        starts, values, *_ = halving.run(begin[begin < end], end[begin < end])
    return starts, values


@dataclass(frozen=True)
class _Halving:
    """Intervals of a function, halved until they can be fitted."""

    f: Function
    label: str
    whole: float
    dense: FloatArray
    seen: FloatArray

    def run(self, begin: FloatArray, end: FloatArray) -> tuple[FloatArray, ...]:
        """Starts and values of the pieces; ends of the intervals in which the function jumps."""
        scale = np.abs(self.seen).max(axis=-1, keepdims=True)
        starts, values, jumps, kinks = [begin[:0]], [], [np.empty((2, 0))], [np.empty((2, 0))]
        while begin.size:
            middle, half = (begin + end) / 2, (end - begin) / 2
            series = _series(self.f, middle, half)
            error = np.maximum(
                _error(self.f, middle, half, series),
                _error_between(self.dense, self.seen, begin, end, series),
            )
            worst = (error / np.where(scale > 0, scale, 1.0)).reshape(-1, begin.size).max(axis=0)
            good, point = worst <= _ERROR, half <= _POINT * self.whole
            narrow = good & (half <= _NARROW * _POINT * self.whole)
            jumps.append(np.stack([begin, end])[:, point & ~good])
            kinks.append(np.stack([begin, end])[:, narrow])
            starts.append(begin[good])
            values.append(_powers(middle[good], half[good], series[..., good, :]))
            rest = ~good & ~point
            if rest.any() and sum(map(len, starts)) + rest.sum() > _MOST:
                near = middle[rest][0]
                raise GroundrollError(
                    f"{self.label} varies too quickly to be followed near t = {near:.4g} s"
                )
            begin, end = (
                np.concatenate(each)
                for each in ((begin[rest], middle[rest]), (middle[rest], end[rest]))
            )
        every = np.concatenate(starts)
        order = np.argsort(every)
        found = _gaps(np.concatenate(jumps, 1), np.concatenate(kinks, 1), _CLOSE * self.whole)
        return every[order], np.concatenate(values, axis=-2)[..., order, :], *found


def _gaps(jumps: FloatArray, kinks: FloatArray, close: float) -> FloatArray:
    """Ends of the intervals to be left out: around each jump, and around kinks elsewhere."""
    found: list[tuple[float, float]] = []
    for intervals in (jumps, kinks):
        groups: list[list[float]] = []
        for first, last in intervals[:, np.argsort(intervals[0])].T.tolist():
            if any(first < b + close and last > a - close for a, b in found):
                continue
            if groups and first < groups[-1][1] + close:
                groups[-1][1] = max(last, groups[-1][1])
            else:
                groups.append([first, last])
        found += [(first, last) for first, last in groups]
    return np.array(found).reshape(-1, 2).T


def _series(f: Function, middle: FloatArray, half: FloatArray) -> FloatArray:
    """Chebyshev coefficients of each piece, shape (..., pieces, terms)."""
    t = middle[:, None] + half[:, None] * NODES
    found = f(t.ravel())
    return found.reshape(*found.shape[:-1], *t.shape) @ _TO_SERIES


def _error(f: Function, middle: FloatArray, half: FloatArray, series: FloatArray) -> FloatArray:
    """Largest error of each piece at points between its nodes, shape (..., pieces)."""
    begin, end = (np.nextafter(middle + side * half, middle) for side in (-1.0, 1.0))
    t = np.clip(middle[:, None] + half[:, None] * _CHECKS, begin[:, None], end[:, None])
    found = f(t.ravel())
    exact = found.reshape(*found.shape[:-1], *t.shape)
    return np.asarray(np.abs(series @ _AT_CHECKS - exact).max(axis=-1))


def _error_between(
    dense: FloatArray, seen: FloatArray, begin: FloatArray, end: FloatArray, series: FloatArray
) -> FloatArray:
    """The same at times that lie close together, wherever a piece holds some."""
    error = np.zeros(series.shape[:-1])
    for k, (first, last) in enumerate(
        zip(np.searchsorted(dense, begin, "right"), np.searchsorted(dense, end), strict=True)
    ):
        if first < last:
            x = (2 * dense[first:last] - begin[k] - end[k]) / (end[k] - begin[k])
            found = chebyshev.chebval(x, np.moveaxis(series[..., k, :], -1, 0))
            error[..., k] = np.abs(found - seen[..., first:last]).max(axis=-1)
    return error


def _powers(middle: FloatArray, half: FloatArray, series: FloatArray) -> FloatArray:
    """Middles, and coefficients of powers of the time from there."""
    powers = series @ _TO_POWERS / half[:, None] ** np.arange(TERMS)
    first = np.broadcast_to(middle[:, None], (*powers.shape[:-1], 1))
    return np.concatenate([first, powers], axis=-1)


def _tables() -> tuple[FloatArray, FloatArray, FloatArray]:
    to_series = np.linalg.inv(chebyshev.chebvander(NODES, TERMS - 1)).T
    to_powers = np.zeros((TERMS, TERMS))
    for k in range(TERMS):
        to_powers[k, : k + 1] = chebyshev.cheb2poly(np.eye(TERMS)[k])[: k + 1]
    at_checks = np.asarray(chebyshev.chebvander(_CHECKS, TERMS - 1).T, dtype=np.float64)
    return np.asarray(to_series, dtype=np.float64), at_checks, to_powers


_TO_SERIES, _AT_CHECKS, _TO_POWERS = _tables()
