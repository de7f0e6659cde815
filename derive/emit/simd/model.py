"""What every kernel of a model needs: its nodes, and the C functions that compute them.

The model is read from CasADi's SX instructions (`graph`); the text of its kernels is joined from
it, from the numbers of ``coefficients.json``, and from drivers, which are C that knows no model.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import casadi as ca

from .ensemble import LANES, STIFF_LANES, ensemble_driver
from .graph import Graph
from .lanes import (
    block,
    elementary,
    guarded,
    loop_function,
    operand,
    phase_functions,
    statements,
    template,
)
from .sums import read
from .trajectory import NODES, trajectory_driver

#: Nodes of a right-hand side from which on a model is large.
_LARGE = 400


@dataclass(frozen=True)
class Carried:
    """A set of states that can be integrated by itself.

    Attributes
    ----------
    states : tuple of int
        In this order; those on which a rate depends come first.
    dynamic : int
        How many of them that is. The others are quadratures and need no stage values.
    outputs : tuple of int
        The outputs that need no other state.
    """

    states: tuple[int, ...]
    dynamic: int
    outputs: tuple[int, ...]


@dataclass(frozen=True)
class Equations:
    """The nodes that a kernel computes, with inputs constant or changing in time.

    Attributes
    ----------
    graph : Graph
    rates, outputs : list of int
        Of all states; of the model.
    along, turns : list of int
        Derivatives of the rates along an error ``e`` and along a mode ``m``.
    spread : int
        Trace of the Jacobian.
    jacobian : dict
        Of a stiff model its entries by row and column, but those that are always zero.
    varying : bool
        Whether inputs change in time.
    """

    graph: Graph
    rates: list[int]
    outputs: list[int]
    along: list[int]
    turns: list[int]
    spread: int
    jacobian: dict[tuple[int, int], int]
    varying: bool

    @cached_property
    def constants(self) -> list[int]:
        """What does not change over a trajectory."""
        needed = [*self.rates, *self.outputs, *self.along, *self.turns, self.spread]
        return self.graph.hoisted([*needed, *self.jacobian.values()])


@dataclass(frozen=True)
class KernelModel:
    """A model as its kernels know it.

    Attributes
    ----------
    carried : tuple of Carried
        The sets of states that are offered, the smallest first.
    held, varying : Equations
        With constant inputs, and with inputs over time.
    in_plane : bool
        Whether two states drive each other and the rest follows.
    stiff : bool
        Whether steps are implicit.
    n_inputs, n_parameters : int
    """

    carried: tuple[Carried, ...]
    held: Equations
    varying: Equations
    in_plane: bool
    stiff: bool
    n_inputs: int
    n_parameters: int

    @property
    def is_large(self) -> bool:
        """Whether constant inputs save too little to be worth code of their own."""
        return len(self.varying.graph.closure(self.varying.rates)) > _LARGE


def read_model(
    rhs: ca.Function,
    outputs: ca.Function,
    keep: Iterable[Iterable[int]] = (),
    stiff: bool = False,
) -> KernelModel:
    """Read a model's functions.

    Parameters
    ----------
    rhs, outputs : casadi.Function
        SX functions (x, u, p) -> xdot and (x, u, p) -> y.
    keep : iterable of iterables of int
        Sets of states that are offered beside the set of all; what they depend on is added.
    stiff : bool
        Whether steps are to be implicit.
    """
    held, varying = (_equations(rhs, outputs, each, stiff) for each in (False, True))
    needs = _needs(rhs)
    seen = _needs(outputs)
    sets = [_carried(needs, seen, states) for states in (*keep, range(len(needs)))]
    core = [j for j in range(len(needs)) if j in _closure(needs, needs[j])]
    return KernelModel(
        carried=tuple(dict.fromkeys(sorted(sets, key=lambda each: len(each.states)))),
        held=held,
        varying=varying,
        in_plane=len(core) == 2,
        stiff=stiff,
        n_inputs=rhs.numel_in(1),
        n_parameters=rhs.numel_in(2),
    )


def _equations(rhs: ca.Function, outputs: ca.Function, varying: bool, stiff: bool) -> Equations:
    graph = Graph()
    n_states, n_inputs, n_parameters = (rhs.numel_in(k) for k in range(3))
    x, e, m = ([graph.leaf(f"{kind}{j}", True) for j in range(n_states)] for kind in "xem")
    u = [graph.leaf(f"u{j}" if varying else f"p{j}", varying) for j in range(n_inputs)]
    p = [graph.leaf(f"p{n_inputs + j}", False) for j in range(n_parameters)]
    leaves = [x, u, p]
    rates, seen = read(graph, rhs, leaves), read(graph, outputs, leaves)
    moving = _moving(_needs(rhs))
    turn = _directional(rhs)
    zero = graph.number(0.0)
    along, turns = (
        read(graph, turn, [*leaves, [d if j in moving else zero for j, d in enumerate(each)]])
        for each in (e, m)
    )
    (spread,) = read(graph, _divergence(rhs, moving), leaves)
    entries, jacobian = _jacobian(rhs)
    found = dict(zip(entries, read(graph, jacobian, leaves), strict=True)) if stiff else {}
    return Equations(graph, rates, seen, along, turns, spread, found, varying)


# --- What depends on what ----------------------------------------------------------------------


def _needs(function: ca.Function) -> list[set[int]]:
    """For each result of (x, u, p) the states that it depends on."""
    pattern = function.jac_sparsity(0, 0)
    rows: list[set[int]] = [set() for _ in range(function.numel_out(0))]
    for row, column in zip(*pattern.get_triplet(), strict=True):
        rows[row].add(column)
    return rows


def _moving(needs: Sequence[set[int]]) -> list[int]:
    """The states on which rates depend."""
    return sorted(set().union(*needs))


def _closure(needs: Sequence[set[int]], states: Iterable[int]) -> set[int]:
    """States, and all that their rates depend on."""
    found: set[int] = set()
    stack = list(states)
    while stack:
        state = stack.pop()
        if state not in found:
            found.add(state)
            stack.extend(needs[state])
    return found


def _carried(needs: Sequence[set[int]], seen: Sequence[set[int]], states: Iterable[int]) -> Carried:
    kept = _closure(needs, states)
    moving = {j for state in kept for j in needs[state]}
    order = (*sorted(moving), *sorted(kept - moving))
    return Carried(order, len(moving), tuple(i for i, each in enumerate(seen) if each <= kept))


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
    spread = ca.sum1(ca.vertcat(ca.SX(1, 1), *(jacobian[j, j] for j in moving)))
    return ca.Function("divergence", arguments, [ca.densify(spread)])


def _jacobian(rhs: ca.Function) -> tuple[list[tuple[int, int]], ca.Function]:
    """Places of the entries of the Jacobian by the states, and the function that gives them."""
    arguments = rhs.sx_in()
    matrix = ca.sparsify(ca.jacobian(rhs(*arguments), arguments[0]))
    places = list(zip(*matrix.sparsity().get_triplet(), strict=True))
    entries = ca.vertcat(ca.SX(0, 1), *(matrix[i, j] for i, j in places))
    return places, ca.Function("entries", arguments, [entries])


# --- Functions of the model --------------------------------------------------------------------


def _constants(equations: Equations) -> str:
    """``constants(p, c)``: everything that does not change over a trajectory."""
    graph = equations.graph
    name = {
        i: f"p[{node.name[1:]}][l]"
        for i, node in enumerate(graph.nodes)
        if node.op == "leaf" and not graph.varies[i]
    }
    body = statements(graph, equations.constants, name)
    body += [f"c[{k}][l] = {name[node]};" for k, node in enumerate(equations.constants)]
    return loop_function("static void constants(const lanes *p, lanes *c)", body)


#: What the functions of lanes read: C arrays, and how the values in them are had.
_READ = {"x": "MOVE(x, S{})", "e": "MOVE(e, S{})", "m": "MOVE(m, S{})", "u": "u[{}][l]"}


def _rates(equations: Equations) -> str:
    """``rates(c, u, x, f)``: the right-hand side for all lanes."""
    targets = [(node, f"WRITE(f, S{j}, {{}});") for j, node in enumerate(equations.rates)]
    arrays = ("const lanes *c", "const lanes *u", "const lanes *x", "lanes *f")
    return phase_functions("rate", "rates", equations, targets, arrays, _READ)


def _plane_turns(equations: Equations) -> str:
    """``turns(c, x, m, f, g, trace)``: rates, their derivatives along m, the Jacobian's trace."""
    targets = [(node, f"WRITE(f, S{j}, {{}});") for j, node in enumerate(equations.rates)]
    targets += [(node, f"WRITE_MOVING(g, S{j}, {{}});") for j, node in enumerate(equations.turns)]
    targets.append((equations.spread, "trace[l] = {};"))
    inputs, results = (
        ("const lanes *c", "const lanes *x", "const lanes *m"),
        ("lanes *f", "lanes *g"),
    )
    arrays = (*inputs, *results, "double *trace")
    return phase_functions("turn", "turns", equations, targets, arrays, _READ)


def _turns(equations: Equations) -> str:
    """``turns(c, u, x, e, m, f, r, g)``: rates, and their derivatives along e and along m."""
    targets = [(node, f"WRITE(f, S{j}, {{}});") for j, node in enumerate(equations.rates)]
    targets += [(node, f"WRITE(r, S{j}, {{}});") for j, node in enumerate(equations.along)]
    targets += [(node, f"WRITE_MOVING(g, S{j}, {{}});") for j, node in enumerate(equations.turns)]
    arrays = (*(f"const lanes *{s}" for s in "cuxem"), *(f"lanes *{s}" for s in "frg"))
    return phase_functions("turn", "turns", equations, targets, arrays, _READ)


def _jacobians(equations: Equations) -> str:
    """``jacobian(c, u, x, f, J)``: rates, and their derivatives by the dynamic states."""
    targets = [(node, f"WRITE(f, S{j}, {{}});") for j, node in enumerate(equations.rates)]
    targets += [
        (node, f"WRITE_ENTRY(J, S{i}, S{j}, {{}});") for (i, j), node in equations.jacobian.items()
    ]
    arrays = (*(f"const lanes *{s}" for s in "cux"), "lanes *f", "lanes (*J)[ND1]")
    return phase_functions("entry", "jacobian", equations, targets, arrays, _READ)


def _outputs(equations: Equations) -> Iterator[str]:
    """``output``, and with it ``observe_lanes(c, u, x, y)`` and ``observe_row(c, l, u, x, y, n)``.

    The first has the outputs of all lanes, the second those of one lane at many times.
    """
    graph = equations.graph
    name = {node: f"c[{k}][l]" for k, node in enumerate(equations.constants)}
    used = graph.closure(equations.outputs)
    leaves = {
        i: graph.nodes[i].name for i in used if graph.nodes[i].op == "leaf" and graph.varies[i]
    }
    known = name | leaves
    body = statements(graph, equations.outputs, known)
    body += [f"*y{k} = {operand(graph, i, known)};" for k, i in enumerate(equations.outputs)]
    given = "".join(f", double {leaf}" for leaf in leaves.values())
    made = "".join(f", double *y{k}" for k in range(len(equations.outputs)))
    yield block(f"INLINE void output(const lanes *c, int l{given}{made})", body)

    def call(index: str) -> str:
        read = {"x": f"PICK(x, S{{}}, {index})", "u": f"u[{{}}][{index}]"}
        values = [read[leaf[0]].format(leaf[1:]) for leaf in leaves.values()]
        places = [f"&y[{k}][{index}]" for k in range(len(equations.outputs))]
        return f"output({', '.join(['c', 'l', *values, *places])});"

    head = "APART void observe_lanes(const lanes *c, const lanes *u, const lanes *x, lanes *y)"
    yield loop_function(head, [call("l")])
    head = (
        "APART void observe_row(const lanes *c, int l, double (*u)[TILE], double (*x)[TILE],"
        " double (*y)[TILE], int count)"
    )
    loop = ['_Pragma("omp simd")', "for (int s = 0; s < count; ++s)", f"    {call('s')}"]
    yield block(head, loop)


# --- The text of the kernels -------------------------------------------------------------------


def kernel_text(model: KernelModel) -> str:
    """C source: what every kernel begins with, the model, and the drivers."""
    plane = _plane_turns(model.held) if model.in_plane else _turns(model.held)
    kinds = ((model.varying, _turns(model.varying)), (model.held, plane))
    derivatives = ((e, _jacobians(e) if model.stiff else turns) for e, turns in kinds)
    varying, held = ("\n".join(_functions(*each)) for each in derivatives)
    both = f"#if VARYING\n{varying}\n#else\n{held}\n#endif"
    only = "#undef VARYING\n#define VARYING 1"
    return template(
        "model.c",
        {
            "@LANES@": str(STIFF_LANES if model.stiff else LANES),
            "@NODES@": str(NODES),
            "/* @ELEMENTARY@ */": elementary(),
            "/* @SIZES@ */": "\n".join(_sizes(model)),
            "/* @ALWAYS@ */": only if model.is_large else "",
            "/* @MODEL@ */": varying if model.is_large else both,
            "/* @ENSEMBLE@ */": ensemble_driver(model.stiff),
            "/* @TRAJECTORY@ */": trajectory_driver(),
        },
    )


def _functions(equations: Equations, derivatives: str) -> Iterator[str]:
    yield _constants(equations)
    yield _rates(equations)
    yield guarded("DRIVER == 1", derivatives)
    yield from _outputs(equations)


def _sizes(model: KernelModel) -> Iterator[str]:
    n_states = len(model.held.rates)
    for index, carried in enumerate(model.carried):
        place = {state: k for k, state in enumerate(carried.states)}
        states = ", ".join(f"S{j} = {place.get(j, -1)}" for j in range(n_states))
        yield f"#{'el' if index else ''}if CARRY == {index}"
        yield f"enum {{ NS = {len(place)}, ND = {carried.dynamic}, {states} }};"
    yield "#endif"
    outputs = len(model.held.outputs)
    sizes = {
        "NU": model.n_inputs,
        "NP": model.n_inputs + model.n_parameters,
        "NY": outputs,
        "NU1": max(1, model.n_inputs),
        "NY1": max(1, outputs),
        "ND1": "ND ? ND : 1",
    }
    yield f"enum {{ {', '.join(f'{k} = {n}' for k, n in sizes.items())} }};"
    constants = [max(1, len(each.constants)) for each in (model.varying, model.held)]
    yield "enum {{ NC = VARYING ? {} : {} }};".format(*constants)
    yield f"#define PLANE {int(model.in_plane)}"
