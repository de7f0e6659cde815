"""A car on laws with corners: tires that let go, scrub, a brake that holds, walls."""

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
    Y,
    i,
    j,
)

a = Parameter("arm", "axle_arm", "m", "axles ahead of the CG and behind it", sign=">0")
C = Parameter("C", "stiffness", "N/rad", "of an axle", sign=">=0")
limit = Parameter("limit", "limit", "N", "largest side force of an axle", sign=">0")
scrub = Parameter("scrub", "scrub", "N s^2/m^2", "drag over velocity squared", sign=">=0")
hold = Parameter("hold", "hold", "N", "largest braking force", sign=">=0")
crawl = Parameter("crawl", "crawl", "m/s", "speed at which the brake takes half hold", sign=">0")
wall = Parameter("wall", "wall", "m", "distance of the walls", sign=">0")
k = Parameter("k_wall", "wall_stiffness", "N/m", "of the walls", sign=">=0")
steering = Input("steering", "steering", "rad", "of the front axle, to the right")
brake = Input("brake", "brake", "1", "1: hold")

alpha = Quantity("alpha", "slip", "rad", "slip angle, from -pi to pi")
F = Quantity("F", "side_force", "N", "side force, to the left")
D = Quantity("D", "drag", "N", "backward")
W = Quantity("W", "wall_force", "N", "of a wall, away from it, to the right")


def axle(angle):
    def law(felt):
        slip = sp.atan2(felt.velocity.dot(j), felt.velocity.dot(i)) - angle
        chain = (
            Equation(alpha, slip, "slip angle"),
            Equation(F, sp.Max(-limit, sp.Min(limit, C * alpha)), "lets go"),
        )
        return Force(-F * j, chain=chain)

    return law


def slows(felt):
    along, across = felt.velocity.dot(i), felt.velocity.dot(j)
    chain = (
        Equation(D, scrub * along * sp.Abs(along) + hold * brake * sp.tanh(along / crawl), "drag"),
        Equation(F, scrub * across**2 * sp.sign(across), "drag"),
    )
    return Force(-D * i - F * j, chain=chain)


def walls(felt):
    beyond = (k * (Y - wall), sp.Gt(Y, wall)), (k * (Y + wall), sp.Lt(Y, -wall)), (0, True)
    chain = (Equation(W, -sp.Piecewise(*beyond), "walls"),)
    return Force(W * felt.right, chain=chain)


corners = Model(
    "corners",
    "Two axles that let go, a brake that holds, between walls.",
    body=Body(speed="free", stands="level"),
    parts=[
        Part("front", a * i, axle(steering), asks=(steering,), kind="wheel"),
        Part("rear", -a * i, axle(0), kind="wheel"),
        Part("slower", 0 * i, slows, asks=(brake,)),
        Part("walls", 0 * i, walls, suffix=""),
    ],
)
