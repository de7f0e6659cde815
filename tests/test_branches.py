"""Branches of equilibria against closed forms, and against root finders of SciPy."""

from __future__ import annotations

import matplotlib as mpl
import numpy as np
import pytest
from own_models import CAR, LAGGING, own
from scipy.optimize import brentq

import groundroll as gr

mpl.use("Agg")
SOFT = gr.Aircraft.load("brott-physical").replace(Ct="50 N/deg")
CESSNA = gr.Aircraft.load("cessna-170")


def marked(found: gr.Branches, kind: str) -> list[float]:
    over = found[found.over]
    return [float(over[mark.branch, mark.point]) for mark in found.marks if mark.kind == kind]


def test_an_oversteering_car_branches_at_its_critical_speed() -> None:
    """V^2 = -L / K with the understeer gradient K = m / L (b / C_f - a / C_r)."""
    m, a, b, front, rear = 1500.0, 1.2, 1.6, 1.2e5, 7e4
    gradient = m / (a + b) * (b / front - a / rear)
    loose = CAR.with_own({**CAR.own, "C_rear": rear})
    found = gr.branches(loose, "speed", (5.0, 40.0), own("single_track"))
    assert marked(found, "branch_point") == pytest.approx(
        [np.sqrt(-(a + b) / gradient)] * 2, rel=1e-6
    )
    straight = found["r"][0]
    np.testing.assert_allclose(straight[np.isfinite(straight)], 0.0, atol=1e-9)


def test_turns_leave_the_straight_line_where_it_becomes_unstable() -> None:
    found = gr.branches(SOFT, "speed", ("5 m/s", "30 m/s"))
    critical = brentq(lambda u: np.linalg.det(gr.linearize(SOFT, speed=u).A), 10, 25, xtol=1e-12)
    assert marked(found, "branch_point") == pytest.approx([critical] * 2, rel=1e-6)
    assert not marked(found, "fold")
    speed, r = found["speed"][1], found["yaw_rate"][1]
    count = int(np.isfinite(speed).sum())
    for k in range(0, count, 7):  # a turn that has not been followed, but found by itself
        turns = gr.trim(SOFT, speed=speed[k])
        assert np.abs(turns["r"] - r[k]).min() < 1e-7
    assert r[0] * r[count - 1] < 0


def test_the_number_of_branches_is_that_of_equilibria_everywhere() -> None:
    found = gr.branches(SOFT, "disturbance", ("-60 N", "60 N"))
    over = found["disturbance"]
    for force in (-50.0, -3.0, 11.0, 19.0, 19.5):
        crossed = (over[:, 1:] - force) * (over[:, :-1] - force) < 0
        assert crossed.sum() == gr.trim(SOFT, disturbance=force).count


def test_a_fold_is_where_the_number_of_equilibria_changes() -> None:
    found = gr.branches(SOFT, "disturbance", ("-60 N", "60 N"))
    folds = sorted(marked(found, "fold"))
    assert folds == pytest.approx([-folds[1], folds[1]], rel=1e-6)
    inside, outside = (gr.trim(SOFT, disturbance=folds[1] * x).count for x in (1 - 1e-6, 1 + 1e-6))
    assert (int(inside), int(outside)) == (3, 1)


def test_an_isle_of_turns_is_closed() -> None:
    found = gr.branches(SOFT, "speed", ("5 m/s", "30 m/s"), disturbance="20 N")
    assert found.ends == (("range", "range"), ("closed", "closed"))
    assert len(marked(found, "fold")) == 2
    low, high = sorted(marked(found, "fold"))
    for speed, count in ((low - 0.01, 1), (low + 0.01, 3), (high - 0.01, 3), (high + 0.01, 1)):
        assert gr.trim(SOFT, speed=speed, disturbance="20 N").count == count


def test_a_lagging_tail_swings_from_a_hopf_point_on() -> None:
    model = own("lagging")
    plane = LAGGING.with_own({**LAGGING.own, "C_tail": 5e4})

    def growth(lag: float) -> float:
        eigenvalues = gr.linearize(plane, model, lag=lag).eigenvalues
        return float(max(x.real for x in eigenvalues if x.imag))

    found = gr.branches(plane, "lag", ("20 ms", "2 s"), model)
    lags = np.linspace(0.02, 2.0, 400)
    signs = np.sign([growth(lag) for lag in lags])
    expected = [
        brentq(growth, low, high, xtol=1e-12)
        for low, high, first, second in zip(lags, lags[1:], signs, signs[1:], strict=False)
        if first != second
    ]
    assert expected
    assert marked(found, "hopf") == pytest.approx(expected, rel=1e-6)


def test_a_wind_is_held_until_the_pedal_is_at_its_stop() -> None:
    asked = {"speed": "30 kt", "solve_for": ["pedal", "thrust"]}
    found = gr.branches(CESSNA, "crosswind", ("0 kt", "30 kt"), "landing_roll", **asked)
    assert found.ends == (("range", "pedal"),)
    last = int(np.isfinite(found["pedal"][0]).sum()) - 1
    assert found["pedal"][0, last] == pytest.approx(1.0, abs=1e-9)
    wind = float(found["crosswind"][0, last])
    assert gr.trim(CESSNA, "landing_roll", crosswind=wind * 0.999, **asked).count == 1
    beyond = gr.trim(CESSNA, "landing_roll", crosswind=wind * 1.001, **asked)
    assert "pedal would have to be" in beyond.reasons[0]
    lin = gr.linearize(CESSNA, "landing_roll", at=found.at(0, last))
    np.testing.assert_allclose(lin.drift, 0.0, atol=1e-7)


def test_nothing_of_a_branch_is_in_the_ground() -> None:
    found = gr.branches(CESSNA, "speed", ("5 kt", "55 kt"), "landing_roll")
    for s in ("height_left_tip", "height_right_tip", "height_propeller_tip"):
        assert np.nanmin(found[s]) > -1e-9
    assert np.isfinite(found["u"]).any(axis=1).all()
    # the turns leave the straight line backwards, and fold: there is one before it is unstable
    (critical, *_), folds = marked(found, "branch_point"), marked(found, "fold")
    assert min(folds) < critical


def test_its_picture_shows_the_marks() -> None:
    found = gr.branches(SOFT, "speed", ("5 m/s", "30 m/s"))
    ax = found.plot()
    assert ax.get_xlabel().startswith("speed")
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["branch point"]
    assert found.plot("v").get_ylabel().startswith("lateral velocity")
    mpl.pyplot.close("all")


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("sped", (1, 2)), "speed"),
        (("speed", (2, 1)), "smaller to a larger"),
        (("speed", 3.0), "must be a pair"),
        (("speed", (1, 2, 3)), "must be a pair"),
        (("speed", ("1 N", 2)), "N"),
    ],
)
def test_what_cannot_be_is_named(arguments: tuple[str, object], words: str) -> None:
    with pytest.raises(gr.GroundrollError, match=words):
        gr.branches(SOFT, *arguments)


def test_arrays_are_refused() -> None:
    with pytest.raises(gr.GroundrollError, match="one aircraft"):
        gr.branches(SOFT, "speed", (10, 20), disturbance=np.zeros((2, 1)))
