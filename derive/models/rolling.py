"""What rolls: the wheels and the parts in the air that `landing_roll` and `rollout` share."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import sympy as sp
from sympy.physics.vector import Vector

from groundroll.derive.core.frames import i, j, k
from groundroll.derive.core.part import Part
from groundroll.derive.parts.air import fin, propeller, push, tailplane
from groundroll.derive.parts.airframe import airframe
from groundroll.derive.parts.controls import (
    aileron,
    brake_left,
    brake_right,
    elevator,
    pedal,
    rudder,
    steering,
    thrust,
)
from groundroll.derive.parts.friction import Tire, radt
from groundroll.derive.parts.gear import (
    MAIN_LEG,
    THIRD_LEG,
    a_third,
    rolling,
    surface,
    toe,
    track,
    z_main,
    z_third,
)
from groundroll.derive.parts.quantities import F_disturbance, a, b
from groundroll.derive.parts.stations import x_h, z_fin, z_h, z_thrust
from groundroll.derive.parts.wheel import Turned, wheel

LEFT, RIGHT, THIRD = "left", "right", "third"

#: From a place in the axes in which stations are measured to that in the axes of the model.
Placing = Callable[[sp.Expr, sp.Expr, sp.Expr], Vector]


def as_measured(x: sp.Expr, y: sp.Expr, z: sp.Expr) -> Vector:
    """A place in the axes in which stations are measured."""
    return x * i + y * j + z * k


def wheels(
    turned: Turned,
    main: Callable[[str], Tire] | None = None,
    third: Tire | None = None,
    place: Placing = as_measured,
) -> Sequence[Part]:
    """The main wheels, toed in, and the third wheel, with the thesis's tire or another."""
    tire = main or (lambda name: radt(surface(name)))
    return [
        wheel(
            LEFT,
            place(a, -track / 2, z_main),
            MAIN_LEG,
            tire(LEFT),
            rolling(LEFT),
            brake=brake_left,
            turned=Turned(toe),
            asks=(brake_left,),
        ),
        wheel(
            RIGHT,
            place(a, track / 2, z_main),
            MAIN_LEG,
            tire(RIGHT),
            rolling(RIGHT),
            brake=brake_right,
            turned=Turned(-toe),
            asks=(brake_right,),
        ),
        wheel(
            THIRD,
            place(a_third, sp.S.Zero, z_third),
            THIRD_LEG,
            third or radt(surface(THIRD), THIRD),
            rolling(THIRD),
            turned=turned,
            asks=(pedal, steering),
        ),
    ]


def aloft(incidence: sp.Expr = sp.S.Zero, place: Placing = as_measured) -> Sequence[Part]:
    """What the air does, `incidence` being that of a level body over its path."""
    zero = sp.S.Zero
    return [
        Part("airframe", 0 * i, airframe(incidence), (pedal, rudder, aileron, elevator), "", ""),
        Part("fin", place(-b, zero, z_fin), fin, (pedal, rudder, thrust), kind="fin"),
        Part("tailplane", place(x_h, zero, z_h), tailplane(incidence), (elevator, thrust)),
        Part("propeller", place(zero, zero, z_thrust), propeller, (thrust,), ""),
        Part("disturbance", place(-b, zero, zero), push(F_disturbance, j), (F_disturbance,), ""),
    ]
