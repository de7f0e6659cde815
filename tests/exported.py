"""What the tests of exports share: every model with an aircraft, and a motion worth following."""

from __future__ import annotations

from typing import Any, NamedTuple

from own_models import PLANES, own

from groundroll import Aircraft
from groundroll.generated import PACKS
from groundroll.model.models import Model, as_model


class Case(NamedTuple):
    """A model, an aircraft, and how it is disturbed."""

    plane: Aircraft
    model: Model
    values: dict[str, Any]


#: By model: the aircraft, and what disturbs it.
_SHIPPED: dict[str, tuple[str, dict[str, Any]]] = {
    "linear": ("brott", {"v0": 0.5, "disturbance": 30.0}),
    "nonlinear": ("brott", {"v0": "1 m/s", "disturbance": "-40 N"}),
    "rollout": ("cessna-170", {"u0": 20.0, "v0": 0.2, "pedal": 0.1, "brake_left": 0.05}),
    "landing_roll": ("cessna-170", {"u0": 20.0, "v0": 0.1, "wind_y": 2.0}),
    "landing_roll_flown": ("cessna-170", {"v0": 0.3, "wind_y": 1.0}),
}
_SHIPPED = {name: entry for name, entry in _SHIPPED.items() if name in PACKS}
_OWN: dict[str, dict[str, Any]] = {
    "single_track": {"steering": "2 deg"},
    "four_wheels": {"steering": "2 deg", "u0": 30.0, "brake_left": 0.1},
    "lagging": {"v0": 0.3, "push": 100.0},
}
NAMES = (*_SHIPPED, *_OWN)


def case(name: str) -> Case:
    """The case of a model."""
    if name in _OWN:
        return Case(PLANES[name], own(name), _OWN[name])
    plane, values = _SHIPPED[name]
    return Case(Aircraft.load(plane), as_model(name), values)
