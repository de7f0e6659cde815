"""C text of a kernel that integrates many trajectories of an SX model side by side.

Three things are joined: the model, read from CasADi's SX instructions (`graph`); the numbers of
``coefficients.json`` (Runge-Kutta tableau, polynomials); and the driver ``ensemble.c``, which is C
that knows no model. The text depends on nothing else.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca

from .graph import Graph
from .lanes import (
    NUMBERS,
    block,
    call_phases,
    elementary,
    literal,
    loop_function,
    operand,
    phase_functions,
    statements,
    template,
)

_TABLEAU = NUMBERS["dop853"]
_LAST, _DENSE_LAST = 12, 16  # stages of a step, and of a step with dense output


@dataclass(frozen=True)
class Kernel:
    """An emitted kernel.

    Attributes
    ----------
    text : str
        C source; compiled with ``-DLANES=1`` it is for single trajectories.
    states : tuple of int
        Which of the model's states it carries, in its order.
    """

    text: str
    states: tuple[int, ...]


@dataclass(frozen=True)
class _Model:
    """The nodes that a kernel computes; its states are in kernel order, dynamic ones first."""

    graph: Graph
    states: tuple[int, ...]
    dynamic: int
    rates: list[int]
    turns: list[int]
    outputs: list[int]
    constants: list[int]
    n_parameters: int


def ensemble_kernel(rhs: ca.Function, outputs: ca.Function, keep: Sequence[int]) -> Kernel:
    """The kernel of a model.

    Parameters
    ----------
    rhs, outputs : casadi.Function
        SX functions (x, u, p) -> xdot and (x, u, p) -> y; u and p are constant over a trajectory.
    keep : sequence of int
        States that are wanted; others are carried only if these or the outputs depend on them.
    """
    model = _read_model(rhs, outputs, keep)
    phases, counts, scratch = _rate_functions(model)
    sizes = {
        "NS": len(model.states),
        "ND": model.dynamic,
        "NP": model.n_parameters,
        "NC": max(1, len(model.constants)),
        "NW": scratch,
        "NY": len(model.outputs),
        "NY1": max(1, len(model.outputs)),
    }
    functions = (
        _constants_function(model),
        phases,
        _rates_function(model, counts),
        _attempt_function(model, counts),
        _dense_function(model, counts),
        _output_functions(model),
    )
    text = template(
        "ensemble.c",
        {
            "/* @ELEMENTARY@ */": elementary(),
            "/* @SIZES@ */": f"enum {{ {', '.join(f'{k} = {n}' for k, n in sizes.items())} }};",
            "/* @MODEL@ */": "\n".join(functions),
            "/* @BETWEEN@ */": template("between.c", {}),
        },
    )
    return Kernel(text, model.states)


# --- The model's nodes ----------------------------------------------------------------------


def _read_model(rhs: ca.Function, outputs: ca.Function, keep: Sequence[int]) -> _Model:
    """Read the functions and keep what the wanted states and the outputs need.

    A state on which no rate depends (a quadrature, such as a distance) needs no stage values;
    such states come last.
    """
    graph = Graph()
    n_states, n_inputs, n_parameters = (rhs.numel_in(k) for k in range(3))
    x = [graph.leaf(f"x{j}", varies=True) for j in range(n_states)]
    p = [graph.leaf(f"p{j}", varies=False) for j in range(n_inputs + n_parameters)]
    leaves = [x, p[:n_inputs], p[n_inputs:]]
    rates = graph.read(rhs, leaves)
    seen = graph.read(outputs, leaves)
    states = set(keep) | _states_read(graph, seen, x)
    while more := _states_read(graph, [rates[j] for j in states], x) - states:
        states |= more
    dynamic = _states_read(graph, [rates[j] for j in states], x)
    order = (*sorted(dynamic), *sorted(states - dynamic))
    kept = [rates[j] for j in order]
    moving = order[: len(dynamic)]
    mode = [
        graph.leaf(f"d{j}", varies=True) if j in moving else graph.number(0.0)
        for j in range(n_states)
    ]
    turned = graph.read(_directional(rhs), [*leaves, mode])
    turns = [turned[j] for j in moving]
    constants = graph.hoisted(kept + seen + turns)
    return _Model(graph, order, len(dynamic), kept, turns, seen, constants, len(p))


def _directional(rhs: ca.Function) -> ca.Function:
    """``(x, u, p, d) -> J d``, the derivative of the rates along a direction of the states."""
    x, u, p = rhs.sx_in()
    direction = ca.SX.sym("d", x.numel())
    turn = ca.densify(ca.jtimes(rhs(x, u, p), x, direction))
    return ca.Function("turn", [x, u, p, direction], [turn])


def _states_read(graph: Graph, targets: Sequence[int], x: Sequence[int]) -> set[int]:
    """Indices of the states on which the targets depend."""
    needed = set(graph.closure(targets))
    return {j for j, node in enumerate(x) if node in needed}


# --- Functions of the model -----------------------------------------------------------------


def _constants_function(model: _Model) -> str:
    """``constants(p, c)``: everything that does not change over a trajectory."""
    graph = model.graph
    name = {
        i: f"p[{node.name[1:]}][l]"
        for i, node in enumerate(graph.nodes)
        if node.op == "leaf" and not graph.varies[i]
    }
    body = statements(graph, model.constants, name)
    body += [f"c[{k}][l] = {name[node]};" for k, node in enumerate(model.constants)]
    return loop_function("static void constants(const lanes *p, lanes *c)", body)


def _lane_function(head: str, model: _Model, targets: Sequence[int], result: str) -> str:
    """An inline function of one lane: constants and states in, ``*f0, *f1, ...`` out."""
    graph = model.graph
    name = {node: f"c[{k}][l]" for k, node in enumerate(model.constants)}
    for i in graph.closure(targets):
        if graph.nodes[i].op == "leaf" and graph.varies[i]:
            name[i] = graph.nodes[i].name
    body = statements(graph, targets, name)
    body += [f"*{result}{k} = {operand(graph, node, name)};" for k, node in enumerate(targets)]
    return block(head, body)


def _rate_functions(model: _Model) -> tuple[str, dict[str, int], int]:
    """The phases of the rates, alone and together with a turn of the power iteration."""
    moving = model.states[: model.dynamic]
    rates = [(node, f"f[{j}][l]") for j, node in enumerate(model.rates)]
    turns = [(node, f"g[{j}][l]") for j, node in enumerate(model.turns)]
    x, d = [f"x{j}" for j in moving], [f"d{j}" for j in moving]
    rate = phase_functions("rate", model.graph, model.constants, rates, x)
    turn = phase_functions("turn", model.graph, model.constants, rates + turns, x + d)
    counts = {"rate": rate.count, "turn": turn.count}
    return rate.text + "\n" + turn.text, counts, max(1, rate.scratch, turn.scratch)


def _rates_function(model: _Model, counts: dict[str, int]) -> str:
    """``rates(c, w, x, f)``: the right-hand side for all lanes."""
    states = [f"x[{j}][l]" for j in range(model.dynamic)]
    calls = call_phases("rate", counts["rate"], "c, w, f, f", states)
    return block("static void rates(const lanes *c, lanes *w, const lanes *x, lanes *f)", calls)


def _output_functions(model: _Model) -> str:
    """The outputs for all lanes at once, and for one lane at many times."""
    lanes_head = "static void observe_lanes(const lanes *c, const lanes *x, lanes *y)"
    row_head = (
        "static void observe_row(const lanes *c, int l, double (*x)[TILE], double (*y)[TILE],"
        " int count)"
    )
    states, results = model.states, range(len(model.outputs))
    leaves = "".join(f", double x{j}" for j in states) + "".join(f", double *y{i}" for i in results)
    one = _lane_function(
        f"INLINE void output(const lanes *c, int l{leaves})", model, model.outputs, "y"
    )

    def call(index: str) -> str:
        places = [
            *(f"x[{j}][{index}]" for j in range(len(states))),
            *(f"&y[{i}][{index}]" for i in results),
        ]
        return f"output(c, l, {', '.join(places)});"

    row = ['_Pragma("omp simd")', "for (int s = 0; s < count; ++s)", f"    {call('s')}"]
    return "\n".join([one, loop_function(lanes_head, [call("l")]), block(row_head, row)])


# --- Stages ---------------------------------------------------------------------------------


def _combination(row: Sequence[float], state: int) -> str:
    """Sum of coefficients times the rates of a state at the stages, without the zeros."""
    terms = (f"{literal(a)} * b->k[{i}][{state}][l]" for i, a in enumerate(row) if a)
    return " + ".join(terms)


def _stage(model: _Model, index: int, counts: dict[str, int]) -> str:
    """``stage<index>(b)``: the states at a stage, then the rates."""
    states, moving = model.states, range(model.dynamic)
    arguments, before = [f"x{states[j]}" for j in moving], []
    for j in moving:
        value = f"b->x[{j}][l]" if index == 0 else f"b->xn[{j}][l]"
        if index not in (0, _LAST):
            value = f"b->x[{j}][l] + b->h[l] * ({_combination(_TABLEAU['A'][index], j)})"
        before.append(f"const double x{states[j]} = {value};")
    name = "rate" if index else "turn"
    if index == 0:
        arguments += [f"b->mode[{j}][l]" for j in moving]
    where = f"b->c, b->w, b->k[{index}], b->turn"
    body = call_phases(name, counts[name], where, arguments, before)
    return block(f"static void stage{index}(block_t *b)", body)


def _attempt_function(model: _Model, counts: dict[str, int]) -> str:
    """``attempt(b)``: the stages, the new states and the two error sums of every state."""
    stages = [_stage(model, index, counts) for index in range(_LAST)]
    calls = ["stage0(b);", "cap(b);", *(f"stage{index}(b);" for index in range(1, _LAST))]
    for j in range(len(model.states)):
        calls += [
            "LANE_LOOP {",
            f"    b->xn[{j}][l] = b->x[{j}][l] + b->h[l] * ({_combination(_TABLEAU['B'], j)});",
            f"    b->e5[{j}][l] = {_combination(_TABLEAU['E5'], j)};",
            f"    b->e3[{j}][l] = {_combination(_TABLEAU['E3'], j)};",
            "}",
        ]
    attempt = block("static void attempt(block_t *b)", calls)
    return "\n".join(["static void cap(block_t *b);", *stages, attempt])


def _dense_function(model: _Model, counts: dict[str, int]) -> str:
    """``prepare_dense(b)``: the extra stages and the coefficients of the interpolation."""
    extra = range(_LAST, _DENSE_LAST)
    calls = [f"stage{index}(b);" for index in extra]
    for j in range(len(model.states)):
        calls += [
            "LANE_LOOP {",
            f"    const double h = b->h[l], move = b->xn[{j}][l] - b->x[{j}][l];",
            f"    const double slope = h * b->k[0][{j}][l];",
            f"    b->d[0][{j}][l] = move;",
            f"    b->d[1][{j}][l] = slope - move;",
            f"    b->d[2][{j}][l] = 2.0 * move - (h * b->k[{_LAST}][{j}][l] + slope);",
        ]
        for i, row in enumerate(_TABLEAU["D"], start=3):
            calls.append(f"    b->d[{i}][{j}][l] = h * ({_combination(row, j)});")
        calls.append("}")
    dense = block("static void prepare_dense(block_t *b)", calls)
    return "\n".join([*(_stage(model, index, counts) for index in extra), dense])
