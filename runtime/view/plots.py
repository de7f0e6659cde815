"""One style for every picture: readable in colour, without it, and on paper."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import AbstractContextManager
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from cycler import cycler

from groundroll.base.errors import GroundrollError
from groundroll.generated import Quantity
from groundroll.model.models import Model, as_model
from groundroll.model.shown import Units, UnitsLike, as_units

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from groundroll.runs.simulation import Trajectory

#: Distinct to colour-blind eyes (Okabe and Ito), ordered so that neighbours differ in grey too.
COLOURS = ("#0072B2", "#D55E00", "#56B4E9", "#111111", "#009E73", "#CC79A7")
#: Solid, dashed, dash-dot, dotted; with the colours they tell lines apart in grey.
DASHES = ("-", (0, (5, 2)), (0, (6, 2, 1.2, 2)), (0, (1.2, 1.6)))
INK, MUTED, GRID = "#222222", "#666666", "#DDDDDD"

#: More runs than this get no legend.
_MOST_LABELS = 6

_STYLE: Any = {
    "axes.axisbelow": True,
    "axes.edgecolor": MUTED,
    "axes.grid": True,
    "axes.labelcolor": INK,
    "axes.labelsize": 9,
    "axes.linewidth": 0.8,
    "axes.prop_cycle": cycler(color=COLOURS),
    "axes.spines.right": False,
    "axes.spines.top": False,
    "axes.titlelocation": "left",
    "axes.titlesize": 9,
    "figure.constrained_layout.use": True,
    "figure.dpi": 100,
    "font.family": ["DejaVu Sans"],
    "font.size": 9,
    "grid.color": GRID,
    "grid.linewidth": 0.6,
    "legend.fontsize": 8,
    "legend.frameon": False,
    "legend.handlelength": 2.6,
    "lines.linewidth": 1.6,
    "lines.markersize": 4.5,
    "mathtext.fontset": "dejavusans",
    "svg.fonttype": "path",
    "text.color": INK,
    "xtick.color": MUTED,
    "xtick.labelcolor": INK,
    "xtick.labelsize": 8,
    "ytick.color": MUTED,
    "ytick.labelcolor": INK,
    "ytick.labelsize": 8,
}


def style() -> AbstractContextManager[None]:
    """The style as a context: ``with style(): ...``."""
    return mpl.rc_context(_STYLE)


def plain(text: str) -> str:
    """A text of the user's as it is: what stands between two dollars would be a formula."""
    return text.replace("$", r"\$")


def whose(result: Any) -> str:
    """Of which aircraft and which model a result is: the title of its picture."""
    return f"{plain(result.aircraft.name)}, {as_model(result.model).name} model"


def titled(ax: Axes, title: str) -> None:
    """Give a picture a title, unless it stands in one that somebody else has titled."""
    if not any(ax.get_title(loc=loc) for loc in ("left", "center", "right")):
        ax.set_title(title)


def legend_above(ax: Axes, title: str, handles: Sequence[Any], columns: int = 3) -> None:
    """A legend above a picture and the title of the picture above that."""
    if not handles:
        titled(ax, title)
        return
    place: Any = {"loc": "lower left", "bbox_to_anchor": (0.0, 1.0), "borderaxespad": 0.3}
    look: Any = {"alignment": "left", "title_fontsize": 9, "handlelength": 1.6}
    ax.legend(handles=handles, title=title, ncols=columns, **place, **look)


def time_history(
    run: Trajectory,
    names: Sequence[str] | None = None,
    ax: Axes | Sequence[Axes] | None = None,
    units: UnitsLike = None,
) -> tuple[Axes, ...]:
    """Plot states, outputs or inputs of a run over time.

    Parameters
    ----------
    run : Trajectory
        One run or several.
    names : sequence of str, optional
        What to plot, by symbol or full name; one below the other. If omitted, where the aircraft
        goes and which way it points.
    ax : Axes or sequence of Axes, optional
        Where: one for each name. A new figure if omitted.
    units : str or mapping of str to str, optional
        See `groundroll.model.shown.as_units`; SI units with degrees if omitted.

    Returns
    -------
    tuple of Axes
        One for each name; ``axes[0].figure`` is the picture.

    Raises
    ------
    GroundrollError
        For an unknown name, no name, or another number of axes than of names.
    """
    model = as_model(run.model)
    names = _most_telling(model) if names is None else names
    wanted = [names] if isinstance(names, str) else list(names)
    shown = as_units(units, model.quantities, run.aircraft)
    symbols = [model.symbol(n, "state or output", tuple(run.values), "this run") for n in wanted]
    if not symbols:
        raise GroundrollError("nothing to plot: names is empty")
    with style():
        axes = _axes(ax, len(symbols))
        for axis, name in zip(axes, symbols, strict=True):
            _draw_over_time(axis, run, model.quantities[name], shown)
        axes[-1].set_xlabel("time (s)")
        titled(axes[0], whose(run))
        if 1 < run[symbols[0]].reshape(-1, run.t.size).shape[0] <= _MOST_LABELS:
            axes[0].legend()
    return tuple(axes)


def _axes(ax: Axes | Sequence[Axes] | None, count: int) -> list[Axes]:
    if ax is None:
        from matplotlib import pyplot

        _, made = pyplot.subplots(count, 1, sharex=True, squeeze=False, figsize=(6, 1 + 2 * count))
        return list(made[:, 0])
    given = list(np.atleast_1d(np.asarray(ax, dtype=object)))
    if len(given) != count:
        raise GroundrollError(f"there are {count} names to plot but {len(given)} axes")
    return given


def _most_telling(model: Model) -> tuple[str, ...]:
    """Displacement and rotation in body axes, or else over the ground, or else what moves."""
    of_thesis = ("y", "theta")
    if set(of_thesis) <= set(model.states) and "theta" not in model.roles.values():
        return of_thesis
    over_ground = (model.roles.get("offset"), model.roles.get("heading"))
    return tuple(s for s in over_ground if s) or model.dynamic[:4]


def _draw_over_time(axis: Axes, run: Trajectory, q: Quantity, units: Units) -> None:
    values = units.values(q, run[q.symbol])
    lines = values.reshape(-1, run.t.size)
    for k, line in enumerate(lines):
        index = ", ".join(map(str, np.unravel_index(k, values.shape[:-1])))
        axis.plot(
            run.t,
            line,
            color=COLOURS[k % len(COLOURS)],
            linestyle=DASHES[k % len(DASHES)],
            label=f"run {index}",
        )
    axis.set_xlim(run.t[0], run.t[-1])
    axis.set_ylabel(units.label(q))
