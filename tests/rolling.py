"""The models of the landing roll for tests: compiled, given an aircraft, and integrated."""

from __future__ import annotations

import copy
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cache
from itertools import pairwise
from math import cos, degrees, radians, sin
from types import ModuleType
from typing import Any

import casadi as ca
import numpy as np
from oracle_roll import Signal, value
from oracle_roll.signals import corners
from scipy.integrate import solve_ivp

from groundroll.derive.core.model import Derivation, Model
from groundroll.derive.emit import pack as emitted
from groundroll.derive.emit.catalogue import Pack
from groundroll.derive.models.landing_roll import LANDING_ROLL
from groundroll.derive.models.rolling import wheels
from groundroll.derive.parts.friction import Tire, alpha, radt
from groundroll.derive.parts.gear import surface
from groundroll.derive.parts.third_wheel import third_wheel

Array = np.ndarray[Any, np.dtype[np.float64]]

#: JSBSim's own wheel as a tire of the thesis whose slip is an angle, its peak 0.8.
JSBSIM_TIRE = {
    "B3": 0.1344 * degrees(1.0),
    "C3": 0.0,
    "B5": 0.8,
    "C5": 0.0,
    "B1": 1 / 2.8,
    "C1": 2.8,
    "D1": 1.0,
    "E1": 1.03,
}


@dataclass(frozen=True)
class Compiled:
    """A model with its right-hand side and outputs."""

    model: Derivation
    rhs: ca.Function
    outputs: ca.Function
    slope: ca.Function

    def vector(self, group: str, values: Mapping[str, float]) -> Array:
        """States, inputs or parameters in order; states and inputs that are not given are zero."""
        names = [q.name for q in getattr(self.model, group)]
        if group == "parameters":
            return np.array([values[name] for name in names], float)
        return np.array([values.get(name, 0.0) for name in names], float)

    def rates(self, x: Array, u: Array, p: Array) -> Array:
        """Time derivatives of the states."""
        return np.array(self.rhs(x, u, p)).ravel()

    def shown(self, x: Array, u: Array, p: Array) -> dict[str, float]:
        """Outputs by symbol."""
        found = np.array(self.outputs(x, u, p)).ravel()
        return dict(zip((q.name for q in self.model.outputs), found, strict=True))


def compiled(model: Model) -> Compiled:
    """A model through everything that makes a pack of it, in CasADi's virtual machine."""
    derived = model.derive()
    pack = Pack(model.name, model.summary, (), derived)
    sources = {f"{m.name}.py": emitted._module_source(pack, m) for m in pack.all_modules}
    module: ModuleType = emitted._load(sources)["model"]
    rhs = module.rhs()
    arguments = [ca.SX.sym(name, rhs.size1_in(n)) for n, name in enumerate("xup")]
    by_x = ca.densify(ca.jacobian(rhs(*arguments), arguments[0]))
    return Compiled(derived, rhs, module.outputs(), ca.Function("slope", arguments, [by_x]))


@cache
def landing_roll() -> Compiled:
    """The landing roll as it ships."""
    return compiled(LANDING_ROLL)


def with_tires(main: Callable[[str], Tire], third: Tire) -> Compiled:
    """The landing roll on other tires."""
    rolling = wheels(third_wheel(), main, third)
    return compiled(replace(LANDING_ROLL, parts=[*rolling, *LANDING_ROLL.parts[len(rolling) :]]))


@cache
def on_jsbsim_tires() -> Compiled:
    """The landing roll on JSBSim's own wheels, whose slip is an angle."""
    return with_tires(
        lambda name: radt(surface(name), measure=alpha),
        radt(surface("third"), "third", measure=alpha),
    )


#: What no stored run has: each part is there, and does nothing.
ABSENT = {
    "break_out": 1.0,
    "stop": 10.0,
    "k_stop": 0.0,
    "k_swivel": 0.0,
    "swivels": 0.0,
    "trail": 0.0,
    "I_swivel": 1.0,
    "c_swivel": 1.0,
    "steering_ratio": 0.0,
    "theta_ground": 0.0,
    "surface_left": 1.0,
    "surface_right": 1.0,
    "surface_third": 1.0,
    "rudder_max": 0.0,
    "A_disc": 2.5,
    "b": 4.8,
    "z_fin": 0.0,
    "fin_apart": 0.0,
    "Ap": 1.0,
    "CL_gamma": 3.0,
    "CL_fin": 1.0,
    "tau_rudder": 0.5,
    "x_h": -4.8,
    "z_h": 0.0,
    "downwash": 0.0,
    "i_h": 0.0,
    "tau_elevator": 0.5,
    "CL_h": 3.0,
    "CL_h_max": 1.0,
    "S_h": 1.0,
    "tailplane_apart": 0.0,
    "v_stop": 0.1,
    "runway_width": 20.0,
    "psi_loop": 1.5,
    "x_tip": 0.0,
    "z_tip": -1.0,
    "propeller_diameter": 1.9,
    "x_propeller": 2.0,
}

#: Keys of the oracle's derivatives -> parameters.
DERIVATIVES = {
    "S": "S_wing",
    "b": "b_wing",
    "cbar": "c_wing",
    "CL": "CL_0",
    "CLa": "CL_alpha",
    "CD": "CD_0",
    "CLmax": "CL_max",
    "K": "K_drag",
    "CYb": "CY_beta",
    "CYr": "CY_r",
    "CYdr": "CY_rudder",
    "Clb": "Cl_beta",
    "Clp": "Cl_p",
    "Clr": "Cl_r",
    "Clda": "Cl_aileron",
    "Cm0": "Cm_0",
    "Cma": "Cm_alpha",
    "Cmq": "Cm_q",
    "Cmde": "Cm_elevator",
    "Cnb": "Cn_beta",
    "Cnr": "Cn_r",
    "Cndr": "Cn_rudder",
    "Cnda": "Cn_aileron",
}


def parameters(aircraft: Mapping[str, Any]) -> dict[str, float]:
    """Parameters of the model, of an aircraft of the oracle's."""
    left, right, third = aircraft["wheels"]
    found = dict(ABSENT) | {key: aircraft[key] for key in ("m", "g", "rho", "Ixx", "Iyy", "Izz")}
    found |= {"Ixz": aircraft["Ixz"], "v_rest": aircraft.get("v_rest", 1e-4)}
    found |= {"a": left["x"], "track": 2 * right["y"], "z_main": left["z"]}
    found |= {"a_third": third["x"], "z_third": third["z"], "toe": radians(left["toe_deg"])}
    for wheel, leg, name in (
        (left, "main", "left"),
        (right, "main", "right"),
        (third, "third", "third"),
    ):
        found |= {f"k_{leg}": wheel["k"], f"c_{leg}": wheel["c"]}
        found[f"mu_roll_{name}"] = wheel["mu_roll"]
        tire = dict(wheel["side"]) if isinstance(wheel["side"], Mapping) else dict(JSBSIM_TIRE)
        found[f"surface_{name}"] = tire.pop("surface", 1.0)
        found |= {key + "_third" * (leg == "third"): number for key, number in tire.items()}
    found |= {"CL_max": 1e3, "K_drag": 0.0, "CY_r": 0.0, "Cl_r": 0.0, "Cn_aileron": 0.0}
    found |= {DERIVATIVES[key]: number for key, number in aircraft["aero"].items()}
    found["z_thrust"] = aircraft.get("thrust_z", 0.0)
    if "disturbed_at" in aircraft:
        found["b"] = -aircraft["disturbed_at"][0]
    if "fin" in aircraft:
        fin, tail = aircraft["fin"], aircraft["tailplane"]
        found |= {"fin_apart": 1.0, "tailplane_apart": 1.0, "A_disc": aircraft["disc"]}
        found |= {"b": -fin["x"], "z_fin": fin["z"], "Ap": fin["S"], "CL_gamma": fin["slope"]}
        found |= {"CL_fin": fin["CLmax"], "tau_rudder": fin["tau"]}
        found |= {"x_h": tail["x"], "z_h": tail["z"], "S_h": tail["S"], "CL_h": tail["slope"]}
        found |= {"CL_h_max": tail["CLmax"], "tau_elevator": tail["tau"]}
        found |= {"i_h": tail["incidence"], "downwash": tail["downwash"]}
    if "swivel" in third:
        swivel = third["swivel"]
        found |= {"swivels": 1.0, "trail": swivel["trail"], "I_swivel": swivel["I"]}
        found |= {"c_swivel": swivel["c"], "k_swivel": swivel["k"], "k_stop": swivel["stop_k"]}
        found |= {"break_out": swivel["break_out"], "stop": swivel["stop"]}
    if third.get("castered"):  # light, and well damped
        found |= {"swivels": 1.0, "trail": 0.05, "I_swivel": 0.01, "c_swivel": 0.05}
    return found


def inputs_at(inputs: Mapping[str, Signal], t: float) -> dict[str, float]:
    """The inputs of the oracle as those of the model."""
    found = {name: value(signal, t) for name, signal in inputs.items()}
    found["steering"] = radians(found.pop("steer_deg", 0.0))
    return found


def simulate(
    compiled: Compiled,
    aircraft: Mapping[str, Any],
    inputs: Mapping[str, Signal],
    times: Array,
    start: Mapping[str, float],
    rtol: float = 1e-8,
    method: str = "LSODA",
    **changes: float,
) -> dict[str, Array]:
    """States and outputs at the times, by symbol, from states given at the first of them."""
    p = compiled.vector("parameters", parameters(copy.deepcopy(aircraft)) | changes)
    x = compiled.vector("states", start)

    def at(t: float) -> Array:
        return compiled.vector("inputs", inputs_at(inputs, t))

    kinks = {c for s in inputs.values() for c in corners(s) if times[0] < c < times[-1]}
    states = np.empty((len(times), len(x)))
    for first, last in pairwise(sorted(kinks | {times[0], times[-1]})):
        inside = (times >= first) & (times <= last)
        before = np.nextafter(last, first)
        run = solve_ivp(
            lambda t, x, before=before: compiled.rates(x, at(min(t, before)), p),
            (first, last),
            x,
            method,
            np.unique(np.append(times[inside], last)),
            rtol=rtol,
            atol=1e-9,
            jac=lambda t, x, before=before: np.array(compiled.slope(x, at(min(t, before)), p)),
        )
        assert run.success, run.message
        states[inside] = run.y.T[np.isin(run.t, times[inside])]
        x = run.y[:, -1]
    shown = [compiled.shown(x, at(t), p) for t, x in zip(times, states, strict=True)]
    found = {q.name: column for q, column in zip(compiled.model.states, states.T, strict=True)}
    found |= {name: np.array([row[name] for row in shown]) for name in shown[0]}
    return found | {f"N{n}": found[f"Fz_{w}"] for n, w in enumerate(("left", "right", "third"))}


def at_rest(run: Mapping[str, Any]) -> dict[str, float]:
    """The states with which a stored run starts."""
    theta, speed = radians(run["rest"]["theta_deg"]), run["initial"]["u0"]
    return {
        "Z": run["rest"]["Z"],
        "theta": theta,
        "u": speed * cos(theta),
        "v": run["initial"]["v0"],
        "w": speed * sin(theta),
    }
