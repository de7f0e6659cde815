"""Steady turns: equilibria of v and r under a steady side force."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from .aircraft import Aircraft, of_aircraft
from .arrays import FloatArray, finite, single
from .errors import GroundrollError, beyond
from .evaluate import columns, elementwise
from .listing import Listed
from .models import ModelLike, as_model
from .modes import modes_of
from .operating_point import OperatingPoint
from .records import Column, Record, measured, run_dims
from .results import Result
from .stability import quantity_of
from .validity import extrapolated_in

BoolArray = npt.NDArray[np.bool_]

#: Slip angle of the main tires up to which equilibria are sought: the tire data end there.
SLIP = math.radians(20.0)

#: Slip angles at which the balance of moments is looked at, for all aircraft at once.
_SAMPLES = 401
_CHUNK = 500
_BISECTIONS = 60
_POLISH = 3
#: A balance with less than this fraction of the main gear's slope does not depend on the angle.
_FLAT = 1e-12


@dataclass(frozen=True, repr=False)
class Trim(Listed, Result):
    """The steady turns of an aircraft; ``trim["v"]`` or ``trim["alpha"]`` holds all branches.

    Attributes
    ----------
    values : mapping of str to ndarray, shape (*shape, branches)
        States v, r and every output by symbol, SI units with radians; the branches in order of
        the slip angle of the main tires, NaN where an aircraft has fewer than another.
    count : int ndarray, shape `shape`
        Number of equilibria found; zero is an answer.
    stable : bool ndarray, shape (*shape, branches)
        Whether the motion about the equilibrium decays; False where there is none.
    decay_rate : ndarray, shape (*shape, branches)
        -max Re(eigenvalue) there, 1/s.
    singular : bool ndarray, shape `shape`
        Where the balance of moments does not depend on the slip angle (main gear at the CG and
        nothing at the tail): there is no equilibrium under a force, and without one every
        sideslip is an equilibrium. None is listed.
    slip : float
        Largest slip angle of the main tires that was searched, rad; infinite for the linear tire.
    aircraft, tire, disturbance
        What was trimmed, at its speed; the side force in N.
    """

    values: Mapping[str, FloatArray]
    count: npt.NDArray[np.int64]
    stable: BoolArray
    decay_rate: FloatArray
    singular: BoolArray
    slip: float
    aircraft: Aircraft
    model: ModelLike
    disturbance: FloatArray

    def __getitem__(self, name: str) -> FloatArray:
        return self.values[
            as_model(self.model).symbol(name, "state or output", tuple(self.values), "this trim")
        ]

    @property
    def points(self) -> tuple[OperatingPoint, ...]:
        """Each equilibrium of a single aircraft as an operating point for `linearize`.

        Raises
        ------
        GroundrollError
            If there are several aircraft; take their numbers from the arrays.
        """
        if self.count.ndim:
            raise GroundrollError(
                f"points are those of one aircraft, not of {self.count.shape}; the arrays"
                ' trim["v"] and trim["r"] hold all of them'
            )
        force = float(self.disturbance)
        pairs = zip(self["v"], self["r"], strict=True)
        return tuple(OperatingPoint(v=float(v), r=float(r), disturbance=force) for v, r in pairs)

    def _record(self) -> Record:
        runs, per = run_dims(self.count.shape), ("branch",)
        model, dims = as_model(self.model), (*runs, *per)
        q = {**model.quantities, "decay_rate": quantity_of("decay_rate")}
        rates = {"decay_rate": self.decay_rate}
        results = {s: measured(dims, v, q[s]) for s, v in {**self.values, **rates}.items()}
        results["stable"] = Column((*runs, *per), self.stable)
        results |= {name: Column(runs, getattr(self, name)) for name in ("count", "singular")}
        given = {"F_disturbance": self.disturbance}
        about = {"slip": self.slip}
        return Record("trim", self.aircraft, model, runs, results, per, given, about)

    @classmethod
    def _of(cls, record: Record) -> Trim:
        results: dict[str, Any] = {s: column.values for s, column in record.results.items()}
        own = {name: results.pop(name) for name in ("stable", "decay_rate", "singular")}
        count = results.pop("count").astype(np.int64)
        (force,) = record.given.values()
        return cls(
            results,
            count=count,
            aircraft=record.aircraft,
            model=record.model.key,
            disturbance=force,
            **own,
            **record.about,
        )

    def _title(self) -> str:
        head = f"Trim of {self.aircraft.name!r}, {as_model(self.model).name} model"
        if self.count.ndim:
            few, many = self.count.min(), self.count.max()
            return f"{head}: {self.count.shape} cases with {few} to {many} equilibria"
        if self.singular:
            return (
                f"{head}: the balance of moments does not depend on the slip angle; no equilibrium"
                " under a side force, and any sideslip is one without"
            )
        where = "" if math.isinf(self.slip) else f" with |alpha| <= {math.degrees(self.slip):g} deg"
        noun = "equilibrium" if self.count <= 1 else "equilibria"
        return f"{head}: {self.count or 'no'} {noun}{where}"

    def _notes(self) -> Iterable[str]:
        return extrapolated_in(self.aircraft, self.values)

    def _rows(self) -> Iterable[Sequence[str]]:
        for k, point in enumerate(() if self.count.ndim else self.points):
            alpha = f"alpha {math.degrees(self['alpha'][k]):.4g} deg"
            verdict = "stable" if self.stable[k] else "unstable"
            yield f"v {point.v:.5g} m/s", f"r {point.r:.5g} rad/s", alpha, verdict


@of_aircraft
def trim(
    plane: Aircraft,
    model: ModelLike = "nonlinear",
    *,
    speed: Any = None,
    disturbance: Any = 0.0,
    slip: float | str = SLIP,
) -> Trim:
    """Find every steady turn of an aircraft under a steady side force on its tail.

    The equilibrium is one equation in one unknown, the slip angle of the main tires (generated,
    see the equation sheet). It is sampled over the whole range; each change of sign, and each
    extremum that touches zero, is bracketed and bisected, then polished by Newton steps with the
    exact Jacobian in v and r. Two equilibria are told apart if the balance of moments has no
    more than one extremum between neighbouring samples, 0.1 degrees apart for the default range.

    Parameters
    ----------
    plane : Aircraft
        The aircraft; its parameters may be arrays.
    model : str or Model
        ``"linear"`` or ``"nonlinear"``.
    speed : float or array, optional
        Forward speed, m/s; default the aircraft's own.
    disturbance : float or array
        Side force on the vertical tail, N, to the right.
    slip : float
        Largest slip angle of the main tires to search, rad, below a right angle; by default
        20 degrees, where the tire data (Table 3.1) end. The linear tire has one equilibrium,
        which is given wherever it is. The angle at the tail may be any.

    Returns
    -------
    Trim
        All equilibria in the range, and the stability of each. There may be none.

    Raises
    ------
    GroundrollError
        For unknown names, values that cannot be, or a range that is none.
    """
    widest = single("slip", slip, "rad")
    if not 0 < widest < math.pi / 2:
        raise GroundrollError(f"slip must be between 0 and a right angle (pi/2), not {slip}")
    aircraft = plane if speed is None else plane.replace(u=speed)
    force = finite("disturbance", disturbance, "N")
    p, flat, shape = aircraft.columns(model, disturbance=force)
    balance = _Balance(model, p, flat["disturbance"])
    search = _only_root if model == "linear" else _all_roots
    found, singular = search(balance, widest)
    found = _polished(balance, found)
    values, stable, decay_rate, count = _gathered(balance, found)

    def shaped(array: Any) -> Any:
        return array.reshape((*shape, *array.shape[1:]))

    return Trim(
        values={name: shaped(array) for name, array in values.items()},
        count=shaped(count),
        stable=shaped(stable),
        decay_rate=shaped(decay_rate),
        singular=shaped(singular),
        slip=math.inf if model == "linear" else widest,
        aircraft=aircraft,
        model=as_model(model).key,
        disturbance=force,
    )


@dataclass(frozen=True)
class _Balance:
    """The balance of moments of some aircraft, one column of parameters each."""

    model: ModelLike
    p: FloatArray
    force: FloatArray

    def at(self, alpha: FloatArray, case: Any = slice(None)) -> dict[str, FloatArray]:
        """The generated equilibrium function at slip angles of the aircraft `case`."""
        parameters = dict(zip(as_model(self.model).parameters, self.p[:, case], strict=True))
        arguments = {"alpha": alpha, "F_disturbance": self.force[case], **parameters}
        found = elementwise(as_model(self.model).function("equilibrium"), arguments)
        if not all(np.isfinite(values).all() for values in found.values()):
            raise beyond("the balance of moments")
        return found

    def moment(self, alpha: FloatArray, case: Any) -> FloatArray:
        """The sum of moments, N m: zero in a steady turn."""
        return self.at(alpha, case)["sum_M"]

    def slope(self, alpha: FloatArray, case: Any) -> FloatArray:
        """Its derivative by the slip angle."""
        return self.at(alpha, case)["d_sum_M_d_alpha"]


@dataclass(frozen=True)
class _Found:
    """Equilibria in a list: of which aircraft each is, and its v and r."""

    case: npt.NDArray[np.intp]
    v: FloatArray
    r: FloatArray


def _only_root(balance: _Balance, slip: float) -> tuple[_Found, BoolArray]:
    """The equilibrium of the linear tire, whose balance is a straight line."""
    line = balance.at(np.zeros_like(balance.force))
    singular = _is_flat(line)
    case = np.flatnonzero(~singular)
    alpha = -line["sum_M"][case] / line["d_sum_M_d_alpha"][case]
    turn = balance.at(alpha, case)
    return _Found(case, turn["v"], turn["r"]), singular


def _is_flat(values: Mapping[str, FloatArray]) -> BoolArray:
    flat: BoolArray = np.abs(values["d_sum_M_d_alpha"]) <= _FLAT * np.abs(
        values["d_M_gear_d_alpha"]
    )
    return flat


def _all_roots(balance: _Balance, slip: float) -> tuple[_Found, BoolArray]:
    """Every equilibrium in the range, some aircraft at a time to bound the memory."""
    parts = []
    for start in range(0, balance.force.size, _CHUNK):
        chunk = slice(start, start + _CHUNK)
        some = _Balance(balance.model, balance.p[:, chunk], balance.force[chunk])
        found, singular = _roots(some, slip)
        parts.append((found.case + start, found.v, found.r, singular))
    case, v, r, singular = (np.concatenate(part) for part in zip(*parts, strict=True))
    return _Found(case, v, r), singular


def _roots(balance: _Balance, slip: float) -> tuple[_Found, BoolArray]:
    """Every equilibrium in the range, and which aircraft have a balance that is constant."""
    grid = np.linspace(-slip, slip, _SAMPLES)
    values = balance.at(grid[:, None])
    singular: BoolArray = np.all(_is_flat(values), axis=0)
    M, slope = values["sum_M"], values["d_sum_M_d_alpha"]
    side = np.sign(M)
    node, node_case = np.nonzero((side == 0) & ~singular)
    cell, case = np.nonzero((side[:-1] * side[1:] < 0) & ~singular)
    low, high = grid[cell], grid[cell + 1]
    near_low, near_high, near_case = _near_extrema(balance, grid, side, np.sign(slope))
    low, high = np.concatenate([low, near_low]), np.concatenate([high, near_high])
    case = np.concatenate([case, near_case])
    alpha = np.concatenate([grid[node], _bisected(balance.moment, low, high, case)])
    case = np.concatenate([node_case, case])
    turn = balance.at(alpha, case)
    return _Found(case, turn["v"], turn["r"]), singular


def _near_extrema(
    balance: _Balance, grid: FloatArray, side: FloatArray, slope: FloatArray
) -> tuple[FloatArray, FloatArray, npt.NDArray[np.intp]]:
    """Brackets of pairs of equilibria between neighbouring samples, from the signs at these.

    Between two samples of one sign the balance may dip through zero and return: then it has an
    extremum there, of the other sign.
    """
    dips = (side[:-1] * side[1:] > 0) & (side[:-1] * slope[:-1] < 0) & (side[1:] * slope[1:] > 0)
    cell, case = np.nonzero(dips)
    low, high = grid[cell], grid[cell + 1]
    extremum = _bisected(balance.slope, low, high, case)
    through = np.sign(balance.moment(extremum, case)) * side[cell, case] <= 0
    low, extremum, high = low[through], extremum[through], high[through]
    case = case[through]
    return (
        np.concatenate([low, extremum]),
        np.concatenate([extremum, high]),
        np.concatenate([case, case]),
    )


def _bisected(f: Any, low: FloatArray, high: FloatArray, case: npt.NDArray[np.intp]) -> FloatArray:
    """Zero of f(alpha, case) in each bracket."""
    if low.size == 0:
        return low
    rising = f(low, case) <= 0
    for _ in range(_BISECTIONS):
        middle = (low + high) / 2
        below = (f(middle, case) <= 0) == rising
        low, high = np.where(below, middle, low), np.where(below, high, middle)
    return (low + high) / 2


def _polished(balance: _Balance, found: _Found) -> _Found:
    """Newton steps in v and r with the exact Jacobian; a step that does not help is not taken."""
    if found.case.size == 0:
        return found
    x, u, p = _columns(balance, found)
    dynamic = _dynamic(balance.model)
    (rates,) = columns(as_model(balance.model).function("rhs"), x, u, p)
    for _ in range(_POLISH):
        A = _state_matrices(balance.model, x, u, p)
        if not np.isfinite(A).all():
            raise beyond("the equilibrium")
        step = np.linalg.pinv(A) @ rates[:, dynamic]
        trial = x.copy()
        trial[dynamic] -= step[:, :, 0].T
        (after,) = columns(as_model(balance.model).function("rhs"), trial, u, p)
        better = np.abs(after[:, dynamic]).sum((1, 2)) < np.abs(rates[:, dynamic]).sum((1, 2))
        x = np.where(better, trial, x)
        rates = np.where(better[:, None, None], after, rates)
    v, r = x[dynamic] + 0.0  # no negative zeros
    return _Found(found.case, v, r)


def _dynamic(model: ModelLike) -> list[int]:
    names = as_model(model)
    return [names.states.index(s) for s in names.dynamic]


def _columns(balance: _Balance, found: _Found) -> tuple[FloatArray, FloatArray, FloatArray]:
    x = np.zeros((len(as_model(balance.model).states), found.case.size))
    x[_dynamic(balance.model)] = found.v, found.r
    return x, balance.force[None, found.case], balance.p[:, found.case]


def _state_matrices(model: ModelLike, x: FloatArray, u: FloatArray, p: FloatArray) -> FloatArray:
    dynamic = _dynamic(model)
    return columns(as_model(model).function("jacobians"), x, u, p)[0][:, dynamic][:, :, dynamic]


def _gathered(
    balance: _Balance, found: _Found
) -> tuple[dict[str, FloatArray], BoolArray, FloatArray, npt.NDArray[np.int64]]:
    """Equilibria as arrays, one row per aircraft, in order of the slip angle."""
    names = as_model(balance.model)
    cases = balance.force.size
    count = np.bincount(found.case, minlength=cases)
    columns_of = {name: np.empty(0) for name in ("v", "r", *names.outputs, "decay_rate")}
    if found.case.size:
        x, u, p = _columns(balance, found)
        outputs = columns(as_model(balance.model).function("outputs"), x, u, p)[0][:, :, 0].T
        modes = modes_of(_state_matrices(balance.model, x, u, p))
        columns_of = {"v": found.v, "r": found.r, **dict(zip(names.outputs, outputs, strict=True))}
        columns_of["decay_rate"] = modes.decay_rate
    order = np.lexsort([columns_of["alpha"], found.case])
    case = found.case[order]
    branch = np.arange(case.size) - np.searchsorted(case, case)
    values = {}
    for name, column in columns_of.items():
        values[name] = np.full((cases, int(count.max(initial=0))), np.nan)
        values[name][case, branch] = column[order]
    decay_rate = values.pop("decay_rate")
    return values, decay_rate > 0, decay_rate, count
