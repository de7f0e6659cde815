# Generated from derive/ (digest 61dbe1126aa8d733) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`.
"""Names, units and meanings; signatures of the models; where each function is."""

from typing import NamedTuple


class Quantity(NamedTuple):
    """What a symbol stands for; SI units with radians."""

    symbol: str
    name: str
    unit: str
    meaning: str
    latex: str
    sign: str


class Signature(NamedTuple):
    """Order of the vectors of a model: x' = f(x, u, p) and y = g(x, u, p)."""

    states: tuple[str, ...]
    dynamic: tuple[str, ...]
    inputs: tuple[str, ...]
    parameters: tuple[str, ...]
    outputs: tuple[str, ...]


class Kernel(NamedTuple):
    """Some states of a model; C files ..._ensemble and ..._trajectory integrate them."""

    model: str
    states: tuple[str, ...]


DIGEST = "61dbe1126aa8d733"

QUANTITIES = {
    q.symbol: q
    for q in (
        Quantity("v", "lateral_velocity", "m/s", "velocity of the CG along the body y axis, to the right", "v", ""),
        Quantity("r", "yaw_rate", "rad/s", "angular velocity about the body z axis, nose right", "r", ""),
        Quantity("y", "lateral_displacement", "m", "integral of v: displacement in aircraft coordinates", "y", ""),
        Quantity("theta", "rotation", "rad", "integral of r: rotation in aircraft coordinates", "\\theta", ""),
        Quantity("X", "distance", "m", "position of the CG along the runway", "X", ""),
        Quantity("Y", "offset", "m", "position of the CG across the runway, to the right", "Y", ""),
        Quantity("psi", "heading", "rad", "angle from the runway to the body x axis, nose right", "\\psi", ""),
        Quantity("m", "mass", "kg", "total mass", "m", ">0"),
        Quantity("Izz", "yaw_inertia", "kg m^2", "moment of inertia about the z axis", "I_{zz}", ">0"),
        Quantity("a", "main_gear_arm", "m", "main gear ahead of the CG (positive: taildragger)", "a", ""),
        Quantity("b", "tail_arm", "m", "CG ahead of the vertical tail and the tail wheel", "b", ">0"),
        Quantity("u", "speed", "m/s", "forward speed, constant", "u", ">0"),
        Quantity("rho", "air_density", "kg/m^3", "density of the air", "\\rho", ">0"),
        Quantity("Ap", "tail_area", "m^2", "area of the vertical tail", "A_p", ">=0"),
        Quantity("CL_gamma", "tail_lift_slope", "1/rad", "lift-curve slope of the vertical tail", "C_{L\\gamma}", ">=0"),
        Quantity("C_alpha", "cornering_stiffness", "N/rad", "cornering stiffness of one main tire", "C_\\alpha", ">=0"),
        Quantity("Ct", "tail_wheel_stiffness", "N/rad", "cornering stiffness of the tail wheel", "C_{f\\,\\mathrm{tail}}", ">=0"),
        Quantity("Fz", "tire_load", "N", "vertical load on one main tire", "F_z", ">0"),
        Quantity("B3", "cornering_coefficient_intercept", "1/rad", "cornering coefficient at no load", "B_3", ""),
        Quantity("C3", "cornering_coefficient_slope", "1/(rad N)", "its change with load", "C_3", ""),
        Quantity("B5", "friction_coefficient_intercept", "1", "friction coefficient at no load", "B_5", ""),
        Quantity("C5", "friction_coefficient_slope", "1/N", "its change with load", "C_5", ""),
        Quantity("B1", "magic_formula_B", "1", "magic formula: stiffness factor", "B_1", ">0"),
        Quantity("C1", "magic_formula_C", "1", "magic formula: shape factor", "C_1", ""),
        Quantity("D1", "magic_formula_D", "1", "magic formula: peak factor", "D_1", ""),
        Quantity("E1", "magic_formula_E", "1", "magic formula: curvature factor", "E_1", ""),
        Quantity("x_cg", "cg_station", "m", "the CG behind the datum", "x_{\\mathrm{CG}}", ""),
        Quantity("x_main", "main_gear_station", "m", "the main gear behind it", "x_{\\mathrm{main}}", ""),
        Quantity("x_tail", "tail_station", "m", "vertical tail and tail wheel behind it", "x_{\\mathrm{tail}}", ""),
        Quantity("x_forward", "cg_forward_limit", "m", "forward limit of the CG", "x_{\\mathrm{forward}}", ""),
        Quantity("x_aft", "cg_aft_limit", "m", "aft limit of the CG", "x_{\\mathrm{aft}}", ""),
        Quantity("g", "gravity", "m/s^2", "acceleration due to gravity", "g", ">0"),
        Quantity("L", "wheelbase", "m", "main gear to tail wheel", "L", ">0"),
        Quantity("f", "main_gear_weight_fraction", "1", "fraction of the weight on the main gear", "f", ""),
        Quantity("F_tail_load", "tail_wheel_load", "N", "vertical load on the tail wheel", "F_{z\\,\\mathrm{tail}}", ">=0"),
        Quantity("K1", "tail_wheel_K1", "1/rad", "tail wheel stiffness over load: linear term", "K_1", ""),
        Quantity("K2", "tail_wheel_K2", "1/(rad N)", "quadratic term", "K_2", ""),
        Quantity("K3", "tail_wheel_K3", "1/(rad N^2)", "cubic term", "K_3", ""),
        Quantity("K4", "tail_wheel_K4", "1/(rad N^3)", "quartic term", "K_4", ""),
        Quantity("h_cg", "cg_height", "m", "the CG above the ground, in the attitude in which stations are measured", "h_{\\mathrm{CG}}", ">0"),
        Quantity("x_nose", "nose_wheel_station", "m", "the nose wheel behind the datum", "x_{\\mathrm{nose}}", ""),
        Quantity("u_lift", "lift_off_speed", "m/s", "speed at which the wings carry all the weight, in the attitude of the ground roll", "u_{\\mathrm{lift}}", ">0"),
        Quantity("F_disturbance", "disturbance", "N", "side force on the vertical tail (a crosswind), to the right", "F_{y\\,\\mathrm{disturbance}}", ""),
        Quantity("alpha", "main_gear_slip_angle", "rad", "slip angle of the main tires", "\\alpha", ""),
        Quantity("gamma", "tail_angle", "rad", "angle of incidence of the tail and its wheel", "\\gamma", ""),
        Quantity("beta", "sideslip_angle", "rad", "angle of the CG's velocity to the x axis", "\\beta", ""),
        Quantity("F_main", "main_gear_force", "N", "lateral force of the two main tires, to the left", "F_{y\\,\\mathrm{main}}", ""),
        Quantity("F_tail", "tail_force", "N", "side force of the vertical tail, to the left", "F_{y\\,\\mathrm{tail}}", ""),
        Quantity("F_tail_wheel", "tail_wheel_force", "N", "lateral force of the tail wheel, to the left", "F_{y\\,\\mathrm{tailwheel}}", ""),
        Quantity("a_y", "lateral_acceleration", "m/s^2", "acceleration of the CG along y", "a_y", ""),
        Quantity("sum_F", "side_force", "N", "sum of the forces along y", "\\sum F_y", ""),
        Quantity("sum_M", "yaw_moment", "N m", "sum of the moments about z through the CG", "\\sum M_z", ""),
        Quantity("F_y", "tire_force", "N", "lateral force of one tire, to the left for a positive slip angle", "F_{y}", ""),
        Quantity("alpha_bar", "normalised_slip_angle", "1", "normalised slip angle", "\\bar{\\alpha}", ""),
        Quantity("F_bar", "normalised_force", "1", "normalised lateral force", "\\bar{F}_y", ""),
        Quantity("C_c", "cornering_coefficient", "1/rad", "cornering stiffness over load", "C_{c}", ""),
        Quantity("mu", "friction_coefficient", "1", "lateral friction coefficient", "\\mu_y", ""),
        Quantity("F_peak", "peak_force", "N", "largest lateral force at a load", "F_{y\\,\\max}", ""),
        Quantity("A_vv", "A_vv", "1/s", "d v_dot / d v", "A_{vv}", ""),
        Quantity("A_vr", "A_vr", "m/s", "d v_dot / d r", "A_{vr}", ""),
        Quantity("A_rv", "A_rv", "1/(m s)", "d r_dot / d v", "A_{rv}", ""),
        Quantity("A_rr", "A_rr", "1/s", "d r_dot / d r", "A_{rr}", ""),
        Quantity("trace", "trace", "1/s", "tr A: stable needs < 0", "\\operatorname{tr} A", ""),
        Quantity("det", "determinant", "1/s^2", "det A: stable needs > 0", "\\det A", ""),
        Quantity("discriminant", "discriminant", "1/s^2", "negative: the modes oscillate", "\\Delta", ""),
        Quantity("re_1", "re_1", "1/s", "real part of the first eigenvalue", "\\Re\\lambda_1", ""),
        Quantity("im_1", "im_1", "rad/s", "imaginary part of the first eigenvalue", "\\Im\\lambda_1", ""),
        Quantity("re_2", "re_2", "1/s", "real part of the second eigenvalue", "\\Re\\lambda_2", ""),
        Quantity("im_2", "im_2", "rad/s", "imaginary part of the second eigenvalue", "\\Im\\lambda_2", ""),
        Quantity("decay_rate", "decay_rate", "1/s", "-max Re(eigenvalue): stable if positive", "d", ""),
        Quantity("natural_frequency", "natural_frequency", "rad/s", "undamped natural frequency", "\\omega_n", ""),
        Quantity("damped_frequency", "damped_frequency", "rad/s", "size of the imaginary part of an eigenvalue", "\\omega_d", ""),
        Quantity("damping_ratio", "damping_ratio", "1", "above 1: two real eigenvalues", "\\zeta", ""),
        Quantity("T_half", "time_to_half", "s", "in which a deviation halves; infinite if it never does", "T_{1/2}", ""),
        Quantity("T_double", "time_to_double", "s", "in which a deviation doubles; infinite if it never does", "T_2", ""),
        Quantity("u_low", "lower_critical_speed", "m/s", "the aircraft is unstable from here", "u_{\\mathrm{low}}", ""),
        Quantity("u_high", "upper_critical_speed", "m/s", "to here", "u_{\\mathrm{high}}", ""),
        Quantity("u_weakest", "weakest_speed", "m/s", "speed at which det A is least", "u_{\\mathrm{weak}}", ""),
        Quantity("det_weakest", "least_determinant", "1/s^2", "det A there", "\\det A_{\\mathrm{weak}}", ""),
        Quantity("e_0", "e_0", "N^4 m^4 s^0", "coefficient of s^0: a real eigenvalue is stationary at a root", "e_{0}", ""),
        Quantity("e_1", "e_1", "N^4 m^2 s^2", "coefficient of s^1: a real eigenvalue is stationary at a root", "e_{1}", ""),
        Quantity("e_2", "e_2", "N^4 m^0 s^4", "coefficient of s^2: a real eigenvalue is stationary at a root", "e_{2}", ""),
        Quantity("e_3", "e_3", "N^4 m^-2 s^6", "coefficient of s^3: a real eigenvalue is stationary at a root", "e_{3}", ""),
        Quantity("e_4", "e_4", "N^4 m^-4 s^8", "coefficient of s^4: a real eigenvalue is stationary at a root", "e_{4}", ""),
        Quantity("u_trace", "least_damping_speed", "m/s", "speed at which -tr A is least", "u_{\\mathrm{tr}}", ""),
        Quantity("x_neutral", "neutral_steer_point", "m", "ahead of the CG: where a side force gives no steady yaw rate", "x_{\\mathrm{N}}", ""),
        Quantity("static_margin", "static_margin", "1", "neutral-steer point behind the CG, over the wheelbase: stable if positive", "\\mathit{SM}", ""),
        Quantity("K_us", "understeer_gradient", "rad s^2/m", "steer angle of the main wheels per lateral acceleration beyond that of pure rolling", "K_{\\mathrm{us}}", ""),
        Quantity("Ct_needed", "tail_wheel_stiffness_needed", "N/rad", "tail wheel stiffness at which det A = 0 at this speed; negative: stable without", "C_{f\\,\\mathrm{tail,\\,needed}}", ""),
        Quantity("Ct_always", "tail_wheel_stiffness_always", "N/rad", "tail wheel stiffness from which det A > 0 at every speed", "C_{f\\,\\mathrm{tail,\\,always}}", ""),
        Quantity("speed_margin", "speed_margin", "1", "sqrt(b Ct/(L C_f)) + sqrt(L k/m) - sqrt(a/L): positive is stable at every speed", "\\mathit{VM}", ""),
        Quantity("a_lost", "gear_arm_lost", "m", "gear ahead of the CG: unstable from here", "a_{\\mathrm{lost}}", ""),
        Quantity("a_regained", "gear_arm_regained", "m", "to here", "a_{\\mathrm{regained}}", ""),
        Quantity("a_always", "gear_arm_always", "m", "gear ahead of the CG: stable at every speed up to here; NaN: anywhere", "a_{\\mathrm{always}}", ""),
        Quantity("u_touch", "touching_speed", "m/s", "speed at which det A is least", "u_{\\mathrm{touch}}", ""),
        Quantity("p_0", "p_0", "N^2 m/kg", "coefficient of tail_load_fraction^0", "p_{0}", ""),
        Quantity("p_1", "p_1", "N^2 m/kg", "coefficient of tail_load_fraction^1", "p_{1}", ""),
        Quantity("p_2", "p_2", "N^2 m/kg", "coefficient of tail_load_fraction^2", "p_{2}", ""),
        Quantity("p_3", "p_3", "N^2 m/kg", "coefficient of tail_load_fraction^3", "p_{3}", ""),
        Quantity("p_4", "p_4", "N^2 m/kg", "coefficient of tail_load_fraction^4", "p_{4}", ""),
        Quantity("p_5", "p_5", "N^2 m/kg", "coefficient of tail_load_fraction^5", "p_{5}", ""),
        Quantity("g_0", "g_0", "N^2", "coefficient of tail_load_fraction^0", "g_{0}", ""),
        Quantity("g_1", "g_1", "N^2", "coefficient of tail_load_fraction^1", "g_{1}", ""),
        Quantity("g_2", "g_2", "N^2", "coefficient of tail_load_fraction^2", "g_{2}", ""),
        Quantity("g_3", "g_3", "N^2", "coefficient of tail_load_fraction^3", "g_{3}", ""),
        Quantity("g_4", "g_4", "N^2", "coefficient of tail_load_fraction^4", "g_{4}", ""),
        Quantity("g_5", "g_5", "N^2", "coefficient of tail_load_fraction^5", "g_{5}", ""),
        Quantity("g_6", "g_6", "N^2", "coefficient of tail_load_fraction^6", "g_{6}", ""),
        Quantity("g_7", "g_7", "N^2", "coefficient of tail_load_fraction^7", "g_{7}", ""),
        Quantity("g_8", "g_8", "N^2", "coefficient of tail_load_fraction^8", "g_{8}", ""),
        Quantity("g_9", "g_9", "N^2", "coefficient of tail_load_fraction^9", "g_{9}", ""),
        Quantity("g_10", "g_10", "N^2", "coefficient of tail_load_fraction^10", "g_{10}", ""),
        Quantity("tail_fraction", "tail_load_fraction", "1", "share of the weight on the tail wheel", "\\phi", ""),
        Quantity("a_loaded", "gear_arm_of_load", "m", "gear ahead of the CG at that share", "a_\\phi", ""),
        Quantity("d_sum_M_d_alpha", "d_yaw_moment_d_main_gear_slip_angle", "(N m)/(rad)", "derivative of sum_M by alpha", "\\frac{\\partial \\sum M_z}{\\partial \\alpha}", ""),
        Quantity("d_M_gear_d_alpha", "d_gear_moment_d_main_gear_slip_angle", "(N m)/(rad)", "derivative of M_gear by alpha", "\\frac{\\partial M_{\\mathrm{gear}}}{\\partial \\alpha}", ""),
        Quantity("x_third", "third_wheel_station", "m", "tail wheel or nose wheel behind the datum", "x_{\\mathrm{third}}", ""),
        Quantity("kappa", "tail_wheel_scale", "1", "stiffness of the tail wheel over that of the aircraft file; 0: it casters", "\\kappa", ">=0"),
        Quantity("w", "weight_on_wheels", "1", "share of the weight on the wheels, lift by speed apart", "w", ""),
        Quantity("tau", "tail_load", "1", "load on the tail wheel over the one that follows from the CG", "\\tau", ""),
        Quantity("eta", "tire_wear", "1", "cornering stiffness of the tires over that of new ones", "\\eta", ">0"),
        Quantity("C_alpha_0", "given_cornering_stiffness", "N/rad", "cornering stiffness of one main tire at the full weight", "C_{\\alpha 0}", ""),
        Quantity("Fz_0", "given_tire_load", "N", "load on one main tire at the full weight", "F_{z0}", ""),
        Quantity("Ct_0", "given_tail_wheel_stiffness", "N/rad", "cornering stiffness of the tail wheel at its static load", "C_{f\\,\\mathrm{tail}\\,0}", ""),
        Quantity("F_0", "given_tail_wheel_load", "N", "the static load at which that holds", "F_0", ""),
        Quantity("B3_worn", "worn_intercept", "1/rad", "B3 of a worn tire", "B_{3\\eta}", ""),
        Quantity("C3_worn", "worn_slope", "1/(rad N)", "C3 of a worn tire", "C_{3\\eta}", ""),
        Quantity("d", "required_decay_rate", "1/s", "a decay rate to be reached", "d", ""),
        Quantity("zeta", "required_damping_ratio", "1", "a damping ratio to be reached", "\\zeta", ""),
        Quantity("trace_d", "shifted_trace", "1/s", "tr(A + d I): not positive", "\\operatorname{tr}_d", ""),
        Quantity("det_d", "shifted_determinant", "1/s^2", "det(A + d I): not negative", "\\det{}_d", ""),
        Quantity("damping", "damping_polynomial", "1/s^2", "(tr A)^2 - 4 zeta^2 det A: not negative", "Z", ""),
        Quantity("third_load", "third_wheel_load_fraction", "1", "share of the weight on the tail wheel or nose wheel, at rest", "\\phi", ""),
        Quantity("nose_over", "nose_over_angle", "rad", "from the vertical below the CG forward to the main wheels", "\\nu", ""),
        Quantity("tip_back", "tip_back_angle", "rad", "from the vertical below the CG back to the main wheels", "\\epsilon", ""),
        Quantity("span", "wheel_span", "m", "main gear to tail wheel or nose wheel", "l", ""),
        Quantity("S", "impulse", "N s", "side impulse, to the right", "S", ""),
        Quantity("x_S", "impulse_station", "m", "where it acts, ahead of the CG", "x_S", ""),
        Quantity("dv", "lateral_velocity_change", "m/s", "what it adds to v", "\\Delta v", ""),
        Quantity("dr", "yaw_rate_change", "rad/s", "what it adds to r", "\\Delta r", ""),
    )
}

MODELS = {
    "linear": Signature(
        ("v", "r", "y", "theta", "X", "Y", "psi",),
        ("v", "r",),
        ("F_disturbance",),
        ("m", "Izz", "a", "b", "u", "rho", "Ap", "CL_gamma", "C_alpha", "Ct",),
        ("alpha", "gamma", "beta", "F_main", "F_tail", "F_tail_wheel", "a_y", "sum_F", "sum_M",),
    ),
    "nonlinear": Signature(
        ("v", "r", "y", "theta", "X", "Y", "psi",),
        ("v", "r",),
        ("F_disturbance",),
        ("m", "Izz", "a", "b", "u", "rho", "Ap", "CL_gamma", "Ct", "Fz", "B3", "C3", "B5", "C5", "B1", "C1", "D1", "E1",),
        ("alpha", "gamma", "beta", "F_main", "F_tail", "F_tail_wheel", "a_y", "sum_F", "sum_M",),
    ),
}

#: Name of a function -> module, builder, C file.
FUNCTIONS = {
    "linear_rhs": ("linear", "rhs", "linear"),
    "linear_outputs": ("linear", "outputs", "linear"),
    "linear_jacobians": ("linear", "jacobians", "linear"),
    "linear_rk4": ("linear", "rk4", "linear_rk4"),
    "linear_rk45": ("linear", "rk45", "linear_rk45"),
    "nonlinear_rhs": ("nonlinear", "rhs", "nonlinear"),
    "nonlinear_outputs": ("nonlinear", "outputs", "nonlinear"),
    "nonlinear_jacobians": ("nonlinear", "jacobians", "nonlinear"),
    "nonlinear_rk4": ("nonlinear", "rk4", "nonlinear_rk4"),
    "nonlinear_rk45": ("nonlinear", "rk45", "nonlinear_rk45"),
    "a_follows": ("loads", "a_follows", "loads"),
    "b_follows": ("loads", "b_follows", "loads"),
    "L_follows": ("loads", "L_follows", "loads"),
    "f_follows": ("loads", "f_follows", "loads"),
    "Fz_follows": ("loads", "Fz_follows", "loads"),
    "F_tail_load_follows": ("loads", "F_tail_load_follows", "loads"),
    "C_alpha_follows": ("loads", "C_alpha_follows", "loads"),
    "Ct_follows": ("loads", "Ct_follows", "loads"),
    "f_follows_with_nose_wheel": ("loads", "f_follows_with_nose_wheel", "loads"),
    "F_tail_load_follows_with_nose_wheel": ("loads", "F_tail_load_follows_with_nose_wheel", "loads"),
    "tire_force": ("tire", "tire_force", "tire"),
    "magic_formula": ("tire", "magic_formula", "tire"),
    "measured_coefficients": ("tire", "measured_coefficients", "tire"),
    "normalised_data": ("tire", "normalised_data", "tire"),
    "state_matrix": ("stability", "state_matrix", "stability"),
    "routh_hurwitz": ("stability", "routh_hurwitz", "stability"),
    "modes": ("stability", "modes", "stability"),
    "linear_modes": ("stability", "linear_modes", "stability"),
    "times": ("stability", "times", "stability"),
    "speed_window": ("stability", "speed_window", "stability"),
    "weakest_speed": ("stability", "weakest_speed", "stability"),
    "stationary_decay": ("stability", "stationary_decay", "stability"),
    "steady_margins": ("stability", "steady_margins", "stability"),
    "tail_wheel_needed": ("stability", "tail_wheel_needed", "stability"),
    "tail_wheel_always": ("stability", "tail_wheel_always", "stability"),
    "gear_position": ("stability", "gear_position", "stability"),
    "gear_position_envelope": ("stability", "gear_position_envelope", "stability"),
    "loaded_gear_position": ("stability", "loaded_gear_position", "stability"),
    "loaded_gear_envelope": ("stability", "loaded_gear_envelope", "stability"),
    "at_tail_load": ("stability", "at_tail_load", "stability"),
    "linear_equilibrium": ("stability", "linear_equilibrium", "stability"),
    "nonlinear_equilibrium": ("stability", "nonlinear_equilibrium", "stability"),
    "placement_following": ("placement", "placement_following", "placement"),
    "placement_constant": ("placement", "placement_constant", "placement"),
    "placement_tire": ("placement", "placement_tire", "placement"),
    "placement_margins": ("placement", "placement_margins", "placement"),
    "placement_limits": ("placement", "placement_limits", "placement"),
    "kick": ("kick", "kick", "kick"),
}

#: How the names of a kernel's C files begin -> what it carries.
KERNELS = {
    "linear_least": Kernel("linear", ("v", "r", "y", "theta",)),
    "linear_body": Kernel("linear", ("v", "r", "y", "theta", "psi",)),
    "linear_path": Kernel("linear", ("v", "r", "psi", "y", "theta", "X", "Y",)),
    "nonlinear_least": Kernel("nonlinear", ("v", "r", "y", "theta",)),
    "nonlinear_body": Kernel("nonlinear", ("v", "r", "y", "theta", "psi",)),
    "nonlinear_path": Kernel("nonlinear", ("v", "r", "psi", "y", "theta", "X", "Y",)),
}

#: Name of a function that has a kernel for many points -> C file.
SWEEPS = {
    "state_matrix": "stability_sweep",
    "routh_hurwitz": "stability_sweep",
    "modes": "stability_sweep",
    "linear_modes": "stability_sweep",
    "times": "stability_sweep",
    "speed_window": "stability_sweep",
    "weakest_speed": "stability_sweep",
    "stationary_decay": "stability_sweep",
    "steady_margins": "stability_sweep",
    "tail_wheel_needed": "stability_sweep",
    "tail_wheel_always": "stability_sweep",
    "gear_position": "stability_sweep",
    "gear_position_envelope": "stability_sweep",
    "loaded_gear_position": "stability_sweep",
    "loaded_gear_envelope": "stability_sweep",
    "at_tail_load": "stability_sweep",
    "linear_equilibrium": "stability_sweep",
}
