"""C text of kernels that evaluate functions at many points: a model and its Jacobians, or bounds.

All results of a kernel share one graph. What each part of them needs is told by a set of parts; a
stretch of code belongs to one such set and runs if any part in it is asked for, so nothing is
computed, or written, twice.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import casadi as ca

from .graph import Graph
from .lanes import block, elementary, expression, guarded, literal, schedule, template
from .sums import read

#: Result -> the part of the results that it belongs to, a bit. The elements of the results are
#: numbered in this order, each by rows: f(n), fx(n, n), ..., as in ``jacobians``.
PARTS = {"f": 1, "fx": 2, "fu": 2, "fp": 4, "g": 8, "gx": 16, "gu": 16, "gp": 32}
#: Parts that are compiled only where they are asked for.
_BY_PARAMETERS = PARTS["fp"] | PARTS["gp"]
_LANES = 16
#: Statements in a loop: of more, a compiler makes slow code slowly.
_LONGEST = 200


@dataclass(frozen=True)
class Stretch:
    """Nodes computed in one loop over the lanes, and the parts of the results that need them."""

    parts: int
    nodes: tuple[int, ...]


def points_kernel(rhs: ca.Function, outputs: ca.Function) -> str:
    """The kernel of a model: rates, outputs and their Jacobians.

    Parameters
    ----------
    rhs, outputs : casadi.Function
        (x, u, p) -> xdot and (x, u, p) -> y.
    """
    arguments = rhs.sx_in()
    return _kernel(arguments, _results(rhs, outputs, arguments), PARTS)


def function_kernel(function: ca.Function) -> str:
    """The kernel of any function; every result of it is a part of its own."""
    arguments, names = function.sx_in(), function.name_out()
    results = dict(zip(names, function.call(arguments), strict=True))
    return _kernel(arguments, results, {name: 64 << k for k, name in enumerate(names)})


def _kernel(arguments: Sequence[ca.SX], results: Mapping[str, ca.SX], of: Mapping[str, int]) -> str:
    graph = Graph()
    sizes = [argument.numel() for argument in arguments]
    leaves = [
        [graph.leaf(str(sum(sizes[:k]) + j), varies=True) for j in range(size)]
        for k, size in enumerate(sizes)
    ]
    entries = ca.vertcat(*(result.nz[:] for result in results.values()))
    nodes = read(graph, ca.Function("results", arguments, [entries]), leaves)
    parts = [of[name] for name, result in results.items() for _ in range(result.nnz())]
    stretches = list(_stretches(graph, nodes, parts))
    rows = _Rows(graph, stretches, nodes, sum(sizes))
    functions = [_function(graph, k, stretch, rows) for k, stretch in enumerate(stretches)]
    bits = [of[name] for name in results]
    return template(
        "points.c",
        {
            "@LANES@": str(_LANES),
            "/* @ELEMENTARY@ */": elementary(),
            "/* @SIZES@ */": _sizes(results, bits, rows, sum(sizes), nodes),
            "/* @MODEL@ */": "\n".join([*functions, *_drivers(stretches, rows)]),
        },
    )


def _results(
    rhs: ca.Function, outputs: ca.Function, arguments: Sequence[ca.SX]
) -> dict[str, ca.SX]:
    """Rates, outputs and their Jacobians, by the names of `PARTS`."""
    found = {}
    for letter, function in (("f", rhs), ("g", outputs)):
        value = function(*arguments)
        x, u, p = arguments
        by_motion = ca.jacobian(value, ca.vertcat(x, u))
        found[letter] = value
        found[f"{letter}x"] = by_motion[:, : x.numel()]
        found[f"{letter}u"] = by_motion[:, x.numel() :]
        found[f"{letter}p"] = ca.jacobian(value, p)
    return dict(zip(found, ca.cse(list(found.values())), strict=True))


def _stretches(graph: Graph, nodes: Sequence[int], parts: Sequence[int]) -> Iterator[Stretch]:
    """Everything to be computed, in an order in which it can be.

    What a node reads is needed wherever the node is: by the same parts or by more.
    """
    needs = dict.fromkeys(graph.closure(nodes), 0)
    for node, part in zip(nodes, parts, strict=True):
        needs[node] |= part
    for node in sorted(needs, reverse=True):
        for a in graph.nodes[node].args:
            needs[a] |= needs[node]
    phase = schedule(graph, nodes).phase
    groups: dict[tuple[int, int, int], list[int]] = {}
    for node in sorted(phase):
        key = (-needs[node].bit_count(), needs[node], phase[node])
        groups.setdefault(key, []).append(node)
    for (_, part, _), members in sorted(groups.items()):
        for start in range(0, len(members), _LONGEST):
            yield Stretch(part, tuple(members[start : start + _LONGEST]))


class _Rows:
    """Where each value that outlives its loop stands; a row is used again when nobody reads it.

    Attributes
    ----------
    of : dict of int
        Node -> row; arguments come first.
    constants : dict of float
        Row -> number that stands there from the beginning.
    count : int
    """

    def __init__(
        self, graph: Graph, stretches: Sequence[Stretch], results: Sequence[int], n_in: int
    ) -> None:
        self.of: dict[int, int] = {}
        self.constants: dict[int, float] = {n_in: 0.0}
        self.count = n_in + 1
        for node, entry in enumerate(graph.nodes):
            if entry.op == "leaf":
                self.of[node] = int(entry.name)
        last = {a: k for k, s in enumerate(stretches) for n in s.nodes for a in graph.nodes[n].args}
        last |= dict.fromkeys(results, len(stretches))
        free: list[int] = []
        leaving: dict[int, list[int]] = {}
        for k, stretch in enumerate(stretches):
            for node in stretch.nodes:
                if last[node] > k:
                    self.of[node] = free.pop() if free else self._new()
                    leaving.setdefault(last[node], []).append(self.of[node])
            free += leaving.get(k, [])
        for node in results:
            if graph.nodes[node].op == "number":
                self.of[node] = self._constant(graph.nodes[node].number)

    def _new(self) -> int:
        self.count += 1
        return self.count - 1

    def _constant(self, number: float) -> int:
        for row, value in self.constants.items():
            if value == number:
                return row
        row = self._new()
        self.constants[row] = number
        return row


def _function(graph: Graph, index: int, stretch: Stretch, rows: _Rows) -> str:
    """``stretch<index>(w)``"""
    name = {n: f"W({row})" for n, row in rows.of.items()}
    lines = []
    for count, node in enumerate(stretch.nodes):
        text = expression(graph, node, name)
        if node in rows.of:
            lines.append(f"{name[node]} = {text};")
        else:
            name[node] = f"v{count}"
            lines.append(f"V({count}) {text};")
    text = "\n".join([f"APART void stretch{index}(lanes *restrict w)", "{ LANE_LOOP {", *lines])
    return _if_compiled(stretch, f"{text}\n}} }}\n")


def _if_compiled(stretch: Stretch, text: str) -> str:
    return text if stretch.parts & ~_BY_PARAMETERS else guarded("BY_PARAMETERS", text)


def _drivers(stretches: Sequence[Stretch], rows: _Rows) -> Iterator[str]:
    """``constants(w)`` and ``evaluate(w, asked)``."""
    fill = [f"LANE_LOOP W({row}) = {literal(value)};" for row, value in rows.constants.items()]
    yield block("static void constants(lanes *w)", fill)
    calls = []
    for k, stretch in enumerate(stretches):
        call = f"if (asked & {stretch.parts}) stretch{k}(w);\n"
        calls += _if_compiled(stretch, call).splitlines()
    yield block("static void evaluate(lanes *w, int asked)", calls)


def _sizes(
    results: Mapping[str, ca.SX],
    bits: Sequence[int],
    rows: _Rows,
    n_in: int,
    nodes: Sequence[int],
) -> str:
    """Numbers of rows and results, and where each element of them stands."""
    first, place, entries = [0], [], iter(nodes)
    for result in results.values():
        where = {}
        for position in zip(*result.sparsity().get_triplet(), strict=True):
            where[position] = rows.of[next(entries)]
        height, width = result.shape
        place += [where.get((i, j), n_in) for i in range(height) for j in range(width)]
        first.append(len(place))
    sizes = {"N_IN": n_in, "N_ROWS": rows.count, "N_RESULTS": len(results)}
    return "\n".join(
        [
            f"enum {{ {', '.join(f'{name} = {size}' for name, size in sizes.items())} }};",
            "/* Of each result its first element and its part; of each element its row. */",
            f"static const int32_t FIRST[] = {_table(first)};",
            f"static const int PART[] = {_table(bits)};",
            f"static const int16_t PLACE[] = {_table(place)};",
            "",
        ]
    )


def _table(values: Sequence[int]) -> str:
    return f"{{{','.join(map(str, values))}}}"
