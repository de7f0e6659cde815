"""A car with left and right wheels and brakes: its speed falls, its loads stay."""

import sympy as sp

from groundroll.derive import Body, Equation, Force, Input, Model, Parameter, Part, Quantity, i, j

a = Parameter("l_front", "front_arm", "m", "front axle ahead of the CG", sign=">0")
b = Parameter("l_rear", "rear_arm", "m", "rear axle behind the CG", sign=">0")
track = Parameter("width", "track_width", "m", "left to right wheel", sign=">=0")
C_front = Parameter("C_front", "front_stiffness", "N/rad", "of the front axle", sign=">=0")
C_rear = Parameter("C_rear", "rear_stiffness", "N/rad", "of the rear axle", sign=">=0")
mu = Parameter("grip", "grip", "1", "largest braking force over load", sign=">=0")
load = Parameter("wheel_load", "wheel_load", "N", "on each wheel", sign=">=0")
steering = Input("steering", "steering", "rad", "of the front wheels, to the right")
brakes = {
    side: Input(f"brake_{side}", f"brake_{side}", "1", f"{side} brakes, 0 to 1")
    for side in ("left", "right")
}

alpha = Quantity("alpha", "slip", "rad", "slip angle", r"\alpha")
F = Quantity("F", "side_force", "N", "side force, to the left of the wheel")
B = Quantity("B", "braking_force", "N", "backward along the wheel")


def wheel(stiffness, angle, brake):
    def law(felt):
        along, across = felt.velocity.dot(i), felt.velocity.dot(j)
        chain = (
            Equation(alpha, sp.atan2(across, along) - angle, "slip angle"),
            Equation(F, stiffness / 2 * alpha, "linear tire"),
            Equation(B, mu * load * brake * sp.sign(along), "brake"),
        )
        heading = sp.cos(angle) * i + sp.sin(angle) * j
        right = -sp.sin(angle) * i + sp.cos(angle) * j
        return Force(-F * right - B * heading, chain=chain)

    return law


four_wheels = Model(
    "four_wheels",
    "Four wheels, brakes left and right, a speed that falls.",
    body=Body(speed="free", stands="level"),
    parts=[
        Part(
            f"{end}_{side}",
            at * i + sign * track / 2 * j,
            wheel(stiffness, steering if end == "front" else 0, brakes[side]),
            asks=(steering, brakes[side]),
            kind="wheel",
        )
        for end, at, stiffness in (("front", a, C_front), ("rear", -b, C_rear))
        for side, sign in (("left", -1), ("right", 1))
    ],
)
