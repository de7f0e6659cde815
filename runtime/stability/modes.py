"""What is read from state matrices: eigenvalues, damping, frequency, for any number of states."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from groundroll.base.arrays import FloatArray
from groundroll.base.memory import room
from groundroll.model.evaluate import elementwise

ComplexArray = npt.NDArray[np.complex128]

#: What is read from the eigenvalues, one number for each matrix.
READ_OFF = ("decay_rate", "damping_ratio", "natural_frequency", "damped_frequency")
#: How the generated function calls the entries of a 2 x 2 matrix, and the parts of eigenvalues.
_ENTRIES, _PARTS = ("A_vv", "A_vr", "A_rv", "A_rr"), ("re_1", "im_1", "re_2", "im_2")


@dataclass(frozen=True)
class Modes:
    """The eigenvalues of state matrices, and what is read from the one that decays last.

    Attributes
    ----------
    eigenvalues : complex ndarray, shape (..., n)
        1/s; the larger real part first, of a pair the positive imaginary part first.
    decay_rate, damping_ratio, natural_frequency, damped_frequency : ndarray, shape (...)
        As in `Linearization`.
    """

    eigenvalues: ComplexArray
    decay_rate: FloatArray
    damping_ratio: FloatArray
    natural_frequency: FloatArray
    damped_frequency: FloatArray


def modes_of(A: FloatArray) -> Modes:
    """Modes of state matrices of shape (..., n, n); NaN where a matrix is not finite."""
    return _of_two(A) if A.shape[-1] == 2 else _of_any(A)


def _of_two(A: FloatArray) -> Modes:
    """By the closed form that is generated."""
    shape, count = A.shape[:-2], math.prod(A.shape[:-2])
    entries, numbers, parts = room((4, count), (8, count), (count, 4))
    entries[...] = A.reshape(-1, 4).T
    found = dict(zip((*_PARTS, *READ_OFF), numbers, strict=True))
    elementwise("modes", dict(zip(_ENTRIES, entries, strict=True)), found)
    for k, name in enumerate(_PARTS):
        parts[:, k] = found[name]
    eigenvalues = parts.view(np.complex128).reshape(*shape, 2)
    return Modes(eigenvalues, *(found[name].reshape(shape) for name in READ_OFF))


def _of_any(A: FloatArray) -> Modes:
    good = np.asarray(np.isfinite(A).all(axis=(-2, -1)))
    found = np.linalg.eigvals(np.where(good[..., None, None], A, 0.0)).astype(np.complex128)
    found = np.where(good[..., None], found, np.nan)
    order = np.lexsort((-found.imag, -found.real), axis=-1)
    eigenvalues = np.take_along_axis(found, order, axis=-1)
    last = eigenvalues[..., 0]
    size = np.abs(last)
    with np.errstate(invalid="ignore", divide="ignore"):
        ratio = -last.real / size
    return Modes(eigenvalues, -last.real, ratio, size, np.abs(last.imag))
