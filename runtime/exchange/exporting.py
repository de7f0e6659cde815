"""An aircraft with a model, written out for other programs."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

from groundroll.aircraft.aircraft import Aircraft
from groundroll.base.errors import unknown
from groundroll.base.files import complete_folder
from groundroll.model.models import ModelLike

from .c_code import c_files
from .fmu import write_fmu
from .jsbsim import MODEL, write_jsbsim
from .subject import Subject, subject


def export(
    plane: Aircraft, to: str, out: str | Path, model: ModelLike | None = None, **values: Any
) -> Path:
    """Write a model with the numbers of an aircraft for programs without Python.

    Parameters
    ----------
    plane : Aircraft
        One aircraft: none of its parameters may be an array.
    to : str
        ``"c"``: a folder of plain C that needs nothing but the mathematical library: the
        equations, an integrator, the parameters, an example and a Makefile. ``"fmu"``: a component
        of the Functional Mock-up Interface 3.0 for model exchange and for co-simulation, compiled
        for this machine, with its source; ``"fmu2"``: of version 2.0. ``"jsbsim"``: the aircraft
        on its legs as a file of the flight dynamics code JSBSim, which says at its top what it
        does not carry.
    out : str or Path
        Where to: a folder, which may exist, or a file.
    model : str or Model, optional
        ``"nonlinear"``, or for JSBSim ``"landing_roll"``, if omitted.
    **values : float or str
        By symbol or full name, as for `groundroll.simulate`: inputs, parameters that differ from
        the aircraft's, and initial states (``v0``), which are zero if omitted.

    Returns
    -------
    Path
        What was written.

    Raises
    ------
    GroundrollError
        For an unknown target, name or value, a parameter that is missing, or a place that cannot
        be written to. Nothing is left half-written.
    """
    return written(plane, to, out, model, values).path


class Written(NamedTuple):
    """A file or folder, and what of the model it does not carry, each in words."""

    path: Path
    lost: tuple[str, ...]


def written(
    plane: Aircraft, to: str, out: str | Path, model: ModelLike | None, values: Mapping[str, Any]
) -> Written:
    """See `export`."""
    if to not in TARGETS:
        raise unknown("target", to, TARGETS, "export")
    target, path = TARGETS[to], Path(out)
    case = subject(plane, target.model if model is None else model, values, "export")
    return Written(path, target.write(case, path) or ())


def _c(case: Subject, path: Path) -> None:
    texts = c_files(case)
    with complete_folder(path) as folder:
        for name, text in texts.items():
            (folder / name).write_text(text, encoding="utf-8")


class Target(NamedTuple):
    """How a target is written, giving what it does not carry, and its model if none is named."""

    write: Callable[[Subject, Path], tuple[str, ...] | None]
    model: str = "nonlinear"


#: What can be exported to.
TARGETS: Mapping[str, Target] = {
    "c": Target(_c),
    "fmu": Target(partial(write_fmu, fmi="3.0")),
    "fmu2": Target(partial(write_fmu, fmi="2.0")),
    "jsbsim": Target(write_jsbsim, MODEL),
}
