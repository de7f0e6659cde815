"""Every example runs, from an empty folder, without a warning."""

from __future__ import annotations

import runpy
from pathlib import Path

import matplotlib as mpl
import pytest
from matplotlib import pyplot
from PIL import Image

EXAMPLES = sorted((Path(__file__).parents[1] / "docs" / "examples").glob("*.py"))
#: What an example leaves behind.
PRODUCTS = {
    "01_first_run": ["first_run.png"],
    "02_own_aircraft": ["my-plane.toml"],
    "03_over_speed": ["over_speed.png"],
    "04_gusts": [],
    "05_results": ["runs.npz"],
    "06_ground_loop": ["ground-loop.gif", "ground-loop.png"],
    "07_yaw_damper": ["yaw_damper.png"],
}


def test_every_example_is_listed() -> None:
    assert [path.stem for path in EXAMPLES] == list(PRODUCTS)


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_the_example_runs(
    path: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    mpl.use("Agg")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("sys.argv", [str(path)])
    monkeypatch.setenv("REPEATS", "0")  # no comparison of times
    try:
        runpy.run_path(str(path), run_name="__main__")
    finally:
        pyplot.close("all")
    assert sorted(p.name for p in tmp_path.iterdir()) == PRODUCTS[path.stem]
    assert capsys.readouterr().out or PRODUCTS[path.stem]


def test_the_picture_of_the_readme_is_small_enough() -> None:
    path = Path(__file__).parents[1] / "docs" / "images" / "ground-loop.png"
    assert path.stat().st_size < 200_000
    with Image.open(path) as picture:
        assert picture.width > 800


def test_the_pilot_stays_on_the_runway(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    mpl.use("Agg")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("REPEATS", "0")
    (path,) = (path for path in EXAMPLES if path.stem.endswith("yaw_damper"))
    result = runpy.run_path(str(path))
    pyplot.close("all")
    assert result["hessian_error"](result["steps"]["rk45 compiled"]) < 1e-8
    assert abs(result["saved"]["Y"]).max() < 3.0 < 9.0 < abs(result["lost"]["Y"]).max()
    assert abs(result["rudder"](result["t"])).max() <= result["LARGEST"] * (1 + 1e-6)
