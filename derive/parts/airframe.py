"""The airframe by its derivatives, at the CG, in body axes; lift stalls, derivatives do not."""

from __future__ import annotations

import sympy as sp

from groundroll.derive.core.equation import Equation
from groundroll.derive.core.frames import i, j, k
from groundroll.derive.core.part import Felt, Force, Law
from groundroll.derive.core.quantity import Constant, Parameter, Quantity

from .air import rudder_max, stalled
from .controls import aileron, elevator, pedal, rudder
from .quantities import rho

S = Parameter("S_wing", "wing_area", "m^2", "reference area", "S", ">0")
span = Parameter("b_wing", "wing_span", "m", "reference span", "b", ">0")
chord = Parameter("c_wing", "mean_chord", "m", "reference chord", r"\bar{c}", ">0")


def _derivative(symbol: str, name: str, meaning: str, latex: str, unit: str = "1/rad") -> Quantity:
    return Parameter(symbol, name, unit, meaning, latex)


CL_0 = _derivative("CL_0", "CL_0", "lift coefficient at no attitude, flaps as set", "C_{L0}", "1")
CL_alpha = _derivative("CL_alpha", "CL_alpha", "lift by angle of attack", r"C_{L\alpha}")
CL_max = Parameter("CL_max", "CL_max", "1", "lift coefficient at which the wing stalls", sign=">0")
CD_0 = _derivative("CD_0", "CD_0", "drag coefficient at no lift", "C_{D0}", "1")
K_drag = _derivative("K_drag", "induced_drag_factor", "drag over lift squared", "K", "1")
CY_beta = _derivative("CY_beta", "CY_beta", "side force by sideslip", r"C_{Y\beta}")
CY_r = _derivative("CY_r", "CY_r", "side force by yaw rate, r span/2V", "C_{Yr}")
CY_rudder = _derivative("CY_rudder", "CY_rudder", "side force by rudder", r"C_{Y\delta r}")
Cl_beta = _derivative("Cl_beta", "Cl_beta", "roll by sideslip", r"C_{l\beta}")
Cl_p = _derivative("Cl_p", "Cl_p", "roll by roll rate, p span/2V", "C_{lp}")
Cl_r = _derivative("Cl_r", "Cl_r", "roll by yaw rate, r span/2V", "C_{lr}")
Cl_aileron = _derivative("Cl_aileron", "Cl_aileron", "roll by aileron", r"C_{l\delta a}")
Cm_0 = _derivative("Cm_0", "Cm_0", "pitch at no angle of attack", "C_{m0}", "1")
Cm_alpha = _derivative("Cm_alpha", "Cm_alpha", "pitch by angle of attack", r"C_{m\alpha}")
Cm_q = _derivative("Cm_q", "Cm_q", "pitch by pitch rate, q chord/2V", "C_{mq}")
Cm_elevator = _derivative("Cm_elevator", "Cm_elevator", "pitch by elevator", r"C_{m\delta e}")
Cn_beta = _derivative("Cn_beta", "Cn_beta", "yaw by sideslip", r"C_{n\beta}")
Cn_r = _derivative("Cn_r", "Cn_r", "yaw by yaw rate, r span/2V", "C_{nr}")
Cn_rudder = _derivative("Cn_rudder", "Cn_rudder", "yaw by rudder", r"C_{n\delta r}")
Cn_aileron = _derivative("Cn_aileron", "Cn_aileron", "yaw by aileron", r"C_{n\delta a}")

#: Air slower than this has no direction.
STILL = Constant(1e-4, "m/s")

u_air = Quantity("u_air", "air_speed_along_x", "m/s", "velocity through the air along x")
v_air = Quantity("v_air", "air_speed_along_y", "m/s", "velocity through the air along y")
w_air = Quantity("w_air", "air_speed_along_z", "m/s", "velocity through the air along z")
V_plane = Quantity("V_plane", "speed_in_plane", "m/s", "through the air in the plane of symmetry")
V_air = Quantity("V_air", "airspeed", "m/s", "speed through the air")
attack = Quantity("attack", "angle_of_attack", "rad", "of the air, from below", r"\alpha_a")
sideslip = Quantity("sideslip", "air_sideslip", "rad", "of the air, from the right", r"\beta_a")
deflected = Quantity("deflected", "rudder_deflection", "rad", "trailing edge left", r"\delta_r")
qS = Quantity("qS", "dynamic_force", "N", "dynamic pressure times wing area", r"\bar{q} S")
CL = Quantity("CL", "lift_coefficient", "1", "of the wing", "C_L")
CD = Quantity("CD", "drag_coefficient", "1", "of the aircraft", "C_D")
lift = Quantity("lift", "lift", "N", "of the wing, across the air in the plane of symmetry")
drag = Quantity("drag", "drag", "N", "of the aircraft, along the air in the plane of symmetry")
Y_air = Quantity("Y_air", "air_side_force", "N", "by the derivatives, to the right")
L_air = Quantity("L_air", "air_roll_moment", "N m", "by the derivatives, right wing down")
M_air = Quantity("M_air", "air_pitch_moment", "N m", "by the derivatives, nose up")
N_air = Quantity("N_air", "air_yaw_moment", "N m", "by the derivatives, nose right")


def airframe(incidence: sp.Expr = sp.S.Zero) -> Law:
    """Lift, drag and the derivatives; `incidence` is that of a level body over its path.

    Angle of attack and sideslip are those of the air in the plane of symmetry and out of it. A
    rate makes rho V S span^2/4 times its derivative, nothing in still air.
    """

    def law(felt: Felt) -> Force:
        rolling, pitching, yawing = (felt.rates.dot(axis) for axis in (i, j, k))
        by_span, by_chord = (sp.Rational(1, 4) * rho * V_air * S * b for b in (span, chord))
        chain = (
            Equation(u_air, felt.air_velocity.dot(i), "air"),
            Equation(v_air, felt.air_velocity.dot(j), "air"),
            Equation(w_air, felt.air_velocity.dot(k), "air"),
            Equation(V_plane, sp.sqrt(u_air**2 + w_air**2 + STILL**2), "air"),
            Equation(V_air, sp.sqrt(V_plane**2 + v_air**2), "air"),
            Equation(
                attack,
                sp.atan2(w_air, sp.sqrt(u_air**2 + STILL**2)) + incidence,
                "angle of attack; from behind as from ahead",
            ),
            Equation(sideslip, sp.atan2(v_air, V_plane), "angle of sideslip"),
            Equation(deflected, rudder - rudder_max * pedal, "linkage"),
            Equation(qS, sp.Rational(1, 2) * rho * V_air**2 * S, "dynamic pressure"),
            Equation(CL, stalled(CL_0 + CL_alpha * attack, CL_max), "lift, and stall"),
            Equation(CD, CD_0 + K_drag * CL**2, "drag polar"),
            Equation(lift, qS * CL, "lift"),
            Equation(drag, qS * CD, "drag"),
            Equation(
                Y_air,
                qS * (CY_beta * sideslip + CY_rudder * deflected) + by_span * CY_r * yawing,
                "derivatives",
            ),
            Equation(
                L_air,
                qS * span * (Cl_beta * sideslip + Cl_aileron * aileron)
                + by_span * span * (Cl_p * rolling + Cl_r * yawing),
                "derivatives",
            ),
            Equation(
                M_air,
                qS * chord * (Cm_0 + Cm_alpha * attack + Cm_elevator * elevator)
                + by_chord * chord * Cm_q * pitching,
                "derivatives",
            ),
            Equation(
                N_air,
                qS * span * (Cn_beta * sideslip + Cn_rudder * deflected + Cn_aileron * aileron)
                + by_span * span * Cn_r * yawing,
                "derivatives",
            ),
        )
        forward, down = u_air / V_plane, w_air / V_plane
        return Force(
            vector=(lift * down - drag * forward) * i
            + Y_air * j
            - (lift * forward + drag * down) * k,
            couple=L_air * i + M_air * j + N_air * k,
            chain=chain,
            shown=(attack, sideslip, CL, lift, drag, Y_air, L_air, M_air, N_air),
        )

    return law
