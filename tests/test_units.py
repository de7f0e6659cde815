"""Dimensions: checked node by node in the derivation, before anything is computed."""

import re

import pytest
import sympy as sp

from groundroll.derive.core.body import Body, m
from groundroll.derive.core.equation import Equation
from groundroll.derive.core.frames import i, j, r, v
from groundroll.derive.core.model import Model
from groundroll.derive.core.part import Force, Part
from groundroll.derive.core.quantity import Quantity
from groundroll.derive.core.unit import BASE, UnitError, unit, unit_of
from groundroll.derive.parts.quantities import F_disturbance, a, u
from groundroll.derive.parts.thesis import alpha, disturbance
from groundroll.derive.parts.tires import F_y
from groundroll.generated import PACKS, Pack

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


@pytest.mark.parametrize("pack", PACKS.values(), ids=PACKS)
def test_every_generated_unit_can_be_read(pack: Pack):
    for quantity in pack.quantities.values():
        assert unit(quantity.unit).free_symbols <= {kg, metre, second}
