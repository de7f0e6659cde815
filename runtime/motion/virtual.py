"""Trajectories without a C compiler: the generated integrator in CasADi's virtual machine.

It gives the same numbers to better than `tol`, hundreds of times slower. Extremes and events are
sought on a grid of 200 intervals, with a parabola through the three points about each peak.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from itertools import pairwise

import casadi as ca
import numpy as np

from groundroll.base.arrays import FloatArray

from .lanes import STATUS, Outcome, Task, Watch

_OK, _NOT_FINITE = (STATUS.index(s) for s in ("ok", "not finite"))
_INTERVALS = 200
#: Longest step under inputs that vary, s; where in it they are sampled, from its beginning to its
#: end, and of which means of the two samples its halves are held at.
_STEP = 0.005
_POINTS = 0.5 + np.array([-1.0, 1.0]) / math.sqrt(12.0)
_MEANS = 0.5 + np.array([[1.0, -1.0], [-1.0, 1.0]]) / math.sqrt(3.0)


def integrate_in_vm(task: Task) -> Outcome:
    """Integrate every trajectory of a task; steps and estimates are not known."""
    model, n = task.model, task.count
    x0, u, p = (
        _stacked(symbols, values, n)
        for symbols, values in (
            (model.states, task.x0),
            (model.inputs, task.inputs),
            (model.parameters, task.parameters),
        )
    )
    grid = _grid(task)
    x = _states(task, grid, x0, u, p)
    rows = _rows(task, grid, x, u, p)
    end, cause = np.full(n, task.t), np.full(n, -1, np.int8)
    for k, watch in enumerate(task.watches):
        first = _first(grid, _watched(watch, rows), watch.limit)
        if watch.ends:
            cause = np.where(first < end, k, cause).astype(np.int8)
            end = np.minimum(first, end)
    final = {s: _at(grid, rows[s], end) for s in task.final}
    for row in rows.values():
        row[grid > end[:, None]] = np.nan
    broken = ~np.isfinite(x).all(axis=(0, 2)) & (cause < 0)
    values = [_watched(watch, rows) for watch in task.watches]
    limits = [watch.limit for watch in task.watches]
    firsts = [_first(grid, *each) for each in zip(values, limits, strict=True)]
    for k, first in enumerate(firsts):  # the end of a trajectory lies between two samples
        first[cause == k] = end[cause == k]
    largest = [
        np.where(np.isfinite(first), np.fmax(_peaks(value), limit), _peaks(value))
        for first, value, limit in zip(firsts, values, limits, strict=True)
    ]
    at = np.searchsorted(grid, task.times)
    return Outcome(
        status=np.where(broken, _NOT_FINITE, _OK).astype(np.int8),
        steps=np.zeros(n, np.int32),
        estimate=np.full(n, np.nan),
        end=end,
        cause=cause,
        final={s: np.where(broken, np.nan, value) for s, value in final.items()},
        samples={s: rows[s][:, at] for s in task.sampled},
        largest=np.array(largest).reshape(-1, n),
        first=np.array(firsts).reshape(-1, n),
    )


def _stacked(symbols: tuple[str, ...], values: Mapping[str, FloatArray], n: int) -> FloatArray:
    rows = [np.broadcast_to(values.get(s, np.zeros(1)), n) for s in symbols]
    return np.array(rows).reshape(len(symbols), n)


def _watched(watch: Watch, rows: dict[str, FloatArray]) -> FloatArray:
    return watch.sign * rows[watch.row] if watch.sign else np.abs(rows[watch.row])


def _grid(task: Task) -> FloatArray:
    """Times at which states are wanted, and where an input jumps."""
    ends = np.linspace(0.0, task.t, _INTERVALS + 1) if task.watches else np.array([0.0, task.t])
    starts = [pieces.start.ravel() for pieces in task.signals.values()]
    breaks = [each[(each > 0) & (each < task.t)] for each in starts]
    return np.unique(np.concatenate([ends, task.times, *breaks]))


def _inputs(task: Task, constant: FloatArray, t: FloatArray) -> FloatArray:
    """Inputs at times, shape (inputs, n, times)."""
    u = np.repeat(constant[:, :, None], t.size, axis=2)
    for s, pieces in task.signals.items():
        u[task.model.inputs.index(s)] = pieces.at(t)
    return u


def _at(grid: FloatArray, row: FloatArray, when: FloatArray) -> FloatArray:
    """A row at a time for each trajectory, on the line between two samples."""
    k = np.clip(np.searchsorted(grid, when), 1, grid.size - 1)
    each = np.arange(when.size)
    share = (when - grid[k - 1]) / (grid[k] - grid[k - 1])
    return row[each, k - 1] + share * (row[each, k] - row[each, k - 1])


def _states(
    task: Task, grid: FloatArray, x0: FloatArray, constant: FloatArray, p: FloatArray
) -> FloatArray:
    """States at the times of a grid, shape (states, n, times); NaN from where a run breaks.

    The compiled integrators hold their input over an interval. Where inputs vary, a step is two
    such intervals whose held inputs are means of two samples, so chosen that the result is of
    fourth order in the step for every input that enters the equations linearly, as forces do (a
    commutator-free Magnus method: Blanes and Moan, Appl. Numer. Math. 56, 2006, 1519).
    """
    advance = task.model.build(f"{task.model.name}_rk45")
    path = [x0]
    for begin, end in pairwise(grid.tolist()):
        x = path[-1]
        steps = math.ceil((end - begin) / _STEP - 1e-9) if task.signals else 1
        for a, b in pairwise(np.linspace(begin, end, steps + 1).tolist()):
            if not task.signals:
                x = _advance(advance, x, constant, p, b - a)
                continue
            inside = np.clip(a + (b - a) * _POINTS, a, np.nextafter(b, a))
            for u in np.moveaxis(_inputs(task, constant, inside) @ _MEANS, -1, 0):
                x = _advance(advance, x, u, p, (b - a) / 2)
        path.append(x)
    return np.stack(path, axis=2)


def _advance(f: ca.Function, x: FloatArray, u: FloatArray, p: FloatArray, h: float) -> FloatArray:
    """One interval; a batch in which a run fails is halved until that run is alone."""
    count = x.shape[1]
    if count == 1 and not np.isfinite(np.concatenate([x, u, p])).all():
        return np.full_like(x, np.nan)
    try:
        return np.array(f.map(count)(x, u, p, h), dtype=np.float64)
    except RuntimeError:
        if count == 1:
            return np.full_like(x, np.nan)
    half = count // 2
    parts = [
        _advance(f, x[:, part], u[:, part], p[:, part], h)
        for part in (slice(0, half), slice(half, None))
    ]
    return np.concatenate(parts, axis=1)


def _rows(
    task: Task, grid: FloatArray, x: FloatArray, u: FloatArray, p: FloatArray
) -> dict[str, FloatArray]:
    """Whatever is sampled or watched over the grid, each of shape (n, times)."""
    model = task.model
    rows = {s: x[k].copy() for k, s in enumerate(model.states)}
    if task.observed:
        outputs = model.build(f"{model.name}_outputs").map(task.count * grid.size)
        inputs = _inputs(task, u, grid).reshape(len(u), -1)
        y = np.array(outputs(x.reshape(len(x), -1), inputs, np.repeat(p, grid.size, axis=1)))
        rows |= {s: y[k].reshape(task.count, grid.size) for k, s in enumerate(model.outputs)}
    return rows


def _peaks(size: FloatArray) -> FloatArray:
    """Largest value of each row, by the parabola about its largest sample."""
    size = np.nan_to_num(size, nan=-np.inf)
    k = np.clip(size.argmax(axis=1), 1, size.shape[1] - 2)
    each = np.arange(len(size))
    left, middle, right = (size[each, k + step] for step in (-1, 0, 1))
    bend = left - 2 * middle + right
    with np.errstate(divide="ignore", invalid="ignore"):
        top = middle - (left - right) ** 2 / (8 * bend)
    inside = (bend < 0) & (middle >= left) & (middle >= right)
    return np.asarray(np.where(inside, top, size.max(axis=1)))


def _first(grid: FloatArray, size: FloatArray, limit: FloatArray) -> FloatArray:
    """First time at which each row reaches a limit, on the line between two samples."""
    bound = np.broadcast_to(limit, len(size))
    over = size >= bound[:, None]
    k = over.argmax(axis=1)
    each = np.arange(len(size))
    before, after = size[each, np.maximum(k - 1, 0)], size[each, k]
    with np.errstate(divide="ignore", invalid="ignore"):
        share = np.where(k > 0, (bound - before) / (after - before), 1.0)
    time = grid[np.maximum(k - 1, 0)] + share * (grid[k] - grid[np.maximum(k - 1, 0)])
    return np.where(over.any(axis=1), time, np.inf)
