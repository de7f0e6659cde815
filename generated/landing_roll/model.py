# Generated from derive/ (digest 0d0ebfc0fdc11d3e) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`.
"""A rigid body on three wheels with legs, in wind, braked and steered, until it stops."""

from functools import cache

import casadi as ca

from groundroll.generated import integrators


@cache
def rhs() -> ca.Function:
    """Time derivatives of the states.

    Inputs
    ------
    x : column of 14
        u [m/s], v [m/s], w [m/s], p [rad/s], q [rad/s], r [rad/s], chi_third [rad],
        chi_rate_third [rad/s], X [m], Y [m], Z [m], phi [rad], theta [rad], psi [rad]
    u : column of 11
        brake_left [1], brake_right [1], pedal [1], steering [rad], wind_x [m/s], wind_y
        [m/s], rudder [rad], aileron [rad], elevator [rad], thrust [N], F_disturbance [N]
    p : column of 98
        a [m], track [m], z_main [m], c_main [N s/m], k_main [N/m], toe [rad], v_rest [m/s],
        B3 [1/rad], C3 [1/(rad N)], B5 [1], C5 [1/N], surface_left [1], B1 [1], E1 [1], C1
        [1], D1 [1], mu_roll_left [1], surface_right [1], mu_roll_right [1], a_third [m],
        z_third [m], c_third [N s/m], k_third [N/m], steering_ratio [rad], break_out [rad],
        k_stop [N m/rad], k_swivel [N m/rad], stop [rad], swivels [1], trail [m], B3_third
        [1/rad], C3_third [1/(rad N)], B5_third [1], C5_third [1/N], surface_third [1],
        B1_third [1], E1_third [1], C1_third [1], D1_third [1], mu_roll_third [1],
        rudder_max [rad], S_wing [m^2], rho [kg/m^3], CL_0 [1], CL_alpha [1/rad], CL_max
        [1], CD_0 [1], K_drag [1], CY_beta [1/rad], CY_r [1/rad], CY_rudder [1/rad], b_wing
        [m], Cl_aileron [1/rad], Cl_beta [1/rad], Cl_p [1/rad], Cl_r [1/rad], Cm_0 [1],
        Cm_alpha [1/rad], Cm_elevator [1/rad], Cm_q [1/rad], c_wing [m], Cn_aileron [1/rad],
        Cn_beta [1/rad], Cn_r [1/rad], Cn_rudder [1/rad], z_fin [m], A_disc [m^2], b [m],
        CL_fin [1], CL_gamma [1/rad], tau_rudder [1], Ap [m^2], fin_apart [1], z_h [m], x_h
        [m], downwash [1], i_h [rad], tau_elevator [1], CL_h [1/rad], CL_h_max [1], S_h
        [m^2], tailplane_apart [1], v_stop [m/s], runway_width [m], psi_loop [rad], x_tip
        [m], z_tip [m], propeller_diameter [m], x_propeller [m], z_thrust [m], g [m/s^2], m
        [kg], Ixx [kg m^2], Ixz [kg m^2], Iyy [kg m^2], Izz [kg m^2], I_swivel [kg m^2],
        c_swivel [N m s/rad]

    Outputs
    -------
    xdot : 14 x 1, time derivatives of x

    Thesis
    ------
    Eq. 4.10 at the foot, Eq. 4.10 at the contact, Eq. 4.10, Eq. 4.13, at any speed, Eq.
    3.3, never below 0, Eq. 3.5, never below a thousandth, Eq. 3.6, Eq. 3.10, Eq. 3.9, Eq.
    3.8, Eq. 3.7, Eq. 3.11, Eq. 4.10 through the air, Eq. 4.19, Eq. 4.29, Eq. 4.8, Eq. 4.9
    """
    x_ = ca.SX.sym("x", 14)
    u, v, w, p, q, r, chi_third, chi_rate_third, X, Y, Z, phi, theta, psi = ca.vertsplit(x_)
    u_ = ca.SX.sym("u", 11)
    brake_left, brake_right, pedal, steering, wind_x, wind_y, rudder, aileron, elevator, thrust, F_disturbance = ca.vertsplit(u_)
    p_ = ca.SX.sym("p", 98)
    a, track, z_main, c_main, k_main, toe, v_rest, B3, C3, B5, C5, surface_left, B1, E1, C1, D1, mu_roll_left, surface_right, mu_roll_right, a_third, z_third, c_third, k_third, steering_ratio, break_out, k_stop, k_swivel, stop, swivels, trail, B3_third, C3_third, B5_third, C5_third, surface_third, B1_third, E1_third, C1_third, D1_third, mu_roll_third, rudder_max, S_wing, rho, CL_0, CL_alpha, CL_max, CD_0, K_drag, CY_beta, CY_r, CY_rudder, b_wing, Cl_aileron, Cl_beta, Cl_p, Cl_r, Cm_0, Cm_alpha, Cm_elevator, Cm_q, c_wing, Cn_aileron, Cn_beta, Cn_r, Cn_rudder, z_fin, A_disc, b, CL_fin, CL_gamma, tau_rudder, Ap, fin_apart, z_h, x_h, downwash, i_h, tau_elevator, CL_h, CL_h_max, S_h, tailplane_apart, v_stop, runway_width, psi_loop, x_tip, z_tip, propeller_diameter, x_propeller, z_thrust, g, m, Ixx, Ixz, Iyy, Izz, I_swivel, c_swivel = ca.vertsplit(p_)
    R_Zz = ca.cos(phi)*ca.cos(theta)  # rotation by psi, theta, phi
    tilt_left = R_Zz  # direction cosine
    R_Zx = -ca.sin(theta)  # rotation by psi, theta, phi
    R_Zy = ca.sin(phi)*ca.cos(theta)  # rotation by psi, theta, phi
    w6 = (1/2)*R_Zy*track
    w7 = R_Zx*a + R_Zz*z_main + Z
    depth_left = -w6 + w7  # geometry
    stroke_left = depth_left/tilt_left  # geometry
    w9 = (1/2)*r*track
    foot_u_left = -q*stroke_left + q*z_main + u + w9  # Eq. 4.10 at the foot
    w10 = a*r - p*z_main + v
    foot_v_left = p*stroke_left + w10  # Eq. 4.10 at the foot
    w13 = (1/2)*p*track
    foot_w_left = -a*q + w - w13  # Eq. 4.10 at the foot
    sinking_left = R_Zx*foot_u_left + R_Zy*foot_v_left + R_Zz*foot_w_left  # direction cosines
    w15 = ca.fmax(0, ca.fmin(1, stroke_left/0.0001))
    touching_left = w15**3*(6*w15**2 - 15*w15 + 10)  # nothing above the ground
    F_leg_left = touching_left*(c_main*sinking_left/tilt_left + k_main*stroke_left)  # spring and damper
    w17 = -0.0001*k_main
    w18 = 1/(0.0001*k_main)
    w19 = ca.fmax(0, ca.fmin(1, F_leg_left*w18))
    Fz_left = (0.0001*k_main*w19**3*(3*w19**2 - 8*w19 + 6) + ca.fmax(0, F_leg_left + w17))/tilt_left  # a leg never pulls
    w21 = R_Zx*ca.cos(toe)
    w23 = R_Zy*ca.sin(toe)
    slope_left = w21 + w23  # direction cosine
    flat_left = ca.sqrt(1 - slope_left**2)  # projection on the runway
    V_x_left = (foot_u_left*ca.cos(toe) + foot_v_left*ca.sin(toe) - sinking_left*slope_left)/flat_left  # Eq. 4.10 at the contact
    w25 = R_Zz*ca.cos(toe)
    w26 = R_Zz*ca.sin(toe)
    w27 = R_Zx*ca.sin(toe)
    w28 = R_Zy*ca.cos(toe)
    V_y_left = (-foot_u_left*w26 + foot_v_left*w25 + foot_w_left*(w27 - w28))/flat_left  # Eq. 4.10
    w31 = (1/1000000)*v_rest**2
    w32 = V_x_left**2 + w31
    tan_alpha_left = V_y_left/ca.sqrt(w32)  # Eq. 4.13, at any speed
    V2_fade_left = ca.sqrt(v_rest**4 + (V_x_left**2 + V_y_left**2)**2)  # near rest
    V_fade_left = ca.sqrt(V2_fade_left)  # near rest
    C_c_left = ca.fmax(0, B3 + C3*Fz_left)  # Eq. 3.3, never below 0
    mu_left = surface_left*ca.fmax(1/1000, B5 + C5*Fz_left)  # Eq. 3.5, never below a thousandth
    alpha_free_left = C_c_left*tan_alpha_left/mu_left  # Eq. 3.6
    w38 = 1/(B1*ca.sqrt(ca.fmax(1/1000000000000, E1 - 1)))
    alpha_bar_left = ca.fmax(-w38, ca.fmin(alpha_free_left, w38))  # held at the peak
    psi_bar_left = alpha_bar_left*(1 - E1) + E1*ca.atan(B1*alpha_bar_left)/B1  # Eq. 3.10
    theta_bar_left = C1*ca.atan(B1*psi_bar_left)  # Eq. 3.9
    F_bar_left = D1*ca.sin(theta_bar_left)  # Eq. 3.8
    grip_left = F_bar_left  # Eq. 3.7
    braked_left = (brake_left*(mu_left - mu_roll_left) + mu_roll_left)/mu_left  # brake
    w42 = braked_left + 1/200000
    w44 = ca.fmax(-w42, ca.fmin(w42, V_x_left/V_fade_left))
    w47 = ca.fmax(0, -100000*braked_left - 100000*w44 + 1/2)
    w48 = ca.fmax(0, -100000*braked_left + 100000*w44 + 1/2)
    along_left = w44 + (1/100000)*w47**3*(1 - 1/2*w47) - 1/100000*w48**3*(1 - 1/2*w48)  # a locked wheel slides
    left_over_left = ca.sqrt(1 - along_left**2)  # friction ellipse
    w49 = grip_left*ca.sqrt(V_y_left**2 + w32)
    w50 = 1/V_fade_left**2
    w51 = (V_y_left*w49*w50 + 1/1000000000000)/(V_y_left**2*w50 + 1/2000000000000)
    w52 = ca.fmax(0, ca.fmin(1, 50*brake_left - 50*w51))
    asked_left = V_y_left*((1/50)*w52**3*(3*w52**2 - 8*w52 + 6) + ca.fmax(0, brake_left - w51 - 1/50))/V_fade_left + w49/V_fade_left  # slip, or a locked wheel that slides
    w53 = left_over_left + 1/200000
    w54 = ca.fmax(-w53, ca.fmin(asked_left, w53))
    w57 = ca.fmax(0, -100000*left_over_left - 100000*w54 + 1/2)
    w58 = ca.fmax(0, -100000*left_over_left + 100000*w54 + 1/2)
    across_left = w54 + (1/100000)*w57**3*(1 - 1/2*w57) - 1/100000*w58**3*(1 - 1/2*w58)  # friction ellipse
    F_x_left = Fz_left*along_left*mu_left  # Eq. 3.11
    F_y_left = Fz_left*across_left*mu_left  # Eq. 3.11
    w60 = -ca.cos(toe)
    push_x_left = -F_x_left*(-R_Zx*slope_left - w60)/flat_left + F_y_left*R_Zz*ca.sin(toe)/flat_left - Fz_left*R_Zx  # resolved
    push_y_left = -F_x_left*(-R_Zy*slope_left + ca.sin(toe))/flat_left - F_y_left*w25/flat_left - Fz_left*R_Zy  # resolved
    push_z_left = F_x_left*R_Zz*slope_left/flat_left - F_y_left*(w27 - w28)/flat_left - Fz_left*R_Zz  # resolved
    tilt_right = R_Zz  # direction cosine
    depth_right = w6 + w7  # geometry
    stroke_right = depth_right/tilt_right  # geometry
    foot_u_right = -q*stroke_right + q*z_main + u - w9  # Eq. 4.10 at the foot
    foot_v_right = p*stroke_right + w10  # Eq. 4.10 at the foot
    foot_w_right = -a*q + w + w13  # Eq. 4.10 at the foot
    sinking_right = R_Zx*foot_u_right + R_Zy*foot_v_right + R_Zz*foot_w_right  # direction cosines
    w64 = ca.fmax(0, ca.fmin(1, stroke_right/0.0001))
    touching_right = w64**3*(6*w64**2 - 15*w64 + 10)  # nothing above the ground
    F_leg_right = touching_right*(c_main*sinking_right/tilt_right + k_main*stroke_right)  # spring and damper
    w65 = ca.fmax(0, ca.fmin(1, F_leg_right*w18))
    Fz_right = (0.0001*k_main*w65**3*(3*w65**2 - 8*w65 + 6) + ca.fmax(0, F_leg_right + w17))/tilt_right  # a leg never pulls
    slope_right = w21 - w23  # direction cosine
    flat_right = ca.sqrt(1 - slope_right**2)  # projection on the runway
    V_x_right = (foot_u_right*ca.cos(toe) - foot_v_right*ca.sin(toe) - sinking_right*slope_right)/flat_right  # Eq. 4.10 at the contact
    w67 = -w27 - w28
    V_y_right = (foot_u_right*w26 + foot_v_right*w25 + foot_w_right*w67)/flat_right  # Eq. 4.10
    w69 = V_x_right**2 + w31
    tan_alpha_right = V_y_right/ca.sqrt(w69)  # Eq. 4.13, at any speed
    V2_fade_right = ca.sqrt(v_rest**4 + (V_x_right**2 + V_y_right**2)**2)  # near rest
    V_fade_right = ca.sqrt(V2_fade_right)  # near rest
    C_c_right = ca.fmax(0, B3 + C3*Fz_right)  # Eq. 3.3, never below 0
    mu_right = surface_right*ca.fmax(1/1000, B5 + C5*Fz_right)  # Eq. 3.5, never below a thousandth
    alpha_free_right = C_c_right*tan_alpha_right/mu_right  # Eq. 3.6
    alpha_bar_right = ca.fmax(-w38, ca.fmin(alpha_free_right, w38))  # held at the peak
    psi_bar_right = alpha_bar_right*(1 - E1) + E1*ca.atan(B1*alpha_bar_right)/B1  # Eq. 3.10
    theta_bar_right = C1*ca.atan(B1*psi_bar_right)  # Eq. 3.9
    F_bar_right = D1*ca.sin(theta_bar_right)  # Eq. 3.8
    grip_right = F_bar_right  # Eq. 3.7
    braked_right = (brake_right*(mu_right - mu_roll_right) + mu_roll_right)/mu_right  # brake
    w72 = braked_right + 1/200000
    w74 = ca.fmax(-w72, ca.fmin(w72, V_x_right/V_fade_right))
    w77 = ca.fmax(0, -100000*braked_right - 100000*w74 + 1/2)
    w78 = ca.fmax(0, -100000*braked_right + 100000*w74 + 1/2)
    along_right = w74 + (1/100000)*w77**3*(1 - 1/2*w77) - 1/100000*w78**3*(1 - 1/2*w78)  # a locked wheel slides
    left_over_right = ca.sqrt(1 - along_right**2)  # friction ellipse
    w79 = grip_right*ca.sqrt(V_y_right**2 + w69)
    w80 = 1/V_fade_right**2
    w81 = (V_y_right*w79*w80 + 1/1000000000000)/(V_y_right**2*w80 + 1/2000000000000)
    w82 = ca.fmax(0, ca.fmin(1, 50*brake_right - 50*w81))
    asked_right = V_y_right*((1/50)*w82**3*(3*w82**2 - 8*w82 + 6) + ca.fmax(0, brake_right - w81 - 1/50))/V_fade_right + w79/V_fade_right  # slip, or a locked wheel that slides
    w83 = left_over_right + 1/200000
    w84 = ca.fmax(-w83, ca.fmin(asked_right, w83))
    w87 = ca.fmax(0, -100000*left_over_right - 100000*w84 + 1/2)
    w88 = ca.fmax(0, -100000*left_over_right + 100000*w84 + 1/2)
    across_right = w84 + (1/100000)*w87**3*(1 - 1/2*w87) - 1/100000*w88**3*(1 - 1/2*w88)  # friction ellipse
    F_x_right = Fz_right*along_right*mu_right  # Eq. 3.11
    F_y_right = Fz_right*across_right*mu_right  # Eq. 3.11
    push_x_right = -F_x_right*(-R_Zx*slope_right - w60)/flat_right - F_y_right*w26/flat_right - Fz_right*R_Zx  # resolved
    push_y_right = -F_x_right*(-R_Zy*slope_right - ca.sin(toe))/flat_right - F_y_right*w25/flat_right - Fz_right*R_Zy  # resolved
    push_z_right = F_x_right*R_Zz*slope_right/flat_right - F_y_right*w67/flat_right - Fz_right*R_Zz  # resolved
    tilt_third = R_Zz  # direction cosine
    depth_third = R_Zx*a_third + R_Zz*z_third + Z  # geometry
    stroke_third = depth_third/tilt_third  # geometry
    foot_u_third = -q*stroke_third + q*z_third + u  # Eq. 4.10 at the foot
    foot_v_third = a_third*r + p*stroke_third - p*z_third + v  # Eq. 4.10 at the foot
    foot_w_third = -a_third*q + w  # Eq. 4.10 at the foot
    sinking_third = R_Zx*foot_u_third + R_Zy*foot_v_third + R_Zz*foot_w_third  # direction cosines
    w93 = ca.fmax(0, ca.fmin(1, stroke_third/0.0001))
    touching_third = w93**3*(6*w93**2 - 15*w93 + 10)  # nothing above the ground
    F_leg_third = touching_third*(c_third*sinking_third/tilt_third + k_third*stroke_third)  # spring and damper
    w95 = ca.fmax(0, ca.fmin(1, F_leg_third/(0.0001*k_third)))
    Fz_third = (0.0001*k_third*w95**3*(3*w95**2 - 8*w95 + 6) + ca.fmax(0, F_leg_third - 0.0001*k_third))/tilt_third  # a leg never pulls
    commanded_third = pedal*steering_ratio + steering  # linkage
    wound_third = chi_third - commanded_third  # linkage
    w97 = (101/100)*stop
    w99 = ca.fmax(0, ca.fmin(1, 100*(chi_third - stop)/stop))
    w100 = ca.fmax(0, ca.fmin(1, 100*(-chi_third - stop)/stop))
    M_spring_third = k_stop*(-1/100*stop*w100**3*(3*w100**2 - 8*w100 + 6) + (1/100)*stop*w99**3*(3*w99**2 - 8*w99 + 6) - ca.fmax(0, -chi_third - w97) + ca.fmax(0, chi_third - w97)) + k_swivel*wound_third*(1/2 - 1/2*ca.tanh(10*(-break_out**2 + wound_third**2)/break_out**2))  # springs
    delta_third = commanded_third + swivels*wound_third  # linkage or swivel
    slope_third = R_Zx*ca.cos(delta_third) + R_Zy*ca.sin(delta_third)  # direction cosine
    flat_third = ca.sqrt(1 - slope_third**2)  # projection on the runway
    V_x_third = (foot_u_third*ca.cos(delta_third) + foot_v_third*ca.sin(delta_third) - sinking_third*slope_third)/flat_third  # Eq. 4.10 at the contact
    w104 = R_Zz*ca.cos(delta_third)
    w105 = R_Zx*ca.sin(delta_third) - R_Zy*ca.cos(delta_third)
    V_y_third = -chi_rate_third*swivels*trail + (-R_Zz*foot_u_third*ca.sin(delta_third) + foot_v_third*w104 + foot_w_third*w105)/flat_third  # Eq. 4.10
    w107 = V_x_third**2 + w31
    tan_alpha_third = V_y_third/ca.sqrt(w107)  # Eq. 4.13, at any speed
    V2_fade_third = ca.sqrt(v_rest**4 + (V_x_third**2 + V_y_third**2)**2)  # near rest
    V_fade_third = ca.sqrt(V2_fade_third)  # near rest
    C_c_third = ca.fmax(0, B3_third + C3_third*Fz_third)  # Eq. 3.3, never below 0
    mu_third = surface_third*ca.fmax(1/1000, B5_third + C5_third*Fz_third)  # Eq. 3.5, never below a thousandth
    alpha_free_third = C_c_third*tan_alpha_third/mu_third  # Eq. 3.6
    w112 = 1/(B1_third*ca.sqrt(ca.fmax(1/1000000000000, E1_third - 1)))
    alpha_bar_third = ca.fmax(-w112, ca.fmin(alpha_free_third, w112))  # held at the peak
    psi_bar_third = -alpha_bar_third*(E1_third - 1) + E1_third*ca.atan(B1_third*alpha_bar_third)/B1_third  # Eq. 3.10
    theta_bar_third = C1_third*ca.atan(B1_third*psi_bar_third)  # Eq. 3.9
    F_bar_third = D1_third*ca.sin(theta_bar_third)  # Eq. 3.8
    grip_third = F_bar_third  # Eq. 3.7
    braked_third = mu_roll_third/mu_third  # brake
    w113 = braked_third + 1/200000
    w115 = ca.fmax(-w113, ca.fmin(w113, V_x_third/V_fade_third))
    w118 = ca.fmax(0, -100000*braked_third - 100000*w115 + 1/2)
    w119 = ca.fmax(0, -100000*braked_third + 100000*w115 + 1/2)
    along_third = w115 + (1/100000)*w118**3*(1 - 1/2*w118) - 1/100000*w119**3*(1 - 1/2*w119)  # a locked wheel slides
    left_over_third = ca.sqrt(1 - along_third**2)  # friction ellipse
    asked_third = grip_third*ca.sqrt(V_y_third**2 + w107)/V_fade_third  # slip
    w120 = left_over_third + 1/200000
    w121 = ca.fmax(-w120, ca.fmin(asked_third, w120))
    w124 = ca.fmax(0, -100000*left_over_third - 100000*w121 + 1/2)
    w125 = ca.fmax(0, -100000*left_over_third + 100000*w121 + 1/2)
    across_third = w121 + (1/100000)*w124**3*(1 - 1/2*w124) - 1/100000*w125**3*(1 - 1/2*w125)  # friction ellipse
    F_x_third = Fz_third*along_third*mu_third  # Eq. 3.11
    F_y_third = Fz_third*across_third*mu_third  # Eq. 3.11
    push_x_third = -F_x_third*(-R_Zx*slope_third + ca.cos(delta_third))/flat_third + F_y_third*R_Zz*ca.sin(delta_third)/flat_third - Fz_third*R_Zx  # resolved
    push_y_third = -F_x_third*(-R_Zy*slope_third + ca.sin(delta_third))/flat_third - F_y_third*w104/flat_third - Fz_third*R_Zy  # resolved
    push_z_third = F_x_third*R_Zz*slope_third/flat_third - F_y_third*w105/flat_third - Fz_third*R_Zz  # resolved
    R_Xx = ca.cos(psi)*ca.cos(theta)  # rotation by psi, theta, phi
    R_Yx = ca.sin(psi)*ca.cos(theta)  # rotation by psi, theta, phi
    wind_u = R_Xx*wind_x + R_Yx*wind_y  # wind
    u_air = u - wind_u  # air
    w132 = ca.sin(phi)*ca.cos(psi)
    R_Xy = w132*ca.sin(theta) - ca.sin(psi)*ca.cos(phi)  # rotation by psi, theta, phi
    w133 = ca.cos(phi)*ca.cos(psi)
    w134 = ca.sin(phi)*ca.sin(psi)
    R_Yy = w133 + w134*ca.sin(theta)  # rotation by psi, theta, phi
    wind_v = R_Xy*wind_x + R_Yy*wind_y  # wind
    v_air = v - wind_v  # air
    R_Xz = w133*ca.sin(theta) + w134  # rotation by psi, theta, phi
    R_Yz = -w132 + ca.sin(psi)*ca.sin(theta)*ca.cos(phi)  # rotation by psi, theta, phi
    wind_w = R_Xz*wind_x + R_Yz*wind_y  # wind
    w_air = w - wind_w  # air
    w135 = u_air**2 + 0.0001**2
    V_plane = ca.sqrt(w_air**2 + w135)  # air
    V_air = ca.sqrt(V_plane**2 + v_air**2)  # air
    attack = ca.atan(w_air/ca.sqrt(w135))  # angle of attack; from behind as from ahead
    sideslip = ca.atan2(v_air, V_plane)  # angle of sideslip
    w136 = -pedal*rudder_max + rudder
    deflected = w136  # linkage
    qS = (1/2)*S_wing*V_air**2*rho  # dynamic pressure
    w138 = CL_max + 1/10
    w139 = ca.fmax(-w138, ca.fmin(w138, CL_0 + CL_alpha*attack))
    w142 = ca.fmax(0, -5*CL_max - 5*w139 + 1/2)
    w143 = ca.fmax(0, -5*CL_max + 5*w139 + 1/2)
    CL = w139 + (1/5)*w142**3*(1 - 1/2*w142) - 1/5*w143**3*(1 - 1/2*w143)  # lift, and stall
    CD = CD_0 + CL**2*K_drag  # drag polar
    lift = CL*qS  # lift
    drag = CD*qS  # drag
    w144 = (1/4)*S_wing*V_air*rho
    Y_air = CY_r*b_wing*r*w144 + qS*(CY_beta*sideslip + CY_rudder*deflected)  # derivatives
    w146 = b_wing**2*w144
    L_air = b_wing*qS*(Cl_aileron*aileron + Cl_beta*sideslip) + w146*(Cl_p*p + Cl_r*r)  # derivatives
    M_air = Cm_q*c_wing**2*q*w144 + c_wing*qS*(Cm_0 + Cm_alpha*attack + Cm_elevator*elevator)  # derivatives
    N_air = Cn_r*r*w146 + b_wing*qS*(Cn_aileron*aileron + Cn_beta*sideslip + Cn_rudder*deflected)  # derivatives
    V_axial_fin = q*z_fin + u - wind_u  # Eq. 4.10 through the air
    w148 = -0.001**2
    w149 = 2*thrust/(A_disc*ca.sqrt(rho**2 + 1e-06**2))
    w150 = V_axial_fin*ca.sqrt(V_axial_fin**2 + 0.001**2) + w149
    w151 = 1/0.001**2
    w152 = ca.fmax(0, ca.fmin(1, w150*w151))
    V_s_fin = ca.sqrt(0.001**2*w152**3*(3*w152**2 - 8*w152 + 6) + ca.fmax(0, w148 + w150) + 0.001**2)  # momentum theory
    V_side_fin = -b*r - p*z_fin + v - wind_v  # Eq. 4.10 through the air
    gamma_fin = ca.atan2(V_side_fin, V_s_fin)  # Eq. 4.19
    delta_rudder_fin = w136  # linkage
    w153 = CL_fin + 1/10
    w154 = ca.fmax(-w153, ca.fmin(w153, CL_gamma*(-delta_rudder_fin*tau_rudder + gamma_fin)))
    w157 = ca.fmax(0, -5*CL_fin - 5*w154 + 1/2)
    w158 = ca.fmax(0, -5*CL_fin + 5*w154 + 1/2)
    C_L_fin = w154 + (1/5)*w157**3*(1 - 1/2*w157) - 1/5*w158**3*(1 - 1/2*w158)  # stall
    F_L_fin = (1/2)*Ap*C_L_fin*fin_apart*rho*(V_s_fin**2 + V_side_fin**2)  # Eq. 4.29
    V_axial_tailplane = q*z_h + u - wind_u  # Eq. 4.10 through the air
    w160 = V_axial_tailplane*ca.sqrt(V_axial_tailplane**2 + 0.001**2) + w149
    w161 = ca.fmax(0, ca.fmin(1, w151*w160))
    V_s_tailplane = ca.sqrt(0.001**2*w161**3*(3*w161**2 - 8*w161 + 6) + ca.fmax(0, w148 + w160) + 0.001**2)  # momentum theory
    V_down_tailplane = -q*x_h + w - wind_w  # Eq. 4.10 through the air
    gamma_tailplane = elevator*tau_elevator + i_h + (1 - downwash)*ca.atan2(V_down_tailplane, V_s_tailplane)  # geometry
    w162 = CL_h_max + 1/10
    w163 = ca.fmax(-w162, ca.fmin(w162, CL_h*gamma_tailplane))
    w166 = ca.fmax(0, -5*CL_h_max - 5*w163 + 1/2)
    w167 = ca.fmax(0, -5*CL_h_max + 5*w163 + 1/2)
    C_L_tailplane = w163 + (1/5)*w166**3*(1 - 1/2*w166) - 1/5*w167**3*(1 - 1/2*w167)  # stall
    F_L_tailplane = (1/2)*C_L_tailplane*S_h*rho*tailplane_apart*(V_down_tailplane**2 + V_s_tailplane**2)  # lift
    sum_Fx = R_Zx*g*m + push_x_left + push_x_right + push_x_third + thrust - drag*u_air/V_plane + lift*w_air/V_plane  # Eq. 4.8
    sum_F = -F_L_fin + F_disturbance + R_Zy*g*m + Y_air + push_y_left + push_y_right + push_y_third  # Eq. 4.8
    sum_Fz = -F_L_tailplane + R_Zz*g*m + push_z_left + push_z_right + push_z_third - drag*w_air/V_plane - lift*u_air/V_plane  # Eq. 4.8
    sum_Mx = F_L_fin*z_fin + L_air - push_y_left*(-stroke_left + z_main) - push_y_right*(-stroke_right + z_main) - push_y_third*(-stroke_third + z_third) - 1/2*push_z_left*track + (1/2)*push_z_right*track  # Eq. 4.8
    sum_My = F_L_tailplane*x_h + M_air - a*push_z_left - a*push_z_right - a_third*push_z_third + push_x_left*(-stroke_left + z_main) + push_x_right*(-stroke_right + z_main) + push_x_third*(-stroke_third + z_third) + thrust*z_thrust  # Eq. 4.8
    sum_M = F_L_fin*b - F_disturbance*b + N_air + a*push_y_left + a*push_y_right + a_third*push_y_third + (1/2)*push_x_left*track - 1/2*push_x_right*track  # Eq. 4.8
    u_dot = -q*w + r*v + sum_Fx/m  # Eq. 4.9
    v_dot = p*w - r*u + sum_F/m  # Eq. 4.9
    w_dot = -p*v + q*u + sum_Fz/m  # Eq. 4.9
    w178 = 1/(Ixx*Izz - Ixz**2)
    w182 = Ixz*q*w178
    w187 = q*r*w178
    p_dot = Ixx*p*w182 - Ixz**2*w187 + Ixz*sum_M*w178 + Iyy*Izz*q*r*w178 - Iyy*p*w182 - Izz**2*w187 + Izz*p*w182 + Izz*sum_Mx*w178  # Eq. 4.9
    q_dot = -Ixx*p*r/Iyy - Ixz*p**2/Iyy + Ixz*r**2/Iyy + Izz*p*r/Iyy + sum_My/Iyy  # Eq. 4.9
    w192 = p*q*w178
    r_dot = Ixx**2*w192 - Ixx*Iyy*p*q*w178 - Ixx*r*w182 + Ixx*sum_M*w178 + Ixz**2*w192 + Ixz*sum_Mx*w178 + Iyy*r*w182 - Izz*r*w182  # Eq. 4.9
    xdot_ = ca.vertcat(u_dot, v_dot, w_dot, p_dot, q_dot, r_dot, chi_rate_third*swivels, swivels*(F_y_third*trail - M_spring_third - c_swivel*chi_rate_third)/I_swivel, R_Xx*u + R_Xy*v + R_Xz*w, R_Yx*u + R_Yy*v + R_Yz*w, R_Zx*u + R_Zy*v + R_Zz*w, p + q*ca.sin(phi)*ca.tan(theta) + r*ca.cos(phi)*ca.tan(theta), q*ca.cos(phi) - r*ca.sin(phi), q*ca.sin(phi)/ca.cos(theta) + r*ca.cos(phi)/ca.cos(theta))
    return ca.Function(
        "landing_roll_rhs",
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
    x : column of 14
        u [m/s], v [m/s], w [m/s], p [rad/s], q [rad/s], r [rad/s], chi_third [rad],
        chi_rate_third [rad/s], X [m], Y [m], Z [m], phi [rad], theta [rad], psi [rad]
    u : column of 11
        brake_left [1], brake_right [1], pedal [1], steering [rad], wind_x [m/s], wind_y
        [m/s], rudder [rad], aileron [rad], elevator [rad], thrust [N], F_disturbance [N]
    p : column of 98
        a [m], track [m], z_main [m], c_main [N s/m], k_main [N/m], toe [rad], v_rest [m/s],
        B3 [1/rad], C3 [1/(rad N)], B5 [1], C5 [1/N], surface_left [1], B1 [1], E1 [1], C1
        [1], D1 [1], mu_roll_left [1], surface_right [1], mu_roll_right [1], a_third [m],
        z_third [m], c_third [N s/m], k_third [N/m], steering_ratio [rad], break_out [rad],
        k_stop [N m/rad], k_swivel [N m/rad], stop [rad], swivels [1], trail [m], B3_third
        [1/rad], C3_third [1/(rad N)], B5_third [1], C5_third [1/N], surface_third [1],
        B1_third [1], E1_third [1], C1_third [1], D1_third [1], mu_roll_third [1],
        rudder_max [rad], S_wing [m^2], rho [kg/m^3], CL_0 [1], CL_alpha [1/rad], CL_max
        [1], CD_0 [1], K_drag [1], CY_beta [1/rad], CY_r [1/rad], CY_rudder [1/rad], b_wing
        [m], Cl_aileron [1/rad], Cl_beta [1/rad], Cl_p [1/rad], Cl_r [1/rad], Cm_0 [1],
        Cm_alpha [1/rad], Cm_elevator [1/rad], Cm_q [1/rad], c_wing [m], Cn_aileron [1/rad],
        Cn_beta [1/rad], Cn_r [1/rad], Cn_rudder [1/rad], z_fin [m], A_disc [m^2], b [m],
        CL_fin [1], CL_gamma [1/rad], tau_rudder [1], Ap [m^2], fin_apart [1], z_h [m], x_h
        [m], downwash [1], i_h [rad], tau_elevator [1], CL_h [1/rad], CL_h_max [1], S_h
        [m^2], tailplane_apart [1], v_stop [m/s], runway_width [m], psi_loop [rad], x_tip
        [m], z_tip [m], propeller_diameter [m], x_propeller [m], z_thrust [m], g [m/s^2], m
        [kg], Ixx [kg m^2], Ixz [kg m^2], Iyy [kg m^2], Izz [kg m^2], I_swivel [kg m^2],
        c_swivel [N m s/rad]

    Outputs
    -------
    y : 47 x 1, outputs Fz_left, alpha_left, F_x_left, F_y_left, Fz_right, alpha_right, F_x_right, F_y_right, Fz_third, alpha_third, F_x_third, F_y_third, attack, sideslip, CL, lift, drag, Y_air, L_air, M_air, N_air, gamma_fin, C_L_fin, F_L_fin, gamma_tailplane, C_L_tailplane, F_L_tailplane, V_ground, height_left_tip, height_right_tip, height_propeller_tip, sum_Fx, sum_F, sum_Fz, sum_Mx, sum_My, sum_M, a_x, a_y, a_z, depth_left, depth_right, depth_third, above_stop, beyond_edge, beyond_loop, ahead

    Thesis
    ------
    Eq. 4.10 at the foot, Eq. 4.10 at the contact, Eq. 4.10, Eq. 4.13, at any speed, Eq.
    4.13, Eq. 3.3, never below 0, Eq. 3.5, never below a thousandth, Eq. 3.6, Eq. 3.10, Eq.
    3.9, Eq. 3.8, Eq. 3.7, Eq. 3.11, Eq. 4.10 through the air, Eq. 4.19, Eq. 4.29, Eq. 4.3,
    Eq. 4.8, Eq. 4.9, Eq. 4.7
    """
    x_ = ca.SX.sym("x", 14)
    u, v, w, p, q, r, chi_third, chi_rate_third, X, Y, Z, phi, theta, psi = ca.vertsplit(x_)
    u_ = ca.SX.sym("u", 11)
    brake_left, brake_right, pedal, steering, wind_x, wind_y, rudder, aileron, elevator, thrust, F_disturbance = ca.vertsplit(u_)
    p_ = ca.SX.sym("p", 98)
    a, track, z_main, c_main, k_main, toe, v_rest, B3, C3, B5, C5, surface_left, B1, E1, C1, D1, mu_roll_left, surface_right, mu_roll_right, a_third, z_third, c_third, k_third, steering_ratio, break_out, k_stop, k_swivel, stop, swivels, trail, B3_third, C3_third, B5_third, C5_third, surface_third, B1_third, E1_third, C1_third, D1_third, mu_roll_third, rudder_max, S_wing, rho, CL_0, CL_alpha, CL_max, CD_0, K_drag, CY_beta, CY_r, CY_rudder, b_wing, Cl_aileron, Cl_beta, Cl_p, Cl_r, Cm_0, Cm_alpha, Cm_elevator, Cm_q, c_wing, Cn_aileron, Cn_beta, Cn_r, Cn_rudder, z_fin, A_disc, b, CL_fin, CL_gamma, tau_rudder, Ap, fin_apart, z_h, x_h, downwash, i_h, tau_elevator, CL_h, CL_h_max, S_h, tailplane_apart, v_stop, runway_width, psi_loop, x_tip, z_tip, propeller_diameter, x_propeller, z_thrust, g, m, Ixx, Ixz, Iyy, Izz, I_swivel, c_swivel = ca.vertsplit(p_)
    R_Zz = ca.cos(phi)*ca.cos(theta)  # rotation by psi, theta, phi
    tilt_left = R_Zz  # direction cosine
    R_Zx = -ca.sin(theta)  # rotation by psi, theta, phi
    R_Zy = ca.sin(phi)*ca.cos(theta)  # rotation by psi, theta, phi
    w6 = (1/2)*R_Zy*track
    w8 = R_Zx*a + R_Zz*z_main + Z
    depth_left = -w6 + w8  # geometry
    stroke_left = depth_left/tilt_left  # geometry
    w10 = (1/2)*r*track
    foot_u_left = -q*stroke_left + q*z_main + u + w10  # Eq. 4.10 at the foot
    w11 = a*r - p*z_main + v
    foot_v_left = p*stroke_left + w11  # Eq. 4.10 at the foot
    w14 = (1/2)*p*track
    foot_w_left = -a*q + w - w14  # Eq. 4.10 at the foot
    sinking_left = R_Zx*foot_u_left + R_Zy*foot_v_left + R_Zz*foot_w_left  # direction cosines
    w16 = ca.fmax(0, ca.fmin(1, stroke_left/0.0001))
    touching_left = w16**3*(6*w16**2 - 15*w16 + 10)  # nothing above the ground
    F_leg_left = touching_left*(c_main*sinking_left/tilt_left + k_main*stroke_left)  # spring and damper
    w18 = -0.0001*k_main
    w19 = 1/(0.0001*k_main)
    w20 = ca.fmax(0, ca.fmin(1, F_leg_left*w19))
    Fz_left = (0.0001*k_main*w20**3*(3*w20**2 - 8*w20 + 6) + ca.fmax(0, F_leg_left + w18))/tilt_left  # a leg never pulls
    w22 = R_Zx*ca.cos(toe)
    w24 = R_Zy*ca.sin(toe)
    slope_left = w22 + w24  # direction cosine
    flat_left = ca.sqrt(1 - slope_left**2)  # projection on the runway
    V_x_left = (foot_u_left*ca.cos(toe) + foot_v_left*ca.sin(toe) - sinking_left*slope_left)/flat_left  # Eq. 4.10 at the contact
    w26 = R_Zz*ca.cos(toe)
    w27 = R_Zz*ca.sin(toe)
    w28 = R_Zx*ca.sin(toe)
    w29 = R_Zy*ca.cos(toe)
    V_y_left = (-foot_u_left*w27 + foot_v_left*w26 + foot_w_left*(w28 - w29))/flat_left  # Eq. 4.10
    w32 = (1/1000000)*v_rest**2
    w33 = V_x_left**2 + w32
    tan_alpha_left = V_y_left/ca.sqrt(w33)  # Eq. 4.13, at any speed
    alpha_left = ca.atan(tan_alpha_left)  # Eq. 4.13
    V2_fade_left = ca.sqrt(v_rest**4 + (V_x_left**2 + V_y_left**2)**2)  # near rest
    V_fade_left = ca.sqrt(V2_fade_left)  # near rest
    C_c_left = ca.fmax(0, B3 + C3*Fz_left)  # Eq. 3.3, never below 0
    mu_left = surface_left*ca.fmax(1/1000, B5 + C5*Fz_left)  # Eq. 3.5, never below a thousandth
    alpha_free_left = C_c_left*tan_alpha_left/mu_left  # Eq. 3.6
    w39 = 1/(B1*ca.sqrt(ca.fmax(1/1000000000000, E1 - 1)))
    alpha_bar_left = ca.fmax(-w39, ca.fmin(alpha_free_left, w39))  # held at the peak
    psi_bar_left = alpha_bar_left*(1 - E1) + E1*ca.atan(B1*alpha_bar_left)/B1  # Eq. 3.10
    theta_bar_left = C1*ca.atan(B1*psi_bar_left)  # Eq. 3.9
    F_bar_left = D1*ca.sin(theta_bar_left)  # Eq. 3.8
    grip_left = F_bar_left  # Eq. 3.7
    braked_left = (brake_left*(mu_left - mu_roll_left) + mu_roll_left)/mu_left  # brake
    w43 = braked_left + 1/200000
    w45 = ca.fmax(-w43, ca.fmin(w43, V_x_left/V_fade_left))
    w48 = ca.fmax(0, -100000*braked_left - 100000*w45 + 1/2)
    w49 = ca.fmax(0, -100000*braked_left + 100000*w45 + 1/2)
    along_left = w45 + (1/100000)*w48**3*(1 - 1/2*w48) - 1/100000*w49**3*(1 - 1/2*w49)  # a locked wheel slides
    left_over_left = ca.sqrt(1 - along_left**2)  # friction ellipse
    w50 = grip_left*ca.sqrt(V_y_left**2 + w33)
    w51 = 1/V_fade_left**2
    w52 = (V_y_left*w50*w51 + 1/1000000000000)/(V_y_left**2*w51 + 1/2000000000000)
    w53 = ca.fmax(0, ca.fmin(1, 50*brake_left - 50*w52))
    asked_left = V_y_left*((1/50)*w53**3*(3*w53**2 - 8*w53 + 6) + ca.fmax(0, brake_left - w52 - 1/50))/V_fade_left + w50/V_fade_left  # slip, or a locked wheel that slides
    w54 = left_over_left + 1/200000
    w55 = ca.fmax(-w54, ca.fmin(asked_left, w54))
    w58 = ca.fmax(0, -100000*left_over_left - 100000*w55 + 1/2)
    w59 = ca.fmax(0, -100000*left_over_left + 100000*w55 + 1/2)
    across_left = w55 + (1/100000)*w58**3*(1 - 1/2*w58) - 1/100000*w59**3*(1 - 1/2*w59)  # friction ellipse
    F_x_left = Fz_left*along_left*mu_left  # Eq. 3.11
    F_y_left = Fz_left*across_left*mu_left  # Eq. 3.11
    w61 = -ca.cos(toe)
    push_x_left = -F_x_left*(-R_Zx*slope_left - w61)/flat_left + F_y_left*R_Zz*ca.sin(toe)/flat_left - Fz_left*R_Zx  # resolved
    push_y_left = -F_x_left*(-R_Zy*slope_left + ca.sin(toe))/flat_left - F_y_left*w26/flat_left - Fz_left*R_Zy  # resolved
    push_z_left = F_x_left*R_Zz*slope_left/flat_left - F_y_left*(w28 - w29)/flat_left - Fz_left*R_Zz  # resolved
    tilt_right = R_Zz  # direction cosine
    depth_right = w6 + w8  # geometry
    stroke_right = depth_right/tilt_right  # geometry
    foot_u_right = -q*stroke_right + q*z_main + u - w10  # Eq. 4.10 at the foot
    foot_v_right = p*stroke_right + w11  # Eq. 4.10 at the foot
    foot_w_right = -a*q + w + w14  # Eq. 4.10 at the foot
    sinking_right = R_Zx*foot_u_right + R_Zy*foot_v_right + R_Zz*foot_w_right  # direction cosines
    w65 = ca.fmax(0, ca.fmin(1, stroke_right/0.0001))
    touching_right = w65**3*(6*w65**2 - 15*w65 + 10)  # nothing above the ground
    F_leg_right = touching_right*(c_main*sinking_right/tilt_right + k_main*stroke_right)  # spring and damper
    w66 = ca.fmax(0, ca.fmin(1, F_leg_right*w19))
    Fz_right = (0.0001*k_main*w66**3*(3*w66**2 - 8*w66 + 6) + ca.fmax(0, F_leg_right + w18))/tilt_right  # a leg never pulls
    slope_right = w22 - w24  # direction cosine
    flat_right = ca.sqrt(1 - slope_right**2)  # projection on the runway
    V_x_right = (foot_u_right*ca.cos(toe) - foot_v_right*ca.sin(toe) - sinking_right*slope_right)/flat_right  # Eq. 4.10 at the contact
    w68 = -w28 - w29
    V_y_right = (foot_u_right*w27 + foot_v_right*w26 + foot_w_right*w68)/flat_right  # Eq. 4.10
    w70 = V_x_right**2 + w32
    tan_alpha_right = V_y_right/ca.sqrt(w70)  # Eq. 4.13, at any speed
    alpha_right = ca.atan(tan_alpha_right)  # Eq. 4.13
    V2_fade_right = ca.sqrt(v_rest**4 + (V_x_right**2 + V_y_right**2)**2)  # near rest
    V_fade_right = ca.sqrt(V2_fade_right)  # near rest
    C_c_right = ca.fmax(0, B3 + C3*Fz_right)  # Eq. 3.3, never below 0
    mu_right = surface_right*ca.fmax(1/1000, B5 + C5*Fz_right)  # Eq. 3.5, never below a thousandth
    alpha_free_right = C_c_right*tan_alpha_right/mu_right  # Eq. 3.6
    alpha_bar_right = ca.fmax(-w39, ca.fmin(alpha_free_right, w39))  # held at the peak
    psi_bar_right = alpha_bar_right*(1 - E1) + E1*ca.atan(B1*alpha_bar_right)/B1  # Eq. 3.10
    theta_bar_right = C1*ca.atan(B1*psi_bar_right)  # Eq. 3.9
    F_bar_right = D1*ca.sin(theta_bar_right)  # Eq. 3.8
    grip_right = F_bar_right  # Eq. 3.7
    braked_right = (brake_right*(mu_right - mu_roll_right) + mu_roll_right)/mu_right  # brake
    w73 = braked_right + 1/200000
    w75 = ca.fmax(-w73, ca.fmin(w73, V_x_right/V_fade_right))
    w78 = ca.fmax(0, -100000*braked_right - 100000*w75 + 1/2)
    w79 = ca.fmax(0, -100000*braked_right + 100000*w75 + 1/2)
    along_right = w75 + (1/100000)*w78**3*(1 - 1/2*w78) - 1/100000*w79**3*(1 - 1/2*w79)  # a locked wheel slides
    left_over_right = ca.sqrt(1 - along_right**2)  # friction ellipse
    w80 = grip_right*ca.sqrt(V_y_right**2 + w70)
    w81 = 1/V_fade_right**2
    w82 = (V_y_right*w80*w81 + 1/1000000000000)/(V_y_right**2*w81 + 1/2000000000000)
    w83 = ca.fmax(0, ca.fmin(1, 50*brake_right - 50*w82))
    asked_right = V_y_right*((1/50)*w83**3*(3*w83**2 - 8*w83 + 6) + ca.fmax(0, brake_right - w82 - 1/50))/V_fade_right + w80/V_fade_right  # slip, or a locked wheel that slides
    w84 = left_over_right + 1/200000
    w85 = ca.fmax(-w84, ca.fmin(asked_right, w84))
    w88 = ca.fmax(0, -100000*left_over_right - 100000*w85 + 1/2)
    w89 = ca.fmax(0, -100000*left_over_right + 100000*w85 + 1/2)
    across_right = w85 + (1/100000)*w88**3*(1 - 1/2*w88) - 1/100000*w89**3*(1 - 1/2*w89)  # friction ellipse
    F_x_right = Fz_right*along_right*mu_right  # Eq. 3.11
    F_y_right = Fz_right*across_right*mu_right  # Eq. 3.11
    push_x_right = -F_x_right*(-R_Zx*slope_right - w61)/flat_right - F_y_right*w27/flat_right - Fz_right*R_Zx  # resolved
    push_y_right = -F_x_right*(-R_Zy*slope_right - ca.sin(toe))/flat_right - F_y_right*w26/flat_right - Fz_right*R_Zy  # resolved
    push_z_right = F_x_right*R_Zz*slope_right/flat_right - F_y_right*w68/flat_right - Fz_right*R_Zz  # resolved
    tilt_third = R_Zz  # direction cosine
    depth_third = R_Zx*a_third + R_Zz*z_third + Z  # geometry
    stroke_third = depth_third/tilt_third  # geometry
    foot_u_third = -q*stroke_third + q*z_third + u  # Eq. 4.10 at the foot
    foot_v_third = a_third*r + p*stroke_third - p*z_third + v  # Eq. 4.10 at the foot
    foot_w_third = -a_third*q + w  # Eq. 4.10 at the foot
    sinking_third = R_Zx*foot_u_third + R_Zy*foot_v_third + R_Zz*foot_w_third  # direction cosines
    w95 = ca.fmax(0, ca.fmin(1, stroke_third/0.0001))
    touching_third = w95**3*(6*w95**2 - 15*w95 + 10)  # nothing above the ground
    F_leg_third = touching_third*(c_third*sinking_third/tilt_third + k_third*stroke_third)  # spring and damper
    w97 = ca.fmax(0, ca.fmin(1, F_leg_third/(0.0001*k_third)))
    Fz_third = (0.0001*k_third*w97**3*(3*w97**2 - 8*w97 + 6) + ca.fmax(0, F_leg_third - 0.0001*k_third))/tilt_third  # a leg never pulls
    commanded_third = pedal*steering_ratio + steering  # linkage
    wound_third = chi_third - commanded_third  # linkage
    delta_third = commanded_third + swivels*wound_third  # linkage or swivel
    slope_third = R_Zx*ca.cos(delta_third) + R_Zy*ca.sin(delta_third)  # direction cosine
    flat_third = ca.sqrt(1 - slope_third**2)  # projection on the runway
    V_x_third = (foot_u_third*ca.cos(delta_third) + foot_v_third*ca.sin(delta_third) - sinking_third*slope_third)/flat_third  # Eq. 4.10 at the contact
    w101 = R_Zz*ca.cos(delta_third)
    w102 = R_Zx*ca.sin(delta_third) - R_Zy*ca.cos(delta_third)
    V_y_third = -chi_rate_third*swivels*trail + (-R_Zz*foot_u_third*ca.sin(delta_third) + foot_v_third*w101 + foot_w_third*w102)/flat_third  # Eq. 4.10
    w104 = V_x_third**2 + w32
    tan_alpha_third = V_y_third/ca.sqrt(w104)  # Eq. 4.13, at any speed
    alpha_third = ca.atan(tan_alpha_third)  # Eq. 4.13
    V2_fade_third = ca.sqrt(v_rest**4 + (V_x_third**2 + V_y_third**2)**2)  # near rest
    V_fade_third = ca.sqrt(V2_fade_third)  # near rest
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
    F_y_third = Fz_third*across_third*mu_third  # Eq. 3.11
    push_x_third = -F_x_third*(-R_Zx*slope_third + ca.cos(delta_third))/flat_third + F_y_third*R_Zz*ca.sin(delta_third)/flat_third - Fz_third*R_Zx  # resolved
    push_y_third = -F_x_third*(-R_Zy*slope_third + ca.sin(delta_third))/flat_third - F_y_third*w101/flat_third - Fz_third*R_Zy  # resolved
    push_z_third = F_x_third*R_Zz*slope_third/flat_third - F_y_third*w102/flat_third - Fz_third*R_Zz  # resolved
    R_Xx = ca.cos(psi)*ca.cos(theta)  # rotation by psi, theta, phi
    R_Yx = ca.sin(psi)*ca.cos(theta)  # rotation by psi, theta, phi
    wind_u = R_Xx*wind_x + R_Yx*wind_y  # wind
    u_air = u - wind_u  # air
    w129 = ca.sin(phi)*ca.cos(psi)
    R_Xy = w129*ca.sin(theta) - ca.sin(psi)*ca.cos(phi)  # rotation by psi, theta, phi
    w130 = ca.cos(phi)*ca.cos(psi)
    w131 = ca.sin(phi)*ca.sin(psi)
    R_Yy = w130 + w131*ca.sin(theta)  # rotation by psi, theta, phi
    wind_v = R_Xy*wind_x + R_Yy*wind_y  # wind
    v_air = v - wind_v  # air
    R_Xz = w130*ca.sin(theta) + w131  # rotation by psi, theta, phi
    R_Yz = -w129 + ca.sin(psi)*ca.sin(theta)*ca.cos(phi)  # rotation by psi, theta, phi
    wind_w = R_Xz*wind_x + R_Yz*wind_y  # wind
    w_air = w - wind_w  # air
    w132 = u_air**2 + 0.0001**2
    V_plane = ca.sqrt(w_air**2 + w132)  # air
    V_air = ca.sqrt(V_plane**2 + v_air**2)  # air
    attack = ca.atan(w_air/ca.sqrt(w132))  # angle of attack; from behind as from ahead
    sideslip = ca.atan2(v_air, V_plane)  # angle of sideslip
    w133 = -pedal*rudder_max + rudder
    deflected = w133  # linkage
    qS = (1/2)*S_wing*V_air**2*rho  # dynamic pressure
    w135 = CL_max + 1/10
    w136 = ca.fmax(-w135, ca.fmin(w135, CL_0 + CL_alpha*attack))
    w139 = ca.fmax(0, -5*CL_max - 5*w136 + 1/2)
    w140 = ca.fmax(0, -5*CL_max + 5*w136 + 1/2)
    CL = w136 + (1/5)*w139**3*(1 - 1/2*w139) - 1/5*w140**3*(1 - 1/2*w140)  # lift, and stall
    CD = CD_0 + CL**2*K_drag  # drag polar
    lift = CL*qS  # lift
    drag = CD*qS  # drag
    w141 = (1/4)*S_wing*V_air*rho
    Y_air = CY_r*b_wing*r*w141 + qS*(CY_beta*sideslip + CY_rudder*deflected)  # derivatives
    w143 = b_wing**2*w141
    L_air = b_wing*qS*(Cl_aileron*aileron + Cl_beta*sideslip) + w143*(Cl_p*p + Cl_r*r)  # derivatives
    M_air = Cm_q*c_wing**2*q*w141 + c_wing*qS*(Cm_0 + Cm_alpha*attack + Cm_elevator*elevator)  # derivatives
    N_air = Cn_r*r*w143 + b_wing*qS*(Cn_aileron*aileron + Cn_beta*sideslip + Cn_rudder*deflected)  # derivatives
    V_axial_fin = q*z_fin + u - wind_u  # Eq. 4.10 through the air
    w145 = -0.001**2
    w146 = 2*thrust/(A_disc*ca.sqrt(rho**2 + 1e-06**2))
    w147 = V_axial_fin*ca.sqrt(V_axial_fin**2 + 0.001**2) + w146
    w148 = 1/0.001**2
    w149 = ca.fmax(0, ca.fmin(1, w147*w148))
    V_s_fin = ca.sqrt(0.001**2*w149**3*(3*w149**2 - 8*w149 + 6) + ca.fmax(0, w145 + w147) + 0.001**2)  # momentum theory
    V_side_fin = -b*r - p*z_fin + v - wind_v  # Eq. 4.10 through the air
    gamma_fin = ca.atan2(V_side_fin, V_s_fin)  # Eq. 4.19
    delta_rudder_fin = w133  # linkage
    w150 = CL_fin + 1/10
    w151 = ca.fmax(-w150, ca.fmin(w150, CL_gamma*(-delta_rudder_fin*tau_rudder + gamma_fin)))
    w154 = ca.fmax(0, -5*CL_fin - 5*w151 + 1/2)
    w155 = ca.fmax(0, -5*CL_fin + 5*w151 + 1/2)
    C_L_fin = w151 + (1/5)*w154**3*(1 - 1/2*w154) - 1/5*w155**3*(1 - 1/2*w155)  # stall
    F_L_fin = (1/2)*Ap*C_L_fin*fin_apart*rho*(V_s_fin**2 + V_side_fin**2)  # Eq. 4.29
    V_axial_tailplane = q*z_h + u - wind_u  # Eq. 4.10 through the air
    w157 = V_axial_tailplane*ca.sqrt(V_axial_tailplane**2 + 0.001**2) + w146
    w158 = ca.fmax(0, ca.fmin(1, w148*w157))
    V_s_tailplane = ca.sqrt(0.001**2*w158**3*(3*w158**2 - 8*w158 + 6) + ca.fmax(0, w145 + w157) + 0.001**2)  # momentum theory
    V_down_tailplane = -q*x_h + w - wind_w  # Eq. 4.10 through the air
    gamma_tailplane = elevator*tau_elevator + i_h + (1 - downwash)*ca.atan2(V_down_tailplane, V_s_tailplane)  # geometry
    w159 = CL_h_max + 1/10
    w160 = ca.fmax(-w159, ca.fmin(w159, CL_h*gamma_tailplane))
    w163 = ca.fmax(0, -5*CL_h_max - 5*w160 + 1/2)
    w164 = ca.fmax(0, -5*CL_h_max + 5*w160 + 1/2)
    C_L_tailplane = w160 + (1/5)*w163**3*(1 - 1/2*w163) - 1/5*w164**3*(1 - 1/2*w164)  # stall
    F_L_tailplane = (1/2)*C_L_tailplane*S_h*rho*tailplane_apart*(V_down_tailplane**2 + V_s_tailplane**2)  # lift
    V_ground = ca.sqrt((R_Xx*u + R_Xy*v + R_Xz*w)**2 + (R_Yx*u + R_Yy*v + R_Yz*w)**2 + 1e-06**2)  # Eq. 4.3
    above_stop = V_ground - v_stop  # definition
    beyond_edge = -1/2*runway_width + ca.fabs(Y)  # definition
    beyond_loop = -psi_loop + ca.fabs(psi)  # definition
    w165 = ca.sqrt(1 - R_Zx**2)
    ahead = ca.fmax(-R_Zx*R_Zz*z_main/w165 + a*w165, -R_Zx*R_Zz*z_third/w165 + a_third*w165)  # geometry
    w167 = (1/2)*R_Zy*b_wing
    w168 = R_Zx*x_tip + R_Zz*z_tip + Z
    height_left_tip = w167 - w168  # geometry
    height_right_tip = -w167 - w168  # geometry
    height_propeller_tip = -R_Zx*x_propeller - R_Zz*((1/2)*propeller_diameter + z_thrust) - Z  # geometry
    sum_Fx = R_Zx*g*m + push_x_left + push_x_right + push_x_third + thrust - drag*u_air/V_plane + lift*w_air/V_plane  # Eq. 4.8
    sum_F = -F_L_fin + F_disturbance + R_Zy*g*m + Y_air + push_y_left + push_y_right + push_y_third  # Eq. 4.8
    sum_Fz = -F_L_tailplane + R_Zz*g*m + push_z_left + push_z_right + push_z_third - drag*w_air/V_plane - lift*u_air/V_plane  # Eq. 4.8
    sum_Mx = F_L_fin*z_fin + L_air - push_y_left*(-stroke_left + z_main) - push_y_right*(-stroke_right + z_main) - push_y_third*(-stroke_third + z_third) - 1/2*push_z_left*track + (1/2)*push_z_right*track  # Eq. 4.8
    sum_My = F_L_tailplane*x_h + M_air - a*push_z_left - a*push_z_right - a_third*push_z_third + push_x_left*(-stroke_left + z_main) + push_x_right*(-stroke_right + z_main) + push_x_third*(-stroke_third + z_third) + thrust*z_thrust  # Eq. 4.8
    sum_M = F_L_fin*b - F_disturbance*b + N_air + a*push_y_left + a*push_y_right + a_third*push_y_third + (1/2)*push_x_left*track - 1/2*push_x_right*track  # Eq. 4.8
    u_dot = -q*w + r*v + sum_Fx/m  # Eq. 4.9
    v_dot = p*w - r*u + sum_F/m  # Eq. 4.9
    w_dot = -p*v + q*u + sum_Fz/m  # Eq. 4.9
    a_x = q*w - r*v + u_dot  # Eq. 4.7
    a_y = -p*w + r*u + v_dot  # Eq. 4.7
    a_z = p*v - q*u + w_dot  # Eq. 4.7
    y_ = ca.vertcat(Fz_left, alpha_left, F_x_left, F_y_left, Fz_right, alpha_right, F_x_right, F_y_right, Fz_third, alpha_third, F_x_third, F_y_third, attack, sideslip, CL, lift, drag, Y_air, L_air, M_air, N_air, gamma_fin, C_L_fin, F_L_fin, gamma_tailplane, C_L_tailplane, F_L_tailplane, V_ground, height_left_tip, height_right_tip, height_propeller_tip, sum_Fx, sum_F, sum_Fz, sum_Mx, sum_My, sum_M, a_x, a_y, a_z, depth_left, depth_right, depth_third, above_stop, beyond_edge, beyond_loop, ahead)
    return ca.Function(
        "landing_roll_outputs",
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
    x : column of 14
    u : column of 11
    p : column of 98

    Outputs
    -------
    fx : 14 x 14, derivatives of xdot by x
    fu : 14 x 11, derivatives of xdot by u
    fp : 14 x 98, derivatives of xdot by p
    gx : 47 x 14, derivatives of y by x
    gu : 47 x 11, derivatives of y by u
    gp : 47 x 98, derivatives of y by p
    """
    return integrators.jacobians(rhs(), outputs(), "landing_roll_jacobians")


@cache
def places() -> ca.Function:
    """Places and forces of the parts: left, right, third, fin, tailplane, propeller, disturbance.

    Inputs
    ------
    x : column of 14
        u [m/s], v [m/s], w [m/s], p [rad/s], q [rad/s], r [rad/s], chi_third [rad],
        chi_rate_third [rad/s], X [m], Y [m], Z [m], phi [rad], theta [rad], psi [rad]
    u : column of 11
        brake_left [1], brake_right [1], pedal [1], steering [rad], wind_x [m/s], wind_y
        [m/s], rudder [rad], aileron [rad], elevator [rad], thrust [N], F_disturbance [N]
    p : column of 98
        a [m], track [m], z_main [m], c_main [N s/m], k_main [N/m], toe [rad], v_rest [m/s],
        B3 [1/rad], C3 [1/(rad N)], B5 [1], C5 [1/N], surface_left [1], B1 [1], E1 [1], C1
        [1], D1 [1], mu_roll_left [1], surface_right [1], mu_roll_right [1], a_third [m],
        z_third [m], c_third [N s/m], k_third [N/m], steering_ratio [rad], break_out [rad],
        k_stop [N m/rad], k_swivel [N m/rad], stop [rad], swivels [1], trail [m], B3_third
        [1/rad], C3_third [1/(rad N)], B5_third [1], C5_third [1/N], surface_third [1],
        B1_third [1], E1_third [1], C1_third [1], D1_third [1], mu_roll_third [1],
        rudder_max [rad], S_wing [m^2], rho [kg/m^3], CL_0 [1], CL_alpha [1/rad], CL_max
        [1], CD_0 [1], K_drag [1], CY_beta [1/rad], CY_r [1/rad], CY_rudder [1/rad], b_wing
        [m], Cl_aileron [1/rad], Cl_beta [1/rad], Cl_p [1/rad], Cl_r [1/rad], Cm_0 [1],
        Cm_alpha [1/rad], Cm_elevator [1/rad], Cm_q [1/rad], c_wing [m], Cn_aileron [1/rad],
        Cn_beta [1/rad], Cn_r [1/rad], Cn_rudder [1/rad], z_fin [m], A_disc [m^2], b [m],
        CL_fin [1], CL_gamma [1/rad], tau_rudder [1], Ap [m^2], fin_apart [1], z_h [m], x_h
        [m], downwash [1], i_h [rad], tau_elevator [1], CL_h [1/rad], CL_h_max [1], S_h
        [m^2], tailplane_apart [1], v_stop [m/s], runway_width [m], psi_loop [rad], x_tip
        [m], z_tip [m], propeller_diameter [m], x_propeller [m], z_thrust [m], g [m/s^2], m
        [kg], Ixx [kg m^2], Ixz [kg m^2], Iyy [kg m^2], Izz [kg m^2], I_swivel [kg m^2],
        c_swivel [N m s/rad]

    Outputs
    -------
    place : 7 x 3, where each part acts, from the CG along body x, y, z [m]
    force : 7 x 3, with what force along body x, y, z [N]

    Thesis
    ------
    Eq. 4.10 at the foot, Eq. 4.10 at the contact, Eq. 4.10, Eq. 4.13, at any speed, Eq.
    3.3, never below 0, Eq. 3.5, never below a thousandth, Eq. 3.6, Eq. 3.10, Eq. 3.9, Eq.
    3.8, Eq. 3.7, Eq. 3.11, Eq. 4.10 through the air, Eq. 4.19, Eq. 4.29
    """
    x_ = ca.SX.sym("x", 14)
    u, v, w, p, q, r, chi_third, chi_rate_third, X, Y, Z, phi, theta, psi = ca.vertsplit(x_)
    u_ = ca.SX.sym("u", 11)
    brake_left, brake_right, pedal, steering, wind_x, wind_y, rudder, aileron, elevator, thrust, F_disturbance = ca.vertsplit(u_)
    p_ = ca.SX.sym("p", 98)
    a, track, z_main, c_main, k_main, toe, v_rest, B3, C3, B5, C5, surface_left, B1, E1, C1, D1, mu_roll_left, surface_right, mu_roll_right, a_third, z_third, c_third, k_third, steering_ratio, break_out, k_stop, k_swivel, stop, swivels, trail, B3_third, C3_third, B5_third, C5_third, surface_third, B1_third, E1_third, C1_third, D1_third, mu_roll_third, rudder_max, S_wing, rho, CL_0, CL_alpha, CL_max, CD_0, K_drag, CY_beta, CY_r, CY_rudder, b_wing, Cl_aileron, Cl_beta, Cl_p, Cl_r, Cm_0, Cm_alpha, Cm_elevator, Cm_q, c_wing, Cn_aileron, Cn_beta, Cn_r, Cn_rudder, z_fin, A_disc, b, CL_fin, CL_gamma, tau_rudder, Ap, fin_apart, z_h, x_h, downwash, i_h, tau_elevator, CL_h, CL_h_max, S_h, tailplane_apart, v_stop, runway_width, psi_loop, x_tip, z_tip, propeller_diameter, x_propeller, z_thrust, g, m, Ixx, Ixz, Iyy, Izz, I_swivel, c_swivel = ca.vertsplit(p_)
    R_Zz = ca.cos(phi)*ca.cos(theta)  # rotation by psi, theta, phi
    tilt_left = R_Zz  # direction cosine
    R_Zx = -ca.sin(theta)  # rotation by psi, theta, phi
    R_Zy = ca.sin(phi)*ca.cos(theta)  # rotation by psi, theta, phi
    w6 = (1/2)*R_Zy*track
    w7 = R_Zx*a + R_Zz*z_main + Z
    depth_left = -w6 + w7  # geometry
    stroke_left = depth_left/tilt_left  # geometry
    w9 = (1/2)*r*track
    foot_u_left = -q*stroke_left + q*z_main + u + w9  # Eq. 4.10 at the foot
    w10 = a*r - p*z_main + v
    foot_v_left = p*stroke_left + w10  # Eq. 4.10 at the foot
    w13 = (1/2)*p*track
    foot_w_left = -a*q + w - w13  # Eq. 4.10 at the foot
    sinking_left = R_Zx*foot_u_left + R_Zy*foot_v_left + R_Zz*foot_w_left  # direction cosines
    w15 = ca.fmax(0, ca.fmin(1, stroke_left/0.0001))
    touching_left = w15**3*(6*w15**2 - 15*w15 + 10)  # nothing above the ground
    F_leg_left = touching_left*(c_main*sinking_left/tilt_left + k_main*stroke_left)  # spring and damper
    w17 = -0.0001*k_main
    w18 = 1/(0.0001*k_main)
    w19 = ca.fmax(0, ca.fmin(1, F_leg_left*w18))
    Fz_left = (0.0001*k_main*w19**3*(3*w19**2 - 8*w19 + 6) + ca.fmax(0, F_leg_left + w17))/tilt_left  # a leg never pulls
    w21 = R_Zx*ca.cos(toe)
    w23 = R_Zy*ca.sin(toe)
    slope_left = w21 + w23  # direction cosine
    flat_left = ca.sqrt(1 - slope_left**2)  # projection on the runway
    V_x_left = (foot_u_left*ca.cos(toe) + foot_v_left*ca.sin(toe) - sinking_left*slope_left)/flat_left  # Eq. 4.10 at the contact
    w25 = R_Zz*ca.cos(toe)
    w26 = R_Zz*ca.sin(toe)
    w27 = R_Zx*ca.sin(toe)
    w28 = R_Zy*ca.cos(toe)
    V_y_left = (-foot_u_left*w26 + foot_v_left*w25 + foot_w_left*(w27 - w28))/flat_left  # Eq. 4.10
    w31 = (1/1000000)*v_rest**2
    w32 = V_x_left**2 + w31
    tan_alpha_left = V_y_left/ca.sqrt(w32)  # Eq. 4.13, at any speed
    V2_fade_left = ca.sqrt(v_rest**4 + (V_x_left**2 + V_y_left**2)**2)  # near rest
    V_fade_left = ca.sqrt(V2_fade_left)  # near rest
    C_c_left = ca.fmax(0, B3 + C3*Fz_left)  # Eq. 3.3, never below 0
    mu_left = surface_left*ca.fmax(1/1000, B5 + C5*Fz_left)  # Eq. 3.5, never below a thousandth
    alpha_free_left = C_c_left*tan_alpha_left/mu_left  # Eq. 3.6
    w38 = 1/(B1*ca.sqrt(ca.fmax(1/1000000000000, E1 - 1)))
    alpha_bar_left = ca.fmax(-w38, ca.fmin(alpha_free_left, w38))  # held at the peak
    psi_bar_left = alpha_bar_left*(1 - E1) + E1*ca.atan(B1*alpha_bar_left)/B1  # Eq. 3.10
    theta_bar_left = C1*ca.atan(B1*psi_bar_left)  # Eq. 3.9
    F_bar_left = D1*ca.sin(theta_bar_left)  # Eq. 3.8
    grip_left = F_bar_left  # Eq. 3.7
    braked_left = (brake_left*(mu_left - mu_roll_left) + mu_roll_left)/mu_left  # brake
    w42 = braked_left + 1/200000
    w44 = ca.fmax(-w42, ca.fmin(w42, V_x_left/V_fade_left))
    w47 = ca.fmax(0, -100000*braked_left - 100000*w44 + 1/2)
    w48 = ca.fmax(0, -100000*braked_left + 100000*w44 + 1/2)
    along_left = w44 + (1/100000)*w47**3*(1 - 1/2*w47) - 1/100000*w48**3*(1 - 1/2*w48)  # a locked wheel slides
    left_over_left = ca.sqrt(1 - along_left**2)  # friction ellipse
    w49 = grip_left*ca.sqrt(V_y_left**2 + w32)
    w50 = 1/V_fade_left**2
    w51 = (V_y_left*w49*w50 + 1/1000000000000)/(V_y_left**2*w50 + 1/2000000000000)
    w52 = ca.fmax(0, ca.fmin(1, 50*brake_left - 50*w51))
    asked_left = V_y_left*((1/50)*w52**3*(3*w52**2 - 8*w52 + 6) + ca.fmax(0, brake_left - w51 - 1/50))/V_fade_left + w49/V_fade_left  # slip, or a locked wheel that slides
    w53 = left_over_left + 1/200000
    w54 = ca.fmax(-w53, ca.fmin(asked_left, w53))
    w57 = ca.fmax(0, -100000*left_over_left - 100000*w54 + 1/2)
    w58 = ca.fmax(0, -100000*left_over_left + 100000*w54 + 1/2)
    across_left = w54 + (1/100000)*w57**3*(1 - 1/2*w57) - 1/100000*w58**3*(1 - 1/2*w58)  # friction ellipse
    F_x_left = Fz_left*along_left*mu_left  # Eq. 3.11
    F_y_left = Fz_left*across_left*mu_left  # Eq. 3.11
    w60 = -ca.cos(toe)
    push_x_left = -F_x_left*(-R_Zx*slope_left - w60)/flat_left + F_y_left*R_Zz*ca.sin(toe)/flat_left - Fz_left*R_Zx  # resolved
    push_y_left = -F_x_left*(-R_Zy*slope_left + ca.sin(toe))/flat_left - F_y_left*w25/flat_left - Fz_left*R_Zy  # resolved
    push_z_left = F_x_left*R_Zz*slope_left/flat_left - F_y_left*(w27 - w28)/flat_left - Fz_left*R_Zz  # resolved
    tilt_right = R_Zz  # direction cosine
    depth_right = w6 + w7  # geometry
    stroke_right = depth_right/tilt_right  # geometry
    foot_u_right = -q*stroke_right + q*z_main + u - w9  # Eq. 4.10 at the foot
    foot_v_right = p*stroke_right + w10  # Eq. 4.10 at the foot
    foot_w_right = -a*q + w + w13  # Eq. 4.10 at the foot
    sinking_right = R_Zx*foot_u_right + R_Zy*foot_v_right + R_Zz*foot_w_right  # direction cosines
    w64 = ca.fmax(0, ca.fmin(1, stroke_right/0.0001))
    touching_right = w64**3*(6*w64**2 - 15*w64 + 10)  # nothing above the ground
    F_leg_right = touching_right*(c_main*sinking_right/tilt_right + k_main*stroke_right)  # spring and damper
    w65 = ca.fmax(0, ca.fmin(1, F_leg_right*w18))
    Fz_right = (0.0001*k_main*w65**3*(3*w65**2 - 8*w65 + 6) + ca.fmax(0, F_leg_right + w17))/tilt_right  # a leg never pulls
    slope_right = w21 - w23  # direction cosine
    flat_right = ca.sqrt(1 - slope_right**2)  # projection on the runway
    V_x_right = (foot_u_right*ca.cos(toe) - foot_v_right*ca.sin(toe) - sinking_right*slope_right)/flat_right  # Eq. 4.10 at the contact
    w67 = -w27 - w28
    V_y_right = (foot_u_right*w26 + foot_v_right*w25 + foot_w_right*w67)/flat_right  # Eq. 4.10
    w69 = V_x_right**2 + w31
    tan_alpha_right = V_y_right/ca.sqrt(w69)  # Eq. 4.13, at any speed
    V2_fade_right = ca.sqrt(v_rest**4 + (V_x_right**2 + V_y_right**2)**2)  # near rest
    V_fade_right = ca.sqrt(V2_fade_right)  # near rest
    C_c_right = ca.fmax(0, B3 + C3*Fz_right)  # Eq. 3.3, never below 0
    mu_right = surface_right*ca.fmax(1/1000, B5 + C5*Fz_right)  # Eq. 3.5, never below a thousandth
    alpha_free_right = C_c_right*tan_alpha_right/mu_right  # Eq. 3.6
    alpha_bar_right = ca.fmax(-w38, ca.fmin(alpha_free_right, w38))  # held at the peak
    psi_bar_right = alpha_bar_right*(1 - E1) + E1*ca.atan(B1*alpha_bar_right)/B1  # Eq. 3.10
    theta_bar_right = C1*ca.atan(B1*psi_bar_right)  # Eq. 3.9
    F_bar_right = D1*ca.sin(theta_bar_right)  # Eq. 3.8
    grip_right = F_bar_right  # Eq. 3.7
    braked_right = (brake_right*(mu_right - mu_roll_right) + mu_roll_right)/mu_right  # brake
    w72 = braked_right + 1/200000
    w74 = ca.fmax(-w72, ca.fmin(w72, V_x_right/V_fade_right))
    w77 = ca.fmax(0, -100000*braked_right - 100000*w74 + 1/2)
    w78 = ca.fmax(0, -100000*braked_right + 100000*w74 + 1/2)
    along_right = w74 + (1/100000)*w77**3*(1 - 1/2*w77) - 1/100000*w78**3*(1 - 1/2*w78)  # a locked wheel slides
    left_over_right = ca.sqrt(1 - along_right**2)  # friction ellipse
    w79 = grip_right*ca.sqrt(V_y_right**2 + w69)
    w80 = 1/V_fade_right**2
    w81 = (V_y_right*w79*w80 + 1/1000000000000)/(V_y_right**2*w80 + 1/2000000000000)
    w82 = ca.fmax(0, ca.fmin(1, 50*brake_right - 50*w81))
    asked_right = V_y_right*((1/50)*w82**3*(3*w82**2 - 8*w82 + 6) + ca.fmax(0, brake_right - w81 - 1/50))/V_fade_right + w79/V_fade_right  # slip, or a locked wheel that slides
    w83 = left_over_right + 1/200000
    w84 = ca.fmax(-w83, ca.fmin(asked_right, w83))
    w87 = ca.fmax(0, -100000*left_over_right - 100000*w84 + 1/2)
    w88 = ca.fmax(0, -100000*left_over_right + 100000*w84 + 1/2)
    across_right = w84 + (1/100000)*w87**3*(1 - 1/2*w87) - 1/100000*w88**3*(1 - 1/2*w88)  # friction ellipse
    F_x_right = Fz_right*along_right*mu_right  # Eq. 3.11
    F_y_right = Fz_right*across_right*mu_right  # Eq. 3.11
    push_x_right = -F_x_right*(-R_Zx*slope_right - w60)/flat_right - F_y_right*w26/flat_right - Fz_right*R_Zx  # resolved
    push_y_right = -F_x_right*(-R_Zy*slope_right - ca.sin(toe))/flat_right - F_y_right*w25/flat_right - Fz_right*R_Zy  # resolved
    push_z_right = F_x_right*R_Zz*slope_right/flat_right - F_y_right*w67/flat_right - Fz_right*R_Zz  # resolved
    tilt_third = R_Zz  # direction cosine
    depth_third = R_Zx*a_third + R_Zz*z_third + Z  # geometry
    stroke_third = depth_third/tilt_third  # geometry
    foot_u_third = -q*stroke_third + q*z_third + u  # Eq. 4.10 at the foot
    foot_v_third = a_third*r + p*stroke_third - p*z_third + v  # Eq. 4.10 at the foot
    foot_w_third = -a_third*q + w  # Eq. 4.10 at the foot
    sinking_third = R_Zx*foot_u_third + R_Zy*foot_v_third + R_Zz*foot_w_third  # direction cosines
    w93 = ca.fmax(0, ca.fmin(1, stroke_third/0.0001))
    touching_third = w93**3*(6*w93**2 - 15*w93 + 10)  # nothing above the ground
    F_leg_third = touching_third*(c_third*sinking_third/tilt_third + k_third*stroke_third)  # spring and damper
    w95 = ca.fmax(0, ca.fmin(1, F_leg_third/(0.0001*k_third)))
    Fz_third = (0.0001*k_third*w95**3*(3*w95**2 - 8*w95 + 6) + ca.fmax(0, F_leg_third - 0.0001*k_third))/tilt_third  # a leg never pulls
    commanded_third = pedal*steering_ratio + steering  # linkage
    wound_third = chi_third - commanded_third  # linkage
    delta_third = commanded_third + swivels*wound_third  # linkage or swivel
    slope_third = R_Zx*ca.cos(delta_third) + R_Zy*ca.sin(delta_third)  # direction cosine
    flat_third = ca.sqrt(1 - slope_third**2)  # projection on the runway
    V_x_third = (foot_u_third*ca.cos(delta_third) + foot_v_third*ca.sin(delta_third) - sinking_third*slope_third)/flat_third  # Eq. 4.10 at the contact
    w99 = R_Zz*ca.cos(delta_third)
    w100 = R_Zx*ca.sin(delta_third) - R_Zy*ca.cos(delta_third)
    V_y_third = -chi_rate_third*swivels*trail + (-R_Zz*foot_u_third*ca.sin(delta_third) + foot_v_third*w99 + foot_w_third*w100)/flat_third  # Eq. 4.10
    w102 = V_x_third**2 + w31
    tan_alpha_third = V_y_third/ca.sqrt(w102)  # Eq. 4.13, at any speed
    V2_fade_third = ca.sqrt(v_rest**4 + (V_x_third**2 + V_y_third**2)**2)  # near rest
    V_fade_third = ca.sqrt(V2_fade_third)  # near rest
    C_c_third = ca.fmax(0, B3_third + C3_third*Fz_third)  # Eq. 3.3, never below 0
    mu_third = surface_third*ca.fmax(1/1000, B5_third + C5_third*Fz_third)  # Eq. 3.5, never below a thousandth
    alpha_free_third = C_c_third*tan_alpha_third/mu_third  # Eq. 3.6
    w107 = 1/(B1_third*ca.sqrt(ca.fmax(1/1000000000000, E1_third - 1)))
    alpha_bar_third = ca.fmax(-w107, ca.fmin(alpha_free_third, w107))  # held at the peak
    psi_bar_third = -alpha_bar_third*(E1_third - 1) + E1_third*ca.atan(B1_third*alpha_bar_third)/B1_third  # Eq. 3.10
    theta_bar_third = C1_third*ca.atan(B1_third*psi_bar_third)  # Eq. 3.9
    F_bar_third = D1_third*ca.sin(theta_bar_third)  # Eq. 3.8
    grip_third = F_bar_third  # Eq. 3.7
    braked_third = mu_roll_third/mu_third  # brake
    w108 = braked_third + 1/200000
    w110 = ca.fmax(-w108, ca.fmin(w108, V_x_third/V_fade_third))
    w113 = ca.fmax(0, -100000*braked_third - 100000*w110 + 1/2)
    w114 = ca.fmax(0, -100000*braked_third + 100000*w110 + 1/2)
    along_third = w110 + (1/100000)*w113**3*(1 - 1/2*w113) - 1/100000*w114**3*(1 - 1/2*w114)  # a locked wheel slides
    left_over_third = ca.sqrt(1 - along_third**2)  # friction ellipse
    asked_third = grip_third*ca.sqrt(V_y_third**2 + w102)/V_fade_third  # slip
    w115 = left_over_third + 1/200000
    w116 = ca.fmax(-w115, ca.fmin(asked_third, w115))
    w119 = ca.fmax(0, -100000*left_over_third - 100000*w116 + 1/2)
    w120 = ca.fmax(0, -100000*left_over_third + 100000*w116 + 1/2)
    across_third = w116 + (1/100000)*w119**3*(1 - 1/2*w119) - 1/100000*w120**3*(1 - 1/2*w120)  # friction ellipse
    F_x_third = Fz_third*along_third*mu_third  # Eq. 3.11
    F_y_third = Fz_third*across_third*mu_third  # Eq. 3.11
    push_x_third = -F_x_third*(-R_Zx*slope_third + ca.cos(delta_third))/flat_third + F_y_third*R_Zz*ca.sin(delta_third)/flat_third - Fz_third*R_Zx  # resolved
    push_y_third = -F_x_third*(-R_Zy*slope_third + ca.sin(delta_third))/flat_third - F_y_third*w99/flat_third - Fz_third*R_Zy  # resolved
    push_z_third = F_x_third*R_Zz*slope_third/flat_third - F_y_third*w100/flat_third - Fz_third*R_Zz  # resolved
    R_Xx = ca.cos(psi)*ca.cos(theta)  # rotation by psi, theta, phi
    R_Yx = ca.sin(psi)*ca.cos(theta)  # rotation by psi, theta, phi
    wind_u = R_Xx*wind_x + R_Yx*wind_y  # wind
    w126 = ca.sin(phi)*ca.cos(psi)
    R_Xy = w126*ca.sin(theta) - ca.sin(psi)*ca.cos(phi)  # rotation by psi, theta, phi
    w127 = ca.cos(phi)*ca.cos(psi)
    w128 = ca.sin(phi)*ca.sin(psi)
    R_Yy = w127 + w128*ca.sin(theta)  # rotation by psi, theta, phi
    wind_v = R_Xy*wind_x + R_Yy*wind_y  # wind
    R_Xz = w127*ca.sin(theta) + w128  # rotation by psi, theta, phi
    R_Yz = -w126 + ca.sin(psi)*ca.sin(theta)*ca.cos(phi)  # rotation by psi, theta, phi
    wind_w = R_Xz*wind_x + R_Yz*wind_y  # wind
    V_axial_fin = q*z_fin + u - wind_u  # Eq. 4.10 through the air
    w131 = -0.001**2
    w132 = 2*thrust/(A_disc*ca.sqrt(rho**2 + 1e-06**2))
    w133 = V_axial_fin*ca.sqrt(V_axial_fin**2 + 0.001**2) + w132
    w134 = 1/0.001**2
    w135 = ca.fmax(0, ca.fmin(1, w133*w134))
    V_s_fin = ca.sqrt(0.001**2*w135**3*(3*w135**2 - 8*w135 + 6) + ca.fmax(0, w131 + w133) + 0.001**2)  # momentum theory
    V_side_fin = -b*r - p*z_fin + v - wind_v  # Eq. 4.10 through the air
    gamma_fin = ca.atan2(V_side_fin, V_s_fin)  # Eq. 4.19
    delta_rudder_fin = -pedal*rudder_max + rudder  # linkage
    w136 = CL_fin + 1/10
    w137 = ca.fmax(-w136, ca.fmin(w136, CL_gamma*(-delta_rudder_fin*tau_rudder + gamma_fin)))
    w140 = ca.fmax(0, -5*CL_fin - 5*w137 + 1/2)
    w141 = ca.fmax(0, -5*CL_fin + 5*w137 + 1/2)
    C_L_fin = w137 + (1/5)*w140**3*(1 - 1/2*w140) - 1/5*w141**3*(1 - 1/2*w141)  # stall
    F_L_fin = (1/2)*Ap*C_L_fin*fin_apart*rho*(V_s_fin**2 + V_side_fin**2)  # Eq. 4.29
    V_axial_tailplane = q*z_h + u - wind_u  # Eq. 4.10 through the air
    w143 = V_axial_tailplane*ca.sqrt(V_axial_tailplane**2 + 0.001**2) + w132
    w144 = ca.fmax(0, ca.fmin(1, w134*w143))
    V_s_tailplane = ca.sqrt(0.001**2*w144**3*(3*w144**2 - 8*w144 + 6) + ca.fmax(0, w131 + w143) + 0.001**2)  # momentum theory
    V_down_tailplane = -q*x_h + w - wind_w  # Eq. 4.10 through the air
    gamma_tailplane = elevator*tau_elevator + i_h + (1 - downwash)*ca.atan2(V_down_tailplane, V_s_tailplane)  # geometry
    w145 = CL_h_max + 1/10
    w146 = ca.fmax(-w145, ca.fmin(w145, CL_h*gamma_tailplane))
    w149 = ca.fmax(0, -5*CL_h_max - 5*w146 + 1/2)
    w150 = ca.fmax(0, -5*CL_h_max + 5*w146 + 1/2)
    C_L_tailplane = w146 + (1/5)*w149**3*(1 - 1/2*w149) - 1/5*w150**3*(1 - 1/2*w150)  # stall
    F_L_tailplane = (1/2)*C_L_tailplane*S_h*rho*tailplane_apart*(V_down_tailplane**2 + V_s_tailplane**2)  # lift
    place_ = ca.blockcat([
        [a, -1/2*track, -stroke_left + z_main],
        [a, (1/2)*track, -stroke_right + z_main],
        [a_third, 0, -stroke_third + z_third],
        [-b, 0, z_fin],
        [x_h, 0, z_h],
        [0, 0, z_thrust],
        [-b, 0, 0],
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
        "landing_roll_places",
        [x_, u_, p_],
        [place_, force_],
        ["x", "u", "p"],
        ["place", "force"],
    )


@cache
def rk4() -> ca.Function:
    """Integrate the model over an interval: see `integrators.interval`."""
    return integrators.interval(rhs(), "landing_roll_rk4", "rk4")


@cache
def rk45() -> ca.Function:
    """Integrate the model over an interval: see `integrators.interval`."""
    return integrators.interval(rhs(), "landing_roll_rk45", "rk45")
