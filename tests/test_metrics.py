"""Metrics of responses, beside those of the linear model in closed form by SciPy."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from oracles import Array
from scipy.linalg import expm

import groundroll as gr
from groundroll.motion import gusts
from groundroll.runs.curve import Curve

PLANE = gr.Aircraft.load("brott-physical")
TRICYCLE = {"a": -0.5, "Ct": 0.0}
AIRCRAFT = {"taildragger": {}, "tricycle": TRICYCLE, "stiff": {"Ct": 8300.0}}
WORDS = tuple(name for name in gr.Metrics.units if name not in ("displacement", "rotation"))
DT = 5e-4
#: Where the oracle's response ends, s: long after everything.
LAST = 15.0

Pieces = list[tuple[float, Array, Array]]


def exact(plane: gr.Aircraft, pieces: Pieces) -> tuple[Array, Array]:
    """Times and [v, r, y, theta] of the linear model from rest, by the matrix exponential.

    Each piece of the force is its duration, s, a matrix E and a start w0: it is the first element
    of w, and w' = E w.
    """
    lin = gr.linearize(plane, "linear")
    A, B = np.zeros((4, 4)), np.zeros(4)
    A[:2, :2], A[2, 0], A[3, 1], B[:2] = lin.A, 1.0, 1.0, lin.B[:, 0]
    states, x = [np.zeros((4, 1))], np.zeros(4)
    for duration, E, w in pieces:
        M = np.block([[A, np.outer(B, np.eye(len(w))[0])], [np.zeros((len(w), 4)), E]])
        steps = round(duration / DT)
        assert steps * DT == pytest.approx(duration)
        advance, z = expm(M * DT), np.concatenate([x, w])
        path = np.empty((4, steps))
        for k in range(steps):
            z = advance @ z
            path[:, k] = z[:4]
        states.append(path)
        x = z[:4]
    found = np.concatenate(states, axis=1)
    return DT * np.arange(found.shape[1]), found


def crossings(t: Array, q: Array, level: float) -> Array:
    """Where straight lines through the samples pass a level."""
    k = np.flatnonzero((q[1:] > level) != (q[:-1] > level))
    return t[k] + DT * (level - q[k]) / (q[k + 1] - q[k])


def words(t: Array, q: Array, steady: float, constant: float) -> dict[str, float]:
    """The definitions of `Metrics`, one by one."""
    band = 0.05 * np.abs(q - steady).max()
    peak = np.abs(q).argmax()
    never = abs(q[peak] - steady) < 1e-8 * abs(steady)
    late = [*crossings(t, q, steady + band), *crossings(t, q, steady - band), constant]
    found = dict.fromkeys(WORDS, math.nan)
    found |= {
        "steady": steady,
        "peak": q[peak],
        "peak_time": math.inf if never else t[peak],
        "recovery_time": max(late) - constant,
    }
    if steady:
        share = q / steady
        found |= {
            "time_constant": crossings(t, share, 1 - 1 / math.e)[0],
            "rise_time": crossings(t, share, 0.9)[0] - crossings(t, share, 0.1)[0],
            "settling_time": max([*crossings(t, share, 0.95), *crossings(t, share, 1.05)]),
            "overshoot": max(share.max() - 1, 0.0),
        }
    return found


def agree(found: gr.Metrics, expected: dict[str, float]) -> None:
    for word, value in expected.items():
        # a flat peak is not found to better than the oracle's samples
        size = 2 * DT if word == "peak_time" else 2e-6 * max(abs(value), 1.0)
        assert float(getattr(found, word)) == pytest.approx(value, abs=size, nan_ok=True), word


HELD = np.zeros((1, 1))
LINE = np.array([[0.0, 1.0], [0.0, 0.0]])


def wave(peak: float, length: float) -> tuple[float, Array, Array]:
    """A 1-cosine gust as the solution of a linear equation."""
    square = (2 * math.pi / length) ** 2
    E = np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, -square, 0.0]])
    return length, E, np.array([0.0, 0.0, peak / 2 * square])


# --- Against the matrix exponential -------------------------------------------------------------


@pytest.mark.parametrize("kind", AIRCRAFT)
def test_a_step_leads_to_a_new_steady_state(kind: str) -> None:
    plane = PLANE.replace(**AIRCRAFT[kind])
    t, x = exact(plane, [(LAST, HELD, np.array([300.0]))])
    lin = gr.linearize(plane, "linear")
    steady = -np.linalg.solve(lin.A, lin.B[:, 0] * 300.0)
    run = gr.simulate(plane, "linear", disturbance=gusts.step(300.0, start=0.7), t=1.0)
    for k, state in enumerate(("v", "r")):
        agree(run.metrics(state), words(t, x[k], float(steady[k]), 0.0))
    assert np.isnan([getattr(run.metrics(s), word) for s in ("y", "theta") for word in WORDS]).all()


@pytest.mark.parametrize("kind", AIRCRAFT)
@pytest.mark.parametrize(
    ("gust", "pieces"),
    [
        (gusts.one_minus_cosine(400.0, start=0.3, length=0.8), [wave(400.0, 0.8)]),
        (gusts.step(-250.0, start=0.3, end=1.1), [(0.8, HELD, np.array([-250.0]))]),
        (
            gusts.sampled([0.0, 0.3, 0.7, 1.2, 9.0], [0.0, 0.0, 500.0, 0.0, 0.0]),
            [
                (0.4, LINE, np.array([0.0, 1250.0])),
                (0.5, LINE, np.array([500.0, -1000.0])),
            ],
        ),
        (
            gusts.step(100.0, 0.3, 0.8) + gusts.step(-300.0, 1.0, 1.5),
            [(h, HELD, np.array([F])) for h, F in ((0.5, 100.0), (0.2, 0.0), (0.5, -300.0))],
        ),
    ],
    ids=["1-cosine", "rectangle", "samples", "sum"],
)
def test_a_pulse_leads_back_to_rest(kind: str, gust: gusts.Gust, pieces: Pieces) -> None:
    plane = PLANE.replace(**AIRCRAFT[kind])
    length = sum(piece[0] for piece in pieces)
    t, x = exact(plane, [*pieces, (LAST, HELD, np.zeros(1))])
    run = gr.simulate(plane, "linear", disturbance=gust, t=1.0)
    for k, state in enumerate(("v", "r", "y", "theta")):
        agree(run.metrics(state), words(t, x[k], 0.0 if k < 2 else float(x[k, -1]), length))


# --- What must hold for any response ----------------------------------------------------------


@given(
    *(st.floats(-900, 900).filter(lambda F: abs(F) > 1), st.floats(0.1, 2), st.floats(0, 1)),
    st.sampled_from(["1-cosine", "rectangle", "triangle"]),
)
def test_where_a_pulse_leaves_the_aircraft_is_told_by_its_impulse(
    F: float, length: float, start: float, form: str
) -> None:
    """[y, theta] at rest is -A^-1 B times the integral of the force, whatever its form."""
    gust = {
        "1-cosine": gusts.one_minus_cosine(F, start, length),
        "rectangle": gusts.step(F / 2, start, start + length),
        "triangle": gusts.sampled([start, start + length / 3, start + length], [0.0, F, 0.0]),
    }[form]
    lin = gr.linearize(PLANE, "linear")
    expected = -np.linalg.solve(lin.A, lin.B[:, 0]) * F * length / 2
    found = gr.simulate(PLANE, "linear", disturbance=gust, t=0.1, samples=2).metrics()
    assert [found.displacement, found.rotation] == pytest.approx(expected, rel=1e-7)


def test_a_short_gust_is_a_kick() -> None:
    """Dv = S/m and Dr = -b S/Izz: the metrics of that start are the limit, at first order."""
    m, b, Izz = (float(PLANE[s]) for s in ("m", "b", "Izz"))
    kick = gr.simulate(PLANE, v0=60.0 / m, r0=-b * 60.0 / Izz).metrics("theta")
    gaps = []
    for length in (0.08, 0.04):
        gust = gusts.one_minus_cosine(2 * 60.0 / length, start=0.5, length=length)
        found = gr.simulate(PLANE, disturbance=gust).metrics("theta")
        gaps.append([float(getattr(found, w) - getattr(kick, w)) for w in WORDS])
        assert np.abs(gaps[-1][:2]).max() < 1e-3 * abs(kick.steady)
        assert np.abs(gaps[-1][2:]).max() < 2 * length
    recovery = WORDS.index("recovery_time")
    assert [gap[recovery] for gap in gaps] == pytest.approx([-0.04, -0.02], rel=0.1)


def test_the_mirrored_gust_gives_the_mirrored_response() -> None:
    gust = gusts.one_minus_cosine(np.array([900.0, -900.0]), 0.2, 0.7)
    found = gr.simulate(PLANE, disturbance=gust).metrics(["v", "r", "theta"])
    for word in WORDS:
        left, right = np.moveaxis(getattr(found, word), -1, 0)
        sign = -1 if word in ("steady", "peak") else 1
        assert right == pytest.approx(sign * left, nan_ok=True), word


def test_a_steady_turn_is_one_of_the_trim() -> None:
    found = gr.simulate(PLANE, disturbance=gusts.step(900.0, 0.5)).metrics(["v", "r"])
    turn = gr.trim(PLANE, disturbance=900.0)
    (k,) = np.flatnonzero(turn.stable)
    assert found.steady == pytest.approx([turn["v"][k], turn["r"][k]], rel=1e-8)


def test_a_constant_force_is_a_step_at_the_start() -> None:
    constant = gr.simulate(PLANE, disturbance=200.0, t=1.0).metrics(["v", "r"])
    step = gr.simulate(PLANE, disturbance=gusts.step(200.0, 2.5), t=5.0).metrics(["v", "r"])
    for word in WORDS:
        assert getattr(constant, word) == pytest.approx(getattr(step, word), rel=1e-7), word


def test_what_follows_a_gust_does_not_depend_on_the_run() -> None:
    gust = gusts.one_minus_cosine(300.0, start=1.0, length=0.5)
    short, long = (gr.simulate(PLANE, disturbance=gust, t=t).metrics("r") for t in (0.2, 9.0))
    for word in WORDS:
        assert getattr(short, word) == pytest.approx(getattr(long, word), abs=0, nan_ok=True)
    assert short.recovery_time > 0


# --- Arrays, and what has no answer -----------------------------------------------------------


def test_every_run_has_the_metrics_it_would_have_alone() -> None:
    a, start = np.array([-0.5, 0.1, 0.9]), np.array([[0.2], [0.55]])
    length = np.array([0.4, 0.7, 1.0])
    plane = PLANE.replace(Ct=0.0, f=0.8)
    gust = gusts.one_minus_cosine(200.0, start, length)
    many = gr.simulate(plane.replace(a=a), disturbance=gust, v0=0.0).metrics(("r", "y"))
    assert many.of == ("r", "y")
    assert many.displacement.shape == (2, 3)
    assert many.peak.shape == (2, 2, 3)
    for i, k in ((0, 0), (1, 1), (1, 2)):
        alone = gusts.one_minus_cosine(200.0, start[i, 0], length[k])
        one = gr.simulate(plane.replace(a=a[k]), disturbance=alone).metrics("y")
        for word in WORDS:
            expected = pytest.approx(float(getattr(one, word)), rel=1e-6, nan_ok=True)
            assert getattr(many, word)[1, i, k] == expected, word
    assert np.isnan(many.peak[:, :, 2]).all()  # unstable
    assert np.isfinite(many.peak[:, :, :2]).all()


def test_no_steady_state_no_metrics() -> None:
    unstable = PLANE.replace(a=0.9, Ct=0.0)
    for gust in (gusts.one_minus_cosine(10.0), gusts.step(10.0)):
        found = gr.simulate(unstable, disturbance=gust).metrics("v")
        assert np.isnan([getattr(found, name) for name in gr.Metrics.units]).all()


def test_nothing_moves() -> None:
    found = gr.simulate(PLANE, y0=0.3).metrics()
    assert (found.displacement, found.rotation) == (0.3, 0)
    assert (found.peak, found.peak_time, found.recovery_time) == (0.3, 0, 0)
    assert np.isnan([found.time_constant, found.overshoot]).all()


def test_a_force_without_an_end_has_none() -> None:
    def sway(t: Array) -> Array:
        return 100 * np.sin(3 * t)

    run = gr.simulate(PLANE, disturbance=sway, t=2.0)
    with pytest.raises(gr.GroundrollError, match=r"function sway has no end.*end=3.0.*read the"):
        run.metrics()
    half = gusts.of_time(sway, end=math.pi / 3)
    assert abs(half(np.array([1.0, 2.0, 9.0])) - [100 * math.sin(3), 0, 0]).max() < 1e-9
    found = gr.simulate(PLANE, "linear", disturbance=half, t=0.5).metrics()
    lin = gr.linearize(PLANE, "linear")
    impulse = 200.0 / 3
    assert found.displacement == pytest.approx(-np.linalg.solve(lin.A, lin.B[:, 0])[0] * impulse)


def test_a_jump_after_the_run_is_found() -> None:
    late = gusts.of_time(lambda t: 50.0 * (t > 1.3), end=2.0)
    found = gr.simulate(PLANE, disturbance=late, t=1.0).metrics("r")
    step = gr.simulate(PLANE, disturbance=gusts.step(50.0, 1.3), t=1.0).metrics("r")
    assert found.peak == pytest.approx(step.peak, rel=1e-6)


def test_an_unknown_state_names_the_nearest() -> None:
    run = gr.simulate(PLANE, v0=0.1, t=0.1)
    with pytest.raises(gr.GroundrollError, match="yaw_rate"):
        run.metrics("yaw_rat")
    assert run.metrics("yaw_rate").of == "r"


def test_metrics_are_told_with_their_units() -> None:
    text = repr(gr.simulate(PLANE, v0=0.1, t=0.1).metrics("r"))
    assert text.startswith("Metrics of r (yaw_rate)\n  displacement   0.0319")
    assert "rad/s\n" in text


def test_a_run_from_disk_has_its_metrics(tmp_path: Path) -> None:
    gust = gusts.one_minus_cosine(100.0, 0.2, 0.5)
    run = gr.simulate(PLANE, disturbance=gust, t=1.0)
    back = gr.Trajectory.load(run.save(tmp_path / "run.npz")).metrics("theta")
    for word in WORDS:
        assert getattr(back, word) == pytest.approx(getattr(run.metrics("theta"), word), rel=1e-9)


# --- The curve they are read off --------------------------------------------------------------


def test_a_cubic_is_exact() -> None:
    cubic = np.polynomial.Polynomial.fromroots([0.13, 0.52, 0.9])
    t = np.array([0.0, 0.4, 0.8, 1.0])
    slope = cubic.deriv()(t)
    curve = Curve(t, cubic(t), slope, slope)
    assert curve.crossings(0.0) == pytest.approx([0.13, 0.52, 0.9], abs=1e-9)
    times, values = curve.extremes()
    turns = np.sort(cubic.deriv().roots())
    assert times[4:] == pytest.approx(turns, abs=1e-9)
    assert values[4:] == pytest.approx(cubic(turns), abs=1e-12)


def test_a_kink_is_no_extremum_between_samples() -> None:
    curve = Curve(
        np.arange(3.0), np.array([0.0, 1.0, 0.0]), np.array([0, 1, -1.0]), np.array([1, -1, 0.0])
    )
    times, values = curve.extremes()
    assert (times.tolist(), values.max()) == ([0, 1, 2], 1)
    assert curve.crossings(0.25) == pytest.approx([0.25, 1.75])
