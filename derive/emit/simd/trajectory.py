"""C text of the driver that integrates one trajectory, its lanes being moments of a step."""

from __future__ import annotations

from functools import cache

from .lanes import NUMBERS, literal, template

_NODES = NUMBERS["collocation"]["nodes"]
NODES = len(_NODES)


@cache
def trajectory_driver() -> str:
    """The driver, with the numbers of the method; no model in it."""
    return template("trajectory.c", {"/* @COLLOCATION@ */": _tables()})


def _tables() -> str:
    """Nodes, and the matrices that integrate and expand what is known at them."""
    lines = [f"static const double NODE[LANES] = {_row(_NODES)};"]
    for name in ("integral", "series"):
        rows = ",\n".join(_row(row) for row in NUMBERS["collocation"][name])
        lines.append(f"static const double {name.upper()}[LANES][LANES] = {{\n{rows}\n}};")
    return "\n".join(lines)


def _row(values: list[float]) -> str:
    return f"{{{', '.join(map(literal, values))}}}"
