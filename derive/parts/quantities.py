"""The symbols of the aircraft: name, unit and meaning, each declared once."""

from __future__ import annotations

from groundroll.derive.core.body import Izz, g, m, u_held
from groundroll.derive.core.quantity import Input, Parameter, State

# --- States of the thesis beside those of the body ----------------------------------------------
y = State("y", "lateral_displacement", "m", "integral of v: displacement in aircraft coordinates")
theta = State(
    "theta", "rotation", "rad", "integral of r: rotation in aircraft coordinates", r"\theta"
)

# --- Inputs ---------------------------------------------------------------------------------
F_disturbance = Input(
    "F_disturbance",
    "disturbance",
    "N",
    "side force on the vertical tail (a crosswind), to the right",
    r"F_{y\,\mathrm{disturbance}}",
)

#: The forward speed, which the thesis holds.
u = u_held

# --- Parameters of the airframe (Table 4.1) ---------------------------------------------------
a = Parameter("a", "main_gear_arm", "m", "main gear ahead of the CG (positive: taildragger)")
b = Parameter("b", "tail_arm", "m", "CG ahead of the vertical tail and the tail wheel", sign=">0")
rho = Parameter("rho", "air_density", "kg/m^3", "density of the air", r"\rho", ">0")
Ap = Parameter("Ap", "tail_area", "m^2", "area of the vertical tail", "A_p", ">=0")
CL_gamma = Parameter(
    "CL_gamma",
    "tail_lift_slope",
    "1/rad",
    "lift-curve slope of the vertical tail",
    r"C_{L\gamma}",
    ">=0",
)

# --- Parameters of the tires (Table 3.2) ------------------------------------------------------
C_alpha = Parameter(
    "C_alpha",
    "cornering_stiffness",
    "N/rad",
    "cornering stiffness of one main tire",
    r"C_\alpha",
    ">=0",
)
Ct = Parameter(
    "Ct",
    "tail_wheel_stiffness",
    "N/rad",
    "cornering stiffness of the tail wheel",
    r"C_{f\,\mathrm{tail}}",
    ">=0",
)
Fz = Parameter("Fz", "tire_load", "N", "vertical load on one main tire", "F_z", ">0")
B3 = Parameter(
    "B3", "cornering_coefficient_intercept", "1/rad", "cornering coefficient at no load", "B_3"
)
C3 = Parameter("C3", "cornering_coefficient_slope", "1/(rad N)", "its change with load", "C_3")
B5 = Parameter(
    "B5", "friction_coefficient_intercept", "1", "friction coefficient at no load", "B_5"
)
C5 = Parameter("C5", "friction_coefficient_slope", "1/N", "its change with load", "C_5")
B1 = Parameter("B1", "magic_formula_B", "1", "magic formula: stiffness factor", "B_1", ">0")
C1 = Parameter("C1", "magic_formula_C", "1", "magic formula: shape factor", "C_1")
D1 = Parameter("D1", "magic_formula_D", "1", "magic formula: peak factor", "D_1")
E1 = Parameter("E1", "magic_formula_E", "1", "magic formula: curvature factor", "E_1")

# --- Tires by size and pressure (NASA TR R-64) --------------------------------------------------
d_tire = Parameter(
    "d_tire", "tire_diameter", "m", "outside diameter of a main tire", r"d_{\mathrm{tire}}", ">0"
)
w_tire = Parameter("w_tire", "tire_width", "m", "width of a main tire", r"w_{\mathrm{tire}}", ">0")
p_tire = Parameter(
    "p_tire", "tire_pressure", "N/m^2", "pressure in a main tire", r"p_{\mathrm{tire}}", ">0"
)
p_rated = Parameter(
    "p_rated",
    "rated_tire_pressure",
    "N/m^2",
    "pressure at which the rated load of a main tire is given",
    r"p_{\mathrm{rated}}",
    ">0",
)
C_z = Parameter(
    "C_z", "tire_load_constant", "1", "of the type of the tires, in NASA TR R-64", "C_z", ">0"
)
C_N = Parameter(
    "C_N",
    "tire_cornering_constant",
    "1/rad",
    "of the type of the tires, in NASA TR R-64",
    "C_N",
    ">0",
)
d_tail = Parameter(
    "d_tail",
    "tail_tire_diameter",
    "m",
    "outside diameter of the tail wheel's tire",
    r"d_{\mathrm{tail}}",
    ">0",
)
w_tail = Parameter(
    "w_tail", "tail_tire_width", "m", "width of the tail wheel's tire", r"w_{\mathrm{tail}}", ">0"
)
p_tail = Parameter(
    "p_tail",
    "tail_tire_pressure",
    "N/m^2",
    "pressure in the tail wheel's tire",
    r"p_{\mathrm{tail}}",
    ">0",
)
delta_tire = Parameter(
    "delta_tire",
    "tire_deflection",
    "m",
    "static deflection of a main tire",
    r"\delta_{\mathrm{tire}}",
    ">0",
)
sigma = Parameter(
    "sigma",
    "relaxation_length",
    "m",
    "distance in which the side force of a main tire builds up",
    r"\sigma",
    ">0",
)

# --- What the main tires were measured at -------------------------------------------------------
Fz_low = Parameter(
    "Fz_low",
    "lowest_measured_load",
    "N",
    "lowest load at which a main tire was measured",
    "F_{z1}",
    ">0",
)
Fz_high = Parameter(
    "Fz_high",
    "highest_measured_load",
    "N",
    "highest load at which a main tire was measured",
    "F_{z2}",
    ">0",
)
alpha_high = Parameter(
    "alpha_high",
    "largest_measured_slip_angle",
    "rad",
    "largest slip angle at which a main tire was measured",
    r"\alpha_2",
    ">0",
)

# --- Stations along the fuselage, positive aft of the datum (Section 4.2.2) -------------------
x_cg = Parameter("x_cg", "cg_station", "m", "the CG behind the datum", r"x_{\mathrm{CG}}")
x_main = Parameter(
    "x_main", "main_gear_station", "m", "the main gear behind it", r"x_{\mathrm{main}}"
)
x_tail = Parameter(
    "x_tail", "tail_station", "m", "vertical tail and tail wheel behind it", r"x_{\mathrm{tail}}"
)
x_forward = Parameter(
    "x_forward", "cg_forward_limit", "m", "forward limit of the CG", r"x_{\mathrm{forward}}"
)
x_aft = Parameter("x_aft", "cg_aft_limit", "m", "aft limit of the CG", r"x_{\mathrm{aft}}")

# --- Loads (Section 4.2.2, App. A.6, Fig. 3.8) ------------------------------------------------
L = Parameter("L", "wheelbase", "m", "main gear to tail wheel", sign=">0")
f = Parameter("f", "main_gear_weight_fraction", "1", "fraction of the weight on the main gear")
F_tail_load = Parameter(
    "F_tail_load",
    "tail_wheel_load",
    "N",
    "vertical load on the tail wheel",
    r"F_{z\,\mathrm{tail}}",
    ">=0",
)
h_cg = Parameter(
    "h_cg",
    "cg_height",
    "m",
    "the CG above the ground, in the attitude in which stations are measured",
    r"h_{\mathrm{CG}}",
    ">0",
)
x_nose = Parameter(
    "x_nose", "nose_wheel_station", "m", "the nose wheel behind the datum", r"x_{\mathrm{nose}}"
)
u_lift = Parameter(
    "u_lift",
    "lift_off_speed",
    "m/s",
    "speed at which the wings carry all the weight, in the attitude of the ground roll",
    r"u_{\mathrm{lift}}",
    ">0",
)
K1 = Parameter("K1", "tail_wheel_K1", "1/rad", "tail wheel stiffness over load: linear term", "K_1")
K2 = Parameter("K2", "tail_wheel_K2", "1/(rad N)", "quadratic term", "K_2")
K3 = Parameter("K3", "tail_wheel_K3", "1/(rad N^2)", "cubic term", "K_3")
K4 = Parameter("K4", "tail_wheel_K4", "1/(rad N^3)", "quartic term", "K_4")

#: In the order of the parameter vectors.
PARAMETERS = (
    *(m, Izz, a, b, u, rho, Ap, CL_gamma),
    *(C_alpha, Ct, Fz, B3, C3, B5, C5, B1, C1, D1, E1),
    *(x_cg, x_main, x_tail, x_forward, x_aft),
    *(g, L, f, F_tail_load, K1, K2, K3, K4),
    *(h_cg, x_nose, u_lift),
    *(d_tire, w_tire, p_tire, p_rated, C_z, C_N, delta_tire, sigma),
    *(d_tail, w_tail, p_tail, Fz_low, Fz_high, alpha_high),
)
