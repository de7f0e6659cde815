"""What an equilibrium of a model needs: which rates vanish, and what is open to make them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from groundroll.aircraft.aircraft import Aircraft
from groundroll.aircraft.values import Given
from groundroll.base.arrays import FloatArray, single
from groundroll.base.errors import GroundrollError, mapped, shown
from groundroll.model.models import Model
from groundroll.model.names import listed

from .equilibria import Question
from .points import Points

#: Parameter below whose speed friction fades; how often that speed something slides.
_FADES, _SLIDES = "v_rest", 2.0
#: How symbols of states of a wheel that swivels begin, which stick like the others at rest.
_SWIVEL = "chi_"
#: Where it is seen on what a model depends: so far, in SI, around where the search begins.
_PLACES, _AROUND = 5, 0.03


def sought(model: Model, found: Given, names: Iterable[str]) -> tuple[str, ...]:
    """Symbols of the inputs to be found.

    Raises
    ------
    GroundrollError
        If one is no input, is named twice, or is given as well.
    """
    inputs = [
        model.symbol(s, "input", model.inputs, "solve_for") for s in listed("solve_for", names)
    ]
    for s in inputs:
        if s in found.inputs or inputs.count(s) > 1:
            why = "given as well" if s in found.inputs else "named twice"
            raise GroundrollError(f"{model.quantities[s].name} ({s}) is to be found, but {why}")
    return tuple(inputs)


def ranges_of(model: Model, within: Mapping[str, Any] | None) -> dict[str, tuple[float, float]]:
    """Ranges of unknowns by symbol, SI."""
    found = dict(model.ranges)
    allowed = (*model.dynamic, *model.inputs)
    given = {} if within is None else mapped("within", within)
    for name, pair in given.items():
        s = model.symbol(name, "state or input", allowed, "within")
        low, high = pair_of(f"within[{name!r}]", pair, model.quantities[s].unit)
        least, most = found.get(s, (-math.inf, math.inf))
        found[s] = max(low, least), min(high, most)
    return found


def pair_of(what: str, pair: Any, unit: str) -> tuple[float, float]:
    """From where to where, SI."""
    if isinstance(pair, str) or not isinstance(pair, Iterable) or len(ends := list(pair)) != 2:
        raise GroundrollError(f"{what} must be a pair, from and to, not {shown(pair)}")
    low, high = (single(what, end, unit) for end in ends)
    if not low < high:
        raise GroundrollError(f"{what} must be from a smaller to a larger value")
    return low, high


def named(plane: Aircraft, found: Given) -> dict[str, FloatArray]:
    """What a call gave: states, inputs, and parameters that it changed, by symbol."""
    given = found.aircraft.given
    changed = {s: x for s, x in given.items() if plane.given.get(s) is not x}
    own = {s: x for s, x in found.aircraft.own.items() if plane.own.get(s) is not x}
    return {**found.states, **found.inputs, **changed, **own}


def question_of(
    points: Points,
    found: Given,
    inputs: tuple[str, ...],
    ranges: Mapping[str, tuple[float, float]],
) -> tuple[Question, tuple[str, ...], tuple[str, ...]]:
    """The question, and the states that are held by something else, and those that do not matter.

    Raises
    ------
    GroundrollError
        If there are more or fewer unknowns than conditions; the message names both.
    """
    model = points.model
    speed, offset = model.roles.get("speed"), model.roles.get("offset")
    fixed = {*found.states, *([speed] if speed in model.dynamic else [])}
    idle = tuple(s for s in _idle(points) if s not in found.states)
    vanish = [s for s in model.dynamic if s not in idle]
    unknown = [s for s in vanish if s not in fixed] + list(inputs)
    heading = model.roles.get("heading")
    if _is_rest(model, found, inputs):
        rest = _at_rest(points, vanish, ranges)
        return rest, (), tuple(s for s in model.dynamic if s not in rest.vanish)
    if heading in unknown and offset in model.states and len(vanish) <= len(unknown):
        vanish.append(offset)  # along the runway
    elif heading in idle and len(unknown) == len(vanish) + 1:
        vanish.append(heading)  # straight ahead
    held: tuple[str, ...] = ()
    if len(unknown) == len(vanish) - 1 and speed in vanish and speed in fixed:
        held = (speed,)
        vanish.remove(speed)
    if len(unknown) != len(vanish):
        raise GroundrollError(_counted(model, unknown, vanish, fixed))
    if heading in unknown and offset not in vanish:
        ranges = {heading: (-math.pi, math.pi), **ranges}  # it may end up anywhere in the wind
    return Question(points, tuple(unknown), tuple(vanish), ranges), held, idle


def _is_rest(model: Model, found: Given, inputs: tuple[str, ...]) -> bool:
    """Whether the question is what stands still: a free speed is given, and is zero."""
    speed = model.roles.get("speed")
    given = found.states.get(speed) if speed in model.dynamic else None
    return given is not None and not given.any() and not inputs and _FADES in model.parameters


def _at_rest(
    points: Points, vanish: list[str], ranges: Mapping[str, tuple[float, float]]
) -> Question:
    """What stands still by friction, where it points.

    Friction near rest takes a creep below a speed that is a parameter; the more, the nearer it is
    to all that there is. What creeps faster than some times that speed slides.
    """
    model = points.model
    turned = model.roles.get("heading")
    sticks = [s for s in vanish if s != turned and not s.startswith(_SWIVEL)]
    fades = float(np.min(points.values[_FADES]))
    creeping = [model.roles.get(role) for role in ("speed", "lateral_velocity", "yaw_rate")]
    creep = {s: fades for s in creeping if s in sticks}
    slow = dict.fromkeys(creep, (-_SLIDES * fades, _SLIDES * fades))
    return Question(points, tuple(sticks), tuple(sticks), {**ranges, **slow}, creep)


def _idle(points: Points) -> list[str]:
    """Dynamic states on which nothing depends here, as on a heading without wind."""
    model = points.model
    rng = np.random.default_rng(1)
    cases = np.arange(max(points.count, _PLACES)) % points.count
    values = {s: np.asarray(x[cases] if x.size > 1 else x[0]) for s, x in _columns(points).items()}
    for s in model.dynamic:
        values[s] = values[s] + rng.uniform(-_AROUND, _AROUND, len(cases))
    slopes = Points(model, points.aircraft, values, (len(cases),)).evaluate("fx")["fx"]
    return [s for k, s in enumerate(model.dynamic) if not slopes[:, :, k].any()]


def _columns(points: Points) -> dict[str, FloatArray]:
    return dict(zip(points.values, points.columns, strict=True))


def _counted(model: Model, unknown: list[str], vanish: list[str], fixed: set[str]) -> str:
    """The message where unknowns and conditions are not as many."""

    def names(symbols: Iterable[str]) -> str:
        return ", ".join(model.quantities[s].name for s in symbols) or "nothing"

    few = len(unknown) < len(vanish)
    given = [s for s in model.dynamic if s in fixed]
    free = [s for s in model.inputs if s not in unknown]
    more = f"name inputs in solve_for ({names(free)})"
    if given:
        more += f", or give fewer states ({names(given)} given)"
    way = more if few else "give states a value, or name fewer inputs in solve_for"
    return (
        f"the rates of {names(vanish)} are to vanish, which are {len(vanish)} conditions, but"
        f" {len(unknown)} quantities are open ({names(unknown)}): {way}"
    )
