"""Pictures of responses: Bode diagram, step response, pole map and root locus."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import cycle
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.patheffects import withStroke

from groundroll.base.arrays import FloatArray
from groundroll.base.errors import GroundrollError, of_kind
from groundroll.base.wording import number
from groundroll.linear.linearization import Linearization
from groundroll.model.models import as_model
from groundroll.model.names import PARAMETERS
from groundroll.model.shown import UnitsLike, as_units

from .plots import COLOURS, DASHES, INK, MUTED, style, titled, whose

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from groundroll.linear.response import FrequencyResponse, RootLocus, StepResponse
    from groundroll.stability.modes import ComplexArray

_DAMPING = (0.1, 0.2, 0.3, 0.5, 0.7, 0.9)
_HALO: Any = [withStroke(linewidth=2.0, foreground="white")]
#: Dark to light enough to be seen, monotonous in grey.
_COURSE = mpl.colors.LinearSegmentedColormap.from_list(
    "course", mpl.colormaps["viridis"](np.linspace(0.0, 0.85, 64))
)


def _new(ax: Axes | None, size: tuple[float, float]) -> Axes:
    if ax is not None:
        return ax
    from matplotlib import pyplot

    return pyplot.subplots(figsize=size)[1]


def _look(k: int) -> dict[str, Any]:
    look = {"color": COLOURS[k % len(COLOURS)], "linestyle": DASHES[k % len(DASHES)]}
    return {**look, "label": f"point {k}"}


def _tell_apart(ax: Axes, count: int) -> None:
    """A legend if there are several points, but not very many."""
    if 1 < count <= len(COLOURS):
        ax.legend()


def bode(
    response: FrequencyResponse, ax: Sequence[Axes] | None, decibels: bool, units: UnitsLike
) -> tuple[Axes, Axes]:
    """Magnitude above phase over frequency."""
    known = as_model(response.model).quantities
    q, by = known[response.output], known[response.input]
    shown = as_units(units, known, response.aircraft)
    unit, per = shown.of(q), shown.of(by)
    with style():
        if ax is None:
            from matplotlib import pyplot

            _, ax = pyplot.subplots(2, 1, sharex=True, figsize=(6, 5))
        if (count := np.asarray(ax, dtype=object).size) != 2:
            raise GroundrollError(f"a Bode diagram needs two axes, not {count}")
        above, below = ax
        magnitude = shown.values(q, response.magnitude) / shown.factor(by)
        phase = np.degrees(response.phase)
        lines = zip(_rows(magnitude), _rows(phase), strict=True)
        for k, (size, angle) in enumerate(lines):
            height = 20 * np.log10(size) if decibels else size
            above.plot(response.frequency, height, **_look(k))
            below.plot(response.frequency, angle, **_look(k))
        _tell_apart(above, len(above.lines))
        above.set_xscale("log")
        below.set_xscale("log")
        ratio = unit if per == "1" else f"{unit}/{per}"
        if decibels:
            above.set_ylabel(f"magnitude (dB of 1 {ratio})")
        else:
            above.set_yscale("log")
            above.set_ylabel(f"magnitude ({ratio})".replace("^2", "²"))
        channel = f"{_words(q.name)} ${q.latex}$ to {_words(by.name)} ${by.latex}$"
        titled(above, f"{whose(response)}: {channel}")
        below.set_ylabel("phase (deg)")
        below.yaxis.set_major_locator(mpl.ticker.MultipleLocator(45))
        below.set_xlabel("frequency (rad/s)")
    return above, below


def step(response: StepResponse, ax: Axes | None, units: UnitsLike) -> Axes:
    """An output over time after a step."""
    known = as_model(response.model).quantities
    q, by = known[response.output], known[response.input]
    shown = as_units(units, known, response.aircraft)
    with style():
        ax = _new(ax, (6, 3.2))
        for k, line in enumerate(_rows(shown.values(q, response.values))):
            ax.plot(response.t, line, **_look(k))
        _tell_apart(ax, len(ax.lines))
        ax.axhline(0.0, color=MUTED, linewidth=0.8)
        ax.set_xlim(0.0, response.t[-1])
        ax.set_xlabel("time after the step (s)")
        ax.set_ylabel(shown.label(q))
        size = f"{number(shown.factor(by) * response.size)} {shown.of(by)}".removesuffix(" 1")
        change = f"step of {size} in {_words(by.name)} ${by.latex}$"
        titled(ax, f"{whose(response)}: {change}")
    return ax


def pole_map(lin: Linearization, ax: Axes | None = None) -> Axes:
    """Draw the eigenvalues in the complex plane, with lines of constant damping.

    Parameters
    ----------
    lin : Linearization
        One point or several.
    ax : Axes, optional
        Where; a new figure if omitted.

    Returns
    -------
    Axes
        What was drawn on.
    """
    of_kind("lin", lin, Linearization)
    poles = lin.eigenvalues.reshape(-1, lin.eigenvalues.shape[-1])
    with style():
        ax = _new(ax, (5.2, 4.4))
        titled(ax, whose(lin))
        for k, pair in enumerate(poles):
            look = {**_look(k), "linestyle": "none"}
            ax.plot(pair.real, pair.imag, marker="x+1v^2"[k % 6], markersize=8, **look)
        _tell_apart(ax, len(poles))
        _plane(ax, poles)
    return ax


def locus(root_locus: RootLocus, ax: Axes | None, unit: str | None) -> Axes:
    """Eigenvalues in the complex plane, coloured by the parameter."""
    q = PARAMETERS[root_locus.parameter]
    units = as_units(unit and {q.symbol: unit}, PARAMETERS)
    shown = units.values(q, root_locus.values)
    with style():
        ax = _new(ax, (6.2, 4.4))
        for mode, marker in zip(root_locus.eigenvalues.T, cycle("os^v"), strict=False):
            ax.plot(mode.real, mode.imag, color=MUTED, linewidth=0.8, zorder=2)
            points = ax.scatter(mode.real, mode.imag, c=shown, cmap=_COURSE, s=9, zorder=3)
            _arrow(ax, mode)
            ends: dict[str, Any] = {
                "marker": marker,
                "linestyle": "none",
                "markeredgecolor": INK,
                "zorder": 4,
            }
            ax.plot(mode.real[0], mode.imag[0], markerfacecolor="white", markersize=6.5, **ends)
        bar = ax.figure.colorbar(points, ax=ax, pad=0.02, fraction=0.06, aspect=28)
        bar.set_label(units.label(q))
        titled(ax, whose(root_locus))
        bar.outline.set_linewidth(0.6)
        _plane(ax, root_locus.eigenvalues)
    return ax


def _arrow(ax: Axes, mode: ComplexArray) -> None:
    """The direction of a mode in the middle of its way."""
    way = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(mode)))])
    if way[-1] == 0:
        return
    k = int(np.clip(np.searchsorted(way, 0.6 * way[-1]), 1, len(mode) - 1))
    tail, head = mode[k - 1], mode[k]
    arrow = {"arrowstyle": "-|>", "color": INK, "linewidth": 0.0, "mutation_scale": 14}
    ax.annotate("", (head.real, head.imag), (tail.real, tail.imag), arrowprops=arrow, zorder=4)


def _plane(ax: Axes, poles: ComplexArray) -> None:
    """Axes of the complex plane around some poles: damping, natural frequency, the stable half."""
    left, right = min(poles.real.min(), 0.0), max(poles.real.max(), 0.0)
    top = float(np.abs(poles.imag).max())
    reach = max(right - left, 2 * top, 1e-9)
    low, high = left - 0.12 * reach, right + 0.12 * reach
    top = max(1.18 * top, 0.25 * reach)
    ax.set_xlim(low, high)
    ax.set_ylim(-top, top)
    ax.grid(visible=False)
    if high > 0:
        ax.axvspan(0.0, high, facecolor="#F4E3DA", zorder=0)
        middle = ax.text(high / 2, -0.95 * top, "unstable", color=MUTED, fontsize=8)
        middle.set(rotation=90, ha="center", va="bottom")
    ax.axhline(0.0, color=MUTED, linewidth=0.8, zorder=1)
    ax.axvline(0.0, color=INK, linewidth=1.2, zorder=1)
    _damping_lines(ax, low, top)
    _frequency_circles(ax, low, top)
    ax.set_xlabel("real part (1/s)")
    ax.set_ylabel("imaginary part (rad/s)")


def _damping_lines(ax: Axes, low: float, top: float) -> None:
    """Rays of constant damping ratio, labelled where they leave the picture."""
    for ratio in _DAMPING:
        slope = math.sqrt(1 - ratio**2) / ratio
        x = max(low, -top / slope)
        for side in (1, -1):
            ax.plot([0.0, x], [0.0, -side * slope * x], color=MUTED, linewidth=0.5, zorder=1)
        at_side = x == low
        ax.annotate(
            f"{ratio:g}",
            (x, -slope * x),
            (3, 0) if at_side else (0, -3),
            textcoords="offset points",
            ha="left" if at_side else "center",
            va="center" if at_side else "top",
            fontsize=7,
            color=MUTED,
            path_effects=_HALO,
            zorder=1,
        )
    ax.text(
        *(1.0, -0.16, r"rays: damping ratio $\zeta$; arcs: natural frequency $\omega_n$ (rad/s)"),
        transform=ax.transAxes,
        ha="right",
        va="top",
        fontsize=8,
        color=MUTED,
    )


def _frequency_circles(ax: Axes, low: float, top: float) -> None:
    reach = math.hypot(low, top)
    angle = np.linspace(math.pi / 2, 3 * math.pi / 2, 181)
    for radius in mpl.ticker.MaxNLocator(5).tick_values(0.0, reach)[1:]:
        if radius > reach:
            continue
        x, y = radius * np.cos(angle), radius * np.sin(angle)
        ax.plot(x, y, color=MUTED, linewidth=0.5, linestyle=DASHES[3], zorder=1)
        if radius < -low:
            ax.annotate(
                *(f"{radius:g}", (-radius, 0.0), (2, -2)),
                textcoords="offset points",
                va="top",
                fontsize=7,
                color=MUTED,
                path_effects=_HALO,
                zorder=1,
            )


def _rows(values: FloatArray) -> FloatArray:
    return values.reshape(-1, values.shape[-1])


def _words(name: str) -> str:
    return name.replace("_", " ")
