"""Where a motion starts that nobody has said: at rest on its legs, at the aircraft's own speed."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from groundroll.aircraft.aircraft import Aircraft
from groundroll.aircraft.parameters import parameters_of
from groundroll.base.arrays import FloatArray, broadcast
from groundroll.base.errors import GroundrollError
from groundroll.generated.packs import Event
from groundroll.model.evaluate import columns
from groundroll.model.models import Model
from groundroll.model.names import PARAMETERS

#: Events of wheels end in the name of the wheel; their outputs are depths below the runway, m.
_LIFTED = "wheel_lifted_"
#: A guess of how far wheels sink in, m; steps of differences; largest step and how many.
SUNK, _H, _STEP, _ROUNDS = 0.05, 1e-6, 0.05, 100
_STIFFER = (
    "give stiffer legs (main_leg_stiffness, third_leg_stiffness), or how far they give way at rest"
    " (main_leg_deflection, third_leg_deflection)"
)
#: A speed so small that nothing drags, m/s, at which slip angles are defined.
CREEP = 1e-6


def start_of(
    plane: Aircraft, model: Model, given: Mapping[str, FloatArray]
) -> dict[str, FloatArray]:
    """Initial value of every state: as given, the aircraft's own speed, at rest, or zero.

    A body on legs starts at the depth and pitch at which it would rest on them without air; if its
    pitch is given, at that depth.
    """
    start = {s: given[s] if s in given else np.zeros(()) for s in model.states}
    speed = model.roles.get("speed")
    if speed in model.states and speed not in given and speed in PARAMETERS and speed in plane:
        start[speed] = plane[speed]
    depth = model.roles.get("depth")
    if depth not in model.states:
        return start
    if depth not in given:
        start[depth], pitch = _at_rest(plane, model, depth)
        start["theta"] = given.get("theta", pitch)
        if "w" not in given:
            start["w"] = _along_the_runway(plane, model, start, depth)
    else:
        _refuse_a_start_underground(plane, model, start, depth)
    return start


def lifts(event: Event) -> bool:
    """Whether an event is that of a wheel that leaves the ground."""
    return event.name.startswith(_LIFTED)


def _refuse_a_start_underground(
    plane: Aircraft, model: Model, start: Mapping[str, FloatArray], depth: str
) -> None:
    """Refuse a start with a wheel deeper in the ground than the CG is above it."""
    wheels = _wheels(model)
    x, u, p, _ = _point(plane, model, start)
    (y,) = columns(model.function("outputs"), x, u, p)
    height = -x[model.states.index(depth)]
    depths = y[:, [model.outputs.index(output) for output in wheels.values()], 0]
    if (bad := depths.max(axis=1, initial=-np.inf) > height).any():
        n = int(bad.argmax())
        raise GroundrollError(
            f"{model.quantities[depth].name} ({depth}0): with {-height[n]:g} m the"
            f" {[*wheels][int(depths[n].argmax())]} wheel of aircraft {plane.name} starts"
            f" {depths[n].max():.3g} m under the runway and its CG {height[n]:.3g} m above it; z is"
            " down, and without it the aircraft starts at rest on its legs"
        )


def _wheels(model: Model) -> dict[str, str]:
    """Name of each wheel, and the output that is its depth."""
    return {e.name.removeprefix(_LIFTED): e.output for e in model.events if lifts(e)}


def _point(
    plane: Aircraft, model: Model, start: Mapping[str, FloatArray]
) -> tuple[FloatArray, FloatArray, FloatArray, tuple[int, ...]]:
    """States, inputs of nothing and parameters, one column for each start, and their shape."""
    values = {f"p {s}": value for s, value in parameters_of(plane, model).items()}
    arrays, shape = broadcast({**start, **values})
    x = np.stack([arrays[s].ravel() for s in model.states])
    p = np.stack([arrays[f"p {s}"].ravel() for s in model.parameters])
    return x, np.zeros((len(model.inputs), p.shape[1])), p, shape


def _along_the_runway(
    plane: Aircraft, model: Model, start: Mapping[str, FloatArray], depth: str
) -> FloatArray:
    """Velocity along body z with which the body neither rises nor sinks; the rate is linear."""
    x, u, p, shape = _point(plane, model, start)
    rhs, rate = model.function("rhs"), []
    for w in (0.0, 1.0):
        x[model.states.index("w")] = w
        rate.append(columns(rhs, x, u, p)[0][:, model.states.index(depth), 0])
    return np.asarray(rate[0] / (rate[0] - rate[1])).reshape(shape)


def _at_rest(plane: Aircraft, model: Model, depth: str) -> tuple[FloatArray, FloatArray]:
    """Depth and pitch at which nothing heaves or pitches, no air and no speed."""
    values = parameters_of(plane, model)
    arrays, shape = broadcast({**values, "rho": np.zeros(())} if "rho" in values else values)
    p = np.stack([arrays[s].ravel() for s in model.parameters])
    n, u = p.shape[1], np.zeros((len(model.inputs), p.shape[1]))
    Z, pitch = model.states.index(depth), model.states.index("theta")
    rows = [model.states.index("w"), model.states.index("q")]
    wheels = [model.outputs.index(output) for output in _wheels(model).values()]

    def state(at: FloatArray) -> FloatArray:
        x = np.zeros((len(model.states), n))
        x[model.states.index("u")], x[Z], x[pitch] = CREEP, *at
        return x

    def depths(at: FloatArray) -> FloatArray:
        (y,) = columns(model.function("outputs"), state(at), u, p)
        return np.asarray(y[:, wheels, 0])

    def rates(at: FloatArray) -> FloatArray:
        (f,) = columns(model.function("rhs"), state(at), u, p)
        return np.asarray(f[:, rows, 0])

    # straight lines through the wheels first, then Newton steps
    at = np.zeros((2, n))
    for _ in range(5):
        at = at - _step(depths, at, depths(at) - SUNK)
    for _ in range(_ROUNDS):
        step = np.clip(_step(rates, at, rates(at)), -_STEP, _STEP)
        at = at - step
        if np.abs(step).max() < 1e-11:
            break
    if not np.isfinite(at).all() or (np.abs(rates(at)) > 1e-6).any():
        raise GroundrollError(
            f"aircraft {plane.name} finds no rest on its legs: look at the stations and depths of"
            f" its wheels; or they cannot carry it: {_STIFFER}"
        )
    _refuse_what_cannot_stand(plane, model, at, depths(at))
    return at[0].reshape(shape), at[1].reshape(shape)


def _refuse_what_cannot_stand(
    plane: Aircraft, model: Model, at: FloatArray, depths: FloatArray
) -> None:
    """Refuse a rest with a wheel in the air, or on legs too weak to keep the CG up.

    A leg that gives way by more than the height that is left above it has failed.
    """
    wheels = [*_wheels(model)]
    height, deepest = -at[0], depths.max(axis=1, initial=-np.inf)
    if (bad := deepest > height).any():
        n = int(bad.argmax())
        wheel = wheels[int(depths[n].argmax())]
        raise GroundrollError(
            f"the legs of aircraft {plane.name} cannot carry it: at rest the {wheel} wheel would be"
            f" {deepest[n]:.3g} m under the runway and the CG {height[n]:.3g} m above it;"
            f" {_STIFFER}"
        )
    if (bad := (depths <= 0).any(axis=1)).any():
        n = int(bad.argmax())
        wheel = wheels[int(depths[n].argmin())]
        raise GroundrollError(
            f"aircraft {plane.name} does not stand on all its wheels: at rest the {wheel} wheel is"
            f" {-depths[n].min():.3g} m above the runway; the CG must be between the main wheels"
            " and the third wheel: look at their stations and depths, and at their legs"
        )


def _step(f: object, at: FloatArray, value: FloatArray) -> FloatArray:
    """The least-squares step in both unknowns, by central differences, shape (2, n)."""
    assert callable(f)
    slopes = []
    for k in range(2):
        h = np.zeros((2, 1))
        h[k] = _H
        slopes.append((f(at + h) - f(at - h)) / (2 * _H))
    J = np.stack(slopes, axis=-1)
    return np.asarray((np.linalg.pinv(J) @ value[..., None])[..., 0].T)
