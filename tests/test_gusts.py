"""Disturbances that vary over time."""

from __future__ import annotations

import math
import pickle
from functools import reduce
from itertools import pairwise
from operator import add

import numpy as np
import pytest
from oracles import Array, right_hand_side
from scipy.integrate import solve_ivp

import groundroll as gr
from groundroll.motion import gusts
from groundroll.motion.signals import Signal

T = np.linspace(0.0, 4.0, 41)
AIRCRAFT = {
    "taildragger": {},
    "ground loop": {"a": 0.9, "Ct": 0.0},
    "tricycle": {"a": -0.5, "Ct": 0.0},
}
GUSTS = {
    "1-cosine": gusts.one_minus_cosine(peak=900.0, start=0.53, length=0.31),
    "step": gusts.step(300.0, start=0.517, end=1.9),
    "sampled": gusts.sampled([0.2, 0.33, 0.9, 2.0], [0.0, 700.0, -500.0, 100.0]),
    "held": gusts.sampled([0.2, 0.33, 0.9, 2.0], [0.0, 700.0, -500.0, 100.0], hold=True),
    "sum": gusts.step(200.0, 1.0) + gusts.one_minus_cosine(-600.0, 1.2, 1.1),
    "smooth": gusts.of_time(lambda t: 400 * np.sin(9 * t) * np.exp(-t)),
}


@pytest.fixture(scope="module")
def plane() -> gr.Aircraft:
    return gr.Aircraft.load("brott-physical")


def oracle(plane: gr.Aircraft, model: str, gust: Signal, x0: Array, times: Array = T) -> Array:
    """States by SciPy with the input as it is, piece by piece between its breaks."""
    f, p = right_hand_side(model), plane.parameters(model)
    ends = [0.0, *(b for b in gust.breaks if 0 < b < times[-1]), times[-1]]
    states, x = np.empty((x0.size, times.size)), x0
    for begin, end in pairwise(ends):
        here = (begin <= times) & (end >= times)

        def rate(t: float, x: Array, begin: float = begin, end: float = end) -> Array:
            inside = np.clip(t, np.nextafter(begin, end), np.nextafter(end, begin))
            return f(x, np.array([float(gust(inside))]), p)

        solution = solve_ivp(
            rate, (begin, end), x, "DOP853", np.union1d(times[here], [end]), rtol=1e-13, atol=1e-15
        )
        states[:, here], x = solution.y[:, : here.sum()], solution.y[:, -1]
    return states


def error(found: Array, exact: Array) -> float:
    """Largest error of a state, relative to its largest magnitude."""
    return float((np.abs(found - exact).max(axis=1) / np.abs(exact).max(axis=1)).max())


@pytest.mark.parametrize("model", ["linear", "nonlinear"])
@pytest.mark.parametrize("kind", AIRCRAFT)
@pytest.mark.parametrize("name", GUSTS)
def test_a_gust_is_integrated_as_well_as_a_constant(
    plane: gr.Aircraft, model: str, kind: str, name: str
) -> None:
    pushed = plane.replace(**AIRCRAFT[kind])
    run = gr.simulate(pushed, model, disturbance=GUSTS[name], v0=0.05, t=T[-1], samples=T.size)
    x0 = np.array([0.05, 0, 0, 0, 0, 0, 0])
    exact = oracle(pushed, model, GUSTS[name], x0)
    found = np.array([run[s] for s in ("v", "r", "y", "theta", "X", "Y", "psi")])
    assert error(found, exact) < 1e-9
    assert run["disturbance"] == pytest.approx(GUSTS[name](T), rel=1e-11, abs=1e-9)
    assert run["a_y"] == pytest.approx(run["sum_F"] / plane["m"], rel=1e-12)


@pytest.mark.parametrize("samples", [3, 101])
def test_a_short_gust_is_not_lost_between_samples(plane: gr.Aircraft, samples: int) -> None:
    gust, x0 = gusts.one_minus_cosine(peak=9000.0, start=0.5, length=0.01), np.zeros(7)
    run = gr.simulate(plane, disturbance=gust, t=1.0, samples=samples)
    exact = oracle(plane, "nonlinear", gust, x0, run.t)
    moved = ("v", "r", "y", "theta")
    assert error(np.array([run[s] for s in moved]), exact[:4]) < 1e-9


def test_a_jump_that_is_not_declared_is_found(plane: gr.Aircraft) -> None:
    def jump(t: Array) -> Array:
        return 500.0 * (t > 0.123456)

    step = gr.simulate(plane, disturbance=gusts.step(500.0, 0.123456), t=1.0, samples=11)
    for force in (jump, gusts.of_time(jump, [0.123456])):
        run = gr.simulate(plane, disturbance=force, t=1.0, samples=11)
        assert np.abs(run["v"] - step["v"]).max() < 2e-9 * np.abs(step["v"]).max()


@pytest.mark.parametrize("power", [0, 1, 2])
@pytest.mark.parametrize("at", [0.303, 0.123456, 0.98765])
def test_what_is_not_smooth_is_found(plane: gr.Aircraft, power: int, at: float) -> None:
    def force(t: Array) -> Array:
        return 100 * np.sin(5 * t) + 9e3 * np.where(t > at, (t - at) ** power, 0.0)

    found = gr.simulate(plane, disturbance=force, t=1.0, samples=11)
    told = gr.simulate(plane, disturbance=gusts.of_time(force, [at]), t=1.0, samples=11)
    for s in ("v", "r", "y", "theta"):
        assert np.abs(found[s] - told[s]).max() < 2e-9 * np.abs(told[s]).max()


def test_a_force_too_quick_to_be_followed_is_refused(plane: gr.Aircraft) -> None:
    rng = np.random.default_rng(1)

    def quick(t: Array) -> Array:
        return rng.normal(size=t.size)

    with pytest.raises(gr.GroundrollError, match=r"function quick varies too quickly .* t = "):
        gr.simulate(plane, disturbance=quick, t=0.1, samples=3)


def test_a_function_of_time_that_is_constant_is_a_constant(plane: gr.Aircraft) -> None:
    by_function = gr.simulate(plane, disturbance=lambda t: np.full(t.shape, 80.0), t=1.0)
    constant = gr.simulate(plane, disturbance=80.0, t=1.0)
    assert by_function["Y"] == pytest.approx(constant["Y"], rel=1e-9, abs=1e-12)
    assert by_function.disturbance == pytest.approx(constant["disturbance"], rel=1e-14)
    assert constant.disturbance.shape == ()


def test_a_run_for_each_of_several_gusts(plane: gr.Aircraft) -> None:
    peaks = np.array([[100.0], [400.0]])
    gust = gusts.one_minus_cosine(peaks, start=0.2, length=0.5)
    run = gr.simulate(plane.replace(a=np.array([-0.5, 0.0, 0.5]), Ct=0.0), disturbance=gust, t=1.0)
    assert run["v"].shape == run["disturbance"].shape == (2, 3, 501)
    assert run.disturbance.shape == (2, 3, 501)
    alone = gusts.one_minus_cosine(400.0, start=0.2, length=0.5)
    one = gr.simulate(plane.replace(a=0.5, Ct=0.0), disturbance=alone, t=1.0)
    assert run["Y"][1, 2] == pytest.approx(one["Y"], rel=1e-9, abs=1e-12)


def test_outputs_see_the_force_of_their_time(plane: gr.Aircraft) -> None:
    run = gr.simulate(plane, disturbance=gusts.step(200.0, start=0.5), t=1.0, samples=3)
    assert run["disturbance"].tolist() == [0.0, 200.0, 200.0]
    assert run["a_y"][1] == pytest.approx(200.0 / plane["m"], rel=1e-12)


def test_shapes_of_the_gusts() -> None:
    t = np.array([0.9, 1.0, 1.25, 1.5, 2.0, 2.1])
    cosine = gusts.one_minus_cosine("0.4 kN", start="1000 ms", length=1.0)
    assert cosine(t) == pytest.approx([0, 0, 200, 400, 0, 0], abs=1e-9)
    assert cosine.breaks == (1.0, 1.5, 2.0)
    assert gusts.step(5.0, 1.0, 2.0)(t).tolist() == [0, 5, 5, 5, 0, 0]
    lines = gusts.sampled([1.0, 2.0], [[0.0, 10.0], [5.0, 5.0]])
    assert lines(t)[0] == pytest.approx([0, 0, 2.5, 5, 10, 10])
    assert lines(t)[1] == pytest.approx(np.full(6, 5.0))
    assert gusts.sampled([1.0, 2.0], [3.0, 4.0], hold=True)(t).tolist() == [3, 3, 3, 3, 4, 4]
    both = gusts.step(5.0, 1.0) + gusts.step(-5.0, 2.0)
    assert both(t).tolist() == gusts.step(5.0, 1.0, 2.0)(t).tolist()
    assert cosine(1.5) == pytest.approx(400.0)
    assert repr(cosine) == "Signal(1-cosine gust of 400 N from 1 s over 1 s)"


def test_a_wind_is_the_force_it_makes_on_the_tail(plane: gr.Aircraft) -> None:
    force = gusts.crosswind(plane, "10 kt")
    p = {s: float(plane[s]) for s in ("rho", "Ap", "CL_gamma", "u")}
    wind = 10 * 1852 / 3600
    thin = 0.5 * p["rho"] * p["u"] * p["Ap"] * p["CL_gamma"] * wind
    assert 0.9 * thin < force <= thin
    assert gusts.crosswind(plane, np.array([-1.0, 0.0, 1.0])) == pytest.approx(
        gusts.crosswind(plane, 1.0) * np.array([-1.0, 0.0, 1.0])
    )


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: gusts.one_minus_cosine(np.nan), "peak must be finite"),
        (lambda: gusts.one_minus_cosine(1.0, length=0.0), "length must be positive"),
        (lambda: gusts.one_minus_cosine("3 m"), "peak: .*3 m"),
        (lambda: gusts.step(1.0, 2.0, 1.0), "end must come after start, not 1.0 after 2.0"),
        (lambda: gusts.sampled([0.0, 0.0], [1.0, 2.0]), "increasing times"),
        (lambda: gusts.sampled([0.0, 1.0], [1.0, 2.0, 3.0]), "one sample for each of 2 times"),
    ],
)
def test_bad_gusts_are_named(make: object, message: str) -> None:
    with pytest.raises(gr.GroundrollError, match=message):
        make()  # type: ignore[operator]


@pytest.mark.parametrize(
    ("force", "message"),
    [
        (math.sin, "function sin must take an array of times.*numpy.vectorize"),
        (lambda t: t[:1], "one value for each of .* times"),
        (lambda t: np.full(t.shape, np.inf), "must be finite"),
    ],
)
def test_bad_functions_of_time_are_named(plane: gr.Aircraft, force: object, message: str) -> None:
    with pytest.raises(gr.GroundrollError, match=message):
        gr.simulate(plane, disturbance=force)


@pytest.mark.parametrize(
    ("gust", "start", "end"),
    [
        (gusts.one_minus_cosine(1.0, 0.2, 0.5), 0.2, 0.7),
        (gusts.step(1.0, 0.2), 0.2, 0.2),
        (gusts.step(1.0, 0.2, 0.9), 0.2, 0.9),
        (gusts.step(1.0, 0.2, 0.9) + gusts.one_minus_cosine(1.0, 0.1, 0.2), 0.1, 0.9),
        (gusts.sampled([0.1, 0.2, 0.4, 0.5, 0.6], [0, 0, 7, 0, 0]), 0.2, 0.5),
        (gusts.sampled([0.1, 0.2, 0.4, 0.5, 0.6], [0, 0, 7, 3, 3], hold=True), 0.4, 0.5),
        (gusts.sampled([0.1, 0.2], [5, 5]), -np.inf, -np.inf),
        (gusts.of_time(np.sin), -np.inf, np.inf),
        (gusts.of_time(np.sin, end=3.0), -np.inf, 3.0),
    ],
    ids=lambda value: repr(value) if isinstance(value, Signal) else "",
)
def test_start_and_end_of_a_gust(gust: Signal, start: float, end: float) -> None:
    assert (gust.start, gust.end) == (pytest.approx(start), pytest.approx(end))


@pytest.mark.parametrize("name", GUSTS)
def test_a_run_with_a_gust_can_be_sent_to_another_process(plane: gr.Aircraft, name: str):
    run = gr.simulate(plane, disturbance=GUSTS[name], t=2.5, samples=26)
    back = pickle.loads(pickle.dumps(run))
    assert (back["v"] == run["v"]).all()
    assert back.gust.label == run.gust.label
    inside = T[T <= 2.5]
    assert (back.gust(inside) == run.gust(inside)).all()
    assert run.gust(inside) == pytest.approx(GUSTS[name](inside), rel=1e-11, abs=1e-9)


def test_a_sum_of_many_gusts_is_no_deeper_than_one(plane: gr.Aircraft):
    many = reduce(add, [gusts.step(1.0, 0.01 * k) for k in range(1500)])
    assert many(T) == pytest.approx(np.floor(np.round(T / 0.01, 6)) + 1)
    assert (pickle.loads(pickle.dumps(many))(T) == many(T)).all()
