"""What becomes of an aircraft that starts off straight running: does it stay on the runway?

Where the speed is held it does if it straightens out, where the speed falls if it comes to a stop.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from groundroll.aircraft.aircraft import Aircraft
from groundroll.base.arrays import FloatArray, common_shape, finite, positive
from groundroll.base.errors import GroundrollError
from groundroll.model.models import Model, ModelLike, as_model
from groundroll.motion.chunks import cut, piece, run
from groundroll.runs.ensemble_result import Ensemble
from groundroll.runs.ensembles import ensemble

ByteArray = npt.NDArray[np.int8]

#: What becomes of a kicked aircraft, in the order of the numbers in `Survival` and `Basin`.
FATES = (
    "stays on the runway",
    "turns too far",
    "leaves the runway",
    "still moving",
    "not computed",
)
OUT, _TURNS, _LEAVES, _MOVING, _UNKNOWN = range(len(FATES))

#: Event at which a roll is over, and time in which it must be where the speed falls, s.
_STOPPED, _ROLL = "stopped", 300.0
#: What a model must know of its states to tell where the aircraft goes.
_ROLES = ("lateral_velocity", "yaw_rate", "heading", "offset")
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
        m; the CG stays within it until the aircraft has straightened out or stopped.
    heading : float
        rad; the heading stays within it.
    settled : float
        The aircraft has straightened out when lateral velocity and yaw rate have both fallen for
        good to this share of their largest values. Where the speed falls it must stop instead.
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


def stops(model: Model) -> bool:
    """Whether a roll in a model comes to an end: its speed falls, and it knows when it is over."""
    return any(event.name == _STOPPED for event in model.events)


def criterion_of(model: Model, half_width: Any, heading: Any, settled: float, t: Any) -> Criterion:
    """The criterion for a model, with its time if none is given."""
    usual = _ROLL if stops(model) else Criterion.t
    return Criterion(half_width, heading, settled, usual if t is None else t)


def needed(model: Model) -> tuple[str, ...]:
    """Symbols of lateral velocity, yaw rate, heading and offset.

    Raises
    ------
    GroundrollError
        If the model does not say which of its states they are.
    """
    missing = [role for role in _ROLES if model.roles.get(role) not in model.states]
    if missing:
        raise GroundrollError(
            f"what becomes of an aircraft needs {' and '.join(missing).replace('_', ' ')}, and the"
            f" model {model.name} has no state of that role"
        )
    return tuple(model.roles[role] for role in _ROLES)


def fates(
    plane: Aircraft,
    v: Any,
    r: Any,
    criterion: Criterion,
    callback: Callable[[int], object] = lambda runs: None,
    model: ModelLike = "nonlinear",
    inputs: Mapping[str, FloatArray] | None = None,
    **options: Any,
) -> tuple[ByteArray, FloatArray]:
    """What becomes of aircraft that start with v and r, and when it is over.

    Parameters
    ----------
    plane : Aircraft
        The aircraft; its parameters broadcast with v and r.
    v, r : float or array
        m/s and rad/s.
    criterion : Criterion
        What counts as surviving.
    callback : callable
        Called with every number of runs that are done.
    model : str or Model
    inputs : mapping of str to ndarray
        Constant inputs by symbol; they broadcast with v and r.
    **options
        ``threads`` and ``executor`` of `groundroll.ensemble`.

    Returns
    -------
    fate : ndarray of int8
        Index of `FATES`.
    when : ndarray
        When it has straightened out or stopped, s; NaN for those that do not in time.
    """
    model = as_model(model)
    names = needed(model)
    start = {f"{names[0]}0": finite("v", v, "m/s"), f"{names[1]}0": finite("r", r, "rad/s")}
    values = {**start, **(inputs or {})}
    shape = common_shape({**plane.given, **values})
    total = math.prod(shape)
    fate, when = np.empty(total, np.int8), np.empty(total)

    def task(part: range) -> tuple[Aircraft, dict[str, FloatArray]]:
        given = {s: piece(value, shape, part) for s, value in plane.given.items() if value.ndim}
        return plane.replace(**given), {s: piece(x, shape, part) for s, x in values.items()}

    def keep(part: range, found: tuple[ByteArray, FloatArray]) -> None:
        where = slice(part.start, part.stop)
        fate[where], when[where] = found

    judged = partial(_stopped if stops(model) else _straightened, criterion, model, options)
    run(judged, cut(total, _RUNS), task, keep, callback)
    return fate.reshape(shape), when.reshape(shape)


Started: TypeAlias = tuple[Aircraft, dict[str, Any]]


def _straightened(
    criterion: Criterion, model: Model, options: dict[str, Any], started: Started
) -> tuple[ByteArray, FloatArray]:
    plane, values = started
    v, r, psi, Y = needed(model)
    ens = ensemble(
        plane,
        criterion.t,
        model,
        at=np.linspace(0.0, criterion.t, _SAMPLES),
        names=(v, r),
        extremes=(v, r),
        limits={psi: criterion.heading, Y: criterion.half_width},
        within={psi: criterion.heading},
        **values,
        **options,
    )
    when = np.maximum(*(_settled(ens, name, criterion.settled) for name in (v, r)))
    return _judged(ens, ens.first[psi], ens.first[Y], when)


def _stopped(
    criterion: Criterion, model: Model, options: dict[str, Any], started: Started
) -> tuple[ByteArray, FloatArray]:
    plane, values = started
    v, _, psi, Y = needed(model)
    limits = {psi: criterion.heading, Y: criterion.half_width}
    ens = ensemble(
        plane,
        criterion.t,
        model,
        names=(v,),
        limits=limits,
        within=limits,
        until=_STOPPED,
        **values,
        **options,
    )
    stopped = ens.events[_STOPPED]
    when = np.where(np.isfinite(stopped), stopped, np.nan)
    return _judged(ens, ens.first[psi], ens.first[Y], when)


def _judged(
    ens: Ensemble, psi: FloatArray, Y: FloatArray, when: FloatArray
) -> tuple[ByteArray, FloatArray]:
    """Fates by the times at which limits are passed, and at which it is over."""
    leaves = np.isfinite(Y) & (np.nan_to_num(when, nan=np.inf) >= Y)
    turns = np.isfinite(psi) & (~leaves | (psi <= Y))
    lost = ~ens.ok & ~np.isfinite(psi) & ~np.isfinite(Y)
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
