"""The kernels of a model, called with NumPy arrays: many trajectories at once, or a single one."""

from __future__ import annotations

import ctypes
import threading
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache, reduce
from typing import Any

import numpy as np
import numpy.typing as npt

from groundroll.base.arrays import FloatArray
from groundroll.base.errors import unknown
from groundroll.generated import Pack
from groundroll.generated.compiler import NoCompilerError
from groundroll.generated.kernels import load, useful_threads
from groundroll.generated.library import say_once

#: Trajectories that a thread integrates side by side, by whether the model is stiff.
_LANES = {False: 32, True: 8}
#: Attempted steps after which a trajectory is given up.
_MAX_STEPS = 500_000
#: Most coefficients of a polynomial of an input, and most rows that can be watched.
TERMS, WATCHES = 16, 32
_ENSEMBLE, _TRAJECTORY = 1, 2
#: The function of each driver.
_SYMBOLS = {_ENSEMBLE: "integrate", _TRAJECTORY: "trace"}

#: What became of a trajectory, by the kernels' code; the last is said by `ensemble` alone.
STATUS = ("ok", "not finite", "step limit", "unsure", "left the range")
#: What is said of some of these.
IN_WORDS = {
    "not finite": "the motion grows beyond what a number can hold",
    "step limit": f"the motion grows or changes too fast to be followed in {_MAX_STEPS:_} steps",
    "unsure": "the error may be larger than tol",
}


@dataclass(frozen=True)
class Pieces:
    """An input over time, as the kernels take it.

    Attributes
    ----------
    start : ndarray, shape (n or 1, pieces)
        When each polynomial begins, s; the first holds before it, too.
    value : ndarray, shape (n or 1, pieces, 1 + terms)
        A time m, s, and the coefficients of a polynomial in t - m.
    """

    start: FloatArray
    value: FloatArray

    def at(self, t: FloatArray) -> FloatArray:
        """Values at times, shape (n or 1, times)."""
        rows = max(len(self.start), len(self.value))
        which = np.maximum((self.start[..., None] <= t).sum(axis=-2) - 1, 0)
        which = np.broadcast_to(which, (rows, t.size))
        value = np.broadcast_to(self.value, (rows, *self.value.shape[1:]))
        middle, *terms = np.moveaxis(np.take_along_axis(value, which[..., None], axis=1), -1, 0)
        return np.asarray(reduce(lambda found, term: found * (t - middle) + term, terms[::-1]))


@dataclass(frozen=True)
class Watch:
    """A row whose largest value is wanted, and when it first is not below a limit.

    Attributes
    ----------
    row : str
        A state or output.
    sign : int
        0: its magnitude; 1 or -1: itself or its negative.
    limit : ndarray, shape (n,) or (1,)
        Infinite if only the largest value is wanted.
    ends : bool
        Whether the trajectory ends there.
    """

    row: str
    sign: int = 0
    limit: FloatArray = field(default_factory=lambda: np.array([np.inf]))
    ends: bool = False


@dataclass(frozen=True)
class Task:
    """Some trajectories to integrate, small enough to be sent elsewhere.

    Attributes
    ----------
    model : Pack
    x0, inputs, parameters : dict of ndarray
        Initial states, constant inputs and parameters by symbol, each with one value for all
        trajectories or one for each.
    signals : dict of Pieces
        Inputs over time.
    count : int
        Number of trajectories.
    t, tol : float
        Duration, s, and the error to be kept relative to each state's scale.
    times : ndarray
        Ascending times, s, at which the rows `sampled` are wanted.
    sampled : tuple of str
        States and outputs to sample.
    final : tuple of str
        States that are wanted at the end.
    watches : tuple of Watch
    """

    model: Pack
    x0: Mapping[str, FloatArray]
    inputs: Mapping[str, FloatArray]
    parameters: Mapping[str, FloatArray]
    count: int
    t: float
    tol: float
    times: FloatArray = field(default_factory=lambda: np.empty(0))
    sampled: tuple[str, ...] = ()
    final: tuple[str, ...] = ()
    watches: tuple[Watch, ...] = ()
    signals: Mapping[str, Pieces] = field(default_factory=dict)

    @property
    def carry(self) -> int:
        """Index of the set of states to be carried."""
        rows = (watch.row for watch in self.watches)
        return smallest(self.model, (*self.sampled, *self.final, *rows))

    @property
    def observed(self) -> bool:
        """Whether an output is wanted."""
        rows = {watch.row for watch in self.watches}
        return bool({*self.sampled, *rows} & {*self.model.outputs})


@dataclass(frozen=True)
class Outcome:
    """What became of some trajectories.

    Attributes
    ----------
    status : ndarray of int8, shape (n,)
        An index of `STATUS`.
    steps : ndarray of int32, shape (n,)
        Attempted steps.
    estimate : ndarray, shape (n,)
        Estimated error relative to each state's scale.
    end : ndarray, shape (n,)
        When the trajectory ended, s.
    cause : ndarray of int8, shape (n,)
        Index of the watch that ended it, -1 if none did.
    final : dict of ndarray, each of shape (n,)
        States at the end; NaN if it was not reached.
    samples : dict of ndarray, each of shape (n, times)
        Rows at the times; NaN after an early end.
    largest, first : ndarray, shape (watches, n)
        Largest value, and when it first was not below its limit, infinite if never.
    """

    status: npt.NDArray[np.int8]
    steps: npt.NDArray[np.int32]
    estimate: FloatArray
    end: FloatArray
    cause: npt.NDArray[np.int8]
    final: dict[str, FloatArray]
    samples: dict[str, FloatArray]
    largest: FloatArray
    first: FloatArray

    @classmethod
    def empty(
        cls, n: int, final: Iterable[str], sampled: Iterable[str], times: int, watches: int
    ) -> Outcome:
        """Room for so many trajectories, states, rows at so many times, and watches."""
        return cls(
            status=np.empty(n, np.int8),
            steps=np.empty(n, np.int32),
            estimate=np.empty(n),
            end=np.empty(n),
            cause=np.empty(n, np.int8),
            final={s: np.empty(n) for s in final},
            samples={s: np.empty((n, times)) for s in sampled},
            largest=np.empty((watches, n)),
            first=np.empty((watches, n)),
        )

    def part(self, chunk: range) -> Outcome:
        """Some of the trajectories, as views."""
        where = slice(chunk.start, chunk.stop)
        return Outcome(
            status=self.status[where],
            steps=self.steps[where],
            estimate=self.estimate[where],
            end=self.end[where],
            cause=self.cause[where],
            final={s: array[where] for s, array in self.final.items()},
            samples={s: array[where] for s, array in self.samples.items()},
            largest=self.largest[:, where],
            first=self.first[:, where],
        )


class _Signal(ctypes.Structure):
    """``signal_t`` of ``model.c``."""

    _fields_ = (
        ("pieces", ctypes.c_int64),
        ("terms", ctypes.c_int64),
        ("start", ctypes.c_void_p),
        ("start_stride", ctypes.c_int64),
        ("value", ctypes.c_void_p),
        ("value_stride", ctypes.c_int64),
    )


class _Watch(ctypes.Structure):
    """``watch_t`` of ``model.c``."""

    _fields_ = (
        *((name, ctypes.c_int64) for name in ("row", "sign", "ends")),
        ("limit", ctypes.c_void_p),
        ("limit_stride", ctypes.c_int64),
        ("largest", ctypes.c_void_p),
        ("first", ctypes.c_void_p),
    )


class _Job(ctypes.Structure):
    """``job_t`` of ``model.c``."""

    _fields_ = (
        *((name, ctypes.c_int64) for name in ("n", "max_steps", "threads", "n_times")),
        *((name, ctypes.c_int64) for name in ("n_watches", "observed")),
        *((name, ctypes.c_double) for name in ("t_end", "tol")),
        *((name, ctypes.c_void_p) for name in ("x0", "x0_stride", "p", "p_stride", "signals")),
        *((name, ctypes.c_void_p) for name in ("final", "end", "cause", "status", "steps")),
        *((name, ctypes.c_void_p) for name in ("estimate", "times", "samples", "watches")),
    )


class _Pointers:
    """A C array of pointers to arrays (or NULL), and one of their strides: 0 for one value."""

    def __init__(self, arrays: Iterable[FloatArray | None]) -> None:
        self._arrays = [None if a is None else np.ascontiguousarray(a) for a in arrays]
        data = [None if a is None else a.ctypes.data for a in self._arrays]
        self._pointers = (ctypes.c_void_p * len(data))(*data)
        strides = [int(a is not None and a.size > 1) for a in self._arrays]
        self._strides = (ctypes.c_int64 * len(data))(*strides)

    @property
    def address(self) -> int:
        return ctypes.addressof(self._pointers)

    @property
    def strides(self) -> int:
        return ctypes.addressof(self._strides)


class _Signals:
    """The inputs of a model over time as a C array; those that are constant, too."""

    def __init__(self, pieces: Sequence[Pieces]) -> None:
        self._kept = []
        self._array = (_Signal * max(1, len(pieces)))()
        for signal, given in zip(self._array, pieces, strict=False):
            start = np.ascontiguousarray(given.start, dtype=np.float64)
            value = np.ascontiguousarray(given.value, dtype=np.float64)
            self._kept += [start, value]
            signal.pieces, signal.terms = start.shape[1], value.shape[2] - 1
            signal.start, signal.value = start.ctypes.data, value.ctypes.data
            signal.start_stride = start.shape[1] if len(start) > 1 else 0
            signal.value_stride = value[0].size if len(value) > 1 else 0

    @property
    def address(self) -> int:
        return ctypes.addressof(self._array)


def held(value: FloatArray) -> Pieces:
    """A constant input as one over time."""
    rows = value.reshape(-1, 1)
    return Pieces(np.zeros((1, 1)), np.stack([np.zeros_like(rows), rows], axis=2))


def can_compile(model: Pack) -> bool:
    """Whether the kernels of a model can be compiled here; says so once if not."""
    try:
        _library(model, _ENSEMBLE, len(model.carried) - 1, model.over_time)
    except NoCompilerError as problem:
        say_once(
            "kernels",
            f"{problem}; ensembles run in CasADi's virtual machine, hundreds of times slower",
        )
        return False
    return True


@cache
def _library(model: Pack, driver: int, carry: int, varying: bool) -> ctypes.CDLL:
    defines = {"DRIVER": driver, "CARRY": carry, "VARYING": int(varying)}
    flags = (f"-D{name}={value}" for name, value in defines.items())
    return load(model.sources / "lanes.c", model.digest, _SYMBOLS[driver], *flags)


def smallest(model: Pack, names: Iterable[str]) -> int:
    """Index of the smallest set of states, of those that kernels carry, that gives these rows.

    Raises
    ------
    GroundrollError
        If a name is no state or output of the model.
    """
    wanted = set(names)
    for index, (states, outputs) in enumerate(zip(model.carried, model.seen, strict=True)):
        if wanted <= {*states, *outputs}:
            return index
    rows = (*model.states, *model.outputs)
    raise unknown("name", min(wanted.difference(rows)), rows, model.name)


def integrate(task: Task, threads: int = 1, into: Outcome | None = None) -> Outcome:
    """Integrate every trajectory of a task; its bits do not depend on the number of threads.

    Parameters
    ----------
    task : Task
    threads : int
    into : Outcome, optional
        Where the results are written; new arrays if omitted.

    Raises
    ------
    NoCompilerError
        If the kernel cannot be compiled.
    """
    model, n = task.model, task.count
    states = model.carried[task.carry]
    rows = (*states, *model.outputs)
    moments = np.ascontiguousarray(task.times, dtype=np.float64)
    outcome = into or Outcome.empty(n, task.final, task.sampled, moments.size, len(task.watches))
    zero = np.zeros(1)
    given = [task.inputs.get(s, zero) for s in model.inputs]
    x0 = _Pointers(task.x0.get(s, zero) for s in states)
    p = _Pointers([*given, *(task.parameters[s] for s in model.parameters)])
    signals = _signals(task)
    limits = [np.ascontiguousarray(watch.limit, dtype=np.float64) for watch in task.watches]
    watches = (_Watch * max(1, len(limits)))()
    for k, (limit, watch) in enumerate(zip(limits, task.watches, strict=True)):
        watches[k] = _Watch(
            row=rows.index(watch.row),
            sign=watch.sign,
            ends=watch.ends,
            limit=limit.ctypes.data,
            limit_stride=int(limit.size > 1),
            largest=outcome.largest[k].ctypes.data,
            first=outcome.first[k].ctypes.data,
        )
    final = _Pointers(outcome.final.get(s) for s in states)
    samples = _Pointers(outcome.samples.get(s) for s in rows)
    job = _Job(
        n=n,
        max_steps=_MAX_STEPS,
        threads=useful_threads(threads, -(-n // _LANES[model.stiff])),
        n_times=moments.size,
        n_watches=len(limits),
        observed=task.observed,
        t_end=task.t,
        tol=task.tol,
        x0=x0.address,
        x0_stride=x0.strides,
        p=p.address,
        p_stride=p.strides,
        signals=signals.address if signals else None,
        final=final.address,
        end=outcome.end.ctypes.data,
        cause=outcome.cause.ctypes.data,
        status=outcome.status.ctypes.data,
        steps=outcome.steps.ctypes.data,
        estimate=outcome.estimate.ctypes.data,
        times=moments.ctypes.data,
        samples=samples.address if task.sampled else None,
        watches=ctypes.addressof(watches),
    )
    kernel = _library(model, _ENSEMBLE, task.carry, signals is not None or model.over_time)
    kernel.integrate(ctypes.byref(job))
    return outcome


def _signals(task: Task) -> _Signals | None:
    if not task.signals:
        return None
    zero = np.zeros(1)
    return _Signals(
        [task.signals.get(s) or held(task.inputs.get(s, zero)) for s in task.model.inputs]
    )


class Stepper(threading.local):
    """One trajectory at given times, prepared once: a call takes tens of microseconds.

    Every thread that calls it has arrays of its own, made at its first call.

    Parameters
    ----------
    model : Pack
    times : ndarray
        Ascending times, s; the last ends the integration.
    tol : float
        Error to be kept relative to each state's scale.
    sampled : sequence of str
        Rows of the result.
    signals : mapping of str to Pieces
        Inputs over time; what is given for them in a call does not count.

    Raises
    ------
    NoCompilerError
        If the kernel cannot be compiled.
    """

    def __init__(
        self,
        model: Pack,
        times: FloatArray,
        tol: float,
        sampled: Sequence[str],
        signals: Mapping[str, Pieces] | None = None,
    ) -> None:
        self._given_to = (model, times, tol, sampled, signals)
        carry = smallest(model, sampled)
        states = model.carried[carry]
        rows = (*states, *model.outputs)
        self._start = np.zeros(len(states))
        self._given = np.zeros(len(model.inputs) + len(model.parameters))
        self._samples = np.empty((len(sampled), times.size))
        self._summary = np.zeros(5)  # status, steps, estimate, end, cause: eight bytes each
        self._times = np.array(times, dtype=np.float64)
        self._inputs = len(model.inputs)
        self._order = np.array([model.states.index(s) for s in states])
        constant = np.zeros((self._inputs, 1, 1, 2))  # a time that does not matter, and the value
        self._constant = constant[:, 0, 0, 1]
        self._over_time: _Signals | None = None
        if signals:
            pieces = (Pieces(np.zeros((1, 1)), value) for value in constant)
            named = dict(zip(model.inputs, pieces, strict=True)) | dict(signals)
            self._over_time = _Signals([named[s] for s in model.inputs])
        self._tables = (
            _Pointers(self._start[k : k + 1] for k in range(self._start.size)),
            _Pointers(self._given[k : k + 1] for k in range(self._given.size)),
            _Pointers(self._samples[sampled.index(s)] if s in sampled else None for s in rows),
        )
        x0, p, samples = self._tables
        summary = self._summary.ctypes.data
        self._job = _Job(
            n=1,
            max_steps=_MAX_STEPS,
            threads=1,
            n_times=times.size,
            n_watches=0,
            observed=not set(sampled) <= set(states),
            t_end=float(times[-1]),
            tol=tol,
            x0=x0.address,
            x0_stride=x0.strides,
            p=p.address,
            p_stride=p.strides,
            signals=self._over_time.address if self._over_time else None,
            status=summary,
            steps=summary + 8,
            estimate=summary + 16,
            end=summary + 24,
            cause=summary + 32,
            times=self._times.ctypes.data,
            samples=samples.address,
        )
        self._reference = ctypes.byref(self._job)
        self._trace: Any = _library(
            model, _TRAJECTORY, carry, bool(signals) or model.over_time
        ).trace

    def __reduce__(self) -> tuple[Any, ...]:
        return Stepper, self._given_to

    def __call__(self, x0: FloatArray, u: FloatArray, p: FloatArray) -> FloatArray:
        """Rows over time; NaN after an early end, of which `status` tells the reason."""
        self._start[:] = x0[self._order]
        self._given[: self._inputs] = self._constant[:] = u
        self._given[self._inputs :] = p
        self._trace(self._reference)
        return self._samples.copy()

    @property
    def status(self) -> str:
        """What became of the last trajectory of this thread, one of `STATUS`."""
        return STATUS[int(self._summary.view(np.int8)[0])]

    @property
    def steps(self) -> int:
        """Attempted steps of the last trajectory of this thread."""
        return int(self._summary.view(np.int32)[2])

    @property
    def estimate(self) -> float:
        """Estimated error of the last trajectory, relative to each state's scale."""
        return float(self._summary[2])
