"""Frequency response, step response and root locus of linear models."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from groundroll.aircraft.aircraft import Aircraft, of_aircraft
from groundroll.base.arrays import FloatArray, finite, positive, single, whole
from groundroll.base.errors import GroundrollError
from groundroll.base.listing import Pictured, span, unit_of
from groundroll.base.wording import number
from groundroll.generated import Quantity
from groundroll.model.models import ModelLike, as_model, symbol_of
from groundroll.model.names import PARAMETERS
from groundroll.model.shown import UnitsLike
from groundroll.results.doors import drawn
from groundroll.stability.modes import ComplexArray

from .linearization import Linearization, linearize

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
        self,
        ax: Sequence[Axes] | None = None,
        *,
        decibels: bool = False,
        units: UnitsLike = None,
    ) -> tuple[Axes, Axes]:
        """Bode diagram: magnitude above phase; `ax` is a pair of axes, new ones if omitted.

        For `units` see `groundroll.model.shown.as_units`.
        """
        axes: tuple[Axes, Axes] = drawn("bode", self, ax, decibels, units)
        return axes

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
    of: Linearization | Aircraft,
    *names: Any,
    frequency: Any = None,
    at: Mapping[str, Any] | None = None,
    **values: Any,
) -> FrequencyResponse:
    """C (j omega - A)^-1 B + D of one output and one input.

    Parameters
    ----------
    of : Linearization or Aircraft
        A linear model, with arrays of every point; or an aircraft, whose model is linearised.
    *names : str
        With an aircraft first the model; then the output, which may be a state, and the input, by
        symbol or full name. The first input of the model if that is omitted.
    frequency : sequence of float, optional
        rad/s, zero or more; by default from a thirtieth of the slowest mode to thirty times the
        fastest.
    at, **values
        Where an aircraft is linearised, as for `linearize`.

    Returns
    -------
    FrequencyResponse
        For sinusoidal deviations from the operating point.

    Raises
    ------
    GroundrollError
        For unknown names, frequencies that cannot be, or one at which the response is infinite.
    """
    lin, output, input = _asked(of, names, at, values, "frequency_response")
    B, C, D, channel = _channel(lin, output, input)
    omega = (
        _default_frequencies(lin) if frequency is None else finite("frequency", frequency, "rad/s")
    )
    if omega.ndim != 1 or omega.size == 0 or (omega < 0).any():
        raise GroundrollError("frequency must be a list of numbers, zero or more, in rad/s")
    gap = np.abs(1j * omega[:, None] - lin.eigenvalues[..., None, :]).min(axis=-1)
    on = gap <= _ON * np.abs(lin.eigenvalues).max(axis=-1)[..., None]
    if on.any():
        where = omega[np.argwhere(on)[0][-1]]
        why = " (A is singular: main gear at the CG, nothing at the tail?)" if where == 0 else ""
        raise GroundrollError(
            f"the response at {where:g} rad/s is infinite: i times it is an eigenvalue of A{why}"
        )
    M = 1j * omega[:, None, None] * np.eye(len(lin.states)) - lin.A[..., None, :, :]
    inside = np.linalg.solve(M, np.broadcast_to(B[..., None, :, None], (*M.shape[:-1], 1)))
    found = np.einsum("...i,...ni->...n", C, inside[..., 0]) + D[..., None]
    return FrequencyResponse(omega, found, *channel, lin.aircraft, lin.model)


#: Closer to an eigenvalue than this share of the largest a response is called infinite.
_ON = 1e-15


def _asked(
    of: Linearization | Aircraft,
    names: Sequence[Any],
    at: Mapping[str, Any] | None,
    values: Mapping[str, Any],
    where: str,
) -> tuple[Linearization, str, str]:
    """The linear model, and the names of its output and input."""
    if isinstance(of, Linearization):
        if at is not None or values:
            raise GroundrollError(f"{where}: a linear model has its operating point already")
        lin, rest = of, list(names)
    else:
        if not names:
            raise GroundrollError(f"{where} of an aircraft needs a model, an output and an input")
        lin, rest = linearize(of, names[0], at, **values), list(names[1:])
    if not 1 <= len(rest) <= 2 or not all(isinstance(name, str) for name in rest):
        raise GroundrollError(f"{where} needs the names of an output and of an input")
    if len(rest) == 1:
        if not lin.inputs:
            raise GroundrollError(f"{where}: the model has no input")
        rest.append(lin.inputs[0])
    return lin, rest[0], rest[1]


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
        C = np.broadcast_to(np.eye(len(lin.states))[lin.states.index(out)], B.shape)
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

    def plot(self, ax: Axes | None = None, *, units: UnitsLike = None) -> Axes:
        """Plot the output over time; for `units` see `groundroll.model.shown.as_units`."""
        axes: Axes = drawn("step", self, ax, units)
        return axes

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
    of: Linearization | Aircraft,
    *names: Any,
    size: float | str = 1.0,
    t: float | str = 5.0,
    samples: int = 501,
    at: Mapping[str, Any] | None = None,
    **values: Any,
) -> StepResponse:
    """Exact response to a step at t = 0, by the matrix exponential.

    Parameters
    ----------
    of : Linearization or Aircraft
        A linear model, with arrays of every point; or an aircraft, whose model is linearised.
    *names : str
        With an aircraft first the model; then the output, which may be a state, and the input, by
        symbol or full name. The first input of the model if that is omitted.
    size : float
        Height of the step, SI.
    t : float
        Duration, s.
    samples : int
        Number of equally spaced samples, the first at 0 and the last at `t`.
    at, **values
        Where an aircraft is linearised, as for `linearize`.

    Returns
    -------
    StepResponse
        Deviation from the operating point; what the drift there does is not in it.
    """
    from scipy.linalg import expm

    lin, output, input = _asked(of, names, at, values, "step_response")
    B, C, D, channel = _channel(lin, output, input)
    duration, count = positive("t", t, "s"), whole("samples", samples, 2)
    height = single("size", size, as_model(lin.model).quantities[channel[1]].unit)
    times, n = np.linspace(0.0, duration, count), len(lin.states)
    # the state with the constant input appended: x' = A x + B u, u' = 0
    augmented = np.zeros((*B.shape[:-1], n + 1, n + 1))
    augmented[..., :n, :n], augmented[..., :n, n] = lin.A, B
    state = np.zeros((*B.shape[:-1], times.size, n + 1))
    state[..., 0, n] = height
    with np.errstate(over="ignore", invalid="ignore"):
        advance = expm(augmented * times[1])
        for k in range(1, times.size):
            state[..., k, :] = np.einsum("...ij,...j->...i", advance, state[..., k - 1, :])
        found = np.einsum("...i,...ni->...n", C, state[..., :n]) + (D * height)[..., None]
    if not np.isfinite(found).all():
        raise GroundrollError(
            f"the step response grows beyond what a number can hold within {duration:g} s"
        )
    return StepResponse(times, found, *channel, height, lin.aircraft, lin.model)


@dataclass(frozen=True, repr=False)
class RootLocus(Pictured):
    """Eigenvalues over a parameter, each mode followed from value to value.

    Attributes
    ----------
    parameter : str
        Symbol.
    values : ndarray, shape (n,)
        Its values, SI units with radians.
    eigenvalues : complex ndarray, shape (n, modes)
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
        axes: Axes = drawn("locus", self, ax, unit)
        return axes

    def __repr__(self) -> str:
        q = PARAMETERS[self.parameter]
        return (
            f"RootLocus of {_whose(self)} over {_named(q)}: {span(self.values)}"
            f" {unit_of(q)}, {self.values.size} values"
            f"\n  real parts {span(self.eigenvalues.real)} 1/s,"
            f" imaginary parts {span(self.eigenvalues.imag)} rad/s"
        )


@of_aircraft
def root_locus(
    plane: Aircraft,
    parameter: str,
    values: Any,
    model: ModelLike = "nonlinear",
    at: Mapping[str, Any] | None = None,
    **others: Any,
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
    model, at, **others
        As for `linearize`; scalars.

    Returns
    -------
    RootLocus
        With each mode in a column of its own.
    """
    chosen = as_model(model)
    known = {**PARAMETERS, **{s: chosen.quantities[s] for s in chosen.parameters}}
    key = symbol_of(known, parameter, "parameter", known, "root_locus")
    swept = finite(f"values of {key}", values, known[key].unit)
    steps = np.diff(np.atleast_1d(swept))
    if swept.ndim != 1 or swept.size < 2 or not ((steps > 0).all() or (steps < 0).all()):
        raise GroundrollError(f"values of {key} must be a list that increases or decreases")
    lin = linearize(plane, chosen, at, **{**others, key: swept})
    if lin.decay_rate.shape not in ((), swept.shape):
        raise GroundrollError(
            f"a locus has one parameter, but other arrays give it the shape {lin.decay_rate.shape}"
        )
    eigenvalues = np.broadcast_to(lin.eigenvalues, (*swept.shape, len(lin.states)))
    return RootLocus(key, swept, follow(swept, eigenvalues), plane, lin.model)


def follow(values: FloatArray, eigenvalues: ComplexArray) -> ComplexArray:
    """Order eigenvalues so that each column continues its own line."""
    from scipy.optimize import linear_sum_assignment

    ordered = eigenvalues.copy()
    for k in range(1, len(values)):
        expected = ordered[k - 1]
        if k > 1:
            ratio = (values[k] - values[k - 1]) / (values[k - 1] - values[k - 2])
            expected = expected + (ordered[k - 1] - ordered[k - 2]) * ratio
        distance = np.abs(expected[:, None] - eigenvalues[k][None, :])
        ordered[k] = eigenvalues[k][linear_sum_assignment(distance)[1]]
    return ordered
