"""Every model that has a pack, shipped or not, and what SymPy makes of its equations.

Nothing here comes from what is generated but the order of vectors. A model that is added to the
packs, or to ``tests/models``, is proved by every test that goes over `NAMES`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Any

import numpy as np
import sympy as sp
from hypothesis import strategies as st
from oracles import RANGES
from own_models import HERE, PLANES, own
from own_models import NAMES as OWN

import groundroll as gr
from groundroll.derive.core.equation import Chain, needed
from groundroll.derive.core.model import Derivation
from groundroll.derive.core.quantity import Constant
from groundroll.derive.emit.catalogue import packs
from groundroll.derive.emit.own import find_model
from groundroll.generated import pack_of
from groundroll.model.models import Model
from groundroll.model.names import FUNCTIONS
from groundroll.model.names import MODELS as SHIPPED

Array = np.ndarray[Any, np.dtype[np.float64]]
Point = tuple[Array, Array, Array]

NAMES = (*SHIPPED, *OWN)

#: Functions of the vectors of a model; all others that ship are of scalars.
OF_MODELS = ("rhs", "outputs", "jacobians", "rk4", "rk45", "places")
OF_SCALARS = [n for n in FUNCTIONS if n.removeprefix(f"{pack_of(n).name}_") not in OF_MODELS]

#: From where states and inputs are drawn, by symbol or by what it begins with; `_ELSE` otherwise.
_MOVING: dict[str, tuple[float, float]] = {
    "u": (5.0, 40.0),
    "v": (-3.0, 3.0),
    "w": (-0.5, 0.5),
    "p": (-0.3, 0.3),
    "q": (-0.3, 0.3),
    "r": (-0.4, 0.4),
    "X": (0.0, 300.0),
    "Y": (-9.0, 9.0),
    "Z": (-1.1, -0.8),
    "phi": (-0.05, 0.05),
    "theta": (-0.03, 0.03),
    "psi": (-3.0, 3.0),
    "brake": (0.1, 0.9),
    "wind": (-4.0, 4.0),
    "thrust": (0.0, 800.0),
    "push": (-1e3, 1e3),
    "F_disturbance": (-2e3, 2e3),
    "steering": (-0.2, 0.2),
    "rudder": (-0.4, 0.4),
    "aileron": (-0.3, 0.3),
    "elevator": (-0.3, 0.3),
}
_ELSE = (-0.5, 0.5)


@dataclass(frozen=True)
class Case:
    """A model: its pack, its equations, and from where its numbers are drawn.

    Attributes
    ----------
    pack : Model
    derived : Derivation
    plane : Aircraft
        An aircraft, or a car.
    """

    pack: Model
    derived: Derivation
    plane: gr.Aircraft

    @cached_property
    def typical(self) -> Mapping[str, float]:
        """Its parameters."""
        p = self.plane.parameters(self.pack)
        return dict(zip(self.pack.parameters, map(float, p), strict=True))

    @property
    def groups(self) -> dict[str, tuple[sp.Symbol, ...]]:
        """States, inputs and parameters under the names of their vectors."""
        return {"x": self.derived.states, "u": self.derived.inputs, "p": self.derived.parameters}

    def range(self, symbol: str, is_parameter: bool) -> tuple[float, float]:
        """From where a quantity is drawn."""
        if self.pack.name in ("linear", "nonlinear"):
            return RANGES[symbol]
        if not is_parameter:
            near = [n for n in (symbol, symbol.split("_")[0]) if n in _MOVING]
            return _MOVING[near[0]] if near else _ELSE
        middle = self.typical[symbol]
        if middle == 0:
            return 0.05, 0.15  # whatever it is, it should count
        low, high = sorted((0.8 * middle, 1.2 * middle))
        return low, high

    def points(self) -> st.SearchStrategy[Point]:
        """States, inputs and parameters, each at one of a thousand steps through its range."""

        def drawn(group: str) -> st.SearchStrategy[Array]:
            ranges = [self.range(str(q), group == "p") for q in self.groups[group]]
            steps = st.tuples(*[st.integers(0, 1000)] * len(ranges))
            low, high = (np.array(side) for side in zip(*ranges, strict=True)) if ranges else _NONE
            return steps.map(lambda n: low + (high - low) * np.array(n, float) / 1000)

        return st.tuples(*map(drawn, self.groups))

    def some(self, count: int, seed: int = 0) -> list[Point]:
        """Some of these points, always the same."""
        rng = np.random.default_rng(seed)
        return [tuple(self._at(g, rng) for g in self.groups) for _ in range(count)]  # type: ignore[misc]

    def _at(self, group: str, rng: np.random.Generator) -> Array:
        ranges = [self.range(str(q), group == "p") for q in self.groups[group]]
        return np.array([rng.uniform(*r) for r in ranges])

    def span(self, group: str) -> Array:
        """How far each entry of a vector ranges."""
        return np.array([np.ptp(self.range(str(q), group == "p")) for q in self.groups[group]])

    @cached_property
    def rates(self) -> Callable[[Array, Array, Array], Array]:
        """x' = f(x, u, p) in NumPy, as SymPy prints it."""
        f = program(self.derived, self.derived.rates)
        return lambda x, u, p: np.array(f(*x, *u, *p), float)

    @cached_property
    def outputs(self) -> Callable[[Array, Array, Array], Array]:
        """y = g(x, u, p) in NumPy, as SymPy prints it."""
        g = program(self.derived, self.derived.outputs)
        return lambda x, u, p: np.array(g(*x, *u, *p), float)


_NONE = np.zeros(0), np.zeros(0)


def program(
    model: Derivation, results: Iterable[sp.Expr], modules: str = "numpy"
) -> Callable[..., list[Any]]:
    """Expressions in the quantities of a model, of its states, inputs and parameters."""
    arguments = (*model.states, *model.inputs, *model.parameters)
    return evaluated(arguments, model.chain, results, modules)


def evaluated(
    arguments: Iterable[sp.Symbol],
    chain: Chain,
    results: Iterable[sp.Expr],
    modules: str = "numpy",
    constant: Callable[[Constant], float] = lambda c: c.value,
) -> Callable[..., list[Any]]:
    """Expressions in the quantities of a chain, computed link by link.

    Parameters
    ----------
    arguments : iterable of Symbol
    chain : tuple of Equation
    results : iterable of Expr
    modules : str
        Whose numbers, as `sympy.lambdify` has it.
    constant : callable
        Value of each constant that has a unit; its own in SI.
    """

    def plain(expr: sp.Expr) -> sp.Expr:
        return expr.xreplace({c: sp.Float(constant(c), 17) for c in expr.atoms(Constant)})

    expressions = [plain(sp.sympify(e)) for e in results]
    links = [(e.lhs, plain(e.rhs)) for e in needed(chain, expressions)]
    made: Callable[..., list[Any]] = sp.lambdify(
        list(arguments), expressions, modules=modules, cse=lambda each: (links, each)
    )
    return made


@cache
def case(name: str) -> Case:
    """The model of this name."""
    if name in OWN:
        pack = own(name)
        plane, derived = PLANES[name], find_model(HERE / f"{name}.py").derive()
    else:
        pack, derived = Model.load(name), derivations()[name]
        plane = gr.Aircraft.load("brott" if name in _THESIS else "cessna-170")
    return Case(pack, derived, plane)


_THESIS = ("linear", "nonlinear")


@cache
def derivations() -> dict[str, Derivation]:
    """The models that ship, as SymPy derives them."""
    return {pack.name: pack.model for pack in packs() if pack.model is not None}
