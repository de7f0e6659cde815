"""What limits the place of the wheels, beside what makes it good."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any, NamedTuple

import numpy as np

from groundroll.base.errors import GroundrollError, one_of

from .envelope import numbers

LAYOUTS = ("taildragger", "tricycle")


class Kind(NamedTuple):
    """What a limit limits.

    Attributes
    ----------
    symbol : str
        The generated quantity.
    unit : str
        Its SI unit.
    shown : str
        The unit people use.
    step : float
        What is much and what is little of it, SI: the weight of a violation.
    layouts : tuple of str
        Where it means something.
    sides : tuple of str
        Which bounds it may have.
    """

    symbol: str
    unit: str
    shown: str
    step: float
    layouts: tuple[str, ...] = LAYOUTS
    sides: tuple[str, ...] = ("at least", "at most")


KINDS = {
    "decay_rate": Kind("decay_rate", "1/s", "1/s", 0.1, sides=("at least",)),
    "damping_ratio": Kind("damping_ratio", "1", "1", 0.05, sides=("at least",)),
    "displacement": Kind("displacement", "m", "m", 0.1, sides=("at most",)),
    "tail_wheel_load": Kind("third_load", "1", "%", 0.01, ("taildragger",)),
    "nose_over": Kind("nose_over", "rad", "deg", np.radians(1.0), ("taildragger",)),
    "nose_wheel_load": Kind("third_load", "1", "%", 0.01, ("tricycle",)),
    "tip_back": Kind("tip_back", "rad", "deg", np.radians(1.0), ("tricycle",)),
    "wheelbase": Kind("span", "m", "mm", 0.05),
}
#: Which load limit belongs to a layout.
LOAD = {"taildragger": "tail_wheel_load", "tricycle": "nose_wheel_load"}
ANGLE = {"taildragger": "nose_over", "tricycle": "tip_back"}

#: Where the numbers of `Limits.textbook` come from, as commonly quoted: the book itself was not at
#: hand when they were written down, so check them before a design rests on them.
SOURCES = {
    "nose_over": "16 to 25 deg from the vertical back to the CG, seen from the main wheels, for"
    " every CG: D. P. Raymer, Aircraft Design: A Conceptual Approach (AIAA), ch. 11",
    "tip_back": "at least 15 deg, or the attitude at which the tail strikes if that is more:"
    " Raymer, ch. 11",
    "nose_wheel_load": "8 to 15 % of the weight from the most aft to the most forward CG:"
    " Raymer, ch. 11",
}


@dataclass(frozen=True)
class Bound:
    """One bound of a limit.

    Attributes
    ----------
    limit : str
        Which limit, e.g. ``"nose_over"``.
    side : str
        ``"at least"`` or ``"at most"``.
    value : float
        SI units.
    """

    limit: str
    side: str
    value: float

    @property
    def kind(self) -> Kind:
        """What is limited."""
        return KINDS[self.limit]

    @property
    def sign(self) -> float:
        """+1 if more is better, -1 if less is."""
        return 1.0 if self.side == "at least" else -1.0

    def __str__(self) -> str:
        return f"{self.limit} {self.side} {show(self.value, self.kind)}"


@dataclass(frozen=True)
class Limits:
    """Limits that hold at every point of the envelope; None is no limit.

    Two-sided ones are (low, high) with None for no bound on that side. Strings with units are
    fine: ``nose_over=("16 deg", "25 deg")``. `Limits.textbook` has rules of thumb.

    Attributes
    ----------
    decay_rate : optional
        Least decay rate, 1/s. The default 0 asks for stability; None allows a placement that
        is unstable.
    damping_ratio : optional
        Least damping ratio of oscillating modes, at most 1.
    displacement : optional
        Most displacement across the runway, m; see `place_gear`.
    tail_wheel_load, nose_wheel_load : optional
        Share of the weight on the third wheel, at rest. It is never less than 0: a wheel does
        not pull at the ground.
    nose_over : optional
        Taildragger: angle between the vertical through the CG and the line from the CG to the
        main wheels, rad, the wheels ahead. Needs `cg_height`.
    tip_back : optional
        Tricycle: the same with the wheels behind.
    wheelbase : optional
        Main gear to third wheel, m.
    """

    decay_rate: Any = 0.0
    damping_ratio: Any = None
    displacement: Any = None
    tail_wheel_load: Any = None
    nose_wheel_load: Any = None
    nose_over: Any = None
    tip_back: Any = None
    wheelbase: Any = None

    def __post_init__(self) -> None:
        for field in fields(self):
            _bounds(field.name, getattr(self, field.name))

    @classmethod
    def textbook(cls, layout: str, **others: Any) -> Limits:
        """Rules of thumb for light aircraft; `SOURCES` says whose.

        Parameters
        ----------
        layout : str
            ``"taildragger"`` or ``"tricycle"``.
        **others
            Further limits, or other values for these.
        """
        rules: dict[str, dict[str, Any]] = {
            "taildragger": {"nose_over": ("16 deg", "25 deg")},
            "tricycle": {"tip_back": ("15 deg", None), "nose_wheel_load": (0.08, 0.15)},
        }
        return cls(**{**rules[one_of("layout", layout, rules, "Limits.textbook")], **others})

    def bounds(self, layout: str) -> tuple[Bound, ...]:
        """Every bound for a layout.

        Raises
        ------
        GroundrollError
            If a limit has no meaning for it.
        """
        found: list[Bound] = []
        for field in fields(self):
            bounds = _bounds(field.name, getattr(self, field.name))
            kind = KINDS[field.name]
            if bounds and layout not in kind.layouts:
                raise GroundrollError(
                    f"Limits.{field.name} means nothing for a {layout}; it is for a"
                    f" {kind.layouts[0]}"
                )
            found += bounds
        if not any(b.limit == LOAD[layout] and b.side == "at least" for b in found):
            found.append(Bound(LOAD[layout], "at least", 0.0))
        return tuple(found)


def _bounds(name: str, value: Any) -> list[Bound]:
    if value is None:
        return []
    kind, where = KINDS[name], f"Limits.{name}"
    if len(kind.sides) == 1:
        pair = [value]
    elif isinstance(value, tuple | list) and len(value) == 2:
        pair = list(value)
    else:
        raise GroundrollError(
            f"{where} has two bounds, (low, high), with None for a missing one; not {value!r}"
        )
    found = [
        Bound(name, side, float(numbers([v], kind.unit, where)[0]))
        for side, v in zip(kind.sides, pair, strict=True)
        if v is not None
    ]
    if not all(np.isfinite(b.value) for b in found):
        raise GroundrollError(f"{where} must be finite, not {value!r}; None is no limit")
    if len(found) == 2 and found[0].value > found[1].value:
        raise GroundrollError(
            f"{where}: the bounds are crossed, at least {show(found[0].value, kind)} but at most"
            f" {show(found[1].value, kind)}"
        )
    if name == "damping_ratio" and not 0 < found[0].value <= 1:
        raise GroundrollError(
            f"{where} must be above 0 and at most 1, not {found[0].value:g}: from 1 on no mode"
            " oscillates"
        )
    if name == "displacement" and found[0].value <= 0:
        raise GroundrollError(f"{where} must be positive, not {found[0].value:g} m")
    return found


#: Units that people use: factor from SI, digits after the point.
SHOWN = {
    "1/s": (1.0, 3),
    "1": (1.0, 3),
    "m": (1.0, 3),
    "%": (100.0, 2),
    "deg": (float(np.degrees(1.0)), 2),
    "mm": (1000.0, 1),
    "kg": (1.0, 1),
    "km/h": (3.6, 1),
    "m^2": (1.0, 4),
}


def show(value: float, kind: Kind) -> str:
    """A value in the unit that people use."""
    return shown(value, kind.shown)


def shown(value: float, unit: str) -> str:
    """An SI value in a unit of `SHOWN`."""
    factor, digits = SHOWN[unit]
    return f"{value * factor:.{digits}f} {unit}".removesuffix(" 1")
