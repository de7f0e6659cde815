"""What every kernel of a model needs: its nodes, and the C functions that compute them.

The model is read from CasADi's SX instructions (`graph`); the text of a kernel is joined from it,
from the numbers of ``coefficients.json``, and from a driver, which is C that knows no model.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property

import casadi as ca

from .graph import Graph
from .lanes import (
    Phases,
    block,
    call_phases,
    elementary,
    loop_function,
    operand,
    phase_functions,
    statements,
    template,
)
from .sums import read


@dataclass(frozen=True)
class KernelModel:
    """The nodes that a kernel computes.

    Attributes
    ----------
    graph : Graph
    states : tuple of int
        Which of the model's states are carried, in this order; those on which a rate depends
        come first.
    dynamic : int
        How many of them that is. The others are quadratures and need no stage values.
    rates, turns, outputs : list of int
        Rates of the states; derivatives of the dynamic ones along a direction; outputs.
    constants : list of int
        What does not change over a trajectory.
    n_parameters : int
        Number of inputs and parameters.
    """

    graph: Graph
    states: tuple[int, ...]
    dynamic: int
    rates: list[int]
    turns: list[int]
    spread: int
    outputs: list[int]
    constants: list[int]
    n_parameters: int

    @property
    def moving(self) -> tuple[int, ...]:
        """The dynamic states."""
        return self.states[: self.dynamic]

    @cached_property
    def rate(self) -> Phases:
        """The right-hand side of one lane: C functions ``rate0, rate1, ...``."""
        results = [(node, f"f[{j}][l]") for j, node in enumerate(self.rates)]
        leaves = [f"x{j}" for j in self.moving]
        return phase_functions("rate", self.graph, self.constants, results, leaves)

    @cached_property
    def turn(self) -> Phases:
        """The right-hand side together with its derivative along a direction."""
        results = [(node, f"f[{j}][l]") for j, node in enumerate(self.rates)]
        results += [(node, f"g[{j}][l]") for j, node in enumerate([*self.turns, self.spread])]
        leaves = [f"x{j}" for j in self.moving] + [f"d{j}" for j in self.moving]
        return phase_functions("turn", self.graph, self.constants, results, leaves)


def read_model(rhs: ca.Function, outputs: ca.Function, keep: Iterable[int]) -> KernelModel:
    """Read a model's functions.

    Parameters
    ----------
    rhs, outputs : casadi.Function
        SX functions (x, u, p) -> xdot and (x, u, p) -> y; u and p are constant over a trajectory.
    keep : iterable of int
        States that are wanted; others are carried only if these or the outputs depend on them.
    """
    graph = Graph()
    n_states, n_inputs, n_parameters = (rhs.numel_in(k) for k in range(3))
    x = [graph.leaf(f"x{j}", varies=True) for j in range(n_states)]
    p = [graph.leaf(f"p{j}", varies=False) for j in range(n_inputs + n_parameters)]
    leaves = [x, p[:n_inputs], p[n_inputs:]]
    rates = read(graph, rhs, leaves)
    seen = read(graph, outputs, leaves)
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
    turned = read(graph, _directional(rhs), [*leaves, mode])
    turns = [turned[j] for j in moving]
    (spread,) = read(graph, _divergence(rhs, moving), leaves)
    constants = graph.hoisted([*kept, *seen, *turns, spread])
    return KernelModel(graph, order, len(dynamic), kept, turns, spread, seen, constants, len(p))


def _directional(rhs: ca.Function) -> ca.Function:
    """``(x, u, p, d) -> J d``, the derivative of the rates along a direction of the states."""
    x, u, p = rhs.sx_in()
    direction = ca.SX.sym("d", x.numel())
    turn = ca.densify(ca.jtimes(rhs(x, u, p), x, direction))
    return ca.Function("turn", [x, u, p, direction], [turn])


def _divergence(rhs: ca.Function, moving: Sequence[int]) -> ca.Function:
    """``(x, u, p) -> sum of d xdot_j / d x_j`` over the dynamic states."""
    arguments = rhs.sx_in()
    jacobian = ca.jacobian(rhs(*arguments), arguments[0])
    spread = ca.sum1(ca.vertcat(*(jacobian[j, j] for j in moving)))
    return ca.Function("divergence", arguments, [ca.densify(spread)])


def _states_read(graph: Graph, targets: Sequence[int], x: Sequence[int]) -> set[int]:
    """Indices of the states on which the targets depend."""
    needed = set(graph.closure(targets))
    return {j for j, node in enumerate(x) if node in needed}


# --- Functions of the model -----------------------------------------------------------------


def constants_function(model: KernelModel) -> str:
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


def rates_function(model: KernelModel) -> str:
    """``rates(c, w, x, f)``: the right-hand side for all lanes."""
    states = [f"x[{j}][l]" for j in range(model.dynamic)]
    calls = call_phases("rate", model.rate.count, "c, w, f, f", states)
    return block("static void rates(const lanes *c, lanes *w, const lanes *x, lanes *f)", calls)


def output_function(model: KernelModel) -> str:
    """``output(c, l, x0, ..., &y0, ...)``: the outputs of one lane."""
    graph, leaves = model.graph, "".join(f", double x{j}" for j in model.states)
    results = "".join(f", double *y{i}" for i in range(len(model.outputs)))
    name = {node: f"c[{k}][l]" for k, node in enumerate(model.constants)}
    for i in graph.closure(model.outputs):
        if graph.nodes[i].op == "leaf" and graph.varies[i]:
            name[i] = graph.nodes[i].name
    body = statements(graph, model.outputs, name)
    body += [f"*y{k} = {operand(graph, node, name)};" for k, node in enumerate(model.outputs)]
    return block(f"INLINE void output(const lanes *c, int l{leaves}{results})", body)


def observe_lanes_function(model: KernelModel) -> str:
    """``observe_lanes(c, x, y)``: the outputs for all lanes at once."""
    head = "static void observe_lanes(const lanes *c, const lanes *x, lanes *y)"
    return loop_function(head, [_output_call(model, "l")])


def observe_row_function(model: KernelModel) -> str:
    """``observe_row(c, l, x, y, count)``: the outputs of one lane at many times."""
    head = (
        "static void observe_row(const lanes *c, int l, double (*x)[TILE], double (*y)[TILE],"
        " int count)"
    )
    loop = ['_Pragma("omp simd")', "for (int s = 0; s < count; ++s)"]
    return block(head, [*loop, f"    {_output_call(model, 's')}"])


def _output_call(model: KernelModel, index: str) -> str:
    states = [f"x[{j}][{index}]" for j in range(len(model.states))]
    results = [f"&y[{i}][{index}]" for i in range(len(model.outputs))]
    return f"output(c, l, {', '.join([*states, *results])});"


# --- The text of a kernel ---------------------------------------------------------------------


def kernel_text(model: KernelModel, lanes: int, functions: Iterable[str], driver: str) -> str:
    """C source: what every kernel begins with, functions of the model, and a driver.

    Parameters
    ----------
    model : KernelModel
    lanes : int
        Number of lanes of a block.
    functions : iterable of str
        C functions of the model.
    driver : str
        C that knows no model.
    """
    sizes = {
        "NS": len(model.states),
        "ND": model.dynamic,
        "NP": model.n_parameters,
        "NC": max(1, len(model.constants)),
        "NW": max(1, model.rate.scratch, model.turn.scratch),
        "NY": len(model.outputs),
        "NY1": max(1, len(model.outputs)),
    }
    return template(
        "model.c",
        {
            "@LANES@": str(lanes),
            "/* @ELEMENTARY@ */": elementary(),
            "/* @SIZES@ */": f"enum {{ {', '.join(f'{k} = {n}' for k, n in sizes.items())} }};",
            "/* @MODEL@ */": "\n".join(functions),
            "/* @DRIVER@ */": driver,
        },
    )
