"""An expression graph that knows what is constant in time, and makes equal nodes one."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import NamedTuple

#: Functions that take long.
CURVES = {
    *("sin", "cos", "tan", "asin", "acos", "atan", "atan2"),
    *("sinh", "cosh", "tanh", "asinh", "acosh", "atanh"),
    *("exp", "log", "expm1", "log1p", "pow"),
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
    depths : list of int
        Most curves in a row on the way to each node, as far as they were asked for.
    """

    nodes: list[Node] = field(default_factory=list)
    varies: list[bool] = field(default_factory=list)
    index: dict[Node, int] = field(default_factory=dict)
    depths: list[int] = field(default_factory=list)

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

    def depth(self, node: int) -> int:
        """Most curves in a row on the way to a node."""
        while len(self.depths) <= node:
            op, args = self.nodes[len(self.depths)][:2]
            below = max((self.depths[a] for a in args), default=0)
            self.depths.append(below + (op in CURVES))
        return self.depths[node]

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
