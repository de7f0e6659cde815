"""What is known of an aircraft, what is missing, and what looks unusual."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache
from importlib import resources
from typing import Any

import numpy as np

from groundroll.aircraft.aircraft import FOLLOWS, Aircraft, of_aircraft
from groundroll.aircraft.consistency import as_written, contradictions, following, in_words, words
from groundroll.aircraft.parameters import NotGivenError
from groundroll.aircraft.source import Source
from groundroll.aircraft.validity import assumed, extrapolated
from groundroll.base.arrays import FloatArray
from groundroll.base.errors import GroundrollError
from groundroll.base.units import from_si, parts, to_si
from groundroll.generated import build
from groundroll.model.evaluate import elementwise, names_of
from groundroll.model.models import ModelLike, as_model
from groundroll.model.names import MODELS, QUANTITIES, parameter_symbols, symbol

from .closed_forms import speed_window

#: Results of `placement_limits` that describe an aircraft at rest: of which gear, from what.
_LIMITS = {
    "third_load": (("taildragger", "tricycle"), ("x_main", "x_third", "x_cg")),
    "nose_over": (("taildragger",), ("x_main", "x_cg", "h_cg")),
    "tip_back": (("tricycle",), ("x_main", "x_cg", "h_cg")),
}

#: Functions that describe a main tire at its load, and what each gives.
_COEFFICIENTS = {"tire_coefficient": "C_c", "tire_friction": "mu", "relative_deflection": "e_z"}

#: From how large a relative difference on a note says that a value overrides what would follow.
_OVERRIDES = 0.01


@dataclass(frozen=True)
class Known:
    """One quantity of an aircraft.

    Attributes
    ----------
    symbol, name, unit : str
        What it is; the unit is the SI unit.
    value : ndarray
        In that unit.
    follows_from : tuple of str
        Symbols of what it follows from; empty if it is given.
    source : Source
        Where it comes from if it is given; an estimate also if it follows from one.
    """

    symbol: str
    name: str
    unit: str
    value: FloatArray
    follows_from: tuple[str, ...] = ()
    source: Source = field(default_factory=Source)


@dataclass(frozen=True, repr=False)
class Check:
    """What `check` found; its repr is a report.

    Attributes
    ----------
    aircraft : Aircraft
        What was checked.
    known : tuple of Known
        Every quantity that is given or follows.
    missing : mapping of str to tuple of str
        For each tire model the parameters it lacks, in words; empty if it can be run.
    warnings : tuple of str
        What contradicts itself, or is outside of what is usual.
    notes : tuple of str
        What is worth knowing and not wrong.
    """

    aircraft: Aircraft
    known: tuple[Known, ...]
    missing: Mapping[str, tuple[str, ...]]
    warnings: tuple[str, ...]
    notes: tuple[str, ...]

    @property
    def estimates(self) -> tuple[str, ...]:
        """Names of the given quantities that are estimates; others may follow from them."""
        return tuple(k.name for k in self.known if k.source.estimate and not k.follows_from)

    def __repr__(self) -> str:
        lines = [f"Check of {self.aircraft.name!r}: {len(self.known)} quantities known"]
        for title, texts in (
            *((f"missing for the {model} model", texts) for model, texts in self.missing.items()),
            ("warnings", self.warnings),
            ("notes", self.notes),
        ):
            lines += [f"  {title}: {text}" for text in texts]
        return "\n".join(lines)


@of_aircraft
def check(plane: Aircraft) -> Check:
    """Explain what is known of an aircraft, what it lacks, and what looks unusual.

    Parameters
    ----------
    plane : Aircraft
        The aircraft; of an array any element counts.

    Returns
    -------
    Check
        Quantities with their sources, missing parameters, warnings and notes. What is usual is
        in the data file ``plausible.toml``, with sources.
    """
    known = (*_parameters(plane), *_coefficients(plane), *_limits(plane))
    return Check(
        aircraft=plane,
        known=known,
        missing={model: tuple(_missing(plane, model)) for model in MODELS},
        warnings=(
            *map(str, contradictions(plane)),
            *_unusual(plane, known),
            *extrapolated(plane),
        ),
        notes=(
            *_table_wanted(plane),
            *_bare(plane),
            *_overrides(plane),
            *assumed(plane),
            *_stability(plane),
        ),
    )


def _parameters(plane: Aircraft) -> Iterator[Known]:
    for s in plane:
        q = QUANTITIES[s]
        if s in plane.given:
            yield Known(s, q.name, q.unit, plane[s], source=plane.sources.get(s, Source()))
        else:
            source = Source(estimate=_is_estimate(plane, s))
            yield Known(s, q.name, q.unit, plane[s], plane.follows_from(s), source)


def _is_estimate(plane: Aircraft, s: str) -> bool:
    """Whether a value is an estimate, or follows from one."""
    if s in plane.given:
        return plane.sources.get(s, Source()).estimate
    return any(_is_estimate(plane, origin) for origin in plane.follows_from(s))


def _coefficients(plane: Aircraft) -> Iterator[Known]:
    """What is usual of a main tire at its load, as far as it follows."""
    for name, s in _COEFFICIENTS.items():
        symbols, _ = names_of(name)
        if all(n in plane for n in symbols):
            q, values = QUANTITIES[s], elementwise(name, {n: plane[n] for n in symbols})
            source = Source(estimate=any(_is_estimate(plane, n) for n in symbols))
            yield Known(s, q.name, q.unit, values[s], symbols, source)


def _limits(plane: Aircraft) -> Iterator[Known]:
    """Share of weight on the third wheel and the angle at the main gear, as far as they follow."""
    gear = _gear(plane)
    stations = {"x_third": "x_nose" if gear == "tricycle" else "x_tail"}
    slots = {slot: stations.get(slot, slot) for slot in build("placement_limits").name_in()}
    unknown = np.asarray(np.nan)
    results = elementwise(
        "placement_limits", {slot: plane.get(s, unknown) for slot, s in slots.items()}
    )
    for s, (gears, needed) in _LIMITS.items():
        symbols = [slots[slot] for slot in needed]
        if gear in gears and all(n in plane for n in symbols):
            q = QUANTITIES[s]
            yield Known(s, q.name, q.unit, results[s], tuple(symbols))


def _gear(plane: Aircraft) -> str:
    """``"taildragger"``, ``"tricycle"``, or nothing if that cannot be told."""
    if "a" not in plane:
        return ""
    return "taildragger" if (plane["a"] > 0).all() else "tricycle"


def _missing(plane: Aircraft, model: ModelLike) -> Iterator[str]:
    for s in as_model(model).parameters:
        try:
            plane[s]
        except NotGivenError:
            q = QUANTITIES[s]
            from_others = f", or {' and '.join(_roots(plane, s))}" if s in FOLLOWS else ""
            yield f"{q.name} ({q.meaning}){from_others}"
        except GroundrollError as problem:
            yield str(problem)


def _table_wanted(plane: Aircraft) -> Iterator[str]:
    if not any(s in plane for s in ("B1", "B3", "B5", "C_alpha")):
        yield (
            "all of the main tires follows from measured side forces, a CSV file beside the"
            ' aircraft\'s (table = "mine.csv" in [main_tires]), or as an estimate from size and'
            ' pressure (size = "6.00-6" and pressure = "42 psi")'
        )


def _roots(plane: Aircraft, s: str) -> list[str]:
    """Names of what a parameter would follow from and is not known."""
    return [QUANTITIES[n].name for n in build(f"{s}_follows").name_in() if n not in plane]


def _unusual(plane: Aircraft, known: tuple[Known, ...]) -> Iterator[str]:
    values = {k.symbol: k.value for k in known}
    for rule in _usual():
        s = symbol(rule["quantity"], "quantity", tuple(QUANTITIES))
        if s not in values or rule.get("gear", _gear(plane)) != _gear(plane):
            continue
        low, high = (_number(rule[bound], s) for bound in ("low", "high"))
        if ((values[s] < low) | (values[s] > high)).any():
            yield (
                f"{QUANTITIES[s].name} is {_shown(s, values[s])}; usual is"
                f" {rule['low']} to {rule['high']}: {rule['meaning']} ({rule['source']})"
            )


@cache
def _usual() -> list[dict[str, Any]]:
    text = (resources.files(__package__) / "plausible.toml").read_text(encoding="utf-8")
    rules: list[dict[str, Any]] = tomllib.loads(text)["usual"]
    return rules


def _number(bound: Any, s: str) -> float:
    return to_si(str(bound), QUANTITIES[s].unit, f"plausible.toml, {s}")


def _shown(s: str, value: FloatArray) -> str:
    """A value in words, a fraction in percent and an angle in degrees."""
    if s == "third_load":
        return f"{100 * float(np.ravel(value)[0]):.1f} %"
    if QUANTITIES[s].unit == "rad":
        return f"{np.degrees(np.ravel(value)[0]):.1f} deg"
    return in_words(s, value)


def _bare(plane: Aircraft) -> Iterator[str]:
    """Values without a unit: whoever forgot one will see what they became."""
    for s in plane.given:
        number, unit = parts(plane.sources.get(s, Source()).entry)
        if number and not unit and QUANTITIES[s].unit != "1" and plane[s].any():
            yield f"{QUANTITIES[s].name} has no unit and is read as {words(plane, s)}"


def _overrides(plane: Aircraft) -> Iterator[str]:
    """Given values that differ from what would follow."""
    for s in filter(FOLLOWS.__contains__, parameter_symbols()):
        other = following(plane, s) if s in plane.given else None
        if other is None:
            continue
        if s == "f" and _gear(plane) == "tricycle" and "x_nose" not in plane.follows_from(s):
            continue  # as if the nose wheel were a tail wheel
        if not np.allclose(plane[s], other, rtol=_OVERRIDES):
            given = in_words(s, plane[s])
            yield f"{QUANTITIES[s].name} is given as {given}; {in_words(s, other)} would follow"


def _stability(plane: Aircraft) -> Iterator[str]:
    """Where the linear model is unstable."""
    try:
        window = speed_window(plane)
    except NotGivenError:
        return
    except GroundrollError as problem:
        yield f"whether the linear model is stable is not known: {problem}"
        return
    unit = as_written(plane, "u")[1]
    low, high = (np.ravel(v) * from_si(1.0, "m/s", unit) for v in (window.low, window.high))
    if not np.isfinite(low).any():
        yield "the linear model is stable at every speed"
        return
    first = int(np.flatnonzero(np.isfinite(low))[0])
    to = f"to {high[first]:.1f} {unit}" if np.isfinite(high[first]) else "upwards"
    yield f"the linear model is unstable from {low[first]:.1f} {unit} {to}"
