"""The thesis's way from Table 3.1 to a tire, against Table 3.2 and against SciPy.

The oracle is the magic formula as App. A.2 has it, in NumPy, and SciPy's least squares.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import approx_fprime, least_squares

import groundroll as gr
from groundroll.model.evaluate import elementwise
from groundroll.study.thesis_tire import (
    MAGIC,
    THESIS_START,
    Table,
    conditioning,
    normalised_rms,
    table_3_1,
    thesis_fit,
)
from groundroll.tires.data import TireData
from groundroll.tires.quality import compare, force_rms

Array = np.ndarray[Any, np.dtype[np.float64]]

DEGREE = np.pi / 180
DATA = TireData.load("goodyear-6.00-6")
TABLE = table_3_1()
FIT = thesis_fit(TABLE)
FITTED = np.array([FIT.parameters[s] for s in MAGIC])

#: Table 3.2, in SI; C5 as there, and as in App. A.5.
TABLE_3_2 = {
    "B3": 0.2117 / DEGREE,
    "C3": -2.2918e-5 / DEGREE,
    "B5": 0.7221,
    "C5": -8.81055e-6,
    "B1": 0.7947,
    "C1": 0.1901,
    "D1": 6.1197,
    "E1": 1.0637,
}
APP_A_5 = {**TABLE_3_2, "C5": -8.81055e-5}
THESIS_MAGIC = np.array([TABLE_3_2[s] for s in MAGIC])


def magic(x: Array, t: Array) -> Array:
    """MAGICERROR.m."""
    B, C, D, E = x
    psi = (1 - E) * t + E / B * np.arctan(B * t)
    return D * np.sin(C * np.arctan(B * psi))


def errors(x: Array) -> Array:
    alpha_bar, F_bar = TABLE.normalised
    return (magic(x, alpha_bar) - F_bar).ravel()


def rms(x: Array) -> float:
    return float(np.sqrt(np.mean(errors(x) ** 2)))


def scipy_fit(start: Any, free: Any = (0, 1, 2, 3), **options: Any) -> Array:
    """Least squares over some of the four parameters, the others as in `start`."""
    x = np.array(start, dtype=float)
    free = list(free)

    def error(part: Array) -> Array:
        y = x.copy()
        y[free] = part
        return errors(y)

    tight = {"xtol": 1e-15, "ftol": 1e-15, "gtol": 1e-15}
    x[free] = least_squares(error, x[free], **tight, **options).x
    return x


class TestTable31:
    """The packaged data are Table 3.1."""

    def test_size(self):
        assert TABLE.forces.shape == (20, 5)
        assert TABLE.slip_angles == pytest.approx(np.arange(1, 21) * DEGREE, rel=1e-14)
        assert TABLE.loads.tolist() == [1779, 2669, 3559, 4448, 5338]

    @pytest.mark.parametrize(
        ("angle", "forces"),
        [
            (1, [302, 414, 454, 485, 489]),
            (10, [1170, 1717, 2153, 2544, 2816]),
            (20, [1241, 1855, 2447, 3011, 3510]),
        ],
    )
    def test_rows(self, angle, forces):
        assert TABLE.forces[angle - 1].tolist() == forces


class TestCoefficients:
    def test_cornering_coefficient_is_the_secant_at_1_deg(self):
        by_hand = np.array([302, 414, 454, 485, 489]) / TABLE.loads / DEGREE
        assert TABLE.coefficients[0] == pytest.approx(by_hand, rel=1e-12)

    def test_friction_coefficient_is_the_peak(self):
        by_hand = np.array([1241, 1855, 2447, 3011, 3510]) / TABLE.loads
        assert TABLE.coefficients[1] == pytest.approx(by_hand, rel=1e-12)

    @pytest.mark.parametrize(
        ("intercept", "slope", "values"),
        [("B3", "C3", TABLE.coefficients[0]), ("B5", "C5", TABLE.coefficients[1])],
    )
    def test_straight_lines_are_least_squares(self, intercept, slope, values):
        x = TABLE.loads - TABLE.loads.mean()
        by_hand = (x @ values) / (x @ x)
        assert FIT.parameters[slope] == pytest.approx(by_hand, rel=1e-9)
        at_mean = FIT.parameters[intercept] + by_hand * TABLE.loads.mean()
        assert at_mean == pytest.approx(values.mean(), rel=1e-12)

    def test_beside_table_3_2(self):
        """Three agree with Table 3.2 within 1 %. C5 is neither of the two values in print."""
        for s in ("B3", "C3", "B5"):
            assert FIT.parameters[s] == pytest.approx(TABLE_3_2[s], rel=0.01)
        assert FIT.parameters["C5"] == pytest.approx(-1.1032e-5, abs=1e-9)


class TestMinimum:
    """The magic formula of the refit is a proper minimum, and the only one before E1 = 1."""

    def test_known_values(self):
        assert list(FITTED) == pytest.approx([0.75873, 1.18718, 1.01721, 0.38689], abs=1e-5)

    def test_agrees_with_scipy_from_the_start_of_the_thesis(self):
        oracle = scipy_fit(THESIS_START, method="lm")
        assert list(FITTED) == pytest.approx(oracle, abs=1e-7)

    def test_gradient_vanishes_and_hessian_is_positive(self):
        def cost(x: Array) -> float:
            return 0.5 * float(errors(x) @ errors(x))

        def gradient(x: Array) -> Array:
            jacobian = np.array([step(x, k) for k in range(4)])
            return jacobian @ errors(x)

        def step(x: Array, k: int) -> Array:
            z = x.astype(complex)
            z[k] += 1e-30j
            return np.imag(magic(z, TABLE.normalised[0])).ravel() / 1e-30

        assert gradient(FITTED) == pytest.approx(np.zeros(4), abs=1e-9)
        hessian = approx_fprime(FITTED, gradient, 1e-7)
        scale = np.sqrt(np.diag(hessian))
        assert np.linalg.eigvalsh((hessian + hessian.T) / 2 / np.outer(scale, scale)).min() > 1e-6
        assert cost(FITTED) == pytest.approx(0.5 * 100 * FIT.rms**2, rel=1e-9)

    @pytest.mark.parametrize(
        "start",
        [
            (1.0, 1.0, 1.0, 0.0),
            (0.5, 1.9, 1.0, 0.9),
            (0.3, 0.5, 3.0, -3.0),
            (2.0, 1.5, 0.8, -1.0),
        ],
    )
    def test_does_not_depend_on_the_start(self, start):
        found = thesis_fit(TABLE, start).parameters
        assert [found[s] for s in MAGIC] == pytest.approx(FITTED, abs=1e-8)

    def test_an_edge_of_the_search_is_named(self):
        """From Table 3.2, in its valley, the search slides to where E1 = 1 holds it."""
        fit = thesis_fit(TABLE, THESIS_MAGIC)
        assert fit.at_edge == ("E1",)
        assert fit.rms == pytest.approx(0.01161, abs=1e-5)

    def test_no_constraint_is_active(self):
        assert FIT.at_edge == ()
        B, C, D, E = FITTED
        assert B > 0.1
        assert 0.1 < C < 1.9
        assert D > 0.1
        assert E < 0.9

    @pytest.mark.parametrize("C", [0.1901, 0.05, 0.01])
    def test_beyond_E_1_lies_a_valley_without_a_minimum(self, C):
        """Lower by 7 %, and lower still the smaller C1 is; D1 grows as 1/C1."""
        start = [0.7743, C, 1.187 / C, 1.072]
        b, _, d, e = found = scipy_fit(start, free=(0, 2, 3), method="lm")
        assert rms(found) == pytest.approx(0.0100, abs=2e-5)
        assert rms(found) < 0.94 * FIT.rms
        assert C * d == pytest.approx(1.184, abs=0.005)
        assert b == pytest.approx(0.777, abs=0.004)
        assert e == pytest.approx(1.0715, abs=0.001)

    def test_conditioning_tells_the_valley_from_the_minimum(self):
        by_hand = approx_fprime(FITTED, lambda x: magic(x, TABLE.normalised[0].ravel()), 1e-7)
        by_hand /= np.linalg.norm(by_hand, axis=0)
        found = conditioning(TABLE, FIT.parameters)
        assert found == pytest.approx(np.linalg.cond(by_hand.T @ by_hand), rel=1e-3)
        assert found == pytest.approx(2.6e5, rel=0.05)
        assert conditioning(TABLE, TABLE_3_2) == pytest.approx(1.86e9, rel=0.05)

    def test_conditioning_without_any_trace_is_infinite(self):
        assert conditioning(TABLE, {"B1": 1.0, "C1": 1.0, "D1": 0.0, "E1": 0.0}) == np.inf


class TestQuality:
    """How far each set is from the data."""

    def test_normalised(self):
        assert FIT.rms == pytest.approx(0.01070, abs=1e-5)
        assert normalised_rms(TABLE, FIT.parameters) == pytest.approx(rms(FITTED), rel=1e-9)
        assert normalised_rms(TABLE, TABLE_3_2) == pytest.approx(0.01306, abs=1e-5)

    def test_normalised_with_the_points_at_zero(self):
        """Counted in, as the errata have it."""
        share = np.sqrt(100 / 105)
        assert share * FIT.rms == pytest.approx(0.0104, abs=5e-5)
        assert share * normalised_rms(TABLE, TABLE_3_2) == pytest.approx(0.0128, abs=6e-5)

    def test_forces(self):
        assert force_rms(DATA, TABLE_3_2) == pytest.approx(27.41, abs=0.01)
        assert force_rms(DATA, APP_A_5) == pytest.approx(931.74, abs=0.01)
        assert force_rms(DATA, FIT.parameters) == pytest.approx(30.71, abs=0.01)

    def test_forces_by_hand(self):
        tan = np.tan(DATA.slip_angles)
        C_c = TABLE_3_2["B3"] + TABLE_3_2["C3"] * DATA.loads
        mu = TABLE_3_2["B5"] + TABLE_3_2["C5"] * DATA.loads
        forces = magic(THESIS_MAGIC, C_c * tan / mu) * mu * DATA.loads
        by_hand = np.sqrt(np.mean((forces - DATA.forces) ** 2))
        assert force_rms(DATA, TABLE_3_2) == pytest.approx(by_hand, rel=1e-9)

    def test_the_thesis_normalised_with_its_friction_line(self):
        """Table 3.2 nearly reaches the bottom of its valley (0.00867) on data normalised with
        the printed line of mu (C5 = -8.81055e-6) and each load's own cornering coefficient."""
        arguments = {
            "alpha": TABLE.slip_angles[:, None],
            "F_y": TABLE.forces,
            "Fz": TABLE.loads,
            "C_c": TABLE.coefficients[0],
            "mu": TABLE_3_2["B5"] + TABLE_3_2["C5"] * TABLE.loads,
        }
        data = elementwise("normalised_data", arguments)
        error = magic(THESIS_MAGIC, data["alpha_bar"]) - data["F_bar"]
        assert np.sqrt(np.mean(error**2)) == pytest.approx(0.00886, abs=1e-5)

    def test_slope_at_zero_is_less_than_the_secant(self):
        """B1 C1 D1: the linear tire is stiffer than the non-linear one at small angles."""
        assert np.prod(THESIS_MAGIC[:3]) == pytest.approx(0.9245, abs=1e-4)
        assert np.prod(FITTED[:3]) == pytest.approx(0.9162, abs=1e-4)


class TestLargeSlip:
    STATIC = 3151.3  # N, one main tire at 15.2 in

    def test_the_thesis_reverses(self):
        q = compare(DATA, {"thesis": TABLE_3_2}, self.STATIC)["thesis"]
        assert np.degrees(q.peak_slip_angle) == pytest.approx(23.4, abs=0.1)
        assert np.degrees(q.reversal) == pytest.approx(70.3, abs=0.1)
        assert q.sideways_share == pytest.approx(-1.813, abs=1e-3)

    def test_the_printed_runs_reverse_sooner(self):
        q = compare(DATA, {"thesis": APP_A_5}, self.STATIC)["thesis"]
        assert np.degrees(q.peak_slip_angle) == pytest.approx(15.5, abs=0.1)
        assert np.degrees(q.reversal) == pytest.approx(60.8, abs=0.1)

    def test_the_refit_does_not(self):
        q = compare(DATA, {"refit": FIT.parameters}, self.STATIC)["refit"]
        assert 30 < np.degrees(q.peak_slip_angle) < 35
        assert q.sideways_share == pytest.approx(0.957, abs=2e-3)
        assert np.isnan(q.reversal)

    @pytest.mark.parametrize("load", [200.0, 1779.0, 3559.0, 5338.0, 9000.0])
    def test_the_refit_never_does_at_any_load(self, load):
        alpha = np.linspace(0, np.pi / 2, 2001)
        arguments = {"alpha": alpha, "Fz": np.asarray(load)}
        values = {s: np.asarray(v) for s, v in FIT.parameters.items()}
        F = elementwise("tire_force", arguments | values)["F_y"]
        assert (F[1:] > 0).all()
        assert F[-1] > 0.9 * F.max()
        left = elementwise("tire_force", {**arguments, **values, "alpha": -alpha})["F_y"]
        assert left == pytest.approx(-F, rel=1e-14)

    def test_table(self):
        table = repr(compare(DATA, {"Table 3.2": TABLE_3_2, "refit": FIT.parameters}))
        header, _, thesis, refit = table.splitlines()
        assert "at 3559 N" in header
        assert "428.2 N/deg" in thesis
        assert "-181%" in thesis
        assert "71.5 deg" in thesis
        assert "never" in refit

    def test_takes_an_aircraft(self):
        plane = gr.Aircraft.load("brott")
        q = compare(DATA, {"brott": plane})["brott"]
        assert q.force_rms == pytest.approx(931.74, abs=0.01)


@st.composite
def tires(draw: st.DrawFn) -> tuple[Table, dict[str, float]]:
    """Forces of a tire whose normalised curve is the same at each load, and what a fit must find.

    With C3/B3 = C5/B5 secant and peak are one share s and t of C_c and mu at every load, so the
    fit must find s B3, t B5, B1 t/s, D1/t, and the same C1 and E1.
    """
    B, C = draw(st.floats(0.75, 1.1)), draw(st.floats(1.25, 1.6))
    D, E = draw(st.floats(0.9, 1.1)), draw(st.floats(-1.0, 0.5))
    stiffness, friction = draw(st.floats(8.0, 14.0)), draw(st.floats(0.5, 0.8))
    slope, scale = draw(st.floats(-8e-5, 0.0)), draw(st.floats(0.3, 3.0))
    alpha = np.arange(1, 26) * DEGREE
    loads = scale * np.array([1500.0, 2500.0, 3500.0, 4500.0])
    share = 1 + slope / scale * loads
    t = stiffness * np.tan(alpha) / friction
    curve = magic(np.array([B, C, D, E]), t)
    forces = curve[:, None] * friction * share * loads
    s_secant, s_peak = curve[0] * friction / (stiffness * alpha[0]), curve.max()
    expected = {
        "B3": s_secant * stiffness,
        "C3": s_secant * stiffness * slope / scale,
        "B5": s_peak * friction,
        "C5": s_peak * friction * slope / scale,
        "B1": B * s_peak / s_secant,
        "C1": C,
        "D1": D / s_peak,
        "E1": E,
    }
    return Table(alpha, loads, forces), expected


class TestSynthetic:
    @given(tires())
    def test_recovers_a_known_tire(self, tire):
        table, expected = tire
        fit = thesis_fit(table)
        assert fit.rms < 1e-9
        assert fit.at_edge == ()
        for s, value in expected.items():
            tolerance = 1e-12 if s in ("C3", "C5") else 1e-4
            assert fit.parameters[s] == pytest.approx(value, rel=1e-4, abs=tolerance), s

    @pytest.mark.parametrize("seed", range(5))
    def test_rounding_of_the_data_hardly_moves_the_fit(self, seed):
        """Table 3.1 is rounded to whole newtons; the refit is known to 3 digits nevertheless."""
        noise = np.random.default_rng(seed).uniform(-0.5, 0.5, TABLE.forces.shape)
        table = Table(TABLE.slip_angles, TABLE.loads, TABLE.forces + noise)
        found = thesis_fit(table).parameters
        assert [found[s] for s in MAGIC] == pytest.approx(FITTED, rel=3e-3)
        assert np.abs(FITTED - [found[s] for s in MAGIC]).max() > 1e-5


class TestPackagedAircraft:
    PLANE = gr.Aircraft.load("brott-physical")

    def test_magic_formula_is_the_fit_rounded_to_4_digits(self):
        for s in MAGIC:
            assert float(self.PLANE[s]) == float(f"{FIT.parameters[s]:.4g}"), s

    def test_rounding_costs_nothing(self):
        rounded = {s: float(self.PLANE[s]) for s in TABLE_3_2}
        exact = {**rounded, **{s: FIT.parameters[s] for s in MAGIC}}
        assert force_rms(DATA, exact) == pytest.approx(27.8, abs=0.05)
        assert force_rms(DATA, rounded) == pytest.approx(force_rms(DATA, exact), abs=0.3)
        assert normalised_rms(TABLE, rounded) == pytest.approx(FIT.rms, abs=1e-5)

    def test_straight_lines_are_those_of_table_3_2(self):
        for s in ("B3", "C3", "B5", "C5"):
            assert float(self.PLANE[s]) == pytest.approx(TABLE_3_2[s], rel=1e-12), s
