"""How sets of tire parameters do on measured forces, and at large slip."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

from groundroll.base.arrays import FloatArray, finite, single
from groundroll.base.errors import GroundrollError, one_of
from groundroll.generated import build
from groundroll.model.evaluate import elementwise
from groundroll.model.names import QUANTITIES

from .data import TireData

#: Symbols of the load dependence (straight lines) and of the magic formula.
LINES = ("B3", "C3", "B5", "C5")
MAGIC = ("B1", "C1", "D1", "E1")


class ParameterSet(Protocol):
    """What holds tire parameters by symbol: a mapping, or an `Aircraft`."""

    def __getitem__(self, symbol: str, /) -> Any: ...


def force_rms(data: TireData, parameters: ParameterSet) -> float:
    """Root mean square error of the reconstructed forces (Fig. 3.7), N."""
    return _rms(_forces(parameters, data.slip_angles, data.loads) - data.forces)


def slope_at_zero(parameters: ParameterSet, load: float) -> float:
    """Slope of the force at zero slip, N/rad: what the linear tire has to be."""
    names = [s for s in build("tire_slope").name_in() if s != "Fz"]
    arguments = {"Fz": np.asarray(load), **_values(parameters, names)}
    return float(elementwise("tire_slope", arguments)["F_slope"])


@dataclass(frozen=True)
class Quality:
    """How a set of tire parameters does on the data, and beyond them at one load.

    Attributes
    ----------
    force_rms : float
        Root mean square error on the data, N.
    slope : float
        Slope of the force at zero slip, N/rad.
    peak_slip_angle : float
        Slip angle of the largest force, rad.
    peak_force : float
        That force, N.
    sideways_share : float
        Force at 90 deg of slip as a share of the peak.
    reversal : float
        Slip angle from which the force has the wrong sign, rad; NaN if it never has.
    """

    force_rms: float
    slope: float
    peak_slip_angle: float
    peak_force: float
    sideways_share: float
    reversal: float


@dataclass(frozen=True, repr=False)
class Comparison:
    """Sets of tire parameters side by side; ``comparison["thesis"]`` is a `Quality`.

    Attributes
    ----------
    data : TireData
        What they are measured against.
    load : float
        Vertical load of what goes beyond the data, N.
    rows : mapping of str to Quality
        By name of the set.
    """

    data: TireData
    load: float
    rows: Mapping[str, Quality]

    def __getitem__(self, name: str) -> Quality:
        return self.rows[one_of("parameter set", name, self.rows, "this comparison")]

    def __repr__(self) -> str:
        width = max(map(len, self.rows), default=0)
        lines = [
            f"Tire parameters against {self.data.name!r}; peak, 90 deg and reversal at"
            f" {self.load:g} N",
            f"  {'':<{width}}  force rms     slope at zero        peak  at 90 deg  reverses at",
        ]
        for name, q in self.rows.items():
            reversal = "never" if np.isnan(q.reversal) else f"{np.degrees(q.reversal):.1f} deg"
            lines.append(
                f"  {name:<{width}}  {q.force_rms:>7.1f} N  {np.radians(q.slope):>9.1f} N/deg"
                f"  {np.degrees(q.peak_slip_angle):>6.1f} deg  {q.sideways_share:>9.0%}"
                f"  {reversal:>11}"
            )
        return "\n".join(lines)


def compare(
    data: TireData, sets: Mapping[str, ParameterSet], load: float | None = None
) -> Comparison:
    """Compare sets of tire parameters on the data and at large slip.

    Parameters
    ----------
    data : TireData
        Measured forces.
    sets : mapping of str to (mapping or Aircraft)
        Parameters by symbol, by a name for the table.
    load : float, optional
        Vertical load at which to look beyond the data, N; default the median of the data's.

    Returns
    -------
    Comparison
        One `Quality` for each set; its repr is a table.
    """
    chosen = single("load", np.median(data.loads) if load is None else load, "N")
    if chosen <= 0:
        raise GroundrollError(f"load must be positive, not {chosen} N")
    rows = {name: _quality(data, name, parameters, chosen) for name, parameters in sets.items()}
    return Comparison(data, chosen, rows)


def _quality(data: TireData, name: str, parameters: ParameterSet, load: float) -> Quality:
    angles = np.linspace(0.0, np.pi / 2, 9001)  # every hundredth of a degree
    forces = _forces(parameters, angles, np.asarray(load))
    peak = int(forces.argmax())
    if not forces[peak] > 0:
        raise GroundrollError(f"parameter set {name!r} gives no force at a load of {load:g} N")
    wrong = np.flatnonzero(forces < 0)
    return Quality(
        force_rms=force_rms(data, parameters),
        slope=slope_at_zero(parameters, load),
        peak_slip_angle=float(angles[peak]),
        peak_force=float(forces[peak]),
        sideways_share=float(forces[-1] / forces[peak]),
        reversal=float(angles[wrong[0]]) if wrong.size else float("nan"),
    )


def _forces(parameters: ParameterSet, alpha: FloatArray, Fz: FloatArray) -> FloatArray:
    arguments = {"alpha": alpha, "Fz": Fz, **_values(parameters, (*LINES, *MAGIC))}
    return elementwise("tire_force", arguments)["F_y"]


def _values(parameters: ParameterSet, symbols: Sequence[str]) -> dict[str, FloatArray]:
    values = {s: finite(s, parameters[s], QUANTITIES[s].unit) for s in symbols}
    for s, value in values.items():
        if value.ndim:
            raise GroundrollError(f"{s} must be one number here, not an array {value.shape}")
    return values


def _rms(errors: FloatArray) -> float:
    return float(np.sqrt(np.mean(errors**2)))
