"""Steady turns against SciPy's root finder on the equations as SymPy prints them."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from oracles import BROTT, MODELS, PER_DEGREE, points, right_hand_side
from scipy.integrate import solve_ivp
from scipy.optimize import root

import groundroll as gr

SLIP = np.radians(20.0)


def aircraft(model="nonlinear", **changes):
    """The thesis's aircraft in Trial 19 as plain numbers, with changes."""
    names = map(str, MODELS[model].parameters)
    return gr.Aircraft("random", {**{name: BROTT[name] for name in names}, **changes})


def rates(plane, model, v, r, force):
    """(v_dot, r_dot) as SymPy prints them."""
    p = np.array([float(plane[str(q)]) for q in MODELS[model].parameters])
    x = np.array([v, r, 0.0, 0.0, 0.0, 0.0, 0.0])
    return right_hand_side(model)(x, [force], p)[:2]


def equilibria_by_scipy(plane, force, starts=15):
    """Every equilibrium within 20 degrees of slip that SciPy finds from a grid of starts."""
    speed, arm = float(plane["u"]), float(plane["a"])
    found = []
    for v in np.linspace(-0.5, 0.5, starts) * speed:
        for r in np.linspace(-0.8, 0.8, 5):
            result = root(lambda x: rates(plane, "nonlinear", *x, force), [v, r], tol=1e-12)
            slip = np.arctan((result.x[0] + arm * result.x[1]) / speed)
            is_new = all(np.abs(result.x - known).max() > 1e-6 for known in found)
            if result.success and abs(slip) < SLIP - 1e-3 and is_new:
                found.append(result.x)
    return np.array(sorted(found, key=lambda x: np.arctan((x[0] + arm * x[1]) / speed)))


@pytest.mark.parametrize(
    ("changes", "force"),
    [
        ({}, 0.0),
        ({"Ct": 60 * PER_DEGREE}, 0.0),
        ({"Ct": 60 * PER_DEGREE}, 15.0),
        ({"Ct": 0.0, "a": 0.5}, 100.0),
        ({"Ct": 145 * PER_DEGREE}, 900.0),
        ({"a": -0.5, "Ct": 0.0}, -300.0),
    ],
)
def test_scipy_finds_no_other_equilibria(changes, force):
    plane = aircraft(**changes)
    trim = gr.trim(plane, disturbance=force)
    inside = np.abs(trim["alpha"]) < SLIP - 1e-3
    found = np.stack([trim["v"], trim["r"]], axis=1)[inside]
    expected = equilibria_by_scipy(plane, force)
    assert len(found) == len(expected)
    np.testing.assert_allclose(found, expected, atol=1e-8)


@given(points("nonlinear"), st.floats(-2000.0, 2000.0))
def test_nothing_accelerates_at_an_equilibrium(point, force):
    names = map(str, MODELS["nonlinear"].parameters)
    plane = gr.Aircraft("random", dict(zip(names, point[2], strict=True)))
    trim = gr.trim(plane, disturbance=force)
    scale = abs(force) / float(plane["m"]) + 1.0
    for turn in trim.points:
        left = rates(plane, "nonlinear", turn.v, turn.r, force)
        np.testing.assert_allclose(left, 0.0, atol=1e-9 * scale)
    assert (np.abs(trim["alpha"]) <= SLIP * (1 + 1e-12)).all()
    assert (np.diff(trim["alpha"]) > 0).all()


@given(points("linear"), st.floats(-2000.0, 2000.0))
def test_the_linear_tire_has_the_one_equilibrium_of_its_matrices(point, force):
    names = map(str, MODELS["linear"].parameters)
    plane = gr.Aircraft("random", dict(zip(names, point[2], strict=True)))
    lin = gr.linearize(plane, "linear")
    trim = gr.trim(plane, "linear", disturbance=force)
    expected = np.linalg.solve(lin.A, -lin.B[:, 0] * force)
    assert int(trim.count) == 1
    np.testing.assert_allclose([trim["v"][0], trim["r"][0]], expected, rtol=1e-6, atol=1e-9)
    assert bool(trim.stable[0]) == bool(lin.decay_rate > 0)


def test_an_unstable_aircraft_settles_in_a_turn():
    """With too soft a tail wheel it leaves the straight line and ends on a branch of the trim."""
    plane = aircraft(Ct=60 * PER_DEGREE)
    trim = gr.trim(plane)
    assert trim.stable.tolist() == [True, False, True]
    p = np.array([float(plane[str(q)]) for q in MODELS["nonlinear"].parameters])
    f = right_hand_side("nonlinear")
    start = np.array([1e-3, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])
    run = solve_ivp(lambda t, x: f(x, [0.0], p), (0.0, 300.0), start, rtol=1e-10, atol=1e-12)
    np.testing.assert_allclose(run.y[:2, -1], [trim["v"][2], trim["r"][2]], atol=1e-6)


def test_branches_are_mirror_images():
    plane = aircraft(Ct=60 * PER_DEGREE)
    left, right = gr.trim(plane, disturbance=-15.0), gr.trim(plane, disturbance=15.0)
    for name in ("v", "r", "alpha", "gamma", "F_main"):
        np.testing.assert_allclose(left[name], -right[name][::-1], atol=1e-9)
    np.testing.assert_array_equal(left.stable, right.stable[::-1])


def test_no_force_beyond_the_tires_is_held():
    """The honest answer is none; with it the arrays are empty, not full of guesses."""
    trim = gr.trim(aircraft(), disturbance=20e3)
    assert int(trim.count) == 0
    assert trim["v"].shape == (0,)
    assert trim.points == ()
    assert "no equilibrium" in repr(trim)


def test_a_fold_is_found_on_both_sides():
    """Where two branches meet and vanish, both are there until they do."""
    plane = aircraft(Ct=60 * PER_DEGREE)
    count = gr.trim(plane, disturbance=np.linspace(0.0, 60.0, 601)).count
    assert set(np.unique(count)) <= {1, 2, 3}
    assert (np.diff(count) <= 0).all()
    last_three = np.flatnonzero(count == 3)[-1]
    near = gr.trim(plane, disturbance=np.linspace(0.0, 60.0, 601)[last_three])
    two = np.diff(near["alpha"]).min()
    assert two < np.radians(0.5)


@pytest.mark.parametrize("model", ["linear", "nonlinear"])
@pytest.mark.parametrize("force", [0.0, 100.0])
def test_a_gear_at_the_cg_with_nothing_behind_it_is_named(model, force):
    trim = gr.trim(aircraft(model, a=0.0, Ap=0.0, Ct=0.0), model, disturbance=force)
    assert bool(trim.singular)
    assert int(trim.count) == 0
    assert "does not depend on the slip angle" in repr(trim)


def test_nothing_behind_the_gear_still_has_its_turn():
    """Without a tail a side force there is balanced by the main gear alone: a F_main = -b F."""
    plane = aircraft(a=0.3, Ap=0.0, Ct=0.0)
    trim = gr.trim(plane, disturbance=100.0)
    assert int(trim.count) == 1
    assert float(trim["F_main"][0]) == pytest.approx(-100 * 3.88112 / 0.3, rel=1e-9)
    assert not trim.stable[0]


def test_arrays_go_through():
    arms, forces = np.array([-0.5, 0.3, 0.9])[:, None], np.array([0.0, 50.0])
    many = gr.trim(aircraft(a=arms), disturbance=forces, speed=20.0)
    assert many.count.shape == (3, 2)
    assert many["alpha"].shape == (3, 2, many.count.max())
    for i, arm in enumerate(arms[:, 0]):
        for j, force in enumerate(forces):
            one = gr.trim(aircraft(a=arm), disturbance=force, speed=20.0)
            n = int(one.count)
            assert n == many.count[i, j]
            np.testing.assert_allclose(many["r"][i, j, :n], one["r"], atol=1e-12)
            assert np.isnan(many["r"][i, j, n:]).all()
            assert not many.stable[i, j, n:].any()
    with pytest.raises(gr.GroundrollError, match="one aircraft"):
        _ = many.points


def test_a_point_of_a_trim_is_one_to_linearise_about():
    trim = gr.trim(aircraft(), disturbance=300.0)
    lin = gr.linearize(trim.aircraft, at=trim.points[0])
    np.testing.assert_allclose(lin.drift, 0.0, atol=1e-12)
    assert float(lin.decay_rate) == pytest.approx(float(trim.decay_rate[0]), rel=1e-12)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"slip": 0.0}, "slip must be between"),
        ({"slip": 1.6}, "slip must be between"),
        ({"slip": np.nan}, "finite"),
        ({"disturbance": np.inf}, "finite"),
        ({"disturbance": "strong"}, "number"),
        ({"speed": 0.0}, "positive"),
        ({"model": "square"}, "linear"),
        ({"speed": [1.0, 2.0], "disturbance": [1.0, 2.0, 3.0]}, "broadcast"),
    ],
)
def test_what_cannot_be_is_named(arguments, words):
    with pytest.raises(gr.GroundrollError, match=words):
        gr.trim(aircraft(), **arguments)


def test_an_unknown_name_is_an_error():
    with pytest.raises(gr.GroundrollError, match="alpha"):
        _ = gr.trim(aircraft())["alhpa"]


def test_turns_on_either_side_of_a_sample_are_not_missed():
    """One turn lay exactly on a sample, and hid the two beside it."""
    plane = gr.Aircraft.load("brott-physical").replace(Ct="50 N/deg")
    trim = gr.trim(plane, speed=16.89142788894574)
    np.testing.assert_allclose(np.degrees(trim["alpha"]), [-0.0974060, 0.0, 0.0974060], atol=1e-6)
    assert trim.stable.tolist() == [True, False, True]
    assert trim.complete


@given(st.floats(-12.0, -2.0).map(lambda x: 10.0**x))
def test_three_turns_are_found_however_close_to_the_pitchfork(beyond):
    """Just past the critical speed two turns leave the straight line, as the root of the excess."""
    plane = gr.Aircraft.load("brott-physical").replace(Ct="50 N/deg")
    critical = _critical_speed(plane)
    few, many = (gr.trim(plane, speed=critical * (1 + x)) for x in (-beyond, beyond))
    assert int(few.count) == 1
    assert int(many.count) == 3
    assert many["alpha"][0] == pytest.approx(-many["alpha"][2], rel=1e-3)


def _critical_speed(plane):
    """Where the straight line stops being stable, from the trim's own exact decay rate."""
    low, high = 16.0, 17.5
    for _ in range(80):
        middle = (low + high) / 2
        stable = gr.linearize(plane, speed=middle).decay_rate > 0
        low, high = (middle, high) if stable else (low, middle)
    return low
