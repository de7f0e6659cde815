# Generated from derive/ with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`.
"""A pack: what was generated of one model, read from its folder."""

from __future__ import annotations

import importlib.util
import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from math import inf
from pathlib import Path
from typing import Any, NamedTuple

import casadi as ca

from .compiler import NoCompilerError, opened
from .library import compiled, say_slower
from .version import FORMAT, VERSION


class PackError(ValueError):
    """A folder that holds no pack that this version can read; the message says the way out."""


class Quantity(NamedTuple):
    """What a symbol stands for; SI units with radians."""

    symbol: str
    name: str
    unit: str
    meaning: str
    latex: str
    sign: str
    kind: str


class Place(NamedTuple):
    """A part that acts, and how it is drawn; its rows in the function ``places``."""

    name: str
    kind: str


class Event(NamedTuple):
    """What happens when an output passes through zero, rising or falling."""

    name: str
    output: str
    rising: bool
    meaning: str


@dataclass(frozen=True)
class Pack:
    """The facts of a pack, and its functions.

    Attributes
    ----------
    folder : Path
    name, summary, digest : str
        The digest is of the equations: symbols, units, order.
    abilities : tuple of str
        What can be done beyond what any model can.
    quantities : mapping of str to Quantity
        By symbol.
    functions : mapping
        Name of a function -> module, builder, C file.
    sweeps : mapping
        Name of a function that has a kernel for many points -> C file.
    states, dynamic, inputs, parameters, outputs : tuple of str
        Order of the vectors: x' = f(x, u, p) and y = g(x, u, p). The rates of the dynamic states
        depend on them; the others are integrals. All empty for a pack without a model.
    ranges : mapping of str to tuple of float
        Between what an input can be moved, SI; infinite where there is no end.
    roles : mapping of str to str
        Which state is ``heading``, ``offset``, ``speed``, ... where there is one.
    places : tuple of Place
    events : tuple of Event
    carried, seen : tuple of tuple of str
        The sets of states that its kernels can carry, the smallest first, and for each the outputs
        that need no other state.
    stiff : bool
        Whether it comes to rest, or is stiff for another reason.
    over_time : bool
        Whether its kernels know inputs over time only, of which constant ones are a case.
    """

    folder: Path
    name: str
    summary: str
    digest: str
    abilities: tuple[str, ...]
    quantities: Mapping[str, Quantity]
    functions: Mapping[str, tuple[str, str, str]]
    sweeps: Mapping[str, str]
    states: tuple[str, ...] = ()
    dynamic: tuple[str, ...] = ()
    inputs: tuple[str, ...] = ()
    parameters: tuple[str, ...] = ()
    outputs: tuple[str, ...] = ()
    ranges: Mapping[str, tuple[float, float]] = ()  # type: ignore[assignment]
    roles: Mapping[str, str] = ()  # type: ignore[assignment]
    places: tuple[Place, ...] = ()
    events: tuple[Event, ...] = ()
    carried: tuple[tuple[str, ...], ...] = ()
    seen: tuple[tuple[str, ...], ...] = ()
    stiff: bool = False
    over_time: bool = False

    def __hash__(self) -> int:
        return hash((self.folder, self.digest))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Pack):
            return NotImplemented
        return (self.folder, self.digest) == (other.folder, other.digest)

    def __reduce__(self) -> tuple[Any, ...]:
        return read_pack, (self.folder,)

    @property
    def sources(self) -> Path:
        """Folder of the C files."""
        return self.folder / "c"

    def compiled(self, name: str) -> ca.Function:
        """A function of the pack, compiled if there is a C compiler."""
        return _compiled(self, name)

    def build(self, name: str) -> ca.Function:
        """The function in CasADi's virtual machine, from its Python source."""
        module, builder, _ = self.functions[name]
        function: ca.Function = getattr(self._module(module), builder)()
        return function

    def _module(self, name: str) -> Any:
        return _module(self.folder / f"{name}.py", self.digest)

    @cached_property
    def own(self) -> Mapping[str, str]:
        """Names of the functions of the model without the name of the pack before them."""
        start = f"{self.name}_"
        return {n.removeprefix(start): n for n in self.functions if n.startswith(start)}


@cache
def _compiled(pack: Pack, name: str) -> ca.Function:
    c_file = pack.functions[name][2]
    if not c_file:
        return pack.build(name)
    try:
        library = compiled(pack.sources / f"{c_file}.c", pack.digest, symbol=name)
        opened(library, name)
    except NoCompilerError as problem:
        say_slower(problem)
        return pack.build(name)
    return ca.external(name, str(library))


@cache
def _module(path: Path, digest: str) -> Any:
    spec = importlib.util.spec_from_file_location(
        f"groundroll_pack_{path.parent.name}_{path.stem}", path
    )
    if spec is None or spec.loader is None:
        raise PackError(f"{path} cannot be read as Python")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def read_pack(folder: Path) -> Pack:
    """Read the pack in a folder, again only if it was made again.

    Raises
    ------
    PackError
        If the folder holds no pack, or one that another version has made.
    """
    try:
        written = (folder / "facts.json").stat()
    except OSError:
        return _read(folder, (0, 0))
    return _read(folder, (written.st_mtime_ns, written.st_size))


@cache
def _read(folder: Path, written: tuple[int, int]) -> Pack:
    path = folder / "facts.json"
    try:
        facts = json.loads(path.read_text(encoding="utf-8"))
        made_with = str(facts["version"])
        is_current = facts["format"] == FORMAT and _series(made_with) == _series(VERSION)
    except FileNotFoundError:
        raise PackError(
            f"{folder} is no pack: it holds no facts.json; `groundroll derive model.py --out"
            f" {folder}` makes one"
        ) from None
    except (OSError, ValueError, KeyError, TypeError) as problem:
        raise PackError(
            f"{path} cannot be read ({problem}): make the pack again with `groundroll derive`"
        ) from None
    if not is_current:
        raise PackError(
            f"the pack in {folder} was made by groundroll {made_with}, this is {VERSION}: make it"
            " again with `groundroll derive`"
        )
    try:
        return _pack(folder, facts)
    except (KeyError, TypeError, ValueError) as problem:
        raise PackError(
            f"{path} is damaged ({problem!r}): make the pack again with `groundroll derive`"
        ) from None


def _series(version: str) -> list[str]:
    return version.split(".")[:2]


def _range(least: float | None, most: float | None) -> tuple[float, float]:
    return -inf if least is None else least, inf if most is None else most


def _pack(folder: Path, facts: Mapping[str, Any]) -> Pack:
    groups = {
        name: tuple(facts.get(name, ()))
        for name in ("states", "dynamic", "inputs", "parameters", "outputs", "abilities")
    }

    return Pack(
        folder=folder,
        name=facts["name"],
        summary=facts["summary"],
        digest=facts["digest"],
        quantities={s: Quantity(s, *entry) for s, entry in facts["quantities"].items()},
        functions={name: (m, b, c) for name, (m, b, c) in facts["functions"].items()},
        sweeps=facts["sweeps"],
        ranges={s: _range(*ends) for s, ends in facts.get("ranges", {}).items()},
        roles=facts.get("roles", {}),
        places=tuple(Place(*place) for place in facts.get("places", ())),
        events=tuple(Event(*event) for event in facts.get("events", ())),
        carried=tuple(map(tuple, facts.get("carried", ()))),
        seen=tuple(map(tuple, facts.get("seen", ()))),
        stiff=bool(facts.get("stiff", False)),
        over_time=bool(facts.get("over_time", False)),
        **groups,
    )
