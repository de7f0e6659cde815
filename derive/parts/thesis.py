"""The parts of the thesis's aircraft: what force each makes (Sections 4.2.3, 4.4, 4.5.4)."""

from __future__ import annotations

import sympy as sp
from sympy.physics.vector import Vector

from groundroll.derive.core.equation import Equation
from groundroll.derive.core.frames import i, j, r, v
from groundroll.derive.core.part import Felt, Force, Law
from groundroll.derive.core.quantity import Quantity

from .quantities import Ap, CL_gamma, Ct, F_disturbance, rho, theta, u, y
from .tires import F_y, Tire

alpha = Quantity("alpha", "main_gear_slip_angle", "rad", "slip angle of the main tires", r"\alpha")
gamma = Quantity(
    "gamma", "tail_angle", "rad", "angle of incidence of the tail and its wheel", r"\gamma"
)
F_main = Quantity(
    "F_main",
    "main_gear_force",
    "N",
    "lateral force of the two main tires, to the left",
    r"F_{y\,\mathrm{main}}",
)
F_tail = Quantity(
    "F_tail",
    "tail_force",
    "N",
    "side force of the vertical tail, to the left",
    r"F_{y\,\mathrm{tail}}",
)
F_tail_wheel = Quantity(
    "F_tail_wheel",
    "tail_wheel_force",
    "N",
    "lateral force of the tail wheel, to the left",
    r"F_{y\,\mathrm{tailwheel}}",
)


def slip_angle(angle: Quantity, velocity: Vector, source: str) -> Equation:
    """Angle of `velocity` to the x axis: atan(V_y / V_x), Eq. 4.13."""
    return Equation(angle, sp.atan(velocity.dot(j) / velocity.dot(i)), source)


def main_gear(tire: Tire) -> Law:
    """The two main tires, a ahead of the CG (Eq. 4.11)."""

    def law(felt: Felt) -> Force:
        chain = (
            slip_angle(alpha, felt.velocity, "Eq. 4.14"),
            *tire(alpha),
            Equation(F_main, 2 * F_y, "Eq. 4.38"),
        )
        return Force(-F_main * j, chain=chain, shown=())

    return law


def vertical_tail(felt: Felt) -> Force:
    """The vertical tail, b behind the CG (Eq. 4.16)."""
    chain = (
        slip_angle(gamma, felt.velocity, "Eq. 4.19"),
        Equation(F_tail, sp.Rational(1, 2) * rho * u**2 * Ap * CL_gamma * gamma, "Eq. 4.29"),
    )
    return Force(-F_tail * j, chain=chain, shown=())


def tail_wheel(felt: Felt) -> Force:
    """The tail wheel, directly below the vertical tail."""
    chain = (
        slip_angle(gamma, felt.velocity, "Eq. 4.19"),
        Equation(F_tail_wheel, Ct * gamma, "Eq. 4.30"),
    )
    return Force(-F_tail_wheel * j, chain=chain, shown=())


def disturbance(felt: Felt) -> Force:
    """A side force on the vertical tail."""
    return Force(F_disturbance * j)


def displacements(felt: Felt) -> Force:
    """No force: the thesis integrates v and r in aircraft coordinates."""
    return Force(rates={y: v, theta: r})
