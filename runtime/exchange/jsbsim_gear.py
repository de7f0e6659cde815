"""The three wheels on which an aircraft of JSBSim stands, among all its contacts."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import product
from xml.etree import ElementTree as ET

from groundroll.base.errors import GroundrollError

from .jsbsim_xml import place

#: Distance within which places count as equal, m.
_SAME = 0.02
#: Depth below the wheels at which another contact would carry the aircraft instead, m.
_BELOW = 0.35


@dataclass(frozen=True)
class Contact:
    """A place that may touch the ground: x aft, y to the right, z up, m; the file's unit."""

    element: ET.Element
    name: str
    x: float
    y: float
    z: float
    unit: str


@dataclass(frozen=True)
class Stance:
    """Main wheels, left and right, all those of a side as one, and the wheel on the centerline."""

    left: Sequence[Contact]
    right: Sequence[Contact]
    third: Contact

    @property
    def x(self) -> float:
        """Station of the main wheels, m."""
        return sum(c.x for c in self.left) / len(self.left)

    @property
    def z(self) -> float:
        """Height of their contacts, m."""
        return sum(c.z for c in self.left) / len(self.left)

    @property
    def track(self) -> float:
        """Left to right, m."""
        right, left = (sum(c.y for c in side) / len(side) for side in (self.right, self.left))
        return right - left


def contacts(root: ET.Element) -> list[Contact]:
    """All wheels of an aircraft: contacts that JSBSim lets roll."""
    found = []
    for element in root.iterfind("ground_reactions/contact"):
        location = element.find("location")
        if element.get("type", "").upper() == "BOGEY" and location is not None:
            name = element.get("name", "wheel")
            (x, y, z), unit = place(location, f"contact {name}")
            found.append(Contact(element, name, x, y, z, unit))
    return found


def stance(wheels: Sequence[Contact], x_cg: float) -> Stance:
    """The wheels that carry the aircraft: a pair and one on the centerline, the CG between them.

    Parameters
    ----------
    wheels : sequence of Contact
    x_cg : float
        Station of the CG, m.

    Raises
    ------
    GroundrollError
        If it does not stand on three wheels.
    """
    if len(wheels) < 3:
        raise GroundrollError(f"it has {len(wheels)} wheels; expected three or more")
    pairs = list(_pairs(wheels))
    middle = [c for c in wheels if abs(c.y) < _SAME]
    if not pairs:
        raise GroundrollError("it has no wheels in pairs, one left and one right")
    if not middle:
        raise GroundrollError("it has no wheel on the centerline")
    stands = [
        (pair, third)
        for pair, third in product(pairs, middle)
        if min(pair[0].x, third.x) < x_cg < max(pair[0].x, third.x)
    ]
    if not stands:
        raise GroundrollError("its CG is not between wheels in a pair and one on the centerline")
    # what stands deepest carries; beside others as deep the pair nearest the CG
    pair, third = min(
        stands, key=lambda s: (max(0.0, _lowest(wheels, *s) - _BELOW), abs(s[0][0].x - x_cg))
    )
    beside = [p for p in pairs if _stands_beside(p, pair, third)]
    return Stance([p[0] for p in beside], [p[1] for p in beside], third)


def _pairs(wheels: Sequence[Contact]) -> Iterator[tuple[Contact, Contact]]:
    for left, right in product(wheels, wheels):
        same = abs(left.x - right.x) < _SAME and abs(left.z - right.z) < _SAME
        if left.y < -_SAME and same and abs(left.y + right.y) < _SAME:
            yield left, right


def _level(c: Contact, pair: tuple[Contact, Contact], third: Contact) -> float:
    """How deep a contact is below the ground under three wheels, m."""
    main = pair[0]
    slope = (third.z - main.z) / (third.x - main.x)
    return main.z + slope * (c.x - main.x) - c.z


def _lowest(wheels: Sequence[Contact], pair: tuple[Contact, Contact], third: Contact) -> float:
    return max(_level(c, pair, third) for c in wheels)


def _stands_beside(
    other: tuple[Contact, Contact], pair: tuple[Contact, Contact], third: Contact
) -> bool:
    """Whether a pair of wheels belongs to the same main gear."""
    near = abs(other[0].x - pair[0].x) < 0.2 * abs(third.x - pair[0].x)
    return near and abs(_level(other[0], pair, third)) < _BELOW
