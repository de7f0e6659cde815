"""Exact derivatives of linear models by the parameters of the aircraft."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING

import casadi as ca
import numpy as np
import numpy.typing as npt

from groundroll.base.arrays import FloatArray
from groundroll.base.listing import Listed, span, unit_of
from groundroll.model.evaluate import columns
from groundroll.model.models import ModelLike, as_model
from groundroll.stability.modes import ComplexArray

from .operating_point import points_at

if TYPE_CHECKING:
    from .linearization import Linearization


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
    model = as_model(lin.model)
    points = points_at(lin.aircraft, model, lin.at, {}, "sensitivities")
    (flat,) = columns(_state_matrix_derivatives(lin.model), *points.vectors)
    # CasADi stacks the columns of A
    n, shape = len(model.dynamic), points.shape
    dA = flat.reshape(*shape, n, n, len(model.parameters)).swapaxes(-3, -2)
    slopes, meet = _eigenvalue_derivatives(lin.A, lin.eigenvalues, dA)
    decay = -slopes[..., 0, :].real
    return Sensitivities(lin.model, model.parameters, dA, slopes, decay, meet)


def _eigenvalue_derivatives(
    A: FloatArray, eigenvalues: ComplexArray, dA: FloatArray
) -> tuple[ComplexArray, npt.NDArray[np.bool_]]:
    """w^H dA v / (w^H v) with the left and right eigenvectors w and v of each eigenvalue.

    v w^H / (w^H v) is the projector on the mode: the product of (A - other I) / (eigenvalue -
    other) over the other eigenvalues.
    """
    n = A.shape[-1]
    apart = eigenvalues[..., :, None] - eigenvalues[..., None, :]
    near = np.abs(apart) <= _SAME * np.abs(eigenvalues).max(axis=-1)[..., None, None]
    alone = ~near | np.eye(n, dtype=bool)
    meet = ~alone.all(axis=(-2, -1))
    factor = (A[..., None, :, :] - eigenvalues[..., None, None] * np.eye(n)).astype(complex)
    slopes = []
    for k in range(n):
        projector = np.broadcast_to(np.eye(n, dtype=complex), A.shape)
        for j in range(n):
            if j != k:
                gap = np.where(near[..., k, j], 1.0, apart[..., k, j])
                projector = projector @ (factor[..., j, :, :] / gap[..., None, None])
        slopes.append(np.einsum("...ij,...jip->...p", projector, dA))
    found = np.stack(slopes, axis=-2)
    return np.where(meet[..., None, None], np.nan, found), meet


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
