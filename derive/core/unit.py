"""Dimensional check, node by node.

Angles are pure numbers: an angle in degrees cannot enter the derivation, because every
quantity is declared in radians.
"""

from __future__ import annotations

import re
from functools import cache

import sympy as sp

from .quantity import Constant

BASE = {name: sp.Symbol(name, positive=True) for name in ("kg", "m", "s")}
_DERIVED = {"N": BASE["kg"] * BASE["m"] / BASE["s"] ** 2, "rad": sp.Integer(1)}


class UnitError(ValueError):
    """Two sides of an equation, or two terms of a sum, differ in unit."""


@cache
def unit(text: str) -> sp.Expr:
    """A unit such as ``"kg m^2"`` or ``"1/(rad N)"`` as a monomial in kg, m and s.

    Raises
    ------
    UnitError
        If the text holds anything else; the message lists the names it may hold.
    """
    known = {**BASE, **_DERIVED}
    if set(re.findall(r"[^\W\d]\w*", text)) <= known.keys():
        try:
            return sp.sympify(text.replace("^", "**").replace(" ", "*"), locals=known)
        except sp.SympifyError:
            pass
    raise UnitError(f"{text!r} is no unit; units are made of {', '.join(known)}")


def unit_of(expr: sp.Expr) -> sp.Expr:
    """Unit of an expression whose symbols are quantities, as a monomial in kg, m and s.

    Raises
    ------
    UnitError
        Naming the sum, function or exponent that does not fit.
    """
    if expr.is_number and not expr.has(Constant):
        return sp.Integer(1)
    if expr.is_Symbol or isinstance(expr, Constant):
        return unit(expr.unit)
    if expr.is_Mul:
        return sp.Mul(*(unit_of(factor) for factor in expr.args))
    if expr.is_Pow:
        _require_number(expr.exp, f"exponent of {expr}")
        return unit_of(expr.base) ** expr.exp
    if expr.is_Add:
        return _common_unit(expr)
    if isinstance(expr, sp.Piecewise):
        return _common_unit(sp.Tuple(*(branch for branch, _ in expr.args)))
    if isinstance(expr, sp.Abs | sp.Max | sp.Min):
        return _common_unit(expr)
    if isinstance(expr, sp.sign | sp.Heaviside):
        unit_of(expr.args[0])  # any, but one
        return sp.Integer(1)
    if isinstance(expr, sp.atan2):
        _common_unit(expr)
        return sp.Integer(1)
    for argument in expr.args:
        _require_number(argument, f"argument of {expr.func.__name__} in {expr}")
    return sp.Integer(1)


def check_unit(expr: sp.Expr, expected: str, where: str) -> None:
    """Raise `UnitError` unless `expr` has the unit `expected`; zero has every unit."""
    branches = [b for b, _ in expr.args] if isinstance(expr, sp.Piecewise) else [expr]
    try:
        fits = set(branches) <= {0, sp.nan} or unit_of(expr) == unit(expected)
    except UnitError as problem:
        raise UnitError(f"{where}: {problem}") from None
    if not fits:
        raise UnitError(
            f"{where}: the right side has unit {unit_of(expr)}, the left side {unit(expected)}"
        )


def _require_number(expr: sp.Expr, what: str) -> None:
    if (found := unit_of(expr)) != 1:
        raise UnitError(f"{what} has unit {found}; it must be a pure number")


def _common_unit(expr: sp.Basic) -> sp.Expr:
    terms = [(term, unit_of(term)) for term in expr.args if term not in (0, sp.nan)]
    if not terms:
        return sp.Integer(1)
    first, expected = terms[0]
    for term, found in terms[1:]:
        if found != expected:
            raise UnitError(f"in {expr}: {first} has unit {expected} but {term} has unit {found}")
    return expected
