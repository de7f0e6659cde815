"""Tables of the worked study, as text for people."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from .prices import describe

if TYPE_CHECKING:
    from .result import Placement
    from .worked import Answer, Hidden, WorkedStudy


@dataclass(frozen=True)
class Table:
    """A table for people: title, header and rows of text."""

    title: str
    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


def tables(study: WorkedStudy) -> tuple[Table, ...]:
    """Where the wheels go, what was hidden, what binds and what it costs, and today's gear."""
    answers = map(_answer_row, study.answers)
    return (
        _table("Where the wheels should go", _ANSWER_HEADER, answers),
        _table("What the constant stiffness hid", _HIDDEN_HEADER, map(_hidden_row, study.hidden)),
        _table("What holds the wheels there", _PRICE_HEADER, _price_rows(study)),
        _table("Today's gear", _TODAY_HEADER, _today_rows(study)),
    )


def _table(title: str, header: tuple[str, ...], rows: Iterable[tuple[str, ...]]) -> Table:
    return Table(title, header, tuple(rows))


def _price_rows(study: WorkedStudy) -> Iterator[tuple[str, ...]]:
    for answer in study.answers:
        if answer.placement is None:
            continue
        prices = [*answer.placement.binding, *answer.placement.prices]
        dear = [p for p in prices if p.step.startswith(("1 mm", "1 kg", "1 deg", "1 %"))]
        for p in dear:
            if p.step != "1 kg m^2":
                yield (*_question(answer), p.of, p.step, f"{p.gain:+.5f}")


def _today_rows(study: WorkedStudy) -> Iterator[tuple[str, ...]]:
    for answer in study.answers:
        if answer.placement and answer.placement.today and answer.limits == "textbook":
            today = answer.placement.today
            worst = today.decay_rate
            broken = [str(s.bound) for s in today.standings if s.room < -1e-9]
            yield (
                *_question(answer)[:3],
                f"{1e3 * today.design['x_main']:.1f}",
                f"{worst.value:.3f}",
                describe(worst.corner, ("u", "x_cg", "tau")),
                "; ".join(broken) or "none",
            )


_ANSWER_HEADER = (
    *("layout", "stiffness", "limits", "main gear (mm behind datum)"),
    *("worst decay rate (1/s)", "worst damping ratio", "worst corner", "held by"),
)
_HIDDEN_HEADER = (
    *("layout", "limits", "placed by constant stiffness (mm)", "believed (1/s)"),
    *("with loads that follow (1/s)", "best with loads that follow (mm)", "then (1/s)"),
)
_PRICE_HEADER = ("layout", "stiffness", "limits", "of", "step", "changes the decay rate by (1/s)")
_TODAY_HEADER = (
    *("layout", "stiffness", "limits", "main gear (mm)", "worst decay rate (1/s)"),
    *("worst corner", "limits broken"),
)


def _question(answer: Answer) -> tuple[str, str, str]:
    return answer.layout, answer.stiffness, answer.limits


def _answer_row(answer: Answer) -> tuple[str, ...]:
    found = answer.placement
    if found is None:
        return (*_question(answer), "nowhere", "", "", "", answer.conflict)
    decay = found.assessment.decay_rate
    return (
        *_question(answer),
        f"{1e3 * found.station:.1f}",
        f"{decay.value:.3f}",
        f"{found.assessment.damping_ratio.value:.3f}",
        describe(decay.corner, _ranging(found)),
        "; ".join(p.of for p in found.binding) or "nothing: the best is between the bounds",
    )


def _hidden_row(h: Hidden) -> tuple[str, ...]:
    return (
        h.layout,
        h.limits,
        f"{1e3 * h.believed.station:.1f}",
        f"{h.believed.value:.3f}",
        f"{h.actual.decay_rate.value:.3f}",
        f"{1e3 * h.best.station:.1f}",
        f"{h.best.value:.3f}",
    )


def _ranging(found: Placement) -> list[str]:
    return [s for s, axis in found.case.axes.items() if axis.low != axis.high]
