"""What any right model of an aircraft on the ground does, whatever its numbers."""

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from oracles import BROTT, MODELS, TRIALS, Array, call, parameters, points, state, values, vector

from groundroll.generated import integrators, load
from groundroll.model.names import MODELS as SIGNATURES

NO_INPUT = np.zeros(1)
MIRROR = np.array([-1, -1, -1, -1, 1, -1, -1])  # v, r, y, theta, X, Y, psi
#: Outputs that are the same in the mirror; the others change sides.
SAME = {"F_held", "N_held"}

cases = pytest.mark.parametrize("model", MODELS)


def outputs(model: str, x: Array, u: Array, p: Array) -> dict[str, float]:
    y = call(load(f"{model}_outputs"), x, u, p)
    return dict(zip(SIGNATURES[model].outputs, y, strict=True))


def aircraft(model: str, p: Array) -> dict[str, float]:
    return dict(zip(SIGNATURES[model].parameters, p, strict=True))


def jacobian(model: str, p: Array, name: str = "fx") -> Array:
    """A Jacobian in straight running."""
    return np.array(load(f"{model}_jacobians")(x=state(), u=NO_INPUT, p=p)[name])


def state_matrix(p: Array) -> Array:
    """A of the linear model, for (v, r)."""
    return jacobian("linear", p)[:2, :2]


def closed_form(name: str, plane: dict[str, float]) -> dict[str, float]:
    function = load(name)
    results = function.call([plane[symbol] for symbol in function.name_in()])
    return dict(zip(function.name_out(), map(float, results), strict=True))


# --- Symmetry -------------------------------------------------------------------------------


@cases
@given(data=st.data())
def test_a_mirrored_aircraft_moves_in_the_mirror(model: str, data: st.DataObject):
    x, u, p = data.draw(points(model))
    f = load(f"{model}_rhs")
    np.testing.assert_array_equal(call(f, MIRROR * x, -u, p), MIRROR * call(f, x, u, p))


@cases
@given(data=st.data())
def test_angles_and_forces_change_sides_in_the_mirror(model: str, data: st.DataObject):
    x, u, p = data.draw(points(model))
    g = load(f"{model}_outputs")
    sides = np.array([1 if name in SAME else -1 for name in SIGNATURES[model].outputs])
    np.testing.assert_array_equal(call(g, MIRROR * x, -u, p), sides * call(g, x, u, p))


@pytest.mark.parametrize("method", integrators.METHODS)
@cases
def test_trajectories_are_mirrored(model: str, method: str):
    F, p = load(f"{model}_{method}"), parameters(model)
    start, push = state(v=1.0, r=0.2, X=3.0, Y=0.5, psi=0.1), np.array([800.0])
    end = call(F, start, push, p, 0.3)
    np.testing.assert_array_equal(call(F, MIRROR * start, -push, p, 0.3), MIRROR * end)


@cases
@given(data=st.data())
def test_the_runway_is_the_same_everywhere_and_in_every_direction(model: str, data: st.DataObject):
    x, u, p = data.draw(points(model))
    turn = np.radians(40)
    elsewhere = x + state(y=1.0, theta=2.0, X=30.0, Y=-4.0, psi=turn)
    here, there = (call(load(f"{model}_rhs"), s, u, p) for s in (x, elsewhere))
    along, across = here[4:6]
    turned = [
        along * np.cos(turn) - across * np.sin(turn),
        along * np.sin(turn) + across * np.cos(turn),
    ]
    np.testing.assert_array_equal(np.delete(there, [4, 5]), np.delete(here, [4, 5]))
    np.testing.assert_allclose(there[4:6], turned, atol=1e-12)


@cases
@given(data=st.data())
def test_the_speed_over_the_ground_is_that_of_the_aircraft(model: str, data: st.DataObject):
    x, u, p = data.draw(points(model))
    rates = call(load(f"{model}_rhs"), x, u, p)
    assert np.hypot(*rates[4:6]) == pytest.approx(np.hypot(aircraft(model, p)["u"], x[0]))


# --- Energy ---------------------------------------------------------------------------------


@cases
@given(data=st.data())
def test_power_goes_into_motion(model: str, data: st.DataObject):
    """Powers of the components and of what holds u constant are the rate of kinetic energy."""
    x, u, p = data.draw(points(model))
    plane, out = aircraft(model, p), outputs(model, x, u, p)
    v, r = x[:2]
    v_dot, r_dot = call(load(f"{model}_rhs"), x, u, p)[:2]
    at_gear, at_tail = v + plane["a"] * r, v - plane["b"] * r
    holding = -plane["m"] * v * r  # forward force under which u stays constant
    powers = [
        -out["F_main"] * at_gear,
        -out["F_tail"] * at_tail,
        -out["F_tail_wheel"] * at_tail,
        u[0] * at_tail,
        holding * plane["u"],
    ]
    kinetic = plane["m"] * v * v_dot + plane["Izz"] * r * r_dot
    assert sum(powers) == pytest.approx(kinetic, abs=1e-12 * np.abs(powers).sum() + 1e-300)


@cases
@given(data=st.data())
def test_tires_and_tail_only_take_energy(model: str, data: st.DataObject):
    """With E1 <= 1; beyond, the fitted force reverses at large slip (see the errata)."""
    fixed = {"E1": 0.4} if model == "nonlinear" else {}
    x, u, p = data.draw(points(model, **fixed))
    plane, out = aircraft(model, p), outputs(model, x, u, p)
    assert out["F_main"] * (x[0] + plane["a"] * x[1]) >= 0
    assert out["F_tail"] * (x[0] - plane["b"] * x[1]) >= 0
    assert out["F_tail_wheel"] * (x[0] - plane["b"] * x[1]) >= 0


# --- Forces ---------------------------------------------------------------------------------


@cases
@given(data=st.data())
def test_forces_add_up(model: str, data: st.DataObject):
    x, u, p = data.draw(points(model))
    plane, out = aircraft(model, p), outputs(model, x, u, p)
    behind = out["F_tail"] + out["F_tail_wheel"] - u[0]
    size = 1e-13 * sum(abs(out[f]) for f in ("F_main", "F_tail", "F_tail_wheel")) + 1e-9
    assert out["sum_F"] == pytest.approx(-out["F_main"] - behind, abs=size)
    expected = -plane["a"] * out["F_main"] + plane["b"] * behind
    assert out["sum_M"] == pytest.approx(expected, abs=10 * size)
    assert out["a_y"] == pytest.approx(out["sum_F"] / plane["m"], abs=1e-11)


@cases
def test_a_push_to_the_right_on_the_tail_turns_the_nose_left(model: str):
    rates = call(load(f"{model}_rhs"), state(), [500.0], parameters(model))
    v_dot, r_dot = rates[:2]
    assert v_dot == pytest.approx(500.0 / BROTT["m"])
    assert r_dot == pytest.approx(-BROTT["b"] * 500.0 / BROTT["Izz"])


@cases
@given(data=st.data())
def test_main_gear_at_the_cg_makes_no_yaw(model: str, data: st.DataObject):
    x, _, p = data.draw(points(model, a=0.0, Ap=0.0, Ct=0.0))
    rates = call(load(f"{model}_rhs"), x, NO_INPUT, p)
    assert rates[1] == 0
    assert outputs(model, x, NO_INPUT, p)["sum_M"] == 0


@given(data=st.data())
def test_the_tire_never_pulls_more_than_its_peak(data: st.DataObject):
    function = load("tire_force")
    plane = dict(zip(function.name_in(), data.draw(values(function.name_in())), strict=True))
    slip = np.linspace(-1.5, 1.5, 301)[None]
    results = function(**{**plane, "alpha": slip})
    forces, mu = np.array(results["F_y"]), plane["B5"] + plane["C5"] * plane["Fz"]
    assert abs(forces).max() <= plane["D1"] * mu * plane["Fz"] * (1 + 1e-14)


@given(data=st.data())
def test_small_angles_are_linear(data: st.DataObject):
    """With C_alpha the slope of the non-linear tire at zero, one model is the other's tangent."""
    _, _, p = data.draw(points("nonlinear"))
    plane = aircraft("nonlinear", p)
    coefficient = plane["B3"] + plane["C3"] * plane["Fz"]
    plane["C_alpha"] = plane["B1"] * plane["C1"] * plane["D1"] * coefficient * plane["Fz"]
    tangent = vector(SIGNATURES["linear"].parameters, plane)
    rows = {
        "f": [SIGNATURES["nonlinear"].states.index(s) for s in SIGNATURES["linear"].states],
        "g": [SIGNATURES["nonlinear"].outputs.index(s) for s in SIGNATURES["linear"].outputs],
    }
    for name in ("fx", "fu", "gx", "gu"):
        exact = jacobian("nonlinear", p, name)
        of_second_order = np.delete(exact, rows[name[0]], axis=0)
        np.testing.assert_array_equal(of_second_order, 0.0)
        np.testing.assert_allclose(
            exact[rows[name[0]]],
            jacobian("linear", tangent, name),
            rtol=0,
            atol=1e-12 * np.abs(exact).max(),
        )


@pytest.mark.parametrize("symbol", ["alpha", "gamma", "beta"])
def test_angles_of_the_two_models_part_in_third_order(symbol: str):
    gaps = []
    for v in (0.5, 1.0):
        point = state(v=v, r=0.02 * v), NO_INPUT
        exact, small = (outputs(model, *point, parameters(model)) for model in MODELS)
        gaps.append(abs(exact[symbol] - small[symbol]))
    assert gaps[1] / gaps[0] == pytest.approx(8, rel=0.02)


@given(data=st.data())
def test_the_wheels_carry_the_weight_and_do_not_tip(data: st.DataObject):
    m, a, b, g = data.draw(values(["m", "arm", "b", "g"]))
    plane = {"m": m, "a": a, "b": b, "g": g}
    for symbol in ("L", "f", "Fz", "F_tail_load"):
        plane |= closed_form(f"{symbol}_follows", plane)
    assert 2 * plane["Fz"] + plane["F_tail_load"] == pytest.approx(m * g)
    assert 2 * plane["Fz"] * a == pytest.approx(plane["F_tail_load"] * b)


# --- Stability of the linear model ----------------------------------------------------------


@pytest.mark.parametrize("trial", TRIALS)
def test_eigenvalues_are_those_printed(trial: int):
    changes, printed, last_digits = TRIALS[trial]
    found = np.linalg.eigvals(state_matrix(parameters("linear", **changes)))
    assert (abs(np.sort_complex(found) - printed) <= last_digits).all()


@given(data=st.data())
def test_closed_forms_of_stability_are_those_of_the_state_matrix(data: st.DataObject):
    _, _, p = data.draw(points("linear"))
    plane, A = aircraft("linear", p), state_matrix(p)
    entries = closed_form("state_matrix", plane)
    np.testing.assert_allclose(list(entries.values()), A.ravel(), rtol=1e-12, atol=1e-12)

    routh = closed_form("routh_hurwitz", plane)
    size = np.abs(A).max() ** 2
    assert routh["trace"] == pytest.approx(np.trace(A))
    assert routh["det"] == pytest.approx(np.linalg.det(A), abs=1e-12 * size)
    assert routh["discriminant"] == pytest.approx(
        routh["trace"] ** 2 - 4 * routh["det"], abs=1e-12 * size
    )


@given(data=st.data())
def test_modes_are_the_eigenvalues(data: st.DataObject):
    names = ("A_vv", "A_vr", "A_rv", "A_rr")
    A = data.draw(values(names)).reshape(2, 2)
    modes = closed_form("modes", dict(zip(names, A.ravel(), strict=True)))
    first, second = (complex(modes[f"re_{n}"], modes[f"im_{n}"]) for n in (1, 2))

    size = np.abs(A).max()
    polynomial = np.array([1.0, -np.trace(A) / size, np.linalg.det(A) / size**2])
    np.testing.assert_allclose(np.poly([first / size, second / size]), polynomial, atol=1e-12)
    assert first.real >= second.real
    assert first.imag >= 0
    assert modes["decay_rate"] == -first.real
    assert modes["damped_frequency"] == abs(first.imag)
    if np.linalg.det(A) > 1e-9 * size**2:
        assert modes["natural_frequency"] ** 2 == pytest.approx((first * second).real)
        assert modes["damping_ratio"] == pytest.approx(
            -(first + second).real / (2 * modes["natural_frequency"])
        )


def test_equal_eigenvalues_lose_no_digits():
    modes = closed_form("modes", {"A_vv": -3.0, "A_vr": 0.0, "A_rv": 1.0, "A_rr": -3.0})
    assert (modes["re_1"], modes["re_2"], modes["im_1"], modes["im_2"]) == (-3, -3, 0, 0)
    assert modes["damping_ratio"] == 1


@given(data=st.data())
def test_a_stable_aircraft_comes_to_rest_where_the_state_matrix_says(data: st.DataObject):
    """[y, theta] at the end is -A^-1 [v, r] at the start."""
    _, _, p = data.draw(points("linear"))
    v, r = data.draw(values(["v", "r"]))
    A = state_matrix(p)
    slowest = -np.linalg.eigvals(A).real.max()
    assume(slowest > 0.5)
    end = call(load("linear_rk45"), state(v=v, r=r), NO_INPUT, p, 30 / slowest)
    rest = -np.linalg.solve(A, [v, r])
    np.testing.assert_allclose(end[2:4], rest, rtol=1e-7, atol=1e-8)
    np.testing.assert_allclose(end[:2], 0, atol=1e-8)


def test_with_the_gear_at_the_cg_alone_the_aircraft_slides_to_m_u_v0_over_C_f():
    """Trial 1, whose A is singular."""
    p = parameters("linear", a=0.0, Ap=0.0, Ct=0.0)
    end = call(load("linear_rk45"), state(v=0.1), NO_INPUT, p, 20.0)
    assert end[2] == pytest.approx(0.1 * BROTT["m"] * BROTT["u"] / (2 * BROTT["C_alpha"]))
    assert end[3] == 0


def growth(p: Array, speed: float) -> float:
    """Largest real part of an eigenvalue at another speed."""
    faster = p.copy()
    faster[SIGNATURES["linear"].parameters.index("u")] = speed
    return np.linalg.eigvals(state_matrix(faster)).real.max()


def assert_unstable_exactly_between(low: float, high: float, p: Array) -> None:
    for speed in np.geomspace(low / 20, high * 20, 60):
        assert (growth(p, speed) > 0) == (low < speed < high)
    for critical, inwards in ((low, 1 + 1e-6), (high, 1 - 1e-6)):
        assert growth(p, critical / inwards) < 0 < growth(p, critical * inwards)


@given(data=st.data())
def test_an_aircraft_is_unstable_between_its_critical_speeds_and_nowhere_else(
    data: st.DataObject,
):
    _, _, p = data.draw(points("linear"))
    low, high = closed_form("speed_window", aircraft("linear", p)).values()
    if np.isnan(low) and np.isnan(high):
        assert all(growth(p, speed) < 0 for speed in np.geomspace(0.5, 500, 60))
    else:
        assert_unstable_exactly_between(low, high, p)


def test_a_taildragger_with_its_gear_far_ahead_has_critical_speeds():
    p = parameters("linear", a=1.5)
    low, high = closed_form("speed_window", aircraft("linear", p)).values()
    assert 0 < low < high < np.inf
    assert_unstable_exactly_between(low, high, p)


@pytest.mark.parametrize(
    ("changes", "window"),
    [
        ({"Ct": 0.0}, "from standstill"),
        ({"Ap": 0.0}, "for ever"),
        ({"Ct": 0.0, "Ap": 0.0}, "from standstill, for ever"),
        ({"Ct": 0.0, "a": -0.5}, "never"),
        ({"Ap": 0.0, "a": -0.5}, "never"),
        ({"Ct": 0.0, "Ap": 0.0, "a": -0.5}, "never"),
        ({"Ct": 1e-9, "a": -0.5}, "never"),
    ],
)
def test_critical_speeds_without_tail_or_tail_wheel(changes: dict[str, float], window: str):
    """NaN twice, and nothing else, means no such speed."""
    low, high = closed_form("speed_window", {**BROTT, **changes}).values()
    assert np.isnan(low) == np.isnan(high) == (window == "never")
    assert (low == 0) == ("from standstill" in window)
    assert (high == np.inf) == ("for ever" in window)
