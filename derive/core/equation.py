"""A derivation as a chain of named equations, each with its source."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import sympy as sp

from .quantity import Quantity
from .unit import check_unit


@dataclass(frozen=True)
class Equation:
    """One line of the derivation: ``lhs = rhs``.

    Parameters
    ----------
    lhs : Quantity
        What is defined.
    rhs : sympy.Expr
        By what; its unit must be that of `lhs`.
    source : str
        Equation, table or section of the thesis, e.g. ``"Eq. 4.14"``.

    Raises
    ------
    UnitError
        If the two sides, or two terms of a sum, differ in unit.
    """

    lhs: Quantity
    rhs: sp.Expr
    source: str

    def __post_init__(self) -> None:
        object.__setattr__(self, "rhs", sp.sympify(self.rhs))
        check_unit(self.rhs, self.lhs.unit, where=f"{self.lhs} ({self.source})")


Chain = tuple[Equation, ...]


def merge(equations: Iterable[Equation]) -> Chain:
    """Drop repeated equations; refuse two definitions of one quantity.

    Parts with bare names that stand in one place (vertical tail and tail wheel) define the same
    angle.
    """
    merged: dict[Quantity, Equation] = {}
    for equation in equations:
        known = merged.setdefault(equation.lhs, equation)
        if known.rhs != equation.rhs and sp.simplify(known.rhs - equation.rhs) != 0:
            raise ValueError(f"{equation.lhs} is defined twice: {known.rhs} and {equation.rhs}")
    return tuple(merged.values())


def ordered(chain: Iterable[Equation]) -> Chain:
    """The same equations, each after those that it uses, otherwise as they were.

    Raises
    ------
    ValueError
        If definitions run in a circle; the message names it.
    """
    definition = {equation.lhs: equation for equation in chain}
    done: dict[Quantity, Equation] = {}

    def visit(lhs: Quantity, path: tuple[Quantity, ...]) -> None:
        if lhs in done or lhs not in definition:
            return
        if lhs in path:
            circle = " -> ".join(map(str, (*path[path.index(lhs) :], lhs)))
            raise ValueError(f"definitions run in a circle: {circle}")
        for symbol in sorted(definition[lhs].rhs.free_symbols, key=str):
            visit(symbol, (*path, lhs))
        done[lhs] = definition[lhs]

    for lhs in definition:
        visit(lhs, ())
    return tuple(done.values())


def needed(chain: Sequence[Equation], results: Iterable[sp.Expr]) -> Chain:
    """The equations of `chain` that `results` depend on, in order."""
    wanted = {s for expr in results for s in sp.sympify(expr).free_symbols}
    kept: list[Equation] = []
    for equation in reversed(chain):
        if equation.lhs in wanted:
            kept.append(equation)
            wanted |= equation.rhs.free_symbols
    return tuple(reversed(kept))


def expand(expr: sp.Expr, chain: Sequence[Equation]) -> sp.Expr:
    """`expr` with every named quantity of `chain` replaced by its definition."""
    for equation in reversed(chain):
        expr = expr.xreplace({equation.lhs: equation.rhs})
    return expr
