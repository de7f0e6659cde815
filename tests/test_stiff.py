"""Ensembles of models that come to rest: right where friction and swivels are stiff."""

from __future__ import annotations

from functools import cache

import casadi as ca
import numpy as np
import pytest
from scipy.integrate import solve_ivp

import groundroll as gr
from groundroll.generated.landing_roll import model as landing_roll
from groundroll.model.models import as_model

MODEL = as_model("landing_roll")
PLANE = gr.Aircraft.load("cessna-170")
#: What the third wheel is -> what makes it so.
THIRD = {
    "fixed": {"third_wheel_swivels": 0.0, "steering_ratio": 0.0},
    "sprung": {"third_wheel_swivels": 1.0, "steering_stiffness": 60.0, "steering_ratio": -0.3},
    "castering": {"third_wheel_swivels": 1.0, "steering_stiffness": 0.0},
}
PUSHED = {"brake_left": 0.4, "brake_right": 0.3, "pedal": 0.2, "wind_y": 3.0}
STATES = tuple(MODEL.states)


@cache
def functions() -> tuple[ca.Function, ca.Function]:
    """Right-hand side and its Jacobian, of the readable builders."""
    rhs = landing_roll.rhs()
    arguments = [ca.SX.sym(name, rhs.size1_in(n)) for n, name in enumerate("xup")]
    slope = ca.densify(ca.jacobian(rhs(*arguments), arguments[0]))
    return rhs, ca.Function("slope", arguments, [slope])


def exact(plane: gr.Aircraft, start: dict[str, float], at: np.ndarray) -> np.ndarray:
    """States at the times by SciPy's Radau, shape (states, times)."""
    rhs, slope = functions()
    p = np.array(plane.parameters(MODEL), float)
    u = np.array([PUSHED.get(s, 0.0) for s in MODEL.inputs])
    run = solve_ivp(
        lambda t, x: np.array(rhs(x, u, p)).ravel(),
        (0.0, at[-1]),
        np.array([start[s] for s in STATES]),
        "Radau",
        at,
        rtol=1e-11,
        atol=1e-13,
        jac=lambda t, x: np.array(slope(x, u, p)),
    )
    assert run.success
    return np.asarray(run.y)


def rolled(plane: gr.Aircraft, t: float, **values: object) -> gr.Ensemble:
    return gr.ensemble(plane, t, MODEL, names=STATES, **(PUSHED | values))


@pytest.fixture(scope="module", params=THIRD)
def reference(request: pytest.FixtureRequest) -> tuple[gr.Aircraft, np.ndarray, np.ndarray]:
    """An aircraft that brakes almost to rest in a crosswind, and its states over time."""
    plane = PLANE.replace(**THIRD[request.param])
    at = np.linspace(0.0, 3.0, 61)
    start = rolled(plane, 1.0, at=[0.0], speed=9.0, v0=0.2)
    return plane, at, exact(plane, {s: float(start[s][..., 0]) for s in STATES}, at)


@pytest.mark.parametrize("tol", [1e-6, 1e-9])
def test_it_agrees_with_radau(reference: tuple[gr.Aircraft, np.ndarray, np.ndarray], tol: float):
    plane, at, truth = reference
    ens = rolled(plane, at[-1], at=at, speed=9.0, v0=0.2, tol=tol)
    assert ens.ok.all()
    for s, wanted in zip(STATES, truth, strict=True):
        scale = max(np.abs(wanted).max(), 1e-6)
        assert np.abs(ens[s] - wanted).max() / scale < tol + 1e-10, s


def cloud(n: int) -> dict[str, np.ndarray]:
    """Random rolls and third wheels."""
    rng = np.random.default_rng(7)
    return {
        "speed": rng.uniform(3.0, 25.0, n),
        "v0": rng.uniform(-0.5, 0.5, n),
        "wind_y": rng.uniform(-5.0, 5.0, n),
        "pedal": rng.uniform(-0.5, 0.5, n),
        "brake_left": rng.uniform(0.0, 0.6, n),
        "third_wheel_swivels": rng.integers(0, 2, n).astype(float),
        "steering_stiffness": rng.choice([0.0, 60.0], n),
    }


@pytest.mark.parametrize("tol", [1e-4, 1e-6])
def test_the_error_at_the_end_is_kept_over_random_rolls(tol: float):
    values = cloud(128)
    ens, fine = (rolled(PLANE, 5.0, tol=each, **values) for each in (tol, 1e-9))
    largest = rolled(PLANE, 5.0, extremes=STATES, tol=1e-6, **values).largest
    assert ens.ok.all()
    assert fine.ok.all()
    for s in STATES:
        error = np.abs(ens[s] - fine[s]) / np.maximum(largest[s], 1e-6)
        assert error.max() < tol, s


def test_bits_do_not_depend_on_threads_or_chunks():
    asked = {"at": [0.0, 1.0, 3.0], "tol": 1e-6, "limits": {"psi": 0.5}, "until": "stopped"}
    one = rolled(PLANE, 3.0, threads=1, **asked, **cloud(50))
    for threads, chunk in ((2, 50), (3, 7), (1, 13)):
        other = rolled(PLANE, 3.0, threads=threads, chunk=chunk, **asked, **cloud(50))
        for s in STATES:
            assert one[s].tobytes() == other[s].tobytes()
        assert one.end.tobytes() == other.end.tobytes()
        assert one.first["psi"].tobytes() == other.first["psi"].tobytes()


def test_slopes_exist_however_far_the_wheel_has_turned():
    _, slope = functions()
    p = np.array(PLANE.replace(**THIRD["castering"]).parameters(MODEL), float)
    start = {"u": 5.0, "Z": -0.9, "theta": 0.2, "chi_third": 5.2}
    x = np.array([start.get(s, 0.0) for s in STATES])
    assert np.isfinite(np.array(slope(x, np.zeros(len(MODEL.inputs)), p))).all()


def test_rolls_to_a_stop_have_fates_and_limits():
    n, rng = 300, np.random.default_rng(2)
    grip = rng.uniform(0.5, 1.0, n)
    surfaces = {f"surface_{wheel}": grip for wheel in ("left", "right", "third")}
    brakes = {"brake_left": 0.3, "brake_right": 0.3}
    ens = gr.ensemble(
        PLANE,
        60.0,
        MODEL,
        speed="30 kt",
        wind_y=rng.normal(0.0, 3.0, n),
        until="stopped",
        limits={"Y": "7.5 m", "psi": "45 deg"},
        chunk=64,
        **brakes,
        **surfaces,
    )
    assert ens.ok.all()
    assert (ens.fate >= 0).all()
    assert (ens.end < 60.0).all()
    for s, limit in (("Y", 7.5), ("psi", np.pi / 4)):
        passed = np.isfinite(ens.first[s])
        assert (passed == (ens.largest[s] >= limit)).all()
        assert 0 < passed.sum() < n
        assert (ens.first[s][passed] <= ens.end[passed]).all()
