"""The thesis's linear model (Section 4.5): small angles and a tire proportional to its slip."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

from groundroll.derive.core.body import beta, r_dot, v_dot
from groundroll.derive.core.linearise import linearise
from groundroll.derive.core.model import Derivation, Model
from groundroll.derive.parts.thesis import F_main, alpha, gamma
from groundroll.derive.parts.tires import linear_tire

from .thesis import thesis_model

#: Exact angles with the linear tire: what the linear model is the linearisation of.
LINEAR_TIRE: Model = thesis_model(
    "linear", "Small angles and the linear tire (Section 4.5).", linear_tire
)

#: Where the thesis prints the linearised links.
_PRINTED = {
    alpha: "Eq. 4.24",
    gamma: "Eq. 4.26",
    beta: "Eq. 4.21",
    F_main: "Eq. 4.28",
    v_dot: "Eq. 4.31",
    r_dot: "Eq. 4.31",
}


@cache
def linear() -> Derivation:
    """The equations of the linear model."""
    model = linearise(LINEAR_TIRE.derive())
    chain = (replace(e, source=_PRINTED.get(e.lhs, e.source)) for e in model.chain)
    return model.replace(chain=tuple(chain))
