"""Tires beyond what they were measured at: refused where nothing can be right, told elsewhere."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import groundroll as gr
from groundroll.aircraft.validity import extrapolated, extrapolated_in
from groundroll.cli import main
from groundroll.derive.core.equation import expand
from groundroll.derive.core.quantity import Quantity
from groundroll.derive.parts import friction
from groundroll.stability.checking import check

BROTT = gr.Aircraft.load("brott-physical")
HEAVY = BROTT.replace(mass="3000 kg")
BEYOND = BROTT.replace(mass="1400 kg")

CASES = Path(__file__).parent / "data" / "tires"
SOFT = {"d_tire": "17.5 in", "w_tire": "6.3 in", "C_z": 0.03, "C_N": 63.0}

CALLS: dict[str, Callable[[gr.Aircraft], Any]] = {
    "linearize": lambda p: gr.linearize(p),
    "linearize, linear": lambda p: gr.linearize(p, "linear"),
    "simulate": lambda p: gr.simulate(p, v0=1.0, t=0.2, samples=3),
    "simulate, linear": lambda p: gr.simulate(p, "linear", v0=1.0, t=0.2, samples=3),
    "trim": lambda p: gr.trim(p, disturbance=100.0),
    "ensemble": lambda p: gr.ensemble(p, v0=[0.5, 1.0], t=0.2),
    "survival": lambda p: gr.survival(p),
}


class TestNegativeStiffness:
    @pytest.mark.parametrize("name", CALLS)
    def test_it_is_refused_everywhere(self, name: str) -> None:
        with pytest.raises(gr.GroundrollError, match="cornering"):
            CALLS[name](HEAVY)

    def test_the_message_says_where(self) -> None:
        with pytest.raises(gr.GroundrollError) as caught:
            gr.linearize(HEAVY)
        assert "at a load of 12632 N a main tire has a negative cornering stiffness" in str(
            caught.value
        )
        assert "measured, 1779 to 5338 N" in str(caught.value)

    def test_of_an_array_any_element_counts(self) -> None:
        fleet = BROTT.replace(mass=[700.0, 800.0, 3000.0])
        with pytest.raises(gr.GroundrollError, match="12632 N"):
            gr.linearize(fleet)
        with pytest.raises(gr.GroundrollError, match="negative cornering stiffness"):
            gr.ensemble(BROTT, v0=1.0, t=0.1, mass=[700.0, 3000.0])

    def test_on_the_command_line(self, capsys: pytest.CaptureFixture[str]) -> None:
        assert main(["linearize", "brott-physical", "--set", "mass=3000 kg"]) == 1
        assert capsys.readouterr().out == ""

    def test_in_a_placement(self) -> None:
        plane = gr.Aircraft.load("cessna-170")
        with pytest.raises(gr.GroundrollError, match=r"mass 2993\.7 kg a main tire has a negative"):
            gr.place_gear(plane, gr.Envelope(mass=("1400 lb", "6600 lb")))

    def test_no_friction_is_refused(self) -> None:
        with pytest.raises(gr.GroundrollError, match="a main tire has no friction"):
            gr.linearize(gr.Aircraft.load("brott").replace(Fz="9 kN"))

    @given(st.floats(200.0, 4000.0), st.sampled_from(["brott-physical", "cessna-170"]))
    def test_what_is_answered_has_damping(self, mass: float, name: str) -> None:
        """The first entry of A is minus a sum of stiffnesses."""
        try:
            lin = gr.linearize(gr.Aircraft.load(name).replace(mass=mass))
        except gr.GroundrollError:
            return
        assert lin.A[0, 0] < 0


class TestWheelsOnLegs:
    """Loads of a landing roll are states: there is nothing to refuse before it starts."""

    @given(st.floats(0.0, 60e3), st.floats(-3.0, 3.0))
    def test_no_load_makes_a_tire_push_the_way_it_slides(self, load: float, slip: float) -> None:
        Fz, at = Quantity("Fz", "load", "N", "load"), friction.slip
        surface = Quantity("surface", "surface", "1", "surface")
        chain = friction.radt(surface)(Fz)
        tire = {s: float(BROTT[s]) for s in map(str, friction.TIRE)}
        point = {"Fz": load, "surface": 1.0, str(at): slip, **tire}
        grip = expand(friction.grip, chain).subs({q: point[str(q)] for q in _symbols(chain, point)})
        assert float(grip) * slip >= 0

    def test_runs_tell_of_wheels_beyond_the_data(self) -> None:
        turning = {"alpha_left": np.radians([5.0, 30.0]), "Fz_right": np.array([1e3, 6e3])}
        load, slip = extrapolated_in(BROTT, {"u": np.array([20.0, 20.0]), **turning})
        assert load.startswith("the load on a main tire, 1779 to 6000 N, is beyond")
        assert "reach 30 deg" in slip
        standing = {"u": np.array([20.0, 0.1]), "alpha_left": turning["alpha_left"]}
        assert extrapolated_in(BROTT, standing) == ()


def _symbols(chain: Any, point: dict[str, float]) -> list[Any]:
    """The free symbols of a chain that have a value."""
    return [q for e in chain for q in e.rhs.free_symbols if str(q) in point]


class TestTold:
    @pytest.mark.parametrize("name", [n for n in CALLS if "linear," not in n])
    def test_results_tell_of_loads_beyond_the_data(self, name: str) -> None:
        told = "the load on a main tire, 5894.8 N, is beyond what was measured, 1779 to 5338 N"
        assert told in repr(CALLS[name](BEYOND))
        assert "beyond what was measured" not in repr(CALLS[name](BROTT))

    def test_runs_tell_of_slip_beyond_the_data(self) -> None:
        run = gr.simulate(BROTT, v0=14.0, t=1.0, samples=11)
        assert "slip angles of the main tires reach 26.7 deg, and were measured to 20" in repr(run)
        assert "slip angles" not in repr(gr.simulate(BROTT, v0=1.0, t=1.0, samples=11))
        assert "slip angles" in run._repr_html_()

    def test_check_tells(self) -> None:
        assert any("beyond what was measured" in text for text in check(BEYOND).warnings)
        assert not any("measured" in text for text in check(BROTT).warnings)

    def test_the_command_line_tells(self, capsys: pytest.CaptureFixture[str]) -> None:
        arguments = ["linearize", "brott-physical", "--set", "mass=1400 kg", "--format"]
        assert main([*arguments, "json"]) == 0
        said = capsys.readouterr()
        assert "beyond the data: the load on a main tire, 5894.8 N" in said.err
        assert json.loads(said.out)["beyond_the_data"][0].startswith("the load on a main tire")

    def test_placement_tells(self) -> None:
        plane = gr.Aircraft.load("cessna-170")
        heavy = gr.place_gear(plane, gr.Envelope(mass=("1400 lb", "2900 lb")))
        assert any("beyond what was measured" in note for note in heavy.notes)
        light = gr.place_gear(plane, gr.Envelope(mass=("1400 lb", "2200 lb")))
        assert not any("measured" in note for note in light.notes)

    def test_without_data_there_is_nothing_to_tell(self) -> None:
        nothing = {"Fz_low": None, "Fz_high": None, "alpha_high": None}
        assert extrapolated(BEYOND.replace(**nothing), slip=np.array([1.0])) == ()


class TestAssumed:
    def test_a_peak_beyond_the_data(self) -> None:
        notes = check(gr.Aircraft.load("cessna-170")).notes
        told = "the largest friction of the main tires, 0.74474, is extrapolated: at 20 deg, where"
        assert any(note.startswith(told) for note in notes)

    def test_a_single_load(self) -> None:
        one = gr.fit_tire(CASES / "one_load.csv").parameters
        notes = check(BROTT.replace(**one)).notes
        assert any("were measured at 2000 N only" in note for note in notes)

    def test_nothing_where_nothing_was_measured(self) -> None:
        nothing = {"Fz_low": None, "Fz_high": None, "alpha_high": None}
        assert not any("main tires" in note for note in check(BROTT.replace(**nothing)).notes)


class TestPlausible:
    @pytest.mark.parametrize(
        ("changes", "words"),
        [
            ({"B5": 746.0}, "friction_coefficient is 745.97"),
            ({"B5": 0.05, "C5": 0.0}, "friction_coefficient is 0.05"),
            ({"B3": 60.0, "C3": 0.0}, "cornering_coefficient is 60 1/rad; usual is 0.015 1/deg"),
            ({"B3": 0.2, "C3": 0.0}, "cornering_coefficient is 0.2 1/rad"),
            ({**SOFT, "p_tire": "8 psi"}, "deflection_over_diameter is 0.1"),
            ({"p_tire": 42.0}, "tire_pressure is 42 N/m^2; usual is 5 psi to 300 psi"),
        ],
    )
    def test_what_is_far_off_is_told(self, changes: dict[str, float], words: str) -> None:
        assert any(text.startswith(words) for text in check(BROTT.replace(**changes)).warnings)

    @pytest.mark.parametrize("name", ["brott", "brott-physical", "cessna-170", "cessna-172p"])
    def test_the_packaged_aircraft_are_not(self, name: str) -> None:
        quantities = ("friction_coefficient is", "cornering_coefficient is", "tire_pressure is")
        assert not [t for t in check(gr.Aircraft.load(name)).warnings if t.startswith(quantities)]

    def test_both_coefficients_are_listed(self) -> None:
        known = {k.symbol: k for k in check(BROTT).known}
        load = float(BROTT["Fz"])
        assert known["C_c"].value == pytest.approx(BROTT["C_alpha"] / load)
        assert known["mu"].value == pytest.approx(BROTT["B5"] + BROTT["C5"] * load)
        assert known["mu"].follows_from == ("Fz", "B5", "C5")
