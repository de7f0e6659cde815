"""Frames and the motion of a rigid body over the runway (Section 4.3).

SAE axes: x forward, y right, z down, so a positive rotation about z turns the nose to the right.
The heading psi, the pitch theta and the roll phi turn the ground's axes into the body's, in this
order.
"""

from __future__ import annotations

from functools import cache

import sympy as sp
from sympy.physics.vector import ReferenceFrame, Vector, dynamicsymbols

from .quantity import Quantity, State

# --- Velocities, in body axes -------------------------------------------------------------------
u = State("u", "speed", "m/s", "velocity of the CG along the body x axis, forward")
v = State("v", "lateral_velocity", "m/s", "velocity of the CG along the body y axis, to the right")
w = State("w", "vertical_velocity", "m/s", "velocity of the CG along the body z axis, down")
p = State("p", "roll_rate", "rad/s", "angular velocity about the body x axis, right wing down")
q = State("q", "pitch_rate", "rad/s", "angular velocity about the body y axis, nose up")
r = State("r", "yaw_rate", "rad/s", "angular velocity about the body z axis, nose right")

# --- Where the body is ----------------------------------------------------------------------------
X = State("X", "distance", "m", "position of the CG along the runway")
Y = State("Y", "offset", "m", "position of the CG across the runway, to the right")
Z = State("Z", "depth", "m", "position of the CG below the runway: negative above it")
phi = State("phi", "roll", "rad", "angle of roll, right wing down", r"\phi")
theta = State("theta", "pitch", "rad", "angle of pitch, nose up", r"\theta")
psi = State(
    "psi", "heading", "rad", "angle from the runway to the body x axis, nose right", r"\psi"
)

TIME = dynamicsymbols._t
_psi, _theta, _phi = dynamicsymbols("psi theta phi")

GROUND = ReferenceFrame("G")
#: The aircraft-fixed frame.
BODY = GROUND.orientnew("B", "Body", [_psi, _theta, _phi], "ZYX")
i, j, k = BODY.x, BODY.y, BODY.z

_ANGLES = {_psi: psi, _theta: theta, _phi: phi}


def rotation(is_level: bool) -> sp.Matrix:
    """Components along ground axes (rows) of the body's unit vectors (columns)."""
    matrix = GROUND.dcm(BODY).subs(_ANGLES)
    return matrix.subs({phi: 0, theta: 0}) if is_level else matrix


@cache
def attitude_rates() -> dict[Quantity, sp.Expr]:
    """Rates of roll, pitch and heading by the body's angular velocity."""
    rates = [angle.diff(TIME) for angle in _ANGLES]
    turning = BODY.ang_vel_in(GROUND).to_matrix(BODY)
    by_rate = turning.jacobian(rates)  # the angular velocity is linear in them
    solution = by_rate.inv().applyfunc(sp.trigsimp) * sp.Matrix([p, q, r])
    return {
        angle: rate.subs(_ANGLES) for angle, rate in zip(_ANGLES.values(), solution, strict=True)
    }


def components(vector: Vector) -> sp.Matrix:
    """A vector along body axes, as a column."""
    return vector.to_matrix(BODY)


def along_body(column: sp.Matrix) -> Vector:
    """A vector from its components along body axes."""
    return column[0] * i + column[1] * j + column[2] * k
