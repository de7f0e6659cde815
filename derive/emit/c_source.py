"""C source of CasADi functions and their derivatives."""

from __future__ import annotations

from collections.abc import Iterable

import casadi as ca


def c_source(name: str, functions: Iterable[ca.Function], header: str) -> str:
    """One C file that exports `functions`.

    Raises
    ------
    NotImplementedError
        If CasADi cannot express a function in C; by itself it only warns.
    """
    generator = ca.CodeGenerator(name, {"with_header": False})
    for function in functions:
        generator.add(function)
    text: str = generator.dump()
    if "#error" in text:
        raise NotImplementedError(f"CasADi cannot generate C for all of {name}")
    return f"/* {header} */\n{text}"
