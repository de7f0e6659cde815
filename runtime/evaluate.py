"""Generated functions applied to NumPy arrays."""

from __future__ import annotations

import math
from collections.abc import Mapping

import casadi as ca
import numpy as np

from . import generated
from .arrays import FloatArray, broadcast

#: Points per call of a generated function: few enough to stay in the cache.
_BLOCK = 256


def elementwise(name: str, arguments: Mapping[str, FloatArray]) -> dict[str, FloatArray]:
    """Apply a generated function of named scalars element by element.

    Parameters
    ----------
    name : str
        Name of the function, e.g. ``"modes"``.
    arguments : mapping
        Arrays by argument name, broadcast against each other; others are ignored.

    Returns
    -------
    dict
        Results by name, each in the common shape.
    """
    function = generated.load(name)
    arrays, shape = broadcast({key: arguments[key] for key in function.name_in()})
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
