"""Checks at the border, because CasADi broadcasts, pads and zero-fills in silence."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal
from numbers import Real
from typing import Any

import numpy as np
import numpy.typing as npt

from groundroll.generated import Quantity

from .errors import GroundrollError, shown
from .memory import check_memory
from .units import UnitError, expected, to_si

FloatArray = npt.NDArray[np.float64]

#: What NumPy would make numbers of.
_NO_NUMBERS = (bytes, bytearray, memoryview, np.ma.MaskedArray)

_SIGNS = {">0": (np.greater, "positive"), ">=0": (np.greater_equal, "zero or positive")}


def finite(name: str, value: Any, unit: str = "1") -> FloatArray:
    """`value` as an array of finite floats; what it may be, and errors, as for `in_si`."""
    array = in_si(name, value, unit)
    own = stored(array)
    good = np.isfinite(own)
    if not good.all():
        raise GroundrollError(f"{name} must be finite, but {_where(name, own, ~good)}")
    return array


def stored(array: FloatArray) -> FloatArray:
    """What an array has in memory: of what is only broadcast, once."""
    if all(array.strides):
        return array
    return array[tuple(slice(None if step else 1) for step in array.strides)]


def in_si(name: str, value: Any, unit: str = "1") -> FloatArray:
    """`value` as an array of floats in an SI unit.

    Parameters
    ----------
    name : str
        What it is, for the error message.
    value : float, array, str, quantity of pint, or lists of them
        Numbers are in the SI unit; strings and quantities have units of their own.
    unit : str, optional
        The SI unit; a pure number if omitted.

    Raises
    ------
    GroundrollError
        If it holds anything else (a truth value, a date, a masked or complex number, bytes): what
        NumPy would make a number of is not always what was meant.
    """
    if type(value) is np.ndarray and value.dtype.kind in "fiu":
        check_memory(8 * value.size, name)
        own = np.asarray(stored(value), dtype=np.float64)
        return own if own.shape == value.shape else np.broadcast_to(own, value.shape)
    if isinstance(value, range):
        check_memory(8 * max(0, (value.stop - value.start) // value.step), name)
    try:
        return np.asarray(_in_si(name, value, unit), dtype=np.float64)
    except GroundrollError:
        raise
    except (TypeError, ValueError, OverflowError, RecursionError) as problem:
        raise _no_number(name, value) from problem


def single(name: str, value: Any, unit: str = "1") -> float:
    """`value` as one number."""
    number = finite(name, value, unit)
    if number.ndim:
        raise GroundrollError(f"{name} must be one number, not {shown(value)}")
    return float(number)


def positive(name: str, value: Any, unit: str = "1") -> float:
    """`value` as one positive number."""
    number = finite(name, value, unit)
    if number.ndim or number <= 0:
        raise GroundrollError(f"{name} must be a positive number, not {shown(value)}")
    return float(number)


def whole(name: str, value: Any, least: int) -> int:
    """`value` as a whole number, not below `least`."""
    number = finite(name, value)
    if number.ndim or number < least or number % 1:
        raise GroundrollError(f"{name} must be a whole number from {least}, not {shown(value)}")
    return int(number)


def physical_of(quantity: Quantity, value: Any) -> FloatArray:
    """`value` as an array of finite floats of the sign that a quantity must have."""
    label = f"{quantity.name} ({quantity.symbol})"
    array = finite(label, value, quantity.unit)
    if quantity.sign:
        accept, words = _SIGNS[quantity.sign]
        own = stored(array)
        good = accept(own, 0.0)
        if not good.all():
            raise GroundrollError(
                f"{label} must be {words}, but {_where(quantity.symbol, own, ~good)}"
            )
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
    """`value` with numbers in the SI unit in place of strings and quantities."""
    if type(value) in (float, int):
        return value
    if isinstance(value, str):
        return to_si(value, unit, name)
    if isinstance(value, (list, tuple)):
        return [_in_si(name, v, unit) for v in value]
    if hasattr(value, "to_root_units"):
        return _of_quantity(name, value, unit)
    if isinstance(value, _NO_NUMBERS) or (isinstance(value, np.ndarray) and _has_unit(value)):
        raise _no_number(name, value)
    array = np.asarray(value)
    if array.dtype.kind in "fiu":
        return array
    if array.ndim and array.dtype.kind in "OU":
        return _in_si(name, array.tolist(), unit)
    if array.dtype.kind == "O" and isinstance(value, (Real, Decimal)):
        return float(value)
    raise _no_number(name, value)


def _has_unit(array: Any) -> bool:
    """Whether an array is one of another library (astropy, unyt) that hides a unit."""
    return hasattr(array, "unit") or hasattr(array, "units")


def _of_quantity(name: str, value: Any, unit: str) -> FloatArray:
    """A quantity of pint, by the definitions of its own registry."""
    none, root = type(value)(0.0, value.units).to_root_units(), value.to_root_units()
    try:
        if none.magnitude:
            raise UnitError(name, "no multiple of an SI unit", expected(unit))
        return finite(name, root.magnitude) * to_si(f"1 {root.units:D}", unit, name)
    except UnitError as problem:
        found = f"{shown(value)}, {problem.found.rpartition(', ')[2]}"
        raise UnitError(name, found, problem.expected) from None


def _no_number(name: str, value: Any) -> GroundrollError:
    plain = type(value) is np.ndarray
    kind = f"{value.dtype} array" if plain else type(value).__name__
    return GroundrollError(
        f"{name} must be a number or an array of numbers, not {shown(value)} ({kind})"
    )


def _where(name: str, array: FloatArray, bad: npt.NDArray[np.bool_]) -> str:
    index = tuple(int(i) for i in np.argwhere(bad)[0])
    place = f"{name}[{', '.join(map(str, index))}]" if index else name
    return f"{place} = {array[index]}"
