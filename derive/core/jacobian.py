"""Jacobians of a chain by the chain rule, one named derivative per link.

Differentiating link by link keeps generated code as readable as the chain itself: every line
is a partial derivative of one equation times derivatives named before.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from .equation import Chain, Equation
from .quantity import Quantity


def derivative(of: Quantity, by: Quantity) -> Quantity:
    """The quantity d(of)/d(by)."""
    return Quantity(
        f"d_{of}_d_{by}",
        f"d_{of.full_name}_d_{by.full_name}",
        f"({of.unit})/({by.unit})",
        f"derivative of {of} by {by}",
        rf"\frac{{\partial {of.latex}}}{{\partial {by.latex}}}",
    )


def tangents(chain: Chain, directions: Sequence[Quantity]) -> Chain:
    """`chain` followed by the total derivative of each of its quantities by each direction.

    A derivative that is zero is left out.
    """
    derived = list(chain)
    for by in directions:
        moving = {by: sp.Integer(1)}
        for equation in chain:
            total = total_derivative(equation.rhs, moving)
            if total != 0:
                name = derivative(equation.lhs, by)
                derived.append(Equation(name, total, f"chain rule on {equation.source}"))
                moving[equation.lhs] = name
    return tuple(derived)


def total_derivative(expr: sp.Expr, moving: dict[Quantity, sp.Expr]) -> sp.Expr:
    """Sum of partial derivatives times the derivatives in `moving`."""
    return sum((slope_of(expr, q) * s for q, s in moving.items() if expr.has(q)), sp.Integer(0))


def slope_of(expr: sp.Expr, by: Quantity) -> sp.Expr:
    """Partial derivative, with steps as selections: 1 above zero, else 0; a jump has no slope."""
    slope = expr.diff(by)
    if not slope.has(sp.Heaviside, sp.DiracDelta, sp.sign):
        return slope
    slope = slope.replace(sp.DiracDelta, lambda *_: sp.Integer(0))
    return slope.replace(sp.Heaviside, lambda x, *_: sp.Piecewise((1, x > 0), (0, True)))


def jacobian(results: Sequence[sp.Expr], chain: Chain, directions: Sequence[Quantity]) -> sp.Matrix:
    """Matrix of total derivatives of `results`, in the names that `tangents` defines."""
    columns = []
    for by in directions:
        moving = {by: sp.Integer(1)}
        for equation in chain:
            if total_derivative(equation.rhs, moving) != 0:
                moving[equation.lhs] = derivative(equation.lhs, by)
        columns.append([total_derivative(sp.sympify(result), moving) for result in results])
    return sp.Matrix(columns).T
