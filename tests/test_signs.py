"""No sign in the models can flip unnoticed.

Every term of every sum, every force, moment, acceleration and angle, and every part is turned
around, one at a time. A few checks that know the physics, the thesis's printed numbers and the
tire's data, but not the equations, must object to each.
"""

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from flips import equation_flips, rate_flips
from oracles import BROTT, MODELS, TRIALS, Array, lambdified, state, vector

from groundroll.derive.core.linearise import linearise
from groundroll.derive.core.model import Derivation
from groundroll.derive.core.part import Felt, Force, Part
from groundroll.derive.models.linear import LINEAR_TIRE
from groundroll.derive.models.nonlinear import NONLINEAR
from groundroll.derive.parts.tires import F_y

# --- The flips ------------------------------------------------------------------------------


def part_flips(name: str) -> Iterator[tuple[str, Derivation]]:
    """The model with one part pushing, or placed, the wrong way."""
    model = {"linear": LINEAR_TIRE, "nonlinear": NONLINEAR}[name]
    gear, *behind, displacements = model.parts

    def backwards(part: Part) -> Part:
        def law(felt: Felt) -> Force:
            force = part.law(felt)
            return replace(force, vector=-force.vector)

        return replace(part, law=law)

    def derived(parts: list[Part]) -> Derivation:
        derivation = replace(model, parts=[*parts, displacements]).derive()
        return linearise(derivation) if name == "linear" else derivation

    acting = [gear, *behind]
    for n, part in enumerate(acting):
        flipped = [*acting[:n], backwards(part), *acting[n + 1 :]]
        yield f"{part.name} pushes backwards", derived(flipped)
    yield "main gear at the wrong end", derived([replace(gear, at=-gear.at), *behind])
    tail_ahead = [replace(part, at=-part.at) for part in behind]
    yield "tail at the wrong end", derived([gear, *tail_ahead])


FLIPS = {
    f"{name}, {what}": model
    for name in MODELS
    for flips in (equation_flips(MODELS[name]), rate_flips(MODELS[name]), part_flips(name))
    for what, model in sorted(flips, key=lambda flip: flip[0])
}

# --- The checks -----------------------------------------------------------------------------

#: From states, disturbance and changes in the thesis's aircraft to rates and outputs by name.
Numbers = Callable[..., dict[str, float]]
MOVING = [(state(v=1.5, r=0.1, psi=0.3), 400.0), (state(v=-0.7, r=0.4, psi=-1.0), -900.0)]


def numbers(model: Derivation) -> Numbers:
    f = lambdified(model, [*model.rates, *model.outputs])
    names = [f"{s}_dot" for s in model.states] + [str(q) for q in model.outputs]

    def evaluate(x: Array, push: float = 0.0, **changes: float) -> dict[str, float]:
        p = vector(model.parameters, {**BROTT, **changes})
        return dict(zip(names, f(*x, push, *p), strict=True))

    return evaluate


def state_matrix(f: Numbers, **changes: float) -> Array:
    columns = []
    for x in (state(v=1e-4), state(r=1e-5)):
        there, back = f(x, **changes), f(-x, **changes)
        size = 2 * abs(x).max()
        columns.append([(there[s] - back[s]) / size for s in ("v_dot", "r_dot")])
    return np.array(columns).T


def sideways(x: Array) -> tuple[float, float]:
    """Sideways velocities of main gear and tail."""
    return x[0] + BROTT["a"] * x[1], x[0] - BROTT["b"] * x[1]


def energy_is_only_taken(model: Derivation, f: Numbers, x: Array, push: float) -> bool:
    (at_gear, at_tail), out = sideways(x), f(x, push)
    powers = [out["F_main"] * at_gear, out["F_tail"] * at_tail, out["F_tail_wheel"] * at_tail]
    return min(powers) > 0


def power_goes_into_motion(model: Derivation, f: Numbers, x: Array, push: float) -> bool:
    (at_gear, at_tail), out = sideways(x), f(x, push)
    behind = push - out["F_tail"] - out["F_tail_wheel"]
    holding_the_speed = -BROTT["m"] * x[0] * x[1] * BROTT["u"]
    power = behind * at_tail - out["F_main"] * at_gear + holding_the_speed
    return np.isclose(power, BROTT["m"] * x[0] * out["v_dot"] + BROTT["Izz"] * x[1] * out["r_dot"])


def forces_make_the_acceleration(model: Derivation, f: Numbers, x: Array, push: float) -> bool:
    """As seen from the ground, where u r is part of it."""
    out = f(x, push)
    behind = push - out["F_tail"] - out["F_tail_wheel"]
    force = behind - out["F_main"]
    moment = -BROTT["a"] * out["F_main"] - BROTT["b"] * behind
    seen = [out["sum_F"], out["sum_M"], BROTT["m"] * out["a_y"], out["a_y"] - BROTT["u"] * x[1]]
    return np.allclose(seen, [force, moment, force, out["v_dot"]])


def thrust_holds_the_speed(model: Derivation, f: Numbers, x: Array, push: float) -> bool:
    """Seen from the ground, the nose turns away from a velocity across it."""
    return np.isclose(
        f(x, push).get("F_held", -BROTT["m"] * x[0] * x[1]), -BROTT["m"] * x[0] * x[1]
    )


def the_ground_carries_the_weight(model: Derivation, f: Numbers, x: Array, push: float) -> bool:
    return np.isclose(f(x, push)["N_held"], BROTT["m"] * BROTT["g"])


def angles_point_where_the_wheels_go(model: Derivation, f: Numbers, x: Array, push: float) -> bool:
    angles = [f(x, push)[name] for name in ("alpha", "gamma", "beta")]
    return np.allclose(angles, np.arctan2([*sideways(x), x[0]], BROTT["u"]), rtol=0.01)


def the_path_follows_the_nose(model: Derivation, f: Numbers, x: Array, push: float) -> bool:
    out, over_ground = f(x, push), (BROTT["u"] + 1j * x[0]) * np.exp(1j * x[6])
    rates = [out[f"{symbol}_dot"] for symbol in ("y", "theta", "X", "Y", "psi")]
    return np.allclose(rates, [*x[:2], over_ground.real, over_ground.imag, x[1]])


def a_crosswind_takes_the_tail_along(model: Derivation, f: Numbers, x: Array, push: float) -> bool:
    out = f(state(), abs(push))
    return out["v_dot"] > 0 > out["r_dot"]


def eigenvalues_are_those_printed(model: Derivation, f: Numbers) -> bool:
    found = [np.linalg.eigvals(state_matrix(f, **trial.changes)) for trial in TRIALS.values()]
    printed, digits = (np.array([trial[n] for trial in TRIALS.values()]) for n in (1, 2))
    return bool((abs(np.sort_complex(found) - printed) <= digits).all())


def trial_19_comes_to_rest_where_printed(model: Derivation, f: Numbers) -> bool:
    """Table 4.11: 0.2736 m and -1.2803 deg, with the C5 that was in force."""
    y, theta = -np.linalg.solve(state_matrix(f, C5=-8.81055e-5), [0.1, 0.0])
    return np.allclose([y, np.degrees(theta)], [0.2736, -1.2803], rtol=0.01)


#: Nine points of Table 3.1: slip angle in deg, load in N, force in N.
TIRE_DATA = np.array(
    [
        *([2, 1779, 534], [8, 1779, 1112], [20, 1779, 1241]),
        *([2, 3559, 823], [8, 3559, 1988], [20, 3559, 2447]),
        *([2, 5338, 912], [8, 5338, 2518], [20, 5338, 3510]),
    ]
)


def the_tire_is_the_one_measured(model: Derivation, f: Numbers) -> bool:
    """To 90 N, with the C5 that fits."""
    force = lambdified(model, [F_y])
    slip, loads, measured = TIRE_DATA.T
    rolling = [state(v=BROTT["u"] * np.tan(np.radians(angle))) for angle in slip]
    tires = [vector(model.parameters, {**BROTT, "Fz": load}) for load in loads]
    computed = [force(*x, 0.0, *p)[0] for x, p in zip(rolling, tires, strict=True)]
    return bool((abs(computed - measured) < 90).all())


IN_MOTION = [
    energy_is_only_taken,
    power_goes_into_motion,
    forces_make_the_acceleration,
    thrust_holds_the_speed,
    the_ground_carries_the_weight,
    angles_point_where_the_wheels_go,
    the_path_follows_the_nose,
    a_crosswind_takes_the_tail_along,
]
AGAINST_PRINT = {
    "linear": [eigenvalues_are_those_printed],
    "nonlinear": [trial_19_comes_to_rest_where_printed, the_tire_is_the_one_measured],
}


def objections(model: Derivation) -> set[str]:
    """The checks that a model does not pass."""
    f = numbers(model)
    moving = {c.__name__ for c in IN_MOTION if not all(c(model, f, *point) for point in MOVING)}
    return moving | {c.__name__ for c in AGAINST_PRINT[model.name] if not c(model, f)}


@cache
def noticed_by(flip: str) -> set[str]:
    return objections(FLIPS[flip])


@pytest.mark.parametrize("name", MODELS)
def test_nothing_objects_to_the_model_itself(name: str):
    assert objections(MODELS[name]) == set()


@pytest.mark.parametrize("flip", FLIPS)
def test_a_flipped_sign_is_noticed(flip: str):
    assert noticed_by(flip)


def test_no_check_is_idle():
    checks = [*IN_MOTION, *AGAINST_PRINT["linear"], *AGAINST_PRINT["nonlinear"]]
    assert set().union(*map(noticed_by, FLIPS)) == {check.__name__ for check in checks}


@pytest.mark.parametrize("name", MODELS)
def test_every_force_is_flipped_where_it_is_made_and_where_it_acts(name: str):
    forces = [str(q) for q in MODELS[name].outputs if q.unit == "N" and q.name[:2] == "F_"]
    forces = [force for force in forces if force != "F_held"]
    assert forces == ["F_main", "F_tail", "F_tail_wheel"]
    for force in forces:
        assert f"{name}, {force}: all of it" in FLIPS
        assert f"{name}, sum_F: -{force}" in FLIPS
    of_the_sums = [flip for flip in FLIPS if flip.startswith((f"{name}, sum_F", f"{name}, sum_M"))]
    assert len(of_the_sums) == 2 * (len(forces) + 1 + 1)  # the disturbance, and all of it
