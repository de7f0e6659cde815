"""A model: a body and its parts, assembled into x' = f(x, u, p) and y = g(x, u, p)."""

from __future__ import annotations

import keyword
from collections import Counter, defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import sympy as sp
from sympy.physics.vector import Vector

from .balance import accelerations, loads
from .body import CARRIED, SPEEDS, SUMS, Body, a_x, a_y, a_z
from .equation import Chain, Equation, expand, merge, needed, ordered
from .frames import components
from .part import Event, Force, Part, shown_of
from .quantity import Quantity

#: What functions of the runtime call their own arguments: no input, state or parameter may.
RESERVED = frozenset(
    [
        *("plane", "aircraft", "model", "t", "samples", "at", "until", "limits", "within", "tol"),
        *("threads", "executor", "chunk", "progress", "names", "extremes", "method", "initial"),
        *("step", "name", "time", "self", "units", "out"),
    ]
)
#: What generated code calls its own.
_TAKEN = frozenset(["ca", "jac", "hess", "null", "cache"])


class ModelError(ValueError):
    """A model that cannot be; the message says which part or quantity, and why."""


@dataclass(frozen=True)
class Model:
    """What a model is made of.

    Attributes
    ----------
    name : str
        Name in generated code and on the command line.
    summary : str
        One line for people.
    body : Body
    parts : sequence of Part
    defaults : tuple of Equation
        What a parameter is where nobody gives it, by other parameters.
    outputs : tuple of Quantity
        What to report first; what the parts show and the balance follow without being named.
    parameters : tuple of Quantity
        An order for the parameters; those that are not in it follow as they appear.
    events : tuple of Event
        What may happen, beside what the parts say.
    """

    name: str
    summary: str
    body: Body
    parts: Sequence[Part]
    defaults: Chain = ()
    outputs: tuple[Quantity, ...] = ()
    parameters: tuple[Quantity, ...] = ()
    events: tuple[Event, ...] = ()

    def derive(self) -> Derivation:
        """The equations of motion.

        Raises
        ------
        ModelError
            If two parts share a name, a quantity has two meanings or no definition, definitions
            run in a circle, or a law uses an input that it did not ask for.
        UnitError
            If a term has the wrong unit.
        """
        return assemble(self)


@dataclass(frozen=True)
class Place:
    """Where a part acts, and with what: for whoever draws it."""

    name: str
    kind: str
    position: Vector
    force: Vector


@dataclass(frozen=True)
class Derivation:
    """A model's equations.

    Attributes
    ----------
    name, summary : str
    states, inputs, parameters, outputs : tuple of Quantity
        In the order of the vectors x, u, p and y.
    chain : tuple of Equation
        From states, inputs and parameters to accelerations and outputs, in order.
    rates : tuple of sympy.Expr
        Time derivative of each state in terms of the chain.
    defaults : tuple of Equation
        What a parameter is where nobody gives it.
    events : tuple of Event
    places : tuple of Place
        The parts that act, as they stand in the model.
    """

    name: str
    summary: str
    states: tuple[Quantity, ...]
    inputs: tuple[Quantity, ...]
    parameters: tuple[Quantity, ...]
    outputs: tuple[Quantity, ...]
    chain: Chain
    rates: tuple[sp.Expr, ...]
    defaults: Chain = ()
    events: tuple[Event, ...] = ()
    places: tuple[Place, ...] = ()

    @cached_property
    def dynamic(self) -> tuple[Quantity, ...]:
        """The velocities, and all that their rates depend on; other states are integrals."""
        rate_of = dict(zip(self.states, self.rates, strict=True))
        found = {s for s in self.states if s in SPEEDS}
        while more := {s for f in found for s in self._read(rate_of[f])} - found:
            found |= more
        return tuple(s for s in self.states if s in found)

    def _read(self, rate: sp.Expr) -> set[Quantity]:
        """The states that a rate depends on."""
        chain = needed(self.chain, [rate])
        used = rate.free_symbols.union(*(e.rhs.free_symbols for e in chain))
        return {s for s in self.states if s in used}

    def explicit(self, expr: sp.Expr) -> sp.Expr:
        """`expr` in states, inputs and parameters only."""
        return expand(expr, self.chain)

    def replace(self, **changes: object) -> Derivation:
        """A copy with some attributes changed."""
        return replace(self, **changes)  # type: ignore[arg-type]


def assemble(model: Model) -> Derivation:
    """Derive a model: see `Model.derive`."""
    body, parts = model.body, tuple(model.parts)
    _check_names(model, parts)
    forces = [_acting(body, part) for part in parts]
    laws = _merged(model, (e for force in forces for e in force.chain))
    surroundings = body.surroundings()
    laws = (*laws, *loads(model.name, body, parts, forces, laws))
    chain = (*laws, *surroundings, *accelerations(model.name, body, forces, laws))
    chain = _sorted(model, chain)
    rates = _rates(body, forces)
    shown = [q for force in forces for q in shown_of(force)]
    balance = [e.lhs for e in chain if e.lhs in _REPORTED]
    wanted = tuple(dict.fromkeys([*model.outputs, *shown, *balance]))
    events = (*(e for force in forces for e in force.events), *model.events)
    outputs = tuple(dict.fromkeys([*wanted, *(e.quantity for e in events)]))
    _check_defined(model, outputs, chain)
    chain = needed(chain, (*rates.values(), *outputs))
    free = _free(chain, rates.values(), outputs, model.defaults)
    _check_free(model, free, rates)
    parameters = [q for q in free if q.kind == "parameter"]
    return Derivation(
        name=model.name,
        summary=model.summary,
        states=tuple(rates),
        inputs=tuple(q for q in free if q.kind == "input"),
        parameters=_in_order(parameters, model.parameters),
        outputs=outputs,
        chain=chain,
        rates=tuple(rates.values()),
        defaults=model.defaults,
        events=events,
        places=tuple(
            Place(part.name, part.kind, force.at, force.vector)
            for part, force in zip(parts, forces, strict=True)
            if part.kind and force.at is not None
        ),
    )


_REPORTED: frozenset[Quantity] = frozenset((a_x, a_y, a_z, *SUMS, *CARRIED))


def _acting(body: Body, part: Part) -> Force:
    """What a part does on this body, its inputs asked for."""
    force = part.acts(body.feel(part))
    expressions = (
        *components(force.vector),
        *components(force.couple),
        *(e.rhs for e in force.chain),
        *map(sp.sympify, force.rates.values()),
    )
    used = {s for e in expressions for s in e.free_symbols if getattr(s, "kind", "") == "input"}
    if unasked := used - set(part.asks) - {e.lhs for e in force.chain}:
        names = ", ".join(sorted(map(str, unasked)))
        raise ModelError(
            f"the law of {part.name} uses {names} without asking: Part(..., asks=({names},))"
        )
    return force


def _merged(model: Model, equations: Iterable[Equation]) -> Chain:
    try:
        return merge(equations)
    except ValueError as problem:
        raise ModelError(f"{model.name}: {problem}; give the parts names of their own") from None


def _sorted(model: Model, chain: Iterable[Equation]) -> Chain:
    try:
        return ordered(chain)
    except ValueError as problem:
        raise ModelError(f"{model.name}: {problem}") from None


def _rates(body: Body, forces: Sequence[Force]) -> dict[Quantity, sp.Expr]:
    """Each state with its rate: velocities, the parts' own, and the path."""
    own = [(state, rate) for force in forces for state, rate in force.rates.items()]
    twice = [str(s) for s, count in Counter(s for s, _ in own).items() if count > 1]
    if twice:
        raise ModelError(f"{', '.join(twice)} has two rates")
    speeds = dict(zip(body.speeds, body.accelerations, strict=True))
    return {**speeds, **{s: sp.sympify(e) for s, e in own}, **body.path_rates()}


def _free(
    chain: Chain, rates: Iterable[sp.Expr], outputs: Iterable[Quantity], defaults: Chain
) -> list[Quantity]:
    """What the equations use without defining it, in order of appearance."""
    defined = {e.lhs for e in chain}
    found: dict[Quantity, None] = {}
    for expr in (*(e.rhs for e in chain), *rates, *outputs):
        for symbol in sorted(expr.free_symbols - defined, key=str):
            found.setdefault(symbol)
    return list(found)


def _in_order(found: Sequence[Quantity], order: Sequence[Quantity]) -> tuple[Quantity, ...]:
    first = [q for q in order if q in found]
    return (*first, *(q for q in found if q not in first))


# --- What cannot be ---------------------------------------------------------------------------


def _check_names(model: Model, parts: Sequence[Part]) -> None:
    if not model.name.isidentifier() or keyword.iskeyword(model.name):
        raise ModelError(f"{model.name!r} cannot name a model: letters, digits and _ only")
    for part in parts:
        if not isinstance(part, Part):
            raise ModelError(f"{model.name}: {part!r} stands among its parts and is no Part")
    twice = [name for name, count in Counter(part.name for part in parts).items() if count > 1]
    if twice:
        raise ModelError(
            f"{model.name}: two parts are called {twice[0]!r}; each needs its own name"
        )
    if not parts:
        raise ModelError(f"{model.name} has no parts")


def _check_defined(model: Model, outputs: Sequence[Quantity], chain: Chain) -> None:
    defined = {e.lhs for e in chain}
    if missing := [q for q in outputs if q not in defined]:
        names = ", ".join(map(str, missing))
        raise ModelError(f"{model.name}: no equation defines {names}, which is to be reported")


def _check_free(model: Model, free: Sequence[Quantity], rates: Iterable[Quantity]) -> None:
    states = set(rates)
    for quantity in free:
        if getattr(quantity, "kind", "") == "state" and quantity not in states:
            raise ModelError(
                f"{model.name}: the state {quantity} has no rate; the law of the part that it"
                f" belongs to gives it: Force(..., rates={{{quantity}: ...}})"
            )
        if not getattr(quantity, "kind", ""):
            raise ModelError(
                f"{model.name}: {quantity} is neither state, input nor parameter, and no equation"
                " defines it"
            )
    named: dict[str, Quantity] = {}
    words: dict[str, set[str]] = defaultdict(set)
    for quantity in (*states, *free):
        known = named.setdefault(quantity.name, quantity)
        if known != quantity:
            difference = next(
                f"{what}: {one!r} and {other!r}"
                for what, one, other in (
                    ("kinds", known.kind, quantity.kind),
                    ("units", known.unit, quantity.unit),
                    ("names", known.full_name, quantity.full_name),
                    ("meanings", known.meaning, quantity.meaning),
                )
                if one != other
            )
            raise ModelError(
                f"{model.name}: {quantity} has two {difference}; give one of them another symbol,"
                " or define it once and use it twice"
            )
        words[quantity.full_name].add(quantity.name)
        if len(same := words[quantity.full_name]) > 1:
            raise ModelError(
                f"{model.name}: {' and '.join(sorted(same))} have the same name"
                f" {quantity.full_name!r}; values are given by name, so each needs its own"
            )
        if not quantity.name.isidentifier() or keyword.iskeyword(quantity.name):
            raise ModelError(f"{model.name}: {quantity.name!r} cannot be a symbol in code")
        for word in (quantity.name, quantity.full_name):
            if word in RESERVED | _TAKEN and quantity.kind in ("input", "parameter"):
                raise ModelError(
                    f"{model.name}: {word!r} is an argument of groundroll's functions or a name of"
                    " the generated code; call the quantity otherwise"
                )
