"""The linear model, derived as a linearisation, and its closed forms (Sections 4.5 and 4.7)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cache

import sympy as sp

from .components import F_main, alpha, gamma
from .equation import Equation
from .model import Model, beta, linear_tire_model
from .newton import r_dot, v_dot
from .quantities import Quantity


def linearise(model: Model) -> Model:
    """Linearise every equation of a model about straight running (v = r = 0, no input).

    Each link of the chain is replaced by its first-order expansion in whatever moves. Straight
    running is an equilibrium where all of it is zero, so the expanded chain is the linearisation
    of the whole. The path over the ground stays exact: it is geometry, not dynamics.

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
    return model.replace(chain=tuple(chain))


def _first_order(expr: sp.Expr, moving: Sequence[Quantity]) -> sp.Expr:
    rest = dict.fromkeys(moving, 0)
    if moving and expr.subs(rest) != 0:
        raise ValueError(f"straight running is not an equilibrium: {expr} does not vanish there")
    slopes = {q: expr.diff(q).subs(rest) for q in moving}
    tangent = sum((slope * q for q, slope in slopes.items()), sp.Integer(0))
    is_linear = not moving or sp.expand(expr - tangent) == 0
    return expr if is_linear else sp.together(tangent)


#: Where the thesis prints the linearised links.
_PRINTED = {
    alpha: "Eq. 4.24",
    gamma: "Eq. 4.26",
    beta: "Eq. 4.21",
    F_main: "Eq. 4.28",
    v_dot: "Eq. 4.31",
    r_dot: "Eq. 4.31",
}


@cache
def linear() -> Model:
    """The thesis's linear model (Section 4.5)."""
    model = linearise(linear_tire_model())
    chain = (replace(e, source=_PRINTED.get(e.lhs, e.source)) for e in model.chain)
    return model.replace(chain=tuple(chain))


@cache
def state_space(model: Model) -> tuple[sp.Matrix, sp.Matrix, sp.Matrix, sp.Matrix]:
    """A, B, C, D of a linear model: x' = A x + B u, y = C x + D u with x = (v, r)."""
    rates = sp.ImmutableMatrix(
        [model.explicit(model.rates[model.states.index(s)]) for s in model.dynamic]
    )
    outputs = sp.ImmutableMatrix([model.explicit(q) for q in model.outputs])
    states, inputs = sp.Matrix(model.dynamic), sp.Matrix(model.inputs)
    A, B = rates.jacobian(states), rates.jacobian(inputs)
    C, D = outputs.jacobian(states), outputs.jacobian(inputs)
    return A, B, C, D
