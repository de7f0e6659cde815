"""C text of a kernel that integrates one trajectory, its lanes being moments of a step."""

from __future__ import annotations

from .lanes import NUMBERS, literal, template
from .model import (
    KernelModel,
    constants_function,
    kernel_text,
    observe_row_function,
    output_function,
    rates_function,
)

_NODES = NUMBERS["collocation"]["nodes"]


def trajectory_kernel(model: KernelModel) -> str:
    """The kernel of a model for single trajectories."""
    functions = (
        constants_function(model),
        model.rate.text,
        rates_function(model),
        output_function(model),
        observe_row_function(model),
    )
    driver = template("trajectory.c", {"/* @COLLOCATION@ */": _tables()})
    return kernel_text(model, len(_NODES), functions, driver)


def _tables() -> str:
    """Nodes, and the matrices that integrate and expand what is known at them."""
    lines = [f"static const double NODE[LANES] = {_row(_NODES)};"]
    for name in ("integral", "series"):
        rows = ",\n".join(_row(row) for row in NUMBERS["collocation"][name])
        lines.append(f"static const double {name.upper()}[LANES][LANES] = {{\n{rows}\n}};")
    return "\n".join(lines)


def _row(values: list[float]) -> str:
    return f"{{{', '.join(map(literal, values))}}}"
