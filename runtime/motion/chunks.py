"""Work cut into chunks: bounded memory, interruption, any executor."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Executor, Future, wait
from typing import Any, TypeVar

import numpy as np

from groundroll.base.arrays import FloatArray, whole
from groundroll.generated.kernels import processors

T = TypeVar("T")
R = TypeVar("R")

#: Chunks that wait at an executor, so that it never idles and memory stays bounded.
_WAITING = 32


def run(
    work: Callable[[T], R],
    chunks: Sequence[range],
    task: Callable[[range], T],
    keep: Callable[[range, R], object],
    callback: Callable[[int], object],
    executor: Executor | None = None,
) -> None:
    """Do `work` on the task of every chunk and `keep` what comes of it.

    Ctrl-C takes effect between chunks; what waits at the executor is cancelled.

    Parameters
    ----------
    work : callable
        To be pickled if there is an executor.
    chunks : sequence of range
        What each task is about.
    task, keep : callable
        Make a task; put its result away. Both run here.
    callback : callable
        Called with the length of each chunk that is done.
    executor : concurrent.futures.Executor, optional
        Where `work` runs; here if omitted.
    """
    for chunk, result in _results(work, chunks, task, executor):
        keep(chunk, result)
        callback(len(chunk))


def _results(
    work: Callable[[T], R],
    chunks: Sequence[range],
    task: Callable[[range], T],
    executor: Executor | None,
) -> Iterator[tuple[range, R]]:
    if executor is None:
        yield from ((chunk, work(task(chunk))) for chunk in chunks)
        return
    waiting: dict[Future[R], range] = {}
    rest = iter(chunks)
    try:
        while True:
            while len(waiting) < _WAITING and (chunk := next(rest, None)) is not None:
                waiting[executor.submit(work, task(chunk))] = chunk
            if not waiting:
                return
            for future in wait(waiting, return_when=FIRST_COMPLETED).done:
                yield waiting.pop(future), future.result()
    finally:
        for future in waiting:
            future.cancel()


def cut(total: int, size: int) -> list[range]:
    """Consecutive ranges of at most `size` that cover 0 to `total`."""
    return [range(start, min(start + size, total)) for start in range(0, total, size)]


def piece(array: FloatArray, shape: tuple[int, ...], chunk: range) -> FloatArray:
    """Part of an array that broadcasts to `shape`, in that shape's flat order; scalars stay."""
    if array.size == 1:
        return array.reshape(())
    whole = np.broadcast_to(array, shape)
    if whole.flags.c_contiguous:
        return whole.reshape(-1)[chunk.start : chunk.stop]
    return np.asarray(whole.flat[chunk.start : chunk.stop])


def thread_count(threads: Any) -> int:
    """Number of threads to use; every processor this process may run on if None.

    Where the work is done no more are made than help there.
    """
    return processors() if threads is None else whole("threads", threads, 1)
