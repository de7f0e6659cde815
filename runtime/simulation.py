"""Simulation of the ground roll after a disturbance."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from .aircraft import Aircraft
from .arrays import FloatArray, as_inputs, finite, positive, whole
from .errors import unknown
from .evaluate import columns
from .gusts import Gust, as_gust, sampled
from .integration import integrate, integrate_varying
from .listing import Listed, span, unit_of
from .memory import check_memory
from .models import Model, ModelLike, as_model
from .records import Record, measured, run_dims, time_axis
from .results import Result

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
    disturbance : ndarray
        Side force on the tail, N: constant, or over time, shape (*shape, samples), if `gust` is
        given. ``run["disturbance"]`` is the series over time either way.
    gust : Gust, optional
        What varied over time; see `groundroll.gusts`.
    """

    t: FloatArray
    values: Mapping[str, FloatArray]
    aircraft: Aircraft
    model: ModelLike
    disturbance: FloatArray
    gust: Gust | None = None

    def __getitem__(self, name: str) -> FloatArray:
        return self.values[
            as_model(self.model).symbol(name, "state or output", tuple(self.values), "this run")
        ]

    def metrics(self, of: str | Sequence[str] = "y") -> Metrics:
        """Steady state, peak, recovery, rise and settling time, overshoot of y or other states.

        See `groundroll.metrics.metrics`.
        """
        from .metrics import metrics

        return metrics(self, of)

    def plot(
        self,
        names: Sequence[str] = ("y", "theta"),
        ax: Axes | Sequence[Axes] | None = None,
    ) -> tuple[Axes, ...]:
        """Plot states or outputs over time; see `groundroll.plots.time_history`."""
        from .plots import time_history

        return time_history(self, names, ax)

    def _record(self) -> Record:
        runs = run_dims(self["v"].shape[:-1])
        model = as_model(self.model)
        series = {
            s: measured((*runs, "t"), values, model.quantities[s])
            for s, values in self.values.items()
        }
        about: dict[str, Any] = {"disturbance": "constant"}
        if self.gust is not None:
            ended = bool((self.gust.end <= self.t[-1]).all())
            about |= {"disturbance": self.gust.label, "ended": ended}
        results = {"t": time_axis(self.t), **series}
        return Record("trajectory", self.aircraft, model, runs, results, per=("t",), about=about)

    @classmethod
    def _of(cls, record: Record) -> Trajectory:
        """As it was; a disturbance that varied over time comes back as its samples."""
        t, about = record["t"], record.about
        values = {s: record[s] for s in record.results if s != "t"}
        (force,) = (values[s] for s in record.model.inputs)
        plane, model = record.aircraft, record.model.key
        if "ended" not in about:
            return cls(t, values, plane, model, force[..., 0])
        lines = sampled(t, force)
        end = lines.end if about["ended"] else np.asarray(np.inf)
        gust = replace(lines, label=f"{about['disturbance']} (its samples)", end=end)
        return cls(t, values, plane, model, force, gust)

    def _repr_html_(self) -> str:
        from .notebook import sparkline, table

        rows = [
            (s, words, sparkline(self[s].reshape(-1, self.t.size)), *rest)
            for s, words, *rest in self._rows()
        ]
        return table(self._title(), rows)

    def _title(self) -> str:
        shape = self["v"].shape[:-1]
        many = f", {' x '.join(map(str, shape))} runs" if shape else ""
        whose = f"{self.aircraft.name!r}, {as_model(self.model).name} model"
        return f"Trajectory of {whose}, 0 to {self.t[-1]:g} s, {self.t.size} samples{many}"

    def _rows(self) -> Iterable[Sequence[str]]:
        for s, series in self.values.items():
            end = f"at the end {span(series[..., -1])}"
            peak = f"largest {np.abs(series).max():.5g}"
            q = as_model(self.model).quantities[s]
            yield s, q.name, peak, end, unit_of(q)


def simulate(
    plane: Aircraft,
    model: ModelLike = "nonlinear",
    *,
    t: float | str = 5.0,
    samples: int = 501,
    speed: Any = None,
    disturbance: Any = 0.0,
    method: str = "rk45",
    **initial: Any,
) -> Trajectory:
    """Simulate the ground roll of an aircraft, hands off.

    As everywhere, a number may be a string with a unit: ``v0="1 kt"``, ``disturbance="70 lbf"``.

    Parameters
    ----------
    plane : Aircraft
        The aircraft; its parameters may be arrays.
    model : str or Model
        ``"linear"`` or ``"nonlinear"``.
    t : float
        Duration, s.
    samples : int
        Number of equally spaced samples, the first at 0 and the last at `t`.
    speed : float or array, optional
        Forward speed, m/s; default the aircraft's own.
    disturbance : float, array, Gust or callable
        Side force on the vertical tail, N, positive to the right: constant, or over time as a
        gust of `groundroll.gusts` or a function from an array of times, s, to an array of forces.
    method : str
        ``"rk45"`` or ``"rk4"``; see `integrator`, and `integration.integrate_varying` for a
        disturbance that varies.
    **initial : float or array
        Initial states by symbol and a zero: ``v0``, ``r0``, ``y0``, ``theta0``, ``X0``, ``Y0``,
        ``psi0``; zero if omitted.

    Returns
    -------
    Trajectory
        States and outputs over time.

    Raises
    ------
    GroundrollError
        For unknown names, values that cannot be, or a run that leaves the numbers.
    """
    names = as_model(model)
    duration, count = positive("t", t, "s"), whole("samples", samples, 2)
    check_memory(8 * count * len((*names.states, *names.outputs, *names.inputs)), "the series")
    aircraft = plane if speed is None else plane.replace(u=speed)
    times = np.linspace(0.0, duration, count)
    start = _initial_state(initial, names)
    gust = as_gust(disturbance)
    force = finite("disturbance", disturbance, "N") if gust is None else gust(times)
    at_start = force if gust is None else force[..., 0]
    p, flat, shape = aircraft.columns(model, disturbance=at_start, **start)
    x0 = np.stack([flat[key] for key in start])
    if gust is None:
        constant = as_inputs(model, flat["disturbance"])
        after = integrate(model, method, times[1:], x0, constant, p)
        u = np.repeat(constant[:, :, None], times.size, axis=2)
    else:
        gust.refuse_jumps(duration)
        inputs = partial(gust.on_runs, model, shape)
        after = integrate_varying(model, method, times[1:], x0, inputs, p, gust.breaks)
        u = inputs(times)
    x = np.concatenate([x0.T[:, :, None], after], axis=2)
    series = np.concatenate([x, _outputs(model, x, u, p), np.moveaxis(u, 0, 1)], axis=1)
    values = {
        name: series[:, i].reshape(*shape, times.size)
        for i, name in enumerate((*names.states, *names.outputs, *names.inputs))
    }
    return Trajectory(times, values, aircraft, names.key, force, gust)


def _outputs(model: ModelLike, x: FloatArray, u: FloatArray, p: FloatArray) -> FloatArray:
    """Outputs over time, shape (runs, outputs, samples)."""
    samples, outputs = x.shape[2], as_model(model).function("outputs")
    rows = [
        columns(
            outputs,
            x[k],
            u[:, k],
            np.repeat(p[:, k, None], samples, axis=1),
        )
        for k in range(len(x))
    ]
    return np.stack([y[:, :, 0].T for (y,) in rows])


def _initial_state(initial: Mapping[str, Any], model: Model) -> dict[str, FloatArray]:
    allowed = {f"{s}0": model.quantities[s].unit for s in model.states}
    for name in initial:
        if name not in allowed:
            raise unknown("argument", name, [*allowed, "speed", "disturbance"], "simulate")
    return {key: finite(key, initial.get(key, 0.0), unit) for key, unit in allowed.items()}
