"""Equilibria of any model: states and inputs at which chosen rates vanish, by Newton's method.

All starts of all cases step side by side, with exact Jacobians. A step is no longer than the
quantities are wide, and is halved until the rates become smaller, so that what starts in the basin
of an equilibrium gets there.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
import numpy.typing as npt

from groundroll.base.arrays import FloatArray
from groundroll.base.errors import GroundrollError
from groundroll.base.listing import unit_of

from .points import Points

BoolArray = npt.NDArray[np.bool_]

#: By unit how much of a quantity matters: steps and starts are measured in it.
_WIDTH = {"m/s": 1.0, "rad/s": 0.1, "rad": 0.05, "m": 0.02, "1": 0.2, "N": 500.0}
#: Starts are up to so many widths from the first, steps up to so many long.
_FAR, _LONGEST = 8.0, 4.0
#: Power with which starts that creep crowd near zero.
_SMALL = 9
_STEPS, _SHORTEST = 80, 1e-4
#: Rates relative to what the widths of the unknowns make of them: there, and not to be had better.
_THERE, _ROUNDING = 1e-9, 1e-15
#: Equilibria closer than this, in widths, are one; what is smaller than that is zero.
_SAME, _NOTHING = 1e-5, 1e-12
_SEED = 20_111


@dataclass(frozen=True)
class Question:
    """What is sought.

    Attributes
    ----------
    points : Points
        One point for each case, with the unknowns where the search begins.
    unknown : tuple of str
        States and inputs.
    vanish : tuple of str
        As many states, whose rates are to vanish.
    ranges : mapping of str to tuple of float
        Between what an unknown may be.
    widths : mapping of str to float
        How much of an unknown matters, where that is not by its unit.
    """

    points: Points
    unknown: tuple[str, ...]
    vanish: tuple[str, ...]
    ranges: Mapping[str, tuple[float, float]]
    widths: Mapping[str, float] = field(default_factory=dict)


@dataclass(frozen=True)
class Answer:
    """Equilibria.

    Attributes
    ----------
    values : ndarray, shape (cases, branches, unknowns)
        In order of the first unknown; NaN where a case has fewer than another.
    reason : callable
        Of a case: why it has no other.
    """

    values: FloatArray
    reason: Callable[[int], str]


def solve(question: Question, starts: int) -> Answer:
    """Every equilibrium within the ranges that Newton's method finds from so many starts."""
    cases, k = question.points.count, len(question.unknown)
    if k == 0:
        raise GroundrollError("nothing is left to be found: every state is given")
    begin = _starts(question, starts)
    found, left = _newton(question, begin.reshape(-1, k), starts)
    found = np.where(np.abs(found) < _NOTHING * widths_of(question), 0.0, _turned(question, found))
    found, left = found.reshape(cases, starts, k), left.reshape(cases, starts)
    solved = left <= _THERE
    low, high = np.array([question.ranges.get(s, (-np.inf, np.inf)) for s in question.unknown]).T
    within = solved & ((found >= low) & (found <= high)).all(axis=-1)
    new = _first_of_each(found / widths_of(question), within)
    count = int(new.sum(axis=1).max(initial=0))
    values = np.where(new[..., None], found, np.nan)
    order = np.argsort(np.where(new, found[..., 0], np.inf), axis=1, kind="stable")
    values = np.take_along_axis(values, order[..., None], axis=1)[:, :count]

    def reason(case: int) -> str:
        return _why(question, found[case], solved[case] & ~within[case], left[case])

    return Answer(values, reason)


def widths_of(question: Question) -> FloatArray:
    """How much of each unknown matters."""
    q = question.points.model.quantities
    usual = {s: _WIDTH.get(q[s].unit, 1.0) for s in question.unknown}
    return np.array([question.widths.get(s, width) for s, width in usual.items()])


def _turned(question: Question, found: FloatArray) -> FloatArray:
    """The same with a heading within half a turn to either side."""
    heading = question.points.model.roles.get("heading")
    if heading in question.unknown:
        k = question.unknown.index(heading)
        found[:, k] -= 2 * np.pi * np.round(found[:, k] / (2 * np.pi))
    return found


def _starts(question: Question, starts: int) -> FloatArray:
    """Where the search begins, shape (cases, starts, unknowns): the first as given."""
    points, widths = question.points, widths_of(question)
    first = np.stack(
        [np.broadcast_to(points.values[s], points.shape).reshape(-1) for s in question.unknown], -1
    )
    rng = np.random.default_rng(_SEED)
    away = rng.uniform(-_FAR, _FAR, (starts, widths.size))
    # what creeps may do so at any small speed
    away = (away * (np.abs(away) / _FAR) ** (_SMALL if question.widths else 0)) * widths
    away[0] = 0.0
    places = first[:, None, :] + away
    for k, s in enumerate(question.unknown):
        low, high = question.ranges.get(s, (-np.inf, np.inf))
        if np.isfinite([low, high]).all() and s not in question.widths:
            places[:, 1:, k] = rng.uniform(low, high, starts - 1)
        places[..., k] = np.clip(places[..., k], low, high)
    return places


def _newton(question: Question, at: FloatArray, starts: int) -> tuple[FloatArray, FloatArray]:
    """Where the steps end, shape (n, unknowns), and what is left of the rates there, (n,)."""
    at, widths = at.copy(), widths_of(question)
    system = _System(question, starts)
    everyone = np.arange(len(at))
    rates, slopes = system(at, everyone)
    scale = np.abs(slopes * widths).max(axis=-1, initial=0.0) + 1e-300
    left = _size(rates / scale)
    step, _ = _step(rates, slopes, scale, widths)
    length = np.ones(len(at))  # first steps are whole ones, and shortened like the others
    open_ = np.flatnonzero(np.isfinite(left) & (left > 0))
    for _ in range(_STEPS):
        if not open_.size:
            break
        trial = at[open_] - length[open_, None] * step[open_] * widths
        rates, slopes = system(trial, open_)
        size = _size(rates / scale[open_])
        better = size < left[open_]
        taken, kept = open_[better], open_[~better]
        at[taken], left[taken] = trial[better], size[better]
        step[taken], length[taken] = _step(rates[better], slopes[better], scale[taken], widths)
        length[kept] /= 4
        done = np.where(better, size <= _ROUNDING, length[open_] < _SHORTEST)
        open_ = open_[~done]
    return at, np.where(np.isfinite(left), left, np.inf)


def _size(rates: FloatArray) -> FloatArray:
    return np.asarray(np.sqrt((rates**2).sum(axis=-1)))


def _step(
    rates: FloatArray, slopes: FloatArray, scale: FloatArray, widths: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Newton's steps in widths, and how much of them to take."""
    J, r = slopes * widths / scale[..., None], (rates / scale)[..., None]
    bad = np.asarray(~(np.isfinite(J).all(axis=(-2, -1)) & np.isfinite(r[..., 0]).all(axis=-1)))
    J, r = np.where(bad[:, None, None], np.eye(J.shape[-1]), J), np.where(bad[:, None, None], 0, r)
    with np.errstate(all="ignore"):
        try:
            step = np.linalg.solve(J, r)[..., 0]
        except np.linalg.LinAlgError:
            step = np.full(rates.shape, np.nan)
        wild = np.asarray(~(np.abs(step) < 1e6).all(axis=-1))
    if wild.any():  # something that does not matter, or not here
        step[wild] = (np.linalg.pinv(J[wild], rcond=1e-9) @ r[wild])[..., 0]
    longest = np.abs(step).max(axis=-1, initial=0.0)
    return np.asarray(step), np.asarray(np.minimum(1.0, _LONGEST / np.maximum(longest, 1e-300)))


class _System:
    """Rates that are to vanish and their derivatives by the unknowns."""

    def __init__(self, question: Question, starts: int) -> None:
        self.points, self.unknown, self.starts = question.points, question.unknown, starts
        model = self.points.model
        self.over = tuple(s for s in model.states if s in {*question.vanish, *question.unknown})
        self.rows = [self.over.index(s) for s in question.vanish]
        inputs = len(self.over)
        self.columns = [
            self.over.index(s) if s in model.states else inputs + model.inputs.index(s)
            for s in question.unknown
        ]
        self.given = dict(zip(self.points.values, self.points.columns, strict=True))

    def __call__(self, at: FloatArray, which: Any) -> tuple[FloatArray, FloatArray]:
        case = which // self.starts
        values = {s: x[case] if x.size > 1 else x[0] for s, x in self.given.items()}
        values |= dict(zip(self.unknown, np.ascontiguousarray(at.T), strict=True))
        values = {s: np.asarray(x) for s, x in values.items()}
        points = replace(self.points, values=values, shape=(len(at),))
        found = points.evaluate("f", "fx", "fu", over=self.over)
        slopes = np.concatenate([found["fx"], found["fu"]], axis=-1)
        return found["f"][:, self.rows], slopes[:, self.rows][:, :, self.columns]


def _first_of_each(found: FloatArray, valid: BoolArray) -> BoolArray:
    """Which of the points of each case are not near an earlier one; distances in widths."""
    new = valid.copy()
    for k in range(1, found.shape[1]):
        for j in range(k):
            near = np.abs(found[:, k] - found[:, j]).max(axis=-1) <= _SAME * (
                1 + np.abs(found[:, j]).max(axis=-1)
            )
            new[:, k] &= ~(new[:, j] & near)
    return new


def _why(question: Question, found: FloatArray, solved: BoolArray, left: FloatArray) -> str:
    """Why a case has no equilibrium: what would have to be beyond its range, or what stays."""
    q = question.points.model.quantities
    if solved.any():
        low, high = np.array(
            [question.ranges.get(s, (-np.inf, np.inf)) for s in question.unknown]
        ).T
        some = found[solved]
        beyond = np.maximum(low - some, some - high) / widths_of(question)
        nearest = np.maximum(beyond, 0.0).sum(axis=1).argmin()
        parts = [
            f"{q[s].name} would have to be"
            f" {f'{some[nearest, k]:.4g} {unit_of(q[s])}'.rstrip()}, beyond its range from"
            f" {low[k]:.4g} to {high[k]:.4g}"
            for k, s in enumerate(question.unknown)
            if beyond[nearest, k] > 0
        ]
        slides = "friction does not hold it: " if question.widths else ""
        return slides + "; ".join(parts)
    names = ", ".join(q[s].name for s in question.unknown)
    return (
        f"no {names} was found for which all rates vanish, from {len(left)} starts; the least that"
        f" was left of them is {left.min():.1e} of what the unknowns can do"
    )
