"""What the linear model says in closed form: stability conditions, modes, critical speeds.

The thesis mentions the Routh-Hurwitz criterion (Section 4.7) but prints none of this.
"""

from __future__ import annotations

import sympy as sp

from groundroll.derive.core.equation import Chain, Equation
from groundroll.derive.core.linearise import state_space
from groundroll.derive.core.quantity import Quantity
from groundroll.derive.models.linear import linear
from groundroll.derive.parts.quantities import Ap, C_alpha, CL_gamma, Ct, rho, u

C_f = Quantity(
    "C_f", "main_gear_stiffness", "N/rad", "cornering stiffness of both main tires", "C_f"
)
k = Quantity("k", "tail_aerodynamic_factor", "kg/m", "stiffness of the vertical tail over u^2", "k")
K = Quantity(
    "K", "tail_stiffness", "N/rad", "stiffness of vertical tail and tail wheel together", "K"
)
A_vv = Quantity("A_vv", "A_vv", "1/s", "d v_dot / d v", "A_{vv}")
A_vr = Quantity("A_vr", "A_vr", "m/s", "d v_dot / d r", "A_{vr}")
A_rv = Quantity("A_rv", "A_rv", "1/(m s)", "d r_dot / d v", "A_{rv}")
A_rr = Quantity("A_rr", "A_rr", "1/s", "d r_dot / d r", "A_{rr}")
trace = Quantity("trace", "trace", "1/s", "tr A: stable needs < 0", r"\operatorname{tr} A")
det = Quantity("det", "determinant", "1/s^2", "det A: stable needs > 0", r"\det A")
discriminant = Quantity(
    "discriminant", "discriminant", "1/s^2", "negative: the modes oscillate", r"\Delta"
)
separation = Quantity(
    "separation", "separation", "1/s", "half the distance between the eigenvalues", r"\delta"
)
spread = Quantity(
    "spread", "spread", "1/s", "half the distance between two real eigenvalues", r"\sigma"
)
re_1 = Quantity("re_1", "re_1", "1/s", "real part of the first eigenvalue", r"\Re\lambda_1")
re_2 = Quantity("re_2", "re_2", "1/s", "real part of the second eigenvalue", r"\Re\lambda_2")
im_1 = Quantity("im_1", "im_1", "rad/s", "imaginary part of the first eigenvalue", r"\Im\lambda_1")
im_2 = Quantity("im_2", "im_2", "rad/s", "imaginary part of the second eigenvalue", r"\Im\lambda_2")
decay_rate = Quantity(
    "decay_rate", "decay_rate", "1/s", "-max Re(eigenvalue): stable if positive", r"d"
)
natural_frequency = Quantity(
    "natural_frequency", "natural_frequency", "rad/s", "undamped natural frequency", r"\omega_n"
)
damped_frequency = Quantity(
    "damped_frequency",
    "damped_frequency",
    "rad/s",
    "size of the imaginary part of an eigenvalue",
    r"\omega_d",
)
damping_ratio = Quantity(
    "damping_ratio", "damping_ratio", "1", "above 1: two real eigenvalues", r"\zeta"
)
s = Quantity("s", "speed_squared", "m^2/s^2", "square of the forward speed", "s")
q_0 = Quantity("q_0", "q_0", "N^2 m^2", "constant term of the speed polynomial", "q_0")
q_1 = Quantity("q_1", "q_1", "N kg m", "linear term of the speed polynomial", "q_1")
q_2 = Quantity("q_2", "q_2", "kg^2", "quadratic term of the speed polynomial", "q_2")
q_root = Quantity("q_root", "q_root", "N kg m", "the positive combination of its roots", r"\hat{q}")
u_low = Quantity(
    "u_low",
    "lower_critical_speed",
    "m/s",
    "the aircraft is unstable from here",
    r"u_{\mathrm{low}}",
)
u_high = Quantity("u_high", "upper_critical_speed", "m/s", "to here", r"u_{\mathrm{high}}")

#: A determinant so small beside its products is what rounding leaves of zero.
ROUNDING = sp.Rational(1, 2**48)

STATE_MATRIX = (A_vv, A_vr, A_rv, A_rr)


def stiffnesses() -> Chain:
    """Axle stiffnesses: all that the linear model knows of tires and tail (Eq. 4.31)."""
    return (
        Equation(C_f, 2 * C_alpha, "Eq. 4.28"),
        Equation(k, rho * Ap * CL_gamma / 2, "Eq. 4.29"),
        Equation(K, Ct + k * u**2, "Eq. 4.31"),
    )


def in_stiffnesses(expr: sp.Expr) -> sp.Expr:
    """`expr` with the axle stiffnesses C_f and K in place of what they are made of."""
    return sp.expand(expr).subs({C_alpha: C_f / 2, Ct: K - rho * Ap * CL_gamma / 2 * u**2})


def state_matrix() -> Chain:
    """The entries of A in axle stiffnesses."""
    A, *_ = state_space(linear())
    return tuple(
        Equation(entry, sp.factor(in_stiffnesses(value)), "Eq. 4.31")
        for entry, value in zip(STATE_MATRIX, A, strict=True)
    )


def routh_hurwitz() -> Chain:
    """Trace and determinant: lambda^2 - tr A lambda + det A = 0 is stable iff tr A < 0 < det A."""
    A, *_ = state_space(linear())
    tr = sp.collect(sp.expand(in_stiffnesses(A.trace())), [C_f, K])
    determinant = sp.collect(sp.expand(in_stiffnesses(A.det())), [C_f * K, C_f, K], sp.factor)
    return (
        Equation(trace, tr, "Section 4.7"),
        Equation(det, determinant, "Section 4.7"),
        Equation(discriminant, trace**2 - 4 * det, "Section 4.7"),
    )


def modes() -> Chain:
    """Eigenvalues and what is read from them, for any 2 x 2 state matrix.

    The larger real part comes first; of a complex pair the positive imaginary part. Near a critical
    speed one eigenvalue is the small difference of two large numbers, unless it is the determinant
    over the other one.
    """
    A = sp.Matrix(2, 2, STATE_MATRIX)
    size = sp.Abs(A_vv * A_rr) + sp.Abs(A_vr * A_rv)
    is_nothing = sp.Abs(A.det()) < ROUNDING * size
    return (
        Equation(trace, A.trace(), "Section 4.7"),
        Equation(det, sp.Piecewise((0, is_nothing), (A.det(), True)), "Section 4.7"),
        # tr^2 - 4 det, written so that equal eigenvalues lose no digits
        Equation(discriminant, (A_vv - A_rr) ** 2 + 4 * A_vr * A_rv, "Section 4.7"),
        Equation(separation, sp.sqrt(sp.Abs(discriminant)) / 2, "Section 4.7"),
        Equation(spread, sp.Piecewise((separation, discriminant > 0), (0, True)), "Section 4.7"),
        Equation(
            damped_frequency,
            sp.Piecewise((separation, discriminant < 0), (0, True)),
            "Section 4.5.7",
        ),
        Equation(re_2, trace / 2 - spread, "Section 4.7"),
        Equation(
            re_1,
            sp.Piecewise(
                (det / re_2, trace * spread < -(trace**2) / 4), (trace / 2 + spread, True)
            ),
            "Section 4.7",
        ),
        Equation(im_1, damped_frequency, "Section 4.7"),
        Equation(im_2, -damped_frequency, "Section 4.7"),
        Equation(
            decay_rate, sp.Piecewise((0, sp.Abs(re_1) <= 0), (-re_1, True)), "Section 4.7"
        ),  # no negative zero
        Equation(natural_frequency, sp.sqrt(det), "Section 4.5.7"),
        Equation(damping_ratio, -trace / (2 * natural_frequency), "Section 4.5.7"),
    )


def tail_area() -> dict[Quantity, sp.Expr]:
    """The tail's area in terms of k, to put k in its place."""
    return {Ap: 2 * k / (rho * CL_gamma)}


def speed_polynomial() -> Chain:
    """Coefficients of q_2 s^2 + q_1 s + q_0, which has the sign of det A, with s = u^2."""
    A, *_ = state_space(linear())
    stiffness = {C_alpha: C_f / 2, **tail_area()}
    numerator = sp.numer(sp.together(A.det().subs(stiffness)))
    polynomial = sp.Poly(sp.expand(numerator.subs(u, sp.sqrt(s))), s)
    coefficients = [sp.factor(c) for c in reversed(polynomial.all_coeffs())]
    return tuple(
        Equation(q, value, "from det A = 0")
        for q, value in zip((q_0, q_1, q_2), coefficients, strict=True)
    )


def speed_window() -> Chain:
    """Critical speeds: the aircraft is unstable between them.

    q_0 and q_2 are never negative, so both roots are positive or none is, and the form with
    q_root loses no digits: s_low = 2 q_0 / q_root and s_high = q_root / (2 q_2). Their roots are
    written so that no window is NaN at both ends, also where there is no tail wheel (q_0 = 0) or
    no vertical tail (q_2 = 0, and the upper end of a window is infinite).
    """
    return (
        *stiffnesses(),
        *speed_polynomial(),
        Equation(q_root, -q_1 + sp.sqrt(q_1**2 - 4 * q_0 * q_2), "from det A = 0"),
        Equation(u_low, sp.sqrt(2 * q_0 * q_root) / q_root, "from det A = 0"),
        Equation(u_high, q_root / sp.sqrt(2 * q_2 * q_root), "from det A = 0"),
    )
