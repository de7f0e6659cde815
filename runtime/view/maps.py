"""The picture of a stability map."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.patheffects import withStroke

from groundroll.aircraft.aircraft import Aircraft
from groundroll.base.arrays import FloatArray, finite
from groundroll.base.errors import GroundrollError
from groundroll.model.names import PARAMETERS, symbol
from groundroll.model.shown import Units, UnitsLike, as_units
from groundroll.stability.closed_forms import quantity_of

from .plots import COLOURS, INK, MUTED, legend_above, plain, style

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from groundroll.stability.maps import StabilityMap

#: Light to dark, so that it keeps its order in grey; not so dark as to hide what is drawn on it.
_COLOURS = mpl.colors.LinearSegmentedColormap.from_list(
    "stability", mpl.colormaps["YlGnBu"](np.linspace(0.0, 0.7, 64))
)
_HALO: Any = [withStroke(linewidth=2.2, foreground="white")]
_UNSTABLE = "#F4E3DA"
#: No contour is labelled this near to the edge, as a fraction of the picture.
_MARGIN = 0.03
_EDGES = {
    "determinant": "det A = 0",
    "trace": "tr A = 0",
    "speed_margin": "stable at every speed from here",
}


def draw(
    chart: StabilityMap,
    ax: Axes | None,
    levels: Any,
    units: UnitsLike,
    marks: Mapping[str, Aircraft],
    ranges: Mapping[str, tuple[Any, Any]],
) -> Axes:
    """Draw a map; see `groundroll.stability.maps.StabilityMap.plot`."""
    shown = _units(chart, units)
    with style():
        if ax is None:
            from matplotlib import pyplot

            _, ax = pyplot.subplots(figsize=(6.6, 4.4))
        of_x, of_y = PARAMETERS[chart.x_name], PARAMETERS[chart.y_name]
        x, y = shown.values(of_x, chart.x), shown.values(of_y, chart.y)
        ax.grid(visible=False)
        ax.set_xlim(x[0], x[-1])
        ax.set_ylim(y[0], y[-1])
        _fill(ax, chart, x, y, shown, levels)
        handles = [
            *_shade_unstable(ax, chart, x, y),
            *_hatch(ax, chart, ranges, shown),
            *_mark(ax, chart, marks, shown),
        ]
        ax.set_xlabel(shown.label(of_x))
        ax.set_ylabel(shown.label(of_y))
        legend_above(ax, f"{plain(chart.aircraft.name)}, linear model", handles)
    return ax


def _units(chart: StabilityMap, units: UnitsLike) -> Units:
    """What was asked for; of what is mapped by its name as a margin too."""
    q = quantity_of(chart.of)
    if isinstance(units, Mapping):
        units = {q.symbol if name == chart.of else name: unit for name, unit in units.items()}
    return as_units(units, {**PARAMETERS, q.symbol: q}, chart.aircraft)


def _fill(
    ax: Axes, chart: StabilityMap, x: FloatArray, y: FloatArray, shown: Units, levels: Any
) -> None:
    """Filled contours with labelled lines and a colour bar."""
    of = quantity_of(chart.of)
    values = shown.values(of, chart.values)
    finite_values = np.ma.masked_invalid(values)
    chosen = _levels(finite_values) if levels is None else finite("levels", levels)
    filled = ax.contourf(x, y, finite_values, levels=chosen, cmap=_COLOURS, extend="both")
    inside = chosen[(chosen > finite_values.min()) & (chosen < finite_values.max())]
    if inside.size:
        lines = ax.contour(x, y, finite_values, levels=inside, colors=INK, linewidths=0.6)
        for text in ax.clabel(lines, fontsize=7.5, fmt="%g", colors=INK):
            text.set_path_effects(_HALO)
            place = ax.transAxes.inverted().transform(ax.transData.transform(text.get_position()))
            if (np.abs(place - 0.5) > 0.5 - _MARGIN).any():  # it would run out of the picture
                text.remove()
    bar = ax.figure.colorbar(filled, ax=ax, pad=0.02, fraction=0.06, aspect=28)
    bar.set_label(shown.label(of._replace(name=chart.of)))
    bar.outline.set_linewidth(0.6)


def _levels(values: Any) -> FloatArray:
    """Round levels over the bulk of the values: a pole at low speed must not take all of them."""
    from matplotlib.ticker import MaxNLocator

    present = values.compressed()
    if present.size == 0:
        raise GroundrollError("there is nothing to draw: no point of the map has a value")
    low, high = np.percentile(present, [2, 96])
    if low == high:
        low, high = low - 0.5, high + 0.5
    return np.asarray(MaxNLocator(9).tick_values(float(low), float(high)))


def _shade_unstable(ax: Axes, chart: StabilityMap, x: FloatArray, y: FloatArray) -> list[Artist]:
    """Shade what is unstable and draw its edge, the zero of each closed form."""
    handles: list[Artist] = []
    for name, zero in chart.boundary.items():
        wrong = zero if name == "trace" else -zero
        if not (wrong > 0).any():
            continue
        ax.contourf(x, y, wrong, levels=[0, np.inf], colors=["none"], hatches=["///"])
        ax.contourf(x, y, wrong, levels=[0, np.inf], colors=[_UNSTABLE], alpha=0.6)
        if (wrong < 0).any():
            ax.contour(x, y, zero, levels=[0], colors=INK, linewidths=2.2)
            handles.append(Line2D([], [], color=INK, linewidth=2.2, label=_EDGES[name]))
    if not chart.stable.all():
        words = "unstable at some speed" if "speed_margin" in chart.boundary else "unstable"
        look: dict[str, Any] = {
            "facecolor": _UNSTABLE,
            "edgecolor": MUTED,
            "hatch": "///",
            "linewidth": 0.5,
        }
        handles.append(Patch(label=words, **look))
    return handles


def _hatch(
    ax: Axes, chart: StabilityMap, ranges: Mapping[str, tuple[Any, Any]], shown: Units
) -> list[Artist]:
    """Hatch the range of a parameter that the aircraft is to meet."""
    handles: list[Artist] = []
    look: dict[str, Any] = {"facecolor": "none", "linewidth": 1.0, "alpha": 0.9}
    hatches = {chart.x_name: ("\\\\", COLOURS[1]), chart.y_name: ("--", COLOURS[5])}
    for name, ends in ranges.items():
        key = symbol(name, "axis", tuple(hatches), "ranges")
        q = PARAMETERS[key]
        low, high = shown.values(q, finite(f"range of {name}", ends, q.unit))
        hatch, colour = hatches[key]
        span = ax.axvspan if key == chart.x_name else ax.axhspan
        span(low, high, hatch=hatch, edgecolor=colour, **look)
        label = f"range of {q.name.replace('_', ' ')}"
        handles.append(Patch(hatch=hatch, edgecolor=colour, label=label, **look))
    return handles


def _mark(
    ax: Axes, chart: StabilityMap, marks: Mapping[str, Aircraft], shown: Units
) -> list[Artist]:
    """Mark aircraft, hollow where something beside x and y differs from the map."""
    handles: list[Artist] = []
    for place, found in _by_place(chart, marks, shown).items():
        fits = any(chart.fits(marks[label]) for label in found)
        (point,) = ax.plot(
            *place,
            marker="o",
            linestyle="none",
            color=INK,
            markerfacecolor=INK if fits else "white",
            markersize=5.5,
            zorder=5,
            clip_on=False,
            label="differs from the map in more than x and y",
        )
        if not fits and not handles:
            handles.append(point)
        text = ax.annotate(
            ", ".join(found), place, (6, 4), textcoords="offset points", fontsize=8, zorder=6
        )
        text.set_path_effects(_HALO)
    return handles


def _by_place(
    chart: StabilityMap, marks: Mapping[str, Aircraft], shown: Units
) -> dict[tuple[float, float], list[str]]:
    """Labels of the marks at each point of the picture."""
    places: dict[tuple[float, float], list[str]] = {}
    for label, plane in marks.items():
        x, y = (float(shown.values(PARAMETERS[s], plane[s])) for s in (chart.x_name, chart.y_name))
        places.setdefault((x, y), []).append(label)
    return places
