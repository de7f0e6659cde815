"""Equilibria of any model: of a car, of a car with brakes, of an aircraft on its legs."""

from __future__ import annotations

import numpy as np
import pytest
from own_models import CAR, FOUR, LAGGING, own
from scipy.optimize import least_squares, root

import groundroll as gr
from groundroll.model.models import Model

PLANE = gr.Aircraft.load("cessna-170")
STRAIGHT = {"speed": "30 kt", "crosswind": "8 kt", "solve_for": ("pedal", "thrust")}


def equilibrium_by_scipy(plane: gr.Aircraft, model: Model, **inputs: float) -> np.ndarray:
    """Dynamic states of a model with a held speed where SciPy finds that nothing accelerates."""
    rhs, p = model.function("rhs"), plane.parameters(model)
    where = [model.states.index(s) for s in model.dynamic]
    u = [inputs.get(s, 0.0) for s in model.inputs]

    def rates(dynamic: np.ndarray) -> np.ndarray:
        x = np.zeros(len(model.states))
        x[where] = dynamic
        return np.array(rhs(x, u, p)).ravel()[where]

    solution = root(rates, np.zeros(len(where)), tol=1e-13)
    assert solution.success
    return np.asarray(solution.x)


def test_a_car_turns_as_scipy_says() -> None:
    model, angles = own("single_track"), np.radians([-2.0, 0.0, 1.0])
    found = gr.trim(CAR, model, steering=angles)
    assert found.count.tolist() == [1, 1, 1]
    assert found.stable.all()
    for k, angle in enumerate(angles):
        expected = equilibrium_by_scipy(CAR, model, steering=angle)
        at = [found[s][k, 0] for s in model.dynamic]
        np.testing.assert_allclose(at, expected, rtol=1e-9, atol=1e-12)


def test_a_car_turns_less_and_less_unlike_its_matrices() -> None:
    model = own("single_track")
    lin = gr.linearize(CAR, model)
    expected = -np.linalg.solve(lin.A, lin.B)[:, 0] * np.radians(1e-3)
    found = gr.trim(CAR, model, steering="1e-3 deg")
    np.testing.assert_allclose([found["v"][0], found["r"][0]], expected, rtol=1e-8)


def test_what_steers_is_found_for_a_turn_that_is_given() -> None:
    model = own("single_track")
    turn = gr.trim(CAR, model, steering="1 deg")
    found = gr.trim(CAR, model, yaw_rate=float(turn["r"][0]), solve_for=["steering"])
    assert float(found["steering"][0]) == pytest.approx(np.radians(1.0), rel=1e-9)
    assert found.point["steering"] == float(found["steering"][0])


def test_a_speed_that_nothing_holds_is_held_by_something_else() -> None:
    model = own("four_wheels")
    found = gr.trim(FOUR, model, speed="20 m/s", steering="1 deg", brake_left=0.1)
    assert found.held == ("u",)
    assert "speed held by something else" in repr(found)
    drift = gr.linearize(FOUR, model, at=found).drift
    assert drift[0] < -0.1
    np.testing.assert_allclose(drift[1:], 0.0, atol=1e-9)


def test_a_model_with_a_state_in_a_part_has_its_trim() -> None:
    model = own("lagging")
    found = gr.trim(LAGGING, model, push="100 N")
    at = [float(found[s][0]) for s in model.dynamic]
    expected = equilibrium_by_scipy(LAGGING, model, push=100.0)
    np.testing.assert_allclose(at, expected, rtol=1e-8, atol=1e-12)


def test_an_aircraft_is_held_straight_in_a_crosswind() -> None:
    found = gr.trim(PLANE, "landing_roll", **STRAIGHT)
    assert found.count == 1
    assert found.held == ()
    assert 0 < float(found["pedal"][0]) < 1
    lin = gr.linearize(PLANE, "landing_roll", at=found)
    np.testing.assert_allclose(lin.drift, 0.0, atol=1e-9)
    assert float(found.decay_rate[0]) == pytest.approx(
        -max(x.real for x in lin.eigenvalues if abs(x) > 1e-9), rel=1e-6
    )
    assert float(found["load_right"][0]) > float(found["load_left"][0]) > 0


def test_it_rolls_on_as_it_was_trimmed() -> None:
    point = gr.trim(PLANE, "landing_roll", speed="30 kt", solve_for=["thrust"]).point
    start = {f"{s}0": point[s] for s in ("u", "w", "Z", "theta")}
    run = gr.simulate(PLANE, "landing_roll", t=10.0, thrust=point["thrust"], **start)
    for s in ("u", "theta", "Z"):
        np.testing.assert_allclose(run[s], point[s], rtol=1e-6)


def test_scipy_goes_to_the_same() -> None:
    found = gr.trim(PLANE, "rollout", **STRAIGHT)
    unknown = tuple(found.searched)
    expected = np.array([float(found[s][0]) for s in unknown])
    scale = np.where(np.array(unknown) == "thrust", 1e3, 1.0)

    def left(x: np.ndarray) -> np.ndarray:
        at = dict(zip(unknown, x * scale, strict=True))
        lin = gr.linearize(PLANE, "rollout", speed="30 kt", crosswind="8 kt", at=at)
        across = at["psi"] + np.arctan2(at["v"], 30 * 1852 / 3600)
        return np.append(lin.drift, across)

    solution = least_squares(left, np.zeros(expected.size), xtol=1e-15, ftol=1e-15, gtol=1e-15)
    np.testing.assert_allclose(solution.x * scale, expected, rtol=1e-6, atol=1e-8)


def test_no_pedal_holds_a_wind_that_is_too_strong() -> None:
    found = gr.trim(PLANE, "rollout", **{**STRAIGHT, "crosswind": "25 kt"})
    assert found.count == 0
    assert "pedal would have to be" in found.reasons[0]
    assert "beyond its range from -1 to 1" in repr(found)
    with pytest.raises(gr.GroundrollError, match="pedal would have to be"):
        _ = found.point
    wider = gr.trim(
        PLANE, "rollout", **{**STRAIGHT, "crosswind": "8 kt"}, within={"pedal": (-1, 0.2)}
    )
    assert wider.count == 0
    assert wider.searched["pedal"] == (-1.0, 0.2)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"solve_for": ("pedal", "thrust", "aileron"), "speed": 15}, "9 conditions, but 11"),
        ({"solve_for": ["pedals"]}, "pedal"),
        ({"solve_for": ("thrust", "thrust")}, "named twice"),
        ({"solve_for": ["thrust"], "thrust": 100.0}, "given as well"),
        ({"within": {"pedal": 3.0}}, "must be a pair"),
        ({"within": {"pedal": (1.0, -1.0)}}, "smaller to a larger"),
        ({"starts": 0}, "starts"),
    ],
)
def test_what_cannot_be_is_named(arguments: dict[str, object], words: str) -> None:
    with pytest.raises(gr.GroundrollError, match=words):
        gr.trim(PLANE, "landing_roll", **arguments)


def test_many_cases_are_each_alone() -> None:
    winds = np.array([0.0, 2.0, 4.0])
    many = gr.trim(PLANE, "rollout", **{**STRAIGHT, "crosswind": winds})
    for k, wind in enumerate(winds):
        one = gr.trim(PLANE, "rollout", **{**STRAIGHT, "crosswind": wind})
        assert one.count == many.count[k] == 1
        np.testing.assert_allclose(many["pedal"][k], one["pedal"], rtol=1e-9, atol=1e-12)


def at_rest(**values: object) -> gr.Trim:
    return gr.trim(PLANE, "landing_roll", speed=0, **values)


def carried(found: gr.Trim) -> dict[str, float]:
    return {s: float(found[f"load_{s}"][0]) for s in ("left", "right", "third")}


def test_it_rests_on_its_legs() -> None:
    found = at_rest()
    assert found.count == 1
    weight = float(PLANE["m"]) * float(PLANE["g"])
    assert sum(carried(found).values()) == pytest.approx(weight, rel=1e-9)
    assert float(found["load_left"][0]) == pytest.approx(float(found["load_right"][0]), rel=1e-9)
    assert found.stable.all()


@pytest.mark.parametrize("brakes", [0.0, 1.0])
def test_it_stands_up_to_the_friction_there_is(brakes: float) -> None:
    """A thrust is held up to rolling resistance, with locked wheels up to mu N of the mains."""
    still = carried(at_rest(thrust=1.0))
    held = 0.02 * sum(still.values())
    if brakes:
        mu = {s: float(PLANE["B5"]) + float(PLANE["C5"]) * still[s] for s in ("left", "right")}
        held += sum((mu[s] - 0.02) * still[s] for s in ("left", "right"))
    given = {"brake_left": brakes, "brake_right": brakes}
    most = 0.95 * held
    assert at_rest(thrust=most, **given).count == 1
    beyond = at_rest(thrust=1.1 * held, **given)
    assert beyond.count == 0
    assert beyond.reasons[0]


def test_brakes_hold_it_in_a_wind_that_rolls_it_away_without() -> None:
    held = at_rest(crosswind="20 kt", brake_left=1, brake_right=1)
    assert held.count == 1
    assert float(held["load_right"][0]) > float(held["load_left"][0])
    for s in ("u", "v", "r"):  # it creeps far below what a wheel does that rolls
        assert abs(float(held[s][0])) < 0.01
    assert "friction does not hold it" in at_rest(crosswind="20 kt").reasons[0]
