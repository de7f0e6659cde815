"""Tires of ``.tir`` files: pure lateral slip of the Magic Formula, MF-Tyre 5.2 and 6.x.

A file is read for its curve over slip angle and load, without camber, without its shifts (ply steer
and conicity) and at its own pressure. That is then data like any other, which
`groundroll.tires.fit` fits.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from groundroll.base.errors import GroundrollError, listed
from groundroll.base.files import text_of
from groundroll.base.units import UnitError, to_si
from groundroll.base.wording import encodable
from groundroll.generated import build
from groundroll.model.evaluate import elementwise

if TYPE_CHECKING:
    from .data import TireData


#: ``KEY = value``; what comes behind is a comment.
_ENTRY = re.compile(r"\s*(?P<key>[A-Za-z]\w*)\s*=\s*(?P<value>'[^']*'|\"[^\"]*\"|[^\s$!]*)")
#: What a file that does not say is taken to have.
_DEFAULTS = {"PKY4": 2.0, "LFZO": 1.0, "LCY": 1.0, "LMUY": 1.0, "LEY": 1.0}
_DEFAULTS |= {"LKY": 1.0, "LHY": 1.0, "LVY": 1.0}
_NEEDED = ("FNOMIN", "PCY1", "PDY1", "PKY1", "PKY2")
#: The curve is taken at these slip angles and shares of the nominal load, as far as the file goes.
_ANGLES = np.radians([0.5, 1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 20])
_LOADS = np.array([0.4, 0.7, 1.0, 1.3, 1.6])


def read(path: Path, make: Callable[..., TireData]) -> TireData:
    """Read the lateral force of a ``.tir`` file.

    Parameters
    ----------
    path : Path
        The file; units as its section UNITS says, N and rad if it does not.

    Raises
    ------
    GroundrollError
        If it cannot be read, lacks a coefficient, or describes no tire.
    """
    entries = _entries(text_of(path, otherwise="cp1252"))
    mistakes: list[str] = []
    force = _unit(entries, "FORCE", "N", mistakes)
    angle = _unit(entries, "ANGLE", "rad", mistakes)
    if angle != 1.0:
        mistakes.append(f"line {entries['ANGLE'][0]}: the coefficients need angles in radians")
    names = [s for s in build("mf_lateral").name_in() if s not in ("alpha", "Fz", "tangent")]
    values = {s: _number(entries, s, mistakes) for s in names}
    for s in _NEEDED:
        if s not in entries:
            mistakes.append(f"{s} is missing: is it a file of MF-Tyre 5.2 or 6.x?")
    limits = {s: _number(entries, s, mistakes) for s in ("FZMIN", "FZMAX", "ALPMIN", "ALPMAX")}
    if mistakes:
        raise GroundrollError(listed(str(path), mistakes))
    is_six = _is_six(entries)
    values |= {"tangent": float(is_six), "LHY": 0.0, "LVY": 0.0}
    values |= {} if is_six else {"PKY4": _DEFAULTS["PKY4"]}
    try:
        return _tire(path, values, limits, force, make)
    except GroundrollError as problem:
        raise GroundrollError(f"{path}: {problem}") from None


def _tire(
    path: Path,
    values: dict[str, float],
    limits: dict[str, float],
    force: float,
    make: Callable[..., TireData],
) -> TireData:
    """Points of the curve, at slip angles of both signs."""
    nominal = values["FNOMIN"]
    if not nominal > 0:
        raise GroundrollError(f"FNOMIN must be positive, not {nominal:g}")
    loads = _within(_LOADS * nominal, limits["FZMIN"], limits["FZMAX"])
    widest = min((abs(limits[s]) for s in ("ALPMIN", "ALPMAX") if limits[s]), default=np.inf)
    angles = _within(_ANGLES, 0.0, widest)
    alpha, Fz = np.meshgrid(np.concatenate([-angles[::-1], angles]), loads)
    arguments = {s: np.asarray(value) for s, value in values.items()}
    F = elementwise("mf_lateral", {**arguments, "alpha": alpha, "Fz": Fz})["F_mf"]
    kind = "6.x" if values["tangent"] else "5.2"
    note = (
        f"read as Magic Formula {kind}, without camber and shifts, at the pressure of its"
        " coefficients"
    )
    points = (alpha.ravel(), force * Fz.ravel(), force * F.ravel())
    return make(encodable(path.stem), *points, notes=(note,))


def _within(
    values: np.typing.NDArray[np.float64], low: float, high: float
) -> np.typing.NDArray[np.float64]:
    """Values as far as limits go, and the limits where these cut some off; no limit is 0."""
    top = high if high > 0 else np.inf
    inside = values[(values >= low) & (values <= top)]
    ends = [end for end in (low, top) if values[0] < end < values[-1]]
    return np.unique(np.concatenate([inside, ends])) if inside.size or ends else values


def _entries(text: str) -> dict[str, tuple[int, str]]:
    """Line and value of each key, the first of its name."""
    found: dict[str, tuple[int, str]] = {}
    for number, line in enumerate(text.splitlines(), start=1):
        match = None if line.lstrip().startswith(("$", "!", "[", "#")) else _ENTRY.match(line)
        if match:
            found.setdefault(match["key"].upper(), (number, match["value"].strip("'\" ")))
    return found


def _number(entries: dict[str, tuple[int, str]], key: str, mistakes: list[str]) -> float:
    if key not in entries:
        return _DEFAULTS.get(key, 0.0)
    line, text = entries[key]
    try:
        value = float(re.sub("[dD]", "e", text))
    except ValueError:
        value = float("nan")
    if not np.isfinite(value):
        mistakes.append(f"line {line}: {key} = {text[:40]!r} is not a finite number")
    return value


def _unit(entries: dict[str, tuple[int, str]], key: str, unit: str, mistakes: list[str]) -> float:
    """How many SI units the unit of a file is."""
    line, text = entries.get(key, (0, unit))
    try:
        return to_si(f"1 {text.lower() if len(text) > 2 else text}", unit, f"line {line}, {key}")
    except UnitError as problem:
        mistakes.append(str(problem))
        return 1.0


def _is_six(entries: dict[str, tuple[int, str]]) -> bool:
    """Whether a file is of MF 6.x, by its FITTYP or by a coefficient that 5.2 has not."""
    fit = entries.get("FITTYP", (0, ""))[1]
    if fit.isdigit():
        return int(fit) >= 60
    return "PPY1" in entries
