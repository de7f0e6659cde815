"""The rollout: the landing roll of a body that neither heaves nor pitches nor rolls."""

from __future__ import annotations

from functools import cache

import sympy as sp
from sympy.physics.vector import Vector

from groundroll.derive.core.body import Body
from groundroll.derive.core.frames import i, j, k
from groundroll.derive.core.model import Derivation, Model
from groundroll.derive.parts.fates import path
from groundroll.derive.parts.follows import FOLLOWS
from groundroll.derive.parts.gear import theta_ground
from groundroll.derive.parts.third_wheel import steered_wheel

from .rolling import aloft, wheels


def as_it_rolls(x: sp.Expr, y: sp.Expr, z: sp.Expr) -> Vector:
    """A place in level axes, from the one in axes that the attitude on three wheels pitches up."""
    sine, cosine = sp.sin(theta_ground), sp.cos(theta_ground)
    return (x * cosine + z * sine) * i + y * j + (z * cosine - x * sine) * k


ROLLOUT = Model(
    "rollout",
    "A level body with a free speed on three wheels: loads from weight, lift and elevator only.",
    body=Body(speed="free", stands="level"),
    parts=[
        *wheels(steered_wheel(), place=as_it_rolls),
        *aloft(theta_ground, place=as_it_rolls),
        path(),
    ],
    defaults=FOLLOWS,
)


@cache
def rollout() -> Derivation:
    """The equations of the rollout."""
    return ROLLOUT.derive()
