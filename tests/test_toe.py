"""Toe-in: the derived criterion against the sketches, and against wheels with finite toe."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import fsolve

import groundroll as gr
from groundroll.control.held import solved
from groundroll.control.pilot import lateral, rolls_at
from groundroll.derive.core.equation import expand
from groundroll.derive.parts.gear import track
from groundroll.derive.parts.quantities import C_alpha, Ct, a, b, h_cg, u
from groundroll.derive.theory import closed_forms as closed
from groundroll.derive.theory.toe import C_load, toe_effects
from groundroll.model.evaluate import elementwise
from groundroll.model.models import as_model

CHAIN = {e.lhs.name: e.rhs for e in toe_effects()}
POSITIVE = st.floats(0.1, 1.0)


def test_both_criteria_are_those_of_the_sketches() -> None:
    C, K, L = C_alpha, closed.K, a + b
    stiffness = CHAIN["toe_pull"] - CHAIN["toe_load"]
    assert (
        sp.simplify(stiffness * track - (track**2 * C - 2 * a * h_cg * C_load * (2 * C + K))) == 0
    )
    A, *_ = closed.state_space(closed.linear())
    det = closed.in_stiffnesses(A.det()).subs(closed.C_f, 2 * C)
    (square,) = sp.solve(sp.numer(sp.together(det)).subs(u, sp.sqrt(closed.s)), closed.s)
    on_boundary = CHAIN["toe_determinant"].subs(u, sp.sqrt(square))
    sketch = track**2 * b * (2 * C + K) - 4 * h_cg * L**2 * K * C_load
    ratio = sp.simplify(on_boundary / sketch)
    assert not ratio.has(C_load)  # the same sign, whatever the tire
    assert ratio.subs(dict.fromkeys(ratio.free_symbols, 1)) > 0


def rates(x: np.ndarray, q: dict[str, float], toe: float) -> np.ndarray:
    """v_dot and r_dot with two toed wheels and moving loads, nothing expanded."""
    v, r = x
    K = q["Ct"] + q["rho"] * q["Ap"] * q["CL_gamma"] / 2 * q["u"] ** 2
    alpha, gamma = (v + q["a"] * r) / q["u"], (v - q["b"] * r) / q["u"]

    def side(S: float) -> tuple[float, float, float]:
        moved = S * q["h_cg"] / q["track"]
        loads = q["Fz"] - moved, q["Fz"] + moved
        left, right = (
            (q["C_alpha"] + q["C_load"] * (load - q["Fz"])) * (alpha + sign * toe)
            for load, sign in zip(loads, (-1.0, 1.0), strict=True)
        )
        across = (left + right) * np.cos(toe)
        pull = (left + right) * np.sin(toe) * q["track"] / 2
        return across, pull, across + K * gamma

    S = fsolve(lambda S: side(S[0])[2] - S[0], [0.0], xtol=1e-14)[0]
    across, pull, S = side(S)
    moment = -q["a"] * across + q["b"] * K * gamma + pull
    return np.array([-S / q["m"] - q["u"] * r, moment / q["Izz"]])


def matrix(q: dict[str, float], toe: float) -> np.ndarray:
    h = 1e-4
    columns = [(rates(h * e, q, toe) - rates(-h * e, q, toe)) / (2 * h) for e in np.eye(2)]
    return np.stack(columns, 1)


@settings(max_examples=30, deadline=None)
@given(POSITIVE, POSITIVE, POSITIVE, st.floats(-1.0, 1.0))
def test_wheels_with_a_finite_toe_agree(
    arm: float, height: float, tail: float, slope: float
) -> None:
    q = {"m": 1000.0, "Izz": 2000.0, "a": arm, "b": 5.0, "u": 25.0, "rho": 1.225, "Ap": 1.5}
    q |= {"CL_gamma": 2.5, "Ct": 6000 * tail, "Fz": 4000.0, "h_cg": height, "track": 2.0}
    q |= {"C_alpha": 28000.0, "C_load": 8 * slope}
    C3 = -0.001
    q |= {"C3": C3, "B3": q["C_load"] - 2 * C3 * q["Fz"]}
    found = elementwise("toe_effects", {k: np.asarray(x) for k, x in q.items()})
    e = 1e-3
    plus, minus = matrix(q, e), matrix(q, -e)
    slope_det = (np.linalg.det(plus) - np.linalg.det(minus)) / (2 * e)
    yaw = (plus[1, 0] - minus[1, 0]) / (2 * e) * q["Izz"] * q["u"]
    assert found["toe_yaw_stiffness"] == pytest.approx(yaw, rel=2e-3, abs=30.0)
    assert found["toe_determinant"] == pytest.approx(slope_det, rel=5e-3, abs=0.02)


def test_the_chain_is_in_parameters_only() -> None:
    chain = (*closed.stiffnesses(), *toe_effects())
    free = expand(CHAIN["toe_determinant"], chain).free_symbols
    assert Ct in free
    assert closed.K not in free


@pytest.mark.parametrize(("track", "good"), [(2.19456, True), (1.0, False)])
def test_the_body_on_legs_says_the_same(track: float, good: bool) -> None:
    """Yaw stiffness by toe-in of `landing_roll`, its heave, pitch and roll taken as quick, no air.

    With the loads, the height and the stiffnesses that it has there; the lean of the body and the
    legs, which the criterion leaves out, are worth the rest.
    """
    model, speed = as_model("landing_roll"), 14.0
    still = {f"mu_roll_{w}": 0.0 for w in ("left", "right", "third")}
    plane = gr.Aircraft.load("cessna-170").replace(rho=1e-9, track=track, **still)
    matrices = []
    for angle in (0.002, -0.002):
        rolls, _ = rolls_at(plane.replace(toe=angle), model, speed, {}, "test", [{"pedal": 1.0}])
        z, found = solved(rolls, rolls.start(1))
        assert found.all()
        states, A, _ = lateral(rolls, z)
        slow, quick = (
            [states.index(s) for s in group] for group in (("v", "r"), ("w", "p", "q", "Z", "phi"))
        )
        quick.append(states.index("theta"))
        part = [
            [A[0][np.ix_(rows, columns)] for columns in (slow, quick)] for rows in (slow, quick)
        ]
        matrices.append(part[0][0] - part[0][1] @ np.linalg.solve(part[1][1], part[1][0]))
    stiffness = (matrices[0] - matrices[1])[1, 0] / 0.004 * float(plane["Izz"]) * speed
    at = rolls.at(z)
    y = dict(zip(model.outputs, at.evaluate("g")["g"][0], strict=True))
    q = {s: float(np.ravel(v)[0]) for s, v in at.values.items()}
    load, third = (y["Fz_left"] + y["Fz_right"]) / 2, y["Fz_third"]
    own = {s: plane[s] for s in ("m", "Izz", "b", "rho", "Ap", "CL_gamma", "B3", "C3", "track")}
    height = q["z_main"] - load / q["k_main"]
    own |= {
        "u": speed,
        "Fz": load,
        "C_alpha": (q["B3"] + q["C3"] * load) * load,
        "Ct": (q["B3_third"] + q["C3_third"] * third) * third,
        "a": q["a"] * np.cos(q["theta"]) + height * np.sin(q["theta"]),
        "h_cg": -q["Z"],
    }
    said = elementwise("toe_effects", {s: np.asarray(x, float) for s, x in own.items()})
    assert bool(stiffness > 0) is good
    assert float(said["toe_yaw_stiffness"]) == pytest.approx(stiffness, rel=0.2)
