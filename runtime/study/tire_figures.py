"""Figures of the tires and the tail wheel."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from groundroll.aircraft.aircraft import Aircraft
from groundroll.base.units import from_si, to_si
from groundroll.model.evaluate import elementwise
from groundroll.model.names import QUANTITIES
from groundroll.model.shown import Units
from groundroll.view.plots import COLOURS, DASHES, INK

from .cases import case, tire_fit
from .figure_legends import place_legend
from .sources import FigureSpec, figure_words, setup, tables

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from groundroll.base.arrays import FloatArray


def _parameter_sets(names: Sequence[str]) -> dict[str, Mapping[str, Any]]:
    """Tire parameters by what the legend calls them."""
    printed = {
        row["symbol"]: to_si(f"{row['value']} {row['unit']}", QUANTITIES[row["symbol"]].unit, "")
        for row in _in_plain_units(tables()["3.2"].rows)
    }
    program = Aircraft.load(setup().aircraft)
    every: dict[str, Mapping[str, Any]] = {
        "table": printed,
        "fit": tire_fit().parameters,
        "program": {symbol: program[symbol] for symbol in printed},
    }
    return {figure_words("sets")[name]: every[name] for name in names}


def _in_plain_units(rows: Sequence[Mapping[str, str]]) -> list[dict[str, str]]:
    return [{**row, "unit": "" if row["unit"] == "1" else row["unit"]} for row in rows]


def _tire(parameters: Mapping[str, Any], alpha: Any, Fz: Any) -> dict[str, FloatArray]:
    values = {name: np.asarray(value, dtype=np.float64) for name, value in parameters.items()}
    return elementwise("tire_force", {"alpha": np.asarray(alpha), "Fz": np.asarray(Fz), **values})


def tire_data(figure: Figure, spec: FigureSpec) -> None:
    axis = figure.add_subplot()
    data = tire_fit().table
    angles = np.degrees(data.slip_angles)
    for k, load in enumerate(data.loads):
        axis.plot(angles, data.forces[:, k], _MARKERS[k], color=COLOURS[k], ls="-", lw=0.8)
        _label_end(axis, angles[-1], data.forces[-1, k], f"{load:.0f} N")
    _force_axes(axis, angles[-1])


_MARKERS = ("o", "s", "^", "D", "v")


def _label_end(axis: Axes, x: float, y: float, text: str) -> None:
    axis.annotate(
        text, (x, y), xytext=(6, 0), textcoords="offset points", va="center", fontsize=8, color=INK
    )


def _force_axes(axis: Axes, last: float) -> None:
    axis.set_xlim(0, last * 1.12)
    axis.set_ylim(0, None)
    axis.set_xticks(np.arange(0, last + 1, 5))
    axis.set_xlabel("slip angle $\\alpha$ (deg)")
    axis.set_ylabel("lateral force of one tire $F_y$ (N)")


def coefficient(figure: Figure, spec: FigureSpec) -> None:
    axis = figure.add_subplot()
    name, unit = spec.options["coefficient"], spec.options["unit"]
    fit = tire_fit()
    measured = dict(zip(("C_c", "mu"), fit.table.coefficients, strict=True))[name]
    scale = from_si(1.0, QUANTITIES[name].unit, unit) if unit != "1" else 1.0
    loads = np.linspace(1500.0, 5600.0, 50)
    for k, (label, parameters) in enumerate(_parameter_sets(spec.options["sets"]).items()):
        line = _tire(parameters, np.zeros_like(loads), loads)[name]
        axis.plot(loads, scale * line, color=COLOURS[k], linestyle=DASHES[k], label=label)
    axis.plot(fit.table.loads, scale * measured, "o", color=INK, label="from Table 3.1")
    axis.set_ylim(0, None)
    axis.set_xlim(loads[0], loads[-1])
    axis.set_xlabel("vertical load $F_z$ (N)")
    q = QUANTITIES[name]
    axis.set_ylabel(
        f"{q.name.replace('_', ' ')} ${q.latex}$" + (f" ({unit})" if unit != "1" else "")
    )
    place_legend(axis, [line for line in axis.get_lines() if line.get_label()])


def normalised(figure: Figure, spec: FigureSpec) -> None:
    axis = figure.add_subplot()
    table = tire_fit().table
    alpha_bar, F_bar = table.normalised
    for k, load in enumerate(table.loads):
        axis.plot(
            alpha_bar[:, k],
            F_bar[:, k],
            _MARKERS[k],
            color=COLOURS[k],
            fillstyle="none",
            label=f"{load:.0f} N",
        )
    alpha_bar = np.linspace(0.0, spec.options["largest"], 200)
    for k, (label, parameters) in enumerate(_parameter_sets(spec.options["sets"]).items()):
        values = {name: np.asarray(value) for name, value in parameters.items()}
        curve = elementwise("magic_formula", {"alpha_bar": alpha_bar, **values})["F_bar"]
        axis.plot(alpha_bar, curve, color=INK, linestyle=DASHES[k], linewidth=1.2, label=label)
    axis.set_xlim(0, alpha_bar[-1])
    axis.set_ylim(0, None)
    axis.set_xlabel(Units().label(QUANTITIES["alpha_bar"]))
    axis.set_ylabel(Units().label(QUANTITIES["F_bar"]))
    axis.legend(loc="lower right", ncols=2)


def reconstruction(figure: Figure, spec: FigureSpec) -> None:
    axis = figure.add_subplot()
    data = tire_fit().table
    alpha = np.radians(np.linspace(0.0, 20.0, 101))
    sets = _parameter_sets(spec.options["sets"])
    for k, load in enumerate(data.loads):
        for j, parameters in enumerate(sets.values()):
            force = _tire(parameters, alpha, np.full_like(alpha, load))["F_y"]
            axis.plot(np.degrees(alpha), force, color=COLOURS[k], ls=DASHES[j], lw=1.2)
        axis.plot(
            np.degrees(data.slip_angles),
            data.forces[:, k],
            _MARKERS[k],
            color=COLOURS[k],
            fillstyle="none",
            markersize=4,
        )
        _label_end(axis, 20.0, data.forces[-1, k], f"{load:.0f} N")
    _force_axes(axis, 20.0)
    handles = [Line2D([], [], color=INK, ls=DASHES[j], lw=1.2, label=s) for j, s in enumerate(sets)]
    handles.append(
        Line2D([], [], color=INK, ls="", marker="o", fillstyle="none", label="Table 3.1")
    )
    place_legend(axis, handles)


def tail_wheel(figure: Figure, spec: FigureSpec) -> None:
    axis = figure.add_subplot()
    plane = Aircraft.load(setup().aircraft)
    static = float(plane.replace(f=None)["F_tail_load"])
    loads = np.linspace(0.0, 2.2 * static, 100)
    curve = plane.replace(Ct=None, F_tail_load=loads)["Ct"]
    per_degree = from_si(1.0, QUANTITIES["Ct"].unit, "N/deg")
    axis.plot(loads, per_degree * curve, color=COLOURS[0])
    axis.plot(0, 0, "o", color=INK, clip_on=False)
    for factor, number in zip(spec.options["factors"], spec.options["trials"], strict=True):
        stiffness = float(case(number, "linear").plane["Ct"]) * per_degree
        axis.plot(factor * static, stiffness, "o", color=INK)
        load = factor * static
        axis.annotate(
            f"{stiffness:.0f} N/deg at {load:.1f} N\n{factor:g} × static, Trial {number}",
            (load, stiffness),
            xytext=(8, -6),
            textcoords="offset points",
            va="top",
            fontsize=8,
        )
    axis.set_xlim(0, 3.1 * static)
    axis.set_ylim(0, 165)
    axis.set_xlabel("tail wheel load $F_{z\\,\\mathrm{tail}}$ (N)")
    axis.set_ylabel("cornering stiffness (N/deg)")
