"""An aircraft of JSBSim as quantities of ours: mass, stations, gear, surfaces, derivatives."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree as ET

import numpy as np

from groundroll.aircraft.surfaces import held
from groundroll.base.arrays import FloatArray
from groundroll.base.errors import GroundrollError
from groundroll.base.units import to_si
from groundroll.model.names import PARAMETERS

from .jsbsim_derivatives import Derivative, NotSimpleError, derivatives
from .jsbsim_gear import Contact, Stance, contacts, stance
from .jsbsim_xml import document, measured, number, place, shown_in, unit_of, words
from .taken import Found, Taken

#: Aeromatic, which wrote many of these files, notes the speed in a comment.
_STALL = re.compile(r"stall\s+speed:\s*([\d.]+)\s*kts", re.IGNORECASE)
#: Moments: the force that adds to them away from the CG, its lever, sign, and reference length.
_MOVED = (
    ("Cn_beta", "CY_beta", "ahead", 1, "b_wing"),
    ("Cn_r", "CY_r", "ahead", 1, "b_wing"),
    ("Cn_rudder", "CY_rudder", "ahead", 1, "b_wing"),
    ("Cl_beta", "CY_beta", "below", -1, "b_wing"),
    ("Cl_r", "CY_r", "below", -1, "b_wing"),
    ("Cm_0", "CL_0", "ahead", 1, "c_wing"),
    ("Cm_0", "CD_0", "below", -1, "c_wing"),
    ("Cm_alpha", "CL_alpha", "ahead", 1, "c_wing"),
)


@dataclass(frozen=True)
class Mass:
    """Mass in kg, CG aft, right, up in m, inertias about it in kg m^2, and the file's units."""

    mass: float
    cg: FloatArray
    inertia: dict[str, float]
    units: dict[str, str]


def read_jsbsim(path: Path) -> Found:
    """What an aircraft file of JSBSim says of an aircraft on three wheels.

    Raises
    ------
    GroundrollError
        If the file cannot be read, or its aircraft has no mass or does not stand on three wheels.
    """
    root, text = document(path)
    found = Found(root.get("name", path.stem).strip(), f"JSBSim, {path.name}")
    try:
        mass = _mass(root, found)
        gear = stance(contacts(root), float(mass.cg[0]))
    except GroundrollError as problem:
        raise GroundrollError(f"{path}: {problem}") from None
    _take_mass(found, mass)
    _take_surfaces(root, found, mass)
    _take_gear(found, gear, mass)
    stall = _STALL.search(text)
    if stall:
        found.take(Taken("u", float(stall[1]), "kt", "the stalling speed of its comment", True))
    else:
        found.left.append("speed: the file has none")
    _take_derivatives(root, found, mass)
    found.left.append("tail_lift_slope: JSBSim knows no fin of its own")
    found.take(
        Taken("g", 9.80665, "m/s^2", "standard gravity"),
        Taken("rho", 1.225, "kg/m^3", "ISO 2533, sea level"),
    )
    return found


# --- Mass ----------------------------------------------------------------------------------------


def _mass(root: ET.Element, found: Found) -> Mass:
    """Empty aircraft with its point masses; fuel is left."""
    balance = root.find("mass_balance")
    empty = measured(balance, "emptywt", "kg", "mass_balance") if balance is not None else None
    if balance is None or empty is None:
        raise GroundrollError("found no <emptywt> in <mass_balance>")
    where = next((e for e in balance.iterfind("location") if e.get("name") == "CG"), None)
    if where is None:
        raise GroundrollError("found no location of the CG in <mass_balance>")
    cg, length = place(where, "CG")
    items = [(to_si(f"{empty[0]!r} {empty[1]}", "kg", "emptywt"), np.array(cg))]
    for point in balance.iterfind("pointmass"):
        name, spot = point.get("name", "pointmass"), point.find("location")
        weight = measured(point, "weight", "kg", name)
        if weight is None or spot is None:
            found.left.append(f"point mass {name}: no weight or location")
            continue
        kilograms = to_si(f"{weight[0]!r} {weight[1]}", "kg", name)
        items.append((kilograms, np.array(place(spot, name)[0])))
    for tank in root.iterfind("propulsion/tank"):
        fuel = measured(tank, "contents", "kg", "tank")
        if fuel and fuel[0]:
            found.left.append(f"{fuel[0]:g} {fuel[1]} in a tank: the mass is without fuel")
    masses = np.array([m for m, _ in items])
    total = float(masses.sum())
    if not total > 0:
        raise GroundrollError("found no mass above zero")
    middle = masses @ np.array([at for _, at in items]) / total
    inertia, units = {}, {"m": empty[1], "length": length}
    for s, tag in (("Ixx", "ixx"), ("Iyy", "iyy"), ("Izz", "izz"), ("Ixz", "ixz")):
        own = measured(balance, tag, "kg m^2", "mass_balance")
        if own is None:
            continue
        value, unit = own
        if s == "Ixz" and balance.get("negated_crossproduct_inertia") != "false":
            value = -value
        inertia[s] = to_si(f"{value!r} {unit}", "kg m^2", tag)
        inertia[s] += sum(m * _moved(s, at - middle) for m, at in items)
        units[s] = unit
    return Mass(total, middle, inertia, units)


def _moved(s: str, d: FloatArray) -> float:
    """What a kilogram away from the CG adds to an inertia."""
    x, y, z = map(float, d)
    return {"Ixx": y * y + z * z, "Iyy": x * x + z * z, "Izz": x * x + y * y, "Ixz": x * z}[s]


def _take_mass(found: Found, mass: Mass) -> None:
    source = "empty aircraft and point masses"
    unit, length = mass.units["m"], mass.units["length"]
    found.take(
        Taken("m", shown_in(mass.mass, "kg", unit), unit, source),
        Taken("x_cg", shown_in(float(mass.cg[0]), "m", length), length, source),
        *(
            Taken(s, shown_in(value, "kg m^2", mass.units[s]), mass.units[s], source)
            for s, value in mass.inertia.items()
        ),
    )


# --- Surfaces and gear ---------------------------------------------------------------------------


def _take_surfaces(root: ET.Element, found: Found, mass: Mass) -> None:
    metrics = root.find("metrics")
    if metrics is None:
        found.left.append("wing and tail: no <metrics>")
        return
    for tag, s in words()["metrics"].items():
        value = measured(metrics, tag, PARAMETERS[s].unit, "metrics")
        if value and value[0]:
            found.take(Taken(s, *value, f"<{tag}>"))
        else:
            found.left.append(f"{PARAMETERS[s].name}: no <{tag}>")
    fin = measured(metrics, "vtailarm", "m", "metrics")
    arm = measured(metrics, "htailarm", "m", "metrics")
    if arm and arm[0]:
        found.take(Taken("x_h", -arm[0], arm[1], "<htailarm>"))
    for tail, source, estimate in (
        (fin, "<vtailarm> from the CG", False),
        (arm, "the fin beside the tailplane: <htailarm> from the CG", True),
    ):
        if tail and tail[0]:  # a tail wheel, of which there is but one station, comes later
            station = float(mass.cg[0]) + to_si(f"{tail[0]!r} {tail[1]}", "m", "tail arm")
            shown = shown_in(station, "m", tail[1])
            found.take(Taken("x_tail", shown, tail[1], source, estimate))
            return
    found.left.append("arm of the fin: no <vtailarm>")


def _take_gear(found: Found, gear: Stance, mass: Mass) -> None:
    third, main = gear.third, gear.left[0]
    depth, third_depth = float(mass.cg[2]) - gear.z, float(mass.cg[2]) - third.z
    tricycle, unit = third.x < gear.x, main.unit
    names = ", ".join(c.name for c in (*gear.left, *gear.right))
    if len(gear.left) > 1:
        found.left.append(f"wheels of a side apart from each other: {names} are one on each side")
    angle = math.degrees(math.atan((third_depth - depth) / (gear.x - third.x)))
    found.take(
        Taken("x_main", shown_in(gear.x, "m", unit), unit, names),
        Taken("track", shown_in(gear.track, "m", unit), unit, names),
        Taken("z_main", shown_in(depth, "m", unit), unit, names),
        Taken("h_cg", shown_in(depth, "m", unit), unit, f"{names}, legs unloaded", True),
        Taken("theta_ground", float(f"{angle:.10g}"), "deg", "heights of its contacts"),
        Taken("z_third", shown_in(third_depth, "m", third.unit), third.unit, third.name),
        Taken(
            "x_nose" if tricycle else "x_tail",
            shown_in(third.x, "m", third.unit),
            third.unit,
            third.name,
        ),
    )
    if tricycle:
        found.take(Taken("Ct", 0.0, "1", "a tricycle has no tail wheel"))
        fin = found.taken.get("x_tail")
        if fin and fin.si <= max(gear.x, float(mass.cg[0])):
            found.left.append(f"tail_station: {fin.text} is ahead of the main wheels or the CG")
            del found.taken["x_tail"]
    _take_legs(found, gear)
    _take_steering(found, third)


def _take_legs(found: Found, gear: Stance) -> None:
    wheels = len(gear.left)
    for c, ending, count in ((gear.left[0], "main", wheels), (gear.third, "third", 1)):
        for tag, letter, si in (("spring_coeff", "k", "N/m"), ("damping_coeff", "c", "N s/m")):
            element = c.element.find(tag)
            if element is None or element.get("type", "").upper() == "SQUARE":
                found.left.append(f"{tag} of {c.name}: none that is linear")
                continue
            value = number(element, f"{c.name}, {tag}") * count
            unit = unit_of(element, si, f"{c.name}, {tag}")
            found.take(Taken(f"{letter}_{ending}", value, unit, f"{c.name}, <{tag}>"))
        _take_tire(found, c, ending)


def _take_tire(found: Found, c: Contact, ending: str) -> None:
    """JSBSim's own curve; a table of forces is left."""
    curve = words()["tire"]
    third = "_third" if ending == "third" else ""
    if c.element.find("table") is not None:
        found.left.append(f"table of tire forces of {c.name}: JSBSim's own curve is taken")
    friction, rolling = c.element.find("static_friction"), c.element.find("rolling_friction")
    if friction is not None:
        mu = number(friction, f"{c.name}, static_friction")
        slope = curve["stiffness"] * curve["shape"] * mu
        source = f"{c.name}, <static_friction> with the curve of JSBSim"
        found.take(
            Taken(f"B5{third}", mu, "1", f"{c.name}, <static_friction>"),
            Taken(f"C5{third}", 0.0, "1/N", "the same at every load"),
            Taken(f"B3{third}", float(f"{slope:.12g}"), "1/deg", source),
            Taken(f"C3{third}", 0.0, "1/(deg N)", "the same at every load"),
            Taken(f"B1{third}", float(f"{1 / curve['shape']:.15g}"), "1", source),
            Taken(f"C1{third}", curve["shape"], "1", source),
            Taken(f"D1{third}", 1.0, "1", source),
            Taken(f"E1{third}", curve["curvature"], "1", source),
        )
    if rolling is not None:
        mu = number(rolling, f"{c.name}, rolling_friction")
        sides = ("third",) if third else ("left", "right")
        source = f"{c.name}, <rolling_friction>"
        found.take(*(Taken(f"mu_roll_{s}", mu, "1", source) for s in sides))


def _take_steering(found: Found, third: Contact) -> None:
    steer, free = third.element.find("max_steer"), third.element.find("castered")
    largest = number(steer, f"{third.name}, max_steer") if steer is not None else 0.0
    casters = (free is not None and number(free, "castered") > 0) or abs(largest) >= 360
    found.take(Taken("swivels", float(casters), "1", f"{third.name}, <max_steer>"))
    if casters:
        found.take(Taken("k_swivel", 0.0, "N m/rad", f"{third.name} casters"))
    else:
        unit = unit_of(steer, "rad", third.name) if steer is not None else "deg"
        found.take(Taken("steering_ratio", largest, unit, f"{third.name}, <max_steer>"))


# --- Derivatives ---------------------------------------------------------------------------------


def _take_derivatives(root: ET.Element, found: Found, mass: Mass) -> None:
    parts: dict[str, list[Derivative]] = {}
    where = {}
    if {"u", "c_wing"} <= set(found.taken):
        viscosity = words()["air"]["kinematic_viscosity"]
        where["aero/Re"] = found.taken["u"].si * found.taken["c_wing"].si / viscosity
    for axis in root.iterfind("aerodynamics/axis"):
        for function in axis.iterfind("function"):
            try:
                for each in list(derivatives(axis.get("name", "").upper(), function, where)):
                    parts.setdefault(each.symbol, []).append(each)
            except NotSimpleError as problem:
                found.left.append(str(problem))
    values = {s: sum(p.value for p in several) for s, several in parts.items()}
    levers, moved = _levers(root, mass), dict(values)
    for s, force, lever, sign, length in _MOVED:
        # a moment of which nothing was taken is not made of this part alone
        if s in values and force in values and length in found.taken:
            moved[s] += sign * levers[lever] / found.taken[length].si * values[force]
    for s, summands in parts.items():
        source = "; ".join(p.source for p in summands)
        if moved[s] != values[s]:
            source += "; moved from <AERORP> to the CG"
        value, unit = float(f"{moved[s]:.12g}"), PARAMETERS[s].unit
        found.take(Taken(s, value, unit, source, not all(p.exact for p in summands)))
    found.take(
        *(
            Taken(s, 0.0, "1", f"the derivatives hold the {name}")
            for s, name in held(values).items()
        )
    )


def _levers(root: ET.Element, mass: Mass) -> dict[str, float]:
    """How far where the forces act is ahead of the CG and below it, m."""
    spot = next((e for e in root.iterfind("metrics/location") if e.get("name") == "AERORP"), None)
    if spot is None:
        return {"ahead": 0.0, "below": 0.0}
    (x, _, z), _ = place(spot, "AERORP")
    return {"ahead": float(mass.cg[0]) - x, "below": float(mass.cg[2]) - z}
