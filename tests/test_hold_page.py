"""The page of what can be held: one command, a table, a picture, and what it says of itself."""

from __future__ import annotations

import json
from pathlib import Path

import matplotlib as mpl
import numpy as np
import pytest

import groundroll as gr
from groundroll.cli import main
from groundroll.control.page import held, on_surface


@pytest.fixture(scope="module")
def wet() -> object:
    return held(gr.Aircraft.load("cessna-170"), "wet", 0.2)


def test_it_holds_what_both_limits_say(wet) -> None:
    plane = gr.Aircraft.load("cessna-170")
    k = 12
    speed = float(wet.limit.speed[k])
    values = on_surface("wet")
    wind = gr.crosswind_limit(plane, speed=speed, brake=0.2, **values)
    assert float(wind.wind) == pytest.approx(wet.limit.wind[k], rel=1e-4)
    assert float(gr.pilot_limit(plane, speed=speed, **values).delay) == pytest.approx(
        wet.still.delay[k], rel=1e-6
    )
    beyond = wet.winds[:, None] > 1.2 * np.interp(wet.windy.speed, wet.limit.speed, wet.limit.wind)
    assert np.isnan(wet.windy.delay[beyond & (wet.windy.speed > 8.0)]).any()


def test_the_picture_has_both_halves(wet) -> None:
    mpl.use("Agg")
    figure = wet.plot()
    labels = [ax.get_ylabel() for ax in figure.axes]
    assert "steady crosswind (kt)" in labels
    assert "time (s)" in labels
    assert "wet" in figure.get_suptitle()


def test_the_command_writes_numbers(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["hold", "cessna-172p", "--surface", "grass", "--format", "json"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert data["surface"] == "grass"
    assert len(data["rows"]) == 24
    assert data["rows"][0][2] in gr.CrosswindLimit.BINDS
    assert main(["hold", "cessna-172p", "--surface", "wood"]) == 1
    assert "unknown surface" in capsys.readouterr().err
