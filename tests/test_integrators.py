"""Compiled integrators against SciPy on the equations as SymPy prints them."""

import numpy as np
import pytest
from every import NAMES, Case, case
from hypothesis import given, settings
from hypothesis import strategies as st
from oracles import (
    MODELS,
    TRIALS,
    Array,
    Point,
    call,
    parameters,
    points,
    right_hand_side,
    state,
    values,
)
from scipy.integrate import solve_ivp

import groundroll as gr
from groundroll.generated import build, integrators, load

NO_INPUT = np.zeros(1)

cases = pytest.mark.parametrize("model", MODELS)
methods = pytest.mark.parametrize("method", integrators.METHODS)


def reference(model: str, point: Point, times: Array) -> Array:
    """States, a column for each time, the first of which is zero."""
    x, u, p = point
    f = right_hand_side(model)
    run = solve_ivp(
        lambda t, x: f(x, u, p),
        (0.0, times[-1]),
        x,
        t_eval=times,
        method="DOP853",
        rtol=1e-12,
        atol=1e-14,
    )
    assert run.success
    return run.y


@cases
@settings(max_examples=60)
@given(data=st.data())
def test_rk45_of_a_random_aircraft_is_right_to_1e_8(model: str, data: st.DataObject):
    point, h = data.draw(points(model)), data.draw(values(["h"]))
    expected = reference(model, point, np.linspace(0.0, h[0], 9))
    found = call(load(f"{model}_rk45"), *point, h)
    assert (abs(found - expected[:, -1]) <= 1e-8 * abs(expected).max(axis=1)).all()


@cases
@pytest.mark.parametrize("trial", TRIALS)
def test_rk45_follows_a_trial_of_the_thesis_over_any_grid(trial: int, model: str):
    p = parameters(model, **TRIALS[trial].changes)
    F, start = load(f"{model}_rk45"), state(v=0.1)
    times = np.array([0.0, 0.1, 0.2, 1.7, 3.0])
    expected = reference(model, (start, NO_INPUT, p), times)
    in_one_go = np.array([call(F, start, NO_INPUT, p, t) for t in times]).T
    in_steps = [start]
    for step in np.diff(times):
        in_steps.append(call(F, in_steps[-1], NO_INPUT, p, step))

    allowed = 1e-8 * abs(expected).max(axis=1, keepdims=True)
    assert (abs(in_one_go - expected) <= allowed).all()
    assert (abs(np.array(in_steps).T - expected) <= allowed).all()


@cases
@pytest.mark.parametrize("steps", [16, 32])
def test_rk4_is_of_fourth_order(steps: int, model: str):
    """Half the step, a sixteenth of the largest error, in every state."""
    start, p, t = state(v=1.0, r=0.1), parameters(model), 0.8
    errors = []
    for n in (steps, 2 * steps):
        exact = reference(model, (start, NO_INPUT, p), np.linspace(0.0, t, n + 1))[:, 1:]
        found = load(f"{model}_rk4").mapaccum(n)(start, NO_INPUT, p, t / n)
        errors.append(abs(np.array(found) - exact).max(axis=1))
    assert errors[1].min() > 1e-11  # far above rounding
    np.testing.assert_allclose(errors[0] / errors[1], 16, rtol=0.2)


@cases
@given(data=st.data())
def test_rk4_takes_the_classical_step(model: str, data: st.DataObject):
    (x, u, p), (h,) = data.draw(points(model)), data.draw(values(["h"])) / 20
    f = right_hand_side(model)
    k1 = f(x, u, p)
    k2 = f(x + h / 2 * k1, u, p)
    k3 = f(x + h / 2 * k2, u, p)
    k4 = f(x + h * k3, u, p)
    step = h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    found = call(load(f"{model}_rk4"), x, u, p, h)
    np.testing.assert_allclose(found, x + step, rtol=1e-12, atol=1e-12)


@methods
@cases
@given(data=st.data())
def test_the_virtual_machine_gives_the_same_numbers(model: str, method: str, data: st.DataObject):
    name = f"{model}_{method}"
    arguments = (*data.draw(points(model)), data.draw(values(["h"])) / 5)
    compiled, interpreted = (call(f, *arguments) for f in (load(name), build(name)))
    np.testing.assert_allclose(compiled, interpreted, rtol=1e-12, atol=1e-13)


@methods
@cases
def test_no_time_changes_nothing(model: str, method: str):
    start = state(v=1.0, r=0.1, y=2.0, X=30.0, psi=0.2)
    end = call(load(f"{model}_{method}"), start, [300.0], parameters(model), 0.0)
    np.testing.assert_array_equal(end, start)


@cases
def test_rk45_runs_backwards(model: str):
    F, p, start = load(f"{model}_rk45"), parameters(model), state(v=0.5, r=0.05, psi=0.1)
    there = call(F, start, [100.0], p, 0.7)
    assert abs(there - start).max() > 0.1
    np.testing.assert_allclose(call(F, there, [100.0], p, -0.7), start, atol=1e-8)


@cases
def test_rk45_says_so_when_it_cannot_integrate(model: str):
    with pytest.raises(RuntimeError, match="Evaluation failed"):
        load(f"{model}_rk45")(state(v=np.nan), NO_INPUT, parameters(model), 1.0)


def test_rk45_follows_an_aircraft_that_spins():
    """Trial 3 after 5 s, as in Fig. 4.7: the linear model has turned 250 times by then."""
    p = parameters("linear", **TRIALS[3].changes)
    call(load("linear_rk45"), state(v=0.1), NO_INPUT, p, 5.0)


# --- Every model ----------------------------------------------------------------------------

every = pytest.mark.parametrize("name", NAMES)


def followed(model: Case, point: Point, times: Array) -> Array:
    """States of any model by SciPy, stiff or not, a column for each time."""
    x, u, p = point
    run = solve_ivp(
        lambda t, x: model.rates(x, u, p),
        (0.0, times[-1]),
        x,
        "DOP853",
        times,
        rtol=1e-12,
        atol=1e-13,
    )
    assert run.success
    return run.y


@every
def test_rk45_of_every_model_is_right_to_1e_8(name: str):
    model, h = case(name), 0.2
    step = model.pack.function("rk45")
    for point in model.some(3, seed=7):
        expected = followed(model, point, np.linspace(0.0, h, 5))
        error = abs(call(step, *point, h) - expected[:, -1])
        assert (error <= 1e-8 * (abs(expected).max(axis=1) + 1e-2)).all()


@every
def test_rk4_of_every_model_takes_the_classical_step(name: str):
    model, h = case(name), 1e-3
    for x, u, p in model.some(3, seed=8):
        f = model.rates
        k1 = f(x, u, p)
        k2 = f(x + h / 2 * k1, u, p)
        k3 = f(x + h / 2 * k2, u, p)
        k4 = f(x + h * k3, u, p)
        change = h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        found = call(model.pack.function("rk4"), x, u, p, h) - x
        np.testing.assert_allclose(found, change, rtol=1e-9, atol=1e-12 * abs(x).max())


@every
def test_every_model_is_simulated_as_scipy_does(name: str):
    """By the kernels, with all inputs constant, outputs too."""
    model = case(name)
    (x, u, _), times = model.some(1, seed=9)[0], np.linspace(0.0, 0.5, 11)
    p = model.plane.parameters(model.pack)
    start = {f"{s}0": value for s, value in zip(model.pack.states, x, strict=True)}
    inputs = dict(zip(model.pack.inputs, u, strict=True))
    run = gr.simulate(model.plane, model.pack, t=0.5, samples=11, tol=1e-10, **start, **inputs)
    expected = followed(model, (x, u, p), times)
    for s, row in zip(model.pack.states, expected, strict=True):
        np.testing.assert_allclose(run[s], row, rtol=1e-8, atol=1e-8 * (1 + abs(row).max()))
    shown = np.array([model.outputs(state, u, p) for state in expected.T]).T
    for name, row in zip(model.pack.outputs, shown, strict=True):
        np.testing.assert_allclose(run[name], row, rtol=1e-6, atol=1e-6 * (1 + abs(row).max()))
