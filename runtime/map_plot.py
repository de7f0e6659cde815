"""The picture of a stability map."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.patheffects import withStroke

from .aircraft import Aircraft, parameter_symbols
from .arrays import FloatArray, finite
from .errors import GroundrollError
from .generated import Quantity
from .names import PARAMETERS, symbol
from .plots import COLOURS, INK, MUTED, style
from .stability import quantity_of
from .units import from_si

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from .maps import StabilityMap

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
    units: Mapping[str, str],
    marks: Mapping[str, Aircraft],
    ranges: Mapping[str, tuple[Any, Any]],
) -> Axes:
    """Draw a map; see `groundroll.maps.StabilityMap.plot`."""
    shown = _Units(chart, units)
    with style():
        if ax is None:
            from matplotlib import pyplot

            _, ax = pyplot.subplots(figsize=(6.6, 4.4))
        x, y = shown.of(chart.x_name, chart.x), shown.of(chart.y_name, chart.y)
        ax.grid(visible=False)
        ax.set_xlim(x[0], x[-1])
        ax.set_ylim(y[0], y[-1])
        _fill(ax, chart, x, y, shown, levels)
        handles = [
            *_shade_unstable(ax, chart, x, y),
            *_hatch(ax, chart, ranges, shown),
            *_mark(ax, chart, marks, shown),
        ]
        ax.set_xlabel(shown.label(chart.x_name))
        ax.set_ylabel(shown.label(chart.y_name))
        if handles:
            corner: dict[str, Any] = {
                "loc": "lower left",
                "bbox_to_anchor": (0.0, 1.0),
                "borderaxespad": 0.3,
            }
            ax.legend(handles=handles, ncols=3, **corner)
    return ax


class _Units:
    """Values and labels in the units that people asked for."""

    def __init__(self, chart: StabilityMap, units: Mapping[str, str]) -> None:
        self._units = {}
        for name, unit in units.items():
            if name == chart.of:
                self._units[chart.of] = unit
            else:
                self._units[symbol(name, "parameter", parameter_symbols(), "units")] = unit

    def of(self, name: str, values: FloatArray) -> FloatArray:
        """Values of a parameter in its shown unit."""
        return values * self.factor(name, PARAMETERS[name].unit)

    def factor(self, name: str, unit: str) -> float:
        """From the SI unit to the shown one."""
        return from_si(1.0, unit, self._units[name]) if name in self._units else 1.0

    def label(self, name: str, quantity: Quantity | None = None) -> str:
        """Name, symbol and shown unit."""
        q = quantity or PARAMETERS[name]
        words = (name if quantity else q.name).replace("_", " ")
        unit = self._units.get(name, q.unit).replace("^2", "²")
        return f"{words} ${q.latex}$" + ("" if unit == "1" else f" ({unit})")


def _fill(
    ax: Axes, chart: StabilityMap, x: FloatArray, y: FloatArray, shown: _Units, levels: Any
) -> None:
    """Filled contours with labelled lines and a colour bar."""
    values = chart.values * shown.factor(chart.of, chart.unit)
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
    bar.set_label(shown.label(chart.of, quantity_of(chart.of)))
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
    ax: Axes, chart: StabilityMap, ranges: Mapping[str, tuple[Any, Any]], shown: _Units
) -> list[Artist]:
    """Hatch the range of a parameter that the aircraft is to meet."""
    handles: list[Artist] = []
    look: dict[str, Any] = {"facecolor": "none", "linewidth": 1.0, "alpha": 0.9}
    hatches = {chart.x_name: ("\\\\", COLOURS[1]), chart.y_name: ("--", COLOURS[5])}
    for name, ends in ranges.items():
        key = symbol(name, "axis", tuple(hatches), "ranges")
        low, high = shown.of(key, finite(f"range of {name}", ends))
        hatch, colour = hatches[key]
        span = ax.axvspan if key == chart.x_name else ax.axhspan
        span(low, high, hatch=hatch, edgecolor=colour, **look)
        label = f"range of {PARAMETERS[key].name.replace('_', ' ')}"
        handles.append(Patch(hatch=hatch, edgecolor=colour, label=label, **look))
    return handles


def _mark(
    ax: Axes, chart: StabilityMap, marks: Mapping[str, Aircraft], shown: _Units
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
    chart: StabilityMap, marks: Mapping[str, Aircraft], shown: _Units
) -> dict[tuple[float, float], list[str]]:
    """Labels of the marks at each point of the picture."""
    places: dict[tuple[float, float], list[str]] = {}
    for label, plane in marks.items():
        x, y = (float(shown.of(s, plane[s])) for s in (chart.x_name, chart.y_name))
        places.setdefault((x, y), []).append(label)
    return places
