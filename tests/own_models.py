"""Models that nobody ships: derived once for each test process, as their author would."""

from __future__ import annotations

import tempfile
from functools import cache
from pathlib import Path

from groundroll import Aircraft
from groundroll.derive.emit.own import derive_file
from groundroll.models import Model

HERE = Path(__file__).parent / "models"
NAMES = tuple(sorted(path.stem for path in HERE.glob("*.py")))
_FOLDER = tempfile.TemporaryDirectory(prefix="groundroll-own-")


@cache
def own(name: str) -> Model:
    """The model in ``models/<name>.py``, read from its pack."""
    out = Path(_FOLDER.name) / name
    derive_file(HERE / f"{name}.py", out)
    return Model.load(out)


CAR = Aircraft(
    "car",
    {"m": 1500.0, "Izz": 2500.0, "u": 30.0, "g": 9.81},
    own={
        "l_front": "1.2 m",
        "rear_arm": 1.6,
        "front_stiffness": "1.2e5 N/rad",
        "C_rear": "150 kN/rad",
    },
)
FOUR = CAR.with_own({**CAR.own, "width": 1.5, "grip": 0.9, "wheel_load": "3.6 kN"})
LAGGING = Aircraft(
    "lagging",
    {"m": 1000.0, "Izz": 2000.0, "u": 25.0, "g": 9.81},
    own={"arm": -0.5, "tail": 5.0, "C_main": 5e4, "C_tail": 8e3, "lag": "50 ms"},
)
PLANES = {"single_track": CAR, "four_wheels": FOUR, "lagging": LAGGING}
