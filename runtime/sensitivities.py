"""Exact derivatives of linear models by the parameters of the aircraft."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cache

import casadi as ca
import numpy as np
import numpy.typing as npt

from .arrays import FloatArray
from .evaluate import columns
from .linearization import ComplexArray, Linearization, columns_at
from .listing import Listed, span, unit_of
from .models import ModelLike, as_model


@dataclass(frozen=True, repr=False)
class Sensitivities(Listed):
    """Exact derivatives of a linear model by the parameters of its aircraft.

    They are partial: the operating point stays, and so do parameters that would follow.
    ``sensitivities["a"]`` (or ``["main_gear_arm"]``) is the derivative of both eigenvalues.

    Attributes
    ----------
    model : str or Model
    parameters : tuple of str
        Symbols, in the order of the last axis of the arrays.
    A : ndarray, shape (..., 2, 2, n)
        Derivatives of the state matrix, SI units with radians.
    eigenvalues : complex ndarray, shape (..., 2, n)
        Derivatives of the eigenvalues, in the order of `Linearization.eigenvalues`. NaN where
        the two meet: there they have no derivative.
    decay_rate : ndarray, shape (..., n)
        Derivatives of the decay rate, 1/s per unit of the parameter.
    modes_meet : bool ndarray
        Where the eigenvalues are too close to each other to tell apart.
    """

    model: ModelLike
    parameters: tuple[str, ...]
    A: FloatArray
    eigenvalues: ComplexArray
    decay_rate: FloatArray
    modes_meet: npt.NDArray[np.bool_]

    def __getitem__(self, name: str) -> ComplexArray:
        column = as_model(self.model).symbol(
            name, "parameter", self.parameters, "these sensitivities"
        )
        return self.eigenvalues[..., self.parameters.index(column)]

    def _title(self) -> str:
        points = " x ".join(map(str, self.modes_meet.shape))
        return f"Sensitivities of the decay rate{f', {points} points' if points else ''}"

    def _rows(self) -> Iterable[Sequence[str]]:
        for k, s in enumerate(self.parameters):
            q = as_model(self.model).quantities[s]
            per = f" per {unit_of(q)}" if unit_of(q) else ""
            yield s, q.name, span(self.decay_rate[..., k]), f"1/s{per}"


#: Eigenvalues closer than this, relative to the larger, carry no digits of their difference.
_SAME = 1e-7


def sensitivities(lin: Linearization) -> Sensitivities:
    """Derivatives of a linear model; see `Sensitivities`."""
    x, u, p, shape = columns_at(lin.aircraft, lin.model, lin.at)
    (flat,) = columns(_state_matrix_derivatives(lin.model), x, u, p)
    # CasADi stacks the columns of A
    dA = flat.reshape(*shape, 2, 2, len(p)).swapaxes(-3, -2)
    slopes, meet = _eigenvalue_derivatives(lin.A, lin.eigenvalues, dA)
    names, decay = as_model(lin.model).parameters, -slopes[..., 0, :].real
    return Sensitivities(lin.model, names, dA, slopes, decay, meet)


def _eigenvalue_derivatives(
    A: FloatArray, eigenvalues: ComplexArray, dA: FloatArray
) -> tuple[ComplexArray, npt.NDArray[np.bool_]]:
    """w^H dA v / (w^H v) with the left and right eigenvectors w and v of each eigenvalue.

    v w^H / (w^H v) is the projector on the mode, (A - other I) / (eigenvalue - other).
    """
    other = eigenvalues[..., ::-1]
    apart = eigenvalues - other
    meet = np.abs(apart[..., 0]) <= _SAME * np.abs(eigenvalues).max(axis=-1)
    apart = np.where(meet[..., None], 1.0, apart)
    projector = (A[..., None, :, :] - other[..., None, None] * np.eye(2)) / apart[..., None, None]
    slopes = np.einsum("...kij,...jip->...kp", projector, dA)
    return np.where(meet[..., None, None], np.nan, slopes), meet


@cache
def _state_matrix_derivatives(model: ModelLike) -> ca.Function:
    """d(vec A)/dp by CasADi's differentiation of the generated Jacobians: (x, u, p) -> (4, n)."""
    names = as_model(model)
    jacobians = names.expression("jacobians")
    x, u, p = (ca.SX.sym(key, jacobians.size1_in(k)) for k, key in enumerate("xup"))
    dynamic = [names.states.index(s) for s in names.dynamic]
    A = jacobians(x, u, p)[0][dynamic, dynamic]
    derivatives = ca.densify(ca.jacobian(ca.vec(A), p))
    return ca.Function(f"{names.name}_state_matrix_derivatives", [x, u, p], [derivatives])
