"""The models of the tests equal what textbooks and Kane's method make of them, sign by sign."""

from collections.abc import Callable, Iterator
from functools import cache
from itertools import chain

import numpy as np
import pytest
import sympy as sp
from every import Case, Point, case
from flips import equation_flips, rate_flips, value
from own_oracles import ORACLES

from groundroll.derive.core.model import Derivation

own = pytest.mark.parametrize("name", ORACLES)


def named(model: Case, point: Point) -> dict[str, float]:
    """All values of a point by symbol."""
    groups = zip(model.groups.values(), point, strict=True)
    return {str(q): float(x) for group, xs in groups for q, x in zip(group, xs, strict=True)}


def results(model: Derivation) -> list[str]:
    return [*(f"{s}_dot" for s in model.states), *map(str, model.outputs)]


@cache
def compiled(expr: sp.Expr) -> tuple[tuple[str, ...], Callable[..., float]]:
    """A link by itself, with the names of its arguments."""
    names = sorted(expr.free_symbols, key=str)
    return tuple(map(str, names)), sp.lambdify(names, expr, "numpy")


def links(model: Derivation) -> Iterator[tuple[str, sp.Expr]]:
    yield from ((e.lhs.name, e.rhs) for e in model.chain)
    for state, rate in zip(model.states, model.rates, strict=True):
        yield f"{state.name}_dot of x", rate


def numbers(model: Derivation, point: dict[str, float], of: Derivation) -> list[float]:
    """Rates and outputs at a point, of a model that has most of its links from another."""
    values, known = dict(point), dict(links(of))
    for name, expr in links(model):
        if expr is known[name]:
            arguments, f = compiled(expr)
            values[name] = float(f(*(values[n] for n in arguments)))
        else:
            values[name] = value(expr, values)
    return [values[f"{s.name}_dot of x"] for s in model.states] + [
        values[q.name] for q in model.outputs
    ]


@cache
def exactly(name: str) -> tuple[list[Point], np.ndarray]:
    """What the oracle says at some points: rolling, and spinning like a top."""
    model = case(name)
    order = results(model.derived)
    points = model.some(30, seed=12)
    spin = 1.0 + 200.0 * np.array([str(s) == "r" for s in model.derived.states])
    points += [(x * spin, u, p) for x, u, p in points[:10]]
    found = [ORACLES[name](named(model, point)) for point in points]
    return points, np.array([[f[n] for n in order] for f in found])


def errors(name: str, derived: Derivation) -> Iterator[np.ndarray]:
    """What a model has otherwise than the oracle, relative to the largest of each, by point."""
    points, exact = exactly(name)
    model = case(name)
    size = np.maximum(np.abs(exact).max(axis=0), 1e-3)
    for point, values in zip(points, exact, strict=True):
        yield np.abs(numbers(derived, named(model, point), model.derived) - values) / size


@own
def test_a_model_is_what_it_is_without_derive(name: str):
    worst = np.max(list(errors(name, case(name).derived)), axis=0)
    order = results(case(name).derived)
    assert {n: e for n, e in zip(order, worst, strict=True) if not e < 1e-12} == {}


@own
def test_what_is_compiled_is_that_too(name: str):
    model = case(name)
    rhs, outputs = model.pack.function("rhs"), model.pack.function("outputs")
    for point, exact in zip(*exactly(name), strict=True):
        found = np.concatenate([np.array(f(*point)).ravel() for f in (rhs, outputs)])
        np.testing.assert_allclose(found, exact, rtol=1e-10, atol=1e-10 * np.abs(exact).max())


def flips(name: str) -> Iterator[tuple[str, Derivation]]:
    derived = case(name).derived
    return chain(equation_flips(derived), rate_flips(derived))


@own
def test_no_sign_flips_unnoticed(name: str):
    flipped = dict(flips(name))
    assert len(flipped) > 20
    unnoticed = [
        what
        for what, derived in flipped.items()
        if not any((e > 1e-6).any() for e in errors(name, derived))
    ]
    assert unnoticed == []
