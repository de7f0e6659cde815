"""What the page knows of a model and an aircraft, as data: names, numbers, units, sliders."""

from __future__ import annotations

import math
import tomllib
from collections.abc import Iterable, Mapping
from functools import cache
from pathlib import Path
from typing import Any

from groundroll.aircraft.consistency import DETERMINED
from groundroll.aircraft.template import section_of
from groundroll.base.arrays import physical_of
from groundroll.base.units import UnitError, from_si, parts, to_si
from groundroll.base.wording import encodable, visible
from groundroll.fates.fates import Criterion
from groundroll.generated import Quantity
from groundroll.model.models import Model
from groundroll.model.names import PARAMETERS
from groundroll.motion.rest import CREEP, SUNK, lifts
from groundroll.tires.size import friction_on, surfaces
from groundroll.view.silhouette import AIRFRAME

from .page_functions import following
from .subject import Subject

_PAGE = Path(__file__).parent / "page"
#: Duration of the roll, s.
_DURATION = 10.0
#: Lateral velocity at the start if nobody says what disturbs the aircraft, m/s.
_KICK = 0.5
#: States that a roll may be kicked in, by their role.
_KICKED = ("lateral_velocity", "yaw_rate", "heading", "offset")
#: Events that are no harm.
_HARMLESS = ("stopped", "wheel_lifted")
#: Friction by wheel, and that of a tire on a dry runway.
_SURFACES, _DRY = ("surface_left", "surface_right", "surface_third"), ("B5", "C5")


@cache
def _settings() -> Mapping[str, Any]:
    return tomllib.loads((_PAGE / "explorer.toml").read_text(encoding="utf-8"))


def facts(subject: Subject) -> dict[str, Any]:
    """Everything that the page holds beside functions, ready for JSON."""
    model, plane = subject.model, subject.aircraft
    known = _known(subject)
    kicks = {f"{model.roles[role]}0": role for role in _KICKED if role in model.roles}
    kicks = {s: role for s, role in kicks.items() if s[:-1] in model.states}
    quantities = {s: q for s in known if (q := _quantity(model, s))}
    quantities |= {s: model.quantities[s] for s in (*model.states, *model.inputs, *model.outputs)}
    given = {s: float(x) for s, x in plane.given.items() if s in known and x.ndim == 0}
    own = {s: float(x) for s, x in _own(subject).items()}
    speed = model.roles.get("speed")
    if speed in model.states:
        given[speed] = subject.start[speed]
    start = {s: subject.start[s[:-1]] for s in kicks}
    if not any((*start.values(), *subject.inputs.values())):  # something should be seen
        start |= {s: _KICK for s, role in kicks.items() if role == "lateral_velocity"}
    friction = [s for s in _SURFACES if s in model.parameters] or [s for s in _DRY if s in given]
    told = {s: _told(q) for s, q in quantities.items()}
    told |= {s: _told(model.quantities[s[:-1]], " at the start") for s in kicks}
    sliders = _sliders(subject, {**given, **own}, start)
    return {
        "name": _text(plane.name),
        "title": _text(subject.title),
        "description": _text(plane.description),
        "model": _model(model),
        "quantities": told,
        "units": {s: _units(subject, s, q["unit"]) for s, q in told.items()},
        "design": {
            "given": {**given, **own},
            "inputs": dict(subject.inputs),
            "start": start,
            "duration": _DURATION,
        },
        "sliders": sliders,
        "rest": _rest(subject),
        "own": list(own),
        "sections": {s: list(section_of(s)) for s in known if s in PARAMETERS},
        "entries": _entries(subject, given),
        "limits": {"heading": Criterion().heading, "half_width": Criterion().half_width},
        "surfaces": {name: friction_on(name)[0] for name in surfaces()},
        "friction": friction,
        "airframe": AIRFRAME,
    }


def _known(subject: Subject) -> list[str]:
    """Every parameter that has a say: those of the model, and those from which they follow."""
    return list(following(subject.model))


def _quantity(model: Model, s: str) -> Quantity | None:
    return model.quantities.get(s) or PARAMETERS.get(s)


def _own(subject: Subject) -> dict[str, Any]:
    """The aircraft's own parameters by symbol, SI units."""
    model = subject.model
    by_name = {n: s for s in model.parameters for n in (s, model.quantities[s].name)}
    return {
        by_name[name]: physical_of(model.quantities[by_name[name]], value)
        for name, value in subject.aircraft.own.items()
        if name in by_name
    }


def _rest(subject: Subject) -> dict[str, Any] | None:
    """How a body on legs finds its rest: see `groundroll.motion.rest`."""
    model = subject.model
    depth = model.roles.get("depth")
    if depth not in model.states:
        return None
    return {
        "depth": depth,
        "pitch": "theta",
        "heave": "w",
        "pitching": "q",
        "density": model.parameters.index("rho") if "rho" in model.parameters else -1,
        "creep": CREEP,
        "wheels": [model.outputs.index(e.output) for e in model.events if lifts(e)],
        "sunk": SUNK,
    }


def _text(text: str) -> str:
    return visible(encodable(text)).strip()


def _told(q: Quantity, more: str = "") -> dict[str, str]:
    meaning = _text(q.meaning)
    return {"name": _text(q.name) + more, "meaning": meaning, "unit": q.unit, "sign": q.sign}


def _model(model: Model) -> dict[str, Any]:
    groups = ("states", "dynamic", "inputs", "parameters", "outputs")
    return {
        "name": model.name,
        "summary": _text(model.summary),
        "digest": model.digest,
        **{group: list(getattr(model, group)) for group in groups},
        "roles": dict(model.roles),
        "places": [{"name": _text(p.name), "kind": p.kind} for p in model.places],
        "events": [
            {
                "name": e.name,
                "output": model.outputs.index(e.output),
                "rising": e.rising,
                "text": _text(e.meaning),
                "bad": not e.name.startswith(_HARMLESS),
            }
            for e in model.events
        ],
    }


def _entries(subject: Subject, given: Mapping[str, float]) -> dict[str, Any]:
    """What the aircraft file says of each number, where it says it itself."""
    found = {}
    for s, source in subject.aircraft.sources.items():
        if s in given:
            value = _text(source.entry) if _reads_as(source.entry, s, given[s]) else ""
            found[s] = {"value": value, "source": _text(source.text), "estimate": source.estimate}
    return found


def _reads_as(entry: str, s: str, value: float) -> bool:
    """Whether an entry of a file gives just this number."""
    try:
        return bool(entry) and to_si(entry, PARAMETERS[s].unit, s) == value
    except UnitError:
        return False


# --- Units ---------------------------------------------------------------------------------------


def _units(subject: Subject, s: str, unit: str) -> list[list[Any]]:
    """Name and size of the unit in which a quantity is shown: the file's, metric, US."""
    metric, american = _settings()["units"].get(unit, (unit, unit))
    source = subject.aircraft.sources.get(s)
    own = parts(source.entry)[1] if source else ""
    return [_unit(name, unit) for name in (own or metric, metric, american)]


def _unit(name: str, unit: str) -> list[Any]:
    try:
        return [name if name != "1" else "", from_si(1.0, unit, name) if name != unit else 1.0]
    except UnitError:
        return [unit, 1.0]


# --- Sliders -------------------------------------------------------------------------------------


def _sliders(
    subject: Subject, given: Mapping[str, float], start: Mapping[str, float]
) -> list[dict[str, Any]]:
    """Sliders in their order: what is shown at once, then what is under "more"."""
    model = subject.model
    offered = [s for s in _known(subject) if s in given or s not in DETERMINED]
    groups = [(g["title"], g["symbols"]) for g in _settings()["group"]]
    own = [s for s in given if s not in PARAMETERS]
    speed = [model.roles["speed"]] if "speed" in model.roles else []
    groups += [("Parameters", own), ("Speed and controls", [*speed, *model.inputs])]
    groups += [("Kick", [*start])]
    shown: dict[str, str] = {}
    for title, symbols in groups:
        for s in symbols:
            if s in offered or s in model.inputs or s in start:
                shown.setdefault(s, title)
    shown |= {s: "" for s in offered if s not in shown}
    values = {**_values(subject), **given, **subject.inputs, **start}
    return [
        {
            "symbol": s,
            "group": title,
            **_ends(subject, s, values[s]),
            "whole": s in _settings()["whole"]["symbols"],
        }
        for s, title in shown.items()
        if math.isfinite(values.get(s, math.nan))
    ]


def _values(subject: Subject) -> dict[str, float]:
    """What follows, as far as it does."""
    plane = subject.aircraft
    found = {s: float(plane[s]) for s in _known(subject) if s in PARAMETERS and s in plane}
    return {**found, **subject.parameters}


def _ends(subject: Subject, s: str, value: float) -> dict[str, Any]:
    """Where a slider begins and ends, in SI; whether it may not go beyond."""
    plane = subject.aircraft
    if s == "x_cg" and "x_forward" in plane and "x_aft" in plane:
        return {"low": float(plane["x_forward"]), "high": float(plane["x_aft"]), "hard": True}
    settings, plain = _settings(), s.removesuffix("0") if s not in PARAMETERS else s
    q = _quantity(subject.model, plain)
    assert q is not None  # of every slider
    ends: Iterable[str] | None = settings["ends"].get(s)
    if ends is None and value == 0:
        ends = settings["zero"].get(q.unit, ("-1", "1"))
    if ends is not None:
        low, high = (to_si(end, q.unit, s) for end in ends)
    elif q.unit in settings["around"] and not q.sign:
        reach = to_si(settings["around"][q.unit], q.unit, s)
        low, high = value - reach, value + reach
    else:
        low, high = sorted((0.2 * value, 2.5 * value)) if q.sign else (-abs(value), 3 * abs(value))
    low, high = min(low, value), max(high, value)
    return {"low": max(low, 0.0) if q.sign == ">=0" else low, "high": high, "hard": False}
