"""In which unit a quantity is shown: as it was given, or as a system of units has it.

Everything is computed in SI units with radians. What people read is in the unit that they used
themselves: for a quantity that they gave, in just that one; for another, in one that goes with it.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from groundroll.base.errors import GroundrollError, unknown
from groundroll.base.units import UnitError, from_si, parts
from groundroll.generated import Quantity

from .models import symbol_of
from .names import PARAMETERS

if TYPE_CHECKING:
    from groundroll.aircraft.aircraft import Aircraft
    from groundroll.base.arrays import FloatArray

#: For people, for people who weigh in pounds, and for programs.
SYSTEMS = ("si", "imperial", "plain")
#: What is said instead of one of them where the aircraft decides.
AS_GIVEN = "as-given"

#: Whoever weighs in these reads forces in pounds too.
_POUNDS = frozenset(("lb", "lbs", "pound", "pounds", "slug", "slugs"))
#: Of each kind of SI unit, the one that pilots read; the rest is put together from the second.
_IMPERIAL = {"kg": "lb", "m/s": "kt", "N/m^2": "psi"}
_WORDS = {"m": "ft", "N": "lbf", "kg": "slug", "rad": "deg"}
#: A length along an aircraft.
_INCH = "in"


@dataclass(frozen=True)
class Units:
    """The unit of each quantity that is shown.

    Attributes
    ----------
    own : mapping of str to str
        By symbol, where it was given.
    usual : mapping of str to str
        By SI unit, for parameters that nobody gave.
    system : str
        For the rest: ``"si"`` (with degrees), ``"imperial"``, or ``"plain"`` (SI units with
        radians, which programs read).
    """

    own: Mapping[str, str] = field(default_factory=dict)
    usual: Mapping[str, str] = field(default_factory=dict)
    system: str = "si"

    def of(self, q: Quantity) -> str:
        """The unit of a quantity; ``"1"`` of a pure number."""
        own = self.own.get(q.symbol, "")
        if own and _fits(own, q.unit):
            return own
        if q.name.endswith("frequency"):
            return q.unit  # as everybody has it
        is_far = q.unit == "m" and q.kind in ("state", "input")
        if q.unit in self.usual and not is_far:
            return self.usual[q.unit]
        if self.system == "imperial" and q.unit == "m" and not is_far:
            return _INCH
        return in_system(q.unit, self.system)

    def factor(self, q: Quantity) -> float:
        """From its SI unit to that."""
        unit = self.of(q)
        return 1.0 if unit == q.unit else from_si(1.0, q.unit, unit)

    def values(self, q: Quantity, values: Any) -> FloatArray:
        """Numbers in its SI unit, in that."""
        factor = self.factor(q)
        return np.asarray(values) if factor == 1.0 else np.asarray(values) * factor

    def label(self, q: Quantity, before: str = "") -> str:
        """Name, symbol and unit of a quantity for an axis."""
        return f"{before}{q.name.replace('_', ' ')} ${q.latex}${in_brackets(self.of(q))}"

    def head(self, name: str, q: Quantity) -> str:
        """Head of a column."""
        unit = self.of(q)
        return name if unit == "1" else f"{name} [{unit}]"

    def given(self, **own: str) -> Units:
        """The same with further units by symbol."""
        return replace(self, own={**self.own, **own})

    @property
    def plain(self) -> Units:
        """The same for programs: what was not given is in SI units with radians."""
        return Units(self.own if self.system != "imperial" else {}, {}, "plain")


#: Units, a system of them, or one for each of some quantities by symbol or full name.
UnitsLike: TypeAlias = Units | str | Mapping[str, str] | None


def as_units(
    units: UnitsLike, quantities: Mapping[str, Quantity], plane: Aircraft | None = None
) -> Units:
    """What was asked for as units.

    Parameters
    ----------
    units : Units, str, mapping or None
        ``"si"`` (as without), ``"imperial"``, ``"as-given"`` (those of the file of the aircraft),
        or units by symbol or full name, e.g. ``{"speed": "kt"}``.
    quantities : mapping of str to Quantity
        Which there are, by symbol.
    plane : Aircraft, optional
        Whose file it is.

    Raises
    ------
    GroundrollError
        For an unknown system or name, or a unit that does not fit.
    """
    if isinstance(units, Units):
        return units
    if units is None:
        return Units()
    if isinstance(units, str):
        if units == AS_GIVEN and plane is not None:
            return as_given(plane)
        if units not in SYSTEMS:
            raise unknown("system of units", units, [*SYSTEMS, AS_GIVEN])
        return Units(system=units)
    if not isinstance(units, Mapping):
        raise GroundrollError(f"units must be a mapping of names to units, not {units!r}")
    own = {}
    for name, unit in units.items():
        key = symbol_of(quantities, str(name), "quantity", quantities, "units")
        from_si(1.0, quantities[key].unit, unit)
        own[quantities[key].symbol] = unit
    return Units(own)


def as_given(plane: Aircraft, **given: str) -> Units:
    """The units that an aircraft and the other arguments of a call were given in.

    Parameters
    ----------
    plane : Aircraft
        Those of its file.
    **given : str
        Further ones by symbol, which come first.
    """
    written = {s: parts(plane.sources[s].entry)[1] for s in plane.given if s in plane.sources}
    own = {s: unit for s, unit in {**written, **given}.items() if unit}
    found: dict[str, Counter[str]] = {}
    for s, unit in own.items():
        if s in PARAMETERS and _fits(unit, PARAMETERS[s].unit):
            found.setdefault(PARAMETERS[s].unit, Counter())[unit] += 1
    usual = {si: counts.most_common(1)[0][0] for si, counts in found.items()}
    is_imperial = _POUNDS & {usual.get("kg", ""), own.get("m", "")}
    return Units(own, usual, "imperial" if is_imperial else "si")


def in_system(unit: str, system: str) -> str:
    """The unit of a system for an SI unit."""
    if system == "plain":
        return unit
    if system == "si":
        return re.sub(r"\brad\b", "deg", unit)
    return _IMPERIAL.get(unit) or re.sub(r"[A-Za-z]+", lambda w: _WORDS.get(w[0], w[0]), unit)


def in_brackets(unit: str) -> str:
    """A unit behind a word in a picture; nothing for a pure number."""
    return "" if unit == "1" else f" ({unit.replace('^2', '²').replace('^3', '³')})"


def _fits(unit: str, si: str) -> bool:
    try:
        from_si(1.0, si, unit)
    except UnitError:
        return False
    return True
