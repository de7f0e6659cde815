"""One input after the other: what became of each, and the sum of that."""

from __future__ import annotations

import signal
import time
import traceback
import warnings
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from groundroll.base.errors import GroundrollError
from groundroll.model.names import MODELS as _MODELS

#: Seconds of the processor that an input may take.
LIMIT = 10.0
#: Every model there is; what else is to be attacked, is added here.
MODELS = tuple(_MODELS)

#: What may become of an input. The last four must not happen.
VERDICTS = ("refused", "answered", "not judged", "wrong", "exception", "hang", "left behind")
BAD = VERDICTS[3:]


class Hang(BaseException):
    """Raised within whatever takes too long."""


@dataclass(frozen=True)
class Case:
    """One input.

    Attributes
    ----------
    shown : str
        The input, in words.
    run : callable
        Gives an answer, or raises `GroundrollError`.
    judge : callable
        What is wrong with an answer: "" if nothing is, None if nobody can tell.
    """

    shown: str
    run: Callable[[], Any]
    judge: Callable[[Any], str | None]


#: Makes an input for a model from a random generator, in an empty folder.
Surface = Callable[[np.random.Generator, str, Path], Case]


@dataclass
class Tally:
    """What became of many inputs, and what to look at."""

    counts: Counter[str] = field(default_factory=Counter)
    bad: list[str] = field(default_factory=list)
    slowest: float = 0.0

    def add(self, other: Tally) -> None:
        self.counts += other.counts
        self.bad += other.bad
        self.slowest = max(self.slowest, other.slowest)

    def __str__(self) -> str:
        parts = [f"{self.counts.total()} tried", *(f"{self.counts[v]} {v}" for v in VERDICTS)]
        return f"{', '.join(parts)}; the slowest took {self.slowest:.1f} s"


def generator(surface: str, seed: int, number: int) -> np.random.Generator:
    """The source of randomness of one input."""
    return np.random.default_rng([seed, number, *surface.encode()])


def attempt(
    name: str, surface: Surface, seed: int, number: int, folder: Path, limit: float = LIMIT
) -> Tally:
    """Try one input, in a folder that is empty before and after."""
    rng = generator(name, seed, number)
    case = surface(rng, MODELS[number % len(MODELS)], folder)
    before, begin = _names(folder), time.process_time()
    verdict, why = _verdict(case, limit)
    took = time.process_time() - begin
    if verdict == "refused" and _names(folder) != before:
        verdict, why = "left behind", f"{_names(folder)} for {before}"
    for path in folder.iterdir():
        path.unlink()
    where = f"{name}:{seed}:{number}"
    bad = [f"{where} {verdict}: {case.shown[:3000]}\n    {why[-3000:]}"] if verdict in BAD else []
    return Tally(Counter([verdict]), bad, took)


def _names(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir())


def _verdict(case: Case, limit: float) -> tuple[str, str]:
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        try:
            with _timed(limit):
                answer = case.run()
        except GroundrollError as problem:
            return ("refused", "") if str(problem).strip() else ("exception", "no words")
        except (Hang, KeyboardInterrupt):  # which solvers make of it
            return "hang", traceback.format_exc()
        except Exception:
            return "exception", traceback.format_exc()
        leaks = [
            w for w in said if issubclass(w.category, RuntimeWarning) and _leaks(str(w.message))
        ]
        if leaks:
            return "exception", f"a warning leaks: {leaks[0]}"
        try:
            wrong = case.judge(answer)
        except Exception:
            return "wrong", f"cannot be judged: {traceback.format_exc()}"
    if wrong is None:
        return "not judged", ""
    return ("wrong", wrong) if wrong else ("answered", "")


def _leaks(message: str) -> bool:
    """Whether a warning is NumPy's."""
    return "encountered in" in message or "divide by zero" in message


@contextmanager
def _timed(limit: float) -> Iterator[None]:
    """Raise `Hang` after so many seconds of the processor, or after ten times as many of waiting.

    Others may want the processor, and a library is compiled once for a machine, in a process of
    its own.
    """

    def ring(number: int, frame: Any) -> None:
        raise Hang

    clocks = {
        signal.SIGPROF: (signal.ITIMER_PROF, limit),
        signal.SIGALRM: (signal.ITIMER_REAL, 10 * limit),
    }
    before = {number: signal.signal(number, ring) for number in clocks}
    begin = time.process_time()
    for timer, most in clocks.values():
        signal.setitimer(timer, most)
    try:
        yield
    finally:
        for number, (timer, _) in clocks.items():
            signal.setitimer(timer, 0)
            signal.signal(number, before[number])
    if time.process_time() - begin > limit:  # compiled code is not interrupted
        raise Hang
