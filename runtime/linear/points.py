"""A model and its Jacobians at many points at once."""

from __future__ import annotations

import ctypes
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
import numpy.typing as npt

from groundroll.aircraft.aircraft import Aircraft
from groundroll.base.arrays import FloatArray
from groundroll.base.memory import check_memory, room
from groundroll.generated import Pack
from groundroll.generated.compiler import NoCompilerError
from groundroll.generated.kernels import load, processors, useful_threads
from groundroll.generated.library import say_slower
from groundroll.model.evaluate import columns
from groundroll.model.models import Model

#: Results, in the order in which the kernels number their elements: rates and outputs, and their
#: Jacobians by states, inputs and parameters.
NAMES = ("f", "fx", "fu", "fp", "g", "gx", "gu", "gp")
#: Points times the square of the arguments of a model from which a second thread pays.
_MUCH = 1e8

IntArray = npt.NDArray[np.int32]


@dataclass(frozen=True)
class Points:
    """One or many points at which a model is evaluated.

    Attributes
    ----------
    model : Model
    aircraft : Aircraft
    values : mapping of str to ndarray
        Every state, input and parameter by symbol, in the order of the model, SI units with
        radians; each a number or an array that broadcasts to the shape of the points.
    shape : tuple of int
    """

    model: Model
    aircraft: Aircraft
    values: Mapping[str, FloatArray]
    shape: tuple[int, ...]

    @property
    def count(self) -> int:
        """How many there are."""
        return math.prod(self.shape)

    @property
    def columns(self) -> list[FloatArray]:
        """The values one after the other: a column of all points, or one number."""
        return [
            np.ascontiguousarray(np.broadcast_to(each, self.shape)).reshape(-1)
            if each.ndim
            else each.reshape(1)
            for each in self.values.values()
        ]

    @property
    def vectors(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """States, inputs and parameters with one column for each point."""
        table = np.stack([np.broadcast_to(each, self.count) for each in self.columns])
        n, m = len(self.model.states), len(self.model.inputs)
        return table[:n], table[n : n + m], table[n + m :]

    def evaluate(
        self, *names: str, over: Sequence[str] | None = None, threads: int | None = None
    ) -> dict[str, FloatArray]:
        """Rates, outputs and Jacobians.

        Parameters
        ----------
        *names : str
            Of `NAMES`: ``f`` and ``g`` are rates and outputs, a second letter says by what their
            Jacobian is: states, inputs or parameters.
        over : sequence of str, optional
            The states whose rates, and by which derivatives, are wanted; the dynamic ones if
            omitted.
        threads : int, optional
            Does not change a bit of the result; by default as many as help.

        Returns
        -------
        dict of ndarray
            By name, SI units with radians: vectors of shape (*shape, n), Jacobians of shape
            (*shape, rows, columns).
        """
        elements = _elements(self.model, names, self.model.dynamic if over is None else tuple(over))
        check_memory(8 * self.count * sum(e.size for e in elements.values()), "so many points")
        pieces = room(*((*self.shape, *e.shape) for e in elements.values()))
        found = dict(zip(elements, pieces, strict=True))
        try:
            kernel = _kernel(self.model, any(name.endswith("p") for name in names))
        except NoCompilerError as problem:
            say_slower(problem)
            _in_vm(self, elements, found)
            return found
        given = self.columns
        much = self.count * len(given) ** 2 > _MUCH
        threads = threads or (processors() if much else 1)
        run(kernel, self.count, given, [(found[n], e) for n, e in elements.items()], threads)
        return found


def run(
    kernel: Any,
    count: int,
    given: Sequence[FloatArray],
    wanted: Sequence[tuple[FloatArray, IntArray]],
    threads: int = 1,
) -> None:
    """Call a kernel of ``points.c``.

    Parameters
    ----------
    kernel
        The function of its library.
    count : int
        Number of points.
    given : sequence of ndarray
        For each argument a column of `count`, or one number.
    wanted : sequence of tuple
        Arrays to be filled, and which elements of the results go there at each point.
    threads : int
        At most.
    """
    pointers = (ctypes.c_void_p * len(given))(*(c.ctypes.data for c in given))
    strides = (ctypes.c_int64 * len(given))(*(int(c.size > 1) for c in given))
    places = (_Wanted * len(wanted))(
        *(_Wanted(array.ctypes.data, e.size, e.ctypes.data) for array, e in wanted)
    )
    job = _Job(
        count,
        useful_threads(threads, count),
        len(wanted),
        ctypes.addressof(pointers),
        ctypes.addressof(strides),
        ctypes.addressof(places),
    )
    kernel(ctypes.byref(job))


class _Wanted(ctypes.Structure):
    """``wanted_t`` of ``points.c``."""

    _fields_ = (("data", ctypes.c_void_p), ("size", ctypes.c_int64), ("element", ctypes.c_void_p))


class _Job(ctypes.Structure):
    """``points_t`` of ``points.c``."""

    _fields_ = (
        *((name, ctypes.c_int64) for name in ("n", "threads", "n_wanted")),
        *((name, ctypes.c_void_p) for name in ("given", "stride", "wanted")),
    )


@cache
def _kernel(model: Pack, by_parameters: bool) -> Any:
    more = ("-DBY_PARAMETERS",) if by_parameters else ()
    return load(model.sources / "points.c", model.digest, "points", *more).points


@cache
def _elements(model: Pack, names: tuple[str, ...], over: tuple[str, ...]) -> dict[str, IntArray]:
    """For each result the numbers of the elements that are wanted, in its shape."""
    kept = [model.states.index(s) for s in over]
    width = {"x": len(model.states), "u": len(model.inputs), "p": len(model.parameters)}
    found, first = {}, 0
    for name in NAMES:
        rows = len(model.states if name[0] == "f" else model.outputs)
        shape = (rows, width[name[1]]) if name[1:] else (rows,)
        numbers = np.arange(first, first + math.prod(shape), dtype=np.int32).reshape(shape)
        first += numbers.size
        numbers = numbers[kept] if name[0] == "f" else numbers
        found[name] = np.ascontiguousarray(numbers[:, kept] if name[1:] == "x" else numbers)
    return {name: found[name] for name in names}


def _in_vm(
    points: Points, elements: Mapping[str, IntArray], found: Mapping[str, FloatArray]
) -> None:
    """The same by CasADi's functions, where nothing can be compiled."""
    model, n = points.model, points.count
    results = {}
    for name, function in (("f", "rhs"), ("g", "outputs")):
        if name in elements:
            (results[name],) = columns(model.expression(function), *points.vectors)
    if elements.keys() - results.keys():
        jacobians = columns(model.expression("jacobians"), *points.vectors)
        results |= dict(zip(("fx", "fu", "fp", "gx", "gu", "gp"), jacobians, strict=True))
    every = _elements(model, NAMES, model.states)
    for name, element in elements.items():
        flat = results[name].reshape(n, -1)
        places = element - every[name].min(initial=2**31 - 1)
        found[name][...] = flat[:, places].reshape(found[name].shape)
