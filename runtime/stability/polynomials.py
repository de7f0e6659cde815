"""Roots of many small polynomials at once."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from groundroll.base.arrays import FloatArray
from groundroll.base.errors import beyond

ComplexArray = npt.NDArray[np.complex128]

#: A leading coefficient so small beside another puts a root beyond what a number can hold.
_NOTHING = 1e-300


def roots(coefficients: FloatArray) -> ComplexArray:
    """Roots of polynomials with the given coefficients.

    Parameters
    ----------
    coefficients : ndarray, shape (n + 1, ...)
        The constant term first. Leading coefficients may be zero.

    Returns
    -------
    complex ndarray, shape (n, ...)
        The roots; NaN beyond the degree. A polynomial that is zero has none.

    Raises
    ------
    GroundrollError
        If a coefficient is not finite.
    """
    if not np.isfinite(coefficients).all():
        raise beyond("the roots of a polynomial")
    size, *shape = coefficients.shape
    flat = coefficients.reshape(size, -1)
    size_of = np.abs(flat)
    counts = (size_of > _NOTHING * size_of.max(axis=0)) & (flat != 0)
    degrees = np.where(counts, np.arange(size)[:, None], 0).max(axis=0)
    found = np.full((size - 1, flat.shape[1]), np.nan, dtype=np.complex128)
    for degree in np.unique(degrees[degrees > 0]):
        which = np.flatnonzero(degrees == degree)
        found[:degree, which] = _companion_roots(flat[: degree + 1, which]).T
    return found.reshape(size - 1, *shape)


def _companion_roots(coefficients: FloatArray) -> ComplexArray:
    degree = len(coefficients) - 1
    companion = np.zeros((coefficients.shape[1], degree, degree))
    companion[:, np.arange(1, degree), np.arange(degree - 1)] = 1.0
    companion[:, :, -1] = -(coefficients[:-1] / coefficients[-1]).T
    return np.linalg.eigvals(companion).astype(np.complex128)


def negative_stretch(coefficients: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The first stretch between 0 and 1 on which polynomials are negative.

    The real parts of all roots divide the range; a sign at the middle of each part decides, so
    that nothing depends on whether a root counts as real.

    Parameters
    ----------
    coefficients : ndarray, shape (n + 1, ...)
        The constant term first.

    Returns
    -------
    start, end : ndarray
        NaN where there is none; `end` is NaN where the stretch lasts to 1.
    """
    real = np.nan_to_num(roots(coefficients).real, nan=1.0)
    ends = np.zeros((1, *real.shape[1:]))
    edges = np.sort(np.concatenate([ends, np.clip(real, 0.0, 1.0), ends + 1.0]), axis=0)
    value = np.polynomial.polynomial.polyval(
        (edges[:-1] + edges[1:]) / 2, coefficients[:, None], tensor=False
    )
    wide = np.diff(edges, axis=0) > 1e-12
    negative = wide & (value < 0)
    start = _first(negative, edges)
    return start, _first(wide & (value > 0) & (edges[:-1] > start), edges)


def _first(where: npt.NDArray[np.bool_], edges: FloatArray) -> FloatArray:
    index = where.argmax(axis=0)[None]
    edge = np.take_along_axis(edges, index, axis=0)[0]
    return np.where(where.any(axis=0), edge, np.nan)
