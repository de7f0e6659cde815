"""The silhouette of an aircraft on the ground: where it is, what it leaves and what pushes it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.colors import to_hex, to_rgb
from matplotlib.patches import PathPatch, Rectangle
from matplotlib.path import Path as Outline
from matplotlib.transforms import Affine2D

from .arrays import FloatArray
from .plots import INK

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Right half of the airframe, (ahead, right), in lengths from the CG to the tail. Only where the
#: wheels stand is the aircraft's own; the rest is a typical light aircraft.
AIRFRAME = {
    "fuselage": (
        *((0.560, 0.000), (0.552, 0.030), (0.520, 0.052), (0.440, 0.092), (0.330, 0.110)),
        *((0.120, 0.120), (-0.080, 0.118), (-0.280, 0.096), (-0.700, 0.044), (-0.930, 0.022)),
        *((-1.060, 0.014), (-1.070, 0.000)),
    ),
    "wing": (
        *((0.190, 0.000), (0.190, 1.080), (0.178, 1.190), (0.140, 1.270), (0.060, 1.310)),
        *((-0.080, 1.315), (-0.150, 1.290), (-0.175, 1.220), (-0.185, 1.080), (-0.195, 0.000)),
    ),
    "tailplane": (
        *((-0.830, 0.000), (-0.860, 0.200), (-0.905, 0.360), (-0.950, 0.405), (-1.010, 0.415)),
        *((-1.045, 0.380), (-1.060, 0.200), (-1.060, 0.000)),
    ),
}
#: In the same lengths: half the track of the main gear, where a nose wheel stands, half length and
#: half width of a tire and of the propeller.
_TRACK, _NOSE_WHEEL = 0.27, 0.40
_TIRE, _PROPELLER = (0.068, 0.026), (0.010, 0.230)

ASPHALT, PAINT = "#D6D7DB", "#FFFFFF"


@dataclass(frozen=True, eq=False)
class Roll:
    """One run: its path over the ground, its wheels, and how it is drawn."""

    t: FloatArray
    X: FloatArray
    Y: FloatArray
    psi: FloatArray
    force: FloatArray
    a: float
    b: float
    label: str
    colour: str

    def at(self, t: float) -> tuple[float, float, float, float]:
        """Position, m, heading, rad, and side force, N, at a time, from sample to sample."""
        series = (self.X, self.Y, self.psi, self.force)
        X, Y, psi, force = (float(np.interp(t, self.t, s)) for s in series)
        return X, Y, psi, force

    def track(self, ahead: float, right: float) -> tuple[FloatArray, FloatArray]:
        """The path over the ground of a point of the aircraft, m from the CG."""
        cos, sin = np.cos(self.psi), np.sin(self.psi)
        return self.X + ahead * cos - right * sin, self.Y + ahead * sin + right * cos


@cache
def _outline() -> Outline:
    """The airframe as one shape in lengths from the CG to the tail."""
    parts = []
    for half in AIRFRAME.values():
        right = np.array(half)
        ring = np.concatenate([right, (right * [1, -1])[::-1], right[:1]])
        parts.append(Outline(ring, closed=True))
    return Outline.make_compound_path(*parts)


def draw_aircraft(axes: Axes, roll: Roll, t: float, shade: float, zorder: float) -> list[Any]:
    """The aircraft where it is at a time, the paler the smaller its shade."""
    ground = _to_ground(axes, roll, t)
    paint, rubber = _mixed(roll.colour, shade), _mixed(INK, shade)
    airframe = PathPatch(_outline(), facecolor=paint, edgecolor=PAINT, linewidth=0.4)
    main = roll.a / roll.b
    third = (-1.0 if roll.a > 0 else _NOSE_WHEEL, 0.0)
    wheels = [_box(*at, *_TIRE, rubber) for at in ((main, _TRACK), (main, -_TRACK), third)]
    patches = [_box(0.575, 0.0, *_PROPELLER, rubber), airframe, *wheels]
    for order, patch in enumerate(patches):
        patch.set(transform=ground + axes.transData, zorder=zorder + 0.01 * order)
        axes.add_patch(patch)
    return patches


def _to_ground(axes: Axes, roll: Roll, t: float) -> Affine2D:
    """From lengths of the aircraft, ahead and right, to the ground; undistorted where that is."""
    X, Y, psi, _ = roll.at(t)
    stretch = float(axes.get_aspect())
    turned = Affine2D().rotate(np.arctan2(stretch * np.sin(psi), np.cos(psi)))
    return turned.scale(roll.b, roll.b / stretch).translate(X, Y)


def draw_tire_tracks(axes: Axes, roll: Roll) -> None:
    half = _TRACK * roll.b
    points = [(roll.a, half), (roll.a, -half), *([(-roll.b, 0.0)] if roll.a > 0 else [])]
    for point in points:
        axes.plot(*roll.track(*point), color=INK, linewidth=0.6, alpha=0.4, zorder=2)


def _box(ahead: float, right: float, long: float, wide: float, colour: str) -> Any:
    corner = (ahead - long, right - wide)
    return Rectangle(corner, 2 * long, 2 * wide, facecolor=colour, edgecolor="none")


def _mixed(colour: str, share: float) -> str:
    """A colour mixed with that of the runway."""
    mixed = share * np.array(to_rgb(colour)) + (1 - share) * np.array(to_rgb(ASPHALT))
    return to_hex(mixed.tolist())


def draw_push(axes: Axes, roll: Roll, t: float, strongest: float, zorder: float) -> list[Any]:
    """An arrow at the tail, its length in proportion to the side force."""
    *_, force = roll.at(t)
    if strongest == 0 or abs(force) < 0.02 * strongest:
        return []
    ends = [(-1.0, 0.0), (-1.0, -1.5 * force / strongest)]
    tail, start = _to_ground(axes, roll, t).transform(ends).tolist()
    arrow = {"arrowstyle": "-|>", "color": INK, "linewidth": 1.2, "shrinkA": 0, "shrinkB": 0}
    return [axes.annotate("", tail, start, arrowprops=arrow, zorder=zorder + 0.5)]
