"""Fin and tailplane at their own stations, in the propeller's slipstream, and the propeller."""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp
from sympy.physics.vector import Vector

from groundroll.derive.core.equation import Chain, Equation
from groundroll.derive.core.frames import i, j, k
from groundroll.derive.core.part import Felt, Force, Law
from groundroll.derive.core.quantity import Constant, Parameter, Quantity
from groundroll.derive.core.rounded import clipped, ramp

from .controls import elevator, pedal, rudder, thrust
from .quantities import Ap, CL_gamma, rho

A_disc = Parameter("A_disc", "propeller_disc_area", "m^2", "of the propeller", sign=">0")
rudder_max = Parameter("rudder_max", "rudder_travel", "rad", "deflection at full pedal")
tau_rudder = Parameter(
    "tau_rudder", "rudder_effectiveness", "1", "angle of the fin that a rudder's is worth"
)
CL_fin = Parameter("CL_fin", "fin_stall", "1", "lift coefficient at which it stalls", sign=">0")
fin_apart = Parameter(
    "fin_apart", "fin_apart", "1", "1: the derivatives leave the fin out; 0: they hold it"
)
S_h = Parameter("S_h", "tailplane_area", "m^2", "of tailplane and elevator", sign=">=0")
CL_h = Parameter("CL_h", "tailplane_lift_slope", "1/rad", "of the tailplane", sign=">=0")
CL_h_max = Parameter(
    "CL_h_max", "tailplane_stall", "1", "lift coefficient at which it stalls", sign=">0"
)
tau_elevator = Parameter(
    "tau_elevator", "elevator_effectiveness", "1", "angle of the tailplane worth an elevator's"
)
i_h = Parameter("i_h", "tailplane_incidence", "rad", "against the body's x axis, nose up")
downwash = Parameter("downwash", "downwash_slope", "1", "of the wing at the tailplane, near ground")
tailplane_apart = Parameter(
    "tailplane_apart", "tailplane_apart", "1", "1: the derivatives leave the tailplane out"
)

#: Width in which a slipstream that just reaches nothing is rounded, and in which lift stalls.
STILL = Constant(0.001, "m/s")
#: Density below which a thrust is no longer the air's.
THIN = Constant(1e-6, "kg/m^3")
STALL = sp.Rational(1, 5)

delta_rudder = Quantity(
    "delta_rudder", "rudder_angle", "rad", "of the rudder, trailing edge left", r"\delta_r"
)
V_axial = Quantity("V_axial", "axial_speed", "m/s", "of the air along x, as the aircraft flies")
V_s = Quantity("V_s", "slipstream_speed", "m/s", "of the air behind the propeller", "V_s")
V_side = Quantity("V_side", "side_speed", "m/s", "across the fin, to its right")
V_down = Quantity("V_down", "down_speed", "m/s", "across the tailplane, downward")
gamma = Quantity("gamma", "incidence", "rad", "angle of incidence in the air", r"\gamma")
C_L = Quantity("C_L", "lift_coefficient", "1", "to the left of a fin, up of a tailplane", "C_L")
F_L = Quantity("F_L", "lift", "N", "to the left of a fin, up of a tailplane", "F_L")


def stalled(lift: sp.Expr, limit: sp.Expr) -> sp.Expr:
    """A lift coefficient that stalls smoothly at a limit, either way."""
    return clipped(lift, limit, STALL)


def slipstream(axial: sp.Expr) -> Chain:
    """Axial speed far behind the propeller by momentum theory, and none against it."""
    still = sp.sqrt(V_axial**2 + STILL**2)
    V2 = V_axial * still + 2 * thrust / (A_disc * sp.sqrt(rho**2 + THIN**2))
    return (
        Equation(V_axial, axial, "Eq. 4.10 through the air"),
        Equation(V_s, sp.sqrt(ramp(V2, STILL**2) + STILL**2), "momentum theory"),
    )


def fin(felt: Felt) -> Force:
    """The vertical tail with its rudder, the thesis's Eq. 4.29 with both of its velocities."""
    chain = (
        *slipstream(felt.air_velocity.dot(i)),
        Equation(V_side, felt.air_velocity.dot(j), "Eq. 4.10 through the air"),
        Equation(gamma, sp.atan2(V_side, V_s), "Eq. 4.19"),
        Equation(delta_rudder, rudder - rudder_max * pedal, "linkage"),
        Equation(C_L, stalled(CL_gamma * (gamma - tau_rudder * delta_rudder), CL_fin), "stall"),
        Equation(
            F_L,
            fin_apart * sp.Rational(1, 2) * rho * (V_s**2 + V_side**2) * Ap * C_L,
            "Eq. 4.29",
        ),
    )
    return Force(-F_L * j, chain=chain, shown=(gamma, C_L, F_L))


def tailplane(incidence: sp.Expr = sp.S.Zero) -> Law:
    """The tailplane with its elevator; `incidence` is that of a level body."""

    def law(felt: Felt) -> Force:
        angle = (sp.atan2(V_down, V_s) + incidence) * (1 - downwash) + i_h
        chain = (
            *slipstream(felt.air_velocity.dot(i)),
            Equation(V_down, felt.air_velocity.dot(k), "Eq. 4.10 through the air"),
            Equation(gamma, angle + tau_elevator * elevator, "geometry"),
            Equation(C_L, stalled(CL_h * gamma, CL_h_max), "stall"),
            Equation(
                F_L,
                tailplane_apart * sp.Rational(1, 2) * rho * (V_s**2 + V_down**2) * S_h * C_L,
                "lift",
            ),
        )
        return Force(-F_L * k, chain=chain, shown=(gamma, C_L, F_L))

    return law


def propeller(felt: Felt) -> Force:
    """Thrust along x. Torque, P-factor and gyroscopic couple are left out."""
    return Force(thrust * i)


#: A force at a place, whatever is felt.
Push = Callable[[Quantity], Law]


def push(force: Quantity, along: Vector) -> Law:
    """An input that pushes along a unit vector of the body."""
    return lambda felt: Force(force * along)
