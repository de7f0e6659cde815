"""The one engine behind `simulate`, `ensemble` and whatever else needs trajectories."""

from __future__ import annotations

from concurrent.futures import Executor
from functools import partial

from groundroll.base.memory import check_memory
from groundroll.base.progress import Progress, counted

from . import lanes
from .chunks import cut, run, thread_count
from .lanes import Outcome, Task
from .plan import Plan
from .virtual import integrate_in_vm


def integrated(
    plan: Plan,
    *,
    threads: int | None = None,
    executor: Executor | None = None,
    chunk: int | None = None,
    progress: Progress = None,
) -> Outcome:
    """Integrate all trajectories of a plan.

    Results are the same to the last bit for any number of threads, chunks and workers on
    processors of one kind.

    Parameters
    ----------
    plan : Plan
    threads : int, optional
        Threads for each chunk; every processor if omitted, or one with an executor.
    executor : concurrent.futures.Executor, optional
        Where the chunks run, as pickled tasks.
    chunk : int, optional
        Most trajectories in one chunk.
    progress : callable or bool, optional
        Called with the numbers of trajectories done and in all.

    Raises
    ------
    GroundrollError
        If the results take more memory than there is, or a parameter cannot be, before any work
        starts.
    """
    count = thread_count(threads if executor is None or threads is not None else 1)
    check_memory(plan.bytes_each * plan.count, "the results")
    chunks = cut(plan.count, min(plan.chunk, chunk or plan.chunk))
    if len(chunks) > 1 and plan.follows:
        for each in chunks:
            plan.task(each)  # what cannot be is found before any work starts
    result = plan.room()
    with counted(progress, "trajectories", plan.count) as done:
        if executor is not None:
            work, keep = partial(integrate, threads=count), partial(_keep, result)
            run(work, chunks, plan.task, keep, done.add, executor)
        else:
            for each in chunks:
                integrate(plan.task(each), count, result.part(each))
                done.add(len(each))
    return result


def integrate(task: Task, threads: int = 1, into: Outcome | None = None) -> Outcome:
    """One chunk, wherever this runs."""
    if lanes.can_compile(task.model):
        return lanes.integrate(task, threads, into)
    found = integrate_in_vm(task)
    if into is not None:
        _copy(found, into)
    return found


def _keep(result: Outcome, chunk: range, found: Outcome) -> None:
    """Put what came of a chunk where it belongs."""
    _copy(found, result.part(chunk))


def _copy(found: Outcome, into: Outcome) -> None:
    for name in ("status", "steps", "estimate", "end", "cause", "largest", "first"):
        getattr(into, name)[...] = getattr(found, name)
    for kind in ("final", "samples"):
        for name, array in getattr(into, kind).items():
            array[...] = getattr(found, kind)[name]
