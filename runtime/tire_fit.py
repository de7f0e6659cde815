"""From measured tire forces to the parameters of the non-linear tire (Section 3.4)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from importlib import resources
from pathlib import Path
from typing import Any, Protocol

import casadi as ca
import numpy as np
import numpy.typing as npt

from .arrays import FloatArray, finite
from .errors import GroundloopError, unknown
from .evaluate import elementwise
from .generated import build
from .generated.names import QUANTITIES

#: Symbols of the load dependence (straight lines) and of the magic formula.
LINES = ("B3", "C3", "B5", "C5")
MAGIC = ("B1", "C1", "D1", "E1")

#: From where the thesis searched: x0 of MAGICFIT.m, App. A.1.
THESIS_START = (0.7407, 1.35, 1.00, -0.51)

#: The search stays where no slip angle makes the force reverse: with E1 <= 1 psi_bar never
#: turns back, and with C1 <= 2 the sine never passes half a turn.
_LOWEST = (1e-6, 1e-6, 1e-6, -np.inf)
_HIGHEST = (np.inf, 2.0, np.inf, 1.0)

_SECANT = np.radians(1.0)  # where Eq. 3.2 takes the cornering coefficient
_FEWEST_ANGLES, _FEWEST_LOADS = 5, 2
_QUIET: dict[str, Any] = {
    "print_time": False,
    "error_on_fail": False,
    "ipopt": {
        "print_level": 0,
        "sb": "yes",
        "tol": 1e-12,
        "acceptable_iter": 0,  # a point short of the minimum is a failure
        "mu_init": 1e-10,  # the usual barrier, 0.1, is so high here that the start is forgotten
        "bound_relax_factor": 0.0,
    },
}


class ParameterSet(Protocol):
    """What holds tire parameters by symbol: a mapping, or an `Aircraft`."""

    def __getitem__(self, symbol: str, /) -> Any: ...


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
            raise _listed(f"tire data {self.name!r}", mistakes)

    @classmethod
    def load(cls, name: str | Path) -> TireData:
        """Read packaged tire data by name, or a CSV file by path.

        Parameters
        ----------
        name : str or Path
            ``"goodyear-6.00-6"`` (Table 3.1 of the thesis), or the path of a ``.csv`` file:
            comment lines begin with ``#``, the header is ``slip_angle_deg`` and the loads in N,
            each row is a slip angle in degrees and the forces in N.

        Raises
        ------
        GroundloopError
            If there is no such data or file, or if the file has mistakes: all of them are
            listed, each with its line.
        """
        path = Path(name)
        if path.suffix != ".csv":
            packaged = _packaged()
            if str(name) not in packaged:
                where = "the packaged ones (a file ends in .csv)"
                raise unknown("tire data", str(name), packaged, where)
            path = packaged[str(name)]
        try:
            text = path.read_text(encoding="utf-8")
        except OSError as problem:
            raise GroundloopError(f"cannot read {path}: {problem.strerror}") from problem
        except UnicodeDecodeError as problem:
            raise GroundloopError(f"{path} is not a text file: {problem}") from problem
        table = _table(text, path)
        try:
            return cls(path.stem, np.radians(table[1:, 0]), table[0, 1:], table[1:, 1:])
        except GroundloopError as problem:
            raise GroundloopError(f"{path}: {problem}") from None

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


@dataclass(frozen=True, repr=False, eq=False)
class TireFit:
    """Parameters of the non-linear tire that fit measured forces.

    Attributes
    ----------
    data : TireData
        What was fitted.
    parameters : mapping of str to float
        By symbol (B3, C3, B5, C5, B1, C1, D1, E1), SI units with radians: what
        ``plane.replace(**fit.parameters)`` takes.
    cornering_coefficients, friction_coefficients : ndarray, shape (k,)
        Measured, at each load: 1/rad and 1.
    alpha_bar, F_bar : ndarray, shape (n, k)
        The normalised data.
    rms : float
        Root mean square error of the magic formula, normalised.
    force_rms : float
        Root mean square error of the whole tire, with the straight lines, N.
    conditioning : float
        See `conditioning`.
    at_edge : tuple of str
        Which parameters of the magic formula lie on the edge of the search, where the minimum
        is none of the free function; empty for a proper minimum.
    """

    data: TireData
    parameters: Mapping[str, float]
    cornering_coefficients: FloatArray
    friction_coefficients: FloatArray
    alpha_bar: FloatArray
    F_bar: FloatArray
    rms: float
    force_rms: float
    conditioning: float
    at_edge: tuple[str, ...]

    def __repr__(self) -> str:
        lines = [f"TireFit of {self.data.name!r}"]
        for s, value in self.parameters.items():
            q = QUANTITIES[s]
            lines.append(f"  {s}{value:>14.6g} {q.unit:<10} {q.name}")
        lines += [
            f"  rms {self.rms:.5f} normalised, {self.force_rms:.1f} N",
            f"  conditioning {self.conditioning:.1e}",
            *(f"  {s} is on the edge of the search: no proper minimum" for s in self.at_edge),
        ]
        return "\n".join(lines)


def fit_tire(
    data: TireData | str | Path = "goodyear-6.00-6", start: Sequence[float] = THESIS_START
) -> TireFit:
    """Fit the non-linear tire to measured forces, as Section 3.4 does.

    Coefficients at each load, their straight lines by least squares, and the magic formula by
    least squares on the normalised data (IPOPT with exact derivatives). The search keeps
    B1, D1 > 0, 0 < C1 <= 2 and E1 <= 1, where the force cannot reverse at any slip angle.
    Beyond E1 = 1 lies a valley without a minimum (C1 to 0, D1 to infinity), which fits the
    thesis's data 7 % better and is worthless beyond them; Table 3.2 is a point in it. The
    search is local: on the thesis's data it ends, nine starts out of ten, in one and the same
    minimum, otherwise in a worse one on the edge, E1 = 1 (so does Table 3.2 as a start).

    Parameters
    ----------
    data : TireData or str or Path
        Measured forces, or what `TireData.load` takes.
    start : sequence of 4 floats
        B1, C1, D1, E1 from where to search; default the thesis's own.

    Returns
    -------
    TireFit
        The parameters and how well they fit.

    Raises
    ------
    GroundloopError
        If the search finds no minimum.
    """
    data = data if isinstance(data, TireData) else TireData.load(data)
    C_c, mu = data.coefficients()
    alpha_bar, F_bar = data.normalised()
    B3, C3 = _straight_line(data.loads, C_c)
    B5, C5 = _straight_line(data.loads, mu)
    magic = _least_squares(alpha_bar, F_bar, start, data.name)
    values = (B3, C3, B5, C5, *magic)
    parameters = dict(zip((*LINES, *MAGIC), values, strict=True))
    return TireFit(
        data=data,
        parameters=parameters,
        cornering_coefficients=C_c,
        friction_coefficients=mu,
        alpha_bar=alpha_bar,
        F_bar=F_bar,
        rms=normalised_rms(data, parameters),
        force_rms=force_rms(data, parameters),
        conditioning=conditioning(data, parameters),
        at_edge=_at_edge(magic),
    )


def normalised_rms(data: TireData, parameters: ParameterSet) -> float:
    """Root mean square error of a magic formula on the normalised data.

    The points at zero slip, which every parameter set meets, are not counted; with one for each
    load the thesis's data give 0.0104 instead of 0.0107.
    """
    alpha_bar, F_bar = data.normalised()
    arguments = {"alpha_bar": alpha_bar, **_values(parameters, MAGIC)}
    return _rms(elementwise("magic_formula", arguments)["F_bar"] - F_bar)


def force_rms(data: TireData, parameters: ParameterSet) -> float:
    """Root mean square error of the reconstructed forces (Fig. 3.7), N."""
    return _rms(_forces(parameters, data.slip_angles[:, None], data.loads) - data.forces)


def conditioning(data: TireData, parameters: ParameterSet) -> float:
    """Condition number of the Gauss-Newton matrix of the magic formula fit.

    Each parameter is scaled so that the diagonal is one: 1 where every parameter leaves a mark
    of its own on the data, infinite where some change of all four leaves none.
    """
    residual, x = _residual(*data.normalised())
    jacobian = ca.Function("jacobian", [x], [ca.jacobian(residual, x)])
    x0 = [float(value) for value in _values(parameters, MAGIC).values()]
    J = np.array(jacobian(x0), dtype=np.float64)
    scale = np.linalg.norm(J, axis=0)
    return float(np.linalg.cond(J / scale) ** 2) if scale.all() else float("inf")


@dataclass(frozen=True)
class Quality:
    """How a set of tire parameters does on the data, and beyond them at one load.

    Attributes
    ----------
    rms, force_rms, conditioning : float
        As in `TireFit`.
    peak_slip_angle : float
        Slip angle of the largest force, rad.
    peak_force : float
        That force, N.
    sideways_share : float
        Force at 90 deg of slip as a share of the peak.
    reversal : float
        Slip angle from which the force has the wrong sign, rad; NaN if it never has.
    """

    rms: float
    force_rms: float
    conditioning: float
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
        if name not in self.rows:
            raise unknown("parameter set", name, self.rows, "this comparison")
        return self.rows[name]

    def __repr__(self) -> str:
        width = max(map(len, self.rows), default=0)
        lines = [
            f"Tire parameters against {self.data.name!r}; peak, 90 deg and reversal at"
            f" {self.load:g} N",
            f"  {'':<{width}}     rms  force rms  conditioning        peak  at 90 deg  reverses at",
        ]
        for name, q in self.rows.items():
            reversal = "never" if np.isnan(q.reversal) else f"{np.degrees(q.reversal):.1f} deg"
            lines.append(
                f"  {name:<{width}}  {q.rms:.4f}  {q.force_rms:>7.1f} N  {q.conditioning:>12.1e}"
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
    chosen = float(finite("load", np.median(data.loads) if load is None else load))
    if chosen <= 0:
        raise GroundloopError(f"load must be positive, not {chosen} N")
    rows = {name: _quality(data, name, parameters, chosen) for name, parameters in sets.items()}
    return Comparison(data, chosen, rows)


def _quality(data: TireData, name: str, parameters: ParameterSet, load: float) -> Quality:
    angles = np.linspace(0.0, np.pi / 2, 9001)  # every hundredth of a degree
    forces = _forces(parameters, angles, np.asarray(load))
    peak = int(forces.argmax())
    if not forces[peak] > 0:
        raise GroundloopError(f"parameter set {name!r} gives no force at a load of {load:g} N")
    wrong = np.flatnonzero(forces < 0)
    return Quality(
        rms=normalised_rms(data, parameters),
        force_rms=force_rms(data, parameters),
        conditioning=conditioning(data, parameters),
        peak_slip_angle=float(angles[peak]),
        peak_force=float(forces[peak]),
        sideways_share=float(forces[-1] / forces[peak]),
        reversal=float(angles[wrong[0]]) if wrong.size else float("nan"),
    )


def _forces(parameters: ParameterSet, alpha: FloatArray, Fz: FloatArray) -> FloatArray:
    arguments = {"alpha": alpha, "Fz": Fz, **_values(parameters, (*LINES, *MAGIC))}
    return elementwise("tire_force", arguments)["F_y"]


def _values(parameters: ParameterSet, symbols: Sequence[str]) -> dict[str, FloatArray]:
    values = {s: finite(s, parameters[s]) for s in symbols}
    for s, value in values.items():
        if value.ndim:
            raise GroundloopError(f"{s} must be one number here, not an array {value.shape}")
    return values


def _rms(errors: FloatArray) -> float:
    return float(np.sqrt(np.mean(errors**2)))


def _straight_line(x: FloatArray, y: FloatArray) -> tuple[float, float]:
    """Intercept and slope of the least-squares line."""
    slope, intercept = np.polyfit(x, y, 1)
    return float(intercept), float(slope)


def _residual(alpha_bar: FloatArray, F_bar: FloatArray) -> tuple[ca.SX, ca.SX]:
    """Errors of the magic formula at the data as an expression of B1, C1, D1, E1."""
    x = ca.SX.sym("x", len(MAGIC))
    predicted = build("magic_formula")(alpha_bar.reshape(1, -1), *ca.vertsplit(x))
    return (predicted - F_bar.reshape(1, -1)).T, x


def _least_squares(
    alpha_bar: FloatArray, F_bar: FloatArray, start: Sequence[float], name: str
) -> list[float]:
    """B1, C1, D1, E1 at the minimum of the sum of squares."""
    x0 = finite("start", start)
    if x0.shape != (len(MAGIC),):
        raise GroundloopError(f"start must be {', '.join(MAGIC)}: 4 numbers, not {start!r}")
    residual, x = _residual(alpha_bar, F_bar)
    solver = ca.nlpsol("magic_fit", "ipopt", {"x": x, "f": ca.sumsqr(residual)}, _QUIET)
    solution = solver(x0=x0, lbx=list(_LOWEST), ubx=list(_HIGHEST))
    if not solver.stats()["success"]:
        raise GroundloopError(
            f"tire data {name!r}: the magic formula fit found no minimum from start"
            f" {tuple(map(float, x0))} (IPOPT: {solver.stats()['return_status']}); try another"
            " start, and check that the forces level off within the measured slip angles"
        )
    return [float(value) for value in np.array(solution["x"]).ravel()]


def _at_edge(magic: Sequence[float]) -> tuple[str, ...]:
    near = np.isclose(magic, _LOWEST, atol=1e-6) | np.isclose(magic, _HIGHEST, atol=1e-6)
    return tuple(s for s, there in zip(MAGIC, near, strict=True) if there)


def _packaged() -> dict[str, Path]:
    folder = resources.files("groundloop") / "fleet"
    files = sorted(Path(str(p)) for p in folder.iterdir() if p.name.endswith(".csv"))
    return {p.stem: p for p in files}


def _listed(what: str, mistakes: Sequence[str]) -> GroundloopError:
    return GroundloopError("\n".join([f"{what} has {len(mistakes)} mistake(s):", *mistakes]))


def _table(text: str, path: Path) -> FloatArray:
    """The numbers of a CSV file, its header as the first row with NaN in the corner."""
    lines = [
        (number, [cell.strip() for cell in line.split(",")])
        for number, line in enumerate(text.splitlines(), start=1)
        if line.strip() and not line.lstrip().startswith("#")
    ]
    if len(lines) < 2:
        raise GroundloopError(f"{path} has no data: a header and rows of numbers are needed")
    (number, header), body = lines[0], lines[1:]
    mistakes = []
    if header[0] != "slip_angle_deg":
        mistakes.append(
            f"line {number}: the header must be slip_angle_deg and the loads in N,"
            f" but begins with {header[0]!r}"
        )
    table = [[float("nan"), *_numbers(header[1:], number, 2, mistakes)]]
    for number, cells in body:
        if len(cells) != len(header):
            mistakes.append(
                f"line {number}: {len(cells)} columns, but the header has {len(header)}"
            )
        table.append(_numbers(cells, number, 1, mistakes))
    if mistakes:
        raise _listed(str(path), mistakes)
    return np.array(table)


def _numbers(cells: Sequence[str], line: int, first: int, mistakes: list[str]) -> list[float]:
    """Finite numbers of a line; for each cell that is none, a mistake."""
    values = []
    for column, cell in enumerate(cells, start=first):
        try:
            value = float(cell)
        except ValueError:
            value = float("nan")
        if not np.isfinite(value):
            mistakes.append(f"line {line}, column {column}: {cell!r} is not a finite number")
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
