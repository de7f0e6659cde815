"""Four derivatives of every model agree, none of which knows of the others.

Differences in 60 digits of the equations as SymPy prints them are exact, whatever a law is made of;
CasADi differentiates the builders; the C code holds Jacobians printed by the chain rule of
`derive.core.jacobian`, and forward and reverse sweeps of its own. Of the short models SymPy
differentiates the expanded expressions too, and the complex step differentiates NumPy.
"""

import re
from collections.abc import Callable, Sequence
from functools import cache
from itertools import product

import casadi as ca
import mpmath
import numpy as np
import pytest
import sympy as sp
from every import NAMES, Array, Case, Point, case, program
from hypothesis import given, settings
from hypothesis import strategies as st
from oracles import lambdified, parameters, state

from groundroll.generated import PACKS

BLOCKS = ("x", "u", "p")
FUNCTIONS = {"f": "rhs", "g": "outputs"}
Jacobians = dict[str, Array]  # "fx", "fu", ..., "gp"
Way = Callable[[str, Point], Jacobians]

every = pytest.mark.parametrize("name", NAMES)
thesis = pytest.mark.parametrize("name", ["linear", "nonlinear"])


def results(model: Case) -> dict[str, tuple[sp.Expr, ...]]:
    return {"f": model.derived.rates, "g": model.derived.outputs}


def shaped(model: Case, columns: Array) -> Jacobians:
    """Columns of the derivatives of rates and outputs by all of x, u and p, as blocks."""
    rows = len(model.derived.rates)
    edges = np.cumsum([len(group) for group in model.groups.values()])[:-1]
    return {
        f + key: block
        for f, part in (("f", columns[:rows]), ("g", columns[rows:]))
        for key, block in zip(BLOCKS, np.split(part, edges, axis=1), strict=True)
    }


@cache
def in_many_digits(name: str) -> Callable[..., list[mpmath.mpf]]:
    model = case(name)
    return program(model.derived, [*model.derived.rates, *model.derived.outputs], "mpmath")


def exactly(name: str, point: Point) -> Jacobians:
    """Central differences over a step so short that nothing is left of their error."""
    model, columns = case(name), []
    spans = np.concatenate([model.span(key) for key in BLOCKS])
    with mpmath.workdps(60):
        here = [mpmath.mpf(float(value)) for block in point for value in block]
        for n, span in enumerate(spans):
            step = mpmath.mpf(float(span)) * mpmath.mpf(10) ** -20
            high, low = (
                in_many_digits(name)(*here[:n], here[n] + way * step, *here[n + 1 :])
                for way in (1, -1)
            )
            columns.append([float((a - b) / (2 * step)) for a, b in zip(high, low, strict=True)])
    return shaped(model, np.array(columns).T)


@cache
def differentiated(name: str) -> ca.Function:
    """Automatic differentiation of the builders, in CasADi's virtual machine."""
    model = case(name)
    at = [ca.SX.sym(key, len(group)) for key, group in model.groups.items()]
    values = {f: model.pack.expression(function)(*at) for f, function in FUNCTIONS.items()}
    names = [f + key for f, key in product("fg", BLOCKS)]
    jacobians = [ca.densify(ca.jacobian(values[f], by)) for f, by in product("fg", at)]
    return ca.Function("differentiated", at, jacobians, [*BLOCKS], names)


def called(function: ca.Function, point: Point) -> Jacobians:
    return dict(zip(function.name_out(), map(np.array, function.call([*point])), strict=True))


def by_casadi(name: str, point: Point) -> Jacobians:
    return called(differentiated(name), point)


def by_compiled_jacobian(name: str, point: Point) -> Jacobians:
    return called(case(name).pack.function("jacobians"), point)


def by_compiled_forward(name: str, point: Point) -> Jacobians:
    """Columns, from one forward sweep for each direction."""
    found = {}
    for (f, each), (n, key) in product(FUNCTIONS.items(), enumerate(BLOCKS)):
        function = case(name).pack.function(each)
        sweep, value = function.forward(1), function(*point)
        columns = [np.zeros((value.numel(), 0))]
        for direction in np.eye(point[n].size):
            seeds = [np.zeros(block.size) for block in point]
            seeds[n] = direction
            columns.append(np.array(sweep(*point, value, *seeds)))
        found[f + key] = np.hstack(columns)
    return found


def by_compiled_reverse(name: str, point: Point) -> Jacobians:
    """Rows, from one reverse sweep for each result."""
    found = {}
    for f, each in FUNCTIONS.items():
        function = case(name).pack.function(each)
        sweep, value = function.reverse(1), function(*point)
        rows = [sweep.call([*point, value, seed]) for seed in np.eye(function.size1_out(0))]
        for n, key in enumerate(BLOCKS):
            found[f + key] = np.array([np.array(row[n]).ravel() for row in rows])
    return found


WAYS = (by_casadi, by_compiled_jacobian, by_compiled_forward, by_compiled_reverse)


@cache
def symbolic(name: str) -> dict[str, Callable[..., list[list[mpmath.mpf]]]]:
    """Every Jacobian by `sympy.diff` of the whole expression, to be called with mpmath."""
    model = case(name)
    whole = {f: sp.Matrix([model.derived.explicit(e) for e in results(model)[f]]) for f in "fg"}
    arguments = [q for group in model.groups.values() for q in group]
    return {
        f + key: sp.lambdify(arguments, whole[f].jacobian(group), modules="mpmath", cse=True)
        for f, (key, group) in product("fg", model.groups.items())
    }


def by_sympy(name: str, point: Point) -> Jacobians:
    with mpmath.workdps(40):
        at = [mpmath.mpf(float(value)) for block in point for value in block]
        return {
            block: np.array(jacobian(*at).tolist(), dtype=float)
            for block, jacobian in symbolic(name).items()
        }


@cache
def numerical(name: str) -> Callable[..., list[complex]]:
    derived = case(name).derived
    return lambdified(derived, [*derived.rates, *derived.outputs])


def by_complex_step(name: str, point: Point) -> Jacobians:
    step, flat = 1e-40, np.concatenate(point).astype(complex)
    columns = [
        np.imag(numerical(name)(*(flat + step * 1j * direction))) / step
        for direction in np.eye(flat.size)
    ]
    return shaped(case(name), np.array(columns).T)


def disagreement(found: Jacobians, exact: Jacobians, room: Jacobians) -> str:
    """The first block with an entry that is not within its room, or nothing."""
    for block, jacobian in exact.items():
        over = abs(found[block] - jacobian) - room[block]
        if over.size and not over.max() <= 0:
            worst = np.unravel_index(over.argmax(), over.shape)
            values = f"{found[block][worst]!r}, exactly {jacobian[worst]!r}"
            return f"{block}{list(map(int, worst))}: {values}"
    return ""


def room(exact: Jacobians, name: str) -> Jacobians:
    """1e-12 of the largest effect that any argument has on the same result."""
    model = case(name)
    reach = {f: np.zeros(len(group)) for f, group in results(model).items()}
    for block, jacobian in exact.items():
        effect = abs(jacobian) * model.span(block[1])
        reach[block[0]] = np.maximum(reach[block[0]], effect.max(axis=1, initial=0))
    return {b: 1e-12 * reach[b[0]][:, None] / model.span(b[1]) for b in exact}


def rounding(name: str, point: Point, exact: Jacobians) -> Jacobians:
    """A hundred times what the last digit of the arguments changes."""
    rng = np.random.default_rng(1)
    nearby = tuple(block * (1 + 1e-15 * rng.choice([-1, 1], block.size)) for block in point)
    return {b: 100 * abs(there - exact[b]) for b, there in exactly(name, nearby).items()}


def assert_same(name: str, point: Point, ways: Sequence[Way], exact: Jacobians) -> None:
    """Every way finds the exact derivatives, as far as numbers of 16 digits can."""
    allowed, is_wide = room(exact, name), False
    for way in ways:
        found = way(name, point)
        if disagreement(found, exact, allowed) and not is_wide:
            wider = rounding(name, point, exact)
            allowed, is_wide = {b: allowed[b] + wider[b] for b in allowed}, True
        assert not (problem := disagreement(found, exact, allowed)), f"{way.__name__} {problem}"


@every
@settings(max_examples=3)
@given(data=st.data())
def test_derivatives_agree(name: str, data: st.DataObject):
    point = data.draw(case(name).points())
    assert_same(name, point, WAYS, exactly(name, point))


@thesis
@settings(max_examples=8)
@given(data=st.data())
def test_sympy_and_the_complex_step_agree_with_differences_in_many_digits(
    name: str, data: st.DataObject
):
    point = data.draw(case(name).points())
    assert_same(name, point, (by_sympy, by_complex_step), exactly(name, point))


@pytest.mark.parametrize("name", ["linear", "nonlinear", "four_wheels"])
def test_a_derivative_that_is_off_in_the_eleventh_digit_is_noticed(name: str):
    (point,) = case(name).some(1)
    exact = exactly(name, point)

    def slightly_off(name: str, point: Point) -> Jacobians:
        return {**exact, "fp": exact["fp"] * (1 + 1e-11)}

    with pytest.raises(AssertionError, match="slightly_off fp"):
        assert_same(name, point, (slightly_off,), exact)


@thesis
def test_at_rest_the_slip_angle_is_smooth(name: str):
    point = (state(), np.zeros(1), parameters(name))
    assert_same(name, point, (*WAYS, by_sympy, by_complex_step), exactly(name, point))


# --- What is exported -----------------------------------------------------------------------

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
