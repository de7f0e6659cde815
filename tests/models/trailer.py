"""A car with a trailer, whose mass is felt by a force that is linear in the accelerations."""

import sympy as sp

from groundroll.derive import (
    Body,
    Equation,
    Force,
    Input,
    Model,
    Parameter,
    Part,
    Quantity,
    State,
    i,
    j,
    k,
)
from groundroll.derive.core.body import r_dot
from groundroll.derive.core.frames import r

a = Parameter("l_front", "front_arm", "m", "front axle ahead of the CG", sign=">0")
b = Parameter("l_rear", "rear_arm", "m", "rear axle behind the CG", sign=">0")
C_front = Parameter("C_front", "front_stiffness", "N/rad", "of the front axle", sign=">=0")
C_rear = Parameter("C_rear", "rear_stiffness", "N/rad", "of the rear axle", sign=">=0")
h = Parameter("l_hitch", "hitch_arm", "m", "hitch behind the CG of the car", sign=">0")
l_t = Parameter("l_trailer", "trailer_arm", "m", "CG of the trailer behind the hitch", sign=">0")
L_t = Parameter("l_axle", "trailer_axle", "m", "axle of the trailer behind the hitch", sign=">0")
m_t = Parameter("m_trailer", "trailer_mass", "kg", "of the trailer", sign=">0")
I_t = Parameter("I_trailer", "trailer_inertia", "kg m^2", "about its CG", sign=">0")
C_t = Parameter("C_trailer", "trailer_stiffness", "N/rad", "of its axle", sign=">=0")
steering = Input("steering", "steering", "rad", "of the front axle, to the right")

alpha = Quantity("alpha", "slip", "rad", "slip angle")
F = Quantity("F", "side_force", "N", "side force, to the left of the wheel")
bend = State("bend", "articulation", "rad", "heading of the trailer less that of the car")
bending = State("bending", "articulation_rate", "rad/s", "rate of the articulation")
turning = Quantity("turning", "trailer_acceleration", "rad/s^2", "yaw acceleration of the trailer")


def axle(stiffness, angle):
    def law(felt):
        slip = sp.atan2(felt.velocity.dot(j), felt.velocity.dot(i)) - angle
        chain = (Equation(alpha, slip, "slip angle"), Equation(F, stiffness * alpha, "linear tire"))
        return Force(-F * (sp.cos(angle) * j - sp.sin(angle) * i), chain=chain)

    return law


def towed(felt):
    """Newton and Euler of the trailer by itself; what is left at the hitch pulls the car."""
    along, across = sp.cos(bend) * i + sp.sin(bend) * j, sp.cos(bend) * j - sp.sin(bend) * i
    spin = r + bending
    at_axle = felt.velocity - L_t * spin * across
    lever = I_t + m_t * l_t**2
    chain = (
        Equation(alpha, sp.atan2(at_axle.dot(across), at_axle.dot(along)), "slip angle"),
        Equation(F, C_t * alpha, "linear tire"),
        Equation(
            turning, (m_t * l_t * felt.acceleration.dot(across) + L_t * F) / lever, "moments, hitch"
        ),
    )
    acceleration = felt.acceleration - l_t * turning * across + l_t * spin**2 * along
    return Force(
        -m_t * acceleration - F * across,
        chain=chain,
        rates={bend: bending, bending: turning - r_dot},
        shown=(alpha, F),
    )


trailer = Model(
    "trailer",
    "A single-track car and a trailer with one axle.",
    body=Body(speed="free", stands="level"),
    parts=[
        Part("front", a * i, axle(C_front, steering), asks=(steering,), kind="wheel"),
        Part("rear", -b * i, axle(C_rear, 0), kind="wheel"),
        Part("hitch", -h * i + 0 * k, towed),
    ],
)
