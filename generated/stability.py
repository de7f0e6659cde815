# Generated from derive/ (digest 3592f43898c580f8) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`.
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
    damped_frequency : 1 x 1, |Im(eigenvalue)| [rad/s]
    damping_ratio : 1 x 1, above 1: two real eigenvalues [1]
    """
    A_vv = ca.SX.sym("A_vv")
    A_vr = ca.SX.sym("A_vr")
    A_rv = ca.SX.sym("A_rv")
    A_rr = ca.SX.sym("A_rr")
    trace = A_rr + A_vv  # Section 4.7
    det = A_rr*A_vv - A_rv*A_vr  # Section 4.7
    discriminant = 4*A_rv*A_vr + (-A_rr + A_vv)**2  # Section 4.7
    spread = (1/2)*ca.sqrt(ca.fmax(0, discriminant))  # Section 4.7
    damped_frequency = (1/2)*ca.sqrt(ca.fmax(0, -discriminant))  # Section 4.5.7
    re_1 = spread + (1/2)*trace  # Section 4.7
    re_2 = -spread + (1/2)*trace  # Section 4.7
    im_1 = damped_frequency  # Section 4.7
    im_2 = -damped_frequency  # Section 4.7
    decay_rate = -re_1  # Section 4.7
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
    k = (1/2)*Ap*CL_gamma*rho  # Eq. 4.29
    q_0 = C_f*Ct*(a + b)**2  # from det A = 0
    q_1 = C_f*a**2*k + 2*C_f*a*b*k - C_f*a*m + C_f*b**2*k + Ct*b*m  # from det A = 0
    q_2 = b*k*m  # from det A = 0
    q_root = -q_1 + ca.sqrt(-4*q_0*q_2 + q_1**2)  # from det A = 0
    s_low = 2*q_0/q_root  # from det A = 0
    s_high = (1/2)*q_root/q_2  # from det A = 0
    u_low = ca.sqrt(s_low)  # from det A = 0
    u_high = ca.sqrt(s_high)  # from det A = 0
    return ca.Function(
        "speed_window",
        [m, a, b, rho, Ap, CL_gamma, C_alpha, Ct],
        [u_low, u_high],
        ["m", "a", "b", "rho", "Ap", "CL_gamma", "C_alpha", "Ct"],
        ["u_low", "u_high"],
    )
