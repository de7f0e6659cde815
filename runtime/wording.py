"""Numbers in words."""

from __future__ import annotations

import math
from typing import Any


def number(value: Any, digits: int = 5) -> str:
    """A number in few digits; what is not a number or without end in words."""
    x = float(value)
    if math.isnan(x):
        return "none"
    if math.isinf(x):
        return "infinite" if x > 0 else "-infinite"
    return f"{0.0 if x == 0 else x:.{digits}g}"
