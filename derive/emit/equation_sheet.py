"""The equation sheet of a pack: its chains in LaTeX, with their sources."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from groundroll.derive.core.equation import Chain
from groundroll.derive.core.model import Derivation
from groundroll.derive.core.quantity import Quantity

from .catalogue import Pack


def equation_sheet(pack: Pack) -> str:
    """Markdown with LaTeX; the last column says where each equation comes from."""
    lines = [
        f"# Equations: {pack.name}",
        "",
        "What the generated code computes, in the order in which it computes it. SI units and",
        "radians; SAE axes: x forward, y right, z down. Angles are positive as in the thesis; its",
        "forces of tires and tail act to the left (−y) for positive angles. Numbers in the last",
        "column are those of H. W. Brott, *A Study of Aircraft Lateral Dynamics & Ground",
        "Stability* (M.Sc. thesis, Rochester Institute of Technology, 1998).",
        "",
    ]
    if pack.model is not None:
        lines += _model_section(pack.model)
    for section in pack.sections:
        lines += _section(section.title, section.chain, section.text)
    return "\n".join([*lines, *_symbol_table(pack.quantities)])


def _model_section(model: Derivation) -> Iterator[str]:
    yield from _section(f"The {model.name} model", model.chain, model.summary)
    yield "and the states:"
    yield ""
    pairs = zip(model.states, model.rates, strict=True)
    rates = [rf"\dot{{{q.latex}}} = {sp.latex(rate)}" for q, rate in pairs]
    for start in range(0, len(rates), _A_LINE):
        yield "$$ " + r",\quad ".join(rates[start : start + _A_LINE]) + " $$"
        yield ""
    if model.defaults:
        yield from _section("What follows where it is not given", model.defaults)


#: Rates of states in one line.
_A_LINE = 4


def _section(title: str, chain: Chain, text: str = "") -> Iterator[str]:
    yield f"## {title}"
    yield ""
    if text:
        yield text
        yield ""
    yield "| quantity | unit | equation | source |"
    yield "|---|---|---|---|"
    for equation in chain:
        lhs, rhs = equation.lhs, sp.latex(equation.rhs)
        body = f"${lhs.latex} = {rhs}$".replace("|", r"\vert ")
        yield f"| {lhs.meaning} | {_unit(lhs)} | {body} | {equation.source} |"
    yield ""


def _symbol_table(quantities: tuple[Quantity, ...]) -> Iterator[str]:
    yield "## Symbols"
    yield ""
    yield "| symbol | in code | name | unit | meaning |"
    yield "|---|---|---|---|---|"
    for q in quantities:
        yield f"| ${q.latex}$ | `{q}` | {q.full_name} | {_unit(q)} | {q.meaning} |"
    yield ""


def _unit(q: Quantity) -> str:
    return "–" if q.unit == "1" else q.unit
