"""How late feedback may come: exact delay margins of a linear loop, and the best gains.

A plant x' = A x + B u is held by u = -e^(-tau s) (K y) / (T s + 1): somebody sees y = C x, and acts
`tau` later through muscles with the lag `T`. The loop is a ratio of polynomials N / D times the
delay. It crosses unit gain where |N(jw)|^2 = |D(jw)|^2, a polynomial in w^2; the delay that turns
its phase to -180 degrees at the first of these crossings is the delay margin. Nothing is
approximated but by rounding (J. E. Marshall et al., *Time-Delay Systems: Stability and Performance
Criteria with Applications*, Ellis Horwood 1992, chapter 2: the direct method).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from groundroll.base.arrays import FloatArray

#: Gains at which a loop is tried between the ends of its gain margin.
_BETWEEN = 7
#: Real part over size up to which a root counts as real, and imaginary part as none.
_TINY = 1e-7


@dataclass(frozen=True)
class Loop:
    """An open loop N(s) / D(s), apart from the delay.

    Attributes
    ----------
    N, D : ndarray
        Coefficients, highest power first.
    """

    N: FloatArray
    D: FloatArray

    def scaled(self, gain: float) -> Loop:
        """The loop with another gain."""
        return Loop(gain * self.N, self.D)


@dataclass(frozen=True)
class Plant:
    """A plant with one input as polynomials: C (s - A)^-1 B = N / D, with the lag of the actuator.

    Attributes
    ----------
    N : ndarray, shape (outputs, degree + 1)
    D : ndarray, shape (degree + 2,)
    """

    N: FloatArray
    D: FloatArray

    @classmethod
    def of(cls, A: FloatArray, B: FloatArray, C: FloatArray, lag: float) -> Plant:
        """From matrices; `B` is one column, `lag` in s.

        The numerators are det(s - A + B c) - det(s - A).
        """
        D = np.poly(A)
        N = np.stack([np.poly(A - np.outer(B, c)) - D for c in C])
        scale = np.abs(N).max(axis=1, keepdims=True)
        N = np.where(np.abs(N) <= 1e-14 * scale, 0.0, N)
        return cls(N, np.asarray(np.polymul(D, [lag, 1.0]) if lag else D, dtype=np.float64))

    def loop(self, gains: FloatArray) -> Loop:
        """The open loop with these gains."""
        return Loop(gains @ self.N, self.D)


@dataclass(frozen=True)
class Margins:
    """What a loop must bear beside its delay.

    Attributes
    ----------
    gain : float
        Factor up and down by which the gain may be wrong; 2 is 6 dB.
    phase : float
        Phase that may be lost, rad.
    """

    gain: float = 2.0
    phase: float = math.radians(30.0)


def is_stable(loop: Loop) -> bool:
    """Whether the closed loop without delay is stable."""
    roots = np.roots(np.polyadd(loop.D, loop.N))
    return bool((roots.real < 0).all())


def delay_margin(loop: Loop, phase: float = 0.0) -> float:
    """The least delay, s, that makes a closed loop unstable; negative infinity if it always is.

    Parameters
    ----------
    loop : Loop
    phase : float
        Phase that is lost beside the delay, rad.
    """
    if not is_stable(loop):
        return -math.inf
    found = math.inf
    for w in _crossings(loop):
        value = np.polyval(loop.N, 1j * w) / np.polyval(loop.D, 1j * w)
        # the delay turns the phase back until it is -pi
        turn = (np.angle(value) + math.pi) % (2 * math.pi)
        if phase > turn:
            return -math.inf
        found = min(found, (turn - phase) / w)
    return found


def _crossings(loop: Loop) -> FloatArray:
    """Frequencies at which the gain of a loop is one, rad/s."""
    polynomial = np.polysub(_squared(loop.D), _squared(loop.N))
    roots = np.roots(np.trim_zeros(polynomial, "f"))
    real = roots[np.abs(roots.imag) <= _TINY * np.abs(roots)].real
    return np.asarray(np.sqrt(real[real > 0]))


def _squared(p: FloatArray) -> FloatArray:
    """|p(jw)|^2 as a polynomial in w^2."""
    alternate = p * (-1.0) ** np.arange(len(p) - 1, -1, -1)
    product = np.polymul(p, alternate)[::2]  # in s^2
    return np.asarray(product * (-1.0) ** np.arange(len(product) - 1, -1, -1))


def delay_limit(loop: Loop, margins: Margins) -> float:
    """The longest delay, s, with which a loop keeps margins; negative infinity if none does.

    The gain is tried at both ends of its margin and between.
    """
    limit = delay_margin(loop, margins.phase)
    if margins.gain > 1:
        for gain in np.geomspace(1 / margins.gain, margins.gain, _BETWEEN):
            if limit == -math.inf:
                break
            limit = min(limit, delay_margin(loop.scaled(float(gain))))
    return limit


def best_gains(
    plant: Plant,
    bounds: Sequence[tuple[float, float]],
    margins: Margins,
    start: FloatArray | None = None,
) -> tuple[FloatArray, float]:
    """The gains within bounds that bear the longest delay, and that delay.

    Parameters
    ----------
    plant : Plant
    bounds : sequence of (low, high)
        Of each gain; the search is on their logarithms where both are positive.
    margins : Margins
    start : ndarray, optional
        Gains to begin from, beside a grid.

    Returns
    -------
    gains : ndarray, shape (outputs,)
    delay : float
        s; negative infinity if no gains hold it.
    """
    from scipy.optimize import minimize

    low, high = np.array(bounds, dtype=float).T
    shares = np.linspace(0.0, 1.0, _GRID)
    grid = np.stack(np.meshgrid(*[shares] * len(low), indexing="ij"), -1).reshape(-1, len(low))

    def gains(share: FloatArray) -> FloatArray:
        x = np.clip(share, 0.0, 1.0)
        with np.errstate(divide="ignore", invalid="ignore"):
            ratio = low * (high / low) ** x
        return np.asarray(np.where((low > 0) & (high > low), ratio, low + x * (high - low)))

    def lost(share: FloatArray) -> float:
        delay = delay_limit(plant.loop(gains(share)), margins)
        return 10.0 if delay == -math.inf else -min(delay, _ENOUGH)

    values = [lost(share) for share in grid]
    order = np.argsort(values)[:_STARTS]
    best, least = grid[order[0]], values[order[0]]
    for k in order:
        if values[k] > 0:
            break
        found = minimize(lost, grid[k], method="Nelder-Mead", options=_POLISHED)
        if found.fun < least:
            best, least = found.x, found.fun
    if start is not None and (delay := delay_limit(plant.loop(start), margins)) > -least:
        return start, delay
    return gains(best), -math.inf if least > 0 else -least


#: Points of the grid along each gain, from how many of which the search is polished, and how.
_GRID, _STARTS = 13, 3
_POLISHED = {"xatol": 1e-5, "fatol": 1e-7, "maxiter": 400}
#: A delay beyond which nobody asks, s.
_ENOUGH = 100.0
