"""Where the numbers of an aircraft come from."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

#: A name in a file, after those of the tables that it is in.
Place: TypeAlias = tuple[str, ...]


@dataclass(frozen=True)
class Source:
    """Where a number comes from.

    Attributes
    ----------
    text : str
        The document, and where in it.
    estimate : bool
        Whether the number is only an estimate.
    entry : str
        The number as it was written, with its unit if it has one.
    """

    text: str = ""
    estimate: bool = False
    entry: str = ""
