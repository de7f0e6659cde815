"""What follows of an aircraft where its file is silent: estimates, each with its source.

Only mass, wing area, the places of the wheels along the fuselage and the fin must be given; the
rest is what is usual for light aircraft. None of it is as good as a measurement.
"""

from __future__ import annotations

import sympy as sp

from groundroll.derive.core.body import Ixx, Ixz, Iyy, Izz, g, m
from groundroll.derive.core.equation import Chain, Equation
from groundroll.derive.core.quantity import Constant, Parameter, Quantity

from . import air, airframe, fates, stations, third_wheel
from .friction import TIRE, v_rest
from .gear import (
    MAIN_LEG,
    THIRD_LEG,
    a_third,
    rolling,
    surface,
    theta_ground,
    toe,
    track,
    z_main,
    z_third,
)
from .quantities import a, b, h_cg

length = Parameter("length", "fuselage_length", "m", "of the aircraft", sign=">0")
sag_main = Parameter("sag_main", "main_leg_deflection", "m", "of a main leg at rest", sign=">0")
sag_third = Parameter(
    "sag_third", "third_leg_deflection", "m", "of the third leg at rest", sign=">0"
)
zeta_leg = Parameter("zeta_leg", "leg_damping_ratio", "1", "of a leg with the mass it carries")
a_rest = Quantity("a_rest", "main_arm_at_rest", "m", "main wheels ahead of the CG, as it stands")
x_rest = Quantity("x_rest", "third_arm_at_rest", "m", "third wheel ahead of the CG, as it stands")
N_third = Quantity("N_third", "third_load_at_rest", "N", "load on the third wheel at rest")
N_main = Quantity("N_main", "main_load_at_rest", "N", "load on a main wheel at rest")
aspect = Quantity("aspect", "aspect_ratio", "1", "of the wing", "A")

half, quarter = sp.Rational(1, 2), sp.Rational(1, 4)


def _decimal(text: str) -> sp.Rational:
    return sp.Rational(text)


def _angle(degrees: int) -> sp.Expr:
    return sp.Rational(degrees, 180) * sp.Float(sp.pi)


def gear() -> Chain:
    """Where the wheels are, their legs, the third wheel."""
    sine, cosine = sp.sin(theta_ground), sp.cos(theta_ground)
    rear = sp.tan(theta_ground) * (a - a_third)
    return (
        Equation(theta_ground, 0, "stations are measured as it stands"),
        Equation(h_cg, _decimal("0.2") * b, "0.20 of it: J-3, Cessna 170; 0.22: Cessna 172"),
        Equation(a_third, -b, "below the fin, as in the thesis"),
        Equation(sag_main, Constant(0.09, "m"), "usual, 0.08 to 0.1 m"),
        Equation(sag_third, Constant(0.05, "m"), "usual, half of the main legs'"),
        Equation(zeta_leg, _decimal("0.15"), "usual of a spring leg"),
        Equation(z_main, h_cg + sag_main, "geometry"),
        Equation(z_third, h_cg - rear + sag_third, "geometry"),
        Equation(a_rest, a * cosine + (z_main - sag_main) * sine, "geometry"),
        Equation(x_rest, a_third * cosine + (z_third - sag_third) * sine, "geometry"),
        Equation(N_third, m * g * a_rest / (a_rest - x_rest), "balance of moments"),
        Equation(N_main, half * (m * g - N_third), "balance of forces"),
        Equation(MAIN_LEG.stiffness, N_main / sag_main, "static deflection"),
        Equation(THIRD_LEG.stiffness, N_third / sag_third, "static deflection"),
        Equation(MAIN_LEG.damping, 2 * zeta_leg * N_main / sp.sqrt(g * sag_main), "damping ratio"),
        Equation(
            THIRD_LEG.damping, 2 * zeta_leg * N_third / sp.sqrt(g * sag_third), "damping ratio"
        ),
        Equation(track, _decimal("0.2") * airframe.span, "0.17: J-3; 0.20 to 0.23: Cessna 172"),
        Equation(toe, 0, "wheels set parallel"),
        *_third_wheel(),
        *(Equation(surface(w), 1, "dry runway") for w in ("left", "right", "third")),
        *(
            Equation(rolling(w), _decimal("0.02"), "on concrete; JSBSim, Raymer Table 17.1")
            for w in ("left", "right", "third")
        ),
        *(Equation(q.of("third"), q, "the tire of the main wheels") for q in TIRE),
    )


def _third_wheel() -> Chain:
    steered = sp.Piecewise((-_angle(20), a_third < 0), (_angle(10), True))
    return (
        Equation(third_wheel.swivels, 0, "fixed, or steered by the pedal"),
        Equation(third_wheel.ratio, steered, "usual of tail wheels; Cessna 172's nose wheel"),
        Equation(third_wheel.k_swivel, 0, "without springs"),
        Equation(third_wheel.I_swivel, Constant(0.02, "kg m^2"), "3 kg of fork and wheel"),
        Equation(third_wheel.c_swivel, Constant(0.5, "N m s/rad"), "estimate"),
        Equation(third_wheel.trail, Constant(0.05, "m"), "estimate"),
        Equation(third_wheel.break_out, _angle(30), "usual of tail wheels that let go"),
        Equation(third_wheel.stop, _angle(360), "it turns all the way round"),
        Equation(third_wheel.k_stop, 0, "without stops"),
    )


def inertia() -> Chain:
    """Moments of inertia by radii of gyration."""
    source = "Raymer, Aircraft Design, radii of gyration: mean of high and low wing"
    span = airframe.span
    return (
        Equation(length, b / _decimal("0.6"), "Raymer, Aircraft Design, Section 6.5: tail arm"),
        Equation(Ixx, m * (_decimal("0.245") * span / 2) ** 2, source),
        Equation(Iyy, m * (_decimal("0.367") * length / 2) ** 2, source),
        Equation(Izz, m * (_decimal("0.393") * (span + length) / 4) ** 2, source),
        Equation(Ixz, 0, "principal axes"),
    )


def wing() -> Chain:
    """Lift, drag and derivatives of the wing; those of the tail are its surfaces' own."""
    w = airframe
    slope = w.CL_alpha
    strips = "strip theory, rectangular wing"
    nothing = "none but the fin's and the tailplane's, which are apart"
    still = (w.CY_beta, w.CY_r, w.CY_rudder, w.Cn_beta, w.Cn_r, w.Cn_rudder, w.Cn_aileron)
    return (
        Equation(w.span, sp.sqrt(7 * w.S), "aspect ratio 7: Raymer Table 4.1, 6 to 7.6"),
        Equation(w.chord, w.S / w.span, "geometry"),
        Equation(aspect, w.span**2 / w.S, "definition"),
        Equation(slope, 2 * sp.Float(sp.pi) * aspect / (2 + sp.sqrt(aspect**2 + 4)), "Helmbold"),
        Equation(w.CL_0, _decimal("0.3"), "cambered aerofoil, flaps up: NACA 2412 to 4412"),
        Equation(w.CL_max, _decimal("1.5"), "usual, flaps up"),
        Equation(w.CD_0, _decimal("0.035"), "usual with a fixed gear"),
        Equation(w.K_drag, 1 / (_decimal("0.8") * sp.Float(sp.pi) * aspect), "Oswald factor 0.8"),
        Equation(w.Cl_p, -slope / 6, strips),
        Equation(w.Cl_r, w.CL_0 / 3, strips),
        Equation(w.Cl_beta, -slope * _angle(3) / 4, f"{strips}, dihedral 3 deg"),
        Equation(w.Cl_aileron, _decimal("0.06") * slope, f"{strips}, ailerons on 40 % of it"),
        Equation(w.Cm_0, -_decimal("0.05"), "NACA 2412"),
        Equation(w.Cm_alpha, 0, "CG at the wing's aerodynamic centre"),
        *(Equation(q, 0, nothing) for q in (w.Cm_q, w.Cm_elevator, *still)),
    )


def tail() -> Chain:
    """Fin, tailplane and propeller."""
    S_h = half * airframe.chord * airframe.S / -stations.x_h
    slope = airframe.CL_alpha
    return (
        Equation(stations.z_fin, -b / 10, "usual: half a metre above the CG"),
        Equation(air.fin_apart, 1, "the derivatives leave the fin out"),
        Equation(air.tailplane_apart, 1, "the derivatives leave the tailplane out"),
        Equation(air.CL_fin, 1, "usual of low aspect ratio"),
        Equation(air.tau_rudder, half, "rudder of 0.3 of the chord"),
        Equation(air.rudder_max, _angle(25), "usual"),
        Equation(stations.x_h, -b, "below the fin"),
        Equation(stations.z_h, 0, "at the height of the CG"),
        Equation(air.S_h, S_h, "Raymer Table 6.4: tail volume 0.5 of homebuilt aircraft"),
        Equation(air.CL_h, _decimal("3.9"), "Helmbold, aspect ratio 4"),
        Equation(air.CL_h_max, 1, "usual of low aspect ratio"),
        Equation(air.tau_elevator, half, "elevator of 0.3 of the chord"),
        Equation(air.i_h, 0, "parallel to the axes"),
        Equation(
            air.downwash,
            slope / (sp.Float(sp.pi) * aspect),
            "lifting line, halved by the ground",
        ),
        Equation(aspect, airframe.span**2 / airframe.S, "definition"),
        Equation(stations.z_thrust, 0, "thrust through the CG"),
        Equation(stations.x_propeller, _decimal("0.4") * b, "Cessna 172; 0.35: J-3"),
        Equation(
            stations.propeller_diameter,
            2 * (h_cg - stations.z_thrust - Constant(0.23, "m")),
            "14 CFR 23.925: 9 in above the ground in level attitude",
        ),
        Equation(
            air.A_disc,
            quarter * sp.Float(sp.pi) * stations.propeller_diameter**2,
            "disc",
        ),
        Equation(stations.x_tip, 0, "abeam of the CG"),
        Equation(stations.z_tip, -airframe.span / 40, "wing at the CG, dihedral 3 deg"),
    )


def limits() -> Chain:
    """The runway, and when a roll is over."""
    return (
        Equation(v_rest, Constant(0.01, "m/s"), "0.3 deg of 25 for a J-3 that stands in the wind"),
        Equation(fates.v_stop, Constant(0.1, "m/s"), "definition"),
        Equation(fates.width, Constant(18.3, "m"), "FAA AC 150/5300-13, small aircraft: 60 ft"),
        Equation(fates.psi_loop, _angle(90), "definition"),
    )


FOLLOWS: Chain = tuple(dict.fromkeys((*wing(), *gear(), *inertia(), *tail(), *limits())))
