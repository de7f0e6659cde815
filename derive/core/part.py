"""Parts: what a model is put together from.

A part has a name, a place and a law. The law is told what it may feel there and returns the force
that it makes, with the chain of equations behind it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import sympy as sp
from sympy.physics.vector import Vector

from .equation import Chain, Equation
from .frames import components
from .quantity import Quantity
from .unit import check_unit

#: The load on a part that stands on the ground, as the law of that part calls it.
Fz = Quantity("Fz", "load", "N", "vertical load, the ground pushing up", "F_z")


@dataclass(frozen=True)
class Felt:
    """What a law may feel at the place of its part; vectors have components along body axes.

    Attributes
    ----------
    position : Vector
        From the CG.
    velocity, acceleration : Vector
        Over the ground. A force may be linear in the acceleration: a mass carried along.
    air_velocity : Vector
        Through the air: the velocity less the wind.
    rates : Vector
        Angular velocity of the body.
    forward, right, down : Vector
        The ground's axes.
    depth : Expr
        Of the place below the runway, m; negative above it. None where the body is level.
    load : Quantity
        The part's load, where the body is level and the balance of the body gives it.
    """

    position: Vector
    velocity: Vector
    acceleration: Vector
    air_velocity: Vector
    rates: Vector
    forward: Vector
    right: Vector
    down: Vector
    depth: sp.Expr | None
    load: Quantity = Fz


@dataclass(frozen=True)
class Event:
    """Something that happens when a quantity passes through zero.

    Attributes
    ----------
    name : str
        What happens, e.g. ``"wheel_lifted"``.
    quantity : Quantity
        What passes through zero, named in the chain.
    rising : bool
        Whether it happens when the quantity grows through zero, or falls through it.
    meaning : str
        One line for people.
    """

    name: str
    quantity: Quantity
    rising: bool
    meaning: str

    def of(self, part: str) -> Event:
        """The same event of one part."""
        if not part:
            return self
        where = f"{self.meaning}, {part}"
        return Event(f"{self.name}_{part}", self.quantity.of(part), self.rising, where)


@dataclass(frozen=True)
class Force:
    """What a part does: a force at its place, a couple, and the equations behind them.

    Attributes
    ----------
    vector, couple : Vector or 0
        Force, N, and couple, N m, on the body.
    chain : tuple of Equation
        What they are made of. Quantities defined here belong to the part; an `Input` defined here
        is driven by it, for every part, and is no input of the model any more.
    rates : mapping of State to Expr
        The states of the law's own and their time derivatives.
    shown : tuple of Quantity, optional
        Which quantities of the chain are outputs of the model; all of them if omitted.
    at : Vector, optional
        Where the force acts, from the CG; the place of the part if omitted.
    events : tuple of Event
        What may happen to the part.
    """

    vector: Vector = field(default_factory=lambda: Vector(0))
    couple: Vector = field(default_factory=lambda: Vector(0))
    chain: Chain = ()
    rates: Mapping[Quantity, sp.Expr] = field(default_factory=dict)
    shown: tuple[Quantity, ...] | None = None
    at: Vector | None = None
    events: tuple[Event, ...] = ()


#: From what is felt at a place to what is done there.
Law = Callable[[Felt], Force]


@dataclass(frozen=True)
class Part:
    """Something that acts on the body.

    Attributes
    ----------
    name : str
        What it is called; no two parts of a model share it.
    at : Vector
        Its place from the CG, made of lengths and the unit vectors i, j, k.
    law : callable
        From `Felt` to `Force`.
    asks : tuple of Quantity
        The inputs of the model, and states of other parts, that the law uses.
    suffix : str, optional
        What the names of its quantities end with; its name if omitted. Parts with an empty suffix
        keep bare names, and may define the same quantity if they define it equally.
    kind : str
        How it is drawn: ``"wheel"``, ``"wheels"`` (a pair of them, left and right), ``"fin"``,
        ``"force"`` or, not at all, ``""``.
    """

    name: str
    at: Vector
    law: Law
    asks: tuple[Quantity, ...] = ()
    suffix: str | None = None
    kind: str = "force"

    def __post_init__(self) -> None:
        if not self.name.isidentifier():
            raise ValueError(f"{self.name!r} cannot name a part: letters, digits and _ only")
        if not isinstance(self.asks, tuple):
            raise ValueError(f"{self.name}: asks is a tuple, as in asks=({self.asks},)")
        if not callable(self.law):
            raise ValueError(
                f"{self.name}: its law is {self.law!r}; expected a function of what is felt"
            )
        _check_vector(self.at, f"the place of {self.name}", "1.2 m ahead as arm * i")
        for axis, length in zip("xyz", components(self.at), strict=True):
            check_unit(length, "m", f"position of {self.name} along {axis}")

    def acts(self, felt: Felt) -> Force:
        """What the part does, under names of its own."""
        suffix = self.name if self.suffix is None else self.suffix
        force = self.law(felt)
        if not isinstance(force, Force):
            raise ValueError(f"the law of {self.name} returns {force!r}; it is to return a Force")
        self._check(force)
        own = [e.lhs for e in force.chain if not is_given(e.lhs)] + list(force.rates)
        names = {q: q.of(suffix) for q in (*own, felt.load)}

        def renamed(vector: Vector) -> Vector:
            return vector.xreplace(names) if vector.args else vector

        return Force(
            vector=renamed(force.vector),
            couple=renamed(force.couple),
            chain=tuple(
                Equation(names.get(e.lhs, e.lhs), e.rhs.xreplace(names), e.source)
                for e in force.chain
            ),
            rates={names[s]: sp.sympify(rate).xreplace(names) for s, rate in force.rates.items()},
            shown=tuple(names.get(q, q) for q in shown_of(force)),
            at=self.at if force.at is None else renamed(force.at),
            events=tuple(event.of(suffix) for event in force.events),
        )

    def _check(self, force: Force) -> None:
        expressions = [e.rhs for e in force.chain] + list(map(sp.sympify, force.rates.values()))
        for vector, unit, what in ((force.vector, "N", "force"), (force.couple, "N m", "couple")):
            _check_vector(vector, f"the {what} of {self.name}", "a force F to the right as F * j")
            column = components(vector)
            expressions += list(column)
            for axis, part in zip("xyz", column, strict=True):
                check_unit(part, unit, f"{what} of {self.name} along {axis}")
        for state, rate in force.rates.items():
            if state.kind != "state":
                raise ValueError(f"{self.name}: {state} has a rate but is no State")
            check_unit(sp.sympify(rate), f"({state.unit})/s", f"rate of {state} of {self.name}")


def _check_vector(vector: object, what: str, example: str) -> None:
    if not isinstance(vector, Vector):
        raise ValueError(
            f"{what} is {vector}; expected a vector along i, j and k: write {example}, nothing as"
            " 0 * i"
        )


def is_given(quantity: sp.Symbol) -> bool:
    """Whether a quantity is an input or a parameter: nothing that a law could call its own."""
    return getattr(quantity, "kind", "") in ("input", "parameter")


def shown_of(force: Force) -> tuple[Quantity, ...]:
    """The outputs of a force."""
    return tuple(e.lhs for e in force.chain) if force.shown is None else force.shown
