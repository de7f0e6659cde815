"""Signs turned around in the equations of a model, one at a time, and what comes of it."""

import math
import operator
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace

import sympy as sp

from groundroll.derive.core.model import Derivation
from groundroll.derive.core.quantity import Constant


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


_FUNCTIONS: dict[str, Callable[..., float]] = {
    **{name: getattr(math, name) for name in ("sin", "cos", "tan", "atan", "atan2", "tanh")},
    "exp": math.exp,
    "log": math.log,
    "sqrt": math.sqrt,
    "asin": math.asin,
    "acos": math.acos,
    "Max": max,
    "Min": min,
    "Abs": abs,
    "sign": lambda x: float((x > 0) - (x < 0)),
    "Add": lambda *terms: sum(terms),
    "Mul": lambda *factors: math.prod(factors),
    "Pow": lambda base, power: base**power,
    "And": lambda *all_of: all(all_of),
    "Or": lambda *any_of: any(any_of),
    "Not": lambda wrong: not wrong,
    "StrictGreaterThan": operator.gt,
    "GreaterThan": operator.ge,
    "StrictLessThan": operator.lt,
    "LessThan": operator.le,
}


def value(expr: sp.Basic, at: Mapping[str, float]) -> float:
    """Of an expression with a value for each symbol, walking through it: nothing is compiled."""
    if isinstance(expr, Constant):
        return expr.value
    if expr.is_Symbol:
        return at[expr.name]
    if isinstance(expr, sp.Piecewise):
        return next(value(result, at) for result, condition in expr.args if value(condition, at))
    if not expr.args:
        return bool(expr) if expr in (sp.true, sp.false) else float(expr)
    return _FUNCTIONS[expr.func.__name__](*(value(part, at) for part in expr.args))
