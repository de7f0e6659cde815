"""A free body on three legs with a load on top, whose mass is felt by its acceleration."""

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
)
from groundroll.derive.core.body import g

x = Parameter("x_leg", "leg_arm", "m", "front legs ahead of the CG, rear leg behind", sign=">0")
y = Parameter("y_leg", "leg_side", "m", "front legs beside the CG", sign=">0")
z = Parameter("z_leg", "leg_length", "m", "feet below the CG", sign=">0")
stiffness = Parameter("k_leg", "leg_stiffness", "N/m", "of a leg", sign=">=0")
damping = Parameter("c_leg", "leg_damping", "N s/m", "of a leg", sign=">=0")
rubbing = Parameter("d_foot", "foot_drag", "N s/m", "of a foot over the ground", sign=">=0")
load = Parameter("m_load", "load_mass", "kg", "of the load", sign=">=0")
x_load = Parameter("x_load", "load_arm", "m", "of the load ahead of the CG")
y_load = Parameter("y_load", "load_side", "m", "of the load right of the CG")
z_load = Parameter("z_load", "load_height", "m", "of the load above the CG")
push = Input("push", "forward_push", "N", "on the load, along the runway")

depth = Quantity("depth", "foot_depth", "m", "of the foot below the ground")
sink = Quantity("sink", "sink_rate", "m/s", "of the foot")
N = Quantity("N", "leg_force", "N", "upward")


def leg(felt):
    chain = (
        Equation(depth, felt.depth, "geometry"),
        Equation(sink, felt.velocity.dot(felt.down), "geometry"),
        Equation(N, stiffness * depth + damping * sink, "spring and damper"),
    )
    over_ground = felt.velocity - sink * felt.down
    return Force(-N * felt.down - rubbing * over_ground, chain=chain, shown=(N,))


def carried(felt):
    return Force(load * (g * felt.down - felt.acceleration) + push * felt.forward)


table = Model(
    "table",
    "A rigid body on three sprung legs, with a mass on top of it.",
    body=Body(speed="free", stands="on legs"),
    parts=[
        Part("left", x * i - y * j + z * k, leg, kind="wheel"),
        Part("right", x * i + y * j + z * k, leg, kind="wheel"),
        Part("behind", -x * i + z * k, leg, kind="wheel"),
        Part("top", x_load * i + y_load * j - z_load * k, carried, asks=(push,)),
    ],
)
