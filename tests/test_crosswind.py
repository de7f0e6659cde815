"""The strongest wind that is held: against root finding on the model, and the body on legs."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import fsolve

import groundroll as gr
from groundroll.control.held import solved
from groundroll.control.pilot import rolls_at
from groundroll.model.evaluate import elementwise
from groundroll.model.models import as_model

TAILDRAGGER, TRICYCLE = (gr.Aircraft.load(f"cessna-{n}") for n in ("170", "172p"))
MODEL = as_model("rollout")
KNOT = 1852 / 3600


def pedal_for(plane: gr.Aircraft, speed: float, wind: float, near: float) -> float:
    """Pedal that holds it, by SciPy on the right-hand side of the model."""
    p = plane.replace(u=speed).parameters(MODEL).reshape(-1)
    rhs, k = MODEL.function("rhs"), MODEL.states.index
    u = np.zeros(len(MODEL.inputs))
    u[MODEL.inputs.index("wind_y")] = wind

    def lost(at: np.ndarray) -> list[float]:
        psi, pedal = at
        x = np.zeros(len(MODEL.states))
        x[[k("u"), k("v"), k("psi")]] = speed * np.cos(psi), -speed * np.sin(psi), psi
        u[MODEL.inputs.index("pedal")] = pedal
        f = np.array(rhs(x, u, p)).ravel()
        return [f[k("u")] * np.sin(psi) + f[k("v")] * np.cos(psi), f[k("r")]]

    found, _, done, why = fsolve(lost, [0.0, near], full_output=True, xtol=1e-12)
    assert done == 1, why
    return float(found[1])


@pytest.mark.parametrize("plane", [TAILDRAGGER, TRICYCLE], ids=lambda p: p.name)
@pytest.mark.parametrize("speed", [5.0, 14.0, 20.0])
def test_where_the_pedal_binds_is_where_root_finding_puts_it(
    plane: gr.Aircraft, speed: float
) -> None:
    found = gr.crosswind_limit(plane, speed=speed, aileron=0.0)
    assert found.what == "pedal"
    wind = float(found.wind)
    assert pedal_for(plane, speed, wind, 0.999) == pytest.approx(1.0, abs=1e-4)
    # on the way there it is enough
    for share in (0.25, 0.5, 0.75, 0.95):
        assert pedal_for(plane, speed, share * wind, share) < 1.0


def test_ailerons_keep_loads_equal_until_their_stops() -> None:
    found = gr.crosswind_limit(TRICYCLE, speed=[12.0, 20.0], aileron="20 deg")
    free = np.abs(found.aileron) < found.aileron_limit
    assert free.all()
    assert found.load_left == pytest.approx(found.load_right, rel=1e-3)
    assert (found.aileron < 0).all()  # the wind from the left: left wing down
    without = gr.crosswind_limit(TRICYCLE, speed=[12.0, 20.0], aileron=0.0)
    assert (without.load_left < without.load_right).all()  # the wind lifts the wing it meets


def test_the_loads_are_those_of_the_body_on_legs() -> None:
    """At the limit of the level body, the body on legs stands on both wheels just so."""
    values = {"crosswind": 0.4 * float(gr.crosswind_limit(TAILDRAGGER, speed=12.0).wind)}
    held = {}
    for name in ("rollout", "landing_roll"):
        rolls, _ = rolls_at(TAILDRAGGER, as_model(name), 12.0, values, "test", [{"pedal": 1.0}])
        z, found = solved(rolls, rolls.start(1))
        assert found.all()
        y = dict(zip(rolls.model.outputs, rolls.at(z).evaluate("g")["g"].T, strict=True))
        if name == "rollout":
            y |= {k: v for k, v in rolls.points.values.items() if k == "track"}
            loads = elementwise("moved_loads", y)
        else:
            loads = {"N_left": y["Fz_left"], "N_right": y["Fz_right"]}
        left, right = loads["N_left"][0], loads["N_right"][0]
        held[name] = (z[0, -1], (right - left) / (right + left))
    assert held["rollout"] == pytest.approx(held["landing_roll"], rel=0.2)
    assert held["rollout"][1] > 0.05


def test_mirrored_winds_are_held_alike() -> None:
    left, right = (
        gr.crosswind_limit(TAILDRAGGER, speed=[4.0, 15.0], direction=d, brake=0.3)
        for d in ("90 deg", "-90 deg")
    )
    assert left.wind == pytest.approx(right.wind, rel=1e-6)
    assert left.pedal == pytest.approx(-right.pedal)
    assert left.brake == pytest.approx(right.brake)


def test_more_to_hold_with_holds_more() -> None:
    speeds = [6.0, 12.0, 18.0]
    bare = gr.crosswind_limit(TRICYCLE, speed=speeds)
    braked = gr.crosswind_limit(TRICYCLE, speed=speeds, brake=0.3)
    assert (braked.wind > bare.wind).all()
    assert (braked.what == "brake").all()
    wider = gr.crosswind_limit(TRICYCLE, speed=speeds, rudder_max="30 deg")
    assert (wider.wind > bare.wind).all()
    slippery = {f"surface_{w}": 0.5 for w in ("left", "right", "third")}
    assert (gr.crosswind_limit(TRICYCLE, speed=speeds, **slippery).wind < bare.wind).all()


def test_a_narrow_track_lifts_a_wheel() -> None:
    narrow = TRICYCLE.replace(track="0.8 m", rudder_max="60 deg", steering_ratio="30 deg")
    without = gr.crosswind_limit(narrow, speed=6.0, aileron=0.0)
    assert without.what == "wheel lifted"
    assert float(without.load_left) == pytest.approx(0.0, abs=1.0)
    assert gr.crosswind_limit(narrow, speed=6.0, aileron="5 deg").what == "aileron"


def test_a_headwind_asks_for_no_pedal() -> None:
    found = gr.crosswind_limit(TAILDRAGGER, speed=8.0, direction=0.0)
    assert float(found.pedal) == pytest.approx(0.0, abs=1e-6)
    assert found.what != "pedal"


def test_demonstrated_winds_are_held_near_touchdown() -> None:
    """Cessna 172 of 1969: 15 mph demonstrated; the 170 has none, 0.2 V_S0 is 10.4 mph."""
    mph = 0.44704
    for plane, demonstrated in ((TRICYCLE, 15 * mph), (TAILDRAGGER, 10.4 * mph)):
        found = gr.crosswind_limit(plane, speed=float(plane["u"]))
        assert 1 <= float(found.wind) / demonstrated <= 2.2, plane.name


def test_the_clause_reports_with_its_assumptions() -> None:
    clause = gr.crosswind_clause(TRICYCLE)
    assert clause.asked == pytest.approx(20 * KNOT)  # a light one stalls below 100 kt
    assert clause.asked_small == pytest.approx(0.2 * clause.stall_speed)
    assert clause.wind == clause.limit.wind.min()
    assert clause.meets
    assert "certifies nothing" in repr(clause)
    assert not gr.crosswind_clause(TAILDRAGGER).meets


def test_any_array_goes_through() -> None:
    grid = TAILDRAGGER.replace(m=np.array([[800.0], [1000.0]]))
    found = gr.crosswind_limit(grid, speed=[5.0, 10.0, 15.0])
    assert found.wind.shape == (2, 3)
    one = gr.crosswind_limit(replace(TAILDRAGGER, name="one").replace(m=1000.0), speed=10.0)
    assert float(one.wind) == pytest.approx(found.wind[1, 1], rel=1e-6)


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        ({"speed": -1.0}, "positive"),
        ({"crosswind": 3.0}, "seeks"),
        ({"brake": 1.5}, "between 0 and 1"),
        ({"aileron": -0.1}, "aileron"),
        ({"bracke": 0.1}, "unknown argument"),
    ],
)
def test_errors_teach(wrong: dict[str, object], words: str) -> None:
    with pytest.raises(gr.GroundrollError, match=words):
        gr.crosswind_limit(TAILDRAGGER, **wrong)
