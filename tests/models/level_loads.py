"""A winged car whose loads follow from the balance of a level body."""

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
    i,
    j,
    k,
    u,
)

a = Parameter("l_front", "front_arm", "m", "front axle ahead of the CG", sign=">0")
b = Parameter("l_rear", "rear_arm", "m", "rear wheel behind the CG", sign=">0")
t = Parameter("half", "half_track", "m", "front wheels beside the middle", sign=">0")
z = Parameter("z_ground", "cg_height", "m", "CG above the ground", sign=">0")
mu = Parameter("grip", "grip", "1", "braking force over load", sign=">=0")
C = Parameter("C_load", "stiffness_over_load", "1/rad", "cornering stiffness over load", sign=">=0")
L_q = Parameter("L_q", "lift_over_speed_squared", "N s^2/m^2", "upward")
x_w = Parameter("x_wing", "wing_arm", "m", "wing ahead of the CG")
M_q = Parameter("M_q", "pitch_over_speed_squared", "N s^2/m", "nose up")
z_p = Parameter("z_thrust", "thrust_height", "m", "line of the thrust above the CG")
thrust = Input("thrust", "thrust", "N", "forward")
brake = Input("brake", "brake", "1", "of all wheels")

alpha = Quantity("alpha", "slip", "rad", "slip angle")
F = Quantity("F", "side_force", "N", "side force, to the left")
B = Quantity("B", "braking_force", "N", "backward")
lift = Quantity("lift", "lift", "N", "upward")


def wheel(felt):
    along, across = felt.velocity.dot(i), felt.velocity.dot(j)
    chain = (
        Equation(alpha, sp.atan2(across, along), "slip angle"),
        Equation(F, C * felt.load * alpha, "tire"),
        Equation(B, mu * felt.load * brake, "brake"),
    )
    return Force(-F * j - B * i, chain=chain, shown=(felt.load, F, B))


def wing(felt):
    chain = (Equation(lift, L_q * u**2, "wing"),)
    return Force(-lift * felt.down, M_q * u**2 * j, chain=chain)


level_loads = Model(
    "level_loads",
    "A level body on three wheels under a wing, pushed by a propeller.",
    body=Body(speed="free", stands="level"),
    parts=[
        Part("left", a * i - t * j + z * k, wheel, asks=(brake,), kind="wheel"),
        Part("right", a * i + t * j + z * k, wheel, asks=(brake,), kind="wheel"),
        Part("rear", -b * i + z * k, wheel, asks=(brake,), kind="wheel"),
        Part("wing", x_w * i, wing, suffix=""),
        Part("propeller", -z_p * k, lambda felt: Force(thrust * i), asks=(thrust,)),
    ],
)
