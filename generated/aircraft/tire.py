# Generated from derive/ (digest 0a06213221c378cc) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`.
"""The tire by itself (Chapter 3)."""

from functools import cache

import casadi as ca


@cache
def tire_force() -> ca.Function:
    """Lateral force of one tire at a slip angle and load.

    Inputs
    ------
    alpha : scalar [rad], slip angle of the main tires
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
    F_y : 1 x 1, lateral force of one tire, to the left for a positive slip angle [N]
    alpha_bar : 1 x 1, normalised slip angle [1]
    F_bar : 1 x 1, normalised lateral force [1]
    C_c : 1 x 1, cornering stiffness over load [1/rad]
    mu : 1 x 1, lateral friction coefficient [1]

    Thesis
    ------
    Eq. 3.3, Eq. 3.5, Eq. 3.6, Eq. 3.10, Eq. 3.9, Eq. 3.8, Eq. 3.11
    """
    alpha = ca.SX.sym("alpha")
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
    return ca.Function(
        "tire_force",
        [alpha, Fz, B3, C3, B5, C5, B1, C1, D1, E1],
        [F_y, alpha_bar, F_bar, C_c, mu],
        ["alpha", "Fz", "B3", "C3", "B5", "C5", "B1", "C1", "D1", "E1"],
        ["F_y", "alpha_bar", "F_bar", "C_c", "mu"],
    )


@cache
def tire_slope() -> ca.Function:
    """Slope of the lateral force of one tire at no slip angle.

    Inputs
    ------
    Fz : scalar [N], vertical load on one main tire
    B3 : scalar [1/rad], cornering coefficient at no load
    C3 : scalar [1/(rad N)], its change with load
    B1 : scalar [1], magic formula: stiffness factor
    C1 : scalar [1], magic formula: shape factor
    D1 : scalar [1], magic formula: peak factor

    Outputs
    -------
    F_slope : 1 x 1, slope of the lateral force of one tire at no slip angle [N/rad]

    Thesis
    ------
    Eq. 3.3
    """
    Fz = ca.SX.sym("Fz")
    B3 = ca.SX.sym("B3")
    C3 = ca.SX.sym("C3")
    B1 = ca.SX.sym("B1")
    C1 = ca.SX.sym("C1")
    D1 = ca.SX.sym("D1")
    C_c = B3 + C3*Fz  # Eq. 3.3
    F_slope = B1*C1*C_c*D1*Fz  # derivative of Eq. 3.11
    return ca.Function(
        "tire_slope",
        [Fz, B3, C3, B1, C1, D1],
        [F_slope],
        ["Fz", "B3", "C3", "B1", "C1", "D1"],
        ["F_slope"],
    )


@cache
def tire_coefficient() -> ca.Function:
    """Cornering coefficient of one tire at a load.

    Inputs
    ------
    Fz : scalar [N], vertical load on one main tire
    B3 : scalar [1/rad], cornering coefficient at no load
    C3 : scalar [1/(rad N)], its change with load

    Outputs
    -------
    C_c : 1 x 1, cornering stiffness over load [1/rad]

    Thesis
    ------
    Eq. 3.3
    """
    Fz = ca.SX.sym("Fz")
    B3 = ca.SX.sym("B3")
    C3 = ca.SX.sym("C3")
    C_c = B3 + C3*Fz  # Eq. 3.3
    return ca.Function(
        "tire_coefficient",
        [Fz, B3, C3],
        [C_c],
        ["Fz", "B3", "C3"],
        ["C_c"],
    )


@cache
def tire_friction() -> ca.Function:
    """Friction of one tire at a load.

    Inputs
    ------
    Fz : scalar [N], vertical load on one main tire
    B5 : scalar [1], friction coefficient at no load
    C5 : scalar [1/N], its change with load

    Outputs
    -------
    mu : 1 x 1, lateral friction coefficient [1]

    Thesis
    ------
    Eq. 3.5
    """
    Fz = ca.SX.sym("Fz")
    B5 = ca.SX.sym("B5")
    C5 = ca.SX.sym("C5")
    mu = B5 + C5*Fz  # Eq. 3.5
    return ca.Function(
        "tire_friction",
        [Fz, B5, C5],
        [mu],
        ["Fz", "B5", "C5"],
        ["mu"],
    )


@cache
def magic_formula_of_shape() -> ca.Function:
    """Factors with which the normalised curve has the slope 1 and levels off at 1.

    Inputs
    ------
    C1 : scalar [1], magic formula: shape factor

    Outputs
    -------
    B1 : 1 x 1, magic formula: stiffness factor [1]
    D1 : 1 x 1, magic formula: peak factor [1]
    """
    C1 = ca.SX.sym("C1")
    D1 = 1  # peak
    B1 = 1/(C1*D1)  # slope
    return ca.Function(
        "magic_formula_of_shape",
        [C1],
        [B1, D1],
        ["C1"],
        ["B1", "D1"],
    )


@cache
def mf_lateral() -> ca.Function:
    """Lateral force by the coefficients of a .tir file, in the axes of the file.

    Inputs
    ------
    alpha : scalar [rad], slip angle of a tire
    Fz : scalar [N], vertical load on one main tire
    FNOMIN : scalar [N], nominal load
    tangent : scalar [1], 1 if slip is the tangent of the angle, else 0
    PCY1 : scalar [1], shape factor
    PDY1 : scalar [1], friction at the nominal load
    PDY2 : scalar [1], its change with load
    PEY1 : scalar [1], curvature at the nominal load
    PEY2 : scalar [1], its change with load
    PEY3 : scalar [1], its dependence on the sign of the slip angle
    PKY1 : scalar [1], largest stiffness over nominal load
    PKY2 : scalar [1], load of the largest stiffness over nominal load
    PKY4 : scalar [1], curvature of the stiffness
    PHY1 : scalar [1], horizontal shift at the nominal load
    PHY2 : scalar [1], its change with load
    PVY1 : scalar [1], vertical shift over load at the nominal load
    PVY2 : scalar [1], its change with load
    LFZO : scalar [1], scale of the nominal load
    LCY : scalar [1], scale of the shape factor
    LMUY : scalar [1], scale of friction
    LEY : scalar [1], scale of the curvature
    LKY : scalar [1], scale of the stiffness
    LHY : scalar [1], scale of the horizontal shift
    LVY : scalar [1], scale of the vertical shift

    Outputs
    -------
    F_mf : 1 x 1, lateral force, as the file's axes have it [N]
    """
    alpha = ca.SX.sym("alpha")
    Fz = ca.SX.sym("Fz")
    FNOMIN = ca.SX.sym("FNOMIN")
    tangent = ca.SX.sym("tangent")
    PCY1 = ca.SX.sym("PCY1")
    PDY1 = ca.SX.sym("PDY1")
    PDY2 = ca.SX.sym("PDY2")
    PEY1 = ca.SX.sym("PEY1")
    PEY2 = ca.SX.sym("PEY2")
    PEY3 = ca.SX.sym("PEY3")
    PKY1 = ca.SX.sym("PKY1")
    PKY2 = ca.SX.sym("PKY2")
    PKY4 = ca.SX.sym("PKY4")
    PHY1 = ca.SX.sym("PHY1")
    PHY2 = ca.SX.sym("PHY2")
    PVY1 = ca.SX.sym("PVY1")
    PVY2 = ca.SX.sym("PVY2")
    LFZO = ca.SX.sym("LFZO")
    LCY = ca.SX.sym("LCY")
    LMUY = ca.SX.sym("LMUY")
    LEY = ca.SX.sym("LEY")
    LKY = ca.SX.sym("LKY")
    LHY = ca.SX.sym("LHY")
    LVY = ca.SX.sym("LVY")
    w2 = 1/(FNOMIN*LFZO)
    df_z = w2*(-FNOMIN*LFZO + Fz)  # 4.E2
    K_y = FNOMIN*LFZO*LKY*PKY1*ca.sin(PKY4*ca.atan(Fz*w2/PKY2))  # 4.E25
    mu_y = LMUY*(PDY1 + PDY2*df_z)  # 4.E23
    S_H = LHY*(PHY1 + PHY2*df_z)  # 4.E27
    S_V = Fz*LMUY*LVY*(PVY1 + PVY2*df_z)  # 4.E29
    slip = S_H + alpha*(1 - tangent) + tangent*ca.tan(alpha)  # 4.E20
    C_y = LCY*PCY1  # 4.E21
    D_y = Fz*mu_y  # 4.E22
    E_y = ca.fmin(1, LEY*(PEY1 + PEY2*df_z)*(-PEY3*ca.if_else(slip >= 0, 1, -1) + 1))  # 4.E24
    B_y = K_y/(C_y*D_y)  # 4.E26
    b_y = B_y*slip - E_y*(B_y*slip - ca.atan(B_y*slip))  # 4.E19
    F_mf = D_y*ca.sin(C_y*ca.atan(b_y)) + S_V  # 4.E19
    return ca.Function(
        "mf_lateral",
        [alpha, Fz, FNOMIN, tangent, PCY1, PDY1, PDY2, PEY1, PEY2, PEY3, PKY1, PKY2, PKY4, PHY1, PHY2, PVY1, PVY2, LFZO, LCY, LMUY, LEY, LKY, LHY, LVY],
        [F_mf],
        ["alpha", "Fz", "FNOMIN", "tangent", "PCY1", "PDY1", "PDY2", "PEY1", "PEY2", "PEY3", "PKY1", "PKY2", "PKY4", "PHY1", "PHY2", "PVY1", "PVY2", "LFZO", "LCY", "LMUY", "LEY", "LKY", "LHY", "LVY"],
        ["F_mf"],
    )


@cache
def relative_deflection() -> ca.Function:
    """Deflection of a tire over its diameter.

    Inputs
    ------
    delta_tire : scalar [m], static deflection of a main tire
    d_tire : scalar [m], outside diameter of a main tire

    Outputs
    -------
    e_z : 1 x 1, deflection over diameter [1]
    """
    delta_tire = ca.SX.sym("delta_tire")
    d_tire = ca.SX.sym("d_tire")
    e_z = delta_tire/d_tire  # definition
    return ca.Function(
        "relative_deflection",
        [delta_tire, d_tire],
        [e_z],
        ["delta_tire", "d_tire"],
        ["e_z"],
    )


@cache
def outside_diameter() -> ca.Function:
    """Outside diameter of a tire from its width and its rim.

    Inputs
    ------
    d_rim : scalar [m], diameter of the rim
    w_tire : scalar [m], width of a main tire

    Outputs
    -------
    d_tire : 1 x 1, outside diameter of a main tire [m]
    """
    d_rim = ca.SX.sym("d_rim")
    w_tire = ca.SX.sym("w_tire")
    d_tire = d_rim + (46/25)*w_tire  # two tires of type III
    return ca.Function(
        "outside_diameter",
        [d_rim, w_tire],
        [d_tire],
        ["d_rim", "w_tire"],
        ["d_tire"],
    )


@cache
def magic_formula() -> ca.Function:
    """Normalised force at a normalised slip angle.

    Inputs
    ------
    alpha_bar : scalar [1], normalised slip angle
    B1 : scalar [1], magic formula: stiffness factor
    C1 : scalar [1], magic formula: shape factor
    D1 : scalar [1], magic formula: peak factor
    E1 : scalar [1], magic formula: curvature factor

    Outputs
    -------
    F_bar : 1 x 1, normalised lateral force [1]

    Thesis
    ------
    Eq. 3.10, Eq. 3.9, Eq. 3.8
    """
    alpha_bar = ca.SX.sym("alpha_bar")
    B1 = ca.SX.sym("B1")
    C1 = ca.SX.sym("C1")
    D1 = ca.SX.sym("D1")
    E1 = ca.SX.sym("E1")
    psi_bar = alpha_bar*(1 - E1) + E1*ca.atan(B1*alpha_bar)/B1  # Eq. 3.10
    theta_bar = C1*ca.atan(B1*psi_bar)  # Eq. 3.9
    F_bar = D1*ca.sin(theta_bar)  # Eq. 3.8
    return ca.Function(
        "magic_formula",
        [alpha_bar, B1, C1, D1, E1],
        [F_bar],
        ["alpha_bar", "B1", "C1", "D1", "E1"],
        ["F_bar"],
    )


@cache
def measured_coefficients() -> ca.Function:
    """Cornering and friction coefficient from measured forces at one load.

    Inputs
    ------
    alpha : scalar [rad], slip angle of the main tires
    F_y : scalar [N], lateral force of one tire, to the left for a positive slip angle
    F_peak : scalar [N], largest lateral force at a load
    Fz : scalar [N], vertical load on one main tire

    Outputs
    -------
    C_c : 1 x 1, cornering stiffness over load [1/rad]
    mu : 1 x 1, lateral friction coefficient [1]

    Thesis
    ------
    Eq. 3.2, Eq. 3.4
    """
    alpha = ca.SX.sym("alpha")
    F_y = ca.SX.sym("F_y")
    F_peak = ca.SX.sym("F_peak")
    Fz = ca.SX.sym("Fz")
    C_c = F_y/(Fz*alpha)  # Eq. 3.2
    mu = F_peak/Fz  # Eq. 3.4
    return ca.Function(
        "measured_coefficients",
        [alpha, F_y, F_peak, Fz],
        [C_c, mu],
        ["alpha", "F_y", "F_peak", "Fz"],
        ["C_c", "mu"],
    )


@cache
def normalised_data() -> ca.Function:
    """A measured force in normalised form.

    Inputs
    ------
    alpha : scalar [rad], slip angle of the main tires
    F_y : scalar [N], lateral force of one tire, to the left for a positive slip angle
    Fz : scalar [N], vertical load on one main tire
    C_c : scalar [1/rad], cornering stiffness over load
    mu : scalar [1], lateral friction coefficient

    Outputs
    -------
    alpha_bar : 1 x 1, normalised slip angle [1]
    F_bar : 1 x 1, normalised lateral force [1]

    Thesis
    ------
    Eq. 3.6, Eq. 3.7
    """
    alpha = ca.SX.sym("alpha")
    F_y = ca.SX.sym("F_y")
    Fz = ca.SX.sym("Fz")
    C_c = ca.SX.sym("C_c")
    mu = ca.SX.sym("mu")
    alpha_bar = C_c*ca.tan(alpha)/mu  # Eq. 3.6
    F_bar = F_y/(Fz*mu)  # Eq. 3.7
    return ca.Function(
        "normalised_data",
        [alpha, F_y, Fz, C_c, mu],
        [alpha_bar, F_bar],
        ["alpha", "F_y", "Fz", "C_c", "mu"],
        ["alpha_bar", "F_bar"],
    )
