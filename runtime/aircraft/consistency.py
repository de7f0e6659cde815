"""Whether the data of an aircraft agree with each other."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundroll.base.arrays import FloatArray
from groundroll.base.errors import GroundrollError
from groundroll.base.units import parts
from groundroll.generated import PACKS
from groundroll.model.names import QUANTITIES, parameter_symbols

from .parameters import NotGivenError
from .surfaces import doubts

if TYPE_CHECKING:
    from .aircraft import Aircraft

#: How far a given length may be from the one that follows from the other data, m: what a tape
#: measure and the rounding of a weight-and-balance sheet leave.
_LENGTHS = {"a": 0.01, "b": 0.01, "L": 0.01}

#: What follows of any aircraft, whatever the model.
_ANYWAY = frozenset(
    name.partition("_follows")[0] for name in PACKS["aircraft"].functions if "_follows" in name
)

#: The same for wheel loads, relative: what a set of scales leaves.
_LOADS = {"Fz": 0.02, "F_tail_load": 0.02}

#: What cannot be given beside what it follows from.
DETERMINED = frozenset((*_LENGTHS, *_LOADS))


@dataclass(frozen=True)
class Contradiction:
    """Something that cannot be, given the rest.

    Attributes
    ----------
    symbol : str
        The parameter to look at first.
    found, expected : str
        In words.
    """

    symbol: str
    found: str
    expected: str

    def __str__(self) -> str:
        name = QUANTITIES[self.symbol].name
        return f"{name} ({self.symbol}): found {self.found}; expected {self.expected}"


def contradictions(plane: Aircraft) -> tuple[Contradiction, ...]:
    """What does not agree in the data of an aircraft.

    Lengths given twice (a + b and L, arms and stations), a CG outside its limits, weight
    fractions and wheel loads that do not add up, a fin or tailplane that counts twice, and
    anything that follows but cannot be. A
    stiffness or weight fraction that is given although it would follow overrides it: that is a
    choice, and no contradiction.

    Parameters
    ----------
    plane : Aircraft
        The aircraft; of an array any element counts.
    """
    found = (
        *_lengths(plane),
        *_cg_limits(plane),
        *_fraction(plane),
        *_tail(plane),
        *_nose_wheel(plane),
        *_loads(plane),
        *(Contradiction(*doubt) for doubt in doubts(plane.given)),
    )
    return found or tuple(_impossible(plane))


def following(plane: Aircraft, key: str) -> FloatArray | None:
    """What a parameter would be if it were not given; None if it would not follow."""
    try:
        return plane.replace(**{key: None})[key]
    except GroundrollError:
        return None


def words(plane: Aircraft, key: str) -> str:
    """A given value as it was written, or any value in its SI unit."""
    number, unit = as_written(plane, key)
    return f"{number} {unit}".rstrip() if number else in_words(key, plane[key])


def as_written(plane: Aircraft, key: str) -> tuple[str, str]:
    """Number and unit of a given value as they were written, a bare number's the SI unit."""
    number, unit = parts(plane.sources[key].entry) if key in plane.sources else ("", "")
    si = QUANTITIES[key].unit
    return number, unit or ("" if si == "1" else si)


def in_words(key: str, value: FloatArray) -> str:
    """A value, or the first of an array, in its SI unit."""
    unit = QUANTITIES[key].unit
    return f"{np.ravel(value)[0]:.5g}{'' if unit == '1' else f' {unit}'}"


def _lengths(plane: Aircraft) -> Iterator[Contradiction]:
    for key, tolerance in _LENGTHS.items():
        yield from _disagreement(plane, key, tolerance)


def _loads(plane: Aircraft) -> Iterator[Contradiction]:
    for key, tolerance in _LOADS.items():
        if key in plane.given:
            yield from _disagreement(plane, key, tolerance * float(plane[key].max()))


def _disagreement(plane: Aircraft, key: str, tolerance: float) -> Iterator[Contradiction]:
    other = following(plane, key) if key in plane.given else None
    if other is not None and (np.abs(plane[key] - other) > tolerance).any():
        sources = " and ".join(QUANTITIES[s].name for s in plane.follows_from(key))
        yield Contradiction(
            key, words(plane, key), f"{in_words(key, other)}, which follows from {sources}"
        )


def _cg_limits(plane: Aircraft) -> Iterator[Contradiction]:
    if "x_forward" in plane and "x_aft" in plane:
        forward, aft = plane["x_forward"], plane["x_aft"]
        if (forward > aft).any():
            yield Contradiction(
                "x_forward",
                words(plane, "x_forward"),
                f"at most cg_aft_limit, {words(plane, 'x_aft')}: stations count aft",
            )
            return
    if "x_cg" not in plane:
        return
    bounds = (("x_forward", np.less, "at least"), ("x_aft", np.greater, "at most"))
    for limit, beyond, at in bounds:
        if limit in plane and beyond(plane["x_cg"], plane[limit]).any():
            yield Contradiction(
                "x_cg",
                words(plane, "x_cg"),
                f"{at} {QUANTITIES[limit].name}, {words(plane, limit)}",
            )


def _fraction(plane: Aircraft) -> Iterator[Contradiction]:
    if "f" in plane.given:
        if ((plane["f"] < 0) | (plane["f"] > 1)).any():
            yield Contradiction("f", words(plane, "f"), "a fraction from 0 to 1")
    elif _is_tricycle(plane) and "f" in plane and "x_nose" not in plane.follows_from("f"):
        yield Contradiction(
            "f",
            "nothing",
            "a fraction from 0 to 1, or nose_wheel_station from which it follows: the main gear is"
            " behind the CG, so that a nose wheel carries the rest",
        )


def _tail(plane: Aircraft) -> Iterator[Contradiction]:
    if "x_tail" in plane and "x_cg" in plane and (plane["x_tail"] <= plane["x_cg"]).any():
        behind = f"a station behind the CG, {words(plane, 'x_cg')}: stations count aft"
        yield Contradiction("x_tail", words(plane, "x_tail"), behind)


def _nose_wheel(plane: Aircraft) -> Iterator[Contradiction]:
    if not all(s in plane for s in ("a", "x_nose", "x_cg")):
        return
    if ((plane["a"] < 0) & (plane["x_nose"] >= plane["x_cg"])).any():
        yield Contradiction(
            "x_nose",
            words(plane, "x_nose"),
            f"a station ahead of the CG, {words(plane, 'x_cg')}: the main gear is behind it",
        )


def _is_tricycle(plane: Aircraft) -> bool:
    return "a" in plane and bool((plane["a"] < 0).any())


def _impossible(plane: Aircraft) -> Iterator[Contradiction]:
    """What follows and cannot be, such as a tail ahead of the CG."""
    # what only some model needs is for whoever asks for that model
    for key in filter(_ANYWAY.__contains__, parameter_symbols()):
        try:
            plane[key]
        except NotGivenError:
            continue
        except GroundrollError as problem:
            yield Contradiction(key, f"that {problem}", "data from which a possible value follows")
            return
