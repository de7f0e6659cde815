"""What becomes of an aircraft that starts off straight running: does it straighten out?"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
import numpy.typing as npt

from .aircraft import Aircraft
from .arrays import FloatArray, common_shape, finite, positive
from .chunks import cut, piece, run
from .ensemble_result import Ensemble
from .ensembles import ensemble
from .errors import GroundrollError

ByteArray = npt.NDArray[np.int8]

#: What becomes of a kicked aircraft, in the order of the numbers in `Survival` and `Basin`.
FATES = ("straightens out", "turns too far", "leaves the runway", "still moving", "not computed")
OUT, _TURNS, _LEAVES, _MOVING, _UNKNOWN = range(len(FATES))

#: Samples over a run, in which straightening out is sought, and runs that are sampled at once.
_SAMPLES, _RUNS = 401, 16_384


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
        limits={"psi": criterion.heading, "Y": criterion.half_width},
        within={"psi": criterion.heading},
        **start,
        **options,
    )
    when = np.maximum(*(_settled(ens, name, criterion.settled) for name in ("v", "r")))
    fate = np.where(np.isnan(when), _MOVING, OUT)
    fate[~ens.ok] = _UNKNOWN
    psi, Y = ens.first["psi"], ens.first["Y"]
    fate[(np.nan_to_num(when, nan=np.inf) >= Y) & np.isfinite(Y)] = _LEAVES
    fate[np.isfinite(psi) & (psi <= Y)] = _TURNS
    return fate.astype(np.int8), np.where(fate == OUT, when, np.nan)


def _settled(ens: Ensemble, name: str, share: float) -> FloatArray:
    """When a state falls for good to a share of its largest value; NaN if it never does."""
    size = np.abs(ens.samples[name])
    limit = share * np.fmax.reduce(size, axis=-1, keepdims=True)
    outside = size > limit
    last = outside.shape[-1] - 1 - outside[..., ::-1].argmax(axis=-1)
    after = np.minimum(last + 1, outside.shape[-1] - 1)
    before_value, after_value = (
        np.take_along_axis(size, k[..., None], axis=-1)[..., 0] for k in (last, after)
    )
    with np.errstate(divide="ignore", invalid="ignore"):
        part = (before_value - limit[..., 0]) / (before_value - after_value)
    when = ens.at[last] + part * (ens.at[after] - ens.at[last])
    when = np.where(outside.any(axis=-1), when, 0.0)
    return np.where((last == after) & outside[..., -1], np.nan, when)
