"""Pictures of an ensemble: one quantity over what was varied, or how it is spread."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from .arrays import FloatArray
from .ensemble_result import Ensemble
from .generated import Quantity
from .models import as_model
from .names import PARAMETERS
from .plots import COLOURS, INK, axis_label, in_shown_unit, style
from .units import from_si

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Beyond this ratio of largest to least a scale of colours is logarithmic.
_WIDE = 100.0


def plot_over(
    ens: Ensemble,
    of: str,
    axes: Mapping[str, FloatArray],
    units: Mapping[str, str] | None = None,
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
    units : mapping of str to str, optional
        Units for the axes, where others than usual are wanted.
    ax : Axes, optional
        Where; a new figure if omitted.
    """
    values = worst(ens, of, min(len(axes), 2))
    names = list(axes)[:2]
    units = units or {}
    grid = [_shown(varied(ens, name)[0], axes[name], units.get(name)) for name in names]
    with style():
        ax = _axes(ax)
        limit = ens.limits.get(of)
        mark = None if limit is None else float(in_shown_unit(_of(ens, of), np.asarray(limit)))
        if len(names) == 1:
            ax.plot(grid[0], values, color=COLOURS[0])
            ax.set_ylabel(_title(_of(ens, of)))
            if mark is not None:
                ax.axhline(mark, color=INK, linewidth=0.9, linestyle="--")
            ax.set_xlim(grid[0][0], grid[0][-1])
        else:
            _field(ax, grid[0], grid[1], values.T, mark, _title(_of(ens, of)))
            ax.set_ylabel(_label(*varied(ens, names[1]), units.get(names[1])))
        ax.set_xlabel(_label(*varied(ens, names[0]), units.get(names[0])))
    return ax


def plot_spread(ens: Ensemble, of: str, ax: Axes | None = None) -> Axes:
    """Draw how the largest magnitude of a quantity is spread over the trajectories.

    Parameters
    ----------
    ens : Ensemble
        Trajectories of any shape.
    of : str
        One of its extremes.
    ax : Axes, optional
        Where; a new figure if omitted.
    """
    values = in_shown_unit(_of(ens, of), ens.largest[of]).reshape(-1)
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
            mark = float(in_shown_unit(_of(ens, of), np.asarray(limit)))
            ax.axvline(mark, color=INK, linewidth=0.9, linestyle="--")
        if good.size:
            half, most = np.percentile(good, (50, 99))
            ax.set_title(f"half are below {half:.3g}, 99 % below {most:.3g}")
        ax.set_xlabel(_title(_of(ens, of)))
        ax.set_ylabel("share of the trajectories (%)")
    return ax


def worst(ens: Ensemble, of: str, axes: int) -> FloatArray:
    """The largest magnitude over the first axes, in the shown unit; NaN where none is known."""
    values = in_shown_unit(_of(ens, of), ens.largest[of])
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


def _title(q: Quantity) -> str:
    return f"largest {axis_label(q)}"


def _of(ens: Ensemble, name: str) -> Quantity:
    model = as_model(ens.model)
    return model.quantities[model.symbol(name, "name", tuple(ens.largest), "the extremes")]


def varied(ens: Ensemble, name: str) -> tuple[Quantity, str]:
    """The quantity that varies, and what is to be said before its name."""
    q = as_model(ens.model).quantities
    if name in q:
        return q[name], ""
    state = name.removesuffix("0")
    return (q[state], "initial ") if state in q else (PARAMETERS[name], "")


def _shown(q: Quantity, values: FloatArray, unit: str | None) -> FloatArray:
    return values * from_si(1.0, q.unit, unit) if unit else in_shown_unit(q, values)


def _label(q: Quantity, before: str, unit: str | None) -> str:
    words = axis_label(q)
    if unit:
        words = f"{q.name.replace('_', ' ')} ${q.latex}$ ({unit})"
    return f"{before}{words}"
