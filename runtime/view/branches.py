"""The picture of branches: a quantity over what is varied."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from groundroll.model.models import as_model
from groundroll.model.names import PARAMETERS
from groundroll.model.shown import as_units

from .plots import COLOURS, INK, style, titled, whose

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from groundroll.linear.branching import Branches

_LOOKS: dict[str, dict[str, Any]] = {
    "fold": {"marker": "o", "markerfacecolor": "white", "label": "fold"},
    "hopf": {"marker": "s", "markerfacecolor": INK, "label": "Hopf point"},
    "branch_point": {"marker": "D", "markerfacecolor": "white", "label": "branch point"},
}


def diagram(branches: Branches, of: str | None, ax: Axes | None) -> Axes:
    """Stable parts as full lines, others dashed; marks as symbols."""
    from matplotlib import pyplot

    model = as_model(branches.model)
    known = {**PARAMETERS, **model.quantities}
    s = (
        model.symbol(of, "quantity", tuple(branches.values), "these branches")
        if of
        else _first(branches)
    )
    units = as_units(None, known)
    across = units.values(known[branches.over], branches.values[branches.over])
    up = units.values(known[s], branches.values[s])
    with style():
        ax = ax or pyplot.subplots(figsize=(6.2, 4.0))[1]
        for b in range(len(branches)):
            colour = COLOURS[b % len(COLOURS)]
            for stable, dashes in ((True, "-"), (False, (0, (4, 2)))):
                # a stretch of one kind goes on to the first point of the other
                kind = branches.stable[b] == stable
                shown = kind | np.append(False, kind[:-1]) & stable
                ax.plot(
                    np.where(shown, across[b], np.nan),
                    np.where(shown, up[b], np.nan),
                    color=colour,
                    linestyle=dashes,
                )
        said = set()
        for mark in branches.marks:
            look = {**_LOOKS[mark.kind], "color": INK, "linestyle": "none", "zorder": 4}
            if mark.kind in said:
                del look["label"]
            said.add(mark.kind)
            place = mark.branch, mark.point
            ax.plot(across[place], up[place], **look)
        if said:
            ax.legend()
        ax.set_xlabel(units.label(known[branches.over]))
        ax.set_ylabel(units.label(known[s]))
        titled(ax, whose(branches))
    return ax


def _first(branches: Branches) -> str:
    role = as_model(branches.model).roles.get("yaw_rate", "")
    return role if role in branches.values else list(branches.values)[1]
