"""What a roll cannot be is said, with the way out; what it can be at the edge is computed."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import groundroll as gr
from groundroll.aircraft.file import AircraftFileError, locate

ROLLS = ("landing_roll", "rollout")
TAIL, NOSE = gr.Aircraft.load("cessna-170"), gr.Aircraft.load("cessna-172p")


def rolled(plane: gr.Aircraft, model: str = "landing_roll", **values: Any) -> gr.Trajectory:
    return gr.simulate(plane, model, **{"t": 0.5, "samples": 6, **values})


# --- Inputs have a range --------------------------------------------------------------------------


@pytest.mark.parametrize("model", ROLLS)
@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"brake_left": 1.5}, "brake_left must be from 0 to 1, but it is 1.5"),
        ({"brake_right": -0.01}, "brake_right must be from 0 to 1, but it is -0.01"),
        ({"brake_left": [0.5, 1.0, 1.1]}, "but it is 1.1"),
        ({"pedal": "150 %"}, "pedal must be from -1 to 1, but it is 1.5"),
        ({"brake_left": gr.signals.step(1.2, 0.3)}, "but it is 1.2"),
        ({"brake_left": gr.signals.sampled([0.0, 0.21, 0.22, 1.0], [0, 0, -0.5, 0])}, "is -0.5"),
        ({"pedal": gr.signals.of_time(lambda t: 4 * t - 0.5)}, "must be from -1 to 1"),
    ],
)
def test_an_input_beyond_its_range_is_refused(
    model: str, values: dict[str, Any], words: str
) -> None:
    with pytest.raises(gr.GroundrollError, match=words):
        rolled(TAIL, model, **values)


@pytest.mark.parametrize("model", ROLLS)
def test_an_input_beyond_its_range_is_refused_by_whoever_takes_one(model: str) -> None:
    with pytest.raises(gr.GroundrollError, match="from 0 to 1"):
        gr.linearize(TAIL, model, at={"brake_left": 1.5})
    with pytest.raises(gr.GroundrollError, match="from 0 to 1"):
        gr.ensemble(TAIL, model=model, brake_left=[0.0, 1.5], t=0.1)


@pytest.mark.parametrize("model", ROLLS)
def test_ends_of_a_range_and_roundings_are_in_it(model: str) -> None:
    """And the derivatives are there."""
    for brake in (0.0, 1.0, -1e-12, 1 + 1e-12):
        lin = gr.linearize(TAIL, model, at={"brake_left": brake, "u": 10.0})
        assert np.isfinite(lin.A).all()
        assert np.isfinite(lin.B).all()
    # a fitted ramp may pass its end by what fitting leaves
    rolled(TAIL, model, brake_left=gr.signals.of_time(lambda t: np.minimum(1.0, 2 * t)))


# --- Standing, creeping, backing ------------------------------------------------------------------


@pytest.mark.parametrize("model", ROLLS)
def test_a_standing_aircraft_stands(model: str) -> None:
    run = rolled(TAIL, model, speed=0.0)
    assert np.abs(run["u"]).max() < 1e-4
    assert run.events["stopped"] == 0.0
    assert np.isfinite(gr.linearize(TAIL, model, at={"u": 0.0}).A).all()


@pytest.mark.parametrize("model", ROLLS)
@settings(max_examples=25, deadline=None)
@given(st.floats(-1.0, 1.0), st.floats(-0.1, 0.1), st.floats(0.0, 1.0))
def test_derivatives_are_there_around_rest(model: str, u: float, v: float, brake: float) -> None:
    at = {"u": u, "v": v, "brake_left": brake, "brake_right": brake}
    lin = gr.linearize(TAIL, model, at=at)
    assert np.isfinite(lin.A).all()
    assert np.isfinite(lin.B).all()


# --- On its wheels --------------------------------------------------------------------------------


@pytest.mark.parametrize("change", [{"k_main": 10.0}, {"k_third": 10.0}, {"sag_main": 2.0}])
def test_legs_that_cannot_carry_it_are_named(change: dict[str, float]) -> None:
    with pytest.raises(gr.GroundrollError, match=r"cannot carry it.*main_leg_deflection"):
        rolled(TAIL, **change)


def test_a_wheel_in_the_air_at_rest_is_named() -> None:
    """The main wheels of a taildragger behind its CG: it lies on its nose."""
    legs = {"k_main": 2e4, "c_main": 1e3, "k_third": 3e3, "c_third": 1e2, "f": 0.95}
    with pytest.raises(gr.GroundrollError, match=r"not stand on all its wheels.*third wheel is"):
        rolled(TAIL.replace(x_main=TAIL["x_cg"] + 0.05, **legs))


@pytest.mark.parametrize("depth", [0.5, -0.2, [-0.9, -0.1]])
def test_a_start_under_the_runway_is_refused(depth: Any) -> None:
    with pytest.raises(gr.GroundrollError, match=r"depth \(Z0\).*wheel.*m under the runway"):
        rolled(TAIL, Z0=depth)


def test_a_pitch_that_is_given_starts_at_the_depth_of_the_rest() -> None:
    rest = rolled(TAIL)
    pitched = rolled(TAIL, theta0=float(rest["theta"][0]) + 0.01)
    assert pitched["Z"][0] == rest["Z"][0]
    assert pitched["theta"][0] == pytest.approx(rest["theta"][0] + 0.01)


def test_wheels_of_a_level_body_lift_when_nothing_is_left_to_carry() -> None:
    """One after the other as it speeds up, the tail first; all of them beyond lift-off."""
    run = rolled(TAIL, "rollout", u0=20.0, thrust=12_000.0, t=4.0, samples=401, elevator=0.2)
    names = [f"wheel_lifted_{w}" for w in ("left", "right", "third")]
    for name in names:
        when, load = float(run.events[name]), run[f"Fz_{name.rpartition('_')[2]}"]
        assert np.isfinite(when)
        assert load[run.t > when][0] == 0.0
        assert load[run.t < when - 0.01].min(initial=np.inf) > 0
    gone = rolled(TAIL, "rollout", u0=70.0)
    assert [float(gone.events[name]) for name in names] == [0.0, 0.0, 0.0]


def test_a_tricycle_stands_before_its_main_wheels() -> None:
    """It noses over its nose wheel, and not where it starts; a taildragger over its main wheels."""
    assert np.isinf(rolled(NOSE).events["nosed_over"])
    assert np.isinf(rolled(TAIL).events["nosed_over"])
    ahead, depth = (float(NOSE[s]) for s in ("a_third", "z_third"))
    over = np.arctan2(ahead, depth)
    for part, happens in ((0.99, False), (1.01, True)):
        run = rolled(NOSE, Z0=-3.0, theta0=-over * part, u0=1.0, t=1e-4)
        assert np.isfinite(run.events["nosed_over"]) == happens


# --- Derivatives of the whole, or of what is left -------------------------------------------------


def test_a_fin_that_counts_twice_is_refused() -> None:
    for derivative, surface in (("Cn_beta", "fin_apart"), ("Cm_alpha", "tailplane_apart")):
        plane = TAIL.replace(**{derivative: -0.07})
        with pytest.raises(
            gr.GroundrollError, match=f"{surface}: found nothing beside {derivative}"
        ):
            rolled(plane)
        for apart in (0.0, 1.0):
            rolled(plane.replace(**{surface: apart}))


def test_a_fin_that_is_nowhere_or_half_is_refused() -> None:
    with pytest.raises(gr.GroundrollError, match=r"0 and no derivatives.*Cn_beta"):
        rolled(TAIL, fin_apart=0)
    with pytest.raises(gr.GroundrollError, match=r"found 0\.5; expected 1 if"):
        rolled(TAIL, fin_apart=0.5)


def test_a_file_with_both_kinds_of_derivatives_is_refused(tmp_path: Path) -> None:
    """With the place to look at; the thesis's models do not care, but a file says one thing."""
    text = Path(str(locate("cessna-170"))).read_text()
    path = tmp_path / "both.toml"
    path.write_text(text.replace("[aero]", "[aero]\nCn_beta = 0.07"))
    with pytest.raises(AircraftFileError, match="fin_apart: found nothing beside Cn_beta"):
        gr.Aircraft.load(path)


def test_the_whole_and_the_whole_less_the_fin_are_one_aircraft() -> None:
    """The fin's own force, at small angles and without a slipstream, as derivatives instead."""
    S, span, b, slope, Ap = (float(TAIL[s]) for s in ("S_wing", "b_wing", "b", "CL_gamma", "Ap"))
    volume = Ap * slope / S
    tau = float(TAIL["tau_rudder"])
    whole = {
        "CY_beta": -volume,
        "CY_r": volume * 2 * b / span,
        "CY_rudder": volume * tau,
        "Cn_beta": volume * b / span,
        "Cn_r": -volume * 2 * (b / span) ** 2,
        "Cn_rudder": -volume * tau * b / span,
    }
    flat = TAIL.replace(z_fin=0.0, theta_ground=0.0)
    apart = gr.linearize(flat, "rollout", at={"u": 20.0})
    held = gr.linearize(flat.replace(fin_apart=0.0, **whole), "rollout", at={"u": 20.0})
    np.testing.assert_allclose(held.A, apart.A, rtol=1e-3, atol=1e-4)
    np.testing.assert_allclose(held.B, apart.B, rtol=1e-3, atol=1e-4)


@pytest.mark.parametrize("model", ROLLS)
def test_a_wing_area_that_is_missing_is_asked_for_once(model: str) -> None:
    with pytest.raises(gr.GroundrollError) as problem:
        rolled(TAIL.replace(S_wing=None), model)
    assert str(problem.value).count("wing_area (S_wing) is not given") == 1
