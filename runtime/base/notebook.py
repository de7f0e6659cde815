"""Tables and pictures for a notebook."""

from __future__ import annotations

import base64
from collections.abc import Callable, Iterable, Sequence
from html import escape
from io import BytesIO
from typing import Any

import numpy as np

from .arrays import FloatArray
from .errors import GroundrollError


class Drawing(str):
    """SVG that is ours, and goes into a table as it is."""


_CELL = "text-align:left;padding:1px 8px"


def table(title: str, rows: Iterable[Sequence[str]], notes: Iterable[str] = ()) -> str:
    """A title, a table and lines below it; cells that are drawings stay as they are."""
    lines = []
    for row in rows:
        cells = (cell if isinstance(cell, Drawing) else escape(cell) for cell in row)
        line = "".join(f'<td style="{_CELL}">{cell}</td>' for cell in cells)
        lines.append(f"<tr>{line}</tr>")
    below = "".join(f"<div>{escape(note)}</div>" for note in notes)
    return f"<div>{escape(title)}<table>{''.join(lines)}</table>{below}</div>"


def picture(text: str, plot: Callable[[], Any]) -> str:
    """A text, and what is drawn by `plot` unless there is nothing to draw."""
    from matplotlib import pyplot

    words = f"<pre>{escape(text)}</pre>"
    try:
        drawn = plot()
    except GroundrollError:
        return f"<div>{words}</div>"
    axes = drawn[0] if isinstance(drawn, tuple) else drawn
    figure = getattr(axes, "figure", None) or axes
    buffer = BytesIO()
    figure.savefig(buffer, format="png", dpi=90)
    pyplot.close(figure)
    data = base64.b64encode(buffer.getvalue()).decode()
    return f'<div>{words}<img src="data:image/png;base64,{data}"></div>'


def sparkline(lines: FloatArray, width: int = 120, height: int = 22) -> Drawing:
    """Series as one small picture, at most 60 points each and the first 8 of them."""
    few = lines[:8, np.unique(np.linspace(0, lines.shape[1] - 1, 60).astype(int))]
    low, high = float(few.min()), float(few.max())
    x = np.linspace(1, width - 1, few.shape[1])
    y = height - 2 - (height - 4) * (few - low) / ((high - low) or 1.0)
    paths = (" ".join(f"{a:.1f},{b:.1f}" for a, b in zip(x, row, strict=True)) for row in y)
    drawn = "".join(f'<polyline points="{p}" fill="none" stroke="#0072B2"/>' for p in paths)
    return Drawing(f'<svg width="{width}" height="{height}">{drawn}</svg>')
