"""C source of CasADi functions and their derivatives."""

from __future__ import annotations

import re
from collections.abc import Iterable

import casadi as ca

#: A statement whose right-hand side is in parentheses as a whole.
_BRACED = re.compile(r"(?<==)\(([^()]*)\);$")


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
    # nobody reads it: indentation and outer parentheses are a sixth of what is committed
    lines = filter(None, (_BRACED.sub(r"\1;", line.strip()) for line in text.splitlines()))
    return "\n".join([f"/* {header} */", *lines, ""])
