"""What toe-in does to an aircraft that rolls straight: the two terms of an old dispute.

With toe-in each main wheel points a little to the middle, and side forces that cancel stand on
both. In a sideslip two things happen. The outer and the inner wheel's forces no longer point
straight across, and the wheel that works harder is pulled back: that turns the nose to where the
aircraft goes, as those say who want toe-in. But the load moves to the leading wheel, whose toe
pushes the nose the other way, as those say who want toe-out. Which wins is a matter of track,
height, and how the cornering stiffness grows with load.
"""

from __future__ import annotations

from functools import cache

import sympy as sp

from groundroll.derive.core.body import Izz, m
from groundroll.derive.core.equation import Chain, Equation
from groundroll.derive.core.frames import r, v
from groundroll.derive.core.quantity import Quantity
from groundroll.derive.parts.gear import toe, track
from groundroll.derive.parts.quantities import B3, C3, C_alpha, Fz, a, b, h_cg, u

from .closed_forms import K

C_load = Quantity(
    "C_load",
    "stiffness_over_load",
    "1/rad",
    "change of the cornering stiffness of one main tire with its load",
    "C'",
)
toe_pull = Quantity(
    "toe_pull",
    "toe_pull",
    "N m/rad^2",
    "yaw stiffness that a radian of toe-in adds because forces point inward",
)
toe_load = Quantity(
    "toe_load",
    "toe_load",
    "N m/rad^2",
    "yaw stiffness that it takes because the load moves to the leading wheel",
)
toe_yaw_stiffness = Quantity(
    "toe_yaw_stiffness",
    "toe_yaw_stiffness",
    "N m/rad^2",
    "change of the yaw stiffness dN/dbeta with toe-in; a positive one turns the nose to where the"
    " aircraft goes",
)
toe_determinant = Quantity(
    "toe_determinant",
    "toe_determinant",
    "1/(rad s^2)",
    "change of det A with toe-in: positive moves the boundary of stability the good way",
)
RESULTS = (toe_pull, toe_load, toe_yaw_stiffness, toe_determinant)


def toe_effects() -> Chain:
    """What a little toe-in changes, to first order in it."""
    stiffness, determinant = _slopes()
    pull = track * C_alpha
    return (
        Equation(C_load, B3 + 2 * C3 * Fz, "Eqs. 3.2, 3.3"),
        Equation(toe_pull, pull, "forces along the fuselage"),
        Equation(toe_load, sp.factor(pull - stiffness), "loads moved by h / track"),
        Equation(toe_yaw_stiffness, toe_pull - toe_load, "definition"),
        Equation(toe_determinant, determinant, "from det A"),
    )


@cache
def _slopes() -> tuple[sp.Expr, sp.Expr]:
    """Derivatives by toe-in of dN/dbeta and of det A."""
    A = _matrix()
    yaw_stiffness = Izz * A[1, 0] * u  # dN/dbeta, beta = v / u
    return (
        sp.factor(yaw_stiffness.diff(toe).subs(toe, 0)),
        sp.factor(A.det().diff(toe).subs(toe, 0)),
    )


def _matrix() -> sp.Matrix:
    """A of the linear model with toed-in wheels between which the side force moves load.

    With toe-in e the wheels slip by alpha - e (left) and alpha + e (right); a side force S moves
    the load S h / track from the left to the right wheel, so F_main = 2 C alpha + 2 C' (h / track)
    S e. Forces across wheels that point inward have parts along the fuselage, track / 2 beside it.
    """
    alpha, gamma = (v + a * r) / u, (v - b * r) / u
    F_main, S = sp.symbols("F_main S")
    balance = [
        F_main - 2 * C_alpha * alpha - 2 * C_load * h_cg / track * S * toe,
        S - F_main - K * gamma,
    ]
    force = sp.solve(balance, [F_main, S], dict=True)[0]
    moment = -a * force[F_main] + b * K * gamma + track / 2 * toe * force[F_main]
    rates = sp.Matrix([-force[S] / m - u * r, moment / Izz])
    return rates.jacobian([v, r])
