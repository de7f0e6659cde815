"""Aircraft files: what they may say, and how every mistake in one is reported at once."""

from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import groundroll as gr
from groundroll.aircraft.aircraft import FOLLOWS, packaged
from groundroll.aircraft.file import AircraftFileError, Mistake
from groundroll.base.units import UnitError, from_si, to_si
from groundroll.model.names import MODELS, QUANTITIES, parameter_symbols
from groundroll.stability.checking import _usual
from groundroll.tires.data import packaged_tables

BRIEF = """
title = "Brief"
source = "a weight-and-balance sheet"
[airframe]
mass = "1650 lb"
yaw_inertia = { value = 1760, source = "a guess", estimate = true }
tail_area = "7.5 ft^2"
tail_lift_slope = "2.5 1/rad"
[stations]
cg_station = "15.2 in"
main_gear_station = "-10 in"
tail_station = "168 in"
[main_tires]
table = "goodyear-6.00-6.csv"
[tail_wheel]
tail_wheel_stiffness = "70 N/deg"
[runway]
speed = "62 mph"
air_density = 1.225
gravity = 9.81
"""

#: What no quantity can be.
WRONG = ("true", "[1]", "nan", "-inf", "'1 furlong^9'", "{ source = 'x' }", "{ value = {} }")


def load(folder: Path, text: str, name: str = "plane.toml") -> gr.Aircraft:
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return gr.Aircraft.load(path)


def mistakes(folder: Path, text: str) -> list[Mistake]:
    with pytest.raises(AircraftFileError) as caught:
        load(folder, text)
    return list(caught.value.mistakes)


def the_mistake(folder: Path, text: str) -> Mistake:
    (one,) = mistakes(folder, text)
    return one


def changed(key: str, entry: str) -> str:
    """The brief file with one entry changed."""
    lines = [f"{key} = {entry}" if s.startswith(f"{key} =") else s for s in BRIEF.splitlines()]
    assert lines != BRIEF.splitlines()
    return "\n".join(lines)


def tricycle() -> str:
    """The brief file with its main gear behind the CG."""
    return changed("main_gear_station", '"25 in"')


# --- What a file may say --------------------------------------------------------------------


def test_values_with_units_become_si(tmp_path: Path):
    plane = load(tmp_path, BRIEF)
    assert plane["mass"] == pytest.approx(748.427, abs=1e-3)
    assert plane["Izz"] == 1760
    assert plane["tail_wheel_stiffness"] == pytest.approx(np.rad2deg(70))
    assert plane["speed"] == pytest.approx(27.7165, abs=1e-4)


def test_arms_and_loads_follow_from_stations_behind_any_datum(tmp_path: Path):
    plane = load(tmp_path, BRIEF)
    shifted = BRIEF.replace("15.2 in", "65.2 in").replace("-10 in", "40 in")
    other = load(tmp_path, shifted.replace("168 in", "218 in"))
    assert plane["a"] == pytest.approx(0.64008)
    assert plane["L"] == pytest.approx(4.5212)
    for symbol in ("a", "b", "L", "f", "Fz", "F_tail_load", "C_alpha"):
        assert other[symbol] == pytest.approx(plane[symbol], rel=1e-12)


def test_where_a_number_comes_from_is_kept(tmp_path: Path):
    plane = load(tmp_path, BRIEF)
    assert plane.source == "a weight-and-balance sheet"
    assert plane.sources["Izz"].text == "a guess"
    assert plane.sources["Izz"].estimate
    assert plane.sources["m"].entry == "1650 lb"
    assert plane.sources["rho"].entry == "1.225"
    assert "estimate: a guess" in repr(plane)


def test_a_tire_by_table_by_parameters_and_by_stiffness(tmp_path: Path):
    by_table = load(tmp_path, BRIEF)
    fit = gr.fit_tire("goodyear-6.00-6")
    assert {s: float(by_table[s]) for s in fit.parameters} == pytest.approx(dict(fit.parameters))
    lines = "\n".join(f"{s} = {value!r}" for s, value in fit.parameters.items())
    by_parameters = load(tmp_path, changed("table", '"x"').replace('table = "x"', lines))
    assert by_parameters["C_alpha"] == pytest.approx(by_table["C_alpha"])
    by_stiffness = load(
        tmp_path, changed("table", '"x"').replace('table = "x"', 'C_alpha = "441 N/deg"')
    )
    assert np.isfinite(gr.linearize(by_stiffness, "linear").decay_rate)
    with pytest.raises(gr.GroundrollError, match="cornering_coefficient_intercept"):
        gr.linearize(by_stiffness, "nonlinear")


def test_a_tire_table_beside_the_file_comes_first(tmp_path: Path):
    table = packaged_tables()["goodyear-6.00-6"].read_text(encoding="utf-8")
    (tmp_path / "mine.csv").write_text(table, encoding="utf-8")
    plane = load(tmp_path, changed("table", '{ value = "mine.csv", source = "my rig" }'))
    assert plane.sources["B1"].text == "fitted to mine.csv; my rig"


def test_texts_lose_the_blanks_around_them(tmp_path: Path):
    plane = load(tmp_path, 'title = " Brief "\ndescription = """\nA light taildragger.\n"""')
    assert (plane.title, plane.description) == ("Brief", "A light taildragger.")


def test_symbols_and_names_and_a_byte_order_mark_are_welcome(tmp_path: Path):
    plane = load(tmp_path, "\ufeff" + BRIEF.replace("mass =", "m ="))
    assert plane["mass"] == plane["m"]


# --- Mistakes ---------------------------------------------------------------------------------


def test_every_mistake_is_reported_at_once_with_its_line(tmp_path: Path):
    text = BRIEF.replace("1650 lb", "748 m").replace("yaw_inertia", "yaw_inertai")
    text = text.replace("62 mph", "62 kmh").replace("168 in", "-168 in")
    found = mistakes(tmp_path, text)
    assert [(m.line, m.key) for m in found] == [
        (5, "airframe.mass"),
        (6, "airframe.yaw_inertai"),
        (12, "stations.tail_station"),
        (18, "runway.speed"),
    ]
    with pytest.raises(AircraftFileError) as caught:
        load(tmp_path, text)
    message = str(caught.value)
    assert message.startswith(f"{tmp_path / 'plane.toml'} has 4 mistakes:\n  line 5, airframe.mass")
    assert message.count("; expected ") == 4


@pytest.mark.parametrize(
    ("key", "entry", "found", "expected"),
    [
        ("mass", '"748 m"', "'748 m', a length", "a mass, such as '1.5 kg'"),
        ("mass", '"1650 lbf"', "a force", "a mass"),
        ("mass", '"light"', "not a number with a unit", "a mass"),
        ("mass", '""', "not a number with a unit", "a mass"),
        ("mass", '"748 kgg"', "unknown unit 'kgg' (did you mean kg", "a mass"),
        ("mass", "true", "True", "a mass"),
        ("mass", "[1, 2]", "[1, 2]", "a mass"),
        ("mass", "1979-05-27", "datetime.date(1979, 5, 27)", "a mass"),
        ("mass", "nan", "nan", "a positive number"),
        ("mass", "inf", "inf", "a positive number"),
        ("mass", "-1", "-1", "a positive number"),
        ("mass", "0", "0", "a positive number"),
        ("tail_area", '"-1 m^2"', "'-1 m^2'", "zero or a positive number"),
        ("mass", '{ source = "x" }', "no value", "value = a mass"),
        ("mass", '{ value = 1, sauce = "x" }', "unknown field 'sauce'", "source"),
        ("mass", "{ value = 1, source = 3 }", "source = 3", "a text"),
        ("mass", '{ value = 1, estimate = "yes" }', "estimate = 'yes'", "true or false"),
        ("tail_wheel_stiffness", '"70 N"', "a force", "a stiffness, such as '1.5 N/rad'"),
        ("tail_wheel_stiffness", '"70 lb/deg"', "'70 lb/deg'", "(as a force, lb is lbf)"),
        ("mass", '"1,650 lb"', "'1,650 lb', with a comma", "a mass"),
        ("tail_station", '"-15 in"', "-15 in", "a station behind the CG, 15.2 in: stations count"),
        ("table", '"nothing.csv"', "'nothing.csv'", "goodyear-6.00-6"),
        ("table", "3", "3", "a CSV file beside plane.toml"),
        ("title", "3", "3", "a text"),
        ("title", '["Brief"]', "['Brief']", "a text"),
        ("title", '{ value = "Brief" }', "{'value': 'Brief'}", "a text"),
        ("mass", "{ value = [748] }", "[748]", "a mass"),
        ("mass", "{ value = { value = 748 } }", "{'value': 748}", "a mass"),
        ("mass", "{ value = true }", "True", "a mass"),
        ("mass", "{ }", "no value", "value = a mass"),
        ("mass", f"1{400 * '0'}", "1000", "a mass"),
        ("mass", '{ value = "-1 lb", estimate = true }', "'-1 lb'", "a positive number"),
        ("mass", '{ value = 1, source = ["x"] }', "source = ['x']", "a text"),
        ("mass", "{ value = 1, estimate = 1 }", "estimate = 1", "true or false"),
        ("mass", "{ value = 1, unit = 'kg' }", "unknown field 'unit'", "value, source, estimate"),
        ("table", "['goodyear-6.00-6.csv']", "['goodyear-6.00-6.csv']", "a CSV file beside"),
        ("table", "{ source = 'my rig' }", "no value", "value = a file name"),
    ],
)
def test_a_mistake_says_what_was_found_and_what_was_expected(
    tmp_path: Path, key: str, entry: str, found: str, expected: str
):
    mistake = the_mistake(tmp_path, changed(key, entry))
    assert mistake.key.rpartition(".")[2] == key
    assert mistake.line is not None
    assert found in mistake.found
    assert expected in mistake.expected


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("tail_whel_stiffness = 3", "tail_wheel_stiffness"),
        ("qqqqqq = 3", "groundroll new"),
        ("[main_tire]\ntable = 'goodyear-6.00-6.csv'", "main_tires.table"),
        ("tail_whel_stiffness = { value = 3, source = 'x' }", "tail_wheel_stiffness"),
        ("[tail]\n[tail.wheel]\ntail_whel_stiffness = 3", "tail_wheel_stiffness"),
        ("[[tail_whel_stiffness]]\nvalue = 3", "tail_wheel_stiffness"),
    ],
)
def test_an_unknown_key_names_the_nearest(tmp_path: Path, line: str, expected: str):
    mistake = the_mistake(tmp_path, f"{BRIEF}\n{line}")
    assert mistake.found == "an unknown key"
    assert expected in mistake.expected


def test_what_a_file_says_of_itself_is_at_its_top(tmp_path: Path):
    assert the_mistake(tmp_path, f"titel = 'Brief'\n{BRIEF}").expected.startswith("title")
    assert the_mistake(tmp_path, f"{BRIEF}\ntitle = 'Brief'").key == "runway.title"


def test_a_value_where_a_table_belongs(tmp_path: Path):
    mistake = the_mistake(tmp_path, "main_tires = 3")
    assert (mistake.key, mistake.found, mistake.expected) == ("main_tires", "3", "a table")


def test_mistakes_have_the_line_they_are_in_however_it_is_written(tmp_path: Path):
    text = (
        """
        title = [
            "a list",
        ]
        description = '''
        mass = -1
        '''
        airframe.mass = "748 s"  # dotted
        wing = { gravity = -9.81 }  # inline
        "quoted" . 'tail_area' = true

        [deep.deeper]
        speed = [100]
        [deep.deeper.yaw_inertia]
        source = """
        + '"""[gravity]"""'
        + """
        [deep.deepest.b]
        value = "3 lb"
        sauce = "x"
        """
    )
    assert [(m.line, m.key, m.found) for m in mistakes(tmp_path, text)] == [
        (2, "title", "['a list']"),
        (8, "airframe.mass", "'748 s', a time"),
        (9, "wing.gravity", "-9.81"),
        (10, "quoted.tail_area", "True"),
        (13, "deep.deeper.speed", "[100]"),
        (14, "deep.deeper.yaw_inertia", "no value"),
        (16, "deep.deepest.b", "'3 lb', a mass"),
        (16, "deep.deepest.b", "an unknown field 'sauce'"),
    ]


@given(
    st.dictionaries(
        st.sampled_from([s for s in parameter_symbols() if s not in FOLLOWS and s[0] != "x"]),
        st.sampled_from(["1", "{ value = 1 }", *WRONG]),
    )
)
def test_the_lines_with_mistakes_are_named_and_no_others(entries: dict[str, str]):
    with TemporaryDirectory() as folder:
        text = "\n".join(f"{s} = {entry}" for s, entry in entries.items())
        wrong = [n for n, entry in enumerate(entries.values(), start=1) if entry in WRONG]
        if wrong:
            assert [m.line for m in mistakes(Path(folder), text)] == wrong
        else:
            assert set(load(Path(folder), text).given) == set(entries)


def test_a_value_given_twice_names_the_other_place(tmp_path: Path):
    mistake = the_mistake(tmp_path, f"{BRIEF}\n[more]\nm = 748")
    assert (mistake.key, mistake.expected) == ("more.m", "it once: it is in airframe.mass too")
    mistake = the_mistake(tmp_path, "mass = 748\nm = 748")
    assert (mistake.line, mistake.expected) == (2, "it once: it is in mass too")


def test_a_bad_tire_table_is_a_mistake_of_the_file(tmp_path: Path):
    (tmp_path / "bad.csv").write_text("slip_angle_deg,1000\n1,x\n", encoding="utf-8")
    mistake = the_mistake(tmp_path, changed("table", '"bad.csv"'))
    assert "'x' is not a finite number" in mistake.found


@pytest.mark.parametrize(
    ("lines", "key", "expected"),
    [
        ("L = '4.7752 m'", "L", "4.5212 m, which follows from main_gear_arm and tail_arm"),
        ("a = '1 m'", "a", "0.64008 m, which follows from cg_station and main_gear_station"),
        ("cg_aft_limit = '14 in'", "stations.cg_station", "at most cg_aft_limit, 14 in"),
        ("cg_forward_limit = '16 in'", "stations.cg_station", "at least cg_forward_limit, 16 in"),
        (
            "cg_forward_limit = '16 in'\ncg_aft_limit = '14 in'",
            "cg_forward_limit",
            "at most cg_aft_limit, 14 in: stations count aft",
        ),
        ("f = 1.2", "f", "a fraction from 0 to 1"),
        ("f = 0.8\nFz = '3183 N'", "Fz", "which follows from mass and gravity and main_gear"),
        ("F_tail_load = '2000 N'", "F_tail_load", "1039"),
    ],
)
def test_data_that_do_not_agree_are_named(tmp_path: Path, lines: str, key: str, expected: str):
    mistake = the_mistake(tmp_path, f"{lines}\n{BRIEF}")
    assert mistake.key == key
    assert expected in mistake.expected


def test_what_agrees_within_a_tape_measure_is_no_mistake(tmp_path: Path):
    assert load(tmp_path, f"L = '4.525 m'\nFz = '3140 N'\n{BRIEF}")["L"] == 4.525


def test_a_tricycle_must_say_what_its_nose_wheel_leaves(tmp_path: Path):
    assert "a nose wheel carries" in the_mistake(tmp_path, tricycle()).expected
    assert load(tmp_path, f"f = 0.9\n{tricycle()}")["a"] < 0


def test_a_nose_wheel_without_the_cg_says_nothing(tmp_path: Path):
    lines = [
        s for s in BRIEF.splitlines() if not s.startswith(("cg_st", "main_gear_st", "tail_st"))
    ]
    arms = "\n".join(["a = -0.3", "b = 4", "x_nose = -1", *lines])
    assert "nose_wheel_station from which it follows" in the_mistake(tmp_path, arms).expected


def test_the_stations_of_a_tricycle_give_its_loads(tmp_path: Path):
    plane = load(tmp_path, f"x_nose = '-35 in'\n{tricycle()}")
    weight = plane["m"] * plane["g"]
    assert 2 * plane["Fz"] / weight == pytest.approx(50.2 / 60)
    assert plane["F_tail_load"] == 0


@pytest.mark.parametrize(
    ("lines", "key", "expected"),
    [
        ("x_nose = '20 in'", "x_nose", "a station ahead of the CG, 15.2 in"),
        ("x_nose = '-35 in'\nFz = '3400 N'", "Fz", "3071.4 N, which follows from"),
        ("x_nose = '-35 in'\nF_tail_load = '900 N'", "F_tail_load", "0 N, which follows from"),
        ("f = 0.9\nx_nose = '20 in'", "x_nose", "the main gear is behind it"),
    ],
)
def test_stations_of_a_tricycle_that_do_not_agree_are_named(
    tmp_path: Path, lines: str, key: str, expected: str
):
    mistake = the_mistake(tmp_path, f"{lines}\n{tricycle()}")
    assert mistake.key == key
    assert expected in mistake.expected


def test_a_fraction_beside_the_stations_of_a_tricycle_is_told(tmp_path: Path):
    stations = f"x_nose = '-35 in'\n{tricycle()}"
    given = load(tmp_path, f"f = 0.9\n{stations}")
    assert given["f"] == 0.9
    note = "main_gear_weight_fraction is given as 0.9; 0.83667 would follow"
    assert note in gr.check(given).notes
    agreed = gr.check(load(tmp_path, f"f = 0.8367\n{stations}"))
    assert not any("would follow" in text for text in agreed.notes)


def test_a_stiffness_or_fraction_that_is_given_overrides_what_follows(tmp_path: Path):
    plane = load(tmp_path, f"f = 1\nC_alpha = '441.63 N/deg'\n{BRIEF}")
    assert plane["C_alpha"] == pytest.approx(np.rad2deg(441.63))


@pytest.mark.parametrize("content", [b"mass = = 3", b"\xff\xfe", b"[a\n", b"a = 1\na = 2\n"])
def test_what_is_not_toml_is_said_with_the_place(tmp_path: Path, content: bytes):
    path = tmp_path / "plane.toml"
    path.write_bytes(content)
    with pytest.raises(gr.GroundrollError, match=r"plane.toml is not (valid TOML|a text).*: .*\d"):
        gr.Aircraft.load(path)


def test_a_file_that_is_not_there(tmp_path: Path):
    with pytest.raises(gr.GroundrollError, match=r"cannot read .*none.toml: No such file"):
        gr.Aircraft.load(tmp_path / "none.toml")


def test_an_unknown_name_names_the_nearest():
    with pytest.raises(gr.GroundrollError, match="did you mean cessna-170"):
        gr.Aircraft.load("cesna-170")


# --- The packaged aircraft --------------------------------------------------------------------


def test_there_are_a_taildragger_and_a_tricycle_beside_the_thesis():
    assert {"brott", "cessna-170", "cessna-172p"} <= set(packaged())
    assert gr.Aircraft.load("cessna-170")["a"] > 0
    assert gr.Aircraft.load("cessna-172p")["a"] < 0


@pytest.mark.parametrize("name", packaged())
def test_a_packaged_aircraft_has_a_source_for_every_number(name: str):
    plane = gr.Aircraft.load(name)
    assert plane.title
    assert plane.description
    assert plane.source
    for symbol in plane.given:
        assert plane.sources[symbol].text, symbol


@pytest.mark.parametrize("name", packaged())
@pytest.mark.parametrize("model", ["linear", "nonlinear"])
def test_a_packaged_aircraft_runs_and_is_stable_at_its_speed(name: str, model: str):
    plane = gr.Aircraft.load(name)
    run = gr.simulate(plane, model=model, v0=0.1, t=8.0, samples=11)
    assert abs(run["r"][-1]) < 1e-4
    assert gr.linearize(plane, model=model).decay_rate > 0


def test_the_loads_of_the_cessna_170_are_those_on_scales():
    """A 170 at 1626 lb had 116 lb on its tail wheel (forum.cessna170.org, post 100596)."""
    plane = gr.Aircraft.load("cessna-170").replace(
        m="1626 lb", main_gear_station="18.5 in", tail_station="249.375 in"
    )
    on_scales = (1510 * 18.5 + 116 * 249.375) / 1626
    loaded = plane.replace(cg_station=f"{on_scales} in")
    assert from_si(float(loaded["F_tail_load"]), "N", "lbf") == pytest.approx(116, abs=0.1)


def test_the_nose_wheel_of_the_cessna_172p_carries_the_rest():
    plane = gr.Aircraft.load("cessna-172p")
    x_cg, x_main, x_nose = (float(plane[s]) for s in ("x_cg", "x_main", "x_nose"))
    assert plane["f"] == pytest.approx((x_cg - x_nose) / (x_main - x_nose), rel=1e-12)
    assert "f" not in plane.given


# --- What is usual ----------------------------------------------------------------------------


@pytest.mark.parametrize("rule", _usual(), ids=lambda rule: rule["quantity"])
def test_every_rule_of_what_is_usual_can_be_applied_and_has_a_source(rule: dict[str, str]):
    (unit,) = (q.unit for q in QUANTITIES.values() if q.name == rule["quantity"])
    low, high = (to_si(str(rule[bound]), unit, "rule") for bound in ("low", "high"))
    assert low < high
    assert rule["meaning"]
    assert rule["source"]
    assert rule.get("gear") in (None, "taildragger", "tricycle")


def test_a_check_is_for_python_too():
    found = gr.check(gr.Aircraft.load("cessna-170"))
    assert not any(found.missing.values())
    assert "yaw_inertia" in found.estimates
    assert "mass" not in found.estimates
    share = next(k for k in found.known if k.symbol == "third_load")
    plane = found.aircraft
    assert share.value == pytest.approx(1 - plane["f"])
    assert share.follows_from == ("x_main", "x_tail", "x_cg")
    assert "quantities known" in repr(found)


def test_a_check_of_an_empty_aircraft_names_all_that_is_missing():
    found = gr.check(gr.Aircraft("empty", {}))
    known = {k.symbol for k in found.known}  # constants, and what follows from these alone
    assert all(set(k.follows_from) <= known for k in found.known)
    assert len(found.missing["nonlinear"]) == len(MODELS["nonlinear"].parameters)


# --- The aircraft and its units ---------------------------------------------------------------


def test_an_aircraft_does_not_freeze_the_array_it_is_given():
    masses = np.array([700.0, 800.0])
    plane = gr.Aircraft.load("brott").replace(m=masses)
    masses[0] = 1.0
    assert plane["m"][0] == 700.0


def test_limits_are_parameters_too():
    assert {"x_forward", "x_aft"} <= set(parameter_symbols())


@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [
        ("100 km/h", "m/s", 100 / 3.6),
        ("100", "m/s", 100),
        ("441.63 N/deg", "N/rad", np.rad2deg(441.63)),
        ("-8.81055e-6 1/N", "1/N", -8.81055e-6),
        ("2.2918e-5 1/(deg N)", "1/(rad N)", np.rad2deg(2.2918e-5)),
        ("\N{MINUS SIGN}10 in", "m", -0.254),
        ("85 %", "1", 0.85),
        ("6 rpm", "rad/s", 0.2 * np.pi),
    ],
)
def test_a_number_with_a_unit(text: str, unit: str, value: float):
    assert to_si(text, unit, "here") == pytest.approx(value, rel=1e-12)


@pytest.mark.parametrize(
    ("text", "unit"),
    [("3 N", "N/rad"), ("3 Hz", "rad/s"), ("3 1/s", "rad/s"), ("3 deg", "1"), ("3 kg", "N")],
)
def test_an_angle_is_not_a_pure_number(text: str, unit: str):
    with pytest.raises(UnitError, match="here: found"):
        to_si(text, unit, "here")


@pytest.mark.parametrize("symbol", parameter_symbols())
def test_the_unit_of_every_parameter_is_one_that_a_file_may_use(symbol: str):
    unit = QUANTITIES[symbol].unit
    assert to_si(f"2 {'' if unit == '1' else unit}", unit, symbol) == pytest.approx(2)
