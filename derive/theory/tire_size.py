"""A tire from its size and pressure (Smiley and Horne, NASA TR R-64, 1960; NACA TN 4110).

The constants were written down from memory. What speaks for them: the pieces join with equal
value and slope, and a measured 6.00-6 tire (Table 3.1 of the thesis) has the slope that follows
within 11 % at each of its five loads. What follows from here is an estimate.
"""

from __future__ import annotations

import sympy as sp

from groundroll.derive.core.equation import Chain, Equation
from groundroll.derive.core.quantity import Quantity
from groundroll.derive.parts.quantities import (
    B3,
    C3,
    C_N,
    C_z,
    Ct,
    F_tail_load,
    Fz,
    d_tail,
    d_tire,
    delta_tire,
    p_rated,
    p_tail,
    p_tire,
    sigma,
    w_tail,
    w_tire,
)

_SOURCE = "NASA TR R-64"

d_rim = Quantity("d_rim", "rim_diameter", "m", "diameter of the rim", r"d_{\mathrm{rim}}", ">0")
l_z = Quantity("l_z", "tire_mean_length", "m", "geometric mean of width and diameter", "l_z")
K_z = Quantity("K_z", "tire_load_scale", "N", "load scale of a tire", "K_z")
k_z = Quantity("k_z", "relative_tire_load", "1", "load over load scale", "k_z")
x_z = Quantity("x_z", "deflection_over_width", "1", "deflection over width", r"\delta/w")
e_z = Quantity("e_z", "deflection_over_diameter", "1", "deflection over diameter", r"\delta/d")
g_N = Quantity("g_N", "cornering_power_shape", "1", "cornering power over its scale", "g_N")
N_scale = Quantity("N_scale", "cornering_power_scale", "N/rad", "its scale", "N_0")
N = Quantity("N", "cornering_power", "N/rad", "slope of the lateral force at no slip angle", "N")
N_load = Quantity("N_load", "cornering_power_by_load", "1/rad", "its derivative by load", "N'")
l_sigma = Quantity(
    "l_sigma", "relaxation_shape", "1", "relaxation length over its scale", r"l_\sigma"
)


def _number(text: str) -> sp.Rational:
    return sp.Rational(text)


def deflection(load: Quantity, d: Quantity, w: Quantity, p: Quantity, rated: Quantity) -> Chain:
    """From a load to the deflection of a tire: the inverse of load over deflection.

    F_z = K_z f(x) with f = 0.96 x + 0.216 x^2/C_z up to x = 10/3 C_z, then 2.4 (x - C_z).
    """
    curved = (
        sp.sqrt(_number("0.9216") + _number("0.864") * k_z / C_z) - _number("0.96")
    ) / _number("0.432")
    return (
        Equation(l_z, sp.sqrt(w * d), _SOURCE),
        Equation(K_z, (p + _number("0.08") * rated) * w * l_z, _SOURCE),
        Equation(k_z, load / K_z, _SOURCE),
        Equation(
            x_z,
            sp.Piecewise(
                (C_z * curved, k_z <= _number("5.6") * C_z), (k_z / _number("2.4") + C_z, True)
            ),
            _SOURCE,
        ),
        Equation(e_z, x_z * w / d, _SOURCE),
    )


def cornering_power(
    load: Quantity, d: Quantity, w: Quantity, p: Quantity, rated: Quantity
) -> Chain:
    """The slope of the lateral force at no slip angle, and how it changes with load.

    The report prints 0.0674 for what makes the pieces join, 0.067375.
    """
    shape = sp.Piecewise(
        (_number("1.2") * e_z - _number("8.8") * e_z**2, e_z <= _number("0.0875")),
        (_number("0.067375") - _number("0.34") * e_z, True),
    )
    chain = deflection(load, d, w, p, rated)
    by_load = sp.Integer(1)
    for equation, inner in zip(chain[2:], (load, k_z, x_z), strict=True):
        by_load *= equation.rhs.diff(inner)
    return (
        *chain,
        Equation(g_N, shape, _SOURCE),
        Equation(N_scale, C_N * (p + _number("0.44") * rated) * w**2, _SOURCE),
        Equation(N, N_scale * g_N, _SOURCE),
        Equation(N_load, N_scale * shape.diff(e_z) * by_load, _SOURCE),
    )


def main_tire() -> Chain:
    """The main tires: deflection, relaxation length, and the line of the cornering coefficient.

    The line touches the curve of the report at the load of the tire: the cornering stiffness is
    right there, and so is its derivative by load.
    """
    tire = (Fz, d_tire, w_tire, p_tire, p_rated)
    relaxation = sp.Piecewise(
        (11 * e_z, e_z <= _number("0.053")),
        (64 * e_z - 500 * e_z**2 - _number("1.4045"), e_z <= _number("0.068")),
        (_number("0.9075") - 4 * e_z, True),
    )
    return (
        Equation(p_rated, p_tire, "taken to be inflated as rated"),
        *cornering_power(*tire),
        Equation(delta_tire, x_z * w_tire, _SOURCE),
        Equation(l_sigma, relaxation, _SOURCE),
        Equation(
            sigma,
            (_number("2.8") - _number("0.8") * p_tire / p_rated) * w_tire * l_sigma,
            _SOURCE,
        ),
        Equation(C3, (N_load - N / Fz) / Fz, "tangent to N/F_z"),
        Equation(B3, N / Fz - C3 * Fz, "tangent to N/F_z"),
    )


def tail_tire() -> Chain:
    """The tail wheel's tire, inflated as rated: its stiffness at its load."""
    chain = cornering_power(F_tail_load, d_tail, w_tail, p_tail, p_tail)
    return (*chain, Equation(Ct, N, _SOURCE))


def outside_diameter() -> Chain:
    """Outside diameter where only width and rim are known: a section as high as 0.92 of its width.

    The 5.00-5 has 0.89, the 6.00-6 0.96.
    """
    return (Equation(d_tire, d_rim + 2 * _number("0.92") * w_tire, "two tires of type III"),)


def relative_deflection() -> Chain:
    """What says whether a tire is overloaded or soft."""
    return (Equation(e_z, delta_tire / d_tire, "definition"),)
