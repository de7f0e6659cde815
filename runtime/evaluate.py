"""Generated functions applied to NumPy arrays."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from . import generated
from .arrays import FloatArray, broadcast


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
    wanted = {key: arguments[key] for key in function.name_in()}
    arrays, shape = broadcast(wanted)
    rows = [array.reshape(1, -1) for array in arrays.values()]
    results = function.call([np.ascontiguousarray(row) for row in rows])
    return {
        key: np.array(result, dtype=np.float64).reshape(shape)
        for key, result in zip(function.name_out(), results, strict=True)
    }


def columns(name: str, *arguments: FloatArray) -> list[FloatArray]:
    """Apply a generated function of vectors to many at once.

    Parameters
    ----------
    name : str
        Name of the function, e.g. ``"nonlinear_rhs"``.
    *arguments : ndarray, shape (n_k, N)
        For each argument one column per evaluation.

    Returns
    -------
    list of ndarray, shape (N, rows, columns)
        One matrix per evaluation for each output.
    """
    function = generated.load(name)
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
