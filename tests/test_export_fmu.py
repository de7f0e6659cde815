"""Components of the Functional Mock-up Interface: valid, and in motion as `simulate` says."""

from __future__ import annotations

import ctypes
import os
import shutil
import subprocess
import tempfile
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import Any

import fmpy
import numpy as np
import pytest
from exported import NAMES, case
from fmpy.fmi2 import FMU2Slave
from fmpy.fmi3 import FMU3Slave
from fmpy.validation import validate_fmu

import groundroll as gr
from groundroll.cli import main

_FOLDER = tempfile.TemporaryDirectory(prefix="groundroll-fmu-")
VERSIONS = {"fmu": "3.0", "fmu2": "2.0"}
#: What is tuned in each model; not what decides how it starts, at rest on its legs.
TUNED = {
    "linear": "Ct",
    "nonlinear": "a",
    "rollout": "track",
    "landing_roll": "track",
    "landing_roll_flown": "tau_pilot",
    "single_track": "C_rear",
    "four_wheels": "grip",
    "lagging": "lag",
}


@cache
def made(name: str, to: str) -> Path:
    """The component of a case, written once."""
    plane, model, values = case(name)
    return gr.export(plane, to, Path(_FOLDER.name) / f"{name}-{to}.fmu", model, **values)


def agrees(name: str, found: Any, **changes: float) -> None:
    """Whether every state and output is that of `simulate`, to 1e-8 of its largest magnitude."""
    plane, model, values = case(name)
    run = gr.simulate(plane, model, t=3.0, samples=31, tol=1e-11, **{**values, **changes})
    for s in (*model.states, *model.outputs):
        largest = abs(run[s]).max()
        allowed = 1e-8 if s in model.states else 1e-7  # differences of large forces
        error = abs(found[model.quantities[s].name] - run[s]).max()
        assert error <= 1e-9 + allowed * largest, s


@pytest.mark.parametrize("to", VERSIONS)
@pytest.mark.parametrize("name", NAMES)
def test_a_component_is_valid_and_small(name: str, to: str) -> None:
    path = made(name, to)
    assert validate_fmu(str(path)) == []
    assert path.stat().st_size < 500_000
    with zipfile.ZipFile(path) as archive:
        names = archive.namelist()
    assert "sources/all.c" in names
    assert "documentation/licenses/FMI.txt" in names
    assert len([n for n in names if n.startswith("binaries/")]) == 1


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
@pytest.mark.parametrize("to", VERSIONS)
@pytest.mark.parametrize("name", NAMES)
def test_it_moves_as_simulate_does_and_so_with_a_parameter_tuned(
    name: str, to: str, kind: str
) -> None:
    plane, model, _ = case(name)
    settings = {"fmi_type": kind, "stop_time": 3.0, "output_interval": 0.1}
    settings["relative_tolerance"] = 1e-12 if kind == "ModelExchange" else 1e-11
    agrees(name, fmpy.simulate_fmu(str(made(name, to)), **settings))
    s = TUNED[name]
    value = 1.1 * float(plane.parameters(model)[model.parameters.index(s)])
    start = {model.quantities[s].name: value}
    tuned = fmpy.simulate_fmu(str(made(name, to)), start_values=start, **settings)
    agrees(name, tuned, **{s: value})


@pytest.mark.parametrize("to", VERSIONS)
def test_variables_have_names_types_and_units(to: str) -> None:
    plane, model, values = case("rollout")
    about = fmpy.read_model_description(str(made("rollout", to)))
    assert about.fmiVersion == VERSIONS[to]
    assert about.numberOfEventIndicators == 0
    found = {v.name: v for v in about.modelVariables}
    p = dict(zip(model.parameters, plane.parameters(model), strict=True))
    for s in model.parameters:
        v = found[model.quantities[s].name]
        assert (v.causality, v.variability, float(v.start)) == ("parameter", "tunable", p[s])
        assert v.unit == v.declaredType.unit == model.quantities[s].unit
        assert v.description == model.quantities[s].meaning
    assert float(found[model.quantities["u"].name].start) == values["u0"]
    assert float(found["pedal"].start) == values["pedal"]
    assert found["pedal"].causality == "input"
    assert found["der(yaw_rate)"].derivative.name == "yaw_rate"
    assert found["der(yaw_rate)"].unit == "rad/s^2"
    assert found["mass"].min == "0.0"
    assert found["mass"].displayUnit == "lb"  # as in the aircraft's file
    assert found["heading"].displayUnit == "deg"
    assert found["heading"].declaredType.name == "Angle"
    bases = {u.name: u.baseUnit for u in about.unitDefinitions}
    assert (bases["N"].kg, bases["N"].m, bases["N"].s, bases["N"].rad) == (1, 1, -2, 0)
    assert bases["1/rad"].rad == -1
    (mass,) = (u for u in about.unitDefinitions if u.name == "kg")
    pounds = {d.name: float(d.factor) for d in mass.displayUnits}
    assert pounds["lb"] == pytest.approx(1 / 0.45359237, rel=1e-12)


@contextmanager
def instance(name: str, to: str, token: str | None = None) -> Iterator[Any]:
    """A component of co-simulation at its start."""
    path = made(name, to)
    about = fmpy.read_model_description(str(path))
    folder = fmpy.extract(str(path))
    model = (FMU3Slave if to == "fmu" else FMU2Slave)(
        guid=token or about.guid,
        unzipDirectory=folder,
        modelIdentifier=about.coSimulation.modelIdentifier,
        instanceName="plane",
    )
    try:
        model.instantiate()
        if to == "fmu2":
            model.setupExperiment(startTime=0.0, tolerance=1e-11)
            model.enterInitializationMode()
        else:
            model.enterInitializationMode(startTime=0.0, tolerance=1e-11)
        model.exitInitializationMode()
        model.references = {v.name: v.valueReference for v in about.modelVariables}
        model.get = model.getReal if to == "fmu2" else model.getFloat64
        model.set = model.setReal if to == "fmu2" else model.setFloat64
        yield model
        model.terminate()
        model.freeInstance()
    finally:
        shutil.rmtree(folder)


@pytest.mark.parametrize("to", VERSIONS)
@pytest.mark.parametrize("name", ["nonlinear", "landing_roll", "four_wheels"])
def test_directional_derivatives_are_the_models(name: str, to: str) -> None:
    model = case(name).model
    q = model.quantities
    with instance(name, to) as component:
        known = [*model.states, *model.inputs, *model.parameters]
        reference = {s: component.references[q[s].name] for s in (*known, *model.outputs)}
        rates = [component.references[f"der({q[s].name})"] for s in model.states]
        unknown = [*rates, *(reference[s] for s in model.outputs)]
        point = component.get([reference[s] for s in known])
        x, u, p = np.split(point, np.cumsum([len(model.states), len(model.inputs)]))
        J = [np.array(each) for each in model.function("jacobians")(x, u, p)]
        expected = np.block([J[:3], J[3:]])
        seed = np.random.default_rng(2).normal(size=len(known)) * (0.01 + abs(np.array(point)))
        given = [reference[s] for s in known]
        found = component.getDirectionalDerivative(unknown, given, list(seed))
        exact = expected @ seed
        np.testing.assert_allclose(found, exact, 1e-9, 1e-9 * abs(exact).max())
        # a state is known and, as an output, unknown too
        state = reference[model.states[0]]
        assert component.getDirectionalDerivative([state], [state], [2.0])[0] == 2.0


@pytest.mark.parametrize("to", VERSIONS)
def test_a_parameter_and_an_input_may_change_on_the_way_and_a_state_be_kept(to: str) -> None:
    plane, model, values = case("nonlinear")
    p = dict(zip(model.parameters, plane.parameters(model), strict=True))
    with instance("nonlinear", to) as component:
        states = [component.references[model.quantities[s].name] for s in model.states]
        slope = component.references["tail_lift_slope"]
        force = component.references["disturbance"]
        component.doStep(0.0, 1.0)
        get, put = (
            (component.getFMUstate, component.setFMUstate)
            if to == "fmu2"
            else (component.getFMUState, component.setFMUState)
        )
        kept, middle = get(), component.get(states)
        component.set([slope, force], [1.2 * p["CL_gamma"], 55.0])
        component.doStep(1.0, 1.0)
        changed = component.get(states)
        put(kept)
        assert component.get(states) == middle
        component.doStep(1.0, 1.0)
        unchanged = component.get(states)
    first = gr.simulate(plane, model, t=1.0, samples=2, tol=1e-11, **values)
    between = {f"{s}0": first[s][-1] for s in model.states}
    same = {"disturbance": values["disturbance"]}
    for found, change in (
        (changed, {"CL_gamma": 1.2 * p["CL_gamma"], "disturbance": 55.0}),
        (unchanged, same),
    ):
        run = gr.simulate(plane, model, t=1.0, samples=2, tol=1e-11, **between, **change)
        expected = [run[s][-1] for s in model.states]
        np.testing.assert_allclose(found, expected, rtol=1e-8, atol=1e-10)


@pytest.mark.parametrize("to", VERSIONS)
def test_what_a_component_cannot_do_is_an_error_and_said(to: str, capfd: Any) -> None:
    with instance("linear", to) as component:
        references, far = component.references, 10_000
        for call in (
            lambda: component.get([far]),
            lambda: component.set([far], [1.0]),
            lambda: component.set([references["side_force"]], [1.0]),
            lambda: component.set([references["der(yaw_rate)"]], [1.0]),
            lambda: component.set([references["mass"]], [np.nan]),
            lambda: component.doStep(0.0, -1.0),
            lambda: component.getDirectionalDerivative([far], [references["mass"]], [1.0]),
        ):
            with pytest.raises(Exception, match="fmi"):
                call()
        component.set([references["speed"]], [1e-300])
        with pytest.raises(Exception, match="fmi"):
            component.doStep(0.0, 1.0)
    said = capfd.readouterr().out
    assert "cannot be set" in said
    assert "must be a finite number" in said
    assert "grows without bound" in said
    with pytest.raises(Exception, match=r"(?i)instantiate"), instance("linear", to, "{other}"):
        pass


#: A step of co-simulation in C, as another simulator takes it.
DRIVER = """
#include "all.c"
int main(void)
{
    fmi3Boolean no, none; fmi3Float64 last; fmi3FMUState kept = NULL;
    fmi3Instance c = fmi3InstantiateCoSimulation("plane", TOKEN, "", 0, 0, 0, 0, NULL, 0, NULL,
        NULL, NULL);
    fmi3EnterInitializationMode(c, 1, 1e-9, 0, 0, 0);
    fmi3ExitInitializationMode(c);
    fmi3EnterStepMode(c);
    fmi3GetFMUState(c, &kept);
    for (int k = 0; k < 20; ++k)
        if (fmi3DoStep(c, 0.1 * k, 0.1, 1, &no, &none, &no, &last))
            return 1;
    unsigned all[END]; double values[END];
    for (unsigned k = 0; k < END; ++k)
        all[k] = k;
    fmi3GetFloat64(c, all, END, values, END);
    fmi3GetDirectionalDerivative(c, all, END, all + U, NU + NP, values, NU + NP, values, END);
    fmi3SetFMUState(c, kept);
    fmi3FreeFMUState(c, &kept);
    fmi3Reset(c);
    fmi3FreeInstance(c);
    return fmi3InstantiateCoSimulation("x", "y", "", 0, 0, 0, 0, NULL, 0, NULL, NULL, NULL) != NULL;
}
"""


@pytest.mark.parametrize("name", ["landing_roll", "four_wheels"])
def test_the_source_is_clean(name: str, tmp_path: Path) -> None:
    strict = ["-O1", "-g", "-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic"]
    for to in VERSIONS:
        with zipfile.ZipFile(made(name, to)) as archive:
            archive.extractall(tmp_path / to)
        sources = tmp_path / to / "sources"
        command = ["cc", *strict, "-fsyntax-only", "all.c"]
        subprocess.run(command, cwd=sources, check=True)
    sources = tmp_path / "fmu" / "sources"
    (sources / "driver.c").write_text(DRIVER)
    sanitized = ["-fsanitize=address,undefined", "-fno-sanitize-recover=all"]
    command = ["cc", *strict, *sanitized, "driver.c", "-lm", "-o", "driver"]
    subprocess.run(command, cwd=sources, check=True)
    subprocess.run(["./driver"], cwd=sources, check=True)


def test_the_library_needs_no_python_and_shows_nothing_of_its_own(tmp_path: Path) -> None:
    with zipfile.ZipFile(made("nonlinear", "fmu")) as archive:
        (library,) = (n for n in archive.namelist() if n.startswith("binaries/"))
        archive.extract(library, tmp_path)
    path = tmp_path / library
    needed = subprocess.run(["ldd", str(path)], capture_output=True, text=True, check=True).stdout
    assert "python" not in needed
    opened = ctypes.CDLL(str(path))
    assert hasattr(opened, "fmi3DoStep")
    assert not hasattr(opened, "model_rates")


def test_two_exports_are_the_same_file_and_another_aircrafts_is_not(tmp_path: Path) -> None:
    plane, model, values = case("nonlinear")
    again = gr.export(plane, "fmu", tmp_path / "again.fmu", model, **values)
    assert again.read_bytes() == made("nonlinear", "fmu").read_bytes()
    other = gr.export(plane, "fmu", tmp_path / "other.fmu", model, m=1000.0)
    tokens = [fmpy.read_model_description(str(p)).guid for p in (again, other)]
    assert tokens[0] != tokens[1]


def test_a_name_with_markup_stays_text(tmp_path: Path) -> None:
    given = gr.Aircraft.load("brott").given
    odd = gr.Aircraft("odd", given, title='<b>"A & B"</b> \x1b[31m */ \ud800')
    for to in VERSIONS:
        path = gr.export(odd, to, tmp_path / f"{to}.fmu", "linear")
        assert validate_fmu(str(path)) == []
        assert '<b>"A & B"</b>' in fmpy.read_model_description(str(path)).description


def test_without_a_compiler_it_says_so_and_leaves_what_was_there(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CC", "no-such-compiler")
    monkeypatch.setattr("groundroll.exchange.fmu.compiler", uncached())
    path = tmp_path / "plane.fmu"
    path.write_text("mine")
    with pytest.raises(gr.GroundrollError, match=r"needs a C compiler.*no-such-compiler.*--to c"):
        gr.export(gr.Aircraft.load("brott"), "fmu", path)
    assert path.read_text() == "mine"
    assert os.listdir(tmp_path) == ["plane.fmu"]


def uncached() -> Any:
    from groundroll.generated import compiler

    return compiler.compiler.__wrapped__


def test_the_command_writes_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "plane.fmu"
    arguments = ["export", "brott", "--to", "fmu2", "--model", "linear", "--out", str(path)]
    assert main([*arguments, "--set", "v0=1 kt"]) == 0
    found = {v.name: v for v in fmpy.read_model_description(str(path)).modelVariables}
    assert float(found["lateral_velocity"].start) == pytest.approx(0.514444, rel=1e-5)
    capsys.readouterr()
    assert main([*arguments[:-1], str(tmp_path / "nowhere" / "plane.fmu")]) == 1
    assert "cannot write" in capsys.readouterr().err
