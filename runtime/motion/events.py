"""What is looked for along a trajectory: extremes, limits, ranges, and the events of a model."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from groundroll.base.arrays import positive
from groundroll.base.errors import GroundrollError, unknown
from groundroll.model.models import Model
from groundroll.model.names import listed

from .lanes import WATCHES, Watch


@dataclass(frozen=True)
class Lookout:
    """What is looked for; the watches are in the order of the attributes.

    Attributes
    ----------
    extremes : tuple of str
        States and outputs whose largest magnitude is wanted, those with limits among them.
    limits, within : dict of float
        Magnitudes whose first passing is wanted, and beyond which a trajectory ends.
    events : tuple of str
        Events of the model whose first time is wanted.
    until : tuple of str
        Those of them that end a trajectory.
    """

    extremes: tuple[str, ...] = ()
    limits: Mapping[str, float] = ()  # type: ignore[assignment]
    within: Mapping[str, float] = ()  # type: ignore[assignment]
    events: tuple[str, ...] = ()
    until: tuple[str, ...] = ()

    def watches(self, model: Model) -> tuple[Watch, ...]:
        """For the kernels."""
        limits, within = dict(self.limits), dict(self.within)
        known = {event.name: event for event in model.events}
        passing = [known[name] for name in self.events]
        return (
            *(Watch(s, limit=np.array([limits.get(s, np.inf)])) for s in self.extremes),
            *(Watch(s, limit=np.array([most]), ends=True) for s, most in within.items()),
            *(
                Watch(e.output, 1 if e.rising else -1, np.zeros(1), e.name in self.until)
                for e in passing
            ),
        )

    @property
    def first_event(self) -> int:
        """Index of the watch of the first event."""
        return len(self.extremes) + len(self.within)


def lookout(
    model: Model,
    extremes: Iterable[str] = (),
    limits: Mapping[str, float | str] | None = None,
    within: Mapping[str, float | str] | None = None,
    events: str | Iterable[str] = (),
    until: str | Iterable[str] = (),
) -> Lookout:
    """What a call asks to be looked for, by symbol.

    Raises
    ------
    GroundrollError
        For unknown names, limits that are not positive, or too much at once.
    """
    allowed = (*model.states, *model.outputs)

    def bounds(kind: str, given: Mapping[str, float | str] | None) -> dict[str, float]:
        if given is None:
            return {}
        if not isinstance(given, Mapping):
            raise GroundrollError(f"{kind} must be a mapping of names to numbers, not {given!r}")
        each = {model.symbol(name, "name", allowed, kind): (name, v) for name, v in given.items()}
        return {
            s: positive(f"{kind}[{name!r}]", value, model.quantities[s].unit)
            for s, (name, value) in each.items()
        }

    firsts, ranges = bounds("limits", limits), bounds("within", within)
    every = [model.symbol(n, "name", allowed, "extremes") for n in listed("extremes", extremes)]
    ends = named_events(model, "until", until)
    found = Lookout(
        extremes=tuple(dict.fromkeys([*every, *firsts, *ranges])),
        limits=firsts,
        within=ranges,
        events=tuple(dict.fromkeys([*named_events(model, "events", events), *ends])),
        until=ends,
    )
    count = len(found.watches(model))
    if count > WATCHES:
        raise GroundrollError(f"{WATCHES} extremes, limits and events at a time, not {count}")
    return found


def named_events(model: Model, kind: str, names: str | Iterable[str]) -> tuple[str, ...]:
    """Names of events of a model, one or several."""
    known = [event.name for event in model.events]
    given = [names] if isinstance(names, str) else listed(kind, names)
    for name in given:
        if not known:
            raise GroundrollError(f"the model {model.name} has no events, so none called {name!r}")
        if name not in known:
            raise unknown("event", name, known, kind)
    return tuple(given)
