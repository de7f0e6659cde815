# Generated from derive/ (digest 2782b10879527e9a) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`.
"""A level body with a free speed on three wheels: loads from weight, lift and elevator only."""

from functools import cache

import casadi as ca

from groundroll.generated import integrators


@cache
def rhs() -> ca.Function:
    """Time derivatives of the states.

    Inputs
    ------
    x : column of 6
        u [m/s], v [m/s], r [rad/s], X [m], Y [m], psi [rad]
    u : column of 11
        wind_x [m/s], wind_y [m/s], thrust [N], elevator [rad], brake_left [1], brake_right
        [1], pedal [1], steering [rad], rudder [rad], aileron [rad], F_disturbance [N]
    p : column of 79
        a [m], theta_ground [rad], toe [rad], track [m], z_main [m], v_rest [m/s], A_disc
        [m^2], rho [kg/m^3], downwash [1], i_h [rad], tau_elevator [1], CL_h [1/rad],
        CL_h_max [1], S_h [m^2], tailplane_apart [1], S_wing [m^2], Cm_0 [1], Cm_alpha
        [1/rad], Cm_elevator [1/rad], c_wing [m], CL_0 [1], CL_alpha [1/rad], CL_max [1],
        CD_0 [1], K_drag [1], a_third [m], g [m/s^2], m [kg], x_h [m], z_h [m], z_third [m],
        z_thrust [m], B3 [1/rad], C3 [1/(rad N)], B5 [1], C5 [1/N], surface_left [1], B1
        [1], E1 [1], C1 [1], D1 [1], mu_roll_left [1], surface_right [1], mu_roll_right [1],
        steering_ratio [rad], swivels [1], B3_third [1/rad], C3_third [1/(rad N)], B5_third
        [1], C5_third [1/N], surface_third [1], B1_third [1], E1_third [1], C1_third [1],
        D1_third [1], mu_roll_third [1], rudder_max [rad], CY_beta [1/rad], CY_r [1/rad],
        CY_rudder [1/rad], b_wing [m], Cl_aileron [1/rad], Cl_beta [1/rad], Cl_r [1/rad],
        Cn_aileron [1/rad], Cn_beta [1/rad], Cn_r [1/rad], Cn_rudder [1/rad], b [m], z_fin
        [m], CL_fin [1], CL_gamma [1/rad], tau_rudder [1], Ap [m^2], fin_apart [1], v_stop
        [m/s], runway_width [m], psi_loop [rad], Izz [kg m^2]

    Outputs
    -------
    xdot : 6 x 1, time derivatives of x

    Thesis
    ------
    Eq. 4.10 at the contact, Eq. 4.10, Eq. 4.13, at any speed, Eq. 4.10 through the air, Eq.
    3.3, never below 0, Eq. 3.5, never below a thousandth, Eq. 3.6, Eq. 3.10, Eq. 3.9, Eq.
    3.8, Eq. 3.7, Eq. 3.11, Eq. 4.19, Eq. 4.29, Eq. 4.8, Eq. 4.9
    """
    x_ = ca.SX.sym("x", 6)
    u, v, r, X, Y, psi = ca.vertsplit(x_)
    u_ = ca.SX.sym("u", 11)
    wind_x, wind_y, thrust, elevator, brake_left, brake_right, pedal, steering, rudder, aileron, F_disturbance = ca.vertsplit(u_)
    p_ = ca.SX.sym("p", 79)
    a, theta_ground, toe, track, z_main, v_rest, A_disc, rho, downwash, i_h, tau_elevator, CL_h, CL_h_max, S_h, tailplane_apart, S_wing, Cm_0, Cm_alpha, Cm_elevator, c_wing, CL_0, CL_alpha, CL_max, CD_0, K_drag, a_third, g, m, x_h, z_h, z_third, z_thrust, B3, C3, B5, C5, surface_left, B1, E1, C1, D1, mu_roll_left, surface_right, mu_roll_right, steering_ratio, swivels, B3_third, C3_third, B5_third, C5_third, surface_third, B1_third, E1_third, C1_third, D1_third, mu_roll_third, rudder_max, CY_beta, CY_r, CY_rudder, b_wing, Cl_aileron, Cl_beta, Cl_r, Cn_aileron, Cn_beta, Cn_r, Cn_rudder, b, z_fin, CL_fin, CL_gamma, tau_rudder, Ap, fin_apart, v_stop, runway_width, psi_loop, Izz = ca.vertsplit(p_)
    w3 = (1/2)*r*track
    w8 = a*ca.cos(theta_ground) + z_main*ca.sin(theta_ground)
    w9 = r*w8 + v
    w10 = w9*ca.sin(toe)
    V_x_left = w10 + (u + w3)*ca.cos(toe)  # Eq. 4.10 at the contact
    V_y_left = w9*ca.cos(toe) - (u + w3)*ca.sin(toe)  # Eq. 4.10
    w12 = (1/1000000)*v_rest**2
    w13 = V_x_left**2 + w12
    tan_alpha_left = V_y_left/ca.sqrt(w13)  # Eq. 4.13, at any speed
    V2_fade_left = ca.sqrt(v_rest**4 + (V_x_left**2 + V_y_left**2)**2)  # near rest
    V_fade_left = ca.sqrt(V2_fade_left)  # near rest
    wind_w = 0  # wind
    V_down_tailplane = -wind_w  # Eq. 4.10 through the air
    wind_u = wind_x*ca.cos(psi) + wind_y*ca.sin(psi)  # wind
    V_axial_tailplane = u - wind_u  # Eq. 4.10 through the air
    w21 = -0.001**2
    w22 = 2*thrust/(A_disc*ca.sqrt(rho**2 + 1e-06**2))
    w23 = V_axial_tailplane*ca.sqrt(V_axial_tailplane**2 + 0.001**2) + w22
    w24 = 1/0.001**2
    w25 = ca.fmax(0, ca.fmin(1, w23*w24))
    V_s_tailplane = ca.sqrt(0.001**2*w25**3*(3*w25**2 - 8*w25 + 6) + ca.fmax(0, w21 + w23) + 0.001**2)  # momentum theory
    gamma_tailplane = elevator*tau_elevator + i_h + (1 - downwash)*(theta_ground + ca.atan2(V_down_tailplane, V_s_tailplane))  # geometry
    w26 = CL_h_max + 1/10
    w27 = ca.fmax(-w26, ca.fmin(w26, CL_h*gamma_tailplane))
    w30 = ca.fmax(0, -5*CL_h_max - 5*w27 + 1/2)
    w31 = ca.fmax(0, -5*CL_h_max + 5*w27 + 1/2)
    C_L_tailplane = w27 + (1/5)*w30**3*(1 - 1/2*w30) - 1/5*w31**3*(1 - 1/2*w31)  # stall
    F_L_tailplane = (1/2)*C_L_tailplane*S_h*rho*tailplane_apart*(V_down_tailplane**2 + V_s_tailplane**2)  # lift
    u_air = u - wind_u  # air
    w_air = -wind_w  # air
    w33 = u_air**2 + 0.0001**2
    attack = theta_ground + ca.atan(w_air/ca.sqrt(w33))  # angle of attack; from behind as from ahead
    V_plane = ca.sqrt(w_air**2 + w33)  # air
    wind_v = -wind_x*ca.sin(psi) + wind_y*ca.cos(psi)  # wind
    v_air = v - wind_v  # air
    V_air = ca.sqrt(V_plane**2 + v_air**2)  # air
    qS = (1/2)*S_wing*V_air**2*rho  # dynamic pressure
    M_air = c_wing*qS*(Cm_0 + Cm_alpha*attack + Cm_elevator*elevator)  # derivatives
    w35 = CL_max + 1/10
    w36 = ca.fmax(-w35, ca.fmin(w35, CL_0 + CL_alpha*attack))
    w39 = ca.fmax(0, -5*CL_max - 5*w36 + 1/2)
    w40 = ca.fmax(0, -5*CL_max + 5*w36 + 1/2)
    CL = w36 + (1/5)*w39**3*(1 - 1/2*w39) - 1/5*w40**3*(1 - 1/2*w40)  # lift, and stall
    CD = CD_0 + CL**2*K_drag  # drag polar
    drag = CD*qS  # drag
    lift = CL*qS  # lift
    w41 = a_third*ca.cos(theta_ground)
    w42 = z_third*ca.sin(theta_ground)
    w43 = -w41 - w42 + w8
    w48 = -F_L_tailplane + g*m - drag*w_air/V_plane - lift*u_air/V_plane
    w49 = F_L_tailplane*(x_h*ca.cos(theta_ground) + z_h*ca.sin(theta_ground)) + M_air + thrust*z_thrust*ca.cos(theta_ground)
    w50 = ca.fmax(0, (1/2)*(-w48*(w41 + w42) - w49)/w43)
    Fz_left = w50  # balance of weight and lift
    C_c_left = ca.fmax(0, B3 + C3*Fz_left)  # Eq. 3.3, never below 0
    mu_left = surface_left*ca.fmax(1/1000, B5 + C5*Fz_left)  # Eq. 3.5, never below a thousandth
    alpha_free_left = C_c_left*tan_alpha_left/mu_left  # Eq. 3.6
    w54 = 1/(B1*ca.sqrt(ca.fmax(1/1000000000000, E1 - 1)))
    alpha_bar_left = ca.fmax(-w54, ca.fmin(alpha_free_left, w54))  # held at the peak
    psi_bar_left = alpha_bar_left*(1 - E1) + E1*ca.atan(B1*alpha_bar_left)/B1  # Eq. 3.10
    theta_bar_left = C1*ca.atan(B1*psi_bar_left)  # Eq. 3.9
    F_bar_left = D1*ca.sin(theta_bar_left)  # Eq. 3.8
    grip_left = F_bar_left  # Eq. 3.7
    braked_left = (brake_left*(mu_left - mu_roll_left) + mu_roll_left)/mu_left  # brake
    w58 = braked_left + 1/200000
    w60 = ca.fmax(-w58, ca.fmin(w58, V_x_left/V_fade_left))
    w63 = ca.fmax(0, -100000*braked_left - 100000*w60 + 1/2)
    w64 = ca.fmax(0, -100000*braked_left + 100000*w60 + 1/2)
    along_left = w60 + (1/100000)*w63**3*(1 - 1/2*w63) - 1/100000*w64**3*(1 - 1/2*w64)  # a locked wheel slides
    left_over_left = ca.sqrt(1 - along_left**2)  # friction ellipse
    w65 = grip_left*ca.sqrt(V_y_left**2 + w13)
    w66 = 1/V_fade_left**2
    w67 = (V_y_left*w65*w66 + 1/1000000000000)/(V_y_left**2*w66 + 1/2000000000000)
    w68 = ca.fmax(0, ca.fmin(1, 50*brake_left - 50*w67))
    asked_left = V_y_left*((1/50)*w68**3*(3*w68**2 - 8*w68 + 6) + ca.fmax(0, brake_left - w67 - 1/50))/V_fade_left + w65/V_fade_left  # slip, or a locked wheel that slides
    w69 = left_over_left + 1/200000
    w70 = ca.fmax(-w69, ca.fmin(asked_left, w69))
    w73 = ca.fmax(0, -100000*left_over_left - 100000*w70 + 1/2)
    w74 = ca.fmax(0, -100000*left_over_left + 100000*w70 + 1/2)
    across_left = w70 + (1/100000)*w73**3*(1 - 1/2*w73) - 1/100000*w74**3*(1 - 1/2*w74)  # friction ellipse
    F_x_left = Fz_left*along_left*mu_left  # Eq. 3.11
    F_y_left = Fz_left*across_left*mu_left  # Eq. 3.11
    push_x_left = -F_x_left*ca.cos(toe) + F_y_left*ca.sin(toe)  # resolved
    push_y_left = -F_x_left*ca.sin(toe) - F_y_left*ca.cos(toe)  # resolved
    V_x_right = -w10 + (u - w3)*ca.cos(toe)  # Eq. 4.10 at the contact
    V_y_right = w9*ca.cos(toe) + (u - w3)*ca.sin(toe)  # Eq. 4.10
    w78 = V_x_right**2 + w12
    tan_alpha_right = V_y_right/ca.sqrt(w78)  # Eq. 4.13, at any speed
    V2_fade_right = ca.sqrt(v_rest**4 + (V_x_right**2 + V_y_right**2)**2)  # near rest
    V_fade_right = ca.sqrt(V2_fade_right)  # near rest
    Fz_right = w50  # balance of weight and lift
    C_c_right = ca.fmax(0, B3 + C3*Fz_right)  # Eq. 3.3, never below 0
    mu_right = surface_right*ca.fmax(1/1000, B5 + C5*Fz_right)  # Eq. 3.5, never below a thousandth
    alpha_free_right = C_c_right*tan_alpha_right/mu_right  # Eq. 3.6
    alpha_bar_right = ca.fmax(-w54, ca.fmin(alpha_free_right, w54))  # held at the peak
    psi_bar_right = alpha_bar_right*(1 - E1) + E1*ca.atan(B1*alpha_bar_right)/B1  # Eq. 3.10
    theta_bar_right = C1*ca.atan(B1*psi_bar_right)  # Eq. 3.9
    F_bar_right = D1*ca.sin(theta_bar_right)  # Eq. 3.8
    grip_right = F_bar_right  # Eq. 3.7
    braked_right = (brake_right*(mu_right - mu_roll_right) + mu_roll_right)/mu_right  # brake
    w81 = braked_right + 1/200000
    w83 = ca.fmax(-w81, ca.fmin(w81, V_x_right/V_fade_right))
    w86 = ca.fmax(0, -100000*braked_right - 100000*w83 + 1/2)
    w87 = ca.fmax(0, -100000*braked_right + 100000*w83 + 1/2)
    along_right = w83 + (1/100000)*w86**3*(1 - 1/2*w86) - 1/100000*w87**3*(1 - 1/2*w87)  # a locked wheel slides
    left_over_right = ca.sqrt(1 - along_right**2)  # friction ellipse
    w88 = grip_right*ca.sqrt(V_y_right**2 + w78)
    w89 = 1/V_fade_right**2
    w90 = (V_y_right*w88*w89 + 1/1000000000000)/(V_y_right**2*w89 + 1/2000000000000)
    w91 = ca.fmax(0, ca.fmin(1, 50*brake_right - 50*w90))
    asked_right = V_y_right*((1/50)*w91**3*(3*w91**2 - 8*w91 + 6) + ca.fmax(0, brake_right - w90 - 1/50))/V_fade_right + w88/V_fade_right  # slip, or a locked wheel that slides
    w92 = left_over_right + 1/200000
    w93 = ca.fmax(-w92, ca.fmin(asked_right, w92))
    w96 = ca.fmax(0, -100000*left_over_right - 100000*w93 + 1/2)
    w97 = ca.fmax(0, -100000*left_over_right + 100000*w93 + 1/2)
    across_right = w93 + (1/100000)*w96**3*(1 - 1/2*w96) - 1/100000*w97**3*(1 - 1/2*w97)  # friction ellipse
    F_x_right = Fz_right*along_right*mu_right  # Eq. 3.11
    F_y_right = Fz_right*across_right*mu_right  # Eq. 3.11
    push_x_right = -F_x_right*ca.cos(toe) - F_y_right*ca.sin(toe)  # resolved
    push_y_right = F_x_right*ca.sin(toe) - F_y_right*ca.cos(toe)  # resolved
    commanded_third = pedal*steering_ratio + steering  # linkage
    delta_third = commanded_third*(1 - swivels)  # linkage
    w102 = r*(w41 + w42) + v
    V_x_third = u*ca.cos(delta_third) + w102*ca.sin(delta_third)  # Eq. 4.10 at the contact
    V_y_third = -u*ca.sin(delta_third) + w102*ca.cos(delta_third)  # Eq. 4.10
    w104 = V_x_third**2 + w12
    tan_alpha_third = V_y_third/ca.sqrt(w104)  # Eq. 4.13, at any speed
    V2_fade_third = ca.sqrt(v_rest**4 + (V_x_third**2 + V_y_third**2)**2)  # near rest
    V_fade_third = ca.sqrt(V2_fade_third)  # near rest
    Fz_third = ca.fmax(0, -(-w48*w8 - w49)/w43)  # balance of weight and lift
    C_c_third = ca.fmax(0, B3_third + C3_third*Fz_third)  # Eq. 3.3, never below 0
    mu_third = surface_third*ca.fmax(1/1000, B5_third + C5_third*Fz_third)  # Eq. 3.5, never below a thousandth
    alpha_free_third = C_c_third*tan_alpha_third/mu_third  # Eq. 3.6
    w109 = 1/(B1_third*ca.sqrt(ca.fmax(1/1000000000000, E1_third - 1)))
    alpha_bar_third = ca.fmax(-w109, ca.fmin(alpha_free_third, w109))  # held at the peak
    psi_bar_third = -alpha_bar_third*(E1_third - 1) + E1_third*ca.atan(B1_third*alpha_bar_third)/B1_third  # Eq. 3.10
    theta_bar_third = C1_third*ca.atan(B1_third*psi_bar_third)  # Eq. 3.9
    F_bar_third = D1_third*ca.sin(theta_bar_third)  # Eq. 3.8
    grip_third = F_bar_third  # Eq. 3.7
    braked_third = mu_roll_third/mu_third  # brake
    w110 = braked_third + 1/200000
    w112 = ca.fmax(-w110, ca.fmin(w110, V_x_third/V_fade_third))
    w115 = ca.fmax(0, -100000*braked_third - 100000*w112 + 1/2)
    w116 = ca.fmax(0, -100000*braked_third + 100000*w112 + 1/2)
    along_third = w112 + (1/100000)*w115**3*(1 - 1/2*w115) - 1/100000*w116**3*(1 - 1/2*w116)  # a locked wheel slides
    left_over_third = ca.sqrt(1 - along_third**2)  # friction ellipse
    asked_third = grip_third*ca.sqrt(V_y_third**2 + w104)/V_fade_third  # slip
    w117 = left_over_third + 1/200000
    w118 = ca.fmax(-w117, ca.fmin(asked_third, w117))
    w121 = ca.fmax(0, -100000*left_over_third - 100000*w118 + 1/2)
    w122 = ca.fmax(0, -100000*left_over_third + 100000*w118 + 1/2)
    across_third = w118 + (1/100000)*w121**3*(1 - 1/2*w121) - 1/100000*w122**3*(1 - 1/2*w122)  # friction ellipse
    F_x_third = Fz_third*along_third*mu_third  # Eq. 3.11
    F_y_third = Fz_third*across_third*mu_third*(1 - swivels)  # Eq. 3.11
    push_x_third = -F_x_third*ca.cos(delta_third) + F_y_third*ca.sin(delta_third)  # resolved
    push_y_third = -F_x_third*ca.sin(delta_third) - F_y_third*ca.cos(delta_third)  # resolved
    sideslip = ca.atan2(v_air, V_plane)  # angle of sideslip
    w124 = -pedal*rudder_max + rudder
    deflected = w124  # linkage
    w125 = (1/4)*S_wing*V_air*r*rho
    Y_air = CY_r*b_wing*w125 + qS*(CY_beta*sideslip + CY_rudder*deflected)  # derivatives
    N_air = Cn_r*b_wing**2*w125 + b_wing*qS*(Cn_aileron*aileron + Cn_beta*sideslip + Cn_rudder*deflected)  # derivatives
    V_axial_fin = u - wind_u  # Eq. 4.10 through the air
    w126 = V_axial_fin*ca.sqrt(V_axial_fin**2 + 0.001**2) + w22
    w127 = ca.fmax(0, ca.fmin(1, w126*w24))
    V_s_fin = ca.sqrt(0.001**2*w127**3*(3*w127**2 - 8*w127 + 6) + ca.fmax(0, w126 + w21) + 0.001**2)  # momentum theory
    w128 = b*ca.cos(theta_ground)
    w129 = z_fin*ca.sin(theta_ground) - w128
    V_side_fin = r*w129 + v - wind_v  # Eq. 4.10 through the air
    gamma_fin = ca.atan2(V_side_fin, V_s_fin)  # Eq. 4.19
    delta_rudder_fin = w124  # linkage
    w130 = CL_fin + 1/10
    w131 = ca.fmax(-w130, ca.fmin(w130, CL_gamma*(-delta_rudder_fin*tau_rudder + gamma_fin)))
    w134 = ca.fmax(0, -5*CL_fin - 5*w131 + 1/2)
    w135 = ca.fmax(0, -5*CL_fin + 5*w131 + 1/2)
    C_L_fin = w131 + (1/5)*w134**3*(1 - 1/2*w134) - 1/5*w135**3*(1 - 1/2*w135)  # stall
    F_L_fin = (1/2)*Ap*C_L_fin*fin_apart*rho*(V_s_fin**2 + V_side_fin**2)  # Eq. 4.29
    sum_Fx = push_x_left + push_x_right + push_x_third + thrust - drag*u_air/V_plane + lift*w_air/V_plane  # Eq. 4.8
    sum_F = -F_L_fin + F_disturbance + Y_air + push_y_left + push_y_right + push_y_third  # Eq. 4.8
    sum_M = -F_L_fin*w129 - F_disturbance*w128 + N_air + (1/2)*push_x_left*track - 1/2*push_x_right*track + push_y_left*w8 + push_y_right*w8 + push_y_third*(w41 + w42)  # Eq. 4.8
    u_dot = r*v + sum_Fx/m  # Eq. 4.9
    v_dot = -r*u + sum_F/m  # Eq. 4.9
    r_dot = sum_M/Izz  # Eq. 4.9
    xdot_ = ca.vertcat(u_dot, v_dot, r_dot, u*ca.cos(psi) - v*ca.sin(psi), u*ca.sin(psi) + v*ca.cos(psi), r)
    return ca.Function(
        "rollout_rhs",
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
    x : column of 6
        u [m/s], v [m/s], r [rad/s], X [m], Y [m], psi [rad]
    u : column of 11
        wind_x [m/s], wind_y [m/s], thrust [N], elevator [rad], brake_left [1], brake_right
        [1], pedal [1], steering [rad], rudder [rad], aileron [rad], F_disturbance [N]
    p : column of 79
        a [m], theta_ground [rad], toe [rad], track [m], z_main [m], v_rest [m/s], A_disc
        [m^2], rho [kg/m^3], downwash [1], i_h [rad], tau_elevator [1], CL_h [1/rad],
        CL_h_max [1], S_h [m^2], tailplane_apart [1], S_wing [m^2], Cm_0 [1], Cm_alpha
        [1/rad], Cm_elevator [1/rad], c_wing [m], CL_0 [1], CL_alpha [1/rad], CL_max [1],
        CD_0 [1], K_drag [1], a_third [m], g [m/s^2], m [kg], x_h [m], z_h [m], z_third [m],
        z_thrust [m], B3 [1/rad], C3 [1/(rad N)], B5 [1], C5 [1/N], surface_left [1], B1
        [1], E1 [1], C1 [1], D1 [1], mu_roll_left [1], surface_right [1], mu_roll_right [1],
        steering_ratio [rad], swivels [1], B3_third [1/rad], C3_third [1/(rad N)], B5_third
        [1], C5_third [1/N], surface_third [1], B1_third [1], E1_third [1], C1_third [1],
        D1_third [1], mu_roll_third [1], rudder_max [rad], CY_beta [1/rad], CY_r [1/rad],
        CY_rudder [1/rad], b_wing [m], Cl_aileron [1/rad], Cl_beta [1/rad], Cl_r [1/rad],
        Cn_aileron [1/rad], Cn_beta [1/rad], Cn_r [1/rad], Cn_rudder [1/rad], b [m], z_fin
        [m], CL_fin [1], CL_gamma [1/rad], tau_rudder [1], Ap [m^2], fin_apart [1], v_stop
        [m/s], runway_width [m], psi_loop [rad], Izz [kg m^2]

    Outputs
    -------
    y : 39 x 1, outputs Fz_left, alpha_left, F_x_left, F_y_left, Fz_right, alpha_right, F_x_right, F_y_right, Fz_third, alpha_third, F_x_third, F_y_third, attack, sideslip, CL, lift, drag, Y_air, L_air, M_air, N_air, gamma_fin, C_L_fin, F_L_fin, gamma_tailplane, C_L_tailplane, F_L_tailplane, V_ground, sum_Fx, sum_F, sum_M, a_x, a_y, N_held, Mx_held, My_held, above_stop, beyond_edge, beyond_loop

    Thesis
    ------
    Eq. 4.10 at the contact, Eq. 4.10, Eq. 4.13, at any speed, Eq. 4.13, Eq. 4.10 through
    the air, Eq. 3.3, never below 0, Eq. 3.5, never below a thousandth, Eq. 3.6, Eq. 3.10,
    Eq. 3.9, Eq. 3.8, Eq. 3.7, Eq. 3.11, Eq. 4.19, Eq. 4.29, Eq. 4.3, Eq. 4.8, Eq. 4.9, Eq.
    4.7
    """
    x_ = ca.SX.sym("x", 6)
    u, v, r, X, Y, psi = ca.vertsplit(x_)
    u_ = ca.SX.sym("u", 11)
    wind_x, wind_y, thrust, elevator, brake_left, brake_right, pedal, steering, rudder, aileron, F_disturbance = ca.vertsplit(u_)
    p_ = ca.SX.sym("p", 79)
    a, theta_ground, toe, track, z_main, v_rest, A_disc, rho, downwash, i_h, tau_elevator, CL_h, CL_h_max, S_h, tailplane_apart, S_wing, Cm_0, Cm_alpha, Cm_elevator, c_wing, CL_0, CL_alpha, CL_max, CD_0, K_drag, a_third, g, m, x_h, z_h, z_third, z_thrust, B3, C3, B5, C5, surface_left, B1, E1, C1, D1, mu_roll_left, surface_right, mu_roll_right, steering_ratio, swivels, B3_third, C3_third, B5_third, C5_third, surface_third, B1_third, E1_third, C1_third, D1_third, mu_roll_third, rudder_max, CY_beta, CY_r, CY_rudder, b_wing, Cl_aileron, Cl_beta, Cl_r, Cn_aileron, Cn_beta, Cn_r, Cn_rudder, b, z_fin, CL_fin, CL_gamma, tau_rudder, Ap, fin_apart, v_stop, runway_width, psi_loop, Izz = ca.vertsplit(p_)
    w3 = (1/2)*r*track
    w7 = a*ca.cos(theta_ground)
    w9 = z_main*ca.sin(theta_ground)
    w11 = r*(w7 + w9) + v
    w12 = w11*ca.sin(toe)
    V_x_left = w12 + (u + w3)*ca.cos(toe)  # Eq. 4.10 at the contact
    V_y_left = w11*ca.cos(toe) - (u + w3)*ca.sin(toe)  # Eq. 4.10
    w14 = (1/1000000)*v_rest**2
    w15 = V_x_left**2 + w14
    tan_alpha_left = V_y_left/ca.sqrt(w15)  # Eq. 4.13, at any speed
    alpha_left = ca.atan(tan_alpha_left)  # Eq. 4.13
    V2_fade_left = ca.sqrt(v_rest**4 + (V_x_left**2 + V_y_left**2)**2)  # near rest
    V_fade_left = ca.sqrt(V2_fade_left)  # near rest
    wind_w = 0  # wind
    V_down_tailplane = -wind_w  # Eq. 4.10 through the air
    wind_u = wind_x*ca.cos(psi) + wind_y*ca.sin(psi)  # wind
    V_axial_tailplane = u - wind_u  # Eq. 4.10 through the air
    w23 = -0.001**2
    w24 = 2*thrust/(A_disc*ca.sqrt(rho**2 + 1e-06**2))
    w25 = V_axial_tailplane*ca.sqrt(V_axial_tailplane**2 + 0.001**2) + w24
    w26 = 1/0.001**2
    w27 = ca.fmax(0, ca.fmin(1, w25*w26))
    V_s_tailplane = ca.sqrt(0.001**2*w27**3*(3*w27**2 - 8*w27 + 6) + ca.fmax(0, w23 + w25) + 0.001**2)  # momentum theory
    gamma_tailplane = elevator*tau_elevator + i_h + (1 - downwash)*(theta_ground + ca.atan2(V_down_tailplane, V_s_tailplane))  # geometry
    w28 = CL_h_max + 1/10
    w29 = ca.fmax(-w28, ca.fmin(w28, CL_h*gamma_tailplane))
    w32 = ca.fmax(0, -5*CL_h_max - 5*w29 + 1/2)
    w33 = ca.fmax(0, -5*CL_h_max + 5*w29 + 1/2)
    C_L_tailplane = w29 + (1/5)*w32**3*(1 - 1/2*w32) - 1/5*w33**3*(1 - 1/2*w33)  # stall
    F_L_tailplane = (1/2)*C_L_tailplane*S_h*rho*tailplane_apart*(V_down_tailplane**2 + V_s_tailplane**2)  # lift
    u_air = u - wind_u  # air
    w_air = -wind_w  # air
    w35 = u_air**2 + 0.0001**2
    attack = theta_ground + ca.atan(w_air/ca.sqrt(w35))  # angle of attack; from behind as from ahead
    V_plane = ca.sqrt(w_air**2 + w35)  # air
    wind_v = -wind_x*ca.sin(psi) + wind_y*ca.cos(psi)  # wind
    v_air = v - wind_v  # air
    V_air = ca.sqrt(V_plane**2 + v_air**2)  # air
    qS = (1/2)*S_wing*V_air**2*rho  # dynamic pressure
    M_air = c_wing*qS*(Cm_0 + Cm_alpha*attack + Cm_elevator*elevator)  # derivatives
    w37 = CL_max + 1/10
    w38 = ca.fmax(-w37, ca.fmin(w37, CL_0 + CL_alpha*attack))
    w41 = ca.fmax(0, -5*CL_max - 5*w38 + 1/2)
    w42 = ca.fmax(0, -5*CL_max + 5*w38 + 1/2)
    CL = w38 + (1/5)*w41**3*(1 - 1/2*w41) - 1/5*w42**3*(1 - 1/2*w42)  # lift, and stall
    CD = CD_0 + CL**2*K_drag  # drag polar
    drag = CD*qS  # drag
    lift = CL*qS  # lift
    w43 = a_third*ca.cos(theta_ground)
    w44 = z_third*ca.sin(theta_ground)
    w45 = -w43 - w44 + w7 + w9
    w49 = drag*w_air/V_plane
    w51 = lift*u_air/V_plane
    w52 = -F_L_tailplane + g*m - w49 - w51
    w53 = x_h*ca.cos(theta_ground)
    w54 = z_h*ca.sin(theta_ground)
    w55 = thrust*z_thrust*ca.cos(theta_ground)
    w56 = F_L_tailplane*(w53 + w54) + M_air + w55
    w57 = ca.fmax(0, (1/2)*(-w52*(w43 + w44) - w56)/w45)
    Fz_left = w57  # balance of weight and lift
    C_c_left = ca.fmax(0, B3 + C3*Fz_left)  # Eq. 3.3, never below 0
    mu_left = surface_left*ca.fmax(1/1000, B5 + C5*Fz_left)  # Eq. 3.5, never below a thousandth
    alpha_free_left = C_c_left*tan_alpha_left/mu_left  # Eq. 3.6
    w61 = 1/(B1*ca.sqrt(ca.fmax(1/1000000000000, E1 - 1)))
    alpha_bar_left = ca.fmax(-w61, ca.fmin(alpha_free_left, w61))  # held at the peak
    psi_bar_left = alpha_bar_left*(1 - E1) + E1*ca.atan(B1*alpha_bar_left)/B1  # Eq. 3.10
    theta_bar_left = C1*ca.atan(B1*psi_bar_left)  # Eq. 3.9
    F_bar_left = D1*ca.sin(theta_bar_left)  # Eq. 3.8
    grip_left = F_bar_left  # Eq. 3.7
    braked_left = (brake_left*(mu_left - mu_roll_left) + mu_roll_left)/mu_left  # brake
    w65 = braked_left + 1/200000
    w67 = ca.fmax(-w65, ca.fmin(w65, V_x_left/V_fade_left))
    w70 = ca.fmax(0, -100000*braked_left - 100000*w67 + 1/2)
    w71 = ca.fmax(0, -100000*braked_left + 100000*w67 + 1/2)
    along_left = w67 + (1/100000)*w70**3*(1 - 1/2*w70) - 1/100000*w71**3*(1 - 1/2*w71)  # a locked wheel slides
    left_over_left = ca.sqrt(1 - along_left**2)  # friction ellipse
    w72 = grip_left*ca.sqrt(V_y_left**2 + w15)
    w73 = 1/V_fade_left**2
    w74 = (V_y_left*w72*w73 + 1/1000000000000)/(V_y_left**2*w73 + 1/2000000000000)
    w75 = ca.fmax(0, ca.fmin(1, 50*brake_left - 50*w74))
    asked_left = V_y_left*((1/50)*w75**3*(3*w75**2 - 8*w75 + 6) + ca.fmax(0, brake_left - w74 - 1/50))/V_fade_left + w72/V_fade_left  # slip, or a locked wheel that slides
    w76 = left_over_left + 1/200000
    w77 = ca.fmax(-w76, ca.fmin(asked_left, w76))
    w80 = ca.fmax(0, -100000*left_over_left - 100000*w77 + 1/2)
    w81 = ca.fmax(0, -100000*left_over_left + 100000*w77 + 1/2)
    across_left = w77 + (1/100000)*w80**3*(1 - 1/2*w80) - 1/100000*w81**3*(1 - 1/2*w81)  # friction ellipse
    F_x_left = Fz_left*along_left*mu_left  # Eq. 3.11
    F_y_left = Fz_left*across_left*mu_left  # Eq. 3.11
    push_x_left = -F_x_left*ca.cos(toe) + F_y_left*ca.sin(toe)  # resolved
    push_y_left = -F_x_left*ca.sin(toe) - F_y_left*ca.cos(toe)  # resolved
    push_z_left = 0  # resolved
    V_x_right = -w12 + (u - w3)*ca.cos(toe)  # Eq. 4.10 at the contact
    V_y_right = w11*ca.cos(toe) + (u - w3)*ca.sin(toe)  # Eq. 4.10
    w85 = V_x_right**2 + w14
    tan_alpha_right = V_y_right/ca.sqrt(w85)  # Eq. 4.13, at any speed
    alpha_right = ca.atan(tan_alpha_right)  # Eq. 4.13
    V2_fade_right = ca.sqrt(v_rest**4 + (V_x_right**2 + V_y_right**2)**2)  # near rest
    V_fade_right = ca.sqrt(V2_fade_right)  # near rest
    Fz_right = w57  # balance of weight and lift
    C_c_right = ca.fmax(0, B3 + C3*Fz_right)  # Eq. 3.3, never below 0
    mu_right = surface_right*ca.fmax(1/1000, B5 + C5*Fz_right)  # Eq. 3.5, never below a thousandth
    alpha_free_right = C_c_right*tan_alpha_right/mu_right  # Eq. 3.6
    alpha_bar_right = ca.fmax(-w61, ca.fmin(alpha_free_right, w61))  # held at the peak
    psi_bar_right = alpha_bar_right*(1 - E1) + E1*ca.atan(B1*alpha_bar_right)/B1  # Eq. 3.10
    theta_bar_right = C1*ca.atan(B1*psi_bar_right)  # Eq. 3.9
    F_bar_right = D1*ca.sin(theta_bar_right)  # Eq. 3.8
    grip_right = F_bar_right  # Eq. 3.7
    braked_right = (brake_right*(mu_right - mu_roll_right) + mu_roll_right)/mu_right  # brake
    w88 = braked_right + 1/200000
    w90 = ca.fmax(-w88, ca.fmin(w88, V_x_right/V_fade_right))
    w93 = ca.fmax(0, -100000*braked_right - 100000*w90 + 1/2)
    w94 = ca.fmax(0, -100000*braked_right + 100000*w90 + 1/2)
    along_right = w90 + (1/100000)*w93**3*(1 - 1/2*w93) - 1/100000*w94**3*(1 - 1/2*w94)  # a locked wheel slides
    left_over_right = ca.sqrt(1 - along_right**2)  # friction ellipse
    w95 = grip_right*ca.sqrt(V_y_right**2 + w85)
    w96 = 1/V_fade_right**2
    w97 = (V_y_right*w95*w96 + 1/1000000000000)/(V_y_right**2*w96 + 1/2000000000000)
    w98 = ca.fmax(0, ca.fmin(1, 50*brake_right - 50*w97))
    asked_right = V_y_right*((1/50)*w98**3*(3*w98**2 - 8*w98 + 6) + ca.fmax(0, brake_right - w97 - 1/50))/V_fade_right + w95/V_fade_right  # slip, or a locked wheel that slides
    w99 = left_over_right + 1/200000
    w100 = ca.fmax(-w99, ca.fmin(asked_right, w99))
    w103 = ca.fmax(0, -100000*left_over_right - 100000*w100 + 1/2)
    w104 = ca.fmax(0, -100000*left_over_right + 100000*w100 + 1/2)
    across_right = w100 + (1/100000)*w103**3*(1 - 1/2*w103) - 1/100000*w104**3*(1 - 1/2*w104)  # friction ellipse
    F_x_right = Fz_right*along_right*mu_right  # Eq. 3.11
    F_y_right = Fz_right*across_right*mu_right  # Eq. 3.11
    push_x_right = -F_x_right*ca.cos(toe) - F_y_right*ca.sin(toe)  # resolved
    push_y_right = F_x_right*ca.sin(toe) - F_y_right*ca.cos(toe)  # resolved
    push_z_right = 0  # resolved
    commanded_third = pedal*steering_ratio + steering  # linkage
    delta_third = commanded_third*(1 - swivels)  # linkage
    w109 = r*(w43 + w44) + v
    V_x_third = u*ca.cos(delta_third) + w109*ca.sin(delta_third)  # Eq. 4.10 at the contact
    V_y_third = -u*ca.sin(delta_third) + w109*ca.cos(delta_third)  # Eq. 4.10
    w111 = V_x_third**2 + w14
    tan_alpha_third = V_y_third/ca.sqrt(w111)  # Eq. 4.13, at any speed
    alpha_third = ca.atan(tan_alpha_third)  # Eq. 4.13
    V2_fade_third = ca.sqrt(v_rest**4 + (V_x_third**2 + V_y_third**2)**2)  # near rest
    V_fade_third = ca.sqrt(V2_fade_third)  # near rest
    Fz_third = ca.fmax(0, -(-w52*(w7 + w9) - w56)/w45)  # balance of weight and lift
    C_c_third = ca.fmax(0, B3_third + C3_third*Fz_third)  # Eq. 3.3, never below 0
    mu_third = surface_third*ca.fmax(1/1000, B5_third + C5_third*Fz_third)  # Eq. 3.5, never below a thousandth
    alpha_free_third = C_c_third*tan_alpha_third/mu_third  # Eq. 3.6
    w116 = 1/(B1_third*ca.sqrt(ca.fmax(1/1000000000000, E1_third - 1)))
    alpha_bar_third = ca.fmax(-w116, ca.fmin(alpha_free_third, w116))  # held at the peak
    psi_bar_third = -alpha_bar_third*(E1_third - 1) + E1_third*ca.atan(B1_third*alpha_bar_third)/B1_third  # Eq. 3.10
    theta_bar_third = C1_third*ca.atan(B1_third*psi_bar_third)  # Eq. 3.9
    F_bar_third = D1_third*ca.sin(theta_bar_third)  # Eq. 3.8
    grip_third = F_bar_third  # Eq. 3.7
    braked_third = mu_roll_third/mu_third  # brake
    w117 = braked_third + 1/200000
    w119 = ca.fmax(-w117, ca.fmin(w117, V_x_third/V_fade_third))
    w122 = ca.fmax(0, -100000*braked_third - 100000*w119 + 1/2)
    w123 = ca.fmax(0, -100000*braked_third + 100000*w119 + 1/2)
    along_third = w119 + (1/100000)*w122**3*(1 - 1/2*w122) - 1/100000*w123**3*(1 - 1/2*w123)  # a locked wheel slides
    left_over_third = ca.sqrt(1 - along_third**2)  # friction ellipse
    asked_third = grip_third*ca.sqrt(V_y_third**2 + w111)/V_fade_third  # slip
    w124 = left_over_third + 1/200000
    w125 = ca.fmax(-w124, ca.fmin(asked_third, w124))
    w128 = ca.fmax(0, -100000*left_over_third - 100000*w125 + 1/2)
    w129 = ca.fmax(0, -100000*left_over_third + 100000*w125 + 1/2)
    across_third = w125 + (1/100000)*w128**3*(1 - 1/2*w128) - 1/100000*w129**3*(1 - 1/2*w129)  # friction ellipse
    F_x_third = Fz_third*along_third*mu_third  # Eq. 3.11
    F_y_third = Fz_third*across_third*mu_third*(1 - swivels)  # Eq. 3.11
    push_x_third = -F_x_third*ca.cos(delta_third) + F_y_third*ca.sin(delta_third)  # resolved
    push_y_third = -F_x_third*ca.sin(delta_third) - F_y_third*ca.cos(delta_third)  # resolved
    push_z_third = 0  # resolved
    sideslip = ca.atan2(v_air, V_plane)  # angle of sideslip
    w131 = -pedal*rudder_max + rudder
    deflected = w131  # linkage
    w132 = (1/4)*S_wing*V_air*r*rho
    Y_air = CY_r*b_wing*w132 + qS*(CY_beta*sideslip + CY_rudder*deflected)  # derivatives
    w134 = b_wing**2*w132
    L_air = Cl_r*w134 + b_wing*qS*(Cl_aileron*aileron + Cl_beta*sideslip)  # derivatives
    N_air = Cn_r*w134 + b_wing*qS*(Cn_aileron*aileron + Cn_beta*sideslip + Cn_rudder*deflected)  # derivatives
    V_axial_fin = u - wind_u  # Eq. 4.10 through the air
    w135 = V_axial_fin*ca.sqrt(V_axial_fin**2 + 0.001**2) + w24
    w136 = ca.fmax(0, ca.fmin(1, w135*w26))
    V_s_fin = ca.sqrt(0.001**2*w136**3*(3*w136**2 - 8*w136 + 6) + ca.fmax(0, w135 + w23) + 0.001**2)  # momentum theory
    w137 = b*ca.cos(theta_ground)
    w138 = z_fin*ca.sin(theta_ground) - w137
    V_side_fin = r*w138 + v - wind_v  # Eq. 4.10 through the air
    gamma_fin = ca.atan2(V_side_fin, V_s_fin)  # Eq. 4.19
    delta_rudder_fin = w131  # linkage
    w139 = CL_fin + 1/10
    w140 = ca.fmax(-w139, ca.fmin(w139, CL_gamma*(-delta_rudder_fin*tau_rudder + gamma_fin)))
    w143 = ca.fmax(0, -5*CL_fin - 5*w140 + 1/2)
    w144 = ca.fmax(0, -5*CL_fin + 5*w140 + 1/2)
    C_L_fin = w140 + (1/5)*w143**3*(1 - 1/2*w143) - 1/5*w144**3*(1 - 1/2*w144)  # stall
    F_L_fin = (1/2)*Ap*C_L_fin*fin_apart*rho*(V_s_fin**2 + V_side_fin**2)  # Eq. 4.29
    V_ground = ca.sqrt((u*ca.sin(psi) + v*ca.cos(psi))**2 + (u*ca.cos(psi) - v*ca.sin(psi))**2 + 1e-06**2)  # Eq. 4.3
    above_stop = V_ground - v_stop  # definition
    beyond_edge = -1/2*runway_width + ca.fabs(Y)  # definition
    beyond_loop = -psi_loop + ca.fabs(psi)  # definition
    sum_Fx = push_x_left + push_x_right + push_x_third + thrust - drag*u_air/V_plane + lift*w_air/V_plane  # Eq. 4.8
    sum_F = -F_L_fin + F_disturbance + Y_air + push_y_left + push_y_right + push_y_third  # Eq. 4.8
    sum_M = -F_L_fin*w138 - F_disturbance*w137 + N_air + (1/2)*push_x_left*track - 1/2*push_x_right*track + push_y_left*(w7 + w9) + push_y_right*(w7 + w9) + push_y_third*(w43 + w44)  # Eq. 4.8
    u_dot = r*v + sum_Fx/m  # Eq. 4.9
    v_dot = -r*u + sum_F/m  # Eq. 4.9
    a_x = -r*v + u_dot  # Eq. 4.7
    a_y = r*u + v_dot  # Eq. 4.7
    N_held = -F_L_tailplane + g*m + push_z_left + push_z_right + push_z_third - w49 - w51  # held balance
    w148 = a*ca.sin(theta_ground)
    w149 = a_third*ca.sin(theta_ground)
    Mx_held = -F_L_fin*b*ca.sin(theta_ground) - F_L_fin*z_fin*ca.cos(theta_ground) + F_disturbance*b*ca.sin(theta_ground) - L_air + push_y_left*z_main*ca.cos(theta_ground) - push_y_left*w148 + push_y_right*z_main*ca.cos(theta_ground) - push_y_right*w148 + push_y_third*z_third*ca.cos(theta_ground) - push_y_third*w149 + (1/2)*push_z_left*track - 1/2*push_z_right*track  # held balance
    w150 = z_main*ca.cos(theta_ground)
    My_held = -F_L_tailplane*w53 - F_L_tailplane*w54 - M_air + push_x_left*w148 - push_x_left*w150 + push_x_right*w148 - push_x_right*w150 - push_x_third*z_third*ca.cos(theta_ground) + push_x_third*w149 + push_z_left*w7 + push_z_left*w9 + push_z_right*w7 + push_z_right*w9 + push_z_third*w43 + push_z_third*w44 - w55  # held balance
    y_ = ca.vertcat(Fz_left, alpha_left, F_x_left, F_y_left, Fz_right, alpha_right, F_x_right, F_y_right, Fz_third, alpha_third, F_x_third, F_y_third, attack, sideslip, CL, lift, drag, Y_air, L_air, M_air, N_air, gamma_fin, C_L_fin, F_L_fin, gamma_tailplane, C_L_tailplane, F_L_tailplane, V_ground, sum_Fx, sum_F, sum_M, a_x, a_y, N_held, Mx_held, My_held, above_stop, beyond_edge, beyond_loop)
    return ca.Function(
        "rollout_outputs",
        [x_, u_, p_],
        [y_],
        ["x", "u", "p"],
        ["y"],
    )


@cache
def b_wing_follows() -> ca.Function:
    """Reference span (aspect ratio 7: Raymer Table 4.1, 6 to 7.6).

    Inputs
    ------
    S_wing : scalar [m^2], reference area

    Outputs
    -------
    b_wing : 1 x 1, reference span [m]
    """
    S_wing = ca.SX.sym("S_wing")
    b_wing = ca.sqrt(7)*ca.sqrt(S_wing)  # aspect ratio 7: Raymer Table 4.1, 6 to 7.6
    return ca.Function(
        "b_wing_follows",
        [S_wing],
        [b_wing],
        ["S_wing"],
        ["b_wing"],
    )


@cache
def c_wing_follows() -> ca.Function:
    """Reference chord (geometry).

    Inputs
    ------
    b_wing : scalar [m], reference span
    S_wing : scalar [m^2], reference area

    Outputs
    -------
    c_wing : 1 x 1, reference chord [m]
    """
    b_wing = ca.SX.sym("b_wing")
    S_wing = ca.SX.sym("S_wing")
    c_wing = S_wing/b_wing  # geometry
    return ca.Function(
        "c_wing_follows",
        [b_wing, S_wing],
        [c_wing],
        ["b_wing", "S_wing"],
        ["c_wing"],
    )


@cache
def CL_alpha_follows() -> ca.Function:
    """Lift by angle of attack (Helmbold).

    Inputs
    ------
    b_wing : scalar [m], reference span
    S_wing : scalar [m^2], reference area

    Outputs
    -------
    CL_alpha : 1 x 1, lift by angle of attack [1/rad]
    """
    b_wing = ca.SX.sym("b_wing")
    S_wing = ca.SX.sym("S_wing")
    aspect = b_wing**2/S_wing  # definition
    CL_alpha = 6.28318530717959*aspect/(ca.sqrt(aspect**2 + 4) + 2)  # Helmbold
    return ca.Function(
        "CL_alpha_follows",
        [b_wing, S_wing],
        [CL_alpha],
        ["b_wing", "S_wing"],
        ["CL_alpha"],
    )


@cache
def CL_0_follows() -> ca.Function:
    """Lift coefficient at no attitude, flaps as set (cambered aerofoil, flaps up: NACA 2412 to 4412).

    Inputs
    ------

    Outputs
    -------
    CL_0 : 1 x 1, lift coefficient at no attitude, flaps as set [1]
    """
    CL_0 = 3/10  # cambered aerofoil, flaps up: NACA 2412 to 4412
    return ca.Function(
        "CL_0_follows",
        [],
        [CL_0],
        [],
        ["CL_0"],
    )


@cache
def CL_max_follows() -> ca.Function:
    """Lift coefficient at which the wing stalls (usual, flaps up).

    Inputs
    ------

    Outputs
    -------
    CL_max : 1 x 1, lift coefficient at which the wing stalls [1]
    """
    CL_max = 3/2  # usual, flaps up
    return ca.Function(
        "CL_max_follows",
        [],
        [CL_max],
        [],
        ["CL_max"],
    )


@cache
def CD_0_follows() -> ca.Function:
    """Drag coefficient at no lift (usual with a fixed gear).

    Inputs
    ------

    Outputs
    -------
    CD_0 : 1 x 1, drag coefficient at no lift [1]
    """
    CD_0 = 7/200  # usual with a fixed gear
    return ca.Function(
        "CD_0_follows",
        [],
        [CD_0],
        [],
        ["CD_0"],
    )


@cache
def K_drag_follows() -> ca.Function:
    """Drag over lift squared (Oswald factor 0.8).

    Inputs
    ------
    b_wing : scalar [m], reference span
    S_wing : scalar [m^2], reference area

    Outputs
    -------
    K_drag : 1 x 1, drag over lift squared [1]
    """
    b_wing = ca.SX.sym("b_wing")
    S_wing = ca.SX.sym("S_wing")
    aspect = b_wing**2/S_wing  # definition
    K_drag = 0.397887357729738/aspect  # Oswald factor 0.8
    return ca.Function(
        "K_drag_follows",
        [b_wing, S_wing],
        [K_drag],
        ["b_wing", "S_wing"],
        ["K_drag"],
    )


@cache
def Cl_p_follows() -> ca.Function:
    """Roll by roll rate, p span/2V (strip theory, rectangular wing).

    Inputs
    ------
    CL_alpha : scalar [1/rad], lift by angle of attack

    Outputs
    -------
    Cl_p : 1 x 1, roll by roll rate, p span/2V [1/rad]
    """
    CL_alpha = ca.SX.sym("CL_alpha")
    Cl_p = -1/6*CL_alpha  # strip theory, rectangular wing
    return ca.Function(
        "Cl_p_follows",
        [CL_alpha],
        [Cl_p],
        ["CL_alpha"],
        ["Cl_p"],
    )


@cache
def Cl_r_follows() -> ca.Function:
    """Roll by yaw rate, r span/2V (strip theory, rectangular wing).

    Inputs
    ------
    CL_0 : scalar [1], lift coefficient at no attitude, flaps as set

    Outputs
    -------
    Cl_r : 1 x 1, roll by yaw rate, r span/2V [1/rad]
    """
    CL_0 = ca.SX.sym("CL_0")
    Cl_r = (1/3)*CL_0  # strip theory, rectangular wing
    return ca.Function(
        "Cl_r_follows",
        [CL_0],
        [Cl_r],
        ["CL_0"],
        ["Cl_r"],
    )


@cache
def Cl_beta_follows() -> ca.Function:
    """Roll by sideslip (strip theory, rectangular wing, dihedral 3 deg).

    Inputs
    ------
    CL_alpha : scalar [1/rad], lift by angle of attack

    Outputs
    -------
    Cl_beta : 1 x 1, roll by sideslip [1/rad]
    """
    CL_alpha = ca.SX.sym("CL_alpha")
    Cl_beta = -0.0130899693899575*CL_alpha  # strip theory, rectangular wing, dihedral 3 deg
    return ca.Function(
        "Cl_beta_follows",
        [CL_alpha],
        [Cl_beta],
        ["CL_alpha"],
        ["Cl_beta"],
    )


@cache
def Cl_aileron_follows() -> ca.Function:
    """Roll by aileron (strip theory, rectangular wing, ailerons on 40 % of it).

    Inputs
    ------
    CL_alpha : scalar [1/rad], lift by angle of attack

    Outputs
    -------
    Cl_aileron : 1 x 1, roll by aileron [1/rad]
    """
    CL_alpha = ca.SX.sym("CL_alpha")
    Cl_aileron = (3/50)*CL_alpha  # strip theory, rectangular wing, ailerons on 40 % of it
    return ca.Function(
        "Cl_aileron_follows",
        [CL_alpha],
        [Cl_aileron],
        ["CL_alpha"],
        ["Cl_aileron"],
    )


@cache
def Cm_0_follows() -> ca.Function:
    """Pitch at no angle of attack (NACA 2412).

    Inputs
    ------

    Outputs
    -------
    Cm_0 : 1 x 1, pitch at no angle of attack [1]
    """
    Cm_0 = -1/20  # NACA 2412
    return ca.Function(
        "Cm_0_follows",
        [],
        [Cm_0],
        [],
        ["Cm_0"],
    )


@cache
def Cm_alpha_follows() -> ca.Function:
    """Pitch by angle of attack (CG at the wing's aerodynamic centre).

    Inputs
    ------

    Outputs
    -------
    Cm_alpha : 1 x 1, pitch by angle of attack [1/rad]
    """
    Cm_alpha = 0  # CG at the wing's aerodynamic centre
    return ca.Function(
        "Cm_alpha_follows",
        [],
        [Cm_alpha],
        [],
        ["Cm_alpha"],
    )


@cache
def Cm_q_follows() -> ca.Function:
    """Pitch by pitch rate, q chord/2V (none but the fin's and the tailplane's, which are apart).

    Inputs
    ------

    Outputs
    -------
    Cm_q : 1 x 1, pitch by pitch rate, q chord/2V [1/rad]
    """
    Cm_q = 0  # none but the fin's and the tailplane's, which are apart
    return ca.Function(
        "Cm_q_follows",
        [],
        [Cm_q],
        [],
        ["Cm_q"],
    )


@cache
def Cm_elevator_follows() -> ca.Function:
    """Pitch by elevator (none but the fin's and the tailplane's, which are apart).

    Inputs
    ------

    Outputs
    -------
    Cm_elevator : 1 x 1, pitch by elevator [1/rad]
    """
    Cm_elevator = 0  # none but the fin's and the tailplane's, which are apart
    return ca.Function(
        "Cm_elevator_follows",
        [],
        [Cm_elevator],
        [],
        ["Cm_elevator"],
    )


@cache
def CY_beta_follows() -> ca.Function:
    """Side force by sideslip (none but the fin's and the tailplane's, which are apart).

    Inputs
    ------

    Outputs
    -------
    CY_beta : 1 x 1, side force by sideslip [1/rad]
    """
    CY_beta = 0  # none but the fin's and the tailplane's, which are apart
    return ca.Function(
        "CY_beta_follows",
        [],
        [CY_beta],
        [],
        ["CY_beta"],
    )


@cache
def CY_r_follows() -> ca.Function:
    """Side force by yaw rate, r span/2V (none but the fin's and the tailplane's, which are apart).

    Inputs
    ------

    Outputs
    -------
    CY_r : 1 x 1, side force by yaw rate, r span/2V [1/rad]
    """
    CY_r = 0  # none but the fin's and the tailplane's, which are apart
    return ca.Function(
        "CY_r_follows",
        [],
        [CY_r],
        [],
        ["CY_r"],
    )


@cache
def CY_rudder_follows() -> ca.Function:
    """Side force by rudder (none but the fin's and the tailplane's, which are apart).

    Inputs
    ------

    Outputs
    -------
    CY_rudder : 1 x 1, side force by rudder [1/rad]
    """
    CY_rudder = 0  # none but the fin's and the tailplane's, which are apart
    return ca.Function(
        "CY_rudder_follows",
        [],
        [CY_rudder],
        [],
        ["CY_rudder"],
    )


@cache
def Cn_beta_follows() -> ca.Function:
    """Yaw by sideslip (none but the fin's and the tailplane's, which are apart).

    Inputs
    ------

    Outputs
    -------
    Cn_beta : 1 x 1, yaw by sideslip [1/rad]
    """
    Cn_beta = 0  # none but the fin's and the tailplane's, which are apart
    return ca.Function(
        "Cn_beta_follows",
        [],
        [Cn_beta],
        [],
        ["Cn_beta"],
    )


@cache
def Cn_r_follows() -> ca.Function:
    """Yaw by yaw rate, r span/2V (none but the fin's and the tailplane's, which are apart).

    Inputs
    ------

    Outputs
    -------
    Cn_r : 1 x 1, yaw by yaw rate, r span/2V [1/rad]
    """
    Cn_r = 0  # none but the fin's and the tailplane's, which are apart
    return ca.Function(
        "Cn_r_follows",
        [],
        [Cn_r],
        [],
        ["Cn_r"],
    )


@cache
def Cn_rudder_follows() -> ca.Function:
    """Yaw by rudder (none but the fin's and the tailplane's, which are apart).

    Inputs
    ------

    Outputs
    -------
    Cn_rudder : 1 x 1, yaw by rudder [1/rad]
    """
    Cn_rudder = 0  # none but the fin's and the tailplane's, which are apart
    return ca.Function(
        "Cn_rudder_follows",
        [],
        [Cn_rudder],
        [],
        ["Cn_rudder"],
    )


@cache
def Cn_aileron_follows() -> ca.Function:
    """Yaw by aileron (none but the fin's and the tailplane's, which are apart).

    Inputs
    ------

    Outputs
    -------
    Cn_aileron : 1 x 1, yaw by aileron [1/rad]
    """
    Cn_aileron = 0  # none but the fin's and the tailplane's, which are apart
    return ca.Function(
        "Cn_aileron_follows",
        [],
        [Cn_aileron],
        [],
        ["Cn_aileron"],
    )


@cache
def theta_ground_follows() -> ca.Function:
    """Pitch, on three wheels, of the axes in which stations are measured; nose up (stations are measured as it stands).

    Inputs
    ------

    Outputs
    -------
    theta_ground : 1 x 1, pitch, on three wheels, of the axes in which stations are measured; nose up [rad]
    """
    theta_ground = 0  # stations are measured as it stands
    return ca.Function(
        "theta_ground_follows",
        [],
        [theta_ground],
        [],
        ["theta_ground"],
    )


@cache
def h_cg_follows() -> ca.Function:
    """The CG above the ground, in the attitude in which stations are measured (0.20 of it: J-3, Cessna 170; 0.22: Cessna 172).

    Inputs
    ------
    b : scalar [m], CG ahead of the vertical tail and the tail wheel

    Outputs
    -------
    h_cg : 1 x 1, the CG above the ground, in the attitude in which stations are measured [m]
    """
    b = ca.SX.sym("b")
    h_cg = (1/5)*b  # 0.20 of it: J-3, Cessna 170; 0.22: Cessna 172
    return ca.Function(
        "h_cg_follows",
        [b],
        [h_cg],
        ["b"],
        ["h_cg"],
    )


@cache
def a_third_follows() -> ca.Function:
    """Third wheel ahead of the CG; negative: a tail wheel (below the fin, as in the thesis).

    Inputs
    ------
    b : scalar [m], CG ahead of the vertical tail and the tail wheel

    Outputs
    -------
    a_third : 1 x 1, third wheel ahead of the CG; negative: a tail wheel [m]
    """
    b = ca.SX.sym("b")
    a_third = -b  # below the fin, as in the thesis
    return ca.Function(
        "a_third_follows",
        [b],
        [a_third],
        ["b"],
        ["a_third"],
    )


@cache
def sag_main_follows() -> ca.Function:
    """Of a main leg at rest (usual, 0.08 to 0.1 m).

    Inputs
    ------

    Outputs
    -------
    sag_main : 1 x 1, of a main leg at rest [m]
    """
    sag_main = 0.09  # usual, 0.08 to 0.1 m
    return ca.Function(
        "sag_main_follows",
        [],
        [sag_main],
        [],
        ["sag_main"],
    )


@cache
def sag_third_follows() -> ca.Function:
    """Of the third leg at rest (usual, half of the main legs').

    Inputs
    ------

    Outputs
    -------
    sag_third : 1 x 1, of the third leg at rest [m]
    """
    sag_third = 0.05  # usual, half of the main legs'
    return ca.Function(
        "sag_third_follows",
        [],
        [sag_third],
        [],
        ["sag_third"],
    )


@cache
def zeta_leg_follows() -> ca.Function:
    """Of a leg with the mass it carries (usual of a spring leg).

    Inputs
    ------

    Outputs
    -------
    zeta_leg : 1 x 1, of a leg with the mass it carries [1]
    """
    zeta_leg = 3/20  # usual of a spring leg
    return ca.Function(
        "zeta_leg_follows",
        [],
        [zeta_leg],
        [],
        ["zeta_leg"],
    )


@cache
def z_main_follows() -> ca.Function:
    """Contact of a main wheel below the CG, leg unloaded (geometry).

    Inputs
    ------
    h_cg : scalar [m], the CG above the ground, in the attitude in which stations are measured
    sag_main : scalar [m], of a main leg at rest

    Outputs
    -------
    z_main : 1 x 1, contact of a main wheel below the CG, leg unloaded [m]
    """
    h_cg = ca.SX.sym("h_cg")
    sag_main = ca.SX.sym("sag_main")
    z_main = h_cg + sag_main  # geometry
    return ca.Function(
        "z_main_follows",
        [h_cg, sag_main],
        [z_main],
        ["h_cg", "sag_main"],
        ["z_main"],
    )


@cache
def z_third_follows() -> ca.Function:
    """Contact of the third wheel below the CG, leg unloaded (geometry).

    Inputs
    ------
    theta_ground : scalar [rad], pitch, on three wheels, of the axes in which stations are measured; nose up
    h_cg : scalar [m], the CG above the ground, in the attitude in which stations are measured
    a_third : scalar [m], third wheel ahead of the CG; negative: a tail wheel
    sag_third : scalar [m], of the third leg at rest
    a : scalar [m], main gear ahead of the CG (positive: taildragger)

    Outputs
    -------
    z_third : 1 x 1, contact of the third wheel below the CG, leg unloaded [m]
    """
    theta_ground = ca.SX.sym("theta_ground")
    h_cg = ca.SX.sym("h_cg")
    a_third = ca.SX.sym("a_third")
    sag_third = ca.SX.sym("sag_third")
    a = ca.SX.sym("a")
    z_third = h_cg + sag_third - (a - a_third)*ca.tan(theta_ground)  # geometry
    return ca.Function(
        "z_third_follows",
        [theta_ground, h_cg, a_third, sag_third, a],
        [z_third],
        ["theta_ground", "h_cg", "a_third", "sag_third", "a"],
        ["z_third"],
    )


@cache
def k_main_follows() -> ca.Function:
    """Of the leg of a main wheel, per stroke along the body's z axis (static deflection).

    Inputs
    ------
    theta_ground : scalar [rad], pitch, on three wheels, of the axes in which stations are measured; nose up
    a_third : scalar [m], third wheel ahead of the CG; negative: a tail wheel
    sag_main : scalar [m], of a main leg at rest
    sag_third : scalar [m], of the third leg at rest
    z_main : scalar [m], contact of a main wheel below the CG, leg unloaded
    z_third : scalar [m], contact of the third wheel below the CG, leg unloaded
    a : scalar [m], main gear ahead of the CG (positive: taildragger)
    g : scalar [m/s^2], acceleration due to gravity
    m : scalar [kg], total mass

    Outputs
    -------
    k_main : 1 x 1, of the leg of a main wheel, per stroke along the body's z axis [N/m]
    """
    theta_ground = ca.SX.sym("theta_ground")
    a_third = ca.SX.sym("a_third")
    sag_main = ca.SX.sym("sag_main")
    sag_third = ca.SX.sym("sag_third")
    z_main = ca.SX.sym("z_main")
    z_third = ca.SX.sym("z_third")
    a = ca.SX.sym("a")
    g = ca.SX.sym("g")
    m = ca.SX.sym("m")
    a_rest = a*ca.cos(theta_ground) + (-sag_main + z_main)*ca.sin(theta_ground)  # geometry
    x_rest = a_third*ca.cos(theta_ground) + (-sag_third + z_third)*ca.sin(theta_ground)  # geometry
    N_third = a_rest*g*m/(a_rest - x_rest)  # balance of moments
    N_main = -1/2*N_third + (1/2)*g*m  # balance of forces
    k_main = N_main/sag_main  # static deflection
    return ca.Function(
        "k_main_follows",
        [theta_ground, a_third, sag_main, sag_third, z_main, z_third, a, g, m],
        [k_main],
        ["theta_ground", "a_third", "sag_main", "sag_third", "z_main", "z_third", "a", "g", "m"],
        ["k_main"],
    )


@cache
def k_third_follows() -> ca.Function:
    """Of the leg of the third wheel, per stroke along the body's z axis (static deflection).

    Inputs
    ------
    theta_ground : scalar [rad], pitch, on three wheels, of the axes in which stations are measured; nose up
    a_third : scalar [m], third wheel ahead of the CG; negative: a tail wheel
    sag_main : scalar [m], of a main leg at rest
    sag_third : scalar [m], of the third leg at rest
    z_main : scalar [m], contact of a main wheel below the CG, leg unloaded
    z_third : scalar [m], contact of the third wheel below the CG, leg unloaded
    a : scalar [m], main gear ahead of the CG (positive: taildragger)
    g : scalar [m/s^2], acceleration due to gravity
    m : scalar [kg], total mass

    Outputs
    -------
    k_third : 1 x 1, of the leg of the third wheel, per stroke along the body's z axis [N/m]
    """
    theta_ground = ca.SX.sym("theta_ground")
    a_third = ca.SX.sym("a_third")
    sag_main = ca.SX.sym("sag_main")
    sag_third = ca.SX.sym("sag_third")
    z_main = ca.SX.sym("z_main")
    z_third = ca.SX.sym("z_third")
    a = ca.SX.sym("a")
    g = ca.SX.sym("g")
    m = ca.SX.sym("m")
    a_rest = a*ca.cos(theta_ground) + (-sag_main + z_main)*ca.sin(theta_ground)  # geometry
    x_rest = a_third*ca.cos(theta_ground) + (-sag_third + z_third)*ca.sin(theta_ground)  # geometry
    N_third = a_rest*g*m/(a_rest - x_rest)  # balance of moments
    k_third = N_third/sag_third  # static deflection
    return ca.Function(
        "k_third_follows",
        [theta_ground, a_third, sag_main, sag_third, z_main, z_third, a, g, m],
        [k_third],
        ["theta_ground", "a_third", "sag_main", "sag_third", "z_main", "z_third", "a", "g", "m"],
        ["k_third"],
    )


@cache
def c_main_follows() -> ca.Function:
    """Of the leg of a main wheel (damping ratio).

    Inputs
    ------
    theta_ground : scalar [rad], pitch, on three wheels, of the axes in which stations are measured; nose up
    a_third : scalar [m], third wheel ahead of the CG; negative: a tail wheel
    sag_main : scalar [m], of a main leg at rest
    sag_third : scalar [m], of the third leg at rest
    zeta_leg : scalar [1], of a leg with the mass it carries
    z_main : scalar [m], contact of a main wheel below the CG, leg unloaded
    z_third : scalar [m], contact of the third wheel below the CG, leg unloaded
    a : scalar [m], main gear ahead of the CG (positive: taildragger)
    g : scalar [m/s^2], acceleration due to gravity
    m : scalar [kg], total mass

    Outputs
    -------
    c_main : 1 x 1, of the leg of a main wheel [N s/m]
    """
    theta_ground = ca.SX.sym("theta_ground")
    a_third = ca.SX.sym("a_third")
    sag_main = ca.SX.sym("sag_main")
    sag_third = ca.SX.sym("sag_third")
    zeta_leg = ca.SX.sym("zeta_leg")
    z_main = ca.SX.sym("z_main")
    z_third = ca.SX.sym("z_third")
    a = ca.SX.sym("a")
    g = ca.SX.sym("g")
    m = ca.SX.sym("m")
    a_rest = a*ca.cos(theta_ground) + (-sag_main + z_main)*ca.sin(theta_ground)  # geometry
    x_rest = a_third*ca.cos(theta_ground) + (-sag_third + z_third)*ca.sin(theta_ground)  # geometry
    N_third = a_rest*g*m/(a_rest - x_rest)  # balance of moments
    N_main = -1/2*N_third + (1/2)*g*m  # balance of forces
    c_main = 2*N_main*zeta_leg/(ca.sqrt(g)*ca.sqrt(sag_main))  # damping ratio
    return ca.Function(
        "c_main_follows",
        [theta_ground, a_third, sag_main, sag_third, zeta_leg, z_main, z_third, a, g, m],
        [c_main],
        ["theta_ground", "a_third", "sag_main", "sag_third", "zeta_leg", "z_main", "z_third", "a", "g", "m"],
        ["c_main"],
    )


@cache
def c_third_follows() -> ca.Function:
    """Of the leg of the third wheel (damping ratio).

    Inputs
    ------
    theta_ground : scalar [rad], pitch, on three wheels, of the axes in which stations are measured; nose up
    a_third : scalar [m], third wheel ahead of the CG; negative: a tail wheel
    sag_main : scalar [m], of a main leg at rest
    sag_third : scalar [m], of the third leg at rest
    zeta_leg : scalar [1], of a leg with the mass it carries
    z_main : scalar [m], contact of a main wheel below the CG, leg unloaded
    z_third : scalar [m], contact of the third wheel below the CG, leg unloaded
    a : scalar [m], main gear ahead of the CG (positive: taildragger)
    g : scalar [m/s^2], acceleration due to gravity
    m : scalar [kg], total mass

    Outputs
    -------
    c_third : 1 x 1, of the leg of the third wheel [N s/m]
    """
    theta_ground = ca.SX.sym("theta_ground")
    a_third = ca.SX.sym("a_third")
    sag_main = ca.SX.sym("sag_main")
    sag_third = ca.SX.sym("sag_third")
    zeta_leg = ca.SX.sym("zeta_leg")
    z_main = ca.SX.sym("z_main")
    z_third = ca.SX.sym("z_third")
    a = ca.SX.sym("a")
    g = ca.SX.sym("g")
    m = ca.SX.sym("m")
    a_rest = a*ca.cos(theta_ground) + (-sag_main + z_main)*ca.sin(theta_ground)  # geometry
    x_rest = a_third*ca.cos(theta_ground) + (-sag_third + z_third)*ca.sin(theta_ground)  # geometry
    N_third = a_rest*g*m/(a_rest - x_rest)  # balance of moments
    c_third = 2*N_third*zeta_leg/(ca.sqrt(g)*ca.sqrt(sag_third))  # damping ratio
    return ca.Function(
        "c_third_follows",
        [theta_ground, a_third, sag_main, sag_third, zeta_leg, z_main, z_third, a, g, m],
        [c_third],
        ["theta_ground", "a_third", "sag_main", "sag_third", "zeta_leg", "z_main", "z_third", "a", "g", "m"],
        ["c_third"],
    )


@cache
def track_follows() -> ca.Function:
    """Left to right main wheel (0.17: J-3; 0.20 to 0.23: Cessna 172).

    Inputs
    ------
    b_wing : scalar [m], reference span

    Outputs
    -------
    track : 1 x 1, left to right main wheel [m]
    """
    b_wing = ca.SX.sym("b_wing")
    track = (1/5)*b_wing  # 0.17: J-3; 0.20 to 0.23: Cessna 172
    return ca.Function(
        "track_follows",
        [b_wing],
        [track],
        ["b_wing"],
        ["track"],
    )


@cache
def toe_follows() -> ca.Function:
    """Of each main wheel, toward the nose of the aircraft (wheels set parallel).

    Inputs
    ------

    Outputs
    -------
    toe : 1 x 1, of each main wheel, toward the nose of the aircraft [rad]
    """
    toe = 0  # wheels set parallel
    return ca.Function(
        "toe_follows",
        [],
        [toe],
        [],
        ["toe"],
    )


@cache
def swivels_follows() -> ca.Function:
    """1 if the third wheel is free to turn, else 0 (fixed, or steered by the pedal).

    Inputs
    ------

    Outputs
    -------
    swivels : 1 x 1, 1 if the third wheel is free to turn, else 0 [1]
    """
    swivels = 0  # fixed, or steered by the pedal
    return ca.Function(
        "swivels_follows",
        [],
        [swivels],
        [],
        ["swivels"],
    )


@cache
def steering_ratio_follows() -> ca.Function:
    """Angle of the third wheel at full right pedal, clockwise seen from above: positive for a nose wheel, negative for a tail wheel (usual of tail wheels; Cessna 172's nose wheel).

    Inputs
    ------
    a_third : scalar [m], third wheel ahead of the CG; negative: a tail wheel

    Outputs
    -------
    steering_ratio : 1 x 1, angle of the third wheel at full right pedal, clockwise seen from above: positive for a nose wheel, negative for a tail wheel [rad]
    """
    a_third = ca.SX.sym("a_third")
    steering_ratio = ca.if_else(a_third < 0, -0.349065850398866, 0.174532925199433)  # usual of tail wheels; Cessna 172's nose wheel
    return ca.Function(
        "steering_ratio_follows",
        [a_third],
        [steering_ratio],
        ["a_third"],
        ["steering_ratio"],
    )


@cache
def k_swivel_follows() -> ca.Function:
    """Of the steering springs; 0: the wheel casters (without springs).

    Inputs
    ------

    Outputs
    -------
    k_swivel : 1 x 1, of the steering springs; 0: the wheel casters [N m/rad]
    """
    k_swivel = 0  # without springs
    return ca.Function(
        "k_swivel_follows",
        [],
        [k_swivel],
        [],
        ["k_swivel"],
    )


@cache
def I_swivel_follows() -> ca.Function:
    """Of what swivels, about its pivot (3 kg of fork and wheel).

    Inputs
    ------

    Outputs
    -------
    I_swivel : 1 x 1, of what swivels, about its pivot [kg m^2]
    """
    I_swivel = 0.02  # 3 kg of fork and wheel
    return ca.Function(
        "I_swivel_follows",
        [],
        [I_swivel],
        [],
        ["I_swivel"],
    )


@cache
def c_swivel_follows() -> ca.Function:
    """Couple over swivel rate: friction, shimmy damper (estimate).

    Inputs
    ------

    Outputs
    -------
    c_swivel : 1 x 1, couple over swivel rate: friction, shimmy damper [N m s/rad]
    """
    c_swivel = 0.5  # estimate
    return ca.Function(
        "c_swivel_follows",
        [],
        [c_swivel],
        [],
        ["c_swivel"],
    )


@cache
def trail_follows() -> ca.Function:
    """Contact behind the pivot, on the ground (estimate).

    Inputs
    ------

    Outputs
    -------
    trail : 1 x 1, contact behind the pivot, on the ground [m]
    """
    trail = 0.05  # estimate
    return ca.Function(
        "trail_follows",
        [],
        [trail],
        [],
        ["trail"],
    )


@cache
def break_out_follows() -> ca.Function:
    """Of the springs, where they let go (usual of tail wheels that let go).

    Inputs
    ------

    Outputs
    -------
    break_out : 1 x 1, of the springs, where they let go [rad]
    """
    break_out = 0.523598775598299  # usual of tail wheels that let go
    return ca.Function(
        "break_out_follows",
        [],
        [break_out],
        [],
        ["break_out"],
    )


@cache
def stop_follows() -> ca.Function:
    """Angle of the stops of the swivel (it turns all the way round).

    Inputs
    ------

    Outputs
    -------
    stop : 1 x 1, angle of the stops of the swivel [rad]
    """
    stop = 6.28318530717959  # it turns all the way round
    return ca.Function(
        "stop_follows",
        [],
        [stop],
        [],
        ["stop"],
    )


@cache
def k_stop_follows() -> ca.Function:
    """Of the stops of the swivel (without stops).

    Inputs
    ------

    Outputs
    -------
    k_stop : 1 x 1, of the stops of the swivel [N m/rad]
    """
    k_stop = 0  # without stops
    return ca.Function(
        "k_stop_follows",
        [],
        [k_stop],
        [],
        ["k_stop"],
    )


@cache
def surface_left_follows() -> ca.Function:
    """Friction on the runway under the left wheel over that on a dry one (dry runway).

    Inputs
    ------

    Outputs
    -------
    surface_left : 1 x 1, friction on the runway under the left wheel over that on a dry one [1]
    """
    surface_left = 1  # dry runway
    return ca.Function(
        "surface_left_follows",
        [],
        [surface_left],
        [],
        ["surface_left"],
    )


@cache
def surface_right_follows() -> ca.Function:
    """Friction on the runway under the right wheel over that on a dry one (dry runway).

    Inputs
    ------

    Outputs
    -------
    surface_right : 1 x 1, friction on the runway under the right wheel over that on a dry one [1]
    """
    surface_right = 1  # dry runway
    return ca.Function(
        "surface_right_follows",
        [],
        [surface_right],
        [],
        ["surface_right"],
    )


@cache
def surface_third_follows() -> ca.Function:
    """Friction on the runway under the third wheel over that on a dry one (dry runway).

    Inputs
    ------

    Outputs
    -------
    surface_third : 1 x 1, friction on the runway under the third wheel over that on a dry one [1]
    """
    surface_third = 1  # dry runway
    return ca.Function(
        "surface_third_follows",
        [],
        [surface_third],
        [],
        ["surface_third"],
    )


@cache
def mu_roll_left_follows() -> ca.Function:
    """Rolling resistance over load, left wheel (on concrete; JSBSim, Raymer Table 17.1).

    Inputs
    ------

    Outputs
    -------
    mu_roll_left : 1 x 1, rolling resistance over load, left wheel [1]
    """
    mu_roll_left = 1/50  # on concrete; JSBSim, Raymer Table 17.1
    return ca.Function(
        "mu_roll_left_follows",
        [],
        [mu_roll_left],
        [],
        ["mu_roll_left"],
    )


@cache
def mu_roll_right_follows() -> ca.Function:
    """Rolling resistance over load, right wheel (on concrete; JSBSim, Raymer Table 17.1).

    Inputs
    ------

    Outputs
    -------
    mu_roll_right : 1 x 1, rolling resistance over load, right wheel [1]
    """
    mu_roll_right = 1/50  # on concrete; JSBSim, Raymer Table 17.1
    return ca.Function(
        "mu_roll_right_follows",
        [],
        [mu_roll_right],
        [],
        ["mu_roll_right"],
    )


@cache
def mu_roll_third_follows() -> ca.Function:
    """Rolling resistance over load, third wheel (on concrete; JSBSim, Raymer Table 17.1).

    Inputs
    ------

    Outputs
    -------
    mu_roll_third : 1 x 1, rolling resistance over load, third wheel [1]
    """
    mu_roll_third = 1/50  # on concrete; JSBSim, Raymer Table 17.1
    return ca.Function(
        "mu_roll_third_follows",
        [],
        [mu_roll_third],
        [],
        ["mu_roll_third"],
    )


@cache
def B3_third_follows() -> ca.Function:
    """Cornering coefficient at no load, third (the tire of the main wheels).

    Inputs
    ------
    B3 : scalar [1/rad], cornering coefficient at no load

    Outputs
    -------
    B3_third : 1 x 1, cornering coefficient at no load, third [1/rad]
    """
    B3 = ca.SX.sym("B3")
    B3_third = B3  # the tire of the main wheels
    return ca.Function(
        "B3_third_follows",
        [B3],
        [B3_third],
        ["B3"],
        ["B3_third"],
    )


@cache
def C3_third_follows() -> ca.Function:
    """Its change with load, third (the tire of the main wheels).

    Inputs
    ------
    C3 : scalar [1/(rad N)], its change with load

    Outputs
    -------
    C3_third : 1 x 1, its change with load, third [1/(rad N)]
    """
    C3 = ca.SX.sym("C3")
    C3_third = C3  # the tire of the main wheels
    return ca.Function(
        "C3_third_follows",
        [C3],
        [C3_third],
        ["C3"],
        ["C3_third"],
    )


@cache
def B5_third_follows() -> ca.Function:
    """Friction coefficient at no load, third (the tire of the main wheels).

    Inputs
    ------
    B5 : scalar [1], friction coefficient at no load

    Outputs
    -------
    B5_third : 1 x 1, friction coefficient at no load, third [1]
    """
    B5 = ca.SX.sym("B5")
    B5_third = B5  # the tire of the main wheels
    return ca.Function(
        "B5_third_follows",
        [B5],
        [B5_third],
        ["B5"],
        ["B5_third"],
    )


@cache
def C5_third_follows() -> ca.Function:
    """Its change with load, third (the tire of the main wheels).

    Inputs
    ------
    C5 : scalar [1/N], its change with load

    Outputs
    -------
    C5_third : 1 x 1, its change with load, third [1/N]
    """
    C5 = ca.SX.sym("C5")
    C5_third = C5  # the tire of the main wheels
    return ca.Function(
        "C5_third_follows",
        [C5],
        [C5_third],
        ["C5"],
        ["C5_third"],
    )


@cache
def B1_third_follows() -> ca.Function:
    """Magic formula: stiffness factor, third (the tire of the main wheels).

    Inputs
    ------
    B1 : scalar [1], magic formula: stiffness factor

    Outputs
    -------
    B1_third : 1 x 1, magic formula: stiffness factor, third [1]
    """
    B1 = ca.SX.sym("B1")
    B1_third = B1  # the tire of the main wheels
    return ca.Function(
        "B1_third_follows",
        [B1],
        [B1_third],
        ["B1"],
        ["B1_third"],
    )


@cache
def C1_third_follows() -> ca.Function:
    """Magic formula: shape factor, third (the tire of the main wheels).

    Inputs
    ------
    C1 : scalar [1], magic formula: shape factor

    Outputs
    -------
    C1_third : 1 x 1, magic formula: shape factor, third [1]
    """
    C1 = ca.SX.sym("C1")
    C1_third = C1  # the tire of the main wheels
    return ca.Function(
        "C1_third_follows",
        [C1],
        [C1_third],
        ["C1"],
        ["C1_third"],
    )


@cache
def D1_third_follows() -> ca.Function:
    """Magic formula: peak factor, third (the tire of the main wheels).

    Inputs
    ------
    D1 : scalar [1], magic formula: peak factor

    Outputs
    -------
    D1_third : 1 x 1, magic formula: peak factor, third [1]
    """
    D1 = ca.SX.sym("D1")
    D1_third = D1  # the tire of the main wheels
    return ca.Function(
        "D1_third_follows",
        [D1],
        [D1_third],
        ["D1"],
        ["D1_third"],
    )


@cache
def E1_third_follows() -> ca.Function:
    """Magic formula: curvature factor, third (the tire of the main wheels).

    Inputs
    ------
    E1 : scalar [1], magic formula: curvature factor

    Outputs
    -------
    E1_third : 1 x 1, magic formula: curvature factor, third [1]
    """
    E1 = ca.SX.sym("E1")
    E1_third = E1  # the tire of the main wheels
    return ca.Function(
        "E1_third_follows",
        [E1],
        [E1_third],
        ["E1"],
        ["E1_third"],
    )


@cache
def length_follows() -> ca.Function:
    """Of the aircraft (Raymer, Aircraft Design, Section 6.5: tail arm).

    Inputs
    ------
    b : scalar [m], CG ahead of the vertical tail and the tail wheel

    Outputs
    -------
    length : 1 x 1, of the aircraft [m]
    """
    b = ca.SX.sym("b")
    length = (5/3)*b  # Raymer, Aircraft Design, Section 6.5: tail arm
    return ca.Function(
        "length_follows",
        [b],
        [length],
        ["b"],
        ["length"],
    )


@cache
def Ixx_follows() -> ca.Function:
    """Moment of inertia about the x axis (Raymer, Aircraft Design, radii of gyration: mean of high and low wing).

    Inputs
    ------
    b_wing : scalar [m], reference span
    m : scalar [kg], total mass

    Outputs
    -------
    Ixx : 1 x 1, moment of inertia about the x axis [kg m^2]
    """
    b_wing = ca.SX.sym("b_wing")
    m = ca.SX.sym("m")
    Ixx = (2401/160000)*b_wing**2*m  # Raymer, Aircraft Design, radii of gyration: mean of high and low wing
    return ca.Function(
        "Ixx_follows",
        [b_wing, m],
        [Ixx],
        ["b_wing", "m"],
        ["Ixx"],
    )


@cache
def Iyy_follows() -> ca.Function:
    """Moment of inertia about the y axis (Raymer, Aircraft Design, radii of gyration: mean of high and low wing).

    Inputs
    ------
    m : scalar [kg], total mass
    length : scalar [m], of the aircraft

    Outputs
    -------
    Iyy : 1 x 1, moment of inertia about the y axis [kg m^2]
    """
    m = ca.SX.sym("m")
    length = ca.SX.sym("length")
    Iyy = (134689/4000000)*length**2*m  # Raymer, Aircraft Design, radii of gyration: mean of high and low wing
    return ca.Function(
        "Iyy_follows",
        [m, length],
        [Iyy],
        ["m", "length"],
        ["Iyy"],
    )


@cache
def Izz_follows() -> ca.Function:
    """Moment of inertia about the z axis (Raymer, Aircraft Design, radii of gyration: mean of high and low wing).

    Inputs
    ------
    b_wing : scalar [m], reference span
    m : scalar [kg], total mass
    length : scalar [m], of the aircraft

    Outputs
    -------
    Izz : 1 x 1, moment of inertia about the z axis [kg m^2]
    """
    b_wing = ca.SX.sym("b_wing")
    m = ca.SX.sym("m")
    length = ca.SX.sym("length")
    Izz = m*((393/4000)*b_wing + (393/4000)*length)**2  # Raymer, Aircraft Design, radii of gyration: mean of high and low wing
    return ca.Function(
        "Izz_follows",
        [b_wing, m, length],
        [Izz],
        ["b_wing", "m", "length"],
        ["Izz"],
    )


@cache
def Ixz_follows() -> ca.Function:
    """Integral of x z over the mass (principal axes).

    Inputs
    ------

    Outputs
    -------
    Ixz : 1 x 1, integral of x z over the mass [kg m^2]
    """
    Ixz = 0  # principal axes
    return ca.Function(
        "Ixz_follows",
        [],
        [Ixz],
        [],
        ["Ixz"],
    )


@cache
def z_fin_follows() -> ca.Function:
    """Centre of the fin below the CG; negative: above (usual: half a metre above the CG).

    Inputs
    ------
    b : scalar [m], CG ahead of the vertical tail and the tail wheel

    Outputs
    -------
    z_fin : 1 x 1, centre of the fin below the CG; negative: above [m]
    """
    b = ca.SX.sym("b")
    z_fin = -1/10*b  # usual: half a metre above the CG
    return ca.Function(
        "z_fin_follows",
        [b],
        [z_fin],
        ["b"],
        ["z_fin"],
    )


@cache
def fin_apart_follows() -> ca.Function:
    """1: the derivatives leave the fin out; 0: they hold it (the derivatives leave the fin out).

    Inputs
    ------

    Outputs
    -------
    fin_apart : 1 x 1, 1: the derivatives leave the fin out; 0: they hold it [1]
    """
    fin_apart = 1  # the derivatives leave the fin out
    return ca.Function(
        "fin_apart_follows",
        [],
        [fin_apart],
        [],
        ["fin_apart"],
    )


@cache
def tailplane_apart_follows() -> ca.Function:
    """1: the derivatives leave the tailplane out (the derivatives leave the tailplane out).

    Inputs
    ------

    Outputs
    -------
    tailplane_apart : 1 x 1, 1: the derivatives leave the tailplane out [1]
    """
    tailplane_apart = 1  # the derivatives leave the tailplane out
    return ca.Function(
        "tailplane_apart_follows",
        [],
        [tailplane_apart],
        [],
        ["tailplane_apart"],
    )


@cache
def CL_fin_follows() -> ca.Function:
    """Lift coefficient at which it stalls (usual of low aspect ratio).

    Inputs
    ------

    Outputs
    -------
    CL_fin : 1 x 1, lift coefficient at which it stalls [1]
    """
    CL_fin = 1  # usual of low aspect ratio
    return ca.Function(
        "CL_fin_follows",
        [],
        [CL_fin],
        [],
        ["CL_fin"],
    )


@cache
def tau_rudder_follows() -> ca.Function:
    """Angle of the fin that a rudder's is worth (rudder of 0.3 of the chord).

    Inputs
    ------

    Outputs
    -------
    tau_rudder : 1 x 1, angle of the fin that a rudder's is worth [1]
    """
    tau_rudder = 1/2  # rudder of 0.3 of the chord
    return ca.Function(
        "tau_rudder_follows",
        [],
        [tau_rudder],
        [],
        ["tau_rudder"],
    )


@cache
def rudder_max_follows() -> ca.Function:
    """Deflection at full pedal (usual).

    Inputs
    ------

    Outputs
    -------
    rudder_max : 1 x 1, deflection at full pedal [rad]
    """
    rudder_max = 0.436332312998582  # usual
    return ca.Function(
        "rudder_max_follows",
        [],
        [rudder_max],
        [],
        ["rudder_max"],
    )


@cache
def x_h_follows() -> ca.Function:
    """Tailplane ahead of the CG; negative: behind (below the fin).

    Inputs
    ------
    b : scalar [m], CG ahead of the vertical tail and the tail wheel

    Outputs
    -------
    x_h : 1 x 1, tailplane ahead of the CG; negative: behind [m]
    """
    b = ca.SX.sym("b")
    x_h = -b  # below the fin
    return ca.Function(
        "x_h_follows",
        [b],
        [x_h],
        ["b"],
        ["x_h"],
    )


@cache
def z_h_follows() -> ca.Function:
    """Tailplane below the CG; negative: above (at the height of the CG).

    Inputs
    ------

    Outputs
    -------
    z_h : 1 x 1, tailplane below the CG; negative: above [m]
    """
    z_h = 0  # at the height of the CG
    return ca.Function(
        "z_h_follows",
        [],
        [z_h],
        [],
        ["z_h"],
    )


@cache
def S_h_follows() -> ca.Function:
    """Of tailplane and elevator (Raymer Table 6.4: tail volume 0.5 of homebuilt aircraft).

    Inputs
    ------
    S_wing : scalar [m^2], reference area
    c_wing : scalar [m], reference chord
    x_h : scalar [m], tailplane ahead of the CG; negative: behind

    Outputs
    -------
    S_h : 1 x 1, of tailplane and elevator [m^2]
    """
    S_wing = ca.SX.sym("S_wing")
    c_wing = ca.SX.sym("c_wing")
    x_h = ca.SX.sym("x_h")
    S_h = -1/2*S_wing*c_wing/x_h  # Raymer Table 6.4: tail volume 0.5 of homebuilt aircraft
    return ca.Function(
        "S_h_follows",
        [S_wing, c_wing, x_h],
        [S_h],
        ["S_wing", "c_wing", "x_h"],
        ["S_h"],
    )


@cache
def CL_h_follows() -> ca.Function:
    """Of the tailplane (Helmbold, aspect ratio 4).

    Inputs
    ------

    Outputs
    -------
    CL_h : 1 x 1, of the tailplane [1/rad]
    """
    CL_h = 39/10  # Helmbold, aspect ratio 4
    return ca.Function(
        "CL_h_follows",
        [],
        [CL_h],
        [],
        ["CL_h"],
    )


@cache
def CL_h_max_follows() -> ca.Function:
    """Lift coefficient at which it stalls (usual of low aspect ratio).

    Inputs
    ------

    Outputs
    -------
    CL_h_max : 1 x 1, lift coefficient at which it stalls [1]
    """
    CL_h_max = 1  # usual of low aspect ratio
    return ca.Function(
        "CL_h_max_follows",
        [],
        [CL_h_max],
        [],
        ["CL_h_max"],
    )


@cache
def tau_elevator_follows() -> ca.Function:
    """Angle of the tailplane worth an elevator's (elevator of 0.3 of the chord).

    Inputs
    ------

    Outputs
    -------
    tau_elevator : 1 x 1, angle of the tailplane worth an elevator's [1]
    """
    tau_elevator = 1/2  # elevator of 0.3 of the chord
    return ca.Function(
        "tau_elevator_follows",
        [],
        [tau_elevator],
        [],
        ["tau_elevator"],
    )


@cache
def i_h_follows() -> ca.Function:
    """Against the body's x axis, nose up (parallel to the axes).

    Inputs
    ------

    Outputs
    -------
    i_h : 1 x 1, against the body's x axis, nose up [rad]
    """
    i_h = 0  # parallel to the axes
    return ca.Function(
        "i_h_follows",
        [],
        [i_h],
        [],
        ["i_h"],
    )


@cache
def downwash_follows() -> ca.Function:
    """Of the wing at the tailplane, near ground (lifting line, halved by the ground).

    Inputs
    ------
    b_wing : scalar [m], reference span
    S_wing : scalar [m^2], reference area
    CL_alpha : scalar [1/rad], lift by angle of attack

    Outputs
    -------
    downwash : 1 x 1, of the wing at the tailplane, near ground [1]
    """
    b_wing = ca.SX.sym("b_wing")
    S_wing = ca.SX.sym("S_wing")
    CL_alpha = ca.SX.sym("CL_alpha")
    aspect = b_wing**2/S_wing  # definition
    downwash = 0.318309886183791*CL_alpha/aspect  # lifting line, halved by the ground
    return ca.Function(
        "downwash_follows",
        [b_wing, S_wing, CL_alpha],
        [downwash],
        ["b_wing", "S_wing", "CL_alpha"],
        ["downwash"],
    )


@cache
def z_thrust_follows() -> ca.Function:
    """Line of thrust below the CG (thrust through the CG).

    Inputs
    ------

    Outputs
    -------
    z_thrust : 1 x 1, line of thrust below the CG [m]
    """
    z_thrust = 0  # thrust through the CG
    return ca.Function(
        "z_thrust_follows",
        [],
        [z_thrust],
        [],
        ["z_thrust"],
    )


@cache
def x_propeller_follows() -> ca.Function:
    """Propeller ahead of the CG (Cessna 172; 0.35: J-3).

    Inputs
    ------
    b : scalar [m], CG ahead of the vertical tail and the tail wheel

    Outputs
    -------
    x_propeller : 1 x 1, propeller ahead of the CG [m]
    """
    b = ca.SX.sym("b")
    x_propeller = (2/5)*b  # Cessna 172; 0.35: J-3
    return ca.Function(
        "x_propeller_follows",
        [b],
        [x_propeller],
        ["b"],
        ["x_propeller"],
    )


@cache
def propeller_diameter_follows() -> ca.Function:
    """Of the propeller (14 CFR 23.925: 9 in above the ground in level attitude).

    Inputs
    ------
    h_cg : scalar [m], the CG above the ground, in the attitude in which stations are measured
    z_thrust : scalar [m], line of thrust below the CG

    Outputs
    -------
    propeller_diameter : 1 x 1, of the propeller [m]
    """
    h_cg = ca.SX.sym("h_cg")
    z_thrust = ca.SX.sym("z_thrust")
    propeller_diameter = 2*h_cg - 2*z_thrust - 2*0.23  # 14 CFR 23.925: 9 in above the ground in level attitude
    return ca.Function(
        "propeller_diameter_follows",
        [h_cg, z_thrust],
        [propeller_diameter],
        ["h_cg", "z_thrust"],
        ["propeller_diameter"],
    )


@cache
def A_disc_follows() -> ca.Function:
    """Of the propeller (disc).

    Inputs
    ------
    propeller_diameter : scalar [m], of the propeller

    Outputs
    -------
    A_disc : 1 x 1, of the propeller [m^2]
    """
    propeller_diameter = ca.SX.sym("propeller_diameter")
    A_disc = 0.785398163397448*propeller_diameter**2  # disc
    return ca.Function(
        "A_disc_follows",
        [propeller_diameter],
        [A_disc],
        ["propeller_diameter"],
        ["A_disc"],
    )


@cache
def x_tip_follows() -> ca.Function:
    """Wing tips ahead of the CG (abeam of the CG).

    Inputs
    ------

    Outputs
    -------
    x_tip : 1 x 1, wing tips ahead of the CG [m]
    """
    x_tip = 0  # abeam of the CG
    return ca.Function(
        "x_tip_follows",
        [],
        [x_tip],
        [],
        ["x_tip"],
    )


@cache
def z_tip_follows() -> ca.Function:
    """Wing tips below the CG; negative: above (wing at the CG, dihedral 3 deg).

    Inputs
    ------
    b_wing : scalar [m], reference span

    Outputs
    -------
    z_tip : 1 x 1, wing tips below the CG; negative: above [m]
    """
    b_wing = ca.SX.sym("b_wing")
    z_tip = -1/40*b_wing  # wing at the CG, dihedral 3 deg
    return ca.Function(
        "z_tip_follows",
        [b_wing],
        [z_tip],
        ["b_wing"],
        ["z_tip"],
    )


@cache
def v_rest_follows() -> ca.Function:
    """Friction fades below this speed of a contact: near rest a wheel creeps instead of sticking (0.3 deg of 25 for a J-3 that stands in the wind).

    Inputs
    ------

    Outputs
    -------
    v_rest : 1 x 1, friction fades below this speed of a contact: near rest a wheel creeps instead of sticking [m/s]
    """
    v_rest = 0.01  # 0.3 deg of 25 for a J-3 that stands in the wind
    return ca.Function(
        "v_rest_follows",
        [],
        [v_rest],
        [],
        ["v_rest"],
    )


@cache
def v_stop_follows() -> ca.Function:
    """Slower than this it has stopped (definition).

    Inputs
    ------

    Outputs
    -------
    v_stop : 1 x 1, slower than this it has stopped [m/s]
    """
    v_stop = 0.1  # definition
    return ca.Function(
        "v_stop_follows",
        [],
        [v_stop],
        [],
        ["v_stop"],
    )


@cache
def runway_width_follows() -> ca.Function:
    """Between the edges (FAA AC 150/5300-13, small aircraft: 60 ft).

    Inputs
    ------

    Outputs
    -------
    runway_width : 1 x 1, between the edges [m]
    """
    runway_width = 18.3  # FAA AC 150/5300-13, small aircraft: 60 ft
    return ca.Function(
        "runway_width_follows",
        [],
        [runway_width],
        [],
        ["runway_width"],
    )


@cache
def psi_loop_follows() -> ca.Function:
    """A heading beyond this is a ground loop (definition).

    Inputs
    ------

    Outputs
    -------
    psi_loop : 1 x 1, a heading beyond this is a ground loop [rad]
    """
    psi_loop = 1.57079632679490  # definition
    return ca.Function(
        "psi_loop_follows",
        [],
        [psi_loop],
        [],
        ["psi_loop"],
    )


@cache
def jacobians() -> ca.Function:
    """Jacobians of states and outputs: see `integrators.jacobians`.

    Inputs
    ------
    x : column of 6
    u : column of 11
    p : column of 79

    Outputs
    -------
    fx : 6 x 6, derivatives of xdot by x
    fu : 6 x 11, derivatives of xdot by u
    fp : 6 x 79, derivatives of xdot by p
    gx : 39 x 6, derivatives of y by x
    gu : 39 x 11, derivatives of y by u
    gp : 39 x 79, derivatives of y by p
    """
    return integrators.jacobians(rhs(), outputs(), "rollout_jacobians")


@cache
def places() -> ca.Function:
    """Places and forces of the parts: left, right, third, fin, tailplane, propeller, disturbance.

    Inputs
    ------
    x : column of 6
        u [m/s], v [m/s], r [rad/s], X [m], Y [m], psi [rad]
    u : column of 11
        wind_x [m/s], wind_y [m/s], thrust [N], elevator [rad], brake_left [1], brake_right
        [1], pedal [1], steering [rad], rudder [rad], aileron [rad], F_disturbance [N]
    p : column of 79
        a [m], theta_ground [rad], toe [rad], track [m], z_main [m], v_rest [m/s], A_disc
        [m^2], rho [kg/m^3], downwash [1], i_h [rad], tau_elevator [1], CL_h [1/rad],
        CL_h_max [1], S_h [m^2], tailplane_apart [1], S_wing [m^2], Cm_0 [1], Cm_alpha
        [1/rad], Cm_elevator [1/rad], c_wing [m], CL_0 [1], CL_alpha [1/rad], CL_max [1],
        CD_0 [1], K_drag [1], a_third [m], g [m/s^2], m [kg], x_h [m], z_h [m], z_third [m],
        z_thrust [m], B3 [1/rad], C3 [1/(rad N)], B5 [1], C5 [1/N], surface_left [1], B1
        [1], E1 [1], C1 [1], D1 [1], mu_roll_left [1], surface_right [1], mu_roll_right [1],
        steering_ratio [rad], swivels [1], B3_third [1/rad], C3_third [1/(rad N)], B5_third
        [1], C5_third [1/N], surface_third [1], B1_third [1], E1_third [1], C1_third [1],
        D1_third [1], mu_roll_third [1], rudder_max [rad], CY_beta [1/rad], CY_r [1/rad],
        CY_rudder [1/rad], b_wing [m], Cl_aileron [1/rad], Cl_beta [1/rad], Cl_r [1/rad],
        Cn_aileron [1/rad], Cn_beta [1/rad], Cn_r [1/rad], Cn_rudder [1/rad], b [m], z_fin
        [m], CL_fin [1], CL_gamma [1/rad], tau_rudder [1], Ap [m^2], fin_apart [1], v_stop
        [m/s], runway_width [m], psi_loop [rad], Izz [kg m^2]

    Outputs
    -------
    place : 7 x 3, where each part acts, from the CG along body x, y, z [m]
    force : 7 x 3, with what force along body x, y, z [N]

    Thesis
    ------
    Eq. 4.10 at the contact, Eq. 4.10, Eq. 4.13, at any speed, Eq. 4.10 through the air, Eq.
    3.3, never below 0, Eq. 3.5, never below a thousandth, Eq. 3.6, Eq. 3.10, Eq. 3.9, Eq.
    3.8, Eq. 3.7, Eq. 3.11, Eq. 4.19, Eq. 4.29
    """
    x_ = ca.SX.sym("x", 6)
    u, v, r, X, Y, psi = ca.vertsplit(x_)
    u_ = ca.SX.sym("u", 11)
    wind_x, wind_y, thrust, elevator, brake_left, brake_right, pedal, steering, rudder, aileron, F_disturbance = ca.vertsplit(u_)
    p_ = ca.SX.sym("p", 79)
    a, theta_ground, toe, track, z_main, v_rest, A_disc, rho, downwash, i_h, tau_elevator, CL_h, CL_h_max, S_h, tailplane_apart, S_wing, Cm_0, Cm_alpha, Cm_elevator, c_wing, CL_0, CL_alpha, CL_max, CD_0, K_drag, a_third, g, m, x_h, z_h, z_third, z_thrust, B3, C3, B5, C5, surface_left, B1, E1, C1, D1, mu_roll_left, surface_right, mu_roll_right, steering_ratio, swivels, B3_third, C3_third, B5_third, C5_third, surface_third, B1_third, E1_third, C1_third, D1_third, mu_roll_third, rudder_max, CY_beta, CY_r, CY_rudder, b_wing, Cl_aileron, Cl_beta, Cl_r, Cn_aileron, Cn_beta, Cn_r, Cn_rudder, b, z_fin, CL_fin, CL_gamma, tau_rudder, Ap, fin_apart, v_stop, runway_width, psi_loop, Izz = ca.vertsplit(p_)
    w2 = (1/2)*r*track
    w7 = a*ca.cos(theta_ground) + z_main*ca.sin(theta_ground)
    w8 = r*w7 + v
    w9 = w8*ca.sin(toe)
    V_x_left = w9 + (u + w2)*ca.cos(toe)  # Eq. 4.10 at the contact
    V_y_left = w8*ca.cos(toe) - (u + w2)*ca.sin(toe)  # Eq. 4.10
    w11 = (1/1000000)*v_rest**2
    w12 = V_x_left**2 + w11
    tan_alpha_left = V_y_left/ca.sqrt(w12)  # Eq. 4.13, at any speed
    V2_fade_left = ca.sqrt(v_rest**4 + (V_x_left**2 + V_y_left**2)**2)  # near rest
    V_fade_left = ca.sqrt(V2_fade_left)  # near rest
    wind_w = 0  # wind
    V_down_tailplane = -wind_w  # Eq. 4.10 through the air
    wind_u = wind_x*ca.cos(psi) + wind_y*ca.sin(psi)  # wind
    V_axial_tailplane = u - wind_u  # Eq. 4.10 through the air
    w20 = -0.001**2
    w21 = 2*thrust/(A_disc*ca.sqrt(rho**2 + 1e-06**2))
    w22 = V_axial_tailplane*ca.sqrt(V_axial_tailplane**2 + 0.001**2) + w21
    w23 = 1/0.001**2
    w24 = ca.fmax(0, ca.fmin(1, w22*w23))
    V_s_tailplane = ca.sqrt(0.001**2*w24**3*(3*w24**2 - 8*w24 + 6) + ca.fmax(0, w20 + w22) + 0.001**2)  # momentum theory
    gamma_tailplane = elevator*tau_elevator + i_h + (1 - downwash)*(theta_ground + ca.atan2(V_down_tailplane, V_s_tailplane))  # geometry
    w25 = CL_h_max + 1/10
    w26 = ca.fmax(-w25, ca.fmin(w25, CL_h*gamma_tailplane))
    w29 = ca.fmax(0, -5*CL_h_max - 5*w26 + 1/2)
    w30 = ca.fmax(0, -5*CL_h_max + 5*w26 + 1/2)
    C_L_tailplane = w26 + (1/5)*w29**3*(1 - 1/2*w29) - 1/5*w30**3*(1 - 1/2*w30)  # stall
    F_L_tailplane = (1/2)*C_L_tailplane*S_h*rho*tailplane_apart*(V_down_tailplane**2 + V_s_tailplane**2)  # lift
    u_air = u - wind_u  # air
    w_air = -wind_w  # air
    w32 = u_air**2 + 0.0001**2
    attack = theta_ground + ca.atan(w_air/ca.sqrt(w32))  # angle of attack; from behind as from ahead
    V_plane = ca.sqrt(w_air**2 + w32)  # air
    wind_v = -wind_x*ca.sin(psi) + wind_y*ca.cos(psi)  # wind
    v_air = v - wind_v  # air
    V_air = ca.sqrt(V_plane**2 + v_air**2)  # air
    qS = (1/2)*S_wing*V_air**2*rho  # dynamic pressure
    M_air = c_wing*qS*(Cm_0 + Cm_alpha*attack + Cm_elevator*elevator)  # derivatives
    w34 = CL_max + 1/10
    w35 = ca.fmax(-w34, ca.fmin(w34, CL_0 + CL_alpha*attack))
    w38 = ca.fmax(0, -5*CL_max - 5*w35 + 1/2)
    w39 = ca.fmax(0, -5*CL_max + 5*w35 + 1/2)
    CL = w35 + (1/5)*w38**3*(1 - 1/2*w38) - 1/5*w39**3*(1 - 1/2*w39)  # lift, and stall
    CD = CD_0 + CL**2*K_drag  # drag polar
    drag = CD*qS  # drag
    lift = CL*qS  # lift
    w40 = a_third*ca.cos(theta_ground)
    w41 = z_third*ca.sin(theta_ground)
    w42 = -w40 - w41 + w7
    w45 = -F_L_tailplane + g*m - drag*w_air/V_plane - lift*u_air/V_plane
    w46 = F_L_tailplane*(x_h*ca.cos(theta_ground) + z_h*ca.sin(theta_ground)) + M_air + thrust*z_thrust*ca.cos(theta_ground)
    w47 = ca.fmax(0, (1/2)*(-w45*(w40 + w41) - w46)/w42)
    Fz_left = w47  # balance of weight and lift
    C_c_left = ca.fmax(0, B3 + C3*Fz_left)  # Eq. 3.3, never below 0
    mu_left = surface_left*ca.fmax(1/1000, B5 + C5*Fz_left)  # Eq. 3.5, never below a thousandth
    alpha_free_left = C_c_left*tan_alpha_left/mu_left  # Eq. 3.6
    w51 = 1/(B1*ca.sqrt(ca.fmax(1/1000000000000, E1 - 1)))
    alpha_bar_left = ca.fmax(-w51, ca.fmin(alpha_free_left, w51))  # held at the peak
    psi_bar_left = alpha_bar_left*(1 - E1) + E1*ca.atan(B1*alpha_bar_left)/B1  # Eq. 3.10
    theta_bar_left = C1*ca.atan(B1*psi_bar_left)  # Eq. 3.9
    F_bar_left = D1*ca.sin(theta_bar_left)  # Eq. 3.8
    grip_left = F_bar_left  # Eq. 3.7
    braked_left = (brake_left*(mu_left - mu_roll_left) + mu_roll_left)/mu_left  # brake
    w55 = braked_left + 1/200000
    w57 = ca.fmax(-w55, ca.fmin(w55, V_x_left/V_fade_left))
    w60 = ca.fmax(0, -100000*braked_left - 100000*w57 + 1/2)
    w61 = ca.fmax(0, -100000*braked_left + 100000*w57 + 1/2)
    along_left = w57 + (1/100000)*w60**3*(1 - 1/2*w60) - 1/100000*w61**3*(1 - 1/2*w61)  # a locked wheel slides
    left_over_left = ca.sqrt(1 - along_left**2)  # friction ellipse
    w62 = grip_left*ca.sqrt(V_y_left**2 + w12)
    w63 = 1/V_fade_left**2
    w64 = (V_y_left*w62*w63 + 1/1000000000000)/(V_y_left**2*w63 + 1/2000000000000)
    w65 = ca.fmax(0, ca.fmin(1, 50*brake_left - 50*w64))
    asked_left = V_y_left*((1/50)*w65**3*(3*w65**2 - 8*w65 + 6) + ca.fmax(0, brake_left - w64 - 1/50))/V_fade_left + w62/V_fade_left  # slip, or a locked wheel that slides
    w66 = left_over_left + 1/200000
    w67 = ca.fmax(-w66, ca.fmin(asked_left, w66))
    w70 = ca.fmax(0, -100000*left_over_left - 100000*w67 + 1/2)
    w71 = ca.fmax(0, -100000*left_over_left + 100000*w67 + 1/2)
    across_left = w67 + (1/100000)*w70**3*(1 - 1/2*w70) - 1/100000*w71**3*(1 - 1/2*w71)  # friction ellipse
    F_x_left = Fz_left*along_left*mu_left  # Eq. 3.11
    F_y_left = Fz_left*across_left*mu_left  # Eq. 3.11
    push_x_left = -F_x_left*ca.cos(toe) + F_y_left*ca.sin(toe)  # resolved
    push_y_left = -F_x_left*ca.sin(toe) - F_y_left*ca.cos(toe)  # resolved
    push_z_left = 0  # resolved
    V_x_right = -w9 + (u - w2)*ca.cos(toe)  # Eq. 4.10 at the contact
    V_y_right = w8*ca.cos(toe) + (u - w2)*ca.sin(toe)  # Eq. 4.10
    w75 = V_x_right**2 + w11
    tan_alpha_right = V_y_right/ca.sqrt(w75)  # Eq. 4.13, at any speed
    V2_fade_right = ca.sqrt(v_rest**4 + (V_x_right**2 + V_y_right**2)**2)  # near rest
    V_fade_right = ca.sqrt(V2_fade_right)  # near rest
    Fz_right = w47  # balance of weight and lift
    C_c_right = ca.fmax(0, B3 + C3*Fz_right)  # Eq. 3.3, never below 0
    mu_right = surface_right*ca.fmax(1/1000, B5 + C5*Fz_right)  # Eq. 3.5, never below a thousandth
    alpha_free_right = C_c_right*tan_alpha_right/mu_right  # Eq. 3.6
    alpha_bar_right = ca.fmax(-w51, ca.fmin(alpha_free_right, w51))  # held at the peak
    psi_bar_right = alpha_bar_right*(1 - E1) + E1*ca.atan(B1*alpha_bar_right)/B1  # Eq. 3.10
    theta_bar_right = C1*ca.atan(B1*psi_bar_right)  # Eq. 3.9
    F_bar_right = D1*ca.sin(theta_bar_right)  # Eq. 3.8
    grip_right = F_bar_right  # Eq. 3.7
    braked_right = (brake_right*(mu_right - mu_roll_right) + mu_roll_right)/mu_right  # brake
    w78 = braked_right + 1/200000
    w80 = ca.fmax(-w78, ca.fmin(w78, V_x_right/V_fade_right))
    w83 = ca.fmax(0, -100000*braked_right - 100000*w80 + 1/2)
    w84 = ca.fmax(0, -100000*braked_right + 100000*w80 + 1/2)
    along_right = w80 + (1/100000)*w83**3*(1 - 1/2*w83) - 1/100000*w84**3*(1 - 1/2*w84)  # a locked wheel slides
    left_over_right = ca.sqrt(1 - along_right**2)  # friction ellipse
    w85 = grip_right*ca.sqrt(V_y_right**2 + w75)
    w86 = 1/V_fade_right**2
    w87 = (V_y_right*w85*w86 + 1/1000000000000)/(V_y_right**2*w86 + 1/2000000000000)
    w88 = ca.fmax(0, ca.fmin(1, 50*brake_right - 50*w87))
    asked_right = V_y_right*((1/50)*w88**3*(3*w88**2 - 8*w88 + 6) + ca.fmax(0, brake_right - w87 - 1/50))/V_fade_right + w85/V_fade_right  # slip, or a locked wheel that slides
    w89 = left_over_right + 1/200000
    w90 = ca.fmax(-w89, ca.fmin(asked_right, w89))
    w93 = ca.fmax(0, -100000*left_over_right - 100000*w90 + 1/2)
    w94 = ca.fmax(0, -100000*left_over_right + 100000*w90 + 1/2)
    across_right = w90 + (1/100000)*w93**3*(1 - 1/2*w93) - 1/100000*w94**3*(1 - 1/2*w94)  # friction ellipse
    F_x_right = Fz_right*along_right*mu_right  # Eq. 3.11
    F_y_right = Fz_right*across_right*mu_right  # Eq. 3.11
    push_x_right = -F_x_right*ca.cos(toe) - F_y_right*ca.sin(toe)  # resolved
    push_y_right = F_x_right*ca.sin(toe) - F_y_right*ca.cos(toe)  # resolved
    push_z_right = 0  # resolved
    commanded_third = pedal*steering_ratio + steering  # linkage
    delta_third = commanded_third*(1 - swivels)  # linkage
    w99 = r*(w40 + w41) + v
    V_x_third = u*ca.cos(delta_third) + w99*ca.sin(delta_third)  # Eq. 4.10 at the contact
    V_y_third = -u*ca.sin(delta_third) + w99*ca.cos(delta_third)  # Eq. 4.10
    w101 = V_x_third**2 + w11
    tan_alpha_third = V_y_third/ca.sqrt(w101)  # Eq. 4.13, at any speed
    V2_fade_third = ca.sqrt(v_rest**4 + (V_x_third**2 + V_y_third**2)**2)  # near rest
    V_fade_third = ca.sqrt(V2_fade_third)  # near rest
    Fz_third = ca.fmax(0, -(-w45*w7 - w46)/w42)  # balance of weight and lift
    C_c_third = ca.fmax(0, B3_third + C3_third*Fz_third)  # Eq. 3.3, never below 0
    mu_third = surface_third*ca.fmax(1/1000, B5_third + C5_third*Fz_third)  # Eq. 3.5, never below a thousandth
    alpha_free_third = C_c_third*tan_alpha_third/mu_third  # Eq. 3.6
    w106 = 1/(B1_third*ca.sqrt(ca.fmax(1/1000000000000, E1_third - 1)))
    alpha_bar_third = ca.fmax(-w106, ca.fmin(alpha_free_third, w106))  # held at the peak
    psi_bar_third = -alpha_bar_third*(E1_third - 1) + E1_third*ca.atan(B1_third*alpha_bar_third)/B1_third  # Eq. 3.10
    theta_bar_third = C1_third*ca.atan(B1_third*psi_bar_third)  # Eq. 3.9
    F_bar_third = D1_third*ca.sin(theta_bar_third)  # Eq. 3.8
    grip_third = F_bar_third  # Eq. 3.7
    braked_third = mu_roll_third/mu_third  # brake
    w107 = braked_third + 1/200000
    w109 = ca.fmax(-w107, ca.fmin(w107, V_x_third/V_fade_third))
    w112 = ca.fmax(0, -100000*braked_third - 100000*w109 + 1/2)
    w113 = ca.fmax(0, -100000*braked_third + 100000*w109 + 1/2)
    along_third = w109 + (1/100000)*w112**3*(1 - 1/2*w112) - 1/100000*w113**3*(1 - 1/2*w113)  # a locked wheel slides
    left_over_third = ca.sqrt(1 - along_third**2)  # friction ellipse
    asked_third = grip_third*ca.sqrt(V_y_third**2 + w101)/V_fade_third  # slip
    w114 = left_over_third + 1/200000
    w115 = ca.fmax(-w114, ca.fmin(asked_third, w114))
    w118 = ca.fmax(0, -100000*left_over_third - 100000*w115 + 1/2)
    w119 = ca.fmax(0, -100000*left_over_third + 100000*w115 + 1/2)
    across_third = w115 + (1/100000)*w118**3*(1 - 1/2*w118) - 1/100000*w119**3*(1 - 1/2*w119)  # friction ellipse
    F_x_third = Fz_third*along_third*mu_third  # Eq. 3.11
    F_y_third = Fz_third*across_third*mu_third*(1 - swivels)  # Eq. 3.11
    push_x_third = -F_x_third*ca.cos(delta_third) + F_y_third*ca.sin(delta_third)  # resolved
    push_y_third = -F_x_third*ca.sin(delta_third) - F_y_third*ca.cos(delta_third)  # resolved
    push_z_third = 0  # resolved
    V_axial_fin = u - wind_u  # Eq. 4.10 through the air
    w121 = V_axial_fin*ca.sqrt(V_axial_fin**2 + 0.001**2) + w21
    w122 = ca.fmax(0, ca.fmin(1, w121*w23))
    V_s_fin = ca.sqrt(0.001**2*w122**3*(3*w122**2 - 8*w122 + 6) + ca.fmax(0, w121 + w20) + 0.001**2)  # momentum theory
    V_side_fin = r*(-b*ca.cos(theta_ground) + z_fin*ca.sin(theta_ground)) + v - wind_v  # Eq. 4.10 through the air
    gamma_fin = ca.atan2(V_side_fin, V_s_fin)  # Eq. 4.19
    delta_rudder_fin = -pedal*rudder_max + rudder  # linkage
    w123 = CL_fin + 1/10
    w124 = ca.fmax(-w123, ca.fmin(w123, CL_gamma*(-delta_rudder_fin*tau_rudder + gamma_fin)))
    w127 = ca.fmax(0, -5*CL_fin - 5*w124 + 1/2)
    w128 = ca.fmax(0, -5*CL_fin + 5*w124 + 1/2)
    C_L_fin = w124 + (1/5)*w127**3*(1 - 1/2*w127) - 1/5*w128**3*(1 - 1/2*w128)  # stall
    F_L_fin = (1/2)*Ap*C_L_fin*fin_apart*rho*(V_s_fin**2 + V_side_fin**2)  # Eq. 4.29
    place_ = ca.blockcat([
        [a*ca.cos(theta_ground) + z_main*ca.sin(theta_ground), -1/2*track, -a*ca.sin(theta_ground) + z_main*ca.cos(theta_ground)],
        [a*ca.cos(theta_ground) + z_main*ca.sin(theta_ground), (1/2)*track, -a*ca.sin(theta_ground) + z_main*ca.cos(theta_ground)],
        [a_third*ca.cos(theta_ground) + z_third*ca.sin(theta_ground), 0, -a_third*ca.sin(theta_ground) + z_third*ca.cos(theta_ground)],
        [-b*ca.cos(theta_ground) + z_fin*ca.sin(theta_ground), 0, b*ca.sin(theta_ground) + z_fin*ca.cos(theta_ground)],
        [x_h*ca.cos(theta_ground) + z_h*ca.sin(theta_ground), 0, -x_h*ca.sin(theta_ground) + z_h*ca.cos(theta_ground)],
        [z_thrust*ca.sin(theta_ground), 0, z_thrust*ca.cos(theta_ground)],
        [-b*ca.cos(theta_ground), 0, b*ca.sin(theta_ground)],
    ])
    force_ = ca.blockcat([
        [push_x_left, push_y_left, push_z_left],
        [push_x_right, push_y_right, push_z_right],
        [push_x_third, push_y_third, push_z_third],
        [0, -F_L_fin, 0],
        [0, 0, -F_L_tailplane],
        [thrust, 0, 0],
        [0, F_disturbance, 0],
    ])
    return ca.Function(
        "rollout_places",
        [x_, u_, p_],
        [place_, force_],
        ["x", "u", "p"],
        ["place", "force"],
    )


@cache
def rk4() -> ca.Function:
    """Integrate the model over an interval: see `integrators.interval`."""
    return integrators.interval(rhs(), "rollout_rk4", "rk4")


@cache
def rk45() -> ca.Function:
    """Integrate the model over an interval: see `integrators.interval`."""
    return integrators.interval(rhs(), "rollout_rk45", "rk45")
