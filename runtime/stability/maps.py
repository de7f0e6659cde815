"""Stability maps: any two parameters against a margin, a damping ratio, a frequency or a window."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from groundroll.aircraft.aircraft import Aircraft, of_aircraft
from groundroll.base.arrays import FloatArray, finite
from groundroll.base.errors import GroundrollError, one_of
from groundroll.base.listing import Pictured
from groundroll.model.models import as_model
from groundroll.model.names import PARAMETERS, parameter_symbols, symbol
from groundroll.model.shown import UnitsLike
from groundroll.results.doors import drawn
from groundroll.results.records import Column, Record, measured
from groundroll.results.results import Result

from .closed_forms import CLOSED_FORMS, OVER_SPEED, closed_forms, quantity_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes


@dataclass(frozen=True, repr=False)
class StabilityMap(Pictured, Result):
    """A quantity of the linear model over two parameters.

    Attributes
    ----------
    x_name, y_name : str
        Symbols of the parameters.
    x, y : ndarray, shapes (nx,), (ny,)
        Their values, SI units with radians.
    of : str
        What is mapped, a name of `groundroll.Margins` or of `groundroll.SpeedWindow`.
    values : ndarray, shape (ny, nx)
        It, in the SI unit `unit`.
    aircraft : Aircraft
        The aircraft at every point, its parameters of shape (ny, nx) where they vary.
    """

    x_name: str
    y_name: str
    x: FloatArray
    y: FloatArray
    of: str
    values: FloatArray
    aircraft: Aircraft

    @property
    def unit(self) -> str:
        """Unit of the values."""
        return quantity_of(self.of).unit

    @cached_property
    def boundary(self) -> dict[str, FloatArray]:
        """What is zero where stability is lost, by name, each of shape (ny, nx).

        ``determinant`` and ``trace`` of A at a speed; ``speed_margin`` if the map is of
        something that concerns every speed at once.
        """
        names = ("speed_margin",) if self.of in OVER_SPEED else ("determinant", "trace")
        found = closed_forms(self.aircraft, names)
        return {name: np.broadcast_to(found[name], self.values.shape) for name in names}

    @cached_property
    def stable(self) -> npt.NDArray[np.bool_]:
        """Where the aircraft is stable: at its speed, or at every speed; shape (ny, nx)."""
        if self.of in OVER_SPEED:
            return self.boundary["speed_margin"] > 0
        return (self.boundary["trace"] < 0) & (self.boundary["determinant"] > 0)

    def fits(self, plane: Aircraft) -> bool:
        """Whether an aircraft is a point of this map: all else is the same."""
        return all(
            bool(np.allclose(plane[s], self.aircraft[s], rtol=1e-9, atol=0.0))
            for s in as_model("linear").parameters
            if self.aircraft[s].ndim == 0
        )

    def plot(
        self,
        ax: Axes | None = None,
        *,
        levels: Any = None,
        units: UnitsLike = None,
        marks: Mapping[str, Aircraft] | None = None,
        ranges: Mapping[str, tuple[Any, Any]] | None = None,
        cg_range: bool = False,
    ) -> Axes:
        """Draw the map as contours, with the boundary of stability from its closed form.

        Parameters
        ----------
        ax : Axes, optional
            Where; a new figure if omitted.
        levels : sequence of float, optional
            Contour levels in the shown unit.
        units : str or mapping of str to str, optional
            See `groundroll.model.shown.as_units`; by parameter or by the name of what is mapped,
            e.g. ``{"speed": "km/h", "tail_wheel_stiffness": "lbf/deg"}``.
        marks : mapping of str to Aircraft, optional
            Aircraft to mark, by label.
        ranges : mapping of str to tuple, optional
            Hatched range of x or y that the aircraft is to meet, in SI units, e.g.
            ``{"speed": (10, 30)}``.
        cg_range : bool
            Hatch what lies between the limits of the CG, if x or y moves with the CG.

        Returns
        -------
        Axes
            What was drawn on.
        """
        hatched = dict(ranges or {})
        if cg_range:
            hatched.update(self._cg_range())
        axes: Axes = drawn("map", self, ax, levels, units, dict(marks or {}), hatched)
        return axes

    def _cg_range(self) -> dict[str, tuple[float, float]]:
        """Values of an axis with the CG at its limits, the wheels staying at their stations."""
        moving = {"x_cg", "a", "b"} & {self.x_name, self.y_name}
        if len(moving) != 1:
            raise GroundrollError(
                "cg_range needs one axis that moves with the CG: cg_station, main_gear_arm or"
                f" tail_arm, not {self.x_name} and {self.y_name}"
            )
        (axis,) = moving
        ends = []
        for limit in ("x_forward", "x_aft"):
            plane = self.aircraft.replace(a=None, b=None, x_cg=self.aircraft[limit])
            ends.append(float(plane[axis]))
        return {axis: (min(ends), max(ends))}

    def _record(self) -> Record:
        axes = (self.y_name, self.x_name)
        results = {self.of: measured(axes, self.values, quantity_of(self.of))}
        results["stable"] = Column(axes, self.stable)
        about = {"x": self.x_name, "y": self.y_name, "of": self.of}
        model = as_model("linear")
        return Record("map", self.aircraft, model, axes, results, about=about)

    @classmethod
    def _of(cls, record: Record) -> StabilityMap:
        x, y, of = (record.about[key] for key in ("x", "y", "of"))
        along_x, along_y = (record.varied[s].values for s in (x, y))
        return cls(x, y, along_x, along_y, of, record[of], record.aircraft)

    def __repr__(self) -> str:
        share = np.count_nonzero(self.stable) / self.stable.size
        return (
            f"StabilityMap of {self.of} ({self.unit}) for {self.aircraft.name!r}:"
            f" {self.x_name} {self.x[0]:g} to {self.x[-1]:g} x {self.y_name} {self.y[0]:g} to"
            f" {self.y[-1]:g}, {self.values.size} points, {100 * share:.0f} % of them stable"
        )


@of_aircraft
def stability_map(
    plane: Aircraft,
    x: tuple[str, Any],
    y: tuple[str, Any],
    of: str = "decay_rate",
) -> StabilityMap:
    """Map a quantity of the linear model over two parameters.

    A million points take about a second: the closed forms are applied to all of them at once.

    Parameters
    ----------
    plane : Aircraft
        The aircraft; none of its parameters may be an array.
    x, y : tuple of str and array
        Symbol or full name of a parameter (``"speed"`` is one), and its values in SI units with
        radians, increasing.
    of : str
        What to map: a margin at the speed of each point (``"decay_rate"``,
        ``"damping_ratio"``, ``"damped_frequency"``, ``"static_margin"``, ... of
        `groundroll.Margins`), or what concerns every speed (``"speed_margin"``,
        ``"lower_critical_speed"``, ``"upper_critical_speed"``, ``"weakest_speed"``,
        ``"least_determinant"``, ``"stiffness_needed_always"``).

    Returns
    -------
    StabilityMap
        Values, boundary and picture.

    Raises
    ------
    GroundrollError
        For unknown names, values that are no increasing list, or a parameter on which nothing
        depends.
    """
    one_of("margin", of, CLOSED_FORMS | OVER_SPEED)
    arrays = [s for s, value in plane.given.items() if value.ndim]
    if arrays:
        raise GroundrollError(
            f"a map is of one aircraft, but {', '.join(arrays)} of {plane.name} are arrays"
        )
    (x_name, x_values), (y_name, y_values) = (_axis("x", x), _axis("y", y))
    if x_name == y_name:
        raise GroundrollError(f"x and y are both {x_name}; a map needs two parameters")
    grid = plane.replace(**{x_name: x_values[None, :], y_name: y_values[:, None]})
    values = closed_forms(grid, [of])[of]
    shape = (y_values.size, x_values.size)
    _check_influence(grid, of, values, dict(zip((y_name, x_name), shape, strict=True)))
    return StabilityMap(
        x_name=x_name,
        y_name=y_name,
        x=x_values,
        y=y_values,
        of=of,
        values=np.ascontiguousarray(np.broadcast_to(values, shape)),
        aircraft=grid,
    )


def _axis(which: str, axis: tuple[str, Any]) -> tuple[str, FloatArray]:
    try:
        name, given = axis
    except (TypeError, ValueError):
        raise GroundrollError(f"{which} must be a pair (name, values), not {axis!r}") from None
    key = symbol(str(name), "parameter", parameter_symbols(), f"{which} of the map")
    values = finite(f"{which} ({key})", given, PARAMETERS[key].unit)
    if values.ndim != 1 or values.size < 2 or (np.diff(values) <= 0).any():
        raise GroundrollError(f"{which} ({key}) must be a list of two or more increasing values")
    return key, values


def _check_influence(grid: Aircraft, of: str, values: FloatArray, sizes: Mapping[str, int]) -> None:
    """Refuse a map that is the same along an axis because nothing depends on its parameter."""
    for (name, size), found in zip(sizes.items(), values.shape or (1, 1), strict=True):
        if size != found:
            given = ", ".join(s for s in as_model("linear").parameters if s in grid.given)
            raise GroundrollError(
                f"{of} of {grid.name} does not depend on {PARAMETERS[name].name} ({name}): the"
                f" parameters {given} are given; replace(...=None) lets one follow from others"
            )
