"""Which functions are generated, and into which pack and module each goes."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property

import sympy as sp

from groundroll.derive.core.equation import Chain, needed
from groundroll.derive.core.jacobian import jacobian, tangents
from groundroll.derive.core.model import Derivation
from groundroll.derive.core.quantity import Quantity
from groundroll.derive.models.landing_roll import landing_roll
from groundroll.derive.models.linear import linear
from groundroll.derive.models.nonlinear import nonlinear
from groundroll.derive.models.rollout import rollout
from groundroll.derive.parts.quantities import B1, C1, D1, PARAMETERS
from groundroll.derive.theory import (
    holding,
    kick,
    loads,
    mf_lateral,
    placement,
    stability_sections,
    tire_size,
)

from .casadi_source import Argument, CasadiPrinter, FunctionSpec, Result, cancel_tangents
from .equilibrium_functions import equilibrium_module
from .module import Module
from .scalar_functions import ordered, scalar_function
from .stability_functions import stability_functions
from .tire_functions import tire_module

#: Equations in a chain up to which its derivatives are written link by link; longer chains are
#: differentiated by CasADi, which keeps the generated code short.
_READABLE = 60


@dataclass(frozen=True)
class Section:
    """A part of an equation sheet: its title, its chain and a text before it."""

    title: str
    chain: Chain
    text: str = ""


@dataclass(frozen=True)
class Pack:
    """What is generated into one folder.

    Attributes
    ----------
    name, summary : str
    modules : tuple of Module
        Functions beside those of the model.
    model : Derivation, optional
        The model, if the pack has one.
    sections : tuple of Section
        Of the equation sheet, after that of the model.
    swept : str
        Module whose functions have kernels for many points; none if empty.
    abilities : tuple of str
        What can be done with it beyond what any model can.
    vocabulary : tuple of Quantity
        What it knows beside what its functions use.
    """

    name: str
    summary: str
    modules: tuple[Module, ...] = ()
    model: Derivation | None = None
    sections: tuple[Section, ...] = ()
    swept: str = ""
    abilities: tuple[str, ...] = ()
    vocabulary: tuple[Quantity, ...] = ()

    @cached_property
    def all_modules(self) -> tuple[Module, ...]:
        """The modules, that of the model first."""
        return self.modules if self.model is None else (model_module(self.model), *self.modules)

    @cached_property
    def quantities(self) -> tuple[Quantity, ...]:
        """Every quantity that appears, in a stable order."""
        found: dict[str, Quantity] = {}
        if self.model is not None:
            for q in (*self.model.states, *self.model.inputs, *self.model.parameters):
                found.setdefault(q.name, q)
            for q in self.model.outputs:
                found.setdefault(q.name, q)
            for equation in self.model.defaults:
                for q in (equation.lhs, *sorted(equation.rhs.free_symbols, key=str)):
                    found.setdefault(q.name, q)
        found |= {q.name: q for q in self.vocabulary if q.name not in found}
        for module in self.modules:
            for function in module.functions:
                results = [x for result in function.results for x in result.value]
                for q in (*(q for arg in function.arguments for q in arg.quantities), *results):
                    if isinstance(q, Quantity):
                        found.setdefault(q.name, q)
        return tuple(found.values())

    @cached_property
    def digest(self) -> str:
        """Digest of the equations as declared: symbols, units and order, and no words."""
        lines = list(_declared(self.model)) if self.model else []
        if not lines:
            for module in self.modules:
                for function in module.functions:
                    lines += [function.casadi_name, *_equations(function.chain)]
        return hashlib.sha256("\n".join(lines).encode()).hexdigest()[:16]


def _declared(model: Derivation) -> Iterator[str]:
    for group in (model.states, model.inputs, model.parameters, model.outputs):
        yield " ".join(f"{q}[{q.unit}]{q.sign}" for q in group)
    yield from _equations(model.chain)
    yield from _equations(model.defaults)
    printer = CasadiPrinter()
    yield from map(printer.doprint, model.rates)
    for event in model.events:
        yield f"{event.name} {event.quantity} {event.rising}"


def _equations(chain: Chain) -> Iterator[str]:
    printer = CasadiPrinter()
    for equation in chain:
        yield f"{equation.lhs}[{equation.lhs.unit}] = {printer.doprint(equation.rhs)}"


def packs() -> tuple[Pack, ...]:
    """Everything that ships, derived afresh."""
    return tuple(derived() for derived in SHIPPED.values())


def _aircraft() -> Pack:
    return Pack(
        "aircraft",
        "What follows of an aircraft, and its tire, before any model.",
        (loads_module(), tire_module(), _placement_module(), _kick_module(), _holding_module()),
        sections=(
            Section("Loads and stiffnesses", loads.static_loads()),
            Section("Loads with a nose wheel", loads.nose_wheel_loads(), _NOSE_WHEEL),
            Section("The tire of a tail wheel", loads.tail_wheel_tire()),
            Section("A main tire from its size and pressure", tire_size.main_tire(), _SIZE),
            Section("A tail wheel's tire from its size and pressure", tire_size.tail_tire()),
            Section("A tire of a .tir file", mf_lateral.lateral_force(), _MF),
            Section("A kick", kick.kick(), _KICK),
            Section("Held: loads that move", holding.moved_loads()),
            Section("Held: friction", holding.friction_used()),
            Section("Held: winds of a clause", holding.clause_winds(), _CLAUSE),
            *(Section(*section) for section in placement.sections()),
        ),
        vocabulary=PARAMETERS,
    )


def _linear() -> Pack:
    return Pack(
        "linear",
        linear().summary,
        (_stability_module(), equilibrium_module(linear())),
        linear(),
        tuple(Section(*section) for section in stability_sections.stability_sections()),
        swept="stability",
        abilities=("closed_forms", "placement", "turns"),
    )


def _nonlinear() -> Pack:
    model = nonlinear()
    return Pack(
        "nonlinear",
        model.summary,
        (equilibrium_module(model),),
        model,
        (Section(*stability_sections.steady_turns(model)),),
        abilities=("turns",),
    )


def _rolling(model: Derivation) -> Pack:
    return Pack(model.name, model.summary, model=model)


def model_module(model: Derivation) -> Module:
    """Right-hand side, outputs and Jacobians of a model, all of (x, u, p); what follows."""
    chain = cancel_tangents(model.chain)
    directions = {"x": model.states, "u": model.inputs, "p": model.parameters}

    def spec(name: str, summary: str, results: list[Result], chain: Chain) -> FunctionSpec:
        arguments = tuple(Argument(key, group) for key, group in directions.items())
        return FunctionSpec(name, f"{model.name}_{name}", summary, arguments, tuple(results), chain)

    rates = Result("xdot", sp.Matrix(model.rates), "time derivatives of x")
    outputs = Result("y", sp.Matrix(model.outputs), f"outputs {', '.join(map(str, model.outputs))}")
    functions = [
        spec("rhs", "Time derivatives of the states.", [rates], chain),
        spec("outputs", "Angles, forces, accelerations and what is carried.", [outputs], chain),
    ]
    is_readable = len(chain) <= _READABLE
    if is_readable:
        derivatives = tangents(chain, [q for group in directions.values() for q in group])
        values = {"f": ("xdot", model.rates), "g": ("y", model.outputs)}
        jacobians = [
            Result(
                f"{function}{key}",
                jacobian(expressions, chain, group),
                f"derivatives of {of} by {key}",
            )
            for function, (of, expressions) in values.items()
            for key, group in directions.items()
        ]
        functions.append(
            spec("jacobians", "Jacobians of states and outputs.", jacobians, derivatives)
        )
    return Module("model", model.summary, (*functions, *following(model)), is_readable)


def following(model: Derivation) -> Iterator[FunctionSpec]:
    """One function for each parameter of a model that follows from others."""
    order = [q for e in model.defaults for q in (e.lhs, *sorted(e.rhs.free_symbols, key=str))]
    yield from _following(model.defaults, "follows", tuple(dict.fromkeys(order)))


def loads_module() -> Module:
    """One function for each parameter that follows from others where it is not given."""
    third = tuple(q.of("third") for q in (B1, C1, D1))
    functions = (
        *_following(loads.static_loads(), "follows", PARAMETERS),
        *_following(loads.nose_wheel_loads(), "follows_with_nose_wheel", PARAMETERS),
        *_following(loads.tail_wheel_tire(), "follows_with_tail_wheel", (*PARAMETERS, *third)),
        *_following(tire_size.main_tire(), "follows", PARAMETERS),
        *_following(tire_size.tail_tire(), "follows_from_size", PARAMETERS),
    )
    return Module("loads", "What follows from CG and gear positions.", functions)


def _following(
    chain: Chain, suffix: str, parameters: tuple[Quantity, ...]
) -> Iterator[FunctionSpec]:
    for equation in chain:
        if equation.lhs.kind != "parameter":
            continue
        # stop at every quantity that an aircraft file may give instead
        inner = tuple(e for e in chain if e is equation or e.lhs.kind != "parameter")
        inner = needed(inner, [equation.lhs])
        summary = (
            f"{equation.lhs.meaning[0].upper()}{equation.lhs.meaning[1:]} ({equation.source})."
        )
        name = f"{equation.lhs}_{suffix}"
        arguments = ordered(inner, parameters)
        yield scalar_function(name, summary, arguments, [equation.lhs], inner)


def _stability_module() -> Module:
    return Module(
        "stability",
        "Closed forms of the linear model (Section 4.7 and what it leaves unsaid).",
        stability_functions(),
    )


def _placement_module() -> Module:
    return Module(
        "placement",
        "Where the wheels may stand: loads, margins and limits from stations.",
        (
            scalar_function(
                "placement_following",
                "Arms, loads and stiffnesses where the stiffnesses follow the loads.",
                placement.FOLLOWING,
                placement.STIFFNESS,
                placement.following_stiffness(),
            ),
            scalar_function(
                "placement_constant",
                "Arms, loads and stiffnesses where no stiffness knows where the gear is.",
                placement.CONSTANT,
                placement.STIFFNESS,
                placement.constant_stiffness(),
            ),
            scalar_function(
                "placement_tire",
                "Cornering coefficient of a worn tire.",
                placement.TIRE,
                placement.WORN,
                placement.worn_tire(),
            ),
            scalar_function(
                "placement_margins",
                "Smooth conditions for a decay rate and a damping ratio.",
                placement.AIRFRAME,
                placement.CONDITIONS,
                placement.margins(),
            ),
            scalar_function(
                "placement_limits",
                "What else limits the place of the wheels.",
                placement.GROUND,
                placement.LIMITED,
                placement.limits(),
            ),
        ),
    )


def _kick_module() -> Module:
    arguments, results = (kick.S, kick.x_S, *kick.INERTIA), (kick.dv, kick.dr)
    summary = "Changes of the motion by a side impulse at a station."
    function = scalar_function("kick", summary, arguments, results, kick.kick())
    return Module("kick", "A kick: what an impulse changes at once.", (function,))


def _holding_module() -> Module:
    return Module(
        "holding",
        "What limits an aircraft that is held straight.",
        (
            scalar_function(
                "moved_loads",
                "Loads on the main wheels of a level body that is rolled.",
                holding.LOADS,
                (holding.N_left, holding.N_right),
                holding.moved_loads(),
            ),
            scalar_function(
                "friction_used",
                "How much of its friction a main tire makes.",
                holding.TIRE,
                (holding.used,),
                holding.friction_used(),
            ),
            scalar_function(
                "clause_winds",
                "Stall speed, and winds of 14 CFR 25.233(a) and the former 23.233(a).",
                holding.STALL,
                (holding.V_stall, holding.wind_large, holding.wind_small),
                holding.clause_winds(),
            ),
        ),
    )


_CLAUSE = "What the clauses ask, said for comparison; nothing here certifies anything."
_NOSE_WHEEL = (
    "What is otherwise with the main gear behind the CG: the nose wheel carries what it leaves."
    " Where this is NaN, the equations above hold."
)
_SIZE = (
    "Smiley and Horne, NASA TR R-64 (1960), from memory: estimates for an aircraft whose tires"
    " nobody has measured."
)
_MF = "Pacejka, Tire and Vehicle Dynamics, 3rd edition, pure lateral slip without camber."
_KICK = "A side impulse changes the motion before any tire can answer."

#: What ships: names of packs, and how each is derived.
SHIPPED: dict[str, Callable[[], Pack]] = {
    "aircraft": _aircraft,
    "linear": _linear,
    "nonlinear": _nonlinear,
    "rollout": lambda: _rolling(rollout()),
    "landing_roll": lambda: _rolling(landing_roll()),
}
