"""The one way from results to what is built upon them: their classes and their pictures.

Every room imports only rooms before its own. What is named here comes later, and is imported when
it is asked for.
"""

from __future__ import annotations

import importlib
from typing import Any

from groundroll.base.errors import one_of

#: Kind of a record -> class of the result that it holds.
KINDS = {
    "trajectory": "runs.simulation.Trajectory",
    "linearization": "linear.linearization.Linearization",
    "trim": "linear.trim_result.Trim",
    "branches": "linear.branching.Branches",
    "sweep": "stability.sweeps.Sweep",
    "map": "stability.maps.StabilityMap",
    "ensemble": "runs.ensemble_result.Ensemble",
    "survival": "fates.kicks.Survival",
    "basin": "fates.basins.Basin",
    "crosswind": "control.crosswind.CrosswindLimit",
    "pilot": "control.pilot.PilotLimit",
}
#: Picture of a result -> function that draws it.
PICTURES = {
    "history": "view.plots.time_history",
    "map": "view.maps.draw",
    "bode": "view.responses.bode",
    "step": "view.responses.step",
    "locus": "view.responses.locus",
    "branches": "view.branches.diagram",
}


def kind(name: str) -> Any:
    """The class of a kind of result."""
    return _found(KINDS[one_of("kind of result", name, KINDS)])


def drawn(picture: str, *arguments: Any, **options: Any) -> Any:
    """What the function of a picture returns."""
    return _found(PICTURES[picture])(*arguments, **options)


def _found(place: str) -> Any:
    module, _, name = place.rpartition(".")
    return getattr(importlib.import_module(f"groundroll.{module}"), name)
