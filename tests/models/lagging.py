"""An aircraft whose tail lags: its side force follows the angle with a time constant."""

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
)

a = Parameter("arm", "gear_arm", "m", "main gear ahead of the CG")
b = Parameter("tail", "tail_distance", "m", "tail behind the CG", sign=">0")
C_main = Parameter("C_main", "main_stiffness", "N/rad", "of the main gear", sign=">=0")
C_tail = Parameter("C_tail", "tail_stiffness", "N/rad", "of the tail", sign=">=0")
lag = Parameter("lag", "tail_lag", "s", "of the force on the tail", sign=">0")
push = Input("push", "push", "N", "on the tail, to the right")

alpha = Quantity("alpha", "slip", "rad", "slip angle")
F = Quantity("F", "side_force", "N", "side force, to the left")
late = State("late", "late_slip", "rad", "slip angle as the flow follows it")


def gear(felt):
    slip = sp.atan(felt.velocity.dot(j) / felt.velocity.dot(i))
    chain = (Equation(alpha, slip, "slip angle"), Equation(F, C_main * sp.tanh(alpha), "tire"))
    return Force(-F * j, chain=chain)


def tail(felt):
    slip = sp.atan(felt.velocity.dot(j) / felt.velocity.dot(i))
    chain = (Equation(alpha, slip, "slip angle"), Equation(F, C_tail * late, "lagging tail"))
    return Force(-F * j, chain=chain, rates={late: (alpha - late) / lag})


lagging = Model(
    "lagging",
    "Main gear and a tail whose force lags.",
    body=Body(speed="held", stands="level"),
    parts=[
        Part("gear", a * i, gear, kind="wheel"),
        Part("tail", -b * i, tail, kind="fin"),
        Part("pusher", -b * i, lambda felt: Force(push * j), asks=(push,)),
    ],
)
