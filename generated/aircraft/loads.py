# Generated from derive/ (digest 4e3da0958760807a) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`.
"""What follows from CG and gear positions."""

from functools import cache

import casadi as ca


@cache
def a_follows() -> ca.Function:
    """Main gear ahead of the CG (positive: taildragger) (Section 4.2.2).

    Inputs
    ------
    x_cg : scalar [m], the CG behind the datum
    x_main : scalar [m], the main gear behind it

    Outputs
    -------
    a : 1 x 1, main gear ahead of the CG (positive: taildragger) [m]
    """
    x_cg = ca.SX.sym("x_cg")
    x_main = ca.SX.sym("x_main")
    a = x_cg - x_main  # Section 4.2.2
    return ca.Function(
        "a_follows",
        [x_cg, x_main],
        [a],
        ["x_cg", "x_main"],
        ["a"],
    )


@cache
def b_follows() -> ca.Function:
    """CG ahead of the vertical tail and the tail wheel (Section 4.2.2).

    Inputs
    ------
    x_cg : scalar [m], the CG behind the datum
    x_tail : scalar [m], vertical tail and tail wheel behind it

    Outputs
    -------
    b : 1 x 1, CG ahead of the vertical tail and the tail wheel [m]
    """
    x_cg = ca.SX.sym("x_cg")
    x_tail = ca.SX.sym("x_tail")
    b = -x_cg + x_tail  # Section 4.2.2
    return ca.Function(
        "b_follows",
        [x_cg, x_tail],
        [b],
        ["x_cg", "x_tail"],
        ["b"],
    )


@cache
def L_follows() -> ca.Function:
    """Main gear to tail wheel (Section 4.2).

    Inputs
    ------
    a : scalar [m], main gear ahead of the CG (positive: taildragger)
    b : scalar [m], CG ahead of the vertical tail and the tail wheel

    Outputs
    -------
    L : 1 x 1, main gear to tail wheel [m]
    """
    a = ca.SX.sym("a")
    b = ca.SX.sym("b")
    L = a + b  # Section 4.2
    return ca.Function(
        "L_follows",
        [a, b],
        [L],
        ["a", "b"],
        ["L"],
    )


@cache
def f_follows() -> ca.Function:
    """Fraction of the weight on the main gear (App. A.6).

    Inputs
    ------
    b : scalar [m], CG ahead of the vertical tail and the tail wheel
    L : scalar [m], main gear to tail wheel

    Outputs
    -------
    f : 1 x 1, fraction of the weight on the main gear [1]

    Thesis
    ------
    App. A.6
    """
    b = ca.SX.sym("b")
    L = ca.SX.sym("L")
    f = b/L  # App. A.6
    return ca.Function(
        "f_follows",
        [b, L],
        [f],
        ["b", "L"],
        ["f"],
    )


@cache
def Fz_follows() -> ca.Function:
    """Vertical load on one main tire (App. A.6).

    Inputs
    ------
    m : scalar [kg], total mass
    g : scalar [m/s^2], acceleration due to gravity
    f : scalar [1], fraction of the weight on the main gear

    Outputs
    -------
    Fz : 1 x 1, vertical load on one main tire [N]

    Thesis
    ------
    App. A.6
    """
    m = ca.SX.sym("m")
    g = ca.SX.sym("g")
    f = ca.SX.sym("f")
    Fz = (1/2)*f*g*m  # App. A.6
    return ca.Function(
        "Fz_follows",
        [m, g, f],
        [Fz],
        ["m", "g", "f"],
        ["Fz"],
    )


@cache
def F_tail_load_follows() -> ca.Function:
    """Vertical load on the tail wheel (App. A.6).

    Inputs
    ------
    m : scalar [kg], total mass
    g : scalar [m/s^2], acceleration due to gravity
    f : scalar [1], fraction of the weight on the main gear

    Outputs
    -------
    F_tail_load : 1 x 1, vertical load on the tail wheel [N]

    Thesis
    ------
    App. A.6
    """
    m = ca.SX.sym("m")
    g = ca.SX.sym("g")
    f = ca.SX.sym("f")
    F_tail_load = g*m*(1 - f)  # App. A.6
    return ca.Function(
        "F_tail_load_follows",
        [m, g, f],
        [F_tail_load],
        ["m", "g", "f"],
        ["F_tail_load"],
    )


@cache
def C_alpha_follows() -> ca.Function:
    """Cornering stiffness of one main tire (Eq. 3.2).

    Inputs
    ------
    Fz : scalar [N], vertical load on one main tire
    B3 : scalar [1/rad], cornering coefficient at no load
    C3 : scalar [1/(rad N)], its change with load

    Outputs
    -------
    C_alpha : 1 x 1, cornering stiffness of one main tire [N/rad]

    Thesis
    ------
    Eq. 3.3, Eq. 3.2
    """
    Fz = ca.SX.sym("Fz")
    B3 = ca.SX.sym("B3")
    C3 = ca.SX.sym("C3")
    C_c = B3 + C3*Fz  # Eq. 3.3
    C_alpha = C_c*Fz  # Eq. 3.2
    return ca.Function(
        "C_alpha_follows",
        [Fz, B3, C3],
        [C_alpha],
        ["Fz", "B3", "C3"],
        ["C_alpha"],
    )


@cache
def Ct_follows() -> ca.Function:
    """Cornering stiffness of the tail wheel (Fig. 3.8).

    Inputs
    ------
    F_tail_load : scalar [N], vertical load on the tail wheel
    K1 : scalar [1/rad], tail wheel stiffness over load: linear term
    K2 : scalar [1/(rad N)], quadratic term
    K3 : scalar [1/(rad N^2)], cubic term
    K4 : scalar [1/(rad N^3)], quartic term

    Outputs
    -------
    Ct : 1 x 1, cornering stiffness of the tail wheel [N/rad]

    Thesis
    ------
    Fig. 3.8
    """
    F_tail_load = ca.SX.sym("F_tail_load")
    K1 = ca.SX.sym("K1")
    K2 = ca.SX.sym("K2")
    K3 = ca.SX.sym("K3")
    K4 = ca.SX.sym("K4")
    Ct = F_tail_load**4*K4 + F_tail_load**3*K3 + F_tail_load**2*K2 + F_tail_load*K1  # Fig. 3.8
    return ca.Function(
        "Ct_follows",
        [F_tail_load, K1, K2, K3, K4],
        [Ct],
        ["F_tail_load", "K1", "K2", "K3", "K4"],
        ["Ct"],
    )


@cache
def f_follows_with_nose_wheel() -> ca.Function:
    """Fraction of the weight on the main gear (balance of moments).

    Inputs
    ------
    a : scalar [m], main gear ahead of the CG (positive: taildragger)
    x_cg : scalar [m], the CG behind the datum
    x_nose : scalar [m], the nose wheel behind the datum

    Outputs
    -------
    f : 1 x 1, fraction of the weight on the main gear [1]
    """
    a = ca.SX.sym("a")
    x_cg = ca.SX.sym("x_cg")
    x_nose = ca.SX.sym("x_nose")
    f = ca.if_else(a < 0, (-x_cg + x_nose)/(a - x_cg + x_nose), ca.SX.nan())  # balance of moments
    return ca.Function(
        "f_follows_with_nose_wheel",
        [a, x_cg, x_nose],
        [f],
        ["a", "x_cg", "x_nose"],
        ["f"],
    )


@cache
def F_tail_load_follows_with_nose_wheel() -> ca.Function:
    """Vertical load on the tail wheel (balance of moments).

    Inputs
    ------
    m : scalar [kg], total mass
    a : scalar [m], main gear ahead of the CG (positive: taildragger)
    g : scalar [m/s^2], acceleration due to gravity
    f : scalar [1], fraction of the weight on the main gear

    Outputs
    -------
    F_tail_load : 1 x 1, vertical load on the tail wheel [N]
    """
    m = ca.SX.sym("m")
    a = ca.SX.sym("a")
    g = ca.SX.sym("g")
    f = ca.SX.sym("f")
    F_tail_load = ca.if_else(a < 0, g*m*ca.fmin(0, 1 - f), ca.SX.nan())  # balance of moments
    return ca.Function(
        "F_tail_load_follows_with_nose_wheel",
        [m, a, g, f],
        [F_tail_load],
        ["m", "a", "g", "f"],
        ["F_tail_load"],
    )
