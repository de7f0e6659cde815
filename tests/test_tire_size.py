"""Tires from size and pressure against NASA TR R-64 written out by hand, and a measured one.

The formulas are Smiley and Horne's; the measured tire is the thesis's 6.00-6 at 42 psi.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import groundroll as gr
from groundroll.model.evaluate import elementwise
from groundroll.stability.checking import check
from groundroll.tires.size import dimensions, surfaces, tire_size, tires

Array = np.ndarray[Any, np.dtype[np.float64]]

INCH, LBF = 0.0254, 4.4482216152605
PSI = LBF / INCH**2
THESIS = {
    "d_tire": 17.5 * INCH,
    "w_tire": 6.3 * INCH,
    "p_tire": 42 * PSI,
    "p_rated": 42 * PSI,
    "C_z": 0.03,
    "C_N": 63.0,
}
LOADS = np.array([400.0, 600.0, 800.0, 1000.0, 1200.0]) * LBF
MEASURED = np.array([67.9, 93.1, 102.1, 109.0, 109.9]) * LBF  # N/deg, Table 3.1 at 1 deg


def load_of(x: Array, d: Array, w: Array, p: Array, rated: Array, C_z: float) -> Array:
    """The report's load of a deflection x w."""
    curved = 0.96 * x + 0.216 * x**2 / C_z
    f = np.where(x <= 10 / 3 * C_z, curved, 2.4 * (x - C_z))
    return (p + 0.08 * rated) * w * np.sqrt(w * d) * f


def power_of(e: Array, w: Array, p: Array, rated: Array, C_N: float) -> Array:
    """The report's cornering power."""
    g = np.where(e <= 0.0875, 1.2 * e - 8.8 * e**2, 0.067375 - 0.34 * e)
    return C_N * (p + 0.44 * rated) * w**2 * g


def relaxation_of(e: Array) -> Array:
    middle = 64 * e - 500 * e**2 - 1.4045
    return np.where(e <= 0.053, 11 * e, np.where(e <= 0.068, middle, 0.9075 - 4 * e))


def computed(name: str, **arguments: Any) -> Array:
    values = {key: np.asarray(value, dtype=float) for key, value in arguments.items()}
    way = f"{name}_follows"
    if name == "B3":
        values["C3"] = elementwise("C3_follows", values)["C3"]
    return elementwise(way, values)[name]


def stiffness(loads: Array, **tire: Any) -> Array:
    B3, C3 = (computed(s, Fz=loads, **tire) for s in ("B3", "C3"))
    return (B3 + C3 * loads) * loads


class TestMeasured:
    def test_the_thesiss_tire_within_15_percent_at_each_load(self) -> None:
        ratio = MEASURED / (np.radians(1.0) * stiffness(LOADS, **THESIS))
        assert ratio == pytest.approx([0.90, 1.03, 1.01, 1.02, 1.02], abs=0.01)

    def test_so_it_is_with_the_other_constant(self) -> None:
        ratio = MEASURED / (np.radians(1.0) * stiffness(LOADS, **{**THESIS, "C_N": 57.0}))
        assert ratio == pytest.approx([1.00, 1.14, 1.12, 1.13, 1.13], abs=0.01)

    def test_deflections(self) -> None:
        found = computed("delta_tire", Fz=LOADS, **THESIS) / INCH
        assert found == pytest.approx([0.53, 0.71, 0.89, 1.06, 1.24], abs=0.005)

    def test_the_stiffness_has_a_maximum_over_load(self) -> None:
        loads = np.linspace(500.0, 9000.0, 2000)
        best = loads[stiffness(loads, **THESIS).argmax()]
        e = computed("delta_tire", Fz=best, **THESIS) / THESIS["d_tire"]
        assert e == pytest.approx(1.2 / 17.6, abs=2e-4)


@pytest.mark.parametrize(
    ("f", "at"),
    [
        (lambda x: load_of(x, 0.4, 0.15, 3e5, 3e5, 0.03), 10 / 3 * 0.03),
        (lambda e: power_of(e, 0.15, 3e5, 3e5, 57.0), 0.0875),
        (relaxation_of, 0.053),
        (relaxation_of, 0.068),
    ],
)
def test_the_pieces_of_the_report_join_with_value_and_slope(f: Any, at: float) -> None:
    """What says that the constants are remembered rightly."""
    h = 1e-6
    before, after = f(np.array(at - h)), f(np.array(at + h))
    slopes = [(f(np.array(at + s * h)) - f(np.array(at + s * 2 * h))) / h for s in (-1, 1)]
    assert after == pytest.approx(before, rel=1e-3)
    assert -slopes[0] == pytest.approx(slopes[1], rel=2e-2) or -slopes[1] == pytest.approx(
        slopes[0], rel=2e-2
    )


@st.composite
def tires_drawn(draw: st.DrawFn) -> dict[str, float]:
    width = draw(st.floats(0.05, 0.3))
    pressure = draw(st.floats(5e4, 1e6))
    return {
        "d_tire": width * draw(st.floats(2.0, 3.5)),
        "w_tire": width,
        "p_tire": pressure,
        "p_rated": pressure * draw(st.floats(0.7, 1.5)),
        "C_z": draw(st.sampled_from([0.02, 0.03])),
        "C_N": draw(st.floats(50.0, 70.0)),
    }


@given(tires_drawn(), st.floats(0.005, 0.4))
def test_against_the_report_by_hand(tire: dict[str, float], x: float) -> None:
    d, w, p, rated = (tire[s] for s in ("d_tire", "w_tire", "p_tire", "p_rated"))
    load = load_of(np.array(x), d, w, p, rated, tire["C_z"])
    e = x * w / d
    assert computed("delta_tire", Fz=load, **tire) == pytest.approx(x * w, rel=1e-12)
    assert stiffness(load, **tire) == pytest.approx(
        power_of(np.array(e), w, p, rated, tire["C_N"]), rel=1e-9, abs=1e-6
    )
    sigma = (2.8 - 0.8 * p / rated) * w * relaxation_of(np.array(e))
    assert computed("sigma", Fz=load, **tire) == pytest.approx(sigma, rel=1e-9)


@given(tires_drawn(), st.floats(0.005, 0.3))
def test_the_line_of_the_coefficient_is_a_tangent(tire: dict[str, float], x: float) -> None:
    d, w, p, rated = (tire[s] for s in ("d_tire", "w_tire", "p_tire", "p_rated"))
    load = load_of(np.array(x), d, w, p, rated, tire["C_z"])
    near = stiffness(load * (1 + np.array([-1e-5, 1e-5])), **tire)
    B3, C3 = (computed(s, Fz=load, **tire) for s in ("B3", "C3"))
    by_load = (near[1] - near[0]) / (2e-5 * load)
    assert B3 + 2 * C3 * load == pytest.approx(by_load, rel=1e-3, abs=1e-3 * B3)


class TestSizes:
    @pytest.mark.parametrize(
        ("text", "width", "diameter"),
        [
            ("6.00-6", 6.3, 17.5),
            ("6.00 x 6", 6.3, 17.5),
            ("600-6", 6.3, 17.5),
            ("600x6", 6.3, 17.5),
            ("6.00-6 6PR", 6.3, 17.5),
            ("5.00-5, 4-ply", 4.8, 13.9),
            ("8.00x4", 8.0, 4 + 2 * 0.92 * 8),
            ("8.00-4", 8.0, 4 + 2 * 0.92 * 8),
            ("8.50-10", 8.5, 10 + 2 * 0.92 * 8.5),
            ("15x6.00-6", 6.0, 15.0),
            ("15x600-6", 6.0, 15.0),
            ("26x10.5-6", 10.5, 26.0),
            ("H19.5x6.75-8", 6.75, 19.5),
            ("26x6.6R14", 6.6, 26.0),
            ("380/150", 150 / 25.4, 380 / 25.4),
            ("380x150-5", 150 / 25.4, 380 / 25.4),
            ("200x50", 50 / 25.4, 200 / 25.4),
            ("2.80/2.50-4", 2.8, 8.5),
            ("2.80x2.50-4", 2.8, 8.5),
            ("8x3.00", 3.0, 8.0),
        ],
    )
    def test_notations(self, text: str, width: float, diameter: float) -> None:
        found = dimensions(text)
        assert found[:2] == pytest.approx((width * INCH, diameter * INCH), rel=1e-12)
        assert found[2]

    @pytest.mark.parametrize(
        "text", ["", "6.00", "600", "abc", "6.00-60", "6-6-6-6", "-6", "6-6 m"]
    )
    def test_what_is_no_size_is_named(self, text: str) -> None:
        with pytest.raises(gr.GroundrollError, match="expected a size, such as"):
            tire_size(text)

    @given(st.text(st.sampled_from("0123456789.-x/ RPHply×"), max_size=14))
    def test_any_text_is_a_size_or_named(self, text: str) -> None:
        try:
            width, diameter, _ = dimensions(text)
        except gr.GroundrollError:
            return
        assert 0 < width < diameter < 40

    def test_every_size_of_the_table_is_read_as_itself(self) -> None:
        for row in tires()["size"]:
            assert dimensions(row["size"])[2] == row["source"]


FILE = """
title = "by size"
[airframe]
mass = "1650 lb"
yaw_inertia = "1298 slug ft2"
tail_area = "7.5 sq ft"
tail_lift_slope = "2.5 1/rad"
[stations]
cg_station = "15.2 in"
main_gear_station = "-10 in"
tail_station = "14 ft 0 in"
[main_tires]
size = "6.00-6"
pressure = "42 psi"
[tail_wheel]
size = "2.80x2.50-4"
pressure = "50 psi"
[runway]
speed = "100 km/h"
air_density = "1.225 kg/m^3"
gravity = "9.81 m/s^2"
"""


def written(folder: Path, text: str = FILE) -> gr.Aircraft:
    path = folder / "plane.toml"
    path.write_text(text, encoding="utf-8")
    return gr.Aircraft.load(path)


class TestFiles:
    def test_stiffness_follows_from_size_and_pressure(self, tmp_path: Path) -> None:
        plane = written(tmp_path)
        assert plane["C_alpha"] == pytest.approx(stiffness(plane["Fz"], **THESIS), rel=1e-9)
        tail = {"w": 2.8 * INCH, "p": 50 * PSI, "rated": 50 * PSI}
        x = np.linspace(0.01, 0.3, 200_000)
        loads = load_of(x, 8.5 * INCH, **tail, C_z=0.03)
        e = np.interp(plane["F_tail_load"], loads, x) * 2.8 / 8.5
        assert plane["Ct"] == pytest.approx(power_of(e, C_N=63.0, **tail), rel=1e-6)
        assert 0.1 < plane["relaxation_length"] < 0.4

    def test_linear_and_nonlinear_tires_agree(self, tmp_path: Path) -> None:
        plane = written(tmp_path)
        linear, nonlinear = (gr.linearize(plane, tire) for tire in ("linear", "nonlinear"))
        assert pytest.approx(nonlinear.A, rel=1e-12) == linear.A

    def test_all_of_it_is_an_estimate(self, tmp_path: Path) -> None:
        found = {k.symbol: k for k in check(written(tmp_path)).known}
        for s in ("d_tire", "w_tire", "C_N", "B5", "C1", "E1", "B3", "C_alpha", "Ct", "sigma"):
            assert found[s].source.estimate, s
        assert not found["p_tire"].source.estimate
        assert not found["Fz"].source.estimate
        assert "6.00-6" in found["d_tire"].source.text

    def test_what_is_said_counts_more(self, tmp_path: Path) -> None:
        more = 'size = "6.00-6"\nB5 = 0.71\ntire_width = "6 in"'
        plane = written(tmp_path, FILE.replace('size = "6.00-6"', more))
        assert plane["B5"] == 0.71
        assert plane["w_tire"] == pytest.approx(6 * INCH)
        assert not plane.sources["B5"].estimate

    def test_a_measured_table_counts_more(self, tmp_path: Path) -> None:
        more = 'size = "6.00-6"\ntable = "goodyear-6.00-6.csv"'
        plane = written(tmp_path, FILE.replace('size = "6.00-6"', more))
        assert {s: float(plane[s]) for s in ("B3", "E1")} == pytest.approx(
            {s: gr.fit_tire().parameters[s] for s in ("B3", "E1")}
        )
        assert plane["tire_deflection"] == pytest.approx(
            computed("delta_tire", Fz=plane["Fz"], **THESIS)
        )

    def test_a_softer_tire_is_less_stiff(self, tmp_path: Path) -> None:
        stiff = written(tmp_path)
        soft = stiff.replace(tire_pressure="24 psi")
        assert soft["C_alpha"] < 0.8 * stiff["C_alpha"]

    @pytest.mark.parametrize("surface", surfaces())
    def test_a_surface_scales_friction(self, tmp_path: Path, surface: str) -> None:
        dry = written(tmp_path)
        plane = written(tmp_path, FILE + f'surface = "{surface}"\n')
        ratio = surfaces()[surface]["friction"] / 0.8
        assert plane["B5"] == pytest.approx(ratio * dry["B5"])
        assert plane["B3"] == dry["B3"]
        low, high = surfaces()[surface]["range"]
        assert low <= surfaces()[surface]["friction"] <= high

    def test_a_surface_scales_the_friction_of_measured_tires_too(self, tmp_path: Path) -> None:
        measured = FILE.replace('size = "6.00-6"\npressure = "42 psi"', 'table = "goodyear-6.00-6"')
        dry, wet = (written(tmp_path, measured + more) for more in ("", 'surface = "wet"\n'))
        assert [wet[s] / dry[s] for s in ("B5", "C5")] == pytest.approx([0.5, 0.5])
        assert wet.sources["B5"].estimate

    @pytest.mark.parametrize(
        ("old", "new", "words"),
        [
            ('"6.00-6"', '"6.00"', r"main_tires\.size: found '6\.00'; expected a size"),
            ('"6.00-6"', "6", r"main_tires\.size: found 6; expected a size in quotes"),
            ('"42 psi"', '"42 kg"', r"main_tires\.pressure: .* a mass; expected a pressure"),
            ('"42 psi"', "-1", r"main_tires\.pressure: found -1; expected a positive number"),
            ("pressure = ", "presure = ", r"main_tires\.presure: .* expected pressure"),
            (
                "speed = ",
                'surface = "mud"\nspeed = ',
                r"runway\.surface: .* expected dry, wet",
            ),
        ],
    )
    def test_mistakes_are_named(self, tmp_path: Path, old: str, new: str, words: str) -> None:
        with pytest.raises(gr.GroundrollError, match=words):
            written(tmp_path, FILE.replace(old, new, 1))

    def test_without_a_pressure_that_is_what_is_missing(self, tmp_path: Path) -> None:
        plane = written(tmp_path, FILE.replace('pressure = "42 psi"\n', ""))
        with pytest.raises(gr.GroundrollError, match=r"tire_pressure \(p_tire\) is not given"):
            gr.linearize(plane)

    def test_a_load_beyond_the_tire_is_refused(self, tmp_path: Path) -> None:
        with pytest.raises(gr.GroundrollError, match=r"cornering_stiffness .* must be zero or pos"):
            gr.linearize(written(tmp_path).replace(mass="20000 lb"), "linear")
