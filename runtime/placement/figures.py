"""Pictures of a placement: the margin over the gear's station, the run, the Pareto front."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from groundroll.base.arrays import FloatArray
from groundroll.view.plots import COLOURS, DASHES, INK, MUTED, plain, style

from .case import Case
from .envelope import corners, grid
from .limits import KINDS, SHOWN, show
from .prices import describe
from .search import Points

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from groundroll.runs.simulation import Trajectory

    from .pareto import Front
    from .result import Placement

#: Objective -> what is drawn over the station, and its label.
_DRAWN = {"damping_ratio": ("damping_ratio", "damping ratio ζ")}
_DECAY = ("decay_rate", "decay rate −max Re λ (1/s)")
_STATIONS = 91
_DENSE = 2200
#: Corners nearer than this share of an axis look the same.
_NEIGHBOURS = 0.1
#: More corners than this make a thicket.
_MOST_CORNERS = 4


def placement_figure(found: Placement) -> Figure:
    """Margin over the station of the main gear, and the path at the worst corner."""
    from matplotlib import pyplot

    with style():
        figure, (above, below) = pyplot.subplots(
            2, 1, figsize=(7.2, 7.4), height_ratios=(3, 2), layout="constrained"
        )
        margin_over_station(above, found)
        path_at_worst(below, found)
        return figure


def margin_over_station(ax: Axes, found: Placement) -> None:
    """The margin of each corner that is worst somewhere, and the worst over the envelope."""
    case = found.case
    symbol, label = _DRAWN.get(case.objective, _DECAY)
    stations = _stations(found)
    points = {s: np.append(v, found.corners[s]) for s, v in corners(case.axes).items()}
    curves = _over_stations(case, found.design, stations, points)[symbol]
    envelope = grid(case.axes, _DENSE)
    lowest = np.array(
        [_over_stations(case, found.design, x, envelope)[symbol].min() for x in stations]
    )
    mm = 1e3 * stations
    ranging = [s for s, axis in case.axes.items() if axis.low != axis.high]
    for n, k in enumerate(_worst_somewhere(curves, case, points)):
        words = describe({s: float(v[k]) for s, v in points.items()}, ranging)
        ax.plot(mm, curves[k], color=COLOURS[n], linestyle=DASHES[1 + n % 3], lw=1.2, label=words)
    ax.plot(mm, lowest, color=INK, lw=2.4, label="worst of the whole envelope")
    ax.set_xlim(mm[0], mm[-1])
    ax.set_xlabel("main gear station behind the datum (mm)")
    ax.set_ylabel(label)
    _limit_vertically(ax, lowest, curves)
    if symbol == "decay_rate":
        ax.axhline(0, color=MUTED, lw=0.8)
        ax.text(mm[-1], 0, "unstable below ", ha="right", va="top", fontsize=8, color=MUTED)
    _shade_forbidden(ax, found, stations)
    _mark_stations(ax, found)
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1.09), ncols=1)


def _stations(found: Placement) -> FloatArray:
    """Stations to draw: the variable's bounds, and today's if it is judged."""
    main = found.case.variables[0]
    low, high = main.low, main.high
    if found.today is not None:
        low = min(low, found.case.today["x_main"] - 0.03)
        high = max(high, found.case.today["x_main"] + 0.03)
    return np.linspace(low, high, _STATIONS)


def _over_stations(
    case: Case, design: Mapping[str, float], stations: FloatArray, points: Points
) -> dict[str, FloatArray]:
    """Values over points (rows) and stations (columns)."""
    moved = {**design, "x_main": stations[None]}
    values = case.values(moved, {s: v[:, None] for s, v in points.items()})
    values["damping_ratio"] = np.where(
        np.isnan(values["damping_ratio"]), 0, values["damping_ratio"]
    )
    return values


def _worst_somewhere(curves: FloatArray, case: Case, points: Points) -> list[int]:
    """The corners that are worst at most stations, and of near neighbours only one."""
    worst, often = np.unique(curves.argmin(axis=0), return_counts=True)
    widths = {s: max(axis.high - axis.low, 1e-9) for s, axis in case.axes.items()}
    chosen: list[int] = []
    for k in worst[np.argsort(-often)]:
        apart = [
            max(abs(points[s][k] - points[s][other]) / width for s, width in widths.items())
            for other in chosen
        ]
        if all(distance > _NEIGHBOURS for distance in apart):
            chosen.append(int(k))
    return chosen[:_MOST_CORNERS]


def _limit_vertically(ax: Axes, lowest: FloatArray, curves: FloatArray) -> None:
    top = np.nanmax(lowest)
    bottom = max(np.nanmin(lowest), -top)
    room = 0.15 * (top - bottom)
    ax.set_ylim(bottom - room, top + 2.5 * room)


def _shade_forbidden(ax: Axes, found: Placement, stations: FloatArray) -> None:
    """Hatch where a limit other than the margin forbids the gear to stand, and name it."""
    case = found.case
    ends = {s: np.array([axis.low, axis.high]) for s, axis in case.axes.items()}
    values = _over_stations(case, found.design, stations, ends)
    forbidden = np.zeros(stations.size, dtype=bool)
    mm, edge = 1e3 * stations, ax.get_ylim()
    for b in case.bounds:
        if b.kind.symbol not in values or b.kind.symbol in ("decay_rate", "damping_ratio"):
            continue
        room = b.sign * (values[b.kind.symbol] - b.value)
        broken = np.atleast_1d((room < -1e-9).any(axis=0))
        forbidden |= broken
        least_room = np.atleast_1d(room.min(axis=0))
        for k in np.flatnonzero(np.diff(broken.astype(int))):
            right = broken[k + 1]
            here, there = least_room[k], least_room[k + 1]
            edge_at = mm[k] + (mm[k + 1] - mm[k]) * here / (here - there)
            words = (
                f"{b.limit.replace('_', ' ')} {'≥' if b.sign > 0 else '≤'} {show(b.value, b.kind)}"
            )
            ax.axvline(edge_at, color=MUTED, lw=0.8)
            ax.text(
                edge_at + (3 if right else -3),
                edge[0] + 0.03 * (edge[1] - edge[0]),
                words,
                rotation=90,
                ha="left" if right else "right",
                va="bottom",
                fontsize=7.5,
                color=MUTED,
                bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.8, "alpha": 0.85},
            )
    ax.fill_between(
        mm,
        *edge,
        where=forbidden,
        facecolor="#EEEEEE",
        edgecolor="#CCCCCC",
        hatch="///",
        linewidth=0,
        zorder=0,
    )


def _mark_stations(ax: Axes, found: Placement) -> None:
    marks: list[tuple[str, float, Any]] = [("placed", found.station, "-")]
    if found.today is not None:
        marks.append(("today", found.today.design["x_main"], DASHES[1]))
    for words, station, dashes in marks:
        x = 1e3 * station
        ax.axvline(x, color=INK, lw=1.1, linestyle=dashes)
        ax.annotate(
            f"{words}\n{_mm(station)}",
            (x, 1),
            (0, 3),
            xycoords=("data", "axes fraction"),
            textcoords="offset points",
            ha="center",
            fontsize=8,
            color=INK,
        )


def _mm(station: float) -> str:
    return f"{1e3 * station:.0f} mm".replace("-", "−")


def path_at_worst(ax: Axes, found: Placement) -> None:
    """Offset over distance at the worst corner, simulated: the new place and today's."""
    runs: list[tuple[str, Trajectory, Any]] = [("placed", found.proof, "-")]
    if found.proof_today is not None:
        runs.append(("today", found.proof_today, DASHES[1]))
    for n, (words, run, dashes) in enumerate(runs):
        ax.plot(run["X"], run["Y"], color=COLOURS[n], linestyle=dashes, label=words)
    end = found.proof["X"][-1]
    most = max(float(np.abs(found.proof["Y"]).max()), 1e-3)
    ax.set_xlim(0, end)
    low, high = ax.get_ylim()
    ax.set_ylim(max(low, -4 * most), min(high, 4 * most))
    ax.axhline(0, color=MUTED, lw=0.8)
    ax.set_xlabel("distance along the runway X (m)")
    ax.set_ylabel("offset to the right Y (m)")
    kept = {s for s, axis in found.case.axes.items() if axis.low != axis.high} | {"u", "x_cg"}
    ax.set_title(
        f"simulated with the {found.case.model} model, v = {found.case.v0:g} m/s at the start, at"
        f" the worst corner:\n{describe(found.worst.corner, kept)}",
        fontsize=8,
    )
    ax.legend()


def front_figure(front: Front) -> Figure:
    """The Pareto front; beside some points the station of the main gear."""
    from matplotlib import pyplot

    kind = KINDS[front.against]
    factor = SHOWN[kind.shown][0]
    label = _DRAWN.get(front.case.objective, _DECAY)[1]
    x, y = factor * front.other, front.margin
    with style():
        figure, ax = pyplot.subplots(figsize=(6.4, 4.2), layout="constrained")
        ax.plot(x, y, "-o", color=COLOURS[0])
        stride = max(1, len(x) // 6)
        for k in range(0, len(x), stride):
            ax.annotate(
                _mm(front.stations[k]),
                (x[k], y[k]),
                (6, 4),
                textcoords="offset points",
                fontsize=7.5,
                color=MUTED,
            )
        ax.set_xlabel(f"worst {front.against.replace('_', ' ')} ({kind.shown})")
        ax.set_ylabel(f"worst {label}")
        ax.set_title(
            f"{plain(front.case.plane.name)} as a {front.case.layout},"
            f" {front.case.stiffness} stiffness\n"
            "beside the points: main gear station behind the datum"
        )
        ax.margins(x=0.08, y=0.1)
        return figure
