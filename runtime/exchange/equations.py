"""The equations of a model as programs in other languages."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import casadi as ca

from groundroll.model.models import Model

from .program import Language, names, read, statements, written

#: The arguments of a model's functions, and by what they change.
_VECTORS = ("x", "u", "p")
_CHANGES = ("dx", "du", "dp")


@dataclass(frozen=True)
class Routine:
    """A function that writes its results into arrays.

    Attributes
    ----------
    name, summary : str
    arguments, results : tuple of str
        Names of arrays.
    body : tuple of str
        Its statements.
    """

    name: str
    summary: str
    arguments: tuple[str, ...]
    results: tuple[str, ...]
    body: tuple[str, ...]


def routines(model: Model, language: Language) -> tuple[Routine, ...]:
    """Rates of the states, outputs, and the derivatives of both along any change."""
    rhs, outputs = model.expression("rhs"), model.expression("outputs")
    vectors = [ca.SX.sym(name, rhs.numel_in(k)) for k, name in enumerate(_VECTORS)]
    changes = [
        ca.SX.sym(name, vector.numel()) for name, vector in zip(_CHANGES, vectors, strict=True)
    ]
    rates, shown = rhs(*vectors), outputs(*vectors)
    everything, change = ca.vertcat(*vectors), ca.vertcat(*changes)
    moved = [ca.jtimes(result, everything, change) for result in (rates, shown)]
    plain = (
        ("rates", "Time derivatives of the states.", rates, "xdot"),
        ("outputs", "Angles, forces and whatever else the model tells.", shown, "y"),
    )
    return (
        *(
            routine(
                name, summary, (*zip(_VECTORS, vectors, strict=True),), ((result, value),), language
            )
            for name, summary, value, result in plain
        ),
        routine(
            "along",
            "By how much rates and outputs change as states, inputs and parameters do.",
            (*zip((*_VECTORS, *_CHANGES), (*vectors, *changes), strict=True),),
            (*zip(("dxdot", "dy"), moved, strict=True),),
            language,
        ),
    )


def routine(
    name: str,
    summary: str,
    arguments: Sequence[tuple[str, ca.SX]],
    results: Sequence[tuple[str, ca.SX]],
    language: Language,
) -> Routine:
    """A function of arrays in a language."""
    texts = [names(array, value.numel()) for array, value in arguments]
    program = read([value for _, value in arguments], [value for _, value in results], texts)

    def body() -> Iterator[str]:
        yield from statements(program, language)
        for (array, _), values in zip(results, program.results, strict=True):
            for k, value in enumerate(values):
                yield f"{array}[{k}] = {written(value, language)};"

    return Routine(
        name, summary, tuple(a for a, _ in arguments), tuple(a for a, _ in results), tuple(body())
    )
