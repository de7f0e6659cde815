"""From measured tire forces to the parameters of the non-linear tire."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from groundroll.base.arrays import FloatArray
from groundroll.model.evaluate import elementwise
from groundroll.model.names import QUANTITIES

from .data import Curve, TireData
from .search import Search

#: The parameters of a tire.
PARAMETERS = ("B3", "C3", "B5", "C5", "B1", "C1", "D1", "E1")

#: Share of a force from which a peak beyond the data is worth telling.
_BEYOND = 0.02
#: Share of friction from which an offset or a difference between the halves is worth telling.
_WORTH = 0.005
#: Error, as a share of friction, above which the tire is not like the formula.
_POOR = 0.03


@dataclass(frozen=True, repr=False, eq=False)
class TireFit:
    """Parameters of the non-linear tire that fit measured forces.

    Attributes
    ----------
    data : TireData
        What was fitted.
    parameters : mapping of str to float
        By symbol, SI units with radians: what ``plane.replace(**fit.parameters)`` takes. The
        lines of the cornering coefficient (B3, C3) and of friction (B5, C5) over load, the magic
        formula (B1, C1, D1, E1), scaled so that the cornering coefficient is the slope at zero
        slip and friction the largest force, each over load; and what was measured (Fz_low,
        Fz_high, alpha_high).
    offsets : mapping of float to float
        Force at zero slip by load, N: conicity and ply steer, which are left out of the tire.
    rms : float
        Root mean square error as a share of friction times load.
    force_rms : float
        Root mean square error, N.
    notes : tuple of str
        What was understood, found and assumed.
    """

    data: TireData
    parameters: Mapping[str, float]
    offsets: Mapping[float, float]
    rms: float
    force_rms: float
    notes: tuple[str, ...]

    def __repr__(self) -> str:
        lines = [f"TireFit of {self.data.name!r}"]
        for s, value in self.parameters.items():
            q = QUANTITIES[s]
            lines.append(f"  {s:<10}{value:>14.6g} {q.unit:<10} {q.name}")
        lines.append(f"  rms {self.rms:.5f} of friction, {self.force_rms:.1f} N")
        return "\n".join([*lines, *(f"  {note}" for note in self.notes)])


def fit_tire(data: TireData | str | Path = "goodyear-6.00-6") -> TireFit:
    """Fit the non-linear tire to measured forces.

    Least squares of the forces over all points at once (IPOPT with exact derivatives). The force
    at zero slip is an offset and left out of the tire. The slope at zero is not below the measured
    secant of any curve that bends down from the start. Where the data leave a choice (a peak that
    lies beyond them, one load) what is likely of a tire decides, with the weight of single points
    of 1 % error; the notes tell it.

    Parameters
    ----------
    data : TireData or str or Path
        Measured forces, or what `TireData.load` takes.

    Returns
    -------
    TireFit
        The parameters, how well they fit, and what is to be known of them.

    Raises
    ------
    GroundrollError
        If the data cannot be read, or are not enough.
    """
    data = data if isinstance(data, TireData) else TireData.load(data)
    search = Search(data.curves)
    found = search.best()
    parameters = {s: float(found[s][0]) for s in PARAMETERS}
    parameters |= dict(zip(("Fz_low", "Fz_high"), search.loads, strict=True))
    parameters["alpha_high"] = float(np.abs(data.slip_angles).max())
    loads = np.concatenate([curve.loads for curve in data.curves])
    friction = _at(parameters, np.zeros_like(loads), loads)["mu"]
    shifts = zip(data.curves, found["S"], search.has_offset, strict=True)
    offsets = {curve.load: float(S) for curve, S, has in shifts if has}
    return TireFit(
        data=data,
        parameters=parameters,
        offsets=offsets,
        rms=_rms(found["errors"] / friction),
        force_rms=_rms(found["errors"] * loads),
        notes=(
            *data.notes,
            *_on_offsets(data.curves, parameters, offsets),
            *_on_the_peak(data.curves, parameters),
            *_on_loads(search),
            *_on_the_fit(_rms(found["errors"] / friction)),
        ),
    )


def _at(
    parameters: Mapping[str, float], alpha: FloatArray, Fz: FloatArray
) -> dict[str, FloatArray]:
    values = {s: np.asarray(value) for s, value in parameters.items()}
    return elementwise("tire_force", {**values, "alpha": alpha, "Fz": Fz})


def _rms(errors: FloatArray) -> float:
    return float(np.sqrt(np.mean(errors**2)))


def _on_offsets(
    curves: tuple[Curve, ...], parameters: Mapping[str, float], offsets: Mapping[float, float]
) -> Iterator[str]:
    """What the curves do at zero slip, and whether their halves agree."""
    told = [curve for curve in curves if curve.load in offsets]
    friction = {c.load: c.load * _friction(parameters, c.load) for c in told}
    large = [c.load for c in told if abs(offsets[c.load]) > _WORTH * friction[c.load]]
    if large:
        yield (
            f"an offset of {_range([offsets[load] for load in large], 'N')} at zero slip, at"
            f" {_range(large, 'N')} of load, is left out of the tire"
        )
    halves = [c for c in told if (c.slip_angles < 0).any() and (c.slip_angles > 0).any()]
    if halves:
        apart = max(_halves_apart(c, offsets[c.load]) / friction[c.load] for c in halves)
        yield (
            f"forces to the left and to the right differ by {100 * apart:.1f} % of the friction"
            " force (rms) or less"
        )


def _halves_apart(curve: Curve, S: float) -> float:
    """Root mean square difference of the two halves of a curve where they overlap, N."""
    alpha, F = curve.slip_angles, curve.forces - S
    right, left = alpha > 0, alpha < 0
    mirrored, there = -alpha[left][::-1], -F[left][::-1]
    common = (alpha >= mirrored[0]) & (alpha <= mirrored[-1]) & right
    if not common.any():
        return 0.0
    return _rms(F[common] - np.interp(alpha[common], mirrored, there))


def _on_the_peak(curves: tuple[Curve, ...], parameters: Mapping[str, float]) -> Iterator[str]:
    """Whether the largest force lies beyond what was measured."""
    beyond = []
    for curve in curves:
        last = float(np.abs(curve.slip_angles).max())
        found = _at(parameters, np.array([last]), np.array([curve.load]))
        friction, reached = float(found["mu"][0]), float(found["F_y"][0]) / curve.load
        if reached < (1 - _BEYOND) * friction:
            beyond.append((curve.load, friction, np.degrees(last), reached))
    if beyond:
        loads, frictions, ends, there = zip(*beyond, strict=True)
        yield (
            f"the largest friction, {_range(frictions)} at {_range(loads, 'N')} of load, is"
            f" extrapolated: at {_range(ends, 'deg')}, where the data end, it is {_range(there)}"
        )


def _on_loads(search: Search) -> Iterator[str]:
    if search.has_one_load:
        yield (
            "how the tire changes with load is unknown: it was measured at"
            f" {_range(search.loads)} N only, and its coefficients there are taken for every load"
        )


def _on_the_fit(rms: float) -> Iterator[str]:
    if rms > _POOR:
        yield f"the formula misses the data by {100 * rms:.0f} % of the friction force (rms)"


def _friction(parameters: Mapping[str, float], load: float) -> float:
    return float(_at(parameters, np.zeros(1), np.array([load]))["mu"][0])


def _range(values: Sequence[float], unit: str = "") -> str:
    """One value, or the first and the last of different ones."""
    first, last = (
        f"{value:.3g}" if abs(value) < 100 else f"{value:.0f}" for value in (values[0], values[-1])
    )
    return f"{first} {unit}".strip() if first == last else f"{first} to {last} {unit}".strip()
