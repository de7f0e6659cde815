"""Pictures of an ensemble: one quantity over what was varied, or how it is spread."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from groundroll.base.arrays import FloatArray
from groundroll.generated import Quantity
from groundroll.model.models import as_model, symbol_of
from groundroll.model.names import PARAMETERS
from groundroll.model.shown import Units, UnitsLike, as_units
from groundroll.runs.ensemble_result import Ensemble

from .plots import COLOURS, INK, style, titled, whose

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Beyond this ratio of largest to least a scale of colours is logarithmic.
_WIDE = 100.0


def plot_over(
    ens: Ensemble,
    of: str,
    axes: Mapping[str, FloatArray],
    units: UnitsLike = None,
    ax: Axes | None = None,
) -> Axes:
    """Draw the largest magnitude of a quantity over the first one or two axes of a grid.

    Further axes are looked at for the worst. Trajectories that came to no end stay grey; a limit
    of the quantity is drawn as a line.

    Parameters
    ----------
    ens : Ensemble
        With one axis for each of `axes`, in that order.
    of : str
        One of its extremes.
    axes : dict of str to array
        Parameters, ``disturbance`` or initial states (``v0``) and their values.
    units : str or mapping of str to str, optional
        See `groundroll.model.shown.as_units`; of what varies by the names of `axes`.
    ax : Axes, optional
        Where; a new figure if omitted.
    """
    shown = _units(ens, units)
    values = worst(ens, of, min(len(axes), 2), shown)
    names = list(axes)[:2]
    along = [varied(ens, name) for name in names]
    grid = [shown.values(q, axes[name]) for name, (q, _) in zip(names, along, strict=True)]
    with style():
        ax = _axes(ax)
        limit = ens.limits.get(of)
        q = _of(ens, of)
        mark = None if limit is None else float(shown.values(q, limit))
        title = f"largest {shown.label(q)}"
        if len(names) == 1:
            ax.plot(grid[0], values, color=COLOURS[0])
            ax.set_ylabel(title)
            if mark is not None:
                ax.axhline(mark, color=INK, linewidth=0.9, linestyle="--")
            ax.set_xlim(grid[0][0], grid[0][-1])
        else:
            _field(ax, grid[0], grid[1], values.T, mark, title)
            ax.set_ylabel(shown.label(*along[1]))
        ax.set_xlabel(shown.label(*along[0]))
        titled(ax, whose(ens))
    return ax


def plot_spread(ens: Ensemble, of: str, ax: Axes | None = None, units: UnitsLike = None) -> Axes:
    """Draw how the largest magnitude of a quantity is spread over the trajectories.

    Parameters
    ----------
    ens : Ensemble
        Trajectories of any shape.
    of : str
        One of its extremes.
    ax : Axes, optional
        Where; a new figure if omitted.
    units : str or mapping of str to str, optional
        See `groundroll.model.shown.as_units`.
    """
    q, shown = _of(ens, of), _units(ens, units)
    values = shown.values(q, ens.largest[of]).reshape(-1)
    good = values[np.isfinite(values)]
    with style():
        ax = _axes(ax)
        bins: Any = 60
        if _wide(good):
            positive = good[good > 0]
            bins = np.geomspace(positive.min(), positive.max(), 61)
            ax.set_xscale("log")
        weights = np.full(good.size, 100.0 / max(values.size, 1))
        ax.hist(
            good, bins=bins, weights=weights, color=COLOURS[2], edgecolor="white", linewidth=0.3
        )
        limit = ens.limits.get(of)
        if limit is not None:
            mark = float(shown.values(q, limit))
            ax.axvline(mark, color=INK, linewidth=0.9, linestyle="--")
        if good.size:
            half, most = np.percentile(good, (50, 99))
            spread = f"half are below {half:.3g}, 99 % below {most:.3g}"
            titled(ax, f"{whose(ens)}: {spread}")
        ax.set_xlabel(f"largest {shown.label(q)}")
        ax.set_ylabel("share of the trajectories (%)")
    return ax


def worst(ens: Ensemble, of: str, axes: int, units: Units) -> FloatArray:
    """The largest magnitude over the first axes, in the shown unit; NaN where none is known."""
    values = units.values(_of(ens, of), ens.largest[of])
    rest = tuple(range(axes, values.ndim))
    return np.asarray(np.fmax.reduce(values, axis=rest)) if rest else values


def _field(
    ax: Axes, x: FloatArray, y: FloatArray, values: FloatArray, mark: float | None, title: str
) -> None:
    from matplotlib.colors import LogNorm

    norm: Any = None
    if _wide(values):
        norm = LogNorm(*np.nanpercentile(values[values > 0], (1, 100)))
    ax.set_facecolor("#999999")
    mesh = ax.pcolormesh(x, y, values, cmap="viridis", norm=norm, rasterized=True)
    bar = ax.figure.colorbar(mesh, ax=ax, extend="neither" if norm is None else "min")
    bar.set_label(title)
    if mark is not None and np.nanmin(values) < mark < np.nanmax(values):
        ax.contour(x, y, values, levels=[mark], colors="white", linewidths=1.2)
        bar.ax.axhline(mark, color="white", linewidth=1.2)
    ax.grid(False)


def _wide(values: FloatArray) -> bool:
    good = values[np.isfinite(values) & (values > 0)]
    return bool(good.size and np.percentile(good, 99) > _WIDE * np.percentile(good, 1))


def _axes(ax: Axes | None) -> Axes:
    if ax is not None:
        return ax
    from matplotlib import pyplot

    return pyplot.subplots(figsize=(5.6, 4.2))[1]


def _units(ens: Ensemble, units: UnitsLike) -> Units:
    """What was asked for; of an initial state by its symbol and a zero too."""
    known = as_model(ens.model).quantities
    if isinstance(units, Mapping):
        known = {**PARAMETERS, **known}
        units = {varied(ens, s)[0].symbol: unit for s, unit in units.items()}
    return as_units(units, known, ens.aircraft)


def _of(ens: Ensemble, name: str) -> Quantity:
    model = as_model(ens.model)
    return model.quantities[model.symbol(name, "name", tuple(ens.largest), "the extremes")]


def varied(ens: Ensemble, name: str) -> tuple[Quantity, str]:
    """The quantity that varies, and what is to be said before its name."""
    q = as_model(ens.model).quantities
    if name in q:
        return q[name], ""
    state = name.removesuffix("0")
    if state in q:
        return q[state], "initial "
    for quantity in q.values():
        if quantity.name == name:
            return quantity, ""
    return PARAMETERS[symbol_of(PARAMETERS, name, "name", PARAMETERS, "the axes")], ""
