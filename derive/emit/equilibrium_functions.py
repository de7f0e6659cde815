"""The generated functions about steady turns of a model with a main gear and a tail."""

from __future__ import annotations

from groundroll.derive.core.body import sum_M
from groundroll.derive.core.equation import needed
from groundroll.derive.core.frames import r, v
from groundroll.derive.core.jacobian import derivative
from groundroll.derive.core.model import Derivation
from groundroll.derive.parts.thesis import alpha
from groundroll.derive.theory.equilibrium import gear_moment, with_slope

from .module import Module
from .scalar_functions import ordered, scalar_function

#: Name of the module; a model that has it can find all of its steady turns.
EQUILIBRIUM = "equilibrium"


def equilibrium_module(model: Derivation) -> Module:
    """The balance of moments in a steady turn, and its slope."""
    chain = with_slope(model)
    slopes = (derivative(q, alpha) for q in (sum_M, gear_moment))
    results = (sum_M, *slopes, v, r)
    name = f"{model.name}_equilibrium"
    summary = "The steady turn at a slip angle: an equilibrium where the moment is zero."
    arguments = (alpha, *model.inputs, *ordered(needed(chain, results)))
    function = scalar_function(name, summary, arguments, results, chain)
    return Module(EQUILIBRIUM, "Steady turns under a steady side force.", (function,))
