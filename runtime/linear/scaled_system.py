"""The rates whose zeros are branches, in coordinates of one size: see `continuation`."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from groundroll.base.arrays import FloatArray

from .equilibria import Question, widths_of
from .points import Points

#: How wide the range is, in widths of the other coordinates, and the part of it over which the
#: slope by the parameter is taken.
SPAN, _PART = 10.0, 1e-6


def placed(
    points: Points, over: str, unknown: Sequence[str], each: Callable[[FloatArray], Points]
) -> Callable[[FloatArray], Points]:
    """What gives points at values of what is varied: at once, if nothing else follows from it."""
    fixed = {s: x for s, x in points.values.items() if s not in (over, *unknown)}
    if any(np.ndim(x) and (x != x.flat[0]).any() for x in fixed.values()):
        return each
    alone = {s: np.asarray(x.flat[0] if np.ndim(x) else x) for s, x in fixed.items()}

    def place(at: FloatArray) -> Points:
        zero = dict.fromkeys(unknown, np.zeros(()))
        values = {s: {over: at, **zero, **alone}[s] for s in points.values}
        return replace(points, values=values, shape=at.shape)

    return place


class ScaledSystem:
    """The system that is followed, in coordinates that are scaled."""

    def __init__(
        self,
        place: Callable[[FloatArray], Points],
        question: Question,
        moving: tuple[str, ...],
        low: float,
        high: float,
    ) -> None:
        self.place, self.question, self.moving = place, question, moving
        self.low, self.high = low, high
        model = question.points.model
        self.model, self.widths = model, widths_of(question)
        wanted = {*question.vanish, *question.unknown, *moving}
        self.states = tuple(s for s in model.states if s in wanted)
        self.rows = [self.states.index(s) for s in question.vanish]
        self.columns = [
            self.states.index(s) if s in model.states else len(self.states) + model.inputs.index(s)
            for s in question.unknown
        ]
        self.motion = [self.states.index(s) for s in moving]
        self.scale: FloatArray | None = None

    def over(self, share: FloatArray) -> FloatArray:
        """What is varied at a last coordinate."""
        return np.asarray(self.low + (self.high - self.low) * np.asarray(share) / SPAN)

    def __call__(self, z: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        part = _PART * SPAN
        shares = np.clip(z[-1] + np.array([0.0, part, -part]), 0.0, SPAN)
        found = self.points(np.tile(z[:-1], (3, 1)), shares).evaluate(
            "f", "fx", "fu", over=self.states
        )
        rates = found["f"][:, self.rows]
        slopes = np.concatenate([found["fx"][0], found["fu"][0]], axis=-1)[self.rows]
        by_over = (rates[1] - rates[2]) / (shares[1] - shares[2])
        both = np.column_stack([slopes[:, self.columns] * self.widths, by_over])
        if self.scale is None:
            self.scale = np.abs(both).max(axis=1) + 1e-300
        motion = found["fx"][0][np.ix_(self.motion, self.motion)]
        return rates[0] / self.scale, both / self.scale[:, None], motion

    def points(self, scaled: FloatArray, shares: FloatArray) -> Points:
        """Points of the model at coordinates."""
        points = self.place(self.over(shares))
        at = (scaled * self.widths).T
        unknown = dict(zip(self.question.unknown, np.ascontiguousarray(at), strict=True))
        return replace(points, values={**points.values, **unknown})
