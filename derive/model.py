"""A model: components assembled into x' = f(x, u, p) and y = g(x, u, p)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import sympy as sp

from .components import (
    Component,
    F_main,
    F_tail,
    F_tail_wheel,
    alpha,
    disturbance,
    gamma,
    main_gear,
    tail_wheel,
    vertical_tail,
)
from .equation import Chain, Equation, expand, needed
from .kinematics import path_rates
from .newton import a_y, equations_of_motion, r_dot, sum_F, sum_M, v_dot
from .quantities import INPUTS, PARAMETERS, STATES, Quantity, r, u, v
from .tire import linear_tire, nonlinear_tire

beta = Quantity(
    "beta", "sideslip_angle", "rad", "angle of the CG's velocity to the x axis", r"\beta"
)
_OUTPUTS = (alpha, gamma, beta, F_main, F_tail, F_tail_wheel, a_y, sum_F, sum_M)


@dataclass(frozen=True)
class Model:
    """A derived model.

    Attributes
    ----------
    name : str
        Name in generated code.
    summary : str
        One line for people.
    states, inputs, parameters, outputs : tuple of Quantity
        In the order of the vectors x, u, p and y.
    chain : tuple of Equation
        From states, inputs and parameters to accelerations and outputs, in order.
    rates : tuple of sympy.Expr
        Time derivative of each state in terms of the chain.
    """

    name: str
    summary: str
    states: tuple[Quantity, ...]
    inputs: tuple[Quantity, ...]
    parameters: tuple[Quantity, ...]
    outputs: tuple[Quantity, ...]
    chain: Chain
    rates: tuple[sp.Expr, ...]

    #: The states whose rates depend on themselves; the others are their integrals.
    dynamic = (v, r)

    def explicit(self, expr: sp.Expr) -> sp.Expr:
        """`expr` in states, inputs and parameters only."""
        return expand(expr, self.chain)

    def replace(self, **changes: object) -> Model:
        """A copy with some attributes changed."""
        return replace(self, **changes)  # type: ignore[arg-type]


def assemble(
    name: str,
    summary: str,
    components: Sequence[Component],
    inputs: Sequence[Quantity] = INPUTS,
    parameters: Sequence[Quantity] = PARAMETERS,
    outputs: Sequence[Quantity] = _OUTPUTS,
) -> Model:
    """Derive the model of an aircraft made of `components`.

    Parameters
    ----------
    name, summary : str
        Name in generated code, and one line for people.
    components : sequence of Component
        Everything that makes a force.
    inputs, parameters : sequence of Quantity
        What the force laws may use; parameters that no equation uses are left out.
    outputs : sequence of Quantity
        What to report; those that no component defines are left out.

    Raises
    ------
    ValueError
        If a force law uses a symbol that is neither state, input nor parameter.
    UnitError
        If a term has the wrong unit.
    """
    beta_equation = Equation(beta, sp.atan(v / u), "Eq. 4.20")
    chain = (*equations_of_motion(components), beta_equation)
    rate_of = {v: v_dot, r: r_dot, **path_rates()}
    rates = tuple(rate_of[state] for state in STATES)
    defined = {equation.lhs for equation in chain}
    outputs = tuple(q for q in outputs if q in defined)
    chain = needed(chain, (*rates, *outputs))

    used = {s for equation in chain for s in equation.rhs.free_symbols} | {u}
    used -= {equation.lhs for equation in chain}
    if unknown := used - {*STATES, *inputs, *parameters}:
        names = ", ".join(sorted(map(str, unknown)))
        raise ValueError(f"{name}: {names} are neither state, input nor parameter")
    return Model(
        name=name,
        summary=summary,
        states=STATES,
        inputs=tuple(inputs),
        parameters=tuple(q for q in parameters if q in used),
        outputs=outputs,
        chain=chain,
        rates=rates,
    )


def nonlinear() -> Model:
    """The thesis's non-linear model (Section 4.6)."""
    parts = (main_gear(nonlinear_tire), vertical_tail(), tail_wheel(), disturbance())
    return assemble("nonlinear", "Exact angles and the non-linear tire (Section 4.6).", parts)


def linear_tire_model() -> Model:
    """Exact angles with the linear tire: what the linear model is the linearisation of."""
    parts = (main_gear(linear_tire), vertical_tail(), tail_wheel(), disturbance())
    return assemble("linear", "Small angles and the linear tire (Section 4.5).", parts)
