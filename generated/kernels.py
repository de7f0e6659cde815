# Generated from derive/ with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`.
"""Kernels for many aircraft at once: compiled on first use, called with NumPy arrays.

They are compiled for the processor at hand, so AVX2 or AVX-512 is used where it is there, and
cached under a name that tells processors apart. A compiler that does not know every flag gets
fewer of them.
"""

from __future__ import annotations

import ctypes
import os
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from .compiler import NoCompilerError, opened
from .library import compiled, say_once, say_slower
from .packs import Kernel, Pack

FloatArray = npt.NDArray[np.float64]

_ALWAYS = ("-fPIC", "-shared", "-std=gnu11")
_NATIVE = ("-O3", "-march=native", "-fno-math-errno", *_ALWAYS)
#: Flags by how much they ask of the compiler. Never -ffast-math. The last three of the first set
#: keep gcc from taking selections in polynomials apart into paths, which costs a third.
_FLAGS = (
    (
        *(*_NATIVE, "-fopenmp", "-fno-trapping-math", "-mprefer-vector-width=512"),
        *("-fno-thread-jumps", "-fno-code-hoisting", "-fno-tree-pre"),
    ),
    (*_NATIVE, "-fopenmp"),
    _NATIVE,
    ("-O2", *_ALWAYS),
)
#: So that closed forms are the same bits as in CasADi's virtual machine.
_UNCONTRACTED = "-ffp-contract=off"
#: Attempted steps after which a trajectory is given up.
_MAX_STEPS = 100_000

#: What became of a trajectory, by the kernels' code.
STATUS = (
    "ok",
    "not finite",
    "step limit",
    "unsure",
    "left the range",
)


#: OpenMP's threads do not survive a fork; a child that used them would wait for ever.
_forked = False


def _after_fork() -> None:
    global _forked
    _forked = True


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_after_fork)


def processors() -> int:
    """How many processors this process may run on."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _useful(threads: int, count: int) -> int:
    """As many threads as help: OpenMP ends the process if it cannot make all it is asked for."""
    return 1 if _forked else max(1, min(threads, count, processors()))


class _Job(ctypes.Structure):
    """``job_t`` of ``ensemble.c``."""

    _fields_ = (
        *((name, ctypes.c_int64) for name in ("n", "max_steps", "threads", "n_times", "observed")),
        *((name, ctypes.c_double) for name in ("t_end", "tol")),
        *((name, ctypes.c_void_p) for name in ("x0", "x0_stride", "p", "p_stride", "final")),
        *((name, ctypes.c_void_p) for name in ("status", "steps", "estimate", "times", "samples")),
        *((name, ctypes.c_void_p) for name in ("limit", "range", "largest", "first")),
    )


@dataclass(frozen=True)
class Outcome:
    """What became of some trajectories; rows are named as in `rows`.

    Attributes
    ----------
    status : ndarray of int8, shape (n,)
        An index of `STATUS`.
    steps : ndarray of int32, shape (n,)
        Attempted steps.
    estimate : ndarray, shape (n,)
        Estimated error relative to each state's scale.
    final : dict of ndarray, each of shape (n,)
        States at the end; NaN if the end was not reached.
    samples : dict of ndarray, each of shape (n, times)
        Rows at the times; NaN after an early end.
    largest, first : dict of ndarray, each of shape (n,)
        Largest |row|, and the first time at which it reached its limit, infinite if never.
    """

    status: npt.NDArray[np.int8]
    steps: npt.NDArray[np.int32]
    estimate: FloatArray
    final: dict[str, FloatArray]
    samples: dict[str, FloatArray]
    largest: dict[str, FloatArray]
    first: dict[str, FloatArray]


@dataclass(frozen=True)
class Task:
    """Some trajectories to integrate, small enough to be sent elsewhere.

    Attributes
    ----------
    kernel : Kernel
        One of a pack's.
    x0, p : tuple of ndarray
        Initial states, in the order of the kernel; inputs, then parameters. Each has one value
        for all trajectories or one for each.
    count : int
        Number of trajectories.
    t, tol : float
        Duration, s, and the error to be kept relative to each state's scale.
    times : ndarray
        Ascending times, s, at which the rows `sampled` are wanted.
    sampled, watched : tuple of str
        Rows to sample, and rows of which the extremes are wanted.
    limits, within : dict of float
        Per row the magnitude whose first passing is sought, and the one that ends a trajectory;
        the rows are among those watched.
    """

    kernel: Kernel
    x0: tuple[FloatArray, ...]
    p: tuple[FloatArray, ...]
    count: int
    t: float
    tol: float
    times: FloatArray
    sampled: tuple[str, ...]
    watched: tuple[str, ...]
    limits: dict[str, float]
    within: dict[str, float]


def can_compile(kernel: Kernel) -> bool:
    """Whether a kernel can be compiled here; says so once if not."""
    try:
        _load(kernel.source + "_ensemble", kernel.digest, "integrate")
    except NoCompilerError as problem:
        say_once(
            "kernels",
            f"{problem}; ensembles run in CasADi's virtual machine, hundreds of times slower",
        )
        return False
    return True


def integrate(task: Task, threads: int = 1) -> Outcome:
    """Integrate every trajectory of a task; its bits do not depend on the number of threads.

    Raises
    ------
    NoCompilerError
        If the kernel cannot be compiled.
    """
    names, states = task.kernel.rows, task.kernel.states
    n, moments = task.count, np.ascontiguousarray(task.times, dtype=np.float64)
    outcome = Outcome(
        status=np.empty(n, np.int8),
        steps=np.empty(n, np.int32),
        estimate=np.empty(n),
        final={s: np.empty(n) for s in states},
        samples={s: np.empty((n, moments.size)) for s in task.sampled},
        largest={s: np.empty(n) for s in task.watched},
        first={s: np.empty(n) for s in task.watched},
    )
    arguments = _Pointers([*task.x0, *task.p])
    limit, leave = (
        np.array([bound.get(s, np.inf) for s in names]) for bound in (task.limits, task.within)
    )
    tables = {
        "final": _Pointers(outcome.final.get(s) for s in states),
        "samples": _Pointers(outcome.samples.get(s) for s in names),
        "largest": _Pointers(outcome.largest.get(s) for s in names),
        "first": _Pointers(outcome.first.get(s) for s in names),
    }
    wanted = {*task.sampled, *task.watched}
    job = _Job(
        n=n,
        max_steps=_MAX_STEPS,
        threads=_useful(threads, n),
        n_times=moments.size,
        observed=not wanted <= set(states),
        t_end=task.t,
        tol=task.tol,
        x0=arguments.address(),
        x0_stride=arguments.stride_address(),
        p=arguments.address(len(task.x0)),
        p_stride=arguments.stride_address(len(task.x0)),
        final=tables["final"].address(),
        status=outcome.status.ctypes.data,
        steps=outcome.steps.ctypes.data,
        estimate=outcome.estimate.ctypes.data,
        times=moments.ctypes.data,
        samples=tables["samples"].address() if task.sampled else None,
        limit=limit.ctypes.data,
        range=leave.ctypes.data,
        largest=tables["largest"].address() if task.watched else None,
        first=tables["first"].address(),
    )
    library = _load(task.kernel.source + "_ensemble", task.kernel.digest, "integrate")
    library.integrate(ctypes.byref(job))
    return outcome


class _Pointers:
    """A C array of pointers to arrays (or NULL), and one of their strides: 0 for one value."""

    def __init__(self, arrays: Any) -> None:
        self._arrays = [None if a is None else _contiguous(a) for a in arrays]
        data = [None if a is None else a.ctypes.data for a in self._arrays]
        self._pointers = (ctypes.c_void_p * len(data))(*data)
        strides = [int(a is not None and a.size > 1) for a in self._arrays]
        self._strides = (ctypes.c_int64 * len(data))(*strides)

    def address(self, start: int = 0) -> int:
        return ctypes.addressof(self._pointers) + 8 * start

    def stride_address(self, start: int = 0) -> int:
        return ctypes.addressof(self._strides) + 8 * start


def _contiguous(array: FloatArray) -> FloatArray:
    return array if array.flags.c_contiguous else np.ascontiguousarray(array)


class Stepper:
    """One trajectory at given times, prepared once: a call takes tens of microseconds.

    Parameters
    ----------
    kernel : Kernel
        One of a pack's.
    times : ndarray
        Ascending times, s; the last ends the integration.
    tol : float
        Error to be kept relative to each state's scale.
    sampled : sequence of str
        Rows of the result.

    Raises
    ------
    NoCompilerError
        If the kernel cannot be compiled.
    """

    def __init__(
        self, kernel: Kernel, times: FloatArray, tol: float, sampled: Sequence[str]
    ) -> None:
        names, states = kernel.rows, kernel.states
        self._start = np.zeros(len(states))
        self._given = np.zeros(len(kernel.inputs) + len(kernel.parameters))
        self._samples = np.empty((len(sampled), times.size))
        self._summary = np.zeros(3)  # status, steps and estimate, eight bytes each
        self._times = np.array(times, dtype=np.float64)
        self._inputs = len(kernel.inputs)
        self._order = np.array([kernel.order.index(s) for s in states])
        self._tables = (
            _Pointers(self._start[k : k + 1] for k in range(self._start.size)),
            _Pointers(self._given[k : k + 1] for k in range(self._given.size)),
            _Pointers(None for _ in states),
            _Pointers(self._samples[sampled.index(s)] if s in sampled else None for s in names),
        )
        x0, p, final, samples = self._tables
        summary = self._summary.ctypes.data
        self._job = _Job(
            n=1,
            max_steps=_MAX_STEPS,
            threads=1,
            n_times=times.size,
            observed=not set(sampled) <= set(states),
            t_end=float(times[-1]),
            tol=tol,
            x0=x0.address(),
            x0_stride=x0.stride_address(),
            p=p.address(),
            p_stride=p.stride_address(),
            final=final.address(),
            status=summary,
            steps=summary + 8,
            estimate=summary + 16,
            times=self._times.ctypes.data,
            samples=samples.address(),
        )
        self._reference = ctypes.byref(self._job)
        self._trace = _load(kernel.source + "_trajectory", kernel.digest, "trace").trace

    def __call__(self, x0: FloatArray, u: FloatArray, p: FloatArray) -> FloatArray:
        """Rows over time; NaN after an early end, of which `status` tells the reason."""
        self._start[:] = x0[self._order]
        self._given[: self._inputs] = u
        self._given[self._inputs :] = p
        self._trace(self._reference)
        return self._samples.copy()

    @property
    def status(self) -> str:
        """What became of the last trajectory, one of `STATUS`."""
        return STATUS[int(self._summary.view(np.int8)[0])]

    @property
    def steps(self) -> int:
        """Attempted steps of the last trajectory."""
        return int(self._summary.view(np.int32)[2])

    @property
    def estimate(self) -> float:
        """Estimated error of the last trajectory, relative to each state's scale."""
        return float(self._summary[2])


def can_sweep(pack: Pack, function: str) -> bool:
    """Whether a function has a kernel for many points, and that can be compiled here."""
    if function not in pack.sweeps:
        return False
    try:
        _sweeper(pack, function)
    except NoCompilerError as problem:
        say_slower(problem)
        return False
    return True


def sweep(
    pack: Pack,
    function: str,
    count: int,
    arguments: Sequence[FloatArray],
    results: Sequence[FloatArray | None],
    threads: int = 1,
) -> None:
    """Apply a function of named scalars to many points, in place.

    Parameters
    ----------
    pack, function : Pack and str
        One of the pack's sweeps.
    count : int
        Number of points.
    arguments, results : sequence of ndarray, each of `count` elements
        In the order of the function. An argument may be a single number, of shape (1,); a result
        that is None is not kept.
    threads : int
        Does not change a bit of the result.

    Raises
    ------
    NoCompilerError
        If there is no C compiler.
    """
    given, made = _Pointers(arguments), _Pointers(results)
    sweeper = _sweeper(pack, function)
    sweeper(count, _useful(threads, count), given.address(), given.stride_address(), made.address())


@cache
def _sweeper(pack: Pack, function: str) -> Any:
    source, symbol = str(pack.sources / pack.sweeps[function]), f"sweep_{function}"
    kernel = getattr(_load(source, pack.digest, symbol, _UNCONTRACTED), symbol)
    kernel.argtypes = (ctypes.c_int64, ctypes.c_int64, *[ctypes.c_void_p] * 3)
    return kernel


@cache
def _load(source: str, digest: str, symbol: str, *more: str) -> ctypes.CDLL:
    """A kernel's library with this function, compiled with the first flags that give one."""
    problem = NoCompilerError(f"{source} was not compiled")
    for flags in _FLAGS:
        try:
            library = compiled(Path(f"{source}.c"), digest, (*flags, *more), symbol=symbol)
            return opened(library, symbol)
        except NoCompilerError as found:
            problem = found
    raise problem
