"""Dimensions in the numbers: another kilogram, metre and second change nothing but the digits.

Constants with a unit are changed along, which only the equations can: what is generated of them
holds their numbers, and is compared with them by other tests.
"""

from collections.abc import Callable, Mapping, Sequence
from functools import cache

import numpy as np
import pytest
import sympy as sp
from every import NAMES, OF_SCALARS, Array, case, evaluated
from hypothesis import given, settings
from hypothesis import strategies as st
from oracles import parameters, state, values

from groundroll.derive.core.quantity import Constant
from groundroll.derive.core.unit import BASE, unit
from groundroll.derive.emit.casadi_source import FunctionSpec
from groundroll.derive.emit.catalogue import packs
from groundroll.generated import PACKS

kg, metre, second = (BASE[name] for name in ("kg", "m", "s"))

Scale = tuple[tuple[sp.Symbol, float], ...]
#: Powers of two scale without rounding, but under square roots.
SCALES = st.tuples(*[st.sampled_from([0.125, 0.25, 0.5, 2.0, 4.0, 8.0])] * 3).map(
    lambda factors: tuple(zip((kg, metre, second), factors, strict=True))
)
SI: Scale = ((kg, 1.0), (metre, 1.0), (second, 1.0))
#: From numbers in some units, and the units of constants, to results.
Function = Callable[[Sequence[Array], Scale], Sequence[Array]]


@cache
def factor(text: str, scale: Scale) -> float:
    return float(unit(text).subs(scale))


def factors(units: object, scale: Scale) -> Array:
    return np.vectorize(lambda text: factor(text, scale), otypes=[float])(np.array(units, object))


def assert_same_physics(
    function: Function,
    arguments: Sequence[Array],
    units_in: Sequence[object],
    units_out: Mapping[str, object],
    scale: Scale,
    tolerance: float = 0.0,
) -> None:
    """A function gives the same results in two systems of units."""
    scaled = [x * factors(u, scale) for u, x in zip(units_in, arguments, strict=True)]
    here, there = function(arguments, SI), function(scaled, scale)
    for (slot, units), before, after in zip(units_out.items(), here, there, strict=True):
        before = np.array(before, float)
        back = np.array(after, float) / factors(units, scale).reshape(before.shape)
        size = np.abs(before).max(initial=0) if tolerance else 0.0
        np.testing.assert_allclose(
            back, before, rtol=1e-14 + tolerance, atol=tolerance * size, err_msg=slot
        )


# --- Functions of scalars ---------------------------------------------------------------------


@cache
def specs() -> dict[str, tuple[str, FunctionSpec]]:
    """Every function of named scalars, and its pack."""
    return {
        spec.name: (pack.name, spec)
        for pack in packs()
        for module in pack.all_modules
        for spec in module.functions
        if all(argument.is_scalar for argument in spec.arguments)
    }


def of_scalars(pack: str, spec: FunctionSpec) -> Function:
    """As it was generated, or, if it holds constants with units, as SymPy prints it."""
    if not any(e.rhs.has(Constant) for e in spec.chain):
        generated = PACKS[pack].compiled(spec.casadi_name)
        return lambda arguments, scale: generated.call(list(arguments))
    inner = [argument.quantities[0] for argument in spec.arguments]
    results = [x for result in spec.results for x in result.value]

    def printed(arguments: Sequence[Array], scale: Scale) -> Sequence[Array]:
        values = evaluated(
            inner, spec.chain, results, constant=lambda c: c.value * factor(c.unit, scale)
        )
        return list(map(np.asarray, values(*(float(np.ravel(x)[0]) for x in arguments))))

    return printed


#: What is printed from a chain; bounds follow from the graph of another function.
PRINTED = [name for name in OF_SCALARS if not name.endswith("_bounds")]


@pytest.mark.parametrize("name", PRINTED)
@settings(max_examples=10)
@given(data=st.data())
def test_closed_forms_do_not_depend_on_the_units(name: str, data: st.DataObject):
    """To the last bit, but for a slope near an extremum that cancels."""
    pack, spec = specs()[name]
    names = [argument.name for argument in spec.arguments]
    units = [[argument.quantities[0].unit] for argument in spec.arguments]
    results = {r.name: [x.unit for x in r.value] for r in spec.results}
    point = [data.draw(values([symbol])) for symbol in names]
    tolerance = 1e-11 if name == "C3_follows" else 0.0
    function = of_scalars(pack, spec)
    assert_same_physics(function, point, units, results, data.draw(SCALES), tolerance)


# --- Functions of models ----------------------------------------------------------------------


def units_of(name: str, slot: str, units: Mapping[str, str]) -> object:
    """Units of an argument or a result of a function of a model, entry by entry."""
    pack = case(name).pack
    vectors = {
        "x": [units[s] for s in pack.states],
        "f": [f"({units[s]})/s" for s in pack.states],
        "u": [units[s] for s in pack.inputs],
        "p": [units[s] for s in pack.parameters],
        "g": [units[s] for s in pack.outputs],
        "h": ["s"],
        "place": [["m"] * 3 for _ in pack.places],
        "force": [["N"] * 3 for _ in pack.places],
    }
    slot = {"x0": "x", "xf": "x", "xdot": "f", "y": "g"}.get(slot, slot)
    if slot in vectors:
        return vectors[slot]
    return [[f"({row})/({column})" for column in vectors[slot[1]]] for row in vectors[slot[0]]]


def units_in(name: str) -> dict[str, str]:
    return {s: q.unit for s, q in case(name).pack.quantities.items()}


def has_constants(name: str) -> bool:
    return any(e.rhs.has(Constant) for e in case(name).derived.chain)


@cache
def printed(name: str, scale: Scale) -> Callable[..., Sequence[float]]:
    """Rates and outputs as SymPy prints them, with the constants that they hold in these units."""
    derived = case(name).derived
    return evaluated(
        [q for group in case(name).groups.values() for q in group],
        derived.chain,
        [*derived.rates, *derived.outputs],
        constant=lambda c: c.value * factor(c.unit, scale),
    )


@pytest.mark.parametrize("name", NAMES)
@settings(max_examples=3)
@given(data=st.data())
def test_the_equations_of_a_model_do_not_depend_on_the_units(name: str, data: st.DataObject):
    model = case(name)

    def function(arguments: Sequence[Array], scale: Scale) -> Sequence[Array]:
        f = printed(name, scale)
        return [np.array(f(*(x for block in arguments for x in block)), float)]

    units = units_in(name)
    slots = [units_of(name, key, units) for key in "xup"]
    results = {"rates and outputs": [*units_of(name, "f", units), *units_of(name, "g", units)]}  # type: ignore[misc]
    point = data.draw(model.points())
    assert_same_physics(function, point, slots, results, data.draw(SCALES), 1e-13)


#: Models in which constants stand, which what is generated of them holds in SI.
WITH_CONSTANTS = {"rollout", "landing_roll", "landing_roll_flown"} & set(NAMES)
PURE = [name for name in NAMES if name not in WITH_CONSTANTS]
GENERATED = ("rhs", "outputs", "jacobians", "places", "rk4", "rk45")


@pytest.mark.parametrize("function", GENERATED)
@pytest.mark.parametrize("name", PURE)
@settings(max_examples=2)
@given(data=st.data())
def test_functions_of_a_model_do_not_depend_on_the_units(
    name: str, function: str, data: st.DataObject
):
    """To the last bit, but for the tolerances of adaptive steps."""
    model, units = case(name), units_in(name)
    compiled = model.pack.function(function)
    point = [*data.draw(model.points()), np.array([0.1])][: compiled.n_in()]
    slots = [units_of(name, slot, units) for slot in compiled.name_in()]
    results = {slot: units_of(name, slot, units) for slot in compiled.name_out()}
    tolerance = 1e-9 if function == "rk45" else 0.0
    assert_same_physics(
        lambda arguments, scale: compiled.call(list(arguments)),
        point,
        slots,
        results,
        data.draw(SCALES),
        tolerance,
    )


def test_no_other_model_is_left_out():
    assert {name for name in NAMES if has_constants(name)} == WITH_CONSTANTS


@pytest.mark.parametrize("symbol", ["m", "Izz", "a", "u", "rho", "Ct", "C3", "C5"])
def test_numbers_betray_a_wrong_unit(symbol: str):
    """The checks above can fail."""
    units = units_in("nonlinear")
    wrong = {**units, symbol: f"({units[symbol]}) m"}
    point = [state(v=1.0, r=0.1), np.zeros(1), parameters("nonlinear")]
    scale = ((kg, 1.0), (metre, 2.0), (second, 1.0))
    rhs = case("nonlinear").pack.function("rhs")

    def check(units: dict[str, str]) -> None:
        slots = [units_of("nonlinear", key, units) for key in "xup"]
        results = {"xdot": units_of("nonlinear", "f", units)}
        assert_same_physics(lambda arguments, _: rhs.call(arguments), point, slots, results, scale)

    check(units)
    with pytest.raises(AssertionError, match="xdot"):
        check(wrong)
