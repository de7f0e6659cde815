"""The view from above: what is drawn stands where the aircraft is."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib import pyplot
from matplotlib.animation import FFMpegWriter
from matplotlib.axes import Axes
from matplotlib.patches import PathPatch, Rectangle
from matplotlib.quiver import Quiver
from own_models import FOUR, PLANES, own
from PIL import Image

import groundroll as gr
from groundroll.model.models import as_model

mpl.use("Agg")


@pytest.fixture(autouse=True)
def _close_figures() -> object:
    yield
    pyplot.close("all")


@pytest.fixture(scope="module")
def loop() -> gr.Trajectory:
    plane = gr.Aircraft.load("brott-physical").replace(speed="60 km/h", Ct=0)
    return gr.simulate(plane, disturbance=gr.gusts.step(-400.0, end=0.8), t=2.5, samples=251)


def airframes(axes: Axes) -> list[PathPatch]:
    return [patch for patch in axes.patches if isinstance(patch, PathPatch)]


def on_the_ground(axes: Axes, patch: PathPatch | Rectangle) -> np.ndarray:
    """Points of a patch in metres along and across."""
    vertices = patch.get_path().vertices
    return axes.transData.inverted().transform(patch.get_transform().transform(vertices))


def test_an_aircraft_stands_at_each_interval(loop: gr.Trajectory) -> None:
    axes = gr.runway_view(loop, every=0.5)
    assert len(airframes(axes)) == 6
    for k, patch in enumerate(airframes(axes)):
        at = 50 * k
        X, Y, psi = (loop[s][at] for s in ("X", "Y", "psi"))
        ahead = on_the_ground(axes, patch) - [X, Y]
        along = ahead @ [np.cos(psi), np.sin(psi)]
        across = ahead @ [-np.sin(psi), np.cos(psi)]
        b = loop.aircraft["b"]
        assert along.min() == pytest.approx(-1.07 * b, rel=1e-6)
        assert along.max() == pytest.approx(0.56 * b, rel=1e-6)
        assert across.max() == pytest.approx(-across.min(), rel=1e-6)


def test_wheels_stand_at_the_gear_and_at_the_tail(loop: gr.Trajectory) -> None:
    axes = gr.runway_view(loop, every=10.0)
    boxes = [p for p in axes.patches if isinstance(p, Rectangle) and p.get_zorder() >= 4]
    centres = [on_the_ground(axes, box)[:4].mean(axis=0) for box in boxes]
    a, b = float(loop.aircraft["a"]), float(loop.aircraft["b"])
    assert centres[1][0] == pytest.approx(a, abs=1e-6)
    assert centres[1] == pytest.approx(centres[2] * [1, -1], abs=1e-6)
    assert centres[3] == pytest.approx([-b, 0.0], abs=1e-6)


def test_right_is_below_and_the_scale_is_true(loop: gr.Trajectory) -> None:
    axes = gr.runway_view(loop)
    low, high = axes.get_ylim()
    assert low > high
    assert axes.get_aspect() == 1.0
    assert "(m)" in axes.get_xlabel()
    assert "(m)" in axes.get_ylabel()
    stretched = gr.runway_view(loop, stretch=4.0)
    assert stretched.get_aspect() == 4.0
    assert "× 4" in stretched.get_ylabel()


def test_the_exit_is_marked_where_the_path_crosses_the_edge(loop: gr.Trajectory) -> None:
    axes = gr.runway_view(loop, width=12.0)
    (cross,) = (line for line in axes.lines if line.get_marker() == "x")
    (X,), (Y,) = cross.get_data()
    assert abs(Y) == 6.0
    assert np.interp(X, loop["X"], loop["Y"]) == pytest.approx(Y, abs=1e-3)
    assert not [t for t in gr.runway_view(loop, width=90).texts if "off the" in t.get_text()]


def test_several_runs_share_a_runway(loop: gr.Trajectory) -> None:
    pair = gr.simulate(loop.aircraft.replace(a=np.array([-0.5, 0.6])), v0=0.1, t=1.0)
    axes = gr.runway_view([loop, pair], labels=["gust", "behind", "ahead"])
    labels = [text.get_text() for text in axes.get_legend().get_texts()]
    assert labels == ["gust", "behind", "ahead", "disturbance, at most 400 N"]
    own = gr.runway_view(pair).get_legend().get_texts()
    assert ["a = -0.5 m" in own[0].get_text(), "a = 0.6 m" in own[1].get_text()] == [True, True]


@pytest.mark.parametrize(
    ("name", "wheels"), [("single_track", 2), ("four_wheels", 4), ("lagging", 1)]
)
def test_wheels_and_forces_of_any_model_are_where_it_has_them(name: str, wheels: int) -> None:
    inputs = {
        "single_track": {},
        "four_wheels": {"u0": 20.0},
        "lagging": {"push": "300 N", "arm": 0.5},
    }[name]
    run = gr.simulate(PLANES[name], own(name), t=1.0, samples=21, **inputs)
    axes = gr.runway_view(run, every=10.0)
    tires = [p for p in axes.patches if isinstance(p, Rectangle) and p.get_zorder() >= 4]
    tires = tires[1:] if name == "lagging" else tires  # the propeller of what has a fin
    centres = [on_the_ground(axes, tire)[:4].mean(axis=0) for tire in tires]
    model = own(name)
    places = np.array(model.function("places")(0.0, 0.0, run.aircraft.parameters(model))[0])
    standing = [n for n, place in enumerate(model.places) if place.kind == "wheel"]
    stretch, enlarged = axes.get_aspect(), 1.0
    if "drawn ×" in axes.get_xlabel():
        enlarged = float(axes.get_xlabel().rpartition(" ")[2])
    np.testing.assert_allclose(centres, enlarged * places[standing, :2], atol=1e-6)
    assert (len(centres), stretch) == (wheels, 1.0)
    words = [text.get_text() for text in axes.get_legend().get_texts()]
    assert words[0] == f"{run.aircraft.name}, {name} model"
    assert words[1:] == (["pusher, at most 300 N"] if name == "lagging" else [])


def test_the_runways_unit_is_that_of_the_picture(loop: gr.Trajectory) -> None:
    metres, feet = gr.runway_view(loop, width=20.0), gr.runway_view(loop, width="60 ft")
    assert "(ft)" in feet.get_xlabel()
    assert "(ft)" in feet.get_ylabel()
    assert [line.get_ydata()[0] for line in feet.lines[:2]] == pytest.approx([-30.0, 30.0])
    path, same = (axes.lines[3].get_xydata() for axes in (metres, feet))
    np.testing.assert_allclose(same, path / 0.3048, rtol=1e-12)
    imperial = gr.runway_view(loop, units="imperial")
    assert "at most 89.9 lbf" in imperial.get_legend().get_texts()[1].get_text()
    assert gr.runway_view(loop, width="60 ft", units="si").get_xlabel().endswith("(m)")


def test_wind_and_events_of_a_landing_roll_are_marked() -> None:
    plane = gr.Aircraft.load("cessna-170")
    calm = gr.simulate(plane, "rollout", u0="30 kt", t=20.0, brake_left=0.3, brake_right=0.3)
    assert not [text for text in gr.runway_view(calm).texts if "wind" in text.get_text()]
    roll = gr.simulate(
        plane, "rollout", u0="30 kt", crosswind="8 kt", tailwind="-6 kt", t=20.0, until="ran_off"
    )
    axes = gr.runway_view(roll, units={"crosswind": "kt"}, width=200.0)
    words = [text.get_text() for text in axes.texts]
    assert "wind 10 kt" in words
    (when,) = (roll.events["ran_off"],)
    assert f"ran off after {float(when):.1f} s" in words
    (path,) = (line for line in axes.lines if len(line.get_xdata()) == np.isfinite(roll["X"]).sum())
    assert np.isfinite(path.get_xydata()).all()
    (arrow,) = (c for c in axes.collections if isinstance(c, Quiver))
    assert arrow.U[0] == pytest.approx(-0.6, abs=1e-6)  # against the roll
    assert arrow.V[0] == pytest.approx(-0.8, abs=1e-6)  # to the right, which is below


def test_a_long_roll_can_be_seen() -> None:
    plane = gr.Aircraft.load("brott-physical")
    axes = gr.runway_view(gr.simulate(plane, r0=0.01, t=30.0))
    assert axes.get_aspect() > 1
    assert "drawn ×" in axes.get_xlabel()
    assert len(airframes(axes)) <= 17
    clock = [text for text in axes.texts if text.get_text().endswith(" s")]
    places = [text.xy[0] for text in clock]
    assert np.diff(places).min() > 0.04 * np.ptp(axes.get_xlim())


def test_a_model_that_does_not_say_where_it_is(loop: gr.Trajectory, monkeypatch) -> None:
    model = dataclasses.replace(as_model("nonlinear"), roles={"heading": "psi"})
    monkeypatch.setattr("groundroll.view.rolls.as_model", lambda _: model)
    with pytest.raises(gr.GroundrollError, match="no distance and no offset"):
        gr.runway_view(loop)


def test_axes_of_ones_own_are_used(loop: gr.Trajectory) -> None:
    figure, axes = pyplot.subplots(figsize=(5.0, 4.0))
    assert gr.runway_view(loop, ax=axes) is axes
    assert figure.get_size_inches().tolist() == [5.0, 4.0]


def test_an_arrow_pushes_the_tail_the_way_of_the_force(loop: gr.Trajectory) -> None:
    axes = gr.runway_view(loop)
    arrows = [text for text in axes.texts if text.arrow_patch is not None]
    assert len(arrows) == 2  # at 0 and 0.5 s; over at 0.8 s
    tail, start = arrows[0].xy, arrows[0].xyann
    assert tail == pytest.approx([-float(loop.aircraft["b"]), 0.0])
    assert start[1] > 0.0  # a force to the left comes from the right, which is below


def test_a_film_has_a_picture_for_each_moment(loop: gr.Trajectory, tmp_path: Path) -> None:
    short = gr.simulate(FOUR, own("four_wheels"), u0=9.0, steering=0.1, t=0.5, samples=11)
    seen: list[int] = []
    path = gr.animate(
        short,
        tmp_path / "roll.gif",
        fps=5,
        slow_motion=2,
        dpi=40,
        progress=lambda k, n: seen.append(k),
    )
    assert path == tmp_path / "roll.gif"
    with Image.open(path) as film:
        assert film.n_frames == 6
    assert seen == [1, 2, 3, 4, 5, 6]
    assert [p.name for p in tmp_path.iterdir()] == ["roll.gif"]


@pytest.mark.skipif(not FFMpegWriter.isAvailable(), reason="ffmpeg is not there")
def test_a_film_for_a_video_player(loop: gr.Trajectory, tmp_path: Path) -> None:
    short = gr.simulate(loop.aircraft, v0=0.1, t=0.5, samples=11)
    path = gr.animate(short, tmp_path / "roll.mp4", fps=5, dpi=40)
    assert path.read_bytes()[4:8] == b"ftyp"


@pytest.mark.skipif(FFMpegWriter.isAvailable(), reason="ffmpeg is there")
def test_a_film_without_ffmpeg_says_so(loop: gr.Trajectory, tmp_path: Path) -> None:
    with pytest.raises(gr.GroundrollError, match=r"needs ffmpeg.*\.gif works"):
        gr.animate(loop, tmp_path / "roll.mp4")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"width": 0.0}, "width must be a positive number"),
        ({"every": -1.0}, "every must be a positive number"),
        ({"stretch": np.nan}, "stretch must be finite"),
        ({"labels": ["a", "b"]}, "1 runs but 2 labels"),
    ],
)
def test_bad_views_are_named(
    loop: gr.Trajectory, arguments: dict[str, object], message: str
) -> None:
    with pytest.raises(gr.GroundrollError, match=message):
        gr.runway_view(loop, **arguments)


def test_bad_films_are_named(loop: gr.Trajectory, tmp_path: Path) -> None:
    with pytest.raises(gr.GroundrollError, match=r"unknown suffix '.gfi'.*.gif"):
        gr.animate(loop, tmp_path / "roll.gfi")
    with pytest.raises(gr.GroundrollError, match="cannot write"):
        gr.animate(loop, tmp_path / "nowhere" / "roll.gif")
    with pytest.raises(gr.GroundrollError, match="nothing to draw"):
        gr.runway_view([])
