"""The oracle of the landing roll and JSBSim agree: on the stored runs, and rolling side by side."""

from __future__ import annotations

import copy
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from jsbsim_live import disagreements, reference, roll, stored
from oracle_roll import STATES, rest, simulate

RUNS = sorted(stored())


def by_oracle(run: dict[str, Any], **changes: Any) -> dict[str, Any]:
    """A stored run by the oracle, with changes to its aircraft."""
    aircraft, start = copy.deepcopy(run["config"]) | changes, run["initial"]
    times = reference(run)["t"]
    states, loads = simulate(aircraft, run["inputs"], times, start["u0"], start["v0"])
    return dict(zip(STATES, states.T, strict=False)) | {f"N{k}": loads[:, k] for k in range(3)}


@pytest.mark.parametrize(
    ("name", "combine"), [*((name, "box") for name in RUNS), ("G1", "ellipse"), ("G4", "ellipse")]
)
def test_the_oracle_agrees_with_the_stored_runs(name: str, combine: str) -> None:
    """An order better than asked; none of these runs brakes or turns to its ellipse's edge."""
    run = stored()[name]
    ours, theirs = by_oracle(run, combine=combine), reference(run)
    assert not disagreements(ours, theirs, allowed=0.2 if name != "G8" else 1.0)


def test_a_wrong_choice_would_be_seen() -> None:
    """One per cent of friction, or a wide regularisation, breaks the agreement."""
    run = stored()["G3"]
    changed = copy.deepcopy(run["config"]["wheels"])
    for wheel in changed:
        wheel["mu_static"] *= 1.01
    assert "psi" in disagreements(by_oracle(run, wheels=changed), reference(run))
    run = stored()["G8"]
    assert "psi" in disagreements(by_oracle(run, v_rest=0.1), reference(run))


@pytest.mark.parametrize("name", RUNS)
def test_the_start_is_the_rest_on_the_legs(name: str) -> None:
    run = stored()[name]
    height, theta = rest(run["config"])
    assert height == pytest.approx(run["rest"]["Z"], abs=1e-6)
    assert np.degrees(theta) == pytest.approx(run["rest"]["theta_deg"], abs=1e-6)


@pytest.mark.parametrize("name", RUNS)
def test_jsbsim_reproduces_the_stored_runs(name: str, tmp_path: Path) -> None:
    run = stored()[name]
    theirs = reference(run)
    live = roll(
        run["jsbsim_xml"],
        run["inputs"],
        theirs["t"],
        tmp_path,
        height=-run["rest"]["Z"],
        theta=np.radians(run["rest"]["theta_deg"]),
        speed=run["initial"]["u0"],
        drift=run["initial"]["v0"],
    )
    assert not disagreements(live, theirs, allowed=0.3)
    for channel in ("x", "y", "theta"):
        largest = np.max(np.abs(theirs[channel]))
        assert live[channel] == pytest.approx(theirs[channel], abs=max(4e-3 * largest, 1e-4))
