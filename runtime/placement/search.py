"""The worst points of an envelope, and the exchange of corners until none is worse.

The envelope is a continuum and a program has a finite number of constraints. So: solve over a few
corners, look for violated points on a dense grid of the whole envelope, sharpen the worst of them
between the grid points, add them to the corners, solve again. It ends when nothing is violated.
Violated or not is asked of the polynomials of the program, which are smooth where eigenvalues meet.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from groundroll.base.arrays import FloatArray
from groundroll.base.errors import GroundrollError

from .envelope import Axis, corners, grid, product
from .problem import Problem
from .program import LEVELS, Program, Solution

#: A residual below this is a violation; residuals are scaled to the order of 1.
_VIOLATED = -1e-8
#: Grid values below this are sharpened: the least value lies between grid points.
_NEAR = 0.05
_ROUNDS = 25
#: Points of the dense check: of closed forms, and of simulated runs.
BUDGET = 15_000
PATH_BUDGET = 400

Points = Mapping[str, FloatArray]
#: From points of an envelope to rows of values, one column for each point.
Rows = Callable[[Points], FloatArray]


@dataclass(frozen=True)
class Found:
    """The end of an exchange.

    Attributes
    ----------
    solution : Solution
        The last one.
    corners : mapping of str to ndarray
        The corners that it was solved over.
    rounds : int
        How often it was solved.
    """

    solution: Solution
    corners: Points
    rounds: int


def least(
    rows: Rows, axes: Mapping[str, Axis], budget: int, near: float = np.inf
) -> Iterator[tuple[float, dict[str, float]]]:
    """The least value of each row over an envelope and where it is.

    Parameters
    ----------
    rows : callable
        From points to rows.
    axes : mapping of str to Axis
        The envelope.
    budget : int
        Points of the dense grid.
    near : float
        Rows that stay above this on the grid are left out.
    """
    points = grid(axes, budget)
    for index, row in enumerate(rows(points)):
        k = int(np.nanargmin(row)) if np.isfinite(row).any() else 0
        if row[k] <= near:
            start = {s: float(values[k]) for s, values in points.items()}
            yield _sharpen(rows, index, axes, points, start)


def _sharpen(
    rows: Rows, index: int, axes: Mapping[str, Axis], points: Points, at: dict[str, float]
) -> tuple[float, dict[str, float]]:
    """The least value of a row near a grid point, by halving steps around the best so far."""
    steps = {
        s: axis.high - axis.low
        if np.unique(points[s]).size < 3
        else np.diff(np.unique(points[s]))[0]
        for s, axis in axes.items()
        if axis.is_range
    }
    best = float(rows({s: np.array([x]) for s, x in at.items()})[index, 0])
    if not steps:
        return best, at
    # small enough for the error, which is of second order, to vanish beside the tolerance
    for _ in range(16):
        around = {s: np.array([x]) for s, x in at.items()}
        for s, step in steps.items():
            three = at[s] + step * np.array([-0.5, 0.0, 0.5])
            around[s] = np.unique(np.clip(three, axes[s].low, axes[s].high))
        local = product(around)
        row = rows(local)[index]
        k = int(np.nanargmin(row)) if np.isfinite(row).any() else 0
        if row[k] <= best:
            best, at = float(row[k]), {s: float(values[k]) for s, values in local.items()}
        steps = {s: step / 2 for s, step in steps.items()}
    return best, at


def exchange(
    problem: Problem,
    starts: Sequence[Mapping[str, float]],
    *,
    elastic: bool = False,
    bounds: FloatArray | None = None,
    giving: Sequence[bool] | None = None,
    known: Points | None = None,
) -> Found:
    """Solve over a growing set of corners until no point of the envelope is violated.

    Parameters
    ----------
    problem : Problem
        What must hold.
    starts : sequence of mapping
        Designs to start from.
    elastic : bool
        Whether bounds give way.
    bounds : ndarray, optional
        Values of the bounds, if not those of the case.
    giving : sequence of bool, optional
        Which bounds may give way; default all.
    known : mapping of str to ndarray, optional
        Corners to begin with; default the ends of the envelope.

    Returns
    -------
    Found
        Its solution is not ok where no start led to one.
    """
    axes = problem.case.axes
    points = dict(known or corners(axes))
    solution = None
    for round_ in range(1, _ROUNDS + 1):
        program = Program(problem, points, elastic=elastic)
        begin = list(starts)
        if solution is not None:
            # a simulated round is dear, and the last optimum is near
            again = [] if problem.rows[2] is not None else begin
            begin = [problem.case.design(solution.chosen), *again]
        solution = _best(program, begin, bounds, giving)
        if not solution.ok:
            return Found(solution, points, round_)
        worse = list(_violated(problem, solution, bounds))
        if not worse:
            return Found(solution, points, round_)
        points = {s: np.append(values, [at[s] for at in worse]) for s, values in points.items()}
    raise GroundrollError(
        f"the worst points of the envelope still move after {_ROUNDS} rounds; narrow the envelope"
        " or the bounds of the variables"
    )


def _best(
    program: Program,
    starts: Sequence[Mapping[str, float]],
    bounds: FloatArray | None,
    giving: Sequence[bool] | None,
) -> Solution:
    """The best of what the starts lead to."""
    case = program.problem.case
    solutions = []
    for design in starts:
        level = 0.0
        if case.objective == "decay_rate" and not program.elastic:
            level = float(case.values(design, program.corners)["decay_rate"].min())
        elif case.objective == "displacement":
            level = 1.0
        solutions.append(program.solve(design, level, bounds, giving))
    more = LEVELS.get(case.objective, -1.0) if not program.elastic else -1.0
    return max(solutions, key=lambda s: (s.ok, more * s.level))


def _violated(
    problem: Problem, solution: Solution, bounds: FloatArray | None
) -> Iterator[dict[str, float]]:
    """The worst points of the envelope at a solution, if they are violated."""
    design = problem.case.design(solution.chosen)
    signs = np.array([b.sign for b in problem.case.bounds])
    values = (problem.bounds if bounds is None else bounds) - signs * solution.slack

    def closed(points: Points) -> FloatArray:
        return problem.residuals(design, solution.level, values, points)

    def simulated(points: Points) -> FloatArray:
        residuals = problem.residuals(design, solution.level, values, points, path=True)
        least_of_all: FloatArray = residuals.min(axis=0, keepdims=True)
        return least_of_all

    checks = [(closed, BUDGET)]
    if problem.rows[2] is not None:
        checks.append((simulated, PATH_BUDGET))
    for rows, budget in checks:
        for residual, at in least(rows, problem.case.axes, budget, _NEAR):
            problem.callback()
            if residual < _VIOLATED:
                yield at
