# Generated from derive/ (digest bfd9ab80ef38709d) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`.
"""Closed forms of the linear model (Section 4.7 and what it leaves unsaid)."""

from functools import cache

import casadi as ca


@cache
def state_matrix() -> ca.Function:
    """A of the linear model.

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

    Outputs
    -------
    A_vv : 1 x 1, d v_dot / d v [1/s]
    A_vr : 1 x 1, d v_dot / d r [m/s]
    A_rv : 1 x 1, d r_dot / d v [1/(m s)]
    A_rr : 1 x 1, d r_dot / d r [1/s]

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
    C_f = 2*C_alpha  # Eq. 4.28
    k = (1/2)*Ap*CL_gamma*rho  # Eq. 4.29
    K = Ct + k*u**2  # Eq. 4.31
    w3 = 1/(m*u)
    A_vv = -w3*(C_f + K)  # Eq. 4.31
    w4 = C_f*a - K*b
    A_vr = -w3*(m*u**2 + w4)  # Eq. 4.31
    w5 = 1/(Izz*u)
    A_rv = -w4*w5  # Eq. 4.31
    A_rr = -w5*(C_f*a**2 + K*b**2)  # Eq. 4.31
    return ca.Function(
        "state_matrix",
        [m, Izz, a, b, u, rho, Ap, CL_gamma, C_alpha, Ct],
        [A_vv, A_vr, A_rv, A_rr],
        ["m", "Izz", "a", "b", "u", "rho", "Ap", "CL_gamma", "C_alpha", "Ct"],
        ["A_vv", "A_vr", "A_rv", "A_rr"],
    )


@cache
def routh_hurwitz() -> ca.Function:
    """Trace and determinant of A: stable if and only if trace < 0 < det.

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

    Outputs
    -------
    trace : 1 x 1, tr A: stable needs < 0 [1/s]
    det : 1 x 1, det A: stable needs > 0 [1/s^2]
    discriminant : 1 x 1, negative: the modes oscillate [1/s^2]

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
    C_f = 2*C_alpha  # Eq. 4.28
    k = (1/2)*Ap*CL_gamma*rho  # Eq. 4.29
    K = Ct + k*u**2  # Eq. 4.31
    w4 = 1/(m*u)
    w6 = 1/(Izz*u)
    trace = C_f*(-a**2*w6 - w4) + K*(-b**2*w6 - w4)  # Section 4.7
    det = C_f*K*(a + b)**2/(Izz*m*u**2) - C_f*a/Izz + K*b/Izz  # Section 4.7
    discriminant = -4*det + trace**2  # Section 4.7
    return ca.Function(
        "routh_hurwitz",
        [m, Izz, a, b, u, rho, Ap, CL_gamma, C_alpha, Ct],
        [trace, det, discriminant],
        ["m", "Izz", "a", "b", "u", "rho", "Ap", "CL_gamma", "C_alpha", "Ct"],
        ["trace", "det", "discriminant"],
    )


@cache
def modes() -> ca.Function:
    """Eigenvalues of a 2 x 2 state matrix and what is read from them.

    Inputs
    ------
    A_vv : scalar [1/s], d v_dot / d v
    A_vr : scalar [m/s], d v_dot / d r
    A_rv : scalar [1/(m s)], d r_dot / d v
    A_rr : scalar [1/s], d r_dot / d r

    Outputs
    -------
    re_1 : 1 x 1, real part of the first eigenvalue [1/s]
    im_1 : 1 x 1, imaginary part of the first eigenvalue [rad/s]
    re_2 : 1 x 1, real part of the second eigenvalue [1/s]
    im_2 : 1 x 1, imaginary part of the second eigenvalue [rad/s]
    decay_rate : 1 x 1, -max Re(eigenvalue): stable if positive [1/s]
    natural_frequency : 1 x 1, undamped natural frequency [rad/s]
    damped_frequency : 1 x 1, size of the imaginary part of an eigenvalue [rad/s]
    damping_ratio : 1 x 1, above 1: two real eigenvalues [1]
    """
    A_vv = ca.SX.sym("A_vv")
    A_vr = ca.SX.sym("A_vr")
    A_rv = ca.SX.sym("A_rv")
    A_rr = ca.SX.sym("A_rr")
    trace = A_rr + A_vv  # Section 4.7
    w3 = A_rr*A_vv - A_rv*A_vr
    det = ca.if_else(ca.fabs(w3) < (1/281474976710656)*ca.fabs(A_rr*A_vv) + (1/281474976710656)*ca.fabs(A_rv*A_vr), 0, w3)  # Section 4.7
    discriminant = 4*A_rv*A_vr + (-A_rr + A_vv)**2  # Section 4.7
    separation = (1/2)*ca.sqrt(ca.fabs(discriminant))  # Section 4.7
    spread = ca.if_else(discriminant > 0, separation, 0)  # Section 4.7
    damped_frequency = ca.if_else(discriminant < 0, separation, 0)  # Section 4.5.7
    re_2 = -spread + (1/2)*trace  # Section 4.7
    re_1 = ca.if_else(spread*trace < -1/4*trace**2, det/re_2, spread + (1/2)*trace)  # Section 4.7
    im_1 = damped_frequency  # Section 4.7
    im_2 = -damped_frequency  # Section 4.7
    decay_rate = ca.if_else(ca.fabs(re_1) <= 0, 0, -re_1)  # Section 4.7
    natural_frequency = ca.sqrt(det)  # Section 4.5.7
    damping_ratio = -1/2*trace/natural_frequency  # Section 4.5.7
    return ca.Function(
        "modes",
        [A_vv, A_vr, A_rv, A_rr],
        [re_1, im_1, re_2, im_2, decay_rate, natural_frequency, damped_frequency, damping_ratio],
        ["A_vv", "A_vr", "A_rv", "A_rr"],
        ["re_1", "im_1", "re_2", "im_2", "decay_rate", "natural_frequency", "damped_frequency", "damping_ratio"],
    )


@cache
def linear_modes() -> ca.Function:
    """Eigenvalues of the linear model, straight from the aircraft's parameters.

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

    Outputs
    -------
    re_1 : 1 x 1, real part of the first eigenvalue [1/s]
    im_1 : 1 x 1, imaginary part of the first eigenvalue [rad/s]
    re_2 : 1 x 1, real part of the second eigenvalue [1/s]
    im_2 : 1 x 1, imaginary part of the second eigenvalue [rad/s]
    decay_rate : 1 x 1, -max Re(eigenvalue): stable if positive [1/s]
    natural_frequency : 1 x 1, undamped natural frequency [rad/s]
    damped_frequency : 1 x 1, size of the imaginary part of an eigenvalue [rad/s]
    damping_ratio : 1 x 1, above 1: two real eigenvalues [1]

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
    C_f = 2*C_alpha  # Eq. 4.28
    k = (1/2)*Ap*CL_gamma*rho  # Eq. 4.29
    K = Ct + k*u**2  # Eq. 4.31
    w3 = 1/(m*u)
    A_vv = -w3*(C_f + K)  # Eq. 4.31
    w4 = C_f*a - K*b
    A_vr = -w3*(m*u**2 + w4)  # Eq. 4.31
    w5 = 1/(Izz*u)
    A_rv = -w4*w5  # Eq. 4.31
    A_rr = -w5*(C_f*a**2 + K*b**2)  # Eq. 4.31
    trace = A_rr + A_vv  # Section 4.7
    w8 = A_rr*A_vv - A_rv*A_vr
    det = ca.if_else(ca.fabs(w8) < (1/281474976710656)*ca.fabs(A_rr*A_vv) + (1/281474976710656)*ca.fabs(A_rv*A_vr), 0, w8)  # Section 4.7
    discriminant = 4*A_rv*A_vr + (-A_rr + A_vv)**2  # Section 4.7
    separation = (1/2)*ca.sqrt(ca.fabs(discriminant))  # Section 4.7
    spread = ca.if_else(discriminant > 0, separation, 0)  # Section 4.7
    damped_frequency = ca.if_else(discriminant < 0, separation, 0)  # Section 4.5.7
    re_2 = -spread + (1/2)*trace  # Section 4.7
    re_1 = ca.if_else(spread*trace < -1/4*trace**2, det/re_2, spread + (1/2)*trace)  # Section 4.7
    im_1 = damped_frequency  # Section 4.7
    im_2 = -damped_frequency  # Section 4.7
    decay_rate = ca.if_else(ca.fabs(re_1) <= 0, 0, -re_1)  # Section 4.7
    natural_frequency = ca.sqrt(det)  # Section 4.5.7
    damping_ratio = -1/2*trace/natural_frequency  # Section 4.5.7
    return ca.Function(
        "linear_modes",
        [m, Izz, a, b, u, rho, Ap, CL_gamma, C_alpha, Ct],
        [re_1, im_1, re_2, im_2, decay_rate, natural_frequency, damped_frequency, damping_ratio],
        ["m", "Izz", "a", "b", "u", "rho", "Ap", "CL_gamma", "C_alpha", "Ct"],
        ["re_1", "im_1", "re_2", "im_2", "decay_rate", "natural_frequency", "damped_frequency", "damping_ratio"],
    )


@cache
def times() -> ca.Function:
    """How fast a deviation dies out or grows.

    Inputs
    ------
    decay_rate : scalar [1/s], -max Re(eigenvalue): stable if positive

    Outputs
    -------
    T_half : 1 x 1, in which a deviation halves; infinite if it never does [s]
    T_double : 1 x 1, in which a deviation doubles; infinite if it never does [s]
    """
    decay_rate = ca.SX.sym("decay_rate")
    w2 = 2*ca.log(2)
    T_half = w2/(decay_rate + ca.fabs(decay_rate))  # definition
    T_double = w2/(-decay_rate + ca.fabs(decay_rate))  # definition
    return ca.Function(
        "times",
        [decay_rate],
        [T_half, T_double],
        ["decay_rate"],
        ["T_half", "T_double"],
    )


@cache
def speed_window() -> ca.Function:
    """Speeds between which the linear model is unstable; NaN where there are none.

    Inputs
    ------
    m : scalar [kg], total mass
    a : scalar [m], main gear ahead of the CG (positive: taildragger)
    b : scalar [m], CG ahead of the vertical tail and the tail wheel
    rho : scalar [kg/m^3], density of the air
    Ap : scalar [m^2], area of the vertical tail
    CL_gamma : scalar [1/rad], lift-curve slope of the vertical tail
    C_alpha : scalar [N/rad], cornering stiffness of one main tire
    Ct : scalar [N/rad], cornering stiffness of the tail wheel

    Outputs
    -------
    u_low : 1 x 1, the aircraft is unstable from here [m/s]
    u_high : 1 x 1, to here [m/s]

    Thesis
    ------
    Eq. 4.28, Eq. 4.29
    """
    m = ca.SX.sym("m")
    a = ca.SX.sym("a")
    b = ca.SX.sym("b")
    rho = ca.SX.sym("rho")
    Ap = ca.SX.sym("Ap")
    CL_gamma = ca.SX.sym("CL_gamma")
    C_alpha = ca.SX.sym("C_alpha")
    Ct = ca.SX.sym("Ct")
    C_f = 2*C_alpha  # Eq. 4.28
    w2 = (1/2)*Ap*CL_gamma*rho
    k = w2  # Eq. 4.29
    C_f = 2*C_alpha  # Eq. 4.28
    k = w2  # Eq. 4.29
    q_0 = C_f*Ct*(a + b)**2  # from det A = 0
    q_1 = C_f*a**2*k + 2*C_f*a*b*k - C_f*a*m + C_f*b**2*k + Ct*b*m  # from det A = 0
    q_2 = b*k*m  # from det A = 0
    q_root = -q_1 + ca.sqrt(-4*q_0*q_2 + q_1**2)  # from det A = 0
    w5 = ca.sqrt(2)
    u_low = w5*ca.sqrt(q_0*q_root)/q_root  # from det A = 0
    u_high = (1/2)*q_root*w5/ca.sqrt(q_2*q_root)  # from det A = 0
    return ca.Function(
        "speed_window",
        [m, a, b, rho, Ap, CL_gamma, C_alpha, Ct],
        [u_low, u_high],
        ["m", "a", "b", "rho", "Ap", "CL_gamma", "C_alpha", "Ct"],
        ["u_low", "u_high"],
    )


@cache
def weakest_speed() -> ca.Function:
    """The speed at which det A is least, and det A there.

    Inputs
    ------
    m : scalar [kg], total mass
    Izz : scalar [kg m^2], moment of inertia about the z axis
    a : scalar [m], main gear ahead of the CG (positive: taildragger)
    b : scalar [m], CG ahead of the vertical tail and the tail wheel
    rho : scalar [kg/m^3], density of the air
    Ap : scalar [m^2], area of the vertical tail
    CL_gamma : scalar [1/rad], lift-curve slope of the vertical tail
    C_alpha : scalar [N/rad], cornering stiffness of one main tire
    Ct : scalar [N/rad], cornering stiffness of the tail wheel

    Outputs
    -------
    u_weakest : 1 x 1, speed at which det A is least [m/s]
    det_weakest : 1 x 1, det A there [1/s^2]

    Thesis
    ------
    Eq. 4.28, Eq. 4.29
    """
    m = ca.SX.sym("m")
    Izz = ca.SX.sym("Izz")
    a = ca.SX.sym("a")
    b = ca.SX.sym("b")
    rho = ca.SX.sym("rho")
    Ap = ca.SX.sym("Ap")
    CL_gamma = ca.SX.sym("CL_gamma")
    C_alpha = ca.SX.sym("C_alpha")
    Ct = ca.SX.sym("Ct")
    C_f = 2*C_alpha  # Eq. 4.28
    k = (1/2)*Ap*CL_gamma*rho  # Eq. 4.29
    q_0 = C_f*Ct*(a + b)**2  # from det A = 0
    q_1 = C_f*a**2*k + 2*C_f*a*b*k - C_f*a*m + C_f*b**2*k + Ct*b*m  # from det A = 0
    q_2 = b*k*m  # from det A = 0
    s_weakest = ca.sqrt(q_0/q_2)  # from d(det A)/ds = 0
    u_weakest = ca.sqrt(s_weakest)  # from d(det A)/ds = 0
    det_weakest = (q_1 + 2*ca.sqrt(q_0*q_2))/(Izz*m)  # from d(det A)/ds = 0
    return ca.Function(
        "weakest_speed",
        [m, Izz, a, b, rho, Ap, CL_gamma, C_alpha, Ct],
        [u_weakest, det_weakest],
        ["m", "Izz", "a", "b", "rho", "Ap", "CL_gamma", "C_alpha", "Ct"],
        ["u_weakest", "det_weakest"],
    )


@cache
def stationary_decay() -> ca.Function:
    """Where over speed the decay rate may be least.

    Inputs
    ------
    m : scalar [kg], total mass
    Izz : scalar [kg m^2], moment of inertia about the z axis
    a : scalar [m], main gear ahead of the CG (positive: taildragger)
    b : scalar [m], CG ahead of the vertical tail and the tail wheel
    rho : scalar [kg/m^3], density of the air
    Ap : scalar [m^2], area of the vertical tail
    CL_gamma : scalar [1/rad], lift-curve slope of the vertical tail
    C_alpha : scalar [N/rad], cornering stiffness of one main tire
    Ct : scalar [N/rad], cornering stiffness of the tail wheel

    Outputs
    -------
    e_0 : 1 x 1, coefficient of s^0: a real eigenvalue is stationary at a root [N^4 m^4 s^0]
    e_1 : 1 x 1, coefficient of s^1: a real eigenvalue is stationary at a root [N^4 m^2 s^2]
    e_2 : 1 x 1, coefficient of s^2: a real eigenvalue is stationary at a root [N^4 m^0 s^4]
    e_3 : 1 x 1, coefficient of s^3: a real eigenvalue is stationary at a root [N^4 m^-2 s^6]
    e_4 : 1 x 1, coefficient of s^4: a real eigenvalue is stationary at a root [N^4 m^-4 s^8]
    u_trace : 1 x 1, speed at which -tr A is least [m/s]

    Thesis
    ------
    Eq. 4.28, Eq. 4.29
    """
    m = ca.SX.sym("m")
    Izz = ca.SX.sym("Izz")
    a = ca.SX.sym("a")
    b = ca.SX.sym("b")
    rho = ca.SX.sym("rho")
    Ap = ca.SX.sym("Ap")
    CL_gamma = ca.SX.sym("CL_gamma")
    C_alpha = ca.SX.sym("C_alpha")
    Ct = ca.SX.sym("Ct")
    C_f = 2*C_alpha  # Eq. 4.28
    k = (1/2)*Ap*CL_gamma*rho  # Eq. 4.29
    q_0 = C_f*Ct*(a + b)**2  # from det A = 0
    q_1 = C_f*a**2*k + 2*C_f*a*b*k - C_f*a*m + C_f*b**2*k + Ct*b*m  # from det A = 0
    q_2 = b*k*m  # from det A = 0
    w7 = 1/m + b**2/Izz
    t_slow = C_f*(1/m + a**2/Izz) + Ct*w7  # Section 4.7
    t_fast = k*w7  # Section 4.7
    u_trace = ca.sqrt(t_slow/t_fast)  # from d(tr A)/du = 0
    w9 = Izz*m*t_slow**2
    e_0 = -q_0*(-4*q_0 + w9)  # from d(lambda)/du = 0
    e_1 = -Izz*m*t_slow*(2*q_0*t_fast - q_1*t_slow)  # from d(lambda)/du = 0
    w12 = Izz*m*t_fast**2
    e_2 = -2*Izz*m*q_1*t_fast*t_slow - 8*q_0*q_2 + 3*q_0*w12 + 3*q_2*w9  # from d(lambda)/du = 0
    e_3 = Izz*m*t_fast*(q_1*t_fast - 2*q_2*t_slow)  # from d(lambda)/du = 0
    e_4 = -q_2*(-4*q_2 + w12)  # from d(lambda)/du = 0
    return ca.Function(
        "stationary_decay",
        [m, Izz, a, b, rho, Ap, CL_gamma, C_alpha, Ct],
        [e_0, e_1, e_2, e_3, e_4, u_trace],
        ["m", "Izz", "a", "b", "rho", "Ap", "CL_gamma", "C_alpha", "Ct"],
        ["e_0", "e_1", "e_2", "e_3", "e_4", "u_trace"],
    )


@cache
def steady_margins() -> ca.Function:
    """What the steady response says of stability.

    Inputs
    ------
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
    x_neutral : 1 x 1, ahead of the CG: where a side force gives no steady yaw rate [m]
    static_margin : 1 x 1, neutral-steer point behind the CG, over the wheelbase: stable if positive [1]
    K_us : 1 x 1, steer angle of the main wheels per lateral acceleration beyond that of pure rolling [rad s^2/m]

    Thesis
    ------
    Eq. 4.28, Eq. 4.29, Eq. 4.31
    """
    m = ca.SX.sym("m")
    a = ca.SX.sym("a")
    b = ca.SX.sym("b")
    u = ca.SX.sym("u")
    rho = ca.SX.sym("rho")
    Ap = ca.SX.sym("Ap")
    CL_gamma = ca.SX.sym("CL_gamma")
    C_alpha = ca.SX.sym("C_alpha")
    Ct = ca.SX.sym("Ct")
    C_f = 2*C_alpha  # Eq. 4.28
    k = (1/2)*Ap*CL_gamma*rho  # Eq. 4.29
    K = Ct + k*u**2  # Eq. 4.31
    L = a + b  # Section 4.2
    w1 = C_f*a - K*b
    x_neutral = w1/(C_f + K)  # Milliken, ch. 5
    static_margin = -x_neutral/L  # Milliken, ch. 5
    K_us = -m*w1/(C_f*K*L)  # Gillespie, ch. 6
    return ca.Function(
        "steady_margins",
        [m, a, b, u, rho, Ap, CL_gamma, C_alpha, Ct],
        [x_neutral, static_margin, K_us],
        ["m", "a", "b", "u", "rho", "Ap", "CL_gamma", "C_alpha", "Ct"],
        ["x_neutral", "static_margin", "K_us"],
    )


@cache
def tail_wheel_needed() -> ca.Function:
    """The tail wheel that stability asks for at a speed.

    Inputs
    ------
    m : scalar [kg], total mass
    a : scalar [m], main gear ahead of the CG (positive: taildragger)
    b : scalar [m], CG ahead of the vertical tail and the tail wheel
    u : scalar [m/s], forward speed, constant
    rho : scalar [kg/m^3], density of the air
    Ap : scalar [m^2], area of the vertical tail
    CL_gamma : scalar [1/rad], lift-curve slope of the vertical tail
    C_alpha : scalar [N/rad], cornering stiffness of one main tire

    Outputs
    -------
    Ct_needed : 1 x 1, tail wheel stiffness at which det A = 0 at this speed; negative: stable without [N/rad]

    Thesis
    ------
    Eq. 4.28, Eq. 4.29, Eq. 4.31
    """
    m = ca.SX.sym("m")
    a = ca.SX.sym("a")
    b = ca.SX.sym("b")
    u = ca.SX.sym("u")
    rho = ca.SX.sym("rho")
    Ap = ca.SX.sym("Ap")
    CL_gamma = ca.SX.sym("CL_gamma")
    C_alpha = ca.SX.sym("C_alpha")
    C_f = 2*C_alpha  # Eq. 4.28
    k = (1/2)*Ap*CL_gamma*rho  # Eq. 4.29
    w3 = m*u**2
    K_needed = C_f*a*w3/(C_f*a**2 + 2*C_f*a*b + C_f*b**2 + b*w3)  # from det A = 0
    Ct_needed = K_needed - k*u**2  # Eq. 4.31
    return ca.Function(
        "tail_wheel_needed",
        [m, a, b, u, rho, Ap, CL_gamma, C_alpha],
        [Ct_needed],
        ["m", "a", "b", "u", "rho", "Ap", "CL_gamma", "C_alpha"],
        ["Ct_needed"],
    )


@cache
def tail_wheel_always() -> ca.Function:
    """The tail wheel that stability asks for at every speed.

    Inputs
    ------
    m : scalar [kg], total mass
    a : scalar [m], main gear ahead of the CG (positive: taildragger)
    b : scalar [m], CG ahead of the vertical tail and the tail wheel
    rho : scalar [kg/m^3], density of the air
    Ap : scalar [m^2], area of the vertical tail
    CL_gamma : scalar [1/rad], lift-curve slope of the vertical tail
    C_alpha : scalar [N/rad], cornering stiffness of one main tire
    Ct : scalar [N/rad], cornering stiffness of the tail wheel

    Outputs
    -------
    Ct_always : 1 x 1, tail wheel stiffness from which det A > 0 at every speed [N/rad]
    speed_margin : 1 x 1, sqrt(b Ct/(L C_f)) + sqrt(L k/m) - sqrt(a/L): positive is stable at every speed [1]

    Thesis
    ------
    Eq. 4.28, Eq. 4.29
    """
    m = ca.SX.sym("m")
    a = ca.SX.sym("a")
    b = ca.SX.sym("b")
    rho = ca.SX.sym("rho")
    Ap = ca.SX.sym("Ap")
    CL_gamma = ca.SX.sym("CL_gamma")
    C_alpha = ca.SX.sym("C_alpha")
    Ct = ca.SX.sym("Ct")
    C_f = 2*C_alpha  # Eq. 4.28
    k = (1/2)*Ap*CL_gamma*rho  # Eq. 4.29
    L = a + b  # Section 4.2
    w1 = ca.sqrt(C_f)
    w2 = ca.sqrt(b)
    w3 = ca.sqrt(m)
    root_needed = w1*(-L*ca.sqrt(k) + w3*ca.sqrt(ca.fmax(0, a)))/(w2*w3)  # from q_1 + 2 sqrt(q_0 q_2) = 0
    Ct_always = ca.fmax(0, root_needed)**2  # its square
    speed_margin = w2*(ca.sqrt(Ct) - root_needed)/(ca.sqrt(L)*w1)  # from q_1 + 2 sqrt(q_0 q_2) > 0
    return ca.Function(
        "tail_wheel_always",
        [m, a, b, rho, Ap, CL_gamma, C_alpha, Ct],
        [Ct_always, speed_margin],
        ["m", "a", "b", "rho", "Ap", "CL_gamma", "C_alpha", "Ct"],
        ["Ct_always", "speed_margin"],
    )


@cache
def gear_position() -> ca.Function:
    """Gear positions between which the aircraft is unstable; NaN where there are none.

    Inputs
    ------
    m : scalar [kg], total mass
    b : scalar [m], CG ahead of the vertical tail and the tail wheel
    u : scalar [m/s], forward speed, constant
    rho : scalar [kg/m^3], density of the air
    Ap : scalar [m^2], area of the vertical tail
    CL_gamma : scalar [1/rad], lift-curve slope of the vertical tail
    C_alpha : scalar [N/rad], cornering stiffness of one main tire
    Ct : scalar [N/rad], cornering stiffness of the tail wheel

    Outputs
    -------
    a_lost : 1 x 1, gear ahead of the CG: unstable from here [m]
    a_regained : 1 x 1, to here [m]

    Thesis
    ------
    Eq. 4.28, Eq. 4.29, Eq. 4.31
    """
    m = ca.SX.sym("m")
    b = ca.SX.sym("b")
    u = ca.SX.sym("u")
    rho = ca.SX.sym("rho")
    Ap = ca.SX.sym("Ap")
    CL_gamma = ca.SX.sym("CL_gamma")
    C_alpha = ca.SX.sym("C_alpha")
    Ct = ca.SX.sym("Ct")
    C_f = 2*C_alpha  # Eq. 4.28
    k = (1/2)*Ap*CL_gamma*rho  # Eq. 4.29
    K = Ct + k*u**2  # Eq. 4.31
    w3 = 2*K*b
    h_0 = w3*(C_f*b + m*u**2)  # from det A = 0
    h_1 = -2*C_f*(m*u**2 - w3)  # from det A = 0
    h_2 = 2*C_f*K  # from det A = 0
    h_root = -h_1 + ca.sqrt(-4*h_0*h_2 + h_1**2)  # from det A = 0
    a_lost = 2*h_0/h_root  # from det A = 0
    a_regained = (1/2)*h_root/h_2  # from det A = 0
    return ca.Function(
        "gear_position",
        [m, b, u, rho, Ap, CL_gamma, C_alpha, Ct],
        [a_lost, a_regained],
        ["m", "b", "u", "rho", "Ap", "CL_gamma", "C_alpha", "Ct"],
        ["a_lost", "a_regained"],
    )


@cache
def gear_position_envelope() -> ca.Function:
    """The least gear position at which stability is lost at some speed.

    Inputs
    ------
    m : scalar [kg], total mass
    b : scalar [m], CG ahead of the vertical tail and the tail wheel
    rho : scalar [kg/m^3], density of the air
    Ap : scalar [m^2], area of the vertical tail
    CL_gamma : scalar [1/rad], lift-curve slope of the vertical tail
    C_alpha : scalar [N/rad], cornering stiffness of one main tire
    Ct : scalar [N/rad], cornering stiffness of the tail wheel

    Outputs
    -------
    a_always : 1 x 1, gear ahead of the CG: stable at every speed up to here; NaN: anywhere [m]
    u_touch : 1 x 1, speed at which det A is least [m/s]

    Thesis
    ------
    Eq. 4.28, Eq. 4.29
    """
    m = ca.SX.sym("m")
    b = ca.SX.sym("b")
    rho = ca.SX.sym("rho")
    Ap = ca.SX.sym("Ap")
    CL_gamma = ca.SX.sym("CL_gamma")
    C_alpha = ca.SX.sym("C_alpha")
    Ct = ca.SX.sym("Ct")
    C_f = 2*C_alpha  # Eq. 4.28
    k = (1/2)*Ap*CL_gamma*rho  # Eq. 4.29
    w1 = ca.sqrt(C_f)
    w2 = ca.sqrt(k)
    w4 = ca.sqrt(Ct)
    w5 = ca.sqrt(b)
    w6 = ca.sqrt(m)
    w_0 = b*w1*w2 + w4*w5*w6  # from q_1 + 2 sqrt(q_0 q_2) = 0
    w_1 = -w1*w6  # from q_1 + 2 sqrt(q_0 q_2) = 0
    w_2 = w1*w2  # from q_1 + 2 sqrt(q_0 q_2) = 0
    root_a = 2*w_0/(-w_1 + ca.sqrt(-4*w_0*w_2 + w_1**2))  # from q_1 + 2 sqrt(q_0 q_2) = 0
    a_always = root_a**2  # from q_1 + 2 sqrt(q_0 q_2) = 0
    s_touch = w1*w4*(a_always + b)/(w2*w5*w6)  # s = sqrt(q_0/q_2)
    u_touch = ca.sqrt(s_touch)  # s = sqrt(q_0/q_2)
    return ca.Function(
        "gear_position_envelope",
        [m, b, rho, Ap, CL_gamma, C_alpha, Ct],
        [a_always, u_touch],
        ["m", "b", "rho", "Ap", "CL_gamma", "C_alpha", "Ct"],
        ["a_always", "u_touch"],
    )


@cache
def loaded_gear_position() -> ca.Function:
    """Polynomial in the tail's load share with the sign of det A, loads following the gear.

    Inputs
    ------
    m : scalar [kg], total mass
    b : scalar [m], CG ahead of the vertical tail and the tail wheel
    u : scalar [m/s], forward speed, constant
    rho : scalar [kg/m^3], density of the air
    Ap : scalar [m^2], area of the vertical tail
    CL_gamma : scalar [1/rad], lift-curve slope of the vertical tail
    B3 : scalar [1/rad], cornering coefficient at no load
    C3 : scalar [1/(rad N)], its change with load
    g : scalar [m/s^2], acceleration due to gravity
    K1 : scalar [1/rad], tail wheel stiffness over load: linear term
    K2 : scalar [1/(rad N)], quadratic term
    K3 : scalar [1/(rad N^2)], cubic term
    K4 : scalar [1/(rad N^3)], quartic term

    Outputs
    -------
    p_0 : 1 x 1, coefficient of tail_load_fraction^0 [N^2 m/kg]
    p_1 : 1 x 1, coefficient of tail_load_fraction^1 [N^2 m/kg]
    p_2 : 1 x 1, coefficient of tail_load_fraction^2 [N^2 m/kg]
    p_3 : 1 x 1, coefficient of tail_load_fraction^3 [N^2 m/kg]
    p_4 : 1 x 1, coefficient of tail_load_fraction^4 [N^2 m/kg]
    p_5 : 1 x 1, coefficient of tail_load_fraction^5 [N^2 m/kg]

    Thesis
    ------
    Eq. 4.29, App. A.6
    """
    m = ca.SX.sym("m")
    b = ca.SX.sym("b")
    u = ca.SX.sym("u")
    rho = ca.SX.sym("rho")
    Ap = ca.SX.sym("Ap")
    CL_gamma = ca.SX.sym("CL_gamma")
    B3 = ca.SX.sym("B3")
    C3 = ca.SX.sym("C3")
    g = ca.SX.sym("g")
    K1 = ca.SX.sym("K1")
    K2 = ca.SX.sym("K2")
    K3 = ca.SX.sym("K3")
    K4 = ca.SX.sym("K4")
    k = (1/2)*Ap*CL_gamma*rho  # Eq. 4.29
    c0_0 = 0  # App. A.6
    w4 = C3*g*m
    w5 = 2*B3 + w4
    c0_1 = K1*b*g**2*m*w5  # App. A.6
    c0_2 = b*g**3*m**2*(2*B3*K2 - C3*K1 + C3*K2*g*m)  # App. A.6
    c0_3 = b*g**4*m**3*(2*B3*K3 - C3*K2 + C3*K3*g*m)  # App. A.6
    c0_4 = b*g**5*m**4*(2*B3*K4 - C3*K3 + K4*w4)  # App. A.6
    c0_5 = -C3*K4*b*g**6*m**5  # App. A.6
    c1_0 = b*g*k*w5  # App. A.6
    c1_1 = -g*m*(C3*b*g*k - 2*K1 + w5)  # App. A.6
    c1_2 = 2*g*m*(B3 - K1 + K2*g*m + w4)  # App. A.6
    c1_3 = g**2*m**2*(-C3 - 2*K2 + 2*K3*g*m)  # App. A.6
    c1_4 = 2*g**3*m**3*(-K3 + K4*g*m)  # App. A.6
    c1_5 = -2*K4*g**4*m**4  # App. A.6
    c2_0 = 2*k  # App. A.6
    c2_1 = -2*k  # App. A.6
    p_0 = c0_0 + c1_0*u**2 + c2_0*u**4  # from det A = 0
    p_1 = c0_1 + c1_1*u**2 + c2_1*u**4  # from det A = 0
    p_2 = c0_2 + c1_2*u**2  # from det A = 0
    p_3 = c0_3 + c1_3*u**2  # from det A = 0
    p_4 = c0_4 + c1_4*u**2  # from det A = 0
    p_5 = c0_5 + c1_5*u**2  # from det A = 0
    return ca.Function(
        "loaded_gear_position",
        [m, b, u, rho, Ap, CL_gamma, B3, C3, g, K1, K2, K3, K4],
        [p_0, p_1, p_2, p_3, p_4, p_5],
        ["m", "b", "u", "rho", "Ap", "CL_gamma", "B3", "C3", "g", "K1", "K2", "K3", "K4"],
        ["p_0", "p_1", "p_2", "p_3", "p_4", "p_5"],
    )


@cache
def loaded_gear_envelope() -> ca.Function:
    """Polynomial in the tail's load share that is zero where a window of speeds opens.

    Inputs
    ------
    m : scalar [kg], total mass
    b : scalar [m], CG ahead of the vertical tail and the tail wheel
    rho : scalar [kg/m^3], density of the air
    Ap : scalar [m^2], area of the vertical tail
    CL_gamma : scalar [1/rad], lift-curve slope of the vertical tail
    B3 : scalar [1/rad], cornering coefficient at no load
    C3 : scalar [1/(rad N)], its change with load
    g : scalar [m/s^2], acceleration due to gravity
    K1 : scalar [1/rad], tail wheel stiffness over load: linear term
    K2 : scalar [1/(rad N)], quadratic term
    K3 : scalar [1/(rad N^2)], cubic term
    K4 : scalar [1/(rad N^3)], quartic term

    Outputs
    -------
    g_0 : 1 x 1, coefficient of tail_load_fraction^0 [N^2]
    g_1 : 1 x 1, coefficient of tail_load_fraction^1 [N^2]
    g_2 : 1 x 1, coefficient of tail_load_fraction^2 [N^2]
    g_3 : 1 x 1, coefficient of tail_load_fraction^3 [N^2]
    g_4 : 1 x 1, coefficient of tail_load_fraction^4 [N^2]
    g_5 : 1 x 1, coefficient of tail_load_fraction^5 [N^2]
    g_6 : 1 x 1, coefficient of tail_load_fraction^6 [N^2]
    g_7 : 1 x 1, coefficient of tail_load_fraction^7 [N^2]
    g_8 : 1 x 1, coefficient of tail_load_fraction^8 [N^2]
    g_9 : 1 x 1, coefficient of tail_load_fraction^9 [N^2]
    g_10 : 1 x 1, coefficient of tail_load_fraction^10 [N^2]

    Thesis
    ------
    Eq. 4.29, App. A.6
    """
    m = ca.SX.sym("m")
    b = ca.SX.sym("b")
    rho = ca.SX.sym("rho")
    Ap = ca.SX.sym("Ap")
    CL_gamma = ca.SX.sym("CL_gamma")
    B3 = ca.SX.sym("B3")
    C3 = ca.SX.sym("C3")
    g = ca.SX.sym("g")
    K1 = ca.SX.sym("K1")
    K2 = ca.SX.sym("K2")
    K3 = ca.SX.sym("K3")
    K4 = ca.SX.sym("K4")
    k = (1/2)*Ap*CL_gamma*rho  # Eq. 4.29
    c0_0 = 0  # App. A.6
    w4 = C3*g*m
    w5 = 2*B3 + w4
    c0_1 = K1*b*g**2*m*w5  # App. A.6
    c0_2 = b*g**3*m**2*(2*B3*K2 - C3*K1 + C3*K2*g*m)  # App. A.6
    c0_3 = b*g**4*m**3*(2*B3*K3 - C3*K2 + C3*K3*g*m)  # App. A.6
    c0_4 = b*g**5*m**4*(2*B3*K4 - C3*K3 + K4*w4)  # App. A.6
    c0_5 = -C3*K4*b*g**6*m**5  # App. A.6
    c1_0 = b*g*k*w5  # App. A.6
    c1_1 = -g*m*(C3*b*g*k - 2*K1 + w5)  # App. A.6
    c1_2 = 2*g*m*(B3 - K1 + K2*g*m + w4)  # App. A.6
    c1_3 = g**2*m**2*(-C3 - 2*K2 + 2*K3*g*m)  # App. A.6
    c1_4 = 2*g**3*m**3*(-K3 + K4*g*m)  # App. A.6
    c1_5 = -2*K4*g**4*m**4  # App. A.6
    c2_0 = 2*k  # App. A.6
    c2_1 = -2*k  # App. A.6
    g_0 = -4*c0_0*c2_0 + c1_0**2  # from det A = 0
    g_1 = -4*c0_0*c2_1 - 4*c0_1*c2_0 + 2*c1_0*c1_1  # from det A = 0
    g_2 = -4*c0_1*c2_1 - 4*c0_2*c2_0 + 2*c1_0*c1_2 + c1_1**2  # from det A = 0
    g_3 = -4*c0_2*c2_1 - 4*c0_3*c2_0 + 2*c1_0*c1_3 + 2*c1_1*c1_2  # from det A = 0
    g_4 = -4*c0_3*c2_1 - 4*c0_4*c2_0 + 2*c1_0*c1_4 + 2*c1_1*c1_3 + c1_2**2  # from det A = 0
    g_5 = -4*c0_4*c2_1 - 4*c0_5*c2_0 + 2*c1_0*c1_5 + 2*c1_1*c1_4 + 2*c1_2*c1_3  # from det A = 0
    g_6 = -4*c0_5*c2_1 + 2*c1_1*c1_5 + 2*c1_2*c1_4 + c1_3**2  # from det A = 0
    g_7 = 2*c1_2*c1_5 + 2*c1_3*c1_4  # from det A = 0
    g_8 = 2*c1_3*c1_5 + c1_4**2  # from det A = 0
    g_9 = 2*c1_4*c1_5  # from det A = 0
    g_10 = c1_5**2  # from det A = 0
    return ca.Function(
        "loaded_gear_envelope",
        [m, b, rho, Ap, CL_gamma, B3, C3, g, K1, K2, K3, K4],
        [g_0, g_1, g_2, g_3, g_4, g_5, g_6, g_7, g_8, g_9, g_10],
        ["m", "b", "rho", "Ap", "CL_gamma", "B3", "C3", "g", "K1", "K2", "K3", "K4"],
        ["g_0", "g_1", "g_2", "g_3", "g_4", "g_5", "g_6", "g_7", "g_8", "g_9", "g_10"],
    )


@cache
def at_tail_load() -> ca.Function:
    """Gear position and weakest speed at a share of the weight on the tail wheel.

    Inputs
    ------
    tail_fraction : scalar [1], share of the weight on the tail wheel
    m : scalar [kg], total mass
    b : scalar [m], CG ahead of the vertical tail and the tail wheel
    rho : scalar [kg/m^3], density of the air
    Ap : scalar [m^2], area of the vertical tail
    CL_gamma : scalar [1/rad], lift-curve slope of the vertical tail
    B3 : scalar [1/rad], cornering coefficient at no load
    C3 : scalar [1/(rad N)], its change with load
    g : scalar [m/s^2], acceleration due to gravity
    K1 : scalar [1/rad], tail wheel stiffness over load: linear term
    K2 : scalar [1/(rad N)], quadratic term
    K3 : scalar [1/(rad N^2)], cubic term
    K4 : scalar [1/(rad N^3)], quartic term

    Outputs
    -------
    a_loaded : 1 x 1, gear ahead of the CG at that share [m]
    u_touch : 1 x 1, speed at which det A is least [m/s]

    Thesis
    ------
    Eq. 4.29, App. A.6
    """
    tail_fraction = ca.SX.sym("tail_fraction")
    m = ca.SX.sym("m")
    b = ca.SX.sym("b")
    rho = ca.SX.sym("rho")
    Ap = ca.SX.sym("Ap")
    CL_gamma = ca.SX.sym("CL_gamma")
    B3 = ca.SX.sym("B3")
    C3 = ca.SX.sym("C3")
    g = ca.SX.sym("g")
    K1 = ca.SX.sym("K1")
    K2 = ca.SX.sym("K2")
    K3 = ca.SX.sym("K3")
    K4 = ca.SX.sym("K4")
    k = (1/2)*Ap*CL_gamma*rho  # Eq. 4.29
    w2 = C3*g*m
    w3 = 2*B3 + w2
    w4 = b*g*k
    c1_0 = w3*w4  # App. A.6
    c1_1 = -g*m*(C3*w4 - 2*K1 + w3)  # App. A.6
    c1_2 = 2*g*m*(B3 - K1 + K2*g*m + w2)  # App. A.6
    c1_3 = g**2*m**2*(-C3 - 2*K2 + 2*K3*g*m)  # App. A.6
    c1_4 = 2*g**3*m**3*(-K3 + K4*g*m)  # App. A.6
    c1_5 = -2*K4*g**4*m**4  # App. A.6
    c2_0 = 2*k  # App. A.6
    c2_1 = -2*k  # App. A.6
    a_loaded = -b*tail_fraction/(tail_fraction - 1)  # App. A.6
    u_touch = ca.sqrt((-c1_0 - c1_1*tail_fraction - c1_2*tail_fraction**2 - c1_3*tail_fraction**3 - c1_4*tail_fraction**4 - c1_5*tail_fraction**5)/(2*c2_0 + 2*c2_1*tail_fraction))  # from d(det A)/ds = 0
    return ca.Function(
        "at_tail_load",
        [tail_fraction, m, b, rho, Ap, CL_gamma, B3, C3, g, K1, K2, K3, K4],
        [a_loaded, u_touch],
        ["tail_fraction", "m", "b", "rho", "Ap", "CL_gamma", "B3", "C3", "g", "K1", "K2", "K3", "K4"],
        ["a_loaded", "u_touch"],
    )


@cache
def toe_effects() -> ca.Function:
    """What a little toe-in changes of yaw stiffness and det A: both terms of the dispute.

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
    Fz : scalar [N], vertical load on one main tire
    B3 : scalar [1/rad], cornering coefficient at no load
    C3 : scalar [1/(rad N)], its change with load
    h_cg : scalar [m], the CG above the ground, in the attitude in which stations are measured
    track : scalar [m], left to right main wheel

    Outputs
    -------
    toe_pull : 1 x 1, yaw stiffness that a radian of toe-in adds because forces point inward [N m/rad^2]
    toe_load : 1 x 1, yaw stiffness that it takes because the load moves to the leading wheel [N m/rad^2]
    toe_yaw_stiffness : 1 x 1, change of the yaw stiffness dN/dbeta with toe-in; a positive one turns the nose to where the aircraft goes [N m/rad^2]
    toe_determinant : 1 x 1, change of det A with toe-in: positive moves the boundary of stability the good way [1/(rad s^2)]

    Thesis
    ------
    Eq. 4.29, Eq. 4.31
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
    Fz = ca.SX.sym("Fz")
    B3 = ca.SX.sym("B3")
    C3 = ca.SX.sym("C3")
    h_cg = ca.SX.sym("h_cg")
    track = ca.SX.sym("track")
    k = (1/2)*Ap*CL_gamma*rho  # Eq. 4.29
    K = Ct + k*u**2  # Eq. 4.31
    C_load = B3 + 2*C3*Fz  # Eqs. 3.2, 3.3
    toe_pull = C_alpha*track  # forces along the fuselage
    toe_load = 2*C_load*a*h_cg*(2*C_alpha + K)/track  # loads moved by h / track
    toe_yaw_stiffness = -toe_load + toe_pull  # definition
    w5 = C_alpha*C_load*h_cg
    w6 = 4*K*w5
    toe_determinant = -(4*C_alpha*C_load*a*h_cg*m*u**2 + C_alpha*K*a*track**2 + C_alpha*K*b*track**2 - C_alpha*m*track**2*u**2 + 2*C_load*K*a*h_cg*m*u**2 - 8*K*a*b*w5 - a**2*w6 - b**2*w6)/(Izz*m*track*u**2)  # from det A
    return ca.Function(
        "toe_effects",
        [m, Izz, a, b, u, rho, Ap, CL_gamma, C_alpha, Ct, Fz, B3, C3, h_cg, track],
        [toe_pull, toe_load, toe_yaw_stiffness, toe_determinant],
        ["m", "Izz", "a", "b", "u", "rho", "Ap", "CL_gamma", "C_alpha", "Ct", "Fz", "B3", "C3", "h_cg", "track"],
        ["toe_pull", "toe_load", "toe_yaw_stiffness", "toe_determinant"],
    )
