"""How late a pilot may be who holds an aircraft straight with the pedals.

Most aircraft with a tail wheel diverge when nobody steers, and are flown every day: what decides is
whether somebody who sees the heading and acts later can still hold them. The roll along the runway
is linearised where it is held, in wind or without, and closed by the crossover model of McRuer:
gains on heading and yaw rate, an exact delay, and the lag of muscles.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from groundroll.aircraft.aircraft import Aircraft, of_aircraft
from groundroll.base.arrays import FloatArray, broadcast, finite, stored
from groundroll.base.errors import GroundrollError
from groundroll.base.listing import Listed, span
from groundroll.linear.operating_point import points_at
from groundroll.model.models import Model, ModelLike, as_model
from groundroll.results.records import Column, Record, run_dims
from groundroll.results.results import Result

from .delay import Margins, Plant, best_gains
from .held import Lever, Rolls, solved

#: Bounds of the gains on heading, pedal over rad, and on yaw rate, pedal over rad/s.
HEADING_GAIN, YAW_RATE_GAIN = (0.5, 20.0), (0.05, 20.0)
#: Phase that may be lost beside the delay, rad.
PHASE_MARGIN = math.radians(30.0)
#: Rates of growth below this are none, 1/s.
_NEUTRAL = 1e-6
#: The pedal does nothing if it turns the nose by less, rad/s^2 at full pedal.
_NOTHING = 1e-9

#: Arrays of the result: unit and words of each.
_ARRAYS = {
    "speed": ("m/s", "speed along the runway"),
    "delay": ("s", "longest delay"),
    "heading_gain": ("1/rad", "pedal over heading"),
    "yaw_rate_gain": ("s/rad", "pedal over yaw rate"),
    "divergence": ("1/s", "rate of growth, hands off"),
    "doubling_time": ("s", "time in which a deviation doubles, hands off"),
    "pedal": ("1", "pedal that holds it"),
}


@dataclass(frozen=True, repr=False)
class PilotLimit(Listed, Result):
    """How late a pilot may be; every array has the shape of the cases.

    Attributes
    ----------
    speed : ndarray
        Along the runway, m/s.
    delay : ndarray
        The longest delay with which the best gains hold the aircraft with all margins, s, beside
        the lag of the muscles; NaN where none holds it, or nothing balances it. 100 s stand for
        any delay.
    heading_gain, yaw_rate_gain : ndarray
        These gains: pedal (1 is full) over rad and over rad/s.
    divergence : ndarray
        Rate at which a deviation grows with the controls as they are, 1/s; 0 if it does not.
    doubling_time : ndarray
        s; infinite where it never doubles.
    pedal : ndarray
        That holds the aircraft in the wind, -1 to 1; beyond that it is not held.
    lag : float
        Of the muscles, s.
    gain_margin, phase_margin : float
        Factor up and down, and rad, that the loop bears beside the delay.
    aircraft, model
        What is held.
    """

    speed: FloatArray
    delay: FloatArray
    heading_gain: FloatArray
    yaw_rate_gain: FloatArray
    divergence: FloatArray
    doubling_time: FloatArray
    pedal: FloatArray
    lag: float
    gain_margin: float
    phase_margin: float
    aircraft: Aircraft
    model: ModelLike

    def _record(self) -> Record:
        runs = run_dims(self.delay.shape)
        results = {s: Column(runs, getattr(self, s), *words) for s, words in _ARRAYS.items()}
        about = {s: getattr(self, s) for s in ("lag", "gain_margin", "phase_margin")}
        model = as_model(self.model)
        return Record("pilot", self.aircraft, model, runs, results, about=about)

    @classmethod
    def _of(cls, record: Record) -> PilotLimit:
        arrays: dict[str, Any] = {s: record[s] for s in _ARRAYS}
        return cls(**arrays, **record.about, aircraft=record.aircraft, model=record.model.key)

    def _title(self) -> str:
        head = f"PilotLimit of {self.aircraft.name!r}, {as_model(self.model).name} model"
        lost = int(np.isnan(self.delay).sum())
        missing = f"; {lost} of {self.delay.size} cannot be held at any delay" if lost else ""
        return f"{head}{missing}"

    def _rows(self) -> Iterable[Sequence[str]]:
        for s, (unit, words) in _ARRAYS.items():
            yield s, span(getattr(self, s)), "" if unit == "1" else unit, words

    def _notes(self) -> Iterable[str]:
        decibels, degrees = 20 * math.log10(self.gain_margin), math.degrees(self.phase_margin)
        yield f"margins {decibels:.3g} dB and {degrees:.3g} deg, lag of muscles {self.lag:g} s"
        yield "delays of pilots: 0.1 to 0.3 s (Swaim; Neal and Smith 1970)"


@of_aircraft
def pilot_limit(
    plane: Aircraft,
    model: ModelLike = "rollout",
    *,
    speed: Any = None,
    lag: Any = 0.1,
    gain_margin: float = 2.0,
    phase_margin: Any = PHASE_MARGIN,
    heading_gain: tuple[float, float] = HEADING_GAIN,
    yaw_rate_gain: tuple[float, float] = YAW_RATE_GAIN,
    **values: Any,
) -> PilotLimit:
    """The longest delay with which a pilot can still hold an aircraft straight.

    Margins, delay and crossings are exact for the linear model; the gains are searched for.
    The speed is taken as constant while the pilot steers.

    Parameters
    ----------
    plane : Aircraft
        The aircraft; its parameters may be arrays.
    model : str or Model
        ``"rollout"``, ``"landing_roll"``, or one of your own with a pedal and a runway.
    speed : float or array, optional
        Along the runway, m/s, positive; the aircraft's own if omitted.
    lag : float
        Of the muscles, s.
    gain_margin : float
        Factor up and down by which the gains may be wrong; 2 is 6 dB, 1 none.
    phase_margin : float
        Phase that may be lost, rad.
    heading_gain, yaw_rate_gain : tuple of float
        Bounds of the gains, pedal over rad and over rad/s.
    **values : float, array or str
        Inputs and parameters by symbol or full name: ``crosswind="5 kt"``, ``elevator="-10 deg"``.

    Returns
    -------
    PilotLimit
        Delay, gains and divergence of each case.

    Raises
    ------
    GroundrollError
        For values that cannot be, a model that does not know a pedal or a runway, or an aircraft
        on which the pedal does nothing.
    """
    chosen = as_model(model)
    margins = Margins(gain_margin, float(finite("phase_margin", phase_margin, "rad")))
    late = finite("lag", lag, "s")
    if late.ndim or late < 0:
        raise GroundrollError(f"lag must be a number from 0 s up, not {lag!r}")
    bounds = [_bounds("heading_gain", heading_gain), _bounds("yaw_rate_gain", yaw_rate_gain)]
    rolls, shape = rolls_at(plane, chosen, speed, values, "pilot_limit", [{"pedal": 1.0}])
    z, found = solved(rolls, rolls.start(1))
    states, A, B = lateral(rolls, z)
    steered = np.abs(B).max(axis=-1, initial=0.0)
    if not (steered > _NOTHING).any():
        raise GroundrollError(
            f"nobody can hold {plane.name} with the pedals: at no speed that was asked for do they"
            " turn it (neither rudder nor third wheel answers)"
        )
    C = np.zeros((2, len(states)))
    for k, role in enumerate(("heading", "yaw_rate")):
        C[k, states.index(chosen.roles[role])] = 1.0
    held = found & (np.abs(z[:, -1]) <= 1.0) & (steered > _NOTHING)
    gains, delay = np.full((len(z), 2), np.nan), np.full(len(z), np.nan)
    some = Plant.of(A[held], B[held], np.broadcast_to(C, (int(held.sum()), *C.shape)), float(late))
    gains[held], delay[held] = best_gains(some, bounds, margins)
    none = ~(delay > 0)
    gains[none], delay[none] = np.nan, np.nan
    growth = np.full(len(z), np.nan)
    growth[found] = np.linalg.eigvals(A[found]).real.max(axis=-1)
    growth = np.where(growth < _NEUTRAL, 0.0, growth)
    with np.errstate(divide="ignore"):
        doubling = math.log(2.0) / growth
    pedal = np.where(found, z[:, -1], np.nan)
    rows = zip(_ARRAYS, (rolls.speed, delay, *gains.T, growth, doubling, pedal), strict=True)
    arrays: dict[str, Any] = {s: np.ascontiguousarray(x).reshape(shape) for s, x in rows}
    return PilotLimit(
        **arrays,
        lag=float(late),
        gain_margin=margins.gain,
        phase_margin=margins.phase,
        aircraft=rolls.points.aircraft,
        model=chosen.key,
    )


def rolls_at(
    plane: Aircraft,
    model: Model,
    speed: Any,
    values: dict[str, Any],
    where: str,
    levers: Sequence[Lever],
) -> tuple[Rolls, tuple[int, ...]]:
    """Rolls along the runway from what a call was given, in a row, and their shape."""
    for lever in levers:
        for s in lever:
            model.symbol(s, "input", model.inputs, where)
    if speed is not None:
        number = finite("speed", speed, "m/s")
        if (stored(number) <= 0).any():
            raise GroundrollError(
                "speed must be positive: at rest nothing turns an aircraft but friction, and no"
                " control holds it; give a walking pace, such as 1 m/s"
            )
        values = {**values, "speed": number}
    points = points_at(plane, model, None, values, where)
    arrays, shape = broadcast(points.values)
    along = model.roles.get("speed", "u")
    # a body that pitches goes along the runway at what its own x axis is given
    flat = {s: np.ascontiguousarray(x).reshape(-1) for s, x in arrays.items()}
    row = replace(points, values=flat, shape=flat[along].shape)
    return Rolls(row, flat[along], levers), shape


def lateral(rolls: Rolls, z: FloatArray) -> tuple[tuple[str, ...], FloatArray, FloatArray]:
    """States but the speed and what never moves, their matrices, and columns of the first lever."""
    model = rolls.model
    found = rolls.at(z).evaluate("fx", "fu", over=model.dynamic)
    columns = (found["fu"][:, :, model.inputs.index(s)] * x for s, x in rolls.levers[0].items())
    A, B = found["fx"], np.asarray(sum(columns))
    moves = np.asarray(A.any(axis=(0, 2)) | B.any(axis=0))
    keep = [k for k, s in enumerate(model.dynamic) if moves[k] and s != model.roles["speed"]]
    return tuple(model.dynamic[k] for k in keep), A[:, keep][:, :, keep], B[:, keep]


def _bounds(name: str, given: tuple[float, float]) -> tuple[float, float]:
    try:
        low, high = (float(finite(name, x)) for x in given)
    except (TypeError, ValueError) as problem:
        if isinstance(problem, GroundrollError):
            raise
        raise GroundrollError(f"{name} must be bounds (low, high), not {given!r}") from None
    if not 0 <= low <= high:
        raise GroundrollError(f"{name} must be bounds from low to high, not {low:g} to {high:g}")
    return low, high
