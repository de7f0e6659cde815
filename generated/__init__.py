# Generated from derive/ (digest 61dbe1126aa8d733) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`.
"""CasADi functions generated from the derivation; see `names.FUNCTIONS` for the list.

`from groundroll.generated import nonlinear_rk45` gives the compiled function; the
modules (`nonlinear`, `linear`, ...) hold the readable builders.
"""

import difflib

import casadi as ca

from .library import SOURCES, StaleError, build, load
from .names import DIGEST, FUNCTIONS, MODELS, QUANTITIES, Quantity, Signature

__all__ = [
    "DIGEST",
    "FUNCTIONS",
    "MODELS",
    "QUANTITIES",
    "SOURCES",
    "Quantity",
    "Signature",
    "StaleError",
    "build",
    "load",
]


def __getattr__(name: str) -> ca.Function:
    if name in FUNCTIONS:
        return load(name)
    near = difflib.get_close_matches(name, FUNCTIONS, n=3)
    hint = f"; did you mean {' or '.join(near)}?" if near else ""
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}{hint}")


def __dir__() -> list[str]:
    return [*__all__, *FUNCTIONS]
