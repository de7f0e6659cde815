"""The landing roll once more, in plain NumPy and SciPy: an oracle apart from `derive`.

A rigid body in six degrees of freedom on three sprung legs, in the air, written down with vectors
from the same documents as the model, for tests only. An aircraft is a plain dictionary in SI and
radians with the keys of `tests/data/landing_roll_runs.json`, and more for what those runs lack.
"""

from .air import Air
from .roll import STATES, Roll, rest, simulate
from .signals import Signal, value

__all__ = ["STATES", "Air", "Roll", "Signal", "rest", "simulate", "value"]
