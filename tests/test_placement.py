"""`place_gear` against a dense grid that knows nothing of it, and against its own promises.

The oracle writes Eq. 4.31 and the static loads out in NumPy and tries every station; it shares no
code with the placement, with `generated` or with `derive`.
"""

from __future__ import annotations

import itertools
import json
from collections.abc import Callable
from typing import Any

import matplotlib as mpl
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from oracles import BROTT, MODELS, PER_DEGREE, Array, right_hand_side
from scipy.integrate import solve_ivp

import groundroll as gr
from groundroll.model.evaluate import elementwise
from groundroll.placement import SOURCES
from groundroll.placement.search import least
from groundroll.placement.worked import WorkedStudy, worked_study

mpl.use("Agg")

INCH = 0.0254
TAIL, NOSE, HEIGHT = 168 * INCH, -1.1, 1.1
FORWARD, AFT = 13.6 * INCH, 16.8 * INCH
#: The cubic through the points that survive of Fig. 3.8, N/rad over N.
CURVE = np.array([0.166916, -6.71022e-5, 9.79469e-9, 0.0]) * PER_DEGREE
#: A corner is (speed, CG station, mass, weight on wheels, tail load, tire wear).
SPEEDS = np.linspace(20, 110, 181) / 3.6
CG_RANGE = np.linspace(FORWARD, AFT, 9)


@pytest.fixture(scope="module")
def brott() -> gr.Aircraft:
    return gr.Aircraft.load("brott").replace(cg_height=HEIGHT, nose_wheel_station=NOSE)


@pytest.fixture(scope="module")
def physical() -> gr.Aircraft:
    plane = gr.Aircraft.load("brott-physical")
    return plane.replace(cg_height=HEIGHT, nose_wheel_station=NOSE, lift_off_speed="130 km/h")


ENVELOPE = gr.Envelope(speed=("20 km/h", "110 km/h"))


# --- The oracle -------------------------------------------------------------------------------
def eigenvalues(
    station: float,
    *,
    following: bool,
    layout: str = "taildragger",
    wear: float = 1.0,
    tail_load: float = 1.0,
    weight: float = 1.0,
    lift_off: float = np.inf,
    tail_wheel: float = 1.0,
    area: float = 0.6929,
    mass: float = 748.43,
) -> Array:
    """Eigenvalues at every speed and CG of the envelope, shape (speeds, CGs, 2)."""
    u, cg = np.meshgrid(SPEEDS, CG_RANGE, indexing="ij")
    a, b = cg - station, TAIL - cg
    third = TAIL if layout == "taildragger" else NOSE
    fraction = (third - cg) / (third - station)
    share = weight * (1 - (u / lift_off) ** 2)
    static = 748.43 * 9.81 * 0.64008 / 4.5212  # at 15.2 in
    if following:
        load = fraction * share * mass * 9.81 / 2
        C = (BROTT["B3"] + BROTT["C3"] * load) * load
        F = tail_load * (1 - fraction) * share * mass * 9.81
        Ct = sum(K * F ** (n + 1) for n, K in enumerate(CURVE))
    else:
        C = 441.63 * PER_DEGREE * share
        points = np.array([static, tail_load * static])
        at_static, now = (sum(K * F ** (n + 1) for n, K in enumerate(CURVE)) for F in points)
        Ct = 112 * PER_DEGREE * now / at_static
    if layout != "taildragger":
        Ct = 0.0 * u
    Cf, K = 2 * C * wear, Ct * wear * tail_wheel + 1.225 / 2 * u**2 * area * 0.1 * PER_DEGREE
    Izz = 1760.0
    # Eq. 4.31, row by row
    A = np.empty((*u.shape, 2, 2))
    A[..., 0, 0] = -(Cf + K) / (mass * u)
    A[..., 0, 1] = (b * K - a * Cf) / (mass * u) - u
    A[..., 1, 0] = (b * K - a * Cf) / (Izz * u)
    A[..., 1, 1] = -(a**2 * Cf + b**2 * K) / (Izz * u)
    return np.linalg.eigvals(A)


def decay(station: float, **options: Any) -> float:
    return float(-eigenvalues(station, **options).real.max())


def damping(station: float, **options: Any) -> float:
    found = eigenvalues(station, **options)
    oscillates = np.abs(found.imag) > 0
    ratio = np.where(oscillates, -found.real / np.abs(found), 1.0)
    return float(ratio.min())


def best_on_grid(score: Callable[[float], float], low: float, high: float) -> float:
    """The best station to 1e-5 m: a grid, and finer grids around its best point."""
    while high - low > 2e-5:
        stations = np.linspace(low, high, 41)
        k = int(np.argmax([score(x) for x in stations]))
        low, high = stations[max(k - 1, 0)], stations[min(k + 1, 40)]
    return (low + high) / 2


def angle(station: float, cg: float) -> float:
    return float(np.degrees(np.arctan((cg - station) / HEIGHT)))


# --- The answer against the grid ---------------------------------------------------------------
CASES: dict[str, tuple[str, dict[str, Any], dict[str, Any], tuple[float, float]]] = {
    "taildragger": ("decay_rate", {}, {}, (FORWARD - 1, FORWARD)),
    "taildragger with the elevator forward": (
        "decay_rate",
        {"tail_load": 0.5},
        {"tail_load": 0.5},
        (FORWARD - 1, FORWARD),
    ),
    "taildragger on worn tires": (
        "decay_rate",
        {"tire_wear": 0.8, "weight_on_wheels": 0.9},
        {"wear": 0.8, "weight": 0.9},
        (FORWARD - 1, FORWARD),
    ),
    "tricycle": ("decay_rate", {}, {"layout": "tricycle"}, (AFT, AFT + 0.6)),
    "tricycle for its damping": ("damping_ratio", {}, {"layout": "tricycle"}, (AFT, AFT + 0.6)),
}


def test_stiffness_is_constant_where_one_is_given(physical):
    def chosen(plane: gr.Aircraft, **options: Any) -> str:
        return gr.place_gear(plane, ENVELOPE, **options).case.stiffness

    soft = physical.replace(Ct="70 N/deg")
    assert chosen(physical) == "following"
    assert chosen(soft) == "constant"
    assert chosen(soft, layout="tricycle") == "following"
    assert chosen(physical.replace(C_alpha="400 N/deg")) == "constant"


@pytest.mark.parametrize("stiffness", ["constant", "following"])
@pytest.mark.parametrize("name", CASES)
def test_the_answer_is_that_of_a_dense_grid(
    brott: gr.Aircraft, physical: gr.Aircraft, name: str, stiffness: str
) -> None:
    objective, ranges, options, (low, high) = CASES[name]
    following = stiffness == "following"
    options = {**options, "following": following}
    found = gr.place_gear(
        physical if following else brott,
        gr.Envelope(speed=("20 km/h", "110 km/h"), **ranges),
        gr.Limits(),
        objective,
        variables={"main_gear_station": (low, high)},
        layout=options.get("layout"),
    )
    assert found.case.stiffness == stiffness
    score = damping if objective == "damping_ratio" else decay
    station = best_on_grid(lambda x: score(x, **options), low, high)
    assert found.station == pytest.approx(station, abs=1e-4)
    assert found.value == pytest.approx(score(found.station, **options), abs=2e-5)
    assert score(found.station, **options) >= score(station, **options) - 2e-5


def test_the_answer_with_lift_is_that_of_a_dense_grid(physical: gr.Aircraft) -> None:
    found = gr.place_gear(physical, gr.Envelope(speed=("20 km/h", "110 km/h"), lift=True))
    score = lambda x: decay(x, following=True, lift_off=130 / 3.6)  # noqa: E731
    station = best_on_grid(score, FORWARD - 1, FORWARD)
    assert found.station == pytest.approx(station, abs=1e-4)
    assert found.value == pytest.approx(score(station), abs=2e-5)


def test_two_variables_are_those_of_a_dense_grid(physical: gr.Aircraft) -> None:
    box = {"main_gear_station": (-0.4, FORWARD), "tail_wheel_scale": (0.2, 1.2)}
    found = gr.place_gear(physical, ENVELOPE, gr.Limits(damping_ratio=0.9), variables=box)
    scores = {}
    for scale in np.linspace(0.2, 1.2, 21):
        for x in np.linspace(-0.4, FORWARD, 41):
            options = {"following": True, "tail_wheel": scale}
            if damping(x, **options) >= 0.9:
                scores[x, scale] = decay(x, **options)
    assert found.value >= max(scores.values()) - 1e-4
    options = {"following": True, "tail_wheel": found.design["kappa"]}
    assert decay(found.station, **options) == pytest.approx(found.value, abs=2e-5)
    assert damping(found.station, **options) == pytest.approx(0.9, abs=1e-5)


def test_the_worst_speed_may_be_inside_the_range(brott: gr.Aircraft) -> None:
    envelope = gr.Envelope(speed=("20 km/h", "110 km/h"), tail_load=0.5)
    limits = gr.Limits(nose_over=("20 deg", None))
    found = gr.place_gear(brott, envelope, limits)
    speed = found.assessment.decay_rate.corner["u"]
    real = eigenvalues(found.station, following=False, tail_load=0.5).real.max(axis=(1, 2))
    assert speed == pytest.approx(SPEEDS[real.argmax()], abs=0.15)
    assert 25 < speed * 3.6 < 105
    assert found.rounds > 1
    assert found.value == pytest.approx(
        decay(found.station, following=False, tail_load=0.5), abs=5e-5
    )


def test_a_set_is_only_its_members(brott: gr.Aircraft) -> None:
    limits = gr.Limits(nose_over=("20 deg", None))
    ends = gr.place_gear(brott, gr.Envelope(speed=["20 km/h", "110 km/h"], tail_load=0.5), limits)
    within = gr.Envelope(speed=("20 km/h", "110 km/h"), tail_load=0.5)
    whole = gr.place_gear(brott, within, limits)
    assert ends.value > whole.value + 0.01
    assert set(np.round(ends.corners["u"] * 3.6, 6)) == {20.0, 110.0}


# --- Limits, prices, today ----------------------------------------------------------------------
def test_the_nose_over_limit_binds_where_geometry_says(physical: gr.Aircraft) -> None:
    found = gr.place_gear(physical, ENVELOPE, gr.Limits.textbook("taildragger"))
    assert found.station == pytest.approx(AFT - HEIGHT * np.tan(np.radians(25)), abs=1e-7)
    assert [p.of for p in found.binding] == ["nose_over at most 25.00 deg"]
    standing = {str(s.bound): s for s in found.assessment.standings}
    assert standing["nose_over at most 25.00 deg"].room == pytest.approx(0, abs=1e-7)
    at_least = standing["nose_over at least 16.00 deg"]
    assert np.degrees(at_least.worst.value) == pytest.approx(angle(found.station, FORWARD))


def test_the_smallest_change_goes_no_further_than_it_must(physical: gr.Aircraft) -> None:
    target = 2.3
    limits = gr.Limits(decay_rate=target)
    found = gr.place_gear(physical, ENVELOPE, limits, "smallest_change")
    low, high = -10 * INCH, 0.0
    for _ in range(40):
        middle = (low + high) / 2
        low, high = (middle, high) if decay(middle, following=True) < target else (low, middle)
    assert found.station == pytest.approx(high, abs=1e-5)
    assert found.assessment.decay_rate.value == pytest.approx(target, abs=1e-7)
    good = gr.place_gear(physical, ENVELOPE, gr.Limits(decay_rate=1.5), "smallest_change")
    assert good.station == pytest.approx(-10 * INCH, abs=1e-6)


def _gain(found: gr.Placement, of: str) -> float:
    (gain,) = (p.gain for p in (*found.binding, *found.prices) if p.of.startswith(of))
    return gain


def _slope(value: Callable[[float], float], step: float) -> float:
    """A central difference over a small step, scaled to a step of 1."""
    return (value(step) - value(-step)) / (2 * step)


def test_prices_are_differences_of_solved_problems(physical: gr.Aircraft) -> None:
    area = {"main_gear_station": (-0.6, 0.3), "tail_area": (0.5, 0.8)}

    def best(**change: float) -> float:
        plane = physical.replace(m=748.43 + change.get("mass", 0.0))
        plane = plane.replace(x_aft=AFT + change.get("aft", 0.0))
        plane = plane.replace(h_cg=HEIGHT + change.get("height", 0.0))
        box = {**area, "tail_area": (0.5, 0.8 + change.get("area", 0.0))}
        limits = gr.Limits(nose_over=(None, np.radians(25 + change.get("angle", 0.0))))
        top = 110 / 3.6 + change.get("speed", 0.0)
        envelope = gr.Envelope(speed=(20 / 3.6, top))
        return gr.place_gear(plane, envelope, limits, variables=box).value

    limits = gr.Limits(nose_over=(None, np.radians(25)))
    found = gr.place_gear(physical, ENVELOPE, limits, variables=area)
    expected = {
        "nose_over at most": _slope(lambda h: best(angle=h), 0.01),
        "tail_area at most": 0.01 * _slope(lambda h: best(area=h), 1e-3),
        "mass": _slope(lambda h: best(mass=h), 0.5),
        "aft cg": 1e-3 * _slope(lambda h: best(aft=h), 1e-4),
        "cg_height": 1e-3 * _slope(lambda h: best(height=h), 1e-3),
        "most speed": _slope(lambda h: best(speed=h), 0.01) / 3.6,
    }
    prices = {of: _gain(found, of) for of in expected}
    assert prices == pytest.approx(expected, rel=2e-3, abs=1e-6)
    assert prices["nose_over at most"] > 0


def test_the_price_of_a_millimetre_of_todays_gear(physical: gr.Aircraft) -> None:
    found = gr.place_gear(physical, ENVELOPE)
    assert found.today is not None
    (price,) = found.today.prices
    slope = _slope(lambda h: decay(-10 * INCH + h, following=True), 1e-3)
    assert (price.of, price.step) == ("main_gear_station", "1 mm")
    assert price.gain == pytest.approx(1e-3 * slope, rel=2e-3)
    here = decay(-10 * INCH, following=True)
    assert found.today.decay_rate.value == pytest.approx(here, abs=1e-4)


def test_what_is_found_is_what_linearize_finds(physical: gr.Aircraft) -> None:
    found = gr.place_gear(physical, ENVELOPE, gr.Limits.textbook("taildragger"))
    plane = found.aircraft.replace(cg_station=found.worst.corner["x_cg"])
    lin = gr.linearize(plane, "linear", speed=found.worst.corner["u"])
    assert lin.decay_rate == pytest.approx(found.value, rel=1e-12)


# --- Displacement ---------------------------------------------------------------------------------
def _offset(station: float, speed: float, cg: float) -> float:
    """Largest |Y| of a run at half-second samples, on the right-hand side as SymPy prints it."""
    p = {**BROTT, "a": cg - station, "b": TAIL - cg, "u": speed, "Ct": 112 * PER_DEGREE}
    p["C5"] = -8.81055e-5
    order = [str(q) for q in MODELS["nonlinear"].parameters]
    vector = np.array([p[s] for s in order])
    f = right_hand_side("nonlinear")
    run = solve_ivp(
        lambda t, x: f(x, np.zeros(1), vector),
        (0, 5),
        [0.1, 0, 0, 0, 0, 0, 0],
        t_eval=np.arange(0.5, 5.1, 0.5),
        rtol=1e-9,
        atol=1e-11,
    )
    return float(np.abs(run.y[5]).max())


def test_the_displacement_is_simulated_and_cannot_be_less(brott: gr.Aircraft) -> None:
    envelope = gr.Envelope(speed=["60 km/h", "110 km/h"])
    found = gr.place_gear(brott, envelope, gr.Limits(), "displacement")

    def worst(station: float) -> float:
        ends = itertools.product((60 / 3.6, 110 / 3.6), (FORWARD, AFT))
        return max(_offset(station, u, cg) for u, cg in ends)

    here = worst(found.station)
    assert found.value == pytest.approx(here, abs=1e-6)
    assert worst(found.station - 2e-3) > here
    assert worst(found.station + 2e-3) > here
    assert np.abs(found.proof["Y"][::50]).max() == pytest.approx(found.value, rel=1e-6)


# --- Conflicts ----------------------------------------------------------------------------------
def test_a_conflict_is_told_with_what_each_limit_would_have_to_give(physical: gr.Aircraft) -> None:
    limits = gr.Limits.textbook("tricycle")
    with pytest.raises(gr.InfeasibleError) as caught:
        gr.place_gear(physical, ENVELOPE, limits, layout="tricycle")
    alone = {str(c.bound): c.alone for c in caught.value.conflicts}

    def nose_load(station: float, cg: float) -> float:
        return (station - cg) / (station - NOSE)

    for_angle = AFT + HEIGHT * np.tan(np.radians(15))
    for_load = (FORWARD - 0.15 * NOSE) / (1 - 0.15)
    assert alone == pytest.approx(
        {
            "nose_wheel_load at most 15.00 %": nose_load(for_angle, FORWARD) - 0.15,
            "tip_back at least 15.00 deg": np.radians(15) - np.arctan((for_load - AFT) / HEIGHT),
        },
        abs=1e-6,
    )
    text = str(caught.value)
    assert "missed by" in text
    assert "alone it would have to give way by" in text
    assert for_load <= caught.value.nearest["x_main"] <= for_angle + 1e-6


def test_a_free_tail_wheel_that_is_never_stable(brott: gr.Aircraft) -> None:
    limits = gr.Limits(nose_over=("16 deg", "25 deg"))
    with pytest.raises(gr.InfeasibleError, match="decay_rate at least") as caught:
        gr.place_gear(brott, ENVELOPE, limits, tail_wheel="free")
    (stability,) = (c for c in caught.value.conflicts if c.bound.limit == "decay_rate")
    rear = FORWARD - HEIGHT * np.tan(np.radians(16))
    assert stability.alone == pytest.approx(-decay(rear, following=False, tail_wheel=0.0), abs=1e-4)


def test_an_unstable_best_is_returned_when_asked_for(brott: gr.Aircraft) -> None:
    limits = gr.Limits(decay_rate=None, nose_over=("16 deg", None))
    found = gr.place_gear(brott, ENVELOPE, limits, tail_wheel="free")
    assert found.value < 0
    assert any("unstable" in note for note in found.notes)


def test_a_gear_at_the_cg_with_nothing_behind_it_is_named(brott: gr.Aircraft) -> None:
    alone = brott.replace(Ap=0, Ct=0, x_forward=None, x_aft=None)
    found = gr.place_gear(
        alone,
        gr.Envelope(speed=25.0),
        variables={"main_gear_station": (15.2 * INCH, 16 * INCH)},
        layout="taildragger",
    )
    assert found.station == pytest.approx(15.2 * INCH, abs=1e-6)
    assert any("A is singular" in note for note in found.notes)
    assert "A is singular" in repr(found)


# --- The polynomials ----------------------------------------------------------------------------
MARGIN = {
    "m": (300.0, 2000.0),
    "Izz": (500.0, 5000.0),
    "a": (-1.5, 1.5),
    "b": (2.0, 6.0),
    "u": (5.0, 60.0),
    "rho": (0.8, 1.3),
    "Ap": (0.0, 2.0),
    "CL_gamma": (1.0, 6.0),
    "C_alpha": (5e3, 5e4),
    "Ct": (0.0, 2e4),
    "d": (-2.0, 6.0),
    "zeta": (0.05, 1.0),
}


@given(st.tuples(*(st.floats(*ends) for ends in MARGIN.values())))
def test_the_conditions_are_those_of_the_eigenvalues(drawn: tuple[float, ...]) -> None:
    p = dict(zip(MARGIN, drawn, strict=True))
    found = elementwise("placement_margins", {s: np.array(x) for s, x in p.items()})
    C, K = 2 * p["C_alpha"], p["Ct"] + p["rho"] / 2 * p["u"] ** 2 * p["Ap"] * p["CL_gamma"]
    couple = p["a"] * C - p["b"] * K
    A = (
        -np.array(
            [
                [(C + K) / p["m"], couple / p["m"] + p["u"] ** 2],
                [couple / p["Izz"], (p["a"] ** 2 * C + p["b"] ** 2 * K) / p["Izz"]],
            ]
        )
        / p["u"]
    )
    roots = np.linalg.eigvals(A)
    room = -roots.real.max() - p["d"]
    if abs(room) > 1e-6:
        assert (found["trace_d"] <= 0 and found["det_d"] >= 0) == (room > 0)
    if roots.real.max() < 0 and abs(roots[0].imag) > 1e-6:
        ratio = -roots[0].real / abs(roots[0])
        if abs(ratio - p["zeta"]) > 1e-6:
            assert (found["damping"] >= 0) == (ratio > p["zeta"])


@given(st.floats(-0.6, 0.3), st.floats(0.35, 0.42), st.floats(5, 40))
def test_equal_cornering_coefficients_cancel_at_any_station(
    station: float, cg: float, speed: float
) -> None:
    """With stiffness in proportion to load the tires do not turn the aircraft: a C_f = b C_t."""
    arguments = {
        "x_main": station,
        "x_third": TAIL,
        "x_tail": TAIL,
        "kappa": 1,
        "u": speed,
        "x_cg": cg,
        "m": 700,
        "w": 1,
        "tau": 1,
        "eta": 1,
        "g": 9.81,
        "u_lift": 1e12,
        "B3": 12,
        "C3": 0,
        "K1": 12,
        "K2": 0,
        "K3": 0,
        "K4": 0,
    }
    loads = elementwise(
        "placement_following", {s: np.array(float(x)) for s, x in arguments.items()}
    )
    couple = 2 * loads["C_alpha"] * loads["a"] - loads["Ct"] * loads["b"]
    assert couple == pytest.approx(0, abs=1e-7 * float(loads["C_alpha"]))


def test_the_search_finds_a_minimum_between_grid_points() -> None:
    plane = gr.Aircraft.load("brott")
    axes = gr.Envelope(speed=(10.0, 30.0), cg=(0.3, 0.5)).axes(plane)

    def bowl(points: Any) -> Array:
        return ((points["u"] - 17.1234) ** 2 + 40 * (points["x_cg"] - 0.4321) ** 2)[None]

    ((value, at),) = least(bowl, axes, 100)
    assert value == pytest.approx(0, abs=1e-7)
    assert (at["u"], at["x_cg"]) == pytest.approx((17.1234, 0.4321), abs=2e-4)


# --- What comes out -----------------------------------------------------------------------------
def test_json_and_repr_tell_the_whole_story(physical: gr.Aircraft) -> None:
    found = gr.place_gear(physical, ENVELOPE, gr.Limits.textbook("taildragger"))
    data = json.loads(found.to_json())
    assert data["design"]["main_gear_station"] == found.station
    assert data["placement"]["decay_rate"]["value"] == found.value
    assert data["today"]["design"]["main_gear_station"] == pytest.approx(-10 * INCH)
    assert data["envelope"]["speed"]["range"] is True
    assert {"of", "step", "gain"} == set(data["binding"][0])
    text = repr(found)
    for words in (
        "taildragger",
        "following stiffness",
        "main gear station",
        "today -254.0 mm",
        "held by nose_over at most 25.00 deg: 1 deg more changes the decay rate by +",
        "worst at speed 110 km/h, CG 345.4 mm",
        "today: nose_over at most 25.00 deg is broken by",
    ):
        assert words in text


def test_pictures_carry_units_and_both_places(physical: gr.Aircraft) -> None:
    from matplotlib import pyplot

    found = gr.place_gear(physical, ENVELOPE, gr.Limits.textbook("taildragger"))
    figure = found.plot()
    above, below = figure.axes
    assert above.get_xlabel() == "main gear station behind the datum (mm)"
    assert above.get_ylabel().endswith("(1/s)")
    words = " ".join(text.get_text() for text in above.texts)
    assert "placed" in words
    assert "today" in words
    assert "nose over ≤ 25.00 deg" in words
    assert below.get_ylabel() == "offset to the right Y (m)"
    worst = next(line for line in above.lines if line.get_label() == "worst of the whole envelope")
    x, y = worst.get_xdata(), worst.get_ydata()
    assert np.interp(1e3 * found.station, x, y) == pytest.approx(found.value, abs=2e-3)
    pyplot.close(figure)


def test_the_front_gives_up_margin_for_angle(physical: gr.Aircraft) -> None:
    from matplotlib import pyplot

    envelope = gr.Envelope(speed=("20 km/h", "110 km/h"), tail_load=0.5)
    found = gr.place_gear(physical, envelope, gr.Limits(nose_over=(None, "25 deg")))
    front = found.pareto("nose_over", 5)
    assert (np.diff(front.margin) <= 1e-9).all()
    assert (np.diff(front.other) > 0).all()
    assert front.margin[0] == pytest.approx(found.value, abs=1e-7)
    for station, margin in zip(front.stations, front.margin, strict=True):
        oracle = decay(float(station), following=True, tail_load=0.5)
        assert oracle == pytest.approx(margin, abs=5e-5)
    figure = front.plot()
    assert figure.axes[0].get_xlabel() == "worst nose over (deg)"
    assert "main gear (mm)" in repr(front)
    pyplot.close(figure)


def test_a_front_without_a_choice_is_one_point(physical: gr.Aircraft) -> None:
    """With all the static load on the tail wheel the better margin is at the greater angle."""
    found = gr.place_gear(physical, ENVELOPE, gr.Limits(nose_over=(None, "25 deg")))
    assert found.pareto("nose_over", 5).stations == pytest.approx([found.station], abs=1e-6)


def test_sources_name_whose_rules_they_are() -> None:
    rules = {
        b.limit
        for layout in ("taildragger", "tricycle")
        for b in gr.Limits.textbook(layout).bounds(layout)
        if b.limit not in ("decay_rate", "tail_wheel_load")
    }
    assert rules == set(SOURCES)
    assert all("Raymer" in text for text in SOURCES.values())


# --- Bad input ----------------------------------------------------------------------------------
BAD_ENVELOPES: dict[str, tuple[dict[str, Any], str]] = {
    "backwards": (
        {"speed": (30, 10)},
        "Envelope.speed: the range runs backwards, from 30 to 10 m/s",
    ),
    "empty": ({"cg": []}, "Envelope.cg is empty"),
    "three ends": ({"speed": (1, 2, 3)}, "a tuple is a range and has two ends, not 3"),
    "no weight": ({"weight_on_wheels": (0, 1)}, "a tire without load has no stiffness"),
    "standing": ({"speed": (0, 10)}, "speed .* must be positive"),
    "worn away": ({"tire_wear": [0.0, 1.0]}, "tire_wear .* must be positive"),
    "not finite": ({"mass": float("nan")}, "must be finite"),
    "wrong unit": ({"speed": ("20 kg", "30 km/h")}, "Envelope.speed"),
    "not a number": ({"cg": [None]}, "Envelope.cg must be a number"),
    "not numbers": ({"cg": [[1], [2, 3]]}, "Envelope.cg must be a number"),
}


@pytest.mark.parametrize("name", BAD_ENVELOPES)
def test_bad_envelopes_are_named(name: str) -> None:
    fields, message = BAD_ENVELOPES[name]
    with pytest.raises(gr.GroundrollError, match=message):
        gr.Envelope(**fields)


BAD_LIMITS: dict[str, tuple[dict[str, Any], str]] = {
    "crossed": (
        {"nose_over": ("25 deg", "16 deg")},
        "Limits.nose_over: the bounds are crossed, at least 25.00 deg but at most 16.00 deg",
    ),
    "one bound": ({"nose_over": "16 deg"}, r"has two bounds, \(low, high\)"),
    "damping above 1": ({"damping_ratio": 1.5}, "above 0 and at most 1"),
    "no displacement": ({"displacement": 0}, "must be positive"),
    "infinite": ({"wheelbase": (None, float("inf"))}, "None is no limit"),
    "wrong unit": ({"wheelbase": ("1 kg", None)}, "Limits.wheelbase"),
}


@pytest.mark.parametrize("name", BAD_LIMITS)
def test_bad_limits_are_named(name: str) -> None:
    fields, message = BAD_LIMITS[name]
    with pytest.raises(gr.GroundrollError, match=message):
        gr.Limits(**fields)


Bad = tuple[dict[str, Any], dict[str, Any], str]
BAD_CALLS: dict[str, Bad] = {
    "objective": ({}, {"objective": "decay"}, "did you mean decay_rate"),
    "layout": ({}, {"layout": "canard"}, "unknown layout"),
    "stiffness": ({}, {"stiffness": "loads"}, "unknown stiffness"),
    "tail wheel": ({}, {"tail_wheel": "lock"}, "did you mean locked"),
    "variable": ({}, {"variables": {"gear": (0, 1)}}, "unknown variable"),
    "crossed": ({}, {"variables": {"main_gear_station": (0.3, 0.1)}}, "the bounds are crossed"),
    "no choice": ({}, {"variables": {"tail_area": (0.5, 0.5)}}, "leaves no choice"),
    "not a pair": ({}, {"variables": {"tail_area": 0.5}}, r"must be \(low, high\)"),
    "negative": ({}, {"variables": {"tail_area": (-0.5, 0.5)}}, "must not be negative"),
    "meets the tail": ({}, {"variables": {"main_gear_station": (0, 5)}}, "may meet"),
    "tail ahead": ({}, {"variables": {"tail_station": (0.4, 5)}}, "must be behind the CG"),
    "nose wheel": (
        {},
        {"variables": {"nose_wheel_station": (-2, -1)}},
        "nothing for a taildragger",
    ),
    "free and scaled": (
        {},
        {"tail_wheel": "free", "variables": {"tail_wheel_scale": (0.5, 2)}},
        "nothing to scale",
    ),
    "limit of the other layout": (
        {},
        {"limits": gr.Limits(tip_back=("15 deg", None))},
        "Limits.tip_back means nothing for a taildragger",
    ),
    "no height": ({"h_cg": None}, {"limits": gr.Limits(nose_over=(0.3, None))}, "cg_height"),
    "no nose wheel": (
        {"x_nose": None},
        {"layout": "tricycle"},
        "a tricycle needs nose_wheel_station",
    ),
    "no lift-off speed": (
        {},
        {"envelope": gr.Envelope(speed=20.0, lift=True)},
        "lift_off_speed .* is not given",
    ),
    "flying": (
        {"u_lift": 25.0},
        {"envelope": gr.Envelope(speed=(10.0, 30.0), lift=True)},
        "no weight is left on the wheels",
    ),
    "arm at odds": ({"a": -0.5}, {}, "A gear is fixed to the airframe: give its station"),
    "stiffness given": ({}, {"stiffness": "following"}, "cannot follow the gear"),
    "array": ({"m": np.array([700.0, 800.0])}, {}, "is an array of shape"),
    "stiffness without load": (
        {"x_main": 0.3861, "x_cg": 0.386, "x_forward": None, "x_aft": None},
        {"envelope": gr.Envelope(tail_load=(0.5, 1.0)), "layout": "taildragger"},
        "carries nothing today",
    ),
    "no curve": ({"K1": None}, {"envelope": gr.Envelope(tail_load=(0.5, 1.0))}, "tail_wheel_K1"),
    "time": ({}, {"t": 0.0}, "t must be a positive number"),
}


@pytest.mark.parametrize("name", BAD_CALLS)
def test_bad_calls_are_named(brott: gr.Aircraft, name: str) -> None:
    changes, arguments, message = BAD_CALLS[name]
    with pytest.raises(gr.GroundrollError, match=message):
        gr.place_gear(brott.replace(**changes), **arguments)


def test_bad_fronts_are_named(brott: gr.Aircraft) -> None:
    found = gr.place_gear(brott, gr.Envelope(speed=25.0))
    for against, points, message in (
        ("nose", 5, "unknown Pareto axis"),
        ("tip_back", 5, "means nothing for a taildragger"),
        ("nose_over", 1, "at least 2 points"),
    ):
        with pytest.raises(gr.GroundrollError, match=message):
            found.pareto(against, points)


# --- The worked study ---------------------------------------------------------------------------
def test_the_aircraft_of_a_placement_has_its_tail_wheel(brott: gr.Aircraft) -> None:
    scale = {"main_gear_station": (-0.2, 0.0), "tail_wheel_scale": (0.5, 1.5)}
    found = gr.place_gear(brott, ENVELOPE, variables=scale)
    at = found.worst.corner
    lin = gr.linearize(found.aircraft.replace(cg_station=at["x_cg"]), "linear", speed=at["u"])
    assert lin.decay_rate == pytest.approx(found.value, rel=1e-12)
    assert found.aircraft["Ct"] == pytest.approx(found.design["kappa"] * brott["Ct"])


@pytest.fixture(scope="module")
def study() -> WorkedStudy:
    return worked_study()


def test_the_study_answers_as_the_grid_does(study: WorkedStudy) -> None:
    for stiffness in ("constant", "following"):
        found = study.placement("taildragger", stiffness, "stability")
        options = {"following": stiffness == "following", "tail_load": 0.5}
        station = best_on_grid(lambda x, o=options: decay(x, **o), FORWARD - 1, FORWARD)
        assert found.station == pytest.approx(station, abs=1e-4)


def test_the_study_tells_what_the_constant_stiffness_hid(study: WorkedStudy) -> None:
    (textbook,) = (h for h in study.hidden if (h.layout, h.limits) == ("taildragger", "textbook"))
    actual = decay(textbook.believed.station, following=True, tail_load=0.5)
    assert textbook.actual.decay_rate.value == pytest.approx(actual, abs=1e-4)
    assert textbook.believed.value > 2.5 * actual
    assert textbook.best.value >= textbook.actual.decay_rate.value - 1e-7
    assert any("leave no place" in finding for finding in study.findings())


def test_the_study_has_whole_tables(study: WorkedStudy) -> None:
    for table in study.tables():
        assert table.rows
        assert {len(row) for row in table.rows} == {len(table.header)}
    assert {e["source"] for e in study.estimates.values()}


def test_the_study_draws_its_figures(study: WorkedStudy) -> None:
    from matplotlib import pyplot

    figures = study.figures()
    assert set(figures) == {
        "placement-models",
        "placement-pareto",
        "placement-taildragger",
        "placement-tricycle",
    }
    for figure in figures.values():
        assert all(ax.get_xlabel() and ax.get_ylabel() for ax in figure.axes)
        pyplot.close(figure)


def test_the_study_takes_the_height_that_it_states(study: WorkedStudy):
    """Not the one that would follow from an estimate where a file is silent."""
    heights = [a.placement.case.numbers["h_cg"] for a in study.answers if a.placement]
    assert len(heights) > 2
    assert heights == pytest.approx([40.3 * 0.0254] * len(heights))
