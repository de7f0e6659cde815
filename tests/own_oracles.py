"""The models in ``tests/models`` once more, independently: NumPy from textbooks, and Kane's method.

Each takes the values of all states, inputs and parameters by symbol and gives the rates, as
``v_dot``, and the outputs. Nothing here knows of `derive`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache
from math import atan, atan2, cos, sin, tanh
from typing import Any

import numpy as np
import sympy as sp
from sympy.physics.mechanics import (
    KanesMethod,
    Particle,
    Point,
    ReferenceFrame,
    RigidBody,
    dynamicsymbols,
    inertia,
)

Values = Mapping[str, float]
#: Where a force acts, the force, and a couple beside it, along body axes.
Act = tuple[Sequence[float], Sequence[float], Sequence[float]]


def act(at: Sequence[float], force: Sequence[float], couple: Sequence[float] = (0, 0, 0)) -> Act:
    return at, force, couple


def planar(s: Values, acts: Sequence[Act], held: bool) -> dict[str, float]:
    """Newton and Euler of a body that stays level (Milliken, ch. 4; SAE axes)."""
    force = sum((np.array(f, float) for _, f, _ in acts), np.zeros(3))
    moment = sum((np.cross(at, f) + np.array(c, float) for at, f, c in acts), np.zeros(3))
    found = {"sum_F": force[1], "sum_M": moment[2], "a_y": force[1] / s["m"]}
    found |= {"v_dot": force[1] / s["m"] - s["r"] * s["u"], "r_dot": moment[2] / s["Izz"]}
    found |= {"N_held": s["m"] * s["g"] + force[2], "Mx_held": -moment[0], "My_held": -moment[1]}
    if held:  # what pushes makes up for what drags, and for the turning of the velocity
        found["F_held"] = -s["m"] * s["v"] * s["r"] - force[0]
    else:
        found |= {"sum_Fx": force[0], "a_x": force[0] / s["m"]}
        found["u_dot"] = force[0] / s["m"] + s["v"] * s["r"]
    return found | path(s)


def path(s: Values) -> dict[str, float]:
    """The velocity over the ground."""
    along, across = cos(s["psi"]), sin(s["psi"])
    return {
        "X_dot": s["u"] * along - s["v"] * across,
        "Y_dot": s["u"] * across + s["v"] * along,
        "psi_dot": s["r"],
    }


def two_axles(s: Values, steering: float) -> dict[str, float]:
    """A single-track car of two linear axles whose forces are across the body."""
    front = atan((s["v"] + s["l_front"] * s["r"]) / s["u"]) - steering
    rear = atan((s["v"] - s["l_rear"] * s["r"]) / s["u"])
    F_front, F_rear = s["C_front"] * front, s["C_rear"] * rear
    acts = [
        act((s["l_front"], 0, 0), (0, -F_front, 0)),
        act((-s["l_rear"], 0, 0), (0, -F_rear, 0)),
    ]
    shown = {"alpha_front": front, "alpha_rear": rear, "F_front": F_front, "F_rear": F_rear}
    return shown | planar(s, acts, held=True)


def single_track(s: Values) -> dict[str, float]:
    return two_axles(s, s["steering"])


def driver(s: Values) -> dict[str, float]:
    wanted = -s["K_psi"] * s["psi"] - s["K_Y"] * (s["Y"] - s["lane"])
    own = {"turned_dot": (wanted - s["turned"]) / s["T_driver"], "steering": s["turned"]}
    return own | two_axles(s, s["turned"])


def four_wheels(s: Values) -> dict[str, float]:
    """Each wheel by itself: its velocity, its slip, its forces in its own axes, turned back."""
    shown, acts = {}, []
    for end, x, C in (("front", s["l_front"], "C_front"), ("rear", -s["l_rear"], "C_rear")):
        for side, sign in (("left", -1), ("right", 1)):
            y, angle = sign * s["width"] / 2, s["steering"] if end == "front" else 0.0
            along, across = s["u"] - y * s["r"], s["v"] + x * s["r"]
            slip = atan2(across, along) - angle
            F, B = s[C] / 2 * slip, s["grip"] * s["wheel_load"] * s[f"brake_{side}"]
            B *= np.sign(along)
            force = -(B + 1j * F) * np.exp(1j * angle)
            acts.append(act((x, y, 0), (force.real, force.imag, 0)))
            shown |= {f"{q}_{end}_{side}": n for q, n in (("alpha", slip), ("F", F), ("B", B))}
    return shown | planar(s, acts, held=False)


def lagging(s: Values) -> dict[str, float]:
    gear = atan((s["v"] + s["arm"] * s["r"]) / s["u"])
    tail = atan((s["v"] - s["tail"] * s["r"]) / s["u"])
    F_gear, F_tail = s["C_main"] * tanh(gear), s["C_tail"] * s["late_tail"]
    acts = [
        act((s["arm"], 0, 0), (0, -F_gear, 0)),
        act((-s["tail"], 0, 0), (0, s["push"] - F_tail, 0)),
    ]
    shown = {"alpha_gear": gear, "alpha_tail": tail, "F_gear": F_gear, "F_tail": F_tail}
    late = {"late_tail_dot": (tail - s["late_tail"]) / s["lag"]}
    return shown | late | planar(s, acts, held=True)


def corners(s: Values) -> dict[str, float]:
    a, shown, acts = s["arm"], {}, []
    for end, x, angle in (("front", a, s["steering"]), ("rear", -a, 0.0)):
        slip = atan2(s["v"] + x * s["r"], s["u"]) - angle
        F = float(np.clip(s["C"] * slip, -s["limit"], s["limit"]))
        acts.append(act((x, 0, 0), (0, -F, 0)))
        shown |= {f"alpha_{end}": slip, f"F_{end}": F}
    D = s["scrub"] * s["u"] * abs(s["u"]) + s["hold"] * s["brake"] * tanh(s["u"] / s["crawl"])
    F = s["scrub"] * s["v"] * abs(s["v"])
    beyond = s["Y"] - float(np.clip(s["Y"], -s["wall"], s["wall"]))
    W = -s["k_wall"] * beyond
    acts += [act((0, 0, 0), (-D, -F, 0)), act((0, 0, 0), (W * sin(s["psi"]), W * cos(s["psi"]), 0))]
    return shown | {"D_slower": D, "F_slower": F, "W": W} | planar(s, acts, held=False)


def level_loads(s: Values) -> dict[str, float]:
    """Loads from moments about the other axle: weight and lift, wing and propeller."""
    a, b, z, u = s["l_front"], s["l_rear"], s["z_ground"], s["u"]
    lift = s["L_q"] * u**2
    pitch = s["x_wing"] * lift + s["M_q"] * u**2 - s["z_thrust"] * s["thrust"]
    carried = s["m"] * s["g"] - lift
    rear = max(0.0, (carried * a + pitch) / (a + b))
    front = max(0.0, (carried * b - pitch) / (a + b)) / 2
    shown, acts = {"lift": lift}, []
    for name, x, y, load in (
        ("left", a, -s["half"], front),
        ("right", a, s["half"], front),
        ("rear", -b, 0.0, rear),
    ):
        F = s["C_load"] * load * atan2(s["v"] + x * s["r"], u - y * s["r"])
        B = s["grip"] * load * s["brake"]
        acts.append(act((x, y, z), (-B, -F, 0)))
        shown |= {f"Fz_{name}": load, f"F_{name}": F, f"B_{name}": B}
    acts.append(act((s["x_wing"], 0, 0), (0, 0, -lift), (0, s["M_q"] * u**2, 0)))
    acts.append(act((0, 0, -s["z_thrust"]), (s["thrust"], 0, 0)))
    return shown | planar(s, acts, held=False)


# --- By Kane's method ---------------------------------------------------------------------------


def solved(
    kane: KanesMethod, bodies: Sequence[Any], loads: Sequence[Any], more: Sequence[sp.Expr]
) -> Callable[[Mapping[str, float]], tuple[np.ndarray, list[float]]]:
    """Rates of the speeds, and more expressions, at values by name."""
    kane.kanes_equations(bodies, loads)
    expressions = [kane.mass_matrix, kane.forcing, *more]
    moving = [*kane.q, *kane.u]
    plain = {f: sp.Symbol(f.func.__name__) for f in moving}
    expressions = [sp.sympify(e).subs(kane.kindiffdict()).subs(plain) for e in expressions]
    names = sorted({s.name for e in expressions for s in e.free_symbols})
    f = sp.lambdify([sp.Symbol(n) for n in names], expressions, "numpy", cse=True)

    def at(values: Mapping[str, float]) -> tuple[np.ndarray, list[float]]:
        mass, forcing, *rest = f(*(values[n] for n in names))
        return np.linalg.solve(mass, forcing).ravel(), [float(x) for x in rest]

    return at


@cache
def _table() -> Callable[[Mapping[str, float]], tuple[np.ndarray, list[float]]]:
    """A rigid body on three legs with a particle on it, in six degrees of freedom."""
    names = "m Ixx Iyy Izz Ixz g x_leg y_leg z_leg k_leg c_leg d_foot m_load x_load y_load z_load"
    (m, Ixx, Iyy, Izz, Ixz, g, x, y, z, k, c, d, m_load, x_load, y_load, z_load) = sp.symbols(names)
    push = sp.Symbol("push")
    X, Y, Z, psi, theta, phi = q = dynamicsymbols("X Y Z psi theta phi")
    u, v, w, p, q_, r = speeds = dynamicsymbols("u v w p q r")
    ground, origin = ReferenceFrame("N"), Point("O")
    body = ground.orientnew("B", "Body", (psi, theta, phi), "ZYX")
    spin = body.ang_vel_in(ground)  # by the rates of the angles
    turning = [spin.dot(e) - s for e, s in zip(body, (p, q_, r), strict=True)]
    cg = origin.locatenew("CG", X * ground.x + Y * ground.y + Z * ground.z)
    origin.set_vel(ground, 0)
    moving = X.diff() * ground.x + Y.diff() * ground.y + Z.diff() * ground.z
    velocity = u * body.x + v * body.y + w * body.z
    path = [(moving - velocity).dot(e) for e in ground]
    rates = sp.solve([*path, *turning], [s.diff() for s in q])
    body.set_ang_vel(ground, p * body.x + q_ * body.y + r * body.z)
    cg.set_vel(ground, velocity)
    down = ground.z
    loads: list[Any] = [(cg, m * g * down)]
    shown = []
    for name, at in (
        ("left", x * body.x - y * body.y + z * body.z),
        ("right", x * body.x + y * body.y + z * body.z),
        ("behind", -x * body.x + z * body.z),
    ):
        foot = cg.locatenew(name, at)
        over = foot.v2pt_theory(cg, ground, body)
        N = k * (Z + at.dot(down)) + c * over.dot(down)
        loads.append((foot, -N * down - d * (over - over.dot(down) * down)))
        shown.append(N)
    place = cg.locatenew("top", x_load * body.x + y_load * body.y - z_load * body.z)
    place.v2pt_theory(cg, ground, body)
    loads += [(place, m_load * g * down + push * ground.x)]
    moments = inertia(body, Ixx, Iyy, Izz, 0, 0, -Ixz)
    bodies = [RigidBody("table", cg, body, m, (moments, cg)), Particle("load", place, m_load)]
    differential = [s.diff() - rates[s.diff()] for s in q]
    kane = KanesMethod(ground, list(q), list(speeds), kd_eqs=differential)
    return solved(kane, bodies, loads, [*(rates[s.diff()] for s in q), *shown])


def table(s: Values) -> dict[str, float]:
    rates, more = _table()(s)
    names = ("X", "Y", "Z", "psi", "theta", "phi")
    found = {f"{n}_dot": float(x) for n, x in zip("uvwpqr", rates, strict=True)}
    found |= {f"{n}_dot": x for n, x in zip(names, more[:6], strict=True)}
    found |= dict(zip(("N_left", "N_right", "N_behind"), more[6:], strict=True))
    return found | balance(s, found)


def balance(s: Values, rates: Values) -> dict[str, float]:
    """What the accelerations say of the sums, in six degrees of freedom or in the plane."""
    V = np.array([s["u"], s["v"], s.get("w", 0.0)])
    spin = np.array([s.get("p", 0.0), s.get("q", 0.0), s["r"]])
    dV, dspin = (np.array([rates.get(f"{n}_dot", 0.0) for n in group]) for group in ("uvw", "pqr"))
    a = dV + np.cross(spin, V)
    Ixx, Iyy, Ixz = s.get("Ixx", 0.0), s.get("Iyy", 0.0), s.get("Ixz", 0.0)
    moments = np.array([[Ixx, 0, -Ixz], [0, Iyy, 0], [-Ixz, 0, s["Izz"]]])
    M = moments @ dspin + np.cross(spin, moments @ spin)
    sums = ("sum_Fx", "sum_F", "sum_Fz", "sum_Mx", "sum_My", "sum_M")
    return dict(zip(sums, [*(s["m"] * a), *M], strict=True)) | dict(
        zip(("a_x", "a_y", "a_z"), a, strict=True)
    )


@cache
def _trailer() -> Callable[[Mapping[str, float]], tuple[np.ndarray, list[float]]]:
    """Two rigid bodies in the plane with a hinge between them."""
    names = "m Izz m_trailer I_trailer l_front l_rear l_hitch l_trailer l_axle"
    m, Izz, m_t, I_t, a, b, h, l_t, L_t = sp.symbols(names)
    C_front, C_rear, C_t, steering = sp.symbols("C_front C_rear C_trailer steering")
    X, Y, psi, bend = q = dynamicsymbols("X Y psi bend_hitch")
    u, v, r, bending = speeds = dynamicsymbols("u v r bending_hitch")
    ground, origin = ReferenceFrame("N"), Point("O")
    car = ground.orientnew("C", "Axis", (psi, ground.z))
    towed = car.orientnew("T", "Axis", (bend, car.z))
    wheel = car.orientnew("W", "Axis", (steering, car.z))
    car.set_ang_vel(ground, r * car.z)
    towed.set_ang_vel(car, bending * car.z)
    cg = origin.locatenew("CG", X * ground.x + Y * ground.y)
    cg.set_vel(ground, u * car.x + v * car.y)
    front, rear = cg.locatenew("front", a * car.x), cg.locatenew("rear", -b * car.x)
    hitch = cg.locatenew("hitch", -h * car.x)
    for point in (front, rear, hitch):
        point.v2pt_theory(cg, ground, car)
    mass = hitch.locatenew("mass", -l_t * towed.x)
    axle = hitch.locatenew("axle", -L_t * towed.x)
    for point in (mass, axle):
        point.v2pt_theory(hitch, ground, towed)
    loads, shown = [], []
    for point, C, axes, along in (
        (front, C_front, wheel, car),
        (rear, C_rear, car, car),
        (axle, C_t, towed, towed),
    ):
        over = point.vel(ground)
        slip = sp.atan2(over.dot(along.y), over.dot(along.x))
        slip -= steering if point is front else 0
        loads.append((point, -C * slip * axes.y))
        shown += [slip, C * slip]
    bodies = [
        RigidBody("car", cg, car, m, (inertia(car, 0, 0, Izz), cg)),
        RigidBody("trailer", mass, towed, m_t, (inertia(towed, 0, 0, I_t), mass)),
    ]
    differential = [
        X.diff() - (u * sp.cos(psi) - v * sp.sin(psi)),
        Y.diff() - (u * sp.sin(psi) + v * sp.cos(psi)),
        psi.diff() - r,
        bend.diff() - bending,
    ]
    kane = KanesMethod(ground, list(q), list(speeds), kd_eqs=differential)
    return solved(kane, bodies, loads, shown)


def trailer(s: Values) -> dict[str, float]:
    rates, shown = _trailer()(s)
    names = ("u_dot", "v_dot", "r_dot", "bending_hitch_dot")
    found = dict(zip(names, map(float, rates), strict=True))
    of = [f"{q}_{end}" for end in ("front", "rear", "hitch") for q in ("alpha", "F")]
    found |= dict(zip(of, shown, strict=True)) | path(s)
    found |= {"bend_hitch_dot": s["bending_hitch"], "N_held": s["m"] * s["g"]}
    return balance(s, found) | found


ORACLES: dict[str, Callable[[Values], dict[str, float]]] = {
    f.__name__: f
    for f in (
        single_track,
        four_wheels,
        lagging,
        corners,
        trailer,
        table,
        driver,
        level_loads,
    )
}
