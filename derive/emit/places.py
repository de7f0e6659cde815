"""Where the parts of a model act and with what: the function that pictures draw from."""

from __future__ import annotations

import sympy as sp

from groundroll.derive.core.frames import components
from groundroll.derive.core.model import Derivation

from .casadi_source import Argument, FunctionSpec, Result, cancel_tangents


def places_spec(model: Derivation) -> FunctionSpec:
    """(x, u, p) -> place and force of each part that acts, one row each, along body axes."""
    groups = {"x": model.states, "u": model.inputs, "p": model.parameters}
    arguments = tuple(Argument(key, group) for key, group in groups.items())
    place = sp.Matrix([list(components(each.position)) for each in model.places])
    force = sp.Matrix([list(components(each.force)) for each in model.places])
    results = (
        Result("place", place, "where each part acts, from the CG along body x, y, z [m]"),
        Result("force", force, "with what force along body x, y, z [N]"),
    )
    names = ", ".join(each.name for each in model.places)
    summary = f"Places and forces of the parts: {names}."
    chain = cancel_tangents(model.chain)
    return FunctionSpec("places", f"{model.name}_places", summary, arguments, results, chain)


def places_source(model: Derivation) -> str:
    """Source of the builder of `places_spec`."""
    return places_spec(model).source() + "\n"
