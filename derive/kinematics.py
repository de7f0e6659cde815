"""Frames, velocities and accelerations of a rigid aircraft on the runway plane (Section 4.3).

SAE axes: x forward, y right, z down, so a positive rotation about z turns the nose to the right.
"""

from __future__ import annotations

import sympy as sp
from sympy.physics.vector import ReferenceFrame, Vector, cross, dynamicsymbols

from .quantities import Quantity, X, Y, psi, r, theta, u, v, y

GROUND = ReferenceFrame("G")
_v, _r, _psi = dynamicsymbols("v r psi")
_TIME = dynamicsymbols._t

#: The aircraft-fixed frame, turned by the heading.
BODY = GROUND.orientnew("B", "Axis", [_psi, GROUND.z])
i, j, k = BODY.x, BODY.y, BODY.z

#: Velocity of the CG, Eq. 4.3, and angular velocity of the aircraft, Eq. 4.4.
V0: Vector = u * i + v * j
OMEGA: Vector = r * k


def velocity(position: Vector) -> Vector:
    """Velocity of the point at `position` (from the CG): V_i = V0 + Omega x R_i, Eq. 4.10."""
    return V0 + cross(OMEGA, position)


def _in_time(vector: Vector) -> Vector:
    return vector.subs({v: _v, r: _r})


def accelerations(vdot: sp.Symbol, rdot: sp.Symbol) -> tuple[Vector, Vector]:
    """Acceleration of the CG and angular acceleration, Eqs. 4.5 and 4.6.

    The frame rotates, so d/dt = d/dt|body + Omega x. The forward speed u is constant.
    """

    def inertial(vector: Vector) -> Vector:
        rate = _in_time(vector).dt(BODY).subs({_v.diff(_TIME): vdot, _r.diff(_TIME): rdot})
        return rate + cross(OMEGA, vector)

    return inertial(V0), inertial(OMEGA)


def path_rates() -> dict[Quantity, sp.Expr]:
    """Rates of the displacements.

    The thesis integrates v and r in aircraft coordinates (y, theta); the path over the ground
    (X, Y, psi) is what a runway sees: the same velocity, resolved along ground axes.
    """
    over_ground = V0.express(GROUND).subs(_psi, psi)
    return {
        y: v,
        theta: r,
        X: over_ground.dot(GROUND.x),
        Y: over_ground.dot(GROUND.y),
        psi: r,
    }
