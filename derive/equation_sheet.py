"""The equation sheet: every generated chain in LaTeX, with the thesis's equation numbers."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

import sympy as sp

from . import placement
from .catalogue import Module
from .equation import Chain
from .kick import kick
from .kinematics import path_rates
from .loads import nose_wheel_loads, static_loads
from .model import Model
from .quantities import Quantity
from .stability_sections import stability_sections

_NOSE_WHEEL = (
    "What is otherwise with the main gear behind the CG: the nose wheel carries what it leaves."
    " Where this is NaN, the equations above hold."
)
_KICK = "A side impulse changes the motion before any tire can answer."


def equation_sheet(derived: Sequence[Module]) -> str:
    """Markdown with LaTeX; the number behind each equation is the thesis's own."""
    lines = [
        "# Equation sheet",
        "",
        "Everything the generated code computes, in the order in which it computes it. SI units",
        "and radians; SAE axes: x forward, y right, z down. Angles are positive as in the thesis;",
        "the forces of tires and tail act to the left (−y) for positive angles. The numbers in the",
        "last column are those of H. W. Brott, *A Study of Aircraft Lateral Dynamics & Ground",
        "Stability* (M.Sc. thesis, Rochester Institute of Technology, 1998).",
        "",
    ]
    models = [module.model for module in derived if module.model is not None]
    for model in models:
        lines += _model_section(model)
    lines += _section("Loads and stiffnesses", static_loads())
    lines += _section("Loads with a nose wheel", nose_wheel_loads(), _NOSE_WHEEL)
    lines += _section("A kick", kick(), _KICK)
    for title, chain, text in (*stability_sections(), *placement.sections()):
        lines += _section(title, chain, text)
    return "\n".join([*lines, *_symbol_table(models)])


def _model_section(model: Model) -> Iterator[str]:
    yield from _section(f"The {model.name} model", model.chain, model.summary)
    yield "and the displacements, in aircraft coordinates and over the ground:"
    yield ""
    rates = [rf"\dot{{{q.latex}}} = {sp.latex(rate)}" for q, rate in path_rates().items()]
    yield "$$ " + r",\quad ".join(rates) + " $$"
    yield ""


def _section(title: str, chain: Chain, text: str = "") -> Iterator[str]:
    yield f"## {title}"
    yield ""
    if text:
        yield text
        yield ""
    yield "| quantity | unit | equation | thesis |"
    yield "|---|---|---|---|"
    for equation in chain:
        lhs, rhs = equation.lhs, sp.latex(equation.rhs)
        body = f"${lhs.latex} = {rhs}$".replace("|", r"\vert ")
        yield f"| {lhs.meaning} | {_unit(lhs)} | {body} | {equation.source} |"
    yield ""


def _symbol_table(models: Iterable[Model]) -> Iterator[str]:
    yield "## Symbols"
    yield ""
    yield "| symbol | in code | name | unit | meaning |"
    yield "|---|---|---|---|---|"
    found: dict[str, Quantity] = {}
    for model in models:
        for q in (*model.states, *model.inputs, *model.parameters):
            found.setdefault(q.name, q)
    for q in found.values():
        yield f"| ${q.latex}$ | `{q}` | {q.full_name} | {_unit(q)} | {q.meaning} |"
    yield ""


def _unit(q: Quantity) -> str:
    return "–" if q.unit == "1" else q.unit
