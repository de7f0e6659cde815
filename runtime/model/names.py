"""Symbols and full names: ``r`` and ``yaw_rate`` are the same quantity."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from functools import cache
from hashlib import sha256
from itertools import islice
from typing import Any

from groundroll.base.arrays import FloatArray, physical_of
from groundroll.base.errors import GroundrollError, one_of, shown, unknown
from groundroll.generated import PACKS, Pack, Quantity

#: Every quantity of the packs that ship, by symbol.
QUANTITIES: dict[str, Quantity] = {}
for _pack in PACKS.values():
    QUANTITIES = {**_pack.quantities, **QUANTITIES}
#: What an aircraft may be given, by symbol: the parameters that any of these packs knows.
PARAMETERS: dict[str, Quantity] = {}
for _pack in PACKS.values():
    for _s, _q in _pack.quantities.items():
        if _q.kind == "parameter":
            PARAMETERS.setdefault(_s, _q)
#: The models that ship, by name.
MODELS = {name: pack for name, pack in PACKS.items() if pack.states}
#: Name of each function of these packs -> module, builder, C file.
FUNCTIONS = {name: entry for pack in PACKS.values() for name, entry in pack.functions.items()}
#: Digest of all their equations.
DIGEST = sha256("".join(pack.digest for pack in PACKS.values()).encode()).hexdigest()[:16]

_SYMBOLS = {**{q.name: symbol for symbol, q in QUANTITIES.items()}, **{s: s for s in QUANTITIES}}

#: Most names in a list.
_MOST = 10_000


@cache
def parameter_symbols() -> tuple[str, ...]:
    """What an aircraft may be given."""
    return tuple(PARAMETERS)


def physical(symbol: str, value: Any) -> FloatArray:
    """`value` as an array of finite floats of the sign that the quantity `symbol` must have."""
    return physical_of(QUANTITIES[symbol], value)


def symbol(name: str, kind: str, allowed: Collection[str], where: str = "") -> str:
    """The symbol of a quantity given by symbol or by full name.

    Raises
    ------
    UnknownNameError
        If it is not one of the symbols `allowed`; the message names the nearest.
    """
    found = _SYMBOLS.get(name) if isinstance(name, str) else None
    if found in allowed:
        return str(found)
    choices = [choice for s in allowed for choice in (s, QUANTITIES[s].name)]
    raise unknown(kind, name, dict.fromkeys(choices), where)


def listed(what: str, names: Any) -> list[str]:
    """A list of names, which one alone is not: its letters would be taken for names.

    Raises
    ------
    GroundrollError
        If it is none, or longer than any that makes sense.
    """
    if isinstance(names, str) or not isinstance(names, Iterable):
        raise GroundrollError(f"{what} must be a list of names, not {shown(names)}")
    found = list(islice(names, _MOST + 1))
    if len(found) > _MOST:
        raise GroundrollError(f"{what} must be a list of at most {_MOST} names")
    return found


def signature(model: str) -> Pack:
    """The pack of a model that ships, ``"linear"`` or ``"nonlinear"``."""
    return MODELS[one_of("model", model, MODELS)]
