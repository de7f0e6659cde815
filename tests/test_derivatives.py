"""Four derivatives of everything agree, none of which knows of the others.

SymPy differentiates the expanded expressions (in 40 digits); CasADi differentiates the builders;
the C code holds Jacobians printed by the chain rule of `derive.core.jacobian`, and forward and
reverse sweeps of its own; the complex step differentiates NumPy.
"""

import re
from collections.abc import Callable
from functools import cache
from itertools import product

import casadi as ca
import mpmath
import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from oracles import MODELS, RANGES, Array, Point, lambdified, parameters, points, state

from groundroll.generated import PACKS, build, integrators, load

BLOCKS = ("x", "u", "p")
NAMES = {"f": "rhs", "g": "outputs"}
Jacobians = dict[str, Array]  # "fx", "fu", ..., "gp"

cases = pytest.mark.parametrize("model", MODELS)


def results(model: str, function: str) -> list[sp.Expr]:
    return [*({"f": MODELS[model].rates, "g": MODELS[model].outputs}[function])]


def groups(model: str) -> dict[str, tuple[sp.Symbol, ...]]:
    m = MODELS[model]
    return {"x": m.states, "u": m.inputs, "p": m.parameters}


@cache
def symbolic(model: str) -> dict[str, Callable[..., list[list[mpmath.mpf]]]]:
    """Every Jacobian by `sympy.diff` of the whole expression, to be called with mpmath."""
    whole = {f: sp.Matrix([MODELS[model].explicit(e) for e in results(model, f)]) for f in "fg"}
    arguments = [q for group in groups(model).values() for q in group]
    return {
        f + key: sp.lambdify(arguments, whole[f].jacobian(group), modules="mpmath", cse=True)
        for f, (key, group) in product("fg", groups(model).items())
    }


def by_sympy(model: str, point: Point) -> Jacobians:
    with mpmath.workdps(40):
        exact = [mpmath.mpf(float(value)) for block in point for value in block]
        return {
            name: np.array(jacobian(*exact).tolist(), dtype=float)
            for name, jacobian in symbolic(model).items()
        }


@cache
def differentiated(model: str) -> ca.Function:
    """Automatic differentiation of the builders, in CasADi's virtual machine."""
    at = [ca.SX.sym(key, len(group)) for key, group in groups(model).items()]
    values = {f: build(f"{model}_{name}")(*at) for f, name in NAMES.items()}
    names = [f + key for f, key in product("fg", BLOCKS)]
    jacobians = [ca.densify(ca.jacobian(values[f], by)) for f, by in product("fg", at)]
    return ca.Function("differentiated", at, jacobians, [*BLOCKS], names)


def by_casadi(model: str, point: Point) -> Jacobians:
    function = differentiated(model)
    return dict(zip(function.name_out(), map(np.array, function.call([*point])), strict=True))


def by_compiled_jacobian(model: str, point: Point) -> Jacobians:
    function = load(f"{model}_jacobians")
    return dict(zip(function.name_out(), map(np.array, function.call([*point])), strict=True))


def by_compiled_forward(model: str, point: Point) -> Jacobians:
    """Columns, from one forward sweep for each direction."""
    found = {}
    for (f, name), (n, key) in product(NAMES.items(), enumerate(BLOCKS)):
        function = load(f"{model}_{name}")
        sweep, value = function.forward(1), function(*point)
        columns = []
        for direction in np.eye(point[n].size):
            seeds = [np.zeros(block.size) for block in point]
            seeds[n] = direction
            columns.append(np.array(sweep(*point, value, *seeds))[:, 0])
        found[f + key] = np.array(columns).T
    return found


def by_compiled_reverse(model: str, point: Point) -> Jacobians:
    """Rows, from one reverse sweep for each result."""
    found = {}
    for f, name in NAMES.items():
        function = load(f"{model}_{name}")
        sweep, value = function.reverse(1), function(*point)
        rows = [sweep.call([*point, value, seed]) for seed in np.eye(function.size1_out(0))]
        for n, key in enumerate(BLOCKS):
            found[f + key] = np.array([np.array(row[n])[:, 0] for row in rows])
    return found


@cache
def numerical(model: str, function: str) -> Callable[..., list[complex]]:
    return lambdified(MODELS[model], results(model, function))


def by_complex_step(model: str, point: Point) -> Jacobians:
    step, flat = 1e-40, np.concatenate(point).astype(complex)
    edges = np.cumsum([block.size for block in point])[:-1]
    found = {}
    for f in NAMES:
        columns = []
        for n in range(flat.size):
            shifted = flat.copy()
            shifted[n] += step * 1j
            columns.append(np.imag(numerical(model, f)(*shifted)) / step)
        blocks = np.split(np.array(columns).T, edges, axis=1)
        found |= {f + key: block for key, block in zip(BLOCKS, blocks, strict=True)}
    return found


WAYS = [
    by_casadi,
    by_compiled_jacobian,
    by_compiled_forward,
    by_compiled_reverse,
    by_complex_step,
]


def spans(model: str, block: str) -> Array:
    """How far each entry of x, u or p ranges: what a derivative by it is to be measured with."""
    return np.array([np.ptp(RANGES[str(q)]) for q in groups(model)[block]])


def assert_same(found: Jacobians, exact: Jacobians, model: str) -> None:
    """Equal to 1e-12 of the largest effect that any argument has on the same result."""
    reach = {f: np.zeros(len(results(model, f))) for f in "fg"}
    for name, jacobian in exact.items():
        reach[name[0]] = np.maximum(reach[name[0]], (abs(jacobian) * spans(model, name[1])).max(1))
    for name, jacobian in exact.items():
        allowed = 1e-12 * reach[name[0]][:, None] / spans(model, name[1])
        error = abs(found[name] - jacobian)
        worst = np.unravel_index((error - allowed).argmax(), error.shape)
        assert (error <= allowed).all(), (
            f"{name}{list(map(int, worst))}: {found[name][worst]!r}, exactly {jacobian[worst]!r}"
        )


@cases
@pytest.mark.parametrize("way", WAYS)
@given(data=st.data())
def test_derivatives_agree(way: Callable[[str, Point], Jacobians], model: str, data: st.DataObject):
    point = data.draw(points(model))
    assert_same(way(model, point), by_sympy(model, point), model)


@cases
def test_a_derivative_that_is_off_in_the_eleventh_digit_is_noticed(model: str):
    point = (state(v=1.0, r=0.2, psi=0.3), np.array([500.0]), parameters(model))
    exact = by_sympy(model, point)
    slightly_off = {**exact, "fp": exact["fp"] * (1 + 1e-11)}
    with pytest.raises(AssertionError, match="fp"):
        assert_same(slightly_off, exact, model)


@cases
def test_at_rest_the_slip_angle_is_smooth(model: str):
    point = (state(), np.zeros(1), parameters(model))
    for way in WAYS:
        assert_same(way(model, point), by_sympy(model, point), model)


# --- Through the integrators ----------------------------------------------------------------


def central_difference(function: Callable[[Array], Array], at: Array, step: Array) -> Array:
    """Fourth-order central differences, a column for each entry of `at`."""
    columns = []
    for n, h in enumerate(step):
        e = h * np.eye(at.size)[n]
        near = function(at + e) - function(at - e)
        far = function(at + 2 * e) - function(at - 2 * e)
        columns.append((8 * near - far) / (12 * h))
    return np.array(columns).T


@pytest.mark.parametrize("method", integrators.METHODS)
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
    for n, span in enumerate([spans(model, key) for key in BLOCKS] + [np.array([0.2])]):

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


@pytest.mark.parametrize("method", integrators.METHODS)
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


EXPORTED = re.compile(r"^CASADI_SYMBOL_EXPORT int (\w+)\(const casadi_real\*\* arg", re.MULTILINE)


#: Parameters above which a model is large.
_MANY = 60


@pytest.mark.parametrize(
    ("pack", "c_file"),
    [
        (p, c)
        for p, pack in PACKS.items()
        for c in sorted({c for *_, c in pack.functions.values()})
        if c
    ],
)
def test_libraries_export_what_an_exact_hessian_needs_and_no_jacobian_of_an_adjoint(
    pack: str, c_file: str
):
    """`jac_adj1` of an integrator has empty blocks: IPOPT would get a wrong Hessian in silence."""
    exported = set(EXPORTED.findall((PACKS[pack].sources / f"{c_file}.c").read_text()))
    plain = {name for name in exported if not name.startswith(("fwd", "adj", "jac"))}
    assert plain
    prefixes = ("", "fwd1_", "adj1_", "fwd1_adj1_")
    if len(PACKS[pack].parameters) > _MANY and c_file == "model":
        # of a large model only what moves has derivatives, to keep the pack compact
        assert not any(name.startswith(("jac", "fwd1_jac", "adj1_jac")) for name in exported)
        plain = {f"{pack}_rhs", f"{pack}_outputs"}
        exported = {name for name in exported if name.endswith(tuple(plain))}
    assert exported == {prefix + name for prefix, name in product(prefixes, plain)}
