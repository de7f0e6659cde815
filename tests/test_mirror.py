"""Every model in the mirror: what turns right there turns left here, and left wheels are right."""

import re

import numpy as np
import pytest
from every import NAMES, Array, Case, case
from oracles import call

#: Full names, without the name of a part, of what changes sides in the mirror; all else stays.
SIDEWAYS = {
    *("lateral_velocity", "roll_rate", "yaw_rate", "offset", "roll", "heading"),
    *("lateral_displacement", "rotation", "swivel_angle", "swivel_rate", "late_slip"),
    *("steering", "pedal", "rudder", "aileron", "crosswind", "disturbance", "push"),
    *("main_gear_slip_angle", "tail_angle", "sideslip_angle", "slip", "air_sideslip"),
    *("main_gear_force", "tail_force", "tail_wheel_force", "wheel_side_force"),
    *("side_force", "air_side_force", "incidence_fin", "lift_coefficient_fin", "lift_fin"),
    *("roll_moment", "yaw_moment", "air_roll_moment", "air_yaw_moment"),
    *("lateral_acceleration", "holding_side_force", "holding_roll_couple", "holding_yaw_couple"),
    *("lane", "turned_wheel", "articulation", "articulation_rate", "wall_force", "load_side"),
}
_OTHER = {"left": "right", "right": "left"}

every = pytest.mark.parametrize("name", NAMES)


def mirror(model: Case, symbols: tuple[str, ...]) -> tuple[list[int], Array]:
    """Where each entry of a vector stands in the mirror, and with which sign."""
    places = {part.name for part in model.pack.places}
    names = [model.pack.quantities[s].name for s in symbols]
    swapped = [re.sub("left|right", lambda side: _OTHER[side[0]], s) for s in symbols]
    bare = [name.removesuffix(f"_{p}") for name in names for p in [_part(name, places)]]
    signs = [-1 if {name, base} & SIDEWAYS else 1 for name, base in zip(names, bare, strict=True)]
    return [symbols.index(s) for s in swapped], np.array(signs)


def _part(name: str, places: set[str]) -> str:
    return next((p for p in sorted(places, key=len, reverse=True) if name.endswith(f"_{p}")), "-")


def mirrored(model: Case, symbols: tuple[str, ...], values: Array) -> Array:
    order, signs = mirror(model, symbols)
    return signs * np.asarray(values)[order]


@every
@pytest.mark.parametrize("function", ["rhs", "outputs"])
def test_a_model_moves_in_the_mirror_as_outside(name: str, function: str):
    model = case(name)
    groups = (model.pack.states, model.pack.inputs, model.pack.parameters)
    shown = model.pack.states if function == "rhs" else model.pack.outputs
    f = model.pack.function(function)
    for point in model.some(20, seed=3):
        inside = [mirrored(model, g, values) for g, values in zip(groups, point, strict=True)]
        here, there = np.atleast_1d(call(f, *point)), np.atleast_1d(call(f, *inside))
        size = 1e-12 * np.abs(here).max()
        np.testing.assert_allclose(there, mirrored(model, shown, here), rtol=1e-10, atol=size)


@every
def test_something_changes_sides(name: str):
    model = case(name)
    for symbols in (model.pack.states, model.pack.outputs):
        assert set(mirror(model, symbols)[1]) == {-1, 1}


@every
def test_it_makes_no_difference_how_far_along_the_runway(name: str):
    model = case(name)
    (x, u, p), f = model.some(1, seed=3)[0], model.pack.function("rhs")
    along = 40.0 * (np.array(model.pack.states) == "X")
    np.testing.assert_array_equal(call(f, x + along, u, p), call(f, x, u, p))
