"""The public face: what is listed here is imported on first use."""

from .aircraft.aircraft import Aircraft as Aircraft
from .base.errors import GroundrollError as GroundrollError
from .control.crosswind import Clause as Clause
from .control.crosswind import CrosswindLimit as CrosswindLimit
from .control.crosswind import crosswind_clause as crosswind_clause
from .control.crosswind import crosswind_limit as crosswind_limit
from .control.pilot import PilotLimit as PilotLimit
from .control.pilot import pilot_limit as pilot_limit
from .exchange import explore as explore
from .exchange import export as export
from .exchange import import_aircraft as import_aircraft
from .fates.basins import Basin as Basin
from .fates.basins import basin as basin
from .fates.kicks import Survival as Survival
from .fates.kicks import survival as survival
from .linear.branching import Branches as Branches
from .linear.branching import branches as branches
from .linear.linearization import Linearization as Linearization
from .linear.linearization import linearize as linearize
from .linear.operating_point import OperatingPoint as OperatingPoint
from .linear.response import (
    FrequencyResponse as FrequencyResponse,
)
from .linear.response import (
    RootLocus as RootLocus,
)
from .linear.response import (
    StepResponse as StepResponse,
)
from .linear.response import (
    frequency_response as frequency_response,
)
from .linear.response import (
    root_locus as root_locus,
)
from .linear.response import (
    step_response as step_response,
)
from .linear.sensitivities import Sensitivities as Sensitivities
from .linear.trim_result import Trim as Trim
from .linear.trimming import trim as trim
from .model.integration import integrator as integrator
from .model.models import Model as Model
from .motion import gusts as gusts
from .motion import signals as signals
from .placement import (
    Envelope as Envelope,
)
from .placement import (
    InfeasibleError as InfeasibleError,
)
from .placement import (
    Limits as Limits,
)
from .placement import (
    Placement as Placement,
)
from .placement import (
    place_gear as place_gear,
)
from .results.results import Result as Result
from .runs.ensemble_result import Ensemble as Ensemble
from .runs.ensembles import ensemble as ensemble
from .runs.metrics import Metrics as Metrics
from .runs.simulation import Trajectory as Trajectory
from .runs.simulation import simulate as simulate
from .runs.solvers import solver as solver
from .stability.checking import Check as Check
from .stability.checking import check as check
from .stability.closed_forms import (
    GearEnvelope as GearEnvelope,
)
from .stability.closed_forms import (
    GearLimit as GearLimit,
)
from .stability.closed_forms import (
    Margins as Margins,
)
from .stability.closed_forms import (
    SpeedWindow as SpeedWindow,
)
from .stability.closed_forms import (
    gear_envelope as gear_envelope,
)
from .stability.closed_forms import (
    gear_limit as gear_limit,
)
from .stability.closed_forms import (
    margins as margins,
)
from .stability.closed_forms import (
    speed_window as speed_window,
)
from .stability.maps import StabilityMap as StabilityMap
from .stability.maps import stability_map as stability_map
from .stability.sweeps import Sweep as Sweep
from .stability.sweeps import sweep as sweep
from .tires.data import TireData as TireData
from .tires.fit import fit_tire as fit_tire
from .view.responses import pole_map as pole_map
from .view.runway import animate as animate
from .view.runway import runway_view as runway_view

__version__: str
