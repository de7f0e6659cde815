"""The body: a rigid body in six degrees of freedom, and what holds some of them (Section 4.3).

m (dV/dt + omega x V) = sum F and I domega/dt + omega x I omega = sum M, from vectors. Where a
constraint holds a velocity, the balance along it gives what the constraint carries instead of an
acceleration.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import sympy as sp
from sympy.physics.vector import Vector, cross

from .equation import Chain, Equation
from .frames import (
    X,
    Y,
    Z,
    along_body,
    attitude_rates,
    components,
    p,
    phi,
    psi,
    q,
    r,
    rotation,
    theta,
    u,
    v,
    w,
)
from .part import Felt, Force, Part
from .quantity import Input, Parameter, Quantity

# --- Inertia ----------------------------------------------------------------------------------
m = Parameter("m", "mass", "kg", "total mass", sign=">0")
Ixx = Parameter(
    "Ixx", "roll_inertia", "kg m^2", "moment of inertia about the x axis", "I_{xx}", ">0"
)
Iyy = Parameter(
    "Iyy", "pitch_inertia", "kg m^2", "moment of inertia about the y axis", "I_{yy}", ">0"
)
Izz = Parameter(
    "Izz", "yaw_inertia", "kg m^2", "moment of inertia about the z axis", "I_{zz}", ">0"
)
Ixz = Parameter("Ixz", "product_of_inertia", "kg m^2", "integral of x z over the mass", "I_{xz}")
g = Parameter("g", "gravity", "m/s^2", "acceleration due to gravity", sign=">0")

#: The forward speed of a body whose speed is held.
u_held = Parameter("u", "speed", "m/s", "forward speed, constant", sign=">0")

# --- Wind -------------------------------------------------------------------------------------
wind_x = Input("wind_x", "tailwind", "m/s", "velocity of the air along the runway, forward")
wind_y = Input("wind_y", "crosswind", "m/s", "velocity of the air across the runway, to the right")
_WIND = tuple(
    Quantity(f"wind_{s}", f"wind_along_{axis}", "m/s", f"velocity of the air along body {axis}")
    for s, axis in zip("uvw", ("x_axis", "y_axis", "z_axis"), strict=True)
)

# --- The balance ------------------------------------------------------------------------------
#: Sum of the forces along each axis, then of the moments about it.
sum_Fx = Quantity("sum_Fx", "forward_force", "N", "sum of the forces along x", r"\sum F_x")
sum_F = Quantity("sum_F", "side_force", "N", "sum of the forces along y", r"\sum F_y")
sum_Fz = Quantity("sum_Fz", "downward_force", "N", "sum of the forces along z", r"\sum F_z")
sum_Mx = Quantity(
    "sum_Mx", "roll_moment", "N m", "sum of the moments about x through the CG", r"\sum M_x"
)
sum_My = Quantity(
    "sum_My", "pitch_moment", "N m", "sum of the moments about y through the CG", r"\sum M_y"
)
sum_M = Quantity(
    "sum_M", "yaw_moment", "N m", "sum of the moments about z through the CG", r"\sum M_z"
)
SUMS = (sum_Fx, sum_F, sum_Fz, sum_Mx, sum_My, sum_M)

u_dot = Quantity("u_dot", "speed_rate", "m/s^2", "time derivative of u", r"\dot{u}")
v_dot = Quantity("v_dot", "lateral_velocity_rate", "m/s^2", "time derivative of v", r"\dot{v}")
w_dot = Quantity("w_dot", "vertical_velocity_rate", "m/s^2", "time derivative of w", r"\dot{w}")
p_dot = Quantity("p_dot", "roll_acceleration", "rad/s^2", "time derivative of p", r"\dot{p}")
q_dot = Quantity("q_dot", "pitch_acceleration", "rad/s^2", "time derivative of q", r"\dot{q}")
r_dot = Quantity("r_dot", "yaw_acceleration", "rad/s^2", "time derivative of r", r"\dot{r}")
SPEEDS = (u, v, w, p, q, r)
ACCELERATIONS = (u_dot, v_dot, w_dot, p_dot, q_dot, r_dot)

a_x = Quantity("a_x", "forward_acceleration", "m/s^2", "acceleration of the CG along x", "a_x")
a_y = Quantity("a_y", "lateral_acceleration", "m/s^2", "acceleration of the CG along y", "a_y")
a_z = Quantity("a_z", "vertical_acceleration", "m/s^2", "acceleration of the CG along z", "a_z")

#: What a constraint carries: the force or couple on the body along or about each axis.
CARRIED = (
    Quantity("F_held", "holding_thrust", "N", "thrust that holds the speed", r"F_{\mathrm{held}}"),
    Quantity("Fy_held", "holding_side_force", "N", "side force of the constraint, to the right"),
    Quantity("N_held", "ground_load", "N", "what the ground carries, pushing up", "N"),
    Quantity("Mx_held", "holding_roll_couple", "N m", "roll couple of the ground, right wing down"),
    Quantity("My_held", "holding_pitch_couple", "N m", "pitch couple of the ground, nose up"),
    Quantity("Mz_held", "holding_yaw_couple", "N m", "yaw couple of the constraint, nose right"),
)


beta = Quantity(
    "beta", "sideslip_angle", "rad", "angle of the CG's velocity to the x axis", r"\beta"
)


@dataclass(frozen=True)
class Body:
    """A rigid body, free or held.

    Attributes
    ----------
    speed : str
        ``"free"``: the forward speed is a state. ``"held"``: it is a parameter, and the thrust
        that holds it an output.
    stands : str
        ``"on legs"``: it heaves, pitches and rolls. ``"level"``: it does not, its axes are
        principal, and what the ground carries is an output.
    """

    speed: Literal["free", "held"] = "free"
    stands: Literal["on legs", "level"] = "on legs"

    def __post_init__(self) -> None:
        for what, value, allowed in (
            ("speed", self.speed, ("free", "held")),
            ("stands", self.stands, ("on legs", "level")),
        ):
            if value not in allowed:
                raise ValueError(
                    f"Body: {what} is {value!r}; it is one of {allowed[0]!r} and {allowed[1]!r}"
                )

    @property
    def is_level(self) -> bool:
        """Whether the body neither heaves nor pitches nor rolls."""
        return self.stands == "level"

    @property
    def _held(self) -> frozenset[Quantity]:
        level = {w, p, q} if self.is_level else set()
        return frozenset(level | ({u} if self.speed == "held" else set()))

    @property
    def speeds(self) -> tuple[Quantity, ...]:
        """The velocities that are free."""
        return tuple(s for s in SPEEDS if s not in self._held)

    @cached_property
    def _motion(self) -> Mapping[Quantity, sp.Expr]:
        """Value of each velocity."""
        at_rest = {s: sp.Integer(0) for s in self._held}
        return {s: s for s in SPEEDS} | at_rest | ({u: u_held} if u in self._held else {})

    @cached_property
    def V0(self) -> Vector:
        """Velocity of the CG, Eq. 4.3."""
        return along_body(sp.Matrix([self._motion[s] for s in (u, v, w)]))

    @cached_property
    def OMEGA(self) -> Vector:
        """Angular velocity, Eq. 4.4."""
        return along_body(sp.Matrix([self._motion[s] for s in (p, q, r)]))

    @property
    def accelerations(self) -> tuple[Quantity, ...]:
        """The rates of the velocities that are free."""
        return tuple(a for s, a in zip(SPEEDS, ACCELERATIONS, strict=True) if s not in self._held)

    def _rates(self, speeds: Sequence[Quantity]) -> Vector:
        """The time derivative, in the body, of three velocities."""
        rate_of = dict(zip(SPEEDS, ACCELERATIONS, strict=True))
        return along_body(sp.Matrix([0 if s in self._held else rate_of[s] for s in speeds]))

    # --- What is felt -------------------------------------------------------------------------

    def velocity(self, position: Vector) -> Vector:
        """Velocity of the point at `position` (from the CG): V_i = V0 + Omega x R_i, Eq. 4.10."""
        return self.V0 + cross(self.OMEGA, position)

    def acceleration(self, position: Vector) -> Vector:
        """Its acceleration: the frame rotates, so d/dt = d/dt|body + Omega x (Eqs. 4.5, 4.6)."""
        turning = self._rates((p, q, r))
        central = self._rates((u, v, w)) + cross(self.OMEGA, self.V0)
        return central + cross(turning, position) + cross(self.OMEGA, cross(self.OMEGA, position))

    @cached_property
    def _directions(self) -> sp.Matrix:
        """Ground axes (rows) along body axes, entry by entry."""
        if self.is_level:
            return rotation(is_level=True)
        return sp.Matrix(3, 3, [_direction(row, column) for row in "XYZ" for column in "xyz"])

    @property
    def ground(self) -> tuple[Vector, Vector, Vector]:
        """Unit vectors along the runway, to its right, and down."""
        forward, right, down = (along_body(self._directions.row(n).T) for n in range(3))
        return forward, right, down

    def feel(self, part: Part) -> Felt:
        """What the law of a part is told."""
        forward, right, down = self.ground
        velocity = self.velocity(part.at)
        return Felt(
            position=part.at,
            velocity=velocity,
            acceleration=self.acceleration(part.at),
            air_velocity=velocity - along_body(sp.Matrix(_WIND)),
            rates=self.OMEGA,
            forward=forward,
            right=right,
            down=down,
            depth=None if self.is_level else Z + part.at.dot(down),
        )

    def surroundings(self) -> Chain:
        """Direction of the axes, the wind along them, and the angle of sideslip."""
        named = () if self.is_level else self._named_directions()
        wind = self._directions.T * sp.Matrix([wind_x, wind_y, 0])
        winds = (Equation(q, e, "wind") for q, e in zip(_WIND, wind, strict=True))
        forward = self._motion[u]
        angle = sp.atan(v / forward) if forward is u_held else sp.atan2(v, forward)
        return (*named, *winds, Equation(beta, angle, "Eq. 4.20"))

    def _named_directions(self) -> Chain:
        entries = rotation(is_level=False)
        return tuple(
            Equation(self._directions[n], entries[n], "rotation by psi, theta, phi")
            for n in range(9)
        )

    # --- The balance --------------------------------------------------------------------------

    def sums(self, forces: Iterable[Force]) -> tuple[sp.Expr, ...]:
        """Sums of forces and of moments about the CG, the weight among them (Eq. 4.8)."""
        force: Vector = m * g * self.ground[2]
        moment = Vector(0)
        for each in forces:
            force = force + each.vector
            moment = moment + cross(each.at, each.vector) + each.couple
        return (*components(force), *components(moment))

    def inertial(self) -> tuple[sp.Expr, ...]:
        """Rates of momentum and of angular momentum along body axes (Eqs. 4.1, 4.2)."""
        momentum = m * self.acceleration(Vector(0))
        turning, spin = self._rates((p, q, r)), self.OMEGA
        momentum_of = (
            sp.diag(Ixx, Iyy, Izz)
            if self.is_level
            else sp.Matrix([[Ixx, 0, -Ixz], [0, Iyy, 0], [-Ixz, 0, Izz]])
        )
        angular = along_body(momentum_of * components(turning)) + cross(
            spin, along_body(momentum_of * components(spin))
        )
        return (*components(momentum), *components(angular))

    def newton(self, sums: Sequence[sp.Expr]) -> Iterator[Equation]:
        """The balance, solved for the accelerations (Eq. 4.9) and for what is carried."""
        residual = [a - s for a, s in zip(self.inertial(), sums, strict=True)]
        free = [n for n, s in enumerate(SPEEDS) if s not in self._held]
        solution = sp.solve([residual[n] for n in free], self.accelerations, dict=True)[0]
        central = components(self.acceleration(Vector(0)))
        for n in free:
            yield Equation(ACCELERATIONS[n], sp.expand(solution[ACCELERATIONS[n]]), "Eq. 4.9")
        for quantity, value in zip((a_x, a_y, a_z), central, strict=True):
            if value.free_symbols & set(self.accelerations):
                yield Equation(quantity, value, "Eq. 4.7")
        for n, s in enumerate(SPEEDS):
            if s in self._held and (carried := sp.expand(residual[n])) != 0:
                yield Equation(CARRIED[n], -carried if n == 2 else carried, "held balance")

    # --- The path -----------------------------------------------------------------------------

    def path_rates(self) -> dict[Quantity, sp.Expr]:
        """Rates of where the body is: its velocity, resolved along ground axes."""
        over_ground = self._directions * components(self.V0)
        along = {X: over_ground[0], Y: over_ground[1]}
        if self.is_level:
            return along | {psi: r}
        turning = attitude_rates()
        return along | {
            Z: over_ground[2],
            phi: turning[phi],
            theta: turning[theta],
            psi: turning[psi],
        }


def _direction(ground: str, body: str) -> Quantity:
    meaning = f"component of the body {body} axis along the ground's {ground} axis"
    return Quantity(f"R_{ground}{body}", f"direction_{ground}{body}", "1", meaning)
