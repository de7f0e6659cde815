"""Linear models against finite differences, other eigenvalue solvers and python-control."""

import sys

import control
import numpy as np
import pytest
from hypothesis import assume, given
from oracles import BROTT, MODELS, parameters, points, right_hand_side, state, values

import groundroll as gr
from groundroll.stability.modes import modes_of


def aircraft(model, p=None):
    """An aircraft from a parameter vector, or the thesis's in Trial 19."""
    names = map(str, MODELS[model].parameters)
    p = parameters(model) if p is None else p
    return gr.Aircraft("random", dict(zip(names, p, strict=True)))


def at(point):
    """The operating point of a random (x, u, p)."""
    return gr.OperatingPoint(v=point[0][0], r=point[0][1], disturbance=point[1][0])


def complex_step(model, point, k, size=1e-30):
    """d(v_dot, r_dot)/d(v or r) of the equations as SymPy prints them."""
    f = right_hand_side(model)
    x = point[0].astype(complex)
    x[k] += 1j * size
    return np.array(f(x, point[1], point[2]))[:2].imag / size


@pytest.mark.parametrize("model", ["linear", "nonlinear"])
def test_the_state_matrix_is_the_derivative_anywhere(model):
    @given(points(model))
    def check(point):
        lin = gr.linearize(aircraft(model, point[2]), model, at(point))
        expected = np.stack([complex_step(model, point, k) for k in (0, 1)], axis=1)
        np.testing.assert_allclose(lin.A, expected, rtol=1e-9, atol=1e-9 * np.abs(lin.A).max())
        drift = right_hand_side(model)(*point)[:2]
        np.testing.assert_allclose(lin.drift, drift, atol=1e-9 * (1 + np.abs(drift).max()))

    check()


@pytest.mark.parametrize("model", ["linear", "nonlinear"])
def test_sensitivities_of_a_are_its_differences(model):
    @given(points(model))
    def check(point):
        lin = gr.linearize(aircraft(model, point[2]), model, at(point))
        sensitivities = lin.sensitivities()
        for k in range(len(point[2])):
            step = 1e-6 * max(abs(point[2][k]), 1e-7)
            ends = []
            for side in (1, -1):
                p = point[2].copy()
                p[k] += side * step
                ends.append(gr.linearize(aircraft(model, p), model, at(point)).A)
            slope = (ends[0] - ends[1]) / (2 * step)
            exact = sensitivities.A[..., k]
            rounding = 1e-15 * np.abs(lin.A).max() / step
            np.testing.assert_allclose(
                exact, slope, rtol=1e-6, atol=100 * rounding + 1e-7 * np.abs(exact).max()
            )

    check()


@pytest.mark.parametrize("model", ["linear", "nonlinear"])
def test_sensitivities_of_eigenvalues_are_those_of_their_eigenvectors(model):
    """w^H dA v / (w^H v) with NumPy's eigenvectors; NaN only where the modes meet."""

    @given(points(model))
    def check(point):
        lin = gr.linearize(aircraft(model, point[2]), model, at(point))
        apart = abs(lin.eigenvalues[0] - lin.eigenvalues[1]) / np.abs(lin.eigenvalues).max()
        assume(apart > 1e-3)
        sensitivities = lin.sensitivities()
        found, right = np.linalg.eig(lin.A)
        left = np.linalg.inv(right)
        for k, eigenvalue in enumerate(lin.eigenvalues):
            mode = np.abs(found - eigenvalue).argmin()
            expected = np.einsum("i,ijp,j->p", left[mode], sensitivities.A, right[:, mode])
            size = 1e-7 * np.abs(sensitivities.A).max(axis=(0, 1)) * np.linalg.cond(right)
            assert (np.abs(sensitivities.eigenvalues[k] - expected) <= size + 1e-12).all()
        assert not sensitivities.modes_meet
        np.testing.assert_array_equal(sensitivities.decay_rate, -sensitivities.eigenvalues[0].real)

    check()


def test_modes_that_meet_have_no_slope():
    """Two real modes meet at a tail wheel of about 113 N/deg; the slope is flagged, not guessed."""
    plane = aircraft("linear")
    low, high = 112 * 57.29578, 115 * 57.29578

    def discriminant(stiffness):
        return float(gr.margins(plane.replace(Ct=stiffness)).discriminant)

    assert discriminant(low) > 0 > discriminant(high)
    for _ in range(80):
        middle = (low + high) / 2
        low, high = (middle, high) if discriminant(middle) > 0 else (low, middle)
    meeting = gr.linearize(plane.replace(Ct=[low, 112 * 57.3]), "linear").sensitivities()
    assert meeting.modes_meet.tolist() == [True, False]
    assert np.isnan(meeting["Ct"][0]).all()
    assert np.isfinite(meeting["Ct"][1]).all()
    assert np.isfinite(meeting.A).all()


def test_sensitivities_by_name():
    sensitivities = gr.linearize(aircraft("nonlinear")).sensitivities()
    np.testing.assert_array_equal(sensitivities["a"], sensitivities["main_gear_arm"])
    with pytest.raises(gr.GroundrollError, match="main_gear_arm"):
        _ = sensitivities["main_gear_am"]


@given(values(["A_vv", "A_vr", "A_rv", "A_rr"]))
def test_modes_are_numpys_eigenvalues(entries):
    A = entries.reshape(2, 2)
    modes = modes_of(A)
    found = modes.eigenvalues
    expected = np.linalg.eigvals(A)
    expected = expected[np.lexsort([-expected.imag, -expected.real])]
    np.testing.assert_allclose(found, expected, atol=1e-6 * max(1.0, np.abs(expected).max()))


# --- python-control --------------------------------------------------------------------------


def test_python_control_gets_the_same_model_with_its_names():
    lin = gr.linearize(aircraft("nonlinear"), at=gr.OperatingPoint(v=0.4, r=0.02))
    system = lin.to_control()
    assert isinstance(system, control.StateSpace)
    assert system.state_labels == ["v", "r"]
    assert system.input_labels == ["F_disturbance"]
    assert system.output_labels == list(lin.outputs)
    np.testing.assert_array_equal(system.A, lin.A)
    np.testing.assert_array_equal(system.D, lin.D)
    np.testing.assert_allclose(np.sort(system.poles()), np.sort(lin.eigenvalues), atol=1e-12)
    frequency, damping, poles = control.damp(system, doprint=False)
    np.testing.assert_allclose(frequency, np.abs(poles), rtol=1e-12)
    if np.iscomplex(lin.eigenvalues).any():
        np.testing.assert_allclose(damping, float(lin.damping_ratio), rtol=1e-9)


def test_one_point_at_a_time_goes_to_python_control():
    lin = gr.linearize(aircraft("linear").replace(a=[-0.5, 0.5]), "linear")
    with pytest.raises(gr.GroundrollError, match=r"lin\[0\].to_control"):
        lin.to_control()
    np.testing.assert_array_equal(lin[1].to_control().A, lin.A[1])


def test_without_python_control_the_error_says_what_to_install(monkeypatch):
    monkeypatch.setitem(sys.modules, "control", None)
    with pytest.raises(gr.GroundrollError, match=r"pip install 'groundroll\[control\]'"):
        gr.linearize(aircraft("linear"), "linear").to_control()


# --- Arrays ------------------------------------------------------------------------------------


def test_any_mix_of_arrays_is_that_of_its_points():
    plane = aircraft("nonlinear").replace(a=np.linspace(-0.5, 0.7, 3)[:, None, None])
    v, r = np.array([0.0, 1.0])[:, None], np.array([0.0, 0.1, 0.2, 0.3])
    lin = gr.linearize(plane, at=gr.OperatingPoint(v=v, r=r), speed=[20.0, 30.0, 40.0, 50.0])
    assert lin.A.shape == (3, 2, 4, 2, 2)
    assert lin.sensitivities().A.shape == (3, 2, 4, 2, 2, len(MODELS["nonlinear"].parameters))
    one = lin[2, 1, 3]
    point = gr.OperatingPoint(v=1.0, r=0.3)
    expected = gr.linearize(aircraft("nonlinear").replace(a=0.7), at=point, speed=50.0)
    for name in ("A", "B", "C", "D", "drift", "eigenvalues", "decay_rate"):
        np.testing.assert_allclose(getattr(one, name), getattr(expected, name), rtol=1e-12)
        np.testing.assert_allclose(getattr(lin, name)[2, 1, 3], getattr(one, name), rtol=1e-12)
    np.testing.assert_allclose(
        lin.sensitivities().eigenvalues[2, 1, 3], one.sensitivities().eigenvalues, rtol=1e-9
    )
    assert lin[2].decay_rate.shape == (2, 4)


@pytest.mark.parametrize("index", [5, (0, 0), (0, 0, 0, 0)])
def test_a_point_that_is_not_there(index):
    lin = gr.linearize(aircraft("linear").replace(a=[-0.5, 0.5]), "linear")
    with pytest.raises(gr.GroundrollError, match="there is no"):
        _ = lin[index]


@pytest.mark.parametrize(
    ("point", "words"),
    [
        (gr.OperatingPoint(v=np.nan), "finite"),
        (gr.OperatingPoint(r=[np.inf]), "finite"),
        (gr.OperatingPoint(v=[1.0, 2.0], r=[1.0, 2.0, 3.0]), "broadcast"),
        (gr.OperatingPoint(v="fast"), "number"),
    ],
)
def test_points_that_cannot_be(point, words):
    with pytest.raises(gr.GroundrollError, match=words):
        gr.linearize(aircraft("linear"), "linear", point)


def test_straight_running_does_not_drift():
    lin = gr.linearize(aircraft("nonlinear"))
    np.testing.assert_array_equal(lin.drift, 0.0)
    assert state(v=0.0)[0] == 0
    assert BROTT["a"] == float(lin.aircraft["a"])
