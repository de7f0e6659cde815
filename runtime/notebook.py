"""Results in a notebook."""

from __future__ import annotations

from collections.abc import Iterable
from html import escape
from typing import TYPE_CHECKING

import numpy as np

from .arrays import FloatArray
from .generated.names import QUANTITIES
from .linearization import READ_OFF

if TYPE_CHECKING:
    from .linearization import Linearization
    from .simulation import Trajectory

_STYLE = "text-align:right;padding:1px 8px"


def run_to_html(run: Trajectory) -> str:
    """A run as a small table with a picture of each series, for a notebook."""
    rows = [
        (
            f"{QUANTITIES[name].name.replace('_', ' ')} ({name})",
            _sparkline(series.reshape(-1, run.t.size)),
            f"{np.abs(series).max():.4g}",
            f"{float(series[..., -1]):.4g}" if series.ndim == 1 else "",
            QUANTITIES[name].unit,
        )
        for name, series in run.values.items()
    ]
    title = repr(run).splitlines()[0]
    return _html(title, ("", "over time", "largest", "at the end", "unit"), rows)


def linearization_to_html(lin: Linearization) -> str:
    """A linearization as a small table, for a notebook."""
    title = repr(lin).splitlines()[0]
    if lin.decay_rate.ndim:
        return f"<div>{escape(repr(lin)).replace(chr(10), '<br>')}</div>"
    numbers = [
        (f"eigenvalue {k}", f"{complex(root):.5g}", "1/s")
        for k, root in enumerate(lin.eigenvalues, start=1)
    ]
    numbers += [
        (name.replace("_", " "), f"{float(getattr(lin, name)):.5g}", QUANTITIES[name].unit)
        for name in READ_OFF
    ]
    return _html(title, ("", "value", "unit"), numbers)


def _sparkline(lines: FloatArray, width: int = 120, height: int = 22) -> str:
    """Series as one small picture, at most 60 points each and the first 8 of them."""
    few = lines[:8, np.unique(np.linspace(0, lines.shape[1] - 1, 60).astype(int))]
    low, high = float(few.min()), float(few.max())
    x = np.linspace(1, width - 1, few.shape[1])
    y = height - 2 - (height - 4) * (few - low) / ((high - low) or 1.0)
    paths = (" ".join(f"{a:.1f},{b:.1f}" for a, b in zip(x, row, strict=True)) for row in y)
    drawn = "".join(f'<polyline points="{p}" fill="none" stroke="#0072B2"/>' for p in paths)
    return f'<svg width="{width}" height="{height}">{drawn}</svg>'


def _html(title: str, heads: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    """A table; texts that are pictures stay as they are."""
    first = "".join(f'<th style="{_STYLE}">{escape(head)}</th>' for head in heads)
    body = "".join(
        "<tr>"
        + "".join(
            f'<td style="{_STYLE}">{cell if cell.startswith("<svg") else escape(cell)}</td>'
            for cell in row
        )
        + "</tr>"
        for row in rows
    )
    return f"<div>{escape(title)}<table><tr>{first}</tr>{body}</table></div>"
