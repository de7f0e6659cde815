"""Measured lateral forces of a tire, as in Table 3.1."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from importlib import resources
from pathlib import Path

import numpy as np
import numpy.typing as npt

from .arrays import FloatArray, finite
from .errors import GroundrollError, listed, one_of, shown
from .evaluate import elementwise
from .files import as_path, text_of
from .units import UnitError, to_si

_SECANT = np.radians(1.0)  # where Eq. 3.2 takes the cornering coefficient
_FEWEST_ANGLES, _FEWEST_LOADS = 5, 2


@dataclass(frozen=True, repr=False, eq=False)
class TireData:
    """Measured lateral forces of one tire.

    Attributes
    ----------
    name : str
        Which tire.
    slip_angles : ndarray, shape (n,)
        rad, increasing, below 90 deg; one of them is 1 deg.
    loads : ndarray, shape (k,)
        Vertical loads, N, increasing.
    forces : ndarray, shape (n, k)
        N, positive for a positive slip angle as in the thesis.
    """

    name: str
    slip_angles: FloatArray
    loads: FloatArray
    forces: FloatArray

    def __post_init__(self) -> None:
        for field in ("slip_angles", "loads", "forces"):
            array = finite(f"{field} of tire data {self.name!r}", getattr(self, field)).copy()
            array.setflags(write=False)
            object.__setattr__(self, field, array)
        mistakes = _shape_mistakes(self) or _content_mistakes(self)
        if mistakes:
            raise GroundrollError(listed(f"tire data {self.name!r}", mistakes))

    @classmethod
    def load(cls, name: str | Path) -> TireData:
        """Read packaged tire data by name, or a CSV file by path.

        Parameters
        ----------
        name : str or Path
            ``"goodyear-6.00-6"`` (Table 3.1 of the thesis), or the path of a ``.csv`` file:
            comment lines begin with ``#``, the header is ``slip_angle_deg`` and the loads,
            each row is a slip angle in degrees and the forces. Loads may have one unit, which is
            that of the forces too (``400 lbf``); bare ones are in N.

        Raises
        ------
        GroundrollError
            If there is no such data or file, or if the file has mistakes: all of them are
            listed, each with its line.
        """
        path = as_path(name)
        if path.suffix != ".csv":
            packaged, where = _packaged(), "the packaged ones (a file ends in .csv)"
            path = packaged[one_of("tire data", str(name), packaged, where)]
        table = _table(text_of(path, most=2**20), path)
        try:
            return cls(path.stem, np.radians(table[1:, 0]), table[0, 1:], table[1:, 1:])
        except GroundrollError as problem:
            raise GroundrollError(f"{path}: {problem}") from None

    def coefficients(self) -> tuple[FloatArray, FloatArray]:
        """Cornering and friction coefficient at each load (Eqs. 3.2, 3.4).

        Returns
        -------
        C_c : ndarray, shape (k,)
            Secant at 1 deg over the load, 1/rad.
        mu : ndarray, shape (k,)
            Largest measured force over the load.
        """
        secant = int(_secant_rows(self)[0])
        arguments = {
            "alpha": np.asarray(self.slip_angles[secant]),
            "F_y": self.forces[secant],
            "F_peak": self.forces.max(axis=0),
            "Fz": self.loads,
        }
        found = elementwise("measured_coefficients", arguments)
        return found["C_c"], found["mu"]

    def normalised(self) -> tuple[FloatArray, FloatArray]:
        """Normalised slip angles and forces (Eqs. 3.6, 3.7), shape (n, k) each.

        Each load is normalised with its own measured coefficients, not with the straight lines.
        """
        C_c, mu = self.coefficients()
        arguments = {
            "alpha": self.slip_angles[:, None],
            "F_y": self.forces,
            "Fz": self.loads,
            "C_c": C_c,
            "mu": mu,
        }
        found = elementwise("normalised_data", arguments)
        return found["alpha_bar"], found["F_bar"]

    def __repr__(self) -> str:
        angles, loads = np.degrees(self.slip_angles), self.loads
        return (
            f"TireData {self.name!r}: {angles.size} slip angles {angles[0]:g} to {angles[-1]:g}"
            f" deg, {loads.size} loads {loads[0]:g} to {loads[-1]:g} N"
        )


def _packaged() -> dict[str, Path]:
    folder = resources.files("groundroll") / "fleet"
    files = sorted(Path(str(p)) for p in folder.iterdir() if p.name.endswith(".csv"))
    return {p.stem: p for p in files}


def _table(text: str, path: Path) -> FloatArray:
    """A CSV file in degrees and N, its header as the first row with NaN in the corner."""
    lines = [
        (number, [cell.strip() for cell in line.split(",")])
        for number, line in enumerate(text.splitlines(), start=1)
        if line.strip() and not line.lstrip().startswith("#")
    ]
    if len(lines) < 2:
        raise GroundrollError(f"{path} has no data: a header and rows of numbers are needed")
    (number, header), body = lines[0], lines[1:]
    mistakes = []
    if header[0] != "slip_angle_deg":
        mistakes.append(
            f"line {number}: the header must be slip_angle_deg and the loads, such as"
            " slip_angle_deg,400 lbf,800 lbf (bare loads are in N), but begins with"
            f" {shown(header[0])}"
        )
    loads, newtons = _loads(header[1:], number, mistakes)
    table = [[float("nan"), *_numbers(loads, number, 2, mistakes)]]
    for number, cells in body:
        if len(cells) != len(header):
            mistakes.append(
                f"line {number}: {len(cells)} columns, but the header has {len(header)}"
            )
        table.append(_numbers(cells, number, 1, mistakes))
    if mistakes:
        raise GroundrollError(listed(str(path), mistakes))
    in_newtons = np.array(table)
    in_newtons[0, 1:] *= newtons
    in_newtons[1:, 1:] *= newtons
    return in_newtons


def _loads(cells: Sequence[str], line: int, mistakes: list[str]) -> tuple[list[str], float]:
    """The loads of a header without their unit, and how many N it is."""
    parts = [cell.partition(" ") for cell in cells]
    numbers, units = [number for number, _, _ in parts], {unit.strip() for _, _, unit in parts}
    if len(units) > 1:
        given = " and ".join(sorted(unit or "none" for unit in units))
        mistakes.append(f"line {line}: all loads must have one unit, but there is {given}")
        return numbers, 1.0
    try:
        return numbers, to_si(f"1 {''.join(units)}", "N", f"line {line}")
    except UnitError as problem:
        mistakes.append(str(problem))
        return numbers, 1.0


def _numbers(cells: Sequence[str], line: int, first: int, mistakes: list[str]) -> list[float]:
    """Finite numbers of a line; for each cell that is none, a mistake."""
    values = []
    for column, cell in enumerate(cells, start=first):
        try:
            value = float(cell)
        except ValueError:
            value = float("nan")
        if not math.isfinite(value):
            mistakes.append(f"line {line}, column {column}: {shown(cell)} is not a finite number")
        values.append(value)
    return values


def _shape_mistakes(data: TireData) -> list[str]:
    expected = (data.slip_angles.size, data.loads.size)
    if data.slip_angles.ndim != 1 or data.loads.ndim != 1 or data.forces.shape != expected:
        return [
            f"forces must be slip angles by loads, but shapes are {data.slip_angles.shape},"
            f" {data.loads.shape} and {data.forces.shape}"
        ]
    mistakes = []
    if data.slip_angles.size < _FEWEST_ANGLES:
        given = data.slip_angles.size
        mistakes.append(f"at least {_FEWEST_ANGLES} slip angles are needed, not {given}")
    if data.loads.size < _FEWEST_LOADS:
        given = data.loads.size
        mistakes.append(f"at least {_FEWEST_LOADS} loads are needed for a line, not {given}")
    return mistakes


def _content_mistakes(data: TireData) -> list[str]:
    mistakes = []
    degrees = np.degrees(data.slip_angles)
    for what, values, unit in (("slip angles", degrees, "deg"), ("loads", data.loads, "N")):
        for k in np.flatnonzero(np.diff(values) <= 0):
            pair = f"{values[k + 1]:g} {unit} follows {values[k]:g} {unit}"
            mistakes.append(f"{what} must increase, but {pair}")
    if degrees[0] < 0 or degrees[-1] >= 90:
        mistakes.append("slip angles must be from 0 to below 90 deg")
    if data.loads[0] <= 0:
        mistakes.append(f"loads must be positive, but there is {data.loads[0]:g} N")
    rows = _secant_rows(data)
    if rows.size == 0:
        mistakes.append("no slip angle is 1 deg, where Eq. 3.2 takes the cornering coefficient")
    elif (data.forces[rows] <= 0).any():
        mistakes.append("forces at 1 deg must be positive (forces and slip angles have one sign)")
    return mistakes


def _secant_rows(data: TireData) -> npt.NDArray[np.intp]:
    """Where the slip angle is 1 deg."""
    return np.flatnonzero(np.isclose(data.slip_angles, _SECANT, rtol=1e-9, atol=0.0))
