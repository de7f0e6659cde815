"""The command line with models that have several inputs: what goes in comes out, with its unit."""

from __future__ import annotations

import csv
import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from own_models import FOUR, own

import groundroll as gr
from groundroll import cli

CAR = """
title = "A car of the tests"
m = "1500 kg"
Izz = 2500.0
g = 9.81

[parameters]
l_front = "1.2 m"
rear_arm = 1.6
front_stiffness = "1.2e5 N/rad"
C_rear = "150 kN/rad"
width = 1.5
grip = 0.9
wheel_load = "3.6 kN"
"""
#: Three inputs of its own, a speed that falls, parameters that stand in the file.
DRIVEN = ("--input", "steering=3 deg", "--input", "brake_left=0.2")
MOVING = ("--start", "u=72 km/h")
Run = Callable[..., str]


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Run:
    """Run a command with ``car.toml`` and the model in ``mine``: what it prints."""
    monkeypatch.chdir(tmp_path)
    Path("car.toml").write_text(CAR)
    Path("mine").symlink_to(own("four_wheels").folder)

    def go(*words: str, code: int = 0) -> str:
        capsys.readouterr()
        found = cli.main(list(words))
        told = capsys.readouterr()
        assert found == code, told.err
        return told.err if code else told.out

    return go


def simulated(**values: object) -> gr.Trajectory:
    given = {"u0": 20.0, "steering": "3 deg", "brake_left": 0.2, **values}
    return gr.simulate(FOUR, own("four_wheels"), **given)


def test_what_goes_in_comes_out_with_its_unit(run: Run) -> None:
    words = ("simulate", "car.toml", "--model", "mine/", *DRIVEN, *MOVING)
    found, expected = json.loads(run(*words, "--format", "json")), simulated()
    assert found["speed"] == 20.0
    assert found["units"]["steering"] == "rad"
    assert found["units"]["brake_left"] == "1"
    np.testing.assert_allclose(found["steering"], np.radians(3.0))
    np.testing.assert_allclose(found["brake_left"], 0.2)
    np.testing.assert_array_equal(found["brake_right"], 0.0)
    for s in ("u", "r", "Y", "F_front_left", "sum_Fx"):
        np.testing.assert_allclose(found[s], expected[s], rtol=1e-12, atol=1e-12)
    header, first, *_ = csv.reader(run(*words, "--format", "csv").splitlines())
    row = dict(zip(header, first, strict=True))
    assert (float(row["u [m/s]"]), float(row["brake_left"])) == (20.0, 0.2)
    assert float(row["steering [rad]"]) == np.radians(3.0)
    table = run(*words, "--no-plot")
    assert "car, four_wheels model, 20 m/s, 5 s" in table
    assert [line.split() for line in table.splitlines() if "  steering " in line] == [
        ["steering", "steering", "3", "3", "deg"]
    ]


@pytest.mark.parametrize("kind", ["npz", "nc"])
def test_what_is_kept_can_be_read(run: Run, kind: str) -> None:
    words = ("--model", "mine/", *DRIVEN, "--out", f"kept.{kind}")
    run("simulate", "car.toml", *words, *MOVING)
    kept, expected = gr.Trajectory.load(f"kept.{kind}"), simulated()
    for s, series in expected.values.items():
        np.testing.assert_allclose(kept[s], series, rtol=1e-12, atol=1e-12)
    assert "'car', four_wheels model" in run("info", f"kept.{kind}")
    run("linearize", "car.toml", *words, "--at", "u=20")
    lin = gr.Linearization.load(f"kept.{kind}")
    assert lin.inputs == ("steering", "brake_left", "brake_right")
    assert lin.at["steering"] == pytest.approx(np.radians(3.0))


def test_linearize_takes_every_state_and_input(run: Run) -> None:
    words = ("linearize", "car.toml", "--model", "mine/", "--at", "yaw_rate=5 deg/s", *DRIVEN)
    found = json.loads(run(*words, "--at", "u=72 km/h", "--set", "width=2 m", "--format", "json"))
    at = {"u": 20.0, "r": np.radians(5.0), "steering": np.radians(3.0), "brake_left": 0.2}
    expected = gr.linearize(FOUR, own("four_wheels"), at=at, width=2.0)
    assert found["at"] == pytest.approx({"v": 0.0, "brake_right": 0.0, **at})
    for name in "ABCD":
        np.testing.assert_allclose(found[name], getattr(expected, name), rtol=1e-12)
    table = run(*words, "--at", "u=72 km/h")
    assert (
        "20 m/s, v = 0 m/s, r = 0.087266 rad/s, steering = 0.05236 rad, brake_left = 0.2" in table
    )
    assert "drift" in table


def test_ensemble_varies_inputs_and_starts(run: Run) -> None:
    words = ("--vary", "steering=0 deg:3 deg:3", "--vary", "u0=36 km/h:72 km/h:2")
    words = ("ensemble", "car.toml", "--model", "mine/", *words, "--input", "brake_left=0.2")
    rows = list(csv.DictReader(run(*words, "--limits", "Y=5 ft", "--format", "csv").splitlines()))
    assert [float(row["steering [rad]"]) for row in rows[::2]] == list(np.radians([0, 1.5, 3]))
    assert [float(row["u0 [m/s]"]) for row in rows[:2]] == [10.0, 20.0]
    last = simulated(tol=1e-9)
    assert float(rows[-1]["u_end [m/s]"]) == pytest.approx(last["u"][-1], rel=1e-5)
    passes = last.t[np.argmax(np.abs(last["Y"]) > 5 * 0.3048)]
    assert float(rows[-1]["Y_first [s]"]) == pytest.approx(passes, abs=0.011)


@pytest.mark.parametrize("command", ["simulate", "linearize", "ensemble"])
@pytest.mark.parametrize("model", ["rollout", "landing_roll"])
def test_the_landing_roll_answers_too(run: Run, command: str, model: str) -> None:
    words = {
        "simulate": ("--start", "u=20", "--t", "0.5", "--no-plot"),
        "linearize": ("--at", "u=20"),
        "ensemble": ("--start", "u=20", "--vary", "steering=0:1 deg:2", "--t", "0.5", "--no-plot"),
    }[command]
    told = run(command, "cessna-170", "--model", model, "--input", "crosswind=5 kt", *words)
    assert f"cessna-170, {model} model" in told
    if command == "simulate":
        wind = next(line.split() for line in told.splitlines() if "wind_y" in line)
        assert wind == ["crosswind", "wind_y", "2.5722", "2.5722", "m/s"]


@pytest.mark.parametrize("view", ["history", "runway"])
def test_pictures_are_drawn(run: Run, view: str) -> None:
    words = ("simulate", "car.toml", "--model", "mine/", *DRIVEN, *MOVING, "--view", view)
    run(*words, "--plot", "run.png")
    assert Path("run.png").read_bytes()[:4] == b"\x89PNG"
    run(*words, "--show", "steering,brake_left,u", "--plot", "run.svg")
    assert Path("run.svg").stat().st_size > 1000
    run("ensemble", "car.toml", "--model", "mine/", "--vary", "brake_left=0:1:5", *MOVING)
    assert Path("car-ensemble.png").is_file()


@pytest.mark.parametrize(
    ("words", "code", "told"),
    [
        (
            ["--input", "sterring=3 deg"],
            1,
            "unknown argument 'sterring' in simulate; did you mean steer",
        ),
        (["--input", "steering=3 N"], 1, "found '3 N', a force; expected an angle"),
        (["--input", "steering"], 2, "expected name=value"),
        (["--input", "steering=1", "--input", "steering=2"], 2, "steering is given twice"),
        (["--start", "U=3"], 1, "unknown argument 'U'"),
        (["--v0", "1", "--start", "v=2"], 2, "v0 is given twice"),
        (["--disturbance", "3 N"], 1, "unknown argument 'disturbance'"),
        (["--set", "widht=3"], 2, "unknown parameter 'widht'"),
    ],
)
def test_what_is_wrong_is_said(run: Run, words: list[str], code: int, told: str) -> None:
    assert told in run("simulate", "car.toml", "--model", "mine/", *words, code=code)


def test_a_folder_that_is_no_pack_is_said(run: Run) -> None:
    Path("empty").mkdir()
    assert "empty" in run("simulate", "car.toml", "--model", "empty/", code=2)


def test_all_that_the_file_lacks_is_said_at_once(run: Run) -> None:
    Path("bare.toml").write_text("m = 1500\ng = 9.81\n\n[parameters]\nwidth = 1.5\n")
    told = run("simulate", "bare.toml", "--model", "mine/", code=1)
    for lacking in ("Izz", "l_front", "l_rear", "C_front", "C_rear", "grip", "wheel_load"):
        assert lacking in told
    assert "width" not in told


def test_trim_takes_every_state_and_input(run: Run) -> None:
    words = ("trim", "car.toml", "--model", "mine/", "--at", "u=72 km/h", *DRIVEN)
    found = json.loads(run(*words, "--format", "json"))
    expected = gr.trim(FOUR, own("four_wheels"), speed=20.0, steering="3 deg", brake_left=0.2)
    assert found["count"] == int(expected.count) == 1
    assert (found["speed"], found["brake_left"]) == (20.0, 0.2)
    assert found["r"] == pytest.approx(expected["r"].tolist())
    assert "speed held by something else" in run(*words)


def test_trim_finds_what_is_asked_for(run: Run) -> None:
    words = ("trim", "cessna-170", "--model", "rollout", "--speed", "30 kt")
    words = (*words, "--input", "crosswind=8 kt", "--solve-for", "pedal", "--solve-for", "thrust")
    asked = {"speed": "30 kt", "crosswind": "8 kt", "solve_for": ["pedal", "thrust"]}
    expected = gr.trim(gr.Aircraft.load("cessna-170"), "rollout", **asked)
    (row,) = csv.DictReader(run(*words, "--format", "csv").splitlines())
    assert float(row["pedal"]) == pytest.approx(float(expected["pedal"][0]))
    assert float(row["thrust [N]"]) == pytest.approx(float(expected["thrust"][0]))
    narrow = run(*words, "--within", "pedal=-10 %:10 %")
    assert "no equilibrium: pedal would have to be" in narrow
    assert "within['pedal'] must be a pair" in run(*words, "--within", "pedal=1", code=1)
