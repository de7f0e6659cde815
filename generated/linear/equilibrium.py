# Generated from derive/ (digest bfd9ab80ef38709d) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`.
"""Steady turns under a steady side force."""

from functools import cache

import casadi as ca

from groundroll.generated import intervals


@cache
def linear_equilibrium() -> ca.Function:
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
    C_alpha : scalar [N/rad], cornering stiffness of one main tire
    Ct : scalar [N/rad], cornering stiffness of the tail wheel

    Outputs
    -------
    sum_M : 1 x 1, sum of the moments about z through the CG [N m]
    d_sum_M_d_alpha : 1 x 1, derivative of sum_M by alpha [(N m)/(rad)]
    d_M_gear_d_alpha : 1 x 1, derivative of M_gear by alpha [(N m)/(rad)]
    v : 1 x 1, velocity of the CG along the body y axis, to the right [m/s]
    r : 1 x 1, angular velocity about the body z axis, nose right [rad/s]

    Thesis
    ------
    Eq. 3.1, Eq. 4.28, Eq. 4.9 with v_dot = r_dot = 0, Eq. 4.24, Eq. 4.26, Eq. 4.29, Eq.
    4.30, Eq. 4.8
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
    C_alpha = ca.SX.sym("C_alpha")
    Ct = ca.SX.sym("Ct")
    F_y = C_alpha*alpha  # Eq. 3.1
    F_main = 2*F_y  # Eq. 4.28
    w3 = 1/(b*m*u)
    r = -F_main*w3*(a + b)  # Eq. 4.9 with v_dot = r_dot = 0
    v = -a*r + alpha*u  # Eq. 4.24
    gamma = (-b*r + v)/u  # Eq. 4.26
    w4 = (1/2)*Ap*CL_gamma*rho*u**2
    F_tail = gamma*w4  # Eq. 4.29
    F_tail_wheel = Ct*gamma  # Eq. 4.30
    sum_M = -F_disturbance*b - F_main*a + F_tail*b + F_tail_wheel*b  # Eq. 4.8
    d_F_y_d_alpha = C_alpha  # chain rule on Eq. 3.1
    d_F_main_d_alpha = 2*d_F_y_d_alpha  # chain rule on Eq. 4.28
    w5 = d_F_main_d_alpha*(a + b)
    d_r_d_alpha = -w3*w5  # chain rule on Eq. 4.9 with v_dot = r_dot = 0
    d_v_d_alpha = -a*d_r_d_alpha + u  # chain rule on Eq. 4.24
    d_gamma_d_alpha = -b*d_r_d_alpha/u + d_v_d_alpha/u  # chain rule on Eq. 4.26
    d_F_tail_d_alpha = d_gamma_d_alpha*w4  # chain rule on Eq. 4.29
    d_F_tail_wheel_d_alpha = Ct*d_gamma_d_alpha  # chain rule on Eq. 4.30
    d_sum_M_d_alpha = -a*d_F_main_d_alpha + b*d_F_tail_d_alpha + b*d_F_tail_wheel_d_alpha  # chain rule on Eq. 4.8
    d_M_gear_d_alpha = w5  # chain rule on a scale for the sum
    return ca.Function(
        "linear_equilibrium",
        [alpha, F_disturbance, m, a, b, u, rho, Ap, CL_gamma, C_alpha, Ct],
        [sum_M, d_sum_M_d_alpha, d_M_gear_d_alpha, v, r],
        ["alpha", "F_disturbance", "m", "a", "b", "u", "rho", "Ap", "CL_gamma", "C_alpha", "Ct"],
        ["sum_M", "d_sum_M_d_alpha", "d_M_gear_d_alpha", "v", "r"],
    )


@cache
def bounds() -> ca.Function:
    """Bounds of the moment and its slope over angles: see `intervals.bounds`."""
    return intervals.bounds(linear_equilibrium(), 2, "linear_bounds")
