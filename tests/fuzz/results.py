"""Results read back: as they were written, with bits flipped, and with other things in them."""

from __future__ import annotations

import copy
import io
import json
import tempfile
import zipfile
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

import groundroll as gr
from groundroll.base.errors import GroundrollError

from . import mutation
from .harness import Case

_PLANE = "cessna-170"
_SPEEDS = np.array([10.0, 20.0, 30.0])
#: What is put into the text of a record.
_ODD: tuple[Any, ...] = (
    *(None, True, 0, -1, 5, 1e300, 1e-300, "", "x", "nonlinear", "v", "../x", "\x1b[31m", "é" * 99),
    *([], {}, [1], ["t"], ["t", "t"], [[1.0]], {"a": 1}, {"varies": "v", "shape": [3]}, [[[]]]),
    *({"varies": "t", "shape": [-1]}, {"varies": None, "shape": "x"}, "nan", [None], 10**30),
)
#: What is put in the place of an array.
_ARRAYS: tuple[Any, ...] = (
    *(np.zeros(0), np.zeros(3), np.zeros((2, 2)), np.array(1.0), np.arange(3), np.array("x")),
    *(np.array([True]), np.array([1j]), np.full(11, np.nan), np.zeros((11, 3)), np.zeros(11)),
    np.zeros(3, [("a", float)]),
)


def _made(kind: str, model: str) -> Any:
    plane = gr.Aircraft.load(_PLANE)
    several = plane.replace(u=_SPEEDS[:, None], m=np.array([900.0, 1000.0]))
    if kind == "trajectory":
        return gr.simulate(plane, model, t=0.02, samples=11, r0=0.01)
    if kind == "many":
        return gr.simulate(several, model, t=0.02, samples=11, r0=0.01)
    if kind == "gust":
        gust = gr.gusts.step(50.0, 0.005)
        return gr.simulate(plane, model, t=0.02, samples=11, F_disturbance=gust)
    if kind == "ensemble":
        return gr.ensemble(plane, 0.02, model, at=[0.01, 0.02], r0=[0.0, 0.01], extremes=["r"])
    if kind == "linearization":
        return gr.linearize(several, model)
    if kind == "trim":
        return gr.trim(several, model, disturbance=[0.0, 50.0])
    if kind == "sweep":
        return gr.sweep(several)
    if kind == "map":
        return gr.stability_map(plane, ("u", _SPEEDS), ("a", [0.2, 0.5]))
    if kind == "survival":
        return gr.survival(gr.Aircraft.load("brott-physical"), speed=_SPEEDS[1:], t=2.0)
    return gr.basin(
        gr.Aircraft.load("brott-physical"), ("v0", [0.0, 5.0]), ("r0", [0.0, 0.5]), t=2.0
    )


_KINDS = (
    *("trajectory", "many", "gust", "ensemble", "linearization"),
    *("trim", "sweep", "map", "survival", "basin"),
)


@cache
def _written(kind: str, model: str, suffix: str) -> bytes | None:
    """A file with a result; None if a model has no such result."""
    with tempfile.TemporaryDirectory() as folder:
        try:
            return _made(kind, model).save(Path(folder) / f"kept{suffix}").read_bytes()
        except GroundrollError:
            return None


def results(rng: np.random.Generator, model: str, folder: Path) -> Case:
    """A file with a result, or what is left of it."""
    plain = None
    while plain is None:
        kind, suffix = str(mutation.pick(rng, _KINDS)), str(mutation.pick(rng, (".npz", ".nc")))
        plain = _written(kind, model, suffix)
    path = folder / f"kept{suffix}"
    how = int(rng.integers(4)) if suffix == ".npz" else int(rng.integers(2))
    if how == 0:
        said, content = "as it was", plain
    elif how == 1:
        said, content = "with bytes changed", mutation.data(rng, plain)
    else:
        said, content = _forged(rng, plain)
    path.write_bytes(content)
    shown = f"{kind} of {model} in {suffix}, {said}"
    if how > 1:
        return Case(shown, lambda: _read(path), lambda r: _judged_forgery(content, r))
    return Case(shown, lambda: _read(path), lambda r: _judged(plain, suffix, r))


def _read(path: Path) -> gr.Result:
    result = gr.Result.load(path)
    repr(result)
    return result


def _arrays(content: bytes) -> tuple[dict[str, Any], dict[str, np.ndarray[Any, Any]]]:
    """Text and arrays of an npz, by NumPy alone."""
    with np.load(io.BytesIO(content)) as archive:
        arrays = {name: archive[name] for name in archive.files}
    return json.loads(str(arrays.pop("record"))), arrays


def _forged(rng: np.random.Generator, plain: bytes) -> tuple[str, bytes]:
    """Another text or other arrays in a file that is whole."""
    about, arrays = _arrays(plain)
    said = []
    for _ in range(int(rng.integers(1, 3))):
        if rng.random() < 0.25:
            name = str(mutation.pick(rng, [*arrays, "more"]))
            arrays[name] = _ARRAYS[int(rng.integers(len(_ARRAYS)))]
            said.append(f"{name} an array {arrays[name].dtype} {arrays[name].shape}")
            continue
        place: Any = about
        trail = []
        while True:
            keys = list(place) if isinstance(place, dict) else list(range(len(place)))
            if not keys:
                break
            key = keys[int(rng.integers(len(keys)))]
            trail.append(key)
            inner = place[key]
            if not isinstance(inner, dict | list) or not inner or rng.random() < 0.3:
                if isinstance(place, dict) and rng.random() < 0.3:
                    del place[key]
                    said.append(f"without {trail}")
                else:
                    place[key] = copy.deepcopy(_ODD[int(rng.integers(len(_ODD)))])
                    said.append(f"{trail} = {place[key]!r}")
                break
            place = inner
    with io.BytesIO() as file:
        with zipfile.ZipFile(file, "w") as archive:
            for name, array in {"record": np.array(json.dumps(about)), **arrays}.items():
                with archive.open(f"{name}.npy", "w") as member:
                    np.lib.format.write_array(member, array, allow_pickle=False)
        return "; ".join(said), file.getvalue()


def _judged(plain: bytes, suffix: str, result: gr.Result) -> str:
    """Whether a result is to the bit what was written."""
    with tempfile.TemporaryDirectory() as folder:
        again = result.save(Path(folder) / f"again{suffix}").read_bytes()
    if suffix == ".npz":
        (text, arrays), (text_2, arrays_2) = _arrays(plain), _arrays(again)
        same = text == text_2 and arrays.keys() == arrays_2.keys()
        same = same and all(a.tobytes() == arrays_2[n].tobytes() for n, a in arrays.items())
        return "" if same else "what was read is not what was written"
    return "" if again == plain else "what was read is not what was written"


def _judged_forgery(content: bytes, result: gr.Result) -> str:
    """Whether a result says what is in its file, forged or not."""
    about, arrays = _arrays(content)
    record = result._record()
    for name, column in record.results.items():
        given, number = arrays[name], column.values.dtype.kind in "fc"
        if not np.array_equal(column.values, given, equal_nan=number):
            return f"{name}: {column.values!r} for {arrays.get(name)!r}"
        if list(column.dims) != about["results"][name]:
            return f"dimensions of {name}: {column.dims}"
    if record.aircraft.name != about["aircraft"]["name"] or record.kind != about["kind"]:
        return "another aircraft, or another kind"
    return ""
