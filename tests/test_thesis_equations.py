"""Chapters 3 and 4, equation by equation: what the thesis prints falls out of the derivation.

What is printed is typed as H. W. Brott (RIT, 1998) has it; what is derived comes from
`groundroll.derive`. The equations listed as errata are held to differ by exactly what the errata
say, and by nothing else.
"""

import pytest
import sympy as sp
from oracles import BROTT
from sympy import atan, cos, pi, sin, tan
from sympy.physics.vector import ReferenceFrame, Vector, cross, dynamicsymbols

from groundroll.derive.core.body import Body, Izz, a_y, beta, m, r_dot, sum_F, sum_M, v_dot
from groundroll.derive.core.equation import Chain, Equation, expand
from groundroll.derive.core.frames import BODY, i, j, k, psi, r, v
from groundroll.derive.core.linearise import linearise
from groundroll.derive.core.model import Derivation, Model
from groundroll.derive.core.part import Part
from groundroll.derive.core.quantity import Quantity
from groundroll.derive.core.unit import UnitError
from groundroll.derive.models.linear import LINEAR_TIRE, linear
from groundroll.derive.models.nonlinear import NONLINEAR as NONLINEAR_MODEL
from groundroll.derive.models.nonlinear import nonlinear
from groundroll.derive.parts import tires as tire
from groundroll.derive.parts.quantities import (
    B1,
    B3,
    B5,
    C1,
    C3,
    C5,
    D1,
    E1,
    Ap,
    C_alpha,
    CL_gamma,
    Ct,
    F_disturbance,
    Fz,
    a,
    b,
    rho,
    u,
)
from groundroll.derive.parts.thesis import (
    F_main,
    F_tail,
    F_tail_wheel,
    alpha,
    gamma,
    main_gear,
    slip_angle,
)
from groundroll.derive.parts.tires import C_c, F_bar, F_peak, F_y, alpha_bar, mu, psi_bar, theta_bar

LEVEL = Body(speed="held", stands="level")
GEAR, TAIL, TAIL_WHEEL, *_ = NONLINEAR_MODEL.parts


def some(name: str, *parts: Part) -> Derivation:
    """A model of some of the thesis's parts, on the thesis's body."""
    return Model(name, "", LEVEL, parts).derive()


NONLINEAR, LINEAR = nonlinear(), linear()
LINEAR_GEAR = Part("main_gear", a * i, main_gear(tire.linear_tire), suffix="")
MAIN_ONLY, WITH_TAIL = some("main", GEAR), some("main_tail", GEAR, TAIL)
LINEAR_MAIN_ONLY = linearise(some("main", LINEAR_GEAR))
LINEAR_WITH_TAIL = linearise(some("main_tail", LINEAR_GEAR, TAIL))
MEASURED, DATA = tire.measured_coefficients(alpha, F_peak), tire.normalised_data(alpha)
ACCELERATION, V0, OMEGA = LEVEL.acceleration(Vector(0)), LEVEL.V0, LEVEL.OMEGA
#: That of a point ahead, less that of the CG, is r_dot across and r^2 back, of its distance.
ANGULAR_ACCELERATION = (LEVEL.acceleration(i) - ACCELERATION).dot(j) * k

# what the thesis writes, in our names
C_f, C_f_tail = 2 * C_alpha, Ct
F_front, F_dist, F_wheel = F_main, F_disturbance, F_tail_wheel
ONE_DEGREE = pi / 180
half = sp.Rational(1, 2)
V_x, V_y = (Quantity(f"V_{axis}", "", "m/s", f"velocity along {axis}") for axis in "xy")
R_x, R_y = sp.symbols("R_x R_y")
V = sp.Symbol("V", positive=True)  # magnitude of V0


def definition(of: Quantity, chain: Chain) -> sp.Expr:
    found = (equation.rhs for equation in chain if equation.lhs == of)
    return next(found, sp.Symbol(f"{of}, which is not defined,"))


def through(expr: sp.Expr, model: Derivation, *quantities: Quantity) -> sp.Expr:
    """`expr` with only these quantities replaced by what the model defines them as."""
    return expand(expr, [e for e in model.chain if e.lhs in quantities])


def rates(model: Derivation) -> list[sp.Expr]:
    """v_dot and r_dot in terms of the forces."""
    return [through(rate, model, v_dot, r_dot, sum_F, sum_M) for rate in (v_dot, r_dot)]


def balance(model: Derivation) -> list[sp.Expr]:
    """m (v_dot + u r) and I_zz r_dot in terms of the forces."""
    along_y, about_z = rates(model)
    return [m * (along_y + u * r), Izz * about_z]


def explicit(model: Derivation, expressions: list[sp.Expr]) -> list[sp.Expr]:
    return [model.explicit(expr) for expr in expressions]


def momentum_rates() -> list[sp.Expr]:
    """dG/dt along y and dH/dt about z, with G and H resolved and differentiated in ground axes."""
    v_t, r_t, heading = dynamicsymbols("v r psi")
    time = dynamicsymbols._t
    ground = ReferenceFrame("ground")
    body = ground.orientnew("body", "Axis", [heading, ground.z])
    rate = {heading.diff(time): r, v_t.diff(time): v_dot, r_t.diff(time): r_dot}
    now = {v_t: v, r_t: r, heading: psi}
    G = (m * (u * body.x + v_t * body.y)).express(ground)
    H = (Izz * r_t * body.z).express(ground)
    return [
        G.dt(ground).express(body).dot(body.y).subs(rate).subs(now),
        H.dt(ground).express(body).dot(body.z).subs(rate).subs(now),
    ]


#: Number of the equation: what is derived, what is printed.
PRINTED: dict[str, tuple[list[sp.Expr | Vector], list[sp.Expr | Vector]]] = {
    "3.1": ([definition(F_y, LINEAR_TIRE.derive().chain)], [C_alpha * alpha]),
    # the secant at 1 deg; C_c is in 1/deg here
    "3.2": ([definition(C_c, MEASURED).subs(alpha, ONE_DEGREE) * ONE_DEGREE], [F_y / Fz]),
    "3.3": ([definition(C_c, NONLINEAR.chain)], [B3 + C3 * Fz]),
    "3.4": ([definition(mu, MEASURED)], [F_peak / Fz]),
    "3.5": ([definition(mu, NONLINEAR.chain)], [B5 + C5 * Fz]),
    # right with C_c in 1/rad; see the erratum
    "3.6": (
        [definition(alpha_bar, NONLINEAR.chain), definition(alpha_bar, DATA)],
        [C_c * tan(alpha) / mu] * 2,
    ),
    "3.7": ([definition(F_bar, DATA)], [F_y / (mu * Fz)]),
    "3.8": ([definition(F_bar, NONLINEAR.chain)], [D1 * sin(theta_bar)]),
    "3.9": ([definition(theta_bar, NONLINEAR.chain)], [C1 * atan(B1 * psi_bar)]),
    "3.10": (
        [definition(psi_bar, NONLINEAR.chain)],
        [(1 - E1) * alpha_bar + E1 * atan(B1 * alpha_bar) / B1],
    ),
    "3.11": ([definition(F_y, NONLINEAR.chain)], [F_bar * mu * Fz]),
    "4.1": ([m * ACCELERATION.dot(j), Izz * ANGULAR_ACCELERATION.dot(k)], momentum_rates()),
    "4.2": (
        [through(m * a_y, NONLINEAR, a_y, v_dot), through(Izz * r_dot, NONLINEAR, r_dot)],
        [sum_F, sum_M],
    ),
    "4.3": ([V0], [u * i + v * j]),
    "4.4": ([OMEGA], [r * k]),
    # with u_dot = 0
    "4.5": (
        [ACCELERATION, ACCELERATION],
        [v_dot * j + cross(OMEGA, V0), (0 - v * r) * i + (v_dot + u * r) * j],
    ),
    "4.6": ([ANGULAR_ACCELERATION] * 2, [r_dot * k + cross(OMEGA, OMEGA), r_dot * k]),
    "4.7": (
        [definition(a_y, NONLINEAR.chain), ANGULAR_ACCELERATION.dot(k)],
        [v_dot + u * r, r_dot],
    ),
    "4.8": (
        [definition(sum_F, NONLINEAR.chain), definition(sum_M, NONLINEAR.chain)],
        [
            -F_front + F_dist - F_tail - F_wheel,
            -a * F_front - b * F_dist + b * (F_tail + F_wheel),
        ],
    ),
    "4.9": (
        balance(NONLINEAR),
        [
            -F_front + F_dist - F_tail - F_wheel,
            -a * F_front - b * F_dist + b * (F_tail + F_wheel),
        ],
    ),
    "4.10": ([LEVEL.velocity(R_x * i + R_y * j)], [V0 + cross(OMEGA, R_x * i + R_y * j)]),
    "4.11": ([GEAR.at], [a * i]),
    "4.12": ([LEVEL.velocity(GEAR.at)], [u * i + (v + a * r) * j]),
    "4.13": ([slip_angle(alpha, V_x * i + V_y * j, "").rhs], [atan(V_y / V_x)]),
    "4.14": ([definition(alpha, NONLINEAR.chain)], [atan((v + a * r) / u)]),
    "4.15": (
        [LEVEL.velocity(TAIL.at)],
        [V0 + cross(OMEGA, TAIL.at)],
    ),
    "4.16": ([TAIL.at, TAIL_WHEEL.at], [-b * i, -b * i]),
    "4.17": ([LEVEL.velocity(TAIL.at)], [u * i + (v - b * r) * j]),
    "4.18": ([slip_angle(gamma, V_x * i + V_y * j, "").rhs], [atan(V_y / V_x)]),
    "4.19": ([definition(gamma, NONLINEAR.chain)], [atan((v - b * r) / u)]),
    "4.20": ([definition(beta, NONLINEAR.chain)], [atan(v / u)]),
    "4.21": ([definition(beta, LINEAR.chain)], [v / u]),
    # with u = V, which Eq. 4.22 concludes
    "4.23": ([definition(beta, LINEAR.chain).subs(u, V)], [v / V]),
    "4.24": ([definition(alpha, LINEAR.chain)], [(v + a * r) / u]),
    "4.25": ([definition(alpha, LINEAR.chain).subs(v, beta * u).subs(u, V)], [beta + a / V * r]),
    "4.26": ([definition(gamma, LINEAR.chain)], [(v - b * r) / u]),
    "4.27": ([definition(gamma, LINEAR.chain).subs(v, beta * u).subs(u, V)], [beta - b / V * r]),
    "4.28": ([through(F_main, LINEAR, F_main, F_y)], [C_f * alpha]),
    "4.29": (
        [definition(F_tail, LINEAR.chain), definition(F_tail, NONLINEAR.chain)],
        [(half * rho * u**2 * Ap * CL_gamma) * gamma] * 2,
    ),
    "4.30": (
        [definition(F_tail_wheel, LINEAR.chain), definition(F_tail_wheel, NONLINEAR.chain)],
        [C_f_tail * gamma] * 2,
    ),
    "4.31": (
        explicit(LINEAR, balance(LINEAR)),
        [
            -C_f * ((v + a * r) / u)
            + F_dist
            - (half * rho * u**2 * Ap * CL_gamma + C_f_tail) * ((v - b * r) / u),
            -a * C_f * ((v + a * r) / u)
            - b * F_dist
            + b * (half * rho * u**2 * Ap * CL_gamma + C_f_tail) * ((v - b * r) / u),
        ],
    ),
    "4.32": (
        explicit(LINEAR_MAIN_ONLY, balance(LINEAR_MAIN_ONLY)),
        [-C_f * ((v + a * r) / u), -a * C_f * ((v + a * r) / u)],
    ),
    "4.33": (rates(LINEAR_MAIN_ONLY), [-F_front / m - u * r, -a * F_front / Izz]),
    "4.34": (
        explicit(LINEAR_WITH_TAIL, balance(LINEAR_WITH_TAIL)),
        [
            -C_f * ((v + a * r) / u) - (half * rho * u**2 * Ap * CL_gamma) * ((v - b * r) / u),
            -a * C_f * ((v + a * r) / u)
            + b * (half * rho * u**2 * Ap * CL_gamma) * ((v - b * r) / u),
        ],
    ),
    "4.35": (
        rates(LINEAR_WITH_TAIL),
        [(-F_front - F_tail) / m - u * r, (-a * F_front + b * F_tail) / Izz],
    ),
    "4.37": (balance(MAIN_ONLY), [-F_front, -a * F_front]),
    # F_front is that of one tire here, and of both everywhere else
    "4.38": (
        [through(rate, MAIN_ONLY, F_main) for rate in rates(MAIN_ONLY)],
        [-2 * F_y / m - u * r, -2 * a * F_y / Izz],
    ),
    "4.39": (balance(WITH_TAIL), [-F_front - F_tail, -a * F_front + b * F_tail]),
}

#: Number of the equation: state derivatives as derived, and as printed with -u r over m.
U_R_OVER_M = {
    "4.36": (
        rates(LINEAR),
        [
            (-F_front + F_dist - F_tail - F_wheel - u * r) / m,
            (-a * F_front - b * F_dist + b * (F_tail + F_wheel)) / Izz,
        ],
    ),
    "4.40": (
        rates(WITH_TAIL),
        [(-F_front - F_tail - u * r) / m, (-a * F_front + b * F_tail) / Izz],
    ),
    "4.41": (
        rates(NONLINEAR),
        [
            (-F_front + F_dist - F_tail - F_wheel - u * r) / m,
            (-a * F_front - b * F_dist + b * (F_tail + F_wheel)) / Izz,
        ],
    ),
}


def is_zero(value: sp.Expr | Vector) -> bool:
    if isinstance(value, Vector):
        return all(is_zero(component) for component in value.to_matrix(BODY))
    return sp.simplify(value) == 0


@pytest.mark.parametrize("number", PRINTED)
def test_printed_equation_is_derived(number: str):
    derived, printed = PRINTED[number]
    for left, right in zip(derived, printed, strict=True):
        assert is_zero(left - right), f"derived {left}, printed {right}"


@pytest.mark.parametrize("number", U_R_OVER_M)
def test_erratum_of_the_centripetal_term(number: str):
    """-u r stands inside the fraction over m, where it has the wrong unit."""
    (v_rate, r_rate), (v_printed, r_printed) = U_R_OVER_M[number]
    assert is_zero(v_rate - v_printed + u * r * (1 - 1 / m))
    assert is_zero(r_rate - r_printed)
    with pytest.raises(UnitError, match=r"but -r\*u has unit m/s\*\*2"):
        Equation(v_dot, v_printed, f"Eq. {number}")


def test_erratum_3_2_the_secant_is_called_the_initial_slope():
    slope = sp.diff(NONLINEAR.explicit(F_y), v).subs({v: 0, r: 0}) * u  # by alpha, at zero
    ratio = slope / (Fz * NONLINEAR.explicit(C_c))
    assert is_zero(ratio - B1 * C1 * D1)
    assert BROTT["B1"] * BROTT["C1"] * BROTT["D1"] == pytest.approx(0.9245, abs=5e-5)


def test_erratum_3_6_lacks_a_factor_with_the_coefficient_in_1_per_degree():
    C_c_per_degree = sp.Symbol("C_c_per_degree")
    derived = definition(alpha_bar, NONLINEAR.chain).subs(C_c, C_c_per_degree / ONE_DEGREE)
    printed = C_c_per_degree * tan(alpha) / mu
    assert is_zero(derived / printed - 180 / pi)


def test_erratum_4_22_prints_the_tangent_for_the_cosine():
    magnitude = V0.magnitude()
    right, printed = cos(definition(beta, NONLINEAR.chain)), v / u
    assert is_zero(right - u / magnitude)
    assert is_zero(printed - tan(definition(beta, NONLINEAR.chain)))
    assert (right.limit(v, 0), printed.limit(v, 0)) == (1, 0)


def test_erratum_a_10_has_the_tail_angle_of_the_linear_model():
    """The text (Eq. 4.19) has the arctangent, and so have we; they differ in third order."""
    listed = (v - b * r) / u
    derived = definition(gamma, NONLINEAR.chain)
    sideways = sp.Symbol("sideways")
    gap = (derived - listed).subs(v, sideways * u + b * r)
    assert is_zero(gap.series(sideways, 0, 5).removeO() + sideways**3 / 3)


def test_no_equation_is_left_out():
    everything = {f"3.{n}" for n in range(1, 12)} | {f"4.{n}" for n in range(1, 42)}
    assert {*PRINTED, *U_R_OVER_M, "4.22"} == everything


def test_every_equation_that_the_derivation_cites_is_proved_here():
    chains = [model.chain for model in (NONLINEAR, LINEAR, MAIN_ONLY)] + [MEASURED, DATA]
    cited = {e.source.removeprefix("Eq. ") for c in chains for e in c if "Eq." in e.source}
    assert cited <= {*PRINTED, *U_R_OVER_M}
    assert len(cited) > 20
