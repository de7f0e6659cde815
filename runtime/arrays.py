"""Checks at the border, because CasADi broadcasts, pads and zero-fills in silence."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from .errors import GroundrollError
from .generated.names import MODELS, QUANTITIES
from .units import to_si

FloatArray = npt.NDArray[np.float64]

_SIGNS = {">0": (np.greater, "positive"), ">=0": (np.greater_equal, "zero or positive")}


def finite(name: str, value: Any, unit: str | None = None) -> FloatArray:
    """`value` as an array of finite floats; strings in it have units, if the SI unit is told.

    Raises
    ------
    GroundrollError
        If it holds anything else; the message says what and where.
    """
    if unit is not None:
        value = _in_si(name, value, unit)
    try:
        array = np.asarray(value, dtype=np.float64)
        if np.asarray(value).dtype == np.bool_:
            raise TypeError("a truth value is no number")
    except (TypeError, ValueError) as problem:
        raise GroundrollError(
            f"{name} must be a number or an array of numbers, not {value!r}"
        ) from problem
    good = np.isfinite(array)
    if not good.all():
        raise GroundrollError(f"{name} must be finite, but {_where(name, array, ~good)}")
    return array


def positive(name: str, value: Any, unit: str | None = None) -> float:
    """`value` as one positive number."""
    number = finite(name, value, unit)
    if number.ndim or number <= 0:
        raise GroundrollError(f"{name} must be a positive number, not {value!r}")
    return float(number)


def whole(name: str, value: Any, least: int) -> int:
    """`value` as a whole number, not below `least`."""
    number = finite(name, value)
    if number.ndim or number < least or number % 1:
        raise GroundrollError(f"{name} must be a whole number from {least}, not {value!r}")
    return int(number)


def as_inputs(tire: str, force: FloatArray) -> FloatArray:
    """Inputs of a model under a disturbance, shape (inputs, *shape): its first; others are zero."""
    inputs = np.zeros((len(MODELS[tire].inputs), *force.shape))
    inputs[0] = force
    return inputs


def physical(symbol: str, value: Any) -> FloatArray:
    """`value` as an array of finite floats of the sign that the quantity `symbol` must have."""
    quantity = QUANTITIES[symbol]
    label = f"{quantity.name} ({symbol})"
    array = finite(label, value, quantity.unit)
    if quantity.sign:
        accept, words = _SIGNS[quantity.sign]
        good = accept(array, 0.0)
        if not good.all():
            raise GroundrollError(f"{label} must be {words}, but {_where(symbol, array, ~good)}")
    return array


def broadcast(arrays: Mapping[str, FloatArray]) -> tuple[dict[str, FloatArray], tuple[int, ...]]:
    """All arrays in their common shape, and the shape; errors as for `common_shape`."""
    shape = common_shape(arrays)
    return {name: np.broadcast_to(array, shape) for name, array in arrays.items()}, shape


def common_shape(arrays: Mapping[str, FloatArray]) -> tuple[int, ...]:
    """What arrays broadcast to.

    Raises
    ------
    GroundrollError
        If they do not; the message gives each shape.
    """
    different = {array.shape for array in arrays.values()} - {()}
    if len(different) <= 1:
        return different.pop() if different else ()
    try:
        return np.broadcast_shapes(*different)
    except ValueError:
        shapes = ", ".join(f"{name} {a.shape}" for name, a in arrays.items() if a.ndim)
        raise GroundrollError(f"these shapes do not broadcast together: {shapes}") from None


def check_out(name: str, array: Any, shape: tuple[int, ...]) -> None:
    """Refuse an array that results of a shape cannot be written to as they come.

    Raises
    ------
    GroundrollError
        If it is no array of native float64 of that shape, writeable and in C order.
    """
    if not isinstance(array, np.ndarray):
        raise GroundrollError(f"{name} must be an array, not {type(array).__name__}")
    if array.shape != shape:
        raise GroundrollError(f"{name} must have the shape {shape}, not {array.shape}")
    if array.dtype != np.float64:
        raise GroundrollError(f"{name} must hold float64, not {array.dtype}")
    if array.flags.carray:
        return
    if not array.flags.writeable:
        raise GroundrollError(f"{name} is read-only")
    raise GroundrollError(
        f"{name} must be contiguous in C order, as np.empty({shape}) is; its strides are"
        f" {array.strides}"
    )


def _in_si(name: str, value: Any, unit: str) -> Any:
    """`value` with numbers in the SI unit in place of strings."""
    if isinstance(value, str):
        return to_si(value, unit, name)
    return [_in_si(name, v, unit) for v in value] if isinstance(value, (list, tuple)) else value


def _where(name: str, array: FloatArray, bad: npt.NDArray[np.bool_]) -> str:
    index = tuple(int(i) for i in np.argwhere(bad)[0])
    place = f"{name}[{', '.join(map(str, index))}]" if index else name
    return f"{place} = {array[index]}"
