"""The linear model at many points: the same numbers, and the same bits, as one by one."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from oracles import values

import groundroll as gr
from groundroll import generated
from groundroll.generated import PACKS, kernels
from groundroll.model.evaluate import elementwise
from groundroll.stability.closed_forms import CLOSED_FORMS
from groundroll.stability.sweeps import SWEPT

PLANE = gr.Aircraft.load("brott")
RNG = np.random.default_rng(3)
POINTS = {
    "a": RNG.uniform(-1.0, 1.0, 25_000),
    "Ct": RNG.uniform(0.0, 8000.0, 25_000),
    "speed": RNG.uniform(15.0, 40.0, 25_000),
}


def test_eigenvalues_are_those_of_numpy():
    sweep = gr.sweep(PLANE, **POINTS)
    lin = gr.linearize(PLANE.replace(**{k: v[:2000] for k, v in POINTS.items()}), "linear")
    exact = np.linalg.eigvals(lin.A)
    exact = np.take_along_axis(exact, np.lexsort((-exact.imag, -exact.real)), axis=-1)
    size = np.abs(exact).max(axis=-1, keepdims=True)
    assert (np.abs(sweep.eigenvalues[:2000] - exact) < 1e-6 * size).all()
    assert sweep["damping_ratio"][:2000] == pytest.approx(lin.damping_ratio, rel=1e-9, nan_ok=True)
    frequency = sweep["natural_frequency"][:2000]
    assert frequency == pytest.approx(lin.natural_frequency, rel=1e-9, nan_ok=True)


@pytest.mark.parametrize("name", sorted(set(SWEPT) & set(CLOSED_FORMS)))
def test_every_margin_is_that_of_margins(name: str):
    few = {k: v[:300] for k, v in POINTS.items()}
    expected = getattr(gr.margins(PLANE.replace(**few)), name)
    assert gr.sweep(PLANE, [name], **few)[name] == pytest.approx(expected, rel=1e-9, nan_ok=True)


@pytest.mark.parametrize("name", sorted(PACKS["linear"].sweeps.keys() - {"linear_modes"}))
def test_kernels_give_the_bits_of_casadi(name: str, monkeypatch: pytest.MonkeyPatch):
    names = generated.build(name).name_in()
    rng = np.random.default_rng(5)
    arguments = {s: rng.uniform(-0.2, 1.0, 20_001) for s in names}
    arguments[names[0]] = np.array(0.7)
    fast = elementwise(name, arguments)
    monkeypatch.setattr(kernels, "can_sweep", lambda pack, function: False)
    slow = elementwise(name, arguments)
    for key, array in slow.items():
        assert np.array_equal(array, fast[key], equal_nan=True), key


@given(st.integers(1, 1100), st.integers(1, 3), values(["a", "Ct", "u"]))
def test_any_number_of_points_and_threads(count: int, threads: int, at: np.ndarray):
    """Blocks of 512 points, whole and broken ones."""
    a = np.linspace(at[0], at[0] + 0.1, count)
    sweep = gr.sweep(PLANE, ["re_1", "im_1"], threads=threads, a=a, Ct=at[1], u=at[2])
    for k in {0, count // 2, count - 1}:
        one = gr.sweep(PLANE, ["re_1", "im_1"], a=a[k], Ct=at[1], u=at[2])
        assert float(one["re_1"]) == sweep["re_1"][k]
        assert float(one["im_1"]) == sweep["im_1"][k]


def test_without_a_compiler_the_numbers_are_the_same(monkeypatch: pytest.MonkeyPatch):
    few = {k: v[:500] for k, v in POINTS.items()}
    fast = gr.sweep(PLANE, **few)
    monkeypatch.setattr(kernels, "can_sweep", lambda pack, function: False)
    slow = gr.sweep(PLANE, **few)
    for name, array in fast.items():
        assert slow[name] == pytest.approx(array, rel=1e-12, abs=1e-12, nan_ok=True)


def test_grids_broadcast_and_results_can_be_reused():
    grid = {"a": np.linspace(-1, 1, 7)[:, None], "speed": np.linspace(15, 40, 5)}
    sweep = gr.sweep(PLANE, **grid)
    assert sweep["re_1"].shape == (7, 5)
    assert sweep.eigenvalues.shape == (7, 5, 2)
    before = sweep["re_1"].copy()
    again = gr.sweep(PLANE, out=sweep, a=grid["a"] + 0.1, speed=grid["speed"])
    assert again["re_1"] is sweep["re_1"]
    assert (again["re_1"] != before).any()
    assert "7 x 5 points" in repr(sweep)


@pytest.mark.parametrize("compiled", [True, False])
def test_results_go_where_they_are_asked_to(compiled: bool, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(kernels, "can_sweep", lambda pack, function: compiled)
    shape, names = (40, 30), ["re_1", "understeer_gradient"]
    few = {"a": np.linspace(-1, 1, 40)[:, None], "speed": np.linspace(15, 40, 30)}
    table = np.full((3, *shape), np.nan)
    out = dict(zip(names, table, strict=False))
    sweep = gr.sweep(PLANE, names, out=out, **few)
    fresh = gr.sweep(PLANE, names, **few)
    for name, row in out.items():
        assert sweep[name] is row
        assert np.array_equal(row, fresh[name])
    assert np.isnan(table[2]).all()


def _room() -> dict[str, np.ndarray]:
    return {name: np.empty(3) for name in ("re_1", "im_1")}


@pytest.mark.parametrize(
    ("out", "message"),
    [
        (np.empty(3), "out must map the names .* re_1, im_1; not ndarray"),
        ({"re_1": np.empty(3)}, "out must map the names .* re_1, im_1; not re_1"),
        (_room() | {"re_2": np.empty(3)}, "not re_1, im_1, re_2"),
        (_room() | {"im_1": [0.0, 0.0, 0.0]}, r"out\['im_1'\] must be an array, not list"),
        (_room() | {"im_1": np.empty(4)}, r"must have the shape \(3,\), not \(4,\)"),
        (_room() | {"im_1": np.empty(3, np.float32)}, "must hold float64, not float32"),
        (_room() | {"im_1": np.empty(3, ">f8")}, "must hold float64, not >f8"),
        (_room() | {"im_1": np.broadcast_to(1.0, 3)}, "is read-only"),
        (_room() | {"im_1": np.empty(6)[::2]}, r"contiguous in C order.* \(16,\)"),
        (dict.fromkeys(["re_1", "im_1"], np.empty(3)), "share memory"),
    ],
)
def test_what_cannot_be_written_to_is_refused(out: object, message: str):
    with pytest.raises(gr.GroundrollError, match=message):
        gr.sweep(PLANE, ["re_1", "im_1"], out=out, a=[0.1, 0.2, 0.3])


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"of": ["re_3"]}, "unknown result 're_3'.*re_1"),
        ({"of": "re_1"}, "of must be a list of names"),
        ({"of": []}, "of is empty"),
        ({"a": [1.0, np.nan]}, "must be finite"),
        ({"a": [1.0, 2.0], "Ct": [1.0, 2.0, 3.0]}, "do not broadcast"),
        ({"speed": 0.0}, "must be positive"),
        ({"spede": 1.0}, "unknown parameter 'spede'.*speed"),
        ({"threads": 1.5}, "threads must be a whole number"),
    ],
)
def test_mistakes_are_named(arguments: dict[str, object], message: str):
    with pytest.raises(gr.GroundrollError, match=message):
        gr.sweep(PLANE, **arguments)
    with pytest.raises(gr.GroundrollError, match="unknown result 'decay'"):
        _ = gr.sweep(PLANE)["decay"]
