"""Models that nobody ships: derived once for each test process, as their author would."""

from __future__ import annotations

import tempfile
from functools import cache
from pathlib import Path

from groundroll import Aircraft
from groundroll.derive.emit.own import derive_file
from groundroll.model.models import Model

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
CORNERS = Aircraft(
    "corners",
    {"m": 1200.0, "Izz": 1500.0, "u": 20.0, "g": 9.81},
    own={
        "arm": 1.3,
        "C": "9e4 N/rad",
        "limit": "6 kN",
        "scrub": 1.1,
        "hold": "5 kN",
        "crawl": "0.5 m/s",
        "wall": 3.0,
        "k_wall": 2e4,
    },
)
TRAILER = CAR.with_own(
    {
        **CAR.own,
        "l_hitch": 2.5,
        "l_trailer": 3.5,
        "l_axle": 4.0,
        "m_trailer": 900.0,
        "I_trailer": 1800.0,
        "C_trailer": "6e4 N/rad",
    }
)
TABLE = Aircraft(
    "table",
    {"m": 40.0, "Ixx": 3.0, "Iyy": 5.0, "Izz": 7.0, "Ixz": 0.4, "g": 9.81},
    own={
        "x_leg": 0.6,
        "y_leg": 0.4,
        "z_leg": 1.0,
        "k_leg": 8e3,
        "c_leg": 300.0,
        "d_foot": 40.0,
        "m_load": 12.0,
        "x_load": 0.2,
        "y_load": 0.1,
        "z_load": 0.5,
    },
)
DRIVER = CAR.with_own({**CAR.own, "K_psi": 0.4, "K_Y": "0.02 rad/m", "T_driver": "0.2 s"})
LEVEL_LOADS = Aircraft(
    "level_loads",
    {"m": 900.0, "Izz": 1400.0, "u": 25.0, "g": 9.81},
    own={
        "l_front": 0.5,
        "l_rear": 4.0,
        "half": 1.1,
        "cg_height": 1.2,
        "grip": 0.7,
        "C_load": 9.0,
        "L_q": 4.0,
        "x_wing": 0.1,
        "M_q": -0.5,
        "z_thrust": 0.2,
    },
)
PLANES = {
    "single_track": CAR,
    "four_wheels": FOUR,
    "lagging": LAGGING,
    "corners": CORNERS,
    "trailer": TRAILER,
    "table": TABLE,
    "driver": DRIVER,
    "level_loads": LEVEL_LOADS,
}
