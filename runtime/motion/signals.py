"""Values over time, for any input of a model: steps, gusts, samples, functions.

>>> import groundroll as gr
>>> plane = gr.Aircraft.load("brott")
>>> push = gr.signals.step("300 N", start=0.5, end="1500 ms")
>>> run = gr.simulate(plane, disturbance=push, t=5.0)

A signal is data, polynomials one after the other, so it can be stored and sent to other processes.
Numbers are in the SI unit of the input; texts have a unit of their own, which must fit the input.
Any number may be an array, for several runs at once. Signals add up, and a number multiplies one:
``gr.signals.step("3 deg") + 0.1 * gr.signals.sampled(t, record)``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import reduce
from math import comb
from typing import Any

import numpy as np
import numpy.typing as npt

from groundroll.base.arrays import FloatArray, finite, single
from groundroll.base.errors import GroundrollError
from groundroll.base.units import parts, to_si

from .fitting import fit
from .lanes import Pieces

#: So far beyond a run, s, a function is followed to where it becomes constant.
_FAR = 1000.0


@dataclass(frozen=True, repr=False, eq=False)
class Signal:
    """A value over time; ``signal(t)`` gives its values at times, s, along the last axis.

    At a jump the value is the one after it.

    Attributes
    ----------
    label : str
        What it is, in words.
    unit : str
        Unit of its values; empty if they are in the SI unit of whatever it is used for.
    """

    label: str
    unit: str

    def __call__(self, t: Any) -> FloatArray:
        times = finite("t", t, "s")
        return self._at(times) if times.ndim else np.asarray(self._at(times[None])[..., 0])

    def _at(self, t: FloatArray) -> FloatArray:
        raise NotImplementedError

    def over(self, t: float) -> Polynomials:
        """The signal from 0 to `t`, s, as polynomials."""
        raise NotImplementedError

    @property
    def start(self) -> FloatArray:
        """Time, s, until which it is zero; -inf if it is not at the beginning."""
        return np.asarray(-np.inf)

    @property
    def end(self) -> FloatArray:
        """Time, s, from which it is constant; inf if that is not known."""
        return np.asarray(np.inf)

    def in_unit(self, unit: str, name: str = "signal") -> Signal:
        """The same signal in another unit, which that of a text must fit.

        Raises
        ------
        GroundrollError
            If it does not.
        """
        factor = to_si(f"1 {self.unit}", unit, name) if self.unit and unit else 1.0
        scaled = self if factor == 1.0 else self.__mul__(factor)
        found: Signal = replace(scaled, unit=unit or self.unit)
        return found

    def __add__(self, other: Signal) -> Signal:
        if not isinstance(other, Signal):
            return NotImplemented
        if self.unit != other.unit:
            if not (self.unit and other.unit):
                raise GroundrollError(
                    f"{self.label} and {other.label} do not add up: give both with a unit, or none"
                )
            other = other.in_unit(self.unit, other.label)
        label = f"{self.label} + {other.label}"
        if isinstance(self, Polynomials) and isinstance(other, Polynomials):
            return replace(_joined(self, other), label=label)
        return Sum(label, self.unit, (self, other))

    def __mul__(self, factor: Any) -> Signal:
        raise NotImplementedError

    def __rmul__(self, factor: Any) -> Signal:
        return self.__mul__(factor)

    def __neg__(self) -> Signal:
        return self * -1.0

    def __repr__(self) -> str:
        return f"Signal({self.label})"


@dataclass(frozen=True, repr=False, eq=False)
class Polynomials(Signal):
    """A signal made of polynomials.

    Attributes
    ----------
    starts : ndarray, shape (..., pieces)
        When each polynomial begins, s, ascending; the first holds before it, too.
    values : ndarray, shape (..., pieces, 1 + terms)
        Of each a time m, s, and the coefficients of powers of t - m.
    known : float
        Time, s, until which it is known.
    """

    starts: FloatArray
    values: FloatArray
    known: float = np.inf

    def over(self, t: float) -> Polynomials:
        return self

    @property
    def shape(self) -> tuple[int, ...]:
        """Of the runs that it has values for."""
        return np.broadcast_shapes(self.starts.shape[:-1], self.values.shape[:-2])

    @property
    def breaks(self) -> tuple[float, ...]:
        """Every time, s, at which a polynomial begins."""
        return tuple(np.unique(self.starts[np.isfinite(self.starts)]).tolist())

    @property
    def start(self) -> FloatArray:
        acts = (self.values[..., 1:] != 0).any(axis=-1)
        first = np.broadcast_to(acts.argmax(axis=-1), self.shape)
        return np.where(first > 0, _taken(self._everywhere(), first), -np.inf)

    @property
    def end(self) -> FloatArray:
        if self.known < np.inf:
            return np.full(self.shape, np.inf)
        level = self.values[..., 1]
        flat = ~(self.values[..., 2:] != 0).any(axis=-1) & (level == level[..., -1:])
        count = np.logical_and.accumulate(flat[..., ::-1], axis=-1).sum(axis=-1)
        last = np.broadcast_to(flat.shape[-1] - count, self.shape)
        found = _taken(self._everywhere(), np.minimum(last, flat.shape[-1] - 1))
        return np.where(last < flat.shape[-1], found, np.inf)

    def _everywhere(self) -> FloatArray:
        """When polynomials begin, for each run."""
        return np.broadcast_to(self.starts, (*self.shape, self.starts.shape[-1]))

    def __mul__(self, factor: Any) -> Polynomials:
        size = finite("factor", factor)[..., None, None]
        value = np.broadcast_arrays(self.values[..., :1], self.values[..., 1:] * size)
        return replace(self, values=np.concatenate([value[0][..., :1], value[1]], axis=-1))

    def _at(self, t: FloatArray) -> FloatArray:
        which = (self.starts[..., None] <= t).sum(axis=-2) - 1
        which = np.broadcast_to(np.maximum(which, 0), (*self.shape, t.size))
        rows = np.broadcast_to(self.values, (*self.shape, *self.values.shape[-2:]))
        middle, *terms = (
            np.take_along_axis(row, which, axis=-1) for row in np.moveaxis(rows, -1, 0)
        )
        return np.asarray(reduce(lambda found, term: found * (t - middle) + term, terms[::-1]))

    def packed(self) -> dict[str, Any]:
        """As plain data, for `unpacked`."""
        starts = np.where(np.isfinite(self.starts), self.starts, np.finfo(np.float64).min)
        return {
            "label": self.label,
            "unit": self.unit,
            "starts": starts.tolist(),
            "values": self.values.tolist(),
            "known": min(self.known, np.finfo(np.float64).max),
        }

    @classmethod
    def unpacked(cls, data: Mapping[str, Any]) -> Polynomials:
        """A signal from plain data."""
        starts = np.asarray(data["starts"], dtype=np.float64)
        starts = np.where(starts == np.finfo(np.float64).min, -np.inf, starts)
        known = data["known"] if data["known"] < np.finfo(np.float64).max else np.inf
        values = np.asarray(data["values"], dtype=np.float64)
        return cls(data["label"], data["unit"], starts, values, known)

    def pieces(self, shape: tuple[int, ...], chunk: range) -> Pieces:
        """As the kernels take it, for some of the runs of a shape, in its flat order."""
        return Pieces(_rows(self.starts, shape, chunk), _rows(self.values, shape, chunk, 2))


@dataclass(frozen=True, repr=False, eq=False)
class OfTime(Signal):
    """Any function of time.

    Attributes
    ----------
    function : callable
        From times, s, shape (k,), to values, shape (..., k).
    breaks : tuple of float
        Times, s, at which it is known to jump.
    last : float
        Time, s, from which it stays as it is then.
    factor : ndarray
        What multiplies the values.
    """

    function: Callable[[FloatArray], Any]
    breaks: tuple[float, ...] = ()
    last: float = np.inf
    factor: FloatArray = field(default_factory=lambda: np.ones(()))

    @property
    def end(self) -> FloatArray:
        return np.asarray(self.last)

    def __mul__(self, factor: Any) -> OfTime:
        return replace(self, factor=self.factor * finite("factor", factor))

    def _at(self, t: FloatArray) -> FloatArray:
        try:
            given = self.function(np.minimum(t, self.last))
        except (TypeError, ValueError) as problem:
            raise GroundrollError(
                f"{self.label} must take an array of times and give an array of values; it failed:"
                f" {problem}. numpy.vectorize makes such a function of one that takes a number"
            ) from problem
        value = finite(f"the value of {self.label}", given, self.unit or "1")
        if value.shape[-1:] != t.shape:
            raise GroundrollError(
                f"{self.label} must give one value for each of {t.size} times, along the last"
                f" axis; it gave shape {value.shape}"
            )
        return value * self.factor[..., None]

    def over(self, t: float) -> Polynomials:
        last = self.last if self.last < t + _FAR else t
        inner = [b for b in self.breaks if 0 < b < last]
        starts, values = fit(self._at, np.array([0.0, *inner, last]), self.label)
        if last == self.last:
            level = self._at(np.array([last]))
            still = np.zeros((*level.shape[:-1], 1, values.shape[-1]))
            still[..., 0, 1] = level[..., 0]
            starts, values = np.append(starts, last), np.concatenate([values, still], axis=-2)
        return Polynomials(
            self.label, self.unit, starts, values, np.inf if last == self.last else t
        )


@dataclass(frozen=True, repr=False, eq=False)
class Sum(Signal):
    """Signals together, of which some are functions."""

    parts: tuple[Signal, ...]

    @property
    def start(self) -> FloatArray:
        return np.asarray(reduce(np.minimum, (part.start for part in self.parts)))

    @property
    def end(self) -> FloatArray:
        return np.asarray(reduce(np.maximum, (part.end for part in self.parts)))

    def __mul__(self, factor: Any) -> Sum:
        return replace(self, parts=tuple(part * factor for part in self.parts))

    def _at(self, t: FloatArray) -> FloatArray:
        return np.asarray(sum(part(t) for part in self.parts))

    def over(self, t: float) -> Polynomials:
        return replace(reduce(_joined, (part.over(t) for part in self.parts)), label=self.label)


# --- What there is -----------------------------------------------------------------------------


def constant(value: Any, *, unit: str = "") -> Signal:
    """A value that stays, to be added to others.

    Parameters
    ----------
    value : float, array or str
        The value.
    unit : str, optional
        Unit of values; that of the text if omitted.
    """
    level, own = _sized("value", value, unit)
    values = np.stack([np.zeros_like(level), level], axis=-1)[..., None, :]
    label = f"constant {_text(level, own)}"
    return Polynomials(label, own, np.array([-np.inf]), values)


def step(size: Any, start: Any = 0.0, end: Any = None, *, unit: str = "") -> Signal:
    """A value that sets in at once and stays, or stops at once.

    Parameters
    ----------
    size : float, array or str
        The value.
    start : float, array or str
        When it sets in, s.
    end : float, array or str, optional
        When it stops, s; never if omitted.
    unit : str, optional
        Unit of values; that of the text if omitted.
    """
    (height, own), begin = _sized("size", size, unit), finite("start", start, "s")
    label, marks, levels = f"step of {_text(height, own)} from {_text(begin, 's')}", [begin], [0, 1]
    if end is not None:
        last = finite("end", end, "s")
        if (last <= begin).any():
            raise GroundrollError(f"end must come after start, not {end} after {start}")
        label, marks, levels = f"{label} to {_text(last, 's')}", [begin, last], [0, 1, 0]
    value = height[..., None] * np.array(levels, dtype=np.float64)
    values = np.stack([np.zeros_like(value), value], axis=-1)
    return Polynomials(label, own, _starts(marks), values)


def one_minus_cosine(peak: Any, start: Any = 0.0, length: Any = 1.0, *, unit: str = "") -> Signal:
    """The discrete gust of the airworthiness codes: peak/2 (1 - cos(2 pi (t - start)/length)).

    Parameters
    ----------
    peak : float, array or str
        Largest value, reached in the middle.
    start : float, array or str
        When it begins, s.
    length : float, array or str
        How long it lasts, s.
    unit : str, optional
        Unit of values; that of the text if omitted.
    """
    (height, own), begin = _sized("peak", peak, unit), finite("start", start, "s")
    duration = finite("length", length, "s")
    if (duration <= 0).any():
        raise GroundrollError(f"length must be positive, not {length}")
    _, unscaled = fit(lambda t: (1 - np.cos(2 * np.pi * t)) / 2, np.array([0, 0.5, 1]), "a gust")
    terms = np.arange(unscaled.shape[-1] - 1)
    level = height[..., None, None] * unscaled[:, 1:] / duration[..., None, None] ** terms
    middle = begin[..., None] + duration[..., None] * unscaled[:, 0]
    runs = np.broadcast_shapes(level.shape[:-2], middle.shape[:-1])
    values = np.zeros((*runs, len(unscaled) + 2, unscaled.shape[-1]))
    values[..., 1:-1, 0], values[..., 1:-1, 1:] = middle, level
    label = f"1-cosine gust of {_text(height, own)} from {_text(begin, 's')} over"
    marks = [begin, begin + duration / 2, begin + duration]
    return Polynomials(f"{label} {_text(duration, 's')}", own, _starts(marks), values)


def sampled(t: Any, values: Any, *, hold: bool = False, unit: str = "") -> Signal:
    """Samples; before the first and after the last the value stays as it is there.

    Parameters
    ----------
    t : array, shape (samples,)
        Times, s, increasing.
    values : array, shape (..., samples)
        The samples.
    hold : bool
        If true each sample holds until the next, as a digital controller's output does;
        otherwise straight lines join them.
    unit : str, optional
        Unit of values; that of the texts if omitted.
    """
    times, (level, own) = finite("t", t, "s"), _sized("values", values, unit)
    if times.ndim != 1 or times.size == 0 or (np.diff(times) <= 0).any():
        raise GroundrollError("t must be a list of increasing times")
    if level.shape[-1:] != times.shape:
        raise GroundrollError(
            f"values must have one sample for each of {times.size} times along the last axis, not"
            f" shape {level.shape}"
        )
    label = f"{times.size} samples from {times[0]:g} to {times[-1]:g} s"
    rows = np.zeros((*level.shape[:-1], times.size + 1, 3))
    rows[..., 1:, 0] = times
    rows[..., 0, 1], rows[..., 1:, 1] = level[..., 0], level
    if not hold:
        rows[..., 1:-1, 2] = np.diff(level, axis=-1) / np.diff(times)
    return Polynomials(label, own, np.array([-np.inf, *times]), rows)


def of_time(
    function: Callable[[FloatArray], Any],
    breaks: Sequence[float] = (),
    end: Any = None,
    *,
    unit: str = "",
) -> Signal:
    """Any function of time.

    Polynomials are fitted to it, to 2e-13 of its largest value. Where it jumps or has a kink is
    found, but faster when said; what passes within 0.25 ms may be missed.

    Parameters
    ----------
    function : callable
        From an array of times, s, shape (k,), to an array of values, shape (..., k).
    breaks : sequence of float
        Times, s, at which it or one of its derivatives jumps.
    end : float, optional
        Time, s, from which the value stays as it is then; it goes on for ever if omitted.
    unit : str, optional
        Unit of values; the SI unit of the input if omitted.
    """
    if not callable(function):
        raise GroundrollError(f"a signal must be a function of an array of times, not {function!r}")
    label = f"function {getattr(function, '__name__', type(function).__name__)}"
    jumps = tuple(np.unique(finite("breaks", breaks, "s")).tolist())
    last = np.inf if end is None else single("end", end, "s")
    return OfTime(label, unit, function, jumps, last)


def as_signal(value: Any) -> Signal | None:
    """A value as a signal if it varies over time, otherwise None."""
    if isinstance(value, Signal):
        return value
    return of_time(value) if callable(value) else None


# --- How it is done ----------------------------------------------------------------------------


def _sized(name: str, value: Any, unit: str) -> tuple[FloatArray, str]:
    """A number in a unit, or in that of its text, and the unit."""
    text = value
    while isinstance(text, list | tuple) and text:
        text = text[0]
    own = unit or (parts(text)[1] if isinstance(text, str) else "")
    return finite(name, value, own or "1"), own


def _text(number: FloatArray, unit: str) -> str:
    span = f"{number:g}" if number.ndim == 0 else f"{number.min():g} to {number.max():g}"
    return f"{span} {unit}".rstrip()


def _starts(marks: Sequence[FloatArray]) -> FloatArray:
    """Starts of the pieces between marks, and of one before them."""
    each = np.broadcast_arrays(*marks)
    return np.stack([np.full(each[0].shape, -np.inf), *each], axis=-1)


def _taken(rows: FloatArray, which: npt.NDArray[np.intp]) -> FloatArray:
    """One element of each row."""
    return np.asarray(np.take_along_axis(rows, which[..., None], axis=-1)[..., 0])


def _rows(array: FloatArray, shape: tuple[int, ...], chunk: range, inner: int = 1) -> FloatArray:
    """Rows of an array that broadcasts to a shape, or a single one if all are the same."""
    tail = array.shape[-inner:]
    if array.size == np.prod(tail):
        return array.reshape(1, *tail)
    every = np.broadcast_to(array, (*shape, *tail))
    return np.asarray(every[np.unravel_index(np.asarray(chunk), shape)])


def _joined(one: Polynomials, other: Polynomials) -> Polynomials:
    """Sum of two signals: a piece for each piece of either."""
    shape = np.broadcast_shapes(one.shape, other.shape)
    begins = [np.broadcast_to(s.starts, (*shape, s.starts.shape[-1])) for s in (one, other)]
    starts = np.sort(np.concatenate(begins, axis=-1), axis=-1)[..., 1:]  # both begin with -inf
    if starts.ndim > 1 and (starts == starts.reshape(-1, starts.shape[-1])[0]).all():
        starts = starts.reshape(-1, starts.shape[-1])[0]
    starts = np.unique(starts) if starts.ndim == 1 else starts
    after = np.concatenate([starts[..., 1:], np.full((*starts.shape[:-1], 1), np.inf)], axis=-1)
    low = np.where(np.isfinite(starts), starts, np.where(np.isfinite(after), after, 0.0))
    middle = (low + np.where(np.isfinite(after), after, low)) / 2
    terms = max(one.values.shape[-1], other.values.shape[-1])
    total = np.zeros((*shape, starts.shape[-1], terms))
    for s in (one, other):
        total[..., 1:] += _moved(s, starts, middle, shape, terms - 1)
    total[..., 0] = middle
    return Polynomials(one.label, one.unit, starts, total, min(one.known, other.known))


def _moved(
    signal: Polynomials,
    starts: FloatArray,
    middle: FloatArray,
    shape: tuple[int, ...],
    terms: int,
) -> FloatArray:
    """Coefficients of a signal about other middles, for pieces that lie within its own."""
    begins = signal.starts[..., None, :]
    which = np.maximum((begins <= starts[..., None]).sum(axis=-1) - 1, 0)
    rows = np.broadcast_to(signal.values, (*shape, *signal.values.shape[-2:]))
    index = np.broadcast_to(which, (*shape, which.shape[-1]))[..., None]
    taken = np.take_along_axis(rows, index, axis=-2)
    by, old = middle - taken[..., 0], taken[..., 1:]
    moved = np.zeros((*taken.shape[:-1], terms))
    for k in range(old.shape[-1]):
        for i in range(k, old.shape[-1]):
            moved[..., k] += comb(i, k) * old[..., i] * by ** (i - k)
    return moved
