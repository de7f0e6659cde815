"""No sign of the physics of a roll-out or a landing roll flips without a change in rates or loads.

Independent oracles hold these numbers (`test_landing_roll`, `test_roll_physics`); here it is shown
that there is no sign that they could miss: each term of each sum counts somewhere near the
aircraft, on its wheels and near rest, in the order of what those tests see.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest
import sympy as sp
from every import Case, case
from test_independent import named, numbers

from groundroll.derive.core.model import Derivation

#: What is zero on a level body, whatever its sign: what moves or pushes up and down.
IDLE = {
    "rollout": {
        *("w_air: all of it", "V_down_tailplane: all of it"),
        *(
            "F_L_tailplane: V_down_tailplane**2",
            "attack: atan(w_air/sqrt(u_air**2 + 0.0001 m/s**2))",
        ),
        *("sum_Fx: lift*w_air/V_plane", "N_held: -drag*w_air/V_plane"),
        *("Mx_held: push_z_left*track/2", "Mx_held: -push_z_right*track/2"),
        *(f"N_held: push_z_{wheel}" for wheel in ("left", "right", "third")),
        *(f"My_held: a*push_z_{side}*cos(theta_ground)" for side in ("left", "right")),
        *(f"My_held: push_z_{side}*z_main*sin(theta_ground)" for side in ("left", "right")),
        "My_held: a_third*push_z_third*cos(theta_ground)",
        "My_held: push_z_third*z_third*sin(theta_ground)",
    },
    "landing_roll": set(),
}


def terms(expr: sp.Expr) -> Iterator[tuple[str, sp.Expr]]:
    """Terms of a sum, and of sums that are factors, flipped: not what rounds a corner."""
    for part in (expr, *(expr.args if expr.is_Mul else ())):
        for term in part.args if part.is_Add else ():
            if not term.has(sp.Max, sp.Min):
                yield str(term), expr.xreplace({part: part - 2 * term})


def flips(model: Derivation) -> Iterator[tuple[str, Derivation]]:
    for n, equation in enumerate(model.chain):
        flipped = dict(terms(equation.rhs))
        if equation.lhs.unit not in ("1", "1/rad") and equation.rhs != 0:
            flipped["all of it"] = -equation.rhs
        for term, rhs in flipped.items():
            chain = (*model.chain[:n], replace(equation, rhs=rhs), *model.chain[n + 1 :])
            yield f"{equation.lhs}: {term}", model.replace(chain=chain)
    for n, (state, rate) in enumerate(zip(model.states, model.rates, strict=True)):
        for term, flipped_rate in {**dict(terms(rate)), "all of it": -rate}.items():
            rates = (*model.rates[:n], flipped_rate, *model.rates[n + 1 :])
            yield f"rate of {state}: {term}", model.replace(rates=rates)


def points(model: Case) -> list[dict[str, float]]:
    """On all wheels and on some, skewed, as fast as it lands and near rest."""
    found = [named(model, point) for point in model.some(24, seed=12)]
    for n, point in enumerate(found):
        point |= {"Ixz": 0.2 * point["Izz"]} if "Ixz" in point else {}
        point |= {"theta": 0.21 + 0.5 * point["theta"]} if "theta" in point else {}
        point |= {"CL_max": 1.5, "CL_h_max": 1.5, "CL_fin": 1.5} if n % 2 else {}
        if n >= 16:
            point["u"], point["v"] = 0.02 * point["u"], 0.1 * point["v"]
    return found


@pytest.mark.parametrize("name", IDLE)
@pytest.mark.filterwarnings("ignore:invalid value encountered")
def test_no_sign_flips_unnoticed(name: str) -> None:
    model = case(name)
    each = points(model)
    exact = [np.array(numbers(model.derived, point, model.derived)) for point in each]
    assert np.isfinite(exact).all()
    size = 1e-5 * np.maximum(np.abs(exact).max(axis=0), 1e-3)

    def is_noticed(flipped: Derivation) -> bool:
        for point, right in zip(each, exact, strict=True):
            try:
                found = np.array(numbers(flipped, point, model.derived), float)
            except (TypeError, ValueError, ArithmeticError):  # a root of what is negative
                return True
            if not (np.abs(found - right) <= size).all():
                return True
        return False

    flipped = dict(flips(model.derived))
    assert len(flipped) > 200
    assert {what for what, derived in flipped.items() if not is_noticed(derived)} == IDLE[name]
