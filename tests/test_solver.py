"""One trajectory whose lanes are moments: right, whatever the grid, and honest about failure."""

from __future__ import annotations

import pickle
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.polynomial import chebyshev, legendre
from oracles import MODELS, right_hand_side
from scipy.integrate import solve_ivp

import groundroll as gr
from groundroll.derive.emit.simd.lanes import NUMBERS
from groundroll.model.names import signature
from groundroll.motion import lanes

PLANE = gr.Aircraft.load("brott-physical")
#: Well behaved at large slip angles.
LARGE_SLIP = {"B1": 0.7587, "C1": 1.187, "D1": 1.017, "E1": 0.387}
TIMES = np.linspace(0.0, 5.0, 41)


def solve(
    plane: gr.Aircraft, start: dict[str, float], model: str = "nonlinear", **options: object
) -> np.ndarray:
    """The solver's rows for named initial states."""
    states = signature(model).states
    x0 = np.array([start.get(s, 0.0) for s in states])
    return gr.solver(model, **options)(x0, np.zeros(1), plane.parameters(model))


def scipy(plane: gr.Aircraft, start: dict[str, float], model: str) -> np.ndarray:
    """All states at `TIMES`, by SciPy from what SymPy prints."""
    states = list(map(str, MODELS[model].states))
    f, p = right_hand_side(model), plane.parameters(model)
    run = solve_ivp(
        lambda t, x: f(x, np.zeros(1), p),
        (0.0, TIMES[-1]),
        [start.get(s, 0.0) for s in states],
        method="DOP853",
        t_eval=TIMES,
        rtol=1e-13,
        atol=1e-18,
    )
    return run.y


# --- Right ----------------------------------------------------------------------------------


@settings(max_examples=40, deadline=None)
@given(
    model=st.sampled_from(["linear", "nonlinear"]),
    tol=st.sampled_from([1e-3, 1e-6, 1e-9]),
    a=st.floats(-0.6, 1.0),
    Ct=st.floats(0.0, 8000.0),
    speed=st.floats(15.0, 40.0),
    v=st.floats(-6.0, 6.0),
    r=st.floats(-0.4, 0.4),
    large_slip=st.booleans(),
)
def test_it_keeps_the_tolerance_against_scipy(
    model: str,
    tol: float,
    a: float,
    Ct: float,
    speed: float,
    v: float,
    r: float,
    large_slip: bool,
):
    plane = PLANE.replace(a=a, Ct=Ct, speed=speed, **(LARGE_SLIP if large_slip else {}))
    start, states = {"v": v, "r": r}, signature(model).states
    exact = scipy(plane, start, model)
    rows = solve(plane, start, model, t=TIMES, names=states, tol=tol)
    scale = np.maximum(np.abs(exact).max(axis=1, keepdims=True), 1e-6)
    # SciPy itself is good to some 1e-11 here
    assert (np.abs(rows - exact) / scale).max() <= tol + 2e-11


@pytest.mark.parametrize("model", ["linear", "nonlinear"])
def test_a_solver_is_one_trajectory_of_an_ensemble(model: str):
    names = ("v", "psi", "Y", "alpha")
    solver = gr.solver(model, TIMES, names=names, tol=1e-9)
    x0 = np.array([0.5, 0.1, 0.0, 0.0, 0.0, 0.0, 0.0])
    rows = solver(x0, np.array([50.0]), PLANE.parameters(model))
    ens = gr.ensemble(
        PLANE, 5.0, model, at=TIMES, names=names, tol=1e-9, v0=0.5, r0=0.1, disturbance=50.0
    )
    assert rows.shape == (4, TIMES.size)
    for row, name in zip(rows, names, strict=True):
        assert np.abs(row - ens[name]).max() < 1e-8 * max(1.0, np.abs(row).max())
    assert solver.status == "ok"


def test_the_grid_changes_no_bit_of_what_is_found():
    start = {"v": 3.0, "r": 0.2}
    fine = solve(PLANE, start, t=np.linspace(0.0, 5.0, 501))
    coarse = solve(PLANE, start, t=np.linspace(0.0, 5.0, 6))
    end = solve(PLANE, start, t=5.0)
    assert np.array_equal(coarse, fine[:, ::100])
    assert np.array_equal(end[:, -1], fine[:, -1])


def test_the_first_row_is_the_start():
    rows = solve(PLANE, {"v": 3.0, "r": 0.2, "y": 7.0}, t=TIMES)
    assert rows[:, 0] == pytest.approx([3.0, 0.2, 7.0, 0.0], abs=1e-14)


def test_an_aircraft_at_rest_stays_at_rest():
    assert not solve(PLANE, {}, t=TIMES).any()


def test_calls_do_not_remember_each_other():
    solver = gr.solver(t=TIMES)
    p, u = PLANE.parameters("nonlinear"), np.zeros(1)
    starts = [np.array([v, 0.1, 0, 0, 0, 0, 0]) for v in (0.5, 6.0)]
    first = [solver(x0, u, p) for x0 in starts]
    assert np.array_equal(first[0], solver(starts[0], u, p))
    assert np.array_equal(first[1], solver(starts[1], u, p))


# --- Failure --------------------------------------------------------------------------------


def test_what_grows_without_bound_is_said():
    """The linear taildragger's divergence passes the largest number."""
    plane = PLANE.replace(a=1.0, Ct=0.0, speed=40.0)
    t = np.linspace(0.0, 5000.0, 11)
    solver = gr.solver("linear", t)
    rows = solver(np.array([0.1, 0, 0, 0, 0, 0, 0.0]), np.zeros(1), plane.parameters("linear"))
    assert solver.status in ("not finite", "step limit")
    assert np.isfinite(rows[:, 0]).all()
    assert np.isnan(rows[:, -1]).all()


def test_not_a_number_is_not_passed_on_in_silence():
    solver = gr.solver(t=TIMES)
    x0 = np.array([np.nan, 0, 0, 0, 0, 0, 0])
    rows = solver(x0, np.zeros(1), PLANE.parameters("nonlinear"))
    assert solver.status == "not finite"
    assert np.isnan(rows).all()
    assert solver.status in lanes.STATUS


# --- The numbers behind it ------------------------------------------------------------------


def test_the_nodes_are_those_of_gauss():
    nodes = NUMBERS["collocation"]["nodes"]
    assert nodes == pytest.approx(legendre.leggauss(len(nodes))[0], abs=1e-15)


@given(st.lists(st.floats(-1.0, 1.0), min_size=16, max_size=16))
def test_the_tables_integrate_and_expand_every_polynomial(coefficients: list[float]):
    nodes = np.array(NUMBERS["collocation"]["nodes"])
    values = chebyshev.chebval(nodes, coefficients)
    integral = chebyshev.chebint(coefficients, lbnd=-1)
    table = np.array(NUMBERS["collocation"]["integral"])
    assert values @ table == pytest.approx(chebyshev.chebval(nodes, integral) / 2, abs=1e-13)
    series = np.array(NUMBERS["collocation"]["series"])
    assert values @ series == pytest.approx(coefficients, abs=1e-13)


# --- Bad input ------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"t": -1.0}, "increasing times from 0 on"),
        ({"t": [1.0, 0.5]}, "increasing times from 0 on"),
        ({"names": ("w",)}, "unknown name 'w'"),
        ({"tol": 1.0}, "tol must be from"),
    ],
)
def test_mistakes_of_a_solver_are_named(arguments: dict[str, object], message: str):
    with pytest.raises(gr.GroundrollError, match=message):
        gr.solver(**arguments)


# --- Shared -----------------------------------------------------------------------------------


def test_threads_may_share_a_solver():
    """Each of them has room of its own: 7 of 2,000 had been wrong in silence."""
    solve = gr.solver(t=np.linspace(0.0, 2.0, 41))
    p = gr.Aircraft.load("brott").parameters("nonlinear")
    starts = np.zeros((2000, 7))
    starts[:, 0] = np.linspace(0.01, 3.0, 2000)
    alone = [solve(x0, np.zeros(1), p) for x0 in starts]
    with ThreadPoolExecutor(8) as pool:
        shared = list(pool.map(lambda x0: solve(x0, np.zeros(1), p), starts))
    assert all((one == other).all() for one, other in zip(alone, shared, strict=True))


def test_a_solver_can_be_sent_to_another_process():
    solve = gr.solver("linear", t=[0.5, 1.0], names=("v", "psi", "gamma"), tol=1e-9)
    p = gr.Aircraft.load("brott").parameters("linear")
    again = pickle.loads(pickle.dumps(solve))
    x0 = np.array([0.3, 0.1, 0, 0, 0, 0, 0])
    assert (again(x0, np.zeros(1), p) == solve(x0, np.zeros(1), p)).all()
