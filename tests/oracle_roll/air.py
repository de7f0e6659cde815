"""Forces of the air: derivatives at the CG, a fin and a tailplane at their own stations, thrust.

Controls in the usual signs: elevator down, rudder to the left and right aileron up are positive;
the pedal is positive to the right.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

Vector = np.ndarray[Any, np.dtype[np.float64]]


class Air(NamedTuple):
    """What the air does to the body: a force, and its moment about the CG, in body axes."""

    force: Vector
    moment: Vector


def stalled(lift: float, limit: float | None) -> float:
    """A lift coefficient between -limit and limit."""
    return lift if limit is None else float(np.clip(lift, -limit, limit))


def derivatives(
    d: Mapping[str, float],
    density: float,
    velocity: Vector,
    rates: Vector,
    controls: Mapping[str, float],
) -> Air:
    """The whole aircraft by its derivatives, in body axes at the CG."""
    u, v, w = velocity
    V2 = velocity @ velocity
    along2 = u * u + w * w
    qS = density * V2 * d["S"] / 2
    beta, alpha = np.arctan2(v, np.sqrt(along2)), np.arctan2(w, abs(u))
    # a rate enters as q S b (b / 2 V) rate = rho V S b^2 / 4 rate, which is nothing at rest
    over_2V = 1 / (2 * np.sqrt(V2)) if V2 > 0 else 0.0
    p, q, r = rates * np.array([d["b"], d["cbar"], d["b"]]) * over_2V
    rudder, aileron, elevator = (controls[name] for name in ("rudder", "aileron", "elevator"))
    CL = stalled(d["CL"] + d["CLa"] * alpha, d.get("CLmax"))
    CD = d["CD"] + d.get("K", 0.0) * CL**2
    along = max(np.sqrt(along2), 1e-9)
    ahead, down = u / along, w / along
    force = qS * np.array(
        [
            -CD * ahead + CL * down,
            d["CYb"] * beta + d["CYdr"] * rudder + d.get("CYr", 0.0) * r,
            -CD * down - CL * ahead,
        ]
    )
    moment = qS * np.array(
        [
            d["b"] * (d["Clb"] * beta + d["Clp"] * p + d.get("Clr", 0.0) * r + d["Clda"] * aileron),
            d["cbar"] * (d["Cm0"] + d["Cma"] * alpha + d["Cmq"] * q + d["Cmde"] * elevator),
            d["b"]
            * (d["Cnb"] * beta + d["Cnr"] * r + d["Cndr"] * rudder + d.get("Cnda", 0.0) * aileron),
        ]
    )
    return Air(force, moment)


def slipstream(u: float, thrust: float, density: float, disc: float) -> float:
    """Axial speed behind the propeller far downstream, by momentum theory."""
    return float(np.sqrt(max(u * abs(u) + 2 * thrust / (density * disc), 0.0)))


def surface(
    s: Mapping[str, float],
    density: float,
    velocity: Vector,
    rates: Vector,
    thrust: float,
    disc: float,
    deflection: float,
    vertical: bool,
) -> Air:
    """A fin (vertical) or tailplane at its station `x`, `z`, with its rudder or elevator."""
    place = np.array([s["x"], 0.0, s["z"]])
    u, v, w = velocity + np.cross(rates, place)
    u = slipstream(u, thrust, density, disc)
    across = v if vertical else w
    angle = np.arctan2(across, u) * (1 - s.get("downwash", 0.0)) + s.get("incidence", 0.0)
    angle += (-s["tau"] if vertical else s["tau"]) * deflection
    lift = stalled(s["slope"] * angle, s.get("CLmax"))
    size = density * (u * u + across * across) * s["S"] / 2 * lift
    force = np.array([0.0, -size, 0.0] if vertical else [0.0, 0.0, -size])
    return Air(force, np.cross(place, force))


def air(
    aircraft: Mapping[str, Any], velocity: Vector, rates: Vector, controls: Mapping[str, float]
) -> Air:
    """All of it, at a velocity through the air."""
    density, thrust = aircraft["rho"], controls["thrust"]
    line = np.array([0.0, 0.0, aircraft.get("thrust_z", 0.0)])
    pull = np.array([thrust, 0.0, 0.0])
    parts = [
        derivatives(aircraft["aero"], density, velocity, rates, controls),
        Air(pull, np.cross(line, pull)),
    ]
    disc = aircraft.get("disc", 0.0)
    for name, vertical, control in (("fin", True, "rudder"), ("tailplane", False, "elevator")):
        if name in aircraft:
            parts.append(
                surface(
                    aircraft[name],
                    density,
                    velocity,
                    rates,
                    thrust,
                    disc,
                    controls[control],
                    vertical,
                )
            )
    force, moment = (np.sum([part[n] for part in parts], axis=0) for n in range(2))
    return Air(force, moment)
