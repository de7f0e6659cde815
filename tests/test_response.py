"""Responses against python-control and SciPy; pictures that say what they show."""

import control
import matplotlib as mpl
import numpy as np
import pytest
from hypothesis import given
from matplotlib import pyplot
from oracles import BROTT, MODELS, PER_DEGREE, points

import groundroll as gr
from groundroll.linear.response import follow


@pytest.fixture(autouse=True)
def _no_window():
    mpl.use("Agg")
    yield
    pyplot.close("all")


def aircraft(**changes):
    """The thesis's aircraft in Trial 19 as plain numbers, with changes."""
    names = map(str, MODELS["nonlinear"].parameters)
    return gr.Aircraft("brott", {name: BROTT[name] for name in (*names, "C_alpha")} | changes)


def random_model(point):
    names = map(str, MODELS["linear"].parameters)
    plane = gr.Aircraft("random", dict(zip(names, point[2], strict=True)))
    return gr.linearize(plane, "linear")


@given(points("linear"))
def test_frequency_responses_are_python_controls(point):
    lin = random_model(point)
    system = lin.to_control()
    omega = np.geomspace(0.03, 300.0, 40)
    expected = control.frequency_response(system, omega).frdata[:, 0, :]
    for row, name in enumerate(lin.outputs):
        found = gr.frequency_response(lin, name, frequency=omega).response
        size = np.abs(expected[row]).max() + 1e-300
        np.testing.assert_allclose(found / size, expected[row] / size, atol=1e-9)


def test_a_state_is_an_output_too():
    lin = gr.linearize(aircraft(), at=gr.OperatingPoint(v=0.3))
    omega = np.array([0.0, 1.0, 10.0])
    found = gr.frequency_response(lin, "yaw_rate", frequency=omega)
    solved = [np.linalg.solve(1j * w * np.eye(2) - lin.A, lin.B[:, 0])[1] for w in omega]
    np.testing.assert_allclose(found.response, solved, rtol=1e-12)
    np.testing.assert_allclose(found.magnitude * np.exp(1j * found.phase), solved, rtol=1e-12)


def test_the_default_frequencies_hold_the_modes():
    lin = gr.linearize(aircraft(Ct=145 * PER_DEGREE), "linear")
    omega = gr.frequency_response(lin, "r").frequency
    speeds = np.abs(lin.eigenvalues)
    assert omega[0] < speeds.min() / 10
    assert omega[-1] > speeds.max() * 10


@given(points("linear"))
def test_step_responses_are_python_controls(point):
    lin = random_model(point)
    times = np.linspace(0.0, 1.0, 41)
    expected = control.step_response(lin.to_control(), times).y[:, 0, :]
    for row, name in enumerate(lin.outputs):
        found = gr.step_response(lin, name, t=1.0, samples=41, size=2.0)
        size = np.abs(expected[row]).max() + 1e-300
        np.testing.assert_allclose(found.t, times)
        np.testing.assert_allclose(found.values / size, 2 * expected[row] / size, atol=1e-9)


def test_a_small_step_is_what_the_simulation_does():
    plane = aircraft(Ct=145 * PER_DEGREE)
    run = gr.simulate(plane, "linear", disturbance=100.0, t=3.0, samples=31)
    lin = gr.linearize(plane, "linear")
    for name in ("v", "r", "alpha", "F_main", "a_y"):
        found = gr.step_response(lin, name, size=100.0, t=3.0, samples=31).values
        np.testing.assert_allclose(found, run[name], atol=1e-7 * np.abs(run[name]).max())


def test_arrays_go_through():
    lin = gr.linearize(aircraft(Ct=np.array([[70.0], [112.0]]) * PER_DEGREE), "linear")
    omega = np.array([0.1, 1.0, 10.0])
    assert gr.frequency_response(lin, "alpha", frequency=omega).response.shape == (2, 1, 3)
    steps = gr.step_response(lin, "alpha", samples=7)
    assert steps.values.shape == (2, 1, 7)
    alone = gr.step_response(lin[1, 0], "alpha", samples=7)
    np.testing.assert_allclose(steps.values[1, 0], alone.values, rtol=1e-12)


# --- Root locus --------------------------------------------------------------------------------


def test_a_locus_has_the_eigenvalues_of_each_value():
    values = np.linspace(50.0, 160.0, 45) * PER_DEGREE
    locus = gr.root_locus(aircraft(), "tail_wheel_stiffness", values, "linear")
    for value, found in zip(values, locus.eigenvalues, strict=True):
        expected = gr.linearize(aircraft(Ct=value), "linear").eigenvalues
        np.testing.assert_allclose(np.sort_complex(found), np.sort_complex(expected), atol=1e-12)


def test_modes_are_followed_through_a_crossing():
    """With a C_f = b K the modes are A_vv and A_rr; the second alone moves with the inertia."""
    plane = aircraft()
    tail = BROTT["Ct"] + BROTT["rho"] * BROTT["Ap"] * BROTT["CL_gamma"] / 2 * BROTT["u"] ** 2
    plane = plane.replace(C_alpha=BROTT["b"] * tail / BROTT["a"] / 2)
    crossing = BROTT["m"] * BROTT["a"] * BROTT["b"]  # where A_rr = A_vv
    inertia = np.linspace(0.7, 1.5, 60) * crossing
    lin = gr.linearize(plane.replace(Izz=inertia), "linear")
    assert abs(lin.A[..., 1, 0]).max() < 1e-9
    locus = gr.root_locus(plane, "Izz", inertia, "linear")
    still, moving = locus.eigenvalues.T
    if np.ptp(still.real) > np.ptp(moving.real):
        still, moving = moving, still
    np.testing.assert_allclose(still, lin.A[:, 0, 0], atol=1e-3)
    np.testing.assert_allclose(moving, lin.A[:, 1, 1], atol=1e-3)
    in_order = lin.eigenvalues  # sorted by real part: each column is a bit of both
    assert np.ptp(in_order[:, 0].real) > 10 * np.ptp(still.real)


def test_a_locus_may_run_backwards():
    values = np.linspace(-0.5, 0.6, 30)
    forth = gr.root_locus(aircraft(), "a", values, "linear").eigenvalues
    back = gr.root_locus(aircraft(), "a", values[::-1], "linear").eigenvalues[::-1]
    np.testing.assert_allclose(np.sort_complex(forth), np.sort_complex(back), atol=1e-12)


def test_following_needs_no_particular_order():
    values = np.linspace(0.0, 1.0, 50)
    lines = np.stack([1 - 2 * values, 2 * values - 0.7], axis=1) + 0j
    shuffled = lines.copy()
    shuffled[::2] = shuffled[::2, ::-1]
    np.testing.assert_array_equal(follow(values, shuffled), lines[:, ::-1])


# --- Pictures ------------------------------------------------------------------------------------


def test_a_bode_diagram_names_its_units():
    lin = gr.linearize(aircraft(Ct=[100 * PER_DEGREE, 145 * PER_DEGREE]), "linear")
    above, below = gr.frequency_response(lin, "yaw_rate").plot()
    assert above.get_ylabel() == "magnitude (deg/s/N)"
    assert below.get_ylabel() == "phase (deg)"
    assert below.get_xlabel() == "frequency (rad/s)"
    assert above.get_yscale() == "log"
    assert len(above.get_legend().get_texts()) == 2
    drawn = above.lines[1].get_ydata()
    np.testing.assert_allclose(
        drawn, np.degrees(gr.frequency_response(lin, "yaw_rate").magnitude[1])
    )


def test_decibels_if_asked_for():
    response = gr.frequency_response(gr.linearize(aircraft(), "linear"), "a_y")
    _, axes = pyplot.subplots(2, 1)
    above, below = response.plot(axes, decibels=True)
    assert above is axes[0]
    assert below is axes[1]
    np.testing.assert_allclose(above.lines[0].get_ydata(), 20 * np.log10(response.magnitude))
    with pytest.raises(gr.GroundrollError, match="two axes"):
        response.plot(axes[:1])


def test_step_pole_map_and_locus_draw_where_they_are_told():
    lin = gr.linearize(aircraft(), "linear")
    locus = gr.root_locus(aircraft(), "Ct", np.linspace(2e3, 9e3, 20), "linear")
    step = gr.step_response(lin, "a_y", size=500.0)
    for draw in (step.plot, lambda ax: gr.pole_map(lin, ax), locus.plot):
        _, ax = pyplot.subplots()
        assert draw(ax=ax) is ax
        assert ax.get_xlabel()
        assert "(" in ax.get_ylabel()
    assert "500 N" in step.plot().get_title(loc="left")
    figure = locus.plot(unit="N/deg").figure
    assert any("N/deg" in axis.get_ylabel() for axis in figure.axes)


# --- Bad input ---------------------------------------------------------------------------------


def test_a_singular_matrix_is_named():
    lin = gr.linearize(aircraft(a=0.0, Ap=0.0, Ct=0.0), "linear")
    with pytest.raises(gr.GroundrollError, match="A is singular"):
        gr.frequency_response(lin, "v", frequency=[0.0, 1.0])
    assert np.isfinite(gr.frequency_response(lin, "v").response).all()
    assert np.isfinite(gr.step_response(lin, "v").values).all()


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda lin: gr.frequency_response(lin, "alhpa"), "alpha"),
        (lambda lin: gr.frequency_response(lin, "alpha", "rudder"), "disturbance"),
        (lambda lin: gr.frequency_response(lin, "alpha", frequency=[-1.0]), "zero or more"),
        (lambda lin: gr.frequency_response(lin, "alpha", frequency=[np.nan]), "finite"),
        (lambda lin: gr.frequency_response(lin, "alpha", frequency=[]), "list"),
        (lambda lin: gr.step_response(lin, "alpha", t=0.0), "positive"),
        (lambda lin: gr.step_response(lin, "alpha", samples=1), "whole number from 2"),
        (lambda lin: gr.step_response(lin, "alpha", size=np.inf), "finite"),
        (lambda lin: gr.root_locus(lin.aircraft, "a", [1.0]), "increases or decreases"),
        (lambda lin: gr.root_locus(lin.aircraft, "a", [1.0, 1.0]), "increases or decreases"),
        (lambda lin: gr.root_locus(lin.aircraft, "gear_arm", [1.0, 2.0]), "main_gear_arm"),
        (
            lambda lin: gr.root_locus(lin.aircraft.replace(b=[[1.0], [2.0]]), "a", [0.1, 0.2]),
            "one parameter",
        ),
    ],
)
def test_what_cannot_be_is_named(call, words):
    with pytest.raises(gr.GroundrollError, match=words):
        call(gr.linearize(aircraft(), "linear"))


def test_a_step_that_leaves_the_numbers():
    lin = gr.linearize(aircraft(Ct=0.0, Ap=0.0), "linear")
    with pytest.raises(gr.GroundrollError, match="beyond what a number can hold"):
        gr.step_response(lin, "v", t=1e4, samples=3)
