"""What a body makes of the forces on it: accelerations, what is carried, loads on the wheels."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from .body import SPEEDS, SUMS, Body
from .equation import Chain, Equation, expand, needed, ordered
from .frames import components, i
from .part import Force, Fz, Part
from .quantity import Quantity


def accelerations(name: str, body: Body, forces: Sequence[Force], laws: Chain) -> Chain:
    """Sums of forces and moments, the accelerations, and what the constraints carry.

    The balance is solved with the sums as symbols: what they are made of stays in the chain above
    and is never multiplied out. Forces that are linear in the accelerations are solved with them.
    """
    sums = body.sums(forces)
    felt = _depending(laws, set(body.accelerations))
    coupled = any(s.free_symbols & ({e.lhs for e in felt} | set(body.accelerations)) for s in sums)
    is_free = [speed in body.speeds for speed in SPEEDS]
    named = [q if free and s != 0 else s for q, s, free in zip(SUMS, sums, is_free, strict=True)]
    definitions = tuple(
        Equation(q, s, "Eq. 4.8")
        for q, s, free in zip(SUMS, sums, is_free, strict=True)
        if free and s != 0
    )
    balance = tuple(body.newton(named))
    if not coupled:
        return (*definitions, *balance)
    solved = _solved(name, body, [expand(s, felt) for s in sums])
    return (*definitions, *solved, *(e for e in balance if e.lhs not in body.accelerations))


def _depending(chain: Chain, on: set[Quantity]) -> Chain:
    """The equations that depend on some quantities, in order."""
    moving, kept = set(on), []
    for equation in ordered(chain):
        if equation.rhs.free_symbols & moving:
            moving.add(equation.lhs)
            kept.append(equation)
    return tuple(kept)


def _solved(name: str, body: Body, sums: Sequence[sp.Expr]) -> Chain:
    """The accelerations where forces are linear in them: an effective mass matrix, inverted."""
    unknown = body.accelerations
    rows = [n for n, speed in enumerate(SPEEDS) if speed in body.speeds]
    residual = [body.inertial()[n] - sums[n] for n in rows]
    matrix = sp.Matrix(residual).jacobian(unknown)
    if matrix.free_symbols & set(unknown):
        raise ValueError(f"{name}: a force is not linear in the accelerations")
    rest = [-e.xreplace(dict.fromkeys(unknown, sp.Integer(0))) for e in residual]
    mass, load = _names(body, rows)
    chain = [
        Equation(mass[n], sp.expand(matrix[n]), "effective mass")
        for n in range(len(mass))
        if matrix[n] != 0
    ]
    chain += [Equation(q, e, "Eq. 4.8 at no acceleration") for q, e in zip(load, rest, strict=True)]
    symbols = sp.Matrix(
        len(rows), len(rows), [mass[n] if matrix[n] != 0 else 0 for n in range(len(mass))]
    )
    solution = symbols.LUsolve(sp.Matrix(load))
    chain += [
        Equation(q, sp.together(e), "Eq. 4.9") for q, e in zip(unknown, solution, strict=True)
    ]
    return tuple(chain)


def _names(body: Body, rows: Sequence[int]) -> tuple[list[Quantity], list[Quantity]]:
    """Entries of the effective mass matrix, and the loads at no acceleration."""
    units = {(0, 0): "kg", (0, 1): "kg m", (1, 0): "kg m", (1, 1): "kg m^2"}
    mass = [
        Quantity(
            f"mass_{SPEEDS[n]}{SPEEDS[c]}",
            f"effective_mass_{SPEEDS[n]}{SPEEDS[c]}",
            units[n > 2, c > 2],
            f"resistance along {SPEEDS[n]} to an acceleration along {SPEEDS[c]}",
        )
        for n in rows
        for c in rows
    ]
    load = [
        Quantity(
            f"rest_{SPEEDS[n]}",
            f"rest_{SPEEDS[n]}",
            "N m" if n > 2 else "N",
            f"sum along {SPEEDS[n]} at no acceleration",
        )
        for n in rows
    ]
    return mass, load


def loads(
    name: str, body: Body, parts: Sequence[Part], forces: Sequence[Force], laws: Chain
) -> Chain:
    """Loads of the parts that stand on the ground, where the body is level.

    Weight, lift and aerodynamic pitching moment are shared by two axles; what the parts on the
    ground do themselves is left to what carries the body, so that loads and accelerations make no
    loop. Parts of one axle share its load. A load never pulls.
    """
    defined = {e.lhs for e in laws}
    standing = {
        n: load
        for n, (part, force) in enumerate(zip(parts, forces, strict=True))
        if (load := Fz.of(part.name if part.suffix is None else part.suffix)) not in defined
        and load in _used(force)
    }
    if not standing:
        return ()
    if not body.is_level:
        missing = ", ".join(map(str, standing.values()))
        raise ValueError(f"{name}: {missing}: on legs the law of a wheel makes its own load")
    symbols = set(standing.values())
    others = [f for n, f in enumerate(forces) if not _depends(f, laws, symbols)]
    down = body.sums(others)[2]
    pitching = body.sums(others)[4]
    axles: dict[sp.Expr, list[int]] = {}
    for n in standing:
        axles.setdefault(parts[n].at.dot(i), []).append(n)
    if len(axles) != 2:
        raise ValueError(
            f"{name}: loads of a level body follow for wheels on two axles, not on {len(axles)};"
            " give the loads as parameters, or let the body stand on legs"
        )
    (front, first), (rear, second) = axles.items()
    on_front = (-pitching - down * rear) / (front - rear)
    on_rear = (-pitching - down * front) / (rear - front)
    return tuple(
        Equation(standing[n], sp.Max(axle / len(wheels), 0), "balance of weight and lift")
        for axle, wheels in ((on_front, first), (on_rear, second))
        for n in wheels
    )


def _used(force: Force) -> set[sp.Symbol]:
    vectors = (*components(force.vector), *components(force.couple))
    expressions = (*vectors, *(e.rhs for e in force.chain), *map(sp.sympify, force.rates.values()))
    return {s for expr in expressions for s in expr.free_symbols}


def _depends(force: Force, laws: Chain, symbols: set[Quantity]) -> bool:
    """Whether a force depends on any of some quantities."""
    vectors = (*components(force.vector), *components(force.couple))
    chain = needed(laws, vectors)
    used = {s for expr in (*vectors, *(e.rhs for e in chain)) for s in expr.free_symbols}
    return bool(used & symbols)
