"""What `tol` promises, on random aircraft of any kind: two methods against each other."""

from __future__ import annotations

import numpy as np
import pytest
from benchmarks.accuracy import REFERENCE, WAYS, by_ensemble_end, by_solver
from clouds import CLOUDS, Cloud

import groundroll as gr

PHYSICAL = ("any aircraft, large-slip, 5 s", "any aircraft, large-slip, 20 s")


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("name", PHYSICAL)
def test_aircraft_of_any_kind_keep_the_tolerance(name: str, way: str):
    cloud, (measured, reference) = CLOUDS[name], WAYS[way]
    plane, start = cloud.drawn(np.random.default_rng(5), 150)
    exact = reference(cloud, plane, start, REFERENCE)
    scale = np.maximum(np.abs(exact.rows).max(axis=2), 1e-6)
    for tol in (1e-4, 1e-6, 1e-9):
        found = measured(cloud, plane, start, tol)
        last = exact.rows[:, :, -found.rows.shape[2] :]
        error = (np.abs(found.rows - last).max(axis=2) / scale).max(axis=1) / tol
        known = np.isfinite(scale).all(axis=1) & (exact.estimate < 0.1 * tol) & found.sound
        assert known.mean() > 0.95
        assert error[known].max() < 1.0
        assert found.sound.mean() > 0.99


@pytest.mark.parametrize("stiffness", [0.0, 1000.0, 8000.0])
def test_a_tricycle_that_had_exceeded_it_keeps_the_tolerance(stiffness: float):
    """One in 7,500 random aircraft had been off by 1.55 times 1e-9, its status ok."""
    own = {"m": 1588.0, "a": -2.083, "u": 54.3, "b": 3.92176, "Ct": stiffness, "Fz": 5300.0}
    plane = gr.Aircraft.load("brott").replace(**own, C5=-8.81055e-6)
    start = {"v0": np.array([-2.23])}
    cloud = Cloud(2.23, 0.0, 5.0)
    exact = by_solver(cloud, plane.replace(m=np.array([1588.0])), start, REFERENCE)
    scale = np.abs(exact.rows).max(axis=2)
    for tol in (1e-6, 1e-9, 1e-11):
        found = by_ensemble_end(cloud, plane, start, tol)
        assert found.sound.all()
        assert (np.abs(found.rows[:, :, 0] - exact.rows[:, :, -1]) / scale).max() < tol
