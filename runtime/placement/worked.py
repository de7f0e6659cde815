"""The thesis's aircraft, worked: where its wheels should go, and what its simplification hid.

Taildragger and tricycle, with the constant stiffness of the thesis and with loads that follow the
gear. What is asked, and the estimates where the thesis is silent, are in ``worked.toml``.
"""

from __future__ import annotations

import tomllib
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from importlib import resources
from typing import TYPE_CHECKING, Any

import numpy as np

from groundroll.aircraft.aircraft import Aircraft
from groundroll.model.names import PARAMETERS

from .assess import Assessment, assess
from .conflict import InfeasibleError
from .envelope import Envelope
from .limits import LAYOUTS, Limits, show
from .place import place_gear
from .problem import Problem
from .result import Placement

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from .pareto import Front
    from .worked_tables import Table

#: Placements along each front.
_POINTS = 7
#: Layouts with a picture of their own, and the limits that it shows.
_DRAWN = (("taildragger", "textbook"), ("tricycle", "relaxed"))


@dataclass(frozen=True)
class Answer:
    """One question of the study and its answer.

    Attributes
    ----------
    aircraft, layout, stiffness, limits : str
        The question; `limits` is the name of a set in ``worked.toml``.
    placement : Placement or None
        The answer; None if no placement satisfies the limits.
    conflict : str
        Then why.
    """

    aircraft: str
    layout: str
    stiffness: str
    limits: str
    placement: Placement | None
    conflict: str = ""


@dataclass(frozen=True)
class Hidden:
    """A gear placed with one model of the stiffness, judged with the other.

    Attributes
    ----------
    layout, limits : str
        Of the question.
    believed : Placement
        Placed with constant stiffness.
    actual : Assessment
        The same place with loads that follow the gear.
    best : Placement
        Placed with loads that follow.
    """

    layout: str
    limits: str
    believed: Placement
    actual: Assessment
    best: Placement


@dataclass(frozen=True, repr=False)
class WorkedStudy:
    """The whole study.

    Attributes
    ----------
    answers : tuple of Answer
        Every question.
    hidden : tuple of Hidden
        What the constant stiffness hid, for each question that both models answer.
    estimates : dict
        Parameter to its value and source, where the thesis gives none.
    callback : callable
        Called after every step of what is made of it, of which there are `steps`.
    """

    answers: tuple[Answer, ...]
    hidden: tuple[Hidden, ...]
    estimates: Mapping[str, Mapping[str, str]]
    callback: Callable[[], object]

    def placement(self, layout: str, stiffness: str, limits: str) -> Placement:
        """The answer to a question.

        Raises
        ------
        LookupError
            If there is none.
        """
        for answer in self.answers:
            if (answer.layout, answer.stiffness, answer.limits) == (layout, stiffness, limits):
                if answer.placement is None:
                    break
                return answer.placement
        raise LookupError(f"no placement for {layout}, {stiffness}, {limits}")

    @cached_property
    def fronts(self) -> tuple[Front, ...]:
        """Margin against nose-over angle as a taildragger, with both models."""
        models = [a.stiffness for a in self.answers if a.placement and a.layout == "taildragger"]
        best = [self.placement("taildragger", s, "stability") for s in dict.fromkeys(models)]
        return tuple(
            each.pareto("nose_over", _POINTS, lambda done, total: self.callback()) for each in best
        )

    def tables(self) -> tuple[Table, ...]:
        """Where the wheels go, what was hidden, what binds and what it costs."""
        from .worked_tables import tables

        return tables(self)

    def findings(self) -> tuple[str, ...]:
        """What to learn from it, in sentences with the numbers of this run."""
        return tuple(_findings(self))

    def figures(self) -> dict[str, Figure]:
        """Pictures by name."""
        from .worked_figures import fronts_figure, models_figure

        drawn: dict[str, Callable[[], Figure]] = {
            "placement-models": lambda: models_figure(self),
            "placement-pareto": lambda: fronts_figure(self.fronts),
        }
        for layout, limits in _DRAWN:
            drawn[f"placement-{layout}"] = self.placement(layout, "following", limits).plot
        found = {}
        for name, draw in drawn.items():
            found[name] = draw()
            self.callback()
        return found

    def __repr__(self) -> str:
        lines = ["Where should the wheels of the thesis's aircraft go?"]
        for answer in self.answers:
            question = f"  {answer.layout}, {answer.stiffness}, {answer.limits}: "
            if answer.placement is None:
                lines.append(question + "nowhere")
            else:
                found = answer.placement
                lines.append(f"{question}{1e3 * found.station:.1f} mm, {found.value:.3f} 1/s")
        return "\n".join([*lines, *(f"  {finding}" for finding in self.findings())])


def steps() -> int:
    """How many steps the study and its figures take."""
    asked = _asked()
    questions = sum(len(asked[layout]["limits"]) for layout in LAYOUTS)
    return len(asked["models"]) * (questions + _POINTS) + 2 + len(_DRAWN)


def worked_study(callback: Callable[[], object] = lambda: None) -> WorkedStudy:
    """Place the gear of the thesis's aircraft with both models of the stiffness.

    Parameters
    ----------
    callback : callable
        Called after every step; see `steps`.

    Returns
    -------
    WorkedStudy
        With tables, findings and figures for the report; about ten seconds.
    """
    asked = _asked()
    estimates = asked["estimates"]
    answers = []
    for name, stiffness in asked["models"].items():
        plane = Aircraft.load(name)
        given = {PARAMETERS[s].name for s in plane.given}  # what merely follows gives way
        plane = plane.replace(**{k: e["value"] for k, e in estimates.items() if k not in given})
        for layout in LAYOUTS:
            ranges = {**asked["envelope"], **asked[layout].get("envelope", {})}
            ends: dict[str, Any] = {key: tuple(pair) for key, pair in ranges.items()}
            envelope = Envelope(**ends)
            for limits, values in asked[layout]["limits"].items():
                bounds = Limits(**values)
                answers.append(_answer(plane, layout, stiffness, limits, envelope, bounds))
                callback()
    return WorkedStudy(tuple(answers), tuple(_hidden(answers)), estimates, callback)


def _asked() -> dict[str, Any]:
    return tomllib.loads((resources.files(__package__) / "worked.toml").read_text("utf-8"))


def _answer(
    plane: Aircraft, layout: str, stiffness: str, name: str, envelope: Envelope, limits: Limits
) -> Answer:
    question = (plane.name, layout, stiffness, name)
    try:
        found = place_gear(plane, envelope, limits, layout=layout, stiffness=stiffness)
    except InfeasibleError as conflict:
        return Answer(*question, None, _conflict(conflict))
    return Answer(*question, found)


def _conflict(problem: InfeasibleError) -> str:
    """The limits in conflict, and what each alone would have to give."""
    parts = [
        f"{c.bound} (alone it would have to give way by {show(c.alone, c.bound.kind)})"
        if np.isfinite(c.alone)
        else str(c.bound)
        for c in problem.conflicts
    ]
    return " against ".join(parts)


def _hidden(answers: list[Answer]) -> Iterator[Hidden]:
    found = {(a.layout, a.limits, a.stiffness): a.placement for a in answers}
    for (layout, limits, stiffness), believed in found.items():
        best = found.get((layout, limits, "following"))
        if stiffness == "constant" and believed is not None and best is not None:
            actual = assess(Problem(best.case), best.case.design({"x_main": believed.station}))
            yield Hidden(layout, limits, believed, actual, best)


def _findings(study: WorkedStudy) -> Iterator[str]:
    for h in study.hidden:
        loss = h.best.value - h.actual.decay_rate.value
        yield (
            f"As a {h.layout} within {h.limits} limits the constant stiffness puts the main gear"
            f" {_mm(h.believed.station)} behind the datum and promises {h.believed.value:.2f} 1/s;"
            f" with loads that follow the gear that place is worth {h.actual.decay_rate.value:.2f}"
            f" 1/s, and the best is {_mm(h.best.station)} ({h.best.value:.2f} 1/s,"
            f" {loss:.2f} 1/s more)."
        )
    for answer in study.answers:
        if answer.placement is None:
            yield (
                f"As a {answer.layout} with {answer.stiffness} stiffness, {answer.limits} limits"
                f" leave no place: {answer.conflict}."
            )
    for stiffness in ("constant", "following"):
        found = study.placement("taildragger", stiffness, "stability")
        today = found.today
        if today is not None and today.prices:
            price = today.prices[0]
            yield (
                f"Today's gear ({_mm(found.case.today['x_main'])}) has {today.decay_rate.value:.2f}"
                f" 1/s at its worst corner with {stiffness} stiffness; {price.step} further aft"
                f" changes that by {price.gain:+.4f} 1/s."
            )


def _mm(station: float) -> str:
    return f"{np.round(1e3 * station, 1):g} mm".replace("-", "−")
