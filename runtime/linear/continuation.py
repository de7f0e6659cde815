"""Curves of equilibria over a parameter, followed by pseudo-arclength.

A step goes along the tangent and is corrected across it, so that a curve is followed around its
folds (H. B. Keller, "Numerical solution of bifurcation and nonlinear eigenvalue problems", 1977).
Where a test function changes sign between two points, the zero is found on the curve between them
(W. Govaerts, "Numerical Methods for Bifurcations of Dynamical Equilibria", 2000).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from groundroll.base.arrays import FloatArray

#: Of coordinates in which all are of one size: rates and their derivatives by all coordinates, (n,)
#: and (n, n + 1), each row of one size, and the matrix of motion.
System = Callable[[FloatArray], tuple[FloatArray, FloatArray, FloatArray]]
ComplexArray = npt.NDArray[np.complex128]

#: Steps, in widths of the coordinates: at first, at most, at least.
_FIRST, _LONGEST, _SHORTEST = 0.02, 0.25, 1e-7
#: Newton steps of a correction; after few of them the next step may be longer.
_CORRECTIONS, _FEW = 8, 3
#: A correction is done below this; tangents of neighbours turn no more than this (cosine).
_DONE, _TURN = 1e-10, 0.98
_MOST_POINTS, _FARTHEST = 3000, 1e4
#: A zero of a test function is narrowed down so often, and to this part of the step.
_NARROWED, _NARROW = 80, 1e-9
#: Curves closer than this are one, and so are marks.
_SAME, _SAME_MARK = 1e-6, 1e-3


class Point(NamedTuple):
    """A point of a curve, its unit tangent, and what is watched there by name."""

    z: FloatArray
    tangent: FloatArray
    tests: Mapping[str, float]
    eigenvalues: ComplexArray


@dataclass(frozen=True)
class Curve:
    """Points in order, what is marked among them, and why it ends where it begins and ends.

    Attributes
    ----------
    points : ndarray, shape (n, coordinates)
    marks : tuple of (str, int)
        ``fold``, ``hopf`` or ``branch_point``, and which point it is.
    ends : tuple of str
        ``range``, ``closed``, ``far``, ``lost``, or the name of what reaches its limit.
    """

    points: FloatArray
    marks: tuple[tuple[str, int], ...]
    ends: tuple[str, str]


@dataclass(frozen=True)
class Follower:
    """Follows the zeros of a system over its last coordinate.

    Attributes
    ----------
    system : callable
        Of scaled coordinates, the last of them that over which the curve goes.
    end : float
        The last coordinate goes from zero to this.
    limits : mapping of str to (int, float)
        Coordinates that end the curve, by name: which, and where.
    """

    system: System
    end: float
    limits: Mapping[str, tuple[int, float]]

    def curves(self, starts: Sequence[FloatArray]) -> list[Curve]:
        """The curves through points near them, and those that branch off, each once."""
        found: list[Curve] = []
        for start in starts:
            z = self._at(start)
            if z is not None and not any(self._is_on(curve, z) for curve in found):
                found.append(self._both_ways(z, None))
        for curve in found:  # which grows
            for kind, k in curve.marks:
                if kind != "branch_point":
                    continue
                for z in self._beside(curve, k):
                    if not any(self._is_on(other, z) for other in found):
                        found.append(self._both_ways(z, None))
        return found

    def _both_ways(self, z: FloatArray, tangent: FloatArray | None) -> Curve:
        start = self._point(z, tangent)
        if start is None:
            return Curve(z[None], (), ("lost", "lost"))
        ahead, marked, end = self._one_way(start)
        if end == "closed":
            return Curve(np.stack(ahead), tuple(marked), (end, end))
        turned = start._replace(tangent=-start.tangent)
        behind, others, begin = self._one_way(self._point(turned.z, turned.tangent) or turned)
        shift = len(behind) - 1
        points = np.stack([*behind[:0:-1], *ahead])
        marks = [(kind, shift - k) for kind, k in others] + [(s, shift + k) for s, k in marked]
        return Curve(points, tuple(sorted(marks, key=lambda mark: mark[1])), (begin, end))

    def _one_way(self, start: Point) -> tuple[list[FloatArray], list[tuple[str, int]], str]:
        points, here, length = [start.z], start, _FIRST
        marks: list[tuple[str, int]] = []
        while len(points) < _MOST_POINTS:
            if length < _SHORTEST:
                return points, marks, "lost"
            there, quick = self._step(here, length)
            if there is None or there.tangent @ here.tangent < _TURN:
                last = self._last(here, length)
                if last is not None:
                    more = [] if np.abs(last - points[-1]).max() < _DONE else [last]
                    return points + more, marks, "range"
                length /= 2
                continue
            part = _part(here.z, there.z, start.z)
            closes = len(points) > 4 and part is not None and there.tangent @ start.tangent > _TURN
            if closes and part is not None:
                there, length = start, part
            for kind, point in self._between(here, there, length):
                if kind in self.limits:
                    return [*points, point], marks, kind
                points.append(point)
                marks.append((kind, len(points) - 1))
            points.append(there.z)
            if closes:
                return points, marks, "closed"
            if np.abs(there.z[:-1]).max() > _FARTHEST:
                return points, marks, "far"
            here, length = there, min(length * (1.4 if quick else 1.0), _LONGEST)
        return points, marks, "lost"

    # --- Steps ---

    def _corrected(
        self, z: FloatArray, border: FloatArray, level: float
    ) -> tuple[FloatArray, int] | None:
        """The zero at which border @ z is as given, near z, and after how many steps."""
        z = z.copy()
        for k in range(_CORRECTIONS):
            if not -1e-9 <= z[-1] <= self.end + 1e-9:
                return None
            rates, slopes, _ = self.system(z)
            matrix = np.vstack([slopes, border])
            left = np.append(rates, border @ z - level)
            if not (np.isfinite(matrix).all() and np.isfinite(left).all()):
                return None
            scale = np.abs(matrix).max(axis=1) + 1e-300
            try:
                step = np.linalg.solve(matrix / scale[:, None], left / scale)
            except np.linalg.LinAlgError:  # at a branch point
                step = np.linalg.lstsq(matrix / scale[:, None], left / scale)[0]
            z -= step
            if np.abs(step).max() < _DONE * (1 + np.abs(z).max()):
                return z, k
        return None

    def _at(self, z: FloatArray) -> FloatArray | None:
        """The equilibrium near z at the same last coordinate."""
        found = self._corrected(z, np.eye(z.size)[-1], float(z[-1]))
        return None if found is None else found[0]

    def _step(self, here: Point, length: float) -> tuple[Point | None, bool]:
        predicted = here.z + length * here.tangent
        level = float(here.tangent @ predicted)
        found = self._corrected(predicted, here.tangent, level)
        if found is None or np.linalg.norm(found[0] - predicted) > length / 2:
            return None, False
        return self._point(found[0], here.tangent), found[1] <= _FEW

    def _last(self, here: Point, length: float) -> FloatArray | None:
        """The end of the range, if the next step leads there."""
        slope = here.tangent[-1]
        goal = self.end if slope > 0 else 0.0
        away = (goal - here.z[-1]) / slope if abs(slope) > 1e-6 else math.inf
        if away > length:
            return None
        predicted = here.z + away * here.tangent
        predicted[-1] = goal
        found = self._at(predicted)
        if found is None or np.linalg.norm(found - predicted) > max(away, 1e-6):
            return None
        return found

    def _point(self, z: FloatArray, along: FloatArray | None) -> Point | None:
        _, slopes, motion = self.system(z)
        if not (np.isfinite(slopes).all() and np.isfinite(motion).all()):
            return None
        tangent = np.linalg.svd(slopes)[2][-1]
        if along is not None and tangent @ along < 0:
            tangent = -tangent
        eigenvalues = np.linalg.eigvals(motion).astype(np.complex128)
        tests = {
            "fold": float(tangent[-1]),
            "branch_point": float(np.linalg.det(np.vstack([slopes, tangent]))),
            "hopf": _hopf(eigenvalues),
            **{name: float(z[k] - most) for name, (k, most) in self.limits.items()},
        }
        return Point(z, tangent, tests, eigenvalues)

    # --- Marks ---

    def _between(self, here: Point, there: Point, length: float) -> list[tuple[str, FloatArray]]:
        """What is to be marked between two points, in order."""
        found: list[tuple[float, str, FloatArray]] = []
        for name, before in here.tests.items():
            if before * there.tests[name] >= 0:
                continue
            s, point = self._zero_of(name, here, there, length)
            if name != "hopf" or _is_pair(point.eigenvalues):
                found.append((s, name, point.z))
        found.sort(key=lambda each: each[0])
        crossed = [s for s, name, _ in found if name == "branch_point"]
        return [
            (name, z)
            for s, name, z in found
            if name != "fold" or all(abs(s - other) > _SAME_MARK for other in crossed)
        ]

    def _zero_of(self, name: str, here: Point, there: Point, length: float) -> tuple[float, Point]:
        """How far from `here`, and where, a test function is zero: the Illinois method."""
        low, high, best = 0.0, length, there
        at_low, at_high = here.tests[name], there.tests[name]
        for k in range(_NARROWED):
            middle = (low * at_high - high * at_low) / (at_high - at_low)
            if k % 3 == 2 or not low < middle < high:
                middle = (low + high) / 2
            point, _ = self._step(here, middle)
            if point is None:
                break
            best, value = point, point.tests[name]
            if value * at_low > 0:
                low, at_low, at_high = middle, value, at_high / 2
            else:
                high, at_high, at_low = middle, value, at_low / 2
            if high - low < _NARROW * length or value == 0:
                break
        return (low + high) / 2, best

    def _beside(self, curve: Curve, k: int) -> list[FloatArray]:
        """Points of the other curve through a branch point, on either side of it."""
        z = curve.points[k]
        _, slopes, _ = self.system(z)
        plane = np.linalg.svd(slopes)[2][-2:]
        along = curve.points[min(k + 1, len(curve.points) - 1)] - curve.points[max(k - 1, 0)]
        part = plane @ along
        across = np.array([-part[1], part[0]]) @ plane / max(np.linalg.norm(part), 1e-300)
        found = []
        for sign in (1.0, -1.0):
            predicted = z + sign * _FIRST * across
            there = self._corrected(predicted, across, float(across @ predicted))
            # the other curve need not be at right angles to this one
            if there is not None and np.linalg.norm(there[0] - z) < 10 * _FIRST:
                found.append(there[0])
        return found

    def _is_on(self, curve: Curve, z: FloatArray) -> bool:
        """Whether a point is one of a curve: corrected from a chord, across it, it is itself."""
        tolerance = _SAME * (1 + np.abs(z).max())
        if np.abs(curve.points - z).max(axis=1).min() < tolerance:
            return True
        first, chords = curve.points[:-1], np.diff(curve.points, axis=0)
        lengths = np.linalg.norm(chords, axis=1)
        near = np.linalg.norm(first - z, axis=1) <= 1.5 * lengths + tolerance
        for k in np.flatnonzero(near & (lengths > 0)):
            along = chords[k] / lengths[k]
            level = float(along @ z)
            part = level - along @ first[k]
            if not -tolerance <= part <= lengths[k] + tolerance:
                continue
            found = self._corrected(first[k] + part * along, along, level)
            if found is not None and np.abs(found[0] - z).max() < tolerance:
                return True
        return False


def _part(first: FloatArray, second: FloatArray, z: FloatArray) -> float | None:
    """How far from the first to the second of two neighbours z is, if it is between them."""
    chord = second - first
    length = np.linalg.norm(chord)
    part = float((z - first) @ chord / length)
    off = np.linalg.norm(z - first - part * chord / length)
    return part if 0 < part <= length and off < 0.1 * length else None


def _sums(eigenvalues: ComplexArray) -> ComplexArray:
    first, second = np.triu_indices(eigenvalues.size, 1)
    return np.asarray(eigenvalues[first] + eigenvalues[second])


def _hopf(eigenvalues: ComplexArray) -> float:
    """A number that changes sign where two eigenvalues become each other's negative."""
    moving = eigenvalues[np.abs(eigenvalues) > 1e-9 * (1e-300 + np.abs(eigenvalues).max(initial=0))]
    sums = _sums(moving)
    if not sums.size:
        return 1.0
    sign = np.prod(sums / np.maximum(np.abs(sums), 1e-300)).real
    return float(np.abs(sums).min() * (1.0 if sign >= 0 else -1.0))


def _is_pair(eigenvalues: ComplexArray) -> bool:
    """Whether those that are each other's negative are on the imaginary axis, not the real one."""
    first, second = np.triu_indices(eigenvalues.size, 1)
    k = int(np.abs(_sums(eigenvalues)).argmin())
    a, b = eigenvalues[first[k]], eigenvalues[second[k]]
    return bool(abs(a.imag) > 1e-6 * abs(a) and abs(b.imag) > 1e-6 * abs(b))
