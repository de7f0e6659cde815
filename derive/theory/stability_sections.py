"""The part of the equation sheet that is about stability: which chains, and how to read them."""

from __future__ import annotations

from collections.abc import Iterator

from groundroll.derive.core.equation import Chain
from groundroll.derive.core.model import Derivation
from groundroll.derive.models.linear import linear

from . import closed_forms as closed
from . import equilibrium, gear_position, margins, toe, worst_speed


def stability_sections() -> Iterator[tuple[str, Chain, str]]:
    """Title, chain and text of each section."""
    for title, chain, text in _sections():
        yield title, chain, " ".join(text.split())


def _sections() -> Iterator[tuple[str, Chain, str]]:
    matrix = (*closed.stiffnesses(), *closed.state_matrix())
    yield "Stability: axle stiffnesses and state matrix", matrix, ""
    yield "Stability: Routh–Hurwitz", closed.routh_hurwitz(), _ROUTH_HURWITZ
    yield "Stability: modes", (*closed.modes(), *margins.times()), ""
    yield "Stability: critical speeds", closed.speed_window(), _SPEEDS
    yield "Stability: weakest speed", worst_speed.weakest_speed(), _WEAKEST
    yield "Stability: worst decay rate", worst_speed.stationary_decay(), _STATIONARY
    yield "Stability: steady margins", margins.steady_margins(), _STEADY
    yield "Stability: tail wheel", margins.tail_wheel_needed(), _TAIL_WHEEL
    yield "Gear position", gear_position.fixed_stiffness(), _POSITION
    yield "Gear position: every speed", gear_position.fixed_stiffness_envelope(), _ENVELOPE
    loaded = (
        *gear_position.following_loads(),
        *gear_position.position_polynomial(),
        *gear_position.envelope_polynomial(),
        *gear_position.at_tail_fraction(),
    )
    yield "Gear position: loads that follow it", loaded, _LOADED
    yield "Toe-in", (*closed.stiffnesses(), *toe.toe_effects()), _TOE
    yield steady_turns(linear())


def steady_turns(model: Derivation) -> tuple[str, Chain, str]:
    """The section on steady turns of a model."""
    text = " ".join(_STEADY_TURNS.split())
    return f"Steady turns of the {model.name} model", equilibrium.equilibrium(model), text


_TOE = r"""
Toe-in $\epsilon$ raises $dN/d\beta$ exactly if $t^2 C > 2 a h C' (2 C + K)$, with the track $t$ and
the height $h$ of the CG; on the boundary of stability it moves $\det A$ up exactly if $t^2 b (2 C +
K) > 4 h L^2 K C'$. A tire whose stiffness falls with load ($C' < 0$) makes both hold always.
"""

_ROUTH_HURWITZ = r"""
The characteristic polynomial is $\lambda^2 - \operatorname{tr}A\,\lambda + \det A$. The aircraft
is stable if and only if $\operatorname{tr}A < 0$ and $\det A > 0$. The trace is negative whenever a
stiffness is positive; the determinant decides.
"""

_SPEEDS = r"""
With $s = u^2$, $\det A$ has the sign of $q_2 s^2 + q_1 s + q_0$: the aircraft is unstable between
$u_{\mathrm{low}}$ and $u_{\mathrm{high}}$, and at no speed if $q_1 > -2\sqrt{q_0 q_2}$, that is if
$\sqrt{m a C_f} < \sqrt{m b C_{f\,\mathrm{tail}}} + L\sqrt{C_f k}$.
"""

_WEAKEST = r"""
$m I_{zz} \det A = q_2 s + q_1 + q_0/s$ is least where $q_2 s = q_0/s$. If the aircraft is unstable
between two speeds, $u_{\mathrm{weak}}$ is their geometric mean.
"""

_STATIONARY = r"""
On a real eigenvalue, $d\lambda/du = 0$ gives
$\lambda = (d\det A/du) / (d\operatorname{tr}A/du)$; put into the characteristic polynomial, with
$\operatorname{tr}A = -(t_0/u + t_1 u)$, that is the quartic $\sum e_n s^n = 0$. Complex eigenvalues
decay slowest at $u_{\mathrm{tr}}$. Over a range of speeds the decay rate is least at one of these
or at an end of the range.
"""

_STEADY = r"""
As for road vehicles (Milliken and Milliken, *Race Car Vehicle Dynamics*, chapter 5; Gillespie,
*Fundamentals of Vehicle Dynamics*, chapter 6), the main gear being the front axle and the tail the
rear one. A side force at $x_{\mathrm{N}}$ ahead of the CG gives a steady sideslip without yawing.
With the main wheels steered by $\delta$ the aircraft turns at
$r = u \delta/(L + K_{\mathrm{us}} u^2)$; in axle loads,
$K_{\mathrm{us}} = (W_{\mathrm{main}}/C_f - W_{\mathrm{tail}}/K)/g$. Both are positive, or both
negative, with $K b - C_f a$.
"""

_TAIL_WHEEL = r"""
Stable at this speed if the tail wheel is stiffer than $C_{f\,\mathrm{tail,\,needed}}$, and at every
speed if it is stiffer than $C_{f\,\mathrm{tail,\,always}}$, that is if the margin
$\mathit{VM} = \sqrt{b C_{f\,\mathrm{tail}}/(L C_f)} + \sqrt{L k/m} - \sqrt{a/L}$ is positive.
"""

_POSITION = r"""
The main gear moves, CG and tail stay, the stiffnesses are constants: $\det A$ has the sign of
$h_2 a^2 + h_1 a + h_0$. The aircraft is unstable with the gear between $a_{\mathrm{lost}}$ and
$a_{\mathrm{regained}}$, and at no position if the roots are not real.
"""

_ENVELOPE = r"""
The condition for stability at every speed is a quadratic in $\sqrt{a}$. The aircraft is stable at
every speed up to $a_{\mathrm{always}}$; with the gear there, stability is lost at
$u_{\mathrm{touch}}$ first.
"""

_LOADED = r"""
$\phi$ is the share of the weight on the tail wheel. Both stiffnesses follow the axle loads:
$\det A$ has the sign of $c_2 s^2 + c_1 s + c_0$, each a polynomial in $\phi$ ($p$ at a speed).
Windows of instability open where its discriminant in $s$, with the coefficients $g$, is zero. With
equal cornering coefficients of main and tail wheels the tires cancel in $K b - C_f a$ and the air
force on the tail decides.
"""

_STEADY_TURNS = r"""
A steady turn is a slip angle of the main tires at which $\sum M_z = 0$; everything else follows
from it.
"""
