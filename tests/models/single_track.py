"""A single-track car with front steering: W. F. Milliken and D. L. Milliken, ch. 5."""

import sympy as sp

from groundroll.derive import Body, Equation, Force, Input, Model, Parameter, Part, Quantity, i, j

a = Parameter("l_front", "front_arm", "m", "front axle ahead of the CG", sign=">0")
b = Parameter("l_rear", "rear_arm", "m", "rear axle behind the CG", sign=">0")
C_front = Parameter("C_front", "front_stiffness", "N/rad", "of the front axle", sign=">=0")
C_rear = Parameter("C_rear", "rear_stiffness", "N/rad", "of the rear axle", sign=">=0")
steering = Input("steering", "steering", "rad", "of the front wheels, to the right")

alpha = Quantity("alpha", "slip", "rad", "slip angle", r"\alpha")
F = Quantity("F", "side_force", "N", "side force, to the left")


def axle(stiffness, angle):
    def law(felt):
        slip = sp.atan(felt.velocity.dot(j) / felt.velocity.dot(i)) - angle
        chain = (Equation(alpha, slip, "slip angle"), Equation(F, stiffness * alpha, "linear tire"))
        return Force(-F * j, chain=chain)

    return law


single_track = Model(
    "single_track",
    "Two axles, the front one steered.",
    body=Body(speed="held", stands="level"),
    parts=[
        Part("front", a * i, axle(C_front, steering), asks=(steering,), kind="wheel"),
        Part("rear", -b * i, axle(C_rear, 0), kind="wheel"),
    ],
)
