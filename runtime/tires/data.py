"""Measured lateral forces of a tire."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

import numpy as np

from groundroll.base.arrays import FloatArray, finite
from groundroll.base.errors import GroundrollError, listed, one_of
from groundroll.base.files import as_path, packaged

from . import table, tir

#: Different slip angles beside zero that a curve takes.
_FEWEST = 4
#: Largest force over load that can be: below and above, a unit is not what it seems.
_FRICTION = (0.02, 5.0)
#: How far apart loads may be, relative, that were meant to be one.
_SAME_LOAD = 0.05


@dataclass(frozen=True)
class Curve:
    """What was measured at one load, in order of the slip angle: N, rad, N, and N as measured."""

    load: float
    slip_angles: FloatArray
    forces: FloatArray
    loads: FloatArray


@dataclass(frozen=True, repr=False, eq=False)
class TireData:
    """Measured lateral forces of one tire, point by point or as a table.

    Attributes
    ----------
    name : str
        Which tire.
    slip_angles, loads, forces : ndarray, shape (n,)
        rad, N and N of each point, by load and angle; forces are positive for positive slip angles
        as in the thesis. May be given as a table: slip angles (n,), loads (k,), forces (n, k); in
        any order, with angles of both signs, and with either sign of the forces.
    notes : tuple of str
        What had to be understood to read them.
    """

    name: str
    slip_angles: FloatArray
    loads: FloatArray
    forces: FloatArray
    notes: tuple[str, ...] = field(default=())

    def __post_init__(self) -> None:
        given = {"slip_angles": "rad", "loads": "N", "forces": "N"}
        alpha, Fz, F = (
            finite(f"{key} of tire data {self.name!r}", getattr(self, key), unit)
            for key, unit in given.items()
        )
        if F.ndim == 2 and F.shape == (alpha.size, Fz.size):
            alpha, Fz = (x.ravel() for x in np.meshgrid(alpha, Fz, indexing="ij"))
            F = F.ravel()
        if not (alpha.ndim == 1 and alpha.shape == Fz.shape == F.shape):
            raise GroundrollError(
                f"tire data {self.name!r}: forces must be as many as slip angles and loads, or a"
                f" table of slip angles by loads, but shapes are"
                f" {', '.join(str(np.shape(getattr(self, key))) for key in given)}"
            )
        Fz, F, notes = _in_the_thesiss_signs(alpha, Fz, F)
        if mistakes := _mistakes(alpha, Fz, F):
            raise GroundrollError(listed(f"tire data {self.name!r}", mistakes))
        order = np.lexsort((alpha, Fz))
        for key, array in zip(given, (alpha, Fz, F), strict=True):
            values = array[order]
            values.setflags(write=False)
            object.__setattr__(self, key, values)
        object.__setattr__(self, "notes", (*self.notes, *notes))

    @classmethod
    def load(cls, name: str | Path) -> TireData:
        """Read packaged tire data by name, or a file by path.

        Parameters
        ----------
        name : str or Path
            ``"goodyear-6.00-6"`` (Table 3.1 of the thesis), or the path of a ``.csv`` file (see
            `groundroll.tires.table`) or of a ``.tir`` file (see `groundroll.tires.tir`).

        Raises
        ------
        GroundrollError
            If there is no such data or file, or if the file has mistakes: all of them are
            listed, each with its line.
        """
        path = as_path(name)
        if path.suffix.lower() == ".tir":
            return tir.read(path, cls)
        if path.suffix.lower() not in (".csv", ".txt", ".tsv", ".dat"):
            tables = packaged_tables()
            where = "the packaged ones (a file ends in .csv or .tir)"
            path = tables[one_of("tire data", str(name), tables, where)]
        return table.read(path, cls)

    @cached_property
    def curves(self) -> tuple[Curve, ...]:
        """The points by load; loads within 5 % of each other are one, their mean."""
        breaks = np.flatnonzero(np.diff(self.loads) > _SAME_LOAD * self.loads[1:]) + 1
        curves = []
        for part in np.split(np.arange(self.loads.size), breaks):
            part = part[np.argsort(self.slip_angles[part], kind="stable")]
            load = float(self.loads[part].mean())
            each = (self.slip_angles[part], self.forces[part], self.loads[part])
            curves.append(Curve(load, *each))
        return tuple(curves)

    def __repr__(self) -> str:
        angles = np.degrees(self.slip_angles)
        loads = [curve.load for curve in self.curves]
        what = f"{len(loads)} loads {loads[0]:g} to" if len(loads) > 1 else "1 load"
        return (
            f"TireData {self.name!r}: {angles.size} points from {angles.min():g} to"
            f" {angles.max():g} deg, {what} {loads[-1]:g} N"
        )


def _in_the_thesiss_signs(
    alpha: FloatArray, Fz: FloatArray, F: FloatArray
) -> tuple[FloatArray, FloatArray, list[str]]:
    """Loads and forces positive, the forces for positive slip angles; and what had to be turned."""
    notes = []
    if Fz.size and (Fz < 0).all():
        Fz = -Fz
        notes.append("loads are negative in the file, and taken without their sign")
    if (F - np.median(F)) @ alpha < 0 and F @ alpha < 0:
        F = -F
        notes.append("forces have the sign opposite to that of the slip angles, and are turned")
    return Fz, F, notes


def _mistakes(alpha: FloatArray, Fz: FloatArray, F: FloatArray) -> list[str]:
    mistakes = []
    different = np.unique(np.round(np.abs(np.degrees(alpha)), 6))
    count = int((different > 0).sum())
    if count < _FEWEST:
        mistakes.append(
            f"at least {_FEWEST} different slip angles beside zero are needed, not {count}"
        )
    if alpha.size and np.abs(alpha).max() >= np.pi / 2:
        largest = np.degrees(np.abs(alpha)).max()
        mistakes.append(f"slip angles must be below 90 deg, but there is {largest:g} deg")
    if (Fz <= 0).any():
        mistakes.append(f"loads must be positive, but there is {Fz.min():g} N")
    if mistakes:
        return mistakes
    if F @ alpha <= 0:
        return ["forces do not grow with the slip angle"]
    low, high = _FRICTION
    friction = float(np.abs(F / Fz).max())
    if not low <= friction <= high:
        return [
            f"the largest force is {friction:.3g} times its load, and a tire has {low:g} to"
            f" {high:g}: are the units of loads and forces those that are named?"
        ]
    return []


def packaged_tables() -> dict[str, Path]:
    """The packaged tire tables by name."""
    return packaged("tires", ".csv")
