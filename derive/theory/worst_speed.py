"""At which speed the linear model is nearest to instability."""

from __future__ import annotations

import sympy as sp

from groundroll.derive.core.body import Izz, m
from groundroll.derive.core.equation import Chain, Equation
from groundroll.derive.core.linearise import state_space
from groundroll.derive.core.quantity import Quantity
from groundroll.derive.models.linear import linear
from groundroll.derive.parts.quantities import C_alpha, Ct, u

from . import closed_forms as closed
from .closed_forms import C_f, k, q_0, q_1, q_2, s

s_weakest = Quantity("s_weakest", "s_weakest", "m^2/s^2", "its square", r"s_{\mathrm{weak}}")
u_weakest = Quantity(
    "u_weakest", "weakest_speed", "m/s", "speed at which det A is least", r"u_{\mathrm{weak}}"
)
det_weakest = Quantity(
    "det_weakest", "least_determinant", "1/s^2", "det A there", r"\det A_{\mathrm{weak}}"
)
_t_slow = Quantity("t_slow", "t_slow", "m/s^2", "tr A = -(t_slow/u + t_fast u)", "t_0")
_t_fast = Quantity("t_fast", "t_fast", "1/m", "tr A = -(t_slow/u + t_fast u)", "t_1")
u_trace = Quantity(
    "u_trace", "least_damping_speed", "m/s", "speed at which -tr A is least", r"u_{\mathrm{tr}}"
)
#: Of a quartic in s = u^2 whose roots hold every speed where a real eigenvalue is stationary.
STATIONARY = tuple(
    Quantity(
        f"e_{n}",
        f"e_{n}",
        f"N^4 m^{4 - 2 * n} s^{2 * n}",
        f"coefficient of s^{n}: a real eigenvalue is stationary at a root",
    )
    for n in range(5)
)


def weakest_speed() -> Chain:
    """Where q_2 s + q_1 + q_0/s, which is m Izz det A, is least: at q_2 s = q_0/s.

    With a window of instability it is the geometric mean of its ends.
    """
    return (
        Equation(s_weakest, sp.sqrt(q_0 / q_2), "from d(det A)/ds = 0"),
        Equation(u_weakest, sp.sqrt(s_weakest), "from d(det A)/ds = 0"),
        Equation(det_weakest, (q_1 + 2 * sp.sqrt(q_0 * q_2)) / (m * Izz), "from d(det A)/ds = 0"),
    )


def stationary_decay() -> Chain:
    """Speeds at which the decay rate may be least, as roots of polynomials in s = u^2.

    On a real eigenvalue, lambda^2 - tr A lambda + det A = 0 and d(lambda)/du = 0 give
    lambda = (d det A/du) / (d tr A/du); put back, that is a quartic in s. Complex eigenvalues
    have the decay rate -tr A / 2, least where t_slow/u = t_fast u.
    """
    A, *_ = state_space(linear())
    tail = {C_alpha: C_f / 2, **closed.tail_area()}
    tr = sp.expand(-A.trace().subs(tail) * u)
    slow, fast = (sp.collect(tr.coeff(u, n), [C_f, Ct, k]) for n in (0, 2))
    return (
        Equation(_t_slow, slow, "Section 4.7"),
        Equation(_t_fast, fast, "Section 4.7"),
        Equation(u_trace, sp.sqrt(_t_slow / _t_fast), "from d(tr A)/du = 0"),
        *_stationary_quartic(),
    )


def _stationary_quartic() -> Chain:
    tr = -(_t_slow / u + _t_fast * u)
    determinant = (q_0 / u**2 + q_1 + q_2 * u**2) / (m * Izz)
    eigenvalue = determinant.diff(u) / tr.diff(u)
    condition = sp.numer(sp.together(eigenvalue**2 - tr * eigenvalue + determinant))
    polynomial = sp.Poly(sp.expand(condition).subs(u, sp.sqrt(s)), s)
    return tuple(
        Equation(e, sp.factor(c), "from d(lambda)/du = 0")
        for e, c in zip(STATIONARY, reversed(polynomial.all_coeffs()), strict=True)
    )
