"""Derivatives through the integrators: of a step, of a trajectory, in an optimiser."""

from collections.abc import Callable

import casadi as ca
import numpy as np
import pytest
from every import NAMES, Array, case
from hypothesis import given, settings
from hypothesis import strategies as st
from oracles import MODELS, RANGES, parameters, points, state

from groundroll.generated import integrators, load

cases = pytest.mark.parametrize("model", MODELS)
methods = pytest.mark.parametrize("method", integrators.METHODS)


@methods
@pytest.mark.parametrize("name", NAMES)
def test_a_step_of_every_model_has_the_slope_of_its_differences(name: str, method: str):
    """Along one direction in all of x, u, p and h at once, and back by the adjoint."""
    model, (h,) = case(name), [0.01]
    step = model.pack.function(method)
    rng = np.random.default_rng(4)
    for point in model.some(2):
        at = [*point, np.array([h])]
        spans = [*(model.span(key) for key in "xup"), np.array([h])]
        along = [1e-2 * span * rng.uniform(-1, 1, span.size) for span in spans]
        end = step(*at)

        def moved(e: float, at: list[Array] = at, along: list[Array] = along) -> Array:
            return np.array(step(*(a + e * d for a, d in zip(at, along, strict=True)))).ravel()

        e = 1e-2
        slope = (8 * (moved(e) - moved(-e)) - (moved(2 * e) - moved(-2 * e))) / (12 * e)
        found = np.array(step.forward(1)(*at, end, *along)).ravel()
        size = np.abs(found).max()
        np.testing.assert_allclose(found, slope, rtol=1e-5, atol=1e-6 * size)
        back = rng.uniform(-1, 1, found.size)
        adjoint = step.reverse(1).call([*at, end, back])
        inward = sum(float(np.array(g).ravel() @ d) for g, d in zip(adjoint, along, strict=True))
        assert inward == pytest.approx(found @ back, rel=1e-9, abs=1e-9 * size)


def spans(model: str, block: str) -> Array:
    """How far each entry of x, u or p ranges."""
    groups = {"x": MODELS[model].states, "u": MODELS[model].inputs, "p": MODELS[model].parameters}
    return np.array([np.ptp(RANGES[str(q)]) for q in groups[block]])


def central_difference(function: Callable[[Array], Array], at: Array, step: Array) -> Array:
    """Fourth-order central differences, a column for each entry of `at`."""
    columns = []
    for n, h in enumerate(step):
        e = h * np.eye(at.size)[n]
        near = function(at + e) - function(at - e)
        far = function(at + 2 * e) - function(at - 2 * e)
        columns.append((8 * near - far) / (12 * h))
    return np.array(columns).T


@methods
@cases
@settings(max_examples=10)
@given(data=st.data())
def test_sensitivities_of_a_trajectory_are_its_finite_differences(
    method: str, model: str, data: st.DataObject
):
    F = load(f"{model}_{method}")
    x, u, p = data.draw(points(model, b=4.0, u=28.0))
    h = np.array([0.05])
    point = [x, u, p, h]
    for n, span in enumerate([spans(model, key) for key in "xup"] + [np.array([0.2])]):

        def final(block: Array, n: int = n) -> Array:
            return np.array(F(*point[:n], block, *point[n + 1 :]))[:, 0]

        expected = central_difference(final, point[n], 2e-4 * span)
        J = F.jacobian()(*point, F(*point))[n]
        scale = abs(final(point[n])).max()
        np.testing.assert_allclose(
            np.array(J) * span, expected * span, rtol=1e-6, atol=1e-7 * scale
        )


def steering_problem(F: ca.Function, intervals: int = 4) -> tuple[dict[str, ca.MX], Array]:
    """Push the tail so as to come back to the centreline, pointing along it, with little force."""
    x = ca.DM(state(v=0.5, r=0.05))
    p = parameters(F.name().split("_")[0])
    pushes = ca.MX.sym("pushes", intervals)
    path: ca.MX = x
    for n in range(intervals):
        path = F(path, 1000 * pushes[n], p, 0.4)
    # v, r, Y and psi at the end
    cost = ca.sumsqr(ca.vertcat(path[0], 10 * path[1], path[5], 10 * path[6]))
    return {"x": pushes, "f": cost + 1e-3 * ca.sumsqr(pushes)}, np.full(intervals, 0.1)


def solver(problem: dict[str, ca.MX], **options: str) -> ca.Function:
    quiet = {"print_level": 0, "sb": "yes", "tol": 1e-10, **options}
    return ca.nlpsol("solver", "ipopt", problem, {"ipopt": quiet, "print_time": False})


@methods
@cases
def test_hessian_in_ipopt_is_the_finite_difference_of_the_gradient(method: str, model: str):
    problem, start = steering_problem(load(f"{model}_{method}"))
    nlp = solver(problem)
    gradient, hessian = (nlp.get_function(f"nlp_{name}") for name in ("grad_f", "hess_l"))
    found = np.array(ca.triu2symm(ca.triu(hessian(start, [], 1, []))))
    expected = central_difference(
        lambda pushes: np.array(gradient(pushes, [])[1])[:, 0], start, np.full(start.size, 1e-3)
    )
    np.testing.assert_allclose(found, expected, rtol=1e-6, atol=1e-7 * abs(found).max())
    assert abs(found).min() > 1e-3  # no block of it is empty


def test_exact_hessians_solve_in_fewer_steps_to_the_same_answer():
    problem, start = steering_problem(load("nonlinear_rk45"))
    solvers = solver(problem), solver(problem, hessian_approximation="limited-memory")
    exact, approximate = (nlp(x0=start) for nlp in solvers)
    steps = [nlp.stats()["iter_count"] for nlp in solvers]
    assert all(nlp.stats()["success"] for nlp in solvers)
    np.testing.assert_allclose(exact["x"], approximate["x"], rtol=1e-4)
    assert steps[0] < steps[1]


def test_the_linear_steering_problem_is_solved_in_one_newton_step():
    """The cost is quadratic in the push, so the least-squares solution is known."""
    F = load("linear_rk45")
    p, start = parameters("linear"), state(v=0.01)
    push = ca.MX.sym("push")
    end = F(start, push, p, 1.0)
    problem = {"x": push, "f": ca.sumsqr(end[:2])}
    slope, rest = (np.array(F(x0, f, p, 1.0))[:2, 0] for x0, f in ((0, 1.0), (start, 0.0)))
    nlp = solver(problem)
    best = float(nlp(x0=0.0)["x"])
    assert best == pytest.approx(-slope @ rest / (slope @ slope), rel=1e-8)
    assert nlp.stats()["iter_count"] <= 2
