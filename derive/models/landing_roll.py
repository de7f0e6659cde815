"""The landing roll: a rigid body on three legs, in the air and over the runway."""

from __future__ import annotations

from functools import cache

from groundroll.derive.core.body import Body
from groundroll.derive.core.model import Derivation, Model
from groundroll.derive.parts.fates import path, strikes, support
from groundroll.derive.parts.follows import FOLLOWS
from groundroll.derive.parts.third_wheel import third_wheel

from .rolling import aloft, wheels

LANDING_ROLL = Model(
    "landing_roll",
    "A rigid body on three wheels with legs, in wind, braked and steered, until it stops.",
    body=Body(speed="free", stands="on legs"),
    parts=[*wheels(third_wheel()), *aloft(), path(), support(), *strikes()],
    defaults=FOLLOWS,
)


@cache
def landing_roll() -> Derivation:
    """The equations of the landing roll."""
    return LANDING_ROLL.derive()
