"""Pure lateral slip of the Magic Formula tire as .tir files have it (MF-Tyre 5.2 and 6.x).

Pacejka, Tire and Vehicle Dynamics, 3rd edition, Eqs. 4.E19 to 4.E30, without camber, turn slip and
change of pressure; with PKY4 = 2 it is that of 5.2, which takes the slip angle for its tangent.
Symbols are those of the files.
"""

from __future__ import annotations

import sympy as sp

from groundroll.derive.core.equation import Chain, Equation
from groundroll.derive.core.quantity import Quantity
from groundroll.derive.parts.quantities import Fz

#: Coefficients of a file: meaning, and value where a file does not give one.
COEFFICIENTS = {
    "PCY1": ("shape factor", None),
    "PDY1": ("friction at the nominal load", None),
    "PDY2": ("its change with load", 0),
    "PEY1": ("curvature at the nominal load", 0),
    "PEY2": ("its change with load", 0),
    "PEY3": ("its dependence on the sign of the slip angle", 0),
    "PKY1": ("largest stiffness over nominal load", None),
    "PKY2": ("load of the largest stiffness over nominal load", None),
    "PKY4": ("curvature of the stiffness", 2),
    "PHY1": ("horizontal shift at the nominal load", 0),
    "PHY2": ("its change with load", 0),
    "PVY1": ("vertical shift over load at the nominal load", 0),
    "PVY2": ("its change with load", 0),
    "LFZO": ("scale of the nominal load", 1),
    "LCY": ("scale of the shape factor", 1),
    "LMUY": ("scale of friction", 1),
    "LEY": ("scale of the curvature", 1),
    "LKY": ("scale of the stiffness", 1),
    "LHY": ("scale of the horizontal shift", 1),
    "LVY": ("scale of the vertical shift", 1),
}
_c = {name: Quantity(name, name.lower(), "1", words) for name, (words, _) in COEFFICIENTS.items()}

alpha = Quantity("alpha", "slip_angle", "rad", "slip angle of a tire", r"\alpha")
FNOMIN = Quantity("FNOMIN", "nominal_load", "N", "nominal load", "F_{z0}", ">0")
tangent = Quantity("tangent", "takes_tangent", "1", "1 if slip is the tangent of the angle, else 0")
df_z = Quantity("df_z", "load_change", "1", "load beyond the nominal over it", "df_z")
K_y = Quantity("K_y", "stiffness", "N", "slope at zero slip, as the file's axes have it", "K_y")
mu_y = Quantity("mu_y", "mf_friction", "1", "friction at a load", r"\mu_y")
S_H = Quantity("S_H", "horizontal_shift", "1", "horizontal shift", "S_{Hy}")
S_V = Quantity("S_V", "vertical_shift", "N", "vertical shift", "S_{Vy}")
slip = Quantity("slip", "shifted_slip", "1", "slip with its shift", r"\alpha_y")
C_y = Quantity("C_y", "mf_shape", "1", "shape factor", "C_y")
D_y = Quantity("D_y", "mf_peak", "N", "peak force", "D_y")
E_y = Quantity("E_y", "mf_curvature", "1", "curvature factor", "E_y")
B_y = Quantity("B_y", "mf_stiffness_factor", "1", "stiffness factor", "B_y")
b_y = Quantity("b_y", "mf_angle", "1", "intermediate", "b_y")
F_mf = Quantity("F_mf", "mf_force", "N", "lateral force, as the file's axes have it", "F_y")

#: What the function takes.
ARGUMENTS = (alpha, Fz, FNOMIN, tangent, *_c.values())


def lateral_force() -> Chain:
    """From slip angle and load to the lateral force."""
    nominal = _c["LFZO"] * FNOMIN
    sign = sp.Piecewise((1, slip >= 0), (-1, True))
    curvature = (_c["PEY1"] + _c["PEY2"] * df_z) * (1 - _c["PEY3"] * sign) * _c["LEY"]
    stiffness = sp.sin(_c["PKY4"] * sp.atan(Fz / (_c["PKY2"] * nominal)))
    return (
        Equation(df_z, (Fz - nominal) / nominal, "4.E2"),
        Equation(K_y, _c["PKY1"] * nominal * stiffness * _c["LKY"], "4.E25"),
        Equation(mu_y, (_c["PDY1"] + _c["PDY2"] * df_z) * _c["LMUY"], "4.E23"),
        Equation(S_H, (_c["PHY1"] + _c["PHY2"] * df_z) * _c["LHY"], "4.E27"),
        Equation(S_V, Fz * (_c["PVY1"] + _c["PVY2"] * df_z) * _c["LVY"] * _c["LMUY"], "4.E29"),
        Equation(slip, tangent * sp.tan(alpha) + (1 - tangent) * alpha + S_H, "4.E20"),
        Equation(C_y, _c["PCY1"] * _c["LCY"], "4.E21"),
        Equation(D_y, mu_y * Fz, "4.E22"),
        Equation(E_y, sp.Min(curvature, 1), "4.E24"),
        Equation(B_y, K_y / (C_y * D_y), "4.E26"),
        Equation(b_y, B_y * slip - E_y * (B_y * slip - sp.atan(B_y * slip)), "4.E19"),
        Equation(F_mf, D_y * sp.sin(C_y * sp.atan(b_y)) + S_V, "4.E19"),
    )
