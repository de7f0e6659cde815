"""Bounds over intervals hold everything that the function takes there, and little more."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import groundroll as gr
from groundroll.generated import build
from groundroll.generated.intervals import bounds

X, P = ca.SX.sym("x"), ca.SX.sym("p")
FUNCTIONS = {
    "sum": X + P * X - 3,
    "product": (X - P) * (X + 1),
    "square": X**2 - P,
    "quotient": P / (X + 4),
    "pole": 1 / X,
    "root": ca.sqrt(X**2 + 0.1),
    "wave": ca.sin(X) * ca.cos(P * X),
    "tangent": ca.tan(X / 4),
    "curves": ca.atan(P * X) + ca.tanh(X) + ca.exp(-X),
    "magic": ca.sin(1.3 * ca.atan(P * X - 0.4 * (P * X - ca.atan(P * X)))),
}


def bounded(expression: ca.SX) -> tuple[ca.Function, ca.Function]:
    function = ca.Function("f", [X, P], [expression], ["x", "p"], ["y"])
    return function, bounds(function, 1, "f_bounds")


@pytest.mark.parametrize("name", FUNCTIONS)
@given(st.floats(-5, 5), st.floats(0, 3), st.floats(-3, 3), st.floats(0, 1))
def test_every_value_lies_between_the_bounds(
    name: str, low: float, width: float, p: float, part: float
) -> None:
    function, over = bounded(FUNCTIONS[name])
    high = low + width
    least, most = (float(x) for x in over(low, high, p))
    value = float(function(min(low + part * width, high), p))
    assert not value < least
    assert not value > most


@pytest.mark.parametrize("name", sorted(FUNCTIONS.keys() - {"pole"}))
def test_bounds_close_in_as_the_interval_does(name: str) -> None:
    function, over = bounded(FUNCTIONS[name])
    for x in (-1.3, 0.7, 2.9):
        least, most = (float(each) for each in over(x - 1e-7, x + 1e-7, 1.7))
        assert least <= float(function(x, 1.7)) <= most
        assert most - least < 1e-4


def test_a_pole_within_has_no_bounds() -> None:
    _, over = bounded(FUNCTIONS["pole"])
    assert [float(x) for x in over(-1, 2, 0)] == [-np.inf, np.inf]


def test_an_operation_without_bounds_is_an_error() -> None:
    with pytest.raises(NotImplementedError, match="no bounds"):
        bounded(ca.erf(X))


@pytest.mark.parametrize("model", ["linear", "nonlinear"])
@given(st.floats(-0.35, 0.35), st.floats(0, 0.1), st.floats(0, 1), st.floats(-1e3, 1e3))
def test_the_balance_of_moments_is_bounded(
    model: str, low: float, width: float, part: float, force: float
) -> None:
    plane, chosen = gr.Aircraft.load("brott"), gr.trim(gr.Aircraft.load("brott"), model)
    assert chosen.complete
    function, over = build(f"{model}_equilibrium"), build(f"{model}_bounds")
    named = {"F_disturbance": force, **{s: float(plane[s]) for s in function.name_in()[2:]}}
    high = low + width
    found = function(alpha=low + part * width, **named)
    between = over(low=low, high=high, **named)
    for name in ("sum_M", "d_sum_M_d_alpha"):
        assert float(between[f"{name}_low"]) <= float(found[name]) <= float(between[f"{name}_high"])
