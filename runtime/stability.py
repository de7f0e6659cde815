"""Closed forms of the linear model, for any array of parameters."""

from __future__ import annotations

from dataclasses import dataclass

from .aircraft import Aircraft
from .arrays import FloatArray
from .evaluate import elementwise
from .generated import build


@dataclass(frozen=True)
class SpeedWindow:
    """Speeds between which the linear model is unstable.

    Attributes
    ----------
    low, high : ndarray
        m/s; NaN where the aircraft is stable at every speed, infinite where there is no end.
    """

    low: FloatArray
    high: FloatArray


def speed_window(plane: Aircraft) -> SpeedWindow:
    """The speeds at which the determinant of the linear model changes sign.

    Parameters
    ----------
    plane : Aircraft
        The aircraft; its parameters may be arrays. Its own speed does not matter.
    """
    arguments = {s: plane[s] for s in build("speed_window").name_in()}
    window = elementwise("speed_window", arguments)
    return SpeedWindow(window["u_low"], window["u_high"])
