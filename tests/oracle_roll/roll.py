"""The equations of motion of the roll, and their integration."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import root

from .air import Vector, air
from .signals import Signal, corners, value
from .tires import friction, side

#: The rigid body's; a swivelling wheel appends its angle and rate.
STATES = ("X", "Y", "Z", "phi", "theta", "psi", "u", "v", "w", "p", "q", "r")
INPUTS = (
    *("steer_deg", "brake_left", "brake_right", "rudder", "aileron", "elevator"),
    *("thrust", "wind_x", "wind_y", "F_disturbance"),
)


def rotation(phi: float, theta: float, psi: float) -> Vector:
    """From body to ground axes: yaw, then pitch, then roll."""
    (cf, ct, cp), (sf, st, sp) = np.cos([phi, theta, psi]), np.sin([phi, theta, psi])
    return np.array(
        [
            [ct * cp, sf * st * cp - cf * sp, cf * st * cp + sf * sp],
            [ct * sp, sf * st * sp + cf * cp, cf * st * sp - sf * cp],
            [-st, sf * ct, cf * ct],
        ]
    )


class Contact(NamedTuple):
    """A wheel on the ground: load, force along and to the left, and what the body feels."""

    load: float
    along: float
    left: float
    slip: float
    force: Vector
    moment: Vector


def contact(
    wheel: Mapping[str, Any],
    aircraft: Mapping[str, Any],
    x: Vector,
    turned: float,
    turning: float,
    brake: float,
) -> Contact:
    """One wheel, its heading turned clockwise by an angle against the body's.

    `turning` is the sideways velocity of the contact to the left because the wheel swivels.
    """
    to_ground = rotation(*x[3:6])
    tilt = to_ground[2, 2]
    foot = np.array([wheel["x"], wheel["y"], wheel["z"]])
    depth = x[2] + to_ground[2] @ foot
    foot = foot - np.array([0.0, 0.0, depth / tilt])
    velocity = to_ground @ (x[6:9] + np.cross(x[9:12], foot))
    load = (wheel["k"] * depth + wheel["c"] * velocity[2]) / tilt**2 if depth > 0 else 0.0
    load = max(load, 0.0)

    heading = (to_ground @ [np.cos(turned), np.sin(turned), 0.0])[:2]
    heading = heading / np.hypot(*heading)
    right = np.array([-heading[1], heading[0]])
    Vx, Vy = velocity[:2] @ heading, velocity[:2] @ right - turning
    width = aircraft.get("v_rest", 1e-4)
    # the force fades below this speed, its slip angle does not
    speed = np.hypot(Vx, Vy)
    fade = speed / (speed**4 + width**4) ** 0.25
    ahead = max(abs(Vx), 1e-9)
    model = wheel["side"]
    mu = friction(model, load) if isinstance(model, Mapping) else wheel["mu_static"]
    lengthwise = wheel["mu_roll"] + brake * (mu - wheel["mu_roll"])
    sideways = side(wheel)(Vy, ahead, load) * fade
    if aircraft.get("combine", "box") == "box":
        lengthwise *= Vx / (Vx**4 + width**4) ** 0.25
    else:  # a wheel rolls until its brake would ask for more than a locked one makes
        locked = mu * Vx / max(speed, 1e-30) * fade
        lengthwise = float(np.clip(locked, -lengthwise, lengthwise))
        left = np.sqrt(max(mu**2 - lengthwise**2, 0.0))
        slide = brake * mu * Vy / max(speed, 1e-30) * fade
        sideways = max(sideways, slide) if Vy > 0 else min(sideways, slide)
        sideways = float(np.clip(sideways, -left, left))
    flat = -load * (lengthwise * heading + sideways * right)
    force = to_ground.T @ [*flat, -load]
    return Contact(
        load,
        lengthwise * load,
        sideways * load,
        np.arctan2(Vy, ahead),
        force,
        np.cross(foot, force),
    )


class Roll(NamedTuple):
    """An aircraft with its inputs over time."""

    aircraft: Mapping[str, Any]
    inputs: Mapping[str, Signal] = {}

    def at(self, t: float) -> dict[str, float]:
        """The inputs at a time."""
        return {name: value(self.inputs.get(name, 0.0), t) for name in INPUTS}

    def contacts(self, t: float, x: Vector) -> list[Contact]:
        """The wheels at a state."""
        inputs = self.at(t)
        brakes = {"LEFT": inputs["brake_left"], "RIGHT": inputs["brake_right"]}
        swivels = iter(x[12:].reshape(-1, 2))
        found = []
        for wheel in self.aircraft["wheels"]:
            turned, turning = np.radians(wheel["toe_deg"]), 0.0
            if "swivel" in wheel:
                angle, rate = next(swivels)
                turned += angle
                turning = wheel["swivel"]["trail"] * rate
            elif wheel.get("castered") == 2:  # JSBSim's, by the body-axis velocity of its foot
                turned += caster(wheel, x)
            else:
                turned += np.radians(wheel["steer_gain"] * inputs["steer_deg"])
            brake = brakes.get(wheel["brake"], 0.0)
            found.append(contact(wheel, self.aircraft, x, turned, turning, brake))
        return found

    def rates(self, t: float, x: Vector) -> Vector:
        """The derivative of the state."""
        c, inputs = self.aircraft, self.at(t)
        to_ground = rotation(*x[3:6])
        velocity, rates = x[6:9], x[9:12]
        wind = to_ground.T @ [inputs["wind_x"], inputs["wind_y"], 0.0]
        aloft = air(c, velocity - wind, rates, inputs)
        wheels = self.contacts(t, x)
        gust = np.array([0.0, inputs["F_disturbance"], 0.0])
        force = aloft.force + sum(w.force for w in wheels) + gust + c["m"] * c["g"] * to_ground[2]
        moment = aloft.moment + sum(w.moment for w in wheels)
        moment = moment + np.cross(c.get("disturbed_at", (0.0, 0.0, 0.0)), gust)
        inertia = np.diag([c["Ixx"], c["Iyy"], c["Izz"]])
        inertia[0, 2] = inertia[2, 0] = -c["Ixz"]
        phi, theta = x[3:5]
        p, q, r = rates
        euler = [
            p + np.tan(theta) * (q * np.sin(phi) + r * np.cos(phi)),
            q * np.cos(phi) - r * np.sin(phi),
            (q * np.sin(phi) + r * np.cos(phi)) / np.cos(theta),
        ]
        turn = np.linalg.solve(inertia, moment - np.cross(rates, inertia @ rates))
        own = swivel_rates(c, x[12:], wheels, inputs["steer_deg"])
        return np.concatenate(
            [to_ground @ velocity, euler, force / c["m"] - np.cross(rates, velocity), turn, own]
        )


def caster(wheel: Mapping[str, Any], x: Vector) -> float:
    """The angle of JSBSim's caster."""
    to_ground = rotation(*x[3:6])
    foot = np.array([wheel["x"], wheel["y"], wheel["z"]])
    foot[2] -= (x[2] + to_ground[2] @ foot) / to_ground[2, 2]
    u, v, _ = x[6:9] + np.cross(x[9:12], foot)
    return float(np.arctan2(v, abs(u)))


def swivel_rates(
    aircraft: Mapping[str, Any], own: Vector, contacts: list[Contact], steer: float
) -> Vector:
    """I chi'' + c chi' + k (chi - ratio pedal) = t F, the spring letting go at its break-out."""
    rates: list[float] = []
    swivels = iter(own.reshape(-1, 2))
    for wheel, at in zip(aircraft["wheels"], contacts, strict=True):
        if "swivel" not in wheel:
            continue
        s = wheel["swivel"]
        angle, rate = next(swivels)
        wound = angle - np.radians(wheel["steer_gain"] * steer)
        spring = s["k"] * wound
        if "break_out" in s:
            out = s["break_out"]
            spring /= 1 + np.exp(min((wound**2 - out**2) / (s["rounding"] * out**2), 500.0))
        if "stop" in s:
            spring += s["stop_k"] * (angle - np.clip(angle, -s["stop"], s["stop"]))
        rates += [rate, (s["trail"] * at.left - s["c"] * rate - spring) / s["I"]]
    return np.array(rates)


def rest(aircraft: Mapping[str, Any]) -> tuple[float, float]:
    """Height Z of the CG and attitude theta on the legs, without air."""

    def unbalanced(unknown: Vector) -> Vector:
        x = np.zeros(12)
        x[2], x[4] = unknown
        wheels = [contact(wheel, aircraft, x, 0.0, 0.0, 0.0) for wheel in aircraft["wheels"]]
        force = sum(w.load for w in wheels) - aircraft["m"] * aircraft["g"]
        return np.array([force, sum(w.moment[1] for w in wheels)])

    found = root(unbalanced, [-0.95 * max(w["z"] for w in aircraft["wheels"]), 0.0], tol=1e-13)
    return float(found.x[0]), float(found.x[1])


def simulate(
    aircraft: Mapping[str, Any],
    inputs: Mapping[str, Signal],
    times: Vector,
    speed: float,
    drift: float = 0.0,
    yaw_rate: float = 0.0,
    rtol: float = 1e-8,
) -> tuple[Vector, Vector]:
    """States and wheel loads at the times, from the rest on the legs but rolling.

    `speed` and `drift` are along and to the right of the runway.
    """
    roll = Roll(aircraft, inputs)
    Z, theta = rest(aircraft)
    x = np.zeros(12 + 2 * sum("swivel" in w for w in aircraft["wheels"]))
    x[[2, 4, 11]] = Z, theta, yaw_rate
    x[6:9] = rotation(0.0, theta, 0.0).T @ [speed, drift, 0.0]
    kinks = {c for signal in inputs.values() for c in corners(signal) if times[0] < c < times[-1]}
    kinks |= {times[0], times[-1]}
    edges = sorted(kinks)
    states = np.empty((len(times), len(x)))
    for start, stop in pairwise(edges):
        inside = (times >= start) & (times <= stop)
        wanted = np.unique(np.append(times[inside], stop))
        # inputs are those after the corner at its start, those before at its end
        last = np.nextafter(stop, start)
        run = solve_ivp(
            lambda t, x, last=last: roll.rates(min(t, last), x),
            (start, stop),
            x,
            "LSODA",
            wanted,
            rtol=rtol,
            atol=1e-9,
        )
        assert run.success, run.message
        states[inside] = run.y.T[np.isin(wanted, times[inside])]
        x = run.y[:, -1]
    loads = np.array(
        [[w.load for w in roll.contacts(t, s)] for t, s in zip(times, states, strict=True)]
    )
    return states, loads
