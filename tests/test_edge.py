"""What a caller hands in: strings with units anywhere, and mistakes that are named."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from matplotlib import pyplot

import groundroll as gr


@pytest.mark.parametrize(
    ("call", "text", "si", "read"),
    [
        (lambda p, x: gr.simulate(p, v0=x, t=0.1, samples=3), "36 km/h", 10.0, lambda r: r["v"]),
        (lambda p, x: gr.simulate(p, v0=1.0, t=x, samples=3), "500 ms", 0.5, lambda r: r["v"]),
        (
            lambda p, x: gr.simulate(p, disturbance=x, t=0.1, samples=3),
            "0.3 kN",
            300.0,
            lambda r: r["v"],
        ),
        (lambda p, x: gr.ensemble(p, v0=[x, 0.1], t=0.1), "36 km/h", 10.0, lambda e: e["v"]),
        (
            lambda p, x: gr.ensemble(p, v0=1.0, t=0.1, limits={"psi": x}),
            "180 deg",
            np.pi,
            lambda e: e.limits["psi"],
        ),
        (lambda p, x: gr.linearize(p, disturbance=x), "1 kN", 1000.0, lambda lin: lin.drift),
        (
            lambda p, x: gr.linearize(p, at=gr.OperatingPoint(r=x)),
            "180 deg/s",
            np.pi,
            lambda lin: lin.A,
        ),
        (lambda p, x: gr.trim(p, disturbance=x), "1 kN", 1000.0, lambda t: t["v"]),
        (lambda p, x: gr.speed_window(p, speeds=(5.0, x)), "36 km/h", 10.0, lambda w: w.worst),
        (
            lambda p, x: gr.stability_map(p, ("speed", [5.0, x]), ("a", [0.1, 0.2])),
            "36 km/h",
            10.0,
            lambda m: m.x,
        ),
        (
            lambda p, x: gr.step_response(gr.linearize(p), "v", size=x),
            "1 kN",
            1e3,
            lambda s: s.size,
        ),
    ],
)
def test_whatever_has_a_unit_takes_it_as_a_string(
    call: Callable[[gr.Aircraft, Any], Any], text: str, si: float, read: Callable[[Any], Any]
) -> None:
    plane = gr.Aircraft.load("brott")
    assert np.array_equal(read(call(plane, text)), read(call(plane, si)))


def test_a_kick_takes_units() -> None:
    plane = gr.Aircraft.load("brott-physical")
    kick = gr.survival(plane, station="-1 ft", half_width="50 ft", heading="30 deg", t="10 s")
    same = gr.survival(plane, station=-0.3048, half_width=15.24, heading=np.radians(30), t=10.0)
    assert kick.impulse == pytest.approx(same.impulse, rel=1e-2)
    assert vars(kick.criterion) == pytest.approx(vars(same.criterion), rel=1e-14)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda p: gr.solver(t=[]), "increasing times"),
        (lambda p: gr.solver(names="psi"), "names must be a list of names, not 'psi'"),
        (lambda p: gr.gusts.of_time(3), "must be a function of an array of times"),
        (lambda p: gr.root_locus(p, "a", 3.0), "list that increases or decreases"),
        (lambda p: gr.step_response(gr.linearize(p), "v", t=[1, 2]), "t must be a positive number"),
        (lambda p: gr.sweep(p, v0=1.0), "unknown parameter 'v0' in sweep"),
        (
            lambda p: gr.simulate(gr.Aircraft.load("brott-physical").replace(a=-0.5)),
            r"tail_wheel_load .* must be zero or positive.* follows from .*"
            r"without nose_wheel_station \(x_nose\)",
        ),
    ],
)
def test_mistakes_are_named(call: Callable[[gr.Aircraft], Any], message: str) -> None:
    with pytest.raises(gr.GroundrollError, match=message):
        call(gr.Aircraft.load("brott"))


def test_a_bode_diagram_in_one_axes_is_refused() -> None:
    response = gr.frequency_response(gr.linearize(gr.Aircraft.load("brott")), "v")
    with pytest.raises(gr.GroundrollError, match="needs two axes, not 1"):
        response.plot(pyplot.figure().add_subplot())
    pyplot.close("all")
