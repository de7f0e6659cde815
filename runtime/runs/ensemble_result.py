"""The result of an ensemble: arrays by name, and what became of each trajectory."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from groundroll.aircraft.aircraft import Aircraft
from groundroll.aircraft.validity import extrapolated_in
from groundroll.base.arrays import FloatArray
from groundroll.base.listing import Listed, span, unit_of
from groundroll.model.models import ModelLike, as_model
from groundroll.motion.lanes import IN_WORDS, STATUS
from groundroll.motion.signals import Polynomials
from groundroll.results.records import Column, Record, measured, run_dims, time_axis
from groundroll.results.results import Result

#: Arrays by name of an ensemble -> what they are called.
_NAMED = {
    "final": "final states",
    "samples": "samples",
    "largest": "extremes",
    "first": "limits",
    "when": "events",
}
_PLAIN = ("status", "steps", "estimate", "end", "fate")
_ABOUT = ("t", "tol", "limits", "within")


class Named(Mapping[str, FloatArray]):
    """Arrays of quantities of a model by symbol or by full name."""

    def __init__(self, arrays: Mapping[str, FloatArray], what: str, model: ModelLike) -> None:
        self._arrays = dict(arrays)
        self._what = what
        self._model = model

    def __getitem__(self, name: str) -> FloatArray:
        model = as_model(self._model)
        return self._arrays[model.symbol(name, "name", tuple(self._arrays), self._what)]

    def __iter__(self) -> Iterator[str]:
        return iter(self._arrays)

    def __len__(self) -> int:
        return len(self._arrays)

    def __repr__(self) -> str:
        return f"{self._what}: {', '.join(self._arrays) or 'none'}"


@dataclass(frozen=True, repr=False, eq=False)
class Ensemble(Listed, Result):
    """What became of many trajectories; ``ens["v"]`` is an array over them.

    In tables and files extremes are called ``largest_alpha`` and ``first_alpha``, and with samples
    over ``t`` the final states ``final_v``.

    Attributes
    ----------
    aircraft : Aircraft
        What rolled, its parameters arrays where they vary.
    model : str or Model
        Which model.
    start : mapping of str to ndarray
        Initial states by symbol.
    inputs : mapping of str to ndarray or Signal
        Inputs by symbol, constant or over time.
    t, tol : float
        Duration, s, and the error asked for.
    status : ndarray of int8
        What became of each trajectory, an index of `STATUS`: ``ok``; ``not finite``; ``step
        limit``; ``unsure`` (the end was reached, but the estimated error stayed above `tol`);
        ``left the range`` (of `within`). Every array has the shape of the trajectories.
    steps : ndarray of int32
        Steps that were tried; 0 where that is not known (without a C compiler).
    estimate : ndarray
        Estimated error relative to each state's scale; NaN where that is not known.
    end : ndarray
        When each trajectory ended, s.
    fate : ndarray of int8
        Which event ended it, an index of the names in `events`; -1 if none did.
    final : mapping of str to ndarray
        States at the end; NaN unless the status is ``ok`` or ``unsure``.
    at : ndarray, shape (times,)
        Times of the samples, s.
    samples : mapping of str to ndarray, each of shape (*shape, times)
        States and outputs at those times; NaN after an early end.
    largest, first : mapping of str to ndarray
        Largest magnitude, and the first time, s, at which it reached its limit: infinite if never.
        What misses a limit by no more than the tolerance has reached it.
    events : mapping of str to ndarray
        When each event first happened, s; infinite if never.
    limits, within : mapping of str to float
        What was asked for.
    """

    aircraft: Aircraft
    model: ModelLike
    start: Mapping[str, FloatArray]
    inputs: Mapping[str, Any]
    t: float
    tol: float
    status: npt.NDArray[np.int8]
    steps: npt.NDArray[np.int32]
    estimate: FloatArray
    end: FloatArray
    fate: npt.NDArray[np.int8]
    final: Named
    at: FloatArray
    samples: Named
    largest: Named
    first: Named
    events: Mapping[str, FloatArray]
    limits: Mapping[str, float]
    within: Mapping[str, float]

    #: Names of the values of `status`.
    STATUS = STATUS

    @property
    def ok(self) -> npt.NDArray[np.bool_]:
        """Where all went well."""
        return np.asarray(self.status == 0)

    @property
    def counts(self) -> dict[str, int]:
        """How many trajectories have each status; those that none has are left out."""
        found = np.bincount(self.status.reshape(-1), minlength=len(STATUS)).tolist()
        return {name: n for name, n in zip(STATUS, found, strict=True) if n}

    def __getitem__(self, name: str) -> FloatArray:
        """Samples of a state or output if there are any, its final values otherwise."""
        return (self.samples if self.at.size else self.final)[name]

    def _record(self) -> Record:
        runs, model = run_dims(self.status.shape), as_model(self.model)
        q = model.quantities
        final = "final_" if self.at.size else ""
        results = {
            "status": Column(runs, self.status, names=STATUS),
            "steps": Column(runs, self.steps),
            "estimate": Column(runs, self.estimate),
            "end": Column(runs, self.end, "s", "end of the trajectory"),
            "fate": Column(runs, self.fate),
            **{f"when_{s}": Column(runs, v, "s", f"first {s}") for s, v in self.events.items()},
            **{f"{final}{s}": measured(runs, v, q[s]) for s, v in self.final.items()},
            **{f"largest_{s}": measured(runs, v, q[s]) for s, v in self.largest.items()},
            **{f"first_{s}": Column(runs, v, "s", f"passed {s}") for s, v in self.first.items()},
        }
        if self.at.size:
            results["t"] = time_axis(self.at)
        results |= {s: measured((*runs, "t"), v, q[s]) for s, v in self.samples.items()}
        signals = {s: v.packed() for s, v in self.inputs.items() if isinstance(v, Polynomials)}
        constant = {s: v for s, v in self.inputs.items() if s not in signals}
        given = {**{f"{s}0": v for s, v in self.start.items()}, **constant}
        about = {name: getattr(self, name) for name in _ABOUT} | {"signals": signals}
        return Record("ensemble", self.aircraft, model, runs, results, given=given, about=about)

    @classmethod
    def _of(cls, record: Record) -> Ensemble:
        results = dict(record.results)
        plain = {name: results.pop(name).values for name in _PLAIN}
        at = results.pop("t", time_axis(np.empty(0))).values
        found: dict[str, dict[str, FloatArray]] = {name: {} for name in _NAMED}
        for name, column in results.items():
            kind, _, s = name.partition("_")
            if kind not in _NAMED:
                kind, s = ("samples" if "t" in column.dims else "final"), name
            found[kind][s] = column.values
        key, events = record.model.key, found.pop("when")
        named: dict[str, Any] = {s: Named(found[s], _NAMED[s], key) for s in found}
        about = dict(record.about)
        signals = {s: Polynomials.unpacked(v) for s, v in about.pop("signals").items()}
        inputs = record.model.inputs
        return cls(
            aircraft=record.aircraft,
            model=key,
            start={s[:-1]: v for s, v in record.given.items() if s not in inputs},
            inputs={s: signals[s] if s in signals else record.given[s] for s in inputs},
            status=plain["status"].astype(np.int8),
            steps=plain["steps"].astype(np.int32),
            estimate=plain["estimate"],
            end=plain["end"],
            fate=plain["fate"].astype(np.int8),
            at=at,
            events=events,
            **named,
            **about,
        )

    def _title(self) -> str:
        counts = ", ".join(f"{n} {name}" for name, n in self.counts.items())
        shape = " x ".join(map(str, self.status.shape)) or "1"
        whose = f"{self.aircraft.name!r}, {as_model(self.model).name} model"
        return (
            f"Ensemble of {whose}: {shape} trajectories of {self.t:g} s, tol {self.tol:g}: {counts}"
        )

    def _rows(self) -> Iterable[Sequence[str]]:
        samples = f"at {self.at.size} times"
        q = as_model(self.model).quantities
        parts = (("at the end", self.final), (samples, self.samples), ("largest", self.largest))
        for words, arrays in parts:
            for s, values in arrays.items():
                yield words, s, q[s].name, span(values), unit_of(q[s])

    def _notes(self) -> Iterable[str]:
        for s, limit in self.limits.items():
            share = np.isfinite(self.first[s]).mean()
            unit = unit_of(as_model(self.model).quantities[s])
            yield f"{100 * share:.3g} % reach |{s}| = {limit:g} {unit}".rstrip()
        for status, n in self.counts.items():
            if status in IN_WORDS:
                yield f"{n} {status}: {IN_WORDS[status]}"
        yield from extrapolated_in(self.aircraft, self.largest)
