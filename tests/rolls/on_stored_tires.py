"""The landing roll on the tires of the stored runs: JSBSim's own, or tables of straight lines."""

from dataclasses import replace
from itertools import pairwise
from math import degrees

import sympy as sp

from groundroll.derive.core.equation import Equation
from groundroll.derive.core.quantity import Parameter
from groundroll.derive.models.landing_roll import LANDING_ROLL
from groundroll.derive.models.rolling import wheels
from groundroll.derive.parts.friction import alpha, grip, radt
from groundroll.derive.parts.gear import surface
from groundroll.derive.parts.third_wheel import third_wheel
from groundroll.derive.parts.tires import mu

#: Side force over load at slip angles in degrees: run G6's main wheels, and its tail wheel.
MAIN = ((0, 0), (2, 0.24), (4, 0.42), (6, 0.54), (10, 0.66), (15, 0.72), (25, 0.75), (90, 0.7))
TAIL = ((0, 0), (2, 0.12), (4, 0.22), (6, 0.3), (10, 0.42), (15, 0.5), (25, 0.56), (90, 0.5))

tabled = Parameter("tabled", "tabled", "1", "1: tires are tables; 0: a formula of the slip angle")


def tire(name, points):
    """JSBSim's own tire, its slip an angle, or a table."""
    own = radt(surface(name), "third" * (name == "third"), measure=alpha)
    size = sp.Abs(alpha) * degrees(1.0)
    lines = [
        (low + (high - low) * (size - start) / (stop - start), size <= stop)
        for (start, low), (stop, high) in pairwise(points)
    ]
    table = sp.sign(alpha) * sp.Piecewise(*lines, (points[-1][1], True)) / mu

    def chain(load):
        *before, last = own(load)
        return (*before, Equation(grip, (1 - tabled) * last.rhs + tabled * table, "either"))

    return chain


rolling = wheels(third_wheel(), lambda name: tire(name, MAIN), tire("third", TAIL))
on_stored_tires = replace(
    LANDING_ROLL,
    name="on_stored_tires",
    summary="The landing roll on the tires of the stored runs.",
    parts=[*rolling, *LANDING_ROLL.parts[len(rolling) :]],
)
