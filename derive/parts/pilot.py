"""A pilot: heading, yaw rate and offset to pedal, late and through muscles.

The crossover model of McRuer (D. T. McRuer and H. R. Jex, "A Review of Quasi-Linear Pilot Models",
IEEE Trans. Human Factors in Electronics HFE-8, 1967): gains, an effective delay of 0.1 to 0.3 s and
a neuromuscular lag of 0.1 s. The delay is Padé's approximation of order (2, 2), right to 1 degree
of phase for frequencies up to 2 / delay; where stability is decided the exact delay is taken.
"""

from __future__ import annotations

import sympy as sp
from sympy.physics.vector import Vector

from groundroll.derive.core.equation import Equation
from groundroll.derive.core.frames import Y, i, phi, psi, r
from groundroll.derive.core.part import Felt, Force, Part
from groundroll.derive.core.quantity import Constant, Input, Parameter, Quantity, State

from .controls import aileron, brake_left, brake_right, pedal

K_psi = Parameter("K_psi", "heading_gain", "1/rad", "pedal of the pilot over heading", r"K_\psi")
K_r = Parameter("K_r", "yaw_rate_gain", "s/rad", "pedal of the pilot over yaw rate", "K_r")
K_Y = Parameter("K_Y", "offset_gain", "1/m", "pedal of the pilot over offset", "K_Y")
K_phi = Parameter("K_phi", "roll_gain", "1", "aileron of the pilot over roll", r"K_\phi")
K_brake = Parameter(
    "K_brake", "brake_gain", "1", "brake on one side over pedal to that side", r"K_{\mathrm{b}}"
)
tau_pilot = Parameter(
    "tau_pilot", "pilot_delay", "s", "from what is seen to what is done", r"\tau", ">0"
)
T_pilot = Parameter("T_pilot", "pilot_lag", "s", "neuromuscular lag", "T", ">0")
aileron_stop = Parameter("aileron_stop", "aileron_stop", "rad", "largest aileron", sign=">0")

#: Where the file is silent: somebody of average quickness who steers with the feet alone.
PILOT = (
    Equation(tau_pilot, Constant(0.2, "s"), "Swaim: 0.1 to 0.2 s; Neal and Smith 1970: 0.3 s"),
    Equation(T_pilot, Constant(0.1, "s"), "Swaim: time constant of limbs"),
    Equation(K_psi, Constant(2.0, "1"), "estimate: full pedal for half a radian"),
    Equation(K_r, Constant(1.0, "s"), "estimate: lead of half a second"),
    Equation(K_Y, Constant(0.02, "1/m"), "estimate: two degrees for two metres"),
    Equation(K_phi, sp.S.Zero, "feet alone"),
    Equation(K_brake, sp.S.Zero, "feet alone"),
    Equation(aileron_stop, Constant(0.35, "rad"), "estimate: 20 degrees"),
)

heading_aim = Input("psi_aim", "heading_aim", "rad", "heading that the pilot wants")
braking = Input(
    "braking", "braking", "1", "of both wheels, 0 (off) to 1 (locked)", within=(0.0, 1.0)
)

wanted = Quantity("wanted", "wanted_pedal", "1", "pedal for what is seen, right positive")
seen = Quantity("seen", "delayed_pedal", "1", "the same, delayed")
late = State("late", "delay_state", "1", "first state of the delay")
late_rate = State("late_rate", "delay_state_rate", "1/s", "second state of the delay")
pressed = State("pressed", "pressed_pedal", "1", "pedal that the muscles give, without its stops")
leaning = State("leaning", "held_aileron", "rad", "aileron of the muscles, without its stops")


def _within(expr: sp.Expr, stop: sp.Expr) -> sp.Expr:
    """A control between its stops."""
    return sp.Max(-stop, sp.Min(stop, expr))


def act(felt: Felt) -> Force:
    """What the pilot does; no force, but controls."""
    # Pade (2, 2): e^(-tau s) = 1 - tau s / (1 + tau s / 2 + (tau s)^2 / 12)
    curvature = 12 * (wanted - late - tau_pilot * late_rate / 2) / tau_pilot**2
    chain = (
        Equation(wanted, -K_psi * (psi - heading_aim) - K_r * r - K_Y * Y, "McRuer 1967"),
        Equation(seen, wanted - tau_pilot * late_rate, "Padé (2, 2)"),
        Equation(pedal, _within(pressed, sp.S.One), "stops of the pedal"),
        Equation(aileron, _within(leaning, aileron_stop), "stops of the stick"),
        Equation(brake_left, sp.Min(1, braking + K_brake * sp.Max(0, -pedal)), "toe brakes"),
        Equation(brake_right, sp.Min(1, braking + K_brake * sp.Max(0, pedal)), "toe brakes"),
    )
    rates = {
        late: late_rate,
        late_rate: curvature,
        pressed: (seen - pressed) / T_pilot,
        leaning: (-K_phi * phi - leaning) / T_pilot,
    }
    controls = (pedal, aileron, brake_left, brake_right)
    return Force(Vector(0), chain=chain, rates=rates, shown=controls)


def pilot() -> Part:
    """Somebody at the controls."""
    return Part("pilot", 0 * i, act, asks=(heading_aim, braking), suffix="", kind="")
