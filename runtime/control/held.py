"""Rolling straight along the runway: the states and the control that hold it there.

An aircraft is held when its CG goes along the runway at a speed, neither turns nor heaves, and is
not pushed across or off it; along the runway it may slow down. The equations are asked of the
model: the rates of all states but the velocities, and the second time derivatives of offset and
depth, which are the Jacobian of their rates times the rates. Unknown are the states that matter,
and levers: inputs that move together. The linear term that is left out, the change of that
Jacobian, only makes Newton's steps a little less than quadratic.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import numpy.typing as npt

from groundroll.base.arrays import FloatArray
from groundroll.base.errors import GroundrollError
from groundroll.linear.points import Points
from groundroll.model.models import Model

IntArray = npt.NDArray[np.intp]
BoolArray = npt.NDArray[np.bool_]

#: What a model must say of itself.
_NEEDED = ("speed", "lateral_velocity", "heading", "distance", "offset", "crosswind")
#: Velocities of the CG along body axes, which follow from the speed along the runway.
_VELOCITIES = ("u", "v", "w")
#: Rates below this are none, over what they may be; Newton's steps, and the largest of them.
_REST, _ROUNDS = 1e-9, 40
#: How much a step may change the states, m/s, rad and m alike.
_STEP = 0.2

#: Inputs that one lever moves, and how much of each it moves: for all points, or for each.
Lever = Mapping[str, FloatArray | float]


@dataclass(frozen=True)
class Rolls:
    """Rolls along the runway, one for each of the points in a row.

    Attributes
    ----------
    points : Points
        Of shape (n,); states, inputs and parameters by symbol.
    speed : ndarray, shape (n,)
        Along the runway, m/s.
    levers : sequence of mapping
        What may be moved to hold it.
    """

    points: Points
    speed: FloatArray
    levers: Sequence[Lever]

    def __post_init__(self) -> None:
        model = self.points.model
        missing = [role for role in _NEEDED if role not in model.roles]
        if missing or "u" not in model.states:
            what = f"no {' and no '.join(missing)}" if missing else "no speed that is free"
            raise GroundrollError(
                f"the model {model.name} cannot be held along a runway: it knows {what};"
                " rollout and landing_roll can"
            )

    @property
    def model(self) -> Model:
        """Of the points."""
        return self.points.model

    @cached_property
    def unknown(self) -> tuple[str, ...]:
        """States that are sought."""
        return self.model.dynamic

    def some(self, which: IntArray | BoolArray) -> Rolls:
        """Some of them."""
        values = {s: v[which] if v.ndim else v for s, v in self.points.values.items()}
        levers = [
            {s: x[which] if np.ndim(x) else x for s, x in lever.items()}  # type: ignore[index]
            for lever in self.levers
        ]
        speed = self.speed[which]
        points = replace(self.points, values=values, shape=speed.shape)
        return Rolls(points, speed, levers)

    def at(self, z: FloatArray) -> Points:
        """The points with states and levers of shape (n, states + levers)."""
        values = dict(self.points.values)
        for k, s in enumerate(self.unknown):
            values[s] = z[:, k]
        for lever, moved in zip(self.levers, z.T[len(self.unknown) :], strict=True):
            for s, share in lever.items():
                values[s] = values[s] + share * moved
        return replace(self.points, values=values)

    def with_inputs(self, **values: FloatArray) -> Rolls:
        """With other inputs beside the levers."""
        points = replace(self.points, values={**self.points.values, **values})
        return replace(self, points=points)

    def start(self, levers: int) -> FloatArray:
        """States as they are given, and no lever moved, shape (n, states + levers)."""
        rows = [self.points.values[s] for s in self.unknown]
        z = np.stack([*(np.broadcast_to(x, self.speed.shape) for x in rows)], axis=-1)
        return np.concatenate([z, np.zeros((len(z), levers))], axis=-1)

    def balance(self, z: FloatArray) -> tuple[FloatArray, FloatArray]:
        """What must be zero, and its Jacobian by z; shapes (n, m), (n, m, states + levers)."""
        model, roles = self.model, self.model.roles
        found = self.at(z).evaluate("f", "fx", "fu", over=model.states)
        f, fx = found["f"], found["fx"]
        moved = np.stack([self._by_lever(found["fu"], lever) for lever in self.levers], axis=-1)
        columns = [model.states.index(s) for s in self.unknown]
        by_z = np.concatenate([fx[:, :, columns], moved], axis=-1)
        rows = [k for k, s in enumerate(model.states) if s not in _VELOCITIES]
        first = f[:, rows]
        first[:, rows.index(model.states.index(roles["distance"]))] -= self.speed
        second = [
            fx[:, model.states.index(roles[role]), :]
            for role in ("offset", "depth")
            if role in roles
        ]
        pushed = [(row * f).sum(axis=-1) for row in second]
        by = [(row[:, None, :] @ by_z)[:, 0] for row in second]
        return (
            np.concatenate([first, np.stack(pushed, axis=-1)], axis=-1),
            np.concatenate([by_z[:, rows], np.stack(by, axis=1)], axis=1),
        )

    def _by_lever(self, fu: FloatArray, lever: Lever) -> FloatArray:
        inputs = self.model.inputs
        parts = (fu[:, :, inputs.index(s)] * np.reshape(x, (-1, 1)) for s, x in lever.items())
        return np.asarray(sum(parts))


def solved(rolls: Rolls, z: FloatArray, rounds: int = _ROUNDS) -> tuple[FloatArray, BoolArray]:
    """Newton's steps in the states and the first lever; the others stay.

    Returns
    -------
    z : ndarray, shape (n, states + levers)
    found : ndarray of bool, shape (n,)
    """
    z, n = z.copy(), len(rolls.unknown)
    kept = slice(0, n + 1)
    left = np.arange(len(z))
    found = np.zeros(len(z), bool)
    for _ in range(rounds):
        some = rolls.some(left)
        F, J = some.balance(z[left])
        done = np.abs(F).max(axis=-1) < _REST * np.maximum(1.0, some.speed)
        found[left[done]] = True
        going = ~done & np.isfinite(F).all(axis=-1) & np.isfinite(J).all(axis=(-1, -2))
        left = left[going]
        if left.size == 0:
            break
        step = by_elimination(J[going][:, :, kept], -F[going])
        size = np.abs(step[:, :n]).max(axis=-1, keepdims=True)
        z[left, kept] += step * np.minimum(1.0, _STEP / np.maximum(size, 1e-300))
    return z, found


def by_elimination(J: FloatArray, F: FloatArray) -> FloatArray:
    """Solutions of linear systems; the shortest where one is singular."""
    try:
        return np.asarray(np.linalg.solve(J, F[..., None])[..., 0])
    except np.linalg.LinAlgError:
        return np.asarray((np.linalg.pinv(J, rcond=1e-12) @ F[..., None])[..., 0])
