"""Oracles that several tests share: random aircraft, and the equations without CasADi.

Everything here comes from SymPy (`lambdify`, `diff`) or from the thesis's pages, never from what
is generated.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import cache
from math import degrees
from typing import Any, NamedTuple

import casadi as ca
import numpy as np
import sympy as sp
from hypothesis import strategies as st

from groundroll.derive.core.model import Derivation
from groundroll.derive.models.linear import linear
from groundroll.derive.models.nonlinear import nonlinear

Array = np.ndarray[Any, np.dtype[np.float64]]
Point = tuple[Array, Array, Array]

#: Both models, as SymPy derives them.
MODELS: dict[str, Derivation] = {"linear": linear(), "nonlinear": nonlinear()}

PER_DEGREE = degrees(1.0)  # from 1/deg to 1/rad

#: The thesis's aircraft in Trial 19, in SI: Tables 3.2, 4.1 and 4.7, App. A.5.
BROTT = {
    "m": 748.43,
    "Izz": 1760.0,
    "a": 0.64008,
    "b": 3.88112,
    "u": 100 / 3.6,
    "rho": 1.225,
    "Ap": 0.6929,
    "CL_gamma": 0.1 * PER_DEGREE,
    "C_alpha": 441.630 * PER_DEGREE,
    "Ct": 70.0 * PER_DEGREE,
    "Fz": 748.43 * 9.81 / 2,
    "B3": 0.2117 * PER_DEGREE,
    "C3": -2.2918e-5 * PER_DEGREE,
    "B5": 0.7221,
    "C5": -8.81055e-6,
    "B1": 0.7947,
    "C1": 0.1901,
    "D1": 6.1197,
    "E1": 1.0637,
    "g": 9.81,
}


class Trial(NamedTuple):
    """A trial of the thesis: what it changes in `BROTT`, and the eigenvalues printed for it."""

    changes: dict[str, float]
    eigenvalues: tuple[complex, complex]
    last_digits: tuple[float, float]


#: Tables 4.4, 4.6 (in which the last digit is not to be trusted) and 4.8.
TRIALS = {
    # printed 2.67, which is cut, not rounded
    3: Trial({"a": 0.5, "Ap": 0.0, "Ct": 0.0}, (-5.37, 2.677), (0.01, 0.001)),
    5: Trial(
        {"a": -0.5, "b": 3.92176, "Ct": 0.0}, (-1.6868 - 4.0996j, -1.6868 + 4.0996j), (2e-4, 2e-4)
    ),
    9: Trial(
        {"a": 0.0, "b": 3.92176, "Ct": 0.0}, (-1.5574 - 1.7867j, -1.5574 + 1.7867j), (2e-4, 2e-4)
    ),
    15: Trial({"a": 0.5, "b": 3.84048, "Ct": 0.0}, (-5.0403, 1.6909), (2e-4, 2e-4)),
    17: Trial({"Ct": 145.0 * PER_DEGREE}, (-3.24 - 1.98j, -3.24 + 1.98j), (0.01, 0.01)),
    19: Trial({}, (-4.84, -0.118), (0.01, 0.001)),
}

#: From where random values are drawn, by symbol; anything else is drawn from `_ELSE`.
RANGES: dict[str, tuple[float, float]] = {
    "v": (-5.0, 5.0),
    "r": (-2.0, 2.0),
    "y": (-9.0, 9.0),
    "theta": (-3.0, 3.0),
    "X": (0.0, 300.0),
    "Y": (-9.0, 9.0),
    "psi": (-3.0, 3.0),
    "F_disturbance": (-2e3, 2e3),
    "m": (300.0, 3000.0),
    "Izz": (400.0, 8000.0),
    "a": (-2.0, 2.0),
    "b": (1.0, 8.0),
    "u": (5.0, 60.0),
    "rho": (0.6, 1.4),
    "Ap": (0.1, 3.0),
    "CL_gamma": (1.0, 6.3),
    "C_alpha": (3e3, 5e4),
    "Ct": (500.0, 2e4),
    "Fz": (800.0, 5500.0),
    "B3": (9.0, 20.0),
    "C3": (-1.4e-3, 2e-4),
    "B5": (0.6, 1.0),
    "C5": (-9e-5, 1e-5),
    "B1": (0.5, 1.2),
    "C1": (0.15, 1.8),
    "D1": (0.8, 6.5),
    "E1": (-1.0, 1.2),
    "g": (9.7, 9.9),
    "h": (0.01, 0.5),
    "alpha": (0.01, 0.5),
    "alpha_bar": (-9.0, 9.0),
    "f": (0.5, 0.95),
    "F_y": (100.0, 3000.0),
    "F_peak": (1000.0, 5000.0),
    "mu": (0.4, 1.0),
    "C_c": (4.0, 20.0),
    "A_vv": (-9.0, 1.0),
    "A_vr": (-60.0, 0.0),
    "A_rv": (-2.0, 2.0),
    "A_rr": (-9.0, 1.0),
}
_ELSE = (0.5, 2.0)


def values(symbols: Iterable[object], **fixed: float) -> st.SearchStrategy[Array]:
    """A value for each symbol: what is fixed, or one of a thousand steps through its range.

    Steps, because hypothesis is fond of 1e-300, which no aircraft measures.
    """

    def drawn(symbol: str) -> st.SearchStrategy[float]:
        low, high = RANGES.get(symbol, _ELSE)
        return st.integers(0, 1000).map(lambda n: round(low + (high - low) * n / 1000, 12))

    each = (st.just(fixed[s]) if s in fixed else drawn(s) for s in map(str, symbols))
    return st.tuples(*each).map(np.array)


def points(model: str, **fixed: float) -> st.SearchStrategy[Point]:
    """States, inputs and parameters of a random aircraft somewhere on the runway."""
    groups = (MODELS[model].states, MODELS[model].inputs, MODELS[model].parameters)
    return st.tuples(*(values(group, **fixed) for group in groups))


def vector(symbols: Iterable[object], named: Mapping[str, float]) -> Array:
    """The values of some symbols, in order."""
    return np.array([named[str(s)] for s in symbols])


def parameters(model: str, **changes: float) -> Array:
    """The thesis's aircraft as a parameter vector, with changes."""
    return vector(MODELS[model].parameters, {**BROTT, **changes})


def state(**named: float) -> Array:
    """A state vector that is zero but for what is named."""
    rest = dict.fromkeys(map(str, MODELS["linear"].states), 0.0)
    return vector(MODELS["linear"].states, {**rest, **named})


def call(function: ca.Function, *arguments: Any) -> Any:
    """Value of a CasADi function as an array, or as a tuple of arrays if it has several results."""
    results = [np.array(result) for result in function.call(list(arguments))]
    flat = tuple(x[:, 0] if x.shape[1] == 1 else x for x in results)
    return flat if len(flat) > 1 else flat[0]


def lambdified(
    model: Derivation, expressions: Iterable[sp.Expr], modules: str = "numpy"
) -> Callable[..., Any]:
    """Expressions in the quantities of a model's chain, as SymPy prints them."""
    explicit = [model.explicit(sp.sympify(e)) for e in expressions]
    arguments = (*model.states, *model.inputs, *model.parameters)
    return sp.lambdify(arguments, explicit, modules=modules, cse=True)


@cache
def right_hand_side(model: str) -> Callable[[Array, Array, Array], Array]:
    """x' = f(x, u, p) of a model in NumPy, as SymPy prints it."""
    f = lambdified(MODELS[model], MODELS[model].rates)
    return lambda x, u, p: np.array(f(*x, *u, *p))
