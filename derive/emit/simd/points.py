"""C text of kernels that evaluate functions of vectors at many points.

Every value that passes from one loop over the lanes to the next stands in a row of a small table;
rows are used again when nobody reads them any more, so the table stays in the cache.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field

import casadi as ca

from .graph import Graph
from .lanes import block, elementary, expression, literal, schedule, template
from .sums import read

_LANES = 32
#: Statements in a loop: more make a compiler slow, fewer pass more from loop to loop.
_LONGEST = 400


def points_kernel(functions: Iterable[ca.Function]) -> str:
    """One C file with a kernel of the name of each function."""
    pieces = {
        "@LANES@": str(_LANES),
        "/* @ELEMENTARY@ */": elementary(),
        "/* @FUNCTIONS@ */": "\n".join(part for f in functions for part in _kernel(f)),
    }
    return template("points.c", pieces)


@dataclass
class _Rows:
    """Which row of the table each node stands in; row 0 holds zeros."""

    of: dict[int, int] = field(default_factory=dict)
    free: list[int] = field(default_factory=list)
    top: int = 1

    def take(self, node: int) -> int:
        """A row for a node."""
        self.of[node] = self.free.pop() if self.free else self.top
        self.top = max(self.top, self.of[node] + 1)
        return self.of[node]


def _kernel(function: ca.Function) -> Iterator[str]:
    name, results = function.name(), _results(function)
    graph, nodes, arguments = _read(function, results)
    parts = list(_parts(graph, nodes))
    rows = _Rows()
    for leaf in arguments:
        rows.take(leaf)
    for k, lines in enumerate(_loops(graph, nodes, parts, rows)):
        loop = ["LANE_LOOP {", *(f"    {line}" for line in lines), "}"]
        yield block(f"APART void {name}_{k}(lanes *restrict w)", loop)
    calls = [f"{name}_{k}(w);" for k in range(len(parts))]
    place, fixed = _places(graph, nodes, rows)
    fill = [f"LANE_LOOP w[{row}][l] = {literal(value)};" for row, value in fixed]
    yield block(f"static void {name}_run(lanes *restrict w)", [*calls, *fill])
    given = [graph.nodes[leaf].name for leaf in arguments]
    yield f"static const int16_t {name}_in[] = {_table(given)};"
    yield f"static const int16_t {name}_size[] = {_table([r.numel() for r in results])};"
    yield f"static const int16_t {name}_place[] = {_table(_dense(results, place))};"
    fields = f"{len(given)}, {len(results)}, {rows.top}, {name}_in, {name}_size, {name}_place"
    yield f"static const function_t {name}_f = {{ {fields}, {name}_run }};"
    yield f"SHOWN void {name}(const points_t *job) {{ all(&{name}_f, job); }}\n"


def _results(function: ca.Function) -> list[ca.SX]:
    results = function(*function.sx_in())
    return list(results) if isinstance(results, tuple) else [results]


def _read(function: ca.Function, results: Sequence[ca.SX]) -> tuple[Graph, list[int], list[int]]:
    """The graph, the node of every element that is not zero, and the arguments that are read."""
    stacked = ca.vertcat(*(result.nz[:] for result in results))
    flat = ca.Function(function.name(), function.sx_in(), [ca.densify(stacked)])
    graph, leaves, count = Graph(), [], 0
    for k in range(function.n_in()):
        size = function.numel_in(k)
        leaves.append([graph.leaf(str(count + i), varies=True) for i in range(size)])
        count += size
    nodes = read(graph, flat, leaves)
    used = set(graph.closure(nodes))
    return graph, nodes, [leaf for group in leaves for leaf in group if leaf in used]


def _parts(graph: Graph, nodes: Sequence[int]) -> Iterator[list[int]]:
    """The operations, phase by phase, in pieces that a compiler likes."""
    phases: dict[int, list[int]] = {}
    for node, phase in schedule(graph, nodes).phase.items():
        if graph.nodes[node].op not in ("leaf", "number"):
            phases.setdefault(phase, []).append(node)
    for _, members in sorted(phases.items()):
        for start in range(0, len(members), _LONGEST):
            yield members[start : start + _LONGEST]


def _loops(
    graph: Graph, nodes: Sequence[int], parts: Sequence[list[int]], rows: _Rows
) -> Iterator[list[str]]:
    """The statements of each loop; rows are taken and given back on the way."""
    last = {a: k for k, part in enumerate(parts) for n in part for a in graph.nodes[n].args}
    last |= dict.fromkeys(nodes, len(parts))
    for k, part in enumerate(parts):
        local: dict[int, str] = {}
        lines: list[str] = []
        for count, node in enumerate(part):
            for a in graph.nodes[node].args:
                if a in rows.of and a not in local:
                    local[a] = f"r{rows.of[a]}"
                    lines.append(f"const double {local[a]} = w[{rows.of[a]}][l];")
            lines.append(f"const double v{count} = {expression(graph, node, local)};")
            local[node] = f"v{count}"
        done = [node for node, end in last.items() if end == k and node in rows.of]
        crossing = [node for node in part if last.get(node, k) > k]
        lines += [f"w[{rows.take(node)}][l] = {local[node]};" for node in crossing]
        rows.free += [rows.of.pop(node) for node in done if graph.nodes[node].op != "leaf"]
        yield lines


def _places(
    graph: Graph, nodes: Sequence[int], rows: _Rows
) -> tuple[list[int], list[tuple[int, float]]]:
    """The row of each element of the results, and the rows that hold numbers."""
    numbers: dict[float, int] = {0.0: 0}
    place = []
    for node in nodes:
        value = graph.nodes[node].number
        if graph.nodes[node].op != "number":
            place.append(rows.of[node])
            continue
        if value not in numbers:
            numbers[value], rows.top = rows.top, rows.top + 1
        place.append(numbers[value])
    return place, [(row, value) for value, row in numbers.items() if row]


def _dense(results: Sequence[ca.SX], place: Sequence[int]) -> list[int]:
    """The row of each element of each result, row by row; row 0 where it is always zero."""
    found, dense = iter(place), []
    for result in results:
        where = {at: next(found) for at in zip(*result.sparsity().get_triplet(), strict=True)}
        height, width = result.shape
        dense += [where.get((i, j), 0) for i in range(height) for j in range(width)]
    return dense


def _table(values: Sequence[object]) -> str:
    return "{ " + ", ".join(map(str, values)) + " }"
