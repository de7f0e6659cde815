"""What should have come out: by CasADi's virtual machine, NumPy and small steps."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

import groundroll as gr
from groundroll.aircraft.parameters import parameters_of
from groundroll.model.models import Model, as_model

Array = np.ndarray[Any, Any]
#: Steps that are tried within an interval, until twice as many change nothing.
_STEPS = (4, 8, 16, 32, 64, 128, 256, 512)


@cache
def _expression(model: str, name: str, count: int) -> Any:
    function = as_model(model).expression(name)
    return function.map(count) if count > 1 else function


def evaluated(model: str, name: str, x: Array, u: Array, p: Array) -> Array:
    """First result of a function of a model at points in columns."""
    count = x.shape[1]
    columns = (np.repeat(a, count // a.shape[1], axis=1) for a in (u, p))
    return np.array(
        _expression(model, name, count)(x, *columns)[0]
        if name == "linearized"
        else _expression(model, name, count)(x, *columns)
    )


def points(plane: gr.Aircraft, model: str, shape: tuple[int, ...]) -> Array:
    """Parameters of each run, one in each column."""
    values = parameters_of(plane, as_model(model)).values()
    return np.stack([np.broadcast_to(v, shape).ravel() for v in values])


def trajectory(run: gr.Trajectory, tol: float) -> str | None:
    """Whether every sample follows from the one before it."""
    model = as_model(run.model)
    shape = run[model.states[0]].shape[:-1]
    p = points(run.aircraft, model.name, shape)
    count, most = run.t.size, max(1e-5, 100 * tol)
    for k, index in enumerate(np.ndindex(*shape)):
        x = np.stack([run[s][index] for s in model.states])
        u = np.stack([np.broadcast_to(run[s], (*shape, count))[index] for s in model.inputs])
        if not np.isfinite(x).all():
            if int(run.status[index]) == 0 and int(np.asarray(run.fate)[index]) < 0:
                return f"run {index} is not finite, but ok"
            continue
        h = float(run.t[1] - run.t[0])
        end, off = _followed(model, x[:, :-1], u[:, :-1], p[:, k : k + 1], h, most / 10)
        if off > most / 10:
            return None
        scale = np.abs(x).max(axis=1, keepdims=True) + 1e-3
        gap = np.abs(end - x[:, 1:]) / scale
        if not gap.max() <= most:
            row, when = np.unravel_index(gap.argmax(), gap.shape)
            return f"run {index}: {model.states[row]} off by {gap.max():.2g} at sample {when + 1}"
    return ""


def _followed(
    model: Model, x: Array, u: Array, p: Array, h: float, most: float
) -> tuple[Array, float]:
    """States after h, s, and how far they may be off relative to their size."""
    before, off = _stepped(model, x, u, p, h, _STEPS[0]), np.inf
    for steps in _STEPS[1:]:
        after = _stepped(model, x, u, p, h, steps)
        size = np.abs(x).max(axis=1, keepdims=True) + 1e-3
        off = float(np.nan_to_num(np.abs(after - before) / size, nan=np.inf).max())
        before = after
        if off <= most:
            break
    return before, off


def _stepped(model: Model, x: Array, u: Array, p: Array, h: float, steps: int) -> Array:
    """Runge-Kutta steps over one interval."""

    def rates(x: Array) -> Array:
        return evaluated(model.name, "rhs", x, u, p)

    dt = h / steps
    with np.errstate(all="ignore"):
        for _ in range(steps):
            k1 = rates(x)
            k2 = rates(x + dt / 2 * k1)
            k3 = rates(x + dt / 2 * k2)
            k4 = rates(x + dt * k3)
            x = x + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    return x


def ends(ens: gr.Ensemble) -> str | None:
    """Whether trajectories end where small steps end."""
    model = as_model(ens.model)
    shape = ens.status.shape
    most = max(1e-5, 100 * ens.tol)
    p = points(ens.aircraft, model.name, shape)
    u = np.stack([np.broadcast_to(ens.inputs.get(s, 0.0), shape).ravel() for s in model.inputs])
    begin = np.stack([np.broadcast_to(ens.start[s], shape).ravel() for s in model.states])
    x, off = _followed(model, begin, u, p, ens.t, most / 10)
    if off > most / 10:
        return None
    for s, values in ens.final.items():
        row = model.states.index(s)
        found, expected, ok = values.ravel(), x[row], ens.ok.ravel()
        scale = np.maximum(np.abs(expected), np.abs(begin[row])) + 1e-3
        gap = (np.abs(found - expected) / scale)[ok]
        if gap.size and not gap.max() <= most:
            return f"{s} off by {gap.max():.2g}"
    return ""


def linearization(lin: gr.Linearization, at: dict[str, Any]) -> str:
    """Whether A and B are differences of the rates, and the eigenvalues those of A."""
    model = as_model(lin.model)
    shape = lin.A.shape[:-2]
    p = points(lin.aircraft, model.name, shape)
    point = {model.symbol(n, "name", (*model.states, *model.inputs)): v for n, v in lin.at.items()}
    rows = [model.states.index(s) for s in lin.states]
    for k, index in enumerate(np.ndindex(*shape)):

        def value(s: str, index: tuple[int, ...] = index) -> float:
            return float(np.broadcast_to(np.asarray(point.get(s, 0.0), float), shape)[index])

        x = np.array([[value(s)] for s in model.states])
        u = np.array([[value(s)] for s in model.inputs])
        for matrix, names, base in ((lin.A, lin.states, x), (lin.B, lin.inputs, u)):
            for column, s in enumerate(names):
                found = matrix[index][:, column]
                place = (model.states if base is x else model.inputs).index(s)
                step = 1e-6 * max(1.0, abs(base[place, 0]))
                high, low = base.copy(), base.copy()
                high[place] += step
                low[place] -= step
                f = [
                    evaluated(
                        model.name, "rhs", *((b, u) if base is x else (x, b)), p[:, k : k + 1]
                    )
                    for b in (high, low)
                ]
                slope = ((f[0] - f[1]) / (2 * step))[rows, 0]
                size = max(1.0, float(np.abs(matrix[index]).max()), float(np.abs(f[0]).max()))
                if not np.allclose(found, slope, rtol=2e-4, atol=2e-5 * size):
                    return f"d/d{s}: {found} for {slope}"
        mine = np.sort_complex(np.linalg.eigvals(lin.A[index]))
        if not np.allclose(mine, np.sort_complex(lin.eigenvalues[index]), 1e-5, 1e-5):
            return f"eigenvalues {lin.eigenvalues[index]} for {mine}"
    return ""


def turns(found: gr.Trim) -> str:
    """Whether nothing accelerates at the equilibria, but for the heading and what is held."""
    model = as_model(found.model)
    shape = found.count.shape
    p = points(found.aircraft, model.name, shape)
    still = [model.states.index(s) for s in model.dynamic if s not in (*found.held, "psi")]
    for k, index in enumerate(np.ndindex(*shape)):
        for branch in range(int(found.count[index])):

            def value(s: str, index: tuple[int, ...] = index, branch: int = branch) -> float:
                if s in found.values:
                    return float(found.values[s][index][branch])
                return float(np.broadcast_to(found.given.get(s, 0.0), shape)[index])

            x = np.array([[value(s)] for s in model.states])
            u = np.array([[value(s)] for s in model.inputs])
            rates = evaluated(model.name, "rhs", x, u, p[:, k : k + 1])[still, 0]
            if not np.abs(rates).max() < 1e-6 * (1 + np.abs(x).max()):
                return f"branch {branch} of {index}: rates {rates}"
    return ""


def state_matrices(plane: gr.Aircraft, shape: tuple[int, ...]) -> Array:
    """A of the linear model in straight running, by differences that are exact: it is linear."""
    model = as_model("linear")
    p = points(plane, "linear", shape)
    rows = [model.states.index(s) for s in model.dynamic]
    columns = []
    for s in model.dynamic:
        x = np.zeros((len(model.states), p.shape[1]))
        x[model.states.index(s)] = 1.0
        u = np.zeros((len(model.inputs), p.shape[1]))
        columns.append(evaluated("linear", "rhs", x, u, p)[rows])
    return np.stack(columns, axis=1).transpose(2, 0, 1).reshape(*shape, 2, 2)


def decays(plane: gr.Aircraft, shape: tuple[int, ...]) -> Array:
    """Decay rates of the linear model."""
    return -np.linalg.eigvals(state_matrices(plane, shape)).real.max(axis=-1)
