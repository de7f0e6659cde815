"""Basins: from which starts, and after which kicks, an aircraft stays on the runway."""

from __future__ import annotations

from collections.abc import Mapping
from concurrent.futures import Executor
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from groundroll.aircraft.aircraft import Aircraft, of_aircraft
from groundroll.base.arrays import FloatArray, finite
from groundroll.base.errors import GroundrollError, unknown
from groundroll.base.listing import Pictured
from groundroll.base.progress import Progress, counted
from groundroll.generated import PACKS, Quantity
from groundroll.model.models import ModelLike, as_model
from groundroll.model.names import PARAMETERS, parameter_symbols, symbol
from groundroll.model.shown import UnitsLike, as_units
from groundroll.results.records import Column, Record, measured
from groundroll.results.results import Result
from groundroll.view.plots import INK, legend_above, plain, style

from .fates import FATES, ByteArray, Criterion, criterion_of, fates
from .kicks import check_tire, kick, rolling

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: What an axis may be beside a parameter -> the quantity.
_STARTS = {
    "v0": PACKS["nonlinear"].quantities["v"],
    "r0": PACKS["nonlinear"].quantities["r"],
    "impulse": PACKS["aircraft"].quantities["S"],
}
#: One colour for each fate, from light to dark in grey print too.
_SHADES = ("#EEF3F7", "#B84A00", "#7FB3DA", "#F0C987", "#333333")


@dataclass(frozen=True, repr=False, eq=False)
class Basin(Pictured, Result):
    """What becomes of an aircraft over two axes.

    Attributes
    ----------
    x_name, y_name : str
        ``v0``, ``r0``, ``impulse`` or the symbol of a parameter.
    x, y : ndarray, shapes (nx,), (ny,)
        Their values, SI units with radians.
    fate : ndarray of int8, shape (ny, nx)
        An index of `groundroll.Survival.FATES`.
    when : ndarray, shape (ny, nx)
        When the aircraft has straightened out or stopped, s; NaN where it does not.
    aircraft : Aircraft
    model : str or Model
    inputs : mapping of str to ndarray
        What acts on it, by symbol.
    station : float
        Where an impulse acts, m ahead of the CG.
    criterion : Criterion
        What counts as surviving.
    """

    x_name: str
    y_name: str
    x: FloatArray
    y: FloatArray
    fate: ByteArray
    when: FloatArray
    aircraft: Aircraft
    model: ModelLike
    inputs: Mapping[str, FloatArray]
    station: float
    criterion: Criterion

    @property
    def share(self) -> float:
        """Share of the points that stay on the runway."""
        return float(np.mean(self.fate == 0))

    def plot(self, ax: Axes | None = None, *, units: UnitsLike = None) -> Axes:
        """Draw the fates, light where the aircraft stays on the runway.

        Parameters
        ----------
        ax : Axes, optional
            Where; a new figure if omitted.
        units : str or mapping of str to str, optional
            See `groundroll.model.shown.as_units`; by the names of the axes.
        """
        from matplotlib import pyplot
        from matplotlib.colors import ListedColormap
        from matplotlib.patches import Patch

        with style():
            if ax is None:
                _, ax = pyplot.subplots(figsize=(5.2, 4.2))
            of_x, of_y = _quantity(self.x_name), _quantity(self.y_name)
            shown = as_units(units, {self.x_name: of_x, self.y_name: of_y}, self.aircraft)
            x, y = shown.values(of_x, self.x), shown.values(of_y, self.y)
            ax.pcolormesh(
                x,
                y,
                self.fate,
                cmap=ListedColormap(_SHADES),
                vmin=-0.5,
                vmax=len(FATES) - 0.5,
                rasterized=True,
            )
            present = np.unique(self.fate).tolist()
            if 0 < self.share < 1:
                ax.contour(x, y, (self.fate == 0) * 1.0, levels=[0.5], colors=INK, linewidths=0.9)
            look: Any = {"edgecolor": INK, "linewidth": 0.5}
            patches = [Patch(facecolor=_SHADES[k], label=FATES[k], **look) for k in present]
            legend_above(
                ax,
                f"{plain(self.aircraft.name)}, {plain(as_model(self.model).name)} model",
                patches,
                2,
            )
            ax.set_xlabel(shown.label(of_x, _before(self.x_name)))
            ax.set_ylabel(shown.label(of_y, _before(self.y_name)))
            ax.grid(False)
        return ax

    def _record(self) -> Record:
        axes = {self.y_name: self.y, self.x_name: self.x}
        results = {s: measured((s,), v, _quantity(s)) for s, v in axes.items()}
        results["fate"] = Column(tuple(axes), self.fate, names=FATES)
        results["when"] = Column(tuple(axes), self.when, "s", "straightened out or stopped after")
        about: dict[str, Any] = {"x": self.x_name, "y": self.y_name, "station": self.station}
        about |= vars(self.criterion)
        model = as_model(self.model)
        return Record(
            "basin", self.aircraft, model, tuple(axes), results, given=self.inputs, about=about
        )

    @classmethod
    def _of(cls, record: Record) -> Basin:
        about = dict(record.about)
        x, y, station = (about.pop(key) for key in ("x", "y", "station"))
        return cls(
            x_name=x,
            y_name=y,
            x=record[x],
            y=record[y],
            fate=record["fate"].astype(np.int8),
            when=record["when"],
            aircraft=record.aircraft,
            model=record.model.key,
            inputs=dict(record.given),
            station=station,
            criterion=Criterion(**about),
        )

    def __repr__(self) -> str:
        counts = np.bincount(self.fate.reshape(-1), minlength=len(FATES)).tolist()
        what = ", ".join(f"{n} {name}" for name, n in zip(FATES, counts, strict=True) if n)
        return (
            f"Basin of {self.aircraft.name!r}: {self.x_name} {self.x[0]:g} to {self.x[-1]:g} x"
            f" {self.y_name} {self.y[0]:g} to {self.y[-1]:g}: {what}"
        )


@of_aircraft
def basin(
    plane: Aircraft,
    x: tuple[str, Any],
    y: tuple[str, Any],
    model: ModelLike = "nonlinear",
    *,
    station: float | str = 0.0,
    half_width: Any = Criterion.half_width,
    heading: Any = Criterion.heading,
    settled: float = Criterion.settled,
    t: Any = None,
    threads: int | None = None,
    executor: Executor | None = None,
    progress: Progress = None,
    **values: Any,
) -> Basin:
    """From which starts an aircraft stays on the runway, hands off; see `groundroll.survival`.

    Parameters
    ----------
    plane : Aircraft
        The aircraft, with a tire that is right at large slip angles (``brott-physical``); none of
        its parameters may be an array.
    x, y : tuple of str and array
        ``"v0"`` (m/s), ``"r0"`` (rad/s), ``"impulse"`` (N s) or a parameter (``"speed"``), and
        increasing values in SI units.
    model : str or Model
        A model that knows heading and offset.
    station : float
        Where an impulse acts, m ahead of the CG.
    half_width, heading, settled, t : float
        See `groundroll.survival`.
    threads, executor, progress
        As for `groundroll.ensemble`.
    **values : float or str
        Parameters and inputs (``crosswind``) by symbol or full name, constant.

    Returns
    -------
    Basin
        Fates and a picture of them.

    Raises
    ------
    GroundrollError
        For unknown names, values that do not increase, or a tire that is wrong at large slip.
    """
    model = as_model(model)
    plane, inputs = rolling(plane, model, values, "basin")
    criterion = criterion_of(model, half_width, heading, settled, t)
    axes = dict((_axis("x", x), _axis("y", y)))
    if len(axes) != 2:
        raise GroundrollError("x and y are the same; a basin needs two axes")
    if arrays := [s for s, value in plane.given.items() if value.ndim]:
        raise GroundrollError(
            f"a basin is of one aircraft, but {', '.join(arrays)} of {plane.name} are arrays"
        )
    (x_name, x_values), (y_name, y_values) = axes.items()
    grid = {x_name: x_values[None, :], y_name: y_values[:, None]}
    varied = {name: value for name, value in grid.items() if name not in _STARTS}
    aircraft = plane.replace(**varied)
    check_tire(aircraft, model)
    place = finite("station", station, "m")
    v, r = _start(grid, aircraft, place)
    shape = (y_values.size, x_values.size)
    starts = np.broadcast_to(v, shape), np.broadcast_to(r, shape)
    options = {"threads": threads, "executor": executor}
    with counted(progress, "kicks", x_values.size * y_values.size) as done:
        fate, when = fates(aircraft, *starts, criterion, done.add, model, inputs, **options)
    return Basin(
        x_name=x_name,
        y_name=y_name,
        x=x_values,
        y=y_values,
        fate=fate,
        when=when,
        aircraft=plane,
        model=model.key,
        inputs=inputs,
        station=float(place),
        criterion=criterion,
    )


def _start(
    grid: Mapping[str, FloatArray], plane: Aircraft, station: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """v and r: those of the grid, and what an impulse adds."""
    zero = np.zeros(())
    v, r = grid.get("v0", zero), grid.get("r0", zero)
    if "impulse" not in grid:
        return v, r
    dv, dr = kick(station, grid["impulse"], plane)
    return v + dv, r + dr


def _axis(which: str, axis: tuple[str, Any]) -> tuple[str, FloatArray]:
    try:
        name, given = axis
    except (TypeError, ValueError):
        raise GroundrollError(f"{which} must be a pair (name, values), not {axis!r}") from None
    key = str(name)
    if key not in _STARTS:
        try:
            key = symbol(key, "parameter", parameter_symbols())
        except GroundrollError:
            known = [q.name for q in PARAMETERS.values()]
            raise unknown("axis", key, [*_STARTS, *known, *parameter_symbols()]) from None
    values = finite(f"{which} ({key})", given, _quantity(key).unit)
    if values.ndim != 1 or values.size < 2 or (np.diff(values) <= 0).any():
        raise GroundrollError(f"{which} ({key}) must be a list of two or more increasing values")
    return key, values


def _quantity(axis: str) -> Quantity:
    """What an axis is."""
    return _STARTS[axis] if axis in _STARTS else PARAMETERS[axis]


def _before(axis: str) -> str:
    """What is to be said before the name of an axis."""
    return "initial " if axis in ("v0", "r0") else ""
