"""What is exported: one model with the numbers of one aircraft."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from importlib.metadata import version
from typing import Any

from groundroll.aircraft.aircraft import Aircraft
from groundroll.aircraft.parameters import parameters_of
from groundroll.aircraft.values import given
from groundroll.base.arrays import FloatArray
from groundroll.base.errors import GroundrollError
from groundroll.generated import Quantity
from groundroll.model.models import Model, ModelLike, as_model
from groundroll.motion.rest import start_of


@dataclass(frozen=True)
class Subject:
    """A model with numbers.

    Attributes
    ----------
    model : Model
    aircraft : Aircraft
    start, inputs, parameters : mapping of str to float
        By symbol, in the order of the model; SI units with radians.
    """

    model: Model
    aircraft: Aircraft
    start: Mapping[str, float]
    inputs: Mapping[str, float]
    parameters: Mapping[str, float]

    @property
    def title(self) -> str:
        """The aircraft for people."""
        return self.aircraft.title or self.aircraft.name

    @property
    def origin(self) -> str:
        """What it was made with."""
        return f"Made by groundroll {version('groundroll')}, equations {self.model.digest}."

    def quantities(self, symbols: Mapping[str, float] | tuple[str, ...]) -> list[Quantity]:
        """What symbols of the model stand for."""
        return [self.model.quantities[s] for s in symbols]


def subject(plane: Aircraft, model: ModelLike, values: Mapping[str, Any], where: str) -> Subject:
    """A model with the numbers of an aircraft, and with values that differ from it.

    Raises
    ------
    GroundrollError
        If a name is unknown, a value cannot be or is an array, or a parameter is missing.
    """
    known = as_model(model)
    sorted_out = given(plane, known, values, where)
    inputs = {s: sorted_out.inputs.get(s, 0.0) for s in known.inputs}
    start = start_of(sorted_out.aircraft, known, sorted_out.states)
    parameters = parameters_of(sorted_out.aircraft, known)
    return Subject(
        known,
        sorted_out.aircraft,
        *(_single(known, group, where) for group in (start, inputs, parameters)),
    )


def _single(model: Model, values: Mapping[str, FloatArray | float], where: str) -> dict[str, float]:
    """Values that must each be one number."""
    for s, value in values.items():
        if getattr(value, "ndim", 0):
            raise GroundrollError(
                f"{where} takes one aircraft, but {model.quantities[s].name} ({s}) is an array of"
                f" {value.size}"  # type: ignore[union-attr]
            )
    return {s: float(value) for s, value in values.items()}
