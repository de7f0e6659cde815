# Generated from derive/ (digest 0a06213221c378cc) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`.
"""A kick: what an impulse changes at once."""

from functools import cache

import casadi as ca


@cache
def kick() -> ca.Function:
    """Changes of the motion by a side impulse at a station.

    Inputs
    ------
    S : scalar [N s], side impulse, to the right
    x_S : scalar [m], where it acts, ahead of the CG
    m : scalar [kg], total mass
    Izz : scalar [kg m^2], moment of inertia about the z axis

    Outputs
    -------
    dv : 1 x 1, what it adds to v [m/s]
    dr : 1 x 1, what it adds to r [rad/s]

    Thesis
    ------
    Eq. 4.1, integrated
    """
    S = ca.SX.sym("S")
    x_S = ca.SX.sym("x_S")
    m = ca.SX.sym("m")
    Izz = ca.SX.sym("Izz")
    dv = S/m  # Eq. 4.1, integrated
    dr = S*x_S/Izz  # Eq. 4.1, integrated
    return ca.Function(
        "kick",
        [S, x_S, m, Izz],
        [dv, dr],
        ["S", "x_S", "m", "Izz"],
        ["dv", "dr"],
    )
