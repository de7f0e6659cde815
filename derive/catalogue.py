"""Which functions are generated, and into which module of `generated/` each goes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import sympy as sp

from . import kick, loads, placement, tire
from .casadi_source import Argument, FunctionSpec, Result, cancel_tangents
from .components import alpha
from .equation import Chain, needed
from .jacobian import jacobian, tangents
from .linear import linear
from .model import Model, nonlinear
from .quantities import B1, C1, D1, E1, PARAMETERS, STATES, Fz, Quantity
from .scalar_functions import ordered, scalar_function
from .stability_functions import stability_functions


@dataclass(frozen=True)
class Module:
    """A module of `generated/`: its name, its docstring and its functions."""

    name: str
    summary: str
    functions: tuple[FunctionSpec, ...]
    model: Model | None = None


def modules() -> tuple[Module, ...]:
    """Everything that is generated, derived afresh."""
    return (
        _model_module(linear()),
        _model_module(nonlinear()),
        _loads_module(),
        _tire_module(),
        _stability_module(),
        _placement_module(),
        _kick_module(),
    )


def _model_module(model: Model) -> Module:
    return Module(model.name, model.summary, model_functions(model), model)


def model_functions(model: Model) -> tuple[FunctionSpec, ...]:
    """Right-hand side, outputs and Jacobians of a model, all of (x, u, p)."""
    chain = cancel_tangents(model.chain)
    directions = {"x": model.states, "u": model.inputs, "p": model.parameters}
    derivatives = tangents(chain, [q for group in directions.values() for q in group])

    def spec(name: str, summary: str, results: Sequence[Result], chain: Chain) -> FunctionSpec:
        arguments = tuple(Argument(key, group) for key, group in directions.items())
        return FunctionSpec(name, f"{model.name}_{name}", summary, arguments, tuple(results), chain)

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
    rates = Result("xdot", sp.Matrix(model.rates), "time derivatives of x")
    outputs = Result("y", sp.Matrix(model.outputs), f"outputs {', '.join(map(str, model.outputs))}")
    return (
        spec("rhs", "Time derivatives of the states.", [rates], chain),
        spec("outputs", "Angles, forces and acceleration.", [outputs], chain),
        spec("jacobians", "Jacobians of states and outputs.", jacobians, derivatives),
    )


def _loads_module() -> Module:
    """One function for each parameter that follows from others where it is not given."""
    functions = (
        *_following(loads.static_loads(), "follows"),
        *_following(loads.nose_wheel_loads(), "follows_with_nose_wheel"),
    )
    return Module("loads", "What follows from CG and gear positions.", functions)


def _following(chain: Chain, suffix: str) -> Iterator[FunctionSpec]:
    for equation in chain:
        if equation.lhs not in PARAMETERS:
            continue
        # stop at every quantity that an aircraft file may give instead
        inner = tuple(e for e in chain if e is equation or e.lhs not in PARAMETERS)
        inner = needed(inner, [equation.lhs])
        summary = (
            f"{equation.lhs.meaning[0].upper()}{equation.lhs.meaning[1:]} ({equation.source})."
        )
        name = f"{equation.lhs}_{suffix}"
        yield scalar_function(name, summary, ordered(inner), [equation.lhs], inner)


def _tire_module() -> Module:
    alpha_bar, F_bar, C_c, mu, F_y = tire.alpha_bar, tire.F_bar, tire.C_c, tire.mu, tire.F_y
    force = cancel_tangents(tire.nonlinear_tire(alpha))
    return Module(
        "tire",
        "The tire by itself (Chapter 3).",
        (
            scalar_function(
                "tire_force",
                "Lateral force of one tire at a slip angle and load.",
                (alpha, *ordered(force)),
                (F_y, alpha_bar, F_bar, C_c, mu),
                force,
            ),
            scalar_function(
                "magic_formula",
                "Normalised force at a normalised slip angle.",
                (alpha_bar, B1, C1, D1, E1),
                (F_bar,),
                tire.magic_formula(),
            ),
            scalar_function(
                "measured_coefficients",
                "Cornering and friction coefficient from measured forces at one load.",
                (alpha, F_y, tire.F_peak, Fz),
                (C_c, mu),
                tire.measured_coefficients(alpha, tire.F_peak),
            ),
            scalar_function(
                "normalised_data",
                "A measured force in normalised form.",
                (alpha, F_y, Fz, C_c, mu),
                (alpha_bar, F_bar),
                tire.normalised_data(alpha),
            ),
        ),
    )


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


#: Every quantity that appears anywhere, by symbol, for the table that the runtime reads.
def all_quantities(generated: Sequence[Module]) -> tuple[Quantity, ...]:
    """States, parameters, and what the functions take and return, in a stable order."""
    found: dict[str, Quantity] = {q.name: q for q in (*STATES, *PARAMETERS)}
    for module in generated:
        for function in module.functions:
            if module.model is None:
                results = [x for result in function.results for x in result.value]
            else:
                results = list(module.model.outputs)
            for q in (*(q for arg in function.arguments for q in arg.quantities), *results):
                found.setdefault(q.name, q)
    return tuple(found.values())
