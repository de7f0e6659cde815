"""An expression graph, read from CasADi SX functions, that knows what is constant in time.

The physics of a kernel comes from the list of SX instructions alone. Reading it does three
things that a compiler may not do without ``-ffast-math``, or cannot know:

- *level*: every node is constant over a trajectory (made of parameters and inputs only) or
  changes in time (made of states). The first kind is computed once per trajectory;
- *scaling*: a product with, or a division by, something constant is carried along as a
  coefficient, so ``x / u * a / b`` costs one multiplication by the constant ``a / (u b)``;
- *sharing*: equal expressions become one node, also across functions.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import casadi as ca

UNARY = {
    ca.OP_SQRT: "sqrt",
    ca.OP_SIN: "sin",
    ca.OP_COS: "cos",
    ca.OP_TAN: "tan",
    ca.OP_ATAN: "atan",
    ca.OP_EXP: "exp",
    ca.OP_LOG: "log",
    ca.OP_FABS: "fabs",
    ca.OP_SIGN: "sign",
    ca.OP_NOT: "not",
    ca.OP_TANH: "tanh",
    ca.OP_ASIN: "asin",
    ca.OP_ACOS: "acos",
}
BINARY = {
    ca.OP_FMIN: "fmin",
    ca.OP_FMAX: "fmax",
    ca.OP_LT: "lt",
    ca.OP_LE: "le",
    ca.OP_EQ: "eq",
    ca.OP_NE: "ne",
    ca.OP_AND: "and",
    ca.OP_OR: "or",
    ca.OP_IF_ELSE_ZERO: "select",
    ca.OP_ATAN2: "atan2",
}
FOLD: dict[str, Callable[[float, float], float]] = {
    "add": lambda a, b: a + b,
    "sub": lambda a, b: a - b,
    "mul": lambda a, b: a * b,
    "div": lambda a, b: a / b if b else math.nan,
}


class Node(NamedTuple):
    """One value: an operation on earlier nodes, a ``leaf`` with a name, or a ``number``."""

    op: str
    args: tuple[int, ...] = ()
    name: str = ""
    number: float = 0.0


class Scaled(NamedTuple):
    """``coefficient * base``; the coefficient is constant in time (``None``: one)."""

    coefficient: int | None
    base: int


@dataclass
class Graph:
    """Nodes in an order in which they can be computed, each once.

    Attributes
    ----------
    nodes : list of Node
    varies : list of bool
        For each node whether it changes in time.
    index : dict
        Where each node is in the list.
    """

    nodes: list[Node] = field(default_factory=list)
    varies: list[bool] = field(default_factory=list)
    index: dict[Node, int] = field(default_factory=dict)

    def add(self, node: Node, varies: bool) -> int:
        """Index of an equal node, made if there is none."""
        if node not in self.index:
            self.index[node] = len(self.nodes)
            self.nodes.append(node)
            self.varies.append(varies)
        return self.index[node]

    def leaf(self, name: str, varies: bool) -> int:
        """A state, input or parameter, by the C expression that reads it."""
        return self.add(Node("leaf", name=name), varies)

    def number(self, value: float) -> int:
        """A literal."""
        return self.add(Node("number", number=float(value)), False)

    def apply(self, op: str, *args: int) -> int:
        """An operation; arithmetic on literals and with neutral elements is done here."""
        values = [self.nodes[a].number if self.nodes[a].op == "number" else None for a in args]
        if op in FOLD and len(known := [v for v in values if v is not None]) == len(args):
            return self.number(FOLD[op](*known))
        if op == "tan" and self.nodes[args[0]].op == "atan":
            return self.nodes[args[0]].args[0]
        if (op in ("add", "sub") and values[1] == 0) or (op in ("mul", "div") and values[1] == 1):
            return args[0]
        if (op == "add" and values[0] == 0) or (op == "mul" and values[0] == 1):
            return args[1]
        if op == "add" and (choice := self.choice(*args)):
            op, args = "choose", choice
        return self.add(Node(op, args), any(self.varies[a] for a in args))

    def choice(self, a: int, b: int) -> tuple[int, int, int] | None:
        """``(condition, yes, no)`` if ``a + b`` is how CasADi spells ``if_else``."""
        first, second = self.nodes[a], self.nodes[b]
        if first.op != "select" or second.op != "select":
            return None
        if self.nodes[second.args[0]] == Node("not", (first.args[0],)):
            return first.args[0], first.args[1], second.args[1]
        return None

    # --- Scaled values: what the instruction list works on ---
    def plain(self, scaled: Scaled) -> int:
        """The node of a scaled value."""
        if scaled.coefficient is None:
            return scaled.base
        return self.apply("mul", scaled.coefficient, scaled.base)

    def times(self, a: int | None, b: int | None) -> int | None:
        """Product of two coefficients."""
        if a is None or b is None:
            return b if a is None else a
        product = self.apply("mul", a, b)
        return None if self.nodes[product] == Node("number", number=1.0) else product

    def multiply(self, a: Scaled, b: Scaled) -> Scaled:
        """Product; a factor constant in time goes into the coefficient."""
        if not self.varies[a.base] and not self.varies[b.base]:
            return Scaled(None, self.apply("mul", self.plain(a), self.plain(b)))
        if not self.varies[a.base]:
            return Scaled(self.times(self.plain(a), b.coefficient), b.base)
        if not self.varies[b.base]:
            return Scaled(self.times(a.coefficient, self.plain(b)), a.base)
        return Scaled(self.times(a.coefficient, b.coefficient), self.apply("mul", a.base, b.base))

    def divide(self, a: Scaled, b: Scaled) -> Scaled:
        """Quotient; only a divisor that changes in time is divided by in the time loop."""
        if not self.varies[a.base] and not self.varies[b.base]:
            return Scaled(None, self.apply("div", self.plain(a), self.plain(b)))
        one = self.number(1.0)
        if not self.varies[b.base]:
            return self.multiply(a, Scaled(None, self.apply("div", one, self.plain(b))))
        ratio = Scaled(None, self.apply("div", one if not self.varies[a.base] else a.base, b.base))
        outer = a.coefficient if self.varies[a.base] else self.plain(a)
        inner = None if b.coefficient is None else self.apply("div", one, b.coefficient)
        return Scaled(self.times(outer, inner), ratio.base)

    def power(self, base: Scaled, exponent: Scaled) -> Scaled:
        """Power; small whole and half exponents become products and a square root."""
        node = self.nodes[self.plain(exponent)]
        if (
            node.op != "number"
            or 2 * node.number != round(2 * node.number)
            or abs(node.number) > 16
        ):
            return Scaled(None, self.apply("pow", self.plain(base), self.plain(exponent)))
        whole, half = divmod(round(2 * abs(node.number)), 2)
        result = Scaled(None, self.apply("sqrt", self.plain(base)) if half else self.number(1.0))
        square = base
        while whole:
            if whole & 1:
                result = self.multiply(result, square)
            whole >>= 1
            square = self.multiply(square, square) if whole else square
        return self.divide(Scaled(None, self.number(1.0)), result) if node.number < 0 else result

    def operate(self, op: int, args: Sequence[Scaled]) -> Scaled:
        """One CasADi operation."""
        minus = Scaled(None, self.number(-1.0))
        if op in (ca.OP_ADD, ca.OP_SUB):
            name = "add" if op == ca.OP_ADD else "sub"
            return Scaled(None, self.apply(name, *map(self.plain, args)))
        if op == ca.OP_MUL:
            return self.multiply(*args)
        if op == ca.OP_DIV:
            return self.divide(*args)
        if op == ca.OP_NEG:
            return self.multiply(minus, args[0])
        if op == ca.OP_TWICE:
            return self.multiply(Scaled(None, self.number(2.0)), args[0])
        if op == ca.OP_SQ:
            return self.multiply(args[0], args[0])
        if op == ca.OP_INV:
            return self.divide(Scaled(None, self.number(1.0)), args[0])
        if op in (ca.OP_POW, ca.OP_CONSTPOW):
            return self.power(*args)
        if op == ca.OP_ASSIGN:
            return args[0]
        if op not in UNARY | BINARY:
            raise NotImplementedError(f"CasADi operation {op} has no emitted form")
        return Scaled(None, self.apply((UNARY | BINARY)[op], *map(self.plain, args)))

    def read(self, function: ca.Function, leaves: Sequence[Sequence[int]]) -> list[int]:
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
        work = [Scaled(None, self.number(0.0))] * function.sz_w()
        result = [self.number(0.0)] * function.nnz_out(0)
        for k in range(function.n_instructions()):
            op, source = function.instruction_id(k), function.instruction_input(k)
            target = function.instruction_output(k)
            if op == ca.OP_OUTPUT:
                result[target[1]] = self.plain(work[source[0]])
            elif op == ca.OP_INPUT:
                work[target[0]] = Scaled(None, leaves[source[0]][source[1]])
            elif op == ca.OP_CONST:
                work[target[0]] = Scaled(None, self.number(function.instruction_constant(k)))
            else:
                work[target[0]] = self.operate(op, [work[s] for s in source])
        return result

    # --- What depends on what ---
    def closure(self, targets: Iterable[int]) -> list[int]:
        """Nodes needed for the targets, in an order in which they can be computed."""
        needed, stack = set(), list(targets)
        while stack:
            node = stack.pop()
            if node not in needed:
                needed.add(node)
                stack.extend(self.nodes[node].args)
        return sorted(needed)

    def hoisted(self, targets: Iterable[int]) -> list[int]:
        """Nodes constant in time that nodes changing in time (or the targets) read; no literals."""
        targets = list(targets)
        changing = [n for n in self.closure(targets) if self.varies[n]]
        read = {a for n in changing for a in self.nodes[n].args} | set(targets)
        return sorted(n for n in read if not self.varies[n] and self.nodes[n].op != "number")


def densified(function: ca.Function) -> ca.Function:
    """The same Function with structural zeros of its output filled in."""
    arguments = function.sx_in()
    return ca.Function(function.name(), arguments, [ca.densify(function(*arguments))])
