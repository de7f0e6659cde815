"""Results on disk and in tables: nothing is lost, and what doesn't fit is refused."""

from __future__ import annotations

import importlib
import json
import zipfile
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
import xarray as xr

import groundloop as gl
from groundloop import records, tables
from groundloop.generated.names import DIGEST


@pytest.fixture(scope="module")
def plane() -> gl.Aircraft:
    return gl.Aircraft.load("brott-physical")


@pytest.fixture(scope="module")
def run(plane: gl.Aircraft) -> gl.Trajectory:
    return gl.simulate(plane, v0=0.1, disturbance=30.0, t=1.0, samples=11)


@pytest.fixture(scope="module")
def many(plane: gl.Aircraft) -> gl.Trajectory:
    varied = plane.replace(a=np.array([0.2, 0.4, 0.6]), speed=np.array([[20.0], [30.0]]))
    return gl.simulate(varied, "linear", v0=0.1, t=1.0, samples=11)


def test_a_run_comes_back_as_it_was(many: gl.Trajectory, tmp_path: Path) -> None:
    path = many.save(tmp_path / "run.npz")
    back = gl.load_run(path)
    assert back.tire == "linear"
    assert list(back.values) == list(many.values)
    for name in many.values:
        assert np.array_equal(back[name], many[name])
    assert np.array_equal(back.t, many.t)
    assert back.aircraft.given.keys() == many.aircraft.given.keys()
    assert all(np.array_equal(back.aircraft[s], many.aircraft[s]) for s in many.aircraft)
    assert back.aircraft.sources == many.aircraft.sources
    assert repr(back.aircraft) == repr(many.aircraft)
    assert back.metrics().displacement == pytest.approx(many.metrics().displacement, abs=0)
    assert [p.name for p in tmp_path.iterdir()] == ["run.npz"]


def test_a_linearization_comes_back_as_it_was(plane: gl.Aircraft, tmp_path: Path) -> None:
    lin = gl.linearize(plane.replace(a=np.array([0.2, 0.6])), at=gl.OperatingPoint(v=0.3))
    back = records.load_linearization(lin.save(tmp_path / "lin.npz"))
    assert np.array_equal(back.A, lin.A)
    assert np.array_equal(back.eigenvalues, lin.eigenvalues)
    assert back.outputs == lin.outputs
    assert back.at.v == lin.at.v
    assert repr(back) == repr(lin)
    with pytest.raises(gl.GroundloopError, match="holds a linearization"):
        gl.load_run(tmp_path / "lin.npz")


def test_an_ensemble_comes_back_as_it_was(plane: gl.Aircraft, tmp_path: Path) -> None:
    many = gl.ensemble(
        plane, t=1.0, at=[0.5, 1.0], a=np.linspace(0.2, 0.6, 3), v0=0.2, extremes=["alpha"]
    )
    back = gl.load_ensemble(many.save(tmp_path / "ensemble.npz"))
    assert repr(back) == repr(many)
    assert np.array_equal(back["v"], many["v"])
    assert np.array_equal(back.largest["alpha"], many.largest["alpha"])
    assert back.status.dtype == many.status.dtype
    assert back.start["v"] == 0.2
    assert np.array_equal(back.aircraft["a"], many.aircraft["a"])


def test_a_sweep_comes_back_as_it_was(plane: gl.Aircraft, tmp_path: Path) -> None:
    points = gl.sweep(plane, ["decay_rate"], speed=np.linspace(10.0, 40.0, 5))
    back = gl.load_sweep(points.save(tmp_path / "sweep.npz"))
    assert np.array_equal(back["decay_rate"], points["decay_rate"])
    assert np.array_equal(back.aircraft["speed"], points.aircraft["speed"])


def test_a_gust_comes_back_as_its_samples(plane: gl.Aircraft, tmp_path: Path) -> None:
    gust = gl.gusts.one_minus_cosine(100.0, 0.2, 0.5)
    run = gl.simulate(plane, disturbance=gust, t=1.0)
    back = gl.load_run(run.save(tmp_path / "gust.npz"))
    assert back.gust is not None
    assert back.gust.label == f"{gust.label} (its samples)"
    assert back.gust(run.t) == pytest.approx(gust(run.t), abs=1e-12)


def test_a_record_says_where_it_comes_from(run: gl.Trajectory, tmp_path: Path) -> None:
    record = records.read(run.save(tmp_path / "run.npz"), "trajectory")
    assert record.provenance["equations"] == DIGEST
    assert {"groundloop", "casadi", "numpy"} < record.provenance.keys()
    with np.load(tmp_path / "run.npz") as plain:
        assert plain["arrays/v"].shape == (11,)
        assert json.loads(str(plain["record"]))["aircraft"]["name"] == "brott-physical"


def test_a_run_of_other_equations_is_refused(
    run: gl.Trajectory, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = run.save(tmp_path / "run.npz")
    monkeypatch.setattr(records, "DIGEST", "0123456789abcdef")
    with pytest.raises(gl.GroundloopError, match=rf"other equations .digest {DIGEST}.*0123"):
        gl.load_run(path)
    assert gl.load_run(path, other_equations=True)["v"][0] == run["v"][0]


def test_files_that_are_no_record_are_refused(run: gl.Trajectory, tmp_path: Path) -> None:
    good = run.save(tmp_path / "run.npz").read_bytes()
    half, noise, plain = (tmp_path / f"{name}.npz" for name in ("half", "noise", "plain"))
    half.write_bytes(good[: len(good) // 2])
    noise.write_bytes(b"not an archive")
    np.savez(plain, x=np.zeros(3))
    for path in (half, noise, plain):
        with pytest.raises(gl.GroundloopError, match="no record of groundloop, or is damaged"):
            gl.load_run(path)
    with pytest.raises(gl.GroundloopError, match="cannot read"):
        gl.load_run(tmp_path / "nowhere.npz")
    with pytest.raises(gl.GroundloopError, match=r"holds a trajectory.*this reads a map"):
        records.read(tmp_path / "run.npz", "map")


def test_a_flipped_bit_is_noticed(run: gl.Trajectory, tmp_path: Path) -> None:
    path = run.save(tmp_path / "run.npz")
    with zipfile.ZipFile(path) as archive:
        member = archive.getinfo("arrays/v.npy")
    good = path.read_bytes()
    for offset in range(5, member.compress_size - 4, 7):
        data = bytearray(good)
        data[member.header_offset + 30 + len(member.filename) + 20 + offset] ^= 1
        path.write_bytes(data)
        with pytest.raises(gl.GroundloopError, match="damaged"):
            gl.load_run(path)


def test_where_a_record_cannot_go(run: gl.Trajectory, tmp_path: Path) -> None:
    with pytest.raises(gl.GroundloopError, match=r"must end in \.npz"):
        run.save(tmp_path / "run.nc")
    with pytest.raises(gl.GroundloopError, match="cannot write"):
        run.save(tmp_path / "nowhere" / "run.npz")


def test_a_run_in_xarray(many: gl.Trajectory) -> None:
    data = many.to_xarray()
    assert isinstance(data, xr.Dataset)
    assert data.sizes == {"run_0": 2, "run_1": 3, "t": 11}
    assert data["a"].dims == ("run_1",)
    assert data["u"].dims == ("run_0",)
    last = data["Y"].isel(t=-1).set_index(run_1="a").sel(run_1=0.4)
    assert np.array_equal(last, many["Y"][:, 1, -1])
    assert data["v"].attrs["units"] == "m/s"
    assert data.attrs["equations"] == DIGEST


def test_a_run_in_pandas(run: gl.Trajectory, many: gl.Trajectory) -> None:
    frame = run.to_pandas()
    assert isinstance(frame, pd.DataFrame)
    assert frame.index.name == "t"
    assert np.array_equal(frame["psi"], run["psi"])
    assert frame.attrs["units"]["r"] == "rad/s"
    several = many.to_pandas()
    assert several.index.names == ["run_0", "run_1", "t"]
    assert np.array_equal(several.loc[(1, 2), "v"], many["v"][1, 2])


def test_a_linearization_in_tables(plane: gl.Aircraft) -> None:
    lin = gl.linearize(plane.replace(a=np.array([0.2, 0.6])))
    data = lin.to_xarray()
    assert data["A"].sel(state_rate="r", state="v").values == pytest.approx(lin.A[:, 1, 0], abs=0)
    assert data["eigenvalues"].dims == ("run", "mode")
    assert data["a"].values.tolist() == [0.2, 0.6]
    frame = lin.to_pandas()
    assert frame["a"].tolist() == [0.2, 0.6]
    assert np.array_equal(frame["eigenvalue_1"], lin.eigenvalues[:, 0])
    single = gl.linearize(plane).to_pandas()
    assert len(single) == 1
    assert single["decay_rate"][0] == gl.linearize(plane).decay_rate


def test_an_ensemble_and_a_sweep_in_tables(plane: gl.Aircraft) -> None:
    arms, kicks = np.array([[0.2], [0.6]]), np.array([0.1, 0.2, 0.4])
    many = gl.ensemble(plane, t=1.0, at=[0.5, 1.0], a=arms, v0=kicks, extremes=["alpha"])
    data = many.to_xarray()
    assert data["v"].dims == ("run_0", "run_1", "t")
    assert np.array_equal(data["v"], many["v"])
    assert np.array_equal(data["largest_alpha"], many.largest["alpha"])
    assert np.array_equal(data["a"], [0.2, 0.6])
    assert np.array_equal(data["v0"][0], kicks)
    frame = many.to_pandas()
    assert len(frame) == 6
    assert np.array_equal(frame["final_v"], many.final["v"].ravel())
    points = gl.sweep(plane, ["decay_rate"], speed=np.linspace(10.0, 40.0, 5))
    table = points.to_xarray()
    assert np.array_equal(table["decay_rate"], points["decay_rate"])
    assert np.array_equal(table["u"], points.aircraft["speed"])


@pytest.mark.parametrize("package", ["xarray", "pandas"])
def test_a_missing_extra_is_named(
    run: gl.Trajectory, package: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    real = importlib.import_module

    def without(name: str, *rest: str) -> object:
        if name == package:
            raise ImportError(name)
        return real(name, *rest)

    monkeypatch.setattr(importlib, "import_module", without)
    with pytest.raises(gl.GroundloopError, match=rf"pip install 'groundloop\[{package}\]'"):
        getattr(run, f"to_{package}")()


def test_notebooks_show_a_table(run: gl.Trajectory, many: gl.Trajectory) -> None:
    html = run._repr_html_()
    assert html.count("<svg") == len(run.values)
    assert "lateral velocity (v)" in html
    assert "<script" not in many._repr_html_()
    lin = gl.linearize(run.aircraft)
    assert "decay rate" in lin._repr_html_()
    assert "3 of them" in tables.linearization_to_html(
        gl.linearize(run.aircraft.replace(a=np.array([0.1, 0.2, 0.3])))
    )
