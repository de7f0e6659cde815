"""The symbols of the model: name, unit and meaning, each declared once.

Units are SI with radians. A `Quantity` *is* a SymPy symbol, so equations are written with it
directly and every expression knows the units of its leaves.
"""

from __future__ import annotations

from typing import Any

import sympy as sp


class Quantity(sp.Symbol):  # type: ignore[misc]
    """A real symbol with a unit and a meaning.

    Parameters
    ----------
    symbol : str
        Symbol used in equations and in generated code, e.g. ``"r"``.
    name : str
        The field's full name, e.g. ``"yaw_rate"``.
    unit : str
        SI unit, e.g. ``"kg m^2"``; ``"1"`` for a pure number.
    meaning : str
        One line for people, with the sign convention where there is one.
    latex : str, optional
        Symbol in LaTeX; SymPy's own rendering of `symbol` if omitted.
    sign : str, optional
        ``">0"`` or ``">=0"`` for what cannot be otherwise (a mass, an area).
    """

    __slots__ = ("full_name", "latex", "meaning", "sign", "unit")

    full_name: str
    unit: str
    meaning: str
    latex: str
    sign: str

    def __new__(
        cls,
        symbol: str,
        name: str,
        unit: str,
        meaning: str,
        latex: str = "",
        sign: str = "",
    ) -> Quantity:
        assumption = {">0": {"positive": True}, ">=0": {"nonnegative": True}, "": {}}[sign]
        obj: Quantity = sp.Symbol.__xnew__(cls, symbol, real=True, **assumption)
        obj.full_name = name
        obj.unit = unit
        obj.meaning = meaning
        obj.latex = latex or sp.latex(sp.Symbol(symbol))
        obj.sign = sign
        return obj

    def __getnewargs_ex__(self) -> tuple[tuple[Any, ...], dict[str, Any]]:
        args = (self.name, self.full_name, self.unit, self.meaning, self.latex, self.sign)
        return args, {}

    def _latex(self, printer: Any) -> str:
        return self.latex


# --- States ---------------------------------------------------------------------------------
v = Quantity(
    "v", "lateral_velocity", "m/s", "velocity of the CG along the body y axis, to the right"
)
r = Quantity("r", "yaw_rate", "rad/s", "angular velocity about the body z axis, nose right")
y = Quantity(
    "y", "lateral_displacement", "m", "integral of v: displacement in aircraft coordinates"
)
theta = Quantity(
    "theta", "rotation", "rad", "integral of r: rotation in aircraft coordinates", r"\theta"
)
X = Quantity("X", "distance", "m", "position of the CG along the runway")
Y = Quantity("Y", "offset", "m", "position of the CG across the runway, to the right")
psi = Quantity(
    "psi", "heading", "rad", "angle from the runway to the body x axis, nose right", r"\psi"
)

# --- Inputs ---------------------------------------------------------------------------------
F_disturbance = Quantity(
    "F_disturbance",
    "disturbance",
    "N",
    "side force on the vertical tail (a crosswind), to the right",
    r"F_{y\,\mathrm{disturbance}}",
)

# --- Parameters of the airframe (Table 4.1) ---------------------------------------------------
m = Quantity("m", "mass", "kg", "total mass", sign=">0")
Izz = Quantity("Izz", "yaw_inertia", "kg m^2", "moment of inertia about the z axis", "I_{zz}", ">0")
a = Quantity("a", "main_gear_arm", "m", "main gear ahead of the CG (positive: taildragger)")
b = Quantity("b", "tail_arm", "m", "CG ahead of the vertical tail and the tail wheel", sign=">0")
u = Quantity("u", "speed", "m/s", "forward speed, constant", sign=">0")
rho = Quantity("rho", "air_density", "kg/m^3", "density of the air", r"\rho", ">0")
Ap = Quantity("Ap", "tail_area", "m^2", "area of the vertical tail", "A_p", ">=0")
CL_gamma = Quantity(
    "CL_gamma",
    "tail_lift_slope",
    "1/rad",
    "lift-curve slope of the vertical tail",
    r"C_{L\gamma}",
    ">=0",
)

# --- Parameters of the tires (Table 3.2) ------------------------------------------------------
C_alpha = Quantity(
    "C_alpha",
    "cornering_stiffness",
    "N/rad",
    "cornering stiffness of one main tire",
    r"C_\alpha",
    ">=0",
)
Ct = Quantity(
    "Ct",
    "tail_wheel_stiffness",
    "N/rad",
    "cornering stiffness of the tail wheel",
    r"C_{f\,\mathrm{tail}}",
    ">=0",
)
Fz = Quantity("Fz", "tire_load", "N", "vertical load on one main tire", "F_z", ">0")
B3 = Quantity(
    "B3", "cornering_coefficient_intercept", "1/rad", "cornering coefficient at no load", "B_3"
)
C3 = Quantity("C3", "cornering_coefficient_slope", "1/(rad N)", "its change with load", "C_3")
B5 = Quantity("B5", "friction_coefficient_intercept", "1", "friction coefficient at no load", "B_5")
C5 = Quantity("C5", "friction_coefficient_slope", "1/N", "its change with load", "C_5")
B1 = Quantity("B1", "magic_formula_B", "1", "magic formula: stiffness factor", "B_1", ">0")
C1 = Quantity("C1", "magic_formula_C", "1", "magic formula: shape factor", "C_1")
D1 = Quantity("D1", "magic_formula_D", "1", "magic formula: peak factor", "D_1")
E1 = Quantity("E1", "magic_formula_E", "1", "magic formula: curvature factor", "E_1")

# --- Stations along the fuselage, positive aft of the datum (Section 4.2.2) -------------------
x_cg = Quantity("x_cg", "cg_station", "m", "the CG behind the datum", r"x_{\mathrm{CG}}")
x_main = Quantity(
    "x_main", "main_gear_station", "m", "the main gear behind it", r"x_{\mathrm{main}}"
)
x_tail = Quantity(
    "x_tail", "tail_station", "m", "vertical tail and tail wheel behind it", r"x_{\mathrm{tail}}"
)
x_forward = Quantity(
    "x_forward", "cg_forward_limit", "m", "forward limit of the CG", r"x_{\mathrm{forward}}"
)
x_aft = Quantity("x_aft", "cg_aft_limit", "m", "aft limit of the CG", r"x_{\mathrm{aft}}")

# --- Loads (Section 4.2.2, App. A.6, Fig. 3.8) ------------------------------------------------
g = Quantity("g", "gravity", "m/s^2", "acceleration due to gravity", sign=">0")
L = Quantity("L", "wheelbase", "m", "main gear to tail wheel", sign=">0")
f = Quantity("f", "main_gear_weight_fraction", "1", "fraction of the weight on the main gear")
F_tail_load = Quantity(
    "F_tail_load",
    "tail_wheel_load",
    "N",
    "vertical load on the tail wheel",
    r"F_{z\,\mathrm{tail}}",
    ">=0",
)
h_cg = Quantity(
    "h_cg",
    "cg_height",
    "m",
    "the CG above the ground, in the attitude in which stations are measured",
    r"h_{\mathrm{CG}}",
    ">0",
)
x_nose = Quantity(
    "x_nose", "nose_wheel_station", "m", "the nose wheel behind the datum", r"x_{\mathrm{nose}}"
)
u_lift = Quantity(
    "u_lift",
    "lift_off_speed",
    "m/s",
    "speed at which the wings carry all the weight, in the attitude of the ground roll",
    r"u_{\mathrm{lift}}",
    ">0",
)
K1 = Quantity("K1", "tail_wheel_K1", "1/rad", "tail wheel stiffness over load: linear term", "K_1")
K2 = Quantity("K2", "tail_wheel_K2", "1/(rad N)", "quadratic term", "K_2")
K3 = Quantity("K3", "tail_wheel_K3", "1/(rad N^2)", "cubic term", "K_3")
K4 = Quantity("K4", "tail_wheel_K4", "1/(rad N^3)", "quartic term", "K_4")

STATES = (v, r, y, theta, X, Y, psi)
INPUTS = (F_disturbance,)
PARAMETERS = (
    *(m, Izz, a, b, u, rho, Ap, CL_gamma),
    *(C_alpha, Ct, Fz, B3, C3, B5, C5, B1, C1, D1, E1),
    *(x_cg, x_main, x_tail, x_forward, x_aft),
    *(g, L, f, F_tail_load, K1, K2, K3, K4),
    *(h_cg, x_nose, u_lift),
)
