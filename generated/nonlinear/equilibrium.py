# Generated from derive/ (digest 0b025fe68865f259) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`.
"""Steady turns under a steady side force."""

from functools import cache

import casadi as ca

from groundroll.generated import intervals


@cache
def nonlinear_equilibrium() -> ca.Function:
    """The steady turn at a slip angle: an equilibrium where the moment is zero.

    Inputs
    ------
    alpha : scalar [rad], slip angle of the main tires
    F_disturbance : scalar [N], side force on the vertical tail (a crosswind), to the right
    m : scalar [kg], total mass
    a : scalar [m], main gear ahead of the CG (positive: taildragger)
    b : scalar [m], CG ahead of the vertical tail and the tail wheel
    u : scalar [m/s], forward speed, constant
    rho : scalar [kg/m^3], density of the air
    Ap : scalar [m^2], area of the vertical tail
    CL_gamma : scalar [1/rad], lift-curve slope of the vertical tail
    Ct : scalar [N/rad], cornering stiffness of the tail wheel
    Fz : scalar [N], vertical load on one main tire
    B3 : scalar [1/rad], cornering coefficient at no load
    C3 : scalar [1/(rad N)], its change with load
    B5 : scalar [1], friction coefficient at no load
    C5 : scalar [1/N], its change with load
    B1 : scalar [1], magic formula: stiffness factor
    C1 : scalar [1], magic formula: shape factor
    D1 : scalar [1], magic formula: peak factor
    E1 : scalar [1], magic formula: curvature factor

    Outputs
    -------
    sum_M : 1 x 1, sum of the moments about z through the CG [N m]
    d_sum_M_d_alpha : 1 x 1, derivative of sum_M by alpha [(N m)/(rad)]
    d_M_gear_d_alpha : 1 x 1, derivative of M_gear by alpha [(N m)/(rad)]
    v : 1 x 1, velocity of the CG along the body y axis, to the right [m/s]
    r : 1 x 1, angular velocity about the body z axis, nose right [rad/s]

    Thesis
    ------
    Eq. 3.3, Eq. 3.5, Eq. 3.6, Eq. 3.10, Eq. 3.9, Eq. 3.8, Eq. 3.11, Eq. 4.38, Eq. 4.9 with
    v_dot = r_dot = 0, Eq. 4.14, Eq. 4.19, Eq. 4.29, Eq. 4.30, Eq. 4.8
    """
    alpha = ca.SX.sym("alpha")
    F_disturbance = ca.SX.sym("F_disturbance")
    m = ca.SX.sym("m")
    a = ca.SX.sym("a")
    b = ca.SX.sym("b")
    u = ca.SX.sym("u")
    rho = ca.SX.sym("rho")
    Ap = ca.SX.sym("Ap")
    CL_gamma = ca.SX.sym("CL_gamma")
    Ct = ca.SX.sym("Ct")
    Fz = ca.SX.sym("Fz")
    B3 = ca.SX.sym("B3")
    C3 = ca.SX.sym("C3")
    B5 = ca.SX.sym("B5")
    C5 = ca.SX.sym("C5")
    B1 = ca.SX.sym("B1")
    C1 = ca.SX.sym("C1")
    D1 = ca.SX.sym("D1")
    E1 = ca.SX.sym("E1")
    C_c = B3 + C3*Fz  # Eq. 3.3
    mu = B5 + C5*Fz  # Eq. 3.5
    alpha_bar = C_c*ca.tan(alpha)/mu  # Eq. 3.6
    psi_bar = alpha_bar*(1 - E1) + E1*ca.atan(B1*alpha_bar)/B1  # Eq. 3.10
    theta_bar = C1*ca.atan(B1*psi_bar)  # Eq. 3.9
    F_bar = D1*ca.sin(theta_bar)  # Eq. 3.8
    F_y = F_bar*Fz*mu  # Eq. 3.11
    F_main = 2*F_y  # Eq. 4.38
    w6 = 1/(b*m*u)
    r = -F_main*w6*(a + b)  # Eq. 4.9 with v_dot = r_dot = 0
    v = -a*r + u*ca.tan(alpha)  # Eq. 4.14
    w7 = -b*r + v
    gamma = ca.atan(w7/u)  # Eq. 4.19
    w9 = (1/2)*Ap*CL_gamma*rho*u**2
    F_tail = gamma*w9  # Eq. 4.29
    F_tail_wheel = Ct*gamma  # Eq. 4.30
    sum_M = -F_disturbance*b - F_main*a + F_tail*b + F_tail_wheel*b  # Eq. 4.8
    w10 = ca.tan(alpha)**2 + 1
    d_alpha_bar_d_alpha = C_c*w10/mu  # chain rule on Eq. 3.6
    d_psi_bar_d_alpha = d_alpha_bar_d_alpha*(-E1 + E1/(B1**2*alpha_bar**2 + 1) + 1)  # chain rule on Eq. 3.10
    d_theta_bar_d_alpha = B1*C1*d_psi_bar_d_alpha/(B1**2*psi_bar**2 + 1)  # chain rule on Eq. 3.9
    d_F_bar_d_alpha = D1*d_theta_bar_d_alpha*ca.cos(theta_bar)  # chain rule on Eq. 3.8
    d_F_y_d_alpha = Fz*d_F_bar_d_alpha*mu  # chain rule on Eq. 3.11
    d_F_main_d_alpha = 2*d_F_y_d_alpha  # chain rule on Eq. 4.38
    w12 = d_F_main_d_alpha*(a + b)
    d_r_d_alpha = -w12*w6  # chain rule on Eq. 4.9 with v_dot = r_dot = 0
    d_v_d_alpha = -a*d_r_d_alpha + u*w10  # chain rule on Eq. 4.14
    w13 = 1/(1 + w7**2/u**2)
    d_gamma_d_alpha = -b*d_r_d_alpha*w13/u + d_v_d_alpha*w13/u  # chain rule on Eq. 4.19
    d_F_tail_d_alpha = d_gamma_d_alpha*w9  # chain rule on Eq. 4.29
    d_F_tail_wheel_d_alpha = Ct*d_gamma_d_alpha  # chain rule on Eq. 4.30
    d_sum_M_d_alpha = -a*d_F_main_d_alpha + b*d_F_tail_d_alpha + b*d_F_tail_wheel_d_alpha  # chain rule on Eq. 4.8
    d_M_gear_d_alpha = w12  # chain rule on a scale for the sum
    return ca.Function(
        "nonlinear_equilibrium",
        [alpha, F_disturbance, m, a, b, u, rho, Ap, CL_gamma, Ct, Fz, B3, C3, B5, C5, B1, C1, D1, E1],
        [sum_M, d_sum_M_d_alpha, d_M_gear_d_alpha, v, r],
        ["alpha", "F_disturbance", "m", "a", "b", "u", "rho", "Ap", "CL_gamma", "Ct", "Fz", "B3", "C3", "B5", "C5", "B1", "C1", "D1", "E1"],
        ["sum_M", "d_sum_M_d_alpha", "d_M_gear_d_alpha", "v", "r"],
    )


@cache
def bounds() -> ca.Function:
    """Bounds of the moment and its slope over angles: see `intervals.bounds`."""
    return intervals.bounds(nonlinear_equilibrium(), 2, "nonlinear_bounds")
