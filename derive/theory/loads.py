"""Geometry, static loads and the stiffnesses that follow from them (Sections 3.5, 4.2.2)."""

from __future__ import annotations

import sympy as sp

from groundroll.derive.core.body import g, m
from groundroll.derive.core.equation import Chain, Equation
from groundroll.derive.core.quantity import Quantity
from groundroll.derive.parts.gear import a_third
from groundroll.derive.parts.quantities import (
    B1,
    B3,
    C1,
    C3,
    D1,
    K1,
    K2,
    K3,
    K4,
    C_alpha,
    Ct,
    F_tail_load,
    Fz,
    L,
    a,
    b,
    f,
    x_cg,
    x_main,
    x_nose,
    x_tail,
)
from groundroll.derive.parts.tires import C_c, load_dependence


def main_gear_share(arm: sp.Expr) -> sp.Expr:
    """Moments about a third wheel that stands `arm` behind the CG, a nose wheel less than zero."""
    return arm / (a + arm)


def static_loads() -> Chain:
    """From CG and gear stations to wheel loads, and from these to cornering stiffnesses.

    The tail wheel's stiffness is a polynomial in its load, zero at zero load (Fig. 3.8).
    """
    W = F_tail_load
    return (
        Equation(a, x_cg - x_main, "Section 4.2.2"),
        Equation(b, x_tail - x_cg, "Section 4.2.2"),
        Equation(L, a + b, "Section 4.2"),
        Equation(f, main_gear_share(b).subs(a + b, L), "App. A.6"),
        Equation(Fz, f * m * g / 2, "App. A.6"),
        Equation(F_tail_load, (1 - f) * m * g, "App. A.6"),
        *load_dependence(),
        Equation(C_alpha, C_c * Fz, "Eq. 3.2"),
        Equation(Ct, K1 * W + K2 * W**2 + K3 * W**3 + K4 * W**4, "Fig. 3.8"),
    )


def nose_wheel_loads() -> Chain:
    """What is otherwise with the main gear behind the CG; NaN where it is not.

    The nose wheel carries what the main gear leaves, and the tail wheel, if there is one, nothing.
    A main gear that carries more than the weight would need a tail that is held down: the load on
    the tail wheel comes out negative.
    """
    return (
        _behind_the_cg(f, main_gear_share(x_nose - x_cg)),
        _behind_the_cg(F_tail_load, sp.Min(1 - f, 0) * m * g),
        _behind_the_cg(a_third, x_cg - x_nose),
    )


def tail_wheel_tire() -> Chain:
    """The tail wheel's tire as a tire like any other, of the stiffness that the thesis gives it.

    Its slope at no slip, load times B C D times the cornering coefficient, is the stiffness at the
    static load; NaN where there is no tail wheel.
    """
    B3_third, C3_third, B1_third, C1_third, D1_third = (q.of("third") for q in (B3, C3, B1, C1, D1))
    slope = Ct / (F_tail_load * B1_third * C1_third * D1_third)
    carries = Ct * F_tail_load > 0
    return (
        Equation(B3_third, sp.Piecewise((slope, carries), (sp.nan, True)), "Eq. 4.30"),
        Equation(C3_third, sp.Piecewise((0, carries), (sp.nan, True)), "Eq. 4.30"),
    )


def _behind_the_cg(quantity: Quantity, expr: sp.Expr) -> Equation:
    return Equation(quantity, sp.Piecewise((expr, a < 0), (sp.nan, True)), "balance of moments")
