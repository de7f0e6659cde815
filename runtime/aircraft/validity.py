"""Where numbers of a tire hold: what cannot be, and what goes beyond what was measured."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np

from groundroll.base.arrays import FloatArray
from groundroll.base.errors import GroundrollError
from groundroll.base.wording import number
from groundroll.model.evaluate import elementwise, names_of

if TYPE_CHECKING:
    from .aircraft import Aircraft

#: How far beyond what was measured is not worth telling, relative.
_SLACK = 0.02
#: How far from the load at which a stiffness follows from size the tangent there is near enough.
_NEAR = 0.15


#: Loads within this ratio are one.
_ONE_LOAD = 1.15
#: Share of friction by which a peak beyond the data is worth telling, and angles to seek it at.
_BEYOND, _ANGLES = 0.02, 500
#: Slip angles and loads of main tires in results, by symbol.
_SLIP_ANGLES = ("alpha", "alpha_left", "alpha_right")
_WHEEL_LOADS = ("Fz_left", "Fz_right")
#: Speed, m/s, from which a slip angle makes forces.
_ROLLING = 1.0


def refuse_impossible_tires(plane: Aircraft, values: Mapping[str, FloatArray]) -> None:
    """Refuse a tire that pushes the way it slides, or without friction, at the load it carries.

    Parameters
    ----------
    plane : Aircraft
        The aircraft.
    values : mapping
        Its parameters of a model by symbol; nothing is refused where they are not those of a tire
        under a load.

    Raises
    ------
    GroundrollError
        If the slope at zero slip is negative anywhere, or friction not positive.
    """
    if not _needed() <= values.keys():
        return
    for what, bad, line in _at_load(values):
        if bad.any():
            load = np.broadcast_to(values["Fz"], bad.shape)[bad].ravel()[0]
            raise GroundrollError(
                f"aircraft {plane.name}: at a load of {number(load)} N {what}: {line} over load,"
                f" which holds near the loads that were measured{_measured(plane)}"
            )


def extrapolated(plane: Aircraft, slip: Any = None, loads: Any = None) -> tuple[str, ...]:
    """What is asked of the main tires beyond what they were measured at, in words.

    Parameters
    ----------
    plane : Aircraft
        The aircraft; of an array any element counts.
    slip : array, optional
        Slip angles of the main tires, rad.
    loads : array, optional
        Loads on one main tire, N; default the aircraft's own.

    Returns
    -------
    tuple of str
        Empty if there is nothing to tell, or nothing known of what was measured.
    """
    return (*_loads(plane, loads), *_slip(plane, slip))


def assumed(plane: Aircraft) -> Iterator[str]:
    """What the data of the main tires do not say, and was taken for it, in words."""
    if not all(s in plane for s in (*_needed(), "E1", "alpha_high", "Fz_low", "Fz_high")):
        return
    low, high, last = (plane[s] for s in ("Fz_low", "Fz_high", "alpha_high"))
    if (high < _ONE_LOAD * low).all():
        yield (
            f"the main tires were measured at {_range(low)} N only: that their cornering"
            " coefficient and friction are the same at every load is an assumption"
        )
    angles = np.linspace(0.0, 1.0, _ANGLES)
    tire = {s: plane[s][..., None] for s in names_of("tire_force")[0] if s != "alpha"}
    ends = last[..., None] + angles * (np.pi / 2 - last[..., None])
    F = elementwise("tire_force", {**tire, "alpha": ends})["F_y"] / tire["Fz"]
    reached, friction = F[..., 0], F.max(axis=-1)
    if (reached < (1 - _BEYOND) * friction).any():
        yield (
            f"the largest friction of the main tires, {_range(friction)}, is extrapolated: at"
            f" {_range(np.degrees(last))} deg, where the data end, it is {_range(reached)}"
        )


def extrapolated_in(plane: Aircraft, values: Mapping[str, FloatArray]) -> tuple[str, ...]:
    """The same of results by symbol: slip angles and loads of the main tires, as far as they are.

    Slip below 1 m/s says nothing of forces. Loads below those measured are common, as the wings
    carry a part of the weight at speed, and the line over load is near there.
    """
    rolls = values["u"] > _ROLLING if "u" in values else True
    slips = [np.where(rolls, np.abs(values[s]), 0.0) for s in _SLIP_ANGLES if s in values]
    slip = np.concatenate([x.ravel() for x in slips]) if slips else None
    found = [values[s].ravel() for s in _WHEEL_LOADS if s in values]
    if not found or "Fz_low" not in plane:
        return extrapolated(plane, slip)
    above = np.maximum(np.concatenate(found), float(plane["Fz_low"].max()))
    return extrapolated(plane, slip, above[np.isfinite(above)])


def _loads(plane: Aircraft, loads: Any) -> Iterator[str]:
    if "Fz" not in plane:
        return
    load = plane["Fz"] if loads is None else np.asarray(loads)
    if "Fz_low" in plane and "Fz_high" in plane:
        low, high = plane["Fz_low"], plane["Fz_high"]
        if ((load < low * (1 - _SLACK)) | (load > high * (1 + _SLACK))).any():
            yield (
                f"the load on a main tire, {_range(load)} N, is beyond what was measured,"
                f" {number(low.min())} to {number(high.max())} N: stiffness and friction there are"
                " straight lines continued"
            )
    elif "B3" in plane and "B3" not in plane.given and loads is not None:
        near = plane["Fz"]
        if (np.abs(load - near) > _NEAR * near).any():
            yield (
                f"the load on a main tire, {_range(load)} N, goes far from {_range(near)} N, where"
                " its cornering coefficient follows from its size: elsewhere it is the tangent"
            )


def _slip(plane: Aircraft, slip: Any) -> Iterator[str]:
    if slip is None or "alpha_high" not in plane:
        return
    largest, high = float(np.nanmax(np.abs(slip), initial=0.0)), float(plane["alpha_high"].max())
    if largest > high * (1 + _SLACK):
        yield (
            f"slip angles of the main tires reach {np.degrees(largest):.3g} deg, and were measured"
            f" to {np.degrees(high):.3g} deg: forces beyond are the formula's"
        )


def _at_load(values: Mapping[str, FloatArray]) -> Iterator[tuple[str, Any, str]]:
    slope = elementwise("tire_slope", values)["F_slope"]
    yield "a main tire has a negative cornering stiffness", slope < 0, "B3 + C3 Fz is a line"
    friction = elementwise("tire_friction", values)["mu"]
    yield "a main tire has no friction", friction <= 0, "B5 + C5 Fz is a line"


def _measured(plane: Aircraft) -> str:
    if not all(s in plane.given for s in ("Fz_low", "Fz_high")):
        return ""
    return f", {_range(plane['Fz_low'])} to {_range(plane['Fz_high'])} N"


@cache
def _needed() -> frozenset[str]:
    return frozenset(s for name in ("tire_slope", "tire_friction") for s in names_of(name)[0])


def _range(values: FloatArray) -> str:
    ends = dict.fromkeys((number(values.min()), number(values.max())))
    return " to ".join(ends)
