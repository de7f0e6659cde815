"""Ensembles and sweeps on disk; see `groundloop.records` for the layout."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from .ensemble_result import Ensemble, Named
from .records import read, under, write
from .sweeps import Sweep

_PLAIN = ("status", "steps", "estimate", "at")
_NAMED = {
    "final": "final states",
    "samples": "samples",
    "largest": "extremes",
    "first": "limits",
}
_ABOUT = ("tire", "t", "tol", "limits", "within")


def save_ensemble(ensemble: Ensemble, path: str | Path) -> Path:
    """Write an ensemble with its aircraft, initial states, inputs and provenance.

    Parameters
    ----------
    ensemble : Ensemble
        What to keep.
    path : str or Path
        Where to, ending in ``.npz``.
    """
    arrays = {name: getattr(ensemble, name) for name in _PLAIN}
    for group in ("start", "inputs", *_NAMED):
        arrays |= {f"{group}/{s}": value for s, value in getattr(ensemble, group).items()}
    about = {name: getattr(ensemble, name) for name in _ABOUT}
    return write(path, "ensemble", arrays, about, ensemble.aircraft)


def load_ensemble(path: str | Path, *, other_equations: bool = False) -> Ensemble:
    """Read an ensemble that `Ensemble.save` wrote.

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
    record = read(path, "ensemble", other_equations=other_equations)
    arrays = record.arrays
    named: dict[str, Any] = {s: Named(under(f"{s}/", arrays), what) for s, what in _NAMED.items()}
    return Ensemble(
        aircraft=record.aircraft,
        start=under("start/", arrays),
        inputs=under("inputs/", arrays),
        status=np.asarray(arrays["status"], np.int8),
        steps=np.asarray(arrays["steps"], np.int32),
        estimate=arrays["estimate"],
        at=arrays["at"],
        **named,
        **record.about,
    )


def save_sweep(sweep: Sweep, path: str | Path) -> Path:
    """Write a sweep with its aircraft and provenance to an npz file."""
    return write(path, "sweep", sweep.arrays, {}, sweep.aircraft)


def load_sweep(path: str | Path, *, other_equations: bool = False) -> Sweep:
    """Read a sweep that `Sweep.save` wrote; arguments and errors as for `load_ensemble`."""
    record = read(path, "sweep", other_equations=other_equations)
    return Sweep(record.aircraft, dict(record.arrays))
