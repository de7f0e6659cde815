"""Closed forms of the linear model, for any array of parameters."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from groundroll.aircraft.aircraft import Aircraft, of_aircraft
from groundroll.base.arrays import FloatArray
from groundroll.base.errors import GroundrollError, one_of
from groundroll.base.listing import Numbers
from groundroll.generated import PACKS, Quantity, build
from groundroll.model.evaluate import elementwise
from groundroll.model.names import physical

from .polynomials import negative_stretch, roots

#: Speeds, m/s, among which the worst is sought if the user names none.
SPEEDS = (1.0, 100.0)

_LOADS = ("fixed", "follow")


#: Margin -> the generated function that gives it and the name of the result.
CLOSED_FORMS = {
    "trace": ("routh_hurwitz", "trace"),
    "determinant": ("routh_hurwitz", "det"),
    "discriminant": ("routh_hurwitz", "discriminant"),
    "decay_rate": ("modes", "decay_rate"),
    "damping_ratio": ("modes", "damping_ratio"),
    "natural_frequency": ("modes", "natural_frequency"),
    "damped_frequency": ("modes", "damped_frequency"),
    "time_to_half": ("times", "T_half"),
    "time_to_double": ("times", "T_double"),
    "neutral_steer_point": ("steady_margins", "x_neutral"),
    "static_margin": ("steady_margins", "static_margin"),
    "understeer_gradient": ("steady_margins", "K_us"),
    "stiffness_needed": ("tail_wheel_needed", "Ct_needed"),
    "stiffness_needed_always": ("tail_wheel_always", "Ct_always"),
    "speed_margin": ("tail_wheel_always", "speed_margin"),
}

#: The same for what is said of every speed at once.
OVER_SPEED = {
    "lower_critical_speed": ("speed_window", "u_low"),
    "upper_critical_speed": ("speed_window", "u_high"),
    "weakest_speed": ("weakest_speed", "u_weakest"),
    "least_determinant": ("weakest_speed", "det_weakest"),
    "speed_margin": ("tail_wheel_always", "speed_margin"),
    "stiffness_needed_always": ("tail_wheel_always", "Ct_always"),
}

_LINEAR = PACKS["linear"].quantities


def quantity_of(margin: str) -> Quantity:
    """What a margin is, by its name in `CLOSED_FORMS` or `OVER_SPEED`."""
    return _LINEAR[(CLOSED_FORMS | OVER_SPEED)[margin][1]]


@dataclass(frozen=True, repr=False)
class Margins(Numbers, of={name: quantity_of(name) for name in CLOSED_FORMS}):
    """How far an aircraft is from instability at a speed.

    Every attribute has the common shape of whatever was an array.

    Attributes
    ----------
    trace, determinant, discriminant : ndarray
        Of A, 1/s, 1/s^2, 1/s^2: stable if and only if trace < 0 < determinant; the modes
        oscillate where the discriminant is negative.
    decay_rate : ndarray
        -max Re(eigenvalue), 1/s; positive if stable.
    damping_ratio : ndarray
        -tr A / (2 sqrt(det A)); NaN where det A < 0.
    natural_frequency, damped_frequency : ndarray
        sqrt(det A) and |Im(eigenvalue)|, rad/s.
    time_to_half, time_to_double : ndarray
        s; infinite where a deviation never halves, or never doubles.
    neutral_steer_point : ndarray
        m ahead of the CG: where a side force gives no steady yaw rate.
    static_margin : ndarray
        Distance of that point *behind* the CG over the wheelbase a + b; positive is stable.
        Milliken and Milliken, *Race Car Vehicle Dynamics*, ch. 5.
    understeer_gradient : ndarray
        rad per m/s^2: (W_main/C_f - W_tail/K)/g, positive for understeer. Gillespie,
        *Fundamentals of Vehicle Dynamics*, ch. 6, with the main gear as the front axle.
    stiffness_needed : ndarray
        Tail wheel stiffness at which det A = 0 at this speed, N/rad; negative: stable without.
    stiffness_needed_always : ndarray
        Tail wheel stiffness from which the aircraft is stable at every speed, N/rad.
    speed_margin : ndarray
        sqrt(b Ct/(L C_f)) + sqrt(L k/m) - sqrt(a/L), with k u^2 the stiffness of the vertical
        tail; positive exactly if the aircraft is stable at every speed. NaN if the main gear is
        behind the tail (a + b < 0).
    """

    trace: FloatArray
    determinant: FloatArray
    discriminant: FloatArray
    decay_rate: FloatArray
    damping_ratio: FloatArray
    natural_frequency: FloatArray
    damped_frequency: FloatArray
    time_to_half: FloatArray
    time_to_double: FloatArray
    neutral_steer_point: FloatArray
    static_margin: FloatArray
    understeer_gradient: FloatArray
    stiffness_needed: FloatArray
    stiffness_needed_always: FloatArray
    speed_margin: FloatArray


@of_aircraft
def margins(plane: Aircraft, *, speed: Any = None) -> Margins:
    """Every margin of the linear model at a speed, in closed form.

    Parameters
    ----------
    plane : Aircraft
        The aircraft; its parameters may be arrays.
    speed : float or array, optional
        Forward speed, m/s; default the aircraft's own.

    Returns
    -------
    Margins
        Of the linear model (Section 4.5 of the thesis) in straight running.
    """
    values = closed_forms(plane if speed is None else plane.replace(u=speed), tuple(CLOSED_FORMS))
    shape = np.broadcast_shapes(*(value.shape for value in values.values()))
    return Margins(**{name: np.broadcast_to(value, shape) for name, value in values.items()})


def closed_forms(plane: Aircraft, names: Sequence[str]) -> dict[str, FloatArray]:
    """Some of the margins, from as few generated functions as they need."""
    known = CLOSED_FORMS | OVER_SPEED
    wanted = {known[one_of("margin", name, known)][0] for name in names}
    results: dict[str, dict[str, FloatArray]] = {}
    if wanted & {"modes", "times"}:
        results["modes"] = elementwise("modes", closed_form("state_matrix", plane))
    if "times" in wanted:
        results["times"] = elementwise("times", results["modes"])
    for function in sorted(wanted - results.keys()):
        results[function] = closed_form(function, plane)
    return {name: results[known[name][0]][known[name][1]] for name in names}


def closed_form(function: str, plane: Aircraft, **given: FloatArray) -> dict[str, FloatArray]:
    """A generated function of an aircraft's parameters, some of them given instead."""
    names = build(function).name_in()
    return elementwise(function, {s: given[s] if s in given else plane[s] for s in names})


_WINDOW = {
    "low": "u_low",
    "high": "u_high",
    "weakest": "u_weakest",
    "least_determinant": "det_weakest",
    "worst": "u",
    "worst_decay_rate": "decay_rate",
}


@dataclass(frozen=True, repr=False)
class SpeedWindow(Numbers, of={name: _LINEAR[s] for name, s in _WINDOW.items()}):
    """Speeds between which the linear model is unstable, and where it is worst.

    Attributes
    ----------
    low, high : ndarray
        m/s; NaN where the aircraft is stable at every speed, infinite where there is no end.
    weakest : ndarray
        Speed at which det A is least over all speeds, m/s: with a window the geometric mean of
        its ends. 0 without a tail wheel, infinite without a vertical tail.
    least_determinant : ndarray
        det A there, 1/s^2: negative exactly if there is a window.
    worst : ndarray
        Speed at which the decay rate is least, m/s, in the range asked for.
    worst_decay_rate : ndarray
        Decay rate there, 1/s; negative if unstable.
    """

    low: FloatArray
    high: FloatArray
    weakest: FloatArray
    least_determinant: FloatArray
    worst: FloatArray
    worst_decay_rate: FloatArray


@of_aircraft
def speed_window(plane: Aircraft, *, speeds: tuple[Any, Any] = SPEEDS) -> SpeedWindow:
    """The speeds at which the determinant of the linear model changes sign, and the worst speed.

    Parameters
    ----------
    plane : Aircraft
        The aircraft; its parameters may be arrays. Its own speed does not matter.
    speeds : tuple of float or array
        Lowest and highest speed among which the worst decay rate is sought, m/s. `low`, `high`
        and `weakest` do not depend on it.
    """
    window = closed_form("speed_window", plane)
    weakest = closed_form("weakest_speed", plane)
    worst, decay_rate = _worst_speed(plane, *_range(speeds))
    return SpeedWindow(
        low=window["u_low"],
        high=window["u_high"],
        weakest=weakest["u_weakest"],
        least_determinant=weakest["det_weakest"],
        worst=worst,
        worst_decay_rate=decay_rate,
    )


def _range(speeds: tuple[Any, Any]) -> tuple[FloatArray, FloatArray]:
    try:
        low, high = (physical("u", speed) for speed in speeds)
    except (TypeError, ValueError) as problem:
        if isinstance(problem, GroundrollError):
            raise
        raise GroundrollError(f"speeds must be a pair (lowest, highest), not {speeds!r}") from None
    if (low > high).any():
        raise GroundrollError(f"speeds must be (lowest, highest), but {low} is above {high}")
    return low, high


def _worst_speed(
    plane: Aircraft, low: FloatArray, high: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Speed of the least decay rate in a range, and that rate.

    The least value of a continuous function is at an end of the range or where it is stationary;
    the generated polynomials hold every such speed, so no sampling is involved.
    """
    found = closed_form("stationary_decay", plane)
    quartic = np.stack([found[f"e_{n}"] for n in range(5)])
    squares = np.nan_to_num(roots(quartic).real, nan=0.0)
    speeds = np.sqrt(np.maximum(squares, 0.0))
    candidates = [low, high, *speeds, np.nan_to_num(found["u_trace"], nan=0.0)]
    shape = np.broadcast_shapes(*(c.shape for c in candidates))
    stack = np.clip(np.stack([np.broadcast_to(c, shape) for c in candidates]), low, high)
    decay = elementwise("modes", closed_form("state_matrix", plane, u=stack))["decay_rate"]
    stack = np.broadcast_to(stack, decay.shape)
    least = decay.argmin(axis=0)[None]
    worst, rate = (np.take_along_axis(values, least, axis=0) for values in (stack, decay))
    return np.asarray(worst[0, ...]), np.asarray(rate[0, ...])


@dataclass(frozen=True, repr=False)
class GearLimit(Numbers, of={"lost": _LINEAR["a"], "regained": _LINEAR["a"]}):
    """Positions of the main gear between which the aircraft is unstable at a speed.

    Attributes
    ----------
    lost, regained : ndarray
        m ahead of the CG (the parameter a), with CG and tail where they are. NaN where the
        aircraft is stable with the gear anywhere. `regained` is usually far ahead of any nose;
        it is infinite or NaN where there is no end.
    """

    lost: FloatArray
    regained: FloatArray


@of_aircraft
def gear_limit(plane: Aircraft, *, speed: Any = None, loads: str = "fixed") -> GearLimit:
    """How far ahead of the CG the main gear may stand at a speed.

    Parameters
    ----------
    plane : Aircraft
        The aircraft; its parameters may be arrays. Its own gear position does not matter: the
        gear moves, CG and tail (b) stay.
    speed : float or array, optional
        Forward speed, m/s; default the aircraft's own.
    loads : str
        ``"fixed"``: cornering stiffnesses are what they are, as in the thesis. ``"follow"``:
        axle loads follow from the gear position (main gear m g b/L, tail wheel m g a/L) and both
        stiffnesses from the loads; the gear is sought between the CG (no load on the tail wheel)
        and ever farther ahead.

    Returns
    -------
    GearLimit
        Where det A changes sign.
    """
    aircraft = plane if speed is None else plane.replace(u=speed)
    return _gear_limit(aircraft, aircraft["u"], one_of("loads", loads, _LOADS))


def _gear_limit(plane: Aircraft, speed: FloatArray, loads: str) -> GearLimit:
    if loads == "fixed":
        found = closed_form("gear_position", plane, u=speed)
        return GearLimit(found["a_lost"], found["a_regained"])
    found = closed_form("loaded_gear_position", plane, u=speed)
    stretch = negative_stretch(np.stack([found[f"p_{n}"] for n in range(6)]))
    lost, regained = (_at_tail_load(plane, share)["a_loaded"] for share in stretch)
    return GearLimit(lost, regained)


def _at_tail_load(plane: Aircraft, share: FloatArray) -> dict[str, FloatArray]:
    return closed_form("at_tail_load", plane, tail_fraction=share)


@dataclass(frozen=True, repr=False)
class GearEnvelope(Numbers, of={"lost": _LINEAR["a"], "speed": _LINEAR["u"]}):
    """The foremost position of the main gear that is stable at every speed of a range.

    Attributes
    ----------
    lost : ndarray
        m ahead of the CG (the parameter a); NaN where the gear may stand anywhere.
    speed : ndarray
        The speed at which stability is lost there, m/s.
    """

    lost: FloatArray
    speed: FloatArray


@of_aircraft
def gear_envelope(
    plane: Aircraft, *, speeds: tuple[Any, Any] = SPEEDS, loads: str = "fixed"
) -> GearEnvelope:
    """How far ahead of the CG the main gear may stand if a whole range of speeds is to be met.

    Parameters
    ----------
    plane : Aircraft
        As for `gear_limit`.
    speeds : tuple of float or array
        Lowest and highest speed, m/s.
    loads : str
        ``"fixed"`` or ``"follow"``, as for `gear_limit`.

    Returns
    -------
    GearEnvelope
        The least of `gear_limit` over the range: at one of its ends, or at a speed at which a
        window of instability opens, which comes in closed form (of a polynomial's roots where
        loads follow).
    """
    low, high = _range(speeds)
    opening = _opening_speeds(plane, one_of("loads", loads, _LOADS))
    candidates = [low, high, *(np.nan_to_num(u, nan=0.0) for u in opening)]
    shape = np.broadcast_shapes(*(c.shape for c in candidates))
    stack = np.clip(np.stack([np.broadcast_to(c, shape) for c in candidates]), low, high)
    lost = np.nan_to_num(_gear_limit(plane, stack, loads).lost, nan=np.inf)
    least = lost.argmin(axis=0)[None]
    found = np.take_along_axis(lost, least, axis=0)[0]
    speed = np.take_along_axis(np.broadcast_to(stack, lost.shape), least, axis=0)[0]
    nowhere = np.isinf(found)
    return GearEnvelope(np.where(nowhere, np.nan, found), np.where(nowhere, np.nan, speed))


def _opening_speeds(plane: Aircraft, loads: str) -> list[FloatArray]:
    """Speeds at which a window of instability can open as the gear moves forward."""
    if loads == "fixed":
        return [closed_form("gear_position_envelope", plane)["u_touch"]]
    found = closed_form("loaded_gear_envelope", plane)
    shares = roots(np.stack([found[f"g_{n}"] for n in range(11)])).real
    return list(_at_tail_load(plane, np.clip(shares, 0.0, 1.0))["u_touch"])
