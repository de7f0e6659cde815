"""Margins, critical speeds and gear positions against brute force and against the thesis."""

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given
from hypothesis import strategies as st
from oracles import BROTT, MODELS, PER_DEGREE, points

import groundroll as gr
from groundroll.derive.core.body import Izz, m
from groundroll.derive.core.equation import expand
from groundroll.derive.core.linearise import state_space
from groundroll.derive.parts.quantities import (
    B3,
    C3,
    K1,
    K2,
    K3,
    K4,
    C_alpha,
    Ct,
    L,
    a,
    b,
    u,
)
from groundroll.derive.theory import gear_position, margins, worst_speed
from groundroll.derive.theory.closed_forms import (
    C_f,
    K,
    k,
    routh_hurwitz,
    speed_polynomial,
    stiffnesses,
)
from groundroll.derive.theory.loads import static_loads
from groundroll.stability.polynomials import negative_stretch, roots

NAMES = tuple(map(str, MODELS["linear"].parameters))


def aircraft(**changes):
    """The thesis's aircraft of Trial 19, with changes, as plain numbers."""
    values = {name: BROTT[name] for name in NAMES} | changes
    return gr.Aircraft("random", values)


_A = sp.lambdify(MODELS["linear"].parameters, list(state_space(MODELS["linear"])[0]), "numpy")


def state_matrix(plane, **changes):
    """A of the linear model as SymPy prints it; with an array, one matrix per element."""
    entries = _A(*({name: plane[name] for name in NAMES} | changes).values())
    shape = np.broadcast_shapes(*map(np.shape, entries))
    flat = np.stack([np.broadcast_to(entry, shape) for entry in entries], axis=-1)
    return flat.reshape(*shape, 2, 2).astype(float)


def decay_rates(plane, speeds):
    """-max Re of NumPy's eigenvalues at each speed."""
    return -np.linalg.eigvals(state_matrix(plane, u=np.asarray(speeds))).real.max(axis=-1)


def determinant(plane, **changes):
    return np.linalg.det(state_matrix(plane, **changes))


planes = (
    points("linear")
    .map(lambda point: aircraft(**dict(zip(NAMES, point[2], strict=True))))
    .filter(lambda plane: float(plane["a"] + plane["b"]) > 0.1)  # the gear ahead of the tail
)
taildraggers = planes.filter(lambda plane: 0.05 < float(plane["a"]) < 0.8 * float(plane["b"]))


# --- The thesis's aircraft ------------------------------------------------------------------


def test_the_tail_wheel_that_the_thesis_needs():
    """66.9 N/deg at full load makes it stable at every speed; the worst speed is 98.5 km/h."""
    plane = aircraft()
    needed = float(gr.margins(plane).stiffness_needed_always)
    assert needed / PER_DEGREE == pytest.approx(66.9, abs=0.05)

    at_the_edge = gr.speed_window(plane.replace(Ct=needed))
    assert float(at_the_edge.weakest) * 3.6 == pytest.approx(98.5, abs=0.1)
    assert float(at_the_edge.worst) * 3.6 == pytest.approx(98.5, abs=0.1)
    assert float(at_the_edge.worst_decay_rate) == pytest.approx(0.0, abs=1e-9)
    assert float(at_the_edge.least_determinant) == pytest.approx(0.0, abs=1e-9)

    stiff, soft = (gr.speed_window(plane.replace(Ct=needed * s)) for s in (1.001, 0.999))
    assert np.isnan(stiff.low)
    assert np.isnan(stiff.high)
    assert soft.low < at_the_edge.weakest < soft.high


def test_table_4_8_is_stable_with_each_tail_wheel():
    found = gr.margins(aircraft(Ct=PER_DEGREE * np.array([70.0, 112.0, 145.0])))
    assert (found.speed_margin > 0).all()
    np.testing.assert_allclose(-found.decay_rate, [-0.118, -2.56, -3.24], atol=6e-3)


def test_a_slow_mode_halves_in_the_time_it_takes():
    """Trial 19: lambda = -0.118, so a deviation halves in ln 2 / 0.118 s."""
    found = gr.margins(aircraft())
    assert float(found.time_to_half) == pytest.approx(np.log(2) / 0.118, rel=5e-3)
    assert np.isinf(found.time_to_double)


# --- Closed forms against brute force, for any aircraft ----------------------------------------


@given(planes)
def test_modes_are_numpys_eigenvalues(plane):
    A, found = state_matrix(plane), gr.margins(plane)
    eigenvalues = np.linalg.eigvals(A)
    scale = np.abs(eigenvalues).max()
    assert float(found.trace) == pytest.approx(np.trace(A), rel=1e-9, abs=1e-12 * scale)
    assert float(found.determinant) == pytest.approx(np.linalg.det(A), abs=1e-9 * scale**2)
    assert float(found.decay_rate) == pytest.approx(-eigenvalues.real.max(), abs=1e-6 * scale)
    assert float(found.damped_frequency) == pytest.approx(
        np.abs(eigenvalues.imag).max(), abs=1e-6 * scale
    )
    assert bool(found.decay_rate > 0) == bool(found.trace < 0 and found.determinant > 0)


@given(planes)
def test_times_are_those_in_which_the_slow_mode_halves_or_doubles(plane):
    found = gr.margins(plane)
    assume(abs(found.decay_rate) > 1e-9)
    grown = np.exp(-found.decay_rate * np.minimum(found.time_to_half, found.time_to_double))
    assert float(grown) == pytest.approx(0.5 if found.decay_rate > 0 else 2.0, rel=1e-12)


@given(planes)
def test_a_side_force_at_the_neutral_steer_point_does_not_turn_the_aircraft(plane):
    found = gr.margins(plane)
    A, mass, inertia = state_matrix(plane), float(plane["m"]), float(plane["Izz"])
    assume(np.linalg.cond(A) < 1e9)
    station = float(found.neutral_steer_point)
    push = np.array([1 / mass, station / inertia])
    v, r = np.linalg.solve(A, -push)
    assert abs(r) <= 1e-9 * abs(v)
    wheelbase = float(plane["a"] + plane["b"])
    assert float(found.static_margin) == pytest.approx(-station / wheelbase, rel=1e-12)


@given(planes)
def test_understeer_gradient_is_the_difference_of_load_over_stiffness(plane):
    """K_us = (W_front/C_front - W_rear/C_rear)/g, and r = u delta / (L + K_us u^2)."""
    gradient = float(gr.margins(plane).understeer_gradient)
    v = {name: float(plane[name]) for name in NAMES}
    base, C = v["a"] + v["b"], 2 * v["C_alpha"]
    tail = v["Ct"] + v["rho"] * v["Ap"] * v["CL_gamma"] / 2 * v["u"] ** 2
    loads = v["m"] * v["b"] / base, v["m"] * v["a"] / base  # over g
    assert gradient == pytest.approx(loads[0] / C - loads[1] / tail, rel=1e-9, abs=1e-12)

    A = state_matrix(plane)
    assume(np.linalg.cond(A) < 1e9)
    _, r = np.linalg.solve(A, -np.array([C / v["m"], v["a"] * C / v["Izz"]]))
    assert r * (base + gradient * v["u"] ** 2) == pytest.approx(v["u"], rel=1e-7)


@given(planes)
def test_the_window_is_where_the_determinant_is_negative(plane):
    window = gr.speed_window(plane)
    speeds = np.geomspace(0.05, 2000.0, 400)
    negative = determinant(plane, u=speeds) < 0
    inside = (speeds > window.low) & (speeds < window.high)
    near = [np.abs(speeds / end - 1) < 1e-6 for end in (window.low, window.high)]
    assert (negative == inside)[~np.logical_or(*near)].all()

    always = bool(gr.margins(plane).speed_margin > 0)
    assert always == np.isnan(window.low) == np.isnan(window.high) == (window.least_determinant > 0)
    if not always:
        assert float(window.weakest) == pytest.approx(np.sqrt(window.low * window.high), rel=1e-9)


@given(planes, st.floats(2.0, 20.0), st.floats(1.5, 6.0))
def test_no_speed_decays_slower_than_the_worst(plane, low, ratio):
    high = low * ratio
    window = gr.speed_window(plane, speeds=(low, high))
    speeds = np.linspace(low, high, 400)
    brute = decay_rates(plane, speeds)
    scale = np.abs(brute).max()
    assert window.worst_decay_rate <= brute.min() + 1e-7 * scale
    assert low <= window.worst <= high
    there = decay_rates(plane, [float(window.worst)])[0]
    assert there == pytest.approx(float(window.worst_decay_rate), abs=1e-6 * scale)


@given(taildraggers)
def test_the_tail_wheel_needed_is_that_of_a_zero_determinant(plane):
    found = gr.margins(plane)
    scale = np.abs(np.linalg.eigvals(state_matrix(plane))).max() ** 2
    if found.stiffness_needed > 0:
        there = determinant(plane, Ct=found.stiffness_needed)
        assert there == pytest.approx(0.0, abs=1e-9 * scale)
    if found.stiffness_needed_always > 1.0:
        for factor in (1.001, 0.999):
            other = gr.margins(plane.replace(Ct=factor * found.stiffness_needed_always))
            assert (other.speed_margin > 0) == (factor > 1)


# --- Gear position --------------------------------------------------------------------------


@given(taildraggers)
def test_stability_is_lost_where_the_gear_limit_says(plane):
    limit = gr.gear_limit(plane)
    arms = np.linspace(-0.9 * float(plane["b"]), 3 * float(plane["b"]), 300)
    negative = determinant(plane, a=arms) < 0
    inside = (arms > limit.lost) & (arms < limit.regained)
    assert (negative == inside).all()


@given(taildraggers, st.floats(2.0, 20.0), st.floats(1.5, 6.0))
def test_the_envelope_is_the_least_limit_over_speed(plane, low, ratio):
    envelope = gr.gear_envelope(plane, speeds=(low, low * ratio))
    over_speed = gr.gear_limit(plane, speed=np.linspace(low, low * ratio, 4001)).lost
    if np.isnan(over_speed).all():
        assert np.isnan(envelope.lost)
        return
    least = np.nanmin(over_speed)
    assume(least < float(plane["b"]))
    assert float(envelope.lost) <= least * (1 + 1e-12)
    assert float(envelope.lost) == pytest.approx(least, rel=1e-5)
    at_that_speed = gr.gear_limit(plane, speed=envelope.speed).lost
    assert float(at_that_speed) == pytest.approx(float(envelope.lost), rel=1e-9)


def following(plane, arm, speed):
    """The aircraft with its gear at `arm` and everything that follows from loads following."""
    free = dict.fromkeys(("f", "Fz", "C_alpha", "Ct", "L", "F_tail_load"))
    return plane.replace(a=arm, b=plane["b"], u=speed, **free)


@pytest.mark.parametrize("speed", [12.0, 100 / 3.6, 45.0])
def test_the_limit_with_loads_that_follow_is_that_of_the_loads_module(speed):
    plane = gr.Aircraft.load("brott")
    limit = gr.gear_limit(plane, speed=speed, loads="follow")
    arms = np.linspace(0.001, 4.0, 500)
    planes = following(plane, arms, speed)
    found = gr.margins(planes).determinant
    inside = (arms > limit.lost) & (arms < limit.regained)
    assert ((found < 0) == inside).all()
    if np.isfinite(limit.lost):
        at_limit = gr.margins(following(plane, limit.lost, speed)).determinant
        assert float(at_limit) == pytest.approx(0.0, abs=1e-8)


def test_the_envelope_with_loads_that_follow_is_the_least_over_speed():
    plane = gr.Aircraft.load("brott")
    for speeds in ((5.0, 60.0), (5.0, 25.0), (40.0, 60.0)):
        envelope = gr.gear_envelope(plane, speeds=speeds, loads="follow")
        grid = gr.gear_limit(plane, speed=np.linspace(*speeds, 20001), loads="follow").lost
        assert float(envelope.lost) == pytest.approx(np.nanmin(grid), abs=1e-7)


def test_equal_cornering_coefficients_cancel_at_any_position():
    """F_main b - F_tail a is zero with axle loads from the CG, whatever the gear position."""
    chain = [e for e in static_loads() if e.lhs not in (a, b)]
    c = sp.Symbol("c", positive=True)
    equal = {B3: c, C3: 0, K1: c, K2: 0, K3: 0, K4: 0}
    main, tail = (expand(stiffness, chain).subs(equal) for stiffness in (2 * C_alpha, Ct))
    difference = tail * b - main * a
    assert sp.simplify(difference) == 0

    plane = gr.Aircraft.load("brott").replace(B3=12.0, C3=0.0, K1=12.0, K2=0.0, K3=0.0, K4=0.0)
    limit = gr.gear_limit(plane, speed=np.array([5.0, 30.0, 80.0]), loads="follow")
    assert np.isnan(limit.lost).all()
    arms = np.linspace(0.05, 3.0, 30)
    without_tail = gr.margins(following(plane.replace(Ap=0.0), arms, 30.0))
    np.testing.assert_allclose(without_tail.neutral_steer_point, 0.0, atol=1e-12)


# --- The derivation ---------------------------------------------------------------------------


def test_the_condition_for_every_speed_is_the_one_of_the_issue():
    """sqrt(m a C) < sqrt(m b K0) + L sqrt(C k), divided by sqrt(m C L)."""
    chain = margins.tail_wheel_needed()
    C, tail, ahead = sp.symbols("C tail ahead", positive=True)
    margin = expand(margins.speed_margin, chain).subs({C_f: C, k: tail}).subs(a, ahead)
    issue = sp.sqrt(m * b * Ct) + (ahead + b) * sp.sqrt(C * tail) - sp.sqrt(m * ahead * C)
    assert sp.simplify(margin - issue / sp.sqrt(m * C * (ahead + b))) == 0


def test_the_stationary_quartic_holds_each_stationary_real_eigenvalue():
    """In 40 digits: the speed of the least decay rate by golden section, put into the quartic."""
    with mp.workdps(40):
        numbers = {q: mp.mpf(BROTT[q.name]) for q in MODELS["linear"].parameters if q.name != "u"}
        rh = (*stiffnesses(), *routh_hurwitz())
        tr, det = (expand(e.lhs, rh).subs(numbers) for e in routh_hurwitz()[:2])
        slow = sp.lambdify(u, tr / 2 + sp.sqrt(tr**2 / 4 - det), "mpmath")
        lo, hi = mp.mpf(20), mp.mpf(40)
        golden = (mp.sqrt(5) - 1) / 2
        for _ in range(90):
            left, right = hi - golden * (hi - lo), lo + golden * (hi - lo)
            lo, hi = (lo, right) if slow(left) > slow(right) else (left, hi)
        s = ((lo + hi) / 2) ** 2
        whole = (*stiffnesses(), *speed_polynomial(), *worst_speed.stationary_decay())
        terms = [mp.mpf(expand(e, whole).subs(numbers)) for e in worst_speed.STATIONARY]
        value = mp.fsum(c * s**n for n, c in enumerate(terms))
        size = mp.fsum(abs(c) * s**n for n, c in enumerate(terms))
        assert abs(value / size) < mp.mpf(10) ** -15
        found = gr.speed_window(aircraft(), speeds=(20.0, 40.0))
        assert float(found.worst) == pytest.approx(float(mp.sqrt(s)), rel=1e-9)


def test_the_position_polynomial_is_det_a():
    """The polynomial in the load share is det A times 2 Izz u^2 (1 - phi)/b, in exact numbers."""
    loaded = (*gear_position.following_loads(), *gear_position.position_polynomial())
    phi = gear_position.tail_fraction
    polynomial = sum(expand(p, loaded) * phi**n for n, p in enumerate(gear_position.POSITION))
    chain = [e for e in static_loads() if e.lhs not in (a, b)]
    stiff = {C_f: 2 * expand(C_alpha, chain), K: expand(Ct, chain) + k * u**2}
    det = routh_hurwitz()[1].rhs.subs(stiff).subs(L, a + b)
    names = sorted({*polynomial.free_symbols, *det.free_symbols} - {a, phi}, key=str)
    exact = {name: sp.Rational(n + 3, 7) for n, name in enumerate(names)}
    share = sp.Rational(2, 9)
    direct = det.subs(a, b * share / (1 - share)) * 2 * Izz * u**2 * (1 - share) / b
    assert polynomial.subs(phi, share).subs(exact) == direct.subs(exact)


# --- Edges and bad input ------------------------------------------------------------------------


def test_windows_without_an_end():
    without_wheel = gr.speed_window(aircraft(Ct=0.0))
    assert without_wheel.low == 0
    assert 0 < without_wheel.high < np.inf
    without_tail = gr.speed_window(aircraft(Ap=0.0))
    assert without_tail.low > 0
    assert without_tail.high == np.inf
    neither = gr.speed_window(aircraft(Ap=0.0, Ct=0.0))
    assert neither.low == 0
    assert neither.high == np.inf


@pytest.mark.parametrize("missing", [{}, {"Ct": 0.0}, {"Ap": 0.0}])
def test_a_gear_behind_the_cg_has_no_window(missing):
    window = gr.speed_window(aircraft(a=-0.5, **missing))
    assert np.isnan(window.low)
    assert np.isnan(window.high)


def test_a_mode_that_stays_neither_halves_nor_doubles():
    """Trials 1 and 2: gear at the CG and nothing at the tail, one eigenvalue is zero."""
    found = gr.margins(aircraft(a=0.0, Ap=0.0, Ct=0.0))
    assert found.determinant == 0
    assert found.time_to_half == np.inf
    assert found.time_to_double == np.inf


def test_without_a_tail_the_gear_must_be_behind_the_cg():
    limit = gr.gear_limit(aircraft(Ap=0.0, Ct=0.0))
    assert limit.lost == 0
    assert limit.regained == np.inf


def test_a_slow_aircraft_may_have_its_gear_anywhere():
    assert np.isnan(gr.gear_limit(aircraft(), speed=2.0).lost)
    assert np.isnan(gr.gear_envelope(aircraft(), speeds=(1.0, 2.0)).lost)


def test_arrays_go_through():
    plane = aircraft(a=np.linspace(-0.5, 1.0, 4)[:, None])
    found = gr.margins(plane, speed=[10.0, 20.0, 30.0])
    assert all(np.shape(value) == (4, 3) for value in vars(found).values())
    window = gr.speed_window(plane, speeds=(5.0, [30.0, 60.0]))
    assert window.worst.shape == (4, 2)
    one = gr.speed_window(aircraft(a=1.0), speeds=(5.0, 60.0))
    assert window.worst[3, 1] == pytest.approx(float(one.worst), rel=1e-12)
    assert gr.gear_envelope(aircraft(m=[700.0, 800.0]), loads="fixed").lost.shape == (2,)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: gr.speed_window(aircraft(), speeds=(30.0, 20.0)), "above"),
        (lambda: gr.speed_window(aircraft(), speeds=(0.0, 20.0)), "positive"),
        (lambda: gr.speed_window(aircraft(), speeds=5.0), "pair"),
        (lambda: gr.speed_window(aircraft(), speeds=(np.nan, 20.0)), "finite"),
        (lambda: gr.margins(aircraft(), speed=-1.0), "positive"),
        (lambda: gr.margins(aircraft(a=[1.0, 2.0]), speed=[1.0, 2.0, 3.0]), "broadcast"),
        (lambda: gr.gear_limit(aircraft(), loads="folow"), "follow"),
        (lambda: gr.gear_limit(aircraft(), loads="follow"), "not given"),
    ],
)
def test_what_cannot_be_is_named(call, words):
    with pytest.raises(gr.GroundrollError, match=words):
        call()


@given(st.lists(st.floats(-2.0, 2.0), min_size=1, max_size=5), st.integers(0, 2))
def test_roots_of_known_polynomials(zeros, padding):
    coefficients = np.polynomial.polynomial.polyfromroots(zeros)
    padded = np.append(coefficients, np.zeros(padding))
    found = roots(padded[:, None])[:, 0]
    assert np.isnan(found[len(zeros) :]).all()
    back = np.polynomial.polynomial.polyfromroots(found[: len(zeros)])
    np.testing.assert_allclose(back, coefficients, atol=1e-10 * np.abs(coefficients).max())


def test_the_first_negative_stretch():
    from_roots = np.polynomial.polynomial.polyfromroots
    rows = [
        from_roots([0.2, 0.7]),
        -from_roots([0.3]),
        from_roots([2.0, 3.0]),
        from_roots([0.4] * 2),
    ]
    coefficients = np.array([np.append(row, np.zeros(3 - len(row))) for row in rows]).T
    start, end = negative_stretch(coefficients)
    np.testing.assert_allclose(start, [0.2, 0.3, np.nan, np.nan], atol=1e-12)
    np.testing.assert_allclose(end, [0.7, np.nan, np.nan, np.nan], atol=1e-12)
