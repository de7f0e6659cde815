"""The placement problem over a set of corners, solved by IPOPT."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import casadi as ca
import numpy as np

from groundroll.base.arrays import FloatArray
from groundroll.model.evaluate import solved

from .case import DESIGN, vector
from .problem import CORNER, Problem

_IPOPT: Any = {
    "print_time": False,
    "error_on_fail": False,
    "show_eval_warnings": False,
    "ipopt.print_level": 0,
    "ipopt.sb": "yes",
    "ipopt.tol": 1e-10,
    "ipopt.constr_viol_tol": 1e-10,
    "ipopt.acceptable_tol": 1e-8,
    "ipopt.bound_relax_factor": 1e-10,
    "ipopt.max_iter": 300,
}
#: Objective -> whether more of it is better; the rest have no level to raise.
LEVELS = {"decay_rate": 1.0, "damping_ratio": 1.0, "displacement": -1.0}
#: Where a level can be, SI. A damping ratio of 1 is all there is: beyond, no mode oscillates.
_LEVEL_RANGE = {"damping_ratio": (0.0, 1.0), "displacement": (0.0, np.inf)}


@dataclass(frozen=True)
class Solution:
    """What IPOPT found.

    Attributes
    ----------
    ok : bool
        Whether it converged to a point that satisfies everything at the corners given.
    chosen : dict of str to float
        Values of the variables by symbol.
    level : float
        The objective, SI. For ``smallest_change`` the length of the change, m, where the width
        of each variable's bounds counts as much as the main gear's.
    slack : ndarray
        How far each bound gives way, SI; zero unless elastic.
    slopes : dict
        Derivatives of the optimal `level` by what is given: ``"design"``, ``"numbers"``,
        ``"bounds"``, ``"low"`` and ``"high"`` (of the variables) as arrays, ``"corners"`` with
        one row for each axis and one column for each corner.
    """

    ok: bool
    chosen: dict[str, float]
    level: float
    slack: FloatArray
    slopes: Mapping[str, Any]


@dataclass(frozen=True)
class Program:
    """A non-linear program over some corners.

    Parameters
    ----------
    problem : Problem
        What must hold at a corner.
    corners : mapping of str to ndarray
        By symbol, one value for each corner.
    fixed : bool
        Whether the design stays as it is: what is left is the level, and its slopes.
    elastic : bool
        Whether bounds give way: the objective is then the sum of what they give, in steps.
    """

    problem: Problem
    corners: Mapping[str, FloatArray]
    fixed: bool = False
    elastic: bool = False

    @cached_property
    def _columns(self) -> FloatArray:
        return np.stack([self.corners[s] for s in CORNER])

    @cached_property
    def _sizes(self) -> tuple[int, int, int]:
        """How many of x are variables, level and slacks."""
        case = self.problem.case
        return (
            0 if self.fixed else len(case.variables),
            int(case.objective in LEVELS),
            len(case.bounds) if self.elastic else 0,
        )

    @cached_property
    def _solver(self) -> ca.Function:
        """From x = (variables, level, slacks) and p = (design, numbers, bounds, box, corners)."""
        problem, case = self.problem, self.problem.case
        free, leveled, slacks = self._sizes
        box = len(case.variables)
        x = ca.MX.sym("x", free + leveled + slacks)
        z, level, slack = ca.vertsplit(x, np.cumsum([0, free, leveled, slacks]).tolist())
        sizes = [len(DESIGN), len(case.numbers), len(case.bounds), box, box, self._columns.size]
        p = ca.MX.sym("p", sum(sizes))
        design, numbers, bounds, low, high, C = ca.vertsplit(p, np.cumsum([0, *sizes]).tolist())
        C = ca.reshape(C, self._columns.shape)
        parts = ca.vertsplit(design)
        for k in range(free):
            parts[DESIGN.index(case.variables[k].symbol)] = low[k] + z[k] * (high[k] - low[k])
        raised = problem.scale * level if leveled else ca.MX(0)
        gives = ca.DM([b.sign * b.kind.step for b in case.bounds])
        relaxed = bounds - gives * slack if slacks else bounds
        g = self._rows(C, ca.vertcat(*parts), numbers, raised, relaxed)
        if slacks:
            f = ca.sum1(slack)
        elif leveled:
            f = -LEVELS[case.objective] * level
        else:
            f = self._change(z, low, high)
        program: Any = {"x": x, "p": p, "f": f, "g": g}
        return ca.nlpsol("placement", "ipopt", program, _IPOPT)

    def _change(self, z: Any, low: Any, high: Any) -> Any:
        """Square of the change from today, in widths of the box; what is new costs nothing."""
        total = ca.MX(0)
        for k, variable in enumerate(self.problem.case.variables):
            today = self.problem.case.today[variable.symbol]
            if np.isfinite(today):
                total += (z[k] - (today - low[k]) / (high[k] - low[k])) ** 2
        return total

    def _rows(self, C: Any, design: Any, numbers: Any, level: Any, bounds: Any) -> Any:
        """Margins and paths at each corner, the ground for each CG station, and the level."""
        problem, case = self.problem, self.problem.case
        margins, ground, paths = problem.rows
        _, stations = np.unique(self.corners["x_cg"], return_index=True)
        parts = []
        for function, columns in (
            (margins, C),
            (ground, C[:, sorted(stations.tolist())]),
            (paths, C),
        ):
            if function is not None and function.size1_out(0):
                rows = function.map("rows", "serial", columns.shape[1], [0, 2, 3, 4], [])
                parts.append(ca.vec(rows(design, columns, numbers, level, bounds)))
        parts += [
            b.sign * (level - bounds[k]) / problem.scale
            for k, b in enumerate(case.bounds)
            if b.limit == case.objective
        ]
        return ca.vertcat(*parts)

    def solve(
        self,
        design: Mapping[str, float],
        level: float = 0.0,
        bounds: FloatArray | None = None,
        giving: Sequence[bool] | None = None,
    ) -> Solution:
        """Solve from a start.

        Parameters
        ----------
        design : mapping of str to float
            Where to start, or the design if it is fixed.
        level : float
            The objective's level to start from.
        bounds : ndarray, optional
            Values of the bounds, if not those of the case.
        giving : sequence of bool, optional
            Which bounds may give way; default all.
        """
        problem, case = self.problem, self.problem.case
        free, leveled, slacks = self._sizes
        values = problem.bounds if bounds is None else bounds
        low = np.array([v.low for v in case.variables])
        high = np.array([v.high for v in case.variables])
        start = vector(design, tuple(v.symbol for v in case.variables))
        z = np.clip((start - low) / (high - low), 0, 1)[:free]
        most = np.where(giving, np.inf, 0.0) if giving is not None else np.full(slacks, np.inf)
        steps = np.array([b.kind.step for b in case.bounds])
        for k, b in enumerate(case.bounds[:slacks]):
            if b.limit == "damping_ratio":
                most[k] = min(most[k], values[k] / steps[k])
        lowest, highest = _LEVEL_RANGE.get(case.objective, (-np.inf, np.inf))
        p = np.concatenate(
            [vector(design, DESIGN), problem.numbers, values, low, high, self._columns.T.ravel()]
        )
        result = solved(
            self._solver,
            x0=np.concatenate([z, [level / problem.scale] * leveled, np.ones(slacks)]),
            p=p,
            lbx=np.concatenate(
                [np.zeros(free), [lowest / problem.scale] * leveled, np.zeros(slacks)]
            ),
            ubx=np.concatenate([np.ones(free), [highest / problem.scale] * leveled, most]),
            lbg=0.0,
            ubg=np.inf,
        )
        problem.callback()
        x = np.array(result["x"]).ravel()
        chosen = {
            v.symbol: float(np.clip(v.low + x[k] * (v.high - v.low), v.low, v.high))
            for k, v in enumerate(case.variables[:free])
        }
        return Solution(
            ok=bool(self._solver.stats()["success"]) and bool(np.isfinite(x).all()),
            chosen=chosen,
            level=self._level(float(result["f"])),
            slack=x[free + leveled :] * steps if slacks else np.zeros(len(values)),
            slopes=self._slopes(np.array(result["lam_p"]).ravel(), float(result["f"])),
        )

    def _level(self, f: float) -> float:
        """The objective in SI units from that of the program."""
        case = self.problem.case
        if self.elastic:
            return f
        if case.objective in LEVELS:
            return -LEVELS[case.objective] * f * self.problem.scale
        return self.problem.scale * float(np.sqrt(max(f, 0.0)))

    def _slopes(self, multipliers: FloatArray, f: float) -> dict[str, FloatArray]:
        """Derivatives of the level by everything given, from the multipliers of p."""
        case = self.problem.case
        factor = 1.0
        if not self.elastic:
            factor = (
                -LEVELS[case.objective] * self.problem.scale
                if case.objective in LEVELS
                else self.problem.scale / (2 * np.sqrt(f))
                if f > 1e-12
                else 0.0
            )
        box = len(case.variables)
        sizes = [len(DESIGN), len(case.numbers), len(case.bounds), box, box]
        parts = np.split(-multipliers * factor, np.cumsum(sizes))
        names = ("design", "numbers", "bounds", "low", "high")
        slopes = dict(zip(names, parts, strict=False))
        return {**slopes, "corners": parts[5].reshape(self._columns.T.shape).T}
