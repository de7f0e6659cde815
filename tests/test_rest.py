"""A roll starts at rest on its legs and along the runway, for every packaged aircraft."""

from __future__ import annotations

import numpy as np
import pytest

import groundroll as gr
from groundroll.aircraft.aircraft import packaged


@pytest.mark.parametrize("name", [n for n in packaged() if n != "brott"])
def test_a_roll_starts_at_rest_on_its_legs(name: str) -> None:
    plane = gr.Aircraft.load(name)
    still = {"rho": 1e-9}  # no air
    run = gr.simulate(plane, "landing_roll", speed="10 m/s", t=0.5, samples=51, **still)
    weight = float(plane["m"] * plane["g"])
    loads = sum(run[s] for s in ("Fz_left", "Fz_right", "Fz_third"))
    assert loads[0] == pytest.approx(weight, rel=2e-3)
    # it stays where it starts: neither heave nor pitch but what rolling resistance does
    assert np.ptp(run["Z"]) < 2e-3
    assert np.ptp(run["theta"]) < 1e-2  # half a degree
    assert np.abs(run["phi"]).max() < 1e-9


def test_what_is_given_is_not_overruled() -> None:
    plane = gr.Aircraft.load("cessna-172p")
    run = gr.simulate(plane, "landing_roll", Z0=-1.5, t=0.1, samples=3)
    assert run["Z"][0] == -1.5
    assert run["theta"][0] == 0.0


def test_arrays_rest_each_for_itself() -> None:
    plane = gr.Aircraft.load("cessna-172p").replace(m=[900.0, 1000.0])
    run = gr.simulate(plane, "landing_roll", speed=10.0, t=0.1, samples=3)
    assert run["Z"][1, 0] > run["Z"][0, 0]  # the heavier one sinks deeper


def test_a_speed_that_is_free_is_the_aircrafts_own() -> None:
    plane = gr.Aircraft.load("cessna-172p")
    run = gr.simulate(plane, "rollout", t=0.1, samples=3)
    assert run["u"][0] == float(plane["u"])
