"""An aircraft as a JSBSim file: to fly it, and to check ours against another program."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, NamedTuple
from xml.etree import ElementTree as ET

import numpy as np

from groundroll.base.arrays import FloatArray
from groundroll.base.errors import GroundrollError
from groundroll.base.files import complete
from groundroll.base.wording import encodable, visible
from groundroll.model.evaluate import columns

from .jsbsim_functions import FOOT, INPUTS, SLUG, aerodynamics
from .subject import Subject

#: The model that the file has, and what it must know.
MODEL = "landing_roll"
#: Slip angles of the tables of the tires, deg, and the speed at which they are taken, m/s.
_SLIPS = np.concatenate((np.arange(0.0, 30.0, 0.25), np.arange(30.0, 91.0, 2.5)))
_SPEED = 30.0
#: Above this, deg, a wheel of JSBSim's casters.
_CASTERS = 360.0


class Wheel(NamedTuple):
    """What the model calls the facts of a wheel: its place is along x, y and z of the body."""

    name: str
    leg: str
    x: str
    side: float
    z: str
    brake: str


WHEELS = (
    Wheel("left", "main", "a", -0.5, "z_main", "LEFT"),
    Wheel("right", "main", "a", 0.5, "z_main", "RIGHT"),
    Wheel("third", "third", "a_third", 0.0, "z_third", "NONE"),
)


def write_jsbsim(subject: Subject, path: Path) -> tuple[str, ...]:
    """Write the aircraft as a JSBSim file, and give what the file does not carry.

    Raises
    ------
    GroundrollError
        If the model is another than the landing roll, or the file cannot be written.
    """
    if subject.model.name != MODEL:
        raise GroundrollError(
            f"a JSBSim file has an aircraft on legs: it is made of the model {MODEL}, not"
            f" {subject.model.name}"
        )
    lost = tuple(_lost(subject))
    text = jsbsim_text(subject, lost)
    with complete(path) as draft:
        draft.write_text(text, encoding="utf-8")
    return lost


def jsbsim_text(subject: Subject, lost: tuple[str, ...]) -> str:
    """The file; what it does not carry stands in a comment at its top."""
    root = ET.Element("fdm_config", name=_name(subject), version="2.0", release="ALPHA")
    root.append(ET.Comment(_comment(subject, lost)))
    head = ET.SubElement(root, "fileheader")
    for tag, text in (
        ("author", encodable(subject.origin)),
        ("filecreationdate", "1970-01-01"),  # equal aircraft are equal files
        ("version", subject.model.digest),
        ("description", visible(encodable(subject.title))),
    ):
        ET.SubElement(head, tag).text = text
    root.append(_metrics(subject.parameters))
    root.append(_mass(subject.parameters))
    root.append(_wheels(subject))
    ET.SubElement(root, "propulsion")
    controls = ET.SubElement(root, "flight_control", name="groundroll")
    for target, _ in INPUTS.values():
        if target.startswith("groundroll/"):
            ET.SubElement(controls, "property", value="0").text = target
    root.append(aerodynamics(subject))
    ET.indent(root)
    return '<?xml version="1.0"?>\n' + ET.tostring(root, "unicode") + "\n"


def _name(subject: Subject) -> str:
    """A name of a folder, as JSBSim wants it."""
    plain = "".join(c if c.isascii() and c.isalnum() else "-" for c in subject.aircraft.name)
    return plain.strip("-") or "aircraft"


def _comment(subject: Subject, lost: tuple[str, ...]) -> str:
    name, start = _name(subject), subject.start
    lines = [
        f"{subject.title}. {subject.origin}",
        f"JSBSim looks for it as aircraft/{name}/{name}.xml.",
        f"It stands on its wheels with the CG {-start['Z']:.6g} m above the runway and pitched"
        f" {math.degrees(start['theta']):.6g} deg up.",
        "Its axes are those of the body, from the CG. Right pedal: fcs/rudder-cmd-norm -1 and"
        " fcs/steer-cmd-norm 1. Elevator, aileron and rudder: fcs/elevator-pos-rad,"
        " fcs/left-aileron-pos-rad and fcs/rudder-pos-rad. Thrust along x: groundroll/thrust-N;"
        " a force at the fin, to the right: groundroll/disturbance-N.",
        "This file does not carry:",
        *(f"- {each}" for each in lost),
    ]
    text = "\n".join(visible(encodable(line)) for line in lines)
    return "\n" + text.replace("--", "- -") + "\n"


def _lost(subject: Subject) -> Iterator[str]:
    """What JSBSim has no place for."""
    p = subject.parameters
    loads = ", ".join(f"{load:.0f} N" for load in _at_rest(subject).values())
    yield (
        "how tires change with their load: they are those of the loads at rest"
        f" (left, right, third: {loads})"
    )
    yield "the friction ellipse: JSBSim limits the forces along and across a wheel each for itself"
    yield f"creeping near rest (rest_speed {p['v_rest']:g} m/s): JSBSim holds a standing wheel"
    if p["swivels"]:
        what = "springs, break-out, damping, stops and inertia" if p["k_swivel"] else "its inertia"
        yield f"the swivel of the third wheel ({what}): here it casters freely"
    yield (
        "ground loops, strikes of wing tips and propeller, the width of the runway: JSBSim has no"
        " such events"
    )
    moved = [subject.model.quantities[s].name for s, value in subject.inputs.items() if value]
    if moved:
        yield f"inputs ({', '.join(moved)}): an aircraft file has none"
    at = {s: value for s, value in subject.start.items() if value and s not in ("Z", "theta", "w")}
    if at:
        yield f"the start ({', '.join(f'{s} {v:.6g}' for s, v in at.items())}): it is for a script"


def _number(parent: ET.Element, tag: str, value: float, unit: str = "") -> None:
    element = ET.SubElement(parent, tag, {"unit": unit} if unit else {})
    element.text = repr(float(value) + 0.0)


def _place(parent: ET.Element, name: str, x: float, y: float, z: float) -> None:
    """A place in JSBSim's structural axes, x aft and z up, of one in those of the body."""
    at = ET.SubElement(parent, "location", {"name": name} if name else {}, unit="M")
    for axis, value in zip("xyz", (-x, y, -z), strict=True):
        _number(at, axis, value)


def _metrics(p: Mapping[str, float]) -> ET.Element:
    found = ET.Element("metrics")
    for tag, value, unit in (
        ("wingarea", p["S_wing"], "M2"),
        ("wingspan", p["b_wing"], "M"),
        ("chord", p["c_wing"], "M"),
        ("htailarea", p["S_h"], "M2"),
        ("htailarm", -p["x_h"], "M"),
        ("vtailarea", p["Ap"], "M2"),
        ("vtailarm", p["b"], "M"),
    ):
        _number(found, tag, value, unit)
    for name in ("AERORP", "EYEPOINT", "VRP"):
        _place(found, name, 0.0, 0.0, 0.0)
    return found


def _mass(p: Mapping[str, float]) -> ET.Element:
    found = ET.Element("mass_balance")
    # in its own unit: JSBSim's KG*M2 is off by 9e-5
    own = SLUG * FOOT**2
    for tag, value in (("ixx", p["Ixx"]), ("iyy", p["Iyy"]), ("izz", p["Izz"]), ("ixz", -p["Ixz"])):
        _number(found, tag, value / own, "SLUG*FT2")
    _number(found, "emptywt", p["m"], "KG")
    _place(found, "CG", 0.0, 0.0, 0.0)
    return found


def _wheels(subject: Subject) -> ET.Element:
    p, tables, most = subject.parameters, _tables(subject), _friction(subject)
    found = ET.Element("ground_reactions")
    for wheel in WHEELS:
        contact = ET.SubElement(found, "contact", type="BOGEY", name=wheel.name.upper())
        _place(contact, "", p[wheel.x], wheel.side * p["track"], p[wheel.z])
        if wheel.side:
            turned = ET.SubElement(contact, "orientation", unit="DEG")
            for tag, angle in (("pitch", 0.0), ("roll", 0.0), ("yaw", 2 * wheel.side * p["toe"])):
                _number(turned, tag, math.degrees(angle))
        table = tables[wheel.name]
        mu = most.get(wheel.name, float(np.abs(table).max()))
        for tag, value, unit in (
            ("static_friction", mu, ""),
            ("dynamic_friction", mu, ""),
            ("rolling_friction", p[f"mu_roll_{wheel.name}"], ""),
            ("spring_coeff", p[f"k_{wheel.leg}"], "N/M"),
            ("damping_coeff", p[f"c_{wheel.leg}"], "N/M/SEC"),
            ("max_steer", 0.0 if wheel.side else _steers(p), "DEG"),
        ):
            _number(contact, tag, value, unit)
        ET.SubElement(contact, "brake_group").text = wheel.brake
        ET.SubElement(contact, "retractable").text = "0"
        curve = ET.SubElement(contact, "table", name="CORNERING_COEFF", type="internal")
        slips, heights = (np.append(-x[:0:-1], x) for x in (_SLIPS, table))
        rows = (f"{a:g} {c + 0.0!r}" for a, c in zip(slips, heights.tolist(), strict=True))
        ET.SubElement(curve, "tableData").text = "\n" + "\n".join(rows) + "\n"
    return found


def _steers(p: Mapping[str, float]) -> float:
    """The angle of the third wheel at full right pedal, deg; with none, that of a steering of 1."""
    return _CASTERS if p["swivels"] else math.degrees(p["steering_ratio"])


# --- The tires at their loads at rest -------------------------------------------------------------


def _rolled(
    subject: Subject, slip: FloatArray, changes: Mapping[str, float], **inputs: float
) -> dict[str, FloatArray]:
    """Outputs at rest on the legs, but for a velocity at angles (rad) to the aircraft's heading."""
    model, start = subject.model, subject.start
    theta = start["theta"]
    state = {
        "Z": start["Z"],
        "theta": theta,
        "u": _SPEED * np.cos(slip) * math.cos(theta),
        "v": _SPEED * np.sin(slip),
        "w": _SPEED * np.cos(slip) * math.sin(theta),
    }

    def rows(symbols: tuple[str, ...], values: Mapping[str, Any]) -> FloatArray:
        return np.array([np.broadcast_to(values.get(s, 0.0), slip.shape) for s in symbols])

    (y,) = columns(
        model.function("outputs"),
        rows(model.states, state),
        rows(model.inputs, inputs),
        rows(model.parameters, {**subject.parameters, **changes}),
    )
    return {s: np.asarray(y[:, k, 0]) for k, s in enumerate(model.outputs)}


def _at_rest(subject: Subject) -> dict[str, float]:
    """Load on each wheel."""
    found = _rolled(subject, np.zeros(1), {})
    return {w.name: float(found[f"Fz_{w.name}"][0]) for w in WHEELS}


def _tables(subject: Subject) -> dict[str, FloatArray]:
    """Side force over load at the slip angles of the tables, of wheels that roll freely."""
    straight = {"toe": 0.0, "swivels": 0.0, "steering_ratio": 0.0}
    free = {f"mu_roll_{w.name}": 0.0 for w in WHEELS}
    found = _rolled(subject, np.radians(_SLIPS), straight | free)
    return {w.name: found[f"F_y_{w.name}"] / found[f"Fz_{w.name}"] for w in WHEELS}


def _friction(subject: Subject) -> dict[str, float]:
    """Friction coefficient of the wheels that have brakes, as locked ones show it."""
    found = _rolled(subject, np.zeros(1), {"toe": 0.0}, brake_left=1.0, brake_right=1.0)
    return {
        w.name: float(found[f"F_x_{w.name}"][0] / found[f"Fz_{w.name}"][0])
        for w in WHEELS
        if w.side
    }
