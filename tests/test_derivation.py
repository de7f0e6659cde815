"""The derivation follows from vectors, for parts that it has never seen."""

import pickle
from collections.abc import Sequence

import pytest
import sympy as sp
from sympy.physics.vector import ReferenceFrame, Vector, dynamicsymbols

from groundroll.derive.core.body import ACCELERATIONS, SPEEDS, Body, Izz, m, sum_F, sum_M
from groundroll.derive.core.equation import Equation, merge, needed
from groundroll.derive.core.frames import BODY, X, Y, i, j, k, psi, r, theta, v
from groundroll.derive.core.frames import u as forward
from groundroll.derive.core.linearise import linearise, state_space
from groundroll.derive.core.model import Derivation, Model, ModelError
from groundroll.derive.core.part import Felt, Force, Part
from groundroll.derive.core.quantity import Input, Parameter, Quantity
from groundroll.derive.emit.catalogue import Pack
from groundroll.derive.emit.equation_sheet import equation_sheet
from groundroll.derive.models.linear import LINEAR_TIRE, linear
from groundroll.derive.models.nonlinear import nonlinear
from groundroll.derive.parts.quantities import C_alpha, F_disturbance, a, b, u
from groundroll.derive.parts.quantities import theta as rotation
from groundroll.derive.parts.quantities import y as displacement
from groundroll.derive.parts.thesis import disturbance, main_gear, slip_angle
from groundroll.derive.parts.tires import linear_tire, nonlinear_tire

delta = Input("delta", "steering_angle", "rad", "nose wheel turned to the right")
l_n = Parameter("l_n", "nose_wheel_arm", "m", "nose wheel ahead of the CG")
C_n = Parameter("C_n", "nose_wheel_stiffness", "N/rad", "cornering stiffness of the nose wheel")
alpha_n = Quantity("alpha_n", "nose_wheel_slip_angle", "rad", "slip angle of the nose wheel")
F_nose = Quantity("F_nose", "nose_wheel_force", "N", "force of the nose wheel, to its left")

LEVEL = Body(speed="held", stands="level")
MAIN_GEAR = Part("main_gear", a * i, main_gear(linear_tire), suffix="")


def steered(felt: Felt) -> Force:
    chain = (
        Equation(alpha_n, sp.atan(felt.velocity.dot(j) / felt.velocity.dot(i)) - delta, "SAE"),
        Equation(F_nose, C_n * alpha_n, "linear tire"),
    )
    return Force(-F_nose * (sp.cos(delta) * j - sp.sin(delta) * i), chain=chain)


#: A steered wheel ahead of the CG.
NOSE_WHEEL = Part("nose_wheel", l_n * i, steered, asks=(delta,), suffix="")


def derived(name: str, *parts: Part) -> Derivation:
    return Model(name, "", LEVEL, parts).derive()


def single_track_car() -> Derivation:
    return Model(
        "car", "Main gear and steered nose wheel.", LEVEL, [MAIN_GEAR, NOSE_WHEEL]
    ).derive()


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
    assert {str(q) for q in car.outputs} == {
        *("alpha_n", "F_nose", "sum_F", "sum_M", "a_y", "F_held", "N_held")
    }


def test_a_model_without_a_tail_has_its_equation_sheet():
    car = single_track_car()
    sheet = equation_sheet(Pack("car", car.summary, model=car))
    assert "## The car model" in sheet
    assert "slip angle of the nose wheel" in sheet
    assert "`C_n` | nose_wheel_stiffness" in sheet


def test_velocity_of_a_point_off_the_centreline():
    x, c = sp.symbols("x c")
    expected = (u - c * r) * i + (v + x * r) * j
    assert LEVEL.velocity(x * i + c * j) - expected == 0


@pytest.mark.parametrize("body", [LEVEL, Body(), Body(speed="free", stands="level")], ids=repr)
def test_accelerations_are_those_seen_from_the_ground(body: Body):
    """SymPy differentiates the velocity of a point of the body in a frame that does not turn."""
    ground, turning = ReferenceFrame("G"), ReferenceFrame("B")
    speeds, place = dynamicsymbols("u v w p q r"), sp.symbols("x y z")

    def vector(frame: ReferenceFrame, components: Sequence[sp.Expr]) -> Vector:
        x, y, z = components
        return x * frame.x + y * frame.y + z * frame.z

    turning.set_ang_vel(ground, vector(turning, speeds[3:]))
    position = vector(turning, place)
    velocity = vector(turning, speeds[:3]) + turning.ang_vel_in(ground).cross(position)
    now = {s.diff(): rate for s, rate in zip(speeds, ACCELERATIONS, strict=True)}
    here = dict(zip(speeds, SPEEDS, strict=True))
    held = {q: 0 for s, q in zip(SPEEDS, ACCELERATIONS, strict=True) if s not in body.speeds}
    held |= {s: u if s == forward else 0 for s in SPEEDS if s not in body.speeds}

    def of(seen: Vector) -> sp.Matrix:
        return seen.to_matrix(turning).subs(now).subs(here).subs(held)

    at = vector(BODY, place)
    assert is_zero(of(velocity) - body.velocity(at).to_matrix(BODY))
    assert is_zero(of(velocity.dt(ground)) - body.acceleration(at).to_matrix(BODY))


def test_path_is_the_velocity_turned_by_the_heading():
    rates = LEVEL.path_rates()
    over_ground = sp.expand((u + sp.I * v) * sp.exp(sp.I * psi), complex=True)
    assert is_zero(rates[X] - sp.re(over_ground))
    assert is_zero(rates[Y] - sp.im(over_ground))
    assert rates[psi] == r


def test_the_attitude_turns_with_the_body():
    """The rates of the angles are those whose rotation matrix turns as Poisson's equation says."""
    rates, attitude = (
        Body().path_rates(),
        sp.Matrix(
            3, 3, [Body().ground[row].dot(column) for row in range(3) for column in (i, j, k)]
        ),
    )
    named = {e.lhs: e.rhs for e in Body().surroundings()}
    matrix = attitude.subs(named)
    phi, p, q = (next(s for s in rates if s.name == "phi"), *SPEEDS[3:5])
    turned = sum((matrix.diff(s) * rates[s] for s in (phi, theta, psi)), sp.zeros(3, 3))
    spin = sp.Matrix([[0, -r, q], [r, 0, -p], [-q, p, 0]])
    assert is_zero(turned - matrix * spin)
    assert is_zero(matrix * matrix.T - sp.eye(3))


def test_the_thesis_integrates_in_aircraft_coordinates_too():
    model = nonlinear()
    rates = dict(zip(model.states, model.rates, strict=True))
    assert (rates[displacement], rates[rotation]) == (v, r)


alpha = Quantity("alpha", "slip_angle", "rad", "slip angle")
force = Quantity("F", "force", "N", "force to the left")


def wheel(felt: Felt) -> Force:
    """One main tire by itself."""
    chain = (slip_angle(alpha, felt.velocity, "SAE"), Equation(force, C_alpha * alpha, "Eq. 3.1"))
    return Force(-force * j, chain=chain)


def test_two_wheels_apart_are_the_main_gear_to_first_order():
    track = Parameter("c", "half_track", "m", "half of the track")
    pair = (
        Part("left", a * i - track * j, wheel),
        Part("right", a * i + track * j, wheel),
    )
    apart, together = derived("apart", *pair), derived("together", MAIN_GEAR)

    turning = {v: 1, r: sp.Rational(1, 2), a: 1, u: 10, track: 2, C_alpha: 1, m: 1, Izz: 1}
    exact = [model.explicit(model.rates[0]).subs(turning).evalf() for model in (apart, together)]
    assert abs(exact[0] - exact[1]) > 1e-4
    assert is_zero(state_space(linearise(apart))[0] - state_space(linearise(together))[0])


def test_a_brake_on_the_right_turns_the_nose_right_and_asks_for_thrust():
    track = Parameter("c", "half_track", "m", "half of the track")
    F_brake = Input("F_brake", "brake", "N", "braking force, backwards")
    brake = Part("brake", track * j, lambda felt: Force(-F_brake * i), asks=(F_brake,))
    model = derived("braked", brake)
    (F_held,) = (q for q in model.outputs if q.name == "F_held")
    assert model.explicit(sum_M) == track * F_brake
    assert model.explicit(sum_F) == sum_F  # there is none
    assert is_zero(model.explicit(F_held) - (F_brake - m * v * r))


def test_the_order_of_parts_does_not_matter():
    push = Part("disturbance", -b * i, disturbance, asks=(F_disturbance,), suffix="")
    parts = (MAIN_GEAR, push, NOSE_WHEEL)
    there, back = derived("there", *parts), derived("back", *parts[::-1])
    for one, other in zip(there.rates, back.rates, strict=True):
        assert is_zero(there.explicit(one) - back.explicit(other))


def test_two_laws_for_one_force_are_refused():
    other = Part("other", a * i, main_gear(nonlinear_tire), suffix="")
    with pytest.raises(ModelError, match=r"two: F_y is defined twice.*; give the parts names"):
        derived("two", MAIN_GEAR, other)


def test_one_angle_at_two_stations_is_refused():
    here = slip_angle(alpha_n, LEVEL.velocity(l_n * i), "here")
    there = slip_angle(alpha_n, LEVEL.velocity(a * i), "there")
    with pytest.raises(ValueError, match="alpha_n is defined twice"):
        merge([here, there])


def test_equal_definitions_are_merged():
    once = Equation(alpha_n, (v + l_n * r) / u, "once")
    again = Equation(alpha_n, v / u + l_n * r / u, "again")
    assert merge([once, again]) == (once,)


def test_an_undeclared_symbol_is_named():
    unknown = Quantity("C_x", "stiffness", "N/rad", "of no kind")
    law = lambda felt: Force(-unknown * v / u * j)  # noqa: E731
    with pytest.raises(ModelError, match="car: C_x is neither state, input nor parameter"):
        derived("car", Part("wheel", l_n * i, law))


def test_only_what_a_result_depends_on_is_kept():
    chain = single_track_car().chain
    assert [str(e.lhs) for e in needed(chain, [F_nose])] == ["alpha_n", "F_nose"]


def test_the_linear_model_is_the_jacobian_at_straight_running():
    """By differentiating the whole of the exact model, not link by link."""
    exact = LINEAR_TIRE.derive()
    rates = sp.Matrix([exact.explicit(rate) for rate in exact.rates[:2]])
    at_rest = dict.fromkeys((*exact.dynamic, *exact.inputs), 0)
    A, B, _, _ = state_space(linear())
    assert exact.dynamic == exact.states[:2] == (v, r)
    assert is_zero(rates.jacobian(exact.dynamic).subs(at_rest) - A)
    assert is_zero(rates.jacobian(exact.inputs).subs(at_rest) - B)


def test_the_linear_model_is_linear_but_for_the_path():
    model = linear()
    moving = sp.Matrix([*model.dynamic, *model.inputs])
    affected = [q for q in model.outputs if q.name != "N_held"]  # which is the weight
    explicit = sp.Matrix([model.explicit(q) for q in (*model.rates[:2], *affected)])
    assert is_zero(explicit - explicit.jacobian(moving) * moving)
    assert model.rates[model.states.index(X)] == LEVEL.path_rates()[X]


def test_an_aircraft_that_is_pushed_at_rest_has_no_linear_model():
    push = Parameter("push", "push", "N", "a constant side force")
    model = derived("pushed", Part("pushed", 0 * i, lambda felt: Force(push * j)))
    with pytest.raises(ValueError, match="straight running is not an equilibrium"):
        linearise(model)


def test_a_quantity_survives_pickling():
    copy = pickle.loads(pickle.dumps(Izz))
    assert (copy, copy.unit, copy.full_name, copy.latex) == (Izz, "kg m^2", "yaw_inertia", "I_{zz}")


def test_the_ground_velocity_is_that_of_the_cg():
    assert LEVEL.velocity(0 * i) == LEVEL.V0
