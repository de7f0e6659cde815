# Generated from derive/ with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`.
"""Packs generated from the derivation, and the library that compiles and loads them.

`from groundroll.generated import nonlinear_rk45` gives a compiled CasADi function of a pack that
ships; `PACKS` holds the packs, `read_pack` reads one from any folder.
"""

from __future__ import annotations

import difflib
from pathlib import Path

import casadi as ca

from .library import StaleError
from .packs import Pack, PackError, Quantity, read_pack

__all__ = ["PACKS", "Pack", "PackError", "Quantity", "StaleError", "build", "load", "read_pack"]

_HERE = Path(__file__).resolve().parent

#: The packs that ship, by name.
PACKS = {path.parent.name: read_pack(path.parent) for path in sorted(_HERE.glob("*/facts.json"))}


def load(name: str) -> ca.Function:
    """A generated function by its name in the project, compiled if there is a C compiler.

    Parameters
    ----------
    name : str
        The pack and the function, e.g. ``"nonlinear_rk45"``, or a closed form by itself,
        e.g. ``"speed_window"``.

    Raises
    ------
    KeyError
        If there is no such function; the message names the nearest.
    StaleError
        If the C code does not belong to these equations.
    """
    return pack_of(name).compiled(name)


def build(name: str) -> ca.Function:
    """The function `name` in CasADi's virtual machine, from its Python source.

    Raises
    ------
    KeyError
        If there is no such function; the message names the nearest.
    """
    return pack_of(name).build(name)


def pack_of(name: str) -> Pack:
    """The pack that ships with a function; `KeyError` names the nearest if there is none."""
    for pack in PACKS.values():
        if name in pack.functions:
            return pack
    known = [function for pack in PACKS.values() for function in pack.functions]
    near = difflib.get_close_matches(name, known, n=3) or sorted(known)
    raise KeyError(f"no generated function {name!r}; there is {', '.join(near)}")


def __getattr__(name: str) -> ca.Function:
    known = [function for pack in PACKS.values() for function in pack.functions]
    if name in known:
        return load(name)
    near = difflib.get_close_matches(name, known, n=3)
    hint = f"; did you mean {' or '.join(near)}?" if near else ""
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}{hint}")


def __dir__() -> list[str]:
    return [*__all__, *(function for pack in PACKS.values() for function in pack.functions)]
