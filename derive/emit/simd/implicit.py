"""C text of steps of Rodas5P, side by side in lanes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .lanes import NUMBERS, block, literal, template

_TABLEAU = NUMBERS["rodas5p"]
_STAGES = 8
_GAMMA: float = _TABLEAU["gamma"]
#: Local tolerance over tolerance, and estimated global error over the length that is carried.
_SHARE, _BLAME = 0.2, 1.0


def implicit_types() -> str:
    """Constants and types of the method."""
    pieces = {"@SHARE@": literal(_SHARE), "@GAMMA@": literal(_GAMMA)}
    return template("implicit_types.c", pieces)


def implicit_method() -> str:
    """The method: `attempt`, `prepare_dense`, `measure`, `dense` and the global error."""
    stages = "\n".join([*map(_stage, range(_STAGES)), _attempt(), _dense()])
    pieces = {
        "/* @STAGES@ */": stages,
        "@BLAME@": literal(_BLAME),
        "@TRANSPORT@": ", ".join(map(literal, transport())),
    }
    return template("implicit.c", pieces)


def transport() -> list[float]:
    """Weights of powers of 1 / (1 - gamma z) that agree with exp(z) to second order."""
    g = _GAMMA
    rows = [[1.0, 1.0, 1.0], [1.0, 2.0, 3.0], [1.0, 3.0, 6.0]]
    found: list[float] = np.linalg.solve(rows, [1.0, 1.0 / g, 0.5 / g**2]).tolist()
    return found


def _sum(row: Sequence[float]) -> str:
    """Sum of coefficients times the increments of the stages, without the zeros."""
    terms = (f"{literal(a)} * b->k[{i}][j][l]" for i, a in enumerate(row) if a)
    return " + ".join(terms)


def _stage(index: int) -> str:
    """``stage<index>(b)``: the increment of a stage, instead of the rates at its beginning."""
    A, C, c, d = (_TABLEAU[key] for key in ("A", "C", "c", "d"))
    body = []
    if index:
        body = [
            "for (int j = 0; j < ND; ++j)",
            f"    LANE_LOOP b->at[j][l] = b->x[j][l] + {_sum(A[index])};",
            f"stage_rates(b, {literal(c[index])});",
        ]
    rate = "b->method.right[j][l]" if index else "b->k[0][j][l]"
    inner = [f"h * {rate}"]
    if index:
        inner.append(_sum(C[index]))
    if d[index]:
        inner.append(f"h * {literal(d[index])} * b->method.slope[j][l]")
    body += [
        "for (int j = 0; j < NS; ++j)",
        "    LANE_LOOP {",
        "        const double h = b->h[l];",
        f"        b->k[{index}][j][l] = GAMMA * ({' + '.join(inner)});",
        "    }",
        f"solve(b, b->k[{index}]);",
    ]
    return block(f"static void stage{index}(block_t *b)", body)


def _attempt() -> str:
    """``attempt(b, job)``: the stages and the new states; the last stage is the error."""
    body = (
        "begin_step(b, job);",
        "factorise(b);",
        *(f"stage{index}(b);" for index in range(_STAGES)),
        "for (int j = 0; j < NS; ++j)",
        f"    LANE_LOOP b->xn[j][l] = b->x[j][l] + {_sum(_TABLEAU['b'])};",
    )
    return block("static void attempt(block_t *b, const job_t *job)", body)


def _dense() -> str:
    """``prepare_dense(b)``: the coefficients of the interpolation."""
    body = (
        "for (int j = 0; j < NS; ++j)",
        "    LANE_LOOP {",
        *(f"        b->d[{i}][j][l] = {_sum(row)};" for i, row in enumerate(_TABLEAU["H"])),
        "    }",
    )
    return block("static void prepare_dense(block_t *b)", body)
