"""Lateral coefficients of a tire, odd in the slip: force over load, to the left if positive."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import atan, atan2, degrees, sin
from typing import Any

import numpy as np

#: From lateral velocity, speed ahead (not negative) and load to side force over load.
Side = Callable[[float, float, float], float]


def jsbsim(peak: float) -> Side:
    """JSBSim's own wheel (FGLGear.cpp): a magic formula in degrees of slip."""

    def coefficient(across: float, along: float, load: float) -> float:
        slip = 0.06 * degrees(atan2(across, along))
        return peak * sin(2.8 * atan(slip - 1.03 * (slip - atan(slip))))

    return coefficient


def table(points: list[list[float]]) -> Side:
    """Straight lines between points (slip in degrees, coefficient), odd in the slip."""
    slip, height = np.array(points).T

    def coefficient(across: float, along: float, load: float) -> float:
        angle = degrees(atan2(across, along))
        return float(np.sign(angle) * np.interp(abs(angle), slip, height))

    return coefficient


def radt(p: Mapping[str, float]) -> Side:
    """The thesis's tire: Radt's normalised slip and the magic formula (Eqs. 3.3 to 3.11)."""

    def coefficient(across: float, along: float, load: float) -> float:
        stiffness = max(0.0, p["B3"] + p["C3"] * load)
        mu = friction(p, load)
        slip = p["B1"] * stiffness * across / (along * mu)
        bent = (1 - p["E1"]) * slip + p["E1"] * atan(slip)
        return mu * p["D1"] * sin(p["C1"] * atan(bent))

    return coefficient


def friction(p: Mapping[str, float], load: float) -> float:
    """The friction coefficient of the thesis's tire at a load, times its surface."""
    return max(1e-3, p["B5"] + p["C5"] * load) * p.get("surface", 1.0)


def side(wheel: Mapping[str, Any]) -> Side:
    """The side law a wheel of the dictionary has."""
    if wheel["side"] == "builtin":
        return jsbsim(wheel["mu_static"])
    if isinstance(wheel["side"], Mapping):
        return radt(wheel["side"])
    return table(wheel["side"])
