"""Frequency response, step response and root locus of linear models."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from .aircraft import Aircraft, parameter_symbols
from .arrays import FloatArray, finite, positive, whole
from .errors import GroundrollError
from .generated import Quantity
from .linearization import ComplexArray, Linearization, OperatingPoint, linearize
from .listing import Pictured, span, unit_of
from .models import ModelLike, as_model
from .names import PARAMETERS, symbol
from .wording import number

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Frequencies of a response that names none: so far below the slowest mode and above the fastest.
_SPAN = 30.0


@dataclass(frozen=True, repr=False)
class FrequencyResponse(Pictured):
    """Steady response of an output to a sinusoidal input, about an operating point.

    Attributes
    ----------
    frequency : ndarray, shape (n,)
        rad/s.
    response : complex ndarray, shape (..., n)
        Output over input, SI units with radians.
    output, input : str
        Symbols.
    aircraft : Aircraft
    model : str or Model
        Whose response it is.
    """

    frequency: FloatArray
    response: ComplexArray
    output: str
    input: str
    aircraft: Aircraft
    model: ModelLike

    @property
    def magnitude(self) -> FloatArray:
        """Amplitude of the output over that of the input."""
        return np.abs(self.response)

    @property
    def phase(self) -> FloatArray:
        """Phase of the output after that of the input, rad, continuous over frequency."""
        return np.unwrap(np.angle(self.response), axis=-1)

    def plot(
        self, ax: Sequence[Axes] | None = None, *, decibels: bool = False
    ) -> tuple[Axes, Axes]:
        """Bode diagram: magnitude above phase; `ax` is a pair of axes, new ones if omitted."""
        from .response_plot import bode

        return bode(self, ax, decibels)

    def __repr__(self) -> str:
        q = as_model(self.model).quantities
        out, by = q[self.output], q[self.input]
        return (
            f"FrequencyResponse of {_named(out)} to {_named(by)} of {_whose(self)}:"
            f" {span(self.frequency)} rad/s, {_many(self.response)}"
            f"\n  largest magnitude {number(self.magnitude.max())} {out.unit} per {by.unit}"
        )


def _named(q: Quantity) -> str:
    return f"{q.name} ({q.symbol})"


def _whose(found: FrequencyResponse | StepResponse | RootLocus) -> str:
    return f"{found.aircraft.name!r}, {as_model(found.model).name} model"


def _many(values: FloatArray | ComplexArray) -> str:
    """How many samples, and of how many points."""
    points = f" of {' x '.join(map(str, values.shape[:-1]))} points" if values.ndim > 1 else ""
    return f"{values.shape[-1]} samples{points}"


def frequency_response(
    lin: Linearization,
    output: str,
    input: str = "disturbance",
    *,
    frequency: Any = None,
) -> FrequencyResponse:
    """C (j omega - A)^-1 B + D of one output and one input.

    Parameters
    ----------
    lin : Linearization
        The linear model; with arrays, of every point.
    output : str
        An output or a state, by symbol or full name, e.g. ``"lateral_acceleration"``.
    input : str
        An input, by symbol or full name.
    frequency : sequence of float, optional
        rad/s, zero or more; by default from a thirtieth of the slowest mode to thirty times the
        fastest.

    Returns
    -------
    FrequencyResponse
        For sinusoidal deviations from the operating point.

    Raises
    ------
    GroundrollError
        For unknown names, frequencies that cannot be, or one at which the response is infinite.
    """
    B, C, D, names = _channel(lin, output, input)
    omega = (
        _default_frequencies(lin) if frequency is None else finite("frequency", frequency, "rad/s")
    )
    if omega.ndim != 1 or omega.size == 0 or (omega < 0).any():
        raise GroundrollError("frequency must be a list of numbers, zero or more, in rad/s")
    s = 1j * omega[:, None, None]
    M = s * np.eye(2) - lin.A[..., None, :, :]
    trace = np.trace(M, axis1=-2, axis2=-1)
    adjugate = trace[..., None, None] * np.eye(2) - M
    polynomial = M[..., 0, 0] * M[..., 1, 1] - M[..., 0, 1] * M[..., 1, 0]
    if (polynomial == 0).any():
        where = omega[np.argwhere(polynomial == 0)[0][-1]]
        why = " (A is singular: main gear at the CG, nothing at the tail?)" if where == 0 else ""
        raise GroundrollError(
            f"the response at {where:g} rad/s is infinite: i times it is an eigenvalue of A{why}"
        )
    numerator = np.einsum("...i,...nij,...j->...n", C, adjugate, B)
    values = numerator / polynomial + D[..., None]
    return FrequencyResponse(omega, values, *names, lin.aircraft, lin.model)


def _channel(
    lin: Linearization, output: str, input: str
) -> tuple[FloatArray, FloatArray, FloatArray, tuple[str, str]]:
    """Column of B, row of C and entry of D between an input and an output or state."""
    model = as_model(lin.model)
    out = model.symbol(output, "output", (*lin.outputs, *lin.states), "this model")
    by = model.symbol(input, "input", lin.inputs, "this model")
    column = lin.inputs.index(by)
    B = lin.B[..., column]
    if out in lin.states:
        C = np.broadcast_to(np.eye(2)[lin.states.index(out)], B.shape)
        return B, C, np.zeros(B.shape[:-1]), (out, by)
    row = lin.outputs.index(out)
    return B, lin.C[..., row, :], lin.D[..., row, column], (out, by)


def _default_frequencies(lin: Linearization) -> FloatArray:
    speeds = np.abs(lin.eigenvalues)
    speeds = speeds[speeds > 1e-9 * speeds.max()]
    if speeds.size == 0:
        raise GroundrollError("every eigenvalue is zero: name the frequencies to look at")
    low, high = np.log10(speeds.min() / _SPAN), np.log10(speeds.max() * _SPAN)
    return np.logspace(low, high, 400)


@dataclass(frozen=True, repr=False)
class StepResponse(Pictured):
    """Response of an output to a step of an input, about an operating point.

    Attributes
    ----------
    t : ndarray, shape (n,)
        Time after the step, s.
    values : ndarray, shape (..., n)
        Deviation of the output, SI units with radians.
    output, input : str
        Symbols.
    size : float
        Height of the step, SI.
    aircraft : Aircraft
    model : str or Model
        Whose response it is.
    """

    t: FloatArray
    values: FloatArray
    output: str
    input: str
    size: float
    aircraft: Aircraft
    model: ModelLike

    def plot(self, ax: Axes | None = None) -> Axes:
        """Plot the output over time."""
        from .response_plot import step

        return step(self, ax)

    def __repr__(self) -> str:
        q = as_model(self.model).quantities
        out, by = q[self.output], q[self.input]
        return (
            f"StepResponse of {_named(out)} to {self.size:g} {by.unit} of {_named(by)} of"
            f" {_whose(self)}: 0 to {self.t[-1]:g} s, {_many(self.values)}"
            f"\n  largest {number(np.abs(self.values).max())}, at the end"
            f" {span(self.values[..., -1])} {unit_of(out)}"
        )


def step_response(
    lin: Linearization,
    output: str,
    input: str = "disturbance",
    *,
    size: float | str = 1.0,
    t: float | str = 5.0,
    samples: int = 501,
) -> StepResponse:
    """Exact response to a step at t = 0, by the matrix exponential.

    Parameters
    ----------
    lin : Linearization
        The linear model; with arrays, of every point.
    output : str
        An output or a state, by symbol or full name.
    input : str
        An input, by symbol or full name.
    size : float
        Height of the step, SI.
    t : float
        Duration, s.
    samples : int
        Number of equally spaced samples, the first at 0 and the last at `t`.

    Returns
    -------
    StepResponse
        Deviation from the operating point; what the drift there does is not in it.
    """
    B, C, D, names = _channel(lin, output, input)
    duration, count = positive("t", t, "s"), whole("samples", samples, 2)
    height = float(finite("size", size, as_model(lin.model).quantities[names[1]].unit))
    times = np.linspace(0.0, duration, count)
    # the state with the constant input appended: x' = A x + B u, u' = 0
    augmented = np.zeros((*B.shape[:-1], 3, 3))
    augmented[..., :2, :2], augmented[..., :2, 2] = lin.A, B
    state = np.zeros((*B.shape[:-1], times.size, 3))
    state[..., 0, 2] = height
    with np.errstate(over="ignore", invalid="ignore"):
        advance = exponential(augmented * times[1])
        for k in range(1, times.size):
            state[..., k, :] = np.einsum("...ij,...j->...i", advance, state[..., k - 1, :])
        values = np.einsum("...i,...ni->...n", C, state[..., :2]) + (D * height)[..., None]
    if not np.isfinite(values).all():
        raise GroundrollError(
            f"the step response grows beyond what a number can hold within {duration:g} s"
        )
    return StepResponse(times, values, *names, height, lin.aircraft, lin.model)


def exponential(matrix: FloatArray) -> FloatArray:
    """Matrix exponential of matrices of shape (..., n, n): Taylor series after scaling by 2^-k."""
    norm = float(np.abs(matrix).sum(axis=-1).max(initial=0.0))
    squarings = max(0, math.ceil(math.log2(norm)) + 1) if norm > 0 else 0
    scaled = matrix / 2.0**squarings
    result = np.broadcast_to(np.eye(matrix.shape[-1]), matrix.shape).copy()
    term = result
    for k in range(1, 19):  # 0.5^19/19! is below rounding
        term = term @ scaled / k
        result = result + term
    for _ in range(squarings):
        result = result @ result
    return result


@dataclass(frozen=True, repr=False)
class RootLocus(Pictured):
    """Eigenvalues over a parameter, each mode followed from value to value.

    Attributes
    ----------
    parameter : str
        Symbol.
    values : ndarray, shape (n,)
        Its values, SI units with radians.
    eigenvalues : complex ndarray, shape (n, 2)
        1/s; a column is one mode, also through values at which two modes cross. Where a pair
        splits into two real modes, or two join, which is which has no answer; the columns stay
        continuous.
    aircraft : Aircraft
    model : str or Model
        Whose eigenvalues they are.
    """

    parameter: str
    values: FloatArray
    eigenvalues: ComplexArray
    aircraft: Aircraft
    model: ModelLike

    def plot(self, ax: Axes | None = None, *, unit: str | None = None) -> Axes:
        """Draw the locus in the complex plane, coloured by the parameter in `unit`."""
        from .response_plot import locus

        return locus(self, ax, unit)

    def __repr__(self) -> str:
        q = PARAMETERS[self.parameter]
        return (
            f"RootLocus of {_whose(self)} over {_named(q)}: {span(self.values)}"
            f" {unit_of(q)}, {self.values.size} values"
            f"\n  real parts {span(self.eigenvalues.real)} 1/s,"
            f" imaginary parts {span(self.eigenvalues.imag)} rad/s"
        )


def root_locus(
    plane: Aircraft,
    parameter: str,
    values: Any,
    model: ModelLike = "nonlinear",
    at: OperatingPoint | None = None,
    *,
    speed: Any = None,
    disturbance: Any = None,
) -> RootLocus:
    """Eigenvalues of the linear model of an aircraft over any of its parameters.

    Parameters
    ----------
    plane : Aircraft
        The aircraft; none of its parameters may be an array.
    parameter : str
        Symbol or full name; what follows from it follows.
    values : sequence of float
        Its values in SI units with radians, increasing or decreasing. Modes are followed by
        continuing the line through their last two points, so steps must be fine enough for
        that.
    model, at, speed, disturbance
        As for `linearize`; scalars.

    Returns
    -------
    RootLocus
        With each mode in a column of its own.
    """
    key = symbol(parameter, "parameter", parameter_symbols(), "root_locus")
    swept = finite(f"values of {key}", values, PARAMETERS[key].unit)
    steps = np.diff(np.atleast_1d(swept))
    if swept.ndim != 1 or swept.size < 2 or not ((steps > 0).all() or (steps < 0).all()):
        raise GroundrollError(f"values of {key} must be a list that increases or decreases")
    aircraft = plane if speed is None else plane.replace(u=speed)
    lin = linearize(aircraft.replace(**{key: swept}), model, at, disturbance=disturbance)
    if lin.decay_rate.shape not in ((), swept.shape):
        raise GroundrollError(
            f"a locus has one parameter, but other arrays give it the shape {lin.decay_rate.shape}"
        )
    eigenvalues = np.broadcast_to(lin.eigenvalues, (*swept.shape, 2))
    return RootLocus(key, swept, follow(swept, eigenvalues), plane, lin.model)


def follow(values: FloatArray, eigenvalues: ComplexArray) -> ComplexArray:
    """Order pairs of eigenvalues so that each column continues its own line."""
    ordered = eigenvalues.copy()
    for k in range(1, len(values)):
        expected = ordered[k - 1]
        if k > 1:
            ratio = (values[k] - values[k - 1]) / (values[k - 1] - values[k - 2])
            expected = expected + (ordered[k - 1] - ordered[k - 2]) * ratio
        swapped = ordered[k, ::-1]
        if np.abs(swapped - expected).sum() < np.abs(ordered[k] - expected).sum():
            ordered[k] = swapped.copy()
    return ordered
