# Generated from derive/ with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`.
"""Kernels for many aircraft at once: compiled on first use, called with NumPy arrays.

They are compiled for the processor at hand, so AVX2 or AVX-512 is used where it is there, and
cached under a name that tells processors apart. A compiler that does not know every flag gets
fewer of them.
"""

from __future__ import annotations

import ctypes
import os
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from .compiler import NoCompilerError, opened
from .library import compiled, say_slower
from .packs import Pack

FloatArray = npt.NDArray[np.float64]

_ALWAYS = ("-fPIC", "-shared", "-std=gnu11")
_NATIVE = ("-O3", "-march=native", "-fno-math-errno", *_ALWAYS)
#: Flags by how much they ask of the compiler. Never -ffast-math. The last three of the first set
#: keep gcc from taking selections in polynomials apart into paths, which costs a third.
_FLAGS = (
    (
        *(*_NATIVE, "-fopenmp", "-fno-trapping-math", "-mprefer-vector-width=512"),
        *("-fno-thread-jumps", "-fno-code-hoisting", "-fno-tree-pre"),
    ),
    (*_NATIVE, "-fopenmp"),
    _NATIVE,
    ("-O2", *_ALWAYS),
)
#: So that closed forms are the same bits as in CasADi's virtual machine.
_UNCONTRACTED = "-ffp-contract=off"


#: OpenMP's threads do not survive a fork; a child that used them would wait for ever.
_forked = False


def _after_fork() -> None:
    global _forked
    _forked = True


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_after_fork)


def processors() -> int:
    """How many processors this process may run on."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def useful_threads(threads: int, count: int) -> int:
    """As many threads as help: OpenMP ends the process if it cannot make all it is asked for."""
    return 1 if _forked else max(1, min(threads, count, processors()))


class _Pointers:
    """A C array of pointers to arrays (or NULL), and one of their strides: 0 for one value."""

    def __init__(self, arrays: Any) -> None:
        self._arrays = [None if a is None else _contiguous(a) for a in arrays]
        data = [None if a is None else a.ctypes.data for a in self._arrays]
        self._pointers = (ctypes.c_void_p * len(data))(*data)
        strides = [int(a is not None and a.size > 1) for a in self._arrays]
        self._strides = (ctypes.c_int64 * len(data))(*strides)

    def address(self, start: int = 0) -> int:
        return ctypes.addressof(self._pointers) + 8 * start

    def stride_address(self, start: int = 0) -> int:
        return ctypes.addressof(self._strides) + 8 * start


def _contiguous(array: FloatArray) -> FloatArray:
    return array if array.flags.c_contiguous else np.ascontiguousarray(array)


def can_sweep(pack: Pack, function: str) -> bool:
    """Whether a function has a kernel for many points, and that can be compiled here."""
    if function not in pack.sweeps:
        return False
    try:
        _sweeper(pack, function)
    except NoCompilerError as problem:
        say_slower(problem)
        return False
    return True


def sweep(
    pack: Pack,
    function: str,
    count: int,
    arguments: Sequence[FloatArray],
    results: Sequence[FloatArray | None],
    threads: int = 1,
) -> None:
    """Apply a function of named scalars to many points, in place.

    Parameters
    ----------
    pack, function : Pack and str
        One of the pack's sweeps.
    count : int
        Number of points.
    arguments, results : sequence of ndarray, each of `count` elements
        In the order of the function. An argument may be a single number, of shape (1,); a result
        that is None is not kept.
    threads : int
        Does not change a bit of the result.

    Raises
    ------
    NoCompilerError
        If there is no C compiler.
    """
    given, made = _Pointers(arguments), _Pointers(results)
    sweeper = _sweeper(pack, function)
    sweeper(
        count,
        useful_threads(threads, count),
        given.address(),
        given.stride_address(),
        made.address(),
    )


@cache
def _sweeper(pack: Pack, function: str) -> Any:
    source, symbol = pack.sources / f"{pack.sweeps[function]}.c", f"sweep_{function}"
    kernel = getattr(load(source, pack.digest, symbol, _UNCONTRACTED), symbol)
    kernel.argtypes = (ctypes.c_int64, ctypes.c_int64, *[ctypes.c_void_p] * 3)
    return kernel


@cache
def load(source: Path, digest: str, symbol: str, *more: str) -> ctypes.CDLL:
    """The library of a C file with this function, compiled with the first flags that give one.

    Raises
    ------
    NoCompilerError
        If no flags do.
    """
    problem = NoCompilerError(f"{source} was not compiled")
    for flags in _FLAGS:
        try:
            return opened(compiled(source, digest, (*flags, *more), symbol=symbol), symbol)
        except NoCompilerError as found:
            problem = found
    raise problem
