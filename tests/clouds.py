"""Random trajectories of random aircraft, on which accuracy is measured."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

import groundroll as gr

Array = np.ndarray[tuple[int, ...], np.dtype[np.float64]]
BODY, PATH = ("v", "r", "y", "theta"), ("v", "r", "X", "Y", "psi")
#: The tire of the thesis as it is right at large slip angles.
LARGE_SLIP = {"B1": 0.7587, "C1": 1.187, "D1": 1.017, "E1": 0.387}
_BODY = {"m": 2500.0, "Izz": 9000.0, "b": 6.0}
HEAVY = {**_BODY, "Fz": 2500 * 9.81 / 2, "C3": -5e-4, **LARGE_SLIP}
STIFF = {"Izz": 900.0, "D1": 9.0, "b": 5.0, "CL_gamma": 9.0}
_PLANE = {"b": 3.92176, "C5": -8.81055e-6}
_GRAVITY = 9.81


@dataclass(frozen=True)
class Cloud:
    """Trajectories of variants of the aircraft of the thesis.

    Attributes
    ----------
    v0, r0 : float
        Largest initial states, m/s and rad/s.
    t : float
        Duration, s.
    changes : mapping of str to float
        What they have in common.
    states : tuple of str
        What is measured.
    """

    v0: float
    r0: float
    t: float
    changes: Mapping[str, float] = field(default_factory=dict)
    states: tuple[str, ...] = BODY

    def drawn(self, rng: np.random.Generator, count: int) -> tuple[gr.Aircraft, dict[str, Array]]:
        """So many aircraft, and their initial states."""
        start = {"v0": rng.uniform(0.01, self.v0, count), "r0": rng.uniform(-1, 1, count) * self.r0}
        plane = gr.Aircraft.load("brott").replace(**{**_PLANE, **self.changes})
        return plane.replace(**self.own(rng, count)), start

    def own(self, rng: np.random.Generator, count: int) -> dict[str, Array]:
        """What differs from aircraft to aircraft."""
        a, Ct, u = rng.uniform((-1, 0, 15), (1, 8000, 40), (count, 3)).T
        return {"a": a, "Ct": Ct, "u": u}


class Anything(Cloud):
    """Aircraft of any kind: 100 to 20,000 kg, 1 to 90 m/s, wheels and tails anywhere."""

    def own(self, rng: np.random.Generator, count: int) -> dict[str, Array]:
        m = np.exp(rng.uniform(np.log(100.0), np.log(20_000.0), count))
        a, b, u = rng.uniform((-3, 0.5, 1), (3, 12, 90), (count, 3)).T
        gyration, load, friction, stiffness, cornering, area, slope = rng.uniform(
            (0.15, 0.25, 0.3, 0.0, 2.0, 0.01, 2.0), (0.5, 0.5, 0.8, 0.2, 12.0, 0.1, 9.0), (count, 7)
        ).T
        weight, none = m * _GRAVITY, np.zeros(count)
        body = {"m": m, "a": a, "b": b, "u": u, "Izz": m * (gyration * b) ** 2}
        tires = {"Fz": weight * load, "B3": cornering, "C3": none, "B5": friction, "C5": none}
        return body | tires | {"Ct": weight * stiffness, "Ap": area * b**2, "CL_gamma": slope}


CLOUDS = {
    "like the benchmark's: v0 to 2 m/s, 5 s": Cloud(2.0, 0.0, 5.0),
    "v0 to 8 m/s, r0 to 0.5 rad/s, 5 s": Cloud(8.0, 0.5, 5.0),
    "the same with the large-slip tire": Cloud(8.0, 0.5, 5.0, LARGE_SLIP),
    "large-slip, v0 to 15 m/s, r0 to 1.5 rad/s, 10 s": Cloud(15.0, 1.5, 10.0, LARGE_SLIP),
    "heavier and mostly unstable, 8 s": Cloud(5.0, 0.3, 8.0, HEAVY),
    "light and stiff, v0 to 3 m/s, 4 s": Cloud(3.0, 1.0, 4.0, STIFF),
    "path over the ground, v0 to 4 m/s, 5 s": Cloud(4.0, 0.2, 5.0, LARGE_SLIP, PATH),
    "any aircraft, v0 to 5 m/s, 5 s": Anything(5.0, 1.0, 5.0),
    "any aircraft, large-slip, 5 s": Anything(5.0, 1.0, 5.0, LARGE_SLIP),
    "any aircraft, large-slip, 20 s": Anything(5.0, 1.0, 20.0, LARGE_SLIP),
    "any aircraft, large-slip, path, 5 s": Anything(5.0, 1.0, 5.0, LARGE_SLIP, PATH),
}
