"""What an ensemble is asked for: checked, laid out, and cut into tasks."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cache, partial
from typing import Any

import numpy as np

from .aircraft import Aircraft, parameter_symbols
from .arrays import FloatArray, common_shape, finite, positive, whole
from .chunks import piece
from .ensemble_result import Ensemble, Named
from .errors import GroundrollError, unknown
from .generated import Pack
from .models import ModelLike, as_model
from .motion.lanes import STATUS, Outcome, Task, Watch
from .names import QUANTITIES, listed, symbol

#: Status of a trajectory that left a range.
LEFT = STATUS.index("left the range")
#: Finest and coarsest `tol`.
TOLERANCES = (1e-11, 1e-3)
#: Bytes that the results of one chunk may take.
_CHUNK_BYTES = 2**26


@dataclass(frozen=True)
class Plan:
    """Everything about an ensemble but its chunks."""

    aircraft: Aircraft
    model: ModelLike
    shape: tuple[int, ...]
    start: dict[str, FloatArray]
    inputs: dict[str, FloatArray]
    t: float
    tol: float
    at: FloatArray
    names: tuple[str, ...]
    chunk: int
    watched: tuple[str, ...] = ()
    limits: Mapping[str, float] | None = None
    within: Mapping[str, float] | None = None

    @property
    def final(self) -> tuple[str, ...]:
        """The names that are states."""
        return tuple(s for s in self.names if s in as_model(self.model).states)

    @property
    def sampled(self) -> tuple[str, ...]:
        """The names that are sampled over time."""
        return self.names if self.at.size else ()

    @property
    def bytes_each(self) -> int:
        """Bytes of the result of one trajectory."""
        numbers = len(self.final) + len(self.names) * self.at.size + 2 * len(self.watches)
        return 8 * numbers + 1 + 1 + 4 + 8 + 8

    @property
    def follows(self) -> bool:
        """Whether a parameter that follows from others varies."""
        return any(value.ndim for value in self.aircraft.given.values())

    @property
    def watches(self) -> tuple[Watch, ...]:
        """Magnitudes whose extremes are wanted, and those beyond which a trajectory ends."""
        limits, within = self.limits or {}, self.within or {}
        return (
            *(Watch(s, limit=np.array([limits.get(s, np.inf)])) for s in self.watched),
            *(Watch(s, limit=np.array([most]), ends=True) for s, most in within.items()),
        )

    def task(self, chunk: range) -> Task:
        """The trajectories of a chunk."""
        cut_out = partial(piece, shape=self.shape, chunk=chunk)
        model, aircraft = as_model(self.model), self.aircraft
        if len(chunk) == math.prod(self.shape):
            p = {s: cut_out(aircraft[s]) for s in model.parameters}
        else:  # what follows from others, follows for the chunk alone
            given = {s: cut_out(value) for s, value in aircraft.given.items()}
            aircraft = replace(aircraft, given=given)
            p = {s: aircraft[s] for s in model.parameters}
        return Task(
            model=model,
            x0={s: cut_out(self.start[s]).reshape(-1) for s in model.states},
            inputs={s: cut_out(self.inputs[s]).reshape(-1) for s in model.inputs},
            parameters={s: value.reshape(-1) for s, value in p.items()},
            count=len(chunk),
            t=self.t,
            tol=self.tol,
            times=self.at,
            sampled=self.sampled,
            final=self.final,
            watches=self.watches,
        )

    def empty_result(self) -> Outcome:
        """Room for all trajectories."""
        n, watches = math.prod(self.shape), len(self.watches)
        return Outcome.empty(n, self.final, self.sampled, self.at.size, watches)

    def shaped(self, result: Outcome) -> Ensemble:
        """The result in the shape of the trajectories."""

        def named(arrays: Mapping[str, FloatArray], wanted: Iterable[str], what: str) -> Named:
            each = {s: arrays[s].reshape((*self.shape, *arrays[s].shape[1:])) for s in wanted}
            return Named(each, what, self.model)

        left = result.cause >= 0
        for state in result.final.values():
            state[left] = np.nan
        largest = dict(zip(self.watched, result.largest, strict=False))
        first = dict(zip(self.watched, result.first, strict=False))
        return Ensemble(
            aircraft=self.aircraft,
            model=self.model,
            start=self.start,
            inputs=self.inputs,
            t=self.t,
            tol=self.tol,
            status=np.where(left, LEFT, result.status).astype(np.int8).reshape(self.shape),
            steps=result.steps.reshape(self.shape),
            estimate=result.estimate.reshape(self.shape),
            final=named(result.final, self.final, "final states"),
            at=self.at,
            samples=named(result.samples, self.sampled, "samples"),
            largest=named(largest, self.watched, "extremes"),
            first=named(first, self.limits or (), "limits"),
            limits=dict(self.limits or {}),
            within=dict(self.within or {}),
        )


def plan(
    plane: Aircraft,
    t: Any,
    model: ModelLike,
    at: Any,
    names: Iterable[str] | None,
    tol: Any,
    chunk: int,
    values: Mapping[str, Any],
) -> Plan:
    model = as_model(model)
    duration = positive("t", t, "s")
    start, inputs, parameters = _sorted(model, values)
    aircraft = plane.replace(**parameters)
    x0 = {s: finite(f"{s}0", start.get(s, 0.0), QUANTITIES[s].unit) for s in model.states}
    u = {
        s: finite(QUANTITIES[s].name, inputs.get(s, 0.0), QUANTITIES[s].unit) for s in model.inputs
    }
    own = {f"{s}0": value for s, value in x0.items()}
    shape = common_shape({**aircraft.given, **u, **own})
    if 0 in shape:
        raise GroundrollError(f"there is nothing to simulate: the arrays broadcast to {shape}")
    times = _times(at, duration)
    if names is None:
        path = {"X", "Y"} & start.keys()
        wanted = model.states if path else _in_body_axes(model)
    else:
        allowed = (*model.states, *model.outputs) if times.size else model.states
        wanted = tuple(symbol(n, "name", allowed, "names") for n in listed("names", names))
    made = Plan(
        aircraft=aircraft,
        model=model.key,
        shape=shape,
        start=x0,
        inputs=u,
        t=duration,
        tol=check_tolerance(tol),
        at=times,
        names=tuple(dict.fromkeys(wanted)),
        chunk=whole("chunk", chunk, 1),
    )
    return replace(made, chunk=min(made.chunk, max(32, _CHUNK_BYTES // made.bytes_each)))


def watching(
    plan: Plan,
    extremes: Iterable[str],
    limits: Mapping[str, float | str],
    within: Mapping[str, float | str],
) -> Plan:
    """The plan with extremes, limits and ranges."""
    model = as_model(plan.model)
    allowed = (*model.states, *model.outputs)

    def bounds(kind: str, given: Mapping[str, float | str]) -> dict[str, float]:
        if not isinstance(given, Mapping):
            raise GroundrollError(f"{kind} must be a mapping of names to numbers, not {given!r}")
        each = {symbol(name, "name", allowed, kind): (name, v) for name, v in given.items()}
        return {
            s: positive(f"{kind}[{name!r}]", value, QUANTITIES[s].unit)
            for s, (name, value) in each.items()
        }

    firsts, ranges = bounds("limits", limits), bounds("within", within)
    every = [symbol(n, "name", allowed, "extremes") for n in listed("extremes", extremes)]
    watched = tuple(dict.fromkeys([*every, *firsts, *ranges]))
    return replace(plan, watched=watched, limits=firsts, within=ranges)


def _sorted(
    model: ModelLike, values: Mapping[str, Any]
) -> tuple[dict[str, Any], dict[str, Any], dict[str, Any]]:
    """Initial states and inputs by symbol, and parameters as they were named."""
    model = as_model(model)
    start, inputs, parameters = {}, {}, {}
    begins = {f"{s}0": s for s in model.states}
    input_names = {name: s for s in model.inputs for name in (s, QUANTITIES[s].name)}
    for name, value in values.items():
        if name in begins:
            start[begins[name]] = value
        elif name in input_names:
            inputs[input_names[name]] = value
        else:
            _check_name(name, [*begins, *input_names])
            parameters[name] = value
    return start, inputs, parameters


def _check_name(name: str, others: Iterable[str]) -> None:
    if name not in _parameter_names():
        raise unknown("argument", name, [*others, *_parameter_names()], "ensemble")


@cache
def _parameter_names() -> dict[str, None]:
    return dict.fromkeys(n for s in parameter_symbols() for n in (s, QUANTITIES[s].name))


def _in_body_axes(model: Pack) -> tuple[str, ...]:
    """Every state but the path over the ground, in the order of the largest set without it."""
    return model.carried[max(0, len(model.carried) - 2)]


def check_tolerance(tol: Any) -> float:
    """`tol` as a number in the range that is offered."""
    number = positive("tol", tol)
    finest, coarsest = TOLERANCES
    if not finest <= number <= coarsest:
        raise GroundrollError(f"tol must be from {finest:g} to {coarsest:g}, not {number:g}")
    return number


def _times(at: Any, duration: float) -> FloatArray:
    if at is None:
        return np.empty(0)
    times = np.atleast_1d(finite("at", at, "s"))
    if times.ndim != 1 or times.size == 0 or (np.diff(times) <= 0).any():
        raise GroundrollError("at must be a list of increasing times")
    if times[0] < 0 or times[-1] > duration:
        raise GroundrollError(
            f"at must lie within 0 to t = {duration:g} s, not {times[0]:g} to {times[-1]:g} s"
        )
    return times
