"""How late a pilot may be: against the model itself with a true delay, and closed forms."""

from __future__ import annotations

import math

import numpy as np
import pytest

import groundroll as gr
from groundroll.control.delay import Margins, Plant, best_gains, delay_margin
from groundroll.control.pilot import lateral, rolls_at
from groundroll.model.models import as_model

PLANE = gr.Aircraft.load("cessna-170")
MODEL = as_model("rollout")


def rolled(speed: float, gains: tuple[float, float], delay: float, lag: float) -> float:
    """Growth of a small deviation: the model itself, a true delay, Heun's steps."""
    steps = max(40, math.ceil(delay / 0.004))
    h = delay / steps
    plane = PLANE.replace(u=speed)
    p = plane.parameters(MODEL).reshape(-1)
    rhs = MODEL.function("rhs")
    k_pedal, index = MODEL.inputs.index("pedal"), MODEL.states.index
    x = np.zeros(len(MODEL.states))
    x[index("u")], x[index("psi")] = speed, 1e-4
    lever, wanted, psi = 0.0, [0.0] * (steps + 1), []

    def rate(x: np.ndarray, lever: float) -> np.ndarray:
        u = np.zeros(len(MODEL.inputs))
        u[k_pedal] = lever
        f = np.array(rhs(x, u, p)).ravel()
        f[index("u")] = 0.0  # the speed is held while the pilot steers
        return f

    for k in range(math.ceil(25 * max(delay, 0.1) / h)):
        wanted.append(-gains[0] * x[index("psi")] - gains[1] * x[index("r")])
        slope = (wanted[k] - lever) / lag
        ahead = lever + h * slope
        after = lever + h / 2 * (slope + (wanted[k + 1] - ahead) / lag)
        first = rate(x, lever)
        x = x + h / 2 * (first + rate(x + h * first, after))
        lever = after
        psi.append(x[index("psi")])
        if abs(psi[-1]) > 0.02:
            return math.inf
    third = len(psi) // 3
    return float(np.abs(psi[-third:]).max() / np.abs(psi[-2 * third : -third]).max())


@pytest.mark.parametrize("speed", [17.5, 19.5, 21.0])
def test_the_model_with_a_true_delay_agrees_on_both_sides(speed: float) -> None:
    found = gr.pilot_limit(PLANE, speed=speed, gain_margin=1.0, phase_margin=0.0)
    gains = (float(found.heading_gain), float(found.yaw_rate_gain))
    delay = float(found.delay)
    assert rolled(speed, gains, 0.93 * delay, found.lag) < 1
    assert rolled(speed, gains, 1.07 * delay, found.lag) > 1


def test_no_other_gains_bear_more() -> None:
    """A dense search by another method finds no longer delay."""
    from scipy.optimize import differential_evolution

    rolls, _ = rolls_at(PLANE, MODEL, 19.0, {}, "test", [{"pedal": 1.0}])
    states, A, B = lateral(rolls, rolls.start(1))
    C = np.zeros((2, len(states)))
    C[0, states.index("psi")] = C[1, states.index("r")] = 1.0
    plant = Plant.of(A[0], B[0], C, 0.1)
    _, delay = best_gains(plant, [(0.5, 20.0), (0.05, 20.0)], Margins(1.0, 0.0))

    def lost(x: np.ndarray) -> float:
        return -max(float(delay_margin(plant.loop(np.exp(x)))), -1.0)

    ends = [(math.log(0.5), math.log(20.0)), (math.log(0.05), math.log(20.0))]
    best = differential_evolution(lost, ends, seed=7, maxiter=60, tol=1e-10)
    assert float(delay) == pytest.approx(-best.fun, rel=3e-3)


def test_the_body_on_legs_agrees_with_the_level_one() -> None:
    level, legs = (
        gr.pilot_limit(PLANE, model, speed=[6.0, 12.0, 16.0])
        for model in ("rollout", "landing_roll")
    )
    assert legs.delay == pytest.approx(level.delay, rel=0.1)


def test_margins_a_lag_and_speed_cost_delay() -> None:
    bare = gr.pilot_limit(PLANE, speed=19.0, gain_margin=1.0, phase_margin=0.0).delay
    assert gr.pilot_limit(PLANE, speed=19.0).delay < 0.7 * bare
    slow = gr.pilot_limit(PLANE, speed=19.0, lag=0.2).delay
    assert slow < gr.pilot_limit(PLANE, speed=19.0, lag="0.05 s").delay
    along = gr.pilot_limit(PLANE, speed=["20 kt", "30 kt", "35 kt"])
    assert (np.diff(along.delay) < 0).all()


def test_divergence_is_that_of_the_linear_model() -> None:
    speeds = [10.0, 19.0, 22.0]
    found = gr.pilot_limit(PLANE, speed=speeds)
    growth = gr.linearize(PLANE, "rollout", speed=speeds).eigenvalues.real.max(axis=-1)
    assert found.divergence == pytest.approx(np.maximum(growth, 0.0), abs=1e-6)
    unstable = found.divergence > 0
    assert found.doubling_time[unstable] == pytest.approx(math.log(2) / growth[unstable])
    assert np.isinf(found.doubling_time[~unstable]).all()


def test_mirrored_winds_ask_for_mirrored_pedals() -> None:
    left, right = (gr.pilot_limit(PLANE, speed=15.0, crosswind=w) for w in (4.0, -4.0))
    assert left.pedal == pytest.approx(-right.pedal)
    assert left.delay == pytest.approx(right.delay, rel=1e-3)
    assert left.pedal > 0  # the wind from the left turns the nose to it: right pedal


def test_what_nobody_can_hold_is_nan_and_counted() -> None:
    found = gr.pilot_limit(PLANE, speed=[15.0, 22.0], lag=1.5)
    assert np.isnan(found.delay[1])
    assert np.isnan(gr.pilot_limit(PLANE, speed=10.0, crosswind=80.0).delay)
    assert "1 of 2 cannot be held" in repr(found)


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        ({"speed": 0.0}, "at rest nothing turns"),
        ({"lag": -0.1}, "lag must be"),
        ({"gain_margin": 0.5}, "margin of gain"),
        ({"phase_margin": 3.2}, "half a turn"),
        ({"heading_gain": (3.0, 1.0)}, "bounds"),
        ({"heading_gain": 3.0}, "bounds"),
        ({"model": "nonlinear"}, "pedal"),
        ({"rudder_max": 0.0, "steering_ratio": 0.0}, "nobody can hold"),
        ({"sped": 3.0}, "speed"),
    ],
)
def test_errors_teach(wrong: dict[str, object], words: str) -> None:
    with pytest.raises(gr.GroundrollError, match=words):
        gr.pilot_limit(PLANE, **wrong)
