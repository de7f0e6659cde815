"""From what a user asks to a case: every number found, every mistake named."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from groundroll import generated
from groundroll.aircraft.aircraft import Aircraft
from groundroll.base.arrays import finite, positive
from groundroll.base.errors import GroundrollError, one_of
from groundroll.model.models import ModelLike, as_model
from groundroll.model.names import QUANTITIES

from .case import THIRD, VARIABLES, Case, Variable
from .envelope import Axis, Envelope, numbers
from .limits import KINDS, LAYOUTS, LOAD, Bound, Limits, shown

STIFFNESS = ("constant", "following")
OBJECTIVES = ("decay_rate", "damping_ratio", "displacement", "smallest_change")
#: How far from the CG range the main gear is looked for where no bounds are given, m.
_REACH = 1.0
#: Lift-off speed of wings that lift nothing, m/s; its square still has a derivative.
_NO_LIFT = 1e12


def resolve(
    plane: Aircraft,
    envelope: Envelope,
    limits: Limits,
    objective: str,
    *,
    variables: Mapping[str, Any] | None = None,
    layout: str | None = None,
    stiffness: str | None = None,
    tail_wheel: str = "locked",
    model: ModelLike = "nonlinear",
    v0: float = 0.1,
    duration: float = 5.0,
) -> Case:
    """Every number of a placement problem; see `place_gear` for the arguments.

    Raises
    ------
    GroundrollError
        For unknown names, bounds that are crossed, parameters that are missing or at odds.
    """
    one_of("objective", objective, OBJECTIVES, "place_gear")
    one_of("tail_wheel", tail_wheel, ("locked", "free"), "place_gear")
    as_model(model)
    today = _today(plane)
    axes = envelope.axes(plane)
    if layout is None:
        layout = LAYOUTS[0] if today["x_main"] < axes["x_cg"].low else LAYOUTS[1]
    one_of("layout", layout, LAYOUTS, "place_gear")
    has_tail_wheel = layout == "taildragger" and tail_wheel == "locked"
    if not has_tail_wheel or _is_zero(plane, "Ct"):
        today["kappa"] = 0.0
    if stiffness is None:
        stiffness = "constant" if _given(plane, today["kappa"] > 0) else "following"
    one_of("stiffness", stiffness, STIFFNESS, "place_gear")
    bounds = limits.bounds(layout)
    chosen = _variables(variables, layout, axes, today)
    return Case(
        plane=plane,
        layout=layout,
        stiffness=stiffness,
        objective=objective,
        axes=axes,
        variables=chosen,
        bounds=_complete(bounds, objective),
        today=_with_nose(today, layout, chosen),
        numbers=_numbers(plane, envelope, axes, bounds, stiffness, today["kappa"] > 0),
        model=model,
        v0=positive("v0", v0, "m/s"),
        duration=positive("t", duration, "s"),
    )


def _today(plane: Aircraft) -> dict[str, float]:
    """Today's stations; an arm that contradicts them is an error, not a choice."""
    today = {s: float(plane[s]) for s in ("x_main", "x_tail", "Ap")}
    for arm, station in (("a", "x_main"), ("b", "x_tail")):
        if arm in plane.given:
            follows = plane.replace(**{arm: None})[arm]
            if not np.allclose(plane[arm], follows, rtol=0, atol=1e-6):
                raise GroundrollError(
                    f"{QUANTITIES[arm].name} ({arm}) of aircraft {plane.name} is given as"
                    f" {float(plane[arm]):g} m, but {QUANTITIES[station].name} puts it at"
                    f" {float(follows):g} m. A gear is fixed to the airframe: give its station,"
                    f" and replace({arm}=None)"
                )
    nose = float(plane["x_nose"]) if "x_nose" in plane else np.nan
    return {**today, "x_nose": nose, "kappa": 1.0}


def _is_zero(plane: Aircraft, symbol: str) -> bool:
    return symbol in plane.given and not plane[symbol].any()


def _with_nose(
    today: Mapping[str, float], layout: str, chosen: tuple[Variable, ...]
) -> dict[str, float]:
    if layout == "tricycle" and np.isnan(today["x_nose"]):
        free = {v.symbol: v for v in chosen}
        if "x_nose" not in free:
            raise GroundrollError(
                "a tricycle needs nose_wheel_station (x_nose): give it to the aircraft, as in"
                " plane.replace(nose_wheel_station='-45 in'), or among the variables"
            )
    return dict(today)


def _variables(
    given: Mapping[str, Any] | None,
    layout: str,
    axes: Mapping[str, Axis],
    today: Mapping[str, float],
) -> tuple[Variable, ...]:
    cg = axes["x_cg"]
    ahead = layout == "taildragger"
    reach = (cg.low - _REACH, cg.low) if ahead else (cg.high, cg.high + _REACH)
    wanted = {"main_gear_station": reach, **(given or {})}
    chosen = []
    for name, bounds in wanted.items():
        symbol = VARIABLES[one_of("variable", name, VARIABLES, "place_gear")]
        where = f"variables[{name!r}]"
        if not isinstance(bounds, tuple | list) or len(bounds) != 2:
            raise GroundrollError(f"{where} must be (low, high), not {bounds!r}")
        unit = QUANTITIES[symbol].unit
        low, high = (float(x) for x in finite(where, numbers(bounds, unit, where)))
        if low > high:
            raise GroundrollError(f"{where}: the bounds are crossed, {low:g} above {high:g} {unit}")
        if low == high:
            raise GroundrollError(
                f"{where} leaves no choice, both bounds are {low:g} {unit}; to hold a value, set"
                " it with plane.replace"
            )
        if symbol in ("Ap", "kappa") and low < 0:
            raise GroundrollError(f"{where} must not be negative, but begins at {low:g} {unit}")
        if symbol == "kappa" and today["kappa"] == 0:
            raise GroundrollError(
                "tail_wheel_scale has nothing to scale: the tail wheel is free, or the aircraft"
                " has none"
            )
        if symbol == "x_nose" and ahead:
            raise GroundrollError("nose_wheel_station means nothing for a taildragger")
        chosen.append(Variable(name, symbol, low, high))
    _check_order(chosen, layout, cg, today)
    return tuple(chosen)


def _check_order(chosen: list[Variable], layout: str, cg: Axis, today: Mapping[str, float]) -> None:
    """Main gear and third wheel must not meet; the CG lies between them or near enough."""
    box = {s: (value, value) for s, value in today.items()}
    box |= {v.symbol: (v.low, v.high) for v in chosen}
    main, third = box["x_main"], box[THIRD[layout]]
    apart = main[1] < third[0] if layout == "taildragger" else third[1] < main[0]
    if np.isfinite(third).all() and not apart:
        raise GroundrollError(
            f"main gear ({shown(main[0], 'mm')} to {shown(main[1], 'mm')} behind the datum) and"
            f" {LOAD[layout].removesuffix('_load').replace('_', ' ')} ({shown(third[0], 'mm')} to"
            f" {shown(third[1], 'mm')}) may meet: a {layout} has its main gear"
            f" {'ahead of' if layout == 'taildragger' else 'behind'} it; change the bounds"
        )
    if box["x_tail"][0] <= cg.high:
        raise GroundrollError(
            f"the tail ({shown(box['x_tail'][0], 'mm')} behind the datum) must be behind the CG"
            f" (to {shown(cg.high, 'mm')})"
        )


def _complete(bounds: tuple[Bound, ...], objective: str) -> tuple[Bound, ...]:
    """Damping and displacement mean nothing without stability."""
    needs = objective in ("damping_ratio", "displacement") or any(
        b.limit in ("damping_ratio", "displacement") for b in bounds
    )
    if needs and not any(b.limit == "decay_rate" for b in bounds):
        return (Bound("decay_rate", "at least", 0.0), *bounds)
    return bounds


#: Functions whose arguments must be known, by model of the stiffness.
_NEEDED = ("placement_margins", "placement_limits", "placement_tire")
#: What is computed, chosen, or ranged over: never a fixed number.
_NOT_FIXED = {
    *("a", "b", "C_alpha", "Ct", "Fz", "d", "zeta", "x_third", "x_main", "x_tail", "kappa"),
    *("Ap", "u", "x_cg", "m", "w", "tau", "eta"),
}


def _numbers(
    plane: Aircraft,
    envelope: Envelope,
    axes: Mapping[str, Axis],
    bounds: tuple[Bound, ...],
    stiffness: str,
    has_tail_wheel: bool,
) -> dict[str, float]:
    """Fixed numbers of the aircraft by symbol."""
    functions = (*_NEEDED, f"placement_{stiffness}")
    wanted = [s for name in functions for s in generated.build(name).name_in()]
    wanted += as_model("nonlinear").parameters
    own = {} if envelope.lift else {"u_lift": _NO_LIFT}
    own |= _references(plane, axes, has_tail_wheel) if stiffness == "constant" else {}
    if stiffness == "following":
        _require_following(plane, has_tail_wheel)
    if not has_tail_wheel:
        own |= {"K1": 1.0, "K2": 0.0, "K3": 0.0, "K4": 0.0}
    needs_height = any(KINDS[b.limit].symbol in ("nose_over", "tip_back") for b in bounds)
    found: dict[str, float] = {}
    for s in dict.fromkeys(wanted):
        if s in _NOT_FIXED:
            continue
        if s == "h_cg" and s not in plane.given:
            # an estimate of it is no ground to place wheels on
            if needs_height:
                raise GroundrollError(
                    f"placement within this limit needs cg_height (h_cg), which aircraft"
                    f" {plane.name} is not given"
                )
            found[s] = np.nan
            continue
        # only the height, and the tire of the simulated run, may be unknown
        optional = s in as_model("nonlinear").parameters
        if s in own:
            found[s] = own[s]
        elif s in plane or not optional:
            found[s] = float(plane[s])
        else:
            found[s] = np.nan
    return found


def _references(
    plane: Aircraft, axes: Mapping[str, Axis], has_tail_wheel: bool
) -> dict[str, float]:
    """Where the constant stiffnesses hold: the aircraft file's stiffnesses and static loads."""
    references = {"C_alpha_0": float(plane["C_alpha"]), "Fz_0": np.nan, "Ct_0": 0.0, "F_0": 0.0}
    if "Fz" in plane:
        references["Fz_0"] = float(plane["Fz"])
    if not has_tail_wheel:
        return references
    references["Ct_0"] = float(plane["Ct"])
    shifted = axes["tau"].low != 1.0 or axes["tau"].high != 1.0
    curve = {f"K{n}": float(plane[f"K{n}"]) for n in range(1, 5) if f"K{n}" in plane}
    if not shifted:
        return {**references, "K1": 1.0, "K2": 0.0, "K3": 0.0, "K4": 0.0}
    if len(curve) < 4:
        raise GroundrollError(
            "Envelope.tail_load needs the tail wheel's stiffness over load: give tail_wheel_K1"
            f" to tail_wheel_K4 to aircraft {plane.name}, or leave tail_load at 1"
        )
    static = plane.replace(f=None, F_tail_load=None)
    if "F_tail_load" not in static or not static["F_tail_load"] > 0:
        raise GroundrollError(
            f"the tail wheel of aircraft {plane.name} carries nothing today, so its stiffness of"
            f" {references['Ct_0']:g} N/rad belongs to no load and Envelope.tail_load cannot"
            " scale it: leave tail_load at 1, or let the stiffness follow (Ct=None,"
            " stiffness='following')"
        )
    return {**references, **curve, "F_0": float(static["F_tail_load"])}


def _given(plane: Aircraft, has_tail_wheel: bool) -> list[str]:
    """The stiffnesses that are given, so that they cannot follow the gear."""
    stiffnesses = ("C_alpha", "Ct") if has_tail_wheel else ("C_alpha",)
    return [s for s in stiffnesses if s in plane.given]


def _require_following(plane: Aircraft, has_tail_wheel: bool) -> None:
    """Stiffnesses can't both be given and follow."""
    for s in _given(plane, has_tail_wheel):
        name = QUANTITIES[s].name
        raise GroundrollError(
            f"{name} ({s}) of aircraft {plane.name} is given, so it cannot follow the gear:"
            f" replace({s}=None), --set {s}= on the command line, or stiffness='constant'"
        )
