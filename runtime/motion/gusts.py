"""Side forces that vary over time: what `simulate` takes as its `disturbance`.

>>> import groundroll as gr
>>> plane = gr.Aircraft.load("brott")
>>> gust = gr.gusts.one_minus_cosine(peak="400 N", start=1.0, length=0.5)
>>> run = gr.simulate(plane, disturbance=gust, t=5.0)

These are signals in N (see `groundroll.signals`, which are for any input). Forces act on the
vertical tail, positive to the right (a wind from the left); times are in s. Any number may be a
text with a unit, or an array for several runs at once.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from groundroll.aircraft.aircraft import Aircraft, of_aircraft
from groundroll.base.arrays import FloatArray, finite
from groundroll.model.evaluate import columns
from groundroll.model.models import as_model
from groundroll.motion import signals

from .signals import Signal


def one_minus_cosine(peak: Any, start: Any = 0.0, length: Any = 1.0) -> Signal:
    """The discrete gust of the airworthiness codes; see `signals.one_minus_cosine`."""
    return signals.one_minus_cosine(peak, start, length, unit="N")


def step(size: Any, start: Any = 0.0, end: Any = None) -> Signal:
    """A force that sets in at once and stays, or stops at once; see `signals.step`."""
    return signals.step(size, start, end, unit="N")


def sampled(t: Any, force: Any, *, hold: bool = False) -> Signal:
    """A force through samples, N; see `signals.sampled`."""
    return signals.sampled(t, force, hold=hold, unit="N")


def of_time(
    force: Callable[[FloatArray], Any], breaks: Sequence[float] = (), end: Any = None
) -> Signal:
    """Any function from an array of times, s, to an array of forces, N; see `signals.of_time`."""
    return signals.of_time(force, breaks, end, unit="N")


@of_aircraft
def crosswind(plane: Aircraft, wind: Any) -> FloatArray:
    """The force of a wind across the runway on the tail of an aircraft that rolls straight.

    Parameters
    ----------
    plane : Aircraft
        The aircraft, at its own speed.
    wind : float, array or str
        Speed of the air to the right, m/s.

    Returns
    -------
    ndarray
        Side force, N, to the right: what the vertical tail makes of this velocity.
    """
    names = as_model("linear")
    p, flat, shape = plane.columns("linear", wind=finite("wind", wind, "m/s"))
    x = np.zeros((len(names.states), p.shape[1]))
    x[names.states.index("v")] = flat["wind"]
    (y,) = columns("linear_outputs", x, np.zeros((len(names.inputs), p.shape[1])), p)
    return y[:, names.outputs.index("F_tail"), 0].reshape(shape)
