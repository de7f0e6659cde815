"""Results of models that nobody shipped: kept, found again, refused when their model changes."""

from __future__ import annotations

import dataclasses
import shutil
from pathlib import Path

import control
import numpy as np
import pytest
from own_models import CAR, FOUR, HERE, LAGGING, own

import groundroll as gr
from groundroll.derive.emit.own import derive_file
from groundroll.model import models
from groundroll.model.models import Model, as_model
from groundroll.results import store
from groundroll.results.records import measured

STEERING = gr.signals.step("3 deg", start=0.5)
#: An own model with several inputs: constant, an array, over time.
RUNS = {
    "one input": lambda: gr.simulate(CAR, own("single_track"), steering="1 deg", t=1.0),
    "over time": lambda: gr.simulate(
        FOUR, own("four_wheels"), u0=30.0, steering=STEERING, brake_left=0.2, t=1.0, samples=51
    ),
    "arrays": lambda: gr.simulate(
        FOUR,
        own("four_wheels"),
        u0=[[20.0], [30.0]],
        steering=np.radians([0.0, 1.0, 2.0]),
        brake_left=0.1,
        brake_right=gr.signals.step([0.1, 0.2, 0.3], start=0.25),
        grip=[0.7, 0.8, 0.9],
        t=1.0,
        samples=11,
    ),
    "own state": lambda: gr.simulate(LAGGING, own("lagging"), late_tail0="1 deg", push=50.0, t=1.0),
}


def derived(folder: Path, old: str = "", new: str = "") -> Path:
    """The pack of the single-track car, with one thing in its file written otherwise."""
    file = folder.with_suffix(".py")
    text = (HERE / "single_track.py").read_text()
    assert old in text
    file.write_text(text.replace(old, new, 1) if old else text)
    derive_file(file, folder)
    return folder


@pytest.fixture
def kept(tmp_path: Path) -> Path:
    """What is kept of the car, made of a pack in a folder that can be moved."""
    folder = derived(tmp_path / "first")
    return gr.simulate(CAR, folder, steering="1 deg", t=1.0).save(tmp_path / "car.npz")


@pytest.mark.parametrize("suffix", [".npz", ".nc"])
@pytest.mark.parametrize("name", RUNS)
def test_what_goes_in_comes_out(name: str, suffix: str, tmp_path: Path) -> None:
    run = RUNS[name]()
    back = gr.Trajectory.load(run.save(tmp_path / f"run{suffix}"))
    assert set(back.values) == set(run.values)
    for s, values in run.values.items():
        np.testing.assert_array_equal(back[s], values)
    assert back.signals.keys() == run.signals.keys()
    for s, signal in run.signals.items():
        np.testing.assert_allclose(back.signals[s](run.t), signal(run.t), rtol=1e-12, atol=1e-12)
    assert back.aircraft.parameters(back.model) == pytest.approx(run.aircraft.parameters(run.model))
    assert repr(back) == repr(run)


def test_inputs_stand_in_tables_with_their_units() -> None:
    run = RUNS["over time"]()
    data, frame = run.to_xarray(), run.to_pandas()
    units = {"steering": "rad", "brake_left": "1", "brake_right": "1", "u": "m/s"}
    for s, unit in units.items():
        assert data[s].attrs["units"] == unit
        assert frame.attrs["units"][s] == unit
        np.testing.assert_array_equal(frame[s], run[s])
    assert data["steering"][-1] == pytest.approx(np.radians(3.0))
    assert data.attrs["equations"] == own("four_wheels").digest
    many = RUNS["arrays"]().to_xarray()
    assert many["grip"].dims == ("run_1",)
    assert many["grip"].attrs["units"] == "1"
    assert many["steering"].dims == ("run_0", "run_1", "t")


def test_a_linearization_takes_every_input_to_tables_and_to_control() -> None:
    lin = gr.linearize(FOUR, own("four_wheels"), at={"speed": 20.0, "steering": "1 deg"})
    data = lin.to_xarray()
    assert data["B"].sel(input="brake_left", state_rate="r") == lin.B[2, 1]
    assert data["input_unit"].values.tolist() == ["rad", "1", "1"]
    assert data["state_unit"].values.tolist() == ["m/s", "m/s", "rad/s"]
    system = lin.to_control()
    assert isinstance(system, control.StateSpace)
    assert system.input_labels == ["steering", "brake_left", "brake_right"]


def test_an_own_model_is_found_again_by_its_folder(kept: Path) -> None:
    run = gr.Trajectory.load(kept)
    assert as_model(run.model).name == "single_track"
    assert run.model == str(kept.parent / "first")
    assert dict(run.aircraft.own) == dict(CAR.own)


def test_a_model_that_was_moved_is_to_be_named(kept: Path, tmp_path: Path) -> None:
    moved = shutil.move(tmp_path / "first", tmp_path / "second")
    with pytest.raises(gr.GroundrollError, match=r"first, which is not found.*model=\.\.\."):
        gr.Trajectory.load(kept)
    assert gr.Trajectory.load(kept, model=moved).model == str(moved)


def test_one_coefficient_refuses_it_and_other_words_do_not(kept: Path, tmp_path: Path) -> None:
    words = derived(tmp_path / "words", "front axle ahead of the CG", "in other words")
    assert Model.load(words).quantities["l_front"].meaning == "in other words"
    assert gr.Trajectory.load(kept, model=words).model == str(words)
    other = derived(tmp_path / "other", "stiffness * alpha", "1.001 * stiffness * alpha")
    with pytest.raises(gr.GroundrollError, match=r"from other equations .* of the model single_"):
        gr.Trajectory.load(kept, model=other)
    assert gr.Trajectory.load(kept, model=other, other_equations=True).model == str(other)


def test_a_model_that_is_derived_again_is_read_again(kept: Path, tmp_path: Path) -> None:
    """As in a notebook: the same folder, in one process."""
    before = gr.linearize(CAR, tmp_path / "first").A
    derived(tmp_path / "first", "stiffness * alpha", "2 * stiffness * alpha")
    after = gr.linearize(CAR, tmp_path / "first").A
    np.testing.assert_allclose(after[:, 0], 2 * before[:, 0], rtol=1e-12)
    with pytest.raises(gr.GroundrollError, match="from other equations"):
        gr.Trajectory.load(kept)


def test_another_model_may_change(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = gr.linearize(gr.Aircraft.load("brott")).save(tmp_path / "lin.npz")

    def changed(name: models.ModelLike) -> Model:
        model = as_model(name)
        return dataclasses.replace(model, digest="0") if model.name == "linear" else model

    monkeypatch.setattr(store, "as_model", changed)
    assert gr.Linearization.load(path).model == "nonlinear"


def test_a_model_of_an_installed_package_goes_by_its_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = derived(tmp_path / "installed")
    monkeypatch.setattr(models, "_announced", lambda: {"family-car": folder})
    lin = gr.linearize(CAR, "family-car")
    assert lin.model == "family-car"
    assert gr.Result.load(lin.save(tmp_path / "lin.npz")).model == "family-car"


def test_what_an_aircraft_varies_may_be_called_like_a_result(tmp_path: Path) -> None:
    """The speed of the aircraft and the speed of the run are both `u`."""
    arms = np.array([1.0, 1.2])
    plane = CAR.with_own({**CAR.own, "l_front": arms}).replace(u=np.array([[20.0], [30.0]]))
    lin = gr.linearize(plane, own("single_track"))
    column = measured((), np.array(1.0), as_model("nonlinear").quantities["v"])
    record = dataclasses.replace(lin._record(), results={"u": column, "l_front": column})
    back = store.read(store.write(record, tmp_path / "kept.npz"))
    assert set(record.varied) == {"aircraft_u", "own_l_front"}
    assert np.array_equal(back.aircraft["u"], [[20.0], [30.0]])
    assert np.array_equal(back.aircraft.own["l_front"], arms)
    assert record.varied["own_l_front"].unit == "m"
