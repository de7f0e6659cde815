"""Many trajectories at once: design sweeps, Monte Carlo, basins of attraction."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from concurrent.futures import Executor
from dataclasses import replace
from typing import Any, TypeVar

import numpy as np
import numpy.typing as npt

from groundroll.aircraft.aircraft import Aircraft, of_aircraft
from groundroll.aircraft.values import given
from groundroll.base.arrays import FloatArray, finite, positive, whole
from groundroll.base.errors import GroundrollError
from groundroll.base.progress import Progress
from groundroll.model.models import Model, ModelLike, as_model
from groundroll.model.names import listed
from groundroll.motion.engine import integrated
from groundroll.motion.events import Lookout, lookout
from groundroll.motion.lanes import STATUS, Outcome
from groundroll.motion.plan import Plan, planned

from .ensemble_result import Ensemble, Named

Number = TypeVar("Number", bound=np.generic)

#: Status of a trajectory that left a range.
_LEFT = STATUS.index("left the range")
#: Most trajectories in a chunk.
_CHUNK = 65_536


@of_aircraft
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
    events: str | Iterable[str] = (),
    until: str | Iterable[str] = (),
    tol: float = 1e-6,
    threads: int | None = None,
    executor: Executor | None = None,
    chunk: int = _CHUNK,
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
        Magnitudes at which a trajectory ends, with the status ``left the range``.
    events : str or iterable of str
        Events of the model whose first time is wanted.
    until : str or iterable of str
        Events of the model at which a trajectory ends, with a state and a time.
    tol : float
        Error of every state relative to its largest magnitude on the trajectory (at least 1e-6
        in SI units), from 1e-11 to 1e-3. It is kept as measured, not as proven: the error is
        estimated along the way and a trajectory that may exceed `tol` is repeated with finer
        steps. Of random aircraft of any kind one in 10 000 exceeded it, by up to three times, most
        were a hundred times better; a tire far beyond its data is worse (see the documentation
        for the distribution).
    threads : int, optional
        Threads for each chunk; every processor if omitted, or one with an executor.
    executor : concurrent.futures.Executor, optional
        Where the chunks run, as pickled jobs: processes, a cluster (``Client.get_executor()`` of
        Dask, ``MPIPoolExecutor`` of mpi4py).
    chunk : int
        Most trajectories in one chunk.
    progress : callable or bool, optional
        Called with the numbers of trajectories done and in all; True draws a bar on a terminal.
    **values : float, array, str, Signal or callable
        Parameters by symbol or full name (``a``, ``speed``), inputs (``disturbance``), constant or
        over time (see `groundroll.signals`), and initial states by symbol and a zero (``v0``,
        ``psi0``; zero if omitted). Arrays broadcast with each other and with the aircraft's own.

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
    model = as_model(model)
    duration, times = positive("t", t, "s"), _times(at, t)
    sorted_out = given(plane, model, values, "ensemble", over_time=True)
    wanted = _names(model, names, times, sorted_out.states)
    look = lookout(model, extremes, limits, within, events, until)
    plan = replace(
        planned(sorted_out, model, duration, tol, times),
        sampled=wanted if times.size else (),
        final=tuple(s for s in wanted if s in model.states),
        watches=look.watches(model),
    )
    found = integrated(
        plan,
        threads=threads,
        executor=executor,
        chunk=whole("chunk", chunk, 1),
        progress=progress,
    )
    return _shaped(plan, look, found)


def _names(
    model: Model, names: Iterable[str] | None, times: FloatArray, start: Mapping[str, Any]
) -> tuple[str, ...]:
    """What is wanted; every state but the path over the ground unless it is given a start."""
    if names is None:
        least = model.carried[max(0, len(model.carried) - 2)]
        return least if start.keys() <= set(least) else model.states
    allowed = (*model.states, *model.outputs) if times.size else model.states
    wanted = (model.symbol(n, "name", allowed, "names") for n in listed("names", names))
    return tuple(dict.fromkeys(wanted))


def _times(at: Any, t: Any) -> FloatArray:
    if at is None:
        return np.empty(0)
    duration = positive("t", t, "s")
    times = np.atleast_1d(finite("at", at, "s"))
    if times.ndim != 1 or times.size == 0 or (np.diff(times) <= 0).any():
        raise GroundrollError("at must be a list of increasing times")
    if times[0] < 0 or times[-1] > duration:
        raise GroundrollError(
            f"at must lie within 0 to t = {duration:g} s, not {times[0]:g} to {times[-1]:g} s"
        )
    return times


def _shaped(plan: Plan, look: Lookout, found: Outcome) -> Ensemble:
    """The result in the shape of the trajectories."""

    def shaped(array: npt.NDArray[Number]) -> npt.NDArray[Number]:
        return array.reshape((*plan.shape, *array.shape[1:]))

    def named(names: Iterable[str], arrays: Iterable[FloatArray], what: str) -> Named:
        each = zip(names, arrays, strict=False)
        return Named({name: shaped(array) for name, array in each}, what, plan.model.key)

    first = dict(zip(look.extremes, found.first, strict=False))
    event = look.first_event
    left = (found.cause >= 0) & (found.cause < event)
    for state in found.final.values():
        state[left] = np.nan
    return Ensemble(
        aircraft=plan.aircraft,
        model=plan.model.key,
        start=plan.start,
        inputs={**plan.inputs, **plan.signals},
        t=plan.t,
        tol=plan.tol,
        status=shaped(np.where(left, _LEFT, found.status).astype(np.int8)),
        steps=shaped(found.steps),
        estimate=shaped(found.estimate),
        end=shaped(found.end),
        fate=shaped(np.maximum(found.cause - event, -1).astype(np.int8)),
        final=named(found.final, found.final.values(), "final states"),
        at=plan.at,
        samples=named(found.samples, found.samples.values(), "samples"),
        largest=named(look.extremes, found.largest, "extremes"),
        first=named(look.limits, (first[s] for s in look.limits), "limits"),
        events=dict(zip(look.events, map(shaped, found.first[event:]), strict=True)),
        limits=dict(look.limits),
        within=dict(look.within),
    )
