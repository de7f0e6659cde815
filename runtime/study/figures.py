"""The figures of the thesis that show data, drawn from the same runs as the tables."""

from __future__ import annotations

import io
import re
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any
from xml.sax.saxutils import escape

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from groundloop.aircraft import Aircraft
from groundloop.evaluate import elementwise
from groundloop.generated.names import QUANTITIES
from groundloop.linearization import linearize
from groundloop.plots import COLOURS, DASHES, INK, MUTED, axis_label, in_shown_unit, style
from groundloop.units import from_si, to_si

from .cases import Case, case, tire_fit
from .sources import FigureSpec, figure_words, setup, tables, trials

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from groundloop.arrays import FloatArray

_SIZE, _WIDE = (5.2, 3.3), (10.6, 3.6)  # inch
_INCH = 0.0254  # m
_ONE_ROW = 60  # letters of a legend, a line sample counted as six

#: How a model is drawn where both are: the non-linear as a band, the linear as dashes upon it.
_OVERLAY: Mapping[str, Mapping[str, Any]] = {
    "nonlinear": {"linestyle": "-", "linewidth": 3.4, "alpha": 0.45, "solid_capstyle": "butt"},
    "linear": {"linestyle": (0, (4, 2)), "linewidth": 1.3},
}


def draw(spec: FigureSpec) -> Figure:
    """Draw a figure of the thesis."""
    with style():
        figure = Figure(figsize=_WIDE if spec.wide else _SIZE)
        _KINDS[spec.kind](figure, spec)
        figure.suptitle(
            f"Figure {spec.number}   {spec.title}", x=0.01, ha="left", fontsize=9, color=MUTED
        )
    return figure


def svg(spec: FigureSpec) -> str:
    """Draw a figure as SVG: the same bytes each time, no two figures with an id in common."""
    return as_svg(draw(spec), spec.number, f"Figure {spec.number}: {spec.caption}")


def as_svg(figure: Figure, number: str, name: str) -> str:
    """A figure as an SVG element with a name; its ids begin with its number."""
    target = io.StringIO()
    with style(), _salted(number):
        figure.savefig(target, format="svg", metadata=_NO_METADATA)
    return _tidied(target.getvalue(), number, name)


_NO_METADATA: dict[str, Any] = dict.fromkeys(("Creator", "Date", "Format", "Type"))


def _salted(number: str) -> Any:
    import matplotlib as mpl

    settings: Any = {"svg.hashsalt": f"groundloop {number}"}
    return mpl.rc_context(settings)


def _tidied(text: str, number: str, name: str) -> str:
    """Only the svg element: ids with the figure's number, coordinates to hundredths, a title."""
    body = text[text.index("<svg") :]
    prefix = f"f{number.replace('.', '-')}-"
    body = re.sub(r'(\bid="|href="#|url\(#)', rf"\g<1>{prefix}", body)
    body = re.sub(r"\s*<metadata>.*?</metadata>", "", body, flags=re.DOTALL)
    body = re.sub(r"<!--.*?-->\s*", "", body, flags=re.DOTALL)
    body = re.sub(r'\b(d|x|y)="([^"]*)"', _rounded, body)
    head, rest = body.split(">", 1)
    rest = re.sub(r"\s*<defs>\s*<style.*?</style>\s*</defs>", "", rest, count=1, flags=re.DOTALL)
    return f'{head} role="img" style="{_JOINS}">\n <title>{escape(name)}</title>{rest.rstrip()}\n'


#: On the svg element instead of in a style sheet, which would reach beyond it in a page.
_JOINS = "stroke-linejoin: round; stroke-linecap: butt"


def _rounded(match: re.Match[str]) -> str:
    def short(number: re.Match[str]) -> str:
        return f"{float(number[0]):.2f}".rstrip("0").rstrip(".")

    shortened = re.sub(r"-?\d+\.\d+", short, match[2])
    return f'{match[1]}="{" ".join(shortened.split())}"'


# --- responses ---


def _response(figure: Figure, spec: FigureSpec) -> None:
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
    radians = options.get("radians", False)
    label = axis_label(options["quantity"])
    axis.set_ylabel(label.replace("(deg)", "(rad)") if radians else label)
    _legend(axis, chosen)


def _series(subject: Case, options: Mapping[str, Any]) -> tuple[FloatArray, FloatArray]:
    name = options["quantity"]
    values = subject.run[name]
    shown = values if options.get("radians") else in_shown_unit(name, values)
    return subject.run.t, shown


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
            at = np.interp(level, *_sorted_pair(y[k - 1 : k + 1], x[k - 1 : k + 1]))
            axis.plot(at, level, marker, color=line.get_color(), clip_on=False, zorder=5)


def _sorted_pair(levels: FloatArray, places: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Levels in increasing order, with their places."""
    order = np.argsort(levels)
    return levels[order], places[order]


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
            handles.append(Line2D([], [], label=_trial_label(number, numbers), **shown))
    if len(models) > 1:
        for model in models:
            own = next(subject for subject in chosen if subject.model == model)
            colour = MUTED if len(numbers) > 1 else _look(own, chosen)["color"]
            label = figure_words("models")[model]
            handles.append(Line2D([], [], label=label, **{**_OVERLAY[model], "color": colour}))
    _place_legend(axis, handles)


def _place_legend(axis: Axes, handles: Sequence[Line2D]) -> None:
    """Above the axes, where no line can run through it."""
    letters = sum(6 + len(str(handle.get_label())) for handle in handles)
    axis.legend(
        handles=list(handles),
        loc="lower left",
        bbox_to_anchor=(0.0, 1.0),
        ncols=len(handles) if letters < _ONE_ROW else 2,
        borderaxespad=0.3,
    )


def _trial_label(number: int, among: Sequence[int]) -> str:
    """The trial and what tells it from the others."""
    words = []
    for key, pattern in figure_words("labels").items():
        values = [trials()[other].changes.get(key) for other in among]
        if len(set(values)) > 1:
            words.append(pattern.format(_short(str(trials()[number].changes[key]))))
    return ", ".join([f"Trial {number}", *words])


def _short(quantity: str) -> str:
    number, _, unit = quantity.partition(" ")
    return f"{float(number):.4g} {unit}"


# --- the tire ---


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


def _tire_data(figure: Figure, spec: FigureSpec) -> None:
    axis = figure.add_subplot()
    data = tire_fit().data
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


def _coefficient(figure: Figure, spec: FigureSpec) -> None:
    axis = figure.add_subplot()
    name, unit = spec.options["coefficient"], spec.options["unit"]
    fit = tire_fit()
    measured = {"C_c": fit.cornering_coefficients, "mu": fit.friction_coefficients}[name]
    scale = from_si(1.0, QUANTITIES[name].unit, unit) if unit != "1" else 1.0
    loads = np.linspace(1500.0, 5600.0, 50)
    for k, (label, parameters) in enumerate(_parameter_sets(spec.options["sets"]).items()):
        line = _tire(parameters, np.zeros_like(loads), loads)[name]
        axis.plot(loads, scale * line, color=COLOURS[k], linestyle=DASHES[k], label=label)
    axis.plot(fit.data.loads, scale * measured, "o", color=INK, label="from Table 3.1")
    axis.set_ylim(0, None)
    axis.set_xlim(loads[0], loads[-1])
    axis.set_xlabel("vertical load $F_z$ (N)")
    q = QUANTITIES[name]
    axis.set_ylabel(
        f"{q.name.replace('_', ' ')} ${q.latex}$" + (f" ({unit})" if unit != "1" else "")
    )
    _place_legend(axis, [line for line in axis.get_lines() if line.get_label()])


def _normalised(figure: Figure, spec: FigureSpec) -> None:
    axis = figure.add_subplot()
    fit = tire_fit()
    for k, load in enumerate(fit.data.loads):
        axis.plot(
            fit.alpha_bar[:, k],
            fit.F_bar[:, k],
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
    axis.set_xlabel(axis_label("alpha_bar"))
    axis.set_ylabel(axis_label("F_bar"))
    axis.legend(loc="lower right", ncols=2)


def _reconstruction(figure: Figure, spec: FigureSpec) -> None:
    axis = figure.add_subplot()
    data = tire_fit().data
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
    _place_legend(axis, handles)


def _tail_wheel(figure: Figure, spec: FigureSpec) -> None:
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


# --- modes over a parameter ---


def _modes(figure: Figure, spec: FigureSpec) -> None:
    axis = figure.add_subplot()
    options = spec.options
    over, quantity = options["over"], options["quantity"]
    unit = options.get("unit", QUANTITIES[over].unit)
    first, last = map(float, options["range"])
    values = np.linspace(first, last, 241)
    scale = 1.0 if unit == QUANTITIES[over].unit else from_si(1.0, QUANTITIES[over].unit, unit)
    handles = []
    for k, number in enumerate(options["trials"]):
        plane = case(number, "linear").plane.replace(**{over: values / scale})
        look: dict[str, Any] = {"color": COLOURS[k], "linestyle": DASHES[k]}
        axis.plot(values, getattr(linearize(plane, "linear"), quantity), **look)
        handles.append(Line2D([], [], label=_series_label(number, options["trials"], over), **look))
    if options.get("crossing"):
        _mark_crossing(axis, QUANTITIES[over].latex, unit)
    for number in options["marks"]:
        subject = case(number, "linear")
        place = scale * float(subject.plane[over])
        axis.plot(place, getattr(subject.linearization, quantity), "o", color=INK, ms=3.5, zorder=4)
    axis.set_xlim(*_padded(options["range"]))
    axis.set_ylim(*options.get("limits", (0, None)))
    axis.set_xlabel(f"{_MODE_LABELS[over]} ({unit})")
    axis.set_ylabel(_MODE_LABELS[quantity])
    _place_legend(axis, handles)


def _mark_crossing(axis: Axes, latex: str, unit: str) -> None:
    """Where the first two lines cross."""
    first, second = (np.asarray(line.get_xydata()) for line in axis.get_lines()[:2])
    gap = first[:, 1] - second[:, 1]
    k = int(np.flatnonzero(np.diff(np.sign(gap)))[0])
    place = float(np.interp(0.0, *_sorted_pair(gap[k : k + 2], first[k : k + 2, 0])))
    level = float(np.interp(place, first[:, 0], first[:, 1]))
    axis.annotate(
        f"equal at ${latex}$ = {place:.3f} {unit}".replace("-", "−"),
        (place, level),
        xytext=(-40, -48),
        textcoords="offset points",
        ha="right",
        fontsize=8,
        arrowprops={"arrowstyle": "-", "color": MUTED, "lw": 0.8},
    )


_MODE_LABELS = {
    "a": "main gear ahead of the CG $a$",
    "Ct": "tail wheel cornering stiffness",
    "damped_frequency": "damped frequency (rad/s)",
    "damping_ratio": "damping ratio $\\zeta$",
}


def _padded(limits: Sequence[float]) -> tuple[float, float]:
    room = 0.02 * (limits[1] - limits[0])
    return limits[0] - room, limits[1] + room


def _series_label(number: int, among: Sequence[int], over: str) -> str:
    words = _trial_label(number, among).split(", ")[1:]
    shown = [word for word in words if not word.startswith("tail wheel")] if over == "Ct" else words
    return ", ".join(shown)


# --- on the runway ---


def _runway(figure: Figure, spec: FigureSpec) -> None:
    left, right = figure.subplots(1, 2)
    options = spec.options
    numbers = list(options["ground"])
    for number in numbers:
        subject = case(number, "nonlinear")
        k = numbers.index(number)
        look: dict[str, Any] = {"color": COLOURS[k], "linestyle": DASHES[k % len(DASHES)]}
        rolled = float(subject.plane["u"]) * subject.run.t
        label = f"Trial {number}"
        if number in options["trials"]:
            left.plot(rolled, 1000 * subject.run["y"], **look)
        right.plot(subject.run["X"], subject.run["Y"], label=label, **look)
    limit = 1000 * options["inches"] * _INCH
    left.axhline(limit, color=MUTED, linewidth=0.8)
    left.annotate("2 inches", (0, limit), xytext=(4, 2), textcoords="offset points", fontsize=8)
    left.set_ylim(0, 1.12 * limit)
    left.set_ylabel("lateral displacement $y$ (mm)")
    left.set_xlabel("distance rolled $u t$ (m)")
    left.set_title("aircraft coordinates, as printed")
    right.axhline(0, color=MUTED, linewidth=0.8)
    right.set_ylabel("offset from the runway axis $Y$ (m)")
    right.set_xlabel("along the runway $X$ (m)")
    right.set_title("over the ground; right is up")
    for axis in (left, right):
        axis.set_xlim(0, rolled[-1])
    right.legend(loc="center left", bbox_to_anchor=(1.01, 0.5))


_KINDS: Mapping[str, Callable[[Figure, FigureSpec], None]] = {
    "response": _response,
    "tire-data": _tire_data,
    "coefficient": _coefficient,
    "normalised": _normalised,
    "reconstruction": _reconstruction,
    "tail-wheel": _tail_wheel,
    "modes": _modes,
    "runway": _runway,
}
