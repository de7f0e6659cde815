"""Results as tables: for xarray, for pandas, and for a notebook."""

from __future__ import annotations

import importlib
from collections.abc import Iterable, Mapping
from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np

from .arrays import FloatArray
from .errors import GroundloopError
from .generated.names import QUANTITIES
from .records import provenance

if TYPE_CHECKING:
    from pandas import DataFrame
    from xarray import Dataset

    from .ensemble_result import Ensemble
    from .linearization import Linearization
    from .simulation import Trajectory
    from .sweeps import Sweep

#: What is read from the eigenvalues: attributes of a linearization, one number for each point.
_READ_OFF = ("decay_rate", "damping_ratio", "natural_frequency", "damped_frequency")
_STYLE = "text-align:right;padding:1px 8px"


def run_to_xarray(run: Trajectory) -> Dataset:
    """States, outputs and input of a run as an xarray.Dataset over time.

    Each variable carries its unit and meaning; parameters of the aircraft that vary are
    coordinates of the runs; name, tire and provenance are attributes.
    """
    shape = run["v"].shape[:-1]
    dims = _dimensions(shape)
    variables = {
        name: ((*dims, "t"), series, _attributes(name)) for name, series in run.values.items()
    }
    time = ("t", run.t, {"units": "s", "long_name": "time"})
    xarray = _needed("xarray", "to_xarray()")
    dataset: Dataset = xarray.Dataset(
        variables,
        coords={"t": time, **_varied(run.aircraft.given, shape, dims)},
        attrs={**_about(run), "disturbance": "constant" if run.gust is None else run.gust.label},
    )
    return dataset


def run_to_pandas(run: Trajectory) -> DataFrame:
    """States, outputs and input of a run as a pandas.DataFrame, one row for each time.

    With several runs their numbers go in front of the time in the index. Units are in ``attrs``.
    """
    pandas = _needed("pandas", "to_pandas()")
    shape = run["v"].shape[:-1]
    levels = [*(range(n) for n in shape), run.t]
    index = pandas.MultiIndex.from_product(levels, names=[*_dimensions(shape), "t"])
    data = {name: series.ravel() for name, series in run.values.items()}
    frame = pandas.DataFrame(data, index=index if shape else pandas.Index(run.t, name="t"))
    frame.attrs = {**_about(run), "units": {s: QUANTITIES[s].unit for s in run.values}}
    return frame


def linearization_to_xarray(lin: Linearization) -> Dataset:
    """The matrices, eigenvalues and what is read from them as an xarray.Dataset.

    Rows and columns of A, B, C and D are labelled with states, inputs and outputs.
    """
    shape = lin.decay_rate.shape
    dims = _dimensions(shape)
    matrices = {
        "A": ("state_rate", "state"),
        "B": ("state_rate", "input"),
        "C": ("output", "state"),
        "D": ("output", "input"),
        "drift": ("state_rate",),
        "eigenvalues": ("mode",),
    }
    variables = {name: ((*dims, *axes), getattr(lin, name)) for name, axes in matrices.items()}
    numbers = {name: (dims, getattr(lin, name), _attributes(name)) for name in _READ_OFF}
    labels = {
        "state": list(lin.states),
        "state_rate": list(lin.states),
        "input": list(lin.inputs),
        "output": list(lin.outputs),
    }
    coords = {**labels, **_varied(lin.aircraft.given, shape, dims)}
    xarray = _needed("xarray", "to_xarray()")
    dataset: Dataset = xarray.Dataset({**variables, **numbers}, coords=coords, attrs=_about(lin))
    return dataset


def linearization_to_pandas(lin: Linearization) -> DataFrame:
    """Eigenvalues and what is read from them as a pandas.DataFrame, one row for each point.

    Parameters of the aircraft that vary are columns in front.
    """
    pandas = _needed("pandas", "to_pandas()")
    shape = lin.decay_rate.shape
    dims = _dimensions(shape)
    varied = {
        name: np.broadcast_to(value, shape).ravel()
        for name, value in lin.aircraft.given.items()
        if value.ndim
    }
    values = {name: np.ravel(getattr(lin, name)) for name in _READ_OFF}
    roots = lin.eigenvalues.reshape(-1, lin.eigenvalues.shape[-1]).T
    modes = {f"eigenvalue_{k}": root for k, root in enumerate(roots, start=1)}
    index = pandas.MultiIndex.from_product([range(n) for n in shape], names=dims) if shape else None
    frame = pandas.DataFrame({**varied, **modes, **values}, index=index)
    frame.attrs = _about(lin)
    return frame


def ensemble_to_xarray(ensemble: Ensemble) -> Dataset:
    """Status, final states, samples and extremes of an ensemble as an xarray.Dataset.

    Extremes are called ``largest_alpha`` and ``first_alpha``; with samples over ``t`` the final
    states are called ``final_v``. Parameters and initial states that vary are coordinates.
    """
    xarray = _needed("xarray", "to_xarray()")
    shape = ensemble.status.shape
    dims = _dimensions(shape)
    time = ("t", ensemble.at, {"units": "s", "long_name": "time"})
    samples = {s: ((*dims, "t"), v, _attributes(s)) for s, v in ensemble.samples.items()}
    dataset: Dataset = xarray.Dataset(
        {**{name: (dims, v) for name, v in _of_each(ensemble).items()}, **samples},
        coords={
            **({"t": time} if ensemble.at.size else {}),
            **_varied(ensemble.aircraft.given, shape, dims),
        },
        attrs={**_about(ensemble), "statuses": ", ".join(ensemble.STATUS)},
    )
    return dataset


def ensemble_to_pandas(ensemble: Ensemble) -> DataFrame:
    """Status, final states and extremes as a pandas.DataFrame, one row for each trajectory."""
    pandas = _needed("pandas", "to_pandas()")
    frame: DataFrame = pandas.DataFrame({s: v.ravel() for s, v in _of_each(ensemble).items()})
    frame.attrs = _about(ensemble)
    return frame


def sweep_to_xarray(sweep: Sweep) -> Dataset:
    """The results of a sweep as an xarray.Dataset; parameters that vary are coordinates."""
    xarray = _needed("xarray", "to_xarray()")
    shape = next(iter(sweep.arrays.values())).shape
    dims = _dimensions(shape)
    dataset: Dataset = xarray.Dataset(
        {name: (dims, values) for name, values in sweep.arrays.items()},
        coords=_varied(sweep.aircraft.given, shape, dims),
        attrs={"aircraft": sweep.aircraft.name, **provenance()},
    )
    return dataset


def _of_each(ensemble: Ensemble) -> dict[str, Any]:
    """What there is one of for each trajectory, with what varies of its start, by name."""
    final = "final_" if ensemble.at.size else ""
    varied = {f"{s}0": np.asarray(v) for s, v in ensemble.start.items() if np.ndim(v)}
    return {
        "status": ensemble.status,
        **{s: np.broadcast_to(v, ensemble.status.shape) for s, v in varied.items()},
        **{f"{final}{s}": v for s, v in ensemble.final.items()},
        **{f"largest_{s}": v for s, v in ensemble.largest.items()},
        **{f"first_{s}": v for s, v in ensemble.first.items()},
    }


def run_to_html(run: Trajectory) -> str:
    """A run as a small table with a picture of each series, for a notebook."""
    rows = [
        (
            f"{QUANTITIES[name].name.replace('_', ' ')} ({name})",
            _sparkline(series.reshape(-1, run.t.size)),
            f"{np.abs(series).max():.4g}",
            f"{float(series[..., -1]):.4g}" if series.ndim == 1 else "",
            QUANTITIES[name].unit,
        )
        for name, series in run.values.items()
    ]
    title = repr(run).splitlines()[0]
    return _html(title, ("", "over time", "largest", "at the end", "unit"), rows)


def linearization_to_html(lin: Linearization) -> str:
    """A linearization as a small table, for a notebook."""
    title = repr(lin).splitlines()[0]
    if lin.decay_rate.ndim:
        return f"<div>{escape(repr(lin)).replace(chr(10), '<br>')}</div>"
    numbers = [
        (f"eigenvalue {k}", f"{complex(root):.5g}", "1/s")
        for k, root in enumerate(lin.eigenvalues, start=1)
    ]
    numbers += [
        (name.replace("_", " "), f"{float(getattr(lin, name)):.5g}", QUANTITIES[name].unit)
        for name in _READ_OFF
    ]
    return _html(title, ("", "value", "unit"), numbers)


def _dimensions(shape: tuple[int, ...]) -> tuple[str, ...]:
    return ("run",) if len(shape) == 1 else tuple(f"run_{k}" for k in range(len(shape)))


def _attributes(name: str) -> dict[str, str]:
    q = QUANTITIES[name]
    return {"units": q.unit, "long_name": q.name.replace("_", " "), "description": q.meaning}


def _about(result: Trajectory | Linearization | Ensemble) -> dict[str, str]:
    return {"aircraft": result.aircraft.name, "tire": result.tire, **provenance()}


def _varied(
    given: Mapping[str, FloatArray], shape: tuple[int, ...], dims: tuple[str, ...]
) -> dict[str, tuple[tuple[str, ...], FloatArray, dict[str, str]]]:
    """Parameters that are arrays, each along the dimensions in which it varies."""
    coordinates = {}
    for name, value in given.items():
        own = dims[len(shape) - value.ndim :] if value.ndim else ()
        along = tuple(d for d, n in zip(own, value.shape, strict=True) if n > 1)
        if along:
            coordinates[name] = (along, np.squeeze(value), _attributes(name))
    return coordinates


def _needed(package: str, caller: str) -> Any:
    try:
        return importlib.import_module(package)
    except ImportError:
        raise GroundloopError(
            f"{caller} needs the package {package}: pip install 'groundloop[{package}]'"
        ) from None


def _sparkline(lines: FloatArray, width: int = 120, height: int = 22) -> str:
    """Series as one small picture, at most 60 points each and the first 8 of them."""
    few = lines[:8, np.unique(np.linspace(0, lines.shape[1] - 1, 60).astype(int))]
    low, high = float(few.min()), float(few.max())
    x = np.linspace(1, width - 1, few.shape[1])
    y = height - 2 - (height - 4) * (few - low) / ((high - low) or 1.0)
    paths = (" ".join(f"{a:.1f},{b:.1f}" for a, b in zip(x, row, strict=True)) for row in y)
    drawn = "".join(f'<polyline points="{p}" fill="none" stroke="#0072B2"/>' for p in paths)
    return f'<svg width="{width}" height="{height}">{drawn}</svg>'


def _html(title: str, heads: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    """A table; texts that are pictures stay as they are."""
    first = "".join(f'<th style="{_STYLE}">{escape(head)}</th>' for head in heads)
    body = "".join(
        "<tr>"
        + "".join(
            f'<td style="{_STYLE}">{cell if cell.startswith("<svg") else escape(cell)}</td>'
            for cell in row
        )
        + "</tr>"
        for row in rows
    )
    return f"<div>{escape(title)}<table><tr>{first}</tr>{body}</table></div>"
