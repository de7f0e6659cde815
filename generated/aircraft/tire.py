# Generated from derive/ (digest e5b6e081fb255334) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`.
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
