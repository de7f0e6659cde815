"""Newton's second law in the rotating aircraft frame (Section 4.3)."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp
from sympy.physics.vector import Vector, cross

from .components import Component, Force
from .equation import Chain, Equation, merge
from .kinematics import accelerations, j, k, velocity
from .quantities import Izz, Quantity, m

sum_F = Quantity("sum_F", "side_force", "N", "sum of the forces along y", r"\sum F_y")
sum_M = Quantity(
    "sum_M", "yaw_moment", "N m", "sum of the moments about z through the CG", r"\sum M_z"
)
a_y = Quantity("a_y", "lateral_acceleration", "m/s^2", "acceleration of the CG along y", "a_y")
v_dot = Quantity("v_dot", "lateral_velocity_rate", "m/s^2", "time derivative of v", r"\dot{v}")
r_dot = Quantity("r_dot", "yaw_acceleration", "rad/s^2", "time derivative of r", r"\dot{r}")


def equations_of_motion(components: Sequence[Component]) -> Chain:
    """From components to v_dot and r_dot, every quantity on the way named.

    The balance is solved with the forces as symbols: what they depend on stays in the chain
    above and is never multiplied out.
    """
    forces = [(part.position, part.law(velocity(part.position))) for part in components]
    laws = merge(equation for _, force in forces for equation in force.chain)
    return (*laws, *_sums(forces), *_newton())


def _sums(forces: Sequence[tuple[Vector, Force]]) -> Chain:
    """Sum of forces and of moments R x F about the CG."""
    side_force = sum((force.vector.dot(j) for _, force in forces), sp.Integer(0))
    yaw_moment = sum((cross(arm, force.vector).dot(k) for arm, force in forces), sp.Integer(0))
    return (
        Equation(sum_F, side_force, "Eq. 4.8"),
        Equation(sum_M, yaw_moment, "Eq. 4.8"),
    )


def _newton() -> Chain:
    """sum F = dG/dt and sum M = dH/dt (Eq. 4.1), solved for the accelerations (Eq. 4.9)."""
    acceleration, angular_acceleration = accelerations(v_dot, r_dot)
    momentum_rate = (m * acceleration).dot(j)  # Eq. 4.2
    angular_momentum_rate = (Izz * angular_acceleration).dot(k)
    solution = sp.solve(
        [momentum_rate - sum_F, angular_momentum_rate - sum_M], [v_dot, r_dot], dict=True
    )[0]
    return (
        Equation(v_dot, sp.expand(solution[v_dot]), "Eq. 4.9"),
        Equation(r_dot, solution[r_dot], "Eq. 4.9"),
        Equation(a_y, acceleration.dot(j), "Eq. 4.7"),
    )
