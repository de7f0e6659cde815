"""The figures of the thesis that show data, drawn from the same runs as the tables."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from matplotlib.figure import Figure

from groundroll.view.plots import COLOURS, DASHES, MUTED, style

from .cases import case
from .figure_svg import as_svg
from .mode_figures import modes
from .response_figures import response
from .sources import FigureSpec
from .tire_figures import coefficient, normalised, reconstruction, tail_wheel, tire_data

_SIZE, _WIDE = (5.2, 3.3), (10.6, 3.6)  # inch
_INCH = 0.0254  # m


def draw(spec: FigureSpec) -> Figure:
    """Draw a figure of the thesis."""
    with style():
        figure = Figure(figsize=_WIDE if spec.wide else _SIZE)
        _KINDS[spec.kind](figure, spec)
        figure.suptitle(
            f"Figure {spec.number}   {spec.title}", x=0.01, ha="left", fontsize=9, color=MUTED
        )
    return figure


def svg(spec: FigureSpec) -> str:
    """Draw a figure as SVG: the same bytes each time, no two figures with an id in common."""
    return as_svg(draw(spec), spec.number, f"Figure {spec.number}: {spec.caption}")


def _runway(figure: Figure, spec: FigureSpec) -> None:
    left, right = figure.subplots(1, 2)
    options = spec.options
    numbers = list(options["ground"])
    for number in numbers:
        subject = case(number, "nonlinear")
        k = numbers.index(number)
        look: dict[str, Any] = {"color": COLOURS[k], "linestyle": DASHES[k % len(DASHES)]}
        rolled = float(subject.plane["u"]) * subject.run.t
        label = f"Trial {number}"
        if number in options["trials"]:
            left.plot(rolled, 1000 * subject.run["y"], **look)
        right.plot(subject.run["X"], subject.run["Y"], label=label, **look)
    limit = 1000 * options["inches"] * _INCH
    left.axhline(limit, color=MUTED, linewidth=0.8)
    left.annotate("2 inches", (0, limit), xytext=(4, 2), textcoords="offset points", fontsize=8)
    left.set_ylim(0, 1.12 * limit)
    left.set_ylabel("lateral displacement $y$ (mm)")
    left.set_xlabel("distance rolled $u t$ (m)")
    left.set_title("aircraft coordinates, as printed")
    right.axhline(0, color=MUTED, linewidth=0.8)
    right.set_ylabel("offset from the runway axis $Y$ (m)")
    right.set_xlabel("along the runway $X$ (m)")
    right.set_title("over the ground; right is up")
    for axis in (left, right):
        axis.set_xlim(0, rolled[-1])
    right.legend(loc="center left", bbox_to_anchor=(1.01, 0.5))


_KINDS: Mapping[str, Callable[[Figure, FigureSpec], None]] = {
    "response": response,
    "tire-data": tire_data,
    "coefficient": coefficient,
    "normalised": normalised,
    "reconstruction": reconstruction,
    "tail-wheel": tail_wheel,
    "modes": modes,
    "runway": _runway,
}
