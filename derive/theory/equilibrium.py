"""Steady turns under a steady side force, reduced to one equation in one unknown.

At rest sideways v_dot = r_dot = 0. Taken about the tail, the moment of the side forces leaves
only the main gear, so its slip angle gives the yaw rate, the lateral velocity and the angle at
the tail without a division by what may be zero; what remains is one balance of moments.
"""

from __future__ import annotations

import sympy as sp

from groundroll.derive.core.body import r_dot, sum_F, sum_M, v_dot
from groundroll.derive.core.equation import Chain, Equation
from groundroll.derive.core.frames import r, v
from groundroll.derive.core.jacobian import tangents
from groundroll.derive.core.model import Derivation
from groundroll.derive.core.quantity import Quantity
from groundroll.derive.parts.quantities import a, b
from groundroll.derive.parts.thesis import F_main, F_tail, F_tail_wheel, alpha, gamma

gear_moment = Quantity(
    "M_gear", "gear_moment", "N m", "moment of the main gear about the tail", r"M_{\mathrm{gear}}"
)


def equilibrium(model: Derivation) -> Chain:
    """From the slip angle of the main tires to the sum of moments, which is zero in a steady turn.

    Raises
    ------
    ValueError
        If the tail's forces do not drop out, so that a slip angle leaves the yaw rate open.
    """
    links = {equation.lhs: equation for equation in model.chain}
    position = [e.lhs for e in model.chain].index(F_main)
    tire = [e for e in model.chain[: position + 1] if e.lhs is not alpha]
    lateral = sp.solve(alpha - links[alpha].rhs, v)
    if len(lateral) != 1:
        raise ValueError(f"{model.name}: the slip angle does not give the lateral velocity")
    return (
        *tire,
        Equation(r, _yaw_rate(links), "Eq. 4.9 with v_dot = r_dot = 0"),
        Equation(v, lateral[0], links[alpha].source),
        *(links[q] for q in (gamma, F_tail, F_tail_wheel, sum_M)),
        Equation(gear_moment, F_main * (a + b), "a scale for the sum"),
    )


def _yaw_rate(links: dict[sp.Symbol, Equation]) -> sp.Expr:
    """Yaw rate of a steady turn, with the forces at the tail eliminated."""
    sums = {q: links[q].rhs for q in (sum_F, sum_M)}
    balance = [links[q].rhs.subs(sums) for q in (v_dot, r_dot)]
    solution = sp.solve(balance, [r, F_tail], dict=True)[0][r]
    if solution.has(F_tail_wheel):
        raise ValueError(f"the tail wheel acts elsewhere than the tail: {solution}")
    return sp.factor(solution)


def with_slope(model: Derivation) -> Chain:
    """The same chain with the derivative of each link by the slip angle."""
    return tangents(equilibrium(model), [alpha])
