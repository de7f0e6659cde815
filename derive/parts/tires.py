"""Lateral force of one tire (Chapter 3), as chains from a slip angle to a force."""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from groundroll.derive.core.equation import Chain, Equation, expand
from groundroll.derive.core.quantity import Quantity

from .quantities import B1, B3, B5, C1, C3, C5, D1, E1, C_alpha, Fz

C_c = Quantity("C_c", "cornering_coefficient", "1/rad", "cornering stiffness over load")
mu = Quantity("mu", "friction_coefficient", "1", "lateral friction coefficient", r"\mu_y")
alpha_bar = Quantity(
    "alpha_bar", "normalised_slip_angle", "1", "normalised slip angle", r"\bar{\alpha}"
)
psi_bar = Quantity("psi_bar", "magic_formula_psi", "1", "magic formula intermediate", r"\bar{\psi}")
theta_bar = Quantity(
    "theta_bar", "magic_formula_theta", "1", "magic formula intermediate", r"\bar{\theta}"
)
F_bar = Quantity("F_bar", "normalised_force", "1", "normalised lateral force", r"\bar{F}_y")
F_peak = Quantity("F_peak", "peak_force", "N", "largest lateral force at a load", r"F_{y\,\max}")
F_slope = Quantity(
    "F_slope", "tire_slope", "N/rad", "slope of the lateral force of one tire at no slip angle"
)
F_y = Quantity(
    "F_y", "tire_force", "N", "lateral force of one tire, to the left for a positive slip angle"
)

#: From a slip angle to the chain that ends in `F_y`.
Tire = Callable[[Quantity], Chain]


def linear_tire(slip_angle: Quantity) -> Chain:
    """Force proportional to the slip angle (Section 3.3)."""
    return (Equation(F_y, C_alpha * slip_angle, "Eq. 3.1"),)


def load_dependence() -> Chain:
    """Cornering and friction coefficient at a load."""
    return (
        Equation(C_c, B3 + C3 * Fz, "Eq. 3.3"),
        Equation(mu, B5 + C5 * Fz, "Eq. 3.5"),
    )


def measured_coefficients(slip_angle: Quantity, peak: Quantity) -> Chain:
    """Both coefficients from one load's measured forces: the secant at a slip angle, the peak."""
    return (
        Equation(C_c, F_y / (Fz * slip_angle), "Eq. 3.2"),
        Equation(mu, peak / Fz, "Eq. 3.4"),
    )


def normalised_data(slip_angle: Quantity) -> Chain:
    """A measured point in normalised form."""
    return (
        Equation(alpha_bar, C_c * sp.tan(slip_angle) / mu, "Eq. 3.6"),
        Equation(F_bar, F_y / (mu * Fz), "Eq. 3.7"),
    )


def magic_formula() -> Chain:
    """Normalised force from normalised slip angle."""
    return (
        Equation(psi_bar, (1 - E1) * alpha_bar + E1 / B1 * sp.atan(B1 * alpha_bar), "Eq. 3.10"),
        Equation(theta_bar, C1 * sp.atan(B1 * psi_bar), "Eq. 3.9"),
        Equation(F_bar, D1 * sp.sin(theta_bar), "Eq. 3.8"),
    )


def nonlinear_tire(slip_angle: Quantity) -> Chain:
    """Radt's normalised tire with the magic formula (Section 3.4).

    C_c is in 1/rad here, as everything is; with C_c in 1/deg Eq. 3.6 needs the factor 180/pi
    that the code of App. A.3 has and the text omits.
    """
    return (
        *load_dependence(),
        Equation(alpha_bar, C_c * sp.tan(slip_angle) / mu, "Eq. 3.6"),
        *magic_formula(),
        Equation(F_y, F_bar * mu * Fz, "Eq. 3.11"),
    )


def slope_at_zero() -> Chain:
    """What the linear tire would have to be to agree with the non-linear one at small angles."""
    angle = Quantity("alpha", "slip_angle", "rad", "slip angle of a tire", r"\alpha")
    at_load = tuple(e for e in nonlinear_tire(angle) if e.lhs not in (C_c, mu))
    slope = expand(F_y, at_load).diff(angle).subs(angle, 0)
    return (*load_dependence(), Equation(F_slope, sp.simplify(slope), "derivative of Eq. 3.11"))


def magic_formula_of_shape() -> Chain:
    """B and D for which the normalised curve has the slope 1 at zero and, for C from 1 on, peaks
    at 1: then C_c is the slope of the tire and mu its friction, and C and E are its shape."""
    slope = expand(F_bar, magic_formula()).diff(alpha_bar).subs(alpha_bar, 0)
    (unit_slope,) = sp.solve(sp.simplify(slope) - 1, B1)
    return (Equation(D1, sp.Integer(1), "peak"), Equation(B1, unit_slope, "slope"))
