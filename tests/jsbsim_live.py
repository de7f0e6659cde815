"""JSBSim beside us: roll an aircraft of its file format over its runway, in SI, for tests.

JSBSim is an independent flight dynamics code. What it needs to be a fair peer stands here once: a
planet that does not turn, with the gravity and the density of the run, a short time step, inputs
written to where they act.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

import jsbsim
import numpy as np
from oracle_roll import Signal, value

FOOT, POUND_FORCE, SLUG = 0.3048, 4.4482216152605, 14.593902937206364
EARTH = 20925646.32546  # the planet's radius, ft
RUNS = Path(__file__).parent / "data" / "landing_roll_runs.json"

#: Channels of a run: track of the CG, velocity and rates in body axes, attitude.
CHANNELS = {
    "x": ("position/from-start-neu-n-ft", FOOT),
    "y": ("position/from-start-neu-e-ft", FOOT),
    "u": ("velocities/u-fps", FOOT),
    "v": ("velocities/v-fps", FOOT),
    "w": ("velocities/w-fps", FOOT),
    "p": ("velocities/p-rad_sec", 1.0),
    "q": ("velocities/q-rad_sec", 1.0),
    "r": ("velocities/r-rad_sec", 1.0),
    "phi": ("attitude/phi-rad", 1.0),
    "theta": ("attitude/theta-rad", 1.0),
    "psi": ("attitude/psi-rad", 1.0),
}

#: Where an input of the oracle acts in JSBSim, and by which factor.
INPUTS = {
    "brake_left": (("fcs/left-brake-cmd-norm", 1.0),),
    "brake_right": (("fcs/right-brake-cmd-norm", 1.0),),
    "rudder": (("fcs/rudder-pos-rad", 1.0),),
    "aileron": (("fcs/left-aileron-pos-rad", 1.0), ("fcs/right-aileron-pos-rad", -1.0)),
    "elevator": (("fcs/elevator-pos-rad", 1.0),),
    "steer_norm": (("fcs/steer-cmd-norm", 1.0),),
    "thrust": (("external_reactions/thrust/magnitude", 1 / POUND_FORCE),),
    "F_disturbance": (("external_reactions/disturbance/magnitude", 1 / POUND_FORCE),),
    "wind_x": (("atmosphere/wind-north-fps", 1 / FOOT),),
    "wind_y": (("atmosphere/wind-east-fps", 1 / FOOT),),
}


@cache
def stored() -> Mapping[str, Any]:
    """The eight stored runs by their names: aircraft, inputs, and what JSBSim answered."""
    return {run["id"]: run for run in json.loads(RUNS.read_text())["runs"]}


def columns() -> list[str]:
    """What the columns of a stored run are."""
    return list(json.loads(RUNS.read_text())["columns"])


def reference(run: Mapping[str, Any]) -> dict[str, np.ndarray[Any, np.dtype[np.float64]]]:
    """The channels of a stored run, angles in radians; `t` too."""
    named = dict(zip(columns(), np.array(run["jsbsim"]).T, strict=True))
    return {
        name.removesuffix("_deg"): np.radians(c) if name.endswith("_deg") else c
        for name, c in named.items()
    }


def disagreements(
    ours: Mapping[str, Any], theirs: Mapping[str, Any], allowed: float = 1.0
) -> dict[str, str]:
    """The channels that differ by more than a roll may, with what was found.

    Heading within 0.3 % or 0.02 deg, roll angle within 1 % or 0.05 deg, speed within 0.1 % or
    1 mm/s, loads within 1 %: per cent of the largest magnitude in the run. `allowed` multiplies
    them.
    """
    tolerances = {"psi": (3e-3, np.radians(0.02)), "phi": (1e-2, np.radians(0.05))}
    tolerances |= {"speed": (1e-3, 1e-3), "N0": (1e-2, 0.0), "N1": (1e-2, 0.0), "N2": (1e-2, 0.0)}
    found = {}
    for name, (relative, absolute) in tolerances.items():
        mine, other = (
            np.hypot(run["u"], run["v"]) if name == "speed" else run[name] for run in (ours, theirs)
        )
        largest, difference = np.max(np.abs(other)), np.max(np.abs(mine - other))
        if not difference <= allowed * max(relative * largest, absolute):
            found[name] = f"{difference:.4g} of {largest:.4g} ({difference / largest:.2%})"
    return found


def planet(gravity: float) -> str:
    """A planet at rest, with this gravity at its surface in m/s^2."""
    GM = gravity / FOOT * EARTH**2
    return (
        f'<?xml version="1.0"?><planet name="still"><semimajor_axis unit="FT">{EARTH}'
        f'</semimajor_axis><semiminor_axis unit="FT">{EARTH}</semiminor_axis>'
        f'<rotation_rate unit="RAD/SEC">0</rotation_rate><GM unit="FT3/SEC2">{GM!r}</GM>'
        "<J2>0</J2></planet>"
    )


def load(fdm: Any, wheel: int) -> float:
    """The load of a wheel normal to the runway, N: JSBSim gives its force in body axes."""
    unit = fdm.get_ground_reactions().get_gear_unit(wheel)
    phi, theta = fdm["attitude/phi-rad"], fdm["attitude/theta-rad"]
    down = (-np.sin(theta), np.cos(theta) * np.sin(phi), np.cos(theta) * np.cos(phi))
    force = (unit.get_body_x_force(), unit.get_body_y_force(), unit.get_body_z_force())
    return float(-POUND_FORCE * np.dot(down, force))


def roll(
    xml: str,
    inputs: Mapping[str, Signal],
    times: np.ndarray[Any, np.dtype[np.float64]],
    folder: Path,
    *,
    height: float,
    theta: float,
    speed: float,
    drift: float = 0.0,
    density: float = 1.225,
    gravity: float = 9.80665,
    steered: int = 2,
    wheels: int = 3,
    step: float = 1 / 2400,
    targets: Mapping[str, tuple[tuple[str, float], ...]] = INPUTS,
) -> dict[str, np.ndarray[Any, np.dtype[np.float64]]]:
    """Channels at the times (multiples of the step): `CHANNELS`, and `N0`... for the loads.

    Parameters
    ----------
    xml : an aircraft as a JSBSim file
    inputs : by the oracle's names; `steer_deg` turns wheel number `steered`
    height, theta : of the CG above the runway (m) and of the body (rad) at the start
    speed, drift : along and to the right of the runway at the start, m/s
    targets : where inputs act, and by which factors
    """
    name = re.search(r'fdm_config name="([^"]+)"', xml)
    assert name is not None
    (folder / name[1]).mkdir(parents=True, exist_ok=True)
    (folder / name[1] / f"{name[1]}.xml").write_text(xml)
    (folder / "planet.xml").write_text(planet(gravity))

    jsbsim.FGJSBBase().debug_lvl = 0
    fdm = jsbsim.FGFDMExec(str(folder))
    fdm.set_debug_level(0)
    fdm.set_aircraft_path(str(folder))
    assert fdm.load_planet(str(folder / "planet.xml"), False)
    assert fdm.load_model(name[1])
    fdm.set_dt(step)
    fdm["simulation/gravity-model"] = 0
    start = {name: value(inputs.get(name, 0.0), 0.0) for name in ("wind_x", "wind_y")}
    fdm["ic/terrain-elevation-ft"] = 0.0
    fdm["ic/lat-geod-deg"] = fdm["ic/long-gc-deg"] = 0.0
    fdm["ic/h-agl-ft"] = height / FOOT
    fdm["ic/phi-rad"], fdm["ic/theta-rad"], fdm["ic/psi-true-rad"] = 0.0, theta, 0.0
    fdm["ic/vn-fps"], fdm["ic/ve-fps"], fdm["ic/vd-fps"] = speed / FOOT, drift / FOOT, 0.0
    fdm["ic/vw-north-fps"], fdm["ic/vw-east-fps"] = (w / FOOT for w in start.values())
    fdm["atmosphere/override/density"] = density / (SLUG / FOOT**3)

    def apply(t: float) -> None:
        for name, signal in inputs.items():
            if name == "steer_deg":
                fdm[f"fcs/steer-pos-deg[{steered}]"] = value(signal, t)
            else:
                for target, factor in targets[name]:
                    fdm[target] = factor * value(signal, t)

    apply(0.0)
    assert fdm.run_ic()
    rows = []
    for n in range(round(times[-1] / step) + 1):
        if n:
            apply(n * step)
            assert fdm.run()
        if np.any(np.abs(times - n * step) < step / 2):
            rows.append([fdm[target] * factor for target, factor in CHANNELS.values()])
            rows[-1] += [load(fdm, k) for k in range(wheels)]
    names = [*CHANNELS, *(f"N{k}" for k in range(wheels))]
    run = dict(zip(names, np.array(rows).T, strict=True))
    run["psi"] = np.unwrap(run["psi"], period=2 * np.pi)
    run["psi"] -= 2 * np.pi * np.round(run["psi"][0] / (2 * np.pi))
    return run
