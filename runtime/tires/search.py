"""The least squares behind `groundroll.tires.fit`: over what, of what, and the search."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import casadi as ca
import numpy as np

from groundroll.base.arrays import FloatArray
from groundroll.generated import build
from groundroll.model.evaluate import solved

from .data import Curve

#: Loads within this ratio are one: nothing can be said of what changes with load.
_ONE_LOAD = 1.15
#: Share of a curve's largest force below which its points make the secant at zero.
_SMALL = 0.2
#: How far from zero, rad, a point counts as one at zero slip.
_AT_ZERO = 1e-3

#: Error of a measured force, as a share of friction, against which what is likely is weighed.
_NOISE = 0.01
#: What is likely where the data do not say: value and spread of C1 and E1, of friction as a
#: multiple of the largest measured, and of the cornering coefficient as one of the mean secant.
_LIKELY = {"C1": (1.3, 0.3), "E1": (0.0, 2.0), "mu": (1.1, 0.5), "C_c": (1.0, 1.0)}
#: Bounds. With C1 from 1 on the curve peaks or levels off at the friction; with C1 up to 2 and E1
#: up to 1 it never reverses.
_BOUNDS = {
    "C_c": (1e-3, 50.0),
    "mu": (0.1, 20.0),
    "C1": (1.0, 2.0),
    "E1": (-20.0, 1.0),
    "S": (-5.0, 5.0),
}
#: From where to search, C1 and E1: of two starts the better end counts.
_STARTS = ((1.3, 0.0), (1.05, -1.0))

_QUIET: dict[str, Any] = {
    "print_time": False,
    "error_on_fail": False,
    "ipopt": {
        "print_level": 0,
        "sb": "yes",
        "tol": 1e-9,
        "max_iter": 300,
        "bound_relax_factor": 0.0,
    },
}


@dataclass(frozen=True)
class Secant:
    """The slope of a curve over its smallest slip angles.

    Attributes
    ----------
    value : float
        N/rad, with the offset of the curve in it.
    per_offset : float
        What an offset of 1 N adds to it, 1/rad.
    is_degressive : bool
        Whether the curve bends down from there, so that its slope at zero is not below it.
    """

    value: float
    per_offset: float
    is_degressive: bool


def secant(curve: Curve) -> Secant:
    """The secant of a curve."""
    alpha, F = curve.slip_angles, curve.forces
    size = np.abs(alpha)
    offset = _offset(curve)
    first = size[size > _AT_ZERO].min()
    weak = np.abs(F - offset) < _SMALL * np.abs(F - offset).max()
    small = (size > _AT_ZERO) & ((size < 1.001 * first) | weak)
    beyond = size > size[small].max()
    next_one = size[beyond].min(initial=np.inf)
    further = beyond & (size < max(4 * size[small].max(), 1.001 * next_one))

    def slope(points: Any, by: FloatArray) -> float:
        return float(by[points] @ alpha[points] / (alpha[points] @ alpha[points]))

    bends = further.any() and slope(further, F - offset) < slope(small, F - offset)
    return Secant(slope(small, F), slope(small, np.ones_like(F)), bool(bends))


def brackets_zero(curve: Curve) -> bool:
    """Whether the data tell what the force at zero slip is."""
    alpha = curve.slip_angles
    return bool((np.abs(alpha) < _AT_ZERO).any() or (alpha.min() < 0 < alpha.max()))


def _offset(curve: Curve) -> float:
    """The force at zero slip, roughly; zero where the data do not say."""
    alpha, F = curve.slip_angles, curve.forces
    at_zero = np.abs(alpha) < _AT_ZERO
    if at_zero.any():
        return float(F[at_zero].mean())
    if not brackets_zero(curve):
        return 0.0
    before, after = alpha < 0, alpha > 0
    x = [alpha[before].max(), alpha[after].min()]
    y = [F[alpha == each].mean() for each in x]
    return float(np.interp(0.0, x, y))


@dataclass(frozen=True)
class Search:
    """Least squares of the forces of one tire, over all of its points at once.

    The unknowns are the cornering coefficient and the friction at the lowest and at the highest
    load (at the only one, if there is one), C1, E1 and an offset for each curve that has one.
    """

    curves: tuple[Curve, ...]

    @cached_property
    def loads(self) -> tuple[float, float]:
        """Lowest and highest."""
        every = np.concatenate([curve.loads for curve in self.curves])
        return float(every.min()), float(every.max())

    @property
    def has_one_load(self) -> bool:
        """Whether the loads are too near each other to tell what changes with them."""
        return self.loads[1] < _ONE_LOAD * self.loads[0]

    @cached_property
    def secants(self) -> tuple[Secant, ...]:
        """Of each curve."""
        return tuple(map(secant, self.curves))

    @cached_property
    def has_offset(self) -> tuple[bool, ...]:
        """Of each curve, whether its offset can be told."""
        return tuple(map(brackets_zero, self.curves))

    @cached_property
    def _scale(self) -> tuple[float, float]:
        """Of the cornering coefficients and of friction."""
        coefficients = [s.value / c.load for s, c in zip(self.secants, self.curves, strict=True)]
        friction = max(float(np.abs(c.forces / c.loads).max()) for c in self.curves)
        return max(float(np.mean(coefficients)), 0.1 * friction), friction

    @cached_property
    def _sizes(self) -> dict[str, int]:
        nodes = 1 if self.has_one_load else 2
        return {"C_c": nodes, "mu": nodes, "C1": 1, "E1": 1, "S": sum(self.has_offset)}

    def best(self) -> dict[str, FloatArray]:
        """What was found: tire parameters by symbol, ``S`` of each curve and the ``errors``.

        Errors are fitted less measured force over load, at the points of the curves in turn.
        """
        x = ca.SX.sym("x", sum(self._sizes.values()))
        values = self._values(x)
        errors = self._errors(values)
        program = {"x": x, "f": self._cost(x, errors), "g": self._above_the_secants(values)}
        solver = ca.nlpsol("tire_fit", "ipopt", program, _QUIET)
        low, high = (
            [_BOUNDS[s][k] for s, n in self._sizes.items() for _ in range(n)] for k in (0, 1)
        )
        ends = []
        for C1, E1 in _STARTS:
            start = {"C_c": 1.2, "mu": 1.1, "C1": C1, "E1": E1, "S": 0.0}
            x0 = [start[s] for s, n in self._sizes.items() for _ in range(n)]
            end = solved(solver, x0=x0, lbx=low, ubx=high, lbg=0.0)
            missed = np.minimum(np.array(end["g"]), 0.0).sum()
            ends.append((float(end["f"]) - 1e6 * missed, np.array(end["x"]).ravel()))
        _, at = min(ends, key=lambda end: end[0] if np.isfinite(end[0]) else np.inf)
        wanted = {**values, "errors": errors}
        numbers = ca.Function("at", [x], list(wanted.values()))(at)
        return {s: np.array(v).ravel() for s, v in zip(wanted, numbers, strict=True)}

    def _split(self, x: ca.SX) -> dict[str, ca.SX]:
        return dict(
            zip(
                self._sizes,
                ca.vertsplit(x, np.cumsum([0, *self._sizes.values()]).tolist()),
                strict=True,
            )
        )

    def _values(self, x: ca.SX) -> dict[str, ca.SX]:
        """Tire parameters by symbol, and the offsets."""
        parts = self._split(x)
        low, high = self.loads
        found = {"C1": parts["C1"], "E1": parts["E1"]}
        pairs = zip(("C_c", "mu"), (("B3", "C3"), ("B5", "C5")), self._scale, strict=True)
        for key, (intercept, slope), scale in pairs:
            ends = scale * parts[key]
            found[slope] = ca.SX(0) if self.has_one_load else (ends[1] - ends[0]) / (high - low)
            found[intercept] = ends[0] - found[slope] * low
        found["B1"], found["D1"] = map(ca.SX, build("magic_formula_of_shape")(found["C1"]))
        free = iter(ca.vertsplit(parts["S"]) if any(self.has_offset) else [])
        scales = [self._scale[1] * curve.load for curve in self.curves]
        shifts = [
            next(free) * scale if has else ca.SX(0)
            for has, scale in zip(self.has_offset, scales, strict=True)
        ]
        found["S"] = ca.vertcat(*shifts)
        return found

    def _cost(self, x: ca.SX, errors: ca.SX) -> ca.SX:
        parts = self._split(x)
        likely = (
            ca.sumsqr((parts[s] - middle) / spread) for s, (middle, spread) in _LIKELY.items()
        )
        return ca.SX(sum(likely, ca.sumsqr(errors / (_NOISE * self._scale[1]))))

    def _errors(self, values: Mapping[str, ca.SX]) -> ca.SX:
        force = build("tire_force")
        parts = []
        for k, curve in enumerate(self.curves):
            point: dict[str, Any] = {
                **values,
                "alpha": curve.slip_angles[None, :],
                "Fz": curve.loads[None, :],
            }
            F = force.call([point[s] for s in force.name_in()])[0]
            parts.append((F + values["S"][k] - curve.forces[None, :]) / curve.loads[None, :])
        errors: ca.SX = ca.horzcat(*parts)
        return errors

    def _above_the_secants(self, values: Mapping[str, ca.SX]) -> ca.SX:
        """By how much the slope at zero is above each secant, relative."""
        slope_at = build("tire_slope")
        rows = [ca.SX(1)]
        for k, (curve, each) in enumerate(zip(self.curves, self.secants, strict=True)):
            if each.is_degressive:
                point: dict[str, Any] = {**values, "Fz": curve.load}
                slope = slope_at.call([point[s] for s in slope_at.name_in()])[0]
                measured = each.value - values["S"][k] * each.per_offset
                rows.append((slope - measured) / (self._scale[0] * curve.load))
        return ca.vertcat(*rows)
