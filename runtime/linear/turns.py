"""Every steady turn of a model that reduces it to one equation, and the proof that it is every.

The range of the slip angle is divided until in each part the balance of moments provably has no
zero, or provably a slope that does not change sign. Bounds of balance and slope over a part come
from interval arithmetic that allows for rounding (R. E. Moore, "Methods and Applications of
Interval Analysis", 1979), so nothing rests on how finely the range is sampled.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import numpy as np
import numpy.typing as npt

from groundroll.base.arrays import FloatArray
from groundroll.base.errors import beyond
from groundroll.base.memory import room
from groundroll.generated import Pack
from groundroll.generated.compiler import NoCompilerError
from groundroll.generated.kernels import load
from groundroll.generated.library import say_slower
from groundroll.model.evaluate import elementwise
from groundroll.model.models import Model

from .points import run

BoolArray = npt.NDArray[np.bool_]
IntArray = npt.NDArray[np.int64]

#: Parts that the range is divided into at first, and how often each is halved at most: what is
#: narrower than that is one point for whatever the answer is used for.
_PARTS, _HALVINGS = 4, 40
#: Parts of one aircraft at a time beyond which its balance is too flat to be told from zero.
_MOST = 512
#: Newton steps towards a zero that is alone in its part, each halving it at least.
_STEPS = 60
#: A balance with less than this fraction of the main gear's slope does not depend on the angle.
_FLAT = 1e-12


@dataclass(frozen=True)
class Balance:
    """The balance of moments of some aircraft over the slip angle of the main tires.

    Attributes
    ----------
    model : Model
    given : mapping of str to ndarray, each of shape (N,) or (1,)
        Inputs and parameters by symbol.
    count : int
        N
    """

    model: Model
    given: Mapping[str, FloatArray]
    count: int

    def at(self, alpha: FloatArray, case: IntArray) -> dict[str, FloatArray]:
        """The generated equilibrium function at slip angles of the aircraft `case`."""
        arguments = {s: x[case] if x.size > 1 else x for s, x in self.given.items()}
        function = self.model.function("equilibrium")
        found = elementwise(function, {**arguments, "alpha": alpha})
        return {name: _finite(values) for name, values in found.items()}


@dataclass(frozen=True)
class Turns:
    """Steady turns in a list.

    Attributes
    ----------
    case : int ndarray, shape (n,)
        Whose each is.
    alpha, v, r : ndarray, shape (n,)
        Slip angle of the main tires, rad, lateral velocity, m/s, and yaw rate, rad/s.
    singular : bool ndarray
        For every aircraft whether its balance does not depend on the slip angle.
    """

    case: IntArray
    alpha: FloatArray
    v: FloatArray
    r: FloatArray
    singular: BoolArray


def every_turn(balance: Balance, slip: float) -> Turns:
    """Every steady turn up to a slip angle, rad; the only one, anywhere, if that is infinite."""
    everyone = np.arange(balance.count)
    if np.isinf(slip):  # the balance is a straight line
        line = balance.at(np.zeros(1), everyone)
        singular = np.broadcast_to(_is_flat(line), balance.count)
        case = np.flatnonzero(~singular)
        line = {s: np.broadcast_to(x, balance.count)[case] for s, x in line.items()}
        alpha = -line["sum_M"] / line["d_sum_M_d_alpha"]
    else:
        # analytic in the angle, so flat everywhere if it is so at a few
        some = [balance.at(np.array([x * slip]), everyone) for x in (-0.7, 0.0, 0.9)]
        singular = np.all([np.broadcast_to(_is_flat(x), balance.count) for x in some], axis=0)
        case, alpha = _zeros(balance, np.flatnonzero(~singular), slip)
    order = np.lexsort([alpha, case])
    case, alpha = case[order], alpha[order]
    turn = balance.at(alpha, case) if case.size else {"v": alpha, "r": alpha}
    return Turns(case, alpha, turn["v"], turn["r"], singular)


def _is_flat(values: Mapping[str, FloatArray]) -> BoolArray:
    flat: BoolArray = np.abs(values["d_sum_M_d_alpha"]) <= _FLAT * np.abs(
        values["d_M_gear_d_alpha"]
    )
    return flat


# --- Division of the range --------------------------------------------------------------------


@dataclass(frozen=True)
class _Parts:
    """Parts of the range: whose, from where to where, and the balance at both ends.

    `off_low` and `off_high` are how far rounding may have put it from there.
    """

    case: IntArray
    low: FloatArray
    high: FloatArray
    at_low: FloatArray
    at_high: FloatArray
    off_low: FloatArray
    off_high: FloatArray

    def __getitem__(self, which: Any) -> _Parts:
        return _Parts(*(each[which] for each in vars(self).values()))


def _zeros(balance: Balance, cases: IntArray, slip: float) -> tuple[IntArray, FloatArray]:
    """Aircraft and slip angle of every zero."""
    edges = np.linspace(-slip, slip, _PARTS + 1)
    case, at = np.repeat(cases, edges.size), np.tile(edges, cases.size)
    M, off = (x.reshape(-1, edges.size) for x in _moment(balance, at, case))
    found = _Parts(
        np.repeat(cases, _PARTS),
        np.tile(edges[:-1], cases.size),
        np.tile(edges[1:], cases.size),
        M[:, :-1].ravel(),
        M[:, 1:].ravel(),
        off[:, :-1].ravel(),
        off[:, 1:].ravel(),
    )
    simple, touching = [], []
    for _ in range(_HALVINGS):
        slope = _bounds(balance, found.low, found.high, found.case, *_RESULTS[2:])
        steady = (slope[0] > 0) | (slope[1] < 0)
        # a part owns its lower end, so that a zero between two parts counts once
        passes = (np.sign(found.at_low) != np.sign(found.at_high)) & (found.at_high != 0)
        passes |= found.at_low == 0
        simple.append(found[steady & passes])
        found = found[~steady & ~_has_none(found, *slope)]
        crowded = np.bincount(found.case, minlength=balance.count)[found.case] > _MOST
        touching.append(found[crowded])
        found = found[~crowded]
        if not found.case.size:
            break
        found = _halved(balance, found)
    touching.append(found)
    end = _last_ends(balance, cases, slip)
    sure = [_polished(balance, _joined(simple)), end]
    case, at = (np.concatenate(each) for each in zip(*sure, strict=True))
    return _with_folds(balance, case, at, *_touched(_joined(touching)))


def _last_ends(balance: Balance, cases: IntArray, slip: float) -> tuple[IntArray, FloatArray]:
    """A zero at the very end of the range, which no part owns."""
    at = np.full(cases.size, slip)
    M, _ = _moment(balance, at, cases)
    return cases[M == 0], at[M == 0]


def _joined(parts: Sequence[_Parts]) -> _Parts:
    columns = zip(*(vars(part).values() for part in parts), strict=True)
    return _Parts(*(np.concatenate(each) for each in columns))


def _halved(balance: Balance, parts: _Parts) -> _Parts:
    middle = (parts.low + parts.high) / 2
    M, off = _moment(balance, middle, parts.case)
    first = replace(parts, high=middle, at_high=M, off_high=off)
    second = replace(parts, low=middle, at_low=M, off_low=off)
    return _joined([first, second])


def _has_none(parts: _Parts, least: FloatArray, most: FloatArray) -> BoolArray:
    """Where the balance, from its values at the ends and bounds of its slope, has no zero.

    Two lines, one from each end, bound it; where they meet it may come closest to zero.
    """
    width, none = parts.high - parts.low, np.zeros(parts.low.shape, bool)
    for sign, steepest in ((1.0, least), (-1.0, most)):
        low, high = sign * parts.at_low, sign * parts.at_high
        down, up = sign * steepest, sign * (most if sign > 0 else least)
        with np.errstate(invalid="ignore", divide="ignore"):
            # low + down t = high - up (width - t)
            t = np.clip((high - up * width - low) / (down - up), 0.0, width)
            closest = np.minimum(low + down * t, high - up * (width - t))
        none |= closest > 2 * np.maximum(parts.off_low, parts.off_high)
    return none


def _touched(parts: _Parts) -> tuple[IntArray, FloatArray]:
    """One zero for each run of neighbouring parts in which none can be excluded: a fold."""
    order = np.lexsort([parts.low, parts.case])
    sorted_ = parts[order]
    joined = (sorted_.case[1:] == sorted_.case[:-1]) & (sorted_.low[1:] <= sorted_.high[:-1])
    begins = np.flatnonzero(np.concatenate([[True], ~joined])[: sorted_.case.size])
    ends = np.append(begins[1:], sorted_.case.size) - 1 if begins.size else begins
    return sorted_.case[begins], (sorted_.low[begins] + sorted_.high[ends]) / 2


def _with_folds(
    balance: Balance, case: IntArray, at: FloatArray, fold: IntArray, at_fold: FloatArray
) -> tuple[IntArray, FloatArray]:
    """All zeros, without folds between which and the zero beside them all is zero but for rounding.

    Each run of those counts once.
    """
    if not fold.size:
        return case, at
    every, place = np.concatenate([case, fold]), np.concatenate([at, at_fold])
    order = np.lexsort([place, every])
    every, place = every[order], place[order]
    sure = (np.arange(every.size) < case.size)[order]
    M, off = _moment(balance, (place[1:] + place[:-1]) / 2, every[1:])
    same = (every[1:] == every[:-1]) & (np.abs(M) <= 2 * off)
    after, before = np.append(False, same), np.append(same & sure[1:], False)
    kept = sure | ~(after | before)
    return every[kept], place[kept]


def _polished(balance: Balance, parts: _Parts) -> tuple[IntArray, FloatArray]:
    """The zero of each part: Newton steps that stay within it, and halve it where they do not."""
    case, low, high = parts.case, parts.low.copy(), parts.high.copy()
    at = np.where(parts.at_low == 0, low, (low + high) / 2)
    rising = parts.at_high > 0
    rising |= (parts.at_high == 0) & (parts.at_low < 0)
    open_ = np.flatnonzero(parts.at_low != 0)
    for _ in range(_STEPS):
        if not open_.size:
            break
        x = at[open_]
        M, slope = _moment(balance, x, case[open_])[0], _slope(balance, x, case[open_])
        below = (M < 0) == rising[open_]
        low[open_] = np.where(below, x, low[open_])
        high[open_] = np.where(below, high[open_], x)
        with np.errstate(divide="ignore", invalid="ignore"):
            next_ = x - M / slope
        inside = (next_ > low[open_]) & (next_ < high[open_])
        next_ = np.where(inside, next_, (low[open_] + high[open_]) / 2)
        at[open_] = np.where(M == 0, x, next_)
        done = np.abs(at[open_] - x) <= 4e-16 * np.abs(x) + 1e-300
        open_ = open_[~done]
    return case, at


# --- Bounds -----------------------------------------------------------------------------------

#: Results of the generated function ``bounds``, in its order.
_RESULTS = ("sum_M_low", "sum_M_high", "d_sum_M_d_alpha_low", "d_sum_M_d_alpha_high")


def _bounds(
    balance: Balance, low: FloatArray, high: FloatArray, case: IntArray, *names: str
) -> list[FloatArray]:
    """Bounds of results over intervals of the slip angle, of the aircraft `case`."""
    if not case.size:
        return [low for _ in names]
    model = balance.model
    arguments = {s: x[case] if x.size > 1 else x for s, x in balance.given.items()}
    try:
        kernel = _kernel(model)
    except NoCompilerError as problem:
        say_slower(problem)
        every = {"low": low, "high": high, **arguments}
        found = elementwise(model.expression("bounds"), every)
        return [found[name] for name in names]
    order = _arguments(model)
    given = [low, high, *(np.ascontiguousarray(arguments[s]).reshape(-1) for s in order)]
    results = room(*[(case.size,)] * len(names))
    elements = [np.array([_RESULTS.index(name)], np.int32) for name in names]
    run(kernel, case.size, given, list(zip(results, elements, strict=True)))
    return results


def _moment(balance: Balance, alpha: FloatArray, case: IntArray) -> tuple[FloatArray, FloatArray]:
    """The balance at slip angles, and how far rounding may have put it from there."""
    low, high = _bounds(balance, alpha, alpha, case, *_RESULTS[:2])
    return _finite((low + high) / 2), (high - low) / 2


def _slope(balance: Balance, alpha: FloatArray, case: IntArray) -> FloatArray:
    """Its slope."""
    low, high = _bounds(balance, alpha, alpha, case, *_RESULTS[2:])
    return _finite((low + high) / 2)


def _finite(values: FloatArray) -> FloatArray:
    if not np.isfinite(values).all():
        raise beyond("the balance of moments")
    return values


@cache
def _kernel(model: Pack) -> Any:
    return load(model.sources / "bounds.c", model.digest, "points").points


@cache
def _arguments(model: Model) -> tuple[str, ...]:
    return tuple(model.expression("bounds").name_in()[2:])
