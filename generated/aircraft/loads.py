# Generated from derive/ (digest 0a06213221c378cc) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`.
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


@cache
def a_third_follows_with_nose_wheel() -> ca.Function:
    """Third wheel ahead of the CG; negative: a tail wheel (balance of moments).

    Inputs
    ------
    a : scalar [m], main gear ahead of the CG (positive: taildragger)
    x_cg : scalar [m], the CG behind the datum
    x_nose : scalar [m], the nose wheel behind the datum

    Outputs
    -------
    a_third : 1 x 1, third wheel ahead of the CG; negative: a tail wheel [m]
    """
    a = ca.SX.sym("a")
    x_cg = ca.SX.sym("x_cg")
    x_nose = ca.SX.sym("x_nose")
    a_third = ca.if_else(a < 0, x_cg - x_nose, ca.SX.nan())  # balance of moments
    return ca.Function(
        "a_third_follows_with_nose_wheel",
        [a, x_cg, x_nose],
        [a_third],
        ["a", "x_cg", "x_nose"],
        ["a_third"],
    )


@cache
def B3_third_follows_with_tail_wheel() -> ca.Function:
    """Cornering coefficient at no load, third (Eq. 4.30).

    Inputs
    ------
    Ct : scalar [N/rad], cornering stiffness of the tail wheel
    F_tail_load : scalar [N], vertical load on the tail wheel
    B1_third : scalar [1], magic formula: stiffness factor, third
    C1_third : scalar [1], magic formula: shape factor, third
    D1_third : scalar [1], magic formula: peak factor, third

    Outputs
    -------
    B3_third : 1 x 1, cornering coefficient at no load, third [1/rad]

    Thesis
    ------
    Eq. 4.30
    """
    Ct = ca.SX.sym("Ct")
    F_tail_load = ca.SX.sym("F_tail_load")
    B1_third = ca.SX.sym("B1_third")
    C1_third = ca.SX.sym("C1_third")
    D1_third = ca.SX.sym("D1_third")
    B3_third = ca.if_else(Ct*F_tail_load > 0, Ct/(B1_third*C1_third*D1_third*F_tail_load), ca.SX.nan())  # Eq. 4.30
    return ca.Function(
        "B3_third_follows_with_tail_wheel",
        [Ct, F_tail_load, B1_third, C1_third, D1_third],
        [B3_third],
        ["Ct", "F_tail_load", "B1_third", "C1_third", "D1_third"],
        ["B3_third"],
    )


@cache
def C3_third_follows_with_tail_wheel() -> ca.Function:
    """Its change with load, third (Eq. 4.30).

    Inputs
    ------
    Ct : scalar [N/rad], cornering stiffness of the tail wheel
    F_tail_load : scalar [N], vertical load on the tail wheel

    Outputs
    -------
    C3_third : 1 x 1, its change with load, third [1/(rad N)]

    Thesis
    ------
    Eq. 4.30
    """
    Ct = ca.SX.sym("Ct")
    F_tail_load = ca.SX.sym("F_tail_load")
    C3_third = ca.if_else(Ct*F_tail_load > 0, 0, ca.SX.nan())  # Eq. 4.30
    return ca.Function(
        "C3_third_follows_with_tail_wheel",
        [Ct, F_tail_load],
        [C3_third],
        ["Ct", "F_tail_load"],
        ["C3_third"],
    )


@cache
def p_rated_follows() -> ca.Function:
    """Pressure at which the rated load of a main tire is given (taken to be inflated as rated).

    Inputs
    ------
    p_tire : scalar [N/m^2], pressure in a main tire

    Outputs
    -------
    p_rated : 1 x 1, pressure at which the rated load of a main tire is given [N/m^2]
    """
    p_tire = ca.SX.sym("p_tire")
    p_rated = p_tire  # taken to be inflated as rated
    return ca.Function(
        "p_rated_follows",
        [p_tire],
        [p_rated],
        ["p_tire"],
        ["p_rated"],
    )


@cache
def delta_tire_follows() -> ca.Function:
    """Static deflection of a main tire (NASA TR R-64).

    Inputs
    ------
    Fz : scalar [N], vertical load on one main tire
    d_tire : scalar [m], outside diameter of a main tire
    w_tire : scalar [m], width of a main tire
    p_tire : scalar [N/m^2], pressure in a main tire
    p_rated : scalar [N/m^2], pressure at which the rated load of a main tire is given
    C_z : scalar [1], of the type of the tires, in NASA TR R-64

    Outputs
    -------
    delta_tire : 1 x 1, static deflection of a main tire [m]
    """
    Fz = ca.SX.sym("Fz")
    d_tire = ca.SX.sym("d_tire")
    w_tire = ca.SX.sym("w_tire")
    p_tire = ca.SX.sym("p_tire")
    p_rated = ca.SX.sym("p_rated")
    C_z = ca.SX.sym("C_z")
    l_z = ca.sqrt(d_tire)*ca.sqrt(w_tire)  # NASA TR R-64
    K_z = l_z*w_tire*((2/25)*p_rated + p_tire)  # NASA TR R-64
    k_z = Fz/K_z  # NASA TR R-64
    x_z = ca.if_else(k_z <= (28/5)*C_z, C_z*((125/54)*ca.sqrt(576/625 + (108/125)*k_z/C_z) - 20/9), C_z + (5/12)*k_z)  # NASA TR R-64
    delta_tire = w_tire*x_z  # NASA TR R-64
    return ca.Function(
        "delta_tire_follows",
        [Fz, d_tire, w_tire, p_tire, p_rated, C_z],
        [delta_tire],
        ["Fz", "d_tire", "w_tire", "p_tire", "p_rated", "C_z"],
        ["delta_tire"],
    )


@cache
def sigma_follows() -> ca.Function:
    """Distance in which the side force of a main tire builds up (NASA TR R-64).

    Inputs
    ------
    Fz : scalar [N], vertical load on one main tire
    d_tire : scalar [m], outside diameter of a main tire
    w_tire : scalar [m], width of a main tire
    p_tire : scalar [N/m^2], pressure in a main tire
    p_rated : scalar [N/m^2], pressure at which the rated load of a main tire is given
    C_z : scalar [1], of the type of the tires, in NASA TR R-64

    Outputs
    -------
    sigma : 1 x 1, distance in which the side force of a main tire builds up [m]
    """
    Fz = ca.SX.sym("Fz")
    d_tire = ca.SX.sym("d_tire")
    w_tire = ca.SX.sym("w_tire")
    p_tire = ca.SX.sym("p_tire")
    p_rated = ca.SX.sym("p_rated")
    C_z = ca.SX.sym("C_z")
    l_z = ca.sqrt(d_tire)*ca.sqrt(w_tire)  # NASA TR R-64
    K_z = l_z*w_tire*((2/25)*p_rated + p_tire)  # NASA TR R-64
    k_z = Fz/K_z  # NASA TR R-64
    x_z = ca.if_else(k_z <= (28/5)*C_z, C_z*((125/54)*ca.sqrt(576/625 + (108/125)*k_z/C_z) - 20/9), C_z + (5/12)*k_z)  # NASA TR R-64
    e_z = w_tire*x_z/d_tire  # NASA TR R-64
    l_sigma = ca.if_else(e_z <= 53/1000, 11*e_z, ca.if_else(e_z <= 17/250, -500*e_z**2 + 64*e_z - 2809/2000, 363/400 - 4*e_z))  # NASA TR R-64
    sigma = l_sigma*w_tire*(14/5 - 4/5*p_tire/p_rated)  # NASA TR R-64
    return ca.Function(
        "sigma_follows",
        [Fz, d_tire, w_tire, p_tire, p_rated, C_z],
        [sigma],
        ["Fz", "d_tire", "w_tire", "p_tire", "p_rated", "C_z"],
        ["sigma"],
    )


@cache
def C3_follows() -> ca.Function:
    """Its change with load (tangent to N/F_z).

    Inputs
    ------
    Fz : scalar [N], vertical load on one main tire
    d_tire : scalar [m], outside diameter of a main tire
    w_tire : scalar [m], width of a main tire
    p_tire : scalar [N/m^2], pressure in a main tire
    p_rated : scalar [N/m^2], pressure at which the rated load of a main tire is given
    C_z : scalar [1], of the type of the tires, in NASA TR R-64
    C_N : scalar [1/rad], of the type of the tires, in NASA TR R-64

    Outputs
    -------
    C3 : 1 x 1, its change with load [1/(rad N)]
    """
    Fz = ca.SX.sym("Fz")
    d_tire = ca.SX.sym("d_tire")
    w_tire = ca.SX.sym("w_tire")
    p_tire = ca.SX.sym("p_tire")
    p_rated = ca.SX.sym("p_rated")
    C_z = ca.SX.sym("C_z")
    C_N = ca.SX.sym("C_N")
    l_z = ca.sqrt(d_tire)*ca.sqrt(w_tire)  # NASA TR R-64
    K_z = l_z*w_tire*((2/25)*p_rated + p_tire)  # NASA TR R-64
    k_z = Fz/K_z  # NASA TR R-64
    w2 = ca.sqrt(576/625 + (108/125)*k_z/C_z)
    x_z = ca.if_else(k_z <= (28/5)*C_z, C_z*((125/54)*w2 - 20/9), C_z + (5/12)*k_z)  # NASA TR R-64
    e_z = w_tire*x_z/d_tire  # NASA TR R-64
    g_N = ca.if_else(e_z <= 7/80, -44/5*e_z**2 + (6/5)*e_z, 539/8000 - 17/50*e_z)  # NASA TR R-64
    N_scale = C_N*w_tire**2*((11/25)*p_rated + p_tire)  # NASA TR R-64
    N = N_scale*g_N  # NASA TR R-64
    N_load = N_scale*w_tire*ca.if_else(k_z <= (28/5)*C_z, 1/w2, 5/12)*ca.if_else(e_z <= 7/80, 6/5 - 88/5*e_z, -17/50)/(K_z*d_tire)  # NASA TR R-64
    C3 = (N_load - N/Fz)/Fz  # tangent to N/F_z
    return ca.Function(
        "C3_follows",
        [Fz, d_tire, w_tire, p_tire, p_rated, C_z, C_N],
        [C3],
        ["Fz", "d_tire", "w_tire", "p_tire", "p_rated", "C_z", "C_N"],
        ["C3"],
    )


@cache
def B3_follows() -> ca.Function:
    """Cornering coefficient at no load (tangent to N/F_z).

    Inputs
    ------
    Fz : scalar [N], vertical load on one main tire
    C3 : scalar [1/(rad N)], its change with load
    d_tire : scalar [m], outside diameter of a main tire
    w_tire : scalar [m], width of a main tire
    p_tire : scalar [N/m^2], pressure in a main tire
    p_rated : scalar [N/m^2], pressure at which the rated load of a main tire is given
    C_z : scalar [1], of the type of the tires, in NASA TR R-64
    C_N : scalar [1/rad], of the type of the tires, in NASA TR R-64

    Outputs
    -------
    B3 : 1 x 1, cornering coefficient at no load [1/rad]
    """
    Fz = ca.SX.sym("Fz")
    C3 = ca.SX.sym("C3")
    d_tire = ca.SX.sym("d_tire")
    w_tire = ca.SX.sym("w_tire")
    p_tire = ca.SX.sym("p_tire")
    p_rated = ca.SX.sym("p_rated")
    C_z = ca.SX.sym("C_z")
    C_N = ca.SX.sym("C_N")
    l_z = ca.sqrt(d_tire)*ca.sqrt(w_tire)  # NASA TR R-64
    K_z = l_z*w_tire*((2/25)*p_rated + p_tire)  # NASA TR R-64
    k_z = Fz/K_z  # NASA TR R-64
    x_z = ca.if_else(k_z <= (28/5)*C_z, C_z*((125/54)*ca.sqrt(576/625 + (108/125)*k_z/C_z) - 20/9), C_z + (5/12)*k_z)  # NASA TR R-64
    e_z = w_tire*x_z/d_tire  # NASA TR R-64
    g_N = ca.if_else(e_z <= 7/80, -44/5*e_z**2 + (6/5)*e_z, 539/8000 - 17/50*e_z)  # NASA TR R-64
    N_scale = C_N*w_tire**2*((11/25)*p_rated + p_tire)  # NASA TR R-64
    N = N_scale*g_N  # NASA TR R-64
    B3 = -C3*Fz + N/Fz  # tangent to N/F_z
    return ca.Function(
        "B3_follows",
        [Fz, C3, d_tire, w_tire, p_tire, p_rated, C_z, C_N],
        [B3],
        ["Fz", "C3", "d_tire", "w_tire", "p_tire", "p_rated", "C_z", "C_N"],
        ["B3"],
    )


@cache
def Ct_follows_from_size() -> ca.Function:
    """Cornering stiffness of the tail wheel (NASA TR R-64).

    Inputs
    ------
    F_tail_load : scalar [N], vertical load on the tail wheel
    C_z : scalar [1], of the type of the tires, in NASA TR R-64
    C_N : scalar [1/rad], of the type of the tires, in NASA TR R-64
    d_tail : scalar [m], outside diameter of the tail wheel's tire
    w_tail : scalar [m], width of the tail wheel's tire
    p_tail : scalar [N/m^2], pressure in the tail wheel's tire

    Outputs
    -------
    Ct : 1 x 1, cornering stiffness of the tail wheel [N/rad]
    """
    F_tail_load = ca.SX.sym("F_tail_load")
    C_z = ca.SX.sym("C_z")
    C_N = ca.SX.sym("C_N")
    d_tail = ca.SX.sym("d_tail")
    w_tail = ca.SX.sym("w_tail")
    p_tail = ca.SX.sym("p_tail")
    l_z = ca.sqrt(d_tail)*ca.sqrt(w_tail)  # NASA TR R-64
    K_z = (27/25)*l_z*p_tail*w_tail  # NASA TR R-64
    k_z = F_tail_load/K_z  # NASA TR R-64
    x_z = ca.if_else(k_z <= (28/5)*C_z, C_z*((125/54)*ca.sqrt(576/625 + (108/125)*k_z/C_z) - 20/9), C_z + (5/12)*k_z)  # NASA TR R-64
    e_z = w_tail*x_z/d_tail  # NASA TR R-64
    g_N = ca.if_else(e_z <= 7/80, -44/5*e_z**2 + (6/5)*e_z, 539/8000 - 17/50*e_z)  # NASA TR R-64
    N_scale = (36/25)*C_N*p_tail*w_tail**2  # NASA TR R-64
    N = N_scale*g_N  # NASA TR R-64
    Ct = N  # NASA TR R-64
    return ca.Function(
        "Ct_follows_from_size",
        [F_tail_load, C_z, C_N, d_tail, w_tail, p_tail],
        [Ct],
        ["F_tail_load", "C_z", "C_N", "d_tail", "w_tail", "p_tail"],
        ["Ct"],
    )
