"""Models: those that ship, those of installed packages, and those of a user's own."""

from __future__ import annotations

import os
from collections.abc import Collection, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import casadi as ca

from groundroll.base.errors import GroundrollError, shown, unknown
from groundroll.generated import PACKS, Pack, PackError, Quantity, read_pack

#: Entry points under which installed packages announce their packs: name -> folder.
GROUP = "groundroll.models"


class Model(Pack):
    """A pack with equations of motion; see `groundroll.generated.packs.Pack` for its facts.

    >>> model = Model.load("nonlinear")
    >>> model.states, model.inputs, model.outputs  # symbols, in the order of the vectors
    """

    @classmethod
    def load(cls, name: str | Path) -> Model:
        """A model that ships, one that an installed package announces, or one in a folder.

        Parameters
        ----------
        name : str or Path
            ``"linear"``, ``"nonlinear"``, …; a name of the entry points ``groundroll.models``; or
            the folder that ``groundroll derive`` wrote.

        Raises
        ------
        GroundrollError
            If there is none, or its folder was made by another version.
        """
        if not isinstance(name, str | Path):
            raise GroundrollError(
                f"a model is a name, a folder or what Model.load gives, not {shown(name)}"
            )
        return _load(os.fspath(name))

    def __repr__(self) -> str:
        states, inputs = ", ".join(self.states), ", ".join(self.inputs) or "none"
        return f"Model {self.name!r}: states {states}; inputs {inputs}; digest {self.digest}"

    def __reduce__(self) -> tuple[Any, ...]:
        return _load, (self.key,)

    @property
    def key(self) -> str:
        """By what `load` finds it again: its name if it ships or is announced, or its folder."""
        if PACKS.get(self.name) == self:
            return self.name
        announced = (name for name, folder in _announced().items() if folder == self.folder)
        return next(announced, str(self.folder))

    def function(self, name: str) -> ca.Function:
        """One of its own functions (``"rhs"``, ``"outputs"``, ``"jacobians"``, ...), compiled."""
        return self.compiled(self._full(name))

    def expression(self, name: str) -> ca.Function:
        """The same function in CasADi's virtual machine, to look into or to build upon."""
        return self.build(self._full(name))

    def _full(self, name: str) -> str:
        full = self.own.get(name)
        if full is None:
            raise GroundrollError(
                f"the model {self.name} has no {name!r}; it has {', '.join(self.own)}"
            )
        return full

    def symbol(self, name: str, kind: str, allowed: Collection[str], where: str = "") -> str:
        """The symbol of one of its quantities given by symbol or by full name."""
        return symbol_of(self.quantities, name, kind, allowed, where)

    def need(self, ability: str, what: str) -> None:
        """Raise an error unless the model has an ability."""
        if ability not in self.abilities:
            able = ", ".join(n for n, pack in PACKS.items() if ability in pack.abilities)
            raise GroundrollError(
                f"{what} needs {ability.replace('_', ' ')}, which the model {self.name} does not"
                f" have; {able} does"
            )


def symbol_of(
    quantities: Mapping[str, Quantity],
    name: str,
    kind: str,
    allowed: Collection[str],
    where: str = "",
) -> str:
    """The symbol of a quantity given by symbol or by full name.

    Raises
    ------
    UnknownNameError
        If it is not one of the symbols `allowed`; the message names the nearest.
    """
    if isinstance(name, str) and name in allowed:
        return name
    known = isinstance(name, str)
    found = next((s for s in allowed if known and quantities[s].name == name), None)
    if found is not None:
        return found
    choices = [choice for s in allowed for choice in (s, quantities[s].name)]
    raise unknown(kind, name, dict.fromkeys(choices), where)


#: What stands for a model wherever one is asked for.
ModelLike = str | Path | Model


def as_model(model: ModelLike) -> Model:
    """A model given as such, by name or by folder."""
    return model if isinstance(model, Model) else Model.load(model)


def _load(name: str) -> Model:
    try:
        pack = _found(name)
        return _model(pack, id(pack))
    except PackError as problem:
        raise GroundrollError(str(problem)) from None


def _found(name: str) -> Pack:
    if name in PACKS and PACKS[name].states:
        return PACKS[name]
    announced = _announced()
    if name in announced:
        return read_pack(announced[name])
    if os.path.isdir(name):
        return read_pack(Path(name).resolve())
    there = [*(n for n, pack in PACKS.items() if pack.states), *announced]
    if os.path.basename(name) != name:
        raise GroundrollError(
            f"there is no folder {name}; `groundroll derive model.py --out {name}` makes a model of"
            f" your own there, and without a folder there is {', '.join(there)}"
        )
    raise unknown("model", name, there)


@cache
def _announced() -> dict[str, Path]:
    """The packs of installed packages."""
    from importlib.metadata import entry_points

    found = {}
    for entry in entry_points(group=GROUP):
        told = entry.load()
        found[entry.name] = Path(told() if callable(told) else told).resolve()
    return found


@cache
def _model(pack: Pack, identity: int) -> Model:
    """A pack as a model, one for each that was read: words may differ where digests do not."""
    if not pack.states:
        raise GroundrollError(f"the pack {pack.name} holds no equations of motion")
    return Model(**{name: getattr(pack, name) for name in Pack.__dataclass_fields__})
