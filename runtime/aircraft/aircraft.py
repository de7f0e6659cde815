"""An aircraft: parameters by name, given or following from others."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from dataclasses import replace as _replace
from functools import cache, cached_property, partial, wraps
from pathlib import Path
from textwrap import shorten
from types import MappingProxyType
from typing import Any, TypeVar, cast

import numpy as np

from groundroll.base.arrays import FloatArray, broadcast, common_shape, stored
from groundroll.base.errors import GroundrollError, mapped, shown
from groundroll.base.listing import Listed
from groundroll.base.memory import check_memory
from groundroll.generated import build
from groundroll.model.evaluate import elementwise
from groundroll.model.models import ModelLike, as_model
from groundroll.model.names import FUNCTIONS, PARAMETERS, parameter_symbols, physical, symbol

from .file import load, packaged_files
from .parameters import NotGivenError, parameters_of, stacked
from .source import Source

F = TypeVar("F", bound=Callable[..., Any])

#: What follows from others where it is not given.
FOLLOWS = frozenset(
    name.removesuffix("_follows") for name in FUNCTIONS if name.endswith("_follows")
)
#: Endings of the functions by which it does: the first that gives a number counts.
_WAYS = (
    "_follows_with_nose_wheel",
    "_follows_with_tail_wheel",
    "_follows",
    "_follows_from_size",
)


@cache
def ways(key: str) -> tuple[str, ...]:
    """Names of the functions by which a parameter follows, the one to try first in front."""
    return tuple(key + ending for ending in _WAYS if key + ending in FUNCTIONS)


def _origins(key: str) -> tuple[str, ...]:
    """What goes directly into the functions by which a parameter follows."""
    return tuple(dict.fromkeys(s for way in ways(key) for s in build(way).name_in()))


class _Checked(dict[str, FloatArray]):
    """Values that `_checked` gave."""


def _checked(key: str, value: Any) -> FloatArray:
    """A value of a parameter that is as it must be, and that nobody can change."""
    array = physical(key, value)
    if array.size == 0:
        raise GroundrollError(f"{_label(key)} must have a value, but it is an empty array")
    own = stored(array)
    if own.flags.writeable or not own.flags.owndata:
        own = own.copy()
        own.setflags(write=False)
    return own if own.shape == array.shape else np.broadcast_to(own, array.shape)


@dataclass(frozen=True, repr=False, eq=False)
class Aircraft(Listed):
    """The parameters of an aircraft, by symbol (``a``) or full name (``main_gear_arm``).

    A parameter that is not given follows from others where it can: arms from stations, loads
    from arms, or from the nose wheel's station with the main gear behind the CG, stiffnesses from
    loads (`groundroll.generated.loads`). Any may be an array; they broadcast.

    Attributes
    ----------
    name, title, description : str
        Short name, one line, and what to know before using the numbers.
    given : mapping of str to ndarray
        Values by symbol, SI units with radians.
    sources : mapping of str to Source
        Where each given value comes from.
    source : str
        The document that most of them come from.
    own : mapping of str to float, array or str
        Parameters of a model of the user's own, by symbol or full name, as numbers in SI units or
        with units; they are checked when the model is known.
    """

    name: str
    given: Mapping[str, FloatArray]
    title: str = ""
    description: str = ""
    sources: Mapping[str, Source] = field(default_factory=dict)
    source: str = ""
    own: Mapping[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        values = mapped("given of an aircraft", self.given)
        if not isinstance(self.name, str):
            raise GroundrollError(f"the name of an aircraft must be a text, not {shown(self.name)}")
        if not isinstance(values, _Checked):
            allowed, where = parameter_symbols(), f"aircraft {shown(self.name)}"
            named = {symbol(s, "parameter", allowed, where): v for s, v in values.items()}
            values = {key: _checked(key, value) for key, value in named.items()}
        common_shape(values)
        object.__setattr__(self, "given", MappingProxyType(values))
        object.__setattr__(self, "own", MappingProxyType(dict(mapped("own", self.own))))

    def __reduce__(self) -> tuple[Any, ...]:
        fields = {**vars(self), "given": dict(self.given), "sources": dict(self.sources)}
        fields["own"] = dict(self.own)
        fields.pop("_known", None)
        return partial(Aircraft, **fields), ()

    @classmethod
    def load(cls, name: str | Path) -> Aircraft:
        """Read a packaged aircraft by name, or an aircraft file by path.

        Parameters
        ----------
        name : str or Path
            ``"brott"`` (reproduces the thesis), ``"brott-physical"`` (the same aircraft with
            the right constants and loads), another of `packaged`, or the path of a TOML file.

        Raises
        ------
        GroundrollError
            If there is no such aircraft or file, or if the file has mistakes: all of them are
            listed, each with its line and key, what was found and what was expected.
        """
        return load(name, cls)

    def replace(self, **changes: Any) -> Aircraft:
        """A copy with some parameters changed.

        Parameters
        ----------
        **changes : float, array, str or None
            By symbol or full name: a number in SI units with radians, an array of them, a
            string with a unit (``"70 N/deg"``), or None to let the parameter follow. An array is
            copied, but for one that owns its memory and is read-only.

        Raises
        ------
        GroundrollError
            For an unknown name, naming the nearest, or a value that cannot be.
        """
        given = _Checked(self.given)
        sources = dict(self.sources)
        changed: dict[str, str] = {}
        for name, value in changes.items():
            key = symbol(name, "parameter", parameter_symbols(), "Aircraft.replace")
            if key in changed:
                raise GroundrollError(
                    f"{changed[key]} and {name} are the same parameter; give one of them"
                )
            changed[key] = name
            sources.pop(key, None)
            if value is None:
                given.pop(key, None)
            else:
                given[key] = _checked(key, value)
        return _replace(self, given=given, sources=sources)

    def at_each(self, pick: Callable[[FloatArray], FloatArray]) -> Aircraft:
        """A copy of which every array is replaced by what `pick` makes of it."""
        given = {s: pick(x) for s, x in self.given.items() if x.ndim}
        own = {s: pick(x) if np.ndim(x) else x for s, x in self.own.items()}
        return self.replace(**given).with_own(own)

    def with_own(self, own: Mapping[str, Any]) -> Aircraft:
        """A copy with other parameters of a model of the user's own."""
        return _replace(self, own=own)

    def __getitem__(self, name: str) -> FloatArray:
        """Value of a parameter, given or following, in SI units with radians.

        Raises
        ------
        GroundrollError
            If the name is unknown, or the value is neither given nor follows.
        """
        return self._resolve(
            symbol(name, "parameter", parameter_symbols(), f"aircraft {self.name}")
        )

    def get(self, name: str, default: FloatArray) -> FloatArray:
        """Value of a parameter, or `default` where it is neither given nor follows."""
        try:
            return self[name]
        except GroundrollError:
            return default

    def __contains__(self, name: object) -> bool:
        try:
            self[str(name)]
        except GroundrollError:
            return False
        return True

    def follows_from(self, name: str) -> tuple[str, ...]:
        """Symbols of what a parameter follows from, or would if it were not given.

        Of an array any element counts.

        Raises
        ------
        GroundrollError
            If the name is unknown, or the parameter does not follow.
        """
        key = symbol(name, "parameter", parameter_symbols(), f"aircraft {self.name}")
        return tuple(dict.fromkeys(s for way, _ in self._found(key) for s in build(way).name_in()))

    def parameters(self, model: ModelLike, speed: Any = None) -> FloatArray:
        """The parameter vector of a model.

        Parameters
        ----------
        model : str or Model
            ``"linear"`` or ``"nonlinear"``.
        speed : float or array, optional
            Forward speed, m/s; the aircraft's own if omitted.

        Returns
        -------
        ndarray, shape (n, ...)
            In the order of ``generated.PACKS[model].parameters``; the rest of the shape is what
            the parameters broadcast to, nothing if none is an array.
        """
        plane = self if speed is None else self.replace(u=speed)
        return stacked(parameters_of(plane, as_model(model)))

    def columns(
        self, model: ModelLike, **others: FloatArray
    ) -> tuple[FloatArray, dict[str, FloatArray], tuple[int, ...]]:
        """Parameters and other arrays, broadcast together and laid out one column per case.

        Parameters
        ----------
        model : str or Model
            ``"linear"`` or ``"nonlinear"``.
        **others : ndarray
            Whatever goes with the parameters, by name.

        Returns
        -------
        p : ndarray, shape (n, N)
            Parameter vectors.
        others : dict of ndarray, each of shape (N,)
        shape : tuple of int
            What they broadcast to; its product is N.
        """
        values = parameters_of(self, as_model(model))
        arrays, shape = broadcast({**values, **others})
        if 0 in shape:
            raise GroundrollError(f"nothing is given: the arrays broadcast to {shape}")
        check_memory(8 * math.prod(shape) * len(arrays), "the parameters of so many cases")
        flat = {name: array.ravel() for name, array in arrays.items()}
        return np.stack([flat[s] for s in values]), {name: flat[name] for name in others}, shape

    @cached_property
    def _known(self) -> dict[str, FloatArray]:
        return dict(self.given)

    def _resolve(self, key: str) -> FloatArray:
        if key not in self._known:
            self._known[key] = self._follow(key)
        return self._known[key]

    def _follow(self, key: str) -> FloatArray:
        found = np.asarray(np.nan)
        for _, value in self._found(key):
            found = np.where(np.isnan(found), value, found)
        try:
            return physical(key, found)
        except GroundrollError as problem:
            raise GroundrollError(f"aircraft {self.name}: {problem}{self._why(key)}") from None

    def _why(self, key: str) -> str:
        """From what a parameter follows, and what is not given that would have a say in it."""
        known = ", ".join(_label(s) for s in _origins(key) if s in self)
        origins = [s for s in _origins(key) if s not in self.given]
        every = dict.fromkeys(x for s in origins for x in (s, *_origins(s)))
        missing = " and ".join(_label(s) for s in every if s not in self)
        return f"; it follows from {known}" + (f", without {missing}" if missing else "")

    def _found(self, key: str) -> Iterator[tuple[str, FloatArray]]:
        """Functions by which a parameter follows, with what each gives, until nothing is NaN."""
        label = _label(key)
        if key not in FOLLOWS:
            raise NotGivenError(f"aircraft {self.name}: {label} is not given", key)
        missing, is_known = None, False
        for way in ways(key):
            try:
                arguments = {s: self._resolve(s) for s in build(way).name_in()}
            except NotGivenError as problem:
                if way == f"{key}_follows":
                    missing = problem
                continue
            value, is_known = elementwise(way, arguments)[key], True
            yield way, value
            if not np.isnan(value).any():
                return
        if missing and not is_known:
            message = f"{missing}, and {label} follows from it"
            raise NotGivenError(message, missing.symbol) from None

    def __iter__(self) -> Iterator[str]:
        """Symbols of the parameters that have a value."""
        return (s for s in parameter_symbols() if s in self)

    def _title(self) -> str:
        return f"Aircraft {self.name!r}: {self.title}"

    def _rows(self) -> Iterable[Sequence[str]]:
        for s in self:
            q = PARAMETERS[s]
            source = self.sources.get(s, Source())
            mark = "estimate: " if source.estimate else ""
            origin = shorten(mark + source.text, 60) if s in self.given else "follows"
            yield s, f"{_short(self[s]):>14}", q.unit, q.name, origin


def of_aircraft(function: F) -> F:
    """Let a function refuse in words what is no aircraft in the place of its first argument."""

    missing = object()  # Python itself complains of that

    @wraps(function)
    def checked(*arguments: Any, **named: Any) -> Any:
        plane = arguments[0] if arguments else named.get("plane", missing)
        if plane is not missing and not isinstance(plane, Aircraft):
            raise GroundrollError(
                f"{function.__name__} takes an aircraft, such as Aircraft.load('brott'), not"
                f" {shown(plane)}"
            )
        return function(*arguments, **named)

    return cast(F, checked)


def packaged() -> tuple[str, ...]:
    """Names of the aircraft that come with the package."""
    return tuple(sorted(packaged_files()))


def _label(key: str) -> str:
    return f"{PARAMETERS[key].name} ({key})"


def _short(value: FloatArray) -> str:
    return f"{float(value):.6g}" if value.ndim == 0 else f"array {value.shape}"
