"""`simulate`, `integrator` and metrics: what users call."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

import groundroll as gr
from groundroll.model.names import MODELS

TRICYCLE = {"cg_station": "13.6 in", "a": -0.5, "Ct": 0}


@pytest.fixture(scope="module")
def plane() -> gr.Aircraft:
    return gr.Aircraft.load("brott")


def test_the_lines_of_the_readme_work(plane: gr.Aircraft) -> None:
    plane = plane.replace(a=-0.5, b=3.92176)
    run = gr.simulate(plane, model="nonlinear", v0=0.1, t=5.0, samples=501)
    assert run.t.shape == run["v"].shape == run["theta"].shape == run["alpha"].shape == (501,)
    lin = gr.linearize(plane, model="nonlinear", at=gr.OperatingPoint(v=0.4, r=0.02))
    assert lin.A.shape == (2, 2)
    assert lin.B.shape == (2, 1)
    assert lin.C.shape == (len(lin.outputs), 2)
    assert lin.D.shape == (len(lin.outputs), 1)
    F = gr.integrator(model="nonlinear", method="rk45", t=[0.1, 0.2, 5.0])
    assert isinstance(F, ca.Function)
    assert F.name_in() == ["x0", "u", "p"]
    assert F.name_out() == ["xf"]
    assert F.size_out(0) == (7, 3)


def test_full_names_and_symbols_are_the_same(plane: gr.Aircraft) -> None:
    run = gr.simulate(plane, v0=0.1, t=0.1, samples=3)
    assert run["yaw_rate"] is run["r"]
    assert plane["mass"] == plane["m"]


def test_the_time_is_found_by_name_too(plane: gr.Aircraft) -> None:
    run = gr.simulate(plane, v0=0.1, t=1.0, samples=11)
    assert run["t"] is run.t
    assert run["time"] is run.t


def test_samples_are_those_of_the_integrator(plane: gr.Aircraft) -> None:
    run = gr.simulate(plane, v0=0.1, r0=0.02, psi0=0.01, t=2.0, samples=5)
    p = plane.parameters("nonlinear")
    x0 = [0.1, 0.02, 0, 0, 0, 0, 0.01]
    xf = np.array(gr.integrator(t=[0.5, 1.0, 1.5, 2.0])(x0, 0, p))
    states = np.array([run[s] for s in MODELS["nonlinear"].states])
    assert states[:, 0] == pytest.approx(x0, abs=0)
    assert np.abs(states[:, 1:] - xf).max(axis=1) == pytest.approx(0.0, abs=3e-9)


def test_a_grid_does_not_change_the_motion(plane: gr.Aircraft) -> None:
    p = plane.parameters("nonlinear")
    x0 = [0.5, 0, 0, 0, 0, 0, 0]
    coarse = np.array(gr.integrator(t=5.0)(x0, 0, p))[:, -1]
    fine = np.array(gr.integrator(t=np.linspace(0.01, 5.0, 500))(x0, 0, p))[:, -1]
    assert fine == pytest.approx(coarse, rel=1e-8, abs=1e-10)


@pytest.mark.parametrize("model", ["linear", "nonlinear"])
def test_arrays_go_through(plane: gr.Aircraft, model: str) -> None:
    many = plane.replace(a=np.array([-0.5, 0.0, 0.5]))
    run = gr.simulate(many, model, v0=np.array([[0.1], [0.2]]), t=1.0, samples=11)
    assert run["v"].shape == (2, 3, 11)
    alone = gr.simulate(plane.replace(a=0.5), model, v0=0.2, t=1.0, samples=11)
    assert run["Y"][1, 2] == pytest.approx(alone["Y"], abs=0)
    assert run["alpha"][1, 2] == pytest.approx(alone["alpha"], abs=0)


def test_speed_and_disturbance_are_those_of_the_run(plane: gr.Aircraft) -> None:
    run = gr.simulate(plane, speed=20.0, disturbance=50.0, t=1.0, samples=3)
    same = gr.simulate(plane.replace(speed="72 km/h"), disturbance=50.0, t=1.0, samples=3)
    assert run["X"] == pytest.approx(same["X"], rel=1e-12)
    assert run["a_y"][0] == pytest.approx(50.0 / plane["m"], rel=1e-12)


def test_one_input_column_for_each_interval(plane: gr.Aircraft) -> None:
    p = plane.parameters("nonlinear")
    F = gr.integrator(t=[0.5, 1.0], piecewise=True)
    half = gr.integrator(t=0.5)
    middle = half(np.zeros(7), 100.0, p)
    end = half(middle, -40.0, p)
    xf = F(np.zeros(7), ca.DM([[100.0, -40.0]]), p)
    assert np.array(xf[:, 1]) == pytest.approx(np.array(end), rel=1e-9, abs=1e-12)


def test_rk4_approaches_rk45(plane: gr.Aircraft) -> None:
    p = plane.parameters("nonlinear")
    x0 = [0.5, 0.1, 0, 0, 0, 0, 0]
    exact = np.array(gr.integrator(t=1.0)(x0, 0, p))
    error = [
        np.abs(np.array(gr.integrator(method="rk4", t=1.0, step=h)(x0, 0, p)) - exact).max()
        for h in (0.1, 0.05)
    ]
    assert 12 < error[0] / error[1] < 22


@pytest.mark.parametrize("model", ["linear", "nonlinear"])
def test_steady_state_is_the_inverse_of_A(plane: gr.Aircraft, model: str) -> None:
    """[y, theta] = -A^-1 x0 (linear model; the non-linear one for a small start)."""
    run = gr.simulate(plane, model, v0=1e-6, r0=2e-7, t=1.0)
    metrics = run.metrics()
    expected = -np.linalg.solve(gr.linearize(plane, model).A, [1e-6, 2e-7])
    assert [metrics.displacement, metrics.rotation] == pytest.approx(expected, rel=1e-6)


def test_metrics_of_a_first_order_response(plane: gr.Aircraft) -> None:
    """Main gear at the CG, no tail: y = v0 T (1 - exp(-t/T))."""
    roll = gr.simulate(plane.replace(a=0.0, b=3.9, Ap=0.0, Ct=0.0), "linear", v0=0.1, t=1.0)
    T = float(plane["m"] * plane["u"] / (2 * plane["C_alpha"]))
    m = roll.metrics()
    assert m.displacement == pytest.approx(0.1 * T, rel=1e-8)
    assert m.time_constant == pytest.approx(T, rel=1e-6)
    assert m.settling_time == pytest.approx(T * np.log(20), rel=1e-6)
    assert m.rise_time == pytest.approx(T * np.log(9), rel=1e-6)
    assert m.overshoot == pytest.approx(0.0, abs=1e-9)


def test_metrics_of_several_runs_and_of_an_unstable_one(plane: gr.Aircraft) -> None:
    pair = plane.replace(**{**TRICYCLE, "a": np.array([-0.5, 0.5])})
    m = gr.simulate(pair, "linear", v0=0.1).metrics()
    assert m.displacement.shape == (2,)
    assert m.overshoot[0] == pytest.approx(2.81, abs=0.01)
    assert np.isnan([m.displacement[1], m.settling_time[1], m.overshoot[1]]).all()


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"v0": np.nan}, "v0 must be finite"),
        ({"v0": [0.1, np.inf]}, r"v0\[1\] = inf"),
        ({"v0": "fast"}, "v0: found 'fast', which is not a number with a unit; expected a speed"),
        ({"v0": "1 kg"}, "v0: found '1 kg', a mass; expected a speed"),
        ({"speed": 0.0}, "speed .* must be positive"),
        ({"speed": -3.0}, "must be positive"),
        ({"disturbance": np.nan}, "disturbance must be finite"),
        ({"t": 0.0}, "t must be a positive number"),
        ({"t": [1.0, 2.0]}, "t must be a positive number"),
        ({"t": 1e9, "disturbance": np.sin}, "looked at: .* GiB"),
        ({"samples": 10**11}, "the series: .* GiB"),
        ({"v0": []}, "nothing to simulate"),
        ({"t": np.nan}, "t must be finite"),
        ({"samples": 1}, "samples must be a whole number from 2"),
        ({"samples": 2.5}, "samples must be a whole number from 2"),
        ({"w0": 1.0}, "unknown argument 'w0'.*v0"),
        ({"method": "rk45"}, "unknown argument 'method'"),
        ({"tol": 1.0}, "tol must be from"),
        ({"until": "stopped"}, "no events"),
        ({"model": "non-linear"}, "unknown model 'non-linear'.*nonlinear"),
        ({"v0": np.zeros(2), "r0": np.zeros(3)}, r"broadcast.*v0 \(2,\), r0 \(3,\)"),
    ],
)
def test_bad_input_is_named(plane: gr.Aircraft, arguments: dict[str, object], message: str) -> None:
    with pytest.raises(gr.GroundrollError, match=message):
        gr.simulate(plane, **arguments)


@pytest.mark.parametrize(
    ("t", "message"),
    [
        ([], "list of numbers"),
        ([0.0, 1.0], "positive and increasing"),
        ([1.0, 1.0], "positive and increasing"),
        ([[1.0, 2.0]], "of shape"),
        ([np.nan], "finite"),
    ],
)
def test_bad_time_grids_are_named(t: object, message: str) -> None:
    with pytest.raises(gr.GroundrollError, match=message):
        gr.integrator(t=t)


def test_a_run_that_leaves_the_numbers_says_so(plane: gr.Aircraft) -> None:
    unstable = plane.replace(**{**TRICYCLE, "a": 0.5})
    with pytest.raises(gr.GroundrollError, match="grows"):
        gr.simulate(unstable, "linear", v0=0.1, t=1000.0, samples=11)


def test_an_unknown_series_names_the_nearest(plane: gr.Aircraft) -> None:
    run = gr.simulate(plane, v0=0.1, t=0.1, samples=3)
    with pytest.raises(KeyError, match=r"unknown state or output 'alfa'.*alpha"):
        run["alfa"]
