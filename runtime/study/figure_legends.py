"""What the lines of the figures are called, and where that stands."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.lines import Line2D

from .sources import figure_words, trials

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from groundroll.base.arrays import FloatArray

_ONE_ROW = 60  # letters of a legend, a line sample counted as six


def place_legend(axis: Axes, handles: Sequence[Line2D]) -> None:
    """Above the axes, where no line can run through it."""
    letters = sum(6 + len(str(handle.get_label())) for handle in handles)
    axis.legend(
        handles=list(handles),
        loc="lower left",
        bbox_to_anchor=(0.0, 1.0),
        ncols=len(handles) if letters < _ONE_ROW else 2,
        borderaxespad=0.3,
    )


def trial_label(number: int, among: Sequence[int]) -> str:
    """The trial and what tells it from the others."""
    words = []
    for key, pattern in figure_words("labels").items():
        values = [trials()[other].changes.get(key) for other in among]
        if len(set(values)) > 1:
            words.append(pattern.format(_short(str(trials()[number].changes[key]))))
    return ", ".join([f"Trial {number}", *words])


def _short(quantity: str) -> str:
    number, _, unit = quantity.partition(" ")
    return f"{float(number):.4g} {unit}"


def sorted_pair(levels: FloatArray, places: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Levels in increasing order, with their places."""
    order = np.argsort(levels)
    return levels[order], places[order]
