"""The tire fit on data as people have them, against right answers and against SciPy."""

from __future__ import annotations

import copy
import pickle
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.optimize import least_squares

import groundroll as gr
from groundroll.model.evaluate import elementwise
from groundroll.tires.data import TireData
from groundroll.tires.fit import PARAMETERS, TireFit, fit_tire
from groundroll.tires.quality import compare, force_rms, slope_at_zero

Array = np.ndarray[Any, np.dtype[np.float64]]

CASES = Path(__file__).parent / "data" / "tires"
GOODYEAR = fit_tire("goodyear-6.00-6")
#: The formula behind most of the cases: slope at zero over load, 1/rad, and friction.
SLOPE, FRICTION = 0.75 * 1.3 * 0.14 * 180 / np.pi, 0.75


def coefficients(fit: TireFit, load: float) -> tuple[float, float]:
    """Cornering coefficient and friction at a load."""
    p = fit.parameters
    return p["B3"] + p["C3"] * load, p["B5"] + p["C5"] * load


def force(parameters: Any, alpha: Any, Fz: Any) -> Array:
    values = {s: np.asarray(parameters[s]) for s in PARAMETERS}
    return elementwise("tire_force", {**values, "alpha": np.asarray(alpha), "Fz": np.asarray(Fz)})[
        "F_y"
    ]


class TestCases:
    """Each file with its right answer."""

    @pytest.mark.parametrize(
        "name",
        ["clean", "offset", "both_signs", "load_in_kN", "no_one_degree", "long", "one_load"],
    )
    def test_slope_and_friction(self, name: str) -> None:
        fit = fit_tire(CASES / f"{name}.csv")
        loads = [2000.0] if name == "one_load" else [1000.0, 2000.0, 3000.0]
        assert fit.parameters["Fz_low"] == loads[0]
        assert fit.parameters["Fz_high"] == loads[-1]
        for load in loads:
            slope, friction = coefficients(fit, load)
            assert slope == pytest.approx(SLOPE, rel=2e-3)
            assert friction == pytest.approx(FRICTION, rel=2e-3)
        assert fit.rms < 1e-3

    def test_an_offset_is_found_and_told(self) -> None:
        fit = fit_tire(CASES / "offset.csv")
        assert list(fit.offsets) == [1000.0, 2000.0, 3000.0]
        assert list(fit.offsets.values()) == pytest.approx([50.0] * 3, abs=0.5)
        assert any("offset of 49.9 to 49.7 N at zero slip" in note for note in fit.notes)

    def test_halves_are_compared(self) -> None:
        told = "forces to the left and to the right differ by 0.0 % of the friction force"
        assert any(told in note for note in fit_tire(CASES / "both_signs.csv").notes)
        assert not any("differ" in note for note in fit_tire(CASES / "clean.csv").notes)

    def test_halves_that_differ_are_told(self) -> None:
        data = TireData.load(CASES / "both_signs.csv")
        lopsided = np.where(data.slip_angles < 0, 0.9, 1.0) * data.forces
        fit = fit_tire(TireData("lopsided", data.slip_angles, data.loads, lopsided))
        (note,) = [note for note in fit.notes if "differ" in note]
        assert 2 < float(note.split("differ by ")[1].split(" %")[0]) < 10

    def test_forces_in_another_unit_than_loads_are_told(self) -> None:
        (note,) = fit_tire(CASES / "load_in_kN.csv").notes
        assert "read in N: in kN, as the loads are, they would be 746 times the loads" in note

    def test_one_load_says_nothing_of_others(self) -> None:
        fit = fit_tire(CASES / "one_load.csv")
        assert (fit.parameters["C3"], fit.parameters["C5"]) == (0.0, 0.0)
        assert any("changes with load is unknown" in note for note in fit.notes)

    def test_a_tire_that_still_rises(self) -> None:
        fit = fit_tire(CASES / "still_rising.csv")
        assert fit.force_rms < 0.01 * 1230
        (note,) = fit.notes
        assert "the largest friction, 0.842 to 0.803 at 1000 to 2000 N of load, is extrapol" in note
        assert "at 10 deg, where the data end" in note
        assert 0.7 < coefficients(fit, 1500.0)[1] < 1.0


class TestPackaged:
    """The thesis's tire."""

    @pytest.mark.parametrize("curve", GOODYEAR.data.curves, ids=lambda c: f"{c.load:g} N")
    def test_the_slope_at_zero_is_not_below_the_secant(self, curve: Any) -> None:
        slope = slope_at_zero(GOODYEAR.parameters, curve.load)
        assert slope >= curve.forces[0] / curve.slip_angles[0] * (1 - 1e-6)
        assert slope <= 1.06 * curve.forces[0] / curve.slip_angles[0]

    def test_known_values(self) -> None:
        known = {"B3": 12.526, "C3": -1.3633e-3, "B5": 0.76163, "C5": -3.81e-6}
        known |= {"B1": 1.0, "C1": 1.0, "D1": 1.0, "E1": 0.5689}
        for s, value in known.items():
            assert GOODYEAR.parameters[s] == pytest.approx(value, rel=1e-3), s

    def test_the_data_of_tires_that_nobody_measured(self) -> None:
        from groundroll.tires.size import tires

        for s, entry in tires()["curve"].items():
            if s != "C5":
                assert entry["value"] == pytest.approx(GOODYEAR.parameters[s], abs=5e-4), s

    def test_error(self) -> None:
        assert GOODYEAR.force_rms == pytest.approx(44.2, abs=0.1)
        assert GOODYEAR.force_rms == pytest.approx(
            force_rms(GOODYEAR.data, GOODYEAR.parameters), rel=1e-9
        )
        assert GOODYEAR.rms < 0.015

    def test_it_never_reverses(self) -> None:
        q = compare(GOODYEAR.data, {"fit": GOODYEAR.parameters})["fit"]
        assert np.isnan(q.reversal)
        assert q.sideways_share == pytest.approx(1.0)
        assert q.slope == pytest.approx(slope_at_zero(GOODYEAR.parameters, 3559.0))

    def test_linear_and_nonlinear_models_agree(self) -> None:
        plane = gr.Aircraft.load("brott-physical").replace(C_alpha=None, **GOODYEAR.parameters)
        linear, nonlinear = (gr.linearize(plane, model) for model in ("linear", "nonlinear"))
        assert pytest.approx(nonlinear.A, rel=1e-12) == linear.A

    def test_what_was_measured_goes_along(self) -> None:
        plane = gr.Aircraft.load("cessna-170")
        assert [float(plane[s]) for s in ("Fz_low", "Fz_high")] == [1779.0, 5338.0]
        assert np.degrees(plane["alpha_high"]) == pytest.approx(20.0)


@st.composite
def measured(draw: st.DrawFn, shapes: Any = None) -> TireData:
    """Forces of tires with any degressive curve, with noise."""
    curves = {
        "exponential": lambda x: 1 - np.exp(-x),
        "hyperbolic": np.tanh,
        "magic": lambda x: np.sin(1.4 * np.arctan(x / 1.4)),
        "arctangent": lambda x: np.arctan(x * np.pi / 2) / (np.pi / 2),
        "straight": lambda x: x,
    }
    shape = curves[draw(st.sampled_from(shapes or sorted(curves)))]
    friction, slope = draw(st.floats(0.2, 1.2)), draw(st.floats(2.0, 20.0))
    top = draw(st.sampled_from([6, 10, 15, 25]))
    degrees = np.unique(np.round(np.linspace(draw(st.sampled_from([0.5, 1, 2])), top, 9), 1))
    loads = draw(st.floats(200.0, 5000.0)) * np.array([1.0, 1.6, 2.4])[: draw(st.integers(1, 3))]
    alpha = np.radians(degrees)[:, None]
    falls = 1 - draw(st.floats(0.0, 0.15)) * (loads / loads[0] - 1)
    forces = friction * loads * shape(slope * falls * alpha / friction)
    assume(np.abs(forces / loads).max() < 3)
    seed, noise = draw(st.integers(0, 1000)), draw(st.sampled_from([0.0, 0.002, 0.01]))
    rough = np.random.default_rng(seed).normal(0.0, noise * friction, forces.shape)
    return TireData("drawn", alpha[:, 0], loads, forces + rough * loads)


class TestAnyTire:
    @settings(max_examples=60)
    @given(measured())
    def test_a_fit_always_answers(self, data: TireData) -> None:
        fit = fit_tire(data)
        p = fit.parameters
        assert 1 <= p["C1"] <= 2
        assert p["E1"] <= 1
        assert p["B1"] * p["C1"] * p["D1"] == pytest.approx(1.0)
        for load in (p["Fz_low"], p["Fz_high"]):
            slope, friction = coefficients(fit, load)
            assert 0 < slope < 60
            assert 0 < friction < 5
        # shapes that are no magic formula: the worst draw comes to 6.2 %
        assert fit.force_rms < 0.08 * np.abs(data.forces).max()

    @settings(max_examples=60)
    @given(measured(["exponential", "hyperbolic", "magic", "arctangent"]))
    def test_the_slope_is_never_below_the_secant(self, data: TireData) -> None:
        fit = fit_tire(data)
        for curve in data.curves:
            secants = curve.forces / curve.slip_angles
            if secants[0] > secants[1] > secants[2]:
                slope = slope_at_zero(fit.parameters, curve.load)
                few = np.abs(curve.forces) < 0.2 * np.abs(curve.forces).max()
                few[0] = True
                assert slope >= min(secants[few]) * (1 - 1e-5)

    @settings(max_examples=20)
    @given(st.floats(8.0, 14.0), st.floats(0.5, 1.0), st.floats(1.1, 1.6), st.floats(-1.0, 0.5))
    def test_a_tire_of_the_formula_is_recovered(
        self, slope: float, friction: float, C: float, E: float
    ) -> None:
        true = {"B3": slope, "C3": -1e-4 * slope, "B5": friction, "C5": -2e-5 * friction}
        true |= {"B1": 1 / C, "C1": C, "D1": 1.0, "E1": E}
        alpha, loads = np.radians(np.arange(1.0, 26.0)), np.array([1500.0, 2500.0, 3500.0])
        forces = force(true, alpha[:, None], loads)
        fit = fit_tire(TireData("known", alpha, loads, forces))
        assert fit.rms < 2e-3
        for load in loads:
            assert coefficients(fit, load)[0] == pytest.approx(slope * (1 - 1e-4 * load), rel=0.01)
            assert coefficients(fit, load)[1] == pytest.approx(
                friction * (1 - 2e-5 * load), rel=0.02
            )

    def test_against_scipy(self) -> None:
        """The same least squares, written apart from ours and solved by SciPy."""
        data = TireData.load(CASES / "clean.csv")
        alpha, Fz, F = data.slip_angles, data.loads, data.forces
        largest = np.abs(F / Fz).max()
        secant = np.mean([c.forces[0] / c.slip_angles[0] / c.load for c in data.curves])

        def errors(x: Array) -> Array:
            c0, c1, m0, m1, C, E = x
            share = (Fz - 1000.0) / 2000.0
            c, m = secant * (c0 + (c1 - c0) * share), largest * (m0 + (m1 - m0) * share)
            t = c * np.tan(alpha) / m
            psi = (1 - E) * t + E * C * np.arctan(t / C)
            fitted = m * Fz * np.sin(C * np.arctan(psi / C))
            likely = [(C - 1.3) / 0.3, E / 2, *((x[:2] - 1) / 1), *((x[2:4] - 1.1) / 0.5)]
            return np.concatenate([(fitted - F) / Fz / (0.01 * largest), likely])

        tight = {"xtol": 1e-15, "ftol": 1e-15, "gtol": 1e-15}
        x = least_squares(errors, [1.2, 1.2, 1.1, 1.1, 1.3, 0.0], **tight).x
        fit = fit_tire(data)
        assert fit.parameters["C1"] == pytest.approx(x[4], abs=1e-5)
        assert fit.parameters["E1"] == pytest.approx(x[5], abs=1e-5)
        assert coefficients(fit, 3000.0) == pytest.approx((secant * x[1], largest * x[3]), rel=1e-6)

    @pytest.mark.parametrize("scale", [0.2, 4.4482216152605])
    def test_units_of_force_do_not_matter(self, scale: float) -> None:
        data = GOODYEAR.data
        fit = fit_tire(
            TireData("scaled", data.slip_angles, data.loads * scale, data.forces * scale)
        )
        for s in ("B3", "B5", "C1", "E1"):
            assert fit.parameters[s] == pytest.approx(GOODYEAR.parameters[s], rel=1e-4), s
        assert fit.parameters["C3"] * scale == pytest.approx(GOODYEAR.parameters["C3"], rel=1e-4)

    def test_order_sign_and_duplicates_do_not_matter(self) -> None:
        data = GOODYEAR.data
        order = np.random.default_rng(1).permutation(np.tile(np.arange(data.forces.size), 2))
        points = (data.slip_angles[order], data.loads[order], -data.forces[order])
        fit = fit_tire(TireData("shuffled", *points))
        for s, value in GOODYEAR.parameters.items():
            assert fit.parameters[s] == pytest.approx(value, rel=1e-3), s
        assert "opposite" in fit.notes[0]

    def test_loads_that_were_measured_need_not_be_round(self) -> None:
        data = GOODYEAR.data
        loads = data.loads * (1 + 0.01 * np.sin(np.arange(data.loads.size)))
        scaled = data.forces * loads / data.loads
        fit = fit_tire(TireData("jitter", data.slip_angles, loads, scaled))
        assert len(fit.data.curves) == 5
        for load in (1779.0, 5338.0):
            assert coefficients(fit, load) == pytest.approx(coefficients(GOODYEAR, load), rel=0.02)

    @pytest.mark.parametrize("offset", [-80.0, 30.0])
    def test_an_offset_belongs_to_no_tire(self, offset: float) -> None:
        data = TireData.load(CASES / "both_signs.csv")
        moved = TireData("moved", data.slip_angles, data.loads, data.forces + offset)
        fit, same = fit_tire(moved), fit_tire(data)
        for s, value in same.parameters.items():
            assert fit.parameters[s] == pytest.approx(value, rel=2e-3, abs=2e-3), s
        assert list(fit.offsets.values()) == pytest.approx([offset] * 3, abs=0.5)


class TestFace:
    def test_quiet(self) -> None:
        """IPOPT prints nothing."""
        code = "import groundroll as gr; gr.fit_tire()"
        run = subprocess.run([sys.executable, "-c", code], capture_output=True, check=True)
        assert run.stdout == b""
        assert run.stderr == b""

    def test_name_is_enough(self) -> None:
        assert gr.fit_tire("goodyear-6.00-6").parameters == GOODYEAR.parameters

    def test_repr_is_a_table(self) -> None:
        lines = repr(GOODYEAR).splitlines()
        assert lines[0] == "TireFit of 'goodyear-6.00-6'"
        assert lines[8].split() == ["E1", "0.568872", "1", "magic_formula_E"]
        assert lines[12].split() == ["rms", "0.01450", "of", "friction,", "44.2", "N"]
        assert "is extrapolated" in lines[13]

    @pytest.mark.parametrize("again", [copy.deepcopy, lambda x: pickle.loads(pickle.dumps(x))])
    def test_copies(self, again: Any) -> None:
        assert again(GOODYEAR).parameters == GOODYEAR.parameters

    @pytest.mark.parametrize("load", [0.0, -1.0, np.nan])
    def test_load(self, load: float) -> None:
        with pytest.raises(gr.GroundrollError, match="load must be"):
            compare(GOODYEAR.data, {"fit": GOODYEAR.parameters}, load)

    def test_no_force_at_the_load(self) -> None:
        with pytest.raises(gr.GroundrollError, match="'fit' gives no force"):
            compare(GOODYEAR.data, {"fit": {**GOODYEAR.parameters, "D1": -1.0}})

    def test_arrays_are_no_parameter_set(self) -> None:
        plane = gr.Aircraft.load("brott").replace(C5=[-8e-6, -8e-5])
        with pytest.raises(gr.GroundrollError, match="C5 must be one number"):
            force_rms(GOODYEAR.data, plane)

    def test_unknown_set(self) -> None:
        with pytest.raises(gr.GroundrollError, match="did you mean thesis"):
            compare(GOODYEAR.data, {"thesis": GOODYEAR.parameters})["thesi"]
