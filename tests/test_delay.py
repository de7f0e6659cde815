"""Delay margins against closed forms, against simulation with a true delay, and as limits."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from groundroll.control.delay import Margins, Plant, best_gains, delay_limit, delay_margin

NONE = Margins(gain=1.0, phase=0.0)


def divergence(rate: float, lag: float = 0.0) -> Plant:
    """y' = rate y + u."""
    return Plant.of(np.array([[rate]]), np.array([1.0]), np.array([[1.0]]), lag)


@given(st.floats(0.2, 5.0), st.floats(0.0, 0.5))
def test_a_first_order_divergence_is_held_below_one_over_its_rate(rate: float, lag: float) -> None:
    # as the gain comes down to the rate, lambda (tau + T) -> 1
    if rate * lag >= 0.9:
        return
    loop = divergence(rate, lag).loop(np.array([rate * (1 + 1e-6)]))
    assert delay_margin(loop) == pytest.approx(1 / rate - lag, rel=1e-3)


def test_the_best_gain_finds_that_limit() -> None:
    _, delay = best_gains(divergence(1.5, 0.1), [(1.0, 20.0)], NONE)
    assert 1.5 * (delay + 0.1) == pytest.approx(1.0, abs=2e-3)


def test_margins_of_six_decibels_and_thirty_degrees_cost_two_thirds() -> None:
    _, delay = best_gains(divergence(1.0), [(0.5, 20.0)], Margins())
    assert delay == pytest.approx(0.30, abs=0.01)
    # by hand: K = 2 lambda is the least gain that bears 6 dB less; 6 dB more gives tau
    w = math.sqrt(15.0)
    assert delay <= (math.pi - (math.pi - math.atan(w))) / w + 1e-6


def test_an_integrator_has_a_quarter_of_a_turn() -> None:
    loop = Plant.of(np.zeros((1, 1)), np.ones(1), np.ones((1, 1)), 0.0).loop(np.array([2.0]))
    assert delay_margin(loop) == pytest.approx(math.pi / 4)


def test_what_is_unstable_without_delay_has_no_margin() -> None:
    assert delay_margin(divergence(1.0).loop(np.array([0.9]))) == -math.inf


@settings(max_examples=20, deadline=None)
@given(st.floats(1.05, 8.0), st.just(0.0) | st.floats(0.05, 0.3), st.floats(0.3, 3.0))
def test_a_simulation_with_a_true_delay_agrees_on_both_sides(
    gain: float, lag: float, rate: float
) -> None:
    loop = divergence(rate, lag).loop(np.array([gain * rate]))
    margin = delay_margin(loop)
    if not 0.02 < margin < 5:
        return
    assert _grows(rate, gain * rate, lag, 1.05 * margin)
    assert not _grows(rate, gain * rate, lag, 0.95 * margin)


def _grows(rate: float, gain: float, lag: float, delay: float) -> bool:
    """Whether y' = rate y - u grows, u being the delayed y through a lag (Heun's steps)."""
    steps = 200
    h = delay / steps
    count = int(60 * max(delay, 0.2) / h)
    y = np.ones(count + steps + 1)
    u = gain if not lag else 0.0
    for k in range(steps, count + steps):
        seen, next_seen = gain * y[k - steps], gain * y[k - steps + 1]
        if lag:
            slope = (seen - u) / lag
            ahead = u + h * slope
            after = u + h / 2 * (slope + (next_seen - ahead) / lag)
        else:
            u, after = seen, next_seen
        first = rate * y[k] - u
        y[k + 1] = y[k] + h / 2 * (first + rate * (y[k] + h * first) - after)
        u = after
        if abs(y[k + 1]) > 1e6:
            return True
    third = count // 3
    return bool(np.abs(y[-third:]).max() > np.abs(y[-2 * third : -third]).max())


@given(st.floats(0.3, 4.0))
def test_a_delay_limit_never_exceeds_the_margin(rate: float) -> None:
    loop = divergence(rate).loop(np.array([3 * rate]))
    assert delay_limit(loop, Margins()) <= delay_margin(loop)
