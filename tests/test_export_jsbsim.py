"""Aircraft written out for JSBSim, which is an independent code, roll there as they do here."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

import numpy as np
import pytest
from jsbsim_live import INPUTS, disagreements, roll
from oracle_roll import Signal

import groundroll as gr
from groundroll.cli import main
from groundroll.exchange import export
from groundroll.exchange.jsbsim import WHEELS
from groundroll.exchange.subject import subject

#: Where an exported aircraft has its inputs.
TARGETS = INPUTS | {
    "pedal": (("fcs/rudder-cmd-norm", -1.0), ("fcs/steer-cmd-norm", 1.0)),
    "thrust": (("groundroll/thrust-N", 1.0),),
    "F_disturbance": (("groundroll/disturbance-N", 1.0),),
}
#: The tires of the main wheels and of the third: what their loads change, and by which slope.
TIRES = {"": "left", "_third": "third"}


def frozen(name: str, **changes: Any) -> gr.Aircraft:
    """A packaged aircraft whose tires have the coefficients of their loads at rest."""
    plane = gr.Aircraft.load(name).replace(**changes)
    case = subject(plane, "landing_roll", {}, "test")
    rest = gr.simulate(plane, "landing_roll", u0=10.0, t=1e-3, samples=2)
    own: dict[str, float] = {}
    for ending, wheel in TIRES.items():
        load = float(rest[f"Fz_{wheel}"][0])
        for level, slope in (("B3", "C3"), ("B5", "C5")):
            p = case.parameters
            own |= {level + ending: p[level + ending] + p[slope + ending] * load}
            own |= {slope + ending: 0.0}
    return plane.replace(**own)


def ours(signal: Signal) -> Any:
    """A signal of the oracle's as one of the library's."""
    if not isinstance(signal, dict):
        return signal
    match signal["type"]:
        case "step":
            return gr.signals.step(signal["value"], signal["t0"], signal.get("end"))
        case "1-cos":
            return gr.signals.one_minus_cosine(signal["peak"], signal["t0"], signal["T"])
    return gr.signals.sampled(signal["t"], signal["v"])


def pulse(height: float, start: float, end: float) -> Signal:
    """Up and down again in a tenth of a second."""
    times = [0.0, start, start + 0.1, end, end + 0.1, 100.0]
    return {"type": "linear", "t": times, "v": [0.0, 0.0, height, height, 0.0, 0.0]}


@dataclass(frozen=True)
class Run:
    """A roll that both do."""

    plane: str
    speed: float
    inputs: Mapping[str, Signal] = field(default_factory=dict)
    drift: float = 0.0
    t: float = 3.0
    changes: Mapping[str, Any] = field(default_factory=dict)
    #: A wheel that comes down hard asks JSBSim for shorter steps: its error falls with them.
    bounces: bool = False


STEP = {"type": "step", "t0": 0.5}
GUST = {"type": "1-cos", "t0": 0.5, "T": 1.5, "peak": 6.0}
RUNS = {
    "kick, tail": Run("cessna-170", 18.0, drift=0.8),
    "kick, nose": Run("cessna-172p", 20.0, drift=2.0),
    "kick, thesis": Run("brott-physical", 20.0, drift=0.5),
    "crosswind, tail": Run("cessna-170", 22.0, {"wind_y": 4.0, "wind_x": -3.0}),
    "crosswind, nose": Run("cessna-172p", 24.0, {"wind_y": -6.0}),
    "gust, tail": Run("cessna-170", 20.0, {"wind_y": GUST}),
    "gust, thesis": Run("brott-physical", 16.0, {"wind_y": GUST}),
    "rudder": Run("cessna-170", 20.0, {"rudder": STEP | {"value": 0.1}}, t=2.5),
    "aileron": Run("cessna-172p", 24.0, {"aileron": STEP | {"value": -0.2}}),
    "elevator": Run(
        "cessna-170", 22.0, {"elevator": STEP | {"value": -0.3}, "wind_y": 2.0}, bounces=True
    ),
    "pedal": Run("cessna-172p", 12.0, {"pedal": STEP | {"value": 0.3}}),
    "pedal, tail": Run("brott-physical", 8.0, {"pedal": STEP | {"value": -0.2}}, t=2.5),
    "power": Run("cessna-170", 4.0, {"thrust": 1500.0, "rudder": -0.2, "elevator": 0.1}, t=4.0),
    "one brake": Run("cessna-172p", 10.0, {"brake_left": STEP | {"value": 0.15}}, t=6.0),
    "both brakes, to rest": Run(
        "cessna-170", 5.0, {"brake_left": 0.2, "brake_right": 0.2, "pedal": -0.1}, t=3.8
    ),
    "push": Run("cessna-172p", 15.0, {"F_disturbance": pulse(800.0, 0.5, 1.5)}),
    "a wheel lifts and returns": Run(
        "cessna-172p", 26.0, {"aileron": pulse(0.42, 0.5, 1.2), "pedal": pulse(0.35, 0.5, 1.2)}
    ),
    "the tail lifts and returns": Run(
        "cessna-170",
        15.0,
        {f"brake_{s}": pulse(0.8, 0.3, 0.8) for s in ("left", "right")},
        bounces=True,
    ),
    "toe, coupled axes": Run(
        "cessna-172p",
        22.0,
        {"aileron": STEP | {"value": 0.15}},
        changes={"toe": "1 deg", "Ixz": 600.0, "z_thrust": -0.2},
    ),
}
#: In which a wheel must leave the ground and come back.
LIFTS = {"a wheel lifts and returns", "the tail lifts and returns"}


def rolled(run: Run, folder: Path) -> tuple[dict[str, Any], dict[str, Any]]:
    """What becomes of a run here and there."""
    plane = frozen(run.plane, **run.changes)
    samples = round(run.t * 40) + 1
    start = subject(plane, "landing_roll", {}, "test").start
    here = gr.simulate(
        plane,
        "landing_roll",
        u0=run.speed * np.cos(start["theta"]),
        v0=run.drift,
        t=run.t,
        samples=samples,
        tol=1e-8,
        **{name: ours(signal) for name, signal in run.inputs.items()},
    )
    path = export(plane, "jsbsim", folder / "plane.xml")
    there = roll(
        path.read_text(),
        run.inputs,
        here.t,
        folder,
        height=-start["Z"],
        theta=start["theta"],
        speed=run.speed,
        drift=run.drift,
        gravity=float(plane["g"]),
        step=1 / 9600 if run.bounces else 1 / 2400,
        targets=TARGETS,
    )
    mine = {s: here[s] for s in ("u", "v", "psi", "phi")}
    return mine | {f"N{k}": here[f"Fz_{w.name}"] for k, w in enumerate(WHEELS)}, there


@pytest.mark.parametrize("name", RUNS)
def test_jsbsim_rolls_alike(name: str, tmp_path: Path) -> None:
    here, there = rolled(RUNS[name], tmp_path)
    assert not disagreements(here, there)
    if name in LIFTS:
        loads = np.array([there[f"N{k}"] for k in range(3)])
        lifted = (loads == 0).any(axis=1)
        assert lifted.any()
        assert (loads[lifted, -1] > 0).all()


def test_it_says_what_it_does_not_carry(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """In the file, and on the terminal."""
    out = tmp_path / "plane.xml"
    words = ["export", "cessna-172p", "--to", "jsbsim", "--out", str(out), "--set", "swivels=1"]
    main(words)
    told = re.findall(r"^- (.*)$", "".join(capsys.readouterr()), re.MULTILINE)
    written = re.findall(r"^- (.*)$", out.read_text(), re.MULTILINE)
    assert told == written
    for word in ("load", "ellipse", "rest_speed", "swivel", "ground loops"):
        assert any(word in each for each in told), word


def test_what_another_program_reads_are_the_numbers_of_the_aircraft(tmp_path: Path) -> None:
    """Mass, stations and wings of the file, as an import would read them."""
    plane = gr.Aircraft.load("cessna-170")
    root = ET.parse(export(plane, "jsbsim", tmp_path / "plane.xml")).getroot()
    sections = [root.find("metrics"), root.find("mass_balance")]
    found = {e.tag: float(e.text or "nan") for part in sections for e in part or () if not len(e)}
    assert found["emptywt"] == pytest.approx(float(plane["m"]), rel=1e-12)
    assert found["wingarea"] == pytest.approx(float(plane["S_wing"]), rel=1e-12)
    # 1 slug ft^2 = 1.3558179483314 kg m^2
    assert found["izz"] * 1.3558179483314 == pytest.approx(float(plane["Izz"]), rel=1e-12)
    wheels = [
        [float(contact.findtext(f"location/{axis}") or "nan") for axis in "xyz"]
        for contact in root.iter("contact")
    ]
    a, half, z = (float(plane[s]) for s in ("a", "track", "z_main"))
    assert wheels[0] == pytest.approx([-a, -half / 2, -z])
    assert wheels[1] == pytest.approx([-a, half / 2, -z])
    assert wheels[2] == pytest.approx([-float(plane["a_third"]), 0.0, -float(plane["z_third"])])


def test_what_cannot_be_exported_is_refused(tmp_path: Path) -> None:
    plane, out = gr.Aircraft.load("cessna-170"), tmp_path / "plane.xml"
    with pytest.raises(gr.GroundrollError, match="landing_roll, not rollout"):
        export(plane, "jsbsim", out, "rollout")
    with pytest.raises(gr.GroundrollError, match="takes one aircraft"):
        export(plane.replace(m=[900.0, 1000.0]), "jsbsim", out)
    assert not out.exists()


def test_names_that_are_no_xml_are_written_in_full(tmp_path: Path) -> None:
    """A title with marks of XML stays a title, and a comment stays a comment."""
    plane = gr.Aircraft.load("cessna-170")
    odd = gr.Aircraft("a/b <c>", dict(plane.given), title='<b> & "--> x')
    root = ET.parse(export(odd, "jsbsim", tmp_path / "plane.xml")).getroot()
    assert root.get("name") == "a-b--c"
    assert root.findtext("fileheader/description") == '<b> & "--> x'
