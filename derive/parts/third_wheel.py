"""The third wheel, at the nose or at the tail: fixed, steered, sprung or castering by parameters.

Fixed: `swivels` is 0 and nothing steers. Steered: `swivels` is 0 and the angle is the pedal's.
Sprung: `swivels` is 1 and springs to the pedal turn it, until they let go at the break-out angle.
Castering: `swivels` is 1 and the stiffness of the springs is 0.
"""

from __future__ import annotations

import sympy as sp

from groundroll.derive.core.equation import Equation
from groundroll.derive.core.quantity import Parameter, Quantity, State
from groundroll.derive.core.rounded import ramp

from .controls import pedal, steering
from .wheel import F_y, Turned

swivels = Parameter(
    "swivels",
    "third_wheel_swivels",
    "1",
    "1 if the third wheel is free to turn, else 0",
    sign=">=0",
)
ratio = Parameter(
    "steering_ratio",
    "steering_ratio",
    "rad",
    "angle of the third wheel at full right pedal, clockwise seen from above: positive for a"
    " nose wheel, negative for a tail wheel",
)
I_swivel = Parameter(
    "I_swivel", "swivel_inertia", "kg m^2", "of what swivels, about its pivot", sign=">0"
)
c_swivel = Parameter(
    "c_swivel", "swivel_damping", "N m s/rad", "couple over swivel rate: friction, shimmy damper"
)
k_swivel = Parameter(
    "k_swivel", "steering_stiffness", "N m/rad", "of the steering springs; 0: the wheel casters"
)
trail = Parameter("trail", "trail", "m", "contact behind the pivot, on the ground", sign=">=0")
break_out = Parameter(
    "break_out", "break_out_angle", "rad", "of the springs, where they let go", sign=">0"
)
stop = Parameter("stop", "swivel_stop", "rad", "angle of the stops of the swivel", sign=">0")
k_stop = Parameter("k_stop", "stop_stiffness", "N m/rad", "of the stops of the swivel")

#: Parts of the break-out angle in which the springs let go, and of the stop's in which it holds.
LETTING_GO = sp.Rational(1, 20)
HOLDING = sp.Rational(1, 100)

chi = State("chi", "swivel_angle", "rad", "of the third wheel, clockwise from above", r"\chi")
chi_rate = State("chi_rate", "swivel_rate", "rad/s", "its rate of swivel", r"\dot{\chi}")
commanded = Quantity("commanded", "steered_angle", "rad", "where pedal and steering want the wheel")
wound = Quantity("wound", "wound_angle", "rad", "of the steering springs")
M_spring = Quantity("M_spring", "spring_couple", "N m", "of springs and stops, against the swivel")
delta = Quantity("delta", "wheel_angle", "rad", "of the wheel, clockwise from above", r"\delta")


def third_wheel() -> Turned:
    """How the third wheel turns: by the pedal, or freely about its pivot.

    The springs let go smoothly at the break-out angle and take hold again where the wheel comes
    back: their potential k o w/2 (ln 2 - ln(1 + exp((o^2 - x^2)/(o w)))) + const levels off, so
    that what they give back is never more than what they took.
    """
    # the logistic function as a tanh: an exp grows without bound where the wheel turns far
    held = (1 - sp.tanh((wound**2 - break_out**2) / (2 * LETTING_GO * break_out**2))) / 2
    beyond = ramp(chi - stop, HOLDING * stop) - ramp(-chi - stop, HOLDING * stop)
    turning = (trail * F_y - c_swivel * chi_rate - M_spring) / I_swivel
    return Turned(
        angle=delta,
        leftward=swivels * trail * chi_rate,
        chain=(
            Equation(commanded, ratio * pedal + steering, "linkage"),
            Equation(wound, chi - commanded, "linkage"),
            Equation(M_spring, k_swivel * wound * held + k_stop * beyond, "springs"),
            Equation(delta, commanded + swivels * wound, "linkage or swivel"),
        ),
        rates={chi: swivels * chi_rate, chi_rate: swivels * turning},
    )


def steered_wheel() -> Turned:
    """The third wheel without states: turned by the pedal, or free and then without side force.

    A light caster follows its velocity at once. Springs that hold it in part need `third_wheel`.
    """
    return Turned(
        angle=delta,
        holds=1 - swivels,
        chain=(
            Equation(commanded, ratio * pedal + steering, "linkage"),
            Equation(delta, (1 - swivels) * commanded, "linkage"),
        ),
    )
