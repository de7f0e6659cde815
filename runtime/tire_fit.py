"""From measured tire forces to the parameters of the non-linear tire (Section 3.4)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np

from .arrays import FloatArray, finite
from .errors import GroundrollError
from .evaluate import solved
from .names import QUANTITIES
from .tire_data import TireData
from .tire_quality import LINES, MAGIC, conditioning, force_rms, normalised_rms, residual

#: From where the thesis searched: x0 of MAGICFIT.m, App. A.1.
THESIS_START = (0.7407, 1.35, 1.00, -0.51)

#: The search stays where no slip angle makes the force reverse: with E1 <= 1 psi_bar never
#: turns back, and with C1 <= 2 the sine never passes half a turn.
_LOWEST = (1e-6, 1e-6, 1e-6, -np.inf)
_HIGHEST = (np.inf, 2.0, np.inf, 1.0)

_QUIET: dict[str, Any] = {
    "print_time": False,
    "error_on_fail": False,
    "ipopt": {
        "print_level": 0,
        "sb": "yes",
        "tol": 1e-12,
        "acceptable_iter": 0,  # a point short of the minimum is a failure
        "mu_init": 1e-10,  # the usual barrier, 0.1, is so high here that the start is forgotten
        "bound_relax_factor": 0.0,
    },
}


@dataclass(frozen=True, repr=False, eq=False)
class TireFit:
    """Parameters of the non-linear tire that fit measured forces.

    Attributes
    ----------
    data : TireData
        What was fitted.
    parameters : mapping of str to float
        By symbol (B3, C3, B5, C5, B1, C1, D1, E1), SI units with radians: what
        ``plane.replace(**fit.parameters)`` takes.
    cornering_coefficients, friction_coefficients : ndarray, shape (k,)
        Measured, at each load: 1/rad and 1.
    alpha_bar, F_bar : ndarray, shape (n, k)
        The normalised data.
    rms : float
        Root mean square error of the magic formula, normalised.
    force_rms : float
        Root mean square error of the whole tire, with the straight lines, N.
    conditioning : float
        See `conditioning`.
    at_edge : tuple of str
        Which parameters of the magic formula lie on the edge of the search, where the minimum
        is none of the free function; empty for a proper minimum.
    """

    data: TireData
    parameters: Mapping[str, float]
    cornering_coefficients: FloatArray
    friction_coefficients: FloatArray
    alpha_bar: FloatArray
    F_bar: FloatArray
    rms: float
    force_rms: float
    conditioning: float
    at_edge: tuple[str, ...]

    def __repr__(self) -> str:
        lines = [f"TireFit of {self.data.name!r}"]
        for s, value in self.parameters.items():
            q = QUANTITIES[s]
            lines.append(f"  {s}{value:>14.6g} {q.unit:<10} {q.name}")
        lines += [
            f"  rms {self.rms:.5f} normalised, {self.force_rms:.1f} N",
            f"  conditioning {self.conditioning:.1e}",
            *(f"  {s} is on the edge of the search: no proper minimum" for s in self.at_edge),
        ]
        return "\n".join(lines)


def fit_tire(
    data: TireData | str | Path = "goodyear-6.00-6", start: Sequence[float] = THESIS_START
) -> TireFit:
    """Fit the non-linear tire to measured forces, as Section 3.4 does.

    Coefficients at each load, their straight lines by least squares, and the magic formula by
    least squares on the normalised data (IPOPT with exact derivatives). The search keeps
    B1, D1 > 0, 0 < C1 <= 2 and E1 <= 1, where the force cannot reverse at any slip angle.
    Beyond E1 = 1 lies a valley without a minimum (C1 to 0, D1 to infinity), which fits the
    thesis's data 7 % better and is worthless beyond them; Table 3.2 is a point in it. The
    search is local: on the thesis's data it ends, nine starts out of ten, in one and the same
    minimum, otherwise in a worse one on the edge, E1 = 1 (so does Table 3.2 as a start).

    Parameters
    ----------
    data : TireData or str or Path
        Measured forces, or what `TireData.load` takes.
    start : sequence of 4 floats
        B1, C1, D1, E1 from where to search; default the thesis's own.

    Returns
    -------
    TireFit
        The parameters and how well they fit.

    Raises
    ------
    GroundrollError
        If the search finds no minimum.
    """
    data = data if isinstance(data, TireData) else TireData.load(data)
    C_c, mu = data.coefficients()
    alpha_bar, F_bar = data.normalised()
    B3, C3 = _straight_line(data.loads, C_c)
    B5, C5 = _straight_line(data.loads, mu)
    magic = _least_squares(alpha_bar, F_bar, start, data.name)
    values = (B3, C3, B5, C5, *magic)
    parameters = dict(zip((*LINES, *MAGIC), values, strict=True))
    return TireFit(
        data=data,
        parameters=parameters,
        cornering_coefficients=C_c,
        friction_coefficients=mu,
        alpha_bar=alpha_bar,
        F_bar=F_bar,
        rms=normalised_rms(data, parameters),
        force_rms=force_rms(data, parameters),
        conditioning=conditioning(data, parameters),
        at_edge=_at_edge(magic),
    )


def _straight_line(x: FloatArray, y: FloatArray) -> tuple[float, float]:
    """Intercept and slope of the least-squares line."""
    slope, intercept = np.polyfit(x, y, 1)
    return float(intercept), float(slope)


def _least_squares(
    alpha_bar: FloatArray, F_bar: FloatArray, start: Sequence[float], name: str
) -> list[float]:
    """B1, C1, D1, E1 at the minimum of the sum of squares."""
    x0 = finite("start", start)
    if x0.shape != (len(MAGIC),):
        raise GroundrollError(f"start must be {', '.join(MAGIC)}: 4 numbers, not {start!r}")
    errors, x = residual(alpha_bar, F_bar)
    solver = ca.nlpsol("magic_fit", "ipopt", {"x": x, "f": ca.sumsqr(errors)}, _QUIET)
    solution = solved(solver, x0=x0, lbx=list(_LOWEST), ubx=list(_HIGHEST))
    if not solver.stats()["success"]:
        raise GroundrollError(
            f"tire data {name!r}: the magic formula fit found no minimum from start"
            f" {tuple(map(float, x0))} (IPOPT: {solver.stats()['return_status']}); try another"
            " start, and check that the forces level off within the measured slip angles"
        )
    return [float(value) for value in np.array(solution["x"]).ravel()]


def _at_edge(magic: Sequence[float]) -> tuple[str, ...]:
    near = np.isclose(magic, _LOWEST, atol=1e-6) | np.isclose(magic, _HIGHEST, atol=1e-6)
    return tuple(s for s, there in zip(MAGIC, near, strict=True) if there)
