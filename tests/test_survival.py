"""How hard a kick is survived: against plain simulations, and where theory knows the answer."""

from __future__ import annotations

from dataclasses import replace

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib import pyplot
from own_models import CAR, own

import groundroll as gr
from groundroll import cli
from groundroll.fates.fates import FATES, Criterion, fates
from groundroll.model.evaluate import elementwise
from groundroll.model.models import as_model

mpl.use("Agg")

PLANE = gr.Aircraft.load("brott-physical")
TAIL = -float(PLANE["b"])
#: Stiffness of the tail wheel in Trials 17 to 19.
TRIALS = {17: "145 N/deg", 18: "112 N/deg", 19: "70 N/deg"}


def test_a_kick_is_momentum_and_angular_momentum():
    changes = elementwise(
        "kick",
        {"S": np.array(300.0), "x_S": np.array(-4.0), "m": PLANE["m"], "Izz": PLANE["Izz"]},
    )
    assert float(changes["dv"]) == pytest.approx(300.0 / 748.43)
    assert float(changes["dr"]) == pytest.approx(-4.0 * 300.0 / 1760.0)


def judged(plane: gr.Aircraft, impulse: float, station: float, criterion: Criterion) -> str:
    """The fate of one kicked aircraft by a plain simulation, looked at every 0.1 ms."""
    v0, r0 = impulse / float(plane["m"]), station * impulse / float(plane["Izz"])
    run = gr.simulate(plane, t=criterion.t, samples=round(criterion.t * 10_000) + 1, v0=v0, r0=r0)
    moving = np.zeros(run.t.size, bool)
    for name in ("v", "r"):
        size = np.abs(run[name])
        moving |= size > criterion.settled * size.max()
    last = np.flatnonzero(moving)[-1]
    if (np.abs(run["psi"]) >= criterion.heading).any():
        return FATES[1]
    if (np.abs(run["Y"][: last + 1]) >= criterion.half_width).any():
        return FATES[2]
    return FATES[0] if last + 1 < run.t.size else FATES[3]


KICKED = {
    "at the CG": ("brott-physical", {"Ct": TRIALS[17]}, 0.0, 7.5),
    "at the tail": ("brott-physical", {"Ct": TRIALS[18]}, TAIL, 15.0),
    "unstable at last": ("brott-physical", {"Ct": TRIALS[19]}, TAIL, 15.0),
    "short of turning too far": ("brott-physical", {"u": 25.0}, 0.0, 25.0),
    "Cessna 170": ("cessna-170", {"u": 25.0}, 0.0, 7.5),
    "Cessna 170, fast": ("cessna-170", {"u": 35.0}, 0.0, 25.0),
    "Cessna 172": ("cessna-172p", {"u": 25.0}, 0.0, 25.0),
}


@pytest.mark.parametrize("kind", KICKED)
def test_the_threshold_is_where_a_plain_simulation_sees_it(kind: str):
    name, changes, station, half_width = KICKED[kind]
    plane = gr.Aircraft.load(name).replace(**changes)
    found = gr.survival(plane, station=station, half_width=half_width)
    assert 0 < found.impulse < np.inf
    below, above = float(found.impulse) * (1 - 5e-5), float(found.impulse) * 1.00105
    assert judged(plane, below, station, found.criterion) == FATES[0]
    assert judged(plane, above, station, found.criterion) == FATES[int(found.fate)] != FATES[0]
    assert float(found.velocity_change) == pytest.approx(float(found.impulse / plane["m"]))


def test_what_turns_too_far_after_it_has_left_the_runway_is_computed():
    """It straightens out, leaves the runway, and then turns past the limit."""
    plane = PLANE.replace(u=15.433)
    speeds = np.linspace(14.3, 14.6, 31)
    fate, when = fates(plane, speeds, 0.0, Criterion())
    mass = float(plane["m"])
    assert [FATES[k] for k in fate] == [judged(plane, mass * v, 0.0, Criterion()) for v in speeds]
    assert set(fate.tolist()) == {0, 1}
    assert (np.isnan(when) == (fate != 0)).all()


def test_every_kick_of_a_range_of_speeds_is_computed(capsys: pytest.CaptureFixture[str]):
    line = ["survival", "brott-physical", "--speed", "20 kt:55 kt", "--no-plot"]
    assert cli.main(line) == 0  # and NumPy warns of nothing
    said = capsys.readouterr()
    assert "leaves the runway" in said.out
    assert "not computed" not in said.out
    assert "Warning" not in said.err


def test_right_and_left_are_the_same():
    v, r = np.linspace(-10, 10, 21)[:, None], np.linspace(-3, 3, 21)
    fate, when = fates(PLANE, v, r, Criterion())
    assert (fate == fate[::-1, ::-1]).all()
    assert when == pytest.approx(when[::-1, ::-1], rel=1e-6, nan_ok=True)


def test_rest_straightens_out_at_once():
    fate, when = fates(PLANE, 0.0, 0.0, Criterion())
    assert (FATES[int(fate)], float(when)) == ("stays on the runway", 0.0)


def test_what_is_unstable_survives_nothing():
    unstable = PLANE.replace(Ct=0.0, a=1.0, b=3.5)
    found = gr.survival(unstable)
    assert found.decay_rate < 0
    assert found.impulse == 0
    assert FATES[int(found.fate)] != FATES[0]


def test_a_wider_runway_is_never_worse():
    widths = (5.0, 7.5, 10.0, 15.0)
    plane = PLANE.replace(Ct=np.array([8307.888, 6417.127, 4010.705]))
    found = np.stack([gr.survival(plane, half_width=w).impulse for w in widths])
    assert (np.diff(found, axis=0) >= -2e-3 * found[:-1]).all()


def test_the_eigenvalue_ranks_the_trials_but_not_by_how_much():
    """Trials 17 to 19 with the right tire: an eigth of the decay rate, a fiftieth of the kick."""
    plane = PLANE.replace(Ct=np.array([8307.888, 6417.127, 4010.705]))
    found = gr.survival(plane, station=-plane["b"])
    assert (np.diff(found.decay_rate) < 0).all()
    assert (np.diff(found.impulse) < 0).all()
    assert found.decay_rate[0] / found.decay_rate[2] == pytest.approx(8.07, abs=0.05)
    assert found.impulse[0] / found.impulse[2] == pytest.approx(53.4, abs=1.0)
    assert [FATES[k] for k in found.fate] == [*["turns too far"] * 2, "leaves the runway"]
    assert np.isnan(found.island).tolist() == [True, True, False]


def test_shapes_broadcast_and_the_largest_tried_is_said():
    stations = np.linspace(-4.0, 1.0, 3)[:, None]
    found = gr.survival(PLANE, station=stations, speed=np.array([20.0, 30.0]), largest=50.0)
    assert found.impulse.shape == found.fate.shape == found.decay_rate.shape == (3, 2)
    assert (found.fate == 0).all()
    assert (found.impulse == 50.0).all()
    assert "6 cases" in repr(found)
    assert " N s  at 0 m  27.778 m/s " in repr(gr.survival(PLANE))


@pytest.fixture(scope="module")
def basin() -> gr.Basin:
    plane = PLANE.replace(Ct=TRIALS[19])
    return gr.basin(plane, ("v0", np.linspace(-8, 8, 33)), ("r0", np.linspace(-3, 3, 25)))


def test_a_basin_is_fates_over_a_grid(basin: gr.Basin):
    assert basin.fate.shape == (25, 33)
    assert 0.2 < basin.share < 0.9
    one, _ = fates(basin.aircraft, basin.x[4], basin.y[20], basin.criterion)
    assert one == basin.fate[20, 4]
    assert "stays on the runway" in repr(basin)


def test_a_basin_over_speed_and_impulse_meets_the_threshold():
    plane = PLANE.replace(Ct=TRIALS[18])
    speeds = np.array([20.0, 30.0, 40.0])
    found = gr.survival(plane, station=TAIL, speed=speeds)
    impulses = np.linspace(0.9, 1.1, 11) * 1900.0
    chart = gr.basin(plane, ("speed", speeds), ("impulse", impulses), station=TAIL)
    assert ((chart.fate == 0) == (impulses[:, None] <= found.impulse)).all()


def test_a_basin_is_drawn_with_units_and_a_legend(basin: gr.Basin):
    axes = basin.plot()
    assert axes.get_xlabel() == "initial lateral velocity $v$ (m/s)"
    assert axes.get_ylabel() == "initial yaw rate $r$ (deg/s)"
    labels = [text.get_text() for text in axes.get_legend().get_texts()]
    assert labels[0] == "stays on the runway"
    assert axes.get_ylim()[1] > 170
    _, own = pyplot.subplots()
    assert basin.plot(own) is own
    pyplot.close("all")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"half_width": 0.0}, "half_width must be a positive number"),
        ({"heading": np.nan}, "heading must be finite"),
        ({"settled": 1.0}, "settled must be below 1"),
        ({"t": -1.0}, "t must be a positive number"),
        ({"largest": -5.0}, "largest must be positive"),
        ({"station": np.inf}, "station must be finite"),
        ({"station": [1.0, 2.0], "speed": [10.0, 20.0, 30.0]}, "do not broadcast"),
    ],
)
def test_mistakes_are_named(arguments: dict[str, object], message: str):
    with pytest.raises(gr.GroundrollError, match=message):
        gr.survival(PLANE, **arguments)


def test_a_tire_that_reverses_is_refused():
    with pytest.raises(gr.GroundrollError, match=r"reverses its force .* brott-physical"):
        gr.survival(gr.Aircraft.load("brott"))


@pytest.mark.parametrize(
    ("x", "y", "message"),
    [
        (("v", [0, 1]), ("r0", [0, 1]), "unknown axis 'v'"),
        (("v0", [0, 1]), ("v0", [0, 1]), "x and y are the same"),
        (("v0", [1, 0]), ("r0", [0, 1]), "increasing values"),
        (("v0",), ("r0", [0, 1]), "pair"),
    ],
)
def test_mistakes_of_a_basin_are_named(x: object, y: object, message: str):
    with pytest.raises(gr.GroundrollError, match=message):
        gr.basin(PLANE, x, y)
    with pytest.raises(gr.GroundrollError, match="of one aircraft"):
        gr.basin(PLANE.replace(a=[0.1, 0.2]), ("v0", [0, 1]), ("r0", [0, 1]))


# --- Every model ----------------------------------------------------------------------------

CESSNA = gr.Aircraft.load("cessna-170")
BRAKED = {"brake_left": 0.3, "brake_right": 0.3, "speed": 20.0}


def rolled(impulse: float, criterion: Criterion) -> str:
    """The fate of one roll to a stop, by a plain simulation that is looked at every 2 ms."""
    v0 = impulse / float(CESSNA["m"])
    run = gr.simulate(CESSNA, "rollout", t=60.0, samples=30_001, v0=v0, until="stopped", **BRAKED)
    over = run.t <= run.events["stopped"]
    turns = np.abs(run["psi"][over]) >= criterion.heading
    leaves = np.abs(run["Y"][over]) >= criterion.half_width
    first = {FATES[1]: turns.argmax() if turns.any() else np.inf}
    first[FATES[2]] = leaves.argmax() if leaves.any() else np.inf
    if min(first.values()) < np.inf:
        return min(first, key=lambda fate: first[fate])
    assert np.isfinite(run.events["stopped"])
    return FATES[0]


def test_where_the_speed_falls_it_stays_on_the_runway_until_it_has_stopped():
    found = gr.survival(CESSNA, "rollout", **BRAKED)
    assert found.impulse > 0
    assert rolled(0.999 * float(found.impulse), found.criterion) == FATES[0]
    beyond = rolled(1.0012 * float(found.impulse), found.criterion)
    assert beyond == FATES[int(found.fate)] != FATES[0]


def test_a_crosswind_takes_from_what_is_survived():
    calm, windy = (
        float(gr.survival(CESSNA, "rollout", crosswind=wind, **BRAKED).impulse)
        for wind in ("0 m/s", "1 m/s")
    )
    assert windy < calm


def test_arrays_of_inputs_are_cases():
    winds = np.array([0.0, 0.5])
    both = gr.survival(CESSNA, "rollout", crosswind=winds, **BRAKED)
    each = [gr.survival(CESSNA, "rollout", crosswind=w, **BRAKED).impulse for w in winds]
    np.testing.assert_allclose(both.impulse, each, rtol=1e-3)


def test_a_result_of_another_model_comes_back(tmp_path):
    found = gr.survival(CESSNA, "rollout", crosswind=0.5, **BRAKED)
    again = gr.Survival.load(found.save(tmp_path / "kept.npz"))
    assert repr(again) == repr(found)
    assert (again.model, again.inputs["wind_y"]) == ("rollout", 0.5)
    basin = gr.basin(CESSNA, ("speed", [10.0, 15.0]), ("impulse", [0.0, 500.0]), "rollout")
    assert repr(gr.Basin.load(basin.save(tmp_path / "basin.nc"))) == repr(basin)
    assert "rollout model" in basin.plot().get_legend().get_title().get_text()
    pyplot.close("all")


def test_a_model_of_ones_own():
    """A car that understeers straightens out whatever the kick, as far as its path allows."""
    found = gr.survival(CAR, own("single_track"), half_width=50.0, speed=15.0, steering=0.0)
    assert found.impulse > 0
    with pytest.raises(gr.GroundrollError, match="cannot be given v0"):
        gr.survival(CAR, own("single_track"), v0=1.0)


def test_a_model_without_a_heading_says_so():
    blind = replace(as_model("rollout"), roles={"speed": "u", "offset": "Y"})
    with pytest.raises(gr.GroundrollError, match="needs lateral velocity and yaw rate and heading"):
        gr.survival(CESSNA, blind)
