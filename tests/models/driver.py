"""A car that somebody steers: what the driver turns is no input of the model any more."""

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
    Y,
    i,
    j,
    psi,
)

a = Parameter("l_front", "front_arm", "m", "front axle ahead of the CG", sign=">0")
b = Parameter("l_rear", "rear_arm", "m", "rear axle behind the CG", sign=">0")
C_front = Parameter("C_front", "front_stiffness", "N/rad", "of the front axle", sign=">=0")
C_rear = Parameter("C_rear", "rear_stiffness", "N/rad", "of the rear axle", sign=">=0")
K_psi = Parameter("K_psi", "heading_gain", "1", "steering over heading")
K_Y = Parameter("K_Y", "offset_gain", "rad/m", "steering over offset")
T = Parameter("T_driver", "driver_lag", "s", "of the driver", sign=">0")
steering = Input("steering", "steering", "rad", "of the front axle, to the right")
lane = Input("lane", "lane", "m", "offset that the driver wants")

alpha = Quantity("alpha", "slip", "rad", "slip angle")
F = Quantity("F", "side_force", "N", "side force, to the left")
turned = State("turned", "turned_wheel", "rad", "where the hands are")


def axle(stiffness, angle):
    def law(felt):
        slip = sp.atan(felt.velocity.dot(j) / felt.velocity.dot(i)) - angle
        chain = (Equation(alpha, slip, "slip angle"), Equation(F, stiffness * alpha, "linear tire"))
        return Force(-F * j, chain=chain)

    return law


def drives(felt):
    wanted = -K_psi * psi - K_Y * (Y - lane)
    return Force(
        chain=(Equation(steering, turned, "driver"),), rates={turned: (wanted - turned) / T}
    )


driver = Model(
    "driver",
    "A single-track car and a driver who holds a lane.",
    body=Body(speed="held", stands="level"),
    parts=[
        Part("front", a * i, axle(C_front, steering), asks=(steering,), kind="wheel"),
        Part("rear", -b * i, axle(C_rear, 0), kind="wheel"),
        Part("hands", 0 * i, drives, asks=(lane,), suffix="", kind=""),
    ],
)
