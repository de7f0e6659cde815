"""The thesis's aircraft: what its linear and its non-linear model have in common."""

from __future__ import annotations

from groundroll.derive.core.body import Body, a_y, beta, sum_F, sum_M
from groundroll.derive.core.frames import i
from groundroll.derive.core.model import Model
from groundroll.derive.core.part import Part
from groundroll.derive.parts.quantities import PARAMETERS, F_disturbance, a, b
from groundroll.derive.parts.thesis import (
    F_main,
    F_tail,
    F_tail_wheel,
    alpha,
    displacements,
    disturbance,
    gamma,
    main_gear,
    tail_wheel,
    vertical_tail,
)
from groundroll.derive.parts.tires import Tire


def thesis_model(name: str, summary: str, tire: Tire) -> Model:
    """Main gear, vertical tail and tail wheel on a level body whose speed is held."""
    return Model(
        name,
        summary,
        body=Body(speed="held", stands="level"),
        parts=[
            Part("main_gear", a * i, main_gear(tire), suffix="", kind="wheels"),
            Part("vertical_tail", -b * i, vertical_tail, suffix="", kind="fin"),
            Part("tail_wheel", -b * i, tail_wheel, suffix="", kind="wheel"),
            Part("disturbance", -b * i, disturbance, asks=(F_disturbance,), suffix=""),
            Part("displacements", 0 * i, displacements, suffix="", kind=""),
        ],
        outputs=(alpha, gamma, beta, F_main, F_tail, F_tail_wheel, a_y, sum_F, sum_M),
        parameters=PARAMETERS,
    )
