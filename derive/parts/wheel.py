"""A wheel on the runway: its leg, its heading, the slip of its tire and the friction it makes."""

from __future__ import annotations

from dataclasses import dataclass, field

import sympy as sp
from sympy.physics.vector import Vector, cross

from groundroll.derive.core.equation import Chain, Equation
from groundroll.derive.core.frames import along_body, components, i, j
from groundroll.derive.core.part import Event, Felt, Force, Law, Part
from groundroll.derive.core.quantity import Quantity

from .friction import Slip, Tire, V_x, V_y, across, along, alpha, ellipse, slipping
from .leg import Leg, depth, sinking, stand
from .tires import mu

F_x = Quantity("F_x", "wheel_drag", "N", "lengthwise force on the wheel, backward", "F_x")
F_y = Quantity("F_y", "wheel_side_force", "N", "side force on the wheel, to the left", "F_y")
slope = Quantity("slope", "heading_slope", "1", "how far the heading in the body points down")
flat = Quantity("flat", "flat_part", "1", "part of the heading that lies in the runway's plane")

#: What a wheel does to the body, along the body's axes.
PUSH = tuple(
    Quantity(f"push_{axis}", f"push_along_{axis}", "N", f"of the wheel on the body, along {axis}")
    for axis in "xyz"
)

LIFTED = Event("wheel_lifted", depth, False, "a wheel leaves the ground")


def unloaded(load: Quantity) -> Event:
    """The same of a level body, whose wheels have no depth: nothing is left to carry."""
    return Event("wheel_lifted", load, False, "a wheel carries nothing any more")


@dataclass(frozen=True)
class Turned:
    """How a wheel is turned about its leg.

    Attributes
    ----------
    angle : Expr
        From the body's x axis to the wheel's heading, clockwise seen from above, rad.
    leftward : Expr
        Velocity of the contact to the left of its wheel because the wheel swivels, m/s.
    holds : Expr
        Part of the side force that the wheel holds: none if it turns away.
    chain : tuple of Equation
    rates : mapping
        Rates of the angle and of its rate, where it is free, by the side force `F_y`.
    """

    angle: sp.Expr = sp.S.Zero
    leftward: sp.Expr = sp.S.Zero
    holds: sp.Expr = sp.S.One
    chain: Chain = ()
    rates: dict[Quantity, sp.Expr] = field(default_factory=dict)


def wheel(
    name: str,
    at: Vector,
    leg: Leg,
    tire: Tire,
    rolling: Quantity,
    brake: sp.Expr = sp.S.Zero,
    turned: Turned | None = None,
    lag: Quantity | None = None,
    asks: tuple[Quantity, ...] = (),
) -> Part:
    """A wheel that stands on the runway.

    Parameters
    ----------
    name : str
    at : Vector
        Its contact with the leg unloaded, from the CG.
    leg : Leg
        What carries the body, where it stands on legs.
    tire : callable
        From the load to the side force over load.
    rolling : Quantity
        Rolling resistance over load.
    brake : Expr
        0 (rolls) to 1 (locked).
    turned : Turned, optional
        Its heading; that of the body if omitted.
    lag : Quantity, optional
        Relaxation length of the tire; its slip is felt at once if omitted.
    asks : tuple of Quantity
        The inputs among all this.
    """
    slip = slipping(lag)
    law = _law(leg, tire, ellipse(brake, rolling, slip.fade), turned or Turned(), slip)
    return Part(name, at, law, asks, kind="wheel")


def _law(leg: Leg, tire: Tire, friction: Chain, turned: Turned, slip: Slip) -> Law:
    def law(felt: Felt) -> Force:
        foot = stand(felt, leg)
        pointing = sp.cos(turned.angle) * i + sp.sin(turned.angle) * j
        right = cross(felt.down, pointing)
        ahead = foot.velocity.dot(pointing)
        # heading and right lie in the runway's plane, flat times as long as they should be
        if foot.chain:
            projected: Chain = (
                Equation(slope, pointing.dot(felt.down), "direction cosine"),
                Equation(flat, sp.sqrt(1 - slope**2), "projection on the runway"),
            )
            ahead, length = ahead - slope * sinking, flat
            heading, load = pointing - slope * felt.down, felt.load
        else:
            projected, length, heading, load = (), sp.S.One, pointing, sp.S.Zero
        friction_force = -F_x / length * heading - F_y / length * right
        pushed = components(friction_force - load * felt.down)
        chain = (
            *foot.chain,
            *turned.chain,
            *projected,
            Equation(V_x, ahead / length, "Eq. 4.10 at the contact"),
            Equation(V_y, foot.velocity.dot(right) / length - turned.leftward, "Eq. 4.10"),
            *slip.chain,
            *tire(felt.load),
            *friction,
            Equation(F_x, along * mu * felt.load, "Eq. 3.11"),
            Equation(F_y, turned.holds * across * mu * felt.load, "Eq. 3.11"),
            *(Equation(q, e, "resolved") for q, e in zip(PUSH, pushed, strict=True)),
        )
        return Force(
            vector=along_body(sp.Matrix(PUSH)),
            chain=chain,
            rates={**turned.rates, **slip.rates},
            shown=(felt.load, alpha, F_x, F_y),
            at=foot.at,
            events=(LIFTED if foot.chain else unloaded(felt.load),),
        )

    return law
