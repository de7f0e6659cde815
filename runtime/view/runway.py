"""The ground roll seen from above: path, heading and aircraft on the runway, as picture or film."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import Rectangle
from matplotlib.patheffects import withStroke

from groundroll.base.arrays import positive, whole
from groundroll.base.errors import GroundrollError, one_of
from groundroll.base.files import complete
from groundroll.base.progress import Progress, counted
from groundroll.base.units import parts
from groundroll.generated import Quantity
from groundroll.model.models import as_model
from groundroll.model.shown import Units, UnitsLike, as_units
from groundroll.runs.simulation import Trajectory

from .plots import INK, MUTED, style
from .rolls import Roll, distance_of, in_words, rolls_of, strongest, wind_speed
from .silhouette import ASPHALT, PAINT, draw_aircraft, draw_pushes, draw_tire_tracks

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_GRASS = "#EDF2E4"
_LARGEST = (8.2, 6.4)  # inches, the axes of a new figure
_MARGIN = (0.8, 1.3)  # inches, for their labels
#: Inches: the axes are at least so high, and what rolls so long, where that is left open.
_HEIGHT, _LENGTH = 1.7, 0.4
#: Times between silhouettes, s, and how often it is drawn at most, where that is left open.
_EVERY, _MOST = (0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 60.0), 16
_STRETCHES = (1.0, 2.0, 5.0, 10.0, 20.0)
_CORNERS = ((0.94, 0.88), (0.94, 0.25), (0.06, 0.88), (0.06, 0.25))
#: Words that are nearer than this share of the picture would meet; what happens within so many
#: seconds is one event.
_APART, _SOON = 0.2, 0.5


@dataclass(frozen=True)
class _View:
    """How runs are laid out, lengths in the unit of the picture."""

    width: float
    every: float
    stretch: float
    enlarged: float
    along: tuple[float, float]
    across: tuple[float, float]
    unit: str
    arrows: dict[str, float]

    @property
    def strongest(self) -> float:
        """The force of the longest arrow, N."""
        return max(self.arrows.values(), default=0.0)


def runway_view(
    run: Trajectory | Sequence[Trajectory],
    *,
    width: float | str = 20.0,
    every: float | str | None = None,
    stretch: float | None = None,
    labels: Sequence[str] | None = None,
    units: UnitsLike = None,
    ax: Axes | None = None,
) -> Axes:
    """Draw ground rolls from above: the runway, the path of the CG, the aircraft at intervals.

    Forward (X) is to the right and the right-hand side (Y) below. Wheels and forces stand where
    the model has them; the rest of the silhouette is a typical light aircraft of that length, with
    a nose wheel if all wheels of the model are behind its CG, or a car if it has no fin. Dark lines
    are tracks of tires (to scale only), arrows the forces that push, a cross is where the CG leaves
    the runway, points are what else happened. Where a model holds its speed, believe the way into
    a ground loop, not what comes after the aircraft has turned.

    Parameters
    ----------
    run : Trajectory or sequence of Trajectory
        What to draw, of any model with a distance, an offset and a heading; each may hold several
        runs.
    width : float
        Width of the runway, m; its middle is Y = 0. A text has a unit of its own, which is that
        of the picture if `units` does not say otherwise.
    every : float, optional
        Time between silhouettes, s. If omitted, so that there are not too many.
    stretch : float, optional
        How many times larger a metre across is drawn than a metre along; 1 is to scale. The
        aircraft keep their shape and point along the stretched path. If omitted, 1 unless the
        roll is very long.
    labels : sequence of str, optional
        One for each run.
    units : str or mapping of str to str, optional
        See `groundroll.model.shown.as_units`.
    ax : Axes, optional
        Where; a new figure if omitted.

    Returns
    -------
    Axes

    Raises
    ------
    GroundrollError
        For a width, interval or stretch that is not positive, too few or too many labels, or a
        model that does not say where it is.
    """
    shown = _units(run, units, width)
    rolls = rolls_of(run, labels, shown)
    view = _view(rolls, distance_of(run), shown, width, every, stretch)
    with style():
        axes = _scene(view, ax)
        for k, roll in enumerate(rolls):
            axes.plot(roll.X, roll.Y, color=roll.colour, linewidth=1.1, zorder=3)
            if view.stretch == view.enlarged == 1:
                draw_tire_tracks(axes, roll)
            marked = _mark_exit(axes, roll, view.width)
            _mark_events(axes, roll, marked)
            for t in np.arange(0.0, roll.t[-1] * (1 + 1e-9), view.every).tolist():
                shade = 0.45 + 0.55 * t / (roll.t[-1] or 1.0)
                draw_aircraft(axes, roll, t, shade, 4 + k, view.enlarged)
                draw_pushes(axes, roll, t, view.strongest, 4 + k, view.enlarged)
        _clock(axes, max(rolls, key=lambda roll: roll.t[-1]), view.every)
        _wind(axes, rolls, shown, run)
        _legend(axes, rolls, labels is not None, view, shown)
    return axes


def animate(
    run: Trajectory | Sequence[Trajectory],
    path: str | Path,
    *,
    width: float | str = 20.0,
    stretch: float | None = None,
    labels: Sequence[str] | None = None,
    units: UnitsLike = None,
    fps: int = 20,
    slow_motion: float = 1.0,
    dpi: int = 90,
    progress: Progress = None,
) -> Path:
    """Write a film of ground rolls seen from above.

    Parameters
    ----------
    run, width, stretch, labels, units
        As for `runway_view`.
    path : str or Path
        Where to; the suffix says what: ``.gif``, or ``.mp4`` where ffmpeg is installed.
    fps : int
        Pictures per second.
    slow_motion : float
        How many times longer the film is than the roll.
    dpi : int
        Dots per inch; the picture is 9 inches wide.
    progress : callable or bool, optional
        Called with the numbers of pictures done and in all; True draws a bar on a terminal.

    Returns
    -------
    Path
        The file, which appears when it is complete.

    Raises
    ------
    GroundrollError
        For another suffix, a writer that is not there, or numbers that are not positive.
    """
    fps, dpi = whole("fps", fps, 1), whole("dpi", dpi, 1)
    slow_motion = positive("slow_motion", slow_motion)
    target = Path(path)
    writer = _writer(target, fps)
    shown = _units(run, units, width)
    rolls = rolls_of(run, labels, shown)
    view = _view(rolls, distance_of(run), shown, width, None, stretch)
    end = max(float(roll.t[-1]) for roll in rolls)
    times = np.linspace(0.0, end, max(2, round(end * slow_motion * fps) + 1)).tolist()

    from matplotlib.animation import FuncAnimation
    from matplotlib.figure import Figure

    with style():
        figure = Figure()
        axes = _scene(view, figure.add_subplot(), fit=True)
        _wind(axes, rolls, shown, run)
        _legend(axes, rolls, labels is not None, view, shown)
        mono: Any = {"family": "DejaVu Sans Mono", "ha": "right", "zorder": 9}
        clock = axes.annotate(" ", (0.99, 0.03), xycoords="axes fraction", **mono)
        figure.draw_without_rendering()
        figure.set_layout_engine("none")  # once is enough, and it takes most of the time
        passing: list[Any] = []

        def draw(frame: int) -> list[Any]:
            while passing:
                passing.pop().remove()
            clock.set_text(f"{times[frame]:4.1f} s")
            for roll in rolls:
                passing.extend(_moment(axes, roll, times[frame], view))
            return passing

        with complete(target) as draft, counted(progress, "pictures", len(times)) as done:
            film = FuncAnimation(figure, draw, frames=len(times), init_func=list)
            film.save(draft, writer=writer, dpi=dpi, progress_callback=lambda *_: done.add())
    return target


def _units(run: Trajectory | Sequence[Trajectory], units: UnitsLike, width: float | str) -> Units:
    """What was asked for; the unit in which the runway is given if nothing was."""
    distance, first = distance_of(run), run if isinstance(run, Trajectory) else run[0]
    unit = parts(width)[1] if isinstance(width, str) else ""
    if units is None and unit:
        positive("width", width, "m")
        return Units({distance.symbol: unit})
    return as_units(units, as_model(first.model).quantities, first.aircraft)


def _view(
    rolls: Sequence[Roll],
    distance: Quantity,
    units: Units,
    width: float | str,
    every: float | str | None,
    stretch: float | None,
) -> _View:
    wide = positive("width", width, "m") * units.factor(distance)
    end = max(float(roll.t[-1]) for roll in rolls)
    usual = next((each for each in _EVERY if end <= each * _MOST), _EVERY[-1])
    interval = usual if every is None else positive("every", every, "s")
    reach = max(roll.size for roll in rolls)
    X = np.concatenate([roll.X for roll in rolls])
    Y = np.concatenate([roll.Y for roll in rolls])
    side = 0.5 * wide + 0.35 * reach
    long = np.ptp(X) + 3.6 * reach
    high = max(Y.max() + 1.5 * reach, side) - min(Y.min() - 1.5 * reach, -side)
    inches = min(_LARGEST[0] / long, _LARGEST[1] / high)
    fitting = next((s for s in _STRETCHES if s * high * inches >= _HEIGHT), _STRETCHES[-1])
    stretched = fitting if stretch is None else positive("stretch", stretch)
    enlarged = max(1.0, float(math.ceil(_LENGTH / (1.6 * reach * inches))))
    reach *= enlarged
    return _View(
        width=wide,
        every=interval,
        stretch=stretched,
        enlarged=enlarged,
        along=(X.min() - 1.8 * reach, X.max() + 1.8 * reach),
        across=(
            min(Y.min() - 1.5 * reach / stretched, -side),
            max(Y.max() + 1.5 * reach / stretched, side),
        ),
        unit=units.of(distance),
        arrows=strongest(rolls),
    )


def _scene(view: _View, ax: Axes | None, fit: bool = False) -> Axes:
    """Axes with an empty runway, in a figure of fitting size if that is ours to choose."""
    along, across = view.along, view.across
    if ax is None:
        from matplotlib import pyplot

        ax, fit = pyplot.subplots()[1], True
    if fit:
        sides = along[1] - along[0], view.stretch * (across[1] - across[0])
        scale = min(most / side for most, side in zip(_LARGEST, sides, strict=True))
        across_page, down = (s * scale + more for s, more in zip(sides, _MARGIN, strict=True))
        ax.figure.set_size_inches(across_page, down)  # type: ignore[union-attr]
    ax.set(xlim=along, ylim=across[::-1], aspect=view.stretch, facecolor=_GRASS)
    ax.grid(False)
    larger = "" if view.enlarged == 1 else f"; what rolls is drawn × {view.enlarged:g}"
    ax.set_xlabel(f"distance $X$ along the runway ({view.unit}){larger}")
    stretched = "" if view.stretch == 1 else f", × {view.stretch:g}"
    ax.set_ylabel(f"offset $Y$ ({view.unit}{stretched})")
    half = view.width / 2
    ax.axhspan(-half, half, color=ASPHALT, linewidth=0, zorder=0)
    for edge in (-half, half):
        ax.axhline(edge, color=PAINT, linewidth=2.2, zorder=1)
    ax.axhline(0.0, color=PAINT, linewidth=1.6, dashes=(8, 6), zorder=1)
    return ax


def _moment(axes: Axes, roll: Roll, t: float, view: _View) -> list[Any]:
    """The path up to a time, and the aircraft at its end with what pushes it."""
    now = min(t, float(roll.t[-1]))
    before = roll.t < now
    X, Y, _ = roll.at(now)
    path = axes.plot([*roll.X[before], X], [*roll.Y[before], Y], color=roll.colour, zorder=3)
    aircraft = draw_aircraft(axes, roll, now, 1.0, 4, view.enlarged)
    return [*path, *aircraft, *draw_pushes(axes, roll, now, view.strongest, 4, view.enlarged)]


def _mark_exit(axes: Axes, roll: Roll, width: float) -> float:
    """Mark where the CG leaves the runway; when, s, or infinite if it does not."""
    outside = np.flatnonzero(np.abs(roll.Y) > width / 2)
    if outside.size == 0 or outside[0] == 0:
        return math.inf
    k = int(outside[0])
    before, after = abs(roll.Y[k - 1]), abs(roll.Y[k])
    share = (width / 2 - before) / (after - before)
    X, t = (float(s[k - 1] + share * (s[k] - s[k - 1])) for s in (roll.X, roll.t))
    Y = float(np.sign(roll.Y[k])) * width / 2
    axes.plot([X], [Y], "x", color=roll.colour, markersize=7, markeredgewidth=2, zorder=9)
    _say(axes, roll, f"off the runway after {t:.1f} s", (X, Y), (-14, -10 if Y > 0 else 10))
    return t


def _mark_events(axes: Axes, roll: Roll, exit_at: float) -> None:
    """Mark what happened, and when; words that would meet stand one above the other."""
    low, high = axes.get_xlim()
    before, level = -math.inf, 0
    for name, t in sorted(roll.events.items(), key=lambda event: event[1]):
        if name == "ran_off" and abs(t - exit_at) < _SOON:
            continue
        X, Y, _ = roll.at(t)
        axes.plot([X], [Y], "o", color=roll.colour, markersize=4, markeredgecolor="white", zorder=9)
        level = level + 1 if X - before < _APART * (high - low) else 0
        before = X
        side = 6 if low + _APART * (high - low) > X else -6
        _say(
            axes, roll, f"{name.replace('_', ' ')} after {t:.1f} s", (X, Y), (side, 16 + 11 * level)
        )


def _say(
    axes: Axes, roll: Roll, words: str, at: tuple[float, float], beside: tuple[float, float]
) -> None:
    axes.annotate(
        words,
        at,
        xytext=beside,
        textcoords="offset points",
        ha="right" if beside[0] < 0 else "left",
        va="center",
        color=roll.colour,
        fontsize=8,
        path_effects=[withStroke(linewidth=2.5, foreground=_GRASS)],
        zorder=9,
    )


def _wind(
    axes: Axes, rolls: Sequence[Roll], units: Units, run: Trajectory | Sequence[Trajectory]
) -> None:
    """An arrow in the corner for the strongest wind of the first run that has one."""
    windy = next((roll for roll in rolls if roll.wind.any()), None)
    first = run if isinstance(run, Trajectory) else run[0]
    q = wind_speed(as_model(first.model))
    if windy is None or q is None:
        return
    speed = np.hypot(*windy.wind.T)
    along, right = windy.wind[speed.argmax()] / speed.max()
    up_to = "up to " if np.ptp(speed) > 1e-6 * speed.max() else ""
    look: Any = {"color": MUTED, "zorder": 9}
    arrow: Any = {"pivot": "mid", "angles": "uv", "units": "inches", "scale_units": "inches"}
    place, corner = axes.transAxes, _free_corner(axes, rolls)
    axes.quiver(*corner, along, -right, scale=2.5, width=0.022, transform=place, **arrow, **look)
    axes.annotate(
        f"wind {up_to}{float(f'{speed.max():.3g}'):g} {units.of(q)}",
        corner,
        (0, -16),
        xycoords=place,
        textcoords="offset points",
        ha="center",
        va="top",
        fontsize=8,
        path_effects=[withStroke(linewidth=2.5, foreground=_GRASS)],
        **look,
    )


def _free_corner(axes: Axes, rolls: Sequence[Roll]) -> tuple[float, float]:
    """The corner of the axes, in shares of them, that is farthest from every path."""
    path = np.concatenate([np.stack([roll.X, roll.Y], axis=-1) for roll in rolls])
    there = axes.transAxes.inverted().transform(axes.transData.transform(path))
    return max(_CORNERS, key=lambda c: float(np.hypot(*(there - c).T).min()))


def _clock(axes: Axes, roll: Roll, every: float) -> None:
    """Times of the silhouettes along the upper edge, under the positions of the longest run."""
    step = every * max(1, round(1.0 / every))
    low, high = axes.get_xlim()
    taken: list[float] = []
    for t in np.arange(0.0, roll.t[-1] * (1 + 1e-9), step).tolist():
        X, *_ = roll.at(t)
        if any(abs(X - other) < 0.05 * (high - low) for other in taken):
            continue
        taken.append(X)
        axes.annotate(
            f"{t:g} s",
            (X, 1.0),
            xycoords=("data", "axes fraction"),
            xytext=(0, 3),
            textcoords="offset points",
            ha="center",
            color=MUTED,
            fontsize=8,
        )


def _legend(axes: Axes, rolls: Sequence[Roll], explicit: bool, view: _View, units: Units) -> None:
    """Names of the runs, and what the arrows are, above the runway."""
    handles: list[Any] = [Rectangle((0, 0), 1, 1, color=r.colour, label=r.label) for r in rolls]
    if view.arrows:
        most = (
            f"{name.replace('_', ' ')}, at most {in_words(force, units)}"
            for name, force in view.arrows.items()
        )
        handles.append(Line2D([], [], color=INK, marker=">", linewidth=0, label="; ".join(most)))
    above: Any = {"bbox_to_anchor": (0.0, 1.0), "borderaxespad": 2.2, "borderpad": 0.0}
    axes.legend(handles=handles, loc="lower left", ncols=3, handlelength=1.2, **above)


def _writer(path: Path, fps: int) -> Any:
    from matplotlib.animation import FFMpegWriter, PillowWriter

    writers: dict[str, Any] = {".gif": PillowWriter, ".mp4": FFMpegWriter}
    writer = writers[one_of("suffix", path.suffix.lower(), writers, f"{path}")]
    if not writer.isAvailable():
        raise GroundrollError(f"{path}: an .mp4 needs ffmpeg, which is not installed; .gif works")
    return writer(fps=fps)
