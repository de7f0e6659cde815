"""The gear: where its wheels are, its legs, the runway under each wheel."""

from __future__ import annotations

from groundroll.derive.core.quantity import Parameter, Quantity

from .leg import Leg

track = Parameter("track", "track", "m", "left to right main wheel", sign=">0")
z_main = Parameter(
    "z_main",
    "main_wheel_depth",
    "m",
    "contact of a main wheel below the CG, leg unloaded",
    sign=">0",
)
a_third = Parameter(
    "a_third", "third_wheel_arm", "m", "third wheel ahead of the CG; negative: a tail wheel"
)
z_third = Parameter(
    "z_third", "third_wheel_depth", "m", "contact of the third wheel below the CG, leg unloaded"
)
theta_ground = Parameter(
    "theta_ground",
    "ground_attitude",
    "rad",
    "pitch, on three wheels, of the axes in which stations are measured; nose up",
    r"\theta_{\mathrm{ground}}",
)
toe = Parameter("toe", "toe_in", "rad", "of each main wheel, toward the nose of the aircraft")


def _leg(wheel: str, meaning: str) -> Leg:
    return Leg(
        Parameter(
            f"k_{wheel}",
            f"{wheel}_leg_stiffness",
            "N/m",
            f"of the leg of {meaning}, per stroke along the body's z axis",
            sign=">0",
        ),
        Parameter(
            f"c_{wheel}", f"{wheel}_leg_damping", "N s/m", f"of the leg of {meaning}", sign=">=0"
        ),
    )


MAIN_LEG = _leg("main", "a main wheel")
THIRD_LEG = _leg("third", "the third wheel")


def surface(wheel: str) -> Quantity:
    """What the runway under a wheel makes of its tire's friction."""
    return Parameter(
        f"surface_{wheel}",
        f"surface_friction_{wheel}",
        "1",
        f"friction on the runway under the {wheel} wheel over that on a dry one",
        sign=">0",
    )


def rolling(wheel: str) -> Quantity:
    """What it takes to roll over the runway under a wheel."""
    return Parameter(
        f"mu_roll_{wheel}",
        f"rolling_resistance_{wheel}",
        "1",
        f"rolling resistance over load, {wheel} wheel",
        sign=">=0",
    )
