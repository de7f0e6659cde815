"""A CasADi function as a list of operations, and their text in C and in JavaScript.

Other languages get their physics from here alone: from the instructions of a pack's functions.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import casadi as ca

from groundroll.base.errors import GroundrollError

#: A number, the text by which an argument is read, or the index of an operation.
Value = float | str | int


class Operation(NamedTuple):
    """An operation of CasADi on values."""

    code: int
    values: tuple[Value, ...]


@dataclass(frozen=True)
class Program:
    """Operations, each on what comes before it, and the values of each result."""

    operations: tuple[Operation, ...]
    results: tuple[tuple[Value, ...], ...]


@dataclass(frozen=True)
class Language:
    """How operations are written.

    Attributes
    ----------
    forms : mapping of int to str
        For each operation of CasADi its text, in which {0} and {1} are the values.
    statement : str
        A declaration of {name} as {text}.
    number : callable
        Text of a literal.
    """

    forms: Mapping[int, str]
    statement: str
    number: Callable[[float], str]


def read(
    arguments: Sequence[ca.SX], results: Sequence[ca.SX], texts: Sequence[Sequence[str]]
) -> Program:
    """The operations that lead from arguments to results.

    Parameters
    ----------
    arguments, results : sequence of casadi.SX
    texts : sequence of sequence of str
        For each argument the texts by which its elements are read.
    """
    shared = ca.cse([ca.densify(result) for result in results])
    function = ca.Function("program", list(arguments), shared)
    work: dict[int, Value] = {}
    found: dict[Operation, int] = {}
    made: list[list[Value]] = [[0.0] * function.numel_out(k) for k in range(function.n_out())]
    for k in range(function.n_instructions()):
        code, taken, put = _instruction(function, k)
        if code == ca.OP_OUTPUT:
            made[put[0]][put[1]] = work[taken[0]]
        elif code == ca.OP_INPUT:
            work[put[0]] = texts[taken[0]][taken[1]]
        elif code == ca.OP_CONST:
            work[put[0]] = float(function.instruction_constant(k))
        else:
            operation = Operation(code, tuple(work[i] for i in taken))
            work[put[0]] = found.setdefault(operation, len(found))
    return Program(tuple(found), tuple(map(tuple, made)))


def _instruction(function: ca.Function, k: int) -> tuple[int, list[int], list[int]]:
    taken, put = function.instruction_input(k), function.instruction_output(k)
    return function.instruction_id(k), taken, put


def statements(program: Program, language: Language, prefix: str = "w") -> Iterator[str]:
    """One declaration for each operation."""
    for k, (code, values) in enumerate(program.operations):
        if code not in language.forms:
            raise GroundrollError(
                f"the model uses operation {code} of CasADi, which cannot be exported"
            )
        text = language.forms[code].format(*(written(v, language, prefix) for v in values))
        yield language.statement.format(name=f"{prefix}{k}", text=text)


def written(value: Value, language: Language, prefix: str = "w") -> str:
    """Text of a value."""
    if isinstance(value, float):
        return language.number(value)
    return value if isinstance(value, str) else f"{prefix}{value}"


def _forms(function: str, others: Mapping[int, str]) -> dict[int, str]:
    """Forms of a language in which a mathematical function is called as `function` says."""
    return {
        **{code: function.format(name) + "({0})" for code, name in _UNARY.items()},
        **{code: function.format(name) + "({0}, {1})" for code, name in _BINARY.items()},
        **_OPERATORS,
        **others,
    }


#: Operations that are written alike in both languages.
_OPERATORS = {
    ca.OP_ASSIGN: "{0}",
    ca.OP_ADD: "{0} + {1}",
    ca.OP_SUB: "{0} - {1}",
    ca.OP_MUL: "{0} * {1}",
    ca.OP_DIV: "{0} / {1}",
    ca.OP_NEG: "-{0}",
    ca.OP_TWICE: "{0} + {0}",
    ca.OP_SQ: "{0} * {0}",
    ca.OP_INV: "1 / {0}",
    ca.OP_LT: "{0} < {1} ? 1 : 0",
    ca.OP_LE: "{0} <= {1} ? 1 : 0",
    ca.OP_NOT: "{0} ? 0 : 1",
    ca.OP_AND: "{0} && {1} ? 1 : 0",
    ca.OP_OR: "{0} || {1} ? 1 : 0",
    ca.OP_IF_ELSE_ZERO: "{0} ? {1} : 0",
    ca.OP_SIGN: "{0} < 0 ? -1 : {0} > 0 ? 1 : {0}",
    ca.OP_LIFT: "{0}",
}
_UNARY = {
    **{getattr(ca, f"OP_{name.upper()}"): name for name in ("sqrt", "exp", "log", "floor", "ceil")},
    **{getattr(ca, f"OP_{name.upper()}"): name for name in ("sin", "cos", "tan", "log1p", "expm1")},
    **{getattr(ca, f"OP_A{name.upper()}"): f"a{name}" for name in ("sin", "cos", "tan")},
    **{getattr(ca, f"OP_{name.upper()}"): name for name in ("sinh", "cosh", "tanh")},
    **{getattr(ca, f"OP_A{name.upper()}"): f"a{name}" for name in ("sinh", "cosh", "tanh")},
}
_BINARY = {
    ca.OP_POW: "pow",
    ca.OP_CONSTPOW: "pow",
    ca.OP_ATAN2: "atan2",
    ca.OP_HYPOT: "hypot",
}


def _literal(nan: str, infinity: str, finite: str) -> Callable[[float], str]:
    def text(value: float) -> str:
        if math.isnan(value):
            return nan
        if math.isinf(value):
            return infinity if value > 0 else f"(-{infinity})"
        number = repr(value).removesuffix(".0")
        return finite.format(f"({number})" if number.startswith("-") else number)

    return text


#: C99; F(sin) is the function of the type that is used, R(0.5) a literal of it.
C = Language(
    _forms(
        "F({})",
        {
            ca.OP_EQ: "{0} == {1} ? 1 : 0",
            ca.OP_NE: "{0} != {1} ? 1 : 0",
            ca.OP_FABS: "F(fabs)({0})",
            ca.OP_FMIN: "F(fmin)({0}, {1})",
            ca.OP_FMAX: "F(fmax)({0}, {1})",
            ca.OP_FMOD: "F(fmod)({0}, {1})",
            ca.OP_COPYSIGN: "F(copysign)({0}, {1})",
            ca.OP_ERF: "F(erf)({0})",
        },
    ),
    "const real {name} = {text};",
    _literal("R(NAN)", "R(INFINITY)", "R({})"),
)
#: JavaScript, in which the names of Math are at hand.
JAVASCRIPT = Language(
    _forms(
        "{}",
        {
            ca.OP_EQ: "{0} === {1} ? 1 : 0",
            ca.OP_NE: "{0} !== {1} ? 1 : 0",
            ca.OP_FABS: "abs({0})",
            ca.OP_FMIN: "min({0}, {1})",
            ca.OP_FMAX: "max({0}, {1})",
            ca.OP_FMOD: "{0} % {1}",
        },
    ),
    "const {name} = {text};",
    _literal("NaN", "Infinity", "{}"),
)


def names(symbol: str, count: int) -> list[str]:
    """The elements of an array."""
    return [f"{symbol}[{k}]" for k in range(count)]
