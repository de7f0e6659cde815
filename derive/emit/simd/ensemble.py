"""C text of the drivers that integrate many trajectories side by side."""

from __future__ import annotations

from functools import cache

from .explicit import explicit_method, explicit_types
from .implicit import implicit_method, implicit_types
from .lanes import template

#: Lanes of a block: many, so that the latencies of short right-hand sides overlap; and one vector,
#: so that what a step of a stiff model needs stays in the nearest cache.
LANES, STIFF_LANES = 32, 8


@cache
def ensemble_driver(stiff: bool) -> str:
    """The driver, with steps of the method for stiff models or of that for others."""
    pieces = {
        "/* @CONSTANTS@ */": implicit_types() if stiff else explicit_types(),
        "/* @METHOD@ */": implicit_method() if stiff else explicit_method(),
        "/* @BETWEEN@ */": template("between.c", {}),
    }
    return template("ensemble.c", pieces)
