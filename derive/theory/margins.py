"""How far the linear model is from instability.

The thesis reads stability off eigenvalues; these are the closed forms behind them. Static margin
and understeer gradient are those of road vehicles: W. F. Milliken and D. L. Milliken, *Race Car
Vehicle Dynamics* (SAE 1995), chapter 5; T. D. Gillespie, *Fundamentals of Vehicle Dynamics* (SAE
1992), chapter 6. The main gear takes the place of the front axle, the tail that of the rear one.
"""

from __future__ import annotations

import sympy as sp

from groundroll.derive.core.body import Body
from groundroll.derive.core.equation import Chain, Equation
from groundroll.derive.core.frames import i, j
from groundroll.derive.core.linearise import linearise, state_space
from groundroll.derive.core.model import Model
from groundroll.derive.core.part import Felt, Force, Law, Part
from groundroll.derive.core.quantity import Input, Parameter, Quantity
from groundroll.derive.models.linear import linear
from groundroll.derive.parts.quantities import Ct, L, a, b, u
from groundroll.derive.parts.thesis import (
    F_main,
    alpha,
    main_gear,
    slip_angle,
    tail_wheel,
    vertical_tail,
)
from groundroll.derive.parts.tires import F_y, Tire, linear_tire

from . import closed_forms as closed
from .closed_forms import C_f, K, decay_rate, k, q_0, q_1, q_2
from .loads import static_loads

time_to_half = Quantity(
    "T_half",
    "time_to_half",
    "s",
    "in which a deviation halves; infinite if it never does",
    r"T_{1/2}",
)
time_to_double = Quantity(
    "T_double",
    "time_to_double",
    "s",
    "in which a deviation doubles; infinite if it never does",
    r"T_2",
)
neutral_steer_point = Quantity(
    "x_neutral",
    "neutral_steer_point",
    "m",
    "ahead of the CG: where a side force gives no steady yaw rate",
    r"x_{\mathrm{N}}",
)
static_margin = Quantity(
    "static_margin",
    "static_margin",
    "1",
    "neutral-steer point behind the CG, over the wheelbase: stable if positive",
    r"\mathit{SM}",
)
understeer_gradient = Quantity(
    "K_us",
    "understeer_gradient",
    "rad s^2/m",
    "steer angle of the main wheels per lateral acceleration beyond that of pure rolling",
    r"K_{\mathrm{us}}",
)
_K_needed = Quantity(
    "K_needed", "K_needed", "N/rad", "K at which det A = 0", r"K_{\mathrm{needed}}"
)
stiffness_needed = Quantity(
    "Ct_needed",
    "tail_wheel_stiffness_needed",
    "N/rad",
    "tail wheel stiffness at which det A = 0 at this speed; negative: stable without",
    r"C_{f\,\mathrm{tail,\,needed}}",
)
_root_needed = Quantity(
    "root_needed", "root_needed", "N^(1/2)", "its square root; negative: stable without", r"\hat{w}"
)
stiffness_needed_always = Quantity(
    "Ct_always",
    "tail_wheel_stiffness_always",
    "N/rad",
    "tail wheel stiffness from which det A > 0 at every speed",
    r"C_{f\,\mathrm{tail,\,always}}",
)
speed_margin = Quantity(
    "speed_margin",
    "speed_margin",
    "1",
    "sqrt(b Ct/(L C_f)) + sqrt(L k/m) - sqrt(a/L): positive is stable at every speed",
    r"\mathit{VM}",
)


def times() -> Chain:
    """Time to half and to double from the decay rate.

    |d| + d is 2 d where the motion decays and 0 where it grows, which makes the time infinite.
    """
    two = 2 * sp.log(2)
    return (
        Equation(time_to_half, two / (sp.Abs(decay_rate) + decay_rate), "definition"),
        Equation(time_to_double, two / (sp.Abs(decay_rate) - decay_rate), "definition"),
    )


def wheelbase() -> Equation:
    """Main gear to tail wheel."""
    return next(equation for equation in static_loads() if equation.lhs is L)


def steady_margins() -> Chain:
    """Neutral-steer point, static margin and understeer gradient, from the steady response."""
    return (
        wheelbase(),
        Equation(neutral_steer_point, _neutral_steer_point(), "Milliken, ch. 5"),
        Equation(static_margin, -neutral_steer_point / L, "Milliken, ch. 5"),
        Equation(understeer_gradient, _understeer_gradient(), "Gillespie, ch. 6"),
    )


def _steady(parts: list[Part]) -> sp.Matrix:
    """Steady (v, r) per unit of the only input, up to the factor det A."""
    tail = [
        Part("vertical_tail", -b * i, vertical_tail, suffix=""),
        Part("tail_wheel", -b * i, tail_wheel, suffix=""),
    ]
    model = Model("steady", "", Body(speed="held", stands="level"), [*parts, *tail])
    A, B, *_ = state_space(linearise(model.derive()))
    return (-A.adjugate() * B).applyfunc(sp.expand)


def _neutral_steer_point() -> sp.Expr:
    """Where a side force must act for the steady yaw rate to vanish."""
    force = Input("F_side", "side_force", "N", "side force")
    at = Parameter("x_side", "side_force_station", "m", "where it acts, ahead of the CG")
    gear = Part("main_gear", a * i, main_gear(linear_tire), suffix="")
    pushed = Part("side_force", at * i, lambda felt: Force(force * j), asks=(force,), suffix="")
    _, yaw_rate = _steady([gear, pushed])
    (station,) = sp.solve(closed.in_stiffnesses(yaw_rate), at)
    return sp.factor(station)


def _understeer_gradient() -> sp.Expr:
    """K_us of a steady turn r = u delta / (L + K_us u^2), with the main wheels steered by delta."""
    delta = Input("delta", "steer_angle", "rad", "main wheels turned to the right")
    model_A, *_ = state_space(linear())
    steered = Part("main_gear", a * i, _steered(linear_tire, delta), asks=(delta,), suffix="")
    _, yaw_rate = _steady([steered])
    per_angle = closed.in_stiffnesses(yaw_rate) / closed.in_stiffnesses(model_A.det())
    gradient = sp.factor(sp.simplify((u / per_angle - (a + b)) / u**2))
    return gradient.subs(a + b, L)


def _steered(tire: Tire, angle: Quantity) -> Law:
    """The main gear with its wheels turned: the slip angle counts from where they point."""

    def law(felt: Felt) -> Force:
        straight = slip_angle(alpha, felt.velocity, "Eq. 4.14")
        turned = Equation(alpha, straight.rhs - angle, "Gillespie, ch. 6")
        chain = (turned, *tire(alpha), Equation(F_main, 2 * F_y, "Eq. 4.38"))
        return Force(-F_main * j, chain=chain, shown=())

    return law


def tail_wheel_needed() -> Chain:
    """Tail wheel stiffness that makes det A = 0, at this speed and at the worst one."""
    A, *_ = state_space(linear())
    (at_this_speed,) = sp.solve(closed.in_stiffnesses(A.det()), K)
    at_worst = root_of_stiffness(ahead := sp.Symbol("ahead", positive=True))
    return (
        wheelbase(),
        Equation(_K_needed, sp.factor(at_this_speed).subs(a + b, L), "from det A = 0"),
        Equation(stiffness_needed, _K_needed - k * u**2, "Eq. 4.31"),
        # a gear behind the CG makes q_1 positive: it counts as a = 0
        Equation(
            _root_needed,
            at_worst.subs(ahead + b, L).subs(ahead, sp.Max(0, a)),
            "from q_1 + 2 sqrt(q_0 q_2) = 0",
        ),
        Equation(stiffness_needed_always, sp.Max(0, _root_needed) ** 2, "its square"),
        Equation(
            speed_margin,
            sp.sqrt(b) / sp.sqrt(C_f * L) * (sp.sqrt(Ct) - _root_needed),
            "from q_1 + 2 sqrt(q_0 q_2) > 0",
        ),
    )


def root_of_stiffness(ahead: sp.Symbol) -> sp.Expr:
    """sqrt(Ct) where the speed polynomial of a gear at a = `ahead` > 0 has a double root.

    A double root is where q_1 + 2 sqrt(q_0 q_2) = 0: the least det A over speed is zero.
    """
    root, C, tail = sp.symbols("root C tail", positive=True)
    polynomial = {e.lhs: e.rhs for e in closed.speed_polynomial()}
    least = (q_1 + 2 * sp.sqrt(q_0 * q_2)).subs(polynomial)
    least = least.subs({Ct: root**2, C_f: C, k: tail, a: ahead})
    (positive,) = sp.solve(sp.expand(sp.powdenest(least, force=True)), root)
    return positive.subs({C: C_f, tail: k})
