"""Octave's ode45 and lsode, in one process of Octave that times itself: no start-up is counted."""

from __future__ import annotations

import itertools
import json
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import common
import numpy as np

FOLDER = Path(sys.argv[1])
SCRIPT = Path(__file__).with_suffix(".m")
COMMAND = ["octave-cli", "--quiet", "--no-init-file"]
FEW = 40


class Octave:
    """A process of Octave that answers jobs."""

    def __init__(self) -> None:
        pipe = subprocess.PIPE
        self._process = subprocess.Popen(
            [*COMMAND, str(SCRIPT)], stdin=pipe, stdout=pipe, text=True
        )
        self._send(common.CONSTANTS)

    def close(self) -> None:
        self._process.communicate("\n")

    def _send(self, what: object) -> None:
        assert self._process.stdin is not None
        print(json.dumps(what), file=self._process.stdin, flush=True)

    def __call__(
        self, method: str, tol: float, draws: np.ndarray, times: np.ndarray
    ) -> tuple[float, np.ndarray]:
        """Seconds, and the states one after the other.

        Parameters
        ----------
        draws : ndarray, shape (4 m, n)
            n systems of m stacked trajectories: all a, all Ct, all u, all v0.
        times : ndarray
            Three or more, because ode45 gives every step for two.
        """
        assert self._process.stdout is not None
        job = {"method": method, "tol": tol, "draws": draws.tolist(), "times": times.tolist()}
        self._send({**job, "final": len(times) == 3})
        seconds, *states = map(float, self._process.stdout.readline().split())
        return seconds, np.array(states)


Answer = tuple[float, np.ndarray]


def main() -> None:
    command = [*COMMAND, "--eval", "printf (version)"]
    version = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    bench, octave = common.Bench(FOLDER, "Octave", version), Octave()
    ends = np.array([0.0, common.T_END / 2, common.T_END])
    one = np.array([[common.SINGLE[k]] for k in ("a", "Ct", "u", "v0")])
    draw = np.array(common.draw(10_000))

    def single(method: str, tol: float) -> Answer:
        seconds, x = octave(method, tol, one, common.TIMES)
        return seconds, x.reshape(-1, 4)

    def one_by_one(method: str, tol: float) -> Answer:
        seconds, x = octave(method, tol, draw[:, :FEW], ends)
        return seconds, x.reshape(-1, 4)

    def stacked(method: str, tol: float) -> Answer:
        seconds, x = octave(method, tol, draw.reshape(-1, 1), ends)
        return seconds, x.reshape(4, -1).T

    def single_error(x: np.ndarray) -> float:
        return common.single_error(FOLDER, x)

    def ensemble_error(x: np.ndarray) -> float:
        return common.ensemble_error(FOLDER, x, np.arange(len(x)))

    ways = (
        ("S", "", "", single, single_error, 1.0),
        ("E10000", ", in a loop", f", {FEW} of them", one_by_one, ensemble_error, FEW / 10_000),
        ("E10000", ", all in one system", "", stacked, ensemble_error, 1.0),
    )
    for method, target in itertools.product(("ode45", "lsode"), common.TARGETS):
        for job, how, sample, run, error, share in ways:

            def solve(tol: float, run=run, method=method) -> Answer:
                return run(method, tol)

            if found := common.tolerance(lambda tol: solve(tol)[1], error, target, coarsest=1e-4):
                bench.row(
                    job, target, method + how, lambda t=found[0]: solve(t), found[1],
                    f"RelTol {found[0]:.1e}{sample}", share=share, timer=own_clock, repeats=7,
                )  # fmt: skip
    octave.close()


def own_clock(run: Callable[[], Answer], inner: int) -> float:
    return sum(run()[0] for _ in range(inner)) / inner


if __name__ == "__main__":
    main()
