"""Plots of runs: units, labels, axes, and a style that stays where it is asked for."""

from __future__ import annotations

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

import groundroll as gr
from groundroll.model.names import QUANTITIES
from groundroll.model.shown import Units
from groundroll.view.plots import style, time_history


@pytest.fixture(scope="module")
def run() -> gr.Trajectory:
    return gr.simulate(gr.Aircraft.load("brott"), v0=0.1, t=2.0, samples=21)


def axes(count: int) -> list:
    return list(Figure().subplots(count, 1, squeeze=False)[:, 0])


def test_run_plot_draws_displacement_and_rotation(run, monkeypatch):
    monkeypatch.setattr("matplotlib.pyplot.subplots", lambda *a, **k: (None, np.array([axes(2)]).T))
    above, below = run.plot()
    assert above.get_ylabel() == "lateral displacement $y$ (m)"
    assert below.get_ylabel() == "rotation $\\theta$ (deg)"
    assert below.get_xlabel() == "time (s)"
    np.testing.assert_allclose(above.get_lines()[0].get_ydata(), run["y"])


def test_angles_are_in_degrees(run):
    (ax,) = axes(1)
    time_history(run, ["alpha"], ax)
    np.testing.assert_allclose(ax.get_lines()[0].get_ydata(), np.degrees(run["alpha"]))


@pytest.mark.parametrize(
    ("name", "label"),
    [
        ("r", "yaw rate $r$ (deg/s)"),
        ("a_y", "lateral acceleration $a_y$ (m/s²)"),
        ("alpha_bar", "normalised slip angle $\\bar{\\alpha}$"),
    ],
)
def test_labels_name_the_shown_unit(name, label):
    assert Units().label(QUANTITIES[name]) == label


def test_given_axes_are_used_and_returned(run):
    pair = axes(2)
    assert time_history(run, ("v", "yaw_rate"), pair) == tuple(pair)
    assert [len(ax.get_lines()) for ax in pair] == [1, 1]


def test_one_name_may_be_a_string(run):
    (ax,) = axes(1)
    time_history(run, "lateral_velocity", ax)
    assert ax.get_ylabel().startswith("lateral velocity")


@pytest.mark.parametrize(("count", "legend"), [(1, False), (3, True), (40, False)])
def test_many_runs_are_told_apart_while_they_can_be(count, legend):
    runs = gr.simulate(gr.Aircraft.load("brott"), v0=np.linspace(0.1, 0.2, count), t=0.5, samples=6)
    above, below = axes(2)
    time_history(runs, ("y", "theta"), (above, below))
    assert len(above.get_lines()) == count
    assert (above.get_legend() is not None) == legend
    looks = {(line.get_color(), str(line.get_linestyle())) for line in above.get_lines()[:6]}
    assert len(looks) == min(count, 6)


@pytest.mark.parametrize(
    ("names", "count", "message"),
    [
        (("y", "thta"), 2, "theta"),
        ((), 1, "names is empty"),
        (("y", "theta"), 1, "2 names to plot but 1 axes"),
    ],
)
def test_mistakes_are_named(run, names, count, message):
    with pytest.raises(gr.GroundrollError, match=message):
        time_history(run, names, axes(count))


def test_style_does_not_leak(run):
    before = dict(mpl.rcParams)
    with style():
        assert mpl.rcParams["axes.grid"]
    time_history(run, ("y",), axes(1))
    assert dict(mpl.rcParams) == before


def test_it_renders(run):
    above, _ = time_history(run, ("y", "theta"), axes(2))
    canvas = FigureCanvasAgg(above.figure)
    canvas.draw()
    assert np.asarray(canvas.buffer_rgba())[..., :3].min() < 255
