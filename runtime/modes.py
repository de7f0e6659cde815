"""What is read from state matrices: eigenvalues, damping, frequency, for any number of states."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from .arrays import FloatArray
from .evaluate import elementwise

ComplexArray = npt.NDArray[np.complex128]


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
    entries = {f"A_{i}{j}": A[..., k, n] for k, i in enumerate("vr") for n, j in enumerate("vr")}
    found = elementwise("modes", entries)
    eigenvalues = np.stack([found[f"re_{k}"] + 1j * found[f"im_{k}"] for k in (1, 2)], -1)
    return Modes(
        eigenvalues,
        found["decay_rate"],
        found["damping_ratio"],
        found["natural_frequency"],
        found["damped_frequency"],
    )


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
