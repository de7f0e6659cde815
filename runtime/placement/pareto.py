"""What a margin costs: the front of the worst-case margin against something else."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from groundroll.base.arrays import FloatArray
from groundroll.base.errors import GroundrollError, one_of
from groundroll.base.listing import Pictured
from groundroll.base.progress import Count, Progress, counted

from .assess import assess, worst_displacement
from .case import Case
from .conflict import solve
from .limits import KINDS, SHOWN, Bound
from .problem import Problem
from .search import exchange
from .starts import begin

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: What a margin can be weighed against, and a value of it that nobody reaches.
AGAINST = {
    "displacement": ("at most", 1e-3),
    "nose_over": ("at least", np.radians(89.0)),
    "tip_back": ("at least", np.radians(89.0)),
    "tail_wheel_load": ("at most", -1.0),
    "nose_wheel_load": ("at most", -1.0),
    "wheelbase": ("at most", 0.0),
}


@dataclass(frozen=True, repr=False)
class Front(Pictured):
    """Placements of which none is better in both respects.

    Attributes
    ----------
    case : Case
        The problem; its objective is the margin.
    against : str
        What the margin is weighed against: its worst value over the envelope counts too.
    margin, other : ndarray
        SI units, one value for each placement, from the best margin on.
    designs : tuple of dict
        The placements, by symbol.
    """

    case: Case
    against: str
    margin: FloatArray
    other: FloatArray
    designs: tuple[Mapping[str, float], ...]

    @property
    def stations(self) -> FloatArray:
        """Stations of the main gear behind the datum, m."""
        return np.array([design["x_main"] for design in self.designs])

    def plot(self) -> Figure:
        """Margin against the other, with the stations beside the points."""
        from .figures import front_figure

        return front_figure(self)

    def __repr__(self) -> str:
        kind = KINDS[self.against]
        factor, digits = SHOWN[kind.shown]
        lines = [
            f"Front of {self.case.objective} against {self.against}, {self.case.plane.name!r}",
            f"  main gear (mm)  {self.case.objective}  {self.against} ({kind.shown})",
        ]
        rows = zip(self.stations, self.margin, self.other, strict=True)
        lines += [f"  {1e3 * x:14.1f}  {m:10.4f}  {o * factor:14.{digits}f}" for x, m, o in rows]
        return "\n".join(lines)


def front(case: Case, against: str, points: int = 13, progress: Progress = None) -> Front:
    """The front of a margin against something else.

    From the placement with the best margin to the one that is best in the other respect; between
    them the best margin for each value of the other.

    Parameters
    ----------
    case : Case
        The problem. Its margin is the damping ratio if that is its objective, else the decay
        rate.
    against : str
        One of `AGAINST`; the case's own bound on it, on the better side, is left out.
    points : int
        How many placements.
    progress : callable or bool, optional
        Called with the number of placements done and in all; True draws a bar on a terminal.

    Raises
    ------
    GroundrollError
        If the other means nothing for the layout, or no placement satisfies the limits.
    """
    one_of("Pareto axis", against, AGAINST, "pareto")
    if case.layout not in KINDS[against].layouts:
        raise GroundrollError(f"pareto: {against} means nothing for a {case.layout}")
    if KINDS[against].symbol in ("nose_over", "tip_back") and not np.isfinite(case.numbers["h_cg"]):
        raise GroundrollError(f"pareto: {against} needs cg_height (h_cg) of the aircraft")
    if points < 2:
        raise GroundrollError(f"pareto: a front has at least 2 points, not {points}")
    with counted(progress, "placements", points) as done:
        return _front(case, against, points, done)


def _front(case: Case, against: str, points: int, done: Count) -> Front:
    side, unreached = AGAINST[against]
    objective = case.objective if case.objective == "damping_ratio" else "decay_rate"
    bounds = tuple(b for b in case.bounds if (b.limit, b.side) != (against, side))
    margin_case = replace(case, objective=objective, bounds=bounds)
    best = solve(Problem(margin_case)).solution
    design = case.design(best.chosen)
    swept = replace(margin_case, bounds=(*bounds, Bound(against, side, unreached)))
    problem = Problem(swept)
    start = _other(problem, design)
    end = _extreme(swept)
    done.add()
    designs, margins, others, known = [design], [best.level], [start], None
    if swept.bounds[-1].sign * (end - start) < 1e-3 * swept.bounds[-1].kind.step:
        points = 1  # the best margin is the best in the other respect too
    for value in np.linspace(start, end, points)[1:]:
        values = np.append(problem.bounds[:-1], value)
        # from the neighbour, and from elsewhere in case it has become the worse of two optima
        starts = [designs[-1], *begin(swept)[:1]]
        found = exchange(problem, starts, bounds=values, known=known)
        if found.solution.ok:
            known = found.corners
            designs.append(case.design(found.solution.chosen))
            margins.append(found.solution.level)
            others.append(_other(problem, designs[-1]))
        done.add()
    return Front(margin_case, against, np.array(margins), np.array(others), tuple(designs))


def _other(problem: Problem, design: Mapping[str, float]) -> float:
    """The worst value of the other over the envelope."""
    bound = problem.case.bounds[-1]
    if bound.limit == "displacement":
        return worst_displacement(problem, design).value
    standings = {s.bound: s for s in assess(problem, design).standings}
    return standings[bound].worst.value


def _extreme(case: Case) -> float:
    """The best value of the other that the limits allow: how far its bound must give way."""
    bare = replace(case, objective="smallest_change")
    problem = Problem(bare)
    giving = [k == len(bare.bounds) - 1 for k in range(len(bare.bounds))]
    solution = exchange(problem, begin(bare), elastic=True, giving=giving).solution
    last = case.bounds[-1]
    if not solution.ok:
        raise GroundrollError(f"pareto: the best {last.limit} within the limits was not found")
    # a hair inside, where the sweep has room to move
    step = 1e-6 * last.kind.step
    return float(last.value - last.sign * (solution.slack[-1] + step))
