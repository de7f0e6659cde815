"""Python source of CasADi functions, printed from chains of equations."""

from __future__ import annotations

import json
import textwrap
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import ClassVar

import sympy as sp
from sympy.logic.boolalg import Boolean
from sympy.printing.codeprinter import CodePrinter

from groundroll.derive.core.equation import Chain, Equation, needed
from groundroll.derive.core.quantity import Quantity


class CasadiPrinter(CodePrinter):  # type: ignore[misc]
    """Prints an expression as CasADi operations; anything not listed here is an error.

    SymPy's own `lambdify` falls back to `math` in silence, where a CasADi symbol becomes NaN.
    """

    printmethod = "_casadi"
    language = "Python"
    _operations: ClassVar[dict[str, str]] = {
        **{
            name: f"ca.{name}"
            for name in (
                *("sin", "cos", "tan", "asin", "acos", "atan", "atan2"),
                *("sinh", "cosh", "tanh", "exp", "log", "sign"),
            )
        },
        "Abs": "ca.fabs",
        "Max": "ca.fmax",
        "Min": "ca.fmin",
    }
    _logic: ClassVar[dict[str, str]] = {
        "And": "ca.logic_and",
        "Or": "ca.logic_or",
        "Not": "ca.logic_not",
    }

    def __init__(self) -> None:
        super().__init__()

    def _format_code(self, lines: list[str]) -> list[str]:
        return lines

    def _print_Function(self, expr: sp.Function) -> str:
        return self._call(self._operation(expr), expr.args)

    def _print_Max(self, expr: sp.Max | sp.Min) -> str:
        operation = self._operation(expr)  # of two arguments at a time, in a stable order
        first, *rest = sorted(expr.args, key=sp.default_sort_key)
        text: str = self._print(first)
        for argument in rest:
            text = f"{operation}({text}, {self._print(argument)})"
        return text

    _print_Min = _print_Max

    def _print_Piecewise(self, expr: sp.Piecewise) -> str:
        *branches, (last, certain) = expr.args
        if certain != sp.true:
            raise NotImplementedError(f"{expr} has no otherwise-branch")
        text: str = "ca.SX.nan()" if last is sp.nan else self._print(last)
        for value, condition in reversed(branches):
            text = f"ca.if_else({self._condition(condition)}, {self._print(value)}, {text})"
        return text

    def _condition(self, condition: sp.Basic) -> str:
        if condition.is_Relational:
            return f"{self._print(condition.lhs)} {condition.rel_op} {self._print(condition.rhs)}"
        name = condition.func.__name__
        if name not in self._logic:
            raise NotImplementedError(f"{condition} is no comparison of two numbers")
        first, *rest = map(self._condition, sorted(condition.args, key=sp.default_sort_key))
        text = first if rest else f"ca.logic_not({first})"
        for other in rest:
            text = f"{self._logic[name]}({text}, {other})"
        return text

    def _print_Pow(self, expr: sp.Pow, rational: bool = False) -> str:
        if expr.exp == sp.Rational(1, 2):
            return self._call("ca.sqrt", [expr.base])
        if expr.exp == sp.Rational(-1, 2):
            return f"1/{self._call('ca.sqrt', [expr.base])}"
        if not expr.exp.is_Integer:
            raise NotImplementedError(f"{expr}: only whole powers and square roots are emitted")
        base = self.parenthesize(expr.base, sp.printing.precedence.PRECEDENCE["Pow"])
        if expr.exp < 0:
            return f"1/{base}" if expr.exp == -1 else f"1/{base}**{-expr.exp}"
        return f"{base}**{expr.exp}"

    def _print_Rational(self, expr: sp.Rational) -> str:
        return f"{expr.p}/{expr.q}"

    def emptyPrinter(self, expr: object) -> str:
        raise NotImplementedError(f"{type(expr).__name__} has no CasADi operation: {expr}")

    # SymPy would print these in its own way
    _print_Pi = _print_Exp1 = _print_ImaginaryUnit = _print_Sum = emptyPrinter

    def _operation(self, expr: sp.Function) -> str:
        name = expr.func.__name__
        if name not in self._operations:
            allowed = ", ".join(sorted(self._operations))
            raise NotImplementedError(f"{name} has no CasADi operation; there are {allowed}")
        return self._operations[name]

    def _call(self, function: str, arguments: Sequence[sp.Expr]) -> str:
        return f"{function}({', '.join(map(self._print, arguments))})"


@dataclass(frozen=True)
class Argument:
    """An input of a generated function: one scalar, or several packed into a column vector."""

    name: str
    quantities: tuple[Quantity, ...]

    @classmethod
    def scalar(cls, quantity: Quantity) -> Argument:
        """An argument that is a quantity by itself."""
        return cls(quantity.name, (quantity,))

    @property
    def is_scalar(self) -> bool:
        """Whether the argument is the quantity itself."""
        return len(self.quantities) == 1 and self.name == self.quantities[0].name


@dataclass(frozen=True)
class Result:
    """An output of a generated function: a matrix with the meaning of its rows and columns."""

    name: str
    value: sp.Matrix
    meaning: str


@dataclass(frozen=True)
class FunctionSpec:
    """A CasADi function to generate.

    Attributes
    ----------
    name : str
        Name of the Python builder.
    casadi_name : str
        Name of the CasADi function, unique in the project and in C.
    summary : str
        One line for people.
    arguments, results : tuple
        Inputs and outputs, in order.
    chain : tuple of Equation
        What the results are computed through.
    """

    name: str
    casadi_name: str
    summary: str
    arguments: tuple[Argument, ...]
    results: tuple[Result, ...]
    chain: Chain

    def source(self) -> str:
        """Python source of the builder."""
        return "\n".join(["@cache", f"def {self.name}() -> ca.Function:", *_indented(self._body())])

    def _body(self) -> Iterator[str]:
        chain = needed(cancel_tangents(self.chain), [x for r in self.results for x in r.value])
        yield from self._docstring(chain)
        for argument in self.arguments:
            yield from _unpack(argument)
        printer = CasadiPrinter()
        for line in _with_temporaries(chain):
            comment = f"  # {line.source}" if line.source else ""
            yield f"{line.lhs} = {printer.doprint(line.rhs)}{comment}"
        for result in self.results:
            if not _is_name(result.value):
                yield f"{result.name}_ = {_matrix(result.value, printer)}"
        values = (r.value[0].name if _is_name(r.value) else f"{r.name}_" for r in self.results)
        yield "return ca.Function("
        yield f'    "{self.casadi_name}",'
        yield f"    [{', '.join(_variable(arg) for arg in self.arguments)}],"
        yield f"    [{', '.join(values)}],"
        yield f"    {json.dumps([arg.name for arg in self.arguments])},"
        yield f"    {json.dumps([result.name for result in self.results])},"
        yield ")"

    def _docstring(self, chain: Chain) -> Iterator[str]:
        yield f'"""{self.summary}'
        yield ""
        yield "Inputs"
        yield "------"
        for argument in self.arguments:
            if argument.is_scalar:
                q = argument.quantities[0]
                yield f"{q} : scalar [{q.unit}], {q.meaning}"
            else:
                yield f"{argument.name} : column of {len(argument.quantities)}"
                yield from _wrapped(f"{q} [{q.unit}]" for q in argument.quantities)
        yield ""
        yield "Outputs"
        yield "-------"
        for result in self.results:
            rows, columns = result.value.shape
            yield f"{result.name} : {rows} x {columns}, {result.meaning}"
        if sources := _printed_equations(chain):
            yield ""
            yield "Thesis"
            yield "------"
            yield from _wrapped(sources, indent="")
        yield '"""'


def cancel_tangents(chain: Chain) -> Chain:
    """Write tan(angle) with the ratio whose arctangent the angle is.

    The slip angle's atan and the tire chain's tan cancel; what is left is cheaper and exact.
    """
    ratios = {sp.tan(e.lhs): sp.tan(e.rhs) for e in chain if isinstance(e.rhs, sp.atan)}
    return tuple(Equation(e.lhs, e.rhs.xreplace(ratios), e.source) for e in chain)


@dataclass(frozen=True)
class _Line:
    lhs: sp.Symbol
    rhs: sp.Expr
    source: str = ""


def _with_temporaries(chain: Chain) -> Iterator[_Line]:
    """The chain, with a temporary before the first use of whatever repeats inside it."""
    names = (sp.Symbol(f"w{n}") for n in range(1, 1000))
    repeated, expressions = sp.cse([e.rhs for e in chain], symbols=names, order="canonical")
    pending, trivial = _split_trivial(repeated)
    expressions = [expr.xreplace(trivial) for expr in expressions]

    def wanted_by(expr: sp.Expr) -> Iterator[_Line]:
        for symbol in sorted(expr.free_symbols & pending.keys(), key=lambda s: int(s.name[1:])):
            if symbol in pending:
                definition = pending.pop(symbol)
                yield from wanted_by(definition)
                yield _Line(symbol, definition)

    for equation, expr in zip(chain, expressions, strict=True):
        yield from wanted_by(expr)
        yield _Line(equation.lhs, expr, equation.source)


def _split_trivial(
    repeated: Sequence[tuple[sp.Symbol, sp.Expr]],
) -> tuple[dict[sp.Symbol, sp.Expr], dict[sp.Symbol, sp.Expr]]:
    """Temporaries worth a name, and those (1/u, B1**2, conditions) that read better in place."""
    kept: dict[sp.Symbol, sp.Expr] = {}
    trivial: dict[sp.Symbol, sp.Expr] = {}
    for symbol, expr in repeated:
        definition = expr.xreplace(trivial)
        is_worth_it = definition.count_ops() > 1 and not isinstance(definition, Boolean)
        (kept if is_worth_it else trivial)[symbol] = definition
    return kept, trivial


def _is_name(value: sp.Matrix) -> bool:
    return value.shape == (1, 1) and bool(value[0].is_Symbol)


def _wrapped(items: Iterable[str], indent: str = "    ") -> list[str]:
    text = ", ".join(items)
    return textwrap.wrap(text, 88, initial_indent=indent, subsequent_indent=indent)


def _variable(argument: Argument) -> str:
    # `u` is the forward speed: the packed vectors get a trailing underscore
    return argument.name if argument.is_scalar else f"{argument.name}_"


def _unpack(argument: Argument) -> Iterator[str]:
    variable, size = _variable(argument), len(argument.quantities)
    if argument.is_scalar:
        yield f'{variable} = ca.SX.sym("{argument.name}")'
        return
    yield f'{variable} = ca.SX.sym("{argument.name}", {size})'
    names = ", ".join(map(str, argument.quantities))
    yield f"{names}{',' if size == 1 else ''} = ca.vertsplit({variable})"


def _matrix(value: sp.Matrix, printer: CasadiPrinter) -> str:
    rows, columns = value.shape
    if rows == columns == 1:
        return str(printer.doprint(value[0]))
    if columns == 1:
        return f"ca.vertcat({', '.join(printer.doprint(x) for x in value)})"
    lines = [f"[{', '.join(printer.doprint(x) for x in value.row(i))}]" for i in range(rows)]
    return f"ca.blockcat([\n    {f',{chr(10)}    '.join(lines)},\n])"


def _printed_equations(chain: Chain) -> list[str]:
    sources = [e.source for e in chain if e.source.startswith(("Eq.", "App.", "Fig."))]
    return list(dict.fromkeys(sources))


def _indented(lines: Iterator[str]) -> Iterator[str]:
    for line in lines:
        for part in line.split("\n"):
            yield f"    {part}" if part else ""
