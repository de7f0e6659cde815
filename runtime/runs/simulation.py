"""Simulation of the ground roll after a disturbance."""

from __future__ import annotations

import warnings
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from groundroll.aircraft.aircraft import Aircraft, of_aircraft
from groundroll.aircraft.validity import extrapolated_in
from groundroll.aircraft.values import given
from groundroll.base.arrays import FloatArray, positive, whole
from groundroll.base.errors import GroundrollError
from groundroll.base.listing import Listed, span, unit_of
from groundroll.base.memory import check_memory
from groundroll.model.models import ModelLike, as_model
from groundroll.model.shown import UnitsLike
from groundroll.motion.engine import integrated
from groundroll.motion.events import Lookout, lookout
from groundroll.motion.lanes import IN_WORDS, STATUS, Outcome
from groundroll.motion.plan import Plan, planned
from groundroll.motion.signals import Polynomials, Signal
from groundroll.results.doors import drawn
from groundroll.results.records import Column, Record, measured, run_dims, time_axis
from groundroll.results.results import Result

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .metrics import Metrics


@dataclass(frozen=True, repr=False)
class Trajectory(Listed, Result):
    """A simulated ground roll; ``run["v"]`` or ``run["lateral_velocity"]`` is an array over time.

    Attributes
    ----------
    t : ndarray, shape (samples,)
        Time, s.
    values : mapping of str to ndarray, shape (*shape, samples)
        States and outputs by symbol, SI units with radians. `shape` is that of whatever array
        was passed; () for a single run.
    aircraft : Aircraft
        What was simulated, at the speed of the run.
    model : str or Model
        Which model.
    signals : mapping of str to Signal
        The inputs that varied over time, by symbol; see `groundroll.signals`.
    status : ndarray of int8
        What became of each run, an index of `STATUS`: ``ok``; ``not finite`` and ``step limit``
        (it grew without bound or changed too fast, and is NaN from there on); ``unsure`` (its
        estimated error stayed above the tolerance).
    end : ndarray
        When each run ended, s: at the last sample, or when an event ended it.
    fate : ndarray of int8
        Which event ended it, an index of the names in `events`; -1 if none did.
    events : mapping of str to ndarray
        When each event of the model first happened, s; infinite if never.
    """

    t: FloatArray
    values: Mapping[str, FloatArray]
    aircraft: Aircraft
    model: ModelLike
    signals: Mapping[str, Signal] = field(default_factory=dict)
    status: npt.NDArray[np.int8] = field(default_factory=lambda: np.zeros((), np.int8))
    end: FloatArray = field(default_factory=lambda: np.array(np.nan))
    fate: npt.NDArray[np.int8] = field(default_factory=lambda: np.full((), -1, np.int8))
    events: Mapping[str, FloatArray] = field(default_factory=dict)

    #: Names of the values of `status`.
    STATUS = STATUS

    @property
    def gust(self) -> Signal | None:
        """The first input of the model, if it varied over time."""
        return self.signals.get(as_model(self.model).inputs[0])

    @property
    def disturbance(self) -> FloatArray:
        """The first input of the model: constant, or over time if it varied."""
        first = as_model(self.model).inputs[0]
        return self.values[first] if first in self.signals else self.values[first][..., 0]

    def __getitem__(self, name: str) -> FloatArray:
        if name in ("t", "time"):
            return self.t
        return self.values[
            as_model(self.model).symbol(name, "state or output", tuple(self.values), "this run")
        ]

    def metrics(self, of: str | Sequence[str] = "y") -> Metrics:
        """Steady state, peak, recovery, rise and settling time, overshoot of y or other states.

        See `groundroll.runs.metrics.metrics`.
        """
        from .metrics import metrics

        return metrics(self, of)

    def plot(
        self,
        names: Sequence[str] | None = None,
        ax: Axes | Sequence[Axes] | None = None,
        *,
        units: UnitsLike = None,
    ) -> tuple[Axes, ...]:
        """Plot states, outputs or inputs over time; see `groundroll.view.plots.time_history`."""
        axes: tuple[Axes, ...] = drawn("history", self, names, ax, units)
        return axes

    def _record(self) -> Record:
        runs, model = run_dims(self.status.shape), as_model(self.model)
        results = {
            "t": time_axis(self.t),
            **{
                s: measured((*runs, "t"), values, model.quantities[s])
                for s, values in self.values.items()
            },
            "status": Column(runs, self.status, names=STATUS),
            "end": Column(runs, self.end, "s", "end of the run"),
            "fate": Column(runs, self.fate),
            **{f"when_{s}": Column(runs, v, "s", f"first {s}") for s, v in self.events.items()},
        }
        signals = {s: signal.over(self.t[-1]).packed() for s, signal in self.signals.items()}
        about = {"signals": signals}
        return Record("trajectory", self.aircraft, model, runs, results, per=("t",), about=about)

    @classmethod
    def _of(cls, record: Record) -> Trajectory:
        columns = record.results
        values = {s: column.values for s, column in columns.items() if "t" in column.dims}
        return cls(
            values.pop("t"),
            values,
            record.aircraft,
            record.model.key,
            {s: Polynomials.unpacked(data) for s, data in record.about["signals"].items()},
            record["status"].astype(np.int8),
            record["end"],
            record["fate"].astype(np.int8),
            {s[5:]: column.values for s, column in columns.items() if s.startswith("when_")},
        )

    def _repr_html_(self) -> str:
        from groundroll.base.notebook import sparkline, table

        rows = [
            (s, words, sparkline(self[s].reshape(-1, self.t.size)), *rest)
            for s, words, *rest in self._rows()
        ]
        return table(self._title(), rows, self._notes())

    def _title(self) -> str:
        shape = self["v"].shape[:-1]
        many = f", {' x '.join(map(str, shape))} runs" if shape else ""
        whose = f"{self.aircraft.name!r}, {as_model(self.model).name} model"
        return f"Trajectory of {whose}, 0 to {self.t[-1]:g} s, {self.t.size} samples{many}"

    def _notes(self) -> Iterable[str]:
        return extrapolated_in(self.aircraft, self.values)

    def _rows(self) -> Iterable[Sequence[str]]:
        last = np.maximum((self.t <= self.end[..., None]).sum(axis=-1) - 1, 0)[..., None]
        for s, series in self.values.items():
            end = f"at the end {span(np.take_along_axis(series, last, axis=-1))}"
            peak = f"largest {np.nanmax(np.abs(series)):.5g}"
            q = as_model(self.model).quantities[s]
            yield s, q.name, peak, end, unit_of(q)


@of_aircraft
def simulate(
    plane: Aircraft,
    model: ModelLike = "nonlinear",
    *,
    t: float | str = 5.0,
    samples: int = 501,
    until: str | Iterable[str] = (),
    tol: float = 1e-9,
    **values: Any,
) -> Trajectory:
    """Simulate the ground roll of an aircraft.

    As everywhere, a number may be a text with a unit: ``v0="1 kt"``, ``disturbance="70 lbf"``.

    Parameters
    ----------
    plane : Aircraft
        The aircraft; its parameters may be arrays.
    model : str or Model
        ``"linear"``, ``"nonlinear"``, another that ships, or one of your own.
    t : float
        Duration, s.
    samples : int
        Number of equally spaced samples, the first at 0 and the last at `t`.
    until : str or iterable of str
        Events of the model at which a run ends; NaN from there on.
    tol : float
        Error of every state relative to its largest magnitude in the run; as for
        `groundroll.ensemble`.
    **values : float, array, str, Signal or callable
        By symbol or full name: inputs (``disturbance``, N), constant or over time as one of
        `groundroll.signals` or `groundroll.gusts` or as a function from an array of times, s, to
        an array of values; parameters that differ from the aircraft's (``speed``); and initial
        states, by symbol and a zero (``v0``, ``psi0``; zero if omitted). Arrays broadcast with
        each other and with the aircraft's own.

    Returns
    -------
    Trajectory
        States and outputs over time.

    Raises
    ------
    GroundrollError
        For unknown names, values that cannot be, or if every run leaves the numbers. If some do,
        a warning says which, and they are NaN from there on.
    """
    known = as_model(model)
    duration, count = positive("t", t, "s"), whole("samples", samples, 2)
    rows = (*known.states, *known.outputs)
    check_memory(8 * count * len((*rows, *known.inputs)), "the series")
    options = ("t", "samples", "until", "tol")
    sorted_out = given(plane, known, values, "simulate", others=options, over_time=True)
    look = lookout(known, events=[event.name for event in known.events], until=until)
    times = np.linspace(0.0, duration, count)
    plan = replace(
        planned(sorted_out, known, duration, tol, times),
        sampled=rows,
        watches=look.watches(known),
    )
    found = integrated(plan)
    _report(found)
    return _shaped(plan, look, found)


def _report(found: Outcome) -> None:
    """Say which runs have left the numbers; raise an error if none has not."""
    lost = np.flatnonzero((found.status != 0) & (found.status != STATUS.index("unsure")))
    if lost.size == 0:
        return
    runs, status = found.status.size, STATUS[found.status[lost[0]]]
    text = f"run {lost[0]} of {runs}: {IN_WORDS[status]}, at t = {found.end[lost[0]]:.4g} s"
    if lost.size == runs:
        raise GroundrollError(text)
    more = f", and so in {lost.size - 1} others" if lost.size > 1 else ""
    warnings.warn(f"{text}{more}; NaN from there on", RuntimeWarning, stacklevel=3)


def _shaped(plan: Plan, look: Lookout, found: Outcome) -> Trajectory:
    """The result in the shape of the runs."""
    shape, times = plan.shape, plan.at
    values = {s: series.reshape((*shape, times.size)) for s, series in found.samples.items()}
    after = times > found.end.reshape((*shape, 1))
    for s in plan.model.inputs:
        level = plan.signals[s](times) if s in plan.signals else plan.inputs[s][..., None]
        values[s] = np.where(after, np.nan, level)
    events = {s: when.reshape(shape) for s, when in zip(look.events, found.first, strict=True)}
    return Trajectory(
        times,
        values,
        plan.aircraft,
        plan.model.key,
        plan.signals,
        found.status.reshape(shape),
        found.end.reshape(shape),
        found.cause.reshape(shape),
        events,
    )
