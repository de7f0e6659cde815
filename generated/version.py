# Generated from derive/ with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`.
"""Which packs this version reads."""

from __future__ import annotations

#: Of what a pack holds and how; another one is refused.
FORMAT = 1
#: Of groundroll, as in ``pyproject.toml``.
VERSION = "0.1.0"
