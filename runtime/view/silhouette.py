"""The silhouette of an aircraft or a car on the ground: what it leaves and what pushes it."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.colors import to_hex, to_rgb
from matplotlib.patches import PathPatch, Rectangle
from matplotlib.path import Path as Outline
from matplotlib.transforms import Affine2D

from groundroll.base.arrays import FloatArray

from .plots import INK
from .rolls import Roll

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Right half of the airframe, (ahead, right), in lengths from the CG to the fin. Only where the
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
#: In the same lengths: half the track of a pair of wheels, where a nose wheel stands, half length
#: and half width of a tire and of the propeller.
_TRACK, _NOSE_WHEEL = 0.27, 0.40
_TIRE, _PROPELLER = (0.068, 0.026), (0.010, 0.230)
#: How far the body of a car reaches beyond its wheels, in lengths between its axles.
_OVERHANG, _FLANK, _CORNER = 0.28, 0.05, 0.12

ASPHALT, PAINT = "#D6D7DB", "#FFFFFF"


def draw_aircraft(
    axes: Axes, roll: Roll, t: float, shade: float, zorder: float, enlarged: float = 1.0
) -> list[Any]:
    """What rolls where it is at a time, the paler the smaller its shade."""
    ground = _to_ground(axes, roll, t, enlarged)
    paint, rubber = _mixed(roll.colour, shade), _mixed(INK, shade)
    wheels = [_box(*at, *_TIRE, rubber) for at in _wheels(roll, t)]
    outline = _airframe() if roll.flies else _car(np.array(list(_wheels(roll, t))))
    body = PathPatch(outline, facecolor=paint, edgecolor=PAINT, linewidth=0.4)
    nose = [_box(0.575, 0.0, *_PROPELLER, rubber)] if roll.flies else []
    patches = [*nose, body, *wheels]
    for order, patch in enumerate(patches):
        patch.set(transform=ground + axes.transData, zorder=zorder + 0.01 * order)
        axes.add_patch(patch)
    return patches


def draw_tire_tracks(axes: Axes, roll: Roll) -> None:
    """Where the wheels have gone."""
    for n, kind in enumerate(roll.kinds):
        if kind not in ("wheel", "wheels"):
            continue
        ahead, right = roll.places[:, n].T
        half = _TRACK * roll.size if kind == "wheels" else 0.0
        for side in (half, -half) if half else (0.0,):
            path = roll.track(ahead, right + side)
            axes.plot(*path, color=INK, linewidth=0.6, alpha=0.4, zorder=2)


def draw_pushes(
    axes: Axes, roll: Roll, t: float, strongest: float, zorder: float, enlarged: float = 1.0
) -> list[Any]:
    """An arrow where a force acts, its length in proportion to it."""
    arrows = []
    for _, kind, place, force in roll.acting(t):
        if kind != "force" or np.hypot(*force) < 0.02 * strongest or not strongest:
            continue
        at = place / roll.size
        ends = np.stack([at, at - 1.5 * force / strongest])
        head, start = _to_ground(axes, roll, t, enlarged).transform(ends).tolist()
        look = {"arrowstyle": "-|>", "color": INK, "linewidth": 1.2, "shrinkA": 0, "shrinkB": 0}
        arrows.append(axes.annotate("", head, start, arrowprops=look, zorder=zorder + 0.5))
    return arrows


def _wheels(roll: Roll, t: float) -> Iterator[tuple[float, float]]:
    """Where the wheels stand, ahead and right, in lengths of what rolls.

    If all stand behind the CG, one that the model leaves out carries the nose; what it has instead
    below the fin is no wheel.
    """
    found = [
        (float(place[0]) / roll.size, float(place[1]) / roll.size, kind)
        for _, kind, place, _ in roll.acting(t)
        if kind in ("wheel", "wheels")
    ]
    has_nose_wheel = roll.flies and found and all(ahead < 0 for ahead, _, _ in found)
    for ahead, right, kind in found:
        if has_nose_wheel and ahead <= -1.0 + 1e-9:
            continue
        sides = (_TRACK, -_TRACK) if kind == "wheels" else (0.0,)
        yield from ((ahead, right + side) for side in sides)
    if has_nose_wheel:
        yield _NOSE_WHEEL, 0.0


@cache
def _airframe() -> Outline:
    """The airframe as one shape in lengths from the CG to the fin."""
    parts = []
    for half in AIRFRAME.values():
        right = np.array(half)
        ring = np.concatenate([right, (right * [1, -1])[::-1], right[:1]])
        parts.append(Outline(ring, closed=True))
    return Outline.make_compound_path(*parts)


def _car(wheels: FloatArray) -> Outline:
    """A body around wheels, its corners cut."""
    if not wheels.size:
        wheels = np.zeros((1, 2))
    front, rear = wheels[:, 0].max() + _OVERHANG, wheels[:, 0].min() - _OVERHANG
    side = max(np.abs(wheels[:, 1]).max() + _FLANK, _TRACK + _FLANK)
    c = _CORNER
    half = [(front, 0), (front, side - c), (front - c, side), (rear + c, side), (rear, side - c)]
    right = np.array([*half, (rear, 0)])
    return Outline(np.concatenate([right, (right * [1, -1])[::-1], right[:1]]), closed=True)


def _to_ground(axes: Axes, roll: Roll, t: float, enlarged: float) -> Affine2D:
    """From lengths of what rolls, ahead and right, to the ground; undistorted where that is."""
    X, Y, psi = roll.at(t)
    stretch, size = float(axes.get_aspect()), enlarged * roll.size
    turned = Affine2D().rotate(np.arctan2(stretch * np.sin(psi), np.cos(psi)))
    return turned.scale(size, size / stretch).translate(X, Y)


def _box(ahead: float, right: float, long: float, wide: float, colour: str) -> Any:
    corner = (ahead - long, right - wide)
    return Rectangle(corner, 2 * long, 2 * wide, facecolor=colour, edgecolor="none")


def _mixed(colour: str, share: float) -> str:
    """A colour mixed with that of the runway."""
    mixed = share * np.array(to_rgb(colour)) + (1 - share) * np.array(to_rgb(ASPHALT))
    return to_hex(mixed.tolist())
