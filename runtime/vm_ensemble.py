"""Ensembles without a C compiler: the generated integrator in CasADi's virtual machine.

It gives the same numbers to better than `tol`, hundreds of times slower. Extremes are sought on a
grid of 200 intervals, with a parabola through the three points about each peak.
"""

from __future__ import annotations

import casadi as ca
import numpy as np
import numpy.typing as npt

from .arrays import FloatArray
from .generated import Pack
from .generated.kernels import STATUS, Outcome, Task

_OK, _NOT_FINITE, _LEFT = (STATUS.index(s) for s in ("ok", "not finite", "left the range"))
_INTERVALS = 200


def integrate_in_vm(task: Task) -> Outcome:
    """Integrate every trajectory of a task; steps and estimates are not known."""
    model = task.kernel.pack
    x0 = np.zeros((len(model.states), task.count))
    for name, value in zip(task.kernel.states, task.x0, strict=True):
        x0[model.states.index(name)] = value
    given = np.stack([np.broadcast_to(value, task.count) for value in task.p])
    u, p = np.split(given, [len(model.inputs)])
    grid = _grid(task)
    x = _states(model, grid, x0, u, p)
    rows = _rows(task, grid, x, u, p)
    status = np.where(np.isfinite(x).all(axis=(0, 2)), _OK, _NOT_FINITE)
    for name, most in task.within.items():
        end = _first(grid, np.abs(rows[name]), most)
        status = np.where((status == _OK) & np.isfinite(end), _LEFT, status)
        _end(rows, grid, end)
    at = np.searchsorted(grid, task.times)
    ended = status != _OK
    return Outcome(
        status=status.astype(np.int8),
        steps=np.zeros(task.count, np.int32),
        estimate=np.full(task.count, np.nan),
        final={
            s: np.where(ended, np.nan, x[model.states.index(s), :, -1]) for s in task.kernel.states
        },
        samples={s: rows[s][:, at] for s in task.sampled},
        largest={s: _peaks(np.abs(rows[s])) for s in task.watched},
        first={s: _first(grid, np.abs(rows[s]), task.limits.get(s, np.inf)) for s in task.watched},
    )


def _grid(task: Task) -> FloatArray:
    ends = np.linspace(0.0, task.t, _INTERVALS + 1) if task.watched else np.array([0.0, task.t])
    return np.union1d(ends, task.times)


def _states(
    model: Pack, grid: FloatArray, x0: FloatArray, u: FloatArray, p: FloatArray
) -> FloatArray:
    """States at the times of a grid, shape (states, n, times); NaN from where a run breaks."""
    advance = model.build(f"{model.name}_rk45")
    path = [x0]
    for h in np.diff(grid).tolist():
        path.append(_advance(advance, path[-1], u, p, h))
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
    model = task.kernel.pack
    rows = {s: x[k].copy() for k, s in enumerate(model.states)}
    if not {*task.sampled, *task.watched} <= rows.keys():
        outputs = model.build(f"{model.name}_outputs").map(task.count * grid.size)
        flat = x.reshape(len(x), -1)
        y = np.array(outputs(flat, *(np.repeat(each, grid.size, axis=1) for each in (u, p))))
        rows |= {s: y[k].reshape(task.count, grid.size) for k, s in enumerate(model.outputs)}
    return rows


def _peaks(size: FloatArray) -> FloatArray:
    """Largest value of each row, by the parabola about its largest sample."""
    size = np.nan_to_num(size, nan=0.0)
    k = np.clip(size.argmax(axis=1), 1, size.shape[1] - 2)
    each = np.arange(len(size))
    left, middle, right = (size[each, k + step] for step in (-1, 0, 1))
    bend = left - 2 * middle + right
    with np.errstate(divide="ignore", invalid="ignore"):
        top = middle - (left - right) ** 2 / (8 * bend)
    inside = (bend < 0) & (middle >= left) & (middle >= right)
    return np.asarray(np.where(inside, top, size.max(axis=1)))


def _first(grid: FloatArray, size: FloatArray, limit: float) -> FloatArray:
    """First time at which each row reaches a limit, on the line between two samples."""
    over = size >= limit
    k = over.argmax(axis=1)
    each = np.arange(len(size))
    before, after = size[each, np.maximum(k - 1, 0)], size[each, k]
    with np.errstate(divide="ignore", invalid="ignore"):
        share = np.where(k > 0, (limit - before) / (after - before), 1.0)
    time = grid[np.maximum(k - 1, 0)] + share * (grid[k] - grid[np.maximum(k - 1, 0)])
    return np.where(over.any(axis=1), time, np.inf)


def _end(rows: dict[str, FloatArray], grid: FloatArray, when: FloatArray) -> None:
    """Nothing is known after a trajectory has ended."""
    after: npt.NDArray[np.bool_] = grid > when[:, None]
    for values in rows.values():
        values[after] = np.nan
