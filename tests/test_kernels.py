"""Kernels of any model: right against SciPy, whatever its states, operations and inputs."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import casadi as ca
import numpy as np
import pytest
from bare_models import Array, Bare, Expressions, bare

from groundroll.motion import lanes
from groundroll.motion.lanes import Pieces, Stepper, Task, Watch
from groundroll.motion.signals import Polynomials, of_time, one_minus_cosine, sampled, step

#: SciPy's own error, relative to each state's scale, in these tests.
SCIPY = 2e-11


def double_pendulum(x: list[ca.SX], u: list[ca.SX], p: list[ca.SX]) -> list[ca.SX]:
    """Angles and rates; the gravity is the parameter."""
    (a, b, w, v), g = x, p[0]
    d = a - b
    left = 3 - ca.cos(2 * d)
    one = -3 * g * ca.sin(a) - g * ca.sin(a - 2 * b)
    one -= 2 * ca.sin(d) * (v * v + w * w * ca.cos(d))
    two = 2 * ca.sin(d) * (2 * w * w + 2 * g * ca.cos(a) + v * v * ca.cos(d))
    return [w, v, one / left, two / left]


def past_a_saddle(x: list[ca.SX], u: list[ca.SX], p: list[ca.SX]) -> list[ca.SX]:
    """An upside-down pendulum, and what follows it."""
    return [x[1], ca.sin(x[0]) - p[0] * x[1], -2 * x[2] + x[0] * x[1], x[0] - x[3]]


def network(x: list[ca.SX], u: list[ca.SX], p: list[ca.SX]) -> list[ca.SX]:
    """Eight states that all drive each other."""
    n = len(x)
    return [ca.tanh(sum(p[n * i + j] * x[j] for j in range(n))) - 0.3 * x[i] for i in range(n)]


def alone(x: list[ca.SX], u: list[ca.SX], p: list[ca.SX]) -> list[ca.SX]:
    """One state that moves by itself, and its integral."""
    return [p[0] * x[0] * (1 - x[0]), x[0]]


def integral(x: list[ca.SX], u: list[ca.SX], p: list[ca.SX]) -> list[ca.SX]:
    """Nothing but an integral."""
    return [p[0] * ca.sin(u[0])]


def every_operation(x: list[ca.SX], u: list[ca.SX], p: list[ca.SX]) -> list[ca.SX]:
    """Each operation that a law may use, where it is smooth."""
    a, b = x
    curve = ca.atan2(a, 2 + b**2) + ca.tanh(b) - ca.exp(-(a**2)) + ca.log(2 + a**2)
    other = ca.sqrt(1 + b**2) - ca.fabs(3 + ca.sin(a)) + ca.fmax(a, -90) + ca.fmin(b, 90)
    rest = ca.if_else(a > -90, ca.sinh(0.1 * b), 5) + ca.sign(2 + ca.cos(a)) + (1 + a**2) ** 0.3
    more = ca.asin(0.5 * ca.tanh(a)) + ca.acos(0.5 * ca.sin(b)) + ca.log1p(b**2) + ca.hypot(a, 1)
    return [p[0] * (curve + other) - 3 * a, p[0] * (rest - ca.expm1(-(b**2)) + more) - 5 * b]


def driven(x: list[ca.SX], u: list[ca.SX], p: list[ca.SX]) -> list[ca.SX]:
    """A pendulum with a spring, pushed and held by two inputs that do not enter linearly."""
    return [x[1], -p[0] * ca.sin(x[0]) - 0.2 * x[1] * (1 + u[1] ** 2) + u[0] - 0.1 * x[2], x[0]]


MODELS: dict[str, tuple[Expressions, tuple[int, int, int]]] = {
    "double pendulum": (double_pendulum, (4, 0, 1)),
    "past a saddle": (past_a_saddle, (4, 0, 1)),
    "network": (network, (8, 0, 64)),
    "alone": (alone, (2, 0, 1)),
    "every operation": (every_operation, (2, 0, 1)),
}


def made(folder: Path, name: str) -> tuple[Bare, Array, Array]:
    """A model with initial states and parameters, one row for each trajectory."""
    rng = np.random.default_rng(len(name))
    rates, sizes = MODELS[name]
    x0, p = rng.normal(0.0, 0.7, (12, sizes[0])), rng.uniform(0.2, 2.0, (12, sizes[2]))
    if name == "past a saddle":
        x0[:, :2] = rng.normal(0.0, (0.01, 0.2), (12, 2)) - [3.1, 0.0]
    if name == "network":
        p = rng.normal(0.0, 0.8, p.shape)
    if name == "alone":
        x0 = np.abs(x0)
    return bare(folder, rates, sizes), x0, p


def task_of(model: Bare, x0: Array, p: Array, t: float, tol: float, **more: object) -> Task:
    pack = model.pack
    made = Task(
        model=pack,
        x0=dict(zip(pack.states, x0.T.copy(), strict=True)),
        inputs={},
        parameters=dict(zip(pack.parameters, p.T.copy(), strict=True)),
        count=len(x0),
        t=t,
        tol=tol,
    )
    return replace(made, **more)


@pytest.mark.parametrize("name", MODELS)
def test_any_model_keeps_the_tolerance_against_scipy(name: str, tmp_path: Path):
    model, x0, p = made(tmp_path, name)
    states, at = model.pack.states, np.linspace(0.0, 4.0, 17)
    exact = [model.exact(*each, at) for each in zip(x0, p, strict=True)]
    scale = np.maximum([np.abs(each).max(axis=1) for each in exact], 1e-6)
    for tol in (1e-4, 1e-6, 1e-9):
        task = task_of(model, x0, p, 4.0, tol, times=at, sampled=states, final=states)
        many = lanes.integrate(task)
        assert (many.status == 0).all()
        single = Stepper(model.pack, at, tol, states)
        for k, (start, values) in enumerate(zip(x0, p, strict=True)):
            for rows in (
                np.array([many.samples[s][k] for s in states]),
                single(start, np.zeros(0), values),
            ):
                error = np.abs(rows - exact[k]).max(axis=1) / scale[k]
                assert error.max() < tol + SCIPY
            end = np.array([many.final[s][k] for s in states])
            assert (np.abs(end - exact[k][:, -1]) / scale[k]).max() < tol + SCIPY


def test_an_integral_alone_is_one(tmp_path: Path):
    model = bare(tmp_path, integral, (1, 1, 1))
    task = task_of(model, np.zeros((2, 1)), np.array([[1.0], [3.0]]), 2.0, 1e-9)
    signal = sampled([0.0, 2.0], [0.0, 1.0]).over(2.0)
    moving = replace(task, signals={"u0": signal.pieces((2,), range(2))}, final=("x0",))
    exact = 2.0 * (1 - np.cos(1.0))  # of sin(t / 2)
    assert lanes.integrate(moving).final["x0"] == pytest.approx([exact, 3 * exact], rel=1e-12)


# --- Inputs over time -------------------------------------------------------------------------


def drawn(kind: str, rng: np.random.Generator) -> Polynomials:
    """A random signal."""
    size, begin, length = rng.normal(0.0, 6.0), rng.uniform(0.1, 1.0), rng.uniform(0.1, 1.0)
    t, values = np.cumsum(rng.exponential(0.4, 9)), rng.normal(0.0, 4.0, 9)

    def wave(t: Array) -> Array:
        return size * np.sin(15 * length * t) * np.exp(-t)

    signals = {
        "1-cosine": one_minus_cosine(size, begin, length),
        "step": step(size, begin, begin + 2 * length),
        "lines": sampled(t, values),
        "held": sampled(t, values, hold=True),
        "smooth": of_time(wave),
        "sum": step(values[0], 0.5) + one_minus_cosine(size, begin, length),
    }
    return signals[kind].over(4.0)


SIGNALS = ("1-cosine", "step", "lines", "held", "smooth", "sum")


def per_run(signals: list[Polynomials]) -> Pieces:
    """Different signals for different runs, filled up with pieces that never begin."""
    pieces = max(each.starts.size for each in signals)
    terms = max(each.values.shape[-1] for each in signals)
    start = np.full((len(signals), pieces), np.inf)
    value = np.zeros((len(signals), pieces, terms))
    for k, each in enumerate(signals):
        start[k, : each.starts.size] = each.starts
        value[k, : each.starts.size, : each.values.shape[-1]] = each.values
    return Pieces(start, value)


@pytest.mark.parametrize("name", SIGNALS)
def test_inputs_over_time_are_integrated_as_well_as_constants(name: str, tmp_path: Path):
    rng = np.random.default_rng(len(name))
    model, n = bare(tmp_path, driven, (3, 2, 1)), 10
    pushes, holds = ([drawn(name, rng) for _ in range(n)] for _ in range(2))
    x0, p = rng.normal(0.0, 0.5, (n, 3)), rng.uniform(0.5, 9.0, (n, 1))
    x0[: n // 2] = 0.0  # at rest until something pushes
    at, states = np.linspace(0.0, 4.0, 33), model.pack.states
    exact = [
        model.exact(
            *each,
            at,
            lambda t, k=k: (float(pushes[k](t)), float(holds[k](t))),
            np.union1d(pushes[k].breaks, holds[k].breaks),
        )
        for k, each in enumerate(zip(x0, p, strict=True))
    ]
    scale = np.maximum([np.abs(each).max(axis=1) for each in exact], 1e-6)
    signals = {"u0": per_run(pushes), "u1": per_run(holds)}
    for tol in (1e-4, 1e-6, 1e-9):
        many = lanes.integrate(
            task_of(model, x0, p, 4.0, tol, times=at, sampled=states, signals=signals)
        )
        assert (many.status == 0).all()
        for k in range(n):
            own = {s: Pieces(each.start[[k]], each.value[[k]]) for s, each in signals.items()}
            single = Stepper(model.pack, at, tol, states, own)
            for rows in (
                np.array([many.samples[s][k] for s in states]),
                single(x0[k], np.zeros(2), p[k]),
            ):
                assert (np.abs(rows - exact[k]).max(axis=1) / scale[k]).max() < tol + SCIPY


def test_bits_under_inputs_over_time_do_not_depend_on_company(tmp_path: Path):
    rng = np.random.default_rng(7)
    model, n = bare(tmp_path, driven, (3, 2, 1)), 70
    pieces = per_run([drawn(SIGNALS[k % len(SIGNALS)], rng) for k in range(n)])
    x0, p = rng.normal(0.0, 0.5, (n, 3)), rng.uniform(0.5, 9.0, (n, 1))
    watches = (Watch("x0", 0, np.array([1.0])), Watch("y0", 1, rng.uniform(0.2, 3.0, n), True))

    def run(which: slice) -> lanes.Outcome:
        own = Pieces(pieces.start[which], pieces.value[which])
        seen = (watches[0], replace(watches[1], limit=watches[1].limit[which]))
        more = {"signals": {"u0": own}, "watches": seen, "final": model.pack.states}
        times = {"times": np.linspace(0.0, 4.0, 9), "sampled": ("x1", "y0")}
        return lanes.integrate(task_of(model, x0[which], p[which], 4.0, 1e-6, **more, **times))

    every, some = run(slice(None)), run(slice(31, 42))
    for name in ("steps", "estimate", "end", "cause", "largest", "first"):
        part = np.ascontiguousarray(getattr(every, name)[..., 31:42])
        assert part.tobytes() == np.ascontiguousarray(getattr(some, name)).tobytes(), name
    for kind in ("final", "samples"):
        for name, array in getattr(some, kind).items():
            assert getattr(every, kind)[name][31:42].tobytes() == array.tobytes()


def test_an_output_sees_the_input_of_its_time(tmp_path: Path):
    model = bare(tmp_path, driven, (3, 2, 1), lambda x, u, p: [u[0], u[0] + u[1]])
    signal = step(2.0, 1.0, 3.0).over(4.0)
    at = np.array([0.0, 1.0, 2.0, 3.0, 4.0])
    task = task_of(model, np.zeros((1, 3)), np.ones((1, 1)), 4.0, 1e-6, times=at)
    pieces = {"u0": signal.pieces((), range(1))}
    inputs = {"u1": np.array([0.25])}
    run = lanes.integrate(replace(task, sampled=("y0", "y1"), signals=pieces, inputs=inputs))
    assert run.samples["y0"].tolist() == [[0.0, 2.0, 2.0, 0.0, 0.0]]
    assert run.samples["y1"].tolist() == [[0.25, 2.25, 2.25, 0.25, 0.25]]


# --- Events -----------------------------------------------------------------------------------


def swing(x: list[ca.SX], u: list[ca.SX], p: list[ca.SX]) -> list[ca.SX]:
    """A harmonic motion: cos(w t) from (1, 0)."""
    return [p[0] * x[1], -p[0] * x[0]]


@pytest.fixture(scope="module")
def pendulum(tmp_path_factory: pytest.TempPathFactory) -> Bare:
    seen = lambda x, u, p: [x[0] + 0 * x[1], x[0] ** 2]  # noqa: E731
    return bare(tmp_path_factory.mktemp("swing") / "model", swing, (2, 0, 1), seen)


def swings(pendulum: Bare, w: Array, watches: tuple[Watch, ...], tol: float, **more: object):
    x0 = np.tile([1.0, 0.0], (w.size, 1))
    task = task_of(pendulum, x0, w[:, None], 10.0, tol, watches=watches, **more)
    return lanes.integrate(task)


@pytest.mark.parametrize("tol", [1e-3, 1e-6, 1e-9])
@pytest.mark.parametrize("row", ["x0", "y0"])
def test_events_have_the_time_of_the_closed_form(pendulum: Bare, row: str, tol: float):
    w = np.linspace(0.3, 7.0, 40)
    level = np.random.default_rng(3).uniform(-0.9, 0.9, 40)
    watches = (
        Watch(row, 1, level),  # cos is above the level from the beginning
        Watch(row, -1, -level),  # it falls to the level at acos(level) / w
        Watch(row, 1, np.full(40, 1.5)),
    )
    found = swings(pendulum, w, watches, tol)
    assert not found.first[0].any()
    slope = w * np.sqrt(1 - level**2)
    error = found.first[1] - np.arccos(level) / w
    assert (np.abs(error) < 3 * tol * np.maximum(1.0, 1.0 / slope)).all()
    assert np.isinf(found.first[2]).all()
    assert found.largest[0] == pytest.approx(1.0, rel=2 * tol)


@pytest.mark.parametrize("tol", [1e-3, 1e-6, 1e-9])
def test_an_event_ends_a_trajectory_with_a_state_and_a_time(pendulum: Bare, tol: float):
    w, level = np.linspace(0.3, 7.0, 40), 0.35
    at = np.linspace(0.0, 10.0, 101)
    watches = (Watch("y0", -1, np.array([-level]), ends=True), Watch("x1", 0))
    found = swings(pendulum, w, watches, tol, times=at, sampled=("x0", "y0"), final=("x0", "x1"))
    end = np.arccos(level) / w
    assert np.abs(found.end - end).max() < 3 * tol / 0.3
    assert (found.status == 0).all()
    assert (found.cause == 0).all()
    assert np.array_equal(found.first[0], found.end)
    assert found.final["x0"] == pytest.approx(level, abs=2 * tol)
    assert found.final["x1"] == pytest.approx(-np.sqrt(1 - level**2), abs=2 * tol)
    assert found.largest[1] == pytest.approx(np.sqrt(1 - level**2), abs=2 * tol)
    known = np.isfinite(found.samples["x0"])
    assert np.array_equal(known, at <= found.end[:, None])
    assert np.abs(found.samples["x0"] - np.cos(w[:, None] * at))[known].max() < 2 * tol


@pytest.mark.parametrize("tol", [1e-3, 1e-4, 1e-6, 1e-9, 1e-11])
def test_first_and_largest_never_contradict_each_other(pendulum: Bare, tol: float):
    """Limits about the peak, closer to it than the tolerance and farther from it."""
    rng = np.random.default_rng(11)
    n = 4000
    w = rng.uniform(0.4, 9.0, n)
    off = rng.choice([-1.0, 1.0], n) * 10.0 ** rng.uniform(-13, -2, n)
    for row, sign in (("x1", 0), ("x1", -1), ("y1", 1)):
        watch = Watch(row, sign, 1.0 + off)
        free = swings(pendulum, w, (watch,), tol)
        ended = swings(pendulum, w, (replace(watch, ends=True),), tol, final=("x0", "x1"))
        for found in (free, ended):
            over = found.largest[0] >= watch.limit
            assert np.array_equal(np.isfinite(found.first[0]), over)
            assert over[off < -3 * tol].all()
            assert not over[off > 3 * tol].any()
        assert np.array_equal(ended.cause == 0, over)
        assert np.array_equal(ended.first[0][over], ended.end[over])
        value = {"x1": ended.final["x1"], "y1": ended.final["x0"] ** 2}[row]
        size = np.abs(value) if sign == 0 else sign * value
        begun = over & (ended.end > 0)
        assert (np.abs(size - watch.limit)[begun] <= 4 * tol + 1e-13).all()


def test_the_earliest_of_several_events_ends_the_trajectory(pendulum: Bare):
    w, levels = np.full(3, 2.0), np.array([0.5, 0.2, -0.4])
    watches = tuple(Watch("x0", -1, np.array([-level]), ends=True) for level in levels[::-1])
    found = swings(pendulum, w, watches, 1e-9)
    assert found.end == pytest.approx(np.arccos(0.5) / 2, rel=1e-8)
    assert (found.cause == 2).all()
    assert np.isinf(found.first[:2]).all()


# --- Threads and processes ----------------------------------------------------------------------


def test_no_more_threads_are_made_than_help(pendulum: Bare):
    watches = (Watch("x0"),)
    few = swings(pendulum, np.linspace(1.0, 2.0, 50), watches, 1e-6)
    task = task_of(
        pendulum, np.tile([1.0, 0.0], (50, 1)), np.linspace(1, 2, 50)[:, None], 10.0, 1e-6
    )
    many = lanes.integrate(replace(task, watches=watches), threads=10**12)
    assert many.largest.tobytes() == few.largest.tobytes()
