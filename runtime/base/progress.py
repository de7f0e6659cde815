"""How far something is: one convention for all that may take longer than a moment."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager

from .interruption import interruptible

#: Called with what is done and how much there is in all, None as long as nobody knows.
Show = Callable[[int, int | None], object]
#: What `progress=` may be; True draws a bar on a terminal.
Progress = Show | bool | None


class Count:
    """Work that is done, of a total that may turn out less or be unknown to the end."""

    def __init__(self, show: Show, total: int | None, check: Callable[[], None]) -> None:
        self._show, self._check = show, check
        self.done, self.total = 0, total

    def add(self, more: int = 1) -> None:
        """So much more is done."""
        self._check()
        self.done += more
        self._show(self.done, self.total)

    def left(self, most: int) -> None:
        """At most so much is left to do."""
        self.total = self.done + most


@contextmanager
def counted(progress: Progress, what: str, total: int | None = None) -> Iterator[Count]:
    """Count work and show it; when the block is left in peace, all of it is done.

    Ctrl-C takes effect when more is done, if not at once.

    Parameters
    ----------
    progress : callable or bool, optional
        See `Progress`.
    what : str
        What is counted, in the plural, for the bar.
    total : int, optional
        How much there is, as far as it is known.
    """
    with interruptible() as check, _shown(progress, what) as show:
        count = Count(show, total, check)
        yield count
        check()
        if count.done != count.total:
            show(count.done, count.done)


@contextmanager
def _shown(progress: Progress, what: str) -> Iterator[Show]:
    if callable(progress):
        yield progress
    elif not progress:
        yield lambda done, total: None
    else:
        from .bar import bar

        with bar(what) as show:
            yield show
