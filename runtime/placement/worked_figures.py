"""Pictures of the worked study: both models of the stiffness beside each other."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from groundroll.view.plots import COLOURS, DASHES, INK, MUTED, style

from .envelope import grid

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from .pareto import Front
    from .result import Placement
    from .worked import WorkedStudy

_WORDS = {
    "constant": "constant stiffness (the thesis)",
    "following": "loads that follow the gear",
}
_LAYOUTS = (("taildragger", "textbook"), ("tricycle", "relaxed"))


def models_figure(study: WorkedStudy) -> Figure:
    """Worst decay rate over the gear's station: taildragger, tricycle, with both models."""
    from matplotlib import pyplot

    with style():
        figure, axes = pyplot.subplots(2, 1, figsize=(7.2, 7.0), layout="constrained")
        for ax, (layout, limits) in zip(axes, _LAYOUTS, strict=True):
            for n, (stiffness, words) in enumerate(_WORDS.items()):
                free = study.placement(layout, stiffness, "stability")
                held = study.placement(layout, stiffness, limits)
                _draw_model(ax, free, held, n, words)
            _allowed(ax, study.placement(layout, "following", limits))
            ax.axhline(0, color=MUTED, lw=0.8)
            ax.set_title(f"as a {layout}, {limits} limits")
            ax.set_xlabel("main gear station behind the datum (mm)")
            ax.set_ylabel("worst decay rate −max Re λ (1/s)")
        handles, labels = axes[0].get_legend_handles_labels()
        order = sorted(range(len(labels)), key=lambda k: labels[k] not in _WORDS.values())
        figure.legend(
            [handles[k] for k in order],
            [labels[k] for k in order],
            loc="outside upper center",
            ncols=2,
        )
        return figure


def _draw_model(ax: Axes, free: Placement, held: Placement, n: int, words: str) -> None:
    """The worst of the envelope over the station, the best of it, and the best within limits."""
    case, main = free.case, free.case.variables[0]
    stations = np.linspace(main.low, main.high, 91)
    points = grid(case.axes, 2200)
    worst = [
        case.values({**free.design, "x_main": x}, points)["decay_rate"].min() for x in stations
    ]
    colour, dashes = COLOURS[n], DASHES[n]
    ax.plot(1e3 * stations, worst, color=colour, linestyle=dashes, label=words)
    for found, marker, label in (
        (free, "o", "best of all"),
        (held, "s", "best within the limits"),
    ):
        ax.plot(
            1e3 * found.station,
            found.value,
            marker,
            color=colour,
            mfc="white" if n else colour,
            ms=7,
            clip_on=False,
            label=label if n == 0 else None,
            linestyle="none",
        )
    ax.set_xlim(1e3 * main.low, 1e3 * main.high)
    today = free.today
    if today is not None and n == 0:
        x = 1e3 * today.design["x_main"]
        ax.axvline(x, color=INK, lw=1.0, linestyle=DASHES[1])
        ax.annotate(
            "today",
            (x, 1),
            (3, -10),
            xycoords=("data", "axes fraction"),
            textcoords="offset points",
            fontsize=8,
        )


def _allowed(ax: Axes, found: Placement) -> None:
    """The stations that the limits of geometry allow."""
    case, main = found.case, found.case.variables[0]
    stations = np.linspace(main.low, main.high, 1001)
    ends = {s: np.array([axis.low, axis.high])[:, None] for s, axis in case.axes.items()}
    values = case.values({**found.design, "x_main": stations[None]}, ends)
    inside = np.ones(stations.size, dtype=bool)
    for b in case.bounds:
        if b.limit != "decay_rate" and b.kind.symbol in values:
            inside &= (b.sign * (values[b.kind.symbol] - b.value) >= 0).all(axis=0)
    mm = 1e3 * stations[inside]
    ax.axvspan(mm[0], mm[-1], color="#E8E8E8", zorder=0, label="the limits allow")


def fronts_figure(fronts: Sequence[Front]) -> Figure:
    """Margin against nose-over angle as a taildragger, with both models."""
    from matplotlib import pyplot

    with style():
        figure, ax = pyplot.subplots(figsize=(6.4, 4.2), layout="constrained")
        for n, front in enumerate(fronts):
            x, y = np.degrees(front.other), front.margin
            words = _WORDS[front.case.stiffness]
            ax.plot(x, y, "os"[n], color=COLOURS[n], linestyle=DASHES[n], label=words)
            for k in range(0, len(x), 2):
                ax.annotate(
                    f"{1e3 * front.stations[k]:.0f} mm".replace("-", "−"),
                    (x[k], y[k]),
                    (6, 4) if n == 0 else (-4, -11),
                    ha="left" if n == 0 else "right",
                    textcoords="offset points",
                    fontsize=7.5,
                    color=MUTED,
                )
        ax.set_xlabel("least nose-over angle, gear ahead of the CG (deg)")
        ax.set_ylabel("worst decay rate −max Re λ (1/s)")
        ax.set_title("as a taildragger; beside the points: main gear station behind the datum")
        ax.margins(x=0.08, y=0.1)
        ax.legend()
        return figure
