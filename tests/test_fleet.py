"""Aircraft files: the packaged ones, what follows from what, and every kind of mistake."""

from __future__ import annotations

import copy
import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import groundroll as gr
from groundroll.aircraft.aircraft import packaged

DEGREE = np.pi / 180
INCH = 0.0254

PRINTED = gr.Aircraft.load("brott")
PHYSICAL = gr.Aircraft.load("brott-physical")
SKYHAWK = gr.Aircraft.load("cessna-172p")

#: What `brott` fixes and `brott-physical` lets follow.
FOLLOWING = ("f", "C_alpha", "Ct")


def write(folder: Path, text: str) -> Path:
    path = folder / "plane.toml"
    path.write_text(text, encoding="utf-8")
    return path


def message(action: Callable[[], Any]) -> str:
    with pytest.raises(gr.GroundrollError) as caught:
        action()
    return str(caught.value)


class TestPackaged:
    def test_both_are_there(self):
        assert {"brott", "brott-physical"} <= set(packaged())

    @pytest.mark.parametrize("name", ["brott", "brott-physical"])
    @pytest.mark.parametrize("model", ["linear", "nonlinear"])
    def test_each_simulates_and_linearizes(self, name, model):
        plane = gr.Aircraft.load(name)
        run = gr.simulate(plane, model=model, v0=0.1, t=5.0)
        assert run["v"][0] == 0.1
        assert abs(run["v"][-1]) < 0.1
        assert gr.linearize(plane, model=model).eigenvalues.real.max() < 0

    @pytest.mark.parametrize("plane", [PRINTED, PHYSICAL], ids=lambda p: p.name)
    def test_every_number_has_its_source(self, plane):
        for s in plane.given:
            assert plane.sources[s].text, s
        estimates = {s for s in plane.given if plane.sources[s].estimate}
        assert estimates == {"K1", "K2", "K3", "K4", "S_wing"}

    def test_they_differ_in_the_tires_only(self):
        assert set(PRINTED.given) - set(PHYSICAL.given) == set(FOLLOWING)
        assert set(PHYSICAL.given) <= set(PRINTED.given)
        different = {s for s in PHYSICAL.given if PHYSICAL.given[s] != PRINTED.given[s]}
        assert different == {"C5", "B1", "C1", "D1", "E1"}

    @pytest.mark.parametrize(
        ("symbol", "value", "tolerance"),
        [
            ("m", 748.43, 0),
            ("Izz", 1760, 0),
            ("a", 0.64008, 1e-12),
            ("b", 3.88112, 1e-12),
            ("L", 4.5212, 1e-12),
            ("u", 100 / 3.6, 1e-12),
            ("f", 0.8584, 5e-5),
            ("Fz", 0.8584 * 748.43 * 9.81 / 2, 0.2),
            ("F_tail_load", 1039.4, 0.1),
            ("C5", -8.81055e-6, 1e-18),
        ],
    )
    def test_numbers_of_the_physical_one(self, symbol, value, tolerance):
        assert float(PHYSICAL[symbol]) == pytest.approx(value, rel=0, abs=tolerance)

    @pytest.mark.parametrize(("load", "stiffness"), [(519.7, 70), (1039.4, 112), (2078.9, 145)])
    def test_tail_wheel_goes_through_the_points_of_figure_3_8(self, load, stiffness):
        Ct = float(PHYSICAL.replace(F_tail_load=load)["Ct"]) * DEGREE
        assert Ct == pytest.approx(stiffness, abs=0.02)

    def test_static_stiffnesses(self):
        assert float(PHYSICAL["Ct"]) * DEGREE == pytest.approx(112, abs=0.01)
        C_c = 0.2117 - 2.2918e-5 * float(PHYSICAL["Fz"])
        assert float(PHYSICAL["C_alpha"]) * DEGREE == pytest.approx(C_c * PHYSICAL["Fz"], rel=1e-12)

    def test_the_printed_cornering_stiffness_is_that_of_the_forward_cg(self):
        """441.63 N/deg belongs to f = 0.867: the CG at 13.6 in."""
        plane = PHYSICAL.replace(cg_station="13.6 in")
        assert float(plane["f"]) == pytest.approx(0.8674, abs=5e-5)
        assert float(plane["C_alpha"]) * DEGREE == pytest.approx(441.63, abs=0.2)


class TestFollowing:
    """From CG and gear stations to loads, from loads to stiffnesses."""

    @given(st.floats(-5, 35))
    def test_loads_balance_the_weight(self, inches):
        plane = PHYSICAL.replace(cg_station=inches * INCH)
        weight = float(plane["m"] * plane["g"])
        main, tail = 2 * float(plane["Fz"]), float(plane["F_tail_load"])
        assert main + tail == pytest.approx(weight, rel=1e-12)
        assert main * float(plane["a"]) == pytest.approx(tail * float(plane["b"]), rel=1e-9)

    @given(*(st.floats(-3, 3), st.floats(0.05, 2), st.floats(0.05, 3), st.floats(300, 3000)))
    def test_loads_balance_on_a_nose_wheel(self, x_cg, behind, ahead, m):
        """Forces and moments about the datum, solved for the two axles."""
        x_main, x_nose = x_cg + behind, x_cg - ahead
        plane = SKYHAWK.replace(x_cg=x_cg, x_main=x_main, x_nose=x_nose, x_tail=x_cg + 5, m=m)
        weight = float(plane["m"] * plane["g"])
        main, nose = np.linalg.solve([[1, 1], [x_main, x_nose]], [weight, weight * x_cg])
        assert 2 * plane["Fz"] == pytest.approx(main, rel=1e-9)
        assert plane["f"] == pytest.approx(1 - nose / weight, rel=1e-9)
        assert plane["F_tail_load"] == 0

    def test_the_cg_moves_the_load_of_a_tricycle(self):
        """By the lever: an inch of the CG is a 65th of the weight from nose to main gear."""
        plane = SKYHAWK.replace(cg_station=np.array([39.4, 43.4, 47.4]) * INCH)
        assert np.diff(plane["f"]) == pytest.approx([4 / 65, 4 / 65])
        assert (np.diff(plane["Fz"]) > 100).all()
        assert (np.diff(plane["C_alpha"]) > 100).all()
        assert plane.follows_from("f") == ("a", "x_cg", "x_nose")

    def test_a_gear_that_passes_the_cg_takes_the_load_to_the_other_wheel(self):
        plane = PHYSICAL.replace(
            nose_wheel_station="-60 in", main_gear_station=np.array([-10, 15.2, 40]) * INCH
        )
        weight = plane["m"] * plane["g"]
        share = [152.8 / 178, 1, 75.2 / 100]
        assert plane["f"] == pytest.approx(share)
        assert plane["F_tail_load"] / weight == pytest.approx([1 - share[0], 0, 0])
        assert (plane["Ct"][1:] == 0).all()
        assert set(plane.follows_from("f")) == {"a", "x_cg", "x_nose", "b", "L"}

    def test_placement_has_the_same_balance(self):
        known = {k.symbol: k for k in gr.check(SKYHAWK).known}
        assert known["third_load"].value == pytest.approx(1 - known["f"].value, rel=1e-12)
        assert known["f"].follows_from == ("a", "x_cg", "x_nose")

    def test_the_cg_moves_loads_and_stiffnesses(self):
        plane = PHYSICAL.replace(cg_station=np.array([13.6, 15.2, 16.8]) * INCH)
        assert (np.diff(plane["F_tail_load"]) > 10).all()
        assert (np.diff(plane["Fz"]) < -10).all()
        assert (np.diff(plane["Ct"]) > 100).all()
        assert (np.diff(plane["C_alpha"]) < -100).all()
        assert (np.diff(plane["L"]) == 0).all()

    def test_the_printed_one_keeps_its_stiffnesses(self):
        plane = PRINTED.replace(cg_station=np.array([13.6, 16.8]) * INCH)
        assert plane["C_alpha"].shape == ()
        assert plane["Ct"].shape == ()

    def test_the_gear_moves_them_too(self):
        plane = PHYSICAL.replace(main_gear_station="-20 in")
        assert float(plane["a"]) == pytest.approx(float(PHYSICAL["a"]) + 10 * INCH, abs=1e-12)
        assert plane["F_tail_load"] > PHYSICAL["F_tail_load"]

    def test_none_lets_a_parameter_follow(self):
        plane = PRINTED.replace(**dict.fromkeys(FOLLOWING))
        for s in ("f", "Fz", "C_alpha", "Ct"):
            assert float(plane[s]) == pytest.approx(float(PHYSICAL[s]), rel=1e-12), s
            assert s not in plane.given

    def test_a_given_value_stops_what_follows(self):
        plane = PHYSICAL.replace(a=-0.5, b=3.92176, Ct=0.0)
        assert float(plane["L"]) == pytest.approx(3.42176, abs=1e-12)
        assert float(plane["Ct"]) == 0

    def test_what_follows_from_nothing_is_named(self):
        text = message(lambda: PHYSICAL.replace(tail_station=None)["b"])
        assert "tail_station (x_tail) is not given" in text
        assert "tail_arm (b) follows from it" in text

    def test_a_missing_mass_is_named(self):
        plane = PRINTED.replace(mass=None)
        assert "mass (m) is not given" in message(lambda: gr.simulate(plane, v0=0.1))
        assert "m" not in plane
        assert "m" in PRINTED

    def test_the_whole_chain_is_named(self):
        text = message(lambda: PHYSICAL.replace(m=None)["Ct"])
        assert "mass (m) is not given" in text
        assert "tail_wheel_stiffness (Ct)" in text

    @pytest.mark.parametrize(
        ("changes", "name"),
        [
            ({"x_tail": 0.1}, "tail_arm (b)"),
            ({"f": 0.0}, "tire_load (Fz)"),
            ({"m": 9000.0}, "cornering_stiffness (C_alpha)"),
            ({"main_gear_station": "40 in"}, "tail_wheel_load (F_tail_load)"),
        ],
    )
    def test_what_follows_must_be_possible(self, changes, name):
        text = message(lambda: gr.linearize(PHYSICAL.replace(**changes), model="linear"))
        assert name in text
        assert "positive" in text


class TestReplace:
    def test_leaves_the_original(self):
        PRINTED.replace(a=-0.5, mass=900.0)
        assert float(PRINTED["m"]) == 748.43
        assert "a" not in PRINTED.given

    def test_symbols_and_full_names_are_one(self):
        by_symbol, by_name = PRINTED.replace(a=-0.5), PRINTED.replace(main_gear_arm=-0.5)
        assert by_symbol["main_gear_arm"] == by_name["a"] == -0.5

    def test_drops_the_source(self):
        assert "C5" in PRINTED.sources
        assert not PRINTED.replace(C5=-1e-5).sources.get("C5")

    @pytest.mark.parametrize(
        ("text", "symbol", "value"),
        [
            ("70 N/deg", "Ct", 70 / DEGREE),
            ("62 mph", "u", 62 * 0.44704),
            ("1650 lb", "m", 1650 * 0.45359237),
            ("15.2 in", "x_cg", 0.38608),
            ("30", "u", 30.0),
            ("-8.8e-6 1/N", "C5", -8.8e-6),
        ],
    )
    def test_strings_carry_units(self, text, symbol, value):
        assert float(PRINTED.replace(**{symbol: text})[symbol]) == pytest.approx(value, rel=1e-12)

    @pytest.mark.parametrize(
        ("name", "nearest"),
        [("mas", "mass"), ("main_gear_am", "main_gear_arm"), ("Fzz", "Fz"), ("izz", "Izz")],
    )
    def test_an_unknown_name_names_the_nearest(self, name, nearest):
        for action in (lambda: PRINTED.replace(**{name: 1.0}), lambda: PRINTED[name]):
            text = message(action)
            assert repr(name) in text
            assert nearest in text

    def test_an_output_is_no_parameter(self):
        assert "'alpha'" in message(lambda: PRINTED.replace(alpha=0.1))

    @pytest.mark.parametrize(
        ("changes", "parts"),
        [
            ({"mass": -1.0}, ("mass (m) must be positive", "-1.0")),
            ({"Izz": 0.0}, ("yaw_inertia (Izz) must be positive", "0.0")),
            ({"u": 0.0}, ("speed (u) must be positive", "0.0")),
            ({"u": -27.8}, ("speed (u) must be positive", "-27.8")),
            ({"b": -3.9}, ("tail_arm (b) must be positive", "-3.9")),
            ({"rho": np.nan}, ("air_density (rho) must be finite", "nan")),
            ({"a": np.inf}, ("main_gear_arm (a) must be finite", "inf")),
            ({"a": [0.5, np.nan, 0.7]}, ("main_gear_arm (a)", "[1]", "nan")),
            ({"m": [[700.0, 800.0], [-5.0, 900.0]]}, ("mass (m)", "[1, 0]", "-5.0")),
            ({"m": "1e400 kg"}, ("mass (m) must be finite", "inf")),
            ({"m": 5 + 1j}, ("mass (m)", "(5+1j)")),
            ({"m": [[1.0], [2.0, 3.0]]}, ("mass (m)",)),
            ({"m": "heavy"}, ("m", "'heavy'", "kg")),
            ({"m": ""}, ("m", "''", "kg")),
            ({"m": "5 stones_and_more"}, ("m", "unknown unit", "stones_and_more")),
            ({"m": "5 5 kg"}, ("m", "'5 kg'")),
            ({"m": "1,5 kg"}, ("m", "'1,5 kg', with a comma", "a point before decimals")),
            ({"u": "100 km"}, ("u", "km", "m/s")),
            ({"Ct": "70 kg/deg"}, ("Ct", "kg/deg", "N/rad")),
            ({"Ct": "70 N"}, ("Ct", "70 N", "N/rad")),
            ({"f": "50 deg"}, ("f", "50 deg", "pure number")),
        ],
    )
    def test_what_cannot_be_is_refused(self, changes, parts):
        text = message(lambda: PRINTED.replace(**changes))
        for part in parts:
            assert part in text

    def test_speed_of_a_run_is_checked_too(self):
        assert "must be positive" in message(lambda: gr.simulate(PRINTED, speed=0.0, v0=0.1))

    def test_nothing_can_be_changed_in_place(self):
        with pytest.raises(ValueError, match="read-only"):
            PRINTED["m"][...] = 1.0
        with pytest.raises(TypeError):
            PRINTED.given["m"] = np.array(1.0)

    def test_two_names_for_one_parameter_are_refused(self):
        assert "a" in message(lambda: PRINTED.replace(a=1.0, main_gear_arm=2.0))

    def test_a_truth_value_is_no_number(self):
        assert "mass (m)" in message(lambda: PRINTED.replace(m=True))

    @pytest.mark.parametrize("again", [copy.deepcopy, lambda x: pickle.loads(pickle.dumps(x))])
    def test_an_aircraft_can_be_copied_and_sent(self, again):
        assert float(again(PRINTED)["m"]) == 748.43


class TestArrays:
    def test_broadcast(self):
        plane = PHYSICAL.replace(
            m=np.array([700.0, 800.0])[:, None], x_cg=np.array([13.6, 15.2, 16.8]) * INCH
        )
        assert plane["Fz"].shape == (2, 3)
        assert plane["a"].shape == (3,)
        assert gr.linearize(plane).eigenvalues.shape == (2, 3, 2)
        one = PHYSICAL.replace(m=800.0, x_cg=16.8 * INCH)
        assert plane["Ct"][1, 2] == pytest.approx(float(one["Ct"]), rel=1e-14)

    def test_shapes_that_do_not_fit(self):
        text = message(lambda: PRINTED.replace(a=np.ones(2), b=np.ones(3)))
        assert "(2,)" in text
        assert "(3,)" in text

    def test_an_array_remains_the_callers(self):
        mine = np.array([0.1, 0.2, 0.3])
        plane = PRINTED.replace(a=mine[:2])
        mine[0] = 9.0
        assert plane["a"].tolist() == [0.1, 0.2]

    def test_an_array_remains_writeable(self):
        mine = np.array([0.1, 0.2])
        PRINTED.replace(a=mine)
        assert mine.flags.writeable

    def test_only_what_is_read_only_is_shared(self):
        mine = np.array([0.1, 0.2])
        mine.flags.writeable = False
        assert PRINTED.replace(a=mine)["a"] is mine
        view = mine[:]
        assert not np.shares_memory(PRINTED.replace(a=view)["a"], mine)

    def test_what_does_not_change_is_shared(self):
        plane = PRINTED.replace(a=np.array([0.1, 0.2]))
        assert plane.replace(m=800.0)["a"] is plane["a"]

    def test_no_values_at_all(self):
        text = message(lambda: gr.simulate(PRINTED.replace(m=np.array([])), v0=0.1))
        assert "mass (m)" in text


class TestFiles:
    def test_a_file_of_ones_own(self, tmp_path):
        text = 'title = "Mine"\nmass = "800 kg"\n[gear]\na = { value = "2 ft", source = "here" }\n'
        plane = gr.Aircraft.load(write(tmp_path, text))
        assert (plane.name, plane.title) == ("plane", "Mine")
        assert float(plane["a"]) == pytest.approx(0.6096, abs=1e-12)
        assert plane.sources["a"].text == "here"

    def test_a_path_as_text(self, tmp_path):
        assert float(gr.Aircraft.load(str(write(tmp_path, "m = 5\n")))["m"]) == 5

    @pytest.mark.parametrize("name", ["brot", "brott_physical", "Brott"])
    def test_a_misspelt_aircraft_names_the_nearest(self, name):
        text = message(lambda: gr.Aircraft.load(name))
        assert repr(name) in text
        assert "brott" in text

    def test_an_unlike_name_lists_what_there_is(self):
        text = message(lambda: gr.Aircraft.load("zzz"))
        assert "brott-physical" in text

    def test_missing_file(self, tmp_path):
        path = tmp_path / "none.toml"
        text = message(lambda: gr.Aircraft.load(path))
        assert str(path) in text
        assert "No such file" in text

    def test_a_folder_is_no_file(self, tmp_path):
        (tmp_path / "folder.toml").mkdir()
        assert "folder.toml" in message(lambda: gr.Aircraft.load(tmp_path / "folder.toml"))

    def test_not_text(self, tmp_path):
        (tmp_path / "plane.toml").write_bytes(b"\xff\xfe\x00")
        assert "plane.toml" in message(lambda: gr.Aircraft.load(tmp_path / "plane.toml"))

    @pytest.mark.parametrize("text", ["mass = \n", "[airframe\n", "mass = 1\nmass = 2\n"])
    def test_invalid_toml(self, tmp_path, text):
        found = message(lambda: gr.Aircraft.load(write(tmp_path, text)))
        assert "plane.toml" in found
        assert "TOML" in found

    @pytest.mark.parametrize(
        ("text", "parts"),
        [
            ("mas = 5", ("mas", "mass")),
            ("[airframe]\ntial_area = 0.7", ("tial_area", "tail_area")),
            ('mass = "5 kgg"', ("mass", "kgg")),
            ('mass = "5 m"', ("mass", "m'", "kg")),
            ('speed = "0 km/h"', ("speed", "0")),
            ("mass = -5", ("mass", "-5")),
            ("mass = nan", ("mass", "nan")),
            ("a = inf", ("a: found inf", "finite")),
            ("mass = 1979-05-27", ("mass", "1979")),
            ('[airframe]\nmass = { value = "5 kg", src = "x" }', ("mass", "src", "source")),
            ("mass = { value = { value = 3 } }", ("mass",)),
            ("m = 1\n[airframe]\nmass = 2", ("line 3, airframe.mass", "it is in m too")),
            ("mass = true", ("mass", "True")),
            ("mass = [700, 800]", ("mass", "[700, 800]")),
            ('mass = { value = 5, estimate = "no" }', ("mass", "estimate = 'no'")),
            ('mass = { source = "scales" }', ("mass", "no value")),
            ("title = 5", ("title", "5")),
            ("# one\n\n[airframe]\nmass = -5", ("line 4, airframe.mass",)),
        ],
    )
    def test_each_mistake_is_named(self, tmp_path, text, parts):
        found = message(lambda: gr.Aircraft.load(write(tmp_path, text)))
        for part in parts:
            assert part in found

    def test_all_mistakes_at_once(self, tmp_path):
        text = """
        mass = "5 kilo"
        [a_table]
        yaw_inertia = -1
        speed = "5 furlongs"
        main_gear_arn = 1
        tail_arm = "5 kg"
        air_density = nan
        """
        found = message(lambda: gr.Aircraft.load(write(tmp_path, text)))
        for part in ("mass", "yaw_inertia", "speed", "main_gear_arn", "tail_arm", "air_density"):
            assert part in found
        assert "6 mistake" in found
