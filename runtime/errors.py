"""Errors that say what was given, where, and what is allowed."""

from __future__ import annotations

import difflib
from collections.abc import Iterable


class GroundrollError(ValueError):
    """Something was asked that cannot be done; the message says what to change."""


class UnexpectedError(GroundrollError):
    """Something else than what belongs in a place.

    Attributes
    ----------
    found, expected : str
        The two halves of the message.
    """

    def __init__(self, where: str, found: str, expected: str) -> None:
        super().__init__(f"{where}: found {found}; expected {expected}")
        self.found = found
        self.expected = expected


class UnknownNameError(GroundrollError, KeyError):
    """A name that does not exist; the message names the nearest that do."""

    def __str__(self) -> str:
        return str(self.args[0])


def beyond(what: str) -> GroundrollError:
    """The error for numbers whose products leave what a double can hold (1e-308 to 1e308)."""
    return GroundrollError(
        f"{what} cannot be computed: numbers so large or so small leave the range of floating point"
    )


def unknown(kind: str, name: str, allowed: Iterable[str], where: str = "") -> UnknownNameError:
    """The error for an unknown name, with the nearest right ones."""
    choices = list(allowed)
    near = difflib.get_close_matches(name, choices, n=3, cutoff=0.5)
    hint = f"did you mean {' or '.join(near)}?" if near else f"there is {', '.join(choices)}"
    place = f" in {where}" if where else ""
    return UnknownNameError(f"unknown {kind} {name!r}{place}; {hint}")
