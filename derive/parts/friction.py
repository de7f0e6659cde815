"""What a tire makes of a slip and a load: friction along and across, never beyond its limit."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import sympy as sp

from groundroll.derive.core.equation import Chain, Equation
from groundroll.derive.core.quantity import Parameter, Quantity, State
from groundroll.derive.core.rounded import clipped, ramp

from . import quantities as given
from .tires import C_c, F_bar, alpha_bar, magic_formula, mu

v_rest = Parameter(
    "v_rest",
    "rest_speed",
    "m/s",
    "friction fades below this speed of a contact: near rest a wheel creeps instead of sticking",
    r"v_{\mathrm{rest}}",
    ">0",
)
#: A slip angle needs a speed of the contact; below this part of `v_rest` it fades to nothing.
AT_REST = sp.Rational(1, 1000)
#: Corners of the friction ellipse are rounded in this part of the friction coefficient.
ROUNDING = sp.Rational(1, 100_000)

V_x = Quantity("V_x", "contact_speed", "m/s", "of the contact, the way the wheel points", "V_x")
V_y = Quantity("V_y", "contact_drift", "m/s", "of the contact, to the right of its wheel", "V_y")
slip = Quantity("tan_alpha", "slip_tangent", "1", "tangent of the slip angle", r"\tan\alpha")
alpha = Quantity("alpha", "slip", "rad", "slip angle, positive to the right", r"\alpha")
alpha_free = Quantity("alpha_free", "normalised_slip", "1", "normalised slip, without a limit")
lagged = State("lagged", "lagged_slip", "1", "tangent of the slip angle that the tire feels")
V2_fade = Quantity("V2_fade", "fading_speed_squared", "m^2/s^2", "its square", "V_0^2")
V_fade = Quantity("V_fade", "fading_speed", "m/s", "speed of the contact, never below `v_rest`")
grip = Quantity("grip", "grip", "1", "side force that the slip would make, over the friction")
braked = Quantity(
    "braked", "braked", "1", "lengthwise force that the brake asks, over the friction"
)
asked = Quantity("asked", "asked", "1", "side force over the friction that slip and slide ask")
along = Quantity("along", "lengthwise_part", "1", "lengthwise force over the friction, backward")
left_over = Quantity(
    "left_over", "left_over", "1", "side force over load that is left for the slip"
)
across = Quantity("across", "side_part", "1", "side force over the friction, to the left")

#: Friction of a tire whose line over load would have none.
LEAST = sp.Rational(1, 1000)
#: Part of the friction in which a tire that slides takes over from one that slips.
SLIDING = sp.Rational(1, 50)
_TINY = sp.Rational(1, 10**12)
#: A curvature factor this little above 1 peaks beyond any slip.
_NEVER = sp.Rational(1, 10**12)

#: From a load to the equations for `mu` and, by the tangent of a slip angle, for `grip`.
Tire = Callable[[Quantity], Chain]

TIRE = (given.B3, given.C3, given.B5, given.C5, given.B1, given.C1, given.D1, given.E1)


def radt(surface: Quantity, wheel: str = "", measure: Quantity = slip) -> Tire:
    """The thesis's tire (Section 3.4), its parameters those of a wheel, on a surface.

    The surface multiplies the friction coefficient: what a sliding tire makes, along and across,
    and not its cornering stiffness, which is the tire's own. Slip is measured by the tangent of
    its angle, as in the thesis, or by another quantity, such as the angle itself.

    With a curvature factor above 1, as the thesis prints, the magic formula peaks, falls and in
    the end pushes the way the tire slides. Here it stays where it peaks. The straight lines over
    load end at nothing: a load far above those that were measured, in a hard bounce, makes a tire
    that slides freely, and never one that pushes the way it slides.
    """
    of_wheel = {q: q.of(wheel) for q in TIRE}
    peak = 1 / (given.B1 * sp.sqrt(sp.Max(given.E1 - 1, _NEVER)))

    def tire(load: Quantity) -> Chain:
        friction = sp.Max(LEAST, given.B5 + given.C5 * load)
        chain = (
            Equation(C_c, sp.Max(0, given.B3 + given.C3 * load), "Eq. 3.3, never below 0"),
            Equation(mu, friction * surface, "Eq. 3.5, never below a thousandth"),
            Equation(alpha_free, C_c * measure / mu, "Eq. 3.6"),
            Equation(alpha_bar, sp.Max(-peak, sp.Min(peak, alpha_free)), "held at the peak"),
            *magic_formula(),
            Equation(grip, F_bar, "Eq. 3.7"),
        )
        return tuple(Equation(e.lhs, e.rhs.xreplace(of_wheel), e.source) for e in chain)

    return tire


@dataclass(frozen=True)
class Slip:
    """The slip of a contact: its equations, its rate where it lags, and how it fades near rest."""

    chain: Chain
    rates: dict[Quantity, sp.Expr]
    fade: sp.Expr


def slipping(lag: Quantity | None = None) -> Slip:
    """The slip of a contact, at once or after the wheel has rolled some relaxation lengths.

    At once, its friction fades near rest, where a velocity has no direction. A lagging slip needs
    no such thing: a tire that is pushed sideways at rest winds up like a spring.
    """
    ahead = sp.sqrt(V_x**2 + (AT_REST * v_rest) ** 2)
    speed = sp.sqrt(V_x**2 + V_y**2 + (AT_REST * v_rest) ** 2)
    fading = (
        Equation(V2_fade, sp.sqrt((V_x**2 + V_y**2) ** 2 + v_rest**4), "near rest"),
        Equation(V_fade, sp.sqrt(V2_fade), "near rest"),
    )
    if lag is None:
        at_once = (
            Equation(slip, V_y / ahead, "Eq. 4.13, at any speed"),
            Equation(alpha, sp.atan(slip), "Eq. 4.13"),
        )
        return Slip((*at_once, *fading), {}, speed / V_fade)
    late = (
        Equation(slip, lagged, "relaxation"),
        Equation(alpha, sp.atan(slip), "Eq. 4.13"),
    )
    return Slip((*late, *fading), {lagged: (V_y - ahead * lagged) / lag}, sp.S.One)


def ellipse(brake: sp.Expr, rolling: Quantity, fade: sp.Expr) -> Chain:
    """Friction along and across a wheel: the brake first, the slip on the ellipse that is left.

    The brake asks for a part of what lies between rolling resistance and friction, 0 to 1. No
    wheel makes more than a locked one, whose friction opposes its velocity. So a locked wheel
    slides without steering, and a wheel that rolls has what its slip makes, up to the limit.
    """
    return (
        Equation(braked, (rolling + brake * (mu - rolling)) / mu, "brake"),
        Equation(along, clipped(V_x / V_fade, braked, ROUNDING), "a locked wheel slides"),
        Equation(left_over, sp.sqrt(1 - along**2), "friction ellipse"),
        *_asked(brake, grip * fade),
        Equation(across, clipped(asked, left_over, ROUNDING), "friction ellipse"),
    )


def _asked(brake: sp.Expr, side: sp.Expr) -> Chain:
    """What the slip asks for: of a braked tire no less than that part of what sliding makes.

    Tires whose curve falls at large slips would otherwise slide more easily locked than rolling.
    """
    if brake == 0:
        return (Equation(asked, side, "slip"),)
    slide = V_y / V_fade
    # side over slide; more than any brake where both are nothing
    ratio = (side * slide + _TINY) / (slide**2 + _TINY / 2)
    more = slide * ramp(brake - ratio, SLIDING)
    return (Equation(asked, side + more, "slip, or a locked wheel that slides"),)
