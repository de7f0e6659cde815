"""A kick: what a side impulse changes at once, before any tire has moved."""

from __future__ import annotations

import sympy as sp
from sympy.physics.vector import Vector, cross

from groundroll.derive.core.body import Izz, m
from groundroll.derive.core.equation import Chain, Equation
from groundroll.derive.core.frames import i, j, k
from groundroll.derive.core.quantity import Quantity

S = Quantity("S", "impulse", "N s", "side impulse, to the right")
x_S = Quantity("x_S", "impulse_station", "m", "where it acts, ahead of the CG", "x_S")
dv = Quantity("dv", "lateral_velocity_change", "m/s", "what it adds to v", r"\Delta v")
dr = Quantity("dr", "yaw_rate_change", "rad/s", "what it adds to r", r"\Delta r")

#: What resists it.
INERTIA = (m, Izz)


def kick() -> Chain:
    """Momentum and angular momentum over a moment: integrals of Eq. 4.1."""
    impulse: Vector = S * j
    momentum = m * dv - impulse.dot(j)
    angular_momentum = Izz * dr - cross(x_S * i, impulse).dot(k)
    solution = sp.solve([momentum, angular_momentum], [dv, dr], dict=True)[0]
    return (
        Equation(dv, solution[dv], "Eq. 4.1, integrated"),
        Equation(dr, solution[dr], "Eq. 4.1, integrated"),
    )
