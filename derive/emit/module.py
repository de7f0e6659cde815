"""A module of a pack: functions that belong together."""

from __future__ import annotations

from dataclasses import dataclass

from .casadi_source import FunctionSpec


@dataclass(frozen=True)
class Module:
    """A module of a pack.

    Attributes
    ----------
    name, summary : str
        Its file and its docstring.
    functions : tuple of FunctionSpec
    is_readable : bool
        Whether Jacobians of a model are among the functions, written link by link; otherwise
        CasADi differentiates.
    """

    name: str
    summary: str
    functions: tuple[FunctionSpec, ...]
    is_readable: bool = True
