"""Signs of life on a terminal, of what takes longer than a moment; silence elsewhere."""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from typing import TYPE_CHECKING, Any

import click

if TYPE_CHECKING:
    from .progress import Show

#: Seconds in which nothing is shown: most commands are done by then.
_MOMENT = 1.0
_PATIENCE = "computing ..."
_WIPE, _WIPE_ABOVE = "\r\033[K", "\033[A\r\033[K"


@contextmanager
def bar(what: str = "") -> Iterator[Show]:
    """Yield a function of (done, total) that shows a bar, or a count while no total is known.

    Before it is told anything a line of patience stands there; at the end all is wiped out.
    """
    if sys.stderr is None or not sys.stderr.isatty():
        yield lambda done, total: None
        return
    begin = time.time()
    with ExitStack() as stack:
        waiting = stack.enter_context(ExitStack())
        waiting.enter_context(_patience())
        drawn: list[Any] = []

        def show(done: int, total: int | None) -> None:
            if time.time() - begin < _MOMENT:
                return
            if not drawn:
                waiting.close()
                drawn.append(_bar(what, total))
                drawn[0].start, drawn[0].pos = begin, done
                stack.callback(_say, _WIPE_ABOVE)
                stack.enter_context(drawn[0])
            drawn[0].length = total
            drawn[0].update(done - drawn[0].pos)

        yield show


def _bar(what: str, total: int | None) -> Any:
    if total is None:
        count: Any = {"bar_template": "%(info)s %(label)s ...", "show_pos": True}
        return click.progressbar(iter(int, 1), label=what, file=sys.stderr, **count)
    return click.progressbar(length=total, label=what, file=sys.stderr)


@contextmanager
def _patience() -> Iterator[None]:
    """After a moment, say that something is under way; wipe it out at the end."""
    shown = threading.Event()

    def show() -> None:
        shown.set()
        _say(_PATIENCE)

    timer = threading.Timer(_MOMENT, show)
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()
        timer.join()
        if shown.is_set():
            _say(_WIPE)


def _say(text: str) -> None:
    with suppress(OSError):
        click.echo(text, err=True, nl=False)
