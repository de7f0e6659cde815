"""Stability maps: every point right, the thesis's figures as cuts, pictures that can be read."""

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib import pyplot
from oracles import PER_DEGREE

import groundroll as gr
from groundroll.stability.closed_forms import CLOSED_FORMS, OVER_SPEED
from groundroll.study.cases import case, trials_on


@pytest.fixture(autouse=True)
def _no_window():
    mpl.use("Agg")
    yield
    pyplot.close("all")


ARMS = np.linspace(-0.9, 1.3, 12)
SPEEDS = np.linspace(5.0, 60.0, 9)


def chart(of="decay_rate", number=17, x=("a", ARMS), y=("speed", SPEEDS)):
    return gr.stability_map(case(number, "linear").plane, x, y, of)


@pytest.mark.parametrize("of", [*CLOSED_FORMS, "lower_critical_speed", "weakest_speed"])
def test_each_point_is_that_of_its_aircraft(of):
    y = ("speed", SPEEDS) if of in CLOSED_FORMS else ("Ct", np.linspace(500.0, 9000.0, 9))
    if of in OVER_SPEED:
        y = ("Ct", np.linspace(500.0, 9000.0, 9))
    found = chart(of, y=y)
    assert found.values.shape == (9, 12)
    for i, j in ((0, 0), (3, 7), (8, 11)):
        plane = case(17, "linear").plane.replace(**{"a": ARMS[j], found.y_name: y[1][i]})
        margins, window = gr.margins(plane), gr.speed_window(plane)
        expected = {
            "lower_critical_speed": window.low,
            "weakest_speed": window.weakest,
        }.get(of)
        expected = getattr(margins, of) if expected is None else expected
        np.testing.assert_allclose(found.values[i, j], expected, rtol=1e-12)


def test_stability_is_that_of_numpys_eigenvalues():
    found = chart(number=19)
    lin = gr.linearize(found.aircraft, "linear")
    expected = (np.linalg.eigvals(lin.A).real < 0).all(axis=-1)
    np.testing.assert_array_equal(found.stable, expected)
    assert found.stable is found.stable  # whoever asks for every point asks once
    assert 0 < np.count_nonzero(expected) < expected.size


def test_a_map_of_every_speed_is_stable_where_there_is_no_window():
    found = chart("speed_margin", number=19, y=("Ct", np.linspace(0.0, 9000.0, 9)))
    window = gr.speed_window(found.aircraft)
    # behind the CG any stiffness will do; without one, stability is lost only at standstill
    np.testing.assert_array_equal(found.stable, np.isnan(window.low))


# --- The thesis's figures are cuts -----------------------------------------------------------


def cut(of, number, parameter, values, others):
    """One row of a map over a parameter and the main tires' stiffness."""
    plane = case(number, "linear").plane
    found = gr.stability_map(plane, (parameter, values), ("C_alpha", others), of)
    return found.values


@pytest.mark.parametrize(
    ("figure", "of"), [("4.21", "damped_frequency"), ("4.22", "damping_ratio")]
)
@pytest.mark.parametrize("forward", [True, False])
def test_figures_4_21_and_4_22_are_cuts_over_the_gear_position(figure, of, forward):
    """Through the printed eigenvalues of Table 4.6: Trials 5 to 12."""
    printed = {  # a, C_alpha (N/deg) -> eigenvalue, CG at 13.6 in and at 16.8 in
        True: {
            (-0.5, 220.815): -1.0135 + 3.2999j,
            (-0.5, 441.630): -1.6868 + 4.0996j,
            (0.0, 220.815): -0.9488 + 1.9998j,
            (0.0, 441.630): -1.5574 + 1.7867j,
        },
        False: {
            (-0.5, 220.815): -1.0014 + 3.2865j,
            (-0.5, 441.630): -1.6747 + 4.0877j,
            (0.0, 220.815): -0.9367 + 1.9763j,
            (0.0, 441.630): -1.5453 + 1.7562j,
        },
    }[forward]
    stiffness = np.array([220.815, 441.630])
    values = cut(of, 5 if forward else 7, "a", np.array([-0.5, 0.0]), stiffness * PER_DEGREE)
    for (arm, model), eigenvalue in printed.items():
        found = values[int(model > 300), int(arm == 0)]
        expected = (
            eigenvalue.imag if of == "damped_frequency" else -eigenvalue.real / abs(eigenvalue)
        )
        assert found == pytest.approx(expected, abs=3e-4), figure


@pytest.mark.parametrize(
    ("figure", "of"), [("4.27", "damped_frequency"), ("4.28", "damping_ratio")]
)
def test_figures_4_27_and_4_28_are_cuts_over_the_tail_wheel(figure, of):
    """Through the printed eigenvalues of Table 4.8: Trials 17 to 22."""
    printed = {
        (70.0, 220.815): -1.76 + 1.92j,
        (112.0, 220.815): -2.19 + 2.92j,
        (145.0, 220.815): -2.53 + 3.47j,
        (145.0, 441.630): -3.24 + 1.98j,
    }
    wheels, tires = np.array([70.0, 112.0, 145.0]), np.array([220.815, 441.630])
    values = cut(of, 17, "Ct", wheels * PER_DEGREE, tires * PER_DEGREE)
    for (wheel, model), eigenvalue in printed.items():
        found = values[int(model > 300), int(np.flatnonzero(wheels == wheel)[0])]
        expected = (
            eigenvalue.imag if of == "damped_frequency" else -eigenvalue.real / abs(eigenvalue)
        )
        assert found == pytest.approx(expected, abs=6e-3), figure
    if of == "damped_frequency":
        assert values[1, 0] == values[1, 1] == 0  # Trials 18 and 19: two real modes
    else:
        assert (values[1, :2] > 1).all()


def test_the_damped_frequencies_of_the_two_tires_cross_as_in_figure_4_21():
    """At a of about -0.06 m: the frequency in the figure is the damped one (see the errata)."""
    arms = np.linspace(-0.2, 0.0, 2001)
    half, full = cut("damped_frequency", 5, "a", arms, np.array([220.815, 441.630]) * PER_DEGREE)
    crossing = arms[np.flatnonzero(np.diff(np.sign(full - half)))]
    np.testing.assert_allclose(crossing, [-0.06], atol=0.01)


# --- Pictures --------------------------------------------------------------------------------


def boundary_of(ax):
    """Vertices of the heaviest contour line."""
    heaviest = max(ax.collections, key=lambda c: np.max(np.append(c.get_linewidths(), 0.0)))
    return np.concatenate([path.vertices for path in heaviest.get_paths() if len(path.vertices)])


def test_the_boundary_drawn_is_where_the_gear_limit_is():
    plane = case(17, "linear").plane
    found = gr.stability_map(
        plane, ("a", np.linspace(0.5, 1.6, 200)), ("speed", np.linspace(10.0, 60.0, 200))
    )
    vertices = boundary_of(found.plot())
    limit = gr.gear_limit(plane, speed=vertices[:, 1]).lost
    np.testing.assert_allclose(vertices[:, 0], limit, atol=2e-3)


def test_labels_have_units_and_the_legend_names_what_is_drawn():
    found = chart(number=19)
    ax = found.plot(
        units={"speed": "km/h"},
        marks=trials_on(found),
        ranges={"speed": (10.0, 30.0)},
        cg_range=True,
    )
    assert "(m)" in ax.get_xlabel()
    assert "(km/h)" in ax.get_ylabel()
    assert any("(1/s)" in axis.get_ylabel() for axis in ax.figure.axes)
    words = {text.get_text() for text in ax.get_legend().get_texts()}
    assert {"det A = 0", "unstable", "range of speed", "range of main gear arm"} <= words
    marked = {text.get_text() for text in ax.texts}
    assert "Trial 19" in marked
    assert "Trial 17" not in marked  # it has another tail wheel
    assert ax.get_ylim() == pytest.approx((18.0, 216.0))


def test_trials_that_differ_otherwise_are_hollow():
    found = chart(number=19)
    ax = found.plot(marks=trials_on(found, 9, 19))
    faces = {line.get_markerfacecolor() for line in ax.lines if line.get_marker() == "o"}
    assert len(faces) == 2
    words = [text.get_text() for text in ax.get_legend().get_texts()]
    assert "differs from the map in more than x and y" in words


def test_marks_at_one_place_share_a_label():
    plane = case(17, "linear").plane
    ax = chart().plot(marks={"one": plane, "two": plane})
    assert "one, two" in {text.get_text() for text in ax.texts}


def test_the_cg_range_is_that_of_the_stations():
    found = chart()
    (ends,) = found._cg_range().values()
    np.testing.assert_allclose(ends, [0.5994, 0.6807], atol=1e-4)  # 13.6 and 16.8 in, gear at -10


def test_nothing_is_drawn_outside_its_figure():
    found = chart(number=19)
    ax = found.plot(units={"speed": "km/h"}, marks=trials_on(found), cg_range=True)
    figure = ax.figure
    figure.canvas.draw()
    box = figure.bbox
    labels = [label for axis in figure.axes for label in (axis.xaxis.label, axis.yaxis.label)]
    for text in (*labels, *ax.texts, *ax.get_legend().get_texts()):
        extent = text.get_window_extent()
        assert extent.x0 >= box.x0 - 1, text
        assert extent.x1 <= box.x1 + 1, text
        assert extent.y0 >= box.y0 - 1, text
        assert extent.y1 <= box.y1 + 1, text


@pytest.mark.parametrize("of", ["damping_ratio", "static_margin", "time_to_half"])
def test_what_has_no_value_everywhere_is_drawn_all_the_same(of):
    assert chart(of, number=19).plot().figure is not None


# --- Bad input -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"of": "decayrate"}, "decay_rate"),
        ({"x": ("gear_arm", ARMS)}, "main_gear_arm"),
        ({"x": "a"}, "pair"),
        ({"x": ("a", [0.0, np.nan])}, "finite"),
        ({"x": ("a", [1.0, 0.0])}, "increasing"),
        ({"x": ("a", 1.0)}, "increasing"),
        ({"x": ("u", SPEEDS)}, "two parameters"),
        ({"y": ("speed", [-1.0, 1.0])}, "positive"),
        ({"of": "speed_margin"}, "does not depend on speed"),
    ],
)
def test_what_cannot_be_is_named(change, words):
    with pytest.raises(gr.GroundrollError, match=words):
        chart(**change)


def test_a_parameter_that_is_overruled_is_named():
    """With a and b given, the CG's station moves nothing: a map over it would be a lie."""
    plane = case(5, "linear").plane.replace(a=0.5, b=3.9)
    with pytest.raises(gr.GroundrollError, match="does not depend on cg_station"):
        gr.stability_map(plane, ("x_cg", [0.3, 0.4]), ("speed", SPEEDS))
    with pytest.raises(gr.GroundrollError, match="are arrays"):
        gr.stability_map(plane.replace(m=[700.0, 800.0]), ("a", ARMS), ("speed", SPEEDS))


def test_pictures_of_what_cannot_be_drawn():
    with pytest.raises(gr.GroundrollError, match="unknown trial 'Trial 99'"):
        trials_on(chart(), 99)
    with pytest.raises(gr.GroundrollError, match="cg_range"):
        chart(x=("Ct", np.linspace(1e3, 9e3, 5))).plot(cg_range=True)
    with pytest.raises(gr.GroundrollError, match="ranges"):
        chart().plot(ranges={"mass": (1.0, 2.0)})
    with pytest.raises(gr.GroundrollError, match="nothing to draw"):
        chart("lower_critical_speed", x=("a", [-0.9, -0.5]), y=("Ct", [1e3, 2e3])).plot()
