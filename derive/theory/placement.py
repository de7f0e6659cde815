"""Where to put the wheels: from stations along the fuselage to margins and to limits.

Everything here starts from stations behind the datum, so that a gear fixed to the airframe stays
where it is when the CG moves. The third wheel is the tail wheel of a taildragger or the nose
wheel of a tricycle; one balance of moments serves both. A nose wheel casters freely: it carries
load and makes no side force.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from groundroll.derive.core.body import Izz, g, m
from groundroll.derive.core.equation import Chain, Equation
from groundroll.derive.core.quantity import Quantity
from groundroll.derive.parts.quantities import (
    B3,
    C3,
    K1,
    K2,
    K3,
    K4,
    Ap,
    C_alpha,
    CL_gamma,
    Ct,
    F_tail_load,
    Fz,
    a,
    b,
    f,
    h_cg,
    rho,
    u,
    u_lift,
    x_cg,
    x_main,
    x_tail,
)

from . import closed_forms as closed
from .closed_forms import STATE_MATRIX, A_rr, A_rv, A_vr, A_vv, det, trace
from .loads import main_gear_share, static_loads

# --- What an envelope ranges over, beside speed, CG station and mass ---------------------------
w = Quantity(
    "w", "weight_on_wheels", "1", "share of the weight on the wheels, lift by speed apart", "w"
)
tau = Quantity(
    "tau", "tail_load", "1", "load on the tail wheel over the one that follows from the CG", r"\tau"
)
eta = Quantity(
    "eta", "tire_wear", "1", "cornering stiffness of the tires over that of new ones", r"\eta", ">0"
)

# --- What a design chooses, beside stations and tail area -------------------------------------
kappa = Quantity(
    "kappa",
    "tail_wheel_scale",
    "1",
    "stiffness of the tail wheel over that of the aircraft file; 0: it casters",
    r"\kappa",
    ">=0",
)
x_third = Quantity(
    "x_third",
    "third_wheel_station",
    "m",
    "tail wheel or nose wheel behind the datum",
    r"x_{\mathrm{third}}",
)

# --- Constant stiffness, as in the thesis -------------------------------------------------------
C_alpha_0 = Quantity(
    "C_alpha_0",
    "given_cornering_stiffness",
    "N/rad",
    "cornering stiffness of one main tire at the full weight",
    r"C_{\alpha 0}",
)
Ct_0 = Quantity(
    "Ct_0",
    "given_tail_wheel_stiffness",
    "N/rad",
    "cornering stiffness of the tail wheel at its static load",
    r"C_{f\,\mathrm{tail}\,0}",
)
Fz_0 = Quantity(
    "Fz_0", "given_tire_load", "N", "load on one main tire at the full weight", "F_{z0}"
)
F_0 = Quantity("F_0", "given_tail_wheel_load", "N", "the static load at which that holds", r"F_0")

# --- What follows ------------------------------------------------------------------------------
B3_worn = Quantity("B3_worn", "worn_intercept", "1/rad", "B3 of a worn tire", r"B_{3\eta}")
C3_worn = Quantity("C3_worn", "worn_slope", "1/(rad N)", "C3 of a worn tire", r"C_{3\eta}")
w_u = Quantity("w_u", "wheel_weight_share", "1", "share of the weight on the wheels", "w_u")
third_load = Quantity(
    "third_load",
    "third_wheel_load_fraction",
    "1",
    "share of the weight on the tail wheel or nose wheel, at rest",
    r"\phi",
)
nose_over = Quantity(
    "nose_over",
    "nose_over_angle",
    "rad",
    "from the vertical below the CG forward to the main wheels",
    r"\nu",
)
tip_back = Quantity(
    "tip_back",
    "tip_back_angle",
    "rad",
    "from the vertical below the CG back to the main wheels",
    r"\epsilon",
)
span = Quantity("span", "wheel_span", "m", "main gear to tail wheel or nose wheel", "l")
d = Quantity("d", "required_decay_rate", "1/s", "a decay rate to be reached", "d")
zeta = Quantity("zeta", "required_damping_ratio", "1", "a damping ratio to be reached", r"\zeta")
trace_d = Quantity(
    "trace_d", "shifted_trace", "1/s", "tr(A + d I): not positive", r"\operatorname{tr}_d"
)
det_d = Quantity("det_d", "shifted_determinant", "1/s^2", "det(A + d I): not negative", r"\det{}_d")
damping = Quantity(
    "damping", "damping_polynomial", "1/s^2", "(tr A)^2 - 4 zeta^2 det A: not negative", "Z"
)


def _static(quantity: Quantity) -> Equation:
    """An equation of the static loads."""
    return next(equation for equation in static_loads() if equation.lhs is quantity)


def geometry() -> Chain:
    """Arms from the CG, and the share of the weight on the main gear."""
    arm = _static(a)
    share = main_gear_share(x_third - x_cg).subs(a, arm.rhs)
    return arm, _static(b), Equation(f, share, _static(f).source)


def worn_tire() -> Chain:
    """A worn tire has less cornering stiffness and the same friction."""
    return (
        Equation(B3_worn, eta * B3, "definition of tire wear"),
        Equation(C3_worn, eta * C3, "definition of tire wear"),
    )


def following_stiffness() -> Chain:
    """Axle loads from the stations, and stiffnesses from the loads.

    Lift takes weight off the wheels with the square of the speed. A force of the elevator acts at
    the tail wheel, so that it changes that load (by `tau`) and no other.
    """
    polynomial = _static(Ct)
    return (
        *geometry(),
        Equation(w_u, w * (1 - u**2 / u_lift**2), "definition of the lift-off speed"),
        Equation(Fz, f * w_u * m * g / 2, "App. A.6"),
        Equation(F_tail_load, tau * (1 - f) * w_u * m * g, "App. A.6"),
        *worn_tire(),
        Equation(C_alpha, (B3_worn + C3_worn * Fz) * Fz, "Eqs. 3.2, 3.3"),
        Equation(Ct, kappa * eta * polynomial.rhs, polynomial.source),
    )


def constant_stiffness() -> Chain:
    """Stiffnesses that do not know where the gear is, as in the thesis.

    The main tires' goes with the weight on the wheels (Table 4.3 halves both), the tail wheel's
    with its load over the static one, along the curve of Fig. 3.8 (Table 4.7). The curve is
    divided by its load, so that a tail wheel without static load is no division by zero.
    """
    curve = sp.expand(_static(Ct).rhs / F_tail_load)
    ratio = tau * curve.subs(F_tail_load, tau * F_0) / curve.subs(F_tail_load, F_0)
    return (
        *geometry(),
        Equation(w_u, w * (1 - u**2 / u_lift**2), "definition of the lift-off speed"),
        Equation(Fz, w_u * Fz_0, "Table 4.3"),
        Equation(F_tail_load, tau * (1 - f) * w_u * m * g, "App. A.6"),
        Equation(C_alpha, eta * w_u * C_alpha_0, "Table 4.3"),
        Equation(Ct, kappa * eta * Ct_0 * ratio, "Table 4.7"),
    )


def margins() -> Chain:
    """What is not positive or not negative exactly where a decay rate or damping is reached.

    Every eigenvalue of A has Re <= -d if and only if A + d I has no eigenvalue with Re > 0:
    its trace is not positive and its determinant is not negative. A complex pair has
    4 zeta^2 = (tr A)^2 / det A; where the determinant is negative the polynomial says nothing.
    Both are smooth where eigenvalues meet, as the eigenvalues are not.
    """
    shifted = sp.Matrix(2, 2, STATE_MATRIX) + d * sp.eye(2)
    # in trace and determinant in place of the entries
    entries = {A_vv: trace - A_rr, A_rv: (A_vv * A_rr - det) / A_vr}
    ratio = -trace / (2 * sp.sqrt(det))
    polynomial = sp.expand((ratio**2 - zeta**2) * 4 * det)

    def invariant(expr: sp.Expr) -> sp.Expr:
        return sp.collect(sp.expand(expr.subs(A_rv, entries[A_rv]).subs(A_vv, entries[A_vv])), d)

    return (
        *closed.stiffnesses(),
        *(e for e in closed.routh_hurwitz() if e.lhs in (trace, det)),
        Equation(trace_d, invariant(shifted.trace()), "Section 4.7"),
        Equation(det_d, invariant(shifted.det()), "Section 4.7"),
        Equation(damping, polynomial, "Section 4.7"),
    )


def limits() -> Chain:
    """What the placement of wheels is limited by, beside stability.

    Angles are seen from the CG, at its height above the ground, in the attitude in which the
    stations are measured.
    """
    return (
        *geometry(),
        Equation(third_load, 1 - f, "App. A.6"),
        Equation(nose_over, sp.atan(a / h_cg), "Raymer, ch. 11"),
        Equation(tip_back, -nose_over, "Raymer, ch. 11"),
        Equation(span, sp.Abs(x_third - x_main), "Section 4.2"),
    )


def sections() -> Iterator[tuple[str, Chain, str]]:
    """Title, chain and text of each section of the equation sheet."""
    yield "Placement: stiffness that follows the gear", following_stiffness(), _FOLLOWING
    yield "Placement: constant stiffness", constant_stiffness(), _CONSTANT
    yield "Placement: margins", margins(), _MARGINS
    yield "Placement: limits", limits(), _LIMITS


_FOLLOWING = (
    "Stations are behind the datum. The third wheel is the tail wheel, or the nose wheel of a"
    " tricycle, which casters: $\\kappa = 0$. An envelope ranges over $u$, $x_{\\mathrm{CG}}$, $m$,"
    " $w$, $\\tau$ and $\\eta$."
)
_CONSTANT = (
    "As in the thesis: no stiffness knows where the gear is. The curve of Fig. 3.8 is divided by"
    " its load, so that no static load is no division by zero."
)
_MARGINS = (
    "A decay rate $d$ is reached if and only if $\\operatorname{tr}_d \\le 0$ and"
    " $\\det{}_d \\ge 0$; a damping ratio $\\zeta \\le 1$ of a stable aircraft if and only if"
    " $Z \\ge 0$. These are smooth where eigenvalues meet."
)
_LIMITS = "Angles are seen from the CG; `SOURCES` of `groundroll.placement` says whose limits."

#: Arguments of the generated functions.
DESIGN = (x_main, x_third, x_tail)
CORNER = (u, x_cg, m, w, tau, eta)
FOLLOWING = (*DESIGN, kappa, *CORNER, g, u_lift, B3, C3, K1, K2, K3, K4)
CONSTANT = (*DESIGN, kappa, *CORNER, g, u_lift, C_alpha_0, Fz_0, Ct_0, F_0, K1, K2, K3, K4)
AIRFRAME = (m, Izz, a, b, u, rho, Ap, CL_gamma, C_alpha, Ct, d, zeta)
GROUND = (x_main, x_third, x_cg, h_cg)
TIRE = (eta, B3, C3)
#: And their results.
WORN = (B3_worn, C3_worn)
STIFFNESS = (a, b, Fz, F_tail_load, C_alpha, Ct)
CONDITIONS = (trace, det, trace_d, det_d, damping)
LIMITED = (third_load, nose_over, tip_back, span)
