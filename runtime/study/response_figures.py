"""Figures of motion over time."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from groundroll.model.shown import Units
from groundroll.view.plots import COLOURS, DASHES, MUTED

from .cases import Case, case
from .figure_legends import place_legend, sorted_pair, trial_label
from .sources import FigureSpec, figure_words, setup

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from groundroll.base.arrays import FloatArray
from groundroll.generated import Quantity
from groundroll.model.models import as_model

#: How a model is drawn where both are: the non-linear as a band, the linear as dashes upon it.
_OVERLAY: Mapping[str, Mapping[str, Any]] = {
    "nonlinear": {"linestyle": "-", "linewidth": 3.4, "alpha": 0.45, "solid_capstyle": "butt"},
    "linear": {"linestyle": (0, (4, 2)), "linewidth": 1.3},
}


def response(figure: Figure, spec: FigureSpec) -> None:
    axis = figure.add_subplot()
    options = spec.options
    chosen = [case(number, model) for number in options["trials"] for model in options["models"]]
    for subject in chosen:
        times, values = _series(subject, options)
        line = axis.plot(times, values, **_look(subject, chosen))[0]
        _mark_exit(axis, line, options.get("limits"))
    axis.set_xlim(0, options.get("duration", setup().duration))
    if "limits" in options:
        axis.set_ylim(*options["limits"])
    axis.set_xlabel("time (s)")
    axis.set_ylabel(_units(options).label(_quantity(chosen[0], options)))
    _legend(axis, chosen)


def _series(subject: Case, options: Mapping[str, Any]) -> tuple[FloatArray, FloatArray]:
    name = options["quantity"]
    values = subject.run[name]
    return subject.run.t, _units(options).values(_quantity(subject, options), values)


def _units(options: Mapping[str, Any]) -> Units:
    return Units(system="plain" if options.get("radians") else "si")


def _quantity(subject: Case, options: Mapping[str, Any]) -> Quantity:
    model = as_model(subject.run.model)
    rows = (*model.states, *model.outputs)
    return model.quantities[model.symbol(options["quantity"], "quantity", rows, "figures.toml")]


def _look(subject: Case, among: Sequence[Case]) -> dict[str, Any]:
    """Colour by trial; by model, or in figures of one model by trial, how the line is drawn."""
    numbers = list(dict.fromkeys(other.trial.number for other in among))
    models = {other.model for other in among}
    index = numbers.index(subject.trial.number)
    if len(numbers) == 1 and len(models) > 1:
        index = sorted(models).index(subject.model)
    drawn = _OVERLAY[subject.model] if len(models) > 1 else {"linestyle": DASHES[index]}
    return {"color": COLOURS[index], **drawn}


def _mark_exit(axis: Axes, line: Line2D, limits: Sequence[float] | None) -> None:
    """An arrowhead where a line leaves the frame."""
    if limits is None:
        return
    x, y = (np.asarray(data, dtype=np.float64) for data in line.get_data())
    for level, marker, outside in (
        (limits[0], "v", y < limits[0]),
        (limits[1], "^", y > limits[1]),
    ):
        if outside.any():
            k = int(np.flatnonzero(outside)[0])
            at = np.interp(level, *sorted_pair(y[k - 1 : k + 1], x[k - 1 : k + 1]))
            axis.plot(at, level, marker, color=line.get_color(), clip_on=False, zorder=5)


def _legend(axis: Axes, chosen: Sequence[Case]) -> None:
    """Names of trials and models above the axes."""
    numbers = list(dict.fromkeys(subject.trial.number for subject in chosen))
    models = list(dict.fromkeys(subject.model for subject in chosen))
    handles = []
    if len(numbers) > 1 or len(models) == 1:
        first = {subject.trial.number: subject for subject in reversed(chosen)}
        for number in numbers:
            look = _look(first[number], chosen)
            plain = {"color": look["color"], "linestyle": look["linestyle"]}
            shown = plain if len(models) == 1 else {"color": look["color"], "linestyle": "-"}
            handles.append(Line2D([], [], label=trial_label(number, numbers), **shown))
    if len(models) > 1:
        for model in models:
            own = next(subject for subject in chosen if subject.model == model)
            colour = MUTED if len(numbers) > 1 else _look(own, chosen)["color"]
            label = figure_words("models")[model]
            handles.append(Line2D([], [], label=label, **{**_OVERLAY[model], "color": colour}))
    place_legend(axis, handles)
