"""The leg of a wheel: a spring and a damper along the body's z axis."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp
from sympy.physics.vector import Vector, cross

from groundroll.derive.core.equation import Chain, Equation
from groundroll.derive.core.frames import along_body, components, k
from groundroll.derive.core.part import Felt, Fz
from groundroll.derive.core.quantity import Constant, Quantity
from groundroll.derive.core.rounded import ramp, step

#: A leg stiffens over this stroke, and lets go of the ground over this times its stiffness.
ROUNDING = Constant(1e-4, "m")

tilt = Quantity("tilt", "tilt", "1", "cosine of the angle from the body's z axis to the vertical")
depth = Quantity("depth", "wheel_depth", "m", "the unloaded wheel below the runway")
stroke = Quantity("stroke", "stroke", "m", "of the leg, along the body's z axis", "s")
foot_u = Quantity("foot_u", "foot_speed", "m/s", "velocity of the foot of the leg along x")
foot_v = Quantity("foot_v", "foot_drift", "m/s", "its velocity along y")
foot_w = Quantity("foot_w", "foot_heave", "m/s", "its velocity along z")
sinking = Quantity("sinking", "sink_rate", "m/s", "downward velocity of the foot of the leg")
touching = Quantity("touching", "touching", "1", "1 on the ground, 0 above it, rounded between")
F_leg = Quantity("F_leg", "leg_force", "N", "spring and damper, along the leg", r"F_{\mathrm{leg}}")


@dataclass(frozen=True)
class Leg:
    """Stiffness per stroke, N/m, and damping per stroke rate, N s/m."""

    stiffness: Quantity
    damping: Quantity


@dataclass(frozen=True)
class Foot:
    """Where a wheel meets the runway.

    Attributes
    ----------
    at : Vector
        From the CG to the ground, at the end of the stroked leg.
    velocity : Vector
        Of the point of the body that is there.
    chain : tuple of Equation
        What the load on the wheel is made of; the balance of a level body gives it otherwise.
    """

    at: Vector
    velocity: Vector
    chain: Chain = ()


def stand(felt: Felt, leg: Leg) -> Foot:
    """A wheel on the runway: the load normal to it, from the depth of the wheel below it.

    The leg moves along the body's z axis until the wheel is on the ground, so its stroke is the
    depth over the tilt. Its force along the body gives the load normal to the runway: the rest of
    it is carried by the leg's bearings. The point of the body at the foot sinks by the rate of the
    stroke times the tilt, so what the load does is what spring and damper do: energy is kept.
    The load is nothing where the wheel is above the ground, and it never pulls.
    """
    if felt.depth is None:
        return Foot(felt.position, felt.velocity)
    velocity = components(felt.velocity - cross(felt.rates, stroke * k))
    foot = along_body(sp.Matrix([foot_u, foot_v, foot_w]))
    chain = (
        Equation(tilt, felt.down.dot(k), "direction cosine"),
        Equation(depth, felt.depth, "geometry"),
        Equation(stroke, depth / tilt, "geometry"),
        *(
            Equation(name, value, "Eq. 4.10 at the foot")
            for name, value in zip((foot_u, foot_v, foot_w), velocity, strict=True)
        ),
        Equation(sinking, foot.dot(felt.down), "direction cosines"),
        Equation(touching, step(stroke, ROUNDING), "nothing above the ground"),
        Equation(
            F_leg,
            touching * (leg.stiffness * stroke + leg.damping * sinking / tilt),
            "spring and damper",
        ),
        Equation(Fz, ramp(F_leg, leg.stiffness * ROUNDING) / tilt, "a leg never pulls"),
    )
    return Foot(felt.position - stroke * k, foot, chain)
