"""Polynomials for a function of time, as good as rounding allows."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import numpy as np
from numpy.polynomial import chebyshev

from groundroll.arrays import FloatArray
from groundroll.chunks import check_memory
from groundroll.errors import GroundrollError

from .lanes import TERMS

#: Where a piece is sampled, from -1 to 1: the nodes of its polynomial, and what it is checked at.
NODES = chebyshev.chebpts1(TERMS)
_CHECKS = np.linspace(-1.0, 1.0, 2 * TERMS + 1)[1:-1]
#: What passes narrower than this, s, may be missed.
_SEEN = 2.5e-4
#: Largest error, relative to the largest value, and the same times a piece's share of the time.
_ERROR, _SHARE = 2e-13, 1e-16
#: Pieces, relative to the whole, at which a jump is found; and most pieces.
_POINT, _MOST = 1e-14, 4000
#: Bytes for each time in which a function is looked at.
_BYTES = 3 * 8

Function = Callable[[FloatArray], FloatArray]


def fit(f: Function, marks: FloatArray, label: str) -> tuple[FloatArray, FloatArray]:
    """Polynomials between marks.

    Intervals are halved until each polynomial is good; that closes in on jumps and kinks, too,
    wherever they are.

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
    whole = marks[-1] - marks[0]
    count = int(np.ceil(whole / _SEEN)) + 1
    check_memory(_BYTES * count, f"the times at which {label} is looked at")
    dense = np.linspace(marks[0], marks[-1], count)
    seen = f(dense)
    scale = np.abs(seen).max(axis=-1, keepdims=True)
    begin, end = marks[:-1], marks[1:]
    starts: list[FloatArray] = []
    values: list[FloatArray] = []
    made = 0
    while begin.size:
        middle, half = (begin + end) / 2, (end - begin) / 2
        series = _series(f, middle, half)
        error = _error(f, middle, half, series)
        error = np.maximum(error, _error_between(dense, seen, begin, end, series))
        worst = (error / np.where(scale > 0, scale, 1.0)).reshape(-1, begin.size).max(axis=0)
        good = (worst <= _ERROR) | (worst * 2 * half <= _SHARE * whole)
        point = ~good & (half <= _POINT * whole)
        starts.append(begin[good])
        values.append(_powers(middle[good], half[good], series[..., good, :]))
        made += int(good.sum())
        rest = ~good & ~point
        if made + rest.sum() > _MOST:
            raise GroundrollError(
                f"{label} varies too quickly to be followed near t = {middle[rest][0]:.4g} s"
            )
        begin, end = (
            np.concatenate(each)
            for each in ((begin[rest], middle[rest]), (middle[rest], end[rest]))
        )
    order = np.argsort(np.concatenate(starts))
    return np.concatenate(starts)[order], np.concatenate(values, axis=-2)[..., order, :]


def _series(f: Function, middle: FloatArray, half: FloatArray) -> FloatArray:
    """Chebyshev coefficients of each piece, shape (..., pieces, terms)."""
    t = middle[:, None] + half[:, None] * NODES
    found = f(t.ravel())
    return found.reshape(*found.shape[:-1], *t.shape) @ _TO_SERIES


def _error(f: Function, middle: FloatArray, half: FloatArray, series: FloatArray) -> FloatArray:
    """Largest error of each piece at points between its nodes, shape (..., pieces)."""
    t = middle[:, None] + half[:, None] * _CHECKS
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
    return to_series, chebyshev.chebvander(_CHECKS, TERMS - 1).T, to_powers


_TO_SERIES, _AT_CHECKS, _TO_POWERS = _tables()
