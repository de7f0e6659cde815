"""What limits an aircraft that is held straight: loads that move, friction, and a clause's wind."""

from __future__ import annotations

import sympy as sp

from groundroll.derive.core.body import CARRIED, g, m
from groundroll.derive.core.equation import Chain, Equation
from groundroll.derive.core.part import Fz
from groundroll.derive.core.quantity import Constant, Quantity
from groundroll.derive.parts.airframe import CL_max, S
from groundroll.derive.parts.friction import LEAST
from groundroll.derive.parts.gear import surface, track
from groundroll.derive.parts.quantities import B5, C5, rho
from groundroll.derive.parts.tires import mu
from groundroll.derive.parts.wheel import F_x, F_y

Mx_held = CARRIED[3]
Fz_left, Fz_right = Fz.of("left"), Fz.of("right")
N_left = Quantity("N_left", "carried_left", "N", "load on the left wheel of a body that rolls")
N_right = Quantity("N_right", "carried_right", "N", "load on the right wheel of a body that rolls")
used = Quantity("used", "friction_used", "1", "force of a tire over its friction")
V_stall = Quantity("V_stall", "stall_speed", "m/s", "1 g, at the largest lift of the wing")
wind_large = Quantity(
    "wind_large", "transport_wind", "m/s", "90 deg wind of 14 CFR 25.233(a), by this stall speed"
)
wind_small = Quantity(
    "wind_small", "small_wind", "m/s", "90 deg wind of the former 14 CFR 23.233(a)"
)
KNOT = Constant(1852 / 3600, "m/s")

LOADS = (Fz_left, Fz_right, Mx_held, track)
TIRE = (F_x, F_y, Fz, B5, C5, surface("left"))
STALL = (m, g, rho, S, CL_max)


def moved_loads() -> Chain:
    """A level body's main wheels carry its roll couple by a difference of their loads."""
    return (
        Equation(N_left, Fz_left + Mx_held / track, "balance of roll moments"),
        Equation(N_right, Fz_right - Mx_held / track, "balance of roll moments"),
    )


def friction_used() -> Chain:
    """How much of its friction a main tire makes, along and across; 1: it slides."""
    friction = sp.Max(LEAST, B5 + C5 * Fz) * surface("left")
    force = sp.sqrt(F_x**2 + F_y**2)
    return (
        Equation(mu, friction, "Eq. 3.5"),
        Equation(used, force / (mu * sp.Max(Fz, Constant(1.0, "N"))), "definition"),
    )


def clause_winds() -> Chain:
    """The winds in which an aircraft may not ground-loop, by its stall speed.

    14 CFR 25.233(a): 20 kt or 0.2 V_SR0, whichever is greater, but no more than 25 kt; the former
    23.233(a): 0.2 V_S0.
    """
    fifth = V_stall / 5
    return (
        Equation(V_stall, sp.sqrt(2 * m * g / (rho * S * CL_max)), "lift carries the weight"),
        Equation(wind_large, sp.Min(25 * KNOT, sp.Max(20 * KNOT, fifth)), "14 CFR 25.233(a)"),
        Equation(wind_small, fifth, "14 CFR 23.233(a), before amendment 23-64"),
    )
