"""What must not be negative at a corner of the envelope, as functions from `generated`."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import casadi as ca
import numpy as np

from groundroll.base.arrays import FloatArray
from groundroll.model.integration import integrator
from groundroll.model.models import as_model

from .case import DESIGN, Case, split, symbolic, vector
from .envelope import AXES

CORNER = tuple(AXES.values())
_ARGUMENTS = ("design", "corner", "numbers", "level", "bounds")
#: Samples of the run that the displacement is read off.
_SAMPLES = 10


@dataclass(frozen=True)
class Problem:
    """Functions of a case: residuals that must not be negative, one column for each corner.

    Attributes
    ----------
    case : Case
        The problem in numbers.
    callback : callable
        Called after every step towards its solution: a program solved, an envelope looked over.
    """

    case: Case
    callback: Callable[[], object] = lambda: None

    @cached_property
    def numbers(self) -> FloatArray:
        """The fixed numbers as a vector."""
        return vector(self.case.numbers, tuple(self.case.numbers))

    @cached_property
    def bounds(self) -> FloatArray:
        """The values of the bounds as a vector."""
        return np.array([b.value for b in self.case.bounds], dtype=np.float64)

    @cached_property
    def rate(self) -> float:
        """A typical rate of the case, 1/s, to scale by."""
        ends = [(v.low + v.high) / 2 for v in self.case.variables]
        design = self.case.design(dict(zip(self._free, ends, strict=True)))
        middle = {s: axis.values.mean() for s, axis in self.case.axes.items()}
        values = self.case.values(design, middle)
        return max(abs(float(values["re_2"])), 1e-3)

    @property
    def _free(self) -> tuple[str, ...]:
        return tuple(v.symbol for v in self.case.variables)

    @cached_property
    def scale(self) -> float:
        """The unit of the objective's level inside the solver."""
        main = self.case.variables[0]
        scales = {
            "decay_rate": self.rate,
            "displacement": 0.1,
            "smallest_change": main.high - main.low,
        }
        return scales.get(self.case.objective, 1.0)

    def _arguments(self, kind: type[ca.SX] | type[ca.MX]) -> tuple[Any, Any, Any, Any, Any]:
        sizes = (len(DESIGN), len(CORNER), len(self.case.numbers), 1, len(self.case.bounds))
        parts = [kind.sym(n, size) for n, size in zip(_ARGUMENTS, sizes, strict=True)]
        return parts[0], parts[1], parts[2], parts[3], parts[4]

    @staticmethod
    def _named(name: str, arguments: tuple[Any, ...], rows: list[Any]) -> ca.Function:
        inputs = list(_ARGUMENTS[: len(arguments)])
        return ca.Function(name, list(arguments), [ca.vertcat(*rows)], inputs, ["rows"])

    def _linked(self, design: Any, corner: Any, numbers: Any) -> dict[str, Any]:
        values = {
            **split(numbers, tuple(self.case.numbers)),
            **split(design, DESIGN),
            **split(corner, CORNER),
        }
        return self.case.link(values)

    def _levels(self, limit: str, level: Any, bounds: Any) -> list[Any]:
        """What a quantity must reach: the level to be raised, and its bound."""
        found = [bounds[k] for k, b in enumerate(self.case.bounds) if b.limit == limit]
        # the level, where there is one, is kept beyond the bound by a row of its own
        return [level] if limit == self.case.objective else found

    def margin_rows(self) -> ca.Function:
        """Conditions for the decay rate and the damping ratio."""
        design, corner, numbers, level, bounds = arguments = self._arguments(ca.SX)
        values = self._linked(design, corner, numbers)

        def conditions(d: Any, zeta: Any) -> dict[str, Any]:
            return symbolic("placement_margins", {**values, "d": d, "zeta": zeta})

        rows = []
        for d in self._levels("decay_rate", level, bounds):
            found = conditions(d, 0)
            rows += [-found["trace_d"] / self.rate, found["det_d"] / self.rate**2]
        for zeta in self._levels("damping_ratio", level, bounds):
            rows.append(conditions(0, zeta)["damping"] / self.rate**2)
        return self._named("margins", arguments, rows)

    def ground_rows(self) -> ca.Function:
        """Loads, angles and lengths between their bounds; of the corner only the CG counts."""
        design, corner, numbers, _, bounds = arguments = self._arguments(ca.SX)
        values = self._linked(design, corner, numbers)
        rows = [
            b.sign * (values[b.kind.symbol] - bounds[k]) / b.kind.step
            for k, b in enumerate(self.case.bounds)
            if b.kind.symbol in values
        ]
        return self._named("ground", arguments, rows)

    def path(self) -> ca.Function:
        """Offset across the runway, Y, at the samples of the run: (design, corner, numbers)."""
        design, corner, numbers, *_ = self._arguments(ca.MX)
        parameters = self._parameters()(design, corner, numbers)
        names = as_model(self.case.model)
        times = np.linspace(0, self.case.duration, _SAMPLES + 1)[1:]
        x0 = np.zeros(len(names.states))
        x0[names.states.index("v")] = self.case.v0
        xf = integrator(self.case.model, "rk45", times)(x0, np.zeros(len(names.inputs)), parameters)
        return self._named("path", (design, corner, numbers), [xf[names.states.index("Y"), :].T])

    def _parameters(self) -> ca.Function:
        """The parameter vector of the simulated model."""
        design, corner, numbers, *_ = self._arguments(ca.SX)
        values = self._linked(design, corner, numbers)
        values |= {"B3": values["B3_worn"], "C3": values["C3_worn"]}
        found = [values[s] for s in as_model(self.case.model).parameters]
        return ca.Function("parameters", [design, corner, numbers], [ca.vertcat(*found)])

    def path_rows(self) -> ca.Function | None:
        """The displacement within its level or bound, to both sides; None if nobody asks."""
        design, corner, numbers, level, bounds = arguments = self._arguments(ca.MX)
        wanted = self._levels("displacement", level, bounds)
        if not wanted:
            return None
        Y = self._path(design, corner, numbers)
        rows = [row for most in wanted for row in ((most - Y) / 0.1, (most + Y) / 0.1)]
        return self._named("paths", arguments, rows)

    @cached_property
    def _path(self) -> ca.Function:
        return self.path()

    @cached_property
    def rows(self) -> tuple[ca.Function, ca.Function, ca.Function | None]:
        """Rows of margins, of the ground, and of the path."""
        return self.margin_rows(), self.ground_rows(), self.path_rows()

    def displacement(self, design: Mapping[str, float], corners: Mapping[str, Any]) -> FloatArray:
        """Largest |Y| over the samples of the run, m, for each corner."""
        C = np.stack([np.atleast_1d(corners[s]) for s in CORNER])
        mapped = self._mapped(self._path, C.shape[1])
        Y: FloatArray = np.array(mapped(vector(design, DESIGN), C, self.numbers))
        most: FloatArray = np.abs(Y).max(axis=0)
        return most

    def _mapped(self, function: ca.Function, count: int) -> ca.Function:
        """A function over `count` corners; made once, for making it costs more than a few calls."""
        key = (function.name(), count)
        if key not in self._maps:
            self._maps[key] = function.map("mapped", "serial", count, self._shared(function), [])
        return self._maps[key]

    @cached_property
    def _maps(self) -> dict[tuple[str, int], ca.Function]:
        return {}

    @staticmethod
    def _shared(function: ca.Function) -> list[int]:
        """Inputs that are the same at every corner."""
        return [k for k in range(function.n_in()) if function.name_in(k) != "corner"]

    def residuals(
        self,
        design: Mapping[str, float],
        level: float,
        bounds: FloatArray,
        corners: Mapping[str, FloatArray],
        *,
        path: bool = False,
    ) -> FloatArray:
        """Rows of a design, one column for each corner: of the path, or of everything else."""
        margins, ground, paths = self.rows
        functions = ([paths] if paths else []) if path else [margins, ground]
        C = np.stack([corners[s] for s in CORNER])
        given = (vector(design, DESIGN), C, self.numbers, level, bounds)
        parts = [np.array(self._mapped(f, C.shape[1])(*given)) for f in functions if f.size1_out(0)]
        return np.concatenate(parts) if parts else np.zeros((0, C.shape[1]))
