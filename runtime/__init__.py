"""Ground stability of light aircraft, from derived equations to compiled integrators.

>>> import groundroll as gr
>>> plane = gr.Aircraft.load("brott")
>>> run = gr.simulate(plane, model="nonlinear", v0=0.1, t=5.0)
>>> lin = gr.linearize(plane, model="linear")

SI units and radians throughout; SAE body axes: x forward, y right, z down.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from . import gusts
    from .aircraft import Aircraft
    from .basins import Basin, basin
    from .checking import Check, check
    from .ensemble_result import Ensemble
    from .ensembles import ensemble
    from .errors import GroundrollError
    from .exchange import explore, export
    from .integration import integrator
    from .kicks import Survival, survival
    from .linearization import Linearization, linearize
    from .maps import StabilityMap, stability_map
    from .metrics import Metrics
    from .motion import signals
    from .operating_point import OperatingPoint
    from .placement import Envelope, InfeasibleError, Limits, Placement, place_gear
    from .response import (
        FrequencyResponse,
        RootLocus,
        StepResponse,
        frequency_response,
        root_locus,
        step_response,
    )
    from .response_plot import pole_map
    from .results import Result
    from .runway import animate, runway_view
    from .sensitivities import Sensitivities
    from .simulation import Trajectory, simulate
    from .solvers import solver
    from .stability import (
        GearEnvelope,
        GearLimit,
        Margins,
        SpeedWindow,
        gear_envelope,
        gear_limit,
        margins,
        speed_window,
    )
    from .sweeps import Sweep, sweep
    from .tire_data import TireData
    from .tire_fit import fit_tire
    from .trimming import Trim, trim

    __version__: str

#: Public name -> module; imported on first use, so that `import groundroll` is cheap.
_HOME = {
    "Aircraft": "aircraft",
    "Basin": "basins",
    "Check": "checking",
    "Ensemble": "ensemble_result",
    "Envelope": "placement",
    "FrequencyResponse": "response",
    "GearEnvelope": "stability",
    "GearLimit": "stability",
    "GroundrollError": "errors",
    "InfeasibleError": "placement",
    "Limits": "placement",
    "Linearization": "linearization",
    "Margins": "stability",
    "Metrics": "metrics",
    "OperatingPoint": "operating_point",
    "Placement": "placement",
    "Result": "results",
    "RootLocus": "response",
    "Sensitivities": "sensitivities",
    "SpeedWindow": "stability",
    "StabilityMap": "maps",
    "StepResponse": "response",
    "Survival": "kicks",
    "Sweep": "sweeps",
    "TireData": "tire_data",
    "Trajectory": "simulation",
    "Trim": "trimming",
    "animate": "runway",
    "basin": "basins",
    "check": "checking",
    "ensemble": "ensembles",
    "explore": "exchange",
    "export": "exchange",
    "fit_tire": "tire_fit",
    "frequency_response": "response",
    "gear_envelope": "stability",
    "gear_limit": "stability",
    "integrator": "integration",
    "linearize": "linearization",
    "margins": "stability",
    "place_gear": "placement",
    "pole_map": "response_plot",
    "root_locus": "response",
    "runway_view": "runway",
    "simulate": "simulation",
    "solver": "solvers",
    "speed_window": "stability",
    "stability_map": "maps",
    "step_response": "response",
    "survival": "kicks",
    "sweep": "sweeps",
    "trim": "trimming",
}

#: Public modules, imported on first use too -> where they are.
_MODULES = {"gusts": "gusts", "signals": "motion.signals"}

__all__ = [
    "Aircraft",
    "Basin",
    "Check",
    "Ensemble",
    "Envelope",
    "FrequencyResponse",
    "GearEnvelope",
    "GearLimit",
    "GroundrollError",
    "InfeasibleError",
    "Limits",
    "Linearization",
    "Margins",
    "Metrics",
    "OperatingPoint",
    "Placement",
    "Result",
    "RootLocus",
    "Sensitivities",
    "SpeedWindow",
    "StabilityMap",
    "StepResponse",
    "Survival",
    "Sweep",
    "TireData",
    "Trajectory",
    "Trim",
    "animate",
    "basin",
    "check",
    "ensemble",
    "explore",
    "export",
    "fit_tire",
    "frequency_response",
    "gear_envelope",
    "gear_limit",
    "gusts",
    "integrator",
    "linearize",
    "margins",
    "place_gear",
    "pole_map",
    "root_locus",
    "runway_view",
    "signals",
    "simulate",
    "solver",
    "speed_window",
    "stability_map",
    "step_response",
    "survival",
    "sweep",
    "trim",
]


def __getattr__(name: str) -> Any:
    if name == "__version__":
        from importlib.metadata import version

        return version(__name__)
    if name in _MODULES:
        return importlib.import_module(f".{_MODULES[name]}", __name__)
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(f".{_HOME[name]}", __name__), name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
