"""Geometry, static loads and the stiffnesses that follow from them (Sections 3.5, 4.2.2)."""

from __future__ import annotations

from .equation import Chain, Equation
from .quantities import (
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
    g,
    m,
    x_cg,
    x_main,
    x_tail,
)
from .tire import C_c, load_dependence


def static_loads() -> Chain:
    """From CG and gear stations to wheel loads, and from these to cornering stiffnesses.

    The tail wheel's stiffness is a polynomial in its load, zero at zero load (Fig. 3.8).
    """
    W = F_tail_load
    return (
        Equation(a, x_cg - x_main, "Section 4.2.2"),
        Equation(b, x_tail - x_cg, "Section 4.2.2"),
        Equation(L, a + b, "Section 4.2"),
        Equation(f, b / L, "App. A.6"),
        Equation(Fz, f * m * g / 2, "App. A.6"),
        Equation(F_tail_load, (1 - f) * m * g, "App. A.6"),
        *load_dependence(),
        Equation(C_alpha, C_c * Fz, "Eq. 3.2"),
        Equation(Ct, K1 * W + K2 * W**2 + K3 * W**3 + K4 * W**4, "Fig. 3.8"),
    )
