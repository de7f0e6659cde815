"""Results of models that nobody shipped: kept, found again, refused when their model changes."""

from __future__ import annotations

import dataclasses
import shutil
from pathlib import Path

import numpy as np
import own_models
import pytest
from own_models import own, sedan, written

import groundroll as gr
from groundroll import models, records
from groundroll.derive.core.frames import i
from groundroll.models import Model, as_model


@pytest.fixture
def kept(tmp_path: Path) -> Path:
    """What is kept of the car, made of a pack in a folder that can be moved."""
    folder = written("car", tmp_path / "first")
    return gr.linearize(sedan(), folder).save(tmp_path / "car.npz")


def changed(folder: Path, what: str) -> Path:
    """The pack of a car in which one thing is different."""
    model = own_models.MODELS["car"]
    front, *others = model.parts
    if what == "coefficient":
        front = dataclasses.replace(front, at=1.001 * own_models.a * i)
    if what == "words":
        said = own_models.Parameter("l_f", "front_axle_arm", "m", "in other words", sign=">0")
        front = dataclasses.replace(front, at=said * i)
        model = dataclasses.replace(model, summary="Other words.")
    return written("car", folder, model=dataclasses.replace(model, parts=[front, *others]))


def test_what_is_kept_of_an_own_model_is_found_again_by_its_folder(kept: Path) -> None:
    lin = gr.Linearization.load(kept)
    assert as_model(lin.model).name == "car"
    assert lin.model == str(kept.parent / "first")
    assert lin.inputs == ("delta", "F_side")
    assert np.array_equal(lin.B, gr.linearize(sedan(), kept.parent / "first").B)
    assert dict(lin.aircraft.own) == dict(sedan().own)


def test_a_model_that_was_moved_is_to_be_named(kept: Path, tmp_path: Path) -> None:
    moved = shutil.move(tmp_path / "first", tmp_path / "second")
    models._load.cache_clear()
    with pytest.raises(gr.GroundrollError, match=r"first, which is not found.*model=\.\.\."):
        gr.Linearization.load(kept)
    assert gr.Linearization.load(kept, model=moved).model == str(moved)


def test_one_coefficient_refuses_it_and_other_words_do_not(kept: Path, tmp_path: Path) -> None:
    words = changed(tmp_path / "words", "words")
    assert Model.load(words).quantities["l_f"].meaning == "in other words"
    assert gr.Linearization.load(kept, model=words).model == str(words)
    coefficient = changed(tmp_path / "coefficient", "coefficient")
    with pytest.raises(gr.GroundrollError, match=r"from other equations .* of the model car"):
        gr.Linearization.load(kept, model=coefficient)
    accepted = gr.Linearization.load(kept, model=coefficient, other_equations=True)
    assert accepted.model == str(coefficient)


def test_another_model_may_change(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = gr.linearize(gr.Aircraft.load("brott")).save(tmp_path / "lin.npz")

    def other(name: models.ModelLike) -> Model:
        return (
            dataclasses.replace(as_model(name), digest="0") if name == "linear" else as_model(name)
        )

    monkeypatch.setattr(records, "as_model", other)
    assert gr.Linearization.load(path).model == "nonlinear"


def test_a_model_of_an_installed_package_goes_by_its_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = written("car", tmp_path / "installed")
    monkeypatch.setattr(models, "_announced", lambda: {"family-car": folder})
    lin = gr.linearize(sedan(), "family-car")
    assert lin.model == "family-car"
    assert gr.Result.load(lin.save(tmp_path / "lin.npz")).model == "family-car"


def test_an_own_model_may_be_called_like_one_that_ships(tmp_path: Path) -> None:
    like = dataclasses.replace(own_models.MODELS["car"], name="linear")
    folder = written("car", tmp_path / "linear", model=like)
    lin = gr.linearize(sedan(), folder)
    assert lin.model == str(folder)
    assert gr.Result.load(lin.save(tmp_path / "lin.npz")).inputs == ("delta", "F_side")


def test_what_an_aircraft_varies_may_be_called_like_a_result(tmp_path: Path) -> None:
    """The speed of the aircraft and the speed of the run are both `u`."""
    arms = np.array([1.0, 1.2])
    run = sedan().with_own({**sedan().own, "l_f": arms})
    lin = gr.linearize(run.replace(u=np.array([[20.0], [30.0]])), own("car"))
    column = records.measured((), np.array(1.0), as_model("nonlinear").quantities["v"])
    record = dataclasses.replace(lin._record(), results={"u": column, "l_f": column})
    path = records.write(record, tmp_path / "kept.npz")
    back = records.read(path)
    assert set(record.varied) == {"aircraft_u", "own_l_f"}
    assert np.array_equal(back.aircraft["u"], [[20.0], [30.0]])
    assert np.array_equal(back.aircraft.own["l_f"], arms)
    assert record.varied["own_l_f"].unit == "m"
