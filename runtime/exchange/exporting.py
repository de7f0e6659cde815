"""An aircraft with a model, written out for other programs."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import Any

from groundroll.aircraft import Aircraft
from groundroll.errors import unknown
from groundroll.files import complete_folder
from groundroll.models import ModelLike

from .c_code import c_files
from .fmu import write_fmu
from .subject import Subject, subject


def export(
    plane: Aircraft, to: str, out: str | Path, model: ModelLike = "nonlinear", **values: Any
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
        for this machine, with its source; ``"fmu2"``: of version 2.0.
    out : str or Path
        Where to: a folder, which may exist, or a file.
    model : str or Model
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
    if to not in TARGETS:
        raise unknown("target", to, TARGETS, "export")
    path = Path(out)
    TARGETS[to](subject(plane, model, values, "export"), path)
    return path


def _c(case: Subject, path: Path) -> None:
    texts = c_files(case)
    with complete_folder(path) as folder:
        for name, text in texts.items():
            (folder / name).write_text(text, encoding="utf-8")


#: What can be exported to, and how it is written.
TARGETS: Mapping[str, Callable[[Subject, Path], None]] = {
    "c": _c,
    "fmu": partial(write_fmu, fmi="3.0"),
    "fmu2": partial(write_fmu, fmi="2.0"),
}
