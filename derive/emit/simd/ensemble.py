"""C text of a kernel that integrates many trajectories side by side, by DOP853."""

from __future__ import annotations

from collections.abc import Sequence

from .lanes import NUMBERS, block, call_phases, literal, template
from .model import (
    KernelModel,
    constants_function,
    kernel_text,
    observe_lanes_function,
    observe_row_function,
    output_function,
    rates_function,
)

_LANES = 32
_TABLEAU = NUMBERS["dop853"]
_LAST, _DENSE_LAST = 12, 16  # stages of a step, and of a step with dense output


def ensemble_kernel(model: KernelModel) -> str:
    """The kernel of a model for many trajectories."""
    functions = (
        constants_function(model),
        model.rate.text,
        model.turn.text,
        rates_function(model),
        output_function(model),
        observe_lanes_function(model),
        observe_row_function(model),
    )
    stages = f"{_attempt_function(model)}\n{_dense_function(model)}"
    pieces = {"/* @STAGES@ */": stages, "/* @BETWEEN@ */": template("between.c", {})}
    return kernel_text(model, _LANES, functions, template("ensemble.c", pieces))


def _combination(row: Sequence[float], state: int) -> str:
    """Sum of coefficients times the rates of a state at the stages, without the zeros."""
    terms = (f"{literal(a)} * b->k[{i}][{state}][l]" for i, a in enumerate(row) if a)
    return " + ".join(terms)


def _stage(model: KernelModel, index: int) -> str:
    """``stage<index>(b)``: the states at a stage, then the rates."""
    states, moving = model.states, range(model.dynamic)
    arguments, before = [f"x{states[j]}" for j in moving], []
    for j in moving:
        value = f"b->x[{j}][l]" if index == 0 else f"b->xn[{j}][l]"
        if index not in (0, _LAST):
            value = f"b->x[{j}][l] + b->h[l] * ({_combination(_TABLEAU['A'][index], j)})"
        before.append(f"const double x{states[j]} = {value};")
    name, phases = ("rate", model.rate) if index else ("turn", model.turn)
    if index == 0:
        arguments += [f"b->mode[{j}][l]" for j in moving]
    where = f"b->c, b->w, b->k[{index}], b->turn"
    body = call_phases(name, phases.count, where, arguments, before)
    return block(f"static void stage{index}(block_t *b)", body)


def _attempt_function(model: KernelModel) -> str:
    """``attempt(b)``: the stages, the new states and the two error sums of every state."""
    stages = [_stage(model, index) for index in range(_LAST)]
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
    return "\n".join([*stages, attempt])


def _dense_function(model: KernelModel) -> str:
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
    return "\n".join([*(_stage(model, index) for index in extra), dense])
