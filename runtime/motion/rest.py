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
#: A speed so small that nothing drags, m/s, at which slip angles are defined.
CREEP = 1e-6


def start_of(
    plane: Aircraft, model: Model, given: Mapping[str, FloatArray]
) -> dict[str, FloatArray]:
    """Initial value of every state: as given, the aircraft's own speed, at rest, or zero.

    A body on legs starts at the depth and pitch at which it would rest on them without air.
    """
    start = {s: given[s] if s in given else np.zeros(()) for s in model.states}
    speed = model.roles.get("speed")
    if speed in model.states and speed not in given and speed in PARAMETERS and speed in plane:
        start[speed] = plane[speed]
    depth = model.roles.get("depth")
    if depth in model.states and not {depth, "theta"} & set(given):
        start[depth], start["theta"] = _at_rest(plane, model, depth)
        if "w" not in given:
            start["w"] = _along_the_runway(plane, model, start, depth)
    return start


def lifts(event: Event) -> bool:
    """Whether an event is that of a wheel that leaves the ground."""
    return event.name.startswith(_LIFTED)


def _along_the_runway(
    plane: Aircraft, model: Model, start: Mapping[str, FloatArray], depth: str
) -> FloatArray:
    """Velocity along body z with which the body neither rises nor sinks; the rate is linear."""
    values = {f"p {s}": value for s, value in parameters_of(plane, model).items()}
    arrays, shape = broadcast({**start, **values})
    x = np.stack([arrays[s].ravel() for s in model.states])
    p = np.stack([arrays[f"p {s}"].ravel() for s in model.parameters])
    rhs, u = model.function("rhs"), np.zeros((len(model.inputs), p.shape[1]))
    rate = []
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
    wheels = [model.outputs.index(event.output) for event in model.events if lifts(event)]

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
            f"aircraft {plane.name} finds no rest on its legs: look at the stations of its wheels,"
            " and at what its legs carry"
        )
    return at[0].reshape(shape), at[1].reshape(shape)


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
