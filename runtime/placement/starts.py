"""Where the solver starts."""

from __future__ import annotations

from typing import Any

import numpy as np

from .case import Case


def begin(case: Case) -> list[dict[str, float]]:
    """Designs to start from: today's, and a spread over the box with the stablest first."""
    count = 5 if len(case.variables) == 1 else 9
    spread = _halton(count, len(case.variables))
    designs = [
        case.design(
            {v.symbol: v.low + x * (v.high - v.low) for v, x in zip(case.variables, z, strict=True)}
        )
        for z in spread
    ]
    inside = all(v.low <= case.today[v.symbol] <= v.high for v in case.variables)
    if inside:
        designs.append(dict(case.today))
    middle = {s: axis.values.mean() for s, axis in case.axes.items()}
    designs.sort(key=lambda d: -float(case.values(d, middle)["decay_rate"]))
    # each start of a simulated objective costs many runs
    return designs[:3] if _simulates(case) else designs


def _simulates(case: Case) -> bool:
    return case.objective == "displacement" or any(b.limit == "displacement" for b in case.bounds)


def _halton(count: int, dimensions: int) -> np.ndarray[Any, np.dtype[np.float64]]:
    """Points spread evenly over the unit box, the same each time."""
    bases = (2, 3, 5, 7, 11)[:dimensions]
    points = np.zeros((count, dimensions))
    for column, base in enumerate(bases):
        for row in range(count):
            index, fraction = row + 1, 1.0
            while index:
                fraction /= base
                points[row, column] += fraction * (index % base)
                index //= base
    return points
