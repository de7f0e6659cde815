"""The ground roll seen from above: path, heading and aircraft on the runway, as picture or film."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import Rectangle
from matplotlib.patheffects import withStroke

from .arrays import positive, whole
from .errors import GroundrollError, one_of
from .files import complete
from .models import as_model
from .names import PARAMETERS
from .plots import COLOURS, INK, MUTED, plain, style
from .progress import Progress, counted
from .silhouette import ASPHALT, PAINT, Roll, draw_aircraft, draw_push, draw_tire_tracks
from .simulation import Trajectory

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_GRASS = "#EDF2E4"
_LARGEST = (8.2, 6.4)  # inches, the axes of a new figure
_MARGIN = (0.8, 1.1)  # inches, for their labels


def runway_view(
    run: Trajectory | Sequence[Trajectory],
    *,
    width: float | str = 20.0,
    every: float | str = 0.5,
    stretch: float = 1.0,
    labels: Sequence[str] | None = None,
    ax: Axes | None = None,
) -> Axes:
    """Draw ground rolls from above: the runway, the path of the CG, the aircraft at intervals.

    Forward (X) is to the right and the right-hand side (Y) below. Main wheels and tail stand
    where the aircraft has them; the rest of the silhouette is a typical light aircraft of that
    length, with a nose wheel where the main gear is behind the CG. Dark lines are tracks of tires
    (to scale only), arrows the side force on the tail, a cross is where the CG leaves the runway.
    The forward speed of the model is constant: believe the way into a ground loop, not what comes
    after the aircraft has turned.

    Parameters
    ----------
    run : Trajectory or sequence of Trajectory
        What to draw; each may hold several runs.
    width : float
        Width of the runway, m; its middle is Y = 0.
    every : float
        Time between silhouettes, s.
    stretch : float
        How many times larger a metre across is drawn than a metre along; 1 is to scale. The
        aircraft keep their shape and point along the stretched path.
    labels : sequence of str, optional
        One for each run.
    ax : Axes, optional
        Where; a new figure if omitted.

    Returns
    -------
    Axes

    Raises
    ------
    GroundrollError
        For a width, interval or stretch that is not positive, or too few or many labels.
    """
    width, every = positive("width", width, "m"), positive("every", every, "s")
    stretch = positive("stretch", stretch)
    rolls = _rolls(run, labels)
    with style():
        axes = _scene(rolls, width, stretch, ax)
        strongest = _strongest(rolls)
        for k, roll in enumerate(rolls):
            axes.plot(roll.X, roll.Y, color=roll.colour, linewidth=1.1, zorder=3)
            if stretch == 1:
                draw_tire_tracks(axes, roll)
            _mark_exit(axes, roll, width)
            for t in np.arange(0.0, roll.t[-1] * (1 + 1e-9), every).tolist():
                draw_aircraft(axes, roll, t, shade=0.45 + 0.55 * t / roll.t[-1], zorder=4 + k)
                draw_push(axes, roll, t, strongest, zorder=4 + k)
        _clock(axes, rolls[0], every)
        _legend(axes, rolls, labels is not None, strongest)
    return axes


def animate(
    run: Trajectory | Sequence[Trajectory],
    path: str | Path,
    *,
    width: float | str = 20.0,
    stretch: float = 1.0,
    labels: Sequence[str] | None = None,
    fps: int = 20,
    slow_motion: float = 1.0,
    dpi: int = 90,
    progress: Progress = None,
) -> Path:
    """Write a film of ground rolls seen from above.

    Parameters
    ----------
    run, width, stretch, labels
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
    width, stretch = positive("width", width, "m"), positive("stretch", stretch)
    fps, dpi = whole("fps", fps, 1), whole("dpi", dpi, 1)
    slow_motion = positive("slow_motion", slow_motion)
    target = Path(path)
    writer = _writer(target, fps)
    rolls = _rolls(run, labels)
    end = max(float(roll.t[-1]) for roll in rolls)
    times = np.linspace(0.0, end, max(2, round(end * slow_motion * fps) + 1)).tolist()

    from matplotlib.animation import FuncAnimation
    from matplotlib.figure import Figure

    with style():
        figure = Figure()
        axes = _scene(rolls, width, stretch, figure.add_subplot(), fit=True)
        strongest = _strongest(rolls)
        _legend(axes, rolls, labels is not None, strongest)
        clock = axes.set_title(" ", loc="right", family="DejaVu Sans Mono")
        figure.draw_without_rendering()
        figure.set_layout_engine("none")  # once is enough, and it takes most of the time
        passing: list[Any] = []

        def draw(frame: int) -> list[Any]:
            while passing:
                passing.pop().remove()
            clock.set_text(f"{times[frame]:4.1f} s")
            for roll in rolls:
                passing.extend(_moment(axes, roll, times[frame], strongest))
            return passing

        with complete(target) as draft, counted(progress, "pictures", len(times)) as done:
            film = FuncAnimation(figure, draw, frames=len(times), init_func=list)
            film.save(draft, writer=writer, dpi=dpi, progress_callback=lambda *_: done.add())
    return target


def _rolls(run: Trajectory | Sequence[Trajectory], labels: Sequence[str] | None) -> list[Roll]:
    runs = [run] if isinstance(run, Trajectory) else list(run)
    parts = [part for each in runs for part in _parts(each)]
    if not parts:
        raise GroundrollError("nothing to draw: no run was given")
    if labels is not None and len(labels) != len(parts):
        raise GroundrollError(f"there are {len(parts)} runs but {len(labels)} labels")
    for k, label in enumerate(labels or ()):
        parts[k] = replace(parts[k], label=label)
    return [replace(part, colour=COLOURS[k % len(COLOURS)]) for k, part in enumerate(parts)]


def _parts(run: Trajectory) -> Iterator[Roll]:
    """Each run in a trajectory by itself."""
    shape = run["X"].shape[:-1]
    paths = (run[s].reshape(-1, run.t.size) for s in ("X", "Y", "psi", "F_disturbance"))
    arms = (np.broadcast_to(run.aircraft[s], shape).ravel().tolist() for s in ("a", "b"))
    for k, (X, Y, psi, force, a, b) in enumerate(zip(*paths, *arms, strict=True)):
        label = (
            f"{plain(run.aircraft.name)}, {as_model(run.model).name} model{_varied(run, shape, k)}"
        )
        yield Roll(run.t, X, Y, psi, force, a, b, label, COLOURS[0])


def _varied(run: Trajectory, shape: tuple[int, ...], k: int) -> str:
    """What is particular to one of several runs: its parameters, or its number."""
    if not shape:
        return ""
    arrays = {s: value for s, value in run.aircraft.given.items() if value.ndim}
    own = [
        f"{s} = {np.broadcast_to(value, shape).flat[k]:.4g} {PARAMETERS[s].unit}"
        for s, value in arrays.items()
    ]
    return ", " + (", ".join(own) or f"run {', '.join(map(str, np.unravel_index(k, shape)))}")


def _strongest(rolls: Sequence[Roll]) -> float:
    return max(float(np.abs(roll.force).max()) for roll in rolls)


def _limits(rolls: Sequence[Roll], width: float) -> tuple[tuple[float, float], ...]:
    """Lowest and highest X and Y, with room for the aircraft and the edges of the runway."""
    reach = max(roll.b for roll in rolls)
    X = np.concatenate([roll.X for roll in rolls])
    Y = np.concatenate([roll.Y for roll in rolls])
    side = 0.5 * width + 0.35 * reach
    across = (min(Y.min() - 1.5 * reach, -side), max(Y.max() + 1.5 * reach, side))
    return (X.min() - 1.8 * reach, X.max() + 1.8 * reach), across


def _scene(
    rolls: Sequence[Roll], width: float, stretch: float, ax: Axes | None, fit: bool = False
) -> Axes:
    """Axes with an empty runway, in a figure of fitting size if that is ours to choose."""
    along, across = _limits(rolls, width)
    if ax is None:
        from matplotlib import pyplot

        ax, fit = pyplot.subplots()[1], True
    if fit:
        sides = along[1] - along[0], stretch * (across[1] - across[0])
        scale = min(most / side for most, side in zip(_LARGEST, sides, strict=True))
        across_page, down = (s * scale + more for s, more in zip(sides, _MARGIN, strict=True))
        ax.figure.set_size_inches(across_page, down)  # type: ignore[union-attr]
    ax.set(xlim=along, ylim=across[::-1], aspect=stretch, facecolor=_GRASS)
    ax.grid(False)
    ax.set_xlabel("distance $X$ along the runway (m)")
    stretched = "" if stretch == 1 else f", × {stretch:g}"
    ax.set_ylabel(f"offset $Y$ (m{stretched})")
    ax.axhspan(-width / 2, width / 2, color=ASPHALT, linewidth=0, zorder=0)
    for edge in (-width / 2, width / 2):
        ax.axhline(edge, color=PAINT, linewidth=2.2, zorder=1)
    ax.axhline(0.0, color=PAINT, linewidth=1.6, dashes=(8, 6), zorder=1)
    return ax


def _moment(axes: Axes, roll: Roll, t: float, strongest: float) -> list[Any]:
    """The path up to a time, and the aircraft at its end with what pushes it."""
    now = min(t, float(roll.t[-1]))
    before = roll.t < now
    X, Y, *_ = roll.at(now)
    path = axes.plot([*roll.X[before], X], [*roll.Y[before], Y], color=roll.colour, zorder=3)
    aircraft = draw_aircraft(axes, roll, now, shade=1.0, zorder=4)
    return [*path, *aircraft, *draw_push(axes, roll, now, strongest, zorder=4)]


def _mark_exit(axes: Axes, roll: Roll, width: float) -> None:
    outside = np.flatnonzero(np.abs(roll.Y) > width / 2)
    if outside.size == 0 or outside[0] == 0:
        return
    k = int(outside[0])
    before, after = abs(roll.Y[k - 1]), abs(roll.Y[k])
    share = (width / 2 - before) / (after - before)
    X, t = (float(s[k - 1] + share * (s[k] - s[k - 1])) for s in (roll.X, roll.t))
    Y = float(np.sign(roll.Y[k])) * width / 2
    axes.plot([X], [Y], "x", color=roll.colour, markersize=7, markeredgewidth=2, zorder=9)
    axes.annotate(
        f"off the runway after {t:.1f} s",
        (X, Y),
        xytext=(-14, -10 if Y > 0 else 10),
        textcoords="offset points",
        ha="right",
        va="center",
        color=roll.colour,
        fontsize=8,
        path_effects=[withStroke(linewidth=2.5, foreground=_GRASS)],
        zorder=9,
    )


def _clock(axes: Axes, roll: Roll, every: float) -> None:
    """Times of the silhouettes along the upper edge, under the positions of the first run."""
    step = every * max(1, round(1.0 / every))
    for t in np.arange(0.0, roll.t[-1] * (1 + 1e-9), step).tolist():
        X, *_ = roll.at(t)
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


def _legend(axes: Axes, rolls: Sequence[Roll], explicit: bool, strongest: float) -> None:
    """Names of the runs if there is a choice, and what the arrows are, above the runway."""
    named = rolls if explicit or len(rolls) > 1 else ()
    handles: list[Any] = [Rectangle((0, 0), 1, 1, color=r.colour, label=r.label) for r in named]
    if strongest > 0:
        words = f"side force on the tail, at most {float(f'{strongest:.3g}'):g} N"
        handles.append(Line2D([], [], color=INK, marker=">", linewidth=0, label=words))
    if handles:
        above = {"bbox_to_anchor": (0.0, 1.0), "borderaxespad": 2.2, "borderpad": 0.0}
        axes.legend(handles=handles, loc="lower left", ncols=3, handlelength=1.2, **above)


def _writer(path: Path, fps: int) -> Any:
    from matplotlib.animation import FFMpegWriter, PillowWriter

    writers: dict[str, Any] = {".gif": PillowWriter, ".mp4": FFMpegWriter}
    writer = writers[one_of("suffix", path.suffix.lower(), writers, f"{path}")]
    if not writer.isAvailable():
        raise GroundrollError(f"{path}: an .mp4 needs ffmpeg, which is not installed; .gif works")
    return writer(fps=fps)
