"""The thesis's non-linear model (Section 4.6): exact angles and the measured tire."""

from __future__ import annotations

from functools import cache

from groundroll.derive.core.model import Derivation, Model
from groundroll.derive.parts.tires import nonlinear_tire

from .thesis import thesis_model

NONLINEAR: Model = thesis_model(
    "nonlinear", "Exact angles and the non-linear tire (Section 4.6).", nonlinear_tire
)


@cache
def nonlinear() -> Derivation:
    """The equations of the non-linear model."""
    return NONLINEAR.derive()
