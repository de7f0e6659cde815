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
    """The accelerations where forces are linear in them: an effective mass matrix, eliminated.

    Forward elimination and back substitution, a link for each entry: a mass matrix is positive
    definite, so no pivot vanishes.
    """
    unknown = body.accelerations
    rows = [n for n, speed in enumerate(SPEEDS) if speed in body.speeds]
    residual = [body.inertial()[n] - sums[n] for n in rows]
    matrix = sp.Matrix(residual).jacobian(unknown)
    if matrix.free_symbols & set(unknown):
        raise ValueError(f"{name}: a force is not linear in the accelerations")
    rest = [-e.xreplace(dict.fromkeys(unknown, sp.Integer(0))) for e in residual]
    elimination = _Elimination(rows)
    for n, row in enumerate(rows):
        for c, column in enumerate(rows):
            elimination.define_mass(row, column, sp.expand(matrix[n, c]))
        elimination.define_load(row, rest[n])
    elimination.forward()
    return (*elimination.chain, *elimination.back(unknown))


class _Elimination:
    """Named entries of a mass matrix and of a load, and the chain that eliminates them."""

    def __init__(self, rows: Sequence[int]) -> None:
        self.rows = rows
        self.chain: list[Equation] = []
        self._mass: dict[tuple[int, int], sp.Expr] = {}
        self._load: dict[int, sp.Expr] = {}

    def define_mass(self, row: int, column: int, value: sp.Expr, less: int | None = None) -> None:
        """Resistance along one axis to an acceleration along another, with what is eliminated."""
        where = f"{SPEEDS[row]}{SPEEDS[column]}" + _less(less)
        meaning = f"resistance along {SPEEDS[row]} to an acceleration along {SPEEDS[column]}"
        unit = _MASS[row > 2, column > 2]
        named = Quantity(f"mass_{where}", f"effective_mass_{where}", unit, meaning + _free(less))
        self._mass[row, column] = self._define(named, value)

    def define_load(self, row: int, value: sp.Expr, less: int | None = None) -> None:
        """Sum along an axis at no acceleration."""
        where = f"{SPEEDS[row]}" + _less(less)
        unit, meaning = "N m" if row > 2 else "N", f"sum along {SPEEDS[row]} at no acceleration"
        named = Quantity(f"rest_{where}", f"rest_{where}", unit, meaning + _free(less))
        self._load[row] = self._define(named, value)

    def _define(self, named: Quantity, value: sp.Expr) -> sp.Expr:
        if value.is_Number or value.is_Symbol:
            return value
        self.chain.append(Equation(named, value, "effective mass"))
        return named

    def forward(self) -> None:
        """Take each acceleration out of the rows below its own."""
        for n, pivot in enumerate(self.rows):
            for row in self.rows[n + 1 :]:
                if self._mass[row, pivot] == 0:
                    continue
                part = self._mass[row, pivot] / self._mass[pivot, pivot]
                for column in self.rows[n + 1 :]:
                    if self._mass[pivot, column] != 0:
                        less = self._mass[row, column] - part * self._mass[pivot, column]
                        self.define_mass(row, column, less, pivot)
                self.define_load(row, self._load[row] - part * self._load[pivot], pivot)

    def back(self, unknown: Sequence[Quantity]) -> Chain:
        """The accelerations, the last first."""
        found = dict(zip(self.rows, unknown, strict=True))
        solved = []
        for n, row in reversed(list(enumerate(self.rows))):
            known = sum((self._mass[row, c] * found[c] for c in self.rows[n + 1 :]), sp.S.Zero)
            value = (self._load[row] - known) / self._mass[row, row]
            solved.append(Equation(found[row], value, "Eq. 4.9"))
        return tuple(solved)


_MASS = {
    (False, False): "kg",
    (False, True): "kg m",
    (True, False): "kg m",
    (True, True): "kg m^2",
}


def _less(pivot: int | None) -> str:
    return "" if pivot is None else f"_less_{SPEEDS[pivot]}"


def _free(pivot: int | None) -> str:
    return "" if pivot is None else f", {SPEEDS[pivot]} and those before it free"


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
