"""Side forces that vary over time: what `simulate` takes as its `disturbance`.

>>> import groundroll as gr
>>> plane = gr.Aircraft.load("brott")
>>> gust = gr.gusts.one_minus_cosine(peak="400 N", start=1.0, length=0.5)
>>> run = gr.simulate(plane, disturbance=gust, t=5.0)

Forces act on the vertical tail, N, positive to the right (a wind from the left); times are in s.
Any number may be a string with a unit, or an array for several runs at once.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import numpy as np

from .aircraft import Aircraft
from .arrays import FloatArray, as_inputs, finite
from .errors import GroundrollError
from .evaluate import columns
from .gust_forces import OneMinusCosine, Samples, Step, Sum, Until
from .memory import check_memory
from .models import ModelLike, as_model

#: Bytes for each millisecond in which a jump is looked for.
_CHECKED = 8 * 5 * 3
#: What a function does whose derivative of order n - 1 jumps.
_JUMPS = {1: "jumps", 2: "has a kink", 3: "changes its curvature"}


@dataclass(frozen=True, repr=False, eq=False)
class Gust:
    """A side force over time; ``gust(t)`` gives the forces at an array of times.

    Gusts add up: ``one_minus_cosine(...) + step(...)``.

    Attributes
    ----------
    force : callable
        From times, s, shape (samples,), to forces, N, shape (..., samples).
    breaks : tuple of float
        Times, s, at which the force or one of its derivatives jumps. Integration stops and
        restarts there; at a jump itself the force is the one after it.
    label : str
        What it is, in words.
    complete : bool
        Whether `breaks` is known to hold every jump; otherwise `refuse_jumps` looks for more.
    start : ndarray
        Time, s, until which there is no force; -inf if there is one from the beginning.
    end : ndarray
        Time, s, from which the force is constant; inf if that is not known.
    """

    force: Callable[[FloatArray], Any]
    breaks: tuple[float, ...] = ()
    label: str = "gust"
    complete: bool = True
    start: FloatArray = field(default_factory=lambda: np.asarray(-np.inf))
    end: FloatArray = field(default_factory=lambda: np.asarray(np.inf))

    def __call__(self, t: Any) -> FloatArray:
        times = finite("t", t, "s")
        if times.ndim == 0:
            return np.asarray(self(times[None])[..., 0])
        try:
            given = self.force(times)
        except (TypeError, ValueError) as problem:
            raise GroundrollError(
                f"{self.label} must take an array of times and give an array of forces; it failed:"
                f" {problem}. numpy.vectorize makes such a function of one that takes a number"
            ) from problem
        force = finite(f"the force of {self.label}", given, "N")
        if force.shape[-1:] != times.shape:
            raise GroundrollError(
                f"{self.label} must give one force for each of {times.size} times, along the last"
                f" axis; it gave shape {force.shape}"
            )
        return force

    def __add__(self, other: Gust) -> Gust:
        if not isinstance(other, Gust):
            return NotImplemented
        return Gust(
            Sum((*self._parts(), *other._parts())),
            tuple(sorted({*self.breaks, *other.breaks})),
            f"{self.label} + {other.label}",
            self.complete and other.complete,
            np.minimum(self.start, other.start),
            np.maximum(self.end, other.end),
        )

    def _parts(self) -> tuple[Callable[[FloatArray], Any], ...]:
        return self.force.parts if isinstance(self.force, Sum) else (self,)

    def on_runs(self, model: ModelLike, shape: tuple[int, ...], t: FloatArray) -> FloatArray:
        """Inputs of a model on runs of some shape, shape (inputs, runs, times)."""
        return as_inputs(model, np.broadcast_to(self(t), (*shape, t.size)).reshape(-1, t.size))

    def refuse_jumps(self, end: float) -> None:
        """Raise an error if the force or a derivative jumps before `end`, s, beside `breaks`.

        Looks at differences over 1 ms and over a quarter of it. Those of order n of a smooth
        function fall to 1/4^n, but to 1/4^(n - 1) only where the derivative of order n - 1 jumps.
        """
        if self.complete:
            return
        marks = [0.0, *(b for b in self.breaks if 0 < b < end), end]
        for begin, last in pairwise(marks):
            pieces = max(8, math.ceil((last - begin) / 1e-3))
            check_memory(_CHECKED * pieces, f"the times at which {self.label} is looked at")
            coarse, fine = (self._inside(begin, last, n) for n in (pieces, 4 * pieces))
            for order in (1, 2, 3):
                before, after = (_differences(force, order) for force in (coarse, fine))
                if after.max() > max(2 * before.max() / 4**order, 1e-9 * np.abs(fine).max()):
                    near = begin + (after.argmax() + order / 2) / (4 * pieces) * (last - begin)
                    raise GroundrollError(
                        f"{self.label} {_JUMPS[order]} near t = {near:.4g} s, or varies too"
                        f" quickly; say where, as gusts.of_time(force, breaks=[{near:.4g}]) does"
                    )

    def _inside(self, begin: float, end: float, pieces: int) -> FloatArray:
        """Forces at equally spaced times, the first and last just inside, one row for each run."""
        times = np.linspace(begin, end, pieces + 1)
        times[[0, -1]] = np.nextafter(begin, end), np.nextafter(end, begin)
        return self(times).reshape(-1, times.size)

    def __repr__(self) -> str:
        return f"Gust({self.label})"


def one_minus_cosine(peak: Any, start: Any = 0.0, length: Any = 1.0) -> Gust:
    """The discrete gust of the airworthiness codes: peak/2 (1 - cos(2 pi (t - start)/length)).

    Parameters
    ----------
    peak : float, array or str
        Largest force, N, reached in the middle.
    start : float, array or str
        When it begins, s.
    length : float, array or str
        How long it lasts, s.
    """
    height, begin = finite("peak", peak, "N"), finite("start", start, "s")
    duration = _positive("length", length, "s")
    label = f"1-cosine gust of {_text(height)} N from {_text(begin)} s over {_text(duration)} s"
    force, last = OneMinusCosine(height, begin, duration), begin + duration
    return Gust(force, _times(begin, last), label, start=begin, end=last)


def step(size: Any, start: Any = 0.0, end: Any = None) -> Gust:
    """A force that sets in at once and stays, or stops at once.

    Parameters
    ----------
    size : float, array or str
        The force, N.
    start : float, array or str
        When it sets in, s.
    end : float, array or str, optional
        When it stops, s; never if omitted.
    """
    height, begin = finite("size", size, "N"), finite("start", start, "s")
    last = np.asarray(np.inf) if end is None else finite("end", end, "s")
    if (last <= begin).any():
        raise GroundrollError(f"end must come after start, not {end} after {start}")
    until = "" if end is None else f" to {_text(last)} s"
    label = f"step of {_text(height)} N from {_text(begin)} s{until}"
    constant = begin if end is None else last
    force = Step(height, begin, last)
    return Gust(force, _times(begin, constant), label, start=begin, end=constant)


def sampled(t: Any, force: Any, *, hold: bool = False) -> Gust:
    """A force through samples; before the first and after the last it stays as it is there.

    Parameters
    ----------
    t : array, shape (samples,)
        Times, s, increasing.
    force : array, shape (..., samples)
        Forces, N.
    hold : bool
        If true each sample holds until the next, as a digital controller's output does;
        otherwise straight lines join them.
    """
    times, values = finite("t", t, "s"), finite("force", force, "N")
    if times.ndim != 1 or times.size == 0 or (np.diff(times) <= 0).any():
        raise GroundrollError("t must be a list of increasing times")
    if values.shape[-1:] != times.shape:
        raise GroundrollError(
            f"force must have one sample for each of {times.size} times along its last axis, not"
            f" shape {values.shape}"
        )

    label = f"{times.size} samples from {times[0]:g} to {times[-1]:g} s"
    acts, changes = values != 0, np.diff(values, axis=-1, prepend=values[..., :1]) != 0
    first, last = acts.argmax(axis=-1), changes.shape[-1] - 1 - changes[..., ::-1].argmax(axis=-1)
    return Gust(
        Samples(times, values, hold),
        _times(times),
        label,
        start=np.where(first > 0, times[first - (0 if hold else 1)], -np.inf),
        end=np.where(changes.any(axis=-1), times[last], times[0]),
    )


def of_time(
    force: Callable[[FloatArray], Any], breaks: Sequence[float] = (), end: float | None = None
) -> Gust:
    """Any function of time, with the times at which it or one of its derivatives jumps.

    Parameters
    ----------
    force : callable
        From an array of times, s, to an array of forces, N.
    breaks : sequence of float
        Times, s; a jump that is left out is an error when it is met.
    end : float, optional
        Time, s, from which the force stays as it is then; it goes on for ever if omitted.
    """
    if not callable(force):
        raise GroundrollError(f"force must be a function of an array of times, not {force!r}")
    label = f"function {getattr(force, '__name__', type(force).__name__)}"
    jumps = finite("breaks", breaks, "s")
    if end is None:
        return Gust(force, _times(jumps), label, complete=False)
    last = finite("end", end, "s")
    return Gust(
        Until(force, last),
        _times(jumps[jumps < last], last),
        label,
        complete=False,
        end=last,
    )


def as_gust(disturbance: Any) -> Gust | None:
    """`disturbance` as a gust if it varies over time, otherwise None."""
    if isinstance(disturbance, Gust):
        return disturbance
    return of_time(disturbance) if callable(disturbance) else None


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


def _differences(force: FloatArray, order: int) -> FloatArray:
    return np.asarray(np.abs(np.diff(force, order)).max(axis=0))


def _positive(name: str, value: Any, unit: str) -> FloatArray:
    number = finite(name, value, unit)
    if (number <= 0).any():
        raise GroundrollError(f"{name} must be positive, not {value}")
    return number


def _times(*times: FloatArray) -> tuple[float, ...]:
    return tuple(sorted({float(t) for group in times for t in np.ravel(group)}))


def _text(number: FloatArray) -> str:
    return f"{float(number):g}" if number.ndim == 0 else f"{number.min():g} to {number.max():g}"
