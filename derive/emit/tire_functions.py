"""The generated functions about one tire: which chains, with which results."""

from __future__ import annotations

from groundroll.derive.core.equation import needed
from groundroll.derive.parts import tires
from groundroll.derive.parts.quantities import (
    B1,
    C1,
    D1,
    E1,
    Fz,
    d_tire,
    delta_tire,
    w_tire,
)
from groundroll.derive.parts.thesis import alpha
from groundroll.derive.theory import mf_lateral, tire_size

from .casadi_source import cancel_tangents
from .module import Module
from .scalar_functions import ordered, scalar_function


def tire_module() -> Module:
    """The module `tire`."""
    alpha_bar, F_bar, C_c, mu, F_y = tires.alpha_bar, tires.F_bar, tires.C_c, tires.mu, tires.F_y
    force = cancel_tangents(tires.nonlinear_tire(alpha))
    return Module(
        "tire",
        "The tire by itself (Chapter 3).",
        (
            scalar_function(
                "tire_force",
                "Lateral force of one tire at a slip angle and load.",
                (alpha, *ordered(force)),
                (F_y, alpha_bar, F_bar, C_c, mu),
                force,
            ),
            scalar_function(
                "tire_slope",
                "Slope of the lateral force of one tire at no slip angle.",
                ordered(needed(tires.slope_at_zero(), [tires.F_slope])),
                (tires.F_slope,),
                tires.slope_at_zero(),
            ),
            scalar_function(
                "tire_coefficient",
                "Cornering coefficient of one tire at a load.",
                ordered(needed(tires.load_dependence(), [tires.C_c])),
                (tires.C_c,),
                tires.load_dependence(),
            ),
            scalar_function(
                "tire_friction",
                "Friction of one tire at a load.",
                ordered(needed(tires.load_dependence(), [tires.mu])),
                (tires.mu,),
                tires.load_dependence(),
            ),
            scalar_function(
                "magic_formula_of_shape",
                "Factors with which the normalised curve has the slope 1 and levels off at 1.",
                (C1,),
                (B1, D1),
                tires.magic_formula_of_shape(),
            ),
            scalar_function(
                "mf_lateral",
                "Lateral force by the coefficients of a .tir file, in the axes of the file.",
                mf_lateral.ARGUMENTS,
                (mf_lateral.F_mf,),
                mf_lateral.lateral_force(),
            ),
            scalar_function(
                "relative_deflection",
                "Deflection of a tire over its diameter.",
                (delta_tire, d_tire),
                (tire_size.e_z,),
                tire_size.relative_deflection(),
            ),
            scalar_function(
                "outside_diameter",
                "Outside diameter of a tire from its width and its rim.",
                (tire_size.d_rim, w_tire),
                (d_tire,),
                tire_size.outside_diameter(),
            ),
            scalar_function(
                "magic_formula",
                "Normalised force at a normalised slip angle.",
                (alpha_bar, B1, C1, D1, E1),
                (F_bar,),
                tires.magic_formula(),
            ),
            scalar_function(
                "measured_coefficients",
                "Cornering and friction coefficient from measured forces at one load.",
                (alpha, F_y, tires.F_peak, Fz),
                (C_c, mu),
                tires.measured_coefficients(alpha, tires.F_peak),
            ),
            scalar_function(
                "normalised_data",
                "A measured force in normalised form.",
                (alpha, F_y, Fz, C_c, mu),
                (alpha_bar, F_bar),
                tires.normalised_data(alpha),
            ),
        ),
    )
