"""Functions of named scalars, to be applied element by element."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from groundroll.derive.core.equation import Chain, needed
from groundroll.derive.core.quantity import Quantity
from groundroll.derive.parts.quantities import PARAMETERS

from .casadi_source import Argument, FunctionSpec, Result


def scalar_function(
    name: str,
    summary: str,
    arguments: Sequence[Quantity],
    results: Sequence[Quantity],
    chain: Chain,
) -> FunctionSpec:
    """A function of named scalars, to be applied element by element."""
    outputs = tuple(Result(str(q), sp.Matrix([q]), f"{q.meaning} [{q.unit}]") for q in results)
    inputs = tuple(map(Argument.scalar, arguments))
    return FunctionSpec(name, name, summary, inputs, outputs, needed(chain, results))


def ordered(chain: Chain, order: Sequence[Quantity] = PARAMETERS) -> tuple[Quantity, ...]:
    """The parameters a chain depends on, in a given order."""
    free = {s for e in chain for s in e.rhs.free_symbols} - {e.lhs for e in chain}
    return tuple(q for q in order if q in free)
