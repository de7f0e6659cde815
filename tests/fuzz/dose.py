"""Many inputs of a surface, in processes of their own."""

from __future__ import annotations

import faulthandler
import sys
import tempfile
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor, as_completed
from multiprocessing import get_context
from pathlib import Path

from .calls import calls
from .files import files
from .harness import LIMIT, Surface, Tally, attempt
from .lines import lines
from .results import results

SURFACES: dict[str, Surface] = {"files": files, "calls": calls, "lines": lines, "results": results}
#: Inputs that one process tries before it tells what became of them.
_BLOCK = 500
#: Cases that are printed of each surface.
_SHOWN = 40


def block(surface: str, seed: int, numbers: range) -> Tally:
    """Try some inputs; a process that is stuck in compiled code ends, and says where."""
    tally = Tally()
    with tempfile.TemporaryDirectory() as folder:
        for number in numbers:
            faulthandler.dump_traceback_later(30 * LIMIT, exit=True)
            tally.add(attempt(surface, SURFACES[surface], seed, number, Path(folder)))
    faulthandler.cancel_dump_traceback_later()
    return tally


def dose(
    surface: str, seed: int, count: int, jobs: int, told: Callable[[str], object] = print
) -> Tally:
    """Try so many inputs of a surface, and print what must not happen as it happens."""
    total, done = Tally(), 0
    blocks = [range(n, min(n + _BLOCK, count)) for n in range(0, count, _BLOCK)]
    with ProcessPoolExecutor(jobs, get_context("spawn")) as pool:
        jobs_of = {pool.submit(block, surface, seed, numbers): numbers for numbers in blocks}
        for job in as_completed(jobs_of):
            numbers = jobs_of[job]
            try:
                tally = job.result()
            except Exception as problem:
                tally = Tally()
                tally.counts["exception"] += 1
                tally.bad.append(
                    f"{surface}:{seed}:{numbers.start}… ended the process: {problem!r}"
                )
            for case in tally.bad[: max(0, _SHOWN - len(total.bad))]:
                told(case)
            total.add(tally)
            done += len(numbers)
            if sys.stderr.isatty():
                print(f"\r{surface}: {done} of {count}", end="", file=sys.stderr)
    return total
