"""What every tool of the benchmark shares: the job, the errors, the limit, the clock.

Needs NumPy and nothing else, because each tool imports it in its own environment. Every sample of
a tool stands between two of the limit in the same process, so that the ratio survives a busy
machine.
"""

from __future__ import annotations

import ctypes
import json
import math
import statistics
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

DEG = 180 / math.pi
T_END = 5.0
TIMES = np.linspace(0.0, T_END, 501)
TARGETS = (1e-6, 1e-9)
#: The thesis's aircraft (a = -0.5 m, all the weight on the main gear) with the right C5.
CONSTANTS = {
    "MASS": 748.43,
    "IZZ": 1760.0,
    "ARM_B": 3.92176,
    "RHO": 1.225,
    "AP": 0.6929,
    "CL_GAMMA": 0.1 * DEG,
    "FZ": 748.43 * 9.81 / 2,
    "B3": 0.2117 * DEG,
    "C3": -2.2918e-5 * DEG,
    "B5": 0.7221,
    "C5": -8.81055e-6,
    "B1": 0.7947,
    "C1": 0.1901,
    "D1": 6.1197,
    "E1": 1.0637,
    "C_ALPHA": 25000.0,
}
SINGLE = {"a": -0.5, "Ct": 0.0, "u": 27.7778, "v0": 0.1}
REPEATS = 9
MOST = 100_000


def draw(n: int) -> list[np.ndarray]:
    """a, Ct, u and v0 of the ensemble; a smaller draw is the beginning of a larger one."""
    z = np.random.default_rng(2024).random((MOST, 4))[:n]
    low, high = np.array([-1.0, 0.0, 15.0, 0.01]), np.array([1.0, 8000.0, 40.0, 2.0])
    return [np.ascontiguousarray(column) for column in (low + (high - low) * z).T]


def linear_draw(n: int) -> list[np.ndarray]:
    """a, Ct and u of the linearisations."""
    rng = np.random.default_rng(7)
    return [rng.uniform(-1, 1, n), rng.uniform(0, 8000, n), rng.uniform(15, 40, n)]


def rates(x: Sequence[Any], a: Any, Ct: Any, u: Any, math: Any = math) -> list[Any]:
    """The right-hand side as the formulas stand, for whatever has atan and sin."""
    c = CONSTANTS
    friction = c["B5"] + c["C5"] * c["FZ"]
    slip = (c["B3"] + c["C3"] * c["FZ"]) * ((x[0] + a * x[1]) / u) / friction
    psi = (1 - c["E1"]) * slip + c["E1"] / c["B1"] * math.atan(c["B1"] * slip)
    main = 2 * c["D1"] * math.sin(c["C1"] * math.atan(c["B1"] * psi)) * friction * c["FZ"]
    tail = 0.5 * c["RHO"] * u * u * c["AP"] * c["CL_GAMMA"] + Ct
    side = tail * math.atan((x[0] - c["ARM_B"] * x[1]) / u)
    return [
        (-main - side) / c["MASS"] - u * x[1],
        (-a * main + c["ARM_B"] * side) / c["IZZ"],
        x[0],
        x[1],
    ]


# --- Errors ---------------------------------------------------------------------------------


def reference(folder: Path) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    data = np.load(folder / "reference.npz")
    return data["final"], data["scale"], data["single"]


def ensemble_error(folder: Path, x: np.ndarray, index: Any = None) -> float:
    """Worst error over trajectories and states, relative to each state's range on each."""
    final, scale, _ = reference(folder)
    index = np.arange(len(x)) if index is None else index
    return float(np.max(np.abs(x - final[index]) / scale[index]))


def single_error(folder: Path, x: np.ndarray) -> float:
    """Worst error over times and states, relative to each state's range."""
    exact = reference(folder)[2]
    return float(np.max(np.abs(np.asarray(x) - exact) / np.abs(exact).max(axis=0)))


def tolerance(
    run: Callable[[float], np.ndarray],
    error: Callable[[np.ndarray], float],
    target: float,
    finest: float = 1e-13,
    coarsest: float = 1e-3,
) -> tuple[float, float] | None:
    """Coarsest tolerance, two to a decade, that meets the target, and its error."""
    tol = coarsest
    while tol >= finest * 0.99:
        if (found := error(run(tol))) <= target:
            return tol, found
        tol /= math.sqrt(10)
    return None


# --- The limit ------------------------------------------------------------------------------


class Limit:
    """The hand-written C."""

    def __init__(self, folder: Path, steps: dict[str, Any] | None = None) -> None:
        self._library = ctypes.CDLL(str(folder / "limit.so"))
        self._steps = json.loads((folder / "limits.json").read_text()) if steps is None else steps

    def ensemble(self, n: int, steps: int, threads: int = 1) -> Callable[[], np.ndarray]:
        columns, out = draw(n), np.empty((n, 4))
        pointers = [ctypes.c_void_p(c.ctypes.data) for c in columns]
        N, target = ctypes.c_int64, ctypes.c_void_p(out.ctypes.data)

        def run() -> np.ndarray:
            assert columns
            self._library.ensemble(N(n), *pointers, N(steps), target, N(threads))
            return out

        return run

    def single(self, steps: int, growth: float, repeat: int = 1) -> Callable[[], np.ndarray]:
        out, D, N = np.empty((TIMES.size, 4)), ctypes.c_double, ctypes.c_int64
        start = [D(SINGLE[k]) for k in ("a", "Ct", "u", "v0")]

        def run() -> np.ndarray:
            target = ctypes.c_void_p(out.ctypes.data)
            self._library.single(*start, N(steps), D(growth), N(TIMES.size), N(repeat), target)
            return out

        return run

    def linear(self, n: int, threads: int = 1, new: bool = False) -> Callable[[], list[np.ndarray]]:
        """Into the same arrays again and again, or into new ones."""
        columns, kept = linear_draw(n), [np.empty(n) for _ in range(6)]
        pointers = [ctypes.c_void_p(c.ctypes.data) for c in columns]

        def run() -> list[np.ndarray]:
            assert columns
            out = [np.empty(n) for _ in range(6)] if new else kept
            table = (ctypes.c_void_p * 6)(*(o.ctypes.data for o in out))
            self._library.linear(ctypes.c_int64(n), *pointers, table, ctypes.c_int64(threads))
            return out

        return run

    def job(self, job: str, target: float, threads: int) -> tuple[Callable[[], Any], float]:
        """The limit of a job, and how much of a call one job is."""
        if job == "S":
            return self.single(*self._steps[f"S/{target:g}"], 300), 1 / 300
        if job in ("L", "N"):
            return self.linear(1_000_000, threads, new=job == "N"), 1.0
        n = int(job[1:])
        return self.ensemble(n, self._steps[f"E{n}/{target:g}"], threads), 1.0


# --- The clock ------------------------------------------------------------------------------


def clock(run: Callable[[], object], inner: int = 1) -> float:
    """Seconds for one of `inner` calls."""
    begin = time.perf_counter()
    for _ in range(inner):
        run()
    return (time.perf_counter() - begin) / inner


class Bench:
    """Times a tool against the limit and prints one JSON line for each row."""

    def __init__(self, folder: Path, tool: str, version: str) -> None:
        self.folder, self.tool, self.version = folder, tool, version
        self.limit = Limit(folder)

    def row(
        self,
        job: str,
        target: float,
        variant: str,
        run: Callable[[], object],
        error: float | None,
        setting: str = "",
        *,
        threads: int = 1,
        share: float = 1.0,
        inner: int = 1,
        repeats: int = REPEATS,
        timer: Callable[[Callable[[], Any], int], float] = clock,
    ) -> None:
        """One row: the median over samples of the ratio to the limit.

        Parameters
        ----------
        share : float
            The part of the job that `run` does.
        inner : int
            Calls per sample, for short jobs.
        timer : callable
            Like `clock`, for a tool that looks at its own.
        """
        limit, part = self.limit.job(job, target, threads)
        run(), limit()
        times, limits, ratios = [], [], []
        for _ in range(max(7, repeats)):
            before = clock(limit) * part
            mine = timer(run, inner) / share
            after = clock(limit) * part
            times.append(mine)
            limits.append(min(before, after))
            ratios.append(mine / min(before, after))
        record = {
            "tool": self.tool, "version": self.version, "variant": variant, "job": job,
            "target": target, "threads": threads, "setting": setting, "error": error,
            "seconds": statistics.median(times), "limit": statistics.median(limits),
            "ratio": statistics.median(ratios), "samples": len(times),
        }  # fmt: skip
        print(json.dumps(record), flush=True)
