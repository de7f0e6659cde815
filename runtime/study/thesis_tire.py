"""The thesis's way from Table 3.1 to a tire (Section 3.4): secants, peaks, magic formula."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import casadi as ca
import numpy as np

from groundroll.base.arrays import FloatArray, finite
from groundroll.base.errors import GroundrollError
from groundroll.generated import build
from groundroll.model.evaluate import elementwise, solved
from groundroll.tires.data import TireData

#: Symbols of the magic formula.
MAGIC = ("B1", "C1", "D1", "E1")

#: From where the thesis searched: x0 of MAGICFIT.m, App. A.1.
THESIS_START = (0.7407, 1.35, 1.00, -0.51)

#: The search stays where no slip angle makes the force reverse: with E1 <= 1 psi_bar never
#: turns back, and with C1 <= 2 the sine never passes half a turn.
_LOWEST = (1e-6, 1e-6, 1e-6, -np.inf)
_HIGHEST = (np.inf, 2.0, np.inf, 1.0)

_QUIET: dict[str, Any] = {
    "print_time": False,
    "error_on_fail": False,
    "ipopt": {
        "print_level": 0,
        "sb": "yes",
        "tol": 1e-12,
        "acceptable_iter": 0,  # a point short of the minimum is a failure
        "mu_init": 1e-10,  # the usual barrier, 0.1, is so high here that the start is forgotten
        "bound_relax_factor": 0.0,
    },
}


@dataclass(frozen=True, eq=False)
class Table:
    """Forces of one tire at slip angles (rows, one of them 1 deg) and loads (columns)."""

    slip_angles: FloatArray
    loads: FloatArray
    forces: FloatArray

    @cached_property
    def coefficients(self) -> tuple[FloatArray, FloatArray]:
        """Cornering and friction coefficient at each load (Eqs. 3.2, 3.4): secant and peak."""
        (secant,) = np.flatnonzero(np.isclose(self.slip_angles, np.radians(1.0), rtol=1e-9))
        arguments = {
            "alpha": np.asarray(self.slip_angles[secant]),
            "F_y": self.forces[secant],
            "F_peak": self.forces.max(axis=0),
            "Fz": self.loads,
        }
        found = elementwise("measured_coefficients", arguments)
        return found["C_c"], found["mu"]

    @cached_property
    def normalised(self) -> tuple[FloatArray, FloatArray]:
        """Normalised slip angles and forces (Eqs. 3.6, 3.7), each load with its coefficients."""
        C_c, mu = self.coefficients
        arguments = {
            "alpha": self.slip_angles[:, None],
            "F_y": self.forces,
            "Fz": self.loads,
            "C_c": C_c,
            "mu": mu,
        }
        found = elementwise("normalised_data", arguments)
        return found["alpha_bar"], found["F_bar"]


def table_3_1() -> Table:
    """Table 3.1."""
    curves = TireData.load("goodyear-6.00-6").curves
    loads = np.array([curve.load for curve in curves])
    return Table(curves[0].slip_angles, loads, np.stack([c.forces for c in curves], axis=1))


@dataclass(frozen=True, eq=False)
class ThesisFit:
    """A tire in the thesis's normalisation.

    Attributes
    ----------
    table : Table
        What was fitted.
    parameters : mapping of str to float
        B3, C3, B5, C5, B1, C1, D1, E1; SI units with radians.
    rms : float
        Root mean square error of the magic formula, normalised.
    at_edge : tuple of str
        Which of its parameters lie on the edge of the search; empty for a proper minimum.
    """

    table: Table
    parameters: Mapping[str, float]
    rms: float
    at_edge: tuple[str, ...]


def thesis_fit(table: Table, start: Sequence[float] = THESIS_START) -> ThesisFit:
    """Straight lines and magic formula by least squares, as Section 3.4 does.

    The search keeps B1, D1 > 0, 0 < C1 <= 2 and E1 <= 1, where the force cannot reverse at any
    slip angle. Beyond E1 = 1 lies a valley without a minimum (C1 to 0, D1 to infinity), which fits
    the thesis's data 7 % better and is worthless beyond them; Table 3.2 is a point in it.

    Parameters
    ----------
    table : Table
        Measured forces.
    start : sequence of 4 floats
        B1, C1, D1, E1 from where to search; default the thesis's own.

    Raises
    ------
    GroundrollError
        If the search finds no minimum.
    """
    C_c, mu = table.coefficients
    magic = _least_squares(*table.normalised, start)
    values = (*_straight_line(table.loads, C_c), *_straight_line(table.loads, mu), *magic)
    parameters = dict(zip(("B3", "C3", "B5", "C5", *MAGIC), values, strict=True))
    return ThesisFit(table, parameters, normalised_rms(table, parameters), _at_edge(magic))


def normalised_rms(table: Table, parameters: Any) -> float:
    """Root mean square error of a magic formula on the normalised data.

    The points at zero slip, which every parameter set meets, are not counted; with one for each
    load the thesis's data give 0.0104 instead of 0.0107.
    """
    alpha_bar, F_bar = table.normalised
    values = {s: finite(s, parameters[s]) for s in MAGIC}
    errors = elementwise("magic_formula", {"alpha_bar": alpha_bar, **values})["F_bar"] - F_bar
    return float(np.sqrt(np.mean(errors**2)))


def conditioning(table: Table, parameters: Any) -> float:
    """Condition number of the Gauss-Newton matrix of the magic formula fit.

    Each parameter is scaled so that the diagonal is one: 1 where every parameter leaves a mark
    of its own on the data, infinite where some change of all four leaves none.
    """
    errors, x = _residual(*table.normalised)
    jacobian = ca.Function("jacobian", [x], [ca.jacobian(errors, x)])
    J = np.array(jacobian([float(parameters[s]) for s in MAGIC]), dtype=np.float64)
    scale = np.linalg.norm(J, axis=0)
    return float(np.linalg.cond(J / scale) ** 2) if scale.all() else float("inf")


def _straight_line(x: FloatArray, y: FloatArray) -> tuple[float, float]:
    """Intercept and slope of the least-squares line."""
    slope, intercept = np.polyfit(x, y, 1)
    return float(intercept), float(slope)


def _least_squares(alpha_bar: FloatArray, F_bar: FloatArray, start: Sequence[float]) -> list[float]:
    """B1, C1, D1, E1 at the minimum of the sum of squares."""
    errors, x = _residual(alpha_bar, F_bar)
    solver = ca.nlpsol("magic_fit", "ipopt", {"x": x, "f": ca.sumsqr(errors)}, _QUIET)
    solution = solved(solver, x0=finite("start", start), lbx=list(_LOWEST), ubx=list(_HIGHEST))
    if not solver.stats()["success"]:
        status = solver.stats()["return_status"]
        raise GroundrollError(f"no minimum from start {tuple(start)} (IPOPT: {status})")
    return [float(value) for value in np.array(solution["x"]).ravel()]


def _residual(alpha_bar: FloatArray, F_bar: FloatArray) -> tuple[ca.SX, ca.SX]:
    """Errors of the magic formula at the data as an expression of B1, C1, D1, E1."""
    x = ca.SX.sym("x", len(MAGIC))
    predicted = build("magic_formula")(alpha_bar.reshape(1, -1), *ca.vertsplit(x))
    return (predicted - F_bar.reshape(1, -1)).T, x


def _at_edge(magic: Sequence[float]) -> tuple[str, ...]:
    near = np.isclose(magic, _LOWEST, atol=1e-6) | np.isclose(magic, _HIGHEST, atol=1e-6)
    return tuple(s for s, there in zip(MAGIC, near, strict=True) if there)
