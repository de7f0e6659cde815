"""Turn nodes of an expression graph into C statements for one lane.

A right-hand side with a chain of curves (atan of atan of sin) makes a loop too long for a
processor to overlap its lanes. `schedule` therefore cuts the chain into phases, each of which
becomes a short loop over the lanes; what passes from one to the next goes through scratch arrays.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from .graph import CURVES, Graph

_HERE = Path(__file__).parent
#: Runge-Kutta tableau and polynomials; see `coefficients`.
NUMBERS = json.loads((_HERE / "coefficients.json").read_text())

INFIX = {"add": "+", "sub": "-", "mul": "*", "div": "/"}
COMPARE = {"lt": "<", "le": "<=", "eq": "==", "ne": "!="}
#: Operations whose name in C is another one.
LANE_FUNCTION = {"fmin": "lane_min", "fmax": "lane_max"} | {
    name: f"lane_{name}" for name in ("sign", "hypot", *sorted(CURVES))
}


def literal(value: float) -> str:
    """A double as C text that reads back to the same bits."""
    if math.isnan(value):
        return "NAN"
    if math.isinf(value):
        return "INFINITY" if value > 0 else "-INFINITY"
    return repr(float(value))


# --- Statements -------------------------------------------------------------------------------


def expression(graph: Graph, node: int, name: dict[int, str]) -> str:
    """C expression of one operation on named values."""
    op, args = graph.nodes[node][:2]
    a = [operand(graph, i, name) for i in args]
    if op == "mul" and a[0] == "-1.0":
        return f"-{a[1]}"
    if op in INFIX:
        return f"{a[0]} {INFIX[op]} {a[1]}"
    if op in COMPARE:
        return f"{a[0]} {COMPARE[op]} {a[1]} ? 1.0 : 0.0"
    if op in ("and", "or"):
        return f"({a[0]} != 0.0) {'&' if op == 'and' else '|'} ({a[1]} != 0.0) ? 1.0 : 0.0"
    if op == "not":
        return f"{a[0]} == 0.0 ? 1.0 : 0.0"
    if op == "select":
        return f"{a[0]} != 0.0 ? {a[1]} : 0.0"
    if op == "choose":
        return f"{a[0]} != 0.0 ? {a[1]} : {a[2]}"
    return f"{LANE_FUNCTION.get(op, op)}({', '.join(a)})"


def operand(graph: Graph, node: int, name: dict[int, str]) -> str:
    """A named value, or a literal."""
    if graph.nodes[node].op == "number":
        text = literal(graph.nodes[node].number)
        return text if graph.nodes[node].number >= 0 or text == "-1.0" else f"({text})"
    return name[node]


def statements(
    graph: Graph, targets: Sequence[int], name: dict[int, str], prefix: str = "w"
) -> list[str]:
    """One declaration for every operation that the targets need and that has no name yet."""
    lines, stack = [], list(targets)
    needed: set[int] = set()
    while stack:
        node = stack.pop()
        if node not in needed and node not in name and graph.nodes[node].op != "number":
            needed.add(node)
            stack.extend(graph.nodes[node].args)
    for count, node in enumerate(sorted(needed)):
        lines.append(f"const double {prefix}{count} = {expression(graph, node, name)};")
        name[node] = f"{prefix}{count}"
    return lines


def block(head: str, body: Sequence[str]) -> str:
    """A C function."""
    return "\n".join([head, "{", *(f"    {line}" for line in body), "}", ""])


def loop_function(head: str, body: Sequence[str]) -> str:
    """A C function that does the same for all lanes."""
    return block(head, ["LANE_LOOP {", *(f"    {line}" for line in body), "}"])


def guarded(condition: str, text: str) -> str:
    """C that is compiled only under a condition."""
    return f"#if {condition}\n{text}#endif\n"


#: The name of a C parameter.
_NAME = re.compile(r"\*+(\w+)")

# --- Phases -----------------------------------------------------------------------------------


@dataclass(frozen=True)
class Schedule:
    """Phase of every node that changes in time, number of phases, and what passes between them."""

    phase: dict[int, int]
    count: int
    crossing: list[int]


def schedule(graph: Graph, targets: Sequence[int]) -> Schedule:
    """Begin a new phase wherever a curve follows another curve; leaves can be read in any."""
    links: dict[int, int] = {}
    phase: dict[int, int] = {}
    last: dict[int, int] = {}  # last phase in which a node is read
    for node in graph.closure(targets):
        if graph.varies[node] and graph.nodes[node].op != "leaf":
            args = [a for a in graph.nodes[node].args if a in phase]
            curve = graph.nodes[node].op in CURVES
            links[node] = max((links[a] for a in args), default=0) + curve
            phase[node] = max([*(phase[a] for a in args), links[node] - 1 if curve else 0])
            last |= {a: max(last.get(a, 0), phase[node]) for a in args}
    crossing = [node for node in sorted(last) if last[node] > phase[node]]
    return Schedule(phase, 1 + max(phase.values(), default=0), crossing)


class Described(Protocol):
    """A graph, and which of its nodes are found in ``c``."""

    @property
    def graph(self) -> Graph: ...
    @property
    def constants(self) -> Sequence[int]: ...


def phase_functions(
    part: str,
    name: str,
    described: Described,
    targets: Sequence[tuple[int, str]],
    arrays: Sequence[str],
    reading: Mapping[str, str],
) -> str:
    """A C function of all lanes that computes the targets, one loop for each phase.

    Parameters
    ----------
    part, name : str
        How the functions of one lane begin, and the name of the whole.
    described : Described
        The graph, and what in it is constant.
    targets : sequence of tuple
        Nodes, and the statements that put their values away.
    arrays : sequence of str
        Parameters of the functions.
    reading : mapping
        First letter of a leaf -> how its value is had, by its number.
    """
    graph = described.graph
    plan = schedule(graph, [node for node, _ in targets])
    known = {node: f"c[{k}][l]" for k, node in enumerate(described.constants)}
    scratch = {node: f"w[{k}][l]" for k, node in enumerate(plan.crossing)}
    parameters = ", ".join([*arrays, "lanes *w", "int l"])
    functions = []
    for step in range(plan.count):
        here = [node for node, phase in plan.phase.items() if phase == step]
        out = [(node, place) for node, place in targets if plan.phase.get(node, 0) == step]
        read = {a for n in here for a in graph.nodes[n].args} | {node for node, _ in out}
        leaves = [n for n in sorted(read) if graph.nodes[n].op == "leaf" and graph.varies[n]]
        local = known | {n: graph.nodes[n].name for n in leaves}
        body = []
        for leaf in (graph.nodes[n].name for n in leaves):
            body.append(f"const double {leaf} = {reading[leaf[0]].format(leaf[1:])};")
        body += statements(graph, here, local)
        body += [f"{scratch[n]} = {local[n]};" for n in plan.crossing if plan.phase[n] == step]
        body += [place.format(operand(graph, node, local)) for node, place in out]
        functions.append(block(f"INLINE void {part}{step}({parameters})", body))
        known |= {n: scratch[n] for n in plan.crossing if plan.phase[n] == step}
    call = ", ".join([*(_NAME.findall(array)[0] for array in arrays), "w", "l"])
    loops = [f"LANE_LOOP {part}{step}({call});" for step in range(plan.count)]
    room = f"lanes w[{max(1, len(plan.crossing))}];"
    functions.append(block(f"APART void {name}({', '.join(arrays)})", [room, *loops]))
    return "\n".join(functions)


# --- Polynomials ------------------------------------------------------------------------------


def even_odd(coefficients: Sequence[float]) -> str:
    """Polynomial in ``s`` as two interleaved Horner chains in ``s2 = s * s``."""

    def chain(part: Sequence[float]) -> str:
        text = literal(part[-1])
        for value in reversed(part[:-1]):
            text = f"({literal(value)} + s2 * {text})"
        return text

    return f"{chain(coefficients[0::2])} + s * {chain(coefficients[1::2])}"


def template(file: str, pieces: Mapping[str, str]) -> str:
    """Text of a C file of this folder with pieces put in for their marks."""
    text = (_HERE / file).read_text()
    for mark, piece in pieces.items():
        text = text.replace(mark, piece)
    return text


def elementary() -> str:
    """The elementary functions with their polynomials."""
    eighth, (high, middle, low) = NUMBERS["tan_pi_8"], NUMBERS["pi_parts"]
    values = {
        "@ATAN@": even_odd(NUMBERS["atan"]["coefficients"]),
        "@SIN@": even_odd(NUMBERS["sin"]["coefficients"]),
        "@EXP@": even_odd(NUMBERS["exp"]["coefficients"]),
        "@LOG@": even_odd(NUMBERS["log"]["coefficients"]),
        "@TAN_PI_8@": literal(eighth),
        "@COT_PI_8@": literal(1.0 / eighth),
        "@PI_HIGH@": literal(high),
        "@PI_MIDDLE@": literal(middle),
        "@PI_LOW@": literal(low),
        "@LN2_HIGH@": literal(NUMBERS["ln2_parts"][0]),
        "@LN2_LOW@": literal(NUMBERS["ln2_parts"][1]),
    }
    return template("elementary.c", values)
