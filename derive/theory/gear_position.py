"""Where the main gear may stand: the positions at which det A changes sign.

CG and tail stay where they are (b is fixed) and the main gear moves (a). Either the stiffnesses
are constants, as in the thesis, or both follow the axle loads, which follow the gear.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from groundroll.derive.core.body import Izz, m
from groundroll.derive.core.equation import Chain, Equation, expand
from groundroll.derive.core.linearise import state_space
from groundroll.derive.core.quantity import Quantity
from groundroll.derive.models.linear import linear
from groundroll.derive.parts.quantities import C_alpha, Ct, L, a, b, f, u

from . import closed_forms as closed
from .closed_forms import s
from .loads import static_loads
from .margins import root_of_stiffness

h_0 = Quantity("h_0", "h_0", "N^2 m^2", "constant term of the position polynomial")
h_1 = Quantity("h_1", "h_1", "N^2 m", "linear term of the position polynomial")
h_2 = Quantity("h_2", "h_2", "N^2", "quadratic term of the position polynomial")
_h_root = Quantity("h_root", "h_root", "N^2 m", "the positive combination of its roots", r"\hat{h}")
a_lost = Quantity(
    "a_lost", "gear_arm_lost", "m", "gear ahead of the CG: unstable from here", r"a_{\mathrm{lost}}"
)
a_regained = Quantity("a_regained", "gear_arm_regained", "m", "to here", r"a_{\mathrm{regained}}")
w_0 = Quantity("w_0", "w_0", "kg m/s", "constant term of the envelope polynomial")
w_1 = Quantity("w_1", "w_1", "kg m^(1/2)/s", "linear term of the envelope polynomial")
w_2 = Quantity("w_2", "w_2", "kg/s", "quadratic term of the envelope polynomial")
_root_a = Quantity("root_a", "root_a", "m^(1/2)", "its smaller root, of sqrt(a)", r"\hat{a}")
a_always = Quantity(
    "a_always",
    "gear_arm_always",
    "m",
    "gear ahead of the CG: stable at every speed up to here; NaN: anywhere",
    r"a_{\mathrm{always}}",
)
_s_touch = Quantity("s_touch", "s_touch", "m^2/s^2", "its square", r"s_{\mathrm{touch}}")
tail_fraction = Quantity(
    "tail_fraction", "tail_load_fraction", "1", "share of the weight on the tail wheel", r"\phi"
)
gear_arm = Quantity(
    "a_loaded", "gear_arm_of_load", "m", "gear ahead of the CG at that share", r"a_\phi"
)
u_touch = Quantity(
    "u_touch", "touching_speed", "m/s", "speed at which det A is least", r"u_{\mathrm{touch}}"
)


def _coefficients(name: str, latex: str, unit: str, count: int) -> tuple[Quantity, ...]:
    return tuple(
        Quantity(
            f"{name}_{n}",
            f"{name}_{n}",
            unit,
            f"coefficient of tail_load_fraction^{n}",
            f"{latex}{n}}}",
        )
        for n in range(count)
    )


#: det A at a speed, up to a positive factor: of c_2 s^2 + c_1 s + c_0, each a polynomial in phi.
_BY_SPEED = (
    _coefficients("c0", "c_{0,", "N^2 m/kg", 6),
    _coefficients("c1", "c_{1,", "N", 6),
    _coefficients("c2", "c_{2,", "kg/m", 2),
)
#: c_2 s^2 + c_1 s + c_0 at a speed.
POSITION = _coefficients("p", "p_{", "N^2 m/kg", 6)
#: c_1^2 - 4 c_0 c_2, zero where the two speeds of det A = 0 meet.
ENVELOPE = _coefficients("g", "g_{", "N^2", 11)


def _named(names: Sequence[Quantity], values: Sequence[sp.Expr], source: str) -> Chain:
    return tuple(Equation(name, e, source) for name, e in zip(names, values, strict=True))


def fixed_stiffness() -> Chain:
    """Gear positions at which det A = 0 at a speed, the stiffnesses being constants.

    The product of the roots and, where they are real, their sum are positive: the gear loses
    stability only ahead of the CG. The form with h_root loses no digits and holds without a tail.
    """
    A, *_ = state_space(linear())
    numerator = sp.numer(sp.together(closed.in_stiffnesses(A.det())))
    polynomial = sp.Poly(sp.expand(numerator), a)
    coefficients = [sp.factor(c) for c in reversed(polynomial.all_coeffs())]
    return (
        *_named((h_0, h_1, h_2), coefficients, "from det A = 0"),
        Equation(_h_root, -h_1 + sp.sqrt(h_1**2 - 4 * h_0 * h_2), "from det A = 0"),
        Equation(a_lost, 2 * h_0 / _h_root, "from det A = 0"),
        Equation(a_regained, _h_root / (2 * h_2), "from det A = 0"),
    )


def fixed_stiffness_envelope() -> Chain:
    """The least of `a_lost` over every speed, and the speed at which it occurs."""
    root, ahead = sp.Symbol("root", positive=True), sp.Symbol("ahead", positive=True)
    reserve = (sp.sqrt(Ct) - root_of_stiffness(ahead).subs(ahead, root**2)) * sp.sqrt(b * m)
    polynomial = sp.Poly(sp.expand(sp.simplify(reserve)), root)
    coefficients = [sp.simplify(c) for c in reversed(polynomial.all_coeffs())]
    source = "from q_1 + 2 sqrt(q_0 q_2) = 0"
    q_0, _, q_2 = (e.rhs for e in closed.speed_polynomial())
    touching = sp.powdenest(sp.sqrt(q_0 / q_2).subs(a, ahead), force=True).subs(ahead, a_always)
    return (
        *_named((w_0, w_1, w_2), coefficients, source),
        Equation(_root_a, 2 * w_0 / (-w_1 + sp.sqrt(w_1**2 - 4 * w_0 * w_2)), source),
        Equation(a_always, _root_a**2, source),
        Equation(_s_touch, touching, "s = sqrt(q_0/q_2)"),
        Equation(u_touch, sp.sqrt(_s_touch), "s = sqrt(q_0/q_2)"),
    )


def following_loads() -> Chain:
    """Polynomials in the share of the weight on the tail wheel, the stiffnesses following it.

    At the share phi the gear stands at a = b phi/(1 - phi). det A times 2 Izz u^2 (1 - phi)/b is
    a polynomial in phi and s = u^2.
    """
    polynomial = _loaded_determinant()
    terms = [
        Equation(c, polynomial.coeff_monomial(tail_fraction**n * s**power), "App. A.6")
        for power, group in enumerate(_BY_SPEED)
        for n, c in enumerate(group)
    ]
    return tuple(Equation(e.lhs, sp.factor(e.rhs), e.source) for e in terms)


def _loaded_determinant() -> sp.Poly:
    A, *_ = state_space(linear())
    chain = [e for e in static_loads() if e.lhs not in (a, b, L, f)]
    loaded = {q: expand(q, chain).subs(f, 1 - tail_fraction) for q in (C_alpha, Ct)}
    determinant = A.det().subs(loaded).subs(a, _arm()).subs(closed.tail_area())
    scaled = determinant.subs(u, sp.sqrt(s)) * 2 * Izz * s * (1 - tail_fraction) / b
    return sp.Poly(sp.expand(sp.cancel(sp.together(scaled))), tail_fraction, s)


def _arm() -> sp.Expr:
    """a from f = b/L = 1 - phi."""
    share = next(e.rhs for e in static_loads() if e.lhs is f).subs(L, a + b)
    (arm,) = sp.solve(share - (1 - tail_fraction), a)
    return sp.factor(arm)


def position_polynomial() -> Chain:
    """The polynomial in phi at a speed."""
    c0, c1, c2 = (_padded(group, len(POSITION)) for group in _BY_SPEED)
    values = (c0[n] + c1[n] * u**2 + c2[n] * u**4 for n in range(len(POSITION)))
    return _named(POSITION, list(values), "from det A = 0")


def envelope_polynomial() -> Chain:
    """c_1^2 - 4 c_0 c_2 as a polynomial in phi, product by product."""
    c0, c1, c2 = (_padded(group, len(ENVELOPE)) for group in _BY_SPEED)

    def product(left: Sequence[sp.Expr], right: Sequence[sp.Expr], power: int) -> sp.Expr:
        return sum((left[n] * right[power - n] for n in range(power + 1)), sp.Integer(0))

    return tuple(
        Equation(g, product(c1, c1, n) - 4 * product(c0, c2, n), "from det A = 0")
        for n, g in enumerate(ENVELOPE)
    )


def _padded(group: Sequence[Quantity], size: int) -> list[sp.Expr]:
    return [*group, *(sp.Integer(0) for _ in range(size - len(group)))]


def at_tail_fraction() -> Chain:
    """Gear position at a share of the weight on the tail wheel, and the weakest speed there."""
    c1, c2 = (
        sum((c * tail_fraction**n for n, c in enumerate(group)), sp.Integer(0))
        for group in _BY_SPEED[1:]
    )
    return (
        Equation(gear_arm, _arm(), "App. A.6"),
        Equation(u_touch, sp.sqrt(-c1 / (2 * c2)), "from d(det A)/ds = 0"),
    )
