"""What the kernels' emitter reads from CasADi has the value that CasADi gives it."""

from __future__ import annotations

import math
from collections.abc import Callable

import casadi as ca
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from groundroll.derive.emit.simd.graph import Graph
from groundroll.derive.emit.simd.sums import read
from groundroll.generated import build

OPERATIONS: dict[str, Callable[..., float]] = {
    "add": lambda a, b: a + b,
    "sub": lambda a, b: a - b,
    "mul": lambda a, b: a * b,
    "div": lambda a, b: a / b,
    "pow": math.pow,
    "sqrt": math.sqrt,
    "atan": math.atan,
    "sin": math.sin,
    "cos": math.cos,
    "fabs": abs,
    "fmin": min,
    "fmax": max,
    "sign": lambda a: float(np.sign(a)),
    "lt": lambda a, b: float(a < b),
    "le": lambda a, b: float(a <= b),
    "not": lambda a: float(not a),
    "select": lambda c, a: a if c else 0.0,
    "choose": lambda c, a, b: a if c else b,
}


def evaluate(graph: Graph, targets: list[int], values: dict[str, float]) -> list[float]:
    """The nodes' values, one by one."""
    found: dict[int, float] = {}
    for n in graph.closure(targets):
        op, args, name, number = graph.nodes[n]
        if op == "leaf":
            found[n] = values[name]
        elif op == "number":
            found[n] = number
        else:
            found[n] = OPERATIONS[op](*(found[a] for a in args))
    return [found[n] for n in targets]


def compare(function: ca.Function, x: list[float], p: list[float]) -> None:
    graph = Graph()
    leaves = [
        [graph.leaf(f"x{k}", varies=True) for k in range(len(x))],
        [graph.leaf(f"p{k}", varies=False) for k in range(len(p))],
    ]
    targets = read(graph, function, leaves)
    values = {f"x{k}": v for k, v in enumerate(x)} | {f"p{k}": v for k, v in enumerate(p)}
    exact = function(x, p).full().ravel()
    assert evaluate(graph, targets, values) == pytest.approx(exact, rel=1e-12, abs=1e-12)


STEPS: tuple[Callable[[ca.SX, ca.SX], ca.SX], ...] = (
    lambda a, b: a + b,
    lambda a, b: a - b,
    lambda a, b: a * b,
    lambda a, b: a / (2 + b**2),
    lambda a, b: -a,
    lambda a, b: 2 * a,
    lambda a, b: a**2,
    lambda a, b: (1 + a**2) ** -1.5,
    lambda a, b: ca.atan(a),
    lambda a, b: ca.sin(a) - b,
    lambda a, b: a - a * b / b,
    lambda a, b: ca.if_else(a < b, a, b),
    lambda a, b: ca.fmax(a, b),
)


@settings(deadline=None)
@given(
    steps=st.lists(
        st.tuples(st.integers(0, len(STEPS) - 1), st.integers(0, 30), st.integers(0, 30)),
        min_size=1,
        max_size=12,
    ),
    x=st.lists(st.floats(0.1, 2.0), min_size=2, max_size=2),
    p=st.lists(st.floats(0.1, 2.0), min_size=2, max_size=2),
)
def test_expressions_keep_their_values(
    steps: list[tuple[int, int, int]], x: list[float], p: list[float]
):
    state, parameter = ca.SX.sym("x", 2), ca.SX.sym("p", 2)
    made = [*ca.vertsplit(state), *ca.vertsplit(parameter), ca.SX(1.0), ca.SX(0.5)]
    for step, i, j in steps:
        made.append(STEPS[step](made[i % len(made)], made[j % len(made)]))
        value = float(ca.Function("f", [state, parameter], [made[-1]])(x, p))
        if not abs(value) < 1e3:
            made.pop()  # rounding of huge numbers is not what is tested
    compare(ca.Function("f", [state, parameter], [ca.vertcat(*made)]), x, p)


def test_what_cancels_is_nothing():
    x, p = ca.SX.sym("x", 2), ca.SX.sym("p", 2)
    literal = x[0] - 0.5 * x[0] - 0.5 * x[0]
    symbolic = (x[0] + p[0] * x[1]) - x[0] - x[1] * p[0]
    results = [each for h in (literal, symbolic) for each in (h, h * x[1], 3 + h)]
    function = ca.Function("f", [x, p], [ca.vertcat(*results)])
    compare(function, [1.5, 0.3], [0.7, 2.0])


@pytest.mark.parametrize("name", ["linear_rhs", "nonlinear_rhs"])
def test_the_models_keep_their_values(name: str):
    model = build(name)
    x, u, p = (list(np.linspace(0.3, 0.9, model.numel_in(k))) for k in range(3))
    packed_x, packed_p = ca.SX.sym("x", len(x)), ca.SX.sym("p", len(u) + len(p))
    both = ca.vertsplit(packed_p, [0, len(u), len(u) + len(p)])
    compare(ca.Function("f", [packed_x, packed_p], [model(packed_x, *both)]), x, u + p)
