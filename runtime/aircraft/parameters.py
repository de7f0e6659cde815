"""The parameters of a model: given by an aircraft, its own, or following from others."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from difflib import get_close_matches
from typing import TYPE_CHECKING

import numpy as np

from groundroll.base.arrays import FloatArray, broadcast, physical_of
from groundroll.base.errors import GroundrollError
from groundroll.base.memory import check_memory
from groundroll.generated import PACKS
from groundroll.model.evaluate import elementwise
from groundroll.model.models import Model
from groundroll.model.names import PARAMETERS

from .surfaces import doubts
from .validity import refuse_impossible_tires

if TYPE_CHECKING:
    from .aircraft import Aircraft


def parameters_of(plane: Aircraft, model: Model) -> dict[str, FloatArray]:
    """Value of each parameter of a model, by symbol and in its order; SI units with radians.

    What stands under ``[parameters]`` of the aircraft file comes first, then what the aircraft is
    given, then what follows by the functions of the model, then what follows for any aircraft.

    Raises
    ------
    GroundrollError
        Naming every parameter that is missing, or one that cannot be.
    """
    own = _own(plane, model)
    found: dict[str, FloatArray] = {}
    missing: list[str] = []
    for s in model.parameters:
        try:
            found[s] = _value(plane, model, own, s, ())
        except _Missing as problem:
            missing.append(str(problem))
    if missing:
        raise NotGivenError(_lacking(plane, model, missing), missing[0])
    for doubt in doubts(plane.given, found):
        raise GroundrollError(
            f"aircraft {plane.name}: {doubt.symbol}: found {doubt.found}; expected {doubt.expected}"
        )
    refuse_impossible_tires(plane, found)
    return found


#: How messages of what is missing say what would follow: `runtime.aircraft` writes them.
_LINK, _FOLLOWS = ", and ", " follows from it"


class _Missing(Exception):
    """A parameter that nothing gives; the message is why, in words."""


class NotGivenError(GroundrollError):
    """A parameter that is neither given nor follows.

    Attributes
    ----------
    symbol : str
        The parameter that is missing, from which the one asked for would follow.
    """

    def __init__(self, message: str, symbol: str) -> None:
        super().__init__(message)
        self.symbol = symbol


def _own(plane: Aircraft, model: Model) -> dict[str, FloatArray]:
    """The aircraft's own parameters that the model knows, by symbol."""
    names = {name: s for s in model.parameters for name in (s, model.quantities[s].name)}
    for name in plane.own if model.name not in PACKS else ():
        if name not in names:
            near = get_close_matches(name, names, n=3) or list(names)
            raise GroundrollError(
                f"aircraft {plane.name}: the model {model.name} has no parameter {name!r}; it has"
                f" {', '.join(near)}"
            )
    return {
        names[name]: physical_of(model.quantities[names[name]], value)
        for name, value in plane.own.items()
        if name in names
    }


def _value(
    plane: Aircraft, model: Model, own: Mapping[str, FloatArray], s: str, path: tuple[str, ...]
) -> FloatArray:
    q = model.quantities[s]
    if s in own:
        return own[s]
    is_known = s in PARAMETERS and PARAMETERS[s].unit == q.unit
    if is_known and s in plane.given:
        return plane.given[s]
    way = f"{s}_follows"
    if model.name not in PACKS and way in model.functions and s not in path:
        function = model.compiled(way)
        arguments = {a: _value(plane, model, own, a, (*path, s)) for a in function.name_in()}
        return physical_of(q, elementwise(function, arguments)[s])
    if is_known:
        try:
            return plane[s]
        except NotGivenError as problem:
            raise _Missing(str(problem).removeprefix(f"aircraft {plane.name}: ")) from None
    raise _Missing(f"{q.name} ({s}, {q.unit}) is not given")


def _lacking(plane: Aircraft, model: Model, missing: list[str]) -> str:
    head = f"aircraft {plane.name} lacks what the model {model.name} needs"
    if len(missing) == 1:
        return f"{head}: {missing[0]}"
    return "\n  ".join([f"{head}:", *_grouped(missing)])


#: Most of what follows from something missing that a message names.
_NAMED = 3


def _grouped(missing: list[str]) -> Iterator[str]:
    """What is missing, each once, with what follows from it."""
    wanted: dict[str, list[str]] = {}
    for text in missing:
        root, *links = text.split(_LINK)
        names = [link.removesuffix(_FOLLOWS) for link in links[-1:]]
        wanted[root] = [*wanted.get(root, []), *names]
    for root, names in wanted.items():
        first, more = dict.fromkeys(names[:_NAMED]), len(names) - _NAMED
        verb = "follows" if len(names) == 1 else "follow"
        others = f" and {more} more" if more > 0 else ""
        yield f"{root}, and {', '.join(first)}{others} {verb} from it" if names else root


def stacked(values: Mapping[str, FloatArray]) -> FloatArray:
    """Values in their common shape, one above the other."""
    arrays, shape = broadcast(values)
    check_memory(8 * math.prod(shape) * len(arrays), "the parameters of so many cases")
    return np.stack(list(arrays.values()))
