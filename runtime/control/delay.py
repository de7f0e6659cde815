"""How late feedback may come: exact delay margins of linear loops, and the best gains.

A plant x' = A x + b u is held by u = -e^(-tau s) (K y) / (T s + 1): somebody sees y = C x, and acts
`tau` later through muscles with the lag `T`. The loop crosses unit gain at the imaginary
eigenvalues of a Hamiltonian matrix; the delay that turns its phase to -180 degrees at the first of
these crossings is the delay margin. Nothing is approximated but by rounding (J. E. Marshall et al.,
*Time-Delay Systems: Stability and Performance Criteria with Applications*, Ellis Horwood 1992,
chapter 2: the direct method; S. Boyd, V. Balakrishnan and P. Kabamba, *A bisection method for
computing the H-infinity norm of a transfer matrix*, Math. Control Signals Systems 2, 1989: the
Hamiltonian). Everything takes arrays of plants and of gains; they broadcast.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from groundroll.base.arrays import FloatArray, finite
from groundroll.base.errors import GroundrollError

IntArray = npt.NDArray[np.intp]

#: Gains at which a loop is tried between the ends of its gain margin.
_BETWEEN = 5
#: Real part over size up to which an eigenvalue counts as imaginary, and how near to one its gain
#: must then be.
_TINY, _NEAR = 1e-5, 1e-3
#: A lag so short that no frequency feels it, s.
_AT_ONCE = 1e-7
#: A frequency so low that a period takes days, rad/s.
_SLOW = 1e-6


@dataclass(frozen=True)
class Loop:
    """Open loops c (s - A)^-1 b, apart from the delay.

    Attributes
    ----------
    A : ndarray, shape (..., n, n)
    b, c : ndarray, shape (..., n)
    """

    A: FloatArray
    b: FloatArray
    c: FloatArray

    def scaled(self, gain: float) -> Loop:
        """The loops with another gain."""
        return Loop(self.A, self.b, gain * self.c)

    @property
    def shape(self) -> tuple[int, ...]:
        """Of the loops."""
        return np.broadcast_shapes(self.A.shape[:-2], self.b.shape[:-1], self.c.shape[:-1])

    def flat(self) -> Loop:
        """The loops in a row."""
        n = self.b.shape[-1]
        A = np.broadcast_to(self.A, (*self.shape, n, n)).reshape(-1, n, n)
        b, c = (np.broadcast_to(x, (*self.shape, n)).reshape(-1, n) for x in (self.b, self.c))
        return Loop(A, b, c)

    def some(self, which: IntArray) -> Loop:
        """Some of the loops in a row."""
        return Loop(self.A[which], self.b[which], self.c[which])

    def at(self, w: FloatArray) -> FloatArray:
        """Values at frequencies, rad/s; one for each of the loops in a row."""
        s = 1j * w[:, None, None] * np.eye(self.b.shape[-1]) - self.A
        return np.asarray((self.c * np.linalg.solve(s, self.b[..., None])[..., 0]).sum(axis=-1))


@dataclass(frozen=True)
class Plant:
    """Plants with one input, behind the lag of the actuator.

    Attributes
    ----------
    A : ndarray, shape (..., n, n)
    b : ndarray, shape (..., n)
    C : ndarray, shape (..., outputs, n)
    """

    A: FloatArray
    b: FloatArray
    C: FloatArray

    @classmethod
    def of(cls, A: FloatArray, B: FloatArray, C: FloatArray, lag: float) -> Plant:
        """From matrices; `B` is one column, `lag` in s: one more state, or none without."""
        if lag < _AT_ONCE:
            return cls(A, B, C)
        shape, n = A.shape[:-2], A.shape[-1]
        wide = np.zeros((*shape, n + 1, n + 1))
        wide[..., :n, :n], wide[..., :n, n], wide[..., n, n] = A, B, -1 / lag
        b = np.zeros(n + 1)
        b[n] = 1 / lag
        return cls(wide, b, np.concatenate([C, np.zeros((*C.shape[:-1], 1))], axis=-1))

    def loop(self, gains: FloatArray) -> Loop:
        """The open loops with gains of shape (..., outputs)."""
        return Loop(self.A, self.b, np.asarray((gains[..., None, :] @ self.C)[..., 0, :]))


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

    def __post_init__(self) -> None:
        for name, unit in (("gain", "1"), ("phase", "rad")):
            number = finite(name, getattr(self, name), unit)
            if number.ndim or number < (1.0 if name == "gain" else 0.0):
                least = "1, which is no margin," if name == "gain" else "0"
                raise GroundrollError(
                    f"the margin of {name} must be a number from {least} up, not {number}"
                )
            object.__setattr__(self, name, float(number))
        if self.phase >= math.pi:
            raise GroundrollError(
                f"a margin of phase of {math.degrees(self.phase):g} deg is half a turn or more: no"
                " loop has it"
            )


def is_stable(loop: Loop) -> FloatArray:
    """Whether the closed loops without delay are stable."""
    closed = loop.A - loop.b[..., :, None] * loop.c[..., None, :]
    return np.asarray((np.linalg.eigvals(closed).real < 0).all(axis=-1))


def delay_margin(loop: Loop, phase: float = 0.0) -> FloatArray:
    """The least delay, s, that makes closed loops unstable; negative infinity if they always are.

    Parameters
    ----------
    loop : Loop
    phase : float
        Phase that is lost beside the delay, rad.
    """
    flat = loop.flat()
    stable = np.flatnonzero(is_stable(flat))
    found = np.full(len(flat.b), -np.inf)
    found[stable] = np.inf
    which, w = _crossings(flat.some(stable))
    which = stable[which]
    value = flat.some(which).at(w)
    real = np.abs(np.abs(value) - 1) < _NEAR
    which, w, value = which[real], w[real], value[real]
    # the delay turns the phase back until it is -pi
    left = (np.angle(value) + math.pi) % (2 * math.pi) - phase
    np.minimum.at(found, which, np.where(left < 0, -np.inf, left / w))
    return found.reshape(loop.shape)


def _crossings(loop: Loop) -> tuple[IntArray, FloatArray]:
    """Frequencies at which the gain of loops in a row may be one, rad/s, and of which each is."""
    n = loop.b.shape[-1]
    H = np.empty((len(loop.b), 2 * n, 2 * n))
    sizes = (np.abs(x).max(axis=-1, initial=0.0) for x in (loop.c, loop.b))
    with np.errstate(divide="ignore", invalid="ignore"):
        even = np.nan_to_num(np.divide(*sizes), nan=1.0, posinf=1.0)
    even = np.where(even > 0, even, 1.0)[:, None, None]
    H[:, :n, :n] = loop.A
    H[:, :n, n:] = even * loop.b[:, :, None] * loop.b[:, None, :]
    H[:, n:, :n] = -loop.c[:, :, None] * loop.c[:, None, :] / even
    H[:, n:, n:] = -loop.A.transpose(0, 2, 1)
    roots = np.linalg.eigvals(H) if len(H) else np.empty((0, 2 * n))
    imaginary = (np.abs(roots.real) <= _TINY * np.abs(roots)) & (roots.imag > _SLOW)
    which, k = np.nonzero(imaginary)
    return which, np.asarray(roots.imag[which, k])


def delay_limit(loop: Loop, margins: Margins) -> FloatArray:
    """The longest delay, s, with which loops keep margins; negative infinity if none does.

    The gain is tried at both ends of its margin and between.
    """
    shape, loop = loop.shape, loop.flat()
    limit = np.full(len(loop.b), np.inf)
    gains = np.geomspace(1 / margins.gain, margins.gain, _BETWEEN) if margins.gain > 1 else ()
    # what is unstable at the low end is not looked at any longer
    for gain, phase in ((1.0, margins.phase), *((float(gain), 0.0) for gain in gains)):
        left = np.flatnonzero(limit > -np.inf)
        found = delay_margin(loop.some(left).scaled(gain), phase)
        limit[left] = np.minimum(limit[left], found)
    return limit.reshape(shape)


def best_gains(
    plant: Plant, bounds: Sequence[tuple[float, float]], margins: Margins
) -> tuple[FloatArray, FloatArray]:
    """The gains within bounds that bear the longest delay, and that delay.

    A grid over the bounds is followed by finer ones about the best, each half as wide.

    Parameters
    ----------
    plant : Plant
    bounds : sequence of (low, high)
        Of each gain; the search is on their logarithms where both are positive.
    margins : Margins

    Returns
    -------
    gains : ndarray, shape (..., outputs)
    delay : ndarray, shape (...)
        s; negative infinity where no gains hold it.
    """
    low, high = np.array(bounds, dtype=float).T
    shape, n = plant.A.shape[:-2], plant.A.shape[-1]
    A = plant.A.reshape(-1, 1, n, n)
    b = np.broadcast_to(plant.b, (*shape, n)).reshape(-1, 1, n)
    C = np.broadcast_to(plant.C, (*shape, *plant.C.shape[-2:])).reshape(-1, 1, len(low), n)
    every = Plant(A, b, C)

    def gains(share: FloatArray) -> FloatArray:
        with np.errstate(divide="ignore", invalid="ignore"):
            ratio = low * (high / low) ** share
        return np.asarray(np.where((low > 0) & (high > low), ratio, low + share * (high - low)))

    best, delay = np.full((len(A), len(low)), 0.5), np.full(len(A), -np.inf)
    half = 0.5
    for count in (_GRID, *[_FINER] * _ROUNDS):
        steps = np.linspace(-half, half, count)
        around = np.stack(np.meshgrid(*[steps] * len(low), indexing="ij"), -1)
        share = np.clip(best[:, None] + around.reshape(-1, len(low)), 0.0, 1.0)
        found = np.minimum(delay_limit(every.loop(gains(share)), margins), _ENOUGH)
        k = found.argmax(axis=1)
        better = found[np.arange(len(A)), k] > delay
        best = np.where(better[:, None], share[np.arange(len(A)), k], best)
        delay = np.maximum(delay, found.max(axis=1))
        half = 2 * half / (count - 1) if count == _GRID else half / 2
    return gains(best).reshape(*shape, len(low)), delay.reshape(shape)


#: Points of the first grid along each gain, of those that follow, and how many follow.
_GRID, _FINER, _ROUNDS = 11, 5, 10
#: A delay beyond which nobody asks, s.
_ENOUGH = 100.0
