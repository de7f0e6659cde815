"""Results on disk and in tables: nothing is lost, and what doesn't fit is refused."""

from __future__ import annotations

import contextlib
import copy
import dataclasses
import functools
import importlib
import json
import pickle
import tracemalloc
import zipfile
from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
import xarray as xr

import groundroll as gr
from groundroll.base import memory
from groundroll.model.models import as_model
from groundroll.results import store
from groundroll.results.doors import KINDS

DIGEST = as_model("nonlinear").digest


@pytest.fixture(scope="module")
def plane() -> gr.Aircraft:
    return PLANE


@pytest.fixture(scope="module")
def run(plane: gr.Aircraft) -> gr.Trajectory:
    return gr.simulate(plane, v0=0.1, disturbance=30.0, t=1.0, samples=11)


@pytest.fixture(scope="module")
def many(plane: gr.Aircraft) -> gr.Trajectory:
    varied = plane.replace(a=np.array([0.2, 0.4, 0.6]), speed=np.array([[20.0], [30.0]]))
    return gr.simulate(varied, "linear", v0=0.1, t=1.0, samples=11)


PLANE = gr.Aircraft.load("brott-physical")
TAILDRAGGER = gr.Aircraft.load("cessna-170")
SPEEDS, ARMS = np.array([[20.0], [30.0]]), np.array([0.2, 0.4, 0.6])
SEVERAL = PLANE.replace(a=ARMS, speed=SPEEDS)
SAMPLED = {"at": [0.5, 1.0], "extremes": ["F_main"], "limits": {"psi": 0.01}}
POINTS = gr.OperatingPoint(v=np.array([0.1, 0.2, 0.3]))

#: One of each kind, and some that differ in what varies.
MADE: dict[str, Callable[[], gr.Result]] = {
    "run": lambda: gr.simulate(PLANE, v0=0.1, disturbance=30.0, t=1.0, samples=11),
    "runs": lambda: gr.simulate(SEVERAL, "linear", v0=0.1, disturbance=SPEEDS + ARMS, t=1.0),
    "point": lambda: gr.linearize(PLANE, at=gr.OperatingPoint(v=0.3)),
    "points": lambda: gr.linearize(SEVERAL, at=POINTS, disturbance=20.0),
    "ensemble": lambda: gr.ensemble(SEVERAL, t=1.0, v0=0.2, within={"psi": 1e-3}),
    "samples": lambda: gr.ensemble(PLANE, t=1.0, v0=SPEEDS / 50, psi0=ARMS / 50, **SAMPLED),
    "trajectory": lambda: gr.ensemble(PLANE, t=1.0, r0=0.1),
    "sweep": lambda: gr.sweep(SEVERAL, ["decay_rate", "lower_critical_speed"]),
    "map": lambda: gr.stability_map(PLANE, ("u", SPEEDS[:, 0]), ("a", ARMS), "static_margin"),
    "survival": lambda: gr.survival(SEVERAL, half_width=7.0),
    "threshold": lambda: gr.survival(PLANE, station=-3.0),
    "basin": lambda: gr.basin(PLANE, ("u", SPEEDS[:, 0]), ("impulse", [0, 9e3]), station=-3.0),
    "starts": lambda: gr.basin(PLANE, ("v0", [0.0, 5.0, 9.0]), ("r0", [0.0, 0.5])),
    "pilot": lambda: gr.pilot_limit(TAILDRAGGER, speed=np.array([[10.0, 19.0], [4.0, 16.0]])),
    "crosswind": lambda: gr.crosswind_limit(TAILDRAGGER, speed=[2.0, 12.0, 18.0], brake=0.3),
    "trim": lambda: gr.trim(PLANE, disturbance=300.0),
    "trims": lambda: gr.trim(SEVERAL, "linear", disturbance=SPEEDS),
    "branches": lambda: gr.branches(PLANE, "speed", (10.0, 40.0), disturbance=20.0),
    "no equilibrium": lambda: gr.trim(PLANE, disturbance=9e4),
}


@cache
def kept(name: str) -> Any:
    return MADE[name]()


def assert_same(found: Any, expected: Any) -> None:
    """Equal to the bit, of the same type and shape, whatever it is made of."""
    if dataclasses.is_dataclass(expected) and not callable(getattr(expected, "force", None)):
        for one in dataclasses.fields(expected):
            assert_same(getattr(found, one.name), getattr(expected, one.name))
    elif isinstance(expected, Mapping):
        assert set(found) == set(expected)
        for key, value in expected.items():
            assert_same(found[key], value)
    elif isinstance(expected, np.ndarray | np.generic):
        assert (found.dtype, found.shape) == (expected.dtype, expected.shape)
        assert found.tobytes() == expected.tobytes()
    else:
        assert type(found) is type(expected)
        assert found == expected


@pytest.mark.parametrize("suffix", [".npz", ".nc"])
@pytest.mark.parametrize("name", MADE)
def test_what_is_kept_comes_back_as_it_was(name: str, suffix: str, tmp_path: Path) -> None:
    result = kept(name)
    path = result.save(tmp_path / f"kept{suffix}")
    back = type(result).load(path)
    assert_same(back, result)
    assert repr(back) == repr(result)
    assert list(back.to_xarray()) == list(result.to_xarray())
    assert [p.name for p in tmp_path.iterdir()] == [path.name]
    assert_same(gr.Result.load(path), result)


@pytest.mark.parametrize("name", MADE)
def test_results_can_be_sent_to_other_processes(name: str) -> None:
    result = kept(name)
    assert_same(pickle.loads(pickle.dumps(result)), result)
    assert_same(copy.deepcopy(result), result)


def test_every_kind_of_result_can_be_kept() -> None:
    made = {type(kept(name)).__name__ for name in MADE}
    assert made == {place.rpartition(".")[2] for place in KINDS.values()}
    assert made == {kind.__name__ for kind in gr.Result.__subclasses__()}


def test_what_comes_back_works(tmp_path: Path) -> None:
    points, chart = kept("points"), kept("map")
    again = gr.Linearization.load(points.save(tmp_path / "points.nc"))
    assert np.array_equal(again[1, 2].A, points.A[1, 2])
    map_again = gr.StabilityMap.load(chart.save(tmp_path / "map.npz"))
    assert np.array_equal(map_again.boundary["trace"], chart.boundary["trace"])
    assert map_again.fits(kept("run").aircraft.replace(a=0.3, speed=20.0))


def test_another_kind_is_named(tmp_path: Path) -> None:
    path = kept("point").save(tmp_path / "lin.npz")
    with pytest.raises(gr.GroundrollError, match="holds a Linearization, not a Trajectory"):
        gr.Trajectory.load(path)


@pytest.mark.parametrize("suffix", [".npz", ".nc"])
def test_a_gust_comes_back(plane: gr.Aircraft, suffix: str, tmp_path: Path) -> None:
    gust = gr.gusts.one_minus_cosine(100.0, 0.2, 0.5)
    run = gr.simulate(plane, disturbance=gust, t=1.0)
    back = gr.Trajectory.load(run.save(tmp_path / f"gust{suffix}"))
    assert back.gust is not None
    assert back.gust.label == gust.label
    assert np.array_equal(back.gust(run.t), gust(run.t))
    assert np.array_equal(back.disturbance, run.disturbance)
    assert back.metrics().peak == run.metrics().peak


@pytest.mark.parametrize("suffix", [".npz", ".nc"])
def test_a_record_says_where_it_comes_from(run: gr.Trajectory, suffix: str, tmp_path: Path) -> None:
    record = store.read(run.save(tmp_path / f"run{suffix}"))
    assert record.provenance["equations"] == DIGEST
    assert {"groundroll", "casadi", "numpy"} < record.provenance.keys()
    assert record.aircraft.sources == run.aircraft.sources


def test_others_can_read_the_files(run: gr.Trajectory, tmp_path: Path) -> None:
    with np.load(run.save(tmp_path / "run.npz")) as plain:
        assert np.array_equal(plain["v"], run["v"])
        assert json.loads(str(plain["record"]))["aircraft"]["name"] == "brott-physical"
    with xr.open_dataset(run.save(tmp_path / "run.nc")) as data:
        assert np.array_equal(data["v"], run["v"])
        assert data["v"].attrs["units"] == "m/s"
        assert data["t"].attrs["units"] == "s"
        assert data.attrs["equations"] == DIGEST


@pytest.mark.parametrize("suffix", [".npz", ".nc"])
def test_a_run_of_other_equations_is_refused(
    run: gr.Trajectory, suffix: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = run.save(tmp_path / f"run{suffix}")
    other = dataclasses.replace(as_model("nonlinear"), digest="0123456789abcdef")
    monkeypatch.setattr(store, "as_model", lambda _: other)
    with pytest.raises(gr.GroundrollError, match=rf"other equations .digest {DIGEST}.*0123"):
        gr.Trajectory.load(path)
    assert gr.Trajectory.load(path, other_equations=True)["v"][0] == run["v"][0]


def test_a_record_of_another_layout_is_refused(
    run: gr.Trajectory, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = run.save(tmp_path / "run.npz")
    monkeypatch.setattr(store, "_LAYOUT", 99)
    with pytest.raises(gr.GroundrollError, match="has the layout 3; this reads the layout 99"):
        gr.Trajectory.load(path)


@pytest.mark.parametrize("suffix", [".npz", ".nc"])
def test_files_that_are_no_record_are_refused(
    run: gr.Trajectory, suffix: str, tmp_path: Path
) -> None:
    good = run.save(tmp_path / f"run{suffix}").read_bytes()
    half, noise, plain = (tmp_path / f"{name}{suffix}" for name in ("half", "noise", "plain"))
    half.write_bytes(good[: len(good) // 2])
    noise.write_bytes(b"not an archive")
    if suffix == ".npz":
        np.savez(plain, x=np.zeros(3))
    else:
        xr.Dataset({"x": ("t", np.zeros(3))}).to_netcdf(plain)
    for path in (half, noise, plain):
        with pytest.raises(gr.GroundrollError, match="no record of groundroll, or is damaged"):
            gr.Trajectory.load(path)
    with pytest.raises(gr.GroundrollError, match="cannot read"):
        gr.Trajectory.load(tmp_path / f"nowhere{suffix}")


@pytest.mark.parametrize("suffix", [".npz", ".nc"])
def test_a_flipped_bit_is_noticed(run: gr.Trajectory, suffix: str, tmp_path: Path) -> None:
    path = run.save(tmp_path / f"run{suffix}")
    good = path.read_bytes()
    if suffix == ".npz":
        with zipfile.ZipFile(path) as archive:
            member = archive.getinfo("v.npy")
        first = member.header_offset + 30 + len(member.filename) + 20 + 5
        places = range(first, first + member.compress_size - 9, 7)
    else:
        first = good.index(run["v"].astype(">f8").tobytes())
        places = range(first, first + 8 * run["v"].size, 7)
    for place in places:
        data = bytearray(good)
        data[place] ^= 1
        path.write_bytes(data)
        with pytest.raises(gr.GroundrollError, match="damaged"):
            gr.Trajectory.load(path)


def test_where_a_record_cannot_go(run: gr.Trajectory, tmp_path: Path) -> None:
    with pytest.raises(gr.GroundrollError, match=r"must end in \.npz or in \.nc"):
        run.save(tmp_path / "run.csv")
    for suffix in (".npz", ".nc"):
        with pytest.raises(gr.GroundrollError, match="cannot write"):
            run.save(tmp_path / "nowhere" / f"run{suffix}")


def test_a_run_in_xarray(many: gr.Trajectory) -> None:
    data = many.to_xarray()
    assert isinstance(data, xr.Dataset)
    assert data.sizes == {"run_0": 2, "run_1": 3, "t": 11}
    assert data["a"].dims == ("run_1",)
    assert data["u"].dims == ("run_0",)
    last = data["Y"].isel(t=-1).set_index(run_1="a").sel(run_1=0.4)
    assert np.array_equal(last, many["Y"][:, 1, -1])
    assert data["v"].attrs["units"] == "m/s"
    assert data.attrs["equations"] == as_model("linear").digest


def test_a_run_in_pandas(run: gr.Trajectory, many: gr.Trajectory) -> None:
    frame = run.to_pandas()
    assert isinstance(frame, pd.DataFrame)
    assert frame.index.name == "t"
    assert np.array_equal(frame["psi"], run["psi"])
    assert frame.attrs["units"]["r"] == "rad/s"
    several = many.to_pandas()
    assert several.index.names == ["run_0", "run_1", "t"]
    assert np.array_equal(several.loc[(1, 2), "v"], many["v"][1, 2])


def test_a_linearization_in_tables(plane: gr.Aircraft) -> None:
    lin = gr.linearize(plane.replace(a=np.array([0.2, 0.6])))
    data = lin.to_xarray()
    assert data["A"].sel(state_rate="r", state="v").values == pytest.approx(lin.A[:, 1, 0], abs=0)
    assert data["eigenvalues"].dims == ("run", "mode")
    assert data["a"].values.tolist() == [0.2, 0.6]
    frame = lin.to_pandas()
    assert frame["a"].tolist() == [0.2, 0.6]
    assert np.array_equal(frame["eigenvalue_1"], lin.eigenvalues[:, 0])
    single = gr.linearize(plane).to_pandas()
    assert len(single) == 1
    assert single["decay_rate"][0] == gr.linearize(plane).decay_rate


def test_an_ensemble_and_a_sweep_in_tables(plane: gr.Aircraft) -> None:
    arms, kicks = np.array([[0.2], [0.6]]), np.array([0.1, 0.2, 0.4])
    many = gr.ensemble(plane, t=1.0, at=[0.5, 1.0], a=arms, v0=kicks, extremes=["alpha"])
    data = many.to_xarray()
    assert data["v"].dims == ("run_0", "run_1", "t")
    assert np.array_equal(data["v"], many["v"])
    assert np.array_equal(data["largest_alpha"], many.largest["alpha"])
    assert np.array_equal(data["a"], [0.2, 0.6])
    assert np.array_equal(data["v0"], kicks)
    frame = many.to_pandas()
    assert len(frame) == 6
    assert np.array_equal(frame["final_v"], many.final["v"].ravel())
    points = gr.sweep(plane, ["decay_rate"], speed=np.linspace(10.0, 40.0, 5))
    assert points.to_pandas()["decay_rate"].tolist() == points["decay_rate"].tolist()
    table = points.to_xarray()
    assert np.array_equal(table["decay_rate"], points["decay_rate"])
    assert np.array_equal(table["u"], points.aircraft["speed"])


def test_a_map_and_a_basin_in_tables() -> None:
    chart, basin = kept("map"), kept("starts")
    data = chart.to_xarray()
    assert np.array_equal(data["static_margin"].sel(u=30.0), chart.values[:, 1])
    assert np.array_equal(data["stable"], chart.stable)
    frame = chart.to_pandas()
    assert frame.index.names == ["a", "u"]
    assert frame.loc[(0.4, 20.0), "static_margin"] == chart.values[1, 0]
    fates = basin.to_xarray()["fate"]
    assert fates.dims == ("r0", "v0")
    meanings = fates.attrs["flag_meanings"].split()
    assert meanings[basin.fate[0, 0]] == "stays_on_the_runway"
    assert (
        basin.to_pandas()["fate"].value_counts()["stays on the runway"] == (basin.fate == 0).sum()
    )


def test_a_survival_and_a_trim_in_tables() -> None:
    survival, trims = kept("survival"), kept("trims")
    frame = survival.to_pandas()
    assert frame["u"].tolist() == [20.0] * 3 + [30.0] * 3
    assert np.array_equal(frame["impulse"], survival.impulse.ravel())
    assert frame["fate"].tolist() == [gr.Survival.FATES[k] for k in survival.fate.flat]
    assert frame.attrs["units"]["impulse"] == "N s"
    assert frame.attrs["half_width"] == 7.0
    data = trims.to_xarray()
    assert data["alpha"].dims == ("run_0", "run_1", "branch")
    assert np.array_equal(data["F_disturbance"], SPEEDS[:, 0])
    assert np.array_equal(trims.to_pandas().loc[(1, 2), "v"], trims["v"][1, 2])
    assert len(kept("no equilibrium").to_pandas()) == 0


@pytest.mark.parametrize("package", ["xarray", "pandas"])
def test_a_missing_extra_is_named(
    run: gr.Trajectory, package: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    real = importlib.import_module

    def without(name: str, *rest: str) -> object:
        if name == package:
            raise ImportError(name)
        return real(name, *rest)

    monkeypatch.setattr(importlib, "import_module", without)
    with pytest.raises(gr.GroundrollError, match=rf"pip install 'groundroll\[{package}\]'"):
        getattr(run, f"to_{package}")()


# --- Files that somebody has had a hand in --------------------------------------------------


def rewritten(path: Path, change: Callable[[dict[str, Any]], None], **more: Any) -> Path:
    """A copy of an npz with another text, and further arrays."""
    with np.load(path) as archive:
        arrays = {name: archive[name] for name in archive.files}
    about = json.loads(str(arrays.pop("record")))
    change(about)
    copy = path.with_name("changed.npz")
    np.savez_compressed(copy, record=np.array(json.dumps(about)), **{**arrays, **more})
    return copy


@pytest.mark.parametrize("name", ["run", "points", "map", "starts", "trims", "ensemble"])
def test_a_text_with_keys_missing_is_refused(name: str, tmp_path: Path) -> None:
    path = kept(name).save(tmp_path / "kept.npz")
    keys: list[tuple[str, ...]] = []
    rewritten(path, lambda about: keys.extend((key,) for key in about))
    for group in ("about", "aircraft", "provenance", "results", "inputs"):
        rewritten(path, lambda about, group=group: keys.extend((group, k) for k in about[group]))
    optional = {("aircraft", s) for s in ("title", "description", "source")}
    optional |= {("provenance", s) for s in ("casadi", "numpy")}
    for place in keys:

        def remove(about: dict[str, Any], place: tuple[str, ...] = place) -> None:
            functools.reduce(dict.__getitem__, place[:-1], about).pop(place[-1])

        changed = rewritten(path, remove)
        if place in optional or place[0] == "about":  # where there is a default
            with contextlib.suppress(gr.GroundrollError):
                gr.Result.load(changed)
            continue
        with pytest.raises(gr.GroundrollError, match=r"damaged|no whole|kind of result"):
            gr.Result.load(changed)


@pytest.mark.parametrize("value", [None, 5, "x", [], {}, [1], {"a": 1}, True])
def test_a_text_with_something_else_in_its_place_is_refused(value: Any, tmp_path: Path) -> None:
    path = kept("run").save(tmp_path / "kept.npz")
    for key in ("layout", "kind", "runs", "per", "results", "inputs", "about"):
        changed = rewritten(path, lambda about, key=key: about.update({key: value}))
        if value in ([], {}) or (key == "about" and isinstance(value, dict)):
            with contextlib.suppress(gr.GroundrollError):  # an aircraft of which little is known
                gr.Result.load(changed)
        else:
            with pytest.raises(gr.GroundrollError):
                gr.Result.load(changed)


def test_an_array_by_itself_is_no_record(tmp_path: Path) -> None:
    np.save(tmp_path / "x.npy", np.zeros(3))
    path = (tmp_path / "x.npy").rename(tmp_path / "x.npz")
    with pytest.raises(gr.GroundrollError, match="no record of groundroll, or is damaged"):
        gr.Result.load(path)


def test_what_does_not_belong_is_not_unpacked(tmp_path: Path) -> None:
    path = kept("run").save(tmp_path / "kept.npz")
    bomb = np.zeros(2**24)
    changed = rewritten(path, lambda about: None, bomb=bomb)
    forged = rewritten(path, lambda about: about["results"].update(v=["t"]), v=bomb)
    forged.rename(tmp_path / "forged.npz")
    changed = rewritten(path, lambda about: None, bomb=bomb)
    for file in (changed, tmp_path / "forged.npz"):
        tracemalloc.start()
        with pytest.raises(gr.GroundrollError, match="is no record"):
            gr.Result.load(file)
        _, peak = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        assert peak < bomb.nbytes + 2**24
    assert changed.stat().st_size < bomb.nbytes / 500


@pytest.mark.parametrize("suffix", [".npz", ".nc"])
def test_more_than_fits_into_memory_is_not_unpacked(
    suffix: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = gr.simulate(PLANE, t=1.0, samples=200_001).save(tmp_path / f"kept{suffix}")
    monkeypatch.setattr(memory, "_available", lambda: 10**6)
    with pytest.raises(gr.GroundrollError, match="not enough memory for what is in"):
        gr.Result.load(path)
