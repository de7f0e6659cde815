"""The closed forms of the linear model at millions of points."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from groundroll.aircraft.aircraft import Aircraft, of_aircraft
from groundroll.base.arrays import FloatArray, check_out, common_shape
from groundroll.base.errors import GroundrollError, one_of, unknown
from groundroll.base.listing import Listed, span, unit_of
from groundroll.base.memory import check_memory
from groundroll.generated import PACKS, Quantity
from groundroll.model.evaluate import names_of, sweep_into
from groundroll.model.models import as_model
from groundroll.model.names import listed, parameter_symbols, symbol
from groundroll.motion.chunks import thread_count
from groundroll.results.records import Record, measured, run_dims
from groundroll.results.results import Result

from .closed_forms import CLOSED_FORMS, OVER_SPEED
from .modes import ComplexArray

#: Name of a result -> generated function, its result.
SWEPT = {
    **{name: ("linear_modes", name) for name in ("re_1", "im_1", "re_2", "im_2")},
    **{
        name: ("linear_modes" if function == "modes" else function, result)
        for name, (function, result) in (CLOSED_FORMS | OVER_SPEED).items()
        if function != "times"
    },
}
_LINEAR = PACKS["linear"].quantities
_MODES = ("re_1", "im_1", "re_2", "im_2", "damping_ratio", "natural_frequency")


@dataclass(frozen=True, repr=False, eq=False)
class Sweep(Listed, Result, Mapping[str, FloatArray]):
    """Results by name, each of the shape of the points; ``sweep["decay_rate"]``.

    Attributes
    ----------
    aircraft : Aircraft
        Its parameters arrays where they vary.
    arrays : dict of ndarray
        SI units with radians.
    """

    aircraft: Aircraft
    arrays: dict[str, FloatArray]

    def __getitem__(self, name: str) -> FloatArray:
        if name not in self.arrays:
            raise unknown("result", name, [*self.arrays, "eigenvalues"], "this sweep")
        return self.arrays[name]

    def __iter__(self) -> Any:
        return iter(self.arrays)

    def __len__(self) -> int:
        return len(self.arrays)

    def _record(self) -> Record:
        runs = run_dims(next(iter(self.arrays.values())).shape)
        results = {name: measured(runs, v, _quantity(name)) for name, v in self.arrays.items()}
        return Record("sweep", self.aircraft, as_model("linear"), runs, results)

    @classmethod
    def _of(cls, record: Record) -> Sweep:
        return cls(record.aircraft, {name: record[name] for name in record.results})

    @property
    def eigenvalues(self) -> ComplexArray:
        """Of A, 1/s, shape (..., 2): the larger real part first."""
        pairs = ((self["re_1"], self["im_1"]), (self["re_2"], self["im_2"]))
        return np.stack([re + 1j * im for re, im in pairs], axis=-1)

    def _title(self) -> str:
        shape = next(iter(self.arrays.values())).shape
        return f"Sweep of {self.aircraft.name!r}: {' x '.join(map(str, shape)) or 1} points"

    def _rows(self) -> Iterable[Sequence[str]]:
        for name, array in self.arrays.items():
            yield name, span(array), unit_of(_quantity(name))


@of_aircraft
def sweep(
    plane: Aircraft,
    of: Iterable[str] = _MODES,
    *,
    threads: int | None = None,
    out: Mapping[str, FloatArray] | None = None,
    **values: Any,
) -> Sweep:
    """Eigenvalues, damping, frequencies and margins of the linear model at many points.

    Parameters
    ----------
    plane : Aircraft
        The aircraft; its parameters may be arrays.
    of : iterable of str
        ``re_1``, ``im_1``, ``re_2``, ``im_2`` (the eigenvalues) and names of `groundroll.Margins`
        or `groundroll.SpeedWindow`. Default: eigenvalues, damping ratio, natural frequency.
    threads : int, optional
        Every processor if omitted; does not change a bit of the result.
    out : mapping of str to ndarray, optional
        Arrays by name of the result, or an earlier `Sweep`, to write to; each of float64, in C
        order, and of the shape of the points. To write to new memory takes longer than the work.
    **values : float or array
        Parameters by symbol or full name; they broadcast.

    Returns
    -------
    Sweep
        Results by name; the arrays of `out` if it is given.

    Raises
    ------
    GroundrollError
        For unknown names, values that cannot be, shapes that do not broadcast, or an `out` that
        cannot be written to.
    """
    names = _names(of)
    for name in values:
        symbol(name, "parameter", parameter_symbols(), "sweep")
    aircraft = plane.replace(**values) if values else plane
    count = thread_count(threads)
    functions = list(dict.fromkeys(SWEPT[name][0] for name in names))
    needed = dict.fromkeys(s for f in functions for s in names_of(f)[0])
    given = {s: aircraft[s] for s in needed}
    shape = common_shape(given)
    results = _room(names, shape, out)
    for function in functions:
        wanted = {SWEPT[name][1]: results[name] for name in names if SWEPT[name][0] == function}
        sweep_into(function, given, shape, wanted, count)
    return Sweep(aircraft, results)


def _quantity(name: str) -> Quantity:
    return _LINEAR[SWEPT[name][1]]


def _names(of: Iterable[str]) -> tuple[str, ...]:
    names = tuple(dict.fromkeys(one_of("result", name, SWEPT) for name in listed("of", of)))
    if not names:
        raise GroundrollError("nothing to sweep: of is empty")
    return names


def _room(
    names: tuple[str, ...], shape: tuple[int, ...], out: Mapping[str, FloatArray] | None
) -> dict[str, FloatArray]:
    """Where the results go."""
    if out is None:
        check_memory(8 * len(names) * math.prod(shape), "the results")
        return {name: np.empty(shape) for name in names}
    if not isinstance(out, Mapping) or set(out) != set(names):
        given = ", ".join(map(str, out)) if isinstance(out, Mapping) else type(out).__name__
        raise GroundrollError(
            f"out must map the names of the results to arrays: {', '.join(names)}; not {given}"
        )
    for name in names:
        check_out(f"out[{name!r}]", out[name], shape)
    in_memory = sorted(names, key=lambda name: out[name].ctypes.data)
    for one, other in pairwise(in_memory):
        if np.may_share_memory(out[one], out[other]):
            raise GroundrollError(f"out[{one!r}] and out[{other!r}] share memory")
    return {name: out[name] for name in names}
