"""A model in plain C: header, source, parameters, an example and a Makefile."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

import jinja2

from groundroll.base.wording import encodable, visible
from groundroll.generated import Quantity

from .equations import Routine, routines
from .program import C
from .subject import Subject

_TEMPLATES = Path(__file__).parent / "c"
#: Names of files that a model cannot have.
_TAKEN = ("main", "parameters")
#: Arrays of the functions, and what is in each.
_ARRAYS = (("x", "states"), ("u", "inputs"), ("p", "parameters"), ("y", "outputs"))


def c_files(subject: Subject) -> dict[str, str]:
    """Text of each file of the bundle by its name."""
    facts = c_facts(subject)
    return {
        f"{facts['name']}.h": rendered("model.h", facts),
        f"{facts['name']}.c": rendered("model.c", facts),
        "parameters.c": rendered("parameters.c", facts),
        "main.c": rendered("main.c", facts),
        "Makefile": rendered("Makefile", facts),
    }


def rendered(template: str, facts: Mapping[str, Any]) -> str:
    """Text of one of the templates."""
    return _environment().get_template(f"{template}.j2").render(facts)


def c_facts(subject: Subject, name: str = "") -> dict[str, Any]:
    """What the templates tell of a subject; `name` is before its functions, by default its own."""
    model = subject.model
    name = name or (f"{model.name}_model" if model.name in _TAKEN else model.name)
    numbers = (("x", subject.start), ("u", subject.inputs), ("p", subject.parameters))
    return {
        "name": name,
        "NAME": name.upper(),
        "summary": comment(model.summary),
        "aircraft": comment(subject.title),
        "origin": comment(subject.origin),
        "arrays": [(a, g, subject.quantities(getattr(model, g))) for a, g in _ARRAYS],
        "values": [(a, [*zip(subject.quantities(n), n.values(), strict=True)]) for a, n in numbers],
        "routines": [_described(r, name) for r in routines(model, C)],
    }


def _described(routine: Routine, model: str) -> Mapping[str, Any]:
    body = "\n".join(routine.body)
    return {
        "name": routine.name,
        "summary": routine.summary,
        "body": routine.body,
        "unused": [a for a in (*routine.arguments, *routine.results) if f"{a}[" not in body],
        "signature": ", ".join(
            [
                *(f"const {model}_real *{a}" for a in routine.arguments),
                *(f"{model}_real *{a}" for a in routine.results),
            ]
        ),
    }


@cache
def _environment() -> jinja2.Environment:
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(_TEMPLATES),
        autoescape=False,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        undefined=jinja2.StrictUndefined,
    )
    environment.filters |= {
        "told": _told,
        "quoted": quoted,
        "number": lambda value: repr(float(value)),
    }
    return environment


def comment(text: str) -> str:
    """A text that a comment in C may hold: in one line, and no end of a comment."""
    return " ".join(re.sub(r"[/*?]+(?=[/*])|\\", " ", visible(encodable(text))).split())


def quoted(text: str) -> str:
    """A text as a string in C."""
    plain = "".join(c if c.isprintable() else " " for c in encodable(text))
    return '"{}"'.format(re.sub(r'(["\\?])', r"\\\1", plain))


def _told(quantity: Quantity) -> str:
    """What a quantity is, for a comment."""
    return comment(f"{quantity.name} [{quantity.unit}]: {quantity.meaning}")
