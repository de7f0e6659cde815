"""Ctrl-C, of which foreign code now and then makes another error, or nothing at all."""

from __future__ import annotations

import signal
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any


@contextmanager
def ended() -> Iterator[list[int]]:
    """Let what asks the process to end do as Ctrl-C does, so that nothing is left behind.

    Yields a list that has the number of the signal from then on.
    """
    by: list[int] = []

    def end(number: int, frame: Any) -> None:
        by.append(number)
        interrupt = signal.getsignal(signal.SIGINT)
        if callable(interrupt):
            interrupt(signal.SIGINT, frame)
        raise KeyboardInterrupt

    mine = threading.current_thread() is threading.main_thread()
    wanted = (getattr(signal, name, None) for name in ("SIGTERM", "SIGHUP"))
    ours = [s for s in wanted if mine and s and signal.getsignal(s) is signal.SIG_DFL]
    for number in ours:
        signal.signal(number, end)
    try:
        yield by
    finally:
        for number in ours:
            signal.signal(number, signal.SIG_DFL)


@contextmanager
def interruptible() -> Iterator[Callable[[], None]]:
    """Let Ctrl-C end the block with KeyboardInterrupt, whatever becomes of it on its way.

    Yields a function to call now and then: it raises what got lost.
    """
    before, report = signal.getsignal(signal.SIGINT), sys.unraisablehook
    pressed: list[int] = []

    def press(number: int, frame: Any) -> Any:
        pressed.append(number)
        return before(number, frame) if callable(before) else None

    def quiet(lost: Any) -> None:
        if not isinstance(lost.exc_value, KeyboardInterrupt):
            report(lost)

    def check() -> None:
        if pressed:
            raise KeyboardInterrupt

    if not callable(before) or threading.current_thread() is not threading.main_thread():
        yield check
        return
    signal.signal(signal.SIGINT, press)
    sys.unraisablehook = quiet
    try:
        yield check
    except Exception as problem:
        if pressed:
            raise KeyboardInterrupt from problem
        raise
    finally:
        sys.unraisablehook = report
        signal.signal(signal.SIGINT, before)
