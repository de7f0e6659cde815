"""Signs turned around in the equations of a model, one at a time."""

from collections.abc import Iterator
from dataclasses import replace

import sympy as sp

from groundroll.derive.core.model import Derivation


def terms(expr: sp.Expr) -> Iterator[tuple[str, sp.Expr]]:
    """Every term of every sum in an expression, and the expression with that term negated."""
    for part in sp.preorder_traversal(expr):
        if part.is_Add:
            for term in part.args:
                yield str(term), expr.xreplace({part: part - 2 * term})


def equation_flips(model: Derivation) -> Iterator[tuple[str, Derivation]]:
    """Every term and all of every equation; of a pure number not all, two signs may cancel."""
    for n, equation in enumerate(model.chain):
        flipped = dict(terms(equation.rhs))
        if equation.lhs.unit not in ("1", "1/rad"):
            flipped["all of it"] = -equation.rhs
        for term, rhs in flipped.items():
            chain = (*model.chain[:n], replace(equation, rhs=rhs), *model.chain[n + 1 :])
            yield f"{equation.lhs}: {term}", model.replace(chain=chain)


def rate_flips(model: Derivation) -> Iterator[tuple[str, Derivation]]:
    """Every term and all of every rate."""
    for n, (symbol, rate) in enumerate(zip(model.states, model.rates, strict=True)):
        for term, flipped in {**dict(terms(rate)), "all of it": -rate}.items():
            rates = (*model.rates[:n], flipped, *model.rates[n + 1 :])
            yield f"rate of {symbol}: {term}", model.replace(rates=rates)
