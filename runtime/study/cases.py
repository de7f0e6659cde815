"""The runs of the study: each is made once and serves tables and figures."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache, cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from groundroll.aircraft.aircraft import Aircraft
from groundroll.base.errors import one_of
from groundroll.linear.linearization import Linearization, linearize
from groundroll.runs.metrics import Metrics
from groundroll.runs.simulation import Trajectory, simulate

from .sources import Trial, setup, trials
from .thesis_tire import Table, ThesisFit, table_3_1, thesis_fit

if TYPE_CHECKING:
    from collections.abc import Mapping

    from groundroll.stability.maps import StabilityMap

#: Newtons in a pound-force, exactly.
POUND = 4.4482216152605


@dataclass(frozen=True)
class Case:
    """One trial with one of the two tires.

    Attributes
    ----------
    trial : Trial
        What is changed.
    model : str
        ``"linear"`` or ``"nonlinear"``.
    """

    trial: Trial
    model: str

    @property
    def reading(self) -> Mapping[str, Any]:
        """What the data say of this run."""
        return self.trial.readings[self.model]

    @cached_property
    def plane(self) -> Aircraft:
        """The aircraft of the run."""
        own = {key: value for key, value in self.reading.items() if key != "time_constant"}
        return Aircraft.load(setup().aircraft).replace(**self.trial.changes, **own)

    @cached_property
    def linearization(self) -> Linearization:
        """About straight running."""
        return linearize(self.plane, self.model)

    @cached_property
    def run(self) -> Trajectory:
        """The response to the start that all trials share."""
        return simulate(
            self.plane,
            self.model,
            t=setup().duration,
            samples=setup().samples,
            v0=setup().lateral_velocity,
        )

    @cached_property
    def metrics(self) -> Metrics:
        """What is read off the response; NaN if unstable."""
        return self.run.metrics()

    def time_constant(self) -> float:
        """In the reading that the table has."""
        if self.reading["time_constant"] == "response":
            return float(self.metrics.time_constant)
        real = self.linearization.eigenvalues.real
        moving = real[np.abs(real) > 1e-9 * np.abs(real).max()]
        return float(-1 / moving.max()) if (moving < 0).all() else float("nan")

    def entry_before_last(self) -> float:
        """When y enters the band of 5 % around its steady value for the last time but one, s."""
        inside = np.abs(self.run["y"] / self.metrics.displacement - 1) <= 0.05
        entries = np.flatnonzero(~inside[:-1] & inside[1:])
        return float(self.run.t[entries[-2] + 1]) if entries.size > 1 else float("nan")


@cache
def case(number: int, model: str) -> Case:
    """The run of a trial."""
    return Case(trials()[number], model)


@cache
def tire_fit() -> ThesisFit:
    """The fit to Table 3.1."""
    return thesis_fit(table_3_1())


@cache
def tire_fit_in_pounds() -> ThesisFit:
    """The fit to Table 3.1 with its forces and loads in the whole pounds they come from."""
    table = table_3_1()
    loads, forces = np.round(table.loads / POUND, -2), np.round(table.forces / POUND)
    return thesis_fit(Table(table.slip_angles, loads * POUND, forces * POUND))


def trials_on(chart: StabilityMap, *numbers: int) -> dict[str, Aircraft]:
    """The thesis's trials as marks for a map: those that are points of it, or some by number.

    Raises
    ------
    GroundrollError
        For a trial that the thesis does not have.
    """
    every = {f"Trial {number}": case(number, "linear").plane for number in trials()}
    if not numbers:
        return {label: plane for label, plane in every.items() if chart.fits(plane)}
    labels = (one_of("trial", f"Trial {number}", every) for number in numbers)
    return {label: every[label] for label in labels}
