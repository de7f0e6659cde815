"""The command line: what it prints where, with which exit code, and that its help is true."""

import csv
import importlib
import io
import json
import re
import shlex
import signal
import subprocess
import sys
import warnings
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import click
import numpy as np
import pytest
from click.testing import CliRunner

import groundroll as gr
from groundroll import cli
from groundroll.aircraft.aircraft import packaged
from groundroll.aircraft.template import _OTHER_NAMES, template
from groundroll.cli import output
from groundroll.generated import PACKS
from groundroll.model.models import as_model
from groundroll.model.names import MODELS, QUANTITIES, parameter_symbols


def command(name: str) -> click.Command:
    found = cli._group.get_command(click.Context(cli._group), name)
    assert found is not None
    return found


KEEPING = ["simulate", "linearize", "trim", "map", "ensemble", "survival"]
FORMATS = [  # place has a test of its own
    n for n in cli.COMMANDS if n != "place" and any("--format" in p.opts for p in command(n).params)
]


class Result(NamedTuple):
    code: int
    out: str
    err: str


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]):
    """Run the command line in an empty folder, in this process."""
    monkeypatch.chdir(tmp_path)

    def go(*arguments: str) -> Result:
        capsys.readouterr()
        code = cli.main(list(arguments))
        return Result(code, *capsys.readouterr())

    return go


def example(name: str) -> str:
    """The example in the help of a command."""
    text = CliRunner().invoke(command(name), ["--help"]).output
    (line,) = re.findall(r"^ +groundroll (.*)$", text.partition("Example:")[2], re.MULTILINE)
    return line


# --- Help --------------------------------------------------------------------------------------


def test_every_command_is_described_once_and_exists():
    for name in cli.COMMANDS:
        module = importlib.import_module(f"groundroll.cli.{name.replace('-', '_')}")
        assert module.command.name == name


#: Those whose example needs long, or a file of the user's.
LONG = {"derive", "import", "place", "study"}


@pytest.mark.parametrize("name", [name for name in cli.COMMANDS if name not in LONG])
def test_the_example_in_the_help_works(run, name: str):
    line = example(name)
    assert line.startswith(name)
    assert run(*shlex.split(line)).code == 0


@pytest.mark.parametrize("name", cli.COMMANDS)
def test_every_option_is_explained(name: str):
    for parameter in command(name).params:
        assert isinstance(parameter, click.Argument) or parameter.help, parameter.name


def test_help_is_quick_because_it_imports_nothing_heavy():
    code = "import sys; from groundroll.cli import main; main(['--help']); print(*sys.modules)"
    result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    heavy = {"casadi", "matplotlib", "pint", "pydantic", "numpy", "groundroll.cli.simulate"}
    assert "simulate" in result.stdout
    assert not heavy & set(result.stdout.split())


@pytest.mark.parametrize(
    ("word", "expected"),
    [
        ("sim", "simulate"),
        ("check cessna-17", "cessna-172p"),
        ("check b --set tail_a", "tail_area="),
    ],
)
def test_the_shell_can_complete(word: str, expected: str, monkeypatch: pytest.MonkeyPatch):
    from click.shell_completion import BashComplete

    *before, last = word.split()
    complete = BashComplete(cli._group, {}, "groundroll", "_GROUNDROLL_COMPLETE")
    assert expected in [item.value for item in complete.get_completions(before, last)]


# --- The three formats ---------------------------------------------------------------------------


@pytest.mark.parametrize("name", FORMATS)
def test_json_is_json_without_nan_and_alone_on_stdout(run, name: str):
    result = run(*_bare(name), "--format", "json")
    assert result.code == 0
    assert json.loads(result.out, parse_constant=pytest.fail)


@pytest.mark.parametrize("name", FORMATS)
def test_csv_has_one_width_and_a_header(run, name: str):
    header, *rows = csv.reader(io.StringIO(run(*_bare(name), "--format", "csv").out))
    assert rows
    assert {len(row) for row in rows} == {len(header)}
    assert all(header) or name == "linearize"


@pytest.mark.parametrize("name", FORMATS)
def test_a_result_goes_to_a_file_if_wanted(run, name: str, tmp_path: Path):
    to_stdout = run(*_bare(name), "--format", "csv")
    to_file = run(*_bare(name), "--format", "csv", "--out", "result.csv")
    assert to_file.out == ""
    assert "wrote result.csv" in to_file.err
    assert (tmp_path / "result.csv").read_text(encoding="utf-8") == to_stdout.out


def test_the_suffix_of_a_file_says_its_format(run, tmp_path: Path):
    words = ("map", "brott", "--x", "speed=10:40:3", "--y", "a=-1:1:2")
    for form in ("csv", "json"):
        out = run(*words, "--format", form).out
        assert run(*words, "--out", f"map.{form}").out == ""
        assert (tmp_path / f"map.{form}").read_text(encoding="utf-8") == out
    run(*words, "--out", "map.txt", "--no-plot")
    assert (tmp_path / "map.txt").read_text(encoding="utf-8") == run(*words, "--no-plot").out


@pytest.mark.parametrize("suffix", [".npz", ".nc"])
@pytest.mark.parametrize("name", KEEPING)
def test_a_result_is_kept_with_all_that_went_in(run, name: str, suffix: str, tmp_path: Path):
    result = run(*_bare(name), "--out", f"kept{suffix}")
    assert (result.code, result.out, result.err) == (0, "", f"wrote kept{suffix}\n")
    assert [path.name for path in tmp_path.iterdir()] == [f"kept{suffix}"]
    kept = gr.Result.load(f"kept{suffix}")
    assert run("info", f"kept{suffix}").out.startswith(repr(kept))
    found = json.loads(run("info", f"kept{suffix}", "--format", "json").out)
    assert found["aircraft"] == kept.aircraft.name
    assert found["inputs"]["m"] == float(kept.aircraft["m"])
    made = found["provenance"]
    assert made["equations"] == PACKS[made["model"]].digest
    assert found["arrays"].keys() >= {str(name) for name in kept.to_xarray()}


def test_info_says_if_other_equations_made_a_file(run, monkeypatch: pytest.MonkeyPatch):
    run("linearize", "brott", "--out", "lin.npz")
    was = PACKS["nonlinear"].digest
    other = replace(as_model("nonlinear"), digest="0123456789abcdef")
    monkeypatch.setattr("groundroll.results.store.as_model", lambda model: other)
    monkeypatch.setattr("groundroll.model.models.as_model", lambda model: other)
    told = run("info", "lin.npz").out
    assert f"equations of the model nonlinear: {was}, now they are other" in told


def _bare(name: str) -> list[str]:
    """The example of a command without format and picture, on a small grid."""
    words = shlex.split(example(name))
    for option in ("--format", "--plot"):
        if option in words:
            del words[words.index(option) : words.index(option) + 2]
    return [f"{word}:5" if ":" in word else word for word in words]


@pytest.mark.parametrize("name", ["ensemble", "survival"])
def test_results_do_not_depend_on_the_number_of_threads(run, name: str):
    one, two = (run(*_bare(name), "--threads", n, "--format", "csv").out for n in "12")
    assert one == two


# --- The same numbers as the Python API ---------------------------------------------------------


def test_simulate_gives_what_the_api_gives(run):
    found = json.loads(run("simulate", "brott", "--v0", "10 cm/s", "--format", "json").out)
    expected = gr.simulate(gr.Aircraft.load("brott"), v0=0.1)
    for name in ("t", "v", "theta", "F_main"):
        series = expected.t if name == "t" else expected[name]
        np.testing.assert_allclose(found[name], series, rtol=0, atol=0)
    assert found["metrics"]["displacement"] == float(expected.metrics().displacement)
    assert found["units"]["theta"] == "rad"


def test_simulate_tells_how_a_gust_is_answered(run):
    words = ("simulate", "brott", "--disturbance", "400 N", "--gust", "one_minus_cosine")
    words += ("--gust-start", "500 ms", "--gust-length", "0.8 s")
    found = json.loads(run(*words, "--format", "json").out)
    gust = gr.gusts.one_minus_cosine(400.0, 0.5, 0.8)
    expected = gr.simulate(gr.Aircraft.load("brott"), disturbance=gust)
    assert found["gust"] == gust.label
    np.testing.assert_allclose(found["v"], expected["v"], rtol=0, atol=0)
    for state in ("v", "r", "y", "theta"):
        metrics = expected.metrics(state)
        assert found["metrics"][state]["peak"] == float(metrics.peak)
        assert found["metrics"][state]["recovery_time"] == float(metrics.recovery_time)
    assert found["metrics"]["r"]["rise_time"] is None
    assert found["metrics"]["rotation"] == float(expected.metrics().rotation)
    text = run(*words, "--no-plot").out
    assert re.search(r"peak_time +\S+ s +\S+ s +\S+ s +\S+ s\n", text)
    assert re.search(r"rise_time +none +none +\S+ s +\S+ s\n", text)


def test_a_step_has_an_overshoot_and_may_end(run):
    words = ("simulate", "brott", "--disturbance", "100 N", "--gust", "step")
    stays = json.loads(run(*words, "--format", "json").out)
    ends = json.loads(run(*words, "--gust-length", "2", "--format", "json").out)
    plane = gr.Aircraft.load("brott")
    expected = gr.simulate(plane, disturbance=gr.gusts.step(100.0)).metrics("r")
    assert stays["metrics"]["r"]["overshoot"] == float(expected.overshoot) > 0
    assert stays["metrics"]["displacement"] is None
    assert ends["gust"] == "step of 100 N from 0 s to 2 s"
    assert ends["metrics"]["r"]["steady"] == 0


def test_states_that_differ_in_case_are_told_apart(run):
    found = json.loads(run("simulate", "brott", "--Y0", "3", "--y0", "1", "--format", "json").out)
    assert (found["Y"][0], found["y"][0]) == (3, 1)


def test_csv_over_time(run):
    result = run("simulate", "brott", "--v0", "0.1", "--samples", "11", "--format", "csv")
    header, *rows = csv.reader(io.StringIO(result.out))
    assert header[:3] == ["t [s]", "v [m/s]", "r [rad/s]"]
    assert len(rows) == 11
    assert float(rows[0][1]) == 0.1


def test_linearize_gives_what_the_api_gives(run):
    words = ("linearize", "brott", "--v", "0.4 m/s", "--r", "1 deg/s", "--speed", "60 km/h")
    found = json.loads(run(*words, "--format", "json").out)
    point = gr.OperatingPoint(v=0.4, r=float(np.radians(1)))
    lin = gr.linearize(gr.Aircraft.load("brott"), at=point, speed=60 / 3.6)
    for name in "ABCD":
        np.testing.assert_allclose(found[name], getattr(lin, name), rtol=1e-12)
    assert found["eigenvalues"][0] == pytest.approx(
        [lin.eigenvalues[0].real, lin.eigenvalues[0].imag]
    )


def test_trim_gives_what_the_api_gives(run):
    found = json.loads(run("trim", "brott", "--disturbance", "100 lbf", "--format", "json").out)
    expected = gr.trim(gr.Aircraft.load("brott"), disturbance=444.822162)
    assert found["v"] == pytest.approx(expected["v"].tolist(), rel=1e-6)
    assert found["stable"] == [True]


def test_that_there_is_no_equilibrium_is_an_answer(run):
    result = run("trim", "brott", "--disturbance", "9000 N")
    assert (result.code, result.err) == (0, "")
    assert "no equilibrium" in result.out


def test_map_gives_what_the_api_gives(run):
    axes = ("--x", "speed=36 km/h:180 km/h:3", "--y", "a=-0.5:0.5:5", "--of", "damping_ratio")
    found = json.loads(run("map", "brott", *axes, "--format", "json").out)
    expected = gr.stability_map(
        gr.Aircraft.load("brott"),
        ("u", np.linspace(10, 50, 3)),
        ("a", np.linspace(-0.5, 0.5, 5)),
        "damping_ratio",
    )
    np.testing.assert_allclose(np.array(found["values"], dtype=float), expected.values, rtol=1e-9)
    assert found["stable"] == expected.stable.tolist()


def test_set_changes_parameters_with_units_and_lets_them_follow(run):
    words = ("--set", "cg_station=16 in", "--set", "mass=800", "--set", "f=", "--set", "Ct=")
    found = json.loads(run("check", "brott", *words, "--format", "json").out)
    values = {row["symbol"]: row["value"] for row in found["quantities"]}
    plane = gr.Aircraft.load("brott").replace(x_cg="16 in", m=800, f=None, Ct=None)
    for symbol in ("x_cg", "m", "a", "f", "Ct"):
        assert values[symbol] == float(plane[symbol])


def test_ensemble_gives_what_the_api_gives(run):
    words = ("--vary", "speed=36 km/h:144 km/h:3", "--v0", "0.5:2:4", "--r0", "1 deg/s")
    more = ("--extremes", "psi,alpha", "--limits", "Y=1 ft", "--tol", "1e-8", "--t", "4")
    found = json.loads(run("ensemble", "brott", *words, *more, "--format", "json").out)
    expected = gr.ensemble(
        gr.Aircraft.load("brott"),
        4.0,
        extremes=["psi", "alpha"],
        limits={"Y": 0.3048},
        tol=1e-8,
        speed=np.linspace(10, 40, 3)[:, None],
        v0=np.linspace(0.5, 2, 4),
        r0=np.radians(1),
    )
    assert found["shape"] == [3, 4]
    for kind in ("final", "largest", "first"):
        arrays = getattr(expected, kind)
        assert found[kind].keys() == arrays.keys()
        for s, values in arrays.items():
            wanted = np.where(np.isfinite(values), values, np.nan)
            np.testing.assert_allclose(np.array(found[kind][s], dtype=float), wanted, rtol=1e-12)


def test_csv_of_an_ensemble_is_one_line_for_each_trajectory(run):
    words = ("--vary", "a=0:1:3", "--vary", "v0=1:2:2", "--within", "psi=1 deg")
    result = run("ensemble", "brott", *words, "--format", "csv")
    header, *rows = csv.reader(io.StringIO(result.out))
    assert (header[:3], header[-1]) == (["a [m]", "v0 [m/s]", "v_end [m/s]"], "status")
    grid = [(float(row[0]), float(row[1])) for row in rows]
    assert grid == [(a, v0) for a in (0.0, 0.5, 1.0) for v0 in (1.0, 2.0)]
    lost = [row for row in rows if row[-1] == "left the range"]
    assert 0 < len(lost) < 6
    assert result.err == f"not every trajectory is ok: {len(lost)} left the range\n"


def test_a_random_draw_lies_within_the_ranges_and_can_be_repeated(run):
    words = ("ensemble", "brott", "--vary", "speed=10:40", "--v0", "0.1:0.2", "--random", "50")
    one, again, other = (
        json.loads(run(*words, "--seed", seed, "--format", "json").out) for seed in "334"
    )
    assert one == again
    assert one["varied"] != other["varied"]
    speed, v0 = (np.array(one["varied"][s]) for s in ("u", "v0"))
    assert (speed.shape, v0.shape) == ((50,), (50,))
    assert 10 <= speed.min() < 15 < 35 < speed.max() <= 40
    assert 0.1 <= v0.min() < v0.max() <= 0.2


@pytest.mark.parametrize(
    "words",
    [
        ("ensemble", "brott", "--v0", "0.01:1:9"),
        ("ensemble", "brott", "--v0", "0.01:1:4", "--vary", "a=0:1:3", "--vary", "r0=0:1:2"),
        ("ensemble", "brott", "--v0", "0.01:1", "--random", "99", "--limits", "psi=3 deg"),
        ("survival", "brott-physical", "--station=-4:0:3", "--speed", "20:40:2"),
    ],
    ids=["line", "worst", "spread", "stations"],
)
def test_ensembles_have_the_picture_that_fits(run, words: tuple[str, ...], tmp_path: Path):
    result = run(*words)
    name = f"{words[1]}-{words[0]}.png"
    assert (result.code, result.err) == (0, f"wrote {name}\n")
    assert (tmp_path / name).stat().st_size > 5_000


def test_survival_gives_what_the_api_gives(run):
    words = ("--station=-3 m:0 m:2", "--speed", "20:30:3", "--heading", "30 deg")
    words = (*words, "--half-width", "25 ft", "--settled", "0.2", "--t", "15")
    found = json.loads(run("survival", "brott-physical", *words, "--format", "json").out)
    expected = gr.survival(
        gr.Aircraft.load("brott-physical"),
        station=np.array([[-3.0], [0.0]]),
        speed=np.array([20.0, 25.0, 30.0]),
        heading=np.radians(30),
        half_width=7.62,
        settled=0.2,
        t=15.0,
    )
    for name in ("impulse", "velocity_change", "yaw_rate_change", "decay_rate", "fate"):
        np.testing.assert_allclose(found[name], getattr(expected, name), rtol=1e-12)


def test_survival_tells_of_islands_and_of_what_was_tried(run):
    words = ("survival", "brott-physical", "--station=-3.88", "--no-plot")
    assert "island" in run(*words, "--set", "Ct=70 N/deg").out
    out = run(*words, "--largest", "10").out
    assert re.search(r" 10 .* nothing tried$", out, re.MULTILINE)
    assert "island" not in out


def test_place_gives_the_station_its_worst_corner_and_a_picture(run, tmp_path: Path):
    words = shlex.split(example("place"))
    result = run(*words, "--format", "json", "--plot", "place.png")
    found = json.loads(result.out)
    assert (result.code, result.err) == (0, "wrote place.png\n")
    assert (tmp_path / "place.png").stat().st_size > 10_000
    assert found["envelope"]["speed"]["values"] == pytest.approx([20 * 0.514444, 50 * 0.514444])
    assert {bound["limit"] for bound in found["limits"]} >= {"nose_over", "decay_rate"}
    assert found["today"]["design"]["main_gear_station"] == pytest.approx(0.5588)
    assert found["placement"]["decay_rate"]["value"] > 0
    assert [price["of"] for price in found["binding"]] == ["nose_over at most 25.00 deg"]
    text = run(*words, "--no-plot").out
    assert re.search(
        r"main gear station \S+ mm = 26.\d\d in .* \(today 558.8 mm = 22.00 in\)", text
    )


def test_headers_are_stacked_where_a_terminal_is_narrow(monkeypatch: pytest.MonkeyPatch):
    header, rows = ["station [m]", "decay rate [1/s]", "beyond it"], [["0", "4.26", "nothing"]]
    monkeypatch.setattr(output, "_width", lambda: 42)
    assert len(output.table(header, rows, right=(0, 1)).splitlines()) == 2
    monkeypatch.setattr(output, "_width", lambda: 41)
    assert output.table(header, rows, right=(0, 1)).splitlines() == [
        "           decay",
        "  station   rate  beyond",
        "      [m]  [1/s]  it",
        "        0   4.26  nothing",
    ]


def test_fit_tire_reads_a_file(run, tmp_path: Path):
    from groundroll.tires.data import packaged_tables

    text = packaged_tables()["goodyear-6.00-6"].read_text(encoding="utf-8")
    (tmp_path / "mine.csv").write_text(text, encoding="utf-8")
    found = json.loads(run("fit-tire", "mine.csv", "--format", "json").out)
    assert found["data"] == "mine"
    assert {p["symbol"]: p["value"] for p in found["parameters"]} == pytest.approx(
        dict(gr.fit_tire().parameters)
    )


def test_fit_tire_tells_of_a_peak_beyond_the_data(run, tmp_path: Path):
    rows = [(1, 31, 41), (2, 60, 80), (4, 115, 155), (6, 165, 225), (10, 235, 330), (15, 280, 400)]
    lines = ["slip_angle_deg, 400 lbf, 600 lbf", *(",".join(map(str, row)) for row in rows)]
    (tmp_path / "ply.csv").write_text("\n".join(lines), encoding="utf-8")
    assert "of friction" in run("fit-tire", "ply.csv").out
    told = "the largest friction, 0.766 to 0.763 at 1779 to 2669 N of load, is extrapolated"
    assert json.loads(run("fit-tire", "ply.csv", "--format", "json").out)["notes"][0].startswith(
        told
    )


def test_info_names_what_is_there(run):
    found = json.loads(run("info", "--format", "json").out)
    assert set(found["aircraft"]) == set(packaged())
    assert set(found["models"]) == set(MODELS)


# --- Pictures ------------------------------------------------------------------------------------


@pytest.mark.parametrize("view", ["history", "runway"])
def test_people_get_a_picture_and_its_path(run, view: str, tmp_path: Path):
    result = run("simulate", "brott", "--v0", "0.1", "--view", view)
    assert result.err == "wrote brott-simulate.png\n"
    assert (tmp_path / "brott-simulate.png").read_bytes()[:4] == b"\x89PNG"


def test_the_kind_of_picture_is_that_of_its_suffix(run, tmp_path: Path):
    run("simulate", "brott", "--v0", "0.1", "--show", "v,r,alpha", "--plot", "run.svg")
    assert "<svg" in (tmp_path / "run.svg").read_text(encoding="utf-8")


@pytest.mark.parametrize("words", [("--no-plot",), ("--format", "csv"), ("--format", "json")])
def test_programs_get_no_picture(run, words: tuple[str, ...], tmp_path: Path):
    assert run("simulate", "brott", "--v0", "0.1", *words).err == ""
    assert not list(tmp_path.iterdir())


def test_a_picture_of_an_unknown_kind_is_an_error(run):
    result = run("simulate", "brott", "--v0", "0.1", "--plot", "run.xyz")
    assert result.code == 1
    assert "cannot write the picture run.xyz" in result.err


# --- check and new -------------------------------------------------------------------------------


def test_check_shows_values_as_written_their_sources_and_estimates(run):
    out = run("check", "cessna-170").out
    assert re.search(r"main_gear_station +x_main +22 +in +\[\d+\]", out)
    assert re.search(r"yaw_inertia +Izz +~1633 +slug ft\^2", out)
    assert re.search(r"main_gear_arm +a +21.05 +in +x_cg, x_main", out)
    assert re.search(r"tail_wheel_load +F_tail_load +206.74 +lbf", out)
    assert re.search(r"cornering_stiffness +C_alpha +~?112.75 +lbf/deg", out)
    assert re.search(r"tail_wheel_load +F_tail_load +0 +N ", run("check", "brott").out)
    assert "Scott 3-24B" in out


def test_check_warns_with_the_source_of_the_rule(run):
    out = run("check", "brott-physical", "--set", "main_gear_station=0 in").out
    assert "third_wheel_load_fraction is 9.0 %" not in out
    out = run("check", "brott-physical", "--set", "main_gear_station=14 in").out
    assert re.search(r"third_wheel_load_fraction is 0.8 %; usual is 8 % to 15 %: .*rule of", out)


def test_check_says_which_given_values_override_what_would_follow(run):
    out = run("check", "brott").out
    assert "main_gear_weight_fraction is given as 1; 0.85843 would follow" in out


def test_check_says_where_an_aircraft_is_unstable(run):
    unstable = "unstable from 19.7 km/h to 190.9 km/h"
    assert unstable in run("check", "brott", "--set", "Ct=10 N/deg").out


def test_check_names_a_cg_outside_its_limits(run):
    out = run("check", "brott", "--set", "cg_station=20 in").out
    assert "cg_station (x_cg): found" in out
    assert "at most cg_aft_limit, 16.8 in" in out


def test_check_says_how_it_reads_a_number_without_a_unit(run, tmp_path: Path):
    (tmp_path / "bare.toml").write_text("mass = '1320'\nspeed = 40\nCt = 0\nB1 = 1", "utf-8")
    out = run("check", "bare.toml").out
    assert re.search(r"mass +m +1320 +kg", out)
    notes = out.partition("Worth knowing")[2]
    assert "mass has no unit and is read as 1320 kg" in notes
    assert "speed has no unit and is read as 40 m/s" in notes
    assert notes.count("no unit") == 2
    assert "no unit" not in run("check", "cessna-170").out


def test_check_takes_pounds_for_slugs_as_a_slip(run):
    out = run("check", "cessna-170", "--set", "yaw_inertia=1633 lb ft^2").out
    assert "yaw_inertia is 68.815 kg m^2; usual is 150 kg m^2" in out
    assert "usual is 150 kg m^2" not in run("check", "cessna-170").out


def test_check_is_strict_if_asked(run):
    assert run("check", "brott").code == 0
    assert run("check", "brott", "--strict").code == 1


def test_check_reports_every_mistake_of_a_file_on_stderr(run, tmp_path: Path):
    (tmp_path / "bad.toml").write_text("mass = '3 m'\nmas = 3\n", encoding="utf-8")
    result = run("check", "bad.toml")
    assert (result.code, result.out) == (1, "")
    assert "bad.toml has 2 mistakes" in result.err
    assert "line 1, mass: found '3 m', a length; expected a mass" in result.err


def test_a_new_file_is_read_and_check_says_what_it_lacks(run, tmp_path: Path):
    assert run("new", "mine.toml").code == 0
    result = run("check", "mine.toml")
    assert result.code == 1
    assert "- mass (total mass)" in result.out
    assert "main_gear_arm" in result.out
    assert "or cg_station and main_gear_station" in result.out
    assert 'table = "mine.csv" in [main_tires]' in result.out
    assert "gravity" not in result.out.partition("Missing")[2]


def test_a_new_file_explains_every_key():
    text = template("mine", "mine.toml")
    for symbol in set(parameter_symbols()) - {"rho", "g", *_OTHER_NAMES}:
        q = QUANTITIES[symbol]
        unit = "" if q.unit == "1" else f" {q.unit}"
        line = f'#{q.name} = {{ value = "?{unit}", source = "" }} # {q.meaning}'
        assert line in text.replace("; follows if not given", "")
    assert '\nair_density = { value = "1.225 kg/m^3", source = "ISO 2533' in text
    assert '\ngravity = { value = "9.80665 m/s^2"' in text
    assert max(map(len, text.splitlines())) < 180


def test_a_new_file_can_be_used_once_it_is_filled_in(run, tmp_path: Path):
    """Round trip: a template filled with an aircraft's values is that aircraft."""
    plane = gr.Aircraft.load("cessna-170")
    run("new", "mine.toml")
    path = tmp_path / "mine.toml"
    lines = []
    for line in path.read_text(encoding="utf-8").splitlines():
        match = re.match(r"#(\w+) = \{ value = \"\?", line)
        key = match[1] if match else ""
        filled = key != "table" and match is not None and key in plane
        lines.append(line[1:].replace('"?', f'"{float(plane[key])!r}', 1) if filled else line)
    path.write_text("\n".join(lines), encoding="utf-8")
    again = gr.Aircraft.load(path)
    for symbol in parameter_symbols():
        if symbol in plane:
            assert again[symbol] == pytest.approx(float(plane[symbol]), rel=1e-12)
    assert run("check", "mine.toml").code == 0


def test_a_new_file_can_begin_as_a_copy_and_is_not_overwritten(run, tmp_path: Path):
    assert run("new", "mine.toml", "--like", "brott").code == 0
    assert gr.Aircraft.load(tmp_path / "mine.toml")["m"] == gr.Aircraft.load("brott")["m"]
    result = run("new", "mine.toml")
    assert result.code == 2
    assert "mine.toml exists; --force overwrites it" in result.err
    assert run("new", "mine.toml", "--force").code == 0


# --- Exit codes ----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("words", "code", "message"),
    [
        (["simulat"], 2, "unknown command 'simulat'; did you mean simulate?"),
        (["simulate"], 2, "Missing argument 'AIRCRAFT'"),
        (["simulate", "brott", "--sped", "3"], 2, "--speed"),
        (["simulate", "brott", "--speed", "3 kg"], 2, "found '3 kg', a mass; expected a speed"),
        (["simulate", "brott", "--set", "mass"], 2, "expected name=value"),
        (["simulate", "brott", "--set", "mas=3"], 2, "unknown parameter 'mas'"),
        (["simulate", "brott", "--set", "mass=3 m"], 2, "found '3 m', a length"),
        (["simulate", "brott", "--set", "mass=-3"], 2, "mass (m) must be positive"),
        (["map", "brott", "--x", "a=1", "--y", "u=1:2"], 2, "expected name=low:high"),
        (["map", "brott", "--x", "a=1:0", "--y", "u=1:2"], 2, "expected low < high"),
        (["map", "brott", "--x", "q=0:1", "--y", "u=1:2"], 2, "unknown parameter 'q'"),
        (["map", "brott", "--x", "a=0:1", "--y", "u=1:2", "--of", "dcay_rate"], 1, "decay_rate"),
        (["place", "brott", "--envelope", "sped=1:2"], 2, "did you mean speed?"),
        (["place", "brott", "--limit", "nose_over"], 2, "expected name=value"),
        (["place", "brott", "--envelope", "speed=3:2"], 1, "the range runs backwards"),
        (["ensemble", "brott"], 2, "nothing varies"),
        (["ensemble", "brott", "--vary", "a=0:1", "--vary", "a=0:2"], 2, "a is varied twice"),
        (["ensemble", "brott", "--vary", "v0=0:1", "--v0", "1"], 2, "v0 is given and varied"),
        (["ensemble", "brott", "--vary", "a=0:1:3", "--random", "9"], 2, "no number of points"),
        (["ensemble", "brott", "--v0", "0:1", "--random", "9", "--seed", "-1"], 2, "0 or more"),
        (["ensemble", "brott", "--v0", "1:"], 2, "expected low:high"),
        (["ensemble", "brott", "--v0", "0:1:x"], 2, "expected a whole number"),
        (["ensemble", "brott", "--v0", "0 kg:1"], 2, "a mass; expected a speed"),
        (["ensemble", "brott", "--v0", "0:1", "--limits", "psi"], 2, "expected name=value"),
        (["ensemble", "brott", "--v0", "0:1", "--limits", "spi=3"], 2, "did you mean psi"),
        (["ensemble", "brott", "--v0", "0:1", "--tol", "1"], 1, "tol must be from"),
        (["survival", "brott"], 1, "reverses its force"),
        (["survival", "brott-physical", "--half-width", "0"], 1, "half_width must be"),
        (["new", "plane.txt"], 2, "expected a name ending in .toml"),
        (["simulate", "brot"], 1, "did you mean brott?"),
        (["simulate", "none.toml"], 1, "cannot read none.toml: No such file"),
        (["simulate", "brott", "--t", "-1"], 1, "t must be a positive number"),
        (["simulate", "brott", "--v0", "0.1", "--show", "vv"], 1, "'vv'"),
        (["simulate", "brott", "--v0", "0.1", "--out", "no/where.csv"], 1, "cannot write"),
        (["fit-tire", "none.csv"], 1, "cannot read none.csv"),
        (["check", "brott", "--out", "x.npz"], 2, "this command keeps no result"),
        (["trim", "brott", "--out", "x.nc", "--format", "csv"], 2, "--format csv does not go"),
        (["ensemble", "brott", "--v0", "0:9:999999", "--out", "no/x.npz"], 1, "there is no folder"),
        (["info", "none.npz"], 1, "cannot read none.npz"),
        (["info", "none.toml"], 1, "must end in .npz or in .nc"),
    ],
)
def test_what_goes_wrong_has_a_code_and_a_message_on_stderr(
    run, words: list[str], code: int, message: str
):
    result = run(*words)
    assert (result.code, result.out) == (code, "") or "--show" in words
    assert message in result.err


def test_a_run_that_nothing_disturbs_says_so(run):
    assert "nothing disturbs the aircraft" in run("simulate", "brott", "--no-plot").err


@pytest.mark.parametrize("raised", [KeyboardInterrupt, click.Abort])
def test_an_interruption_is_clean(
    run, monkeypatch: pytest.MonkeyPatch, raised: type[BaseException]
):
    from groundroll.cli import info

    def interrupted(**_: object) -> None:
        raise raised

    monkeypatch.setattr(info.command, "callback", interrupted)
    code, out, err = run("info")
    assert (code, out, err.strip()) == (130, "", "groundroll: interrupted")


def test_an_interruption_that_foreign_code_makes_an_error_of_is_clean(
    run, monkeypatch: pytest.MonkeyPatch
):
    from groundroll.cli import info

    def failed(**_: object) -> None:
        try:
            signal.raise_signal(signal.SIGINT)
        except KeyboardInterrupt:
            raise TypeError("wrong type of arguments") from None

    monkeypatch.setattr(info.command, "callback", failed)
    code, out, err = run("info")
    assert (code, out, err.strip()) == (130, "", "groundroll: interrupted")
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_a_warning_is_one_line_on_stderr(run, monkeypatch: pytest.MonkeyPatch):
    from groundroll.cli import info

    def warned(**_: object) -> None:
        with warnings.catch_warnings():
            warnings.simplefilter("always")
            warnings.warn("no compiler", RuntimeWarning, stacklevel=1)

    monkeypatch.setattr(info.command, "callback", warned)
    assert run("info") == (0, "", "groundroll: warning: no compiler\n")


# --- As a process --------------------------------------------------------------------------------


def process(*words: str, **settings: object) -> subprocess.CompletedProcess[str]:
    program = [sys.executable, "-m", "groundroll", *words]
    return subprocess.run(program, capture_output=True, text=True, check=False, **settings)


def test_as_a_process_results_and_messages_are_kept_apart(tmp_path: Path):
    result = process("simulate", "brott", "--v0", "0.1", "--format", "csv", cwd=tmp_path)
    assert (result.returncode, result.stderr) == (0, "")
    assert result.stdout.startswith("t [s],v [m/s]")
    assert len(result.stdout.splitlines()) == 502


def test_as_a_process_a_failure_has_its_code(tmp_path: Path):
    result = process("check", "brot", cwd=tmp_path)
    assert (result.returncode, result.stdout) == (1, "")
    assert result.stderr.startswith("groundroll: unknown aircraft 'brot'")


def test_a_reader_that_leaves_early_is_no_trouble(tmp_path: Path):
    line = f"{shlex.quote(sys.executable)} -m groundroll simulate brott --format csv --samples 9999"
    result = subprocess.run(
        ["bash", "-c", f"{line} | head -1"], capture_output=True, text=True, cwd=tmp_path
    )
    assert result.stdout.startswith("t [s]")
    assert "Traceback" not in result.stderr
    assert "BrokenPipe" not in result.stderr
