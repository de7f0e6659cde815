# Generated from derive/ (digest bfd9ab80ef38709d) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`.
"""Small angles and the linear tire (Section 4.5)."""

from functools import cache

import casadi as ca

from groundroll.generated import integrators


@cache
def rhs() -> ca.Function:
    """Time derivatives of the states.

    Inputs
    ------
    x : column of 7
        v [m/s], r [rad/s], y [m], theta [rad], X [m], Y [m], psi [rad]
    u : column of 1
        F_disturbance [N]
    p : column of 11
        m [kg], Izz [kg m^2], a [m], b [m], u [m/s], rho [kg/m^3], Ap [m^2], CL_gamma
        [1/rad], C_alpha [N/rad], Ct [N/rad], g [m/s^2]

    Outputs
    -------
    xdot : 7 x 1, time derivatives of x

    Thesis
    ------
    Eq. 4.24, Eq. 3.1, Eq. 4.28, Eq. 4.26, Eq. 4.29, Eq. 4.30, Eq. 4.8, Eq. 4.31
    """
    x_ = ca.SX.sym("x", 7)
    v, r, y, theta, X, Y, psi = ca.vertsplit(x_)
    u_ = ca.SX.sym("u", 1)
    F_disturbance, = ca.vertsplit(u_)
    p_ = ca.SX.sym("p", 11)
    m, Izz, a, b, u, rho, Ap, CL_gamma, C_alpha, Ct, g = ca.vertsplit(p_)
    alpha = (a*r + v)/u  # Eq. 4.24
    F_y = C_alpha*alpha  # Eq. 3.1
    F_main = 2*F_y  # Eq. 4.28
    gamma = (-b*r + v)/u  # Eq. 4.26
    F_tail = (1/2)*Ap*CL_gamma*gamma*rho*u**2  # Eq. 4.29
    F_tail_wheel = Ct*gamma  # Eq. 4.30
    sum_F = F_disturbance - F_main - F_tail - F_tail_wheel  # Eq. 4.8
    sum_M = -F_disturbance*b - F_main*a + F_tail*b + F_tail_wheel*b  # Eq. 4.8
    v_dot = -r*u + sum_F/m  # Eq. 4.31
    r_dot = sum_M/Izz  # Eq. 4.31
    xdot_ = ca.vertcat(v_dot, r_dot, v, r, u*ca.cos(psi) - v*ca.sin(psi), u*ca.sin(psi) + v*ca.cos(psi), r)
    return ca.Function(
        "linear_rhs",
        [x_, u_, p_],
        [xdot_],
        ["x", "u", "p"],
        ["xdot"],
    )


@cache
def outputs() -> ca.Function:
    """Angles, forces, accelerations and what is carried.

    Inputs
    ------
    x : column of 7
        v [m/s], r [rad/s], y [m], theta [rad], X [m], Y [m], psi [rad]
    u : column of 1
        F_disturbance [N]
    p : column of 11
        m [kg], Izz [kg m^2], a [m], b [m], u [m/s], rho [kg/m^3], Ap [m^2], CL_gamma
        [1/rad], C_alpha [N/rad], Ct [N/rad], g [m/s^2]

    Outputs
    -------
    y : 10 x 1, outputs alpha, gamma, beta, F_main, F_tail, F_tail_wheel, a_y, sum_F, sum_M, N_held

    Thesis
    ------
    Eq. 4.24, Eq. 3.1, Eq. 4.28, Eq. 4.26, Eq. 4.29, Eq. 4.30, Eq. 4.21, Eq. 4.8, Eq. 4.31,
    Eq. 4.7
    """
    x_ = ca.SX.sym("x", 7)
    v, r, y, theta, X, Y, psi = ca.vertsplit(x_)
    u_ = ca.SX.sym("u", 1)
    F_disturbance, = ca.vertsplit(u_)
    p_ = ca.SX.sym("p", 11)
    m, Izz, a, b, u, rho, Ap, CL_gamma, C_alpha, Ct, g = ca.vertsplit(p_)
    alpha = (a*r + v)/u  # Eq. 4.24
    F_y = C_alpha*alpha  # Eq. 3.1
    F_main = 2*F_y  # Eq. 4.28
    gamma = (-b*r + v)/u  # Eq. 4.26
    F_tail = (1/2)*Ap*CL_gamma*gamma*rho*u**2  # Eq. 4.29
    F_tail_wheel = Ct*gamma  # Eq. 4.30
    beta = v/u  # Eq. 4.21
    sum_F = F_disturbance - F_main - F_tail - F_tail_wheel  # Eq. 4.8
    sum_M = -F_disturbance*b - F_main*a + F_tail*b + F_tail_wheel*b  # Eq. 4.8
    v_dot = -r*u + sum_F/m  # Eq. 4.31
    a_y = r*u + v_dot  # Eq. 4.7
    N_held = g*m  # held balance
    y_ = ca.vertcat(alpha, gamma, beta, F_main, F_tail, F_tail_wheel, a_y, sum_F, sum_M, N_held)
    return ca.Function(
        "linear_outputs",
        [x_, u_, p_],
        [y_],
        ["x", "u", "p"],
        ["y"],
    )


@cache
def jacobians() -> ca.Function:
    """Jacobians of states and outputs.

    Inputs
    ------
    x : column of 7
        v [m/s], r [rad/s], y [m], theta [rad], X [m], Y [m], psi [rad]
    u : column of 1
        F_disturbance [N]
    p : column of 11
        m [kg], Izz [kg m^2], a [m], b [m], u [m/s], rho [kg/m^3], Ap [m^2], CL_gamma
        [1/rad], C_alpha [N/rad], Ct [N/rad], g [m/s^2]

    Outputs
    -------
    fx : 7 x 7, derivatives of xdot by x
    fu : 7 x 1, derivatives of xdot by u
    fp : 7 x 11, derivatives of xdot by p
    gx : 10 x 7, derivatives of y by x
    gu : 10 x 1, derivatives of y by u
    gp : 10 x 11, derivatives of y by p

    Thesis
    ------
    Eq. 4.24, Eq. 3.1, Eq. 4.28, Eq. 4.26, Eq. 4.29, Eq. 4.30, Eq. 4.8
    """
    x_ = ca.SX.sym("x", 7)
    v, r, y, theta, X, Y, psi = ca.vertsplit(x_)
    u_ = ca.SX.sym("u", 1)
    F_disturbance, = ca.vertsplit(u_)
    p_ = ca.SX.sym("p", 11)
    m, Izz, a, b, u, rho, Ap, CL_gamma, C_alpha, Ct, g = ca.vertsplit(p_)
    w2 = a*r + v
    alpha = w2/u  # Eq. 4.24
    F_y = C_alpha*alpha  # Eq. 3.1
    F_main = 2*F_y  # Eq. 4.28
    w3 = -b*r + v
    gamma = w3/u  # Eq. 4.26
    w4 = Ap*CL_gamma*gamma
    w7 = (1/2)*u**2
    F_tail = rho*w4*w7  # Eq. 4.29
    F_tail_wheel = Ct*gamma  # Eq. 4.30
    w8 = -F_disturbance + F_tail + F_tail_wheel
    sum_F = -F_main - w8  # Eq. 4.8
    sum_M = -F_disturbance*b - F_main*a + F_tail*b + F_tail_wheel*b  # Eq. 4.8
    d_alpha_d_v = 1/u  # chain rule on Eq. 4.24
    d_F_y_d_v = C_alpha*d_alpha_d_v  # chain rule on Eq. 3.1
    d_F_main_d_v = 2*d_F_y_d_v  # chain rule on Eq. 4.28
    d_gamma_d_v = 1/u  # chain rule on Eq. 4.26
    w9 = Ap*CL_gamma*rho*w7
    d_F_tail_d_v = d_gamma_d_v*w9  # chain rule on Eq. 4.29
    d_F_tail_wheel_d_v = Ct*d_gamma_d_v  # chain rule on Eq. 4.30
    d_beta_d_v = 1/u  # chain rule on Eq. 4.21
    d_sum_F_d_v = -d_F_main_d_v - d_F_tail_d_v - d_F_tail_wheel_d_v  # chain rule on Eq. 4.8
    d_sum_M_d_v = -a*d_F_main_d_v + b*d_F_tail_d_v + b*d_F_tail_wheel_d_v  # chain rule on Eq. 4.8
    d_v_dot_d_v = d_sum_F_d_v/m  # chain rule on Eq. 4.31
    d_r_dot_d_v = d_sum_M_d_v/Izz  # chain rule on Eq. 4.31
    d_a_y_d_v = d_v_dot_d_v  # chain rule on Eq. 4.7
    d_alpha_d_r = a/u  # chain rule on Eq. 4.24
    d_F_y_d_r = C_alpha*d_alpha_d_r  # chain rule on Eq. 3.1
    d_F_main_d_r = 2*d_F_y_d_r  # chain rule on Eq. 4.28
    d_gamma_d_r = -b/u  # chain rule on Eq. 4.26
    d_F_tail_d_r = d_gamma_d_r*w9  # chain rule on Eq. 4.29
    d_F_tail_wheel_d_r = Ct*d_gamma_d_r  # chain rule on Eq. 4.30
    d_sum_F_d_r = -d_F_main_d_r - d_F_tail_d_r - d_F_tail_wheel_d_r  # chain rule on Eq. 4.8
    d_sum_M_d_r = -a*d_F_main_d_r + b*d_F_tail_d_r + b*d_F_tail_wheel_d_r  # chain rule on Eq. 4.8
    d_v_dot_d_r = d_sum_F_d_r/m - u  # chain rule on Eq. 4.31
    d_r_dot_d_r = d_sum_M_d_r/Izz  # chain rule on Eq. 4.31
    d_a_y_d_r = d_v_dot_d_r + u  # chain rule on Eq. 4.7
    d_sum_F_d_F_disturbance = 1  # chain rule on Eq. 4.8
    d_sum_M_d_F_disturbance = -b  # chain rule on Eq. 4.8
    d_v_dot_d_F_disturbance = d_sum_F_d_F_disturbance/m  # chain rule on Eq. 4.31
    d_r_dot_d_F_disturbance = d_sum_M_d_F_disturbance/Izz  # chain rule on Eq. 4.31
    d_a_y_d_F_disturbance = d_v_dot_d_F_disturbance  # chain rule on Eq. 4.7
    d_v_dot_d_m = -sum_F/m**2  # chain rule on Eq. 4.31
    d_a_y_d_m = d_v_dot_d_m  # chain rule on Eq. 4.7
    d_N_held_d_m = g  # chain rule on held balance
    d_r_dot_d_Izz = -sum_M/Izz**2  # chain rule on Eq. 4.31
    d_alpha_d_a = r/u  # chain rule on Eq. 4.24
    d_F_y_d_a = C_alpha*d_alpha_d_a  # chain rule on Eq. 3.1
    d_F_main_d_a = 2*d_F_y_d_a  # chain rule on Eq. 4.28
    d_sum_F_d_a = -d_F_main_d_a  # chain rule on Eq. 4.8
    d_sum_M_d_a = -F_main - a*d_F_main_d_a  # chain rule on Eq. 4.8
    d_v_dot_d_a = d_sum_F_d_a/m  # chain rule on Eq. 4.31
    d_r_dot_d_a = d_sum_M_d_a/Izz  # chain rule on Eq. 4.31
    d_a_y_d_a = d_v_dot_d_a  # chain rule on Eq. 4.7
    d_gamma_d_b = -r/u  # chain rule on Eq. 4.26
    d_F_tail_d_b = d_gamma_d_b*w9  # chain rule on Eq. 4.29
    d_F_tail_wheel_d_b = Ct*d_gamma_d_b  # chain rule on Eq. 4.30
    d_sum_F_d_b = -d_F_tail_d_b - d_F_tail_wheel_d_b  # chain rule on Eq. 4.8
    d_sum_M_d_b = b*d_F_tail_d_b + b*d_F_tail_wheel_d_b + w8  # chain rule on Eq. 4.8
    d_v_dot_d_b = d_sum_F_d_b/m  # chain rule on Eq. 4.31
    d_r_dot_d_b = d_sum_M_d_b/Izz  # chain rule on Eq. 4.31
    d_a_y_d_b = d_v_dot_d_b  # chain rule on Eq. 4.7
    w13 = 1/u**2
    d_alpha_d_u = -w13*w2  # chain rule on Eq. 4.24
    d_F_y_d_u = C_alpha*d_alpha_d_u  # chain rule on Eq. 3.1
    d_F_main_d_u = 2*d_F_y_d_u  # chain rule on Eq. 4.28
    d_gamma_d_u = -w13*w3  # chain rule on Eq. 4.26
    d_F_tail_d_u = d_gamma_d_u*w9 + rho*u*w4  # chain rule on Eq. 4.29
    d_F_tail_wheel_d_u = Ct*d_gamma_d_u  # chain rule on Eq. 4.30
    d_beta_d_u = -v*w13  # chain rule on Eq. 4.21
    d_sum_F_d_u = -d_F_main_d_u - d_F_tail_d_u - d_F_tail_wheel_d_u  # chain rule on Eq. 4.8
    d_sum_M_d_u = -a*d_F_main_d_u + b*d_F_tail_d_u + b*d_F_tail_wheel_d_u  # chain rule on Eq. 4.8
    d_v_dot_d_u = d_sum_F_d_u/m - r  # chain rule on Eq. 4.31
    d_r_dot_d_u = d_sum_M_d_u/Izz  # chain rule on Eq. 4.31
    d_a_y_d_u = d_v_dot_d_u + r  # chain rule on Eq. 4.7
    d_F_tail_d_rho = w4*w7  # chain rule on Eq. 4.29
    d_sum_F_d_rho = -d_F_tail_d_rho  # chain rule on Eq. 4.8
    d_sum_M_d_rho = b*d_F_tail_d_rho  # chain rule on Eq. 4.8
    d_v_dot_d_rho = d_sum_F_d_rho/m  # chain rule on Eq. 4.31
    d_r_dot_d_rho = d_sum_M_d_rho/Izz  # chain rule on Eq. 4.31
    d_a_y_d_rho = d_v_dot_d_rho  # chain rule on Eq. 4.7
    w14 = gamma*rho*w7
    d_F_tail_d_Ap = CL_gamma*w14  # chain rule on Eq. 4.29
    d_sum_F_d_Ap = -d_F_tail_d_Ap  # chain rule on Eq. 4.8
    d_sum_M_d_Ap = b*d_F_tail_d_Ap  # chain rule on Eq. 4.8
    d_v_dot_d_Ap = d_sum_F_d_Ap/m  # chain rule on Eq. 4.31
    d_r_dot_d_Ap = d_sum_M_d_Ap/Izz  # chain rule on Eq. 4.31
    d_a_y_d_Ap = d_v_dot_d_Ap  # chain rule on Eq. 4.7
    d_F_tail_d_CL_gamma = Ap*w14  # chain rule on Eq. 4.29
    d_sum_F_d_CL_gamma = -d_F_tail_d_CL_gamma  # chain rule on Eq. 4.8
    d_sum_M_d_CL_gamma = b*d_F_tail_d_CL_gamma  # chain rule on Eq. 4.8
    d_v_dot_d_CL_gamma = d_sum_F_d_CL_gamma/m  # chain rule on Eq. 4.31
    d_r_dot_d_CL_gamma = d_sum_M_d_CL_gamma/Izz  # chain rule on Eq. 4.31
    d_a_y_d_CL_gamma = d_v_dot_d_CL_gamma  # chain rule on Eq. 4.7
    d_F_y_d_C_alpha = alpha  # chain rule on Eq. 3.1
    d_F_main_d_C_alpha = 2*d_F_y_d_C_alpha  # chain rule on Eq. 4.28
    d_sum_F_d_C_alpha = -d_F_main_d_C_alpha  # chain rule on Eq. 4.8
    d_sum_M_d_C_alpha = -a*d_F_main_d_C_alpha  # chain rule on Eq. 4.8
    d_v_dot_d_C_alpha = d_sum_F_d_C_alpha/m  # chain rule on Eq. 4.31
    d_r_dot_d_C_alpha = d_sum_M_d_C_alpha/Izz  # chain rule on Eq. 4.31
    d_a_y_d_C_alpha = d_v_dot_d_C_alpha  # chain rule on Eq. 4.7
    d_F_tail_wheel_d_Ct = gamma  # chain rule on Eq. 4.30
    d_sum_F_d_Ct = -d_F_tail_wheel_d_Ct  # chain rule on Eq. 4.8
    d_sum_M_d_Ct = b*d_F_tail_wheel_d_Ct  # chain rule on Eq. 4.8
    d_v_dot_d_Ct = d_sum_F_d_Ct/m  # chain rule on Eq. 4.31
    d_r_dot_d_Ct = d_sum_M_d_Ct/Izz  # chain rule on Eq. 4.31
    d_a_y_d_Ct = d_v_dot_d_Ct  # chain rule on Eq. 4.7
    d_N_held_d_g = m  # chain rule on held balance
    fx_ = ca.blockcat([
        [d_v_dot_d_v, d_v_dot_d_r, 0, 0, 0, 0, 0],
        [d_r_dot_d_v, d_r_dot_d_r, 0, 0, 0, 0, 0],
        [1, 0, 0, 0, 0, 0, 0],
        [0, 1, 0, 0, 0, 0, 0],
        [-ca.sin(psi), 0, 0, 0, 0, 0, -u*ca.sin(psi) - v*ca.cos(psi)],
        [ca.cos(psi), 0, 0, 0, 0, 0, u*ca.cos(psi) - v*ca.sin(psi)],
        [0, 1, 0, 0, 0, 0, 0],
    ])
    fu_ = ca.vertcat(d_v_dot_d_F_disturbance, d_r_dot_d_F_disturbance, 0, 0, 0, 0, 0)
    fp_ = ca.blockcat([
        [d_v_dot_d_m, 0, d_v_dot_d_a, d_v_dot_d_b, d_v_dot_d_u, d_v_dot_d_rho, d_v_dot_d_Ap, d_v_dot_d_CL_gamma, d_v_dot_d_C_alpha, d_v_dot_d_Ct, 0],
        [0, d_r_dot_d_Izz, d_r_dot_d_a, d_r_dot_d_b, d_r_dot_d_u, d_r_dot_d_rho, d_r_dot_d_Ap, d_r_dot_d_CL_gamma, d_r_dot_d_C_alpha, d_r_dot_d_Ct, 0],
        [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
        [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
        [0, 0, 0, 0, ca.cos(psi), 0, 0, 0, 0, 0, 0],
        [0, 0, 0, 0, ca.sin(psi), 0, 0, 0, 0, 0, 0],
        [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
    ])
    gx_ = ca.blockcat([
        [d_alpha_d_v, d_alpha_d_r, 0, 0, 0, 0, 0],
        [d_gamma_d_v, d_gamma_d_r, 0, 0, 0, 0, 0],
        [d_beta_d_v, 0, 0, 0, 0, 0, 0],
        [d_F_main_d_v, d_F_main_d_r, 0, 0, 0, 0, 0],
        [d_F_tail_d_v, d_F_tail_d_r, 0, 0, 0, 0, 0],
        [d_F_tail_wheel_d_v, d_F_tail_wheel_d_r, 0, 0, 0, 0, 0],
        [d_a_y_d_v, d_a_y_d_r, 0, 0, 0, 0, 0],
        [d_sum_F_d_v, d_sum_F_d_r, 0, 0, 0, 0, 0],
        [d_sum_M_d_v, d_sum_M_d_r, 0, 0, 0, 0, 0],
        [0, 0, 0, 0, 0, 0, 0],
    ])
    gu_ = ca.vertcat(0, 0, 0, 0, 0, 0, d_a_y_d_F_disturbance, d_sum_F_d_F_disturbance, d_sum_M_d_F_disturbance, 0)
    gp_ = ca.blockcat([
        [0, 0, d_alpha_d_a, 0, d_alpha_d_u, 0, 0, 0, 0, 0, 0],
        [0, 0, 0, d_gamma_d_b, d_gamma_d_u, 0, 0, 0, 0, 0, 0],
        [0, 0, 0, 0, d_beta_d_u, 0, 0, 0, 0, 0, 0],
        [0, 0, d_F_main_d_a, 0, d_F_main_d_u, 0, 0, 0, d_F_main_d_C_alpha, 0, 0],
        [0, 0, 0, d_F_tail_d_b, d_F_tail_d_u, d_F_tail_d_rho, d_F_tail_d_Ap, d_F_tail_d_CL_gamma, 0, 0, 0],
        [0, 0, 0, d_F_tail_wheel_d_b, d_F_tail_wheel_d_u, 0, 0, 0, 0, d_F_tail_wheel_d_Ct, 0],
        [d_a_y_d_m, 0, d_a_y_d_a, d_a_y_d_b, d_a_y_d_u, d_a_y_d_rho, d_a_y_d_Ap, d_a_y_d_CL_gamma, d_a_y_d_C_alpha, d_a_y_d_Ct, 0],
        [0, 0, d_sum_F_d_a, d_sum_F_d_b, d_sum_F_d_u, d_sum_F_d_rho, d_sum_F_d_Ap, d_sum_F_d_CL_gamma, d_sum_F_d_C_alpha, d_sum_F_d_Ct, 0],
        [0, 0, d_sum_M_d_a, d_sum_M_d_b, d_sum_M_d_u, d_sum_M_d_rho, d_sum_M_d_Ap, d_sum_M_d_CL_gamma, d_sum_M_d_C_alpha, d_sum_M_d_Ct, 0],
        [d_N_held_d_m, 0, 0, 0, 0, 0, 0, 0, 0, 0, d_N_held_d_g],
    ])
    return ca.Function(
        "linear_jacobians",
        [x_, u_, p_],
        [fx_, fu_, fp_, gx_, gu_, gp_],
        ["x", "u", "p"],
        ["fx", "fu", "fp", "gx", "gu", "gp"],
    )


@cache
def places() -> ca.Function:
    """Places and forces of the parts: main_gear, vertical_tail, tail_wheel, disturbance.

    Inputs
    ------
    x : column of 7
        v [m/s], r [rad/s], y [m], theta [rad], X [m], Y [m], psi [rad]
    u : column of 1
        F_disturbance [N]
    p : column of 11
        m [kg], Izz [kg m^2], a [m], b [m], u [m/s], rho [kg/m^3], Ap [m^2], CL_gamma
        [1/rad], C_alpha [N/rad], Ct [N/rad], g [m/s^2]

    Outputs
    -------
    place : 4 x 3, where each part acts, from the CG along body x, y, z [m]
    force : 4 x 3, with what force along body x, y, z [N]

    Thesis
    ------
    Eq. 4.24, Eq. 3.1, Eq. 4.28, Eq. 4.26, Eq. 4.29, Eq. 4.30
    """
    x_ = ca.SX.sym("x", 7)
    v, r, y, theta, X, Y, psi = ca.vertsplit(x_)
    u_ = ca.SX.sym("u", 1)
    F_disturbance, = ca.vertsplit(u_)
    p_ = ca.SX.sym("p", 11)
    m, Izz, a, b, u, rho, Ap, CL_gamma, C_alpha, Ct, g = ca.vertsplit(p_)
    alpha = (a*r + v)/u  # Eq. 4.24
    F_y = C_alpha*alpha  # Eq. 3.1
    F_main = 2*F_y  # Eq. 4.28
    gamma = (-b*r + v)/u  # Eq. 4.26
    F_tail = (1/2)*Ap*CL_gamma*gamma*rho*u**2  # Eq. 4.29
    F_tail_wheel = Ct*gamma  # Eq. 4.30
    place_ = ca.blockcat([
        [a, 0, 0],
        [-b, 0, 0],
        [-b, 0, 0],
        [-b, 0, 0],
    ])
    force_ = ca.blockcat([
        [0, -F_main, 0],
        [0, -F_tail, 0],
        [0, -F_tail_wheel, 0],
        [0, F_disturbance, 0],
    ])
    return ca.Function(
        "linear_places",
        [x_, u_, p_],
        [place_, force_],
        ["x", "u", "p"],
        ["place", "force"],
    )


@cache
def rk4() -> ca.Function:
    """Integrate the model over an interval: see `integrators.interval`."""
    return integrators.interval(rhs(), "linear_rk4", "rk4")


@cache
def rk45() -> ca.Function:
    """Integrate the model over an interval: see `integrators.interval`."""
    return integrators.interval(rhs(), "linear_rk45", "rk45")
