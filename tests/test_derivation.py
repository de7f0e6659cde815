"""The derivation follows from vectors, for components that it has never seen."""

import pickle

import pytest
import sympy as sp
from sympy.physics.vector import Vector, dynamicsymbols

from groundroll.derive.catalogue import Module
from groundroll.derive.components import Component, Force, disturbance, main_gear, slip_angle
from groundroll.derive.equation import Equation, expand, merge, needed
from groundroll.derive.equation_sheet import equation_sheet
from groundroll.derive.kinematics import (
    BODY,
    GROUND,
    V0,
    accelerations,
    i,
    j,
    k,
    path_rates,
    velocity,
)
from groundroll.derive.linear import linear, linearise, state_space
from groundroll.derive.model import Model, assemble, linear_tire_model
from groundroll.derive.newton import equations_of_motion, r_dot, sum_F, sum_M, v_dot
from groundroll.derive.quantities import (
    PARAMETERS,
    C_alpha,
    Izz,
    Quantity,
    X,
    Y,
    a,
    m,
    psi,
    r,
    theta,
    u,
    v,
    y,
)
from groundroll.derive.tire import linear_tire, nonlinear_tire

delta = Quantity("delta", "steering_angle", "rad", "nose wheel turned to the right")
l_n = Quantity("l_n", "nose_wheel_arm", "m", "nose wheel ahead of the CG")
C_n = Quantity("C_n", "nose_wheel_stiffness", "N/rad", "cornering stiffness of the nose wheel")
alpha_n = Quantity("alpha_n", "nose_wheel_slip_angle", "rad", "slip angle of the nose wheel")
F_nose = Quantity("F_nose", "nose_wheel_force", "N", "force of the nose wheel, to its left")


def nose_wheel() -> Component:
    """A fifth component: a steered wheel ahead of the CG."""

    def law(velocity: Vector) -> Force:
        chain = (
            Equation(alpha_n, sp.atan(velocity.dot(j) / velocity.dot(i)) - delta, "SAE"),
            Equation(F_nose, C_n * alpha_n, "linear tire"),
        )
        return Force(-F_nose * (sp.cos(delta) * j - sp.sin(delta) * i), chain)

    return Component("nose wheel", l_n * i, law)


def single_track_car() -> Model:
    return assemble(
        "car",
        "Main gear and steered nose wheel.",
        [main_gear(linear_tire), nose_wheel()],
        inputs=[delta],
        parameters=[*PARAMETERS, l_n, C_n],
    )


def is_zero(value: sp.Expr | sp.Matrix) -> bool:
    difference = sp.simplify(value)
    return bool(
        difference == sp.zeros(*difference.shape) if difference.is_Matrix else difference == 0
    )


def test_a_nose_wheel_makes_the_single_track_car():
    """Rajamani, *Vehicle Dynamics and Control*, Section 2.3, in the states (v, r)."""
    A, B, _, _ = state_space(linearise(single_track_car()))

    C_front, C_rear, l_f, l_r = C_n, 2 * C_alpha, l_n, -a  # axle stiffnesses and distances
    textbook_A = sp.Matrix(
        [
            [
                -(C_front + C_rear) / (m * u),
                -u - (C_front * l_f - C_rear * l_r) / (m * u),
            ],
            [
                -(C_front * l_f - C_rear * l_r) / (Izz * u),
                -(C_front * l_f**2 + C_rear * l_r**2) / (Izz * u),
            ],
        ]
    )
    textbook_B = sp.Matrix([C_front / m, C_front * l_f / Izz])
    assert is_zero(A - textbook_A)
    assert is_zero(B - textbook_B)


def test_a_car_steered_right_turns_right_at_the_textbook_yaw_rate():
    """Steady yaw rate u delta / (L + K_us u^2), Milliken's understeer form."""
    A, B, _, _ = state_space(linearise(single_track_car()))
    wheelbase = l_n - a
    understeer = m / wheelbase * (-a / C_n - l_n / (2 * C_alpha))
    steady = -(A.inv() * B)[1]
    assert is_zero(steady - u / (wheelbase + understeer * u**2))


def test_the_nose_wheel_needs_no_word_from_the_rest():
    car = single_track_car()
    assert car.inputs == (delta,)
    assert {l_n, C_n} < set(car.parameters)
    assert {str(q) for q in car.outputs} == {"alpha", "beta", "F_main", "a_y", "sum_F", "sum_M"}


def test_a_model_without_a_tail_has_its_section_in_the_equation_sheet():
    car = single_track_car()
    sheet = equation_sheet([Module("car", car.summary, (), car)])
    assert "## The car model" in sheet
    assert "slip angle of the nose wheel" in sheet
    assert "`C_n` | nose_wheel_stiffness" in sheet
    assert "Steady turns of the nonlinear model" in sheet


def test_velocity_of_a_point_off_the_centreline():
    x, c = sp.symbols("x c")
    expected = (u - c * r) * i + (v + x * r) * j
    assert velocity(x * i + c * j) - expected == 0


def test_accelerations_are_those_seen_from_the_ground():
    """Resolve the velocity along ground axes, differentiate there, resolve along body axes."""
    vt, rt, heading = dynamicsymbols("v r psi")
    time = dynamicsymbols._t
    rates = {heading.diff(time): rt, vt.diff(time): v_dot, rt.diff(time): r_dot}
    seen = (u * i + vt * j).express(GROUND).dt(GROUND).subs(rates).express(BODY)

    acceleration, angular = accelerations(v_dot, r_dot)
    now = {vt: v, rt: r}
    assert is_zero(seen.to_matrix(BODY).subs(now) - acceleration.to_matrix(BODY))
    assert angular - r_dot * k == 0


def test_path_is_the_velocity_turned_by_the_heading():
    rates = path_rates()
    over_ground = sp.expand((u + sp.I * v) * sp.exp(sp.I * psi), complex=True)
    assert is_zero(rates[X] - sp.re(over_ground))
    assert is_zero(rates[Y] - sp.im(over_ground))
    assert (rates[y], rates[theta], rates[psi]) == (v, r, r)


def wheel(name: str, position: Vector) -> Component:
    """One main tire by itself, with names of its own."""
    angle = Quantity(f"alpha_{name}", "slip_angle", "rad", "slip angle")
    force = Quantity(f"F_{name}", "force", "N", "force to the left")

    def law(velocity: Vector) -> Force:
        chain = (slip_angle(angle, velocity, "SAE"), Equation(force, C_alpha * angle, "Eq. 3.1"))
        return Force(-force * j, chain)

    return Component(name, position, law)


def test_two_wheels_apart_are_the_main_gear_to_first_order():
    track = Quantity("c", "half_track", "m", "half of the track")
    pair = [wheel("left", a * i - track * j), wheel("right", a * i + track * j)]
    apart = assemble("apart", "", pair, parameters=[*PARAMETERS, track])
    together = assemble("together", "", [main_gear(linear_tire)])

    turning = {v: 1, r: sp.Rational(1, 2), a: 1, u: 10, track: 2, C_alpha: 1, m: 1, Izz: 1}
    exact = [model.explicit(v_dot).subs(turning).evalf() for model in (apart, together)]
    assert abs(exact[0] - exact[1]) > 1e-4
    assert is_zero(state_space(linearise(apart))[0] - state_space(linearise(together))[0])


def test_a_brake_on_the_right_turns_the_nose_right():
    track = Quantity("c", "half_track", "m", "half of the track")
    F_brake = Quantity("F_brake", "brake", "N", "braking force, backwards")
    brake = Component("brake", track * j, lambda velocity: Force(-F_brake * i))
    chain = equations_of_motion([brake])
    assert expand(sum_M, chain) == track * F_brake
    assert expand(sum_F, chain) == 0


def test_the_order_of_components_does_not_matter():
    parts = [main_gear(linear_tire), disturbance(), nose_wheel()]
    there, back = (equations_of_motion(order) for order in (parts, parts[::-1]))
    assert is_zero(expand(v_dot, there) - expand(v_dot, back))
    assert is_zero(expand(r_dot, there) - expand(r_dot, back))


def test_two_laws_for_one_force_are_refused():
    with pytest.raises(ValueError, match="F_y is defined twice"):
        equations_of_motion([main_gear(linear_tire), main_gear(nonlinear_tire)])


def test_one_angle_at_two_stations_is_refused():
    here = slip_angle(alpha_n, velocity(l_n * i), "here")
    there = slip_angle(alpha_n, velocity(a * i), "there")
    with pytest.raises(ValueError, match="alpha_n is defined twice"):
        merge([here, there])


def test_equal_definitions_are_merged():
    once = Equation(alpha_n, (v + l_n * r) / u, "once")
    again = Equation(alpha_n, v / u + l_n * r / u, "again")
    assert merge([once, again]) == (once,)


def test_an_undeclared_symbol_is_named():
    with pytest.raises(ValueError, match=r"car: C_n, l_n are neither state, input nor parameter"):
        assemble("car", "", [nose_wheel()], inputs=[delta])


def test_only_what_a_result_depends_on_is_kept():
    chain = single_track_car().chain
    assert [str(e.lhs) for e in needed(chain, [F_nose])] == ["alpha_n", "F_nose"]


def test_the_linear_model_is_the_jacobian_at_straight_running():
    """By differentiating the whole of the exact model, not link by link."""
    exact = linear_tire_model()
    rates = sp.Matrix([exact.explicit(v_dot), exact.explicit(r_dot)])
    at_rest = dict.fromkeys((*exact.dynamic, *exact.inputs), 0)
    A, B, _, _ = state_space(linear())
    assert is_zero(rates.jacobian(exact.dynamic).subs(at_rest) - A)
    assert is_zero(rates.jacobian(exact.inputs).subs(at_rest) - B)


def test_the_linear_model_is_linear_but_for_the_path():
    model = linear()
    moving = sp.Matrix([*model.dynamic, *model.inputs])
    explicit = sp.Matrix([model.explicit(q) for q in (v_dot, r_dot, *model.outputs)])
    assert is_zero(explicit - explicit.jacobian(moving) * moving)
    assert model.rates[model.states.index(X)] == path_rates()[X]


def test_an_aircraft_that_is_pushed_at_rest_has_no_linear_model():
    push = Quantity("push", "push", "N", "a constant side force")
    pushed = Component("push", 0 * i, lambda velocity: Force(push * j))
    model = assemble("pushed", "", [pushed], parameters=[*PARAMETERS, push])
    with pytest.raises(ValueError, match="straight running is not an equilibrium"):
        linearise(model)


def test_a_quantity_survives_pickling():
    copy = pickle.loads(pickle.dumps(Izz))
    assert (copy, copy.unit, copy.full_name, copy.latex) == (Izz, "kg m^2", "yaw_inertia", "I_{zz}")


def test_the_ground_velocity_is_that_of_the_cg():
    assert velocity(0 * i) == V0
