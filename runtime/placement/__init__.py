"""Where the wheels should stand: the best station over an envelope, within limits.

`envelope` and `limits` say what is asked; `case` resolves it to numbers; `problem` turns it into
functions of `generated`; `program` solves it over some corners and `search` exchanges corners
until none is worse; `assess`, `result`, `pareto` and `figures` say what came out.
"""

from .envelope import Envelope
from .limits import SOURCES, Limits
from .place import Conflict, InfeasibleError, place_gear
from .result import Placement

__all__ = [
    "SOURCES",
    "Conflict",
    "Envelope",
    "InfeasibleError",
    "Limits",
    "Placement",
    "place_gear",
]
