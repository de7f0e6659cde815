"""Derivatives of the whole aircraft, or of the aircraft without fin or tailplane: never both."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import NamedTuple

import numpy as np

from groundroll.base.arrays import FloatArray

#: What says whether the derivatives leave a surface out, its name, and what they hold of it.
_APART = {
    "fin_apart": (
        "fin",
        ("CY_beta", "CY_r", "CY_rudder", "Cn_beta", "Cn_r", "Cn_rudder"),
    ),
    "tailplane_apart": ("tailplane", ("Cm_alpha", "Cm_q", "Cm_elevator")),
}


def held(derivatives: Collection[str]) -> dict[str, str]:
    """The parameters that are 0 because some of these derivatives hold a surface, and which."""
    return {s: surface for s, (surface, own) in _APART.items() if set(own) & set(derivatives)}


class Doubt(NamedTuple):
    """A parameter that must say more: what was found, and what was expected."""

    symbol: str
    found: str
    expected: str


def doubts(given: Mapping[str, FloatArray], needed: Collection[str] = _APART) -> Iterator[Doubt]:
    """Where a surface would count twice, or not at all.

    Parameters
    ----------
    given : mapping of str to ndarray
        What an aircraft is given, by symbol.
    needed : collection of str
        Parameters that matter.
    """
    for symbol, (surface, derivatives) in _APART.items():
        held = [s for s in derivatives if s in given and given[s].any()]
        if symbol not in needed:
            continue
        choice = f"1 if the derivatives leave the {surface} out, 0 if they hold it"
        if symbol not in given:
            if held:
                yield Doubt(symbol, f"nothing beside {', '.join(held)}", choice)
        elif not np.isin(given[symbol], (0.0, 1.0)).all():
            yield Doubt(symbol, f"{given[symbol].ravel()[0]:g}", choice)
        elif not held and not given[symbol].all():
            wanted = f"1, or the derivatives that hold the {surface}: {', '.join(derivatives)}"
            yield Doubt(symbol, "0 and no derivatives that are not 0", wanted)
