# Generated from derive/ with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`.
"""Bounds of a function over an interval of its first argument, which hold whatever is rounded.

Interval arithmetic (R. E. Moore, "Methods and Applications of Interval Analysis", 1979): every
operation on numbers becomes one on their bounds, and widens its result by more than it can have
been rounded.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import casadi as ca

#: How far arithmetic, and how far curves, are off at most, relative to the result.
_ROUNDED, _CURVED = 2.0**-51, 2.0**-48
_TINY = 1e-300


class Interval(NamedTuple):
    """From where to where; the same expression twice for a number."""

    low: ca.SX
    high: ca.SX

    @property
    def is_number(self) -> bool:
        """Whether it has no width."""
        return ca.is_equal(self.low, self.high)


def bounds(function: ca.Function, count: int, name: str) -> ca.Function:
    """Bounds of the first results of a function of named scalars.

    Parameters
    ----------
    function : casadi.Function
        Of scalars, made of operations that are known here.
    count : int
        How many of its results are wanted.
    name : str
        Name of the result.

    Returns
    -------
    casadi.Function
        (low, high, ...) -> result_low, result_high, ...: the first argument by its ends, the
        others as they are.
    """
    low, high, *others = (ca.SX.sym(s) for s in ("low", "high", *function.name_in()[1:]))
    given = [Interval(low, high), *(Interval(x, x) for x in others)]
    work: dict[int, Interval] = {}
    results: dict[int, Interval] = {}
    for k in range(function.n_instructions()):
        op, source = function.instruction_id(k), function.instruction_input(k)
        target = function.instruction_output(k)[0]
        if op == ca.OP_OUTPUT:
            results[target] = work[source[0]]
        elif op == ca.OP_INPUT:
            work[target] = given[source[0]]
        elif op == ca.OP_CONST:
            number = ca.SX(function.instruction_constant(k))
            work[target] = Interval(number, number)
        elif op in _OPERATIONS:
            work[target] = _OPERATIONS[op](*(work[s] for s in source))
        else:
            raise NotImplementedError(f"CasADi operation {op} has no bounds over an interval")
    ends = [end for k in range(count) for end in results[k]]
    names = [
        f"{result}_{end}" for result in function.name_out()[:count] for end in Interval._fields
    ]
    arguments = ["low", "high", *function.name_in()[1:]]
    return ca.Function(name, [low, high, *others], ca.cse(ends), arguments, names)


def _wider(low: ca.SX, high: ca.SX, part: float = _ROUNDED) -> Interval:
    return Interval(
        low - (part * ca.fabs(low) + _TINY),
        high + (part * ca.fabs(high) + _TINY),
    )


def _add(a: Interval, b: Interval) -> Interval:
    return _wider(a.low + b.low, a.high + b.high)


def _negative(a: Interval) -> Interval:
    return Interval(-a.high, -a.low)


def _multiply(a: Interval, b: Interval) -> Interval:
    if a.is_number or b.is_number:
        number, other = (a, b) if a.is_number else (b, a)
        ends = [number.low * other.low, number.low * other.high]
        if other.is_number:
            return _wider(ends[0], ends[0])
    else:
        ends = [x * y for x in a for y in b]
    low = high = ends[0]
    for end in ends[1:]:
        low, high = ca.fmin(low, end), ca.fmax(high, end)
    return _wider(low, high)


def _square(a: Interval) -> Interval:
    if a.is_number:
        return _multiply(a, a)
    p, q = ca.fabs(a.low), ca.fabs(a.high)
    nearest = ca.if_else(_holds_zero(a), 0.0, ca.fmin(p, q))
    farthest = ca.fmax(p, q)
    return _wider(nearest * nearest, farthest * farthest)


def _holds_zero(a: Interval) -> ca.SX:
    return ca.logic_and(a.low <= 0, a.high >= 0)


def _inverse(a: Interval) -> Interval:
    if a.is_number:
        return _wider(1 / a.low, 1 / a.low)
    found, crosses = _wider(1 / a.high, 1 / a.low), _holds_zero(a)
    return _unless(crosses, found)


def _unless(broken: ca.SX, found: Interval) -> Interval:
    """Everything where a function is broken within the interval."""
    return Interval(ca.if_else(broken, -ca.inf, found.low), ca.if_else(broken, ca.inf, found.high))


def _rising(function: Callable[[ca.SX], ca.SX]) -> Callable[[Interval], Interval]:
    """Bounds of a function that rises everywhere."""

    def bound(a: Interval) -> Interval:
        return _wider(function(a.low), function(a.high), _CURVED)

    return bound


def _root(a: Interval) -> Interval:
    return _wider(ca.sqrt(ca.fmax(a.low, 0)), ca.sqrt(a.high))


def _holds(a: Interval, turns: float) -> ca.SX:
    """Whether one of the angles that are this far beyond a whole number of turns is in it."""
    low, high = (end / (2 * math.pi) - turns for end in a)
    return ca.floor(high + 1e-9) >= ca.ceil(low - 1e-9)


def _tangent(a: Interval) -> Interval:
    broken = ca.logic_or(_holds(a, 0.25), _holds(a, -0.25))
    return _unless(broken, _rising(ca.tan)(a))


def _sine(a: Interval) -> Interval:
    # off relative to the result where that is small, because so is the angle
    off = [_CURVED * ca.fmin(ca.fabs(end), 1.0) for end in a]
    return _wave(ca.sin, 0.25, a, *off)


def _cosine(a: Interval) -> Interval:
    return _wave(ca.cos, 0.0, a, ca.SX(_CURVED), ca.SX(_CURVED))


def _wave(
    function: Callable[[ca.SX], ca.SX], top: float, a: Interval, at_low: ca.SX, at_high: ca.SX
) -> Interval:
    """Bounds of a sine whose largest value is so many turns from zero, off so far at the ends."""
    p, q = function(a.low), function(a.high)
    low = ca.fmin(p - at_low, q - at_high)
    high = ca.fmax(p + at_low, q + at_high)
    return Interval(
        ca.if_else(_holds(a, top + 0.5), -1.0, low),
        ca.if_else(_holds(a, top), 1.0, high),
    )


_OPERATIONS: dict[int, Callable[..., Interval]] = {
    ca.OP_ADD: _add,
    ca.OP_SUB: lambda a, b: _add(a, _negative(b)),
    ca.OP_NEG: _negative,
    ca.OP_MUL: _multiply,
    ca.OP_TWICE: lambda a: Interval(2 * a.low, 2 * a.high),
    ca.OP_SQ: _square,
    ca.OP_DIV: lambda a, b: _multiply(a, _inverse(b)),
    ca.OP_INV: _inverse,
    ca.OP_SQRT: _root,
    ca.OP_ATAN: _rising(ca.atan),
    ca.OP_TANH: _rising(ca.tanh),
    ca.OP_EXP: _rising(ca.exp),
    ca.OP_TAN: _tangent,
    ca.OP_SIN: _sine,
    ca.OP_COS: _cosine,
}
