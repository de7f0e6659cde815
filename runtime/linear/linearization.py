"""Linear models at any operating point."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from groundroll.aircraft.aircraft import Aircraft, of_aircraft
from groundroll.aircraft.validity import extrapolated
from groundroll.base.arrays import FloatArray
from groundroll.base.errors import GroundrollError, beyond
from groundroll.base.listing import Listed, span, unit_of
from groundroll.model.models import ModelLike, as_model
from groundroll.results.records import Column, Record, measured, run_dims
from groundroll.results.results import Result
from groundroll.stability.closed_forms import quantity_of
from groundroll.stability.modes import READ_OFF, ComplexArray, Modes, modes_of

from .operating_point import OperatingPoint, operating_point, points_at

if TYPE_CHECKING:
    import control
    import pandas

    from .sensitivities import Sensitivities

#: Axes of the arrays.
_AXES = {
    "A": ("state_rate", "state"),
    "B": ("state_rate", "input"),
    "C": ("output", "state"),
    "D": ("output", "input"),
    "drift": ("state_rate",),
    "eigenvalues": ("mode",),
}

#: Axes along which what is told has a unit of its own.
_MEASURED = ("state", "input", "output")


@dataclass(frozen=True, repr=False)
class Linearization(Listed, Result):
    """x' = drift + A (x - x_op) + B (u - u_op), y = y_op + C (x - x_op) + D (u - u_op).

    x are the dynamic states and u all inputs; their symbols are in `states` and `inputs`, those of
    y in `outputs`. With arrays among the arguments every attribute has their common shape in front.

    Attributes
    ----------
    A, B, C, D : ndarray, shapes (..., n, n), (..., n, m), (..., k, n), (..., k, m)
        State-space matrices, SI units with radians.
    drift : ndarray, shape (..., n)
        Rates of the states at the operating point; zero at an equilibrium.
    eigenvalues : complex ndarray, shape (..., n)
        1/s; the larger real part first, of a pair the positive imaginary part first.
    decay_rate : ndarray
        -max Re(eigenvalue), 1/s; positive if stable.
    damping_ratio : ndarray
        With two states -tr A / (2 sqrt(det A)): above 1 the eigenvalues are real, NaN where det A
        < 0. With others that of the eigenvalue with the largest real part.
    natural_frequency, damped_frequency : ndarray
        With two states sqrt(det A), otherwise the size of that eigenvalue, and the size of the
        imaginary part, rad/s.
    """

    A: FloatArray
    B: FloatArray
    drift: FloatArray
    at: OperatingPoint
    aircraft: Aircraft
    model: ModelLike
    states: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]

    @cached_property
    def _seen(self) -> dict[str, FloatArray]:
        """C and D, when they are asked for: they take longer than the rest."""
        points = points_at(self.aircraft, as_model(self.model), self.at, {}, "linearize")
        return points.evaluate("gx", "gu")

    @property
    def C(self) -> FloatArray:  # what attributes are is said above
        return self._seen["gx"]

    @property
    def D(self) -> FloatArray:
        return self._seen["gu"]

    @cached_property
    def _modes(self) -> Modes:
        return modes_of(self.A)

    @property
    def eigenvalues(self) -> ComplexArray:
        return self._modes.eigenvalues

    @property
    def decay_rate(self) -> FloatArray:
        return self._modes.decay_rate

    @property
    def damping_ratio(self) -> FloatArray:
        return self._modes.damping_ratio

    @property
    def natural_frequency(self) -> FloatArray:
        return self._modes.natural_frequency

    @property
    def damped_frequency(self) -> FloatArray:
        return self._modes.damped_frequency

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of the points."""
        return self.drift.shape[:-1]

    def __getitem__(self, index: Any) -> Linearization:
        """The points at an index, or at a tuple of indices, of a linearization with arrays."""
        shape = self.shape

        def pick(value: Any) -> FloatArray:
            return np.asarray(np.broadcast_to(value, shape)[index])

        try:
            at = OperatingPoint(**{name: pick(value) for name, value in self.at.items()})
            aircraft = self.aircraft.at_each(pick)
        except IndexError as problem:
            raise GroundrollError(f"there is no [{index}] among points {shape}") from problem
        return linearize(aircraft, self.model, at)

    def sensitivities(self) -> Sensitivities:
        """Exact derivatives of A and of the eigenvalues by each parameter of the model.

        See `groundroll.linear.sensitivities.Sensitivities`.
        """
        from .sensitivities import sensitivities

        return sensitivities(self)

    def to_control(self) -> control.StateSpace:
        """The same model for the package control, with named states, inputs and outputs.

        Raises
        ------
        GroundrollError
            If this is more than one point, or the package is not installed.
        """
        if self.shape:
            first = ", ".join("0" * len(self.shape))
            raise GroundrollError(
                f"a StateSpace holds one point, not {self.shape}: choose one, as in"
                f" lin[{first}].to_control()"
            )
        try:
            import control
        except ImportError:
            raise GroundrollError(
                "to_control() needs the package control: pip install 'groundroll[control]'"
            ) from None
        names = {"states": self.states, "inputs": self.inputs, "outputs": self.outputs}
        return control.StateSpace(
            self.A, self.B, self.C, self.D, **{kind: list(each) for kind, each in names.items()}
        )

    def to_pandas(self) -> pandas.DataFrame:
        """See `Result.to_pandas`; the eigenvalues are in columns of their own."""
        frame = super().to_pandas()
        for k, values in enumerate(np.moveaxis(self.eigenvalues, -1, 0), start=1):
            frame[f"eigenvalue_{k}"] = values.ravel()
        return frame

    def _record(self) -> Record:
        runs = run_dims(self.decay_rate.shape)
        results = {
            name: Column((*runs, *axes), getattr(self, name)) for name, axes in _AXES.items()
        }
        results |= {
            name: measured(runs, getattr(self, name), quantity_of(name)) for name in READ_OFF
        }
        labels = {"state": self.states, "state_rate": self.states}
        labels |= {"input": self.inputs, "output": self.outputs}
        results |= {axis: Column((axis,), np.array(names)) for axis, names in labels.items()}
        model = as_model(self.model)
        units = {axis: [model.quantities[s].unit for s in labels[axis]] for axis in _MEASURED}
        results |= {f"{axis}_unit": Column((axis,), np.array(u)) for axis, u in units.items()}
        by_name = {model.quantities[s].name: s for s in model.inputs}
        given = {by_name.get(s, s): np.asarray(x, np.float64) for s, x in self.at.items()}
        return Record("linearization", self.aircraft, model, runs, results, given=given)

    @classmethod
    def _of(cls, record: Record) -> Linearization:
        q = record.model.quantities
        at = {
            q[s].name if s in record.model.inputs else s: x if x.ndim else float(x)
            for s, x in record.given.items()
        }
        parts: dict[str, Any] = {name: record[name] for name in ("A", "B", "drift")}
        for axis in _MEASURED:
            parts[f"{axis}s"] = tuple(record[axis].tolist())
        model = record.model.key
        found = cls(**parts, at=OperatingPoint(**at), aircraft=record.aircraft, model=model)
        # what is kept is not computed again, by another version perhaps
        vars(found)["_seen"] = {"gx": record["C"], "gu": record["D"]}
        vars(found)["_modes"] = Modes(record["eigenvalues"], *(record[name] for name in READ_OFF))
        return found

    def _title(self) -> str:
        whose = f"{self.aircraft.name!r}, {as_model(self.model).name} model"
        head = f"Linearization of {whose}, at {self.at}"
        if self.decay_rate.ndim:
            stable = np.count_nonzero(self.decay_rate > 0)
            return f"{head}: {self.decay_rate.shape} points, {stable} of them stable"
        return f"{head}: {'stable' if self.decay_rate > 0 else 'unstable'}"

    def _notes(self) -> Iterable[str]:
        return extrapolated(self.aircraft)

    def _rows(self) -> Iterable[Sequence[str]]:
        if not self.decay_rate.ndim:
            yield "eigenvalues", ", ".join(f"{root:.5g}" for root in self.eigenvalues), "1/s"
        for name in READ_OFF:
            yield name, span(getattr(self, name)), unit_of(quantity_of(name))


@of_aircraft
def linearize(
    plane: Aircraft,
    model: ModelLike = "nonlinear",
    at: Mapping[str, Any] | None = None,
    **values: Any,
) -> Linearization:
    """Linearise the model of an aircraft about a state of motion.

    Parameters
    ----------
    plane : Aircraft
        The aircraft; its parameters may be arrays.
    model : str or Model
        A model that ships, a folder, or what `Model.load` gives.
    at : OperatingPoint or mapping, optional
        Where: states, inputs and parameters by symbol or full name, each a number in SI units, an
        array, or a text with a unit: ``{"v": 0.4, "disturbance": "70 lbf"}``. What is not named is
        zero, a free speed the aircraft's own. It need not be an equilibrium.
    **values : float, array or str
        The same as keywords: ``speed="100 km/h"``, ``steering="1 deg"``.

    Returns
    -------
    Linearization
        Exact Jacobians by the dynamic states and all inputs, and what is read from them.

    Raises
    ------
    GroundrollError
        For unknown names, naming the nearest, or values that cannot be.
    """
    chosen = as_model(model)
    points = points_at(plane, chosen, at, values, "linearize")
    found = points.evaluate("f", "fx", "fu")
    if not np.isfinite(found["fx"]).all():
        raise beyond(f"the linear model of {plane.name} by the model {chosen.name}")
    return Linearization(
        A=found["fx"],
        B=found["fu"],
        drift=found["f"],
        at=operating_point(points),
        aircraft=points.aircraft,
        model=chosen.key,
        states=chosen.dynamic,
        inputs=chosen.inputs,
        outputs=chosen.outputs,
    )
