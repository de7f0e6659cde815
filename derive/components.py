"""Components of the aircraft: where each sits and what force it makes (Sections 4.2.3, 4.4, 4.5.4).

A component is a position vector and a force law. To add one, write its law here (or in your own
module) and put it in the list given to `derive.model.assemble`; nothing else changes.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import sympy as sp
from sympy.physics.vector import Vector

from .equation import Chain, Equation
from .kinematics import i, j
from .quantities import Ap, CL_gamma, Ct, F_disturbance, Quantity, a, b, rho, u
from .tire import F_y, Tire

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


@dataclass(frozen=True)
class Force:
    """A force on the aircraft and the chain of equations behind it."""

    vector: Vector
    chain: Chain = ()


#: From the velocity of the component to the force it makes.
ForceLaw = Callable[[Vector], Force]


@dataclass(frozen=True)
class Component:
    """Something that makes a force: its name, its position from the CG and its force law."""

    name: str
    position: Vector
    law: ForceLaw


def slip_angle(angle: Quantity, velocity: Vector, source: str) -> Equation:
    """Angle of `velocity` to the x axis: atan(V_y / V_x), Eq. 4.13."""
    return Equation(angle, sp.atan(velocity.dot(j) / velocity.dot(i)), source)


def main_gear(tire: Tire) -> Component:
    """The two main tires, a ahead of the CG (Eq. 4.11)."""

    def law(velocity: Vector) -> Force:
        chain = (
            slip_angle(alpha, velocity, "Eq. 4.14"),
            *tire(alpha),
            Equation(F_main, 2 * F_y, "Eq. 4.38"),
        )
        return Force(-F_main * j, chain)

    return Component("main gear", a * i, law)


def vertical_tail() -> Component:
    """The vertical tail, b behind the CG (Eq. 4.16)."""

    def law(velocity: Vector) -> Force:
        chain = (
            slip_angle(gamma, velocity, "Eq. 4.19"),
            Equation(F_tail, sp.Rational(1, 2) * rho * u**2 * Ap * CL_gamma * gamma, "Eq. 4.29"),
        )
        return Force(-F_tail * j, chain)

    return Component("vertical tail", -b * i, law)


def tail_wheel() -> Component:
    """The tail wheel, directly below the vertical tail."""

    def law(velocity: Vector) -> Force:
        chain = (
            slip_angle(gamma, velocity, "Eq. 4.19"),
            Equation(F_tail_wheel, Ct * gamma, "Eq. 4.30"),
        )
        return Force(-F_tail_wheel * j, chain)

    return Component("tail wheel", -b * i, law)


def disturbance() -> Component:
    """A side force on the vertical tail."""
    return Component("disturbance", -b * i, lambda velocity: Force(F_disturbance * j))
