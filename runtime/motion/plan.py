"""What is to be integrated: checked, laid out, and cut into tasks for the kernels."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np

from groundroll.aircraft.aircraft import Aircraft
from groundroll.aircraft.parameters import parameters_of
from groundroll.aircraft.values import Given, refuse_beyond
from groundroll.base.arrays import FloatArray, common_shape, finite, positive
from groundroll.base.errors import GroundrollError
from groundroll.model.models import Model

from .chunks import piece
from .lanes import Outcome, Task, Watch
from .rest import start_of
from .signals import Polynomials, as_signal

#: Finest and coarsest `tol`.
TOLERANCES = (1e-11, 1e-3)
#: Bytes that the results of one chunk may take, and the fewest trajectories in one.
_CHUNK_BYTES, _FEWEST = 2**26, 32
#: Times at which the range of a signal is looked at, and by how much a fitted one may pass it.
_LOOKS, _FITTED = 65, 1e-6


@dataclass(frozen=True)
class Plan:
    """Everything about some trajectories but their chunks.

    Attributes
    ----------
    aircraft : Aircraft
    model : Model
    shape : tuple of int
        What parameters, inputs and initial states broadcast to.
    start, inputs : dict of ndarray
        Initial states and constant inputs by symbol.
    signals : dict of Polynomials
        Inputs over time.
    t, tol : float
        Duration, s, and the error to be kept relative to each state's scale.
    at : ndarray
        Ascending times, s, at which `sampled` is wanted.
    sampled, final : tuple of str
        States and outputs to sample; states that are wanted at the end.
    watches : tuple of Watch
    """

    aircraft: Aircraft
    model: Model
    shape: tuple[int, ...]
    start: Mapping[str, FloatArray]
    inputs: Mapping[str, FloatArray]
    signals: Mapping[str, Polynomials]
    t: float
    tol: float
    at: FloatArray
    sampled: tuple[str, ...] = ()
    final: tuple[str, ...] = ()
    watches: tuple[Watch, ...] = ()

    @property
    def count(self) -> int:
        """Number of trajectories."""
        return math.prod(self.shape)

    @property
    def bytes_each(self) -> int:
        """Bytes of the result of one trajectory."""
        numbers = len(self.final) + len(self.sampled) * self.at.size + 2 * len(self.watches)
        return 8 * numbers + 1 + 1 + 4 + 8 + 8

    @property
    def chunk(self) -> int:
        """Most trajectories whose results take a bounded amount of memory."""
        return max(_FEWEST, _CHUNK_BYTES // self.bytes_each)

    @property
    def follows(self) -> bool:
        """Whether a parameter that follows from others varies."""
        return any(value.ndim for value in self.aircraft.given.values())

    def task(self, chunk: range) -> Task:
        """The trajectories of a chunk, in the flat order of the shape."""
        cut = partial(piece, shape=self.shape, chunk=chunk)
        if len(chunk) == self.count:
            parameters = {s: cut(p) for s, p in parameters_of(self.aircraft, self.model).items()}
        else:  # what follows from others, follows for the chunk alone
            given = {s: cut(value) for s, value in self.aircraft.given.items()}
            own = {s: cut(v) if np.ndim(v) else v for s, v in self.aircraft.own.items()}
            aircraft = replace(self.aircraft, given=given).with_own(own)
            parameters = parameters_of(aircraft, self.model)
        return Task(
            model=self.model,
            x0={s: cut(value).reshape(-1) for s, value in self.start.items()},
            inputs={s: cut(value).reshape(-1) for s, value in self.inputs.items()},
            parameters={s: value.reshape(-1) for s, value in parameters.items()},
            signals={s: signal.pieces(self.shape, chunk) for s, signal in self.signals.items()},
            count=len(chunk),
            t=self.t,
            tol=self.tol,
            times=self.at,
            sampled=self.sampled,
            final=self.final,
            watches=tuple(
                replace(watch, limit=cut(watch.limit).reshape(-1)) for watch in self.watches
            ),
        )

    def room(self) -> Outcome:
        """For the results of all trajectories."""
        times, watches = self.at.size, len(self.watches)
        return Outcome.empty(self.count, self.final, self.sampled, times, watches)


def planned(given: Given, model: Model, t: Any, tol: Any, at: FloatArray) -> Plan:
    """A plan of what a call was given, of which nothing is wanted yet.

    Raises
    ------
    GroundrollError
        If a value cannot be, or shapes do not broadcast.
    """
    duration = positive("t", t, "s")
    unit = {s: model.quantities[s].unit for s in model.inputs}
    name = {s: model.quantities[s].name for s in model.inputs}
    over_time = {s: as_signal(value) for s, value in given.inputs.items()}
    signals = {
        s: signal.in_unit(unit[s], name[s]).over(duration)
        for s, signal in over_time.items()
        if signal is not None
    }
    for s in model.ranges:
        if s in signals:
            refuse_beyond(model, s, signals[s](_looked_at(signals[s], duration)), _FITTED)
    inputs = {s: given.inputs.get(s, np.zeros(())) for s in model.inputs if s not in signals}
    start = start_of(given.aircraft, model, given.states)
    shape = common_shape(
        {
            **given.aircraft.given,
            **{s: finite(s, v) for s, v in given.aircraft.own.items() if np.ndim(v)},
            **inputs,
            **{s: np.broadcast_to(0.0, signal.shape) for s, signal in signals.items()},
            **{f"{s}0": value for s, value in start.items()},
        }
    )
    if 0 in shape:
        raise GroundrollError(f"there is nothing to simulate: the arrays broadcast to {shape}")
    return Plan(given.aircraft, model, shape, start, inputs, signals, duration, tolerance(tol), at)


def _looked_at(signal: Polynomials, duration: float) -> FloatArray:
    """Times at which a signal's range is looked at: many, and where its polynomials begin."""
    starts = [start for start in signal.breaks[:_LOOKS] if 0 <= start <= duration]
    return np.union1d(np.linspace(0.0, duration, _LOOKS), starts)


def tolerance(tol: Any) -> float:
    """`tol` as a number in the range that is offered."""
    number = positive("tol", tol)
    finest, coarsest = TOLERANCES
    if not finest <= number <= coarsest:
        raise GroundrollError(f"tol must be from {finest:g} to {coarsest:g}, not {number:g}")
    return number
