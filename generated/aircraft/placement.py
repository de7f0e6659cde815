# Generated from derive/ (digest 0a06213221c378cc) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`.
"""Where the wheels may stand: loads, margins and limits from stations."""

from functools import cache

import casadi as ca


@cache
def placement_following() -> ca.Function:
    """Arms, loads and stiffnesses where the stiffnesses follow the loads.

    Inputs
    ------
    x_main : scalar [m], the main gear behind it
    x_third : scalar [m], tail wheel or nose wheel behind the datum
    x_tail : scalar [m], vertical tail and tail wheel behind it
    kappa : scalar [1], stiffness of the tail wheel over that of the aircraft file; 0: it casters
    u : scalar [m/s], forward speed, constant
    x_cg : scalar [m], the CG behind the datum
    m : scalar [kg], total mass
    w : scalar [1], share of the weight on the wheels, lift by speed apart
    tau : scalar [1], load on the tail wheel over the one that follows from the CG
    eta : scalar [1], cornering stiffness of the tires over that of new ones
    g : scalar [m/s^2], acceleration due to gravity
    u_lift : scalar [m/s], speed at which the wings carry all the weight, in the attitude of the ground roll
    B3 : scalar [1/rad], cornering coefficient at no load
    C3 : scalar [1/(rad N)], its change with load
    K1 : scalar [1/rad], tail wheel stiffness over load: linear term
    K2 : scalar [1/(rad N)], quadratic term
    K3 : scalar [1/(rad N^2)], cubic term
    K4 : scalar [1/(rad N^3)], quartic term

    Outputs
    -------
    a : 1 x 1, main gear ahead of the CG (positive: taildragger) [m]
    b : 1 x 1, CG ahead of the vertical tail and the tail wheel [m]
    Fz : 1 x 1, vertical load on one main tire [N]
    F_tail_load : 1 x 1, vertical load on the tail wheel [N]
    C_alpha : 1 x 1, cornering stiffness of one main tire [N/rad]
    Ct : 1 x 1, cornering stiffness of the tail wheel [N/rad]

    Thesis
    ------
    App. A.6, Fig. 3.8
    """
    x_main = ca.SX.sym("x_main")
    x_third = ca.SX.sym("x_third")
    x_tail = ca.SX.sym("x_tail")
    kappa = ca.SX.sym("kappa")
    u = ca.SX.sym("u")
    x_cg = ca.SX.sym("x_cg")
    m = ca.SX.sym("m")
    w = ca.SX.sym("w")
    tau = ca.SX.sym("tau")
    eta = ca.SX.sym("eta")
    g = ca.SX.sym("g")
    u_lift = ca.SX.sym("u_lift")
    B3 = ca.SX.sym("B3")
    C3 = ca.SX.sym("C3")
    K1 = ca.SX.sym("K1")
    K2 = ca.SX.sym("K2")
    K3 = ca.SX.sym("K3")
    K4 = ca.SX.sym("K4")
    a = x_cg - x_main  # Section 4.2.2
    b = -x_cg + x_tail  # Section 4.2.2
    f = (-x_cg + x_third)/(-x_main + x_third)  # App. A.6
    w_u = w*(-u**2/u_lift**2 + 1)  # definition of the lift-off speed
    w2 = g*m*w_u
    Fz = (1/2)*f*w2  # App. A.6
    F_tail_load = tau*w2*(1 - f)  # App. A.6
    B3_worn = B3*eta  # definition of tire wear
    C3_worn = C3*eta  # definition of tire wear
    C_alpha = Fz*(B3_worn + C3_worn*Fz)  # Eqs. 3.2, 3.3
    Ct = eta*kappa*(F_tail_load**4*K4 + F_tail_load**3*K3 + F_tail_load**2*K2 + F_tail_load*K1)  # Fig. 3.8
    return ca.Function(
        "placement_following",
        [x_main, x_third, x_tail, kappa, u, x_cg, m, w, tau, eta, g, u_lift, B3, C3, K1, K2, K3, K4],
        [a, b, Fz, F_tail_load, C_alpha, Ct],
        ["x_main", "x_third", "x_tail", "kappa", "u", "x_cg", "m", "w", "tau", "eta", "g", "u_lift", "B3", "C3", "K1", "K2", "K3", "K4"],
        ["a", "b", "Fz", "F_tail_load", "C_alpha", "Ct"],
    )


@cache
def placement_constant() -> ca.Function:
    """Arms, loads and stiffnesses where no stiffness knows where the gear is.

    Inputs
    ------
    x_main : scalar [m], the main gear behind it
    x_third : scalar [m], tail wheel or nose wheel behind the datum
    x_tail : scalar [m], vertical tail and tail wheel behind it
    kappa : scalar [1], stiffness of the tail wheel over that of the aircraft file; 0: it casters
    u : scalar [m/s], forward speed, constant
    x_cg : scalar [m], the CG behind the datum
    m : scalar [kg], total mass
    w : scalar [1], share of the weight on the wheels, lift by speed apart
    tau : scalar [1], load on the tail wheel over the one that follows from the CG
    eta : scalar [1], cornering stiffness of the tires over that of new ones
    g : scalar [m/s^2], acceleration due to gravity
    u_lift : scalar [m/s], speed at which the wings carry all the weight, in the attitude of the ground roll
    C_alpha_0 : scalar [N/rad], cornering stiffness of one main tire at the full weight
    Fz_0 : scalar [N], load on one main tire at the full weight
    Ct_0 : scalar [N/rad], cornering stiffness of the tail wheel at its static load
    F_0 : scalar [N], the static load at which that holds
    K1 : scalar [1/rad], tail wheel stiffness over load: linear term
    K2 : scalar [1/(rad N)], quadratic term
    K3 : scalar [1/(rad N^2)], cubic term
    K4 : scalar [1/(rad N^3)], quartic term

    Outputs
    -------
    a : 1 x 1, main gear ahead of the CG (positive: taildragger) [m]
    b : 1 x 1, CG ahead of the vertical tail and the tail wheel [m]
    Fz : 1 x 1, vertical load on one main tire [N]
    F_tail_load : 1 x 1, vertical load on the tail wheel [N]
    C_alpha : 1 x 1, cornering stiffness of one main tire [N/rad]
    Ct : 1 x 1, cornering stiffness of the tail wheel [N/rad]

    Thesis
    ------
    App. A.6
    """
    x_main = ca.SX.sym("x_main")
    x_third = ca.SX.sym("x_third")
    x_tail = ca.SX.sym("x_tail")
    kappa = ca.SX.sym("kappa")
    u = ca.SX.sym("u")
    x_cg = ca.SX.sym("x_cg")
    m = ca.SX.sym("m")
    w = ca.SX.sym("w")
    tau = ca.SX.sym("tau")
    eta = ca.SX.sym("eta")
    g = ca.SX.sym("g")
    u_lift = ca.SX.sym("u_lift")
    C_alpha_0 = ca.SX.sym("C_alpha_0")
    Fz_0 = ca.SX.sym("Fz_0")
    Ct_0 = ca.SX.sym("Ct_0")
    F_0 = ca.SX.sym("F_0")
    K1 = ca.SX.sym("K1")
    K2 = ca.SX.sym("K2")
    K3 = ca.SX.sym("K3")
    K4 = ca.SX.sym("K4")
    a = x_cg - x_main  # Section 4.2.2
    b = -x_cg + x_tail  # Section 4.2.2
    f = (-x_cg + x_third)/(-x_main + x_third)  # App. A.6
    w_u = w*(-u**2/u_lift**2 + 1)  # definition of the lift-off speed
    Fz = Fz_0*w_u  # Table 4.3
    F_tail_load = g*m*tau*w_u*(1 - f)  # App. A.6
    C_alpha = C_alpha_0*eta*w_u  # Table 4.3
    w3 = F_0**2*K3
    w4 = F_0**3*K4
    Ct = Ct_0*eta*kappa*tau*(F_0*K2*tau + K1 + tau**3*w4 + tau**2*w3)/(F_0*K2 + K1 + w3 + w4)  # Table 4.7
    return ca.Function(
        "placement_constant",
        [x_main, x_third, x_tail, kappa, u, x_cg, m, w, tau, eta, g, u_lift, C_alpha_0, Fz_0, Ct_0, F_0, K1, K2, K3, K4],
        [a, b, Fz, F_tail_load, C_alpha, Ct],
        ["x_main", "x_third", "x_tail", "kappa", "u", "x_cg", "m", "w", "tau", "eta", "g", "u_lift", "C_alpha_0", "Fz_0", "Ct_0", "F_0", "K1", "K2", "K3", "K4"],
        ["a", "b", "Fz", "F_tail_load", "C_alpha", "Ct"],
    )


@cache
def placement_tire() -> ca.Function:
    """Cornering coefficient of a worn tire.

    Inputs
    ------
    eta : scalar [1], cornering stiffness of the tires over that of new ones
    B3 : scalar [1/rad], cornering coefficient at no load
    C3 : scalar [1/(rad N)], its change with load

    Outputs
    -------
    B3_worn : 1 x 1, B3 of a worn tire [1/rad]
    C3_worn : 1 x 1, C3 of a worn tire [1/(rad N)]
    """
    eta = ca.SX.sym("eta")
    B3 = ca.SX.sym("B3")
    C3 = ca.SX.sym("C3")
    B3_worn = B3*eta  # definition of tire wear
    C3_worn = C3*eta  # definition of tire wear
    return ca.Function(
        "placement_tire",
        [eta, B3, C3],
        [B3_worn, C3_worn],
        ["eta", "B3", "C3"],
        ["B3_worn", "C3_worn"],
    )


@cache
def placement_margins() -> ca.Function:
    """Smooth conditions for a decay rate and a damping ratio.

    Inputs
    ------
    m : scalar [kg], total mass
    Izz : scalar [kg m^2], moment of inertia about the z axis
    a : scalar [m], main gear ahead of the CG (positive: taildragger)
    b : scalar [m], CG ahead of the vertical tail and the tail wheel
    u : scalar [m/s], forward speed, constant
    rho : scalar [kg/m^3], density of the air
    Ap : scalar [m^2], area of the vertical tail
    CL_gamma : scalar [1/rad], lift-curve slope of the vertical tail
    C_alpha : scalar [N/rad], cornering stiffness of one main tire
    Ct : scalar [N/rad], cornering stiffness of the tail wheel
    d : scalar [1/s], a decay rate to be reached
    zeta : scalar [1], a damping ratio to be reached

    Outputs
    -------
    trace : 1 x 1, tr A: stable needs < 0 [1/s]
    det : 1 x 1, det A: stable needs > 0 [1/s^2]
    trace_d : 1 x 1, tr(A + d I): not positive [1/s]
    det_d : 1 x 1, det(A + d I): not negative [1/s^2]
    damping : 1 x 1, (tr A)^2 - 4 zeta^2 det A: not negative [1/s^2]

    Thesis
    ------
    Eq. 4.28, Eq. 4.29, Eq. 4.31
    """
    m = ca.SX.sym("m")
    Izz = ca.SX.sym("Izz")
    a = ca.SX.sym("a")
    b = ca.SX.sym("b")
    u = ca.SX.sym("u")
    rho = ca.SX.sym("rho")
    Ap = ca.SX.sym("Ap")
    CL_gamma = ca.SX.sym("CL_gamma")
    C_alpha = ca.SX.sym("C_alpha")
    Ct = ca.SX.sym("Ct")
    d = ca.SX.sym("d")
    zeta = ca.SX.sym("zeta")
    C_f = 2*C_alpha  # Eq. 4.28
    k = (1/2)*Ap*CL_gamma*rho  # Eq. 4.29
    K = Ct + k*u**2  # Eq. 4.31
    w4 = 1/(m*u)
    w6 = 1/(Izz*u)
    trace = C_f*(-a**2*w6 - w4) + K*(-b**2*w6 - w4)  # Section 4.7
    det = C_f*K*(a + b)**2/(Izz*m*u**2) - C_f*a/Izz + K*b/Izz  # Section 4.7
    trace_d = 2*d + trace  # Section 4.7
    det_d = d**2 + d*trace + det  # Section 4.7
    damping = -4*det*zeta**2 + trace**2  # Section 4.7
    return ca.Function(
        "placement_margins",
        [m, Izz, a, b, u, rho, Ap, CL_gamma, C_alpha, Ct, d, zeta],
        [trace, det, trace_d, det_d, damping],
        ["m", "Izz", "a", "b", "u", "rho", "Ap", "CL_gamma", "C_alpha", "Ct", "d", "zeta"],
        ["trace", "det", "trace_d", "det_d", "damping"],
    )


@cache
def placement_limits() -> ca.Function:
    """What else limits the place of the wheels.

    Inputs
    ------
    x_main : scalar [m], the main gear behind it
    x_third : scalar [m], tail wheel or nose wheel behind the datum
    x_cg : scalar [m], the CG behind the datum
    h_cg : scalar [m], the CG above the ground, in the attitude in which stations are measured

    Outputs
    -------
    third_load : 1 x 1, share of the weight on the tail wheel or nose wheel, at rest [1]
    nose_over : 1 x 1, from the vertical below the CG forward to the main wheels [rad]
    tip_back : 1 x 1, from the vertical below the CG back to the main wheels [rad]
    span : 1 x 1, main gear to tail wheel or nose wheel [m]

    Thesis
    ------
    App. A.6
    """
    x_main = ca.SX.sym("x_main")
    x_third = ca.SX.sym("x_third")
    x_cg = ca.SX.sym("x_cg")
    h_cg = ca.SX.sym("h_cg")
    a = x_cg - x_main  # Section 4.2.2
    f = -(-x_cg + x_third)/(x_main - x_third)  # App. A.6
    third_load = 1 - f  # App. A.6
    nose_over = ca.atan(a/h_cg)  # Raymer, ch. 11
    tip_back = -nose_over  # Raymer, ch. 11
    span = ca.fabs(x_main - x_third)  # Section 4.2
    return ca.Function(
        "placement_limits",
        [x_main, x_third, x_cg, h_cg],
        [third_load, nose_over, tip_back, span],
        ["x_main", "x_third", "x_cg", "h_cg"],
        ["third_load", "nose_over", "tip_back", "span"],
    )
