"""Curves of equilibria of systems whose folds, branch points and Hopf points are known."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from groundroll.linear.continuation import Follower

Array = np.ndarray


def system(
    f: Callable[[Array, float], Array], slopes: Callable[[Array, float], Array], low: float
) -> Callable[[Array], tuple[Array, Array, Array]]:
    """f(x, p) with p = low + the last coordinate."""

    def at(z: Array) -> tuple[Array, Array, Array]:
        x, p = z[:-1], low + z[-1]
        both = np.asarray(slopes(x, p), dtype=float)
        return np.asarray(f(x, p), dtype=float), both, both[:, :-1]

    return at


def found(curves: list, kind: str) -> list[Array]:
    return [curve.points[k] for curve in curves for name, k in curve.marks if name == kind]


def test_a_fold_is_where_two_equilibria_meet() -> None:
    """x^2 = p, from p = -1 to 3."""
    f = system(lambda x, p: x**2 - p, lambda x, p: [[2 * x[0], -1.0]], -1.0)
    curves = Follower(f, 4.0, {}).curves([np.array([1.0, 2.0]), np.array([-1.0, 2.0])])
    assert len(curves) == 1
    assert curves[0].ends == ("range", "range")
    (fold,) = found(curves, "fold")
    np.testing.assert_allclose(fold, [0.0, 1.0], atol=1e-7)
    x, over = curves[0].points.T
    np.testing.assert_allclose(x**2, over - 1.0, atol=1e-9)
    assert sorted(x[[0, -1]]) == pytest.approx([-np.sqrt(3), np.sqrt(3)])


def test_a_cubic_has_its_two_folds() -> None:
    """p = x^3 - 3 x: folds at x = -1, p = 2 and x = 1, p = -2."""
    f = system(lambda x, p: x**3 - 3 * x - p, lambda x, p: [[3 * x[0] ** 2 - 3, -1.0]], -5.0)
    curves = Follower(f, 10.0, {}).curves([np.array([-2.2, 0.5])])
    folds = sorted(map(tuple, found(curves, "fold")))
    np.testing.assert_allclose(folds, [(-1.0, 7.0), (1.0, 3.0)], atol=1e-7)


def test_what_branches_off_a_pitchfork_is_followed() -> None:
    """p x - x^3: the straight line and, from p = 0, two arms x = +-sqrt(p)."""
    f = system(lambda x, p: p * x - x**3, lambda x, p: [[p - 3 * x[0] ** 2, x[0]]], -2.03)
    curves = Follower(f, 4.0, {}).curves([np.array([0.0, 0.0])])
    assert len(curves) == 2
    line, arms = curves
    np.testing.assert_allclose(line.points[:, 0], 0.0, atol=1e-12)
    np.testing.assert_allclose(found([line], "branch_point"), [[0.0, 2.03]], atol=1e-6)
    np.testing.assert_allclose(arms.points[:, 0] ** 2, arms.points[:, 1] - 2.03, atol=1e-6)
    assert arms.points[0, 0] * arms.points[-1, 0] < 0
    assert not found([arms], "fold")


def test_both_lines_of_a_transcritical_point_are_there() -> None:
    """x (p - x)."""
    f = system(lambda x, p: x * (p - x), lambda x, p: [[p - 2 * x[0], x[0]]], -1.1)
    curves = Follower(f, 2.2, {}).curves([np.array([0.0, 0.0])])
    assert [curve.ends for curve in curves] == [("range", "range")] * 2
    np.testing.assert_allclose(found(curves[:1], "branch_point"), [[0.0, 1.1]], atol=1e-6)


def test_a_hopf_point_is_marked_and_a_saddle_whose_sum_vanishes_is_not() -> None:
    """x' = p x - y, y' = x + p y has one at p = 0; x' = (1 + p) x, y' = (p - 1) y has none."""
    turning = system(
        lambda x, p: np.array([p * x[0] - x[1], x[0] + p * x[1]]),
        lambda x, p: [[p, -1.0, x[0]], [1.0, p, x[1]]],
        -0.7,
    )
    curves = Follower(turning, 2.0, {}).curves([np.zeros(3)])
    np.testing.assert_allclose(found(curves, "hopf"), [[0.0, 0.0, 0.7]], atol=1e-8)
    saddle = system(
        lambda x, p: np.array([(1 + p) * x[0], (p - 1) * x[1]]),
        lambda x, p: [[1 + p, 0.0, x[0]], [0.0, p - 1, x[1]]],
        -0.7,
    )
    assert not found(Follower(saddle, 1.4, {}).curves([np.zeros(3)]), "hopf")


def test_an_isle_is_closed() -> None:
    """x^2 + p^2 = 1."""
    f = system(lambda x, p: x**2 + p**2 - 1, lambda x, p: [[2 * x[0], 2 * p]], -2.0)
    (curve,) = Follower(f, 4.0, {}).curves([np.array([1.0, 2.0]), np.array([-1.0, 2.0])])
    assert curve.ends == ("closed", "closed")
    folds = sorted(float(z[-1]) for z in found([curve], "fold"))
    np.testing.assert_allclose(folds, [1.0, 3.0], atol=1e-7)


def test_a_limit_ends_a_curve_where_it_is_reached() -> None:
    f = system(lambda x, p: x - p, lambda x, p: [[1.0, -1.0]], 0.0)
    (curve,) = Follower(f, 4.0, {"pedal": (0, 1.5)}).curves([np.array([0.5, 0.5])])
    assert curve.ends in (("range", "pedal"), ("pedal", "range"))
    ends = sorted(curve.points[[0, -1]].tolist())
    np.testing.assert_allclose(ends, [[0.0, 0.0], [1.5, 1.5]], atol=1e-7)
