"""Options that commands share: the same words, each defined once."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import wraps
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click
from click.shell_completion import CompletionItem

from .output import FORMATS, KEPT, KEPT_IN

if TYPE_CHECKING:
    from groundroll.aircraft.aircraft import Aircraft
    from groundroll.model.models import Model, ModelLike

    ParamType = click.ParamType[Any]
else:
    ParamType = click.ParamType  # generic for type checkers only, before click 8.5

F = TypeVar("F", bound=Callable[..., Any])

#: What --set gives: names and values as written, None for a parameter that is to follow.
Changes = tuple[tuple[str, str | None], ...]

#: What options that name quantities of a model give: names and values as written.
Values = tuple[tuple[str, str], ...]

#: More digits has no number of points that anybody can wait for.
_DIGITS = 20

#: Points along an axis of a map if the range names no number.
_POINTS = 201


@dataclass(frozen=True)
class Grid:
    """A parameter or initial state and its values along an axis.

    Attributes
    ----------
    symbol : str
        The parameter.
    values : tuple of str and array
        Symbol and values in the SI unit, as `groundroll.stability_map` takes them.
    unit : str
        Unit that the range was given in; empty for the SI unit.
    points : int, optional
        Number of values, if the range names one.
    """

    symbol: str
    values: tuple[str, Any]
    unit: str
    points: int | None = None

    def spread(self, points: int) -> Any:
        """As many values as the range names, or else `points`."""
        import numpy as np

        values = self.values[1]
        return np.linspace(values[0], values[-1], self.points or points)


class Quantity(ParamType):
    """A number with a unit, e.g. ``100 km/h``; a bare one is in the SI unit."""

    def __init__(self, unit: str) -> None:
        self.name = "quantity"
        self.unit = unit

    def convert(self, value: Any, param: Any, ctx: Any) -> float:
        from groundroll.base.units import UnitError, to_si

        if not isinstance(value, str):
            return float(value)
        try:
            return to_si(value, self.unit, "value")
        except UnitError as problem:
            self.fail(f"found {problem.found}; expected {problem.expected}", param, ctx)


class Range(ParamType):
    """``name=low:high`` or ``name=low:high:points``, with units; names are those of parameters."""

    name = "name=low:high[:points]"

    def convert(self, value: Any, param: Any, ctx: Any) -> Grid:
        from groundroll.base.errors import GroundrollError
        from groundroll.model.names import QUANTITIES, parameter_symbols, symbol

        if isinstance(value, Grid):
            return value
        name, _, text = (part.strip() for part in str(value).partition("="))
        if not (name and _split(text)):
            self.fail(f"found {value!r}; expected name=low:high, such as a=-1 m:1 m", param, ctx)
        try:
            key = symbol(name, "parameter", parameter_symbols())
            return _grid(key, name, text, QUANTITIES[key].unit)
        except (GroundrollError, ValueError) as problem:
            self.fail(str(problem), param, ctx)

    def shell_complete(self, ctx: Any, param: Any, incomplete: str) -> list[CompletionItem]:
        return Assignment().shell_complete(ctx, param, incomplete)


def range_of(model: Model, text: str, option: str, where: str) -> Grid:
    """``name=low:high[:points]`` of a parameter, an input or an initial state of a model.

    Raises
    ------
    BadParameter
        If there is no such name, or the range is none.
    """
    from groundroll.aircraft.values import kind_of
    from groundroll.base.errors import GroundrollError
    from groundroll.model.names import PARAMETERS

    name, _, ends = (part.strip() for part in text.partition("="))
    if not (name and _split(ends)):
        wrong = f"found {text!r}; expected name=low:high, such as a=-1 m:1 m"
        raise click.BadParameter(wrong, param_hint=option)
    try:
        kind, symbol = kind_of(model, name, where)
        q = model.quantities[symbol] if symbol in model.quantities else PARAMETERS[symbol]
        key = {"input": q.name, "parameter": symbol, "state": f"{symbol}0"}[kind]
        return _grid(key, name, ends, q.unit)
    except (GroundrollError, ValueError) as problem:
        raise click.BadParameter(str(problem), param_hint=option) from problem


class QuantityOrRange(Quantity):
    """A number with a unit, or ``low:high`` or ``low:high:points`` of them."""

    def __init__(self, key: str, unit: str) -> None:
        super().__init__(unit)
        self.name = "quantity|range"
        self.key = key

    def convert(self, value: Any, param: Any, ctx: Any) -> Any:
        from groundroll.base.errors import GroundrollError

        if isinstance(value, Grid) or ":" not in str(value):
            return value if isinstance(value, Grid) else super().convert(value, param, ctx)
        if not _split(value):
            self.fail(f"found {value!r}; expected low:high, such as 1:2", param, ctx)
        try:
            return _grid(self.key, self.key, value, self.unit)
        except (GroundrollError, ValueError) as problem:
            self.fail(str(problem), param, ctx)


def _split(text: str) -> tuple[str, str, str] | None:
    """Low, high and number of points of a range as written; None if an end is missing."""
    low, _, rest = text.partition(":")
    high, _, points = (part.strip() for part in rest.partition(":"))
    return (low.strip(), high, points) if low.strip() and high else None


def _grid(key: str, name: str, text: str, unit: str) -> Grid:
    """A range as written, in the SI unit."""
    import numpy as np

    from groundroll.base.errors import shown
    from groundroll.base.memory import check_memory
    from groundroll.base.units import parts, to_si

    low, high, points = _split(text) or ("", "", "")
    ends = [to_si(end, unit, name) for end in (low, high)]
    if points and not (points.isdecimal() and len(points) < _DIGITS):
        raise ValueError(f"found {shown(points)} points; expected a whole number")
    count = int(points) if points else None
    check_memory(8 * (count or 0), f"{name} of so many points")
    if not (ends[0] < ends[1] and (count is None or count >= 2)):
        raise ValueError(f"found {name}={text!r}; expected low < high and 2 or more points")
    return Grid(key, (key, np.linspace(ends[0], ends[1], count or _POINTS)), parts(low)[1], count)


class AircraftName(ParamType):
    """A packaged aircraft by name, or an aircraft file."""

    name = "aircraft"

    def shell_complete(self, ctx: Any, param: Any, incomplete: str) -> list[CompletionItem]:
        from groundroll.aircraft.aircraft import packaged

        names = [CompletionItem(n) for n in packaged() if n.startswith(incomplete)]
        return [*names, CompletionItem(incomplete, type="file")]


class ModelName(ParamType):
    """A model that ships, or that an installed package announces, or the folder of a pack."""

    name = "model"

    def convert(self, value: Any, param: Any, ctx: Any) -> str:
        from groundroll.base.errors import GroundrollError
        from groundroll.model.models import as_model

        try:
            return as_model(value).key
        except GroundrollError as problem:
            self.fail(str(problem), param, ctx)

    def shell_complete(self, ctx: Any, param: Any, incomplete: str) -> list[CompletionItem]:
        from groundroll.generated import PACKS

        names = [n for n, pack in PACKS.items() if pack.states and n.startswith(incomplete)]
        return [*map(CompletionItem, names), CompletionItem(incomplete, type="dir")]


class Assignment(ParamType):
    """``name=value``, the value with a unit; an empty value lets the parameter follow."""

    name = "name=value"

    def convert(self, value: Any, param: Any, ctx: Any) -> tuple[str, str | None]:
        name, equals, text = str(value).partition("=")
        if not equals:
            self.fail(f"found {value!r}; expected name=value, such as mass='1650 lb'", param, ctx)
        return name.strip(), text.strip() or None

    def shell_complete(self, ctx: Any, param: Any, incomplete: str) -> list[CompletionItem]:
        from groundroll.model.names import QUANTITIES, parameter_symbols

        names = [QUANTITIES[s].name for s in parameter_symbols()]
        return [CompletionItem(f"{n}=") for n in names if n.startswith(incomplete)]


class Named(Assignment):
    """``name=value`` of a model: handed on as written, because the model knows its units."""

    def convert(self, value: Any, param: Any, ctx: Any) -> tuple[str, str]:
        name, text = super().convert(value, param, ctx)
        if not (name and text):
            self.fail(f"found {value!r}; expected name=value, such as r='2 deg/s'", param, ctx)
        return name, text

    def shell_complete(self, ctx: Any, param: Any, incomplete: str) -> list[CompletionItem]:
        return []


def named(name: str, text: str, own: str) -> Callable[[F], F]:
    """An option that gives quantities of the model by symbol or full name, and may repeat."""
    words = f"{text} By symbol or full name, with its unit; may be repeated."
    return click.option(f"--{name}", own, type=Named(), multiple=True, help=words)


inputs = named("input", "An input of the model, e.g. --input steering='3 deg'.", "inputs")


def by_name(*given: Any) -> dict[str, Any]:
    """Values by name from options that name them; what is given twice is refused.

    Parameters
    ----------
    *given : mapping, or sequence of pairs of str and anything
        A value that is None was not given.
    """
    found: dict[str, Any] = {}
    for group in given:
        for name, value in group.items() if isinstance(group, Mapping) else group:
            if value is None:
                continue
            if name in found:
                raise click.UsageError(f"{name} is given twice")
            found[name] = value
    return found


def example(line: str) -> str:
    """The epilog of a command: something to copy, which click does not wrap."""
    return f"\b\nExample:\n  {line}"


def aircraft(command: F) -> F:
    """AIRCRAFT and --set; the command gets `plane`, an `Aircraft`."""
    command = click.option(
        "--set",
        "changes",
        type=Assignment(),
        multiple=True,
        help="Change a parameter, e.g. --set cg_station='16 in'; may be repeated. Without a"
        " value (--set Ct=) the parameter follows from others.",
    )(command)
    return click.argument("plane", type=AircraftName(), metavar="AIRCRAFT")(command)


def tell(plane: Aircraft, values: Mapping[str, Any] | None = None) -> None:
    """Say on stderr what is asked of the tires, in results, beyond what they were measured at."""
    from groundroll.aircraft.validity import extrapolated_in

    from .output import say

    for text in extrapolated_in(plane, values or {}):
        say(f"beyond the data: {text}")


def loaded(name: str, changes: Changes, model: ModelLike | None = None) -> Aircraft:
    """The aircraft that AIRCRAFT and --set describe; a model may have parameters of its own."""
    from groundroll.aircraft.aircraft import Aircraft
    from groundroll.base.errors import GroundrollError

    plane = Aircraft.load(name)
    own = {} if model is None else _own_parameters(model)
    for parameter, value in changes:
        try:
            if parameter in own and value is not None:
                plane = plane.with_own({**plane.own, own[parameter]: value})
            else:
                plane = plane.replace(**{parameter: value})
        except GroundrollError as problem:
            raise click.BadParameter(str(problem), param_hint="--set") from problem
    return plane


def _own_parameters(model: ModelLike) -> dict[str, str]:
    """Symbols of the parameters that only this model has, by symbol and by full name."""
    from groundroll.model.models import as_model
    from groundroll.model.names import PARAMETERS

    known = as_model(model)
    own = [s for s in known.parameters if s not in PARAMETERS]
    return {name: s for s in own for name in (s, known.quantities[s].name)}


def speed_at(plane: Aircraft, model: ModelLike, values: Mapping[str, Any]) -> float:
    """The forward speed of a result: where it is free, what it is at the start."""
    from groundroll.model.models import as_model

    name = as_model(model).roles.get("speed", "u")
    value = values[name] if name in values else plane[name]
    return float(getattr(value, "flat", [value])[0])


def with_values(name: str, changes: Changes) -> tuple[Aircraft, dict[str, str]]:
    """The aircraft that AIRCRAFT describes, and what --set gives: by name, for the model to sort.

    What is to follow from others is the aircraft's own affair.
    """
    values = {parameter: value for parameter, value in changes if value is not None}
    return loaded(name, tuple(change for change in changes if change[1] is None)), values


def model(default: str | None = "nonlinear", told: str | bool = True) -> Callable[[F], F]:
    """--model; `told` is what help says of a default that depends."""
    return click.option(
        "--model",
        type=ModelName(),
        default=default,
        show_default=told,
        help="The model: one that ships, or a folder made by `groundroll derive`.",
    )


def quantity(name: str, unit: str, text: str, **settings: Any) -> Callable[[F], F]:
    """An option with a unit; the command gets it under its own name, upper case or lower."""
    words = f"{text} A bare number is in {unit}."
    own = name.replace("-", "_")
    return click.option(f"--{name}", own, type=Quantity(unit), help=words, **settings)


def varied(name: str, key: str, unit: str, text: str, **settings: Any) -> Callable[[F], F]:
    """An option with a unit that may be a range, of the parameter or initial state `key`."""
    words = f"{text} A bare number is in {unit}; low:high[:points] is a range."
    return click.option(f"--{name}", name, type=QuantityOrRange(key, unit), help=words, **settings)


def speed(command: F) -> F:
    """--speed."""
    return quantity("speed", "m/s", "Forward speed; default the aircraft's own.")(command)


def disturbance(command: F) -> F:
    """--disturbance."""
    text = "Side force on the vertical tail, to the right."
    return quantity("disturbance", "N", text)(command)


def output(command: Callable[..., Any], keeps: bool = False) -> Callable[..., Any]:
    """--format and --out; the command gets as `form` one of `FORMATS`, or KEPT if it `keeps`."""

    @wraps(command)
    def formed(*, form: str | None, out: Path | None, **others: Any) -> Any:
        return command(form=_form(form, out, keeps), out=out, **others)

    kept = "; .npz or .nc (NetCDF) for the result itself, which `groundroll info` and Python read"
    option = click.option(
        "--out",
        type=click.Path(dir_okay=False, path_type=Path),
        help="File to write to instead of stdout, its suffix the format: .csv, .json"
        f"{kept if keeps else ''}.",
    )
    return click.option(
        "--format",
        "form",
        type=click.Choice(FORMATS),
        help="For people, a spreadsheet or a program. The latter two are in SI units with radians."
        " Default: as the suffix of --out says, or table.",
    )(option(formed))


def result(command: Callable[..., Any]) -> Callable[..., Any]:
    """--format and --out of a command whose result can be kept."""
    return output(command, keeps=True)


def _form(form: str | None, out: Path | None, keeps: bool) -> str:
    from groundroll.base.errors import GroundrollError

    suffix = out.suffix if out else ""
    if out and not out.parent.is_dir():
        raise GroundrollError(f"cannot write {out}: there is no folder {out.parent}")
    if suffix not in KEPT_IN:
        return form or (suffix[1:] if suffix[1:] in FORMATS else FORMATS[0])
    if not keeps or form:
        why = f"--format {form} does not go into it" if keeps else "this command keeps no result"
        raise click.BadParameter(f"found {out}; {why}", param_hint="--out")
    return KEPT


def picture(command: F) -> F:
    """--plot and --no-plot."""
    command = click.option("--no-plot", "plotless", is_flag=True, help="Write no picture.")(command)
    return click.option(
        "--plot",
        type=click.Path(dir_okay=False, path_type=Path),
        help="File for the picture, its suffix the kind (png, svg, pdf). Default: a PNG in this"
        " folder, if the format is table.",
    )(command)


def draw(
    figure: Callable[[], Any], default: str, form: str, plot: Path | None, plotless: bool
) -> None:
    """Draw and save a picture where one is wanted, and say where it is."""
    if plotless or (plot is None and form != "table"):
        return
    import matplotlib as mpl
    from matplotlib import pyplot

    from groundroll.base.errors import GroundrollError
    from groundroll.base.files import complete

    from .output import say

    mpl.use("Agg")
    path = plot or Path(f"{default}.png")
    drawn = figure()
    with complete(path) as draft:
        try:
            drawn.savefig(draft, format=path.suffix[1:] or "png")
        except ValueError as problem:
            raise GroundrollError(f"cannot write the picture {path}: {problem}") from problem
        finally:
            pyplot.close(drawn)
    say(f"wrote {path}")


def with_unit(name: str, unit: str) -> str:
    """Head of a column."""
    return name if unit == "1" else f"{name} [{unit}]"


def about(plane: Aircraft, **more: Any) -> Mapping[str, Any]:
    """What identifies a result: version, aircraft and settings."""
    from importlib.metadata import version

    from groundroll.aircraft.validity import extrapolated

    beyond = extrapolated(plane)
    told = {"beyond_the_data": beyond} if beyond else {}
    return {"groundroll": version("groundroll"), "aircraft": plane.name, **told, **more}
