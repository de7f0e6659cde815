"""An aircraft file of groundroll from files of other programs."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from groundroll.base.errors import GroundrollError
from groundroll.base.files import as_path, complete

from .avl import read_avl
from .jsbsim_reader import read_jsbsim


@dataclass(frozen=True)
class Imported:
    """What became of an import.

    Attributes
    ----------
    path : Path
        The aircraft file.
    left : tuple of str
        What could not be taken, in words.
    """

    path: Path
    left: tuple[str, ...]


def import_aircraft(
    file: str | Path, out: str | Path, derivatives: str | Path | None = None
) -> Imported:
    """Write an aircraft file from an aircraft of JSBSim.

    Mass with point masses, inertias, stations, gear, wing and tail areas, and the derivatives that
    are constants or simple tables, each with where it stands; what is not taken is listed.

    Parameters
    ----------
    file : str or Path
        Aircraft in JSBSim's XML.
    out : str or Path
        The aircraft file; its name ends in .toml.
    derivatives : str or Path, optional
        Stability derivatives as AVL writes them (``.st``), which come before those of `file`.

    Returns
    -------
    Imported

    Raises
    ------
    GroundrollError
        If a file cannot be read, its aircraft does not stand on three wheels, or `out` cannot be
        written. Nothing is left half-written.
    """
    path = as_path(out)
    if path.suffix != ".toml":
        raise GroundrollError(f"found {path.name!r}; expected a name ending in .toml")
    found = read_jsbsim(as_path(file))
    if derivatives is not None:
        more = read_avl(as_path(derivatives))
        found.take(*more.taken.values())
        found.left += more.left
        found.source += f"; AVL, {as_path(derivatives).name}"
    with complete(path) as draft:
        draft.write_text(found.toml(), encoding="utf-8")
    return Imported(path, tuple(found.left))
