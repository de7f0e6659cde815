"""Results on disk: arrays with the parameters and the provenance they came from, as npz.

A record is an npz file that NumPy alone can read: arrays by name, and under ``record`` a text in
JSON that says what they are, of which aircraft, and from which equations.
"""

from __future__ import annotations

import json
import zlib
from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields, replace
from importlib.metadata import version
from pathlib import Path
from typing import Any
from zipfile import BadZipFile

import numpy as np

from .aircraft import Aircraft, Source
from .arrays import FloatArray
from .errors import GroundloopError
from .files import complete
from .generated.names import DIGEST
from .gusts import sampled
from .linearization import Linearization, OperatingPoint
from .simulation import Trajectory

#: Raised when the layout changes.
_LAYOUT = 1
_PACKAGES = ("groundloop", "casadi", "numpy")


@dataclass(frozen=True)
class Record:
    """What a file holds.

    Attributes
    ----------
    kind : str
        What was saved, e.g. ``"trajectory"``.
    arrays : mapping of str to ndarray
        Its arrays, SI units with radians.
    about : mapping
        Its other attributes.
    aircraft : Aircraft
        The aircraft it belongs to, with the source of each number.
    provenance : mapping of str to str
        ``"equations"``, the digest of the derivation, and the version of each package.
    """

    kind: str
    arrays: Mapping[str, FloatArray]
    about: Mapping[str, Any]
    aircraft: Aircraft
    provenance: Mapping[str, str]


def provenance() -> dict[str, str]:
    """What results of this process come from: digest of the equations, versions of packages."""
    return {"equations": DIGEST, **{name: version(name) for name in _PACKAGES}}


def write(
    path: str | Path,
    kind: str,
    arrays: Mapping[str, FloatArray],
    about: Mapping[str, Any],
    aircraft: Aircraft,
) -> Path:
    """Write a record.

    Parameters
    ----------
    path : str or Path
        Where to, ending in ``.npz``; the file appears when it is complete.
    kind, arrays, about, aircraft
        As in `Record`; `about` is anything that JSON can hold.

    Raises
    ------
    GroundloopError
        If the path does not end in ``.npz`` or cannot be written.
    """
    target = Path(path)
    if target.suffix != ".npz":
        raise GroundloopError(f"{target} must end in .npz: records are NumPy archives")
    words = {f.name: getattr(aircraft, f.name) for f in fields(aircraft)}
    text = {
        "layout": _LAYOUT,
        "kind": kind,
        "about": dict(about),
        "aircraft": {key: value for key, value in words.items() if isinstance(value, str)},
        "sources": {s: asdict(source) for s, source in aircraft.sources.items()},
        "provenance": provenance(),
    }
    given = {f"given/{s}": value for s, value in aircraft.given.items()}
    members = {**{f"arrays/{name}": value for name, value in arrays.items()}, **given}
    with complete(target) as draft, draft.open("wb") as file:
        np.savez_compressed(file, record=np.array(json.dumps(text, indent=1)), **members)  # type: ignore[arg-type]
    return target


def read(path: str | Path, kind: str, *, other_equations: bool = False) -> Record:
    """Read a record and check that it is whole and what is asked for.

    Parameters
    ----------
    path : str or Path
        The file.
    kind : str
        What it must hold.
    other_equations : bool
        Whether to accept results of other equations than those that are installed.

    Raises
    ------
    GroundloopError
        If the file cannot be read, is damaged or no record, holds something else, or comes from
        other equations.
    """
    try:
        with Path(path).open("rb") as file, np.load(file, allow_pickle=False) as archive:
            if archive.zip.testzip() is not None:  # reading an array doesn't look at checksums
                raise BadZipFile
            members = {name: archive[name] for name in archive.files}
        text = json.loads(str(members.pop("record")))
    except FileNotFoundError as problem:
        raise GroundloopError(f"cannot read {path}: {problem.strerror}") from problem
    except (OSError, ValueError, KeyError, AttributeError, BadZipFile, zlib.error) as problem:
        raise GroundloopError(f"{path} is no record of groundloop, or is damaged") from problem
    if text["layout"] != _LAYOUT or text["kind"] != kind:
        raise GroundloopError(
            f"{path} holds a {text['kind']} in layout {text['layout']}; this reads a {kind} in"
            f" layout {_LAYOUT}"
        )
    equations = text["provenance"]["equations"]
    if equations != DIGEST and not other_equations:
        raise GroundloopError(
            f"{path} was computed from other equations (digest {equations}, groundloop"
            f" {text['provenance']['groundloop']}) than those installed ({DIGEST}); compute it"
            " again, or accept it with other_equations=True"
        )
    aircraft = Aircraft(
        given=under("given/", members),
        sources={s: Source(**source) for s, source in text["sources"].items()},
        **text["aircraft"],
    )
    return Record(kind, under("arrays/", members), text["about"], aircraft, text["provenance"])


def save_run(run: Trajectory, path: str | Path) -> Path:
    """Write a run with its aircraft and provenance; `load_run` reads it.

    Parameters
    ----------
    run : Trajectory
        What to keep.
    path : str or Path
        Where to, ending in ``.npz``.
    """
    about = {
        "tire": run.tire,
        "values": list(run.values),
        "gust": run.gust
        and {
            "label": run.gust.label,
            "breaks": run.gust.breaks,
            "ended": bool((run.gust.end <= run.t[-1]).all()),
        },
    }
    arrays = {"t": run.t, "disturbance": run.disturbance, **run.values}
    return write(path, "trajectory", arrays, about, run.aircraft)


def load_run(path: str | Path, *, other_equations: bool = False) -> Trajectory:
    """Read a run that `Trajectory.save` wrote.

    A disturbance that varied over time comes back as its samples.

    Parameters
    ----------
    path : str or Path
        The file.
    other_equations : bool
        Whether to accept a run of other equations than those that are installed.

    Returns
    -------
    Trajectory

    Raises
    ------
    GroundloopError
        If the file is no such run, is damaged, or comes from other equations.
    """
    record = read(path, "trajectory", other_equations=other_equations)
    arrays, about = record.arrays, record.about
    values = {name: arrays[name] for name in about["values"]}
    t, disturbance, gust = arrays["t"], arrays["disturbance"], about["gust"]
    if any(series.shape[-1:] != t.shape for series in values.values()):
        raise GroundloopError(f"{path} is damaged: its series differ in length")
    if gust is not None:
        lines = sampled(t, disturbance)
        end = lines.end if gust["ended"] else np.asarray(np.inf)
        gust = replace(lines, label=f"{gust['label']} (its samples)", end=end)
    return Trajectory(t, values, record.aircraft, about["tire"], disturbance, gust)


def save_linearization(lin: Linearization, path: str | Path) -> Path:
    """Write a linearization with its aircraft and provenance; `load_linearization` reads it.

    Parameters
    ----------
    lin : Linearization
        What to keep.
    path : str or Path
        Where to, ending in ``.npz``.
    """
    values = {f.name: getattr(lin, f.name) for f in fields(lin)}
    arrays = {name: value for name, value in values.items() if isinstance(value, np.ndarray)}
    at = {f"at.{f.name}": np.asarray(getattr(lin.at, f.name)) for f in fields(lin.at)}
    about = {key: value for key, value in values.items() if isinstance(value, (str, tuple))}
    return write(path, "linearization", {**arrays, **at}, about, lin.aircraft)


def load_linearization(path: str | Path, *, other_equations: bool = False) -> Linearization:
    """Read a linearization that `save_linearization` wrote.

    Parameters
    ----------
    path : str or Path
        The file.
    other_equations : bool
        Whether to accept one of other equations than those that are installed.

    Raises
    ------
    GroundloopError
        If the file is no such thing, is damaged, or comes from other equations.
    """
    record = read(path, "linearization", other_equations=other_equations)
    values: dict[str, Any] = {
        name: tuple(value) if isinstance(value, list) else value
        for name, value in [*record.arrays.items(), *record.about.items()]
        if not name.startswith("at.")
    }
    arrays = under("at.", record.arrays)
    at = {name: array if array.ndim else float(array) for name, array in arrays.items()}
    return Linearization(**values, at=OperatingPoint(**at), aircraft=record.aircraft)


def under(prefix: str, members: Mapping[str, Any]) -> dict[str, Any]:
    """The members whose names begin with a prefix, without it."""
    return {
        name.removeprefix(prefix): value
        for name, value in members.items()
        if name.startswith(prefix)
    }
