"""Read CasADi SX functions into a graph.

The physics of a kernel comes from the list of SX instructions alone. Reading it does three
things that a compiler may not do without ``-ffast-math``, or cannot know:

- *level*: every node is constant over a trajectory (made of parameters and inputs only) or
  changes in time (made of states). The first kind is computed once per trajectory;
- *collecting*: a sum is carried along as constants times what changes, so ``x / u * a / b + x``
  costs one multiplication by the constant ``a / (u b) + 1``;
- *sharing*: equal expressions become one node, also across functions.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import casadi as ca

from .graph import Graph, Node

UNARY = {
    getattr(ca, f"OP_{name.upper()}"): name
    for name in (
        *("sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh"),
        *("asinh", "acosh", "atanh", "exp", "log", "expm1", "log1p"),
        *("sqrt", "fabs", "sign", "floor", "ceil", "not"),
    )
}
BINARY = {
    getattr(ca, f"OP_{name.upper()}"): name
    for name in (
        *("fmin", "fmax", "atan2", "hypot", "copysign"),
        *("lt", "le", "eq", "ne", "and", "or"),
    )
} | {ca.OP_IF_ELSE_ZERO: "select"}
#: Operations that have no emitted form, for the message.
_NAMES = {getattr(ca, name): name[3:].lower() for name in dir(ca) if name.startswith("OP_")}


class Scaled(NamedTuple):
    """``coefficient * base``; the coefficient is constant in time (``None``: one)."""

    coefficient: int | None
    base: int


class Sum(NamedTuple):
    """``scale * (terms + constant)``; only the bases of the terms change in time.

    One that has no terms has a constant, so that nothing is taken for one.
    """

    scale: int | None = None
    terms: tuple[Scaled, ...] = ()
    constant: int | None = None


def single(graph: Graph, node: int) -> Sum:
    """A node as a sum."""
    return Sum(terms=(Scaled(None, node),)) if graph.varies[node] else Sum(constant=node)


def added(graph: Graph, a: Sum, b: Sum) -> Sum:
    """Sum of two sums, equal bases collected."""
    coefficients: dict[int, int | None] = {}
    for part in (a, b):
        for coefficient, base in part.terms:
            mine = times(graph, part.scale, coefficient)
            if base in coefficients:
                mine = graph.apply("add", factor(graph, coefficients[base]), factor(graph, mine))
            coefficients[base] = mine
    terms = tuple(
        Scaled(None if is_number(graph, c, 1.0) else c, base)
        for base, c in coefficients.items()
        if not is_number(graph, c, 0.0)
    )
    constant = None
    for part in (a, b):
        if part.constant is not None:
            mine = factor(graph, times(graph, part.scale, part.constant))
            constant = mine if constant is None else graph.apply("add", constant, mine)
    return Sum(None, terms, graph.number(0.0) if constant is None and not terms else constant)


def factor(graph: Graph, coefficient: int | None) -> int:
    """The node of a coefficient."""
    return graph.number(1.0) if coefficient is None else coefficient


def is_number(graph: Graph, node: int | None, value: float) -> bool:
    """Whether a coefficient is this literal."""
    return node is not None and graph.nodes[node] == Node("number", number=value)


def scaled(graph: Graph, whole: Sum) -> Scaled:
    """A sum as a node and its scale; late terms last, so that the early ones can be added."""
    if not whole.terms:
        return Scaled(None, factor(graph, times(graph, whole.scale, whole.constant)))
    if len(whole.terms) == 1 and whole.constant is None:
        coefficient, base = whole.terms[0]
        return Scaled(times(graph, whole.scale, coefficient), base)
    first, *rest = sorted(whole.terms, key=lambda term: (graph.depth(term.base), term.base))
    node = product(graph, first)
    if whole.constant is not None:
        node = graph.apply("add", node, whole.constant)
    for term in rest:
        node = graph.apply("add", node, product(graph, term))
    return Scaled(whole.scale, node)


def product(graph: Graph, scaled: Scaled) -> int:
    """The node of a scaled value."""
    if scaled.coefficient is None:
        return scaled.base
    return graph.apply("mul", scaled.coefficient, scaled.base)


def plain(graph: Graph, whole: Sum) -> int:
    """The node of a sum."""
    return product(graph, scaled(graph, whole))


def times(graph: Graph, a: int | None, b: int | None) -> int | None:
    """Product of two coefficients."""
    if a is None or b is None:
        return b if a is None else a
    product = graph.apply("mul", a, b)
    return None if graph.nodes[product] == Node("number", number=1.0) else product


def multiply(graph: Graph, a: Sum, b: Sum) -> Sum:
    """Product; a factor constant in time goes into the scale."""
    for one, other in ((a, b), (b, a)):
        if not one.terms:
            scale = times(graph, plain(graph, one), other.scale)
            if not other.terms:
                return Sum(constant=factor(graph, times(graph, scale, other.constant)))
            return Sum(scale, other.terms, other.constant)
    x, y = scaled(graph, a), scaled(graph, b)
    product = Scaled(None, graph.apply("mul", x.base, y.base))
    return Sum(times(graph, x.coefficient, y.coefficient), (product,))


def divide(graph: Graph, a: Sum, b: Sum) -> Sum:
    """Quotient; only a divisor that changes in time is divided by in the time loop."""
    one = graph.number(1.0)
    if not b.terms:
        if not a.terms:
            return Sum(constant=graph.apply("div", plain(graph, a), plain(graph, b)))
        return multiply(graph, a, Sum(constant=graph.apply("div", one, plain(graph, b))))
    coefficient, base = scaled(graph, b)
    inner = None if coefficient is None else graph.apply("div", one, coefficient)
    # one reciprocal serves every quotient with this divisor
    ratio = Sum(inner, (Scaled(None, graph.apply("div", one, base)),))
    return multiply(graph, a, ratio)


def power(graph: Graph, base: Sum, exponent: Sum) -> Sum:
    """Power; small whole and half exponents become products and a square root."""
    node = graph.nodes[plain(graph, exponent)]
    if node.op != "number" or 2 * node.number != round(2 * node.number) or abs(node.number) > 16:
        return single(graph, graph.apply("pow", plain(graph, base), plain(graph, exponent)))
    whole, half = divmod(round(2 * abs(node.number)), 2)
    one = Sum(constant=graph.number(1.0))
    result = single(graph, graph.apply("sqrt", plain(graph, base))) if half else one
    square = base
    while whole:
        if whole & 1:
            result = multiply(graph, result, square)
        whole >>= 1
        square = multiply(graph, square, square) if whole else square
    return divide(graph, one, result) if node.number < 0 else result


def operate(graph: Graph, op: int, args: Sequence[Sum]) -> Sum:
    """One CasADi operation."""
    one, two, minus = (Sum(constant=graph.number(n)) for n in (1.0, 2.0, -1.0))
    if op == ca.OP_ADD:
        return added(graph, *args)
    if op == ca.OP_SUB:
        return added(graph, args[0], multiply(graph, minus, args[1]))
    if op == ca.OP_MUL:
        return multiply(graph, *args)
    if op == ca.OP_DIV:
        return divide(graph, *args)
    if op == ca.OP_NEG:
        return multiply(graph, minus, args[0])
    if op == ca.OP_TWICE:
        return multiply(graph, two, args[0])
    if op == ca.OP_SQ:
        return multiply(graph, args[0], args[0])
    if op == ca.OP_INV:
        return divide(graph, one, args[0])
    if op in (ca.OP_POW, ca.OP_CONSTPOW):
        return power(graph, *args)
    if op == ca.OP_ASSIGN:
        return args[0]
    if op not in UNARY | BINARY:
        known = ", ".join(sorted({*UNARY.values(), *BINARY.values()} - {"select"}))
        raise NotImplementedError(f"{_NAMES[op]} has no form in the kernels; there are {known}")
    return single(graph, graph.apply((UNARY | BINARY)[op], *(plain(graph, a) for a in args)))


def read(graph: Graph, function: ca.Function, leaves: Sequence[Sequence[int]]) -> list[int]:
    """Add a function's instructions.

    Parameters
    ----------
    function : casadi.Function
        With dense inputs and one dense output.
    leaves : sequence of sequences of int
        For every argument the nodes of its elements.

    Returns
    -------
    list of int
        The nodes of the output's elements.
    """
    if not function.is_a("SXFunction") or function.n_out() != 1:
        raise ValueError(f"{function.name()} must be an SX function with one output")
    for k in range(function.n_in()):
        if function.nnz_in(k) != len(leaves[k]) or not function.sparsity_in(k).is_dense():
            raise ValueError(
                f"argument {k} of {function.name()} must have {len(leaves[k])} elements"
            )
    if not function.sparsity_out(0).is_dense():
        function = densified(function)
    nothing = Sum(constant=graph.number(0.0))
    work = [nothing] * function.sz_w()
    result = [graph.number(0.0)] * function.nnz_out(0)
    uses = reads(function)
    for k in range(function.n_instructions()):
        op, source = function.instruction_id(k), function.instruction_input(k)
        target = function.instruction_output(k)
        if op == ca.OP_OUTPUT:
            result[target[1]] = plain(graph, added(graph, work[source[0]], nothing))
        elif op == ca.OP_INPUT:
            work[target[0]] = single(graph, leaves[source[0]][source[1]])
        elif op == ca.OP_CONST:
            work[target[0]] = Sum(constant=graph.number(function.instruction_constant(k)))
        else:
            made = operate(graph, op, [work[s] for s in source])
            if uses[k] > 1 and made.terms:
                coefficient, base = scaled(graph, made)
                made = Sum(coefficient, (Scaled(None, base),))
            work[target[0]] = made
    return result


def reads(function: ca.Function) -> list[int]:
    """How often the result of each instruction is read."""
    count = [0] * function.n_instructions()
    made: dict[int, int] = {}
    for k in range(function.n_instructions()):
        op = function.instruction_id(k)
        if op not in (ca.OP_INPUT, ca.OP_CONST):
            for place in function.instruction_input(k):
                count[made[place]] += 1
        if op != ca.OP_OUTPUT:
            made[function.instruction_output(k)[0]] = k
    return count


def densified(function: ca.Function) -> ca.Function:
    """The same Function with structural zeros of its output filled in."""
    arguments = function.sx_in()
    return ca.Function(function.name(), arguments, [ca.densify(function(*arguments))])
