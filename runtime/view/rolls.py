"""Runs as they are drawn from above: where an aircraft goes, what it stands on, what pushes it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from groundroll.aircraft.parameters import parameters_of
from groundroll.base.arrays import FloatArray
from groundroll.base.errors import GroundrollError, of_kind, shown
from groundroll.generated import Quantity
from groundroll.model.evaluate import columns
from groundroll.model.models import Model, as_model
from groundroll.model.names import PARAMETERS
from groundroll.model.shown import Units
from groundroll.runs.simulation import Trajectory

from .plots import COLOURS, plain, whose

#: What a model must say to be drawn on a runway.
_NEEDED = ("distance", "offset", "heading")
#: A force, for its unit.
_FORCE = Quantity("", "force", "N", "", "F", "", "")


@dataclass(frozen=True, eq=False)
class Roll:
    """One run as far as it went, lengths in the unit of the picture.

    Attributes
    ----------
    t, X, Y, psi : ndarray, shape (samples,)
        Time, s, path over the ground, and heading, rad.
    names, kinds : tuple of str
        Of what acts on it: ``"wheel"``, ``"wheels"`` (a pair of them), ``"fin"``, ``"force"``.
    places, forces : ndarray, shape (samples, parts, 2)
        Where each acts, ahead and to the right of the CG, and with what force, forward and to the
        right.
    wind : ndarray, shape (samples, 2)
        Velocity of the air along the runway and to its right; nothing but zeros without wind.
    events : mapping of str to float
        What happened, and when, s.
    label, colour : str
    """

    t: FloatArray
    X: FloatArray
    Y: FloatArray
    psi: FloatArray
    names: tuple[str, ...]
    kinds: tuple[str, ...]
    places: FloatArray
    forces: FloatArray
    wind: FloatArray
    label: str
    colour: str = COLOURS[0]
    events: Mapping[str, float] = field(default_factory=dict)

    @property
    def size(self) -> float:
        """A length to draw it by: from the CG to the fin, or without one from end to end."""
        ahead = self.places[0, :, 0]
        fins = [-x for x, kind in zip(ahead, self.kinds, strict=True) if kind == "fin" and x < 0]
        return float(fins[0] if fins else np.ptp(ahead) or 1.0)

    @property
    def flies(self) -> bool:
        """Whether it has a fin behind its CG."""
        return any(
            k == "fin" and x < 0 for k, x in zip(self.kinds, self.places[0, :, 0], strict=True)
        )

    def at(self, t: float) -> tuple[float, float, float]:
        """Position and heading at a time, from sample to sample."""
        X, Y, psi = (float(np.interp(t, self.t, s)) for s in (self.X, self.Y, self.psi))
        return X, Y, psi

    def acting(self, t: float) -> Iterator[tuple[str, str, FloatArray, FloatArray]]:
        """Name, kind, place and force of each part at a time."""
        k = min(int(np.searchsorted(self.t, t)), self.t.size - 1)
        yield from zip(self.names, self.kinds, self.places[k], self.forces[k], strict=True)

    def track(self, ahead: FloatArray, right: FloatArray) -> tuple[FloatArray, FloatArray]:
        """The path over the ground of a point of the aircraft."""
        cos, sin = np.cos(self.psi), np.sin(self.psi)
        return self.X + ahead * cos - right * sin, self.Y + ahead * sin + right * cos


def rolls_of(
    run: Trajectory | Sequence[Trajectory], labels: Sequence[str] | None, units: Units
) -> list[Roll]:
    """Every run by itself, in these units and with colours of their own.

    Raises
    ------
    GroundrollError
        If there is none, there are too few or too many labels, or a model does not say where it
        is.
    """
    rolls = [roll for each in _runs(run) for roll in _rolls(each, units)]
    if not rolls:
        raise GroundrollError("nothing to draw: no run was given")
    if labels is not None and len(labels) != len(rolls):
        raise GroundrollError(f"there are {len(rolls)} runs but {len(labels)} labels")
    for k, label in enumerate(labels or ()):
        rolls[k] = replace(rolls[k], label=label)
    return [replace(roll, colour=COLOURS[k % len(COLOURS)]) for k, roll in enumerate(rolls)]


def _runs(run: Trajectory | Sequence[Trajectory]) -> list[Trajectory]:
    """One run or several as a list."""
    if isinstance(run, Trajectory):
        return [run]
    if not isinstance(run, list | tuple):
        raise GroundrollError(
            f"what is drawn is a run of simulate or a list of them, not {shown(run)}"
        )
    return [of_kind("a run", each, Trajectory) for each in run]


def distance_of(run: Trajectory | Sequence[Trajectory]) -> Quantity:
    """The quantity by which a run is laid out on a runway."""
    runs = _runs(run)
    if not runs:
        raise GroundrollError("nothing to draw: no run was given")
    model = as_model(runs[0].model)
    missing = [role for role in _NEEDED if role not in model.roles]
    if missing:
        nothing = " and no ".join(missing)
        raise GroundrollError(f"the model {model.name} cannot be drawn on a runway: no {nothing}")
    return model.quantities[model.roles["distance"]]


def strongest(rolls: Sequence[Roll]) -> dict[str, float]:
    """The largest of each force that is no wheel's and no fin's, by name, N."""
    found: dict[str, float] = {}
    for roll in rolls:
        size = np.hypot(*np.moveaxis(roll.forces, -1, 0)).max(axis=0)
        for name, kind, force in zip(roll.names, roll.kinds, size.tolist(), strict=True):
            if kind == "force" and force > 0:
                found[name] = max(force, found.get(name, 0.0))
    return found


def in_words(force: float, units: Units) -> str:
    """A force with its unit."""
    return f"{float(f'{units.factor(_FORCE) * force:.3g}'):g} {units.of(_FORCE)}"


def _rolls(run: Trajectory, units: Units) -> Iterator[Roll]:
    model = as_model(run.model)
    metre = units.factor(distance_of(run))
    shape = run.values[model.states[0]].shape[:-1]
    count = int(np.prod(shape))
    series = {s: v.reshape(count, -1) for s, v in run.values.items()}
    p = np.stack(
        [
            np.broadcast_to(v, shape).reshape(count)
            for v in parameters_of(run.aircraft, model).values()
        ]
    )
    path = [model.roles[role] for role in _NEEDED]
    for k in range(count):
        there = np.isfinite(series[path[0]][k])
        own = {s: v[k, there] for s, v in series.items()}
        places, forces = _acting(model, own, p[:, k])
        X, Y, psi = (own[s] for s in path)
        yield Roll(
            t=run.t[there],
            X=X * metre,
            Y=Y * metre,
            psi=psi,
            names=tuple(place.name for place in model.places),
            kinds=tuple(place.kind for place in model.places),
            places=places * metre,
            forces=forces,
            wind=_wind(model, own, units),
            label=f"{whose(run)}{_varied(run, shape, k, units)}",
            events=_events(run, k),
        )


def _acting(
    model: Model, series: Mapping[str, FloatArray], p: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Places, m, and forces, N, over time, shapes (samples, parts, 2)."""
    x, u = (np.stack([series[s] for s in names]) for names in (model.states, model.inputs))
    if not model.places:
        return (np.empty((x.shape[1], 0, 2)),) * 2
    every = np.repeat(p[:, None], x.shape[1], axis=1)
    places, forces = columns(model.function("places"), x, u, every)
    return places[:, :, :2], forces[:, :, :2]


def wind_speed(model: Model) -> Quantity | None:
    """What the wind is to the model, for its unit; None if it knows none."""
    role = model.roles.get("crosswind") or model.roles.get("tailwind")
    return model.quantities[role] if role else None


def _wind(model: Model, series: Mapping[str, FloatArray], units: Units) -> FloatArray:
    """Velocity of the air along and across the runway, in the unit that is shown."""
    q = wind_speed(model)
    if q is None:
        return np.zeros((1, 2))
    roles = [model.roles.get(role) for role in ("tailwind", "crosswind")]
    parts = [units.values(q, series[s]) if s else np.zeros(1) for s in roles]
    return np.stack(np.broadcast_arrays(*parts), axis=-1)


def _events(run: Trajectory, k: int) -> dict[str, float]:
    times = {name: float(when.reshape(-1)[k]) for name, when in run.events.items()}
    return {name: t for name, t in times.items() if np.isfinite(t)}


def _varied(run: Trajectory, shape: tuple[int, ...], k: int, units: Units) -> str:
    """What is particular to one of several runs: its parameters, or its number."""
    if not shape:
        return ""
    known = {**PARAMETERS, **as_model(run.model).quantities}
    numbers = {**run.aircraft.given, **run.aircraft.own}
    own = []
    for s, value in numbers.items():
        if s in known and np.ndim(value):
            number = float(units.values(known[s], np.broadcast_to(value, shape).flat[k]))
            unit = units.of(known[s])
            own.append(f"{s} = {number:.4g} {unit}".removesuffix(" 1"))
    index = ", ".join(map(str, np.unravel_index(k, shape)))
    return ", " + plain(", ".join(own) or f"run {index}")
