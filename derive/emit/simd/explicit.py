"""C text of steps of DOP853, side by side in lanes."""

from __future__ import annotations

from collections.abc import Sequence

from .lanes import NUMBERS, block, literal, template

_TABLEAU = NUMBERS["dop853"]
_LAST, _DENSE_LAST = 12, 16  # stages of a step, and of a step with dense output


def explicit_types() -> str:
    """Constants and types of the method."""
    return template("explicit_types.c", {})


def explicit_method() -> str:
    """The method: `attempt`, `prepare_dense`, `measure`, `dense` and the global error."""
    stages = "\n".join([*map(_stage, range(1, _DENSE_LAST)), _attempt(), _dense()])
    pieces = {"/* @STAGES@ */": stages, "/* @ERRORS@ */": template("errors.c", {})}
    return template("explicit.c", pieces)


def _combination(row: Sequence[float]) -> str:
    """Sum of coefficients times the rates of a state at the stages, without the zeros."""
    return " + ".join(f"{literal(a)} * b->k[{i}][j][l]" for i, a in enumerate(row) if a)


def _stage(index: int) -> str:
    """``stage<index>(b)``: the states at a stage, then the rates."""
    value = "b->xn[j][l]"
    if index != _LAST:
        value = f"b->x[j][l] + b->h[l] * ({_combination(_TABLEAU['A'][index])})"
    body = (
        "for (int j = 0; j < ND; ++j)",
        f"    LANE_LOOP b->at[j][l] = {value};",
        f"stage_rates(b, {index}, {literal(_TABLEAU['C'][index])});",
    )
    return block(f"static void stage{index}(block_t *b)", body)


def _attempt() -> str:
    """``attempt(b)``: the stages, the new states and the two error sums of every state."""
    body = (
        "first_stage(b);",
        *(f"stage{index}(b);" for index in range(1, _LAST)),
        "for (int j = 0; j < NS; ++j)",
        "    LANE_LOOP {",
        f"        b->xn[j][l] = b->x[j][l] + b->h[l] * ({_combination(_TABLEAU['B'])});",
        f"        b->method.e5[j][l] = {_combination(_TABLEAU['E5'])};",
        f"        b->method.e3[j][l] = {_combination(_TABLEAU['E3'])};",
        "    }",
    )
    return block("static void attempt(block_t *b, const job_t *job)", body)


def _dense() -> str:
    """``prepare_dense(b)``: the extra stages and the coefficients of the interpolation."""
    rows = (
        f"        b->d[{i}][j][l] = h * ({_combination(row)});"
        for i, row in enumerate(_TABLEAU["D"], start=3)
    )
    body = (
        *(f"stage{index}(b);" for index in range(_LAST, _DENSE_LAST)),
        "for (int j = 0; j < NS; ++j)",
        "    LANE_LOOP {",
        "        const double h = b->h[l], move = b->xn[j][l] - b->x[j][l];",
        "        const double slope = h * b->k[0][j][l];",
        "        b->d[0][j][l] = move;",
        "        b->d[1][j][l] = slope - move;",
        f"        b->d[2][j][l] = 2.0 * move - (h * b->k[{_LAST}][j][l] + slope);",
        *rows,
        "    }",
    )
    return block("static void prepare_dense(block_t *b)", body)
