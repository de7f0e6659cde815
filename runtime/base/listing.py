"""What results show of themselves: a title and rows of words, or a picture."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, ClassVar

import numpy as np

from groundroll.generated import Quantity

from .wording import number, visible


class Listed:
    """A title, rows of cells and notes below them; in a notebook a table."""

    def _title(self) -> str:
        raise NotImplementedError

    def _rows(self) -> Iterable[Sequence[str]]:
        return ()

    def _notes(self) -> Iterable[str]:
        return ()

    def __repr__(self) -> str:
        rows = [[visible(cell) for cell in row] for row in self._rows()]
        widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
        lines = ["  ".join(map(str.ljust, row, widths)) for row in rows]
        below = (f"  {s}".rstrip() for s in (*lines, *self._notes()))
        return "\n".join([visible(self._title()), *map(visible, below)])

    def _repr_html_(self) -> str:
        from .notebook import table

        return table(self._title(), self._rows(), self._notes())


class Numbers(Listed):
    """Attributes of which each is a number, or an array of them, of a quantity."""

    _of: ClassVar[Mapping[str, Quantity]]

    def __init_subclass__(cls, of: Mapping[str, Quantity]) -> None:
        cls._of = of

    def _title(self) -> str:
        shape = np.broadcast_shapes(*(np.shape(getattr(self, name)) for name in self._of))
        points = f", {' x '.join(map(str, shape))} points" if shape else ""
        return f"{type(self).__name__}{points}"

    def _rows(self) -> Iterable[Sequence[str]]:
        for name, q in self._of.items():
            yield name, span(getattr(self, name)), unit_of(q)


class Pictured:
    """A picture says more than words; in a notebook both are there."""

    def plot(self) -> Any:
        """Draw it."""
        raise NotImplementedError

    def _repr_html_(self) -> str:
        from .notebook import picture

        return picture(repr(self), self.plot)


def span(values: Any) -> str:
    """A number, or the least and the largest of many; what is not finite in words."""
    array = np.asarray(values)
    good = array[np.isfinite(array)]
    if array.size == 1:
        return number(array.item())
    if not good.size:
        return "nowhere finite"
    some = "" if good.size == array.size else f" ({good.size} of {array.size} finite)"
    ends = dict.fromkeys((number(good.min()), number(good.max())))
    return f"{' to '.join(ends)}{some}"


def unit_of(q: Quantity) -> str:
    """Unit of a quantity; a pure number has none."""
    return "" if q.unit == "1" else q.unit
