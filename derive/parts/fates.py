"""What may become of a roll: parts that watch, and do nothing."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp
from sympy.physics.vector import Vector

from groundroll.derive.core.equation import Equation
from groundroll.derive.core.frames import Y, i, j, k, psi
from groundroll.derive.core.part import Event, Felt, Force, Part
from groundroll.derive.core.quantity import Constant, Parameter, Quantity

from .airframe import span
from .gear import a_third, z_main, z_third
from .quantities import a
from .stations import propeller_diameter, x_propeller, x_tip, z_thrust, z_tip

width = Parameter("runway_width", "runway_width", "m", "between the edges", sign=">0")
v_stop = Parameter("v_stop", "stopping_speed", "m/s", "slower than this it has stopped", sign=">0")
psi_loop = Parameter(
    "psi_loop", "ground_loop_heading", "rad", "a heading beyond this is a ground loop", sign=">0"
)

#: Near rest a speed is rounded in this.
STILL = Constant(1e-6, "m/s")

V_ground = Quantity("V_ground", "ground_speed", "m/s", "of the CG over the ground")
above_stop = Quantity("above_stop", "speed_above_stop", "m/s", "speed above that of a stop")
beyond_edge = Quantity("beyond_edge", "beyond_edge", "m", "the CG beyond an edge of the runway")
beyond_loop = Quantity("beyond_loop", "beyond_loop", "rad", "the heading beyond its limit")
ahead = Quantity("ahead", "wheels_ahead", "m", "foremost wheels ahead of the CG over the ground")
height = Quantity("height", "height", "m", "above the runway")

STOPPED = Event("stopped", above_stop, False, "it has stopped")
RAN_OFF = Event("ran_off", beyond_edge, True, "the CG leaves the runway at its side")
GROUND_LOOP = Event("ground_loop", beyond_loop, True, "the heading goes beyond its limit")
NOSED_OVER = Event("nosed_over", ahead, False, "the CG goes ahead of all wheels")
STRUCK = Event("struck", height, False, "it touches the ground")


def path() -> Part:
    """How fast, how far across and how far turned."""

    def law(felt: Felt) -> Force:
        along, across = felt.velocity.dot(felt.forward), felt.velocity.dot(felt.right)
        chain = (
            Equation(V_ground, sp.sqrt(along**2 + across**2 + STILL**2), "Eq. 4.3"),
            Equation(above_stop, V_ground - v_stop, "definition"),
            Equation(beyond_edge, sp.Abs(Y) - width / 2, "definition"),
            Equation(beyond_loop, sp.Abs(psi) - psi_loop, "definition"),
        )
        return Force(chain=chain, shown=(V_ground,), events=(STOPPED, RAN_OFF, GROUND_LOOP))

    return Part("path", Vector(0), law, suffix="", kind="")


def support() -> Part:
    """How far the foremost wheels are ahead of the CG in the attitude in which it rolls.

    An aircraft whose CG has come ahead of all its wheels goes over: a taildragger over its main
    wheels, a tricycle over its nose wheel.
    """

    def law(felt: Felt) -> Force:
        pitched = i.dot(felt.down)
        along = (i - pitched * felt.down) / sp.sqrt(1 - pitched**2)
        third = (a_third * i + z_third * k).dot(along)
        chain = (Equation(ahead, sp.Max(felt.position.dot(along), third), "geometry"),)
        return Force(chain=chain, shown=(), events=(NOSED_OVER,))

    return Part("support", a * i + z_main * k, law, suffix="", kind="")


def strikes() -> Sequence[Part]:
    """Places that should not touch the ground: wing tips and propeller."""

    def law(felt: Felt) -> Force:
        assert felt.depth is not None
        chain = (Equation(height, -felt.depth, "geometry"),)
        return Force(chain=chain, shown=(height,), events=(STRUCK,))

    return [
        Part("left_tip", x_tip * i - span / 2 * j + z_tip * k, law, kind=""),
        Part("right_tip", x_tip * i + span / 2 * j + z_tip * k, law, kind=""),
        Part(
            "propeller_tip", x_propeller * i + (z_thrust + propeller_diameter / 2) * k, law, kind=""
        ),
    ]
