"""The landing roll with a pilot at the controls."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

from groundroll.derive.core.model import Derivation
from groundroll.derive.parts.pilot import PILOT, pilot

from .landing_roll import LANDING_ROLL

LANDING_ROLL_FLOWN = replace(
    LANDING_ROLL,
    name="landing_roll_flown",
    summary="The landing roll, held straight by a pilot who is late.",
    parts=[*LANDING_ROLL.parts, pilot()],
    defaults=(*LANDING_ROLL.defaults, *PILOT),
)


@cache
def landing_roll_flown() -> Derivation:
    """The equations of the landing roll with a pilot."""
    return LANDING_ROLL_FLOWN.derive()
