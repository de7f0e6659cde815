"""The variables of a component, as the Functional Mock-up Interface describes them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from groundroll.base.units import UnitError, from_si, parts
from groundroll.generated import Quantity

from .subject import Subject

#: In what quantities are shown if the aircraft file does not say.
_SHOWN_IN = {"rad": "deg", "rad/s": "deg/s"}


@dataclass(frozen=True)
class Variable:
    """A variable of a component.

    Attributes
    ----------
    reference : int
        By which the compiled component knows it; see ``component.c``.
    name, description, unit : str
        Its SI unit, with radians.
    shown_in : str
        The unit in which people want to see it; empty: the SI unit.
    causality, variability, initial : str
        As FMI says it.
    start : float, optional
    least : float, optional
        Smallest value that it may have.
    derivative : int, optional
        Reference of the state of which it is the derivative.
    depends : tuple of int, optional
        References of the states and inputs that it is computed from.
    """

    reference: int
    name: str
    description: str
    unit: str
    shown_in: str = ""
    causality: str = "output"
    variability: str = "continuous"
    initial: str = "calculated"
    start: float | None = None
    least: float | None = None
    derivative: int | None = None
    depends: tuple[int, ...] = ()


def variables(subject: Subject) -> list[Variable]:
    """Every variable of a subject: time, states, derivatives, inputs, parameters, outputs."""
    return list(_numbered(subject))


def _numbered(subject: Subject) -> Iterator[Variable]:
    model, shown_in = subject.model, _shown_in(subject)
    groups = (model.states, model.inputs, model.parameters, model.outputs)
    symbols = [s for group in groups for s in group]
    names = _names([model.quantities[s] for s in symbols])
    states, inputs = len(model.states), len(model.inputs)
    known = (*range(1, 1 + states), *range(1 + 2 * states, 1 + 2 * states + inputs))
    rates, outputs = (_dependencies(subject, name, known) for name in ("rhs", "outputs"))
    counter = iter(range(1 + 2 * len(symbols)))

    def variable(s: str, q: Quantity, **more: object) -> Variable:
        least = 0.0 if q.sign else None
        about = (next(counter), names[s], q.meaning, q.unit, shown_in.get(s, ""))
        return Variable(*about, least=least, **more)  # type: ignore[arg-type]

    yield Variable(next(counter), "time", "time", "s", causality="independent", initial="")
    exact = {"initial": "exact"}
    first = 1
    for k, (s, value) in enumerate(subject.start.items()):
        q = model.quantities[s]
        yield variable(s, q, start=value, depends=(first + k,), **exact)
    for k, s in enumerate(model.states):
        q = model.quantities[s]
        yield Variable(
            next(counter),
            f"der({names[s]})",
            f"time derivative of {names[s]}",
            _per_second(q.unit),
            causality="local",
            derivative=first + k,
            depends=rates[k],
        )
    for s, value in subject.inputs.items():
        yield variable(s, model.quantities[s], causality="input", start=value, initial="")
    tunable = {"causality": "parameter", "variability": "tunable", **exact}
    for s, value in subject.parameters.items():
        yield variable(s, model.quantities[s], start=value, **tunable)
    for k, s in enumerate(model.outputs):
        yield variable(s, model.quantities[s], depends=outputs[k])


def _dependencies(subject: Subject, function: str, known: Sequence[int]) -> list[tuple[int, ...]]:
    """For each result of a function of the model the states and inputs that it is made of."""
    made = subject.model.expression(function)
    found: list[set[int]] = [set() for _ in range(made.numel_out(0))]
    first = 0
    for k in range(2):
        for row, column in zip(*made.jac_sparsity(0, k).get_triplet(), strict=True):
            found[row].add(known[first + column])
        first += made.numel_in(k)
    return [tuple(sorted(each)) for each in found]


def _names(quantities: Sequence[Quantity]) -> dict[str, str]:
    """The full name of each symbol, or the symbol where two have one name."""
    count = Counter(["time", *(q.name for q in quantities)])
    return {q.symbol: q.name if count[q.name] == 1 else q.symbol for q in quantities}


def _shown_in(subject: Subject) -> Mapping[str, str]:
    """The user's own units, as far as the aircraft file has some."""
    found = {}
    for s, q in subject.model.quantities.items():
        source = subject.aircraft.sources.get(s)
        unit = parts(source.entry)[1] if source and source.entry else ""
        unit = unit or _SHOWN_IN.get(q.unit, "")
        try:
            if unit and unit != q.unit and from_si(1.0, q.unit, unit) != 1.0:
                found[s] = unit
        except UnitError:
            continue
    return found


def _per_second(unit: str) -> str:
    """The unit of a time derivative."""
    if unit.endswith("/s"):
        return f"{unit}^2"
    return f"{unit}/s" if "/" not in unit else f"({unit})/s"
