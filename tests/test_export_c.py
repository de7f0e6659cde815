"""The plain C bundle: compiled strictly, under sanitizers, and equal to the model it came from."""

from __future__ import annotations

import csv
import ctypes
import io
import os
import subprocess
from functools import cache
from pathlib import Path

import casadi as ca
import numpy as np
import pytest
from exported import NAMES, case
from unprivileged import read_only_folder

import groundroll as gr
from groundroll.cli import main

STRICT = "-O1 -g -std=c99 -pedantic -Wall -Wextra -Werror"
SANITIZED = f"{STRICT} -fsanitize=address,undefined -fno-sanitize-recover=all"
#: Error of a roll relative to the largest magnitude of a quantity, and what is taken for none.
ERROR = {"double": (1e-8, 1e-9), "float": (5e-3, 1e-4)}
FLOATS = {"double": np.float64, "float": np.float32}


def written(name: str, folder: Path) -> Path:
    plane, model, values = case(name)
    return gr.export(plane, "c", folder / name, model, **values)


def rows(text: str) -> dict[str, np.ndarray]:
    head, *lines = csv.reader(io.StringIO(text))
    return dict(zip(head, np.array(lines, float).T, strict=True))


@pytest.mark.parametrize("real", ["double", "float"])
@pytest.mark.parametrize("name", NAMES)
def test_the_example_rolls_as_simulate_does(name: str, real: str, tmp_path: Path) -> None:
    plane, model, values = case(name)
    folder = written(name, tmp_path)
    make = ["make", "-s", f"REAL={real}", f"CFLAGS={SANITIZED}"]
    subprocess.run(make, cwd=folder, check=True)
    done = subprocess.run(["./roll"], cwd=folder, check=True, capture_output=True, text=True)
    found = rows(done.stdout)
    run = gr.simulate(plane, model, t=5.0, samples=51, tol=1e-11, **values)
    relative, absolute = ERROR[real]
    symbols = (*model.states, *model.outputs)
    for symbol, series in zip(symbols, list(found.values())[1:], strict=True):
        # what the model tells are differences of large forces
        allowed = relative if symbol in model.states else 10 * relative
        error = abs(series - run[symbol]).max()
        assert error <= absolute + allowed * abs(run[symbol]).max(), symbol
    assert list(found) == ["t", *(model.quantities[s].name for s in symbols)]


@pytest.mark.parametrize("real", ["double", "float"])
@pytest.mark.parametrize("name", NAMES)
def test_the_functions_are_the_models(name: str, real: str, tmp_path: Path) -> None:
    """Rates and outputs, and their changes along any direction, at points near the roll's."""
    model = case(name).model
    library = shared(name, real, tmp_path)
    rng = np.random.default_rng(1)
    x, u, p = start(name)
    jacobians = model.function("jacobians")
    for _ in range(5):
        point = [v + s * rng.uniform(0, 1, v.size) * (1 + abs(v)) for v, s in around(x, u, p)]
        change = [rng.normal(size=v.size) * (0.01 + abs(v)) for v in point]
        J = dict(zip(jacobians.name_out(), map(np.array, jacobians(*point)), strict=True))
        expected = {
            "xdot": np.array(model.function("rhs")(*point)).ravel(),
            "y": np.array(model.function("outputs")(*point)).ravel(),
            "dxdot": sum(J[f"f{by}"] @ d for by, d in zip("xup", change, strict=True)),
            "dy": sum(J[f"g{by}"] @ d for by, d in zip("xup", change, strict=True)),
        }
        found = dict(zip(expected, called(library, model, real, point, change), strict=True))
        rtol = {"double": 1e-9, "float": 2e-2}[real]
        for key, exact in expected.items():
            np.testing.assert_allclose(found[key], exact, rtol, rtol * abs(exact).max())


def around(*vectors: np.ndarray) -> list[tuple[np.ndarray, float]]:
    """Vectors x, u, p, and how far from them points are."""
    return list(zip(vectors, (0.01, 0.01, 0.001), strict=True))


@cache
def start(name: str) -> tuple[np.ndarray, ...]:
    from groundroll.exchange.subject import subject

    plane, model, values = case(name)
    found = subject(plane, model, values, "a test")
    groups = (found.start, found.inputs, found.parameters)
    return tuple(np.array(list(group.values())) for group in groups)


def shared(name: str, real: str, tmp_path: Path) -> ctypes.CDLL:
    """The model linked with the mathematical library and with nothing else."""
    folder = written(name, tmp_path)
    sources = [f"{name}.c", "parameters.c"]
    flag = [f"-D{name.upper()}_FLOAT"] if real == "float" else []
    command = ["cc", *STRICT.split(), "-O3", *flag, "-fPIC", "-shared", "-nostdlib", "-Wl,-z,defs"]
    subprocess.run([*command, *sources, "-lm", "-o", "model.so"], cwd=folder, check=True)
    return ctypes.CDLL(str(folder / "model.so"))


def called(library, model, real, point, change) -> list[np.ndarray]:
    """Results of all functions of a library."""
    kind = FLOATS[real]

    def call(function: str, given: list[np.ndarray], sizes: list[int]) -> list[np.ndarray]:
        arrays = [np.array(v, kind) for v in given]
        results = [np.full(size, np.nan, kind) for size in sizes]
        pointers = [ctypes.c_void_p(a.ctypes.data) for a in (*arrays, *results)]
        getattr(library, f"{model.name}_{function}")(*pointers)
        return results

    sizes = [len(model.states), len(model.outputs)]
    return [
        *call("rates", point, sizes[:1]),
        *call("outputs", point, sizes[1:]),
        *call("along", [*point, *change], sizes),
    ]


def test_a_step_may_be_cut_anywhere(tmp_path: Path) -> None:
    """In one call or in many, and going on with the step that was found."""
    plane, model, _ = case("nonlinear")
    library = shared("nonlinear", "double", tmp_path)
    x, u, p = start("nonlinear")

    def ended(pieces: int) -> np.ndarray:
        state, step = x.copy(), ctypes.c_double(0.0)
        pointers = [ctypes.c_void_p(a.ctypes.data) for a in (state, u, p)]
        duration, tolerance = ctypes.c_double(3.0 / pieces), ctypes.c_double(1e-11)
        for _ in range(pieces):
            assert (
                library.nonlinear_advance(*pointers, duration, tolerance, ctypes.byref(step)) == 0
            )
        return state

    exact = gr.simulate(plane, model, t=3.0, samples=2, v0=1.0, disturbance=-40.0, tol=1e-11)
    for pieces in (1, 7, 1000):
        expected = [exact[s][-1] for s in model.states]
        np.testing.assert_allclose(ended(pieces), expected, rtol=1e-9, atol=1e-10)


def test_what_leaves_the_numbers_is_told(tmp_path: Path) -> None:
    library = shared("nonlinear", "double", tmp_path)
    x, u, p = (v.copy() for v in start("nonlinear"))
    before, p[0] = x.copy(), np.nan
    pointers = [ctypes.c_void_p(a.ctypes.data) for a in (x, u, p)]
    numbers = [ctypes.c_double(v) for v in (1.0, 1e-9)]
    assert library.nonlinear_advance(*pointers, *numbers, None) == 1
    np.testing.assert_array_equal(x, before)


@pytest.mark.parametrize(
    "operation",
    [
        *("sinh", "cosh", "asinh", "atanh", "expm1", "log1p", "floor", "ceil", "erf", "sign"),
        *("hypot", "fmod", "copysign", "fmin", "fmax", "atan2"),
        *(ca.OP_EQ, ca.OP_NE, ca.OP_AND, ca.OP_OR, ca.OP_NOT, ca.OP_LE),
    ],
)
def test_any_operation_of_a_law_is_written(operation: str | int) -> None:
    """What the models at hand do not use, too."""
    from groundroll.exchange.program import JAVASCRIPT, C, read, statements

    a, b = ca.SX.sym("a"), ca.SX.sym("b")
    if isinstance(operation, int):
        made = ca.SX.binary(operation, a, b) if operation != ca.OP_NOT else ca.logic_not(a)
    else:
        made = getattr(ca, operation)(*((a, b) if operation in TWO else (a,)))
    program = read([a, b], [made], [["a"], ["b"]])
    for language in (C, JAVASCRIPT) if operation not in ("erf", "copysign") else (C,):
        (line,) = list(statements(program, language))[-1:]
        assert line.startswith("const ")


TWO = ("hypot", "fmod", "copysign", "fmin", "fmax", "atan2")


def test_names_with_markup_do_no_harm(tmp_path: Path) -> None:
    plane = gr.Aircraft.load("brott")
    odd = gr.Aircraft('*/ #error "x" \\', plane.given, title='a */ int??/ "b" \u202e\n#error <b>')
    folder = gr.export(odd, "c", tmp_path / "odd", "linear", v0=0.1)
    subprocess.run(["make", "-s", f"CFLAGS={STRICT}"], cwd=folder, check=True)
    subprocess.run(["./roll"], cwd=folder, check=True, capture_output=True)


def test_a_folder_is_filled_again_and_keeps_what_is_not_ours(tmp_path: Path) -> None:
    written("linear", tmp_path)
    (tmp_path / "linear" / "mine.txt").write_text("mine")
    (tmp_path / "linear" / "main.c").write_text("older")
    folder = written("linear", tmp_path)
    assert (folder / "mine.txt").read_text() == "mine"
    assert "SAMPLES" in (folder / "main.c").read_text()
    assert [path.name for path in tmp_path.iterdir()] == ["linear"]


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"to": "rust"}, "unknown target 'rust' in export; there is c"),
        ({"model": "linea"}, "unknown model 'linea'; did you mean linear"),
        (
            {"v0": [0.1, 0.2]},
            "export takes one aircraft, but lateral_velocity (v) is an array of 2",
        ),
        ({"mass": [900, 950]}, "export takes one aircraft, but mass (m) is an array of 2"),
        ({"disturbance": gr.gusts.step(1.0)}, "disturbance must be constant here"),
        ({"out": "nowhere/deep/plane"}, "cannot write .*plane"),
        ({"out": "file"}, "cannot write .*file"),
        ({"model": "rollout", "wing_area": None, "plane": "lacking"}, "lacks"),
    ],
    ids=str,
)
def test_what_cannot_be_is_said_and_nothing_is_left(changes, told, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("mine")
    settings = {"to": "c", "out": "plane", "model": "linear", **changes}
    given = {k: v for k, v in settings.items() if k not in ("to", "out", "model", "plane")}
    plane = (
        gr.Aircraft("lacking", {"m": 900.0}) if "plane" in settings else gr.Aircraft.load("brott")
    )
    with pytest.raises(gr.GroundrollError, match=told.replace("(", r"\(").replace(")", r"\)")):
        gr.export(plane, settings["to"], tmp_path / settings["out"], settings["model"], **given)
    assert [path.name for path in tmp_path.iterdir()] == ["file"]
    assert (tmp_path / "file").read_text() == "mine"


# nobody, who stands in for root there, may not compile
@pytest.mark.parametrize("to", ["c", "fmu"] if os.geteuid() else ["c"])
def test_a_folder_that_is_read_only_is_told(to: str) -> None:
    plane = gr.Aircraft.load("brott")
    with (
        read_only_folder() as folder,
        pytest.raises(gr.GroundrollError, match=r"cannot write .*Permission denied"),
    ):
        gr.export(plane, to, folder / "plane", "linear")


def test_the_command_writes_the_same(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    expected = gr.export(gr.Aircraft.load("brott"), "c", tmp_path / "a", v0="1 kt", m="900 kg")
    arguments = ["export", "brott", "--to", "c", "--out", str(tmp_path / "b"), "--set", "v0=1 kt"]
    assert main([*arguments, "--set", "m=900 kg"]) == 0
    assert str(tmp_path / "b") in capsys.readouterr().err
    for path in expected.iterdir():
        assert (tmp_path / "b" / path.name).read_bytes() == path.read_bytes()
    assert main([*arguments[:3], "pascal", *arguments[4:]]) == 2
    assert "unknown target 'pascal'" in capsys.readouterr().err
