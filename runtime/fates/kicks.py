"""How hard a kick an aircraft survives: the threshold of a ground loop.

A linear model says whether a small disturbance dies out, not how large a one may be. Here a side
impulse changes lateral velocity and yaw rate at once; the aircraft rolls on, hands off, and
survives if it straightens out, or in a model whose speed falls comes to a stop, before it leaves
the runway or turns too far.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from typing import Any

import numpy as np

from groundroll.aircraft.aircraft import Aircraft, of_aircraft
from groundroll.aircraft.parameters import parameters_of
from groundroll.aircraft.validity import extrapolated
from groundroll.aircraft.values import given
from groundroll.base.arrays import FloatArray, broadcast, finite
from groundroll.base.errors import GroundrollError
from groundroll.base.listing import Listed, span
from groundroll.base.progress import Count, Progress, counted
from groundroll.generated import PACKS, build
from groundroll.linear.linearization import linearize
from groundroll.model.evaluate import elementwise
from groundroll.model.models import Model, ModelLike, as_model
from groundroll.model.names import PARAMETERS
from groundroll.results.records import Column, Record, measured, run_dims
from groundroll.results.results import Result

from .fates import FATES, OUT, ByteArray, Criterion, criterion_of, fates, needed

#: Impulses that are tried before bisection, and in each of its rounds.
_SCAN, _SECTIONS = 64, 15
#: The impulse found is this near to the threshold, relative to it; below the second number, as a
#: share of the largest one tried, an aircraft survives none.
_NEAR, _NONE = 1e-3, 1e-7
#: Slip angle up to which the main tires' force must keep its sign.
_LARGE_SLIP = math.radians(85)


#: Cases that are listed one by one.
_LISTED = 12
_KICK = {
    "station": "x_S",
    "impulse": "S",
    "velocity_change": "dv",
    "yaw_rate_change": "dr",
    "island": "S",
}
#: Of each result the quantity that it is.
_QUANTITIES = {
    **{name: PACKS["aircraft"].quantities[symbol] for name, symbol in _KICK.items()},
    "decay_rate": PACKS["linear"].quantities["decay_rate"],
}


@dataclass(frozen=True, repr=False, eq=False)
class Survival(Listed, Result):
    """How hard a kick an aircraft survives; every array has the shape of the cases.

    Attributes
    ----------
    aircraft : Aircraft
        Who is kicked.
    model : str or Model
        In which model it rolls.
    inputs : mapping of str to ndarray
        What acts on it beside the kick, by symbol.
    station : ndarray
        Where, m ahead of the CG.
    criterion : Criterion
        What counts as surviving.
    impulse : ndarray
        N s: every smaller one is survived; 0 if none is.
    velocity_change, yaw_rate_change : ndarray
        What it does to v, m/s, and to r, rad/s.
    fate : ndarray of int8
        What becomes of the aircraft beyond it, an index of `FATES`; 0 if it survives whatever
        was tried.
    island : ndarray
        Largest impulse found that is survived though a smaller one is not, N s; NaN if none.
    decay_rate : ndarray
        What the linearised model says, 1/s; positive if stable.
    """

    aircraft: Aircraft
    model: ModelLike
    inputs: Mapping[str, FloatArray]
    station: FloatArray
    criterion: Criterion
    impulse: FloatArray
    velocity_change: FloatArray
    yaw_rate_change: FloatArray
    fate: ByteArray
    island: FloatArray
    decay_rate: FloatArray

    #: Names of the values of `fate`.
    FATES = FATES

    def _record(self) -> Record:
        runs = run_dims(self.impulse.shape)
        results = {name: measured(runs, getattr(self, name), q) for name, q in _QUANTITIES.items()}
        results["fate"] = Column(runs, self.fate, names=FATES)
        about, model = vars(self.criterion), as_model(self.model)
        return Record(
            "survival", self.aircraft, model, runs, results, given=self.inputs, about=about
        )

    @classmethod
    def _of(cls, record: Record) -> Survival:
        results = {name: record[name] for name in _QUANTITIES}
        criterion, fate = Criterion(**record.about), record["fate"].astype(np.int8)
        return cls(
            record.aircraft,
            record.model.key,
            dict(record.given),
            criterion=criterion,
            fate=fate,
            **results,
        )

    def _title(self) -> str:
        c, n = self.criterion, self.impulse.size
        return (
            f"Survival of {self.aircraft.name!r}, {as_model(self.model).name} model, on"
            f" ±{c.half_width:g} m, heading within {math.degrees(c.heading):g}°:"
            f" {n} {'case' if n == 1 else 'cases'}"
        )

    def _rows(self) -> Iterable[Sequence[str]]:
        speed = np.broadcast_to(self.aircraft["u"], self.impulse.shape)
        arrays = (self.impulse, self.station, speed, self.velocity_change, self.yaw_rate_change)
        for k in range(min(self.impulse.size, _LISTED)):
            S, x, u, dv, dr = (f"{np.ravel(array)[k]:.5g}" for array in arrays)
            beyond = FATES[np.ravel(self.fate)[k]] if np.ravel(self.fate)[k] else "nothing tried"
            added = f"v + {dv} m/s", f"r + {dr} rad/s"
            yield f"{S} N s", f"at {x} m", f"{u} m/s", *added, f"beyond it: {beyond}"

    def _notes(self) -> Iterable[str]:
        if self.impulse.size > _LISTED:
            yield f"and more: {span(self.impulse)} N s in all"
        yield from extrapolated(self.aircraft)


@of_aircraft
def survival(
    plane: Aircraft,
    model: ModelLike = "nonlinear",
    *,
    station: Any = 0.0,
    half_width: Any = Criterion.half_width,
    heading: Any = Criterion.heading,
    settled: float = Criterion.settled,
    t: Any = None,
    largest: Any = None,
    threads: int | None = None,
    executor: Executor | None = None,
    progress: Progress = None,
    **values: Any,
) -> Survival:
    """The largest side impulse that an aircraft survives, hands off.

    In a model whose speed is held, the thesis's, it survives if it straightens out within the
    runway; in one whose speed falls (``rollout``, ``landing_roll``), if it stays there until it
    has stopped.

    Right and left are the same by symmetry. The impulses that are survived need not be all up to
    a largest one: every one below `Survival.impulse` is (as far as 64 of them tell), and
    `Survival.island` says if some above it are, too.

    Parameters
    ----------
    plane : Aircraft
        The aircraft, with a tire that is right at large slip angles (``brott-physical``); its
        parameters may be arrays.
    model : str or Model
        A model that knows heading and offset.
    station : float or array
        Where the impulse acts, m ahead of the CG; the tail is at minus `b`.
    half_width, heading, settled, t : float
        See `Criterion`. The time is 20 s, and 300 s in a model whose speed falls.
    largest : float or array, optional
        Largest impulse tried, N s. Default: one that changes v, or r times the arm of the tail,
        by the forward speed.
    threads, executor
        As for `groundroll.ensemble`.
    progress : callable or bool, optional
        Called with the numbers of runs done and in all; the latter is the most that there may
        be, and falls while bisection goes on. True draws a bar on a terminal.
    **values : float, array or str
        Parameters (``speed``) and inputs (``crosswind``, ``pedal``, ``brake_left``) by symbol or
        full name, constant.

    Returns
    -------
    Survival
        The threshold to within 1e-3 of it.

    Raises
    ------
    GroundrollError
        For values that cannot be, a model without heading or offset, or a tire whose force changes
        its sign at a large slip angle.
    """
    model = as_model(model)
    aircraft, inputs = rolling(plane, model, values, "survival")
    criterion = criterion_of(model, half_width, heading, settled, t)
    check_tire(aircraft, model)
    own = {s: aircraft[s] for s in ("u", "b", "m", "Izz") if s != "b" or s in aircraft}
    place = finite("station", station, "m")
    arrays, shape = broadcast({**aircraft.given, **own, **inputs, "station": place})
    unit = kick(arrays["station"], 1.0, arrays)
    top = _top(arrays, unit) if largest is None else _positive(largest, shape)
    options = {"threads": threads, "executor": executor}
    with counted(progress, "kicks") as done:
        search = _Search(aircraft, model, inputs, shape, unit, criterion, options, done)
        low, fate, island = search.threshold(top)
    return Survival(
        aircraft=aircraft,
        model=model.key,
        inputs=inputs,
        station=np.array(arrays["station"]),
        criterion=criterion,
        impulse=low,
        velocity_change=low * unit[0],
        yaw_rate_change=low * unit[1],
        fate=fate,
        island=island,
        decay_rate=np.broadcast_to(linearize(aircraft, model).decay_rate, shape),
    )


def rolling(
    plane: Aircraft, model: Model, values: Mapping[str, Any], where: str
) -> tuple[Aircraft, dict[str, FloatArray]]:
    """The aircraft with what a call changes, and the constant inputs; it starts straight."""
    needed(model)
    sorted_out = given(plane, model, values, where)
    aircraft, start = sorted_out.aircraft, dict(sorted_out.states)
    if (speed := model.roles.get("speed")) in start and speed in PARAMETERS:
        aircraft = aircraft.replace(**{speed: start.pop(speed)})
    if start:
        raise GroundrollError(
            f"{where} starts straight, at rest on its legs; it cannot be given"
            f" {', '.join(f'{s}0' for s in start)}"
        )
    return aircraft, dict(sorted_out.inputs)


@dataclass(frozen=True)
class _Search:
    """The threshold of every case, with `unit` the change of v and r per impulse."""

    aircraft: Aircraft
    model: Model
    inputs: Mapping[str, FloatArray]
    shape: tuple[int, ...]
    unit: tuple[FloatArray, FloatArray]
    criterion: Criterion
    options: dict[str, Any]
    done: Count

    def threshold(self, top: FloatArray) -> tuple[FloatArray, ByteArray, FloatArray]:
        """Impulse, fate beyond it, and largest survived beyond it."""
        self._left(top / _SCAN, 0 * top, top, _SCAN)
        tried = top * np.linspace(0.0, 1.0, _SCAN + 1)[1:].reshape(-1, *(1 for _ in self.shape))
        found = self._fates(tried)
        low, high, fate = _bracket(np.zeros(self.shape), tried, found)
        lost = found != OUT
        beyond = np.logical_or.accumulate(lost, axis=0) & ~lost
        island = np.where(beyond, tried, np.nan)
        while (wide := (high - low > _NEAR * high) & (high > _NONE * top) & (fate != OUT)).any():
            self._left((high - low)[wide], low[wide], top[wide])
            shares = np.linspace(0.0, 1.0, _SECTIONS + 2)[1:]
            inner = low + (high - low) * shares.reshape(-1, *(1 for _ in self.shape))
            low, high, fate = _bracket(low, inner, self._fates(inner))
        best = np.where(high > _NONE * top, low, 0.0)
        with np.errstate(invalid="ignore"):
            largest = np.where(beyond.any(axis=0), np.nan_to_num(island).max(axis=0), np.nan)
        return best, fate, largest

    def _left(self, width: FloatArray, low: FloatArray, top: FloatArray, scan: int = 0) -> None:
        """Most runs that are left: after a scan, brackets are refined until they are narrow."""
        narrow, runs = _NEAR * np.maximum(low, _NONE * top), _SECTIONS + 1
        rounds = np.ceil(np.log(width / narrow) / np.log(runs)).max(initial=0.0)
        self.done.left(math.prod(self.shape) * (scan + runs * int(rounds)))

    def _fates(self, impulses: FloatArray) -> ByteArray:
        v, r = (impulses * each for each in self.unit)
        return fates(
            self.aircraft,
            v,
            r,
            self.criterion,
            self.done.add,
            self.model,
            self.inputs,
            **self.options,
        )[0]


def _bracket(
    low: FloatArray, tried: FloatArray, fate: ByteArray
) -> tuple[FloatArray, FloatArray, ByteArray]:
    """The last impulse before the first that is not survived, that one, and its fate."""
    lost = fate != OUT
    k = np.where(lost.any(axis=0), lost.argmax(axis=0), len(tried) - 1)[None]
    stack = np.concatenate([low[None], tried])
    first = np.where(lost.any(axis=0), 0, 1)  # nothing is lost: the last one is survived
    before = np.take_along_axis(stack, k + first, axis=0)[0]
    after = np.take_along_axis(tried, k, axis=0)[0]
    return before, after, np.take_along_axis(fate, k, axis=0)[0]


def kick(station: FloatArray, impulse: Any, plane: Any) -> tuple[FloatArray, FloatArray]:
    """Changes of v and r by an impulse at a station."""
    given = {
        "S": finite("impulse", impulse, "N s"),
        "x_S": station,
        "m": plane["m"],
        "Izz": plane["Izz"],
    }
    changes = elementwise("kick", given)
    return changes["dv"], changes["dr"]


def _top(plane: dict[str, FloatArray], unit: tuple[FloatArray, FloatArray]) -> FloatArray:
    """The impulse that changes v, or the sideways velocity of the tail by turning, by u."""
    dv, dr = unit
    faster = np.maximum(np.abs(dv), np.abs(dr) * plane["b"]) if "b" in plane else np.abs(dv)
    return np.asarray(plane["u"] / faster)


def _positive(largest: Any, shape: tuple[int, ...]) -> FloatArray:
    value = finite("largest", largest, "N s")
    if (value <= 0).any():
        raise GroundrollError(f"largest must be positive, not {largest!r}")
    arrays, _ = broadcast({"largest": value, "the cases": np.empty(shape)})
    return arrays["largest"]


def check_tire(plane: Aircraft, model: Model) -> None:
    """Refuse a tire whose force pulls the wrong way at a large slip angle, if the model has it."""
    parameters_of(plane, model)  # says more of a tire that cannot be at all
    of_the_tire = build("tire_force").name_in()
    if not {"B5", "C5"} <= set(model.parameters):
        return
    others = {s: plane[s][..., None] for s in of_the_tire if s != "alpha"}
    slip = np.linspace(0.0, _LARGE_SLIP, 171)[1:]
    force = elementwise("tire_force", {**others, "alpha": slip})["F_y"]
    if (force <= 0).any():
        first = math.degrees(slip[(force <= 0).reshape(-1, slip.size).any(axis=0).argmax()])
        raise GroundrollError(
            f"the tire of {plane.name} reverses its force at a slip angle of {first:.0f}°: a kick"
            " needs a tire that is right at large slip, such as that of brott-physical"
        )
