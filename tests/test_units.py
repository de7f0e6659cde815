"""Dimensions: checked node by node in the derivation, and in the numbers that come out."""

import re
from dataclasses import replace
from functools import cache

import casadi as ca
import numpy as np
import pytest
import sympy as sp
from hypothesis import find, given, settings
from hypothesis import strategies as st
from oracles import Array, is_rolling, parameters, rolling, state, values

from groundroll import generated
from groundroll.derive.core.body import Body, m
from groundroll.derive.core.equation import Equation
from groundroll.derive.core.frames import i, j, r, v
from groundroll.derive.core.model import Derivation, Model
from groundroll.derive.core.part import Force, Part
from groundroll.derive.core.quantity import Constant, Quantity
from groundroll.derive.core.unit import BASE, UnitError, unit, unit_of
from groundroll.derive.emit.catalogue import model_module
from groundroll.derive.models.landing_roll import landing_roll
from groundroll.derive.models.rollout import rollout
from groundroll.derive.parts.quantities import F_disturbance, a, u
from groundroll.derive.parts.thesis import alpha, disturbance
from groundroll.derive.parts.tires import F_y
from groundroll.names import FUNCTIONS, QUANTITIES

kg, metre, second = (BASE[name] for name in ("kg", "m", "s"))
newton = kg * metre / second**2
F = Quantity("F", "force", "N", "a force")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("1", 1),
        ("rad", 1),
        ("kg m^2", kg * metre**2),
        ("N/rad", newton),
        ("1/(rad N)", 1 / newton),
        ("1/(rad N^3)", newton**-3),
        ("N kg m", newton * kg * metre),
        ("kg/m^3", kg / metre**3),
        ("(m/s)/(kg m^2)", 1 / (second * kg * metre)),
    ],
)
def test_a_unit_is_read_as_a_monomial(text: str, expected: sp.Expr):
    assert unit(text) == expected


@pytest.mark.parametrize("text", ["furlong", "kgg", "deg", "N m s^-2 x", "S", "", "kg +"])
def test_an_unknown_unit_is_refused(text: str):
    with pytest.raises(UnitError, match=re.escape(repr(text))):
        unit(text)


@pytest.mark.parametrize(
    ("expr", "expected"),
    [
        (m * u**2 / (2 * a), newton),
        (sp.sqrt(u**2 + v**2), metre / second),
        (sp.atan((v + a * r) / u), 1),
        (sp.Max(v, 0), metre / second),
        (sp.Abs(a), metre),
        (sp.Piecewise((v, r > 0), (u, True)), metre / second),
        (sp.Piecewise((v, r > 0), (sp.nan, True)), metre / second),
        (sp.Rational(2, 3), 1),
    ],
)
def test_unit_of_an_expression(expr: sp.Expr, expected: sp.Expr):
    assert unit_of(expr) == expected


@pytest.mark.parametrize(
    ("expr", "complaint"),
    [
        (v + r, "r has unit 1/s"),
        (m * (v + a), "a has unit m"),
        (sp.atan(v), "argument of atan in atan(v) has unit m/s"),
        (sp.sin(a / u), "argument of sin in sin(a/u) has unit s"),
        (u ** (r), "exponent of u**r has unit 1/s"),
        (sp.Max(v, a), "v has unit m/s"),
        (sp.Piecewise((v, r > 0), (a, True)), "a has unit m"),
        (sp.atan(alpha * sp.sin(sp.cos(F / m) * alpha)), "argument of cos in cos(F/m)"),
    ],
)
def test_a_wrong_term_is_named(expr: sp.Expr, complaint: str):
    with pytest.raises(UnitError, match=re.escape(complaint)):
        unit_of(expr)


def test_a_sum_names_the_term_that_differs():
    with pytest.raises(UnitError, match=r"-r\*u has unit m/s\*\*2"):
        Equation(F, F_disturbance - r * u, "Eq. 4.36")


def test_both_sides_of_an_equation_must_agree():
    with pytest.raises(UnitError, match=r"F_y \(Eq. 3.1\): the right side has unit 1, the left"):
        Equation(F_y, alpha, "Eq. 3.1")


def test_zero_has_every_unit():
    assert Equation(F, sp.Integer(0), "no force").rhs == 0


LEVEL = Body(speed="held", stands="level")


def test_a_part_with_a_wrong_force_law_cannot_be_assembled():
    """The weight forgotten in F = C_c alpha F_z: a coefficient where a stiffness belongs."""
    C_c = Quantity("C_c", "cornering_coefficient", "1/rad", "stiffness over load")

    def law(felt: object) -> Force:
        return Force(-F * j, chain=(Equation(F, C_c * alpha, "typing error"),))

    with pytest.raises(UnitError, match=r"F \(typing error\)"):
        Model("wrong", "", LEVEL, [Part("wrong", a * i, law)]).derive()


def test_a_position_that_is_a_number_is_caught():
    with pytest.raises(UnitError, match=r"position of beside along x: .* unit 1, the left side m"):
        Part("beside", 2 * i, disturbance, asks=(F_disturbance,))


@pytest.mark.parametrize(
    ("force", "complaint"),
    [
        (Force(a * F_disturbance * j), "force of wrong along y: the right side has unit kg*m**2"),
        (Force(couple=F_disturbance * j), "couple of wrong along y: the right side has unit kg*m"),
        (Force(rates={v: F_disturbance}), "rate of v of wrong: the right side has unit kg*m"),
    ],
)
def test_what_a_law_returns_has_its_unit(force: Force, complaint: str):
    part = Part("wrong", a * i, lambda felt: force, asks=(F_disturbance,))
    with pytest.raises(UnitError, match=re.escape(complaint)):
        Model("wrong", "", LEVEL, [part]).derive()


@pytest.mark.parametrize("symbol", QUANTITIES)
def test_every_generated_unit_can_be_read(symbol: str):
    assert unit(QUANTITIES[symbol].unit).free_symbols <= {kg, metre, second}


# --- In the numbers -------------------------------------------------------------------------

Scale = tuple[tuple[sp.Symbol, float], ...]
#: Powers of two scale without rounding.
SCALES = st.tuples(*[st.sampled_from([0.125, 0.25, 0.5, 2.0, 4.0, 8.0])] * 3).map(
    lambda factors: tuple(zip((kg, metre, second), factors, strict=True))
)
UNITS = {symbol: quantity.unit for symbol, quantity in QUANTITIES.items()}


@cache
def factor(text: str, scale: Scale) -> float:
    return float(unit(text).subs(scale))


def model_of(function: str) -> generated.Pack | None:
    """The model whose vectors a generated function takes; None if it takes scalars."""
    takes_vectors = generated.load(function).name_in(0) in ("x", "x0")
    return generated.pack_of(function) if takes_vectors else None


def symbols_in(function: str, argument: str) -> list[str]:
    """What an argument of a generated function holds, entry by entry."""
    model = model_of(function)
    if model is None or argument == "h":
        return [argument]
    return list({"x": model.states, "u": model.inputs, "p": model.parameters}[argument[0]])


def units_in(function: str, slot: str, units: dict[str, str]) -> list[str] | list[list[str]]:
    """Units of an argument or a result of a generated function, entry by entry."""
    model = model_of(function)
    if model is None:
        return [units[slot]]
    states = [units[symbol] for symbol in model.states]
    vectors = {
        "x": states,
        "x0": states,
        "xf": states,
        "xdot": [f"({text})/s" for text in states],
        "u": [units[symbol] for symbol in model.inputs],
        "p": [units[symbol] for symbol in model.parameters],
        "y": [units[symbol] for symbol in model.outputs],
        "h": ["s"],
        "place": [["m"] * 3 for _ in model.places],
        "force": [["N"] * 3 for _ in model.places],
    }
    if slot in vectors:
        return vectors[slot]
    rows, columns = vectors[{"f": "xdot", "g": "y"}[slot[0]]], vectors[slot[1]]
    return [[f"({row})/({column})" for column in columns] for row in rows]


def assert_same_physics(
    name: str, arguments: list[Array], scale: Scale, units: dict[str, str], tolerance: float = 0.0
) -> None:
    """A function gives the same results in two systems of units."""

    def factors(slot: str) -> Array:
        return np.vectorize(lambda text: factor(text, scale))(units_in(name, slot, units))

    function = generated.load(name)
    scaled = [x * factors(slot) for slot, x in zip(function.name_in(), arguments, strict=True)]
    here, there = (function.call(point) for point in (arguments, scaled))
    for slot, before, after in zip(function.name_out(), here, there, strict=True):
        back = np.array(after) / factors(slot).reshape(after.shape)
        before = np.array(before)
        size = np.abs(before).max(initial=0) if tolerance else 0.0
        np.testing.assert_allclose(
            back, before, rtol=1e-14 + tolerance, atol=tolerance * size, err_msg=slot
        )


#: The formulas of what rolls hold numbers with units of their own: see below for these.
SCALED = [name for name in FUNCTIONS if not is_rolling(generated.pack_of(name))]


@pytest.mark.parametrize("name", SCALED)
@settings(max_examples=10)
@given(data=st.data())
def test_numbers_do_not_depend_on_the_units_of_mass_length_and_time(name: str, data: st.DataObject):
    """To the last bit, but for adaptive steps, and for a slope near an extremum that cancels."""
    arguments = generated.load(name).name_in()
    point = [data.draw(values(symbols_in(name, argument))) for argument in arguments]
    tolerance = 1e-9 if name.endswith("rk45") else 1e-11 if name == "C3_follows" else 0.0
    assert_same_physics(name, point, data.draw(SCALES), UNITS, tolerance)


def functions_in(model: Derivation, scale: Scale) -> dict[str, ca.Function]:
    """Right-hand side and outputs of a model, its constants in other units."""

    def scaled(expr: sp.Expr) -> sp.Expr:
        constants = expr.atoms(Constant)
        other = {c: Constant(c.value * factor(c.unit, scale), c.unit) for c in constants}
        return expr.xreplace(other)

    chain = tuple(replace(e, rhs=scaled(e.rhs)) for e in model.chain)
    changed = model.replace(chain=chain, rates=tuple(map(scaled, model.rates)))
    found: dict[str, object] = {}
    head = "from functools import cache\nimport casadi as ca\n"
    for spec in model_module(changed).functions[:2]:
        exec(head + spec.source(), found)
    return {name: found[name]() for name in ("rhs", "outputs")}  # type: ignore[operator]


@pytest.mark.parametrize("model", [rollout(), landing_roll()], ids=lambda model: model.name)
@settings(max_examples=10)
@given(data=st.data())
def test_a_rolling_model_does_not_depend_on_the_units(model: Derivation, data: st.DataObject):
    """Numbers with units in its formulas are in the other units too."""
    pack, scale = generated.PACKS[model.name], data.draw(SCALES)
    here = functions_in(model, tuple((q, 1.0) for q, _ in scale))
    there = functions_in(model, scale)
    point = [data.draw(rolling(pack, argument)) for argument in "xup"]
    groups = (model.states, model.inputs, model.parameters)
    factors = [np.array([factor(q.unit, scale) for q in group]) for group in groups]
    other = [values * scaled for values, scaled in zip(point, factors, strict=True)]
    units = {
        "rhs": [f"({q.unit})/s" for q in model.states],
        "outputs": [q.unit for q in model.outputs],
    }
    for name, unit_texts in units.items():
        before = np.array(here[name](*point)).ravel()
        back = np.array(there[name](*other)).ravel()
        back = back / np.array([factor(text, scale) for text in unit_texts])
        assert np.isfinite(before).all()
        # forces of thousands of newtons cancel in their sums
        np.testing.assert_allclose(back, before, rtol=1e-9, atol=1e-8, err_msg=name)


def test_a_wrong_unit_of_a_constant_would_be_seen():
    model, scale = landing_roll(), ((kg, 1.0), (metre, 2.0), (second, 1.0))
    wrong = model.replace(
        chain=tuple(
            replace(e, rhs=e.rhs.xreplace({c: 2 * c for c in e.rhs.atoms(Constant)}))
            for e in model.chain
        )
    )
    point = [find(rolling(generated.PACKS["landing_roll"], a), lambda _: True) for a in "xup"]
    same = [np.array(functions_in(m, scale)["rhs"](*point)) for m in (model, wrong)]
    with pytest.raises(AssertionError):  # at the tolerance above
        np.testing.assert_allclose(same[1], same[0], rtol=1e-9, atol=1e-8)


@pytest.mark.parametrize("symbol", ["m", "Izz", "a", "u", "rho", "Ct", "C3", "C5"])
def test_numbers_betray_a_wrong_unit(symbol: str):
    """The check above can fail."""
    wrong = {**UNITS, symbol: f"({UNITS[symbol]}) m"}
    point = [state(v=1.0, r=0.1), np.zeros(1), parameters("nonlinear")]
    scale = ((kg, 1.0), (metre, 2.0), (second, 1.0))
    assert_same_physics("nonlinear_rhs", point, scale, UNITS)
    with pytest.raises(AssertionError, match="xdot"):
        assert_same_physics("nonlinear_rhs", point, scale, wrong)
