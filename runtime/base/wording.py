"""Numbers in words."""

from __future__ import annotations

import math
import re
from typing import Any

#: What a terminal obeys instead of showing it, or cannot show; lines and tabs it may have.
_HIDDEN = re.compile(
    "[\x00-\x08\x0b-\x1f\x7f-\x9f\u2028\u2029\u202a-\u202e\u2066-\u2069\ud800-\udfff]"
)


def visible(text: str) -> str:
    """A text with whatever a terminal would obey instead of showing written as in Python."""
    return _HIDDEN.sub(lambda found: found[0].encode("unicode_escape").decode(), text)


def encodable(text: str) -> str:
    """A text that goes into any file: of a file name it may hold what is no character."""
    return text.encode("utf-8", "replace").decode()


def number(value: Any, digits: int = 5) -> str:
    """A number in few digits; what is not a number or without end in words."""
    x = float(value)
    if math.isnan(x):
        return "none"
    if math.isinf(x):
        return "infinite" if x > 0 else "-infinite"
    return f"{0.0 if x == 0 else x:.{digits}g}"
