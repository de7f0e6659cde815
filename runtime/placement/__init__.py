"""Where the wheels should stand: the best station over an envelope, within limits.

`envelope` and `limits` say what is asked and `resolve` turns it into the numbers of a `case`;
`problem` puts it into functions of `generated`; `program` solves it over some corners and `search`
exchanges corners until none is worse; `conflict` says why there is no answer; `assess`, `prices`,
`result`, `pareto` and `figures` say what the answer is worth.
"""

from .conflict import Conflict, InfeasibleError
from .envelope import Envelope
from .limits import SOURCES, Limits
from .place import place_gear
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
