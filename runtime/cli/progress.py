"""Signs of life on a terminal; silence elsewhere."""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from typing import Any

import click


@contextmanager
def progress() -> Iterator[Callable[[str, int, int], None]]:
    """Yield a function of (what is being done, steps done, steps in all) that shows a bar."""
    with ExitStack() as stack:
        bars: list[Any] = []

        def show(label: str, done: int, total: int) -> None:
            if not bars:
                hidden = not sys.stderr.isatty()
                bar = click.progressbar(
                    length=total,
                    file=sys.stderr,
                    hidden=hidden,
                    item_show_func=lambda item: item,
                )
                bars.append(stack.enter_context(bar))
            bars[0].update(done - bars[0].pos, label)

        yield show


@contextmanager
def patience(message: str = "computing (the first run compiles)") -> Iterator[None]:
    """After a second, say on a terminal that something is under way; wipe it out at the end."""
    if not sys.stderr.isatty():
        yield
        return
    shown = threading.Event()

    def show() -> None:
        shown.set()
        click.echo(f"{message} ...", err=True, nl=False)

    timer = threading.Timer(1.0, show)
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()
        if shown.is_set():
            click.echo("\r\033[K", err=True, nl=False)
