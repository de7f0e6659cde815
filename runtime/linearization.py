"""Linear models at any operating point."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from .aircraft import Aircraft
from .arrays import FloatArray, as_inputs, finite
from .errors import GroundrollError
from .evaluate import columns, elementwise
from .listing import Listed, span, unit_of
from .models import ModelLike, as_model
from .records import Column, Record, measured, run_dims
from .results import Result
from .stability import quantity_of

if TYPE_CHECKING:
    import control
    import pandas

    from .sensitivities import Sensitivities

ComplexArray = npt.NDArray[np.complex128]

#: Of what is read from the eigenvalues one number for each point, and of the rest the axes.
READ_OFF = ("decay_rate", "damping_ratio", "natural_frequency", "damped_frequency")
_AXES = {
    "A": ("state_rate", "state"),
    "B": ("state_rate", "input"),
    "C": ("output", "state"),
    "D": ("output", "input"),
    "drift": ("state_rate",),
    "eigenvalues": ("mode",),
}


@dataclass(frozen=True)
class OperatingPoint:
    """A state of motion to linearise about.

    Attributes
    ----------
    v : float or array
        Lateral velocity, m/s, to the right.
    r : float or array
        Yaw rate, rad/s, nose right.
    disturbance : float or array
        Side force on the vertical tail, N, to the right.
    """

    v: Any = 0.0
    r: Any = 0.0
    disturbance: Any = 0.0

    def in_si(self) -> OperatingPoint:
        """The same with numbers and arrays only."""
        v, r = finite("at.v", self.v, "m/s"), finite("at.r", self.r, "rad/s")
        force = finite("disturbance", self.disturbance, "N")
        return OperatingPoint(*(x if x.ndim else float(x) for x in (v, r, force)))


@dataclass(frozen=True, repr=False)
class Linearization(Listed, Result):
    """x' = drift + A (x - x_op) + B (u - u_op), y = y_op + C (x - x_op) + D (u - u_op).

    x = (v, r), u = (disturbance); the names are in `states`, `inputs`, `outputs`. With arrays
    among the arguments every attribute has their common shape in front.

    Attributes
    ----------
    A, B, C, D : ndarray, shapes (..., 2, 2), (..., 2, 1), (..., n, 2), (..., n, 1)
        State-space matrices, SI units with radians.
    drift : ndarray, shape (..., 2)
        (v_dot, r_dot) at the operating point; zero at an equilibrium.
    eigenvalues : complex ndarray, shape (..., 2)
        1/s; the larger real part first, of a pair the positive imaginary part first.
    decay_rate : ndarray
        -max Re(eigenvalue), 1/s; positive if stable.
    damping_ratio : ndarray
        -tr A / (2 sqrt(det A)); above 1 the eigenvalues are real; NaN where det A < 0.
    natural_frequency, damped_frequency : ndarray
        sqrt(det A) and the size of the imaginary part, rad/s.
    """

    A: FloatArray
    B: FloatArray
    C: FloatArray
    D: FloatArray
    drift: FloatArray
    eigenvalues: ComplexArray
    decay_rate: FloatArray
    damping_ratio: FloatArray
    natural_frequency: FloatArray
    damped_frequency: FloatArray
    at: OperatingPoint
    aircraft: Aircraft
    model: ModelLike
    states: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]

    def __getitem__(self, index: Any) -> Linearization:
        """The points at an index, or at a tuple of indices, of a linearization with arrays."""
        shape = self.decay_rate.shape

        def pick(value: Any) -> FloatArray:
            return np.asarray(np.broadcast_to(value, shape)[index])

        try:
            given = {s: pick(value) for s, value in self.aircraft.given.items() if value.ndim}
            at = OperatingPoint(pick(self.at.v), pick(self.at.r), pick(self.at.disturbance))
        except IndexError as problem:
            raise GroundrollError(f"there is no [{index}] among points {shape}") from problem
        return linearize(self.aircraft.replace(**given), self.model, at)

    def sensitivities(self) -> Sensitivities:
        """Exact derivatives of A and of the eigenvalues by each parameter of the model.

        See `groundroll.sensitivities.Sensitivities`.
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
        if self.decay_rate.ndim:
            first = ", ".join("0" * self.decay_rate.ndim)
            raise GroundrollError(
                f"a StateSpace holds one point, not {self.decay_rate.shape}: choose one, as in"
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
        given = {"v": self.at.v, "r": self.at.r, "F_disturbance": self.at.disturbance}
        given = {s: np.asarray(value, np.float64) for s, value in given.items()}
        model = as_model(self.model)
        return Record("linearization", self.aircraft, model, runs, results, given=given)

    @classmethod
    def _of(cls, record: Record) -> Linearization:
        at = (value if value.ndim else float(value) for value in record.given.values())
        parts: dict[str, Any] = {name: record[name] for name in (*_AXES, *READ_OFF)}
        for axis in ("state", "input", "output"):
            parts[f"{axis}s"] = tuple(record[axis].tolist())
        model = record.model.key
        return cls(**parts, at=OperatingPoint(*at), aircraft=record.aircraft, model=model)

    def _title(self) -> str:
        whose = f"{self.aircraft.name!r}, {as_model(self.model).name} model"
        head = f"Linearization of {whose}, at {self.at}"
        if self.decay_rate.ndim:
            stable = np.count_nonzero(self.decay_rate > 0)
            return f"{head}: {self.decay_rate.shape} points, {stable} of them stable"
        return f"{head}: {'stable' if self.decay_rate > 0 else 'unstable'}"

    def _rows(self) -> Iterable[Sequence[str]]:
        if not self.decay_rate.ndim:
            yield "eigenvalues", ", ".join(f"{root:.5g}" for root in self.eigenvalues), "1/s"
        for name in READ_OFF:
            yield name, span(getattr(self, name)), unit_of(quantity_of(name))


def linearize(
    plane: Aircraft,
    model: ModelLike = "nonlinear",
    at: OperatingPoint | None = None,
    *,
    speed: Any = None,
    disturbance: Any = None,
) -> Linearization:
    """Linearise the model of an aircraft about a state of motion.

    Parameters
    ----------
    plane : Aircraft
        The aircraft; its parameters may be arrays.
    model : str or Model
        ``"linear"`` or ``"nonlinear"``.
    at : OperatingPoint, optional
        Where; straight running if omitted. It need not be an equilibrium.
    speed : float or array, optional
        Forward speed, m/s; default the aircraft's own.
    disturbance : float or array, optional
        Side force on the tail, N; overrides that of `at`.

    Returns
    -------
    Linearization
        Exact Jacobians and what is read from them.
    """
    point = at or OperatingPoint()
    if disturbance is not None:
        point = OperatingPoint(point.v, point.r, disturbance)
    point = point.in_si()
    names = as_model(model)
    aircraft = plane if speed is None else plane.replace(u=speed)
    x, u, p, shape = columns_at(aircraft, model, point)
    fx, fu, _, gx, gu, _ = columns(as_model(model).function("jacobians"), x, u, p)
    (rates,) = columns(as_model(model).function("rhs"), x, u, p)
    dynamic = [names.states.index(s) for s in names.dynamic]

    def shaped(values: FloatArray) -> FloatArray:
        return values.reshape(*shape, *values.shape[1:])

    A = shaped(fx[:, dynamic][:, :, dynamic])
    modes = modes_of(A)
    eigenvalues = np.stack(
        [modes["re_1"] + 1j * modes["im_1"], modes["re_2"] + 1j * modes["im_2"]], -1
    )
    return Linearization(
        A=A,
        B=shaped(fu[:, dynamic]),
        C=shaped(gx[:, :, dynamic]),
        D=shaped(gu),
        drift=shaped(rates[:, dynamic, 0]),
        eigenvalues=eigenvalues,
        decay_rate=modes["decay_rate"],
        damping_ratio=modes["damping_ratio"],
        natural_frequency=modes["natural_frequency"],
        damped_frequency=modes["damped_frequency"],
        at=point,
        aircraft=aircraft,
        model=names.key,
        states=names.dynamic,
        inputs=names.inputs,
        outputs=names.outputs,
    )


def columns_at(
    aircraft: Aircraft, model: ModelLike, at: OperatingPoint
) -> tuple[FloatArray, FloatArray, FloatArray, tuple[int, ...]]:
    """States, inputs and parameters at operating points, one column per point, and their shape."""
    p, flat, shape = aircraft.columns(
        model,
        v=finite("at.v", at.v, "m/s"),
        r=finite("at.r", at.r, "rad/s"),
        disturbance=finite("disturbance", at.disturbance, "N"),
    )
    zero = np.zeros(p.shape[1])
    x = np.stack([flat.get(s, zero) for s in as_model(model).states])
    return x, as_inputs(model, flat["disturbance"]), p, shape


def modes_of(A: FloatArray) -> dict[str, FloatArray]:
    """What the generated function ``modes`` says of state matrices of shape (..., 2, 2)."""
    entries = {f"A_{i}{j}": A[..., k, n] for k, i in enumerate("vr") for n, j in enumerate("vr")}
    return elementwise("modes", entries)
