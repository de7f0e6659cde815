"""The whole picture of what can be held, over speed and wind, on one page."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from groundroll.aircraft.aircraft import Aircraft
from groundroll.base.arrays import FloatArray
from groundroll.base.errors import one_of
from groundroll.base.units import from_si
from groundroll.tires.size import surfaces
from groundroll.view.plots import plain, style

from .crosswind import BINDS, Clause, CrosswindLimit, crosswind_clause
from .pilot import PilotLimit, pilot_limit

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Speeds of the limits, and of the map of delays; winds of that, as shares of the strongest.
_SPEEDS, _COLUMNS, _WINDS = 24, 9, 6
#: What people need, s, with its sources in ``PilotLimit``.
PEOPLE = (0.1, 0.3)
#: Levels of the map of delays, s.
_LEVELS = (0.05, 0.1, 0.2, 0.3, 0.5, 1.0, 2.0, 5.0)
_KNOTS = from_si(1.0, "m/s", "kt")


@dataclass(frozen=True)
class Held:
    """What can be held: the strongest wind at each speed, and how late a pilot may be.

    Attributes
    ----------
    clause : Clause
        With the limit of the wind at each speed.
    still : PilotLimit
        Without wind at the same speeds.
    windy : PilotLimit
        Over a grid, shape (winds, speeds).
    winds : ndarray
        Of that grid, m/s.
    surface : str
    """

    clause: Clause
    still: PilotLimit
    windy: PilotLimit
    winds: FloatArray
    surface: str

    @property
    def limit(self) -> CrosswindLimit:
        """The strongest wind at each speed."""
        return self.clause.limit

    def plot(self) -> Figure:
        """Wind, delay and doubling time over speed."""
        from matplotlib import pyplot

        with style():
            figure, (above, below) = pyplot.subplots(
                2, 1, figsize=(7.5, 8.5), sharex=True, height_ratios=(3, 2), layout="constrained"
            )
            self._draw_wind(above)
            self._draw_delay(below)
            where = f" on a {self.surface} runway" if self.surface else ""
            figure.suptitle(f"{plain(self.limit.aircraft.name)}: what can be held{where}")
        return figure

    def _draw_wind(self, ax: Any) -> None:
        from matplotlib import colormaps

        speed, wind = self.limit.speed * _KNOTS, self.limit.wind * _KNOTS
        delay = np.clip(np.nan_to_num(self.windy.delay, nan=0.0), 0.0, None)
        grid = np.broadcast_arrays(self.windy.speed * _KNOTS, self.winds[:, None] * _KNOTS)
        colours = colormaps["cividis"](np.linspace(0.1, 1.0, len(_LEVELS) + 1))
        shades = ax.contourf(*grid, delay, levels=(0, *_LEVELS), colors=colours, extend="max")
        ax.figure.colorbar(shades, ax=ax, label="longest delay of the pilot (s)")
        ax.plot(speed, wind, "k-", lw=1.2)
        ax.fill_between(speed, wind, 1.15 * wind.max(), color="white")
        for k in np.unique(self.limit.binds):
            at = self.limit.binds == k
            ax.plot(speed[at], wind[at], "osD^vPX*"[k], color="k", ms=5, label=BINDS[k])
        for name, asked, dashes in (
            ("25.233(a)", self.clause.asked, "--"),
            ("former 23.233(a)", self.clause.asked_small, ":"),
        ):
            ax.axhline(asked * _KNOTS, color="tab:blue", ls=dashes, lw=1, label=name)
        ax.set(ylim=(0, 1.15 * wind.max()), ylabel="steady crosswind (kt)")
        ax.legend(title="what runs out first", fontsize="small", loc="upper right")

    def _draw_delay(self, ax: Any) -> None:
        speed = self.still.speed * _KNOTS
        ax.semilogy(speed, self.still.delay, "k-", label="longest delay, no wind")
        doubling = np.where(np.isfinite(self.still.doubling_time), self.still.doubling_time, np.nan)
        ax.semilogy(speed, doubling, color="tab:red", label="a deviation doubles in, hands off")
        ax.axhspan(*PEOPLE, color="0.85", label="delays of people")
        ax.set(xlabel="speed along the runway (kt)", ylabel="time (s)")
        ax.grid(alpha=0.3)
        ax.legend(fontsize="small")


def held(plane: Aircraft, surface: str = "", brake: float = 0.0, **values: Any) -> Held:
    """What can be held from a walking pace to nine tenths of the stall speed.

    Parameters
    ----------
    plane : Aircraft
    surface : str
        Of ``surfaces.toml``, e.g. ``"wet"``; as the aircraft says if empty.
    brake, **values
        As for `groundroll.crosswind_limit`.
    """
    values = {**on_surface(surface), **values}
    clause = crosswind_clause(plane, brake=brake, **values)
    limit = clause.limit
    still = pilot_limit(plane, speed=limit.speed, **values)
    speeds = np.linspace(limit.speed[0], limit.speed[-1], _COLUMNS)
    winds = np.linspace(0.0, float(limit.wind.max()), _WINDS)
    windy = pilot_limit(plane, speed=speeds, crosswind=winds[:, None], **values)
    return Held(clause, still, windy, winds, surface)


def on_surface(surface: str) -> Mapping[str, float]:
    """Friction of a surface over that of a dry runway, under each wheel."""
    if not surface:
        return {}
    known = surfaces()
    ratio = known[one_of("surface", surface, known)]["friction"] / known["dry"]["friction"]
    return {f"surface_{wheel}": ratio for wheel in ("left", "right", "third")}
