"""What becomes of an aircraft that starts off straight running: does it straighten out?"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
import numpy.typing as npt

from groundroll.aircraft.aircraft import Aircraft
from groundroll.base.arrays import FloatArray, common_shape, finite, positive
from groundroll.base.errors import GroundrollError
from groundroll.motion.chunks import cut, piece, run
from groundroll.runs.ensemble_result import Ensemble
from groundroll.runs.ensembles import ensemble

ByteArray = npt.NDArray[np.int8]

#: What becomes of a kicked aircraft, in the order of the numbers in `Survival` and `Basin`.
FATES = ("straightens out", "turns too far", "leaves the runway", "still moving", "not computed")
OUT, _TURNS, _LEAVES, _MOVING, _UNKNOWN = range(len(FATES))

#: Samples over a run, in which straightening out is sought, and runs that are sampled at once.
_SAMPLES, _RUNS = 401, 16_384
#: Share of a limit that a peak between samples may pass only from.
_NEAR = 0.8


@dataclass(frozen=True)
class Criterion:
    """What counts as surviving a kick.

    Attributes
    ----------
    half_width : float
        m; the CG stays within it until the aircraft has straightened out.
    heading : float
        rad; the heading stays within it.
    settled : float
        The aircraft has straightened out when lateral velocity and yaw rate have both fallen for
        good to this share of their largest values.
    t : float
        s, in which it must.
    """

    half_width: float = 15.0
    heading: float = math.radians(45)
    settled: float = 0.1
    t: float = 20.0

    def __post_init__(self) -> None:
        for name, unit in {"half_width": "m", "heading": "rad", "settled": "1", "t": "s"}.items():
            object.__setattr__(self, name, positive(name, getattr(self, name), unit))
        if self.settled >= 1:
            raise GroundrollError(f"settled must be below 1, not {self.settled!r}")


def fates(
    plane: Aircraft,
    v: Any,
    r: Any,
    criterion: Criterion,
    told: Callable[[int], object] = lambda runs: None,
    **options: Any,
) -> tuple[ByteArray, FloatArray]:
    """What becomes of aircraft that start with v and r, and when they have straightened out.

    Parameters
    ----------
    plane : Aircraft
        The aircraft; its parameters broadcast with v and r.
    v, r : float or array
        m/s and rad/s.
    criterion : Criterion
        What counts as surviving.
    told : callable
        Called with every number of runs that are done.
    **options
        ``threads`` and ``executor`` of `groundroll.ensemble`.

    Returns
    -------
    fate : ndarray of int8
        Index of `FATES`.
    when : ndarray
        s; NaN for those that do not straighten out in time.
    """
    start = {"v": finite("v", v, "m/s"), "r": finite("r", r, "rad/s")}
    shape = common_shape({**plane.given, **start})
    total = math.prod(shape)
    fate, when = np.empty(total, np.int8), np.empty(total)

    def task(part: range) -> tuple[Aircraft, dict[str, FloatArray]]:
        given = {s: piece(value, shape, part) for s, value in plane.given.items() if value.ndim}
        values = {f"{s}0": piece(value, shape, part) for s, value in start.items()}
        return plane.replace(**given), values

    def keep(part: range, found: tuple[ByteArray, FloatArray]) -> None:
        where = slice(part.start, part.stop)
        fate[where], when[where] = found

    run(partial(_judged, criterion, options), cut(total, _RUNS), task, keep, told)
    return fate.reshape(shape), when.reshape(shape)


def _judged(
    criterion: Criterion, options: dict[str, Any], started: tuple[Aircraft, dict[str, Any]]
) -> tuple[ByteArray, FloatArray]:
    plane, start = started
    ens = ensemble(
        plane,
        criterion.t,
        at=np.linspace(0.0, criterion.t, _SAMPLES),
        names=("v", "r"),
        extremes=("v", "r"),
        limits={"psi": criterion.heading, "Y": criterion.half_width},
        within={"psi": criterion.heading},
        **start,
        **options,
    )
    when = np.maximum(*(_settled(ens, name, criterion.settled) for name in ("v", "r")))
    psi, Y = ens.first["psi"], ens.first["Y"]
    leaves = np.isfinite(Y) & (np.nan_to_num(when, nan=np.inf) >= Y)
    turns = np.isfinite(psi) & (~leaves | (psi <= Y))
    lost = ~ens.ok & ~np.isfinite(psi)
    fate = np.select(
        [lost, turns, leaves, np.isnan(when)], [_UNKNOWN, _TURNS, _LEAVES, _MOVING], OUT
    )
    return fate.astype(np.int8), np.where(fate == OUT, when, np.nan)


def _settled(ens: Ensemble, name: str, share: float) -> FloatArray:
    """When a state falls for good to a share of its largest value; NaN if it never does."""
    count = ens.at.size
    state = ens.samples[name].reshape(-1, count)
    limit = share * ens.largest[name].reshape(-1, 1)
    outside = np.abs(state) > limit
    row, peak, beside = _peaks(np.abs(state), limit, outside)
    outside[row, peak] = True
    last = count - 1 - outside[:, ::-1].argmax(axis=1)[:, None]
    begin = np.clip(last - 1, 0, count - 4)
    values = np.take_along_axis(state, begin + np.arange(4), axis=1)
    sign = np.sign(np.take_along_axis(state, last, axis=1))
    since = (last - begin).astype(float)
    since[row, 0] += np.where(last[row, 0] == peak, beside, 0.0)
    passed = _falls(values * sign, limit, since, last - begin + 1.0)
    when = np.where(outside.any(axis=1), ens.at[1] * (begin + passed)[:, 0], 0.0)
    return np.where(outside[:, -1], np.nan, when).reshape(ens.status.shape)


def _peaks(
    size: FloatArray, limit: FloatArray, outside: npt.NDArray[np.bool_]
) -> tuple[npt.NDArray[np.intp], npt.NDArray[np.intp], FloatArray]:
    """Samples beside which a parabola passes the limit that they do not, and how far beside."""
    near = (size > _NEAR * limit) & ~outside
    near[:, [0, -1]] = False
    row, k = np.nonzero(near)
    left, middle, right = (size[row, k + step] for step in (-1, 0, 1))
    top = (middle >= left) & (middle >= right) & (middle > np.minimum(left, right))
    row, k = row[top], k[top]
    rise, bend = (right - left)[top], (2 * middle - left - right)[top]
    over = middle[top] + rise**2 / (8 * bend) > limit[row, 0]
    return row[over], k[over], (rise / (2 * bend))[over]


def _falls(values: FloatArray, limit: FloatArray, low: Any, high: Any) -> FloatArray:
    """Where the cubic through values at 0, 1, 2, 3 falls to a limit between two places.

    Straight lines between samples, and their peaks, move thresholds by more than a thousandth.
    """
    terms = np.moveaxis(values @ np.linalg.inv(np.vander(np.arange(4.0))).T, -1, 0)[..., None]
    for _ in range(40):
        x = (low + high) / 2
        above = np.polyval(terms, x) > limit
        low, high = np.where(above, x, low), np.where(above, high, x)
    return np.asarray(high)
