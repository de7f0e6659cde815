"""Linearisation of a model about straight running, and its matrices."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cache

import sympy as sp

from .equation import Equation
from .model import Derivation
from .quantity import Quantity


def linearise(model: Derivation) -> Derivation:
    """Linearise every equation of a model about straight running (v = r = 0, no input).

    Each link of the chain is replaced by its first-order expansion in whatever moves. Straight
    running is an equilibrium where all of it is zero, so the expanded chain is the linearisation
    of the whole. The path over the ground stays exact: it is geometry, not dynamics. Outputs that
    are of second order vanish.

    Raises
    ------
    ValueError
        If straight running is not an equilibrium of the model.
    """
    moving: list[Quantity] = [*model.dynamic, *model.inputs]
    chain: list[Equation] = []
    for equation in model.chain:
        expanded = _first_order(equation.rhs, [q for q in moving if equation.rhs.has(q)])
        chain.append(replace(equation, rhs=expanded))
        if expanded.has(*moving):
            moving.append(equation.lhs)
    nothing = {equation.lhs for equation in chain if equation.rhs == 0}
    return model.replace(
        chain=tuple(e for e in chain if e.lhs not in nothing),
        outputs=tuple(q for q in model.outputs if q not in nothing),
    )


def _first_order(expr: sp.Expr, moving: Sequence[Quantity]) -> sp.Expr:
    rest = dict.fromkeys(moving, 0)
    if moving and expr.subs(rest) != 0:
        raise ValueError(f"straight running is not an equilibrium: {expr} does not vanish there")
    slopes = {q: expr.diff(q).subs(rest) for q in moving}
    tangent = sum((slope * q for q, slope in slopes.items()), sp.Integer(0))
    is_linear = not moving or sp.expand(expr - tangent) == 0
    return expr if is_linear else sp.together(tangent)


@cache
def state_space(model: Derivation) -> tuple[sp.Matrix, sp.Matrix, sp.Matrix, sp.Matrix]:
    """A, B, C, D of a linear model: x' = A x + B u, y = C x + D u, x being dynamic."""
    rates = sp.ImmutableMatrix(
        [model.explicit(model.rates[model.states.index(s)]) for s in model.dynamic]
    )
    outputs = sp.ImmutableMatrix([model.explicit(q) for q in model.outputs])
    states, inputs = (sp.Matrix(len(q), 1, q) for q in (model.dynamic, model.inputs))
    A, B = rates.jacobian(states), rates.jacobian(inputs)
    C, D = outputs.jacobian(states), outputs.jacobian(inputs)
    return A, B, C, D
