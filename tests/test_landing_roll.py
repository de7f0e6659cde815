"""The landing roll against its witnesses: JSBSim's stored runs, and the oracle."""

from __future__ import annotations

import copy
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from jsbsim_live import disagreements, reference, stored
from oracle_roll import STATES, Roll
from rolling import (
    JSBSIM_TIRE,
    Array,
    Compiled,
    at_rest,
    landing_roll,
    on_jsbsim_tires,
    parameters,
    simulate,
)


def _rolled(compiled: Compiled, name: str, **changes: float) -> dict[str, Any]:
    run = stored()[name]
    times = reference(run)["t"]
    return simulate(compiled, run["config"], run["inputs"], times, at_rest(run), **changes)


@pytest.mark.parametrize("name", ["G3", "G8"])
def test_jsbsim_comes_to_rest_alike(name: str) -> None:
    """Narrower near rest than explicit steps can follow; `test_stored_rolls` has all eight runs."""
    ours = _rolled(on_jsbsim_tires(), name)
    assert not disagreements(ours, reference(stored()[name]), 0.2 if name != "G8" else 1.0)


def test_the_width_near_rest_is_seen() -> None:
    """A standing aircraft in wind creeps the more the wider friction fades near rest."""
    theirs = reference(stored()["G8"])["psi"][-1]
    errors = [
        abs(_rolled(on_jsbsim_tires(), "G8", v_rest=width)["psi"][-1] - theirs)
        for width in (1e-3, 1e-2, 1e-1)
    ]
    assert np.degrees(errors) == pytest.approx([0.03, 0.32, 3.5], rel=0.2)


# --- The oracle, at random ------------------------------------------------------------------------

small = st.floats(-1.0, 1.0)
part = st.floats(0.0, 1.0)


@st.composite
def aircraft(draw: st.DrawFn) -> dict[str, Any]:
    """An aircraft like a stored one, everything in it changed and all that it can have."""
    plane = copy.deepcopy(stored()["G5"]["config"]) | {"combine": "ellipse", "v_rest": 0.01}
    for key in ("m", "Ixx", "Iyy", "Izz", "rho"):
        plane[key] *= 1 + 0.3 * draw(small)
    plane |= {"Ixz": 50.0 * draw(small), "thrust_z": 0.2 * draw(small), "disc": 1 + draw(part)}
    plane["aero"] |= {key: 0.3 * draw(small) for key in ("CL", "CLa", "Cma", "CYr", "Clr", "Cnda")}
    plane["aero"] |= {"CD": 0.1 * draw(part), "K": 0.1 * draw(part), "CLmax": 0.5 + draw(part)}
    for name, place in (("fin", -4.8), ("tailplane", -4.6)):
        plane[name] = {"x": place + draw(small), "z": 0.5 * draw(small), "S": 2 * draw(part)}
        plane[name] |= {"slope": 2 + draw(part), "CLmax": 0.3 + draw(part), "tau": draw(part)}
    plane["tailplane"] |= {"incidence": 0.05 * draw(small), "downwash": 0.5 * draw(part)}
    plane["disturbed_at"] = (plane["fin"]["x"], 0.0, 0.0)
    toe = draw(small)
    tire = {key: number * (1 + 0.2 * draw(small)) for key, number in JSBSIM_TIRE.items()}
    tire |= {"E1": draw(small), "C1": 1.2 + 0.3 * draw(small), "D1": 1.0, "C5": -1e-5 * draw(part)}
    tire |= {"C3": -1e-4 * draw(part)}
    for wheel, sign in zip(plane["wheels"], (1, -1, 0), strict=True):
        wheel["side"] = tire | {"surface": 0.3 + 0.7 * draw(part)}
        wheel |= {"toe_deg": sign * toe, "mu_roll": 0.05 * draw(part)}
    third = plane["wheels"][2]
    third["side"]["B3"] *= 0.5 + draw(part)
    if draw(st.booleans()):
        third["swivel"] = {
            "I": 0.02 + 0.02 * draw(part),
            "c": draw(part),
            "trail": 0.1 * draw(part),
        }
        third["swivel"] |= {"k": 50 * draw(part), "break_out": 0.3, "rounding": 1 / 20}
        third["swivel"] |= {"stop": 0.8, "stop_k": 200.0}
    return plane


@st.composite
def motion(draw: st.DrawFn) -> dict[str, float]:
    """States about the rest on the legs."""
    sizes = {"X": 9.0, "Y": 9.0, "Z": 0.08, "phi": 0.05, "theta": 0.03, "psi": 3.0, "v": 3.0}
    sizes |= {"u": 15.0, "w": 0.5, "p": 0.3, "q": 0.3, "r": 0.5}
    sizes |= {"chi_third": 1.0, "chi_rate_third": 2.0}
    state = {name: size * draw(small) for name, size in sizes.items()}
    return state | {"Z": state["Z"] - 0.87, "u": 10.0 + state["u"]}


@st.composite
def controls(draw: st.DrawFn) -> dict[str, float]:
    """Inputs of the oracle."""
    sizes = {"steer_deg": 10.0, "rudder": 0.4, "aileron": 0.3, "elevator": 0.3, "thrust": 500.0}
    sizes |= {"wind_x": 5.0, "wind_y": 8.0, "F_disturbance": 300.0}
    brakes = {"brake_left": draw(part), "brake_right": draw(part)}
    return {name: size * draw(small) for name, size in sizes.items()} | brakes


WHEELS = ("left", "right", "third")


def point(
    compiled: Compiled, plane: dict[str, Any], state: dict[str, float], inputs: dict[str, float]
) -> tuple[Array, Array, Array]:
    """The vectors x, u, p of a model."""
    p = compiled.vector("parameters", parameters(plane))
    u = compiled.vector("inputs", {**inputs, "steering": np.radians(inputs["steer_deg"])})
    return compiled.vector("states", state), u, p


def _far_from_corners(shown: dict[str, float], plane: dict[str, Any]) -> bool:
    """Whether nothing is in the narrow range where the model rounds what the oracle does not."""
    touches = [0 < shown[f"depth_{w}"] < 2e-4 for w in WHEELS]
    stalls = [
        abs(abs(shown[lift]) - limit) < 0.11
        for lift, limit in (
            ("CL", plane["aero"]["CLmax"]),
            ("C_L_fin", plane["fin"]["CLmax"]),
            ("C_L_tailplane", plane["tailplane"]["CLmax"]),
        )
    ]
    return not any(touches + stalls)


@settings(max_examples=200)
@given(aircraft(), motion(), controls())
def test_the_oracle_agrees_at_random(
    plane: dict[str, Any], state: dict[str, float], inputs: dict[str, float]
) -> None:
    """Rates and loads, but where corners are rounded."""
    compiled = landing_roll()
    x, u, p = point(compiled, plane, state, inputs)
    shown = compiled.shown(x, u, p)
    assume(_far_from_corners(shown, plane))
    assume(not 0 < abs(state["chi_third"]) - 0.8 < 0.01)
    own = [state[n] for n in ("chi_third", "chi_rate_third") if "swivel" in plane["wheels"][2]]
    at = np.array([*(state[name] for name in STATES), *own])
    oracle = Roll(plane, inputs)
    theirs = dict(
        zip([*STATES, "chi_third", "chi_rate_third"], oracle.rates(0.0, at), strict=False)
    )
    ours = dict(zip((q.name for q in compiled.model.states), compiled.rates(x, u, p), strict=True))
    loads = [w.load for w in oracle.contacts(0.0, at)]
    assert [shown[f"Fz_{w}"] for w in WHEELS] == pytest.approx(loads, abs=0.5, rel=1e-9)
    for name, rate in theirs.items():
        assert ours[name] == pytest.approx(rate, abs=3e-3, rel=1e-3), name
