"""How strong a steady wind may be in which an aircraft still rolls along the runway.

From no wind on, the roll that is held straight (`held`) is followed as the wind grows, by
pseudo-arclength (E. L. Allgower and K. Georg, *Numerical Continuation Methods*, Springer 1990):
the pedal keeps it straight, ailerons keep the loads on both main wheels equal as long as they can,
and when the pedal is at its stop a brake goes on. The wind at which the first limit is reached is
the answer, and that limit what binds. All points step side by side.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import numpy.typing as npt

from groundroll.aircraft.aircraft import Aircraft, of_aircraft
from groundroll.base.arrays import FloatArray, finite, stored
from groundroll.base.errors import GroundrollError
from groundroll.base.listing import Listed, span
from groundroll.model.evaluate import elementwise
from groundroll.model.models import as_model
from groundroll.results.records import Column, Record, run_dims
from groundroll.results.results import Result

from .held import BoolArray, IntArray, Rolls, by_elimination, solved
from .pilot import rolls_at

#: What may bind.
BINDS = (
    "nothing",
    "pedal",
    "brake",
    "aileron",
    "wheel lifted",
    "friction",
    "balance",
    "not held",
)
NOTHING, PEDAL, BRAKE, AILERON, LIFTED, FRICTION, BALANCE, NOT_HELD = range(len(BINDS))

#: What there is, beside the whole pedal; side winds; largest wind, m/s.
AILERON_TRAVEL, FROM_THE_LEFT = math.radians(20.0), math.radians(90.0)
STRONGEST = 60.0
#: Main wheels that use so much of their friction slide.
SLIDES = 0.95

#: How far heading, lever and wind go in one step.
_WIDTHS = (0.15, 1.0, 10.0)
#: First, longest and shortest step; how many; Newton's steps in each; steps to the limit.
_FIRST, _LONGEST, _SHORTEST, _STEPS, _NEWTON, _NARROW = 0.3, 0.6, 1e-3, 150, 5, 6
#: Newton's steps before which the aileron is set again; after that it hardly moves.
_LEVELLED = 2
_REST = 1e-7

_ARRAYS = {
    "speed": ("m/s", "speed along the runway"),
    "wind": ("m/s", "strongest wind"),
    "pedal": ("1", "right positive"),
    "brake": ("1", "on the side of the pedal"),
    "aileron": ("rad", "right wing down positive"),
    "heading": ("rad", "nose right of the runway"),
    "load_left": ("N", "on the left wheel"),
    "load_right": ("N", "on the right wheel"),
    "friction_used": ("1", "of the main wheels"),
}


@dataclass(frozen=True, repr=False)
class CrosswindLimit(Listed, Result):
    """The strongest wind in which an aircraft is held, and how; arrays of the shape of the cases.

    Attributes
    ----------
    speed, wind : ndarray
        m/s. The wind is steady and comes from `direction`; `groundroll.control.crosswind.STRONGEST`
        where nothing binds below it, NaN where the aircraft is not held even without wind.
    binds : ndarray of int8
        What runs out first: an index of `BINDS`. ``aileron``: a wheel lifts though it is at its
        stop; ``friction``: the main wheels slide; ``balance``: the equilibrium turns back before
        any control is at its stop, so that no stronger wind is balanced.
    pedal, brake, aileron, heading, load_left, load_right, friction_used : ndarray
        How it is held there: pedal and brake as shares of all, rad, N.
    direction : float
        From where the wind comes, rad: 0 from ahead, pi/2 from the left, pi from behind.
    brake_limit, aileron_limit : float
        The most that was allowed, of the brake as a share, of the aileron in rad.
    aircraft : Aircraft
    """

    speed: FloatArray
    wind: FloatArray
    binds: npt.NDArray[np.int8]
    pedal: FloatArray
    brake: FloatArray
    aileron: FloatArray
    heading: FloatArray
    load_left: FloatArray
    load_right: FloatArray
    friction_used: FloatArray
    direction: float
    brake_limit: float
    aileron_limit: float
    aircraft: Aircraft

    #: Names of the values of `binds`.
    BINDS = BINDS

    @property
    def what(self) -> npt.NDArray[np.str_]:
        """What binds, in words."""
        return np.array(BINDS)[self.binds]

    def _record(self) -> Record:
        runs = run_dims(self.wind.shape)
        results = {s: Column(runs, getattr(self, s), *words) for s, words in _ARRAYS.items()}
        results["binds"] = Column(runs, self.binds, names=BINDS)
        about = {s: getattr(self, s) for s in ("direction", "brake_limit", "aileron_limit")}
        return Record("crosswind", self.aircraft, as_model("rollout"), runs, results, about=about)

    @classmethod
    def _of(cls, record: Record) -> CrosswindLimit:
        arrays: dict[str, Any] = {s: record[s] for s in _ARRAYS}
        binds = record["binds"].astype(np.int8)
        return cls(**arrays, binds=binds, **record.about, aircraft=record.aircraft)

    def _title(self) -> str:
        return (
            f"CrosswindLimit of {self.aircraft.name!r}, rollout model, wind from"
            f" {math.degrees(self.direction):g} deg left of ahead"
        )

    def _rows(self) -> Iterable[Sequence[str]]:
        for s, (unit, words) in _ARRAYS.items():
            yield s, span(getattr(self, s)), "" if unit == "1" else unit, words
        found = np.bincount(self.binds.ravel(), minlength=len(BINDS))
        said = ", ".join(f"{BINDS[k]} {n}" for k, n in enumerate(found) if n)
        yield "binds", said, "", "what runs out first, at how many points"

    def _notes(self) -> Iterable[str]:
        yield "steady wind; the body neither heaves nor rolls; demonstrated winds are lower: gusts"


@of_aircraft
def crosswind_limit(
    plane: Aircraft,
    *,
    speed: Any = None,
    direction: Any = FROM_THE_LEFT,
    brake: Any = 0.0,
    aileron: Any = AILERON_TRAVEL,
    **values: Any,
) -> CrosswindLimit:
    """The strongest steady wind in which an aircraft can be held along the runway.

    Parameters
    ----------
    plane : Aircraft
        The aircraft; its parameters may be arrays.
    speed : float or array, optional
        Along the runway, m/s, positive; the aircraft's own if omitted.
    direction : float
        From where the wind comes, rad left of straight ahead: pi/2 is a crosswind from the left, 0
        a headwind, pi a tailwind.
    brake : float
        The most that one brake may do once the pedal is at its stop, 0 (none) to 1 (locked).
    aileron : float
        Largest deflection, rad, either way. It is used to keep the loads of both wheels equal.
    **values : float, array or str
        Inputs and parameters by symbol or full name: ``elevator="-15 deg"`` (stick back),
        ``thrust``, ``mass``, ``surface_friction_left`` and so on.

    Returns
    -------
    CrosswindLimit
        Wind, what binds, and how the aircraft is held there.

    Raises
    ------
    GroundrollError
        For unknown names and values that cannot be, a speed that is not positive among them.
    """
    model = as_model("rollout")
    taken = {"wind_x", "wind_y", "tailwind", "crosswind", "pedal"} & values.keys()
    if taken:
        raise GroundrollError(
            f"{', '.join(sorted(taken))} is what crosswind_limit seeks; it takes the direction of"
            " the wind, and brake, aileron and speed"
        )
    most = _share("brake", brake), _one("aileron", aileron, "rad")
    angle = _one("direction", direction, "rad")
    wind = {"wind_x": -math.cos(angle), "wind_y": math.sin(angle)}
    levers = [{"pedal": 1.0}, wind]
    rolls, shape = rolls_at(plane, model, speed, values, "crosswind_limit", levers)
    found = _Found(rolls, *most)
    found.follow()
    arrays = {s: np.ascontiguousarray(x).reshape(shape) for s, x in found.arrays().items()}
    return CrosswindLimit(
        **arrays,
        direction=angle,
        brake_limit=most[0],
        aileron_limit=most[1],
        aircraft=rolls.points.aircraft,
    )


def _one(name: str, value: Any, unit: str) -> float:
    number = finite(name, value, unit)
    if number.ndim or (name == "aileron" and number < 0):
        raise GroundrollError(f"{name} must be one number, not {value!r}")
    return float(number)


def _share(name: str, value: Any) -> float:
    number = _one(name, value, "1")
    if not 0 <= number <= 1:
        raise GroundrollError(f"{name} must be between 0 and 1, not {number:g}")
    return number


class _Found:
    """Where each point has come to."""

    def __init__(self, rolls: Rolls, brake: float, aileron: float) -> None:
        self.rolls, self.brake, self.aileron = rolls, brake, aileron
        self.n = len(rolls.unknown)
        self.weights = np.zeros(self.n + 2)
        heading = rolls.unknown.index(rolls.model.roles["heading"])
        self.weights[[heading, self.n, self.n + 1]] = 1 / np.array(_WIDTHS)
        self.z, held = solved(rolls, rolls.start(2))
        self.t = np.zeros_like(self.z)
        self.binds = np.where(held, NOTHING, NOT_HELD).astype(np.int8)
        self.pedal = np.zeros(len(self.z))  # where it is at its stop
        y = self._outputs(rolls, self.z)
        self.carried = np.maximum(np.max(self._loads(rolls, y), axis=0), 1.0)

    def follow(self) -> None:
        """Let the wind grow until something binds, and then with a brake."""
        self._grow(np.flatnonzero(self.binds == NOTHING), 1.0, PEDAL)
        stopped = np.flatnonzero(self.binds == PEDAL)
        if self.brake > 0 and stopped.size:
            self.pedal[stopped] = np.sign(self.z[stopped, self.n])
            self.z[stopped, self.n] = 0.0
            self._brakes(stopped)
            self._grow(stopped, self.brake, BRAKE)

    def _brakes(self, which: IntArray) -> None:
        """From now on the lever is a brake on the side of the pedal."""
        stop = self.pedal
        lever = {
            "pedal": (stop == 0).astype(float),
            "brake_left": (stop < 0).astype(float),
            "brake_right": (stop > 0).astype(float),
        }
        self.rolls = replace(
            self.rolls.with_inputs(pedal=self.rolls.points.values["pedal"] + stop),
            levers=[lever, self.rolls.levers[1]],
        )

    def _grow(self, which: IntArray, most: float, stop: int) -> None:
        border = np.zeros((len(which), self.n + 2))
        border[:, -1] = 1.0
        z, J, good = self._corrected(which, self.z[which], border)
        self.z[which] = z
        self.t[which] = self._tangent(J, border)
        over = self._over(which, z, self.t[which], most)
        bound = ~good | (over.max(axis=1) > _REST)
        self._bind(which[bound], over[bound], stop)
        left, length = which[~bound], np.full(len(which), _FIRST)[~bound]
        ends: list[tuple[IntArray, FloatArray]] = []
        for _ in range(_STEPS):
            if left.size == 0:
                break
            z, t, good, over = self._stepped(left, length, most)
            beyond = good & (over.max(axis=1) > 0)
            ends.append((left[beyond], length[beyond]))
            on = good & ~beyond
            self.z[left[on]], self.t[left[on]] = z[on], t[on]
            strong = on & (z[:, -1] >= STRONGEST)
            self.z[left[strong], -1] = STRONGEST
            lost = ~good & (length < _SHORTEST)
            self.binds[left[lost]] = BALANCE
            length = np.where(good, np.minimum(1.6 * length, _LONGEST), length / 4)
            going = ~beyond & ~strong & ~lost
            left, length = left[going], length[going]
        self.binds[left] = BALANCE
        if ends:
            which, length = (np.concatenate(x) for x in zip(*ends, strict=True))
            self._narrow(which, length, most, stop)

    def _narrow(self, which: IntArray, length: FloatArray, most: float, stop: int) -> None:
        """Where between the last point and the next the first limit is (Illinois)."""
        if which.size == 0:
            return
        low, high = np.zeros(len(which)), length
        at_low = self._over(which, self.z[which], self.t[which], most).max(axis=1)
        z, t, _, over = self._stepped(which, high, most)
        at_high = over.max(axis=1)
        for _ in range(_NARROW):
            middle = (low * at_high - high * at_low) / (at_high - at_low)
            middle = np.where(np.isfinite(middle), middle, (low + high) / 2)
            z, t, _, over = self._stepped(which, middle, most)
            value = over.max(axis=1)
            same = np.sign(value) == np.sign(at_high)
            low, at_low = np.where(same, low, high), np.where(same, at_low / 2, at_high)
            high, at_high = middle, value
        self.z[which], self.t[which] = z, t
        self._bind(which, over, stop)
        at_stop = which[self.binds[which] == stop]
        if at_stop.size:  # exactly there
            lever = np.zeros((len(at_stop), self.n + 2))
            lever[:, self.n] = 1.0
            z = self.z[at_stop]
            z[:, self.n] = np.copysign(most, z[:, self.n])
            z, _, good = self._corrected(at_stop, z, lever)
            self.z[at_stop[good]] = z[good]

    def _bind(self, which: IntArray, over: FloatArray, stop: int) -> None:
        kinds = np.array([stop, LIFTED, FRICTION, BALANCE], np.int8)
        self.binds[which] = kinds[over.argmax(axis=1)] if len(over) else NOTHING
        lifted = which[self.binds[which] == LIFTED]
        if self.aileron > 0 and lifted.size:
            used = np.abs(self._levelled(self._some(lifted), self.z[lifted]))
            self.binds[lifted[used >= 0.999 * self.aileron]] = AILERON

    # --- One step -------------------------------------------------------------------------------

    def _some(self, which: IntArray) -> Rolls:
        return self.rolls.some(which)

    def _stepped(
        self, which: IntArray, length: FloatArray, most: float
    ) -> tuple[FloatArray, FloatArray, BoolArray, FloatArray]:
        z, t = self.z[which], self.t[which]
        border = self.weights**2 * t
        start = z + length[:, None] * t
        z, J, good = self._corrected(which, start, border)
        t = self._tangent(J, border)
        return z, t, good, self._over(which, z, t, most)

    def _corrected(
        self, which: IntArray, z: FloatArray, border: FloatArray
    ) -> tuple[FloatArray, FloatArray, BoolArray]:
        """Newton's steps across a direction."""
        rolls, z = self._some(which), z.copy()
        begin = (border * z).sum(axis=-1)
        for k in range(_NEWTON + 1):
            if k < _LEVELLED:
                rolls = rolls.with_inputs(aileron=self._levelled(rolls, z))
            F, J = rolls.balance(z)
            size = np.abs(F).max(axis=-1, initial=0.0)
            if k == _NEWTON or (size < _REST).all():
                break
            wide = np.concatenate([J, border[:, None, :]], axis=1)
            away = begin - (border * z).sum(axis=-1)
            right = np.concatenate([-F, away[:, None]], axis=1)
            usable = np.isfinite(wide).all(axis=(1, 2)) & np.isfinite(right).all(axis=1)
            z[usable] += by_elimination(wide[usable], right[usable])
        return z, J, np.asarray(size < 100 * _REST)

    def _tangent(self, J: FloatArray, border: FloatArray) -> FloatArray:
        """The direction in which the balance stays, as long as the widths say."""
        wide = np.concatenate([J, border[:, None, :]], axis=1)
        right = np.zeros(wide.shape[:-1])
        right[:, -1] = 1.0
        bad = ~np.isfinite(wide).all(axis=(1, 2))
        wide[bad] = np.eye(self.n + 2)
        t = by_elimination(wide, right)
        return np.asarray(t / np.linalg.norm(self.weights * t, axis=-1, keepdims=True))

    def _over(self, which: IntArray, z: FloatArray, t: FloatArray, most: float) -> FloatArray:
        """How far each limit is passed: lever, load, friction, and whether the wind falls."""
        rolls = self._some(which)
        rolls = rolls.with_inputs(aileron=self._levelled(rolls, z))
        y = self._outputs(rolls, z)
        least = np.min(self._loads(rolls, y), axis=0)
        lever = np.abs(z[:, self.n]) - most
        used = self._used(rolls, y) - SLIDES
        falls = -t[:, -1] / _WIDTHS[-1]
        return np.stack([lever, -least / self.carried[which], used, falls], axis=-1)

    def _outputs(self, rolls: Rolls, z: FloatArray) -> dict[str, FloatArray]:
        y = rolls.at(z).evaluate("g")["g"]
        return dict(zip(rolls.model.outputs, y.T, strict=True))

    def _levelled(self, rolls: Rolls, z: FloatArray) -> FloatArray:
        """The aileron that makes the loads equal, as far as it goes; its couple is linear."""
        if self.aileron == 0:
            return np.zeros(len(z))
        none, full = (
            self._outputs(rolls.with_inputs(aileron=np.full(len(z), x)), z)["Mx_held"]
            for x in (0.0, self.aileron)
        )
        with np.errstate(divide="ignore", invalid="ignore"):
            wanted = np.nan_to_num(-none / (full - none) * self.aileron)
        return np.asarray(np.clip(wanted, -self.aileron, self.aileron))

    def _loads(self, rolls: Rolls, y: Mapping[str, FloatArray]) -> tuple[FloatArray, FloatArray]:
        found = elementwise("moved_loads", {**rolls.points.values, **y})
        return found["N_left"], found["N_right"]

    def _used(self, rolls: Rolls, y: Mapping[str, FloatArray]) -> FloatArray:
        """Friction that the main wheels use, that which uses less of it."""
        p = rolls.points.values
        each = []
        for wheel in ("left", "right"):
            force = {s: y[f"{s}_{wheel}"] for s in ("F_x", "F_y", "Fz")}
            surface = {"surface_left": p[f"surface_{wheel}"]}
            each.append(elementwise("friction_used", {**p, **force, **surface})["used"])
        return np.minimum(*each)

    def arrays(self) -> Mapping[str, Any]:
        """What it all comes to."""
        z, rolls = self.z, self.rolls
        aileron = self._levelled(rolls, z)
        rolls = rolls.with_inputs(aileron=aileron)
        y = self._outputs(rolls, z)
        left, right = self._loads(rolls, y)
        stopped = self.pedal != 0
        lever = z[:, self.n]
        heading = rolls.unknown.index(rolls.model.roles["heading"])
        found = {
            "wind": z[:, -1],
            "pedal": np.where(stopped, self.pedal, lever),
            "brake": np.where(stopped, lever, 0.0),
            "aileron": aileron,
            "heading": z[:, heading],
            "load_left": left,
            "load_right": right,
            "friction_used": self._used(rolls, y),
        }
        held = self.binds != NOT_HELD
        found = {s: np.where(held, x, np.nan) for s, x in found.items()}
        return {"speed": rolls.speed, "binds": self.binds, **found}


@dataclass(frozen=True, repr=False)
class Clause(Listed):
    """What 14 CFR 25.233(a) asks about ground loops, computed: a report, and no certificate.

    Attributes
    ----------
    stall_speed : float
        By the largest lift coefficient of the aircraft, m/s.
    asked, asked_small : float
        90 deg winds of 25.233(a) and, of the former 23.233(a), 0.2 V_S0, m/s.
    wind, speed : float
        The least of the strongest winds, and the speed at which it is, m/s.
    limit : CrosswindLimit
        At every speed.
    """

    stall_speed: float
    asked: float
    asked_small: float
    wind: float
    speed: float
    limit: CrosswindLimit

    @property
    def meets(self) -> bool:
        """Whether the computed wind is no less than 25.233(a) asks."""
        return self.wind >= self.asked

    def _title(self) -> str:
        verdict = "is" if self.meets else "is NOT"
        return f"Clause 14 CFR 25.233(a) for {self.limit.aircraft.name!r}: the wind {verdict} held"

    def _rows(self) -> Iterable[Sequence[str]]:
        yield "stall speed", span(self.stall_speed), "m/s"
        yield "25.233(a): 20 kt or 0.2 V_SR0, at most 25 kt", span(self.asked), "m/s"
        yield "former 23.233(a): 0.2 V_S0", span(self.asked_small), "m/s"
        yield "held at every speed up to", span(self.wind), "m/s"
        k = int(np.nanargmin(self.limit.wind))
        yield "least at a speed of", span(self.speed), "m/s"
        yield "what binds there", str(self.limit.what[k]), ""

    def _notes(self) -> Iterable[str]:
        yield "assumes: steady wind at 90 deg, the surface that is given, a level body, no gusts,"
        yield "no delay of the pilot (see pilot_limit), stall speed by CL_max; certifies nothing"


@of_aircraft
def crosswind_clause(
    plane: Aircraft, *, speed: Any = None, brake: Any = 0.0, **values: Any
) -> Clause:
    """What 14 CFR 25.233(a) asks, against the wind that is held; it certifies nothing.

    Parameters
    ----------
    plane : Aircraft
        One aircraft.
    speed : array, optional
        Speeds, m/s; 24 from a twentieth of the stall speed to nine tenths if omitted.
    brake, **values
        As for `crosswind_limit`.

    Returns
    -------
    Clause
        What is asked, what is held, and what binds.
    """
    parameters = rolls_at(plane, as_model("rollout"), 1.0, values, "crosswind_clause", [])[0]
    winds = elementwise("clause_winds", parameters.points.values)
    if any(np.size(x) != 1 for x in winds.values()):
        raise GroundrollError("a clause is of one aircraft; its parameters must be no arrays")
    stall, asked, small = (float(np.squeeze(winds[s])) for s in winds)
    speeds = np.linspace(0.05, 0.9, 24) * stall if speed is None else finite("speed", speed, "m/s")
    limit = crosswind_limit(plane, speed=np.atleast_1d(speeds), brake=brake, **values)
    if np.isnan(limit.wind).any():
        where = stored(limit.speed)[np.isnan(limit.wind)][0]
        raise GroundrollError(
            f"{plane.name} is not held at {where:g} m/s even without wind: it may fly there"
        )
    k = int(limit.wind.argmin())
    return Clause(stall, asked, small, float(limit.wind.flat[k]), float(limit.speed.flat[k]), limit)
