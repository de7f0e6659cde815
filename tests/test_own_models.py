"""Own models: the car of the textbook, a car with four wheels, a tail with a state of its own."""

from __future__ import annotations

import control
import numpy as np
import pytest
from own_models import CAR, FOUR, LAGGING, PLANES, own
from scipy.integrate import solve_ivp

import groundroll as gr

m, Izz, u, a, b, Cf, Cr = 1500.0, 2500.0, 30.0, 1.2, 1.6, 1.2e5, 1.5e5


def textbook() -> tuple[np.ndarray, np.ndarray]:
    """A and B of the single-track car, SAE axes (Milliken, ch. 5)."""
    A = [
        [-(Cf + Cr) / (m * u), -(a * Cf - b * Cr) / (m * u) - u],
        [-(a * Cf - b * Cr) / (Izz * u), -(a**2 * Cf + b**2 * Cr) / (Izz * u)],
    ]
    return np.array(A), np.array([[Cf / m], [a * Cf / Izz]])


def test_the_single_track_car_is_the_textbooks() -> None:
    lin = gr.linearize(CAR, own("single_track"))
    A, B = textbook()
    np.testing.assert_allclose(lin.A, A, rtol=1e-13)
    np.testing.assert_allclose(lin.B, B, rtol=1e-13)
    assert lin.states == ("v", "r")
    assert lin.inputs == ("steering",)


def test_its_steady_turn_has_the_characteristic_speed() -> None:
    gradient = m / (a + b) * (b / Cf - a / Cr)  # understeers
    characteristic = np.sqrt((a + b) / gradient)
    lin = gr.linearize(CAR, own("single_track"), speed=[characteristic / 2, characteristic])
    gain = -np.linalg.solve(lin.A, lin.B)[:, 1, 0]
    # at the characteristic speed the gain is half that of a neutral car
    assert gain[1] == pytest.approx(characteristic / (a + b) / 2, rel=1e-12)
    assert gain[0] == pytest.approx(characteristic / 2 / (a + b) / 1.25, rel=1e-12)


def test_an_oversteering_car_has_a_critical_speed() -> None:
    loose = CAR.with_own({**CAR.own, "C_rear": 7e4})
    gradient = m / (a + b) * (b / Cf - a / 7e4)
    critical = np.sqrt(-(a + b) / gradient)
    speeds = critical * np.array([0.999, 1.001])
    lin = gr.linearize(loose, own("single_track"), speed=speeds)
    assert lin.decay_rate[0] > 0 > lin.decay_rate[1]


def test_its_step_response_is_that_of_another_program() -> None:
    found = gr.step_response(CAR, own("single_track"), "r", "steering", size="1 deg", t=2.0)
    A, B = textbook()
    system = control.StateSpace(A, B * np.radians(1.0), [[0.0, 1.0]], 0.0)
    _, expected = control.step_response(system, found.t)
    np.testing.assert_allclose(found.values, expected, atol=1e-9)


def test_four_equal_wheels_are_two() -> None:
    four = gr.linearize(FOUR, own("four_wheels"))
    two = gr.linearize(CAR, own("single_track"))
    assert four.states == ("u", "v", "r")
    np.testing.assert_allclose(four.A[1:, 1:], two.A, rtol=1e-12)
    np.testing.assert_allclose(four.B[1:, :1], two.B, rtol=1e-12)
    np.testing.assert_allclose(four.A[0], 0.0, atol=1e-12)
    # brakes on one side turn the car to that side
    assert four.B[2, 1] < 0 < four.B[2, 2]
    assert four.B[2, 1] == pytest.approx(-four.B[2, 2])


def test_several_inputs_are_given_by_name_with_units() -> None:
    at = {"speed": "72 km/h", "yaw_rate": "5 deg/s", "steering": "1 deg", "brake_left": 0.2}
    lin = gr.linearize(FOUR, own("four_wheels"), at=at)
    assert lin.at["u"] == pytest.approx(20.0)
    assert lin.at["steering"] == pytest.approx(np.radians(1.0))
    assert lin.at["brake_left"] == 0.2
    many = gr.linearize(FOUR, own("four_wheels"), at=at, steering=np.linspace(-0.1, 0.1, 201))
    assert many.A.shape == (201, 3, 3)
    one = gr.linearize(FOUR, own("four_wheels"), at=at, steering=0.1)
    np.testing.assert_allclose(many.A[-1], one.A, rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(many[-1].B, one.B, rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize("name", PLANES)
def test_jacobians_are_those_of_complex_steps(name: str) -> None:
    model, plane = own(name), PLANES[name]
    lin = gr.linearize(plane, model, at=dict.fromkeys(model.dynamic[-2:], 0.05))
    p = plane.parameters(model)
    x = np.array([float(lin.at.get(s, 0.0)) for s in model.states])
    rhs = model.function("rhs")
    h = 1e-6
    for k, state in enumerate(model.dynamic):
        step = h * (np.array(model.states) == state)
        high, low = (np.array(rhs(x + sign * step, 0, p)).ravel() for sign in (1, -1))
        rows = [model.states.index(s) for s in model.dynamic]
        slope = ((high - low) / (2 * h))[rows]
        np.testing.assert_allclose(lin.A[:, k], slope, rtol=1e-6, atol=1e-6 * np.abs(lin.A).max())


def test_a_state_of_a_part_is_a_state_of_the_model() -> None:
    model = own("lagging")
    assert model.dynamic == ("v", "r", "late_tail")
    lin = gr.linearize(LAGGING, model)
    assert lin.eigenvalues.shape == (3,)
    exact = np.linalg.eigvals(lin.A)
    np.testing.assert_allclose(sorted(lin.eigenvalues.real), sorted(exact.real), rtol=1e-12)
    sensitivities = lin.sensitivities()
    h = 1e-6
    near = [gr.linearize(LAGGING, model, lag=0.05 * (1 + sign * h)).eigenvalues for sign in (1, -1)]
    slope = (near[0] - near[1]) / (2 * 0.05 * h)
    np.testing.assert_allclose(sensitivities["lag"], slope, rtol=1e-5)


def test_a_step_response_of_three_states_is_scipys() -> None:
    model = own("lagging")
    lin = gr.linearize(LAGGING, model)
    found = gr.step_response(lin, "yaw_rate", "push", size="100 N", t=1.0, samples=11)
    B = 100.0 * lin.B[:, 0]
    run = solve_ivp(
        lambda t, x: lin.A @ x + B, (0, 1), np.zeros(3), "DOP853", found.t, rtol=1e-11, atol=1e-12
    )
    np.testing.assert_allclose(found.values, run.y[1], atol=1e-9)


def test_all_that_a_model_lacks_is_listed() -> None:
    with pytest.raises(gr.GroundrollError) as problem:
        gr.linearize(gr.Aircraft("bare", {"m": 1.0}), own("single_track"))
    for name in ("l_front", "C_front", "l_rear", "C_rear", "Izz"):
        assert f"({name}" in str(problem.value)


def test_a_misspelt_parameter_is_named() -> None:
    wrong = CAR.with_own({**CAR.own, "C_reer": 1.0})
    with pytest.raises(gr.GroundrollError, match=r"no parameter 'C_reer'; it has C_rear"):
        gr.linearize(wrong, own("single_track"))


def test_closed_forms_are_not_there_for_every_model() -> None:
    with pytest.raises(gr.GroundrollError, match=r"unknown argument .sterring.*steering"):
        gr.linearize(CAR, own("single_track"), sterring=0.1)
