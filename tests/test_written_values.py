"""What a number with a unit may look like, wherever one is taken; the rest is refused by name.

The oracle of the units is a table of factors typed in from their definitions.
"""

from __future__ import annotations

import datetime
import math
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np
import pandas
import pint
import pytest
from hypothesis import given
from hypothesis import strategies as st

import groundroll as gr
from groundroll.base.arrays import finite
from groundroll.base.units import UnitError, parts, to_si
from groundroll.tires.data import TireData
from groundroll.tires.quality import compare

UREG = pint.UnitRegistry()
PLANE = gr.Aircraft.load("brott")

ANGLES = {
    **dict.fromkeys(("rad", "radian"), 1.0),
    **dict.fromkeys(("deg", "degree"), math.pi / 180),
    **dict.fromkeys(("grad", "gon", "gradian"), math.pi / 200),
    **dict.fromkeys(("turn", "revolution"), 2 * math.pi),
    "arcmin": math.pi / 180 / 60,
    "arcsec": math.pi / 180 / 3600,
    "mil": 2 * math.pi / 6400,
}
PREFIXES = {
    "": 0,
    "deca": 1,
    "hecto": 2,
    "kilo": 3,
    "mega": 6,
    "giga": 9,
    "tera": 12,
    "deci": -1,
    "centi": -2,
    "milli": -3,
    "micro": -6,
    "nano": -9,
    "pico": -12,
}
angles = pytest.mark.parametrize("angle", ANGLES)
prefixes = pytest.mark.parametrize("prefix", PREFIXES)


class TestAngles:
    """Pint takes them for pure numbers."""

    @angles
    @prefixes
    def test_as_an_angle(self, angle: str, prefix: str) -> None:
        right = ANGLES[angle] * 10.0 ** PREFIXES[prefix]
        assert to_si(f"3 {prefix}{angle}", "rad", "x") == pytest.approx(3 * right, rel=1e-14)

    @angles
    @prefixes
    def test_in_a_stiffness(self, angle: str, prefix: str) -> None:
        right = 1 / (ANGLES[angle] * 10.0 ** PREFIXES[prefix])
        assert to_si(f"2 N/{prefix}{angle}", "N/rad", "x") == pytest.approx(2 * right, rel=1e-14)

    @angles
    @prefixes
    def test_where_none_belongs(self, angle: str, prefix: str) -> None:
        for unit, text in (("N", "1 N*{}"), ("1", "1 {}"), ("N/rad", "1 N*{}"), ("N/rad", "1 N")):
            with pytest.raises(UnitError, match="expected"):
                to_si(text.format(prefix + angle), unit, "x")


@pytest.mark.parametrize("text", ["3 dB", "3 Np", "3 dBm", "3 octave", "3 degC", "3 degF"])
def test_what_has_a_zero_of_its_own_is_no_multiple(text: str) -> None:
    with pytest.raises(UnitError, match="no multiple of an SI unit"):
        to_si(text, "1", "x")
    with pytest.raises(UnitError, match="expected a stiffness"):
        to_si(f"3 N/{text[2:]}", "N/rad", "x")


@pytest.mark.parametrize(
    ("text", "unit", "right"),
    [
        ("17 ft 2 in", "m", 206 * 0.0254),
        ("-17 ft 2 in", "m", -206 * 0.0254),
        ("3 lb 4 oz", "kg", 3.25 * 0.45359237),
        ("12 deg 30 arcmin", "rad", math.radians(12.5)),
        ("1 slug ft2", "kg m^2", 14.5939029372 * 0.3048**2),
        ("1298 SLUG*FT2", "kg m^2", 1298 * 14.5939029372 * 0.3048**2),
        ("2 slug-ft²", "kg m^2", 2 * 14.5939029372 * 0.3048**2),
        ("2 KG*M2", "kg m^2", 2.0),
        ("3 FT2", "m^2", 3 * 0.3048**2),
        ("3 sq ft", "m^2", 3 * 0.3048**2),
        ("3 sq. ft", "m^2", 3 * 0.3048**2),
        ("3 IN", "m", 3 * 0.0254),
        ("3 LBS", "kg", 3 * 0.45359237),
        ("1000lbf", "N", 4448.2216152605),
        ("1 m s⁻²", "m/s^2", 1.0),
        ("2 m·s^(-2)", "m/s^2", 2.0),
        ("2 m per s", "m/s", 2.0),
        ("2 1/(deg N^2)", "1/(rad N^2)", math.degrees(2.0)),
        ("42 psi", "N/m^2", 42 * 4.4482216152605 / 0.0254**2),
        ("8 %", "1", 0.08),
        ("−3 m", "m", -3.0),
    ],
)
def test_notations(text: str, unit: str, right: float) -> None:
    assert to_si(text, unit, "x") == pytest.approx(right, rel=1e-12)
    number, last = parts(text)
    assert f"{number}{last}".replace(" ", "") == text.replace("−", "-").replace(" ", "")


@pytest.mark.parametrize(
    ("text", "unit", "words"),
    [
        ("17 ft 14 in", "m", "of which 14 in is too much"),
        ("2 in 1 ft", "m", "of which 1 ft is too much"),
        ("17 ft 2 kg", "m", "a mass; expected a length"),
        ("17 ft 2", "m", "unknown unit"),
        ("3 M", "m", "did you mean m?"),
        ("5 lb", "N", "as a force, lb is lbf"),
        ("30 kg", "m/s", "a mass; expected a speed"),
        ("1,5 m", "m", "with a comma"),
        ("1 _", "m", "unknown unit"),
        ("1 __class__", "m", "unknown unit"),
    ],
)
def test_what_does_not_fit_is_named(text: str, unit: str, words: str) -> None:
    with pytest.raises(UnitError) as caught:
        to_si(text, unit, "x")
    assert words in str(caught.value)


@pytest.mark.parametrize(
    "text",
    [
        *("1 kg^9^9^9^9", "2**2**2**2**2**2", "1 kg**(9**9)", "1 (((kg^9)^9)^9)^9", "1 9^9^9^9"),
        *("1 m^99999999", "1 m^1e9", "1 " + "(" * 5000, "9" * 5000 + "m" * 5000),
        "1" + " " * 3000 + "#",
        "1 " + "m*" * 3000 + "m",
    ],
)
def test_units_that_would_be_computed_for_ever_are_refused(text: str) -> None:
    with pytest.raises(UnitError) as caught:
        to_si(text, "kg", "x")
    assert len(str(caught.value)) < 400


@given(st.text(st.sampled_from("0129.eE+-*/^() mskgNftdBraionp%°²_,;µ\n\t#"), max_size=40))
def test_any_text_is_a_number_or_named(text: str) -> None:
    try:
        value = to_si(text, "m", "x")
    except UnitError:
        return
    assert isinstance(value, float)


class TestForeignNumbers:
    """Numbers of other libraries."""

    @pytest.mark.parametrize(
        ("value", "unit", "right"),
        [
            (100 * UREG.km / UREG.h, "m/s", 100 / 3.6),
            (np.array([90.0, 180.0]) * UREG.deg, "rad", [math.pi / 2, math.pi]),
            ([1 * UREG.ft, 2 * UREG.m, "3 in", 4], "m", [0.3048, 2.0, 0.0762, 4.0]),
            (5 * UREG.N / UREG.mrad, "N/rad", 5000.0),
            (np.array(["3 ft", "2"]), "m", [0.9144, 2.0]),
            (np.array([1, "2 ft"], dtype=object), "m", [1.0, 0.6096]),
            (pandas.Series([1, 2]), "m", [1.0, 2.0]),
            (Decimal("1.5"), "m", 1.5),
            (Fraction(1, 2), "m", 0.5),
            (np.float32(0.5), "m", 0.5),
            (range(3), "m", [0.0, 1.0, 2.0]),
            ([[1, 2], (3, 4)], "m", [[1.0, 2.0], [3.0, 4.0]]),
        ],
    )
    def test_that_are_read(self, value: Any, unit: str, right: Any) -> None:
        found = finite("x", value, unit)
        assert found.dtype == np.float64
        assert found == pytest.approx(np.asarray(right), rel=1e-14)

    def test_a_registry_of_the_users_own_is_heeded(self) -> None:
        own = pint.UnitRegistry()
        own.define("pace = 0.75 m")
        assert finite("x", 4 * own.pace, "m") == pytest.approx(3.0)

    @pytest.mark.parametrize(
        ("value", "words"),
        [
            (30 * UREG.kg, r"<Quantity\(30, 'kilogram'\)>, a mass; expected a speed"),
            (UREG.Quantity(3, "dB"), "no multiple"),
            (UREG.Quantity(np.ma.array([1.0], mask=[True]), "m/s"), "MaskedArray"),
            (np.ma.array([1.0, 2.0], mask=[False, True]), "MaskedArray"),
            ([np.ma.masked, 1.0], "MaskedConstant"),
            (np.timedelta64(3, "s"), "timedelta64"),
            (np.array([3], "m8[s]"), r"timedelta64\[s\]"),
            (np.datetime64("2026-01-01"), "datetime64"),
            ([datetime.timedelta(seconds=3)], "timedelta"),
            (pandas.Timedelta("3 s"), "Timedelta"),
            (1 + 2j, "complex"),
            (1 + 0j, "complex"),
            (np.array([1 + 0j]), "complex128"),
            (b"30", "bytes"),
            (bytearray(b"30"), "bytearray"),
            (np.array([b"30"]), "S2"),
            (True, "bool"),
            ([True, 30.0], "bool"),
            (np.array([1, True], dtype=object), "bool"),
            (np.array([True]), "bool array"),
            (None, "NoneType"),
            ({30.0}, "set"),
            ({}, "dict"),
            ([[1.0], [2.0, 3.0]], "list"),
            (10**400, "int"),
            pytest.param(10**5000, "int", id="5001 digits"),
            (iter([1.0]), "iterator"),
            (np.zeros(2, [("a", "f8")]), "array"),
        ],
    )
    def test_that_are_refused_by_name(self, value: Any, words: str) -> None:
        with pytest.raises(gr.GroundrollError, match=words):
            finite("x", value, "m/s")


def _roll(**given: Any) -> gr.Trajectory:
    return gr.simulate(gr.Aircraft.load("cessna-170"), "landing_roll", t=0.1, samples=3, **given)


CALLS: dict[str, Callable[[Any], object]] = {
    "replace": lambda x: PLANE.replace(speed=x),
    "simulate v0": lambda x: gr.simulate(PLANE, v0=x, t=0.1, samples=3),
    "simulate t": lambda x: gr.simulate(PLANE, v0=1.0, t=x, samples=3),
    "simulate disturbance": lambda x: gr.simulate(PLANE, disturbance=x, t=0.1, samples=3),
    "simulate step": lambda x: gr.simulate(PLANE, v0=1.0, t=0.1, samples=3, step=x),
    "ensemble r0": lambda x: gr.ensemble(PLANE, r0=x, t=0.1),
    "ensemble parameter": lambda x: gr.ensemble(PLANE, v0=1.0, mass=x, t=0.1),
    "linearize": lambda x: gr.linearize(PLANE, speed=x),
    "operating point": lambda x: gr.linearize(PLANE, at=gr.OperatingPoint(v=x)),
    "trim": lambda x: gr.trim(PLANE, disturbance=x),
    "map": lambda x: gr.stability_map(PLANE, ("speed", [5.0, x]), ("a", [0.1, 0.2])),
    "survival": lambda x: gr.survival(PLANE, station=x),
    "envelope": lambda x: gr.place_gear(PLANE, envelope=gr.Envelope(cg=[x])),
    "limits": lambda x: gr.Limits(decay_rate=x).bounds("taildragger"),
    "criterion": lambda x: gr.survival(PLANE, half_width=x),
    "gust": lambda x: gr.gusts.step(x),
    "gust times": lambda x: gr.gusts.sampled([0.0, x], [1.0, 2.0]),
    "wind": lambda x: gr.gusts.crosswind(PLANE, x),
    "input": lambda x: _roll(pedal=x),
    "input with a unit": lambda x: _roll(wind_y=x),
    "state": lambda x: _roll(v0=x),
    "load": lambda x: compare(TireData.load("goodyear-6.00-6"), {}, x),
}


@pytest.mark.parametrize("name", CALLS)
@pytest.mark.parametrize(
    "value",
    [True, b"3", 3 + 0j, np.timedelta64(3, "s"), np.ma.array([3.0]), 3 * UREG.tesla, "3 dB"],
    ids=lambda value: type(value).__name__,
)
def test_no_door_lets_a_foreign_value_through(name: str, value: Any) -> None:
    with pytest.raises(gr.GroundrollError):
        CALLS[name](value)
