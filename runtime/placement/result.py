"""A placement: where the wheels go, what that is worth, what limits it, what a change would buy."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from groundroll.aircraft.aircraft import Aircraft
from groundroll.aircraft.consistency import as_written
from groundroll.base.listing import Pictured
from groundroll.base.progress import Progress
from groundroll.base.units import from_si
from groundroll.model.names import QUANTITIES
from groundroll.runs.simulation import Trajectory, simulate

from .assess import Assessment, Standing, Worst
from .case import VARIABLES, Case
from .limits import KINDS, SHOWN, shown
from .prices import Price, describe
from .search import Points

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from .pareto import Front

#: Objective -> in words, what a change changes, and the unit people use.
_OBJECTIVES = {
    "decay_rate": ("largest worst-case decay rate", "decay rate", "1/s"),
    "damping_ratio": ("largest worst-case damping ratio", "damping ratio", "1"),
    "displacement": ("smallest worst-case displacement", "displacement", "mm"),
    "smallest_change": ("smallest change that meets the limits", "change", "mm"),
}
_SHOWN = {"m": "mm", "m^2": "m^2", "1": "1"}


@dataclass(frozen=True, repr=False)
class Placement(Pictured):
    """Where the wheels should stand.

    Attributes
    ----------
    case : Case
        The problem in numbers.
    design : mapping of str to float
        The whole design by symbol, SI units; `station` is the main gear's.
    aircraft : Aircraft
        The aircraft with that design, at its own speed and CG.
    assessment, today : Assessment
        The design over the whole envelope, and today's. `today` is None where today's wheels
        cannot be judged in this layout: the third wheel would hang in the air.
    binding : tuple of Price
        The limits and bounds that hold the design where it is, and what giving way would buy.
    prices : tuple of Price
        What a small change of envelope, aircraft or fixed dimensions would buy, the design
        re-optimised.
    corners : mapping of str to ndarray
        The points of the envelope that decided.
    rounds : int
        How often corners were exchanged.
    notes : tuple of str
        What to know before using it.
    """

    case: Case
    design: Mapping[str, float]
    assessment: Assessment
    today: Assessment | None
    binding: tuple[Price, ...]
    prices: tuple[Price, ...]
    corners: Points
    rounds: int
    notes: tuple[str, ...] = ()

    @property
    def station(self) -> float:
        """Station of the main gear behind the datum, m."""
        return self.design["x_main"]

    @property
    def worst(self) -> Worst:
        """The objective at its worst corner, SI units."""
        worst = self.assessment.objective(self.case.objective)
        assert worst is not None
        return worst

    @property
    def value(self) -> float:
        """The objective's worst-case value, SI units."""
        return self.worst.value

    @cached_property
    def aircraft(self) -> Aircraft:
        """Today's aircraft with the new design, at its own speed and CG."""
        plane, scale = self.case.plane, self.design["kappa"]
        changes: dict[str, Any] = {s: self.design[s] for s in ("x_main", "x_tail", "Ap")}
        # a scaled tail wheel: of its stiffness where that is given, of its curve where it follows
        curve = ("K1", "K2", "K3", "K4")
        scaled = curve if self.case.stiffness == "following" and scale else ("Ct",)
        if scale != 1:
            changes |= {s: scale * plane[s] if scale else 0.0 for s in scaled}
        changes |= {arm: None for arm in ("a", "b") if arm in plane.given}
        if np.isfinite(self.design["x_nose"]):
            changes["x_nose"] = self.design["x_nose"]
        return plane.replace(**changes)

    @cached_property
    def proof(self) -> Trajectory:
        """A simulation at the worst corner, with the tire of the case."""
        return self._run(self.design)

    @cached_property
    def proof_today(self) -> Trajectory | None:
        """The same run with today's design, at the same corner."""
        return None if self.today is None else self._run(self.today.design)

    def _run(self, design: Mapping[str, float]) -> Trajectory:
        plane = self.case.aircraft(design, self.worst.corner)
        return simulate(plane, self.case.model, v0=self.case.v0, t=self.case.duration)

    def pareto(
        self, against: str = "nose_over", points: int = 13, progress: Progress = None
    ) -> Front:
        """The front of the margin against something else; see `groundroll.placement.pareto`."""
        from .pareto import front

        return front(self.case, against, points, progress)

    def plot(self) -> Figure:
        """Margin over gear station for each corner, and the run at the worst corner."""
        from .figures import placement_figure

        return placement_figure(self)

    def to_json(self) -> str:
        """Everything but the functions, SI units with radians, as JSON text."""
        return json.dumps(_plain(self), indent=2)

    def __repr__(self) -> str:
        words, noun, unit = _OBJECTIVES[self.case.objective]
        kept = {s for s, axis in self.case.axes.items() if axis.low != axis.high} | {"u", "x_cg"}
        where = describe(self.worst.corner, kept)
        today = self.today.objective(self.case.objective) if self.today else None
        # of a change the decay rate that it brings is told
        name, of = (noun, unit) if noun != "change" else ("decay rate", "1/s")
        was = f" (today {shown(today.value, of)})" if today else ""
        lines = [
            f"Placement of {self.case.plane.name!r} as a {self.case.layout}, {self.case.stiffness}"
            f" stiffness: {words}",
            *(f"  {_chosen(v.symbol, self.design, self.case)}" for v in self.case.variables),
            f"  {name} {shown(self.value, of)}{was}, worst at {where}",
        ]
        lines += [f"  held by {p.of}: {_words(p, noun, unit)}" for p in self.binding]
        prices = sorted(self.prices, key=lambda p: -abs(p.gain))
        lines += [f"  {p.of}: {_words(p, noun, unit)}" for p in prices[:6]]
        if self.today:
            lines += [f"  today: {_broken(s)}" for s in self.today.standings if s.room < 0]
        return "\n".join([*lines, *(f"  note: {note}" for note in self.notes)])


def _chosen(symbol: str, design: Mapping[str, float], case: Case) -> str:
    unit, today = _SHOWN.get(QUANTITIES[symbol].unit, "1"), case.today[symbol]
    sheet = as_written(case.plane, symbol)[1] if symbol in case.plane.given else ""

    def both(value: float) -> str:
        if unit != "mm" or sheet in ("", "m", "mm"):
            return shown(value, unit)
        return f"{shown(value, unit)} = {from_si(value, 'm', sheet):.2f} {sheet}"

    name = next(name for name, s in VARIABLES.items() if s == symbol)
    was = f" (today {both(today)})" if np.isfinite(today) else ""
    behind = " behind the datum" if unit == "mm" else ""
    return f"{name.replace('_', ' ')} {both(design[symbol])}{behind}{was}"


def _words(price: Price, noun: str, unit: str) -> str:
    gain = price.gain * SHOWN[unit][0]
    return f"{price.step} changes the {noun} by {gain:+.3g} {unit}".removesuffix(" 1")


def _broken(standing: Standing) -> str:
    kind = KINDS[standing.bound.limit]
    return f"{standing.bound} is broken by {shown(-standing.room, kind.shown)}"


def _plain(found: Placement) -> dict[str, Any]:
    case = found.case
    return {
        "aircraft": case.plane.name,
        "layout": case.layout,
        "stiffness": case.stiffness,
        "objective": case.objective,
        "envelope": {
            QUANTITIES[s].name: {"values": axis.values.tolist(), "range": axis.is_range}
            for s, axis in case.axes.items()
        },
        "limits": [{"limit": b.limit, "side": b.side, "value": b.value} for b in case.bounds],
        "variables": [{"name": v.name, "low": v.low, "high": v.high} for v in case.variables],
        "design": _design(found.design),
        "placement": _assessment(found.assessment),
        "today": None if found.today is None else _assessment(found.today),
        "binding": [vars(p) for p in found.binding],
        "prices": [vars(p) for p in found.prices],
        "corners": {QUANTITIES[s].name: values.tolist() for s, values in found.corners.items()},
        "rounds": found.rounds,
        "notes": list(found.notes),
    }


def _design(design: Mapping[str, float]) -> dict[str, float | None]:
    return {name: _number(design[s]) for name, s in VARIABLES.items()}


def _number(value: float) -> float | None:
    return float(value) if np.isfinite(value) else None


def _worst(worst: Worst | None) -> dict[str, Any] | None:
    if worst is None:
        return None
    corner = {QUANTITIES[s].name: float(x) for s, x in worst.corner.items()}
    return {"value": _number(worst.value), "corner": corner}


def _assessment(found: Assessment) -> dict[str, Any]:
    return {
        "design": _design(found.design),
        "decay_rate": _worst(found.decay_rate),
        "damping_ratio": _worst(found.damping_ratio),
        "displacement": _worst(found.displacement),
        "limits": [
            {
                "limit": s.bound.limit,
                "side": s.bound.side,
                "bound": s.bound.value,
                "worst": _worst(s.worst),
                "room": _number(s.room),
            }
            for s in found.standings
        ],
        "prices": [vars(p) for p in found.prices],
    }
