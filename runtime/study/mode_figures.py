"""Figures of damping and frequency over a parameter."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from groundroll.base.units import from_si
from groundroll.linear.linearization import linearize
from groundroll.model.names import QUANTITIES
from groundroll.view.plots import COLOURS, DASHES, INK, MUTED

from .cases import case
from .figure_legends import place_legend, sorted_pair, trial_label
from .sources import FigureSpec

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def modes(figure: Figure, spec: FigureSpec) -> None:
    axis = figure.add_subplot()
    options = spec.options
    over, quantity = options["over"], options["quantity"]
    unit = options.get("unit", QUANTITIES[over].unit)
    first, last = map(float, options["range"])
    values = np.linspace(first, last, 241)
    scale = 1.0 if unit == QUANTITIES[over].unit else from_si(1.0, QUANTITIES[over].unit, unit)
    handles = []
    for k, number in enumerate(options["trials"]):
        plane = case(number, "linear").plane.replace(**{over: values / scale})
        look: dict[str, Any] = {"color": COLOURS[k], "linestyle": DASHES[k]}
        axis.plot(values, getattr(linearize(plane, "linear"), quantity), **look)
        handles.append(Line2D([], [], label=_series_label(number, options["trials"], over), **look))
    if options.get("crossing"):
        _mark_crossing(axis, QUANTITIES[over].latex, unit)
    for number in options["marks"]:
        subject = case(number, "linear")
        place = scale * float(subject.plane[over])
        axis.plot(place, getattr(subject.linearization, quantity), "o", color=INK, ms=3.5, zorder=4)
    axis.set_xlim(*_padded(options["range"]))
    axis.set_ylim(*options.get("limits", (0, None)))
    axis.set_xlabel(f"{_MODE_LABELS[over]} ({unit})")
    axis.set_ylabel(_MODE_LABELS[quantity])
    place_legend(axis, handles)


def _mark_crossing(axis: Axes, latex: str, unit: str) -> None:
    """Where the first two lines cross."""
    first, second = (np.asarray(line.get_xydata()) for line in axis.get_lines()[:2])
    gap = first[:, 1] - second[:, 1]
    k = int(np.flatnonzero(np.diff(np.sign(gap)))[0])
    place = float(np.interp(0.0, *sorted_pair(gap[k : k + 2], first[k : k + 2, 0])))
    level = float(np.interp(place, first[:, 0], first[:, 1]))
    axis.annotate(
        f"equal at ${latex}$ = {place:.3f} {unit}".replace("-", "−"),
        (place, level),
        xytext=(-40, -48),
        textcoords="offset points",
        ha="right",
        fontsize=8,
        arrowprops={"arrowstyle": "-", "color": MUTED, "lw": 0.8},
    )


_MODE_LABELS = {
    "a": "main gear ahead of the CG $a$",
    "Ct": "tail wheel cornering stiffness",
    "damped_frequency": "damped frequency (rad/s)",
    "damping_ratio": "damping ratio $\\zeta$",
}


def _padded(limits: Sequence[float]) -> tuple[float, float]:
    room = 0.02 * (limits[1] - limits[0])
    return limits[0] - room, limits[1] + room


def _series_label(number: int, among: Sequence[int], over: str) -> str:
    words = trial_label(number, among).split(", ")[1:]
    shown = [word for word in words if not word.startswith("tail wheel")] if over == "Ct" else words
    return ", ".join(shown)
