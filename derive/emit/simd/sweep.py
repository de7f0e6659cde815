"""C text of kernels that apply functions of named scalars to many points.

The statements are those of the SX instructions in their order, so the bits are those of CasADi's
own C code; only the loop over points is new. A block of points at a time stays in the cache, and
what is the same at all points is spread over a block once.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import casadi as ca

from .lanes import block, literal, template

_INFIX = {ca.OP_ADD: "+", ca.OP_SUB: "-", ca.OP_MUL: "*", ca.OP_DIV: "/"}
_COMPARE = {ca.OP_LT: "<", ca.OP_LE: "<=", ca.OP_EQ: "==", ca.OP_NE: "!="}
_ONE = {
    ca.OP_ASSIGN: "{0}",
    ca.OP_NEG: "-{0}",
    ca.OP_TWICE: "2.0 * {0}",
    ca.OP_SQ: "{0} * {0}",
    ca.OP_INV: "1.0 / {0}",
    ca.OP_SQRT: "sqrt({0})",
    ca.OP_FABS: "fabs({0})",
    ca.OP_NOT: "{0} == 0.0 ? 1.0 : 0.0",
}
_TWO = {
    **{op: f"{{0}} {sign} {{1}}" for op, sign in _INFIX.items()},
    **{op: f"{{0}} {sign} {{1}} ? 1.0 : 0.0" for op, sign in _COMPARE.items()},
    ca.OP_FMAX: "larger({0}, {1})",
    ca.OP_FMIN: "smaller({0}, {1})",
    ca.OP_IF_ELSE_ZERO: "{0} != 0.0 ? {1} : 0.0",
}
_OPERATIONS = _ONE | _TWO
_APART = {ca.OP_INPUT, ca.OP_OUTPUT, ca.OP_CONST}


def can_sweep(function: ca.Function) -> bool:
    """Whether a kernel can be emitted: scalars only, and no operation that is not rounded right."""
    scalar = all(function.numel_in(k) == 1 for k in range(function.n_in()))
    operations = {function.instruction_id(k) for k in range(function.n_instructions())}
    return scalar and operations <= _OPERATIONS.keys() | _APART


def sweep_kernels(functions: Iterable[ca.Function]) -> str:
    """One C file with a kernel ``sweep_<name>`` for each function."""
    return "\n".join([template("sweep.c", {}), *(part for f in functions for part in _kernel(f))])


def _kernel(function: ca.Function) -> Iterator[str]:
    name, n_in, n_out = function.name(), function.n_in(), function.n_out()
    arguments = (
        *(f"const double *restrict p{k}" for k in range(n_in)),
        *(f"double *y{k}" for k in range(n_out)),
    )
    loop = [
        '_Pragma("omp simd")',
        "for (int64_t i = 0; i < n; ++i) {",
        *(f"    {line}" for line in _statements(function)),
        "}",
    ]
    yield block(f"static void {name}_block(int64_t n, {', '.join(arguments)})", loop)
    values = (*(f"p[{k}]" for k in range(n_in)), *(f"y[{k}]" for k in range(n_out)))
    call = [f"{name}_block(n, {', '.join(values)});"]
    yield block(f"static void {name}_any(int64_t n, const double **p, double **y)", call)
    yield (
        f"SHOWN void sweep_{name}(int64_t n, int64_t threads, const double *const *p,\n"
        "    const int64_t *stride, double *const *y)\n"
        f"{{\n    sweep({name}_any, {n_in}, {n_out}, n, threads, p, stride, y);\n}}\n"
    )


def _statements(function: ca.Function) -> Iterator[str]:
    """The SX instructions; work variables are reused, so each is declared when it is written."""
    version: dict[int, str] = {}
    for k in range(function.n_instructions()):
        op, source = function.instruction_id(k), function.instruction_input(k)
        target = function.instruction_output(k)
        if op == ca.OP_OUTPUT:
            yield f"y{target[0]}[i] = {version[source[0]]};"
            continue
        if op == ca.OP_INPUT:
            value = f"p{source[0]}[i]"
        elif op == ca.OP_CONST:
            value = literal(function.instruction_constant(k))
        else:
            value = _OPERATIONS[op].format(*(version[s] for s in source))
        version[target[0]] = f"w{k}"
        yield f"const double w{k} = {value};"
