# Generated from derive/ (digest 0a06213221c378cc) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`.
"""What limits an aircraft that is held straight."""

from functools import cache

import casadi as ca


@cache
def moved_loads() -> ca.Function:
    """Loads on the main wheels of a level body that is rolled.

    Inputs
    ------
    Fz_left : scalar [N], vertical load, the ground pushing up, left
    Fz_right : scalar [N], vertical load, the ground pushing up, right
    Mx_held : scalar [N m], roll couple of the ground, right wing down
    track : scalar [m], left to right main wheel

    Outputs
    -------
    N_left : 1 x 1, load on the left wheel of a body that rolls [N]
    N_right : 1 x 1, load on the right wheel of a body that rolls [N]
    """
    Fz_left = ca.SX.sym("Fz_left")
    Fz_right = ca.SX.sym("Fz_right")
    Mx_held = ca.SX.sym("Mx_held")
    track = ca.SX.sym("track")
    N_left = Fz_left + Mx_held/track  # balance of roll moments
    N_right = Fz_right - Mx_held/track  # balance of roll moments
    return ca.Function(
        "moved_loads",
        [Fz_left, Fz_right, Mx_held, track],
        [N_left, N_right],
        ["Fz_left", "Fz_right", "Mx_held", "track"],
        ["N_left", "N_right"],
    )


@cache
def friction_used() -> ca.Function:
    """How much of its friction a main tire makes.

    Inputs
    ------
    F_x : scalar [N], lengthwise force on the wheel, backward
    F_y : scalar [N], side force on the wheel, to the left
    Fz : scalar [N], vertical load, the ground pushing up
    B5 : scalar [1], friction coefficient at no load
    C5 : scalar [1/N], its change with load
    surface_left : scalar [1], friction on the runway under the left wheel over that on a dry one

    Outputs
    -------
    used : 1 x 1, force of a tire over its friction [1]

    Thesis
    ------
    Eq. 3.5
    """
    F_x = ca.SX.sym("F_x")
    F_y = ca.SX.sym("F_y")
    Fz = ca.SX.sym("Fz")
    B5 = ca.SX.sym("B5")
    C5 = ca.SX.sym("C5")
    surface_left = ca.SX.sym("surface_left")
    mu = surface_left*ca.fmax(1/1000, B5 + C5*Fz)  # Eq. 3.5
    used = ca.sqrt(F_x**2 + F_y**2)/(mu*ca.fmax(1.0, Fz))  # definition
    return ca.Function(
        "friction_used",
        [F_x, F_y, Fz, B5, C5, surface_left],
        [used],
        ["F_x", "F_y", "Fz", "B5", "C5", "surface_left"],
        ["used"],
    )


@cache
def clause_winds() -> ca.Function:
    """Stall speed, and winds of 14 CFR 25.233(a) and the former 23.233(a).

    Inputs
    ------
    m : scalar [kg], total mass
    g : scalar [m/s^2], acceleration due to gravity
    rho : scalar [kg/m^3], density of the air
    S_wing : scalar [m^2], reference area
    CL_max : scalar [1], lift coefficient at which the wing stalls

    Outputs
    -------
    V_stall : 1 x 1, 1 g, at the largest lift of the wing [m/s]
    wind_large : 1 x 1, 90 deg wind of 14 CFR 25.233(a), by this stall speed [m/s]
    wind_small : 1 x 1, 90 deg wind of the former 14 CFR 23.233(a) [m/s]
    """
    m = ca.SX.sym("m")
    g = ca.SX.sym("g")
    rho = ca.SX.sym("rho")
    S_wing = ca.SX.sym("S_wing")
    CL_max = ca.SX.sym("CL_max")
    V_stall = ca.sqrt(2)*ca.sqrt(g)*ca.sqrt(m)/(ca.sqrt(CL_max)*ca.sqrt(S_wing)*ca.sqrt(rho))  # lift carries the weight
    wind_large = ca.fmin(25*0.5144444444444445, ca.fmax(20*0.5144444444444445, (1/5)*V_stall))  # 14 CFR 25.233(a)
    wind_small = (1/5)*V_stall  # 14 CFR 23.233(a), before amendment 23-64
    return ca.Function(
        "clause_winds",
        [m, g, rho, S_wing, CL_max],
        [V_stall, wind_large, wind_small],
        ["m", "g", "rho", "S_wing", "CL_max"],
        ["V_stall", "wind_large", "wind_small"],
    )
