"""An aircraft: parameters by name, given or following from others."""

from __future__ import annotations

import difflib
import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from dataclasses import replace as _replace
from functools import cache, cached_property
from importlib import resources
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np

from .arrays import FloatArray, broadcast, physical
from .errors import GroundloopError, unknown
from .evaluate import elementwise
from .generated import build
from .generated.names import FUNCTIONS, MODELS, QUANTITIES
from .names import signature, symbol
from .units import to_si

_FOLLOWS = {name.removesuffix("_follows") for name in FUNCTIONS if name.endswith("_follows")}


@cache
def _parameter_symbols() -> tuple[str, ...]:
    """What an aircraft may be given: parameters of the models and of what follows."""
    wanted = [p for model in MODELS.values() for p in model.parameters]
    for name in sorted(_FOLLOWS):
        wanted += [name, *build(f"{name}_follows").name_in()]
    present = {*wanted, "x_forward", "x_aft"}
    return tuple(s for s in QUANTITIES if s in present)


@dataclass(frozen=True)
class Source:
    """Where a number comes from, and whether it is only an estimate."""

    text: str = ""
    estimate: bool = False


@dataclass(frozen=True, repr=False, eq=False)
class Aircraft:
    """The parameters of an aircraft, by symbol (``a``) or full name (``main_gear_arm``).

    A parameter that is not given follows from others where it can: arms from stations, loads
    from arms, stiffnesses from loads (`groundloop.generated.loads`). Any may be an array; they
    broadcast.

    Attributes
    ----------
    name, title, description : str
        Short name, one line, and what to know before using the numbers.
    given : mapping of str to ndarray
        Values by symbol, SI units with radians.
    sources : mapping of str to Source
        Where each given value comes from.
    """

    name: str
    given: Mapping[str, FloatArray]
    title: str = ""
    description: str = ""
    sources: Mapping[str, Source] = field(default_factory=dict)

    def __post_init__(self) -> None:
        values = {s: physical(s, value) for s, value in self.given.items()}
        for array in values.values():
            array.setflags(write=False)
        broadcast(values)
        object.__setattr__(self, "given", MappingProxyType(values))

    @classmethod
    def load(cls, name: str | Path) -> Aircraft:
        """Read a packaged aircraft by name, or an aircraft file by path.

        Parameters
        ----------
        name : str or Path
            ``"brott"`` (reproduces the thesis), ``"brott-physical"`` (the same aircraft with
            the right constants and loads), or the path of a TOML file.

        Raises
        ------
        GroundloopError
            If there is no such aircraft or file, or if the file has mistakes: all of them are
            listed, each with its key.
        """
        path = Path(name)
        if path.suffix != ".toml":
            packaged = {p.name.removesuffix(".toml"): p for p in _packaged()}
            if str(name) not in packaged:
                raise unknown(
                    "aircraft", str(name), packaged, "the packaged ones (a file ends in .toml)"
                )
            path = Path(str(packaged[str(name)]))
        try:
            data = tomllib.loads(path.read_text(encoding="utf-8"))
        except OSError as problem:
            raise GroundloopError(f"cannot read {path}: {problem.strerror}") from problem
        except (tomllib.TOMLDecodeError, UnicodeDecodeError) as problem:
            raise GroundloopError(f"{path} is not valid TOML: {problem}") from problem
        return _from_data(data, path)

    def replace(self, **changes: Any) -> Aircraft:
        """A copy with some parameters changed.

        Parameters
        ----------
        **changes : float, array, str or None
            By symbol or full name: a number in SI units with radians, an array of them, a
            string with a unit (``"70 N/deg"``), or None to let the parameter follow.

        Raises
        ------
        GroundloopError
            For an unknown name, naming the nearest, or a value that cannot be.
        """
        given = dict(self.given)
        sources = dict(self.sources)
        for name, value in changes.items():
            key = symbol(name, "parameter", _parameter_symbols(), "Aircraft.replace")
            sources.pop(key, None)
            if value is None:
                given.pop(key, None)
            else:
                given[key] = _value(value, key, name)
        return _replace(self, given=given, sources=sources)

    def __getitem__(self, name: str) -> FloatArray:
        """Value of a parameter, given or following, in SI units with radians.

        Raises
        ------
        GroundloopError
            If the name is unknown, or the value is neither given nor follows.
        """
        return self._resolve(
            symbol(name, "parameter", _parameter_symbols(), f"aircraft {self.name}")
        )

    def __contains__(self, name: object) -> bool:
        try:
            self[str(name)]
        except GroundloopError:
            return False
        return True

    def parameters(self, tire: str, speed: Any = None) -> FloatArray:
        """The parameter vector of a model.

        Parameters
        ----------
        tire : str
            ``"linear"`` or ``"nonlinear"``.
        speed : float or array, optional
            Forward speed, m/s; the aircraft's own if omitted.

        Returns
        -------
        ndarray, shape (n, ...)
            In the order of ``generated.MODELS[tire].parameters``; the rest of the shape is what
            the parameters broadcast to, nothing if none is an array.
        """
        plane = self if speed is None else self.replace(u=speed)
        arrays, _ = broadcast({s: plane[s] for s in signature(tire).parameters})
        return np.stack(list(arrays.values()))

    def columns(
        self, tire: str, **others: FloatArray
    ) -> tuple[FloatArray, dict[str, FloatArray], tuple[int, ...]]:
        """Parameters and other arrays, broadcast together and laid out one column per case.

        Parameters
        ----------
        tire : str
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
        names = signature(tire).parameters
        arrays, shape = broadcast({**{s: self[s] for s in names}, **others})
        flat = {name: array.ravel() for name, array in arrays.items()}
        return np.stack([flat[s] for s in names]), {name: flat[name] for name in others}, shape

    @cached_property
    def _known(self) -> dict[str, FloatArray]:
        return dict(self.given)

    def _resolve(self, key: str) -> FloatArray:
        if key not in self._known:
            self._known[key] = self._follow(key)
        return self._known[key]

    def _follow(self, key: str) -> FloatArray:
        label = f"{QUANTITIES[key].name} ({key})"
        if key not in _FOLLOWS:
            raise GroundloopError(f"aircraft {self.name}: {label} is not given")
        needed = build(f"{key}_follows").name_in()
        try:
            arguments = {s: self._resolve(s) for s in needed}
        except GroundloopError as problem:
            raise GroundloopError(f"{problem}, and {label} follows from it") from None
        return physical(key, elementwise(f"{key}_follows", arguments)[key])

    def __iter__(self) -> Iterator[str]:
        """Symbols of the parameters that have a value."""
        return (s for s in _parameter_symbols() if s in self)

    def __repr__(self) -> str:
        lines = [f"Aircraft {self.name!r}: {self.title}"]
        for s in self:
            q = QUANTITIES[s]
            origin = self.sources.get(s, Source()).text if s in self.given else "follows"
            lines.append(
                f"  {s:<12}{_short(self[s]):>14} {q.unit:<12} {q.name:<32} {origin}".rstrip()
            )
        return "\n".join(lines)


def packaged() -> tuple[str, ...]:
    """Names of the aircraft that come with the package."""
    return tuple(sorted(p.name.removesuffix(".toml") for p in _packaged()))


def _packaged() -> list[Any]:
    folder = resources.files("groundloop") / "fleet"
    return [p for p in folder.iterdir() if p.name.endswith(".toml")]


_ABOUT = ("title", "description", "source")


def _from_data(data: Mapping[str, Any], path: Path) -> Aircraft:
    """An aircraft from the tables of a file, or one error that lists every mistake."""
    given: dict[str, Any] = {}
    sources: dict[str, Source] = {}
    mistakes: list[str] = []
    for key, entry in _leaves(data):
        where = f"{path.name}: {key}"
        try:
            name = symbol(key.rpartition(".")[2], "key", _parameter_symbols(), where)
            value, source = _entry(entry, where)
            if name in given:
                raise GroundloopError(f"{where} is given twice")
            given[name] = physical(name, _value(value, name, where))
            sources[name] = source
        except GroundloopError as problem:
            mistakes.append(str(problem))
    if mistakes:
        raise GroundloopError("\n".join([f"{path} has {len(mistakes)} mistake(s):", *mistakes]))
    return Aircraft(
        name=path.stem,
        given=given,
        title=str(data.get("title", path.stem)),
        description=str(data.get("description", "")).strip(),
        sources=sources,
    )


def _leaves(data: Mapping[str, Any], prefix: str = "") -> Iterator[tuple[str, Any]]:
    for key, entry in data.items():
        if not prefix and key in _ABOUT:
            continue
        if isinstance(entry, Mapping) and "value" not in entry:
            yield from _leaves(entry, f"{prefix}{key}.")
        else:
            yield f"{prefix}{key}", entry


def _entry(entry: Any, where: str) -> tuple[Any, Source]:
    if not isinstance(entry, Mapping):
        return entry, Source()
    fields = ("value", "source", "estimate")
    for name in entry:
        if name not in fields:
            near = difflib.get_close_matches(name, fields, n=1) or fields
            raise GroundloopError(f"{where}: unknown field {name!r}; there is {', '.join(near)}")
    return entry["value"], Source(str(entry.get("source", "")), bool(entry.get("estimate", False)))


def _value(value: Any, key: str, where: str) -> Any:
    return to_si(value, QUANTITIES[key].unit, where) if isinstance(value, str) else value


def _short(value: FloatArray) -> str:
    return f"{float(value):.6g}" if value.ndim == 0 else f"array {value.shape}"
