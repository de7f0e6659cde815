"""What the pilot moves. All of it is zero until somebody moves it."""

from __future__ import annotations

from groundroll.derive.core.quantity import Input

pedal = Input(
    "pedal",
    "pedal",
    "1",
    "rudder pedals, -1 (full left) to 1 (full right)",
    within=(-1.0, 1.0),
)
rudder = Input(
    "rudder", "rudder", "rad", "deflection beside the pedal's, trailing edge left positive"
)
steering = Input(
    "steering",
    "steering",
    "rad",
    "angle of the third wheel beside the pedal's, clockwise seen from above",
)
aileron = Input("aileron", "aileron", "rad", "deflection, right wing down positive")
elevator = Input("elevator", "elevator", "rad", "deflection, trailing edge down positive")
brake_left = Input(
    "brake_left",
    "brake_left",
    "1",
    "left wheel's brake, 0 (off) to 1 (locked)",
    within=(0.0, 1.0),
)
brake_right = Input(
    "brake_right",
    "brake_right",
    "1",
    "right wheel's brake, 0 (off) to 1 (locked)",
    within=(0.0, 1.0),
)
thrust = Input("thrust", "thrust", "N", "of the propeller, forward", within=(0.0, None))
