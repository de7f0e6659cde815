"""What results show of themselves: words that tell something, and more in a notebook."""

from __future__ import annotations

import base64
import dataclasses
import inspect
import io
from collections.abc import Callable
from html import escape
from typing import Any

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib import pyplot
from PIL import Image

import groundroll as gr
from groundroll.base.listing import span

mpl.use("Agg")

PLANE = gr.Aircraft.load("brott-physical")
SEVERAL = PLANE.replace(a=[0.2, 0.6], speed=[[20.0], [30.0], [40.0]])
CESSNA = gr.Aircraft.load("cessna-170")
ARMS, SPEEDS = ("a", np.linspace(0.2, 0.6, 9)), ("speed", np.linspace(10.0, 40.0, 9))

#: Public results and what is more in a notebook than words.
SHOWN: dict[str, tuple[Callable[[], Any], str]] = {
    "Aircraft": (lambda: PLANE, "<table"),
    "Basin": (lambda: gr.basin(PLANE, SPEEDS, ("v0", [0.0, 20.0])), "<img"),
    "Branches": (lambda: gr.branches(PLANE, "speed", (10.0, 40.0)), "<table"),
    "Clause": (lambda: gr.crosswind_clause(CESSNA), "<table"),
    "CrosswindLimit": (lambda: gr.crosswind_limit(CESSNA, speed=[4.0, 12.0]), "<table"),
    "Ensemble": (lambda: gr.ensemble(SEVERAL, 1.0, v0=0.1, limits={"y": 0.1}), "<table"),
    "FrequencyResponse": (lambda: gr.frequency_response(gr.linearize(SEVERAL), "r"), "<img"),
    "GearEnvelope": (lambda: gr.gear_envelope(SEVERAL), "<table"),
    "GearLimit": (lambda: gr.gear_limit(SEVERAL), "<table"),
    "Linearization": (lambda: gr.linearize(SEVERAL), "<table"),
    "Margins": (lambda: gr.margins(SEVERAL), "<table"),
    "Metrics": (lambda: gr.simulate(SEVERAL, v0=0.1, t=0.1).metrics(), "<table"),
    "PilotLimit": (lambda: gr.pilot_limit(CESSNA, speed=[4.0, 19.0]), "<table"),
    "Placement": (lambda: gr.place_gear(CESSNA), "<img"),
    "RootLocus": (lambda: gr.root_locus(PLANE, *SPEEDS), "<img"),
    "Sensitivities": (lambda: gr.linearize(SEVERAL).sensitivities(), "<table"),
    "SpeedWindow": (lambda: gr.speed_window(SEVERAL), "<table"),
    "StabilityMap": (lambda: gr.stability_map(PLANE, SPEEDS, ARMS), "<img"),
    "StepResponse": (lambda: gr.step_response(gr.linearize(SEVERAL), "r"), "<img"),
    "Survival": (lambda: gr.survival(SEVERAL), "<table"),
    "Sweep": (lambda: gr.sweep(SEVERAL), "<table"),
    "Trajectory": (lambda: gr.simulate(SEVERAL, v0=0.1, t=1.0), "<svg"),
    "Trim": (lambda: gr.trim(PLANE, disturbance=100.0), "<table"),
}
#: What says enough in words.
PLAIN = {"Check", "Envelope", "Limits", "Model", "OperatingPoint", "Result", "TireData"}


@pytest.mark.parametrize("name", SHOWN)
def test_a_result_tells_something(name: str):
    make, more = SHOWN[name]
    result = make()
    title, *lines = repr(result).splitlines()
    assert title.startswith(name)
    assert "array(" not in repr(result)
    assert lines or name in {"Basin", "StabilityMap"}
    assert all(line.startswith("  ") and line == line.rstrip() for line in lines)
    html = result._repr_html_()
    assert escape(title) in html
    assert more in html
    assert "<script" not in html
    assert pyplot.get_fignums() == []


def test_every_public_result_is_looked_at():
    classes = {name for name in gr.__all__ if inspect.isclass(getattr(gr, name))}
    errors = {name for name in classes if issubclass(getattr(gr, name), Exception)}
    assert classes == SHOWN.keys() | PLAIN | errors


def test_the_picture_is_that_of_plot():
    html = gr.step_response(gr.linearize(PLANE), "r")._repr_html_()
    data = base64.b64decode(html.partition("base64,")[2].partition('"')[0])
    with Image.open(io.BytesIO(data)) as image:
        assert image.format == "PNG"
        assert min(image.size) > 200


def test_where_nothing_can_be_drawn_there_are_words():
    nowhere = ("lower_critical_speed", ("a", [-0.9, -0.5]), ("Ct", [1e3, 2e3]))
    html = gr.stability_map(PLANE, *nowhere[1:], of=nowhere[0])._repr_html_()
    assert "StabilityMap of lower_critical_speed" in html
    assert "<img" not in html


def test_columns_stand_below_each_other():
    lines = repr(gr.margins(PLANE)).splitlines()
    starts = {line.index(text) for line, text in zip(lines[1:3], ("-5.799", "8.3716"), strict=True)}
    assert len(starts) == 1


def test_markup_is_words():
    html = dataclasses.replace(PLANE, title="<b> & more")._repr_html_()
    assert "&lt;b&gt; &amp; more" in html
    assert "<b>" not in html


@pytest.mark.parametrize(
    ("values", "expected"),
    [
        (2.0, "2"),
        (np.nan, "none"),
        (-np.inf, "-infinite"),
        ([1.0, 3.0], "1 to 3"),
        ([3.0, 3.0], "3"),
        ([1.0, np.nan, 3.0, np.inf], "1 to 3 (2 of 4 finite)"),
        ([np.nan, np.inf], "nowhere finite"),
    ],
)
def test_numbers_in_words(values: Any, expected: str):
    assert span(values) == expected
