"""Many trajectories at once: design sweeps, Monte Carlo, basins of attraction."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from concurrent.futures import Executor
from functools import partial
from typing import Any

from .aircraft import Aircraft
from .chunks import cut, run, thread_count
from .ensemble_plan import plan, watching
from .ensemble_result import Ensemble
from .memory import check_memory
from .models import ModelLike
from .motion import lanes
from .motion.lanes import Outcome, Task
from .motion.virtual import integrate_in_vm
from .progress import Progress, counted


def ensemble(
    plane: Aircraft,
    t: float | str = 5.0,
    model: ModelLike = "nonlinear",
    *,
    at: Any = None,
    names: Iterable[str] | None = None,
    extremes: Iterable[str] = (),
    limits: Mapping[str, float | str] | None = None,
    within: Mapping[str, float | str] | None = None,
    tol: float = 1e-6,
    threads: int | None = None,
    executor: Executor | None = None,
    chunk: int = 65_536,
    progress: Progress = None,
    **values: Any,
) -> Ensemble:
    """Simulate many ground rolls at once, hands off.

    Results are the same to the last bit for any number of threads, chunks and workers on
    processors of one kind. Beside the result, memory stays bounded: chunks are made and
    integrated one after the other.

    Parameters
    ----------
    plane : Aircraft
        The aircraft; its parameters may be arrays.
    t : float
        Duration, s.
    model : str or Model
        ``"linear"`` or ``"nonlinear"``.
    at : sequence of float, optional
        Increasing times, s, from 0 to `t` at which to sample; only final states if omitted.
    names : iterable of str, optional
        States that are wanted, and outputs with `at`. Default: every state but the path over the
        ground (X, Y), which costs half as much again.
    extremes : iterable of str
        States and outputs whose largest magnitude is wanted.
    limits : mapping of str to float, optional
        Magnitudes whose first passing is wanted, by state or output, SI units with radians.
    within : mapping of str to float, optional
        Magnitudes beyond which a trajectory ends, with the status ``left the range``.
    tol : float
        Error of every state relative to its largest magnitude on the trajectory (at least 1e-6
        in SI units), from 1e-11 to 1e-3. It is kept as measured, not as proven: the error is
        estimated along the way and a trajectory that may exceed `tol` is repeated with finer
        steps; over a million trajectories of every kind that was tried, of which most were a
        hundred times better, a few in 100 000 that pass close by an unstable equilibrium
        exceeded it (see the documentation for the distribution).
    threads : int, optional
        Threads for each chunk; every processor if omitted, or one with an executor.
    executor : concurrent.futures.Executor, optional
        Where the chunks run, as pickled jobs: processes, a cluster (``Client.get_executor()`` of
        Dask, ``MPIPoolExecutor`` of mpi4py).
    chunk : int
        Most trajectories in one chunk.
    progress : callable or bool, optional
        Called with the numbers of trajectories done and in all; True draws a bar on a terminal.
    **values : float or array
        Parameters by symbol or full name (``a``, ``speed``), ``disturbance``, and initial states
        by symbol and a zero (``v0``, ``psi0``; zero if omitted). Arrays broadcast with each other
        and with the aircraft's own.

    Returns
    -------
    Ensemble
        Arrays by name, and the status of every trajectory.

    Raises
    ------
    GroundrollError
        For unknown names, values that cannot be, shapes that do not broadcast, or more memory
        than there is, before any work starts.
    """
    asked = plan(plane, t, model, at, names, tol, chunk, values)
    asked = watching(asked, extremes, limits or {}, within or {})
    count = thread_count(threads if executor is None or threads is not None else 1)
    total = math.prod(asked.shape)
    check_memory(asked.bytes_each * total, "the results")
    chunks = cut(total, asked.chunk)
    if len(chunks) > 1 and asked.follows:
        for each in chunks:
            asked.task(each)  # what cannot be is found before any work starts
    result = asked.empty_result()
    work, keep = partial(_integrate, threads=count), partial(_keep, result)
    with counted(progress, "trajectories", total) as done:
        run(work, chunks, asked.task, keep, done.add, executor)
    return asked.shaped(result)


def _integrate(task: Task, threads: int) -> Outcome:
    """One chunk, wherever this runs."""
    if lanes.can_compile(task.model):
        return lanes.integrate(task, threads)
    return integrate_in_vm(task)


def _keep(result: Outcome, chunk: range, found: Outcome) -> None:
    """Put what came of a chunk where it belongs."""
    where = slice(chunk.start, chunk.stop)
    for name in ("status", "steps", "estimate", "end", "cause", "largest", "first"):
        getattr(result, name)[..., where] = getattr(found, name)
    for kind in ("final", "samples"):
        for name, array in getattr(result, kind).items():
            array[where] = getattr(found, kind)[name]
