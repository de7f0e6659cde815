# Generated from derive/ (digest 0b025fe68865f259) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`.
"""Exact angles and the non-linear tire (Section 4.6)."""

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
    p : column of 19
        m [kg], Izz [kg m^2], a [m], b [m], u [m/s], rho [kg/m^3], Ap [m^2], CL_gamma
        [1/rad], Ct [N/rad], Fz [N], B3 [1/rad], C3 [1/(rad N)], B5 [1], C5 [1/N], B1 [1],
        C1 [1], D1 [1], E1 [1], g [m/s^2]

    Outputs
    -------
    xdot : 7 x 1, time derivatives of x

    Thesis
    ------
    Eq. 3.3, Eq. 3.5, Eq. 3.6, Eq. 3.10, Eq. 3.9, Eq. 3.8, Eq. 3.11, Eq. 4.38, Eq. 4.19, Eq.
    4.29, Eq. 4.30, Eq. 4.8, Eq. 4.9
    """
    x_ = ca.SX.sym("x", 7)
    v, r, y, theta, X, Y, psi = ca.vertsplit(x_)
    u_ = ca.SX.sym("u", 1)
    F_disturbance, = ca.vertsplit(u_)
    p_ = ca.SX.sym("p", 19)
    m, Izz, a, b, u, rho, Ap, CL_gamma, Ct, Fz, B3, C3, B5, C5, B1, C1, D1, E1, g = ca.vertsplit(p_)
    C_c = B3 + C3*Fz  # Eq. 3.3
    mu = B5 + C5*Fz  # Eq. 3.5
    alpha_bar = C_c*(a*r + v)/(mu*u)  # Eq. 3.6
    psi_bar = alpha_bar*(1 - E1) + E1*ca.atan(B1*alpha_bar)/B1  # Eq. 3.10
    theta_bar = C1*ca.atan(B1*psi_bar)  # Eq. 3.9
    F_bar = D1*ca.sin(theta_bar)  # Eq. 3.8
    F_y = F_bar*Fz*mu  # Eq. 3.11
    F_main = 2*F_y  # Eq. 4.38
    gamma = ca.atan((-b*r + v)/u)  # Eq. 4.19
    F_tail = (1/2)*Ap*CL_gamma*gamma*rho*u**2  # Eq. 4.29
    F_tail_wheel = Ct*gamma  # Eq. 4.30
    sum_F = F_disturbance - F_main - F_tail - F_tail_wheel  # Eq. 4.8
    sum_M = -F_disturbance*b - F_main*a + F_tail*b + F_tail_wheel*b  # Eq. 4.8
    v_dot = -r*u + sum_F/m  # Eq. 4.9
    r_dot = sum_M/Izz  # Eq. 4.9
    xdot_ = ca.vertcat(v_dot, r_dot, v, r, u*ca.cos(psi) - v*ca.sin(psi), u*ca.sin(psi) + v*ca.cos(psi), r)
    return ca.Function(
        "nonlinear_rhs",
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
    p : column of 19
        m [kg], Izz [kg m^2], a [m], b [m], u [m/s], rho [kg/m^3], Ap [m^2], CL_gamma
        [1/rad], Ct [N/rad], Fz [N], B3 [1/rad], C3 [1/(rad N)], B5 [1], C5 [1/N], B1 [1],
        C1 [1], D1 [1], E1 [1], g [m/s^2]

    Outputs
    -------
    y : 11 x 1, outputs alpha, gamma, beta, F_main, F_tail, F_tail_wheel, a_y, sum_F, sum_M, F_held, N_held

    Thesis
    ------
    Eq. 4.14, Eq. 3.3, Eq. 3.5, Eq. 3.6, Eq. 3.10, Eq. 3.9, Eq. 3.8, Eq. 3.11, Eq. 4.38, Eq.
    4.19, Eq. 4.29, Eq. 4.30, Eq. 4.20, Eq. 4.8, Eq. 4.9, Eq. 4.7
    """
    x_ = ca.SX.sym("x", 7)
    v, r, y, theta, X, Y, psi = ca.vertsplit(x_)
    u_ = ca.SX.sym("u", 1)
    F_disturbance, = ca.vertsplit(u_)
    p_ = ca.SX.sym("p", 19)
    m, Izz, a, b, u, rho, Ap, CL_gamma, Ct, Fz, B3, C3, B5, C5, B1, C1, D1, E1, g = ca.vertsplit(p_)
    w2 = (a*r + v)/u
    alpha = ca.atan(w2)  # Eq. 4.14
    C_c = B3 + C3*Fz  # Eq. 3.3
    mu = B5 + C5*Fz  # Eq. 3.5
    alpha_bar = C_c*w2/mu  # Eq. 3.6
    psi_bar = alpha_bar*(1 - E1) + E1*ca.atan(B1*alpha_bar)/B1  # Eq. 3.10
    theta_bar = C1*ca.atan(B1*psi_bar)  # Eq. 3.9
    F_bar = D1*ca.sin(theta_bar)  # Eq. 3.8
    F_y = F_bar*Fz*mu  # Eq. 3.11
    F_main = 2*F_y  # Eq. 4.38
    gamma = ca.atan((-b*r + v)/u)  # Eq. 4.19
    F_tail = (1/2)*Ap*CL_gamma*gamma*rho*u**2  # Eq. 4.29
    F_tail_wheel = Ct*gamma  # Eq. 4.30
    beta = ca.atan(v/u)  # Eq. 4.20
    sum_F = F_disturbance - F_main - F_tail - F_tail_wheel  # Eq. 4.8
    sum_M = -F_disturbance*b - F_main*a + F_tail*b + F_tail_wheel*b  # Eq. 4.8
    v_dot = -r*u + sum_F/m  # Eq. 4.9
    a_y = r*u + v_dot  # Eq. 4.7
    F_held = -m*r*v  # held balance
    N_held = g*m  # held balance
    y_ = ca.vertcat(alpha, gamma, beta, F_main, F_tail, F_tail_wheel, a_y, sum_F, sum_M, F_held, N_held)
    return ca.Function(
        "nonlinear_outputs",
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
    p : column of 19
        m [kg], Izz [kg m^2], a [m], b [m], u [m/s], rho [kg/m^3], Ap [m^2], CL_gamma
        [1/rad], Ct [N/rad], Fz [N], B3 [1/rad], C3 [1/(rad N)], B5 [1], C5 [1/N], B1 [1],
        C1 [1], D1 [1], E1 [1], g [m/s^2]

    Outputs
    -------
    fx : 7 x 7, derivatives of xdot by x
    fu : 7 x 1, derivatives of xdot by u
    fp : 7 x 19, derivatives of xdot by p
    gx : 11 x 7, derivatives of y by x
    gu : 11 x 1, derivatives of y by u
    gp : 11 x 19, derivatives of y by p

    Thesis
    ------
    Eq. 3.3, Eq. 3.5, Eq. 3.6, Eq. 3.10, Eq. 3.9, Eq. 3.8, Eq. 3.11, Eq. 4.38, Eq. 4.19, Eq.
    4.29, Eq. 4.30, Eq. 4.8
    """
    x_ = ca.SX.sym("x", 7)
    v, r, y, theta, X, Y, psi = ca.vertsplit(x_)
    u_ = ca.SX.sym("u", 1)
    F_disturbance, = ca.vertsplit(u_)
    p_ = ca.SX.sym("p", 19)
    m, Izz, a, b, u, rho, Ap, CL_gamma, Ct, Fz, B3, C3, B5, C5, B1, C1, D1, E1, g = ca.vertsplit(p_)
    C_c = B3 + C3*Fz  # Eq. 3.3
    mu = B5 + C5*Fz  # Eq. 3.5
    w1 = a*r + v
    w5 = C_c/(mu*u)
    alpha_bar = w1*w5  # Eq. 3.6
    w7 = ca.atan(B1*alpha_bar)
    psi_bar = alpha_bar*(1 - E1) + E1*w7/B1  # Eq. 3.10
    w8 = ca.atan(B1*psi_bar)
    theta_bar = C1*w8  # Eq. 3.9
    F_bar = D1*ca.sin(theta_bar)  # Eq. 3.8
    F_y = F_bar*Fz*mu  # Eq. 3.11
    F_main = 2*F_y  # Eq. 4.38
    w11 = -b*r + v
    gamma = ca.atan(w11/u)  # Eq. 4.19
    w12 = Ap*CL_gamma*gamma
    w15 = (1/2)*u**2
    F_tail = rho*w12*w15  # Eq. 4.29
    F_tail_wheel = Ct*gamma  # Eq. 4.30
    w16 = -F_disturbance + F_tail + F_tail_wheel
    sum_F = -F_main - w16  # Eq. 4.8
    sum_M = -F_disturbance*b - F_main*a + F_tail*b + F_tail_wheel*b  # Eq. 4.8
    w17 = 1/u**2
    w18 = 1/(w1**2*w17 + 1)
    d_alpha_d_v = w18/u  # chain rule on Eq. 4.14
    d_alpha_bar_d_v = w5  # chain rule on Eq. 3.6
    w21 = E1/(B1**2*alpha_bar**2 + 1)
    w22 = -E1 + w21 + 1
    d_psi_bar_d_v = d_alpha_bar_d_v*w22  # chain rule on Eq. 3.10
    w23 = C1/(B1**2*psi_bar**2 + 1)
    d_theta_bar_d_v = B1*d_psi_bar_d_v*w23  # chain rule on Eq. 3.9
    w25 = D1*ca.cos(theta_bar)
    d_F_bar_d_v = d_theta_bar_d_v*w25  # chain rule on Eq. 3.8
    d_F_y_d_v = Fz*d_F_bar_d_v*mu  # chain rule on Eq. 3.11
    d_F_main_d_v = 2*d_F_y_d_v  # chain rule on Eq. 4.38
    w27 = 1/(w11**2*w17 + 1)
    d_gamma_d_v = w27/u  # chain rule on Eq. 4.19
    w29 = Ap*CL_gamma*rho*w15
    d_F_tail_d_v = d_gamma_d_v*w29  # chain rule on Eq. 4.29
    d_F_tail_wheel_d_v = Ct*d_gamma_d_v  # chain rule on Eq. 4.30
    w30 = 1/(v**2*w17 + 1)
    d_beta_d_v = w30/u  # chain rule on Eq. 4.20
    d_sum_F_d_v = -d_F_main_d_v - d_F_tail_d_v - d_F_tail_wheel_d_v  # chain rule on Eq. 4.8
    d_sum_M_d_v = -a*d_F_main_d_v + b*d_F_tail_d_v + b*d_F_tail_wheel_d_v  # chain rule on Eq. 4.8
    d_v_dot_d_v = d_sum_F_d_v/m  # chain rule on Eq. 4.9
    d_r_dot_d_v = d_sum_M_d_v/Izz  # chain rule on Eq. 4.9
    d_a_y_d_v = d_v_dot_d_v  # chain rule on Eq. 4.7
    d_F_held_d_v = -m*r  # chain rule on held balance
    d_alpha_d_r = a*w18/u  # chain rule on Eq. 4.14
    d_alpha_bar_d_r = a*w5  # chain rule on Eq. 3.6
    d_psi_bar_d_r = d_alpha_bar_d_r*w22  # chain rule on Eq. 3.10
    d_theta_bar_d_r = B1*d_psi_bar_d_r*w23  # chain rule on Eq. 3.9
    d_F_bar_d_r = d_theta_bar_d_r*w25  # chain rule on Eq. 3.8
    d_F_y_d_r = Fz*d_F_bar_d_r*mu  # chain rule on Eq. 3.11
    d_F_main_d_r = 2*d_F_y_d_r  # chain rule on Eq. 4.38
    d_gamma_d_r = -b*w27/u  # chain rule on Eq. 4.19
    d_F_tail_d_r = d_gamma_d_r*w29  # chain rule on Eq. 4.29
    d_F_tail_wheel_d_r = Ct*d_gamma_d_r  # chain rule on Eq. 4.30
    d_sum_F_d_r = -d_F_main_d_r - d_F_tail_d_r - d_F_tail_wheel_d_r  # chain rule on Eq. 4.8
    d_sum_M_d_r = -a*d_F_main_d_r + b*d_F_tail_d_r + b*d_F_tail_wheel_d_r  # chain rule on Eq. 4.8
    d_v_dot_d_r = d_sum_F_d_r/m - u  # chain rule on Eq. 4.9
    d_r_dot_d_r = d_sum_M_d_r/Izz  # chain rule on Eq. 4.9
    d_a_y_d_r = d_v_dot_d_r + u  # chain rule on Eq. 4.7
    d_F_held_d_r = -m*v  # chain rule on held balance
    d_sum_F_d_F_disturbance = 1  # chain rule on Eq. 4.8
    d_sum_M_d_F_disturbance = -b  # chain rule on Eq. 4.8
    d_v_dot_d_F_disturbance = d_sum_F_d_F_disturbance/m  # chain rule on Eq. 4.9
    d_r_dot_d_F_disturbance = d_sum_M_d_F_disturbance/Izz  # chain rule on Eq. 4.9
    d_a_y_d_F_disturbance = d_v_dot_d_F_disturbance  # chain rule on Eq. 4.7
    d_v_dot_d_m = -sum_F/m**2  # chain rule on Eq. 4.9
    d_a_y_d_m = d_v_dot_d_m  # chain rule on Eq. 4.7
    d_F_held_d_m = -r*v  # chain rule on held balance
    d_N_held_d_m = g  # chain rule on held balance
    d_r_dot_d_Izz = -sum_M/Izz**2  # chain rule on Eq. 4.9
    d_alpha_d_a = r*w18/u  # chain rule on Eq. 4.14
    d_alpha_bar_d_a = r*w5  # chain rule on Eq. 3.6
    d_psi_bar_d_a = d_alpha_bar_d_a*w22  # chain rule on Eq. 3.10
    d_theta_bar_d_a = B1*d_psi_bar_d_a*w23  # chain rule on Eq. 3.9
    d_F_bar_d_a = d_theta_bar_d_a*w25  # chain rule on Eq. 3.8
    d_F_y_d_a = Fz*d_F_bar_d_a*mu  # chain rule on Eq. 3.11
    d_F_main_d_a = 2*d_F_y_d_a  # chain rule on Eq. 4.38
    d_sum_F_d_a = -d_F_main_d_a  # chain rule on Eq. 4.8
    d_sum_M_d_a = -F_main - a*d_F_main_d_a  # chain rule on Eq. 4.8
    d_v_dot_d_a = d_sum_F_d_a/m  # chain rule on Eq. 4.9
    d_r_dot_d_a = d_sum_M_d_a/Izz  # chain rule on Eq. 4.9
    d_a_y_d_a = d_v_dot_d_a  # chain rule on Eq. 4.7
    d_gamma_d_b = -r*w27/u  # chain rule on Eq. 4.19
    d_F_tail_d_b = d_gamma_d_b*w29  # chain rule on Eq. 4.29
    d_F_tail_wheel_d_b = Ct*d_gamma_d_b  # chain rule on Eq. 4.30
    d_sum_F_d_b = -d_F_tail_d_b - d_F_tail_wheel_d_b  # chain rule on Eq. 4.8
    d_sum_M_d_b = b*d_F_tail_d_b + b*d_F_tail_wheel_d_b + w16  # chain rule on Eq. 4.8
    d_v_dot_d_b = d_sum_F_d_b/m  # chain rule on Eq. 4.9
    d_r_dot_d_b = d_sum_M_d_b/Izz  # chain rule on Eq. 4.9
    d_a_y_d_b = d_v_dot_d_b  # chain rule on Eq. 4.7
    d_alpha_d_u = -w1*w17*w18  # chain rule on Eq. 4.14
    d_alpha_bar_d_u = -C_c*w1*w17/mu  # chain rule on Eq. 3.6
    d_psi_bar_d_u = d_alpha_bar_d_u*w22  # chain rule on Eq. 3.10
    d_theta_bar_d_u = B1*d_psi_bar_d_u*w23  # chain rule on Eq. 3.9
    d_F_bar_d_u = d_theta_bar_d_u*w25  # chain rule on Eq. 3.8
    d_F_y_d_u = Fz*d_F_bar_d_u*mu  # chain rule on Eq. 3.11
    d_F_main_d_u = 2*d_F_y_d_u  # chain rule on Eq. 4.38
    d_gamma_d_u = -w11*w17*w27  # chain rule on Eq. 4.19
    d_F_tail_d_u = d_gamma_d_u*w29 + rho*u*w12  # chain rule on Eq. 4.29
    d_F_tail_wheel_d_u = Ct*d_gamma_d_u  # chain rule on Eq. 4.30
    d_beta_d_u = -v*w17*w30  # chain rule on Eq. 4.20
    d_sum_F_d_u = -d_F_main_d_u - d_F_tail_d_u - d_F_tail_wheel_d_u  # chain rule on Eq. 4.8
    d_sum_M_d_u = -a*d_F_main_d_u + b*d_F_tail_d_u + b*d_F_tail_wheel_d_u  # chain rule on Eq. 4.8
    d_v_dot_d_u = d_sum_F_d_u/m - r  # chain rule on Eq. 4.9
    d_r_dot_d_u = d_sum_M_d_u/Izz  # chain rule on Eq. 4.9
    d_a_y_d_u = d_v_dot_d_u + r  # chain rule on Eq. 4.7
    d_F_tail_d_rho = w12*w15  # chain rule on Eq. 4.29
    d_sum_F_d_rho = -d_F_tail_d_rho  # chain rule on Eq. 4.8
    d_sum_M_d_rho = b*d_F_tail_d_rho  # chain rule on Eq. 4.8
    d_v_dot_d_rho = d_sum_F_d_rho/m  # chain rule on Eq. 4.9
    d_r_dot_d_rho = d_sum_M_d_rho/Izz  # chain rule on Eq. 4.9
    d_a_y_d_rho = d_v_dot_d_rho  # chain rule on Eq. 4.7
    w34 = gamma*rho*w15
    d_F_tail_d_Ap = CL_gamma*w34  # chain rule on Eq. 4.29
    d_sum_F_d_Ap = -d_F_tail_d_Ap  # chain rule on Eq. 4.8
    d_sum_M_d_Ap = b*d_F_tail_d_Ap  # chain rule on Eq. 4.8
    d_v_dot_d_Ap = d_sum_F_d_Ap/m  # chain rule on Eq. 4.9
    d_r_dot_d_Ap = d_sum_M_d_Ap/Izz  # chain rule on Eq. 4.9
    d_a_y_d_Ap = d_v_dot_d_Ap  # chain rule on Eq. 4.7
    d_F_tail_d_CL_gamma = Ap*w34  # chain rule on Eq. 4.29
    d_sum_F_d_CL_gamma = -d_F_tail_d_CL_gamma  # chain rule on Eq. 4.8
    d_sum_M_d_CL_gamma = b*d_F_tail_d_CL_gamma  # chain rule on Eq. 4.8
    d_v_dot_d_CL_gamma = d_sum_F_d_CL_gamma/m  # chain rule on Eq. 4.9
    d_r_dot_d_CL_gamma = d_sum_M_d_CL_gamma/Izz  # chain rule on Eq. 4.9
    d_a_y_d_CL_gamma = d_v_dot_d_CL_gamma  # chain rule on Eq. 4.7
    d_F_tail_wheel_d_Ct = gamma  # chain rule on Eq. 4.30
    d_sum_F_d_Ct = -d_F_tail_wheel_d_Ct  # chain rule on Eq. 4.8
    d_sum_M_d_Ct = b*d_F_tail_wheel_d_Ct  # chain rule on Eq. 4.8
    d_v_dot_d_Ct = d_sum_F_d_Ct/m  # chain rule on Eq. 4.9
    d_r_dot_d_Ct = d_sum_M_d_Ct/Izz  # chain rule on Eq. 4.9
    d_a_y_d_Ct = d_v_dot_d_Ct  # chain rule on Eq. 4.7
    d_C_c_d_Fz = C3  # chain rule on Eq. 3.3
    d_mu_d_Fz = C5  # chain rule on Eq. 3.5
    w36 = C_c*w1/(mu**2*u)
    d_alpha_bar_d_Fz = d_C_c_d_Fz*w1/(mu*u) - d_mu_d_Fz*w36  # chain rule on Eq. 3.6
    d_psi_bar_d_Fz = d_alpha_bar_d_Fz*w22  # chain rule on Eq. 3.10
    d_theta_bar_d_Fz = B1*d_psi_bar_d_Fz*w23  # chain rule on Eq. 3.9
    d_F_bar_d_Fz = d_theta_bar_d_Fz*w25  # chain rule on Eq. 3.8
    d_F_y_d_Fz = F_bar*Fz*d_mu_d_Fz + F_bar*mu + Fz*d_F_bar_d_Fz*mu  # chain rule on Eq. 3.11
    d_F_main_d_Fz = 2*d_F_y_d_Fz  # chain rule on Eq. 4.38
    d_sum_F_d_Fz = -d_F_main_d_Fz  # chain rule on Eq. 4.8
    d_sum_M_d_Fz = -a*d_F_main_d_Fz  # chain rule on Eq. 4.8
    d_v_dot_d_Fz = d_sum_F_d_Fz/m  # chain rule on Eq. 4.9
    d_r_dot_d_Fz = d_sum_M_d_Fz/Izz  # chain rule on Eq. 4.9
    d_a_y_d_Fz = d_v_dot_d_Fz  # chain rule on Eq. 4.7
    d_C_c_d_B3 = 1  # chain rule on Eq. 3.3
    w38 = w1/(mu*u)
    d_alpha_bar_d_B3 = d_C_c_d_B3*w38  # chain rule on Eq. 3.6
    d_psi_bar_d_B3 = d_alpha_bar_d_B3*w22  # chain rule on Eq. 3.10
    d_theta_bar_d_B3 = B1*d_psi_bar_d_B3*w23  # chain rule on Eq. 3.9
    d_F_bar_d_B3 = d_theta_bar_d_B3*w25  # chain rule on Eq. 3.8
    d_F_y_d_B3 = Fz*d_F_bar_d_B3*mu  # chain rule on Eq. 3.11
    d_F_main_d_B3 = 2*d_F_y_d_B3  # chain rule on Eq. 4.38
    d_sum_F_d_B3 = -d_F_main_d_B3  # chain rule on Eq. 4.8
    d_sum_M_d_B3 = -a*d_F_main_d_B3  # chain rule on Eq. 4.8
    d_v_dot_d_B3 = d_sum_F_d_B3/m  # chain rule on Eq. 4.9
    d_r_dot_d_B3 = d_sum_M_d_B3/Izz  # chain rule on Eq. 4.9
    d_a_y_d_B3 = d_v_dot_d_B3  # chain rule on Eq. 4.7
    d_C_c_d_C3 = Fz  # chain rule on Eq. 3.3
    d_alpha_bar_d_C3 = d_C_c_d_C3*w38  # chain rule on Eq. 3.6
    d_psi_bar_d_C3 = d_alpha_bar_d_C3*w22  # chain rule on Eq. 3.10
    d_theta_bar_d_C3 = B1*d_psi_bar_d_C3*w23  # chain rule on Eq. 3.9
    d_F_bar_d_C3 = d_theta_bar_d_C3*w25  # chain rule on Eq. 3.8
    d_F_y_d_C3 = Fz*d_F_bar_d_C3*mu  # chain rule on Eq. 3.11
    d_F_main_d_C3 = 2*d_F_y_d_C3  # chain rule on Eq. 4.38
    d_sum_F_d_C3 = -d_F_main_d_C3  # chain rule on Eq. 4.8
    d_sum_M_d_C3 = -a*d_F_main_d_C3  # chain rule on Eq. 4.8
    d_v_dot_d_C3 = d_sum_F_d_C3/m  # chain rule on Eq. 4.9
    d_r_dot_d_C3 = d_sum_M_d_C3/Izz  # chain rule on Eq. 4.9
    d_a_y_d_C3 = d_v_dot_d_C3  # chain rule on Eq. 4.7
    d_mu_d_B5 = 1  # chain rule on Eq. 3.5
    d_alpha_bar_d_B5 = -d_mu_d_B5*w36  # chain rule on Eq. 3.6
    d_psi_bar_d_B5 = d_alpha_bar_d_B5*w22  # chain rule on Eq. 3.10
    d_theta_bar_d_B5 = B1*d_psi_bar_d_B5*w23  # chain rule on Eq. 3.9
    d_F_bar_d_B5 = d_theta_bar_d_B5*w25  # chain rule on Eq. 3.8
    d_F_y_d_B5 = F_bar*Fz*d_mu_d_B5 + Fz*d_F_bar_d_B5*mu  # chain rule on Eq. 3.11
    d_F_main_d_B5 = 2*d_F_y_d_B5  # chain rule on Eq. 4.38
    d_sum_F_d_B5 = -d_F_main_d_B5  # chain rule on Eq. 4.8
    d_sum_M_d_B5 = -a*d_F_main_d_B5  # chain rule on Eq. 4.8
    d_v_dot_d_B5 = d_sum_F_d_B5/m  # chain rule on Eq. 4.9
    d_r_dot_d_B5 = d_sum_M_d_B5/Izz  # chain rule on Eq. 4.9
    d_a_y_d_B5 = d_v_dot_d_B5  # chain rule on Eq. 4.7
    d_mu_d_C5 = Fz  # chain rule on Eq. 3.5
    d_alpha_bar_d_C5 = -d_mu_d_C5*w36  # chain rule on Eq. 3.6
    d_psi_bar_d_C5 = d_alpha_bar_d_C5*w22  # chain rule on Eq. 3.10
    d_theta_bar_d_C5 = B1*d_psi_bar_d_C5*w23  # chain rule on Eq. 3.9
    d_F_bar_d_C5 = d_theta_bar_d_C5*w25  # chain rule on Eq. 3.8
    d_F_y_d_C5 = F_bar*Fz*d_mu_d_C5 + Fz*d_F_bar_d_C5*mu  # chain rule on Eq. 3.11
    d_F_main_d_C5 = 2*d_F_y_d_C5  # chain rule on Eq. 4.38
    d_sum_F_d_C5 = -d_F_main_d_C5  # chain rule on Eq. 4.8
    d_sum_M_d_C5 = -a*d_F_main_d_C5  # chain rule on Eq. 4.8
    d_v_dot_d_C5 = d_sum_F_d_C5/m  # chain rule on Eq. 4.9
    d_r_dot_d_C5 = d_sum_M_d_C5/Izz  # chain rule on Eq. 4.9
    d_a_y_d_C5 = d_v_dot_d_C5  # chain rule on Eq. 4.7
    d_psi_bar_d_B1 = alpha_bar*w21/B1 - E1*w7/B1**2  # chain rule on Eq. 3.10
    d_theta_bar_d_B1 = B1*d_psi_bar_d_B1*w23 + psi_bar*w23  # chain rule on Eq. 3.9
    d_F_bar_d_B1 = d_theta_bar_d_B1*w25  # chain rule on Eq. 3.8
    d_F_y_d_B1 = Fz*d_F_bar_d_B1*mu  # chain rule on Eq. 3.11
    d_F_main_d_B1 = 2*d_F_y_d_B1  # chain rule on Eq. 4.38
    d_sum_F_d_B1 = -d_F_main_d_B1  # chain rule on Eq. 4.8
    d_sum_M_d_B1 = -a*d_F_main_d_B1  # chain rule on Eq. 4.8
    d_v_dot_d_B1 = d_sum_F_d_B1/m  # chain rule on Eq. 4.9
    d_r_dot_d_B1 = d_sum_M_d_B1/Izz  # chain rule on Eq. 4.9
    d_a_y_d_B1 = d_v_dot_d_B1  # chain rule on Eq. 4.7
    d_theta_bar_d_C1 = w8  # chain rule on Eq. 3.9
    d_F_bar_d_C1 = d_theta_bar_d_C1*w25  # chain rule on Eq. 3.8
    d_F_y_d_C1 = Fz*d_F_bar_d_C1*mu  # chain rule on Eq. 3.11
    d_F_main_d_C1 = 2*d_F_y_d_C1  # chain rule on Eq. 4.38
    d_sum_F_d_C1 = -d_F_main_d_C1  # chain rule on Eq. 4.8
    d_sum_M_d_C1 = -a*d_F_main_d_C1  # chain rule on Eq. 4.8
    d_v_dot_d_C1 = d_sum_F_d_C1/m  # chain rule on Eq. 4.9
    d_r_dot_d_C1 = d_sum_M_d_C1/Izz  # chain rule on Eq. 4.9
    d_a_y_d_C1 = d_v_dot_d_C1  # chain rule on Eq. 4.7
    d_F_bar_d_D1 = ca.sin(theta_bar)  # chain rule on Eq. 3.8
    d_F_y_d_D1 = Fz*d_F_bar_d_D1*mu  # chain rule on Eq. 3.11
    d_F_main_d_D1 = 2*d_F_y_d_D1  # chain rule on Eq. 4.38
    d_sum_F_d_D1 = -d_F_main_d_D1  # chain rule on Eq. 4.8
    d_sum_M_d_D1 = -a*d_F_main_d_D1  # chain rule on Eq. 4.8
    d_v_dot_d_D1 = d_sum_F_d_D1/m  # chain rule on Eq. 4.9
    d_r_dot_d_D1 = d_sum_M_d_D1/Izz  # chain rule on Eq. 4.9
    d_a_y_d_D1 = d_v_dot_d_D1  # chain rule on Eq. 4.7
    d_psi_bar_d_E1 = -alpha_bar + w7/B1  # chain rule on Eq. 3.10
    d_theta_bar_d_E1 = B1*d_psi_bar_d_E1*w23  # chain rule on Eq. 3.9
    d_F_bar_d_E1 = d_theta_bar_d_E1*w25  # chain rule on Eq. 3.8
    d_F_y_d_E1 = Fz*d_F_bar_d_E1*mu  # chain rule on Eq. 3.11
    d_F_main_d_E1 = 2*d_F_y_d_E1  # chain rule on Eq. 4.38
    d_sum_F_d_E1 = -d_F_main_d_E1  # chain rule on Eq. 4.8
    d_sum_M_d_E1 = -a*d_F_main_d_E1  # chain rule on Eq. 4.8
    d_v_dot_d_E1 = d_sum_F_d_E1/m  # chain rule on Eq. 4.9
    d_r_dot_d_E1 = d_sum_M_d_E1/Izz  # chain rule on Eq. 4.9
    d_a_y_d_E1 = d_v_dot_d_E1  # chain rule on Eq. 4.7
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
        [d_v_dot_d_m, 0, d_v_dot_d_a, d_v_dot_d_b, d_v_dot_d_u, d_v_dot_d_rho, d_v_dot_d_Ap, d_v_dot_d_CL_gamma, d_v_dot_d_Ct, d_v_dot_d_Fz, d_v_dot_d_B3, d_v_dot_d_C3, d_v_dot_d_B5, d_v_dot_d_C5, d_v_dot_d_B1, d_v_dot_d_C1, d_v_dot_d_D1, d_v_dot_d_E1, 0],
        [0, d_r_dot_d_Izz, d_r_dot_d_a, d_r_dot_d_b, d_r_dot_d_u, d_r_dot_d_rho, d_r_dot_d_Ap, d_r_dot_d_CL_gamma, d_r_dot_d_Ct, d_r_dot_d_Fz, d_r_dot_d_B3, d_r_dot_d_C3, d_r_dot_d_B5, d_r_dot_d_C5, d_r_dot_d_B1, d_r_dot_d_C1, d_r_dot_d_D1, d_r_dot_d_E1, 0],
        [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
        [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
        [0, 0, 0, 0, ca.cos(psi), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
        [0, 0, 0, 0, ca.sin(psi), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
        [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
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
        [d_F_held_d_v, d_F_held_d_r, 0, 0, 0, 0, 0],
        [0, 0, 0, 0, 0, 0, 0],
    ])
    gu_ = ca.vertcat(0, 0, 0, 0, 0, 0, d_a_y_d_F_disturbance, d_sum_F_d_F_disturbance, d_sum_M_d_F_disturbance, 0, 0)
    gp_ = ca.blockcat([
        [0, 0, d_alpha_d_a, 0, d_alpha_d_u, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
        [0, 0, 0, d_gamma_d_b, d_gamma_d_u, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
        [0, 0, 0, 0, d_beta_d_u, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
        [0, 0, d_F_main_d_a, 0, d_F_main_d_u, 0, 0, 0, 0, d_F_main_d_Fz, d_F_main_d_B3, d_F_main_d_C3, d_F_main_d_B5, d_F_main_d_C5, d_F_main_d_B1, d_F_main_d_C1, d_F_main_d_D1, d_F_main_d_E1, 0],
        [0, 0, 0, d_F_tail_d_b, d_F_tail_d_u, d_F_tail_d_rho, d_F_tail_d_Ap, d_F_tail_d_CL_gamma, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
        [0, 0, 0, d_F_tail_wheel_d_b, d_F_tail_wheel_d_u, 0, 0, 0, d_F_tail_wheel_d_Ct, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
        [d_a_y_d_m, 0, d_a_y_d_a, d_a_y_d_b, d_a_y_d_u, d_a_y_d_rho, d_a_y_d_Ap, d_a_y_d_CL_gamma, d_a_y_d_Ct, d_a_y_d_Fz, d_a_y_d_B3, d_a_y_d_C3, d_a_y_d_B5, d_a_y_d_C5, d_a_y_d_B1, d_a_y_d_C1, d_a_y_d_D1, d_a_y_d_E1, 0],
        [0, 0, d_sum_F_d_a, d_sum_F_d_b, d_sum_F_d_u, d_sum_F_d_rho, d_sum_F_d_Ap, d_sum_F_d_CL_gamma, d_sum_F_d_Ct, d_sum_F_d_Fz, d_sum_F_d_B3, d_sum_F_d_C3, d_sum_F_d_B5, d_sum_F_d_C5, d_sum_F_d_B1, d_sum_F_d_C1, d_sum_F_d_D1, d_sum_F_d_E1, 0],
        [0, 0, d_sum_M_d_a, d_sum_M_d_b, d_sum_M_d_u, d_sum_M_d_rho, d_sum_M_d_Ap, d_sum_M_d_CL_gamma, d_sum_M_d_Ct, d_sum_M_d_Fz, d_sum_M_d_B3, d_sum_M_d_C3, d_sum_M_d_B5, d_sum_M_d_C5, d_sum_M_d_B1, d_sum_M_d_C1, d_sum_M_d_D1, d_sum_M_d_E1, 0],
        [d_F_held_d_m, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
        [d_N_held_d_m, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, d_N_held_d_g],
    ])
    return ca.Function(
        "nonlinear_jacobians",
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
    p : column of 19
        m [kg], Izz [kg m^2], a [m], b [m], u [m/s], rho [kg/m^3], Ap [m^2], CL_gamma
        [1/rad], Ct [N/rad], Fz [N], B3 [1/rad], C3 [1/(rad N)], B5 [1], C5 [1/N], B1 [1],
        C1 [1], D1 [1], E1 [1], g [m/s^2]

    Outputs
    -------
    place : 4 x 3, where each part acts, from the CG along body x, y, z [m]
    force : 4 x 3, with what force along body x, y, z [N]

    Thesis
    ------
    Eq. 3.3, Eq. 3.5, Eq. 3.6, Eq. 3.10, Eq. 3.9, Eq. 3.8, Eq. 3.11, Eq. 4.38, Eq. 4.19, Eq.
    4.29, Eq. 4.30
    """
    x_ = ca.SX.sym("x", 7)
    v, r, y, theta, X, Y, psi = ca.vertsplit(x_)
    u_ = ca.SX.sym("u", 1)
    F_disturbance, = ca.vertsplit(u_)
    p_ = ca.SX.sym("p", 19)
    m, Izz, a, b, u, rho, Ap, CL_gamma, Ct, Fz, B3, C3, B5, C5, B1, C1, D1, E1, g = ca.vertsplit(p_)
    C_c = B3 + C3*Fz  # Eq. 3.3
    mu = B5 + C5*Fz  # Eq. 3.5
    alpha_bar = C_c*(a*r + v)/(mu*u)  # Eq. 3.6
    psi_bar = alpha_bar*(1 - E1) + E1*ca.atan(B1*alpha_bar)/B1  # Eq. 3.10
    theta_bar = C1*ca.atan(B1*psi_bar)  # Eq. 3.9
    F_bar = D1*ca.sin(theta_bar)  # Eq. 3.8
    F_y = F_bar*Fz*mu  # Eq. 3.11
    F_main = 2*F_y  # Eq. 4.38
    gamma = ca.atan((-b*r + v)/u)  # Eq. 4.19
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
        "nonlinear_places",
        [x_, u_, p_],
        [place_, force_],
        ["x", "u", "p"],
        ["place", "force"],
    )


@cache
def rk4() -> ca.Function:
    """Integrate the model over an interval: see `integrators.interval`."""
    return integrators.interval(rhs(), "nonlinear_rk4", "rk4")


@cache
def rk45() -> ca.Function:
    """Integrate the model over an interval: see `integrators.interval`."""
    return integrators.interval(rhs(), "nonlinear_rk45", "rk45")
