"""Generated functions applied to NumPy arrays."""

from __future__ import annotations

import io
import math
from collections.abc import Mapping
from contextlib import redirect_stderr
from functools import cache
from typing import Any

import casadi as ca
import numpy as np

from groundroll import generated
from groundroll.base.arrays import FloatArray, broadcast
from groundroll.base.memory import check_memory, room
from groundroll.generated import kernels

#: Points per call of a generated function: few enough to stay in the cache.
_BLOCK = 256
#: Points from which a kernel pays, which may have to be compiled first.
_MANY = 2_000


def elementwise(
    name: str | ca.Function,
    arguments: Mapping[str, FloatArray],
    out: dict[str, FloatArray] | None = None,
) -> dict[str, FloatArray]:
    """Apply a generated function of named scalars element by element.

    Parameters
    ----------
    name : str or casadi.Function
        The function, or its name, e.g. ``"modes"``.
    arguments : mapping
        Arrays by argument name, broadcast against each other; others are ignored.
    out : dict, optional
        Where each result goes; new arrays if omitted.

    Returns
    -------
    dict
        Results by name, each in the common shape.
    """
    function = generated.load(name) if isinstance(name, str) else name
    arrays, shape = broadcast({key: arguments[key] for key in function.name_in()})
    numbers = math.prod(shape) * (function.n_in() + function.n_out())
    check_memory(8 * numbers, f"arguments and results of {function.name()}")
    if isinstance(name, str) and math.prod(shape) >= _MANY and _can_sweep(name):
        names = function.name_out()
        found = out or dict(zip(names, room(*[shape] * len(names)), strict=True))
        sweep_into(name, arguments, shape, found)
        return found
    found = _one_by_one(function, arrays, shape)
    for key, values in (out or {}).items():
        values[...] = found[key]
    return found


def sweep_into(
    name: str,
    arguments: Mapping[str, FloatArray],
    shape: tuple[int, ...],
    results: Mapping[str, FloatArray],
    threads: int = 1,
) -> None:
    """Apply a generated function to many points, in place: `elementwise`, a hundred times faster.

    Parameters
    ----------
    name, arguments
        As for `elementwise`.
    shape : tuple of int
        What the arguments broadcast to.
    results : mapping
        Contiguous arrays of that shape by result name; others are not kept.
    threads : int
        Does not change a bit of the result.
    """
    given, made = names_of(name)
    if not _can_sweep(name):
        found = _one_by_one(generated.build(name), {k: arguments[k] for k in given}, shape)
        for key, result in results.items():
            result[...] = found[key]
        return
    flat = [_flat(arguments[key], shape) for key in given]
    kernels.sweep(
        generated.pack_of(name),
        name,
        math.prod(shape),
        flat,
        [results.get(key) for key in made],
        threads,
    )


def _can_sweep(name: str) -> bool:
    return kernels.can_sweep(generated.pack_of(name), name)


@cache
def names_of(function: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Names of the arguments and of the results of a generated function."""
    built = generated.build(function)
    return tuple(built.name_in()), tuple(built.name_out())


def _flat(array: FloatArray, shape: tuple[int, ...]) -> FloatArray:
    """An argument as one number or as a column with one for each point."""
    if array.size > 1 and array.shape != shape:
        array = np.broadcast_to(array, shape)
    return np.ascontiguousarray(array, dtype=np.float64).reshape(-1)


def _one_by_one(
    function: ca.Function, arrays: Mapping[str, FloatArray], shape: tuple[int, ...]
) -> dict[str, FloatArray]:
    count = math.prod(shape)
    blocks = math.ceil(count / _BLOCK)
    rows = np.ones((len(arrays), blocks * _BLOCK))  # what fills the last block is thrown away
    for row, array in zip(rows, arrays.values(), strict=True):
        row[:count].reshape(shape)[...] = array
    results = np.empty((function.n_out(), blocks * _BLOCK))
    _apply(function.map(_BLOCK), rows, results)
    return {
        key: result[:count].reshape(shape)
        for key, result in zip(function.name_out(), results, strict=True)
    }


def _apply(function: ca.Function, rows: FloatArray, results: FloatArray) -> None:
    """Run through rows in blocks, in place: CasADi's own conversion of arrays is far slower."""
    buffer, evaluate = function.buffer()
    for start in range(0, rows.shape[1], _BLOCK):
        block = slice(start, start + _BLOCK)
        for k, row in enumerate(rows):
            buffer.set_arg(k, memoryview(row[block]))  # type: ignore[call-arg]  # its C++ signature
        for k, result in enumerate(results):
            buffer.set_res(k, memoryview(result[block]))  # type: ignore[call-arg]
        evaluate()


def columns(function: str | ca.Function, *arguments: FloatArray) -> list[FloatArray]:
    """Apply a generated function of vectors to many at once.

    Parameters
    ----------
    function : str or casadi.Function
        The function or its name, e.g. ``"nonlinear_rhs"``.
    *arguments : ndarray, shape (n_k, N)
        For each argument one column per evaluation.

    Returns
    -------
    list of ndarray, shape (N, rows, columns)
        One matrix per evaluation for each output.
    """
    if isinstance(function, str):
        function = generated.load(function)
    count = arguments[0].shape[1]
    results = (
        function.map(count).call(list(arguments)) if count > 1 else function.call(list(arguments))
    )
    matrices = []
    for k, result in enumerate(results):
        rows, width = function.size_out(k)
        values = np.array(result, dtype=np.float64).reshape(rows, count, width)
        matrices.append(np.moveaxis(values, 1, 0))
    return matrices


def solved(solver: ca.Function, **arguments: Any) -> dict[str, Any]:
    """What a solver returns. CasADi makes a warning of Ctrl-C and IPOPT a failure; not so here."""
    with redirect_stderr(io.StringIO()) as said:
        try:
            result: dict[str, Any] = solver(**arguments)
        except SystemError as problem:  # that it returned while interrupted
            if isinstance(problem.__cause__, KeyboardInterrupt):
                raise KeyboardInterrupt from None
            raise
    if "KeyboardInterrupt" in said.getvalue():
        raise KeyboardInterrupt
    return result
