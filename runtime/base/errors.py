"""Errors that say what was given, where, and what is allowed."""

from __future__ import annotations

import difflib
from collections.abc import Collection, Iterable, Mapping, Sequence
from typing import Any, TypeVar

T = TypeVar("T")

#: Characters of what was given that a message shows.
_LONG = 80
#: Mistakes that are listed: whoever has more has one in common to all.
MOST_MISTAKES = 50


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


def listed(what: str, mistakes: Sequence[Any], more: int = 0) -> str:
    """The message for mistakes, the first of them with a line each.

    Parameters
    ----------
    what : str
        What has them.
    mistakes : sequence
        Each as it is to be read.
    more : int
        How many there are beside these.
    """
    total = len(mistakes) + more
    lines = [f"{what} has {total} mistake{'s' if total > 1 else ''}:"]
    lines += map(str, mistakes[:MOST_MISTAKES])
    left = total - len(mistakes[:MOST_MISTAKES])
    return "\n  ".join([*lines, f"and {left} more"] if left else lines)


def beyond(what: str) -> GroundrollError:
    """The error for numbers whose products leave what a double can hold (1e-308 to 1e308)."""
    return GroundrollError(
        f"{what} cannot be computed: numbers so large or so small leave the range of floating point"
    )


def unknown(kind: str, name: Any, allowed: Iterable[str], where: str = "") -> UnknownNameError:
    """The error for an unknown name, with the nearest right ones."""
    choices = list(allowed)
    text = name if isinstance(name, str) else ""
    near = difflib.get_close_matches(text[:_LONG], choices, n=3, cutoff=0.5)
    hint = f"did you mean {' or '.join(near)}?" if near else f"there is {', '.join(choices)}"
    place = f" in {where}" if where else ""
    return UnknownNameError(f"unknown {kind} {shown(name)}{place}; {hint}")


def one_of(kind: str, name: Any, allowed: Collection[str], where: str = "") -> str:
    """A name that is one of those `allowed`; otherwise the error says which there are."""
    if isinstance(name, str) and name in allowed:
        return name
    raise unknown(kind, name, allowed, where)


def mapped(what: str, value: Any) -> Mapping[Any, Any]:
    """A value that is a mapping of names to values; otherwise the error says what it is."""
    if not isinstance(value, Mapping):
        raise GroundrollError(f"{what} must map names to values, not {shown(value)}")
    return value


def of_kind(what: str, value: T, kind: type[Any]) -> T:
    """A value of a class; otherwise the error says what it is."""
    if not isinstance(value, kind):
        raise GroundrollError(f"{what} must be of the class {kind.__name__}, not {shown(value)}")
    return value


def shown(value: Any) -> str:
    """A value as Python shows it, or the beginning of that."""
    try:
        text = " ".join(repr(value).split())
    except Exception:  # an integer of thousands of digits, lists within lists, a class's own
        return f"what is too long to show ({type(value).__name__})"
    return text if len(text) <= _LONG else f"{text[: _LONG - 3]}..."
