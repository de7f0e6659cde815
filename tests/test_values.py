"""What is given to a call by name: parameters, inputs and initial states of any model."""

from __future__ import annotations

import numpy as np
import pytest

import groundroll as gr
from groundroll.aircraft.values import given
from groundroll.model.models import Model

PLANE = gr.Aircraft.load("brott-physical")
MODEL = Model.load("nonlinear")


def test_each_name_finds_its_kind() -> None:
    found = given(
        PLANE,
        MODEL,
        {"speed": "50 kt", "disturbance": "70 lbf", "v0": "1 kt", "heading": "3 deg"},
        "here",
    )
    assert found.aircraft["u"] == pytest.approx(25.72222, rel=1e-6)
    assert found.inputs["F_disturbance"] == pytest.approx(311.3755, rel=1e-6)
    assert found.states["v"] == pytest.approx(0.514444, rel=1e-5)
    assert found.states["psi"] == pytest.approx(np.radians(3.0))


def test_arrays_go_through() -> None:
    found = given(PLANE, MODEL, {"Ct": [1.0, 2.0], "v0": [[1.0], [2.0]]}, "here")
    assert found.aircraft["Ct"].shape == (2,)
    assert found.states["v"].shape == (2, 1)


def test_what_a_parameter_follows_from_may_be_given() -> None:
    found = given(PLANE, MODEL, {"cg_station": "14 in"}, "here")
    assert found.aircraft["a"] == pytest.approx(0.6096)


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"sped": 3.0}, "did you mean speed"),
        ({"u": 3.0, "speed": 4.0}, "u and speed are the same parameter"),
        ({"disturbance": "3 m"}, "disturbance"),
        ({"v0": np.nan}, "v0 must be finite"),
        ({"disturbance": np.sin}, "disturbance must be constant here"),
        ({"v": 0.3}, "did you mean"),
    ],
)
def test_what_cannot_be_is_named(values: dict[str, object], words: str) -> None:
    with pytest.raises(gr.GroundrollError, match=words):
        given(PLANE, MODEL, values, "here")


def test_a_state_is_called_by_its_symbol_at_an_operating_point() -> None:
    found = given(PLANE, MODEL, {"v": 0.3, "yaw_rate": "2 deg/s"}, "here", bare_states=True)
    assert found.states["v"] == 0.3
    assert found.states["r"] == pytest.approx(np.radians(2.0))


def test_all_that_is_missing_is_listed_at_once() -> None:
    bare = gr.Aircraft("bare", {"m": 700.0})
    with pytest.raises(gr.GroundrollError) as problem:
        bare.parameters("nonlinear")
    message = str(problem.value)
    assert message.startswith("aircraft bare lacks what the model nonlinear needs:")
    for word in ("yaw_inertia", "air_density", "tail_area", "magic_formula_B", "gravity"):
        assert word in message
