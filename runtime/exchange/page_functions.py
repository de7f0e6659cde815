"""The functions of the page, as JavaScript: those of the model, and by which parameters follow."""

from __future__ import annotations

import json
from collections.abc import Iterator
from functools import cache

import casadi as ca

from groundroll.aircraft.aircraft import ways
from groundroll.generated import PACKS, build
from groundroll.model.models import Model
from groundroll.model.names import PARAMETERS

from .equations import Routine, routine, routines
from .program import JAVASCRIPT, names, read, statements, written

#: Functions of Math that the others call by name.
_MATH = (
    *("sqrt", "exp", "log", "floor", "ceil", "sin", "cos", "tan", "log1p", "expm1", "asin", "acos"),
    *("atan", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh", "pow", "atan2", "hypot"),
    *("abs", "min", "max"),
)


@cache
def functions_text(model: Model) -> str:
    """JavaScript that defines rates, outputs, along, places and WAYS."""
    head = f"const {{ {', '.join(_MATH)} }} = Math;"
    parts = [_function(each) for each in (*routines(model, JAVASCRIPT), _places(model))]
    follow = ",\n".join(
        f"{json.dumps(s)}: [{', '.join(_way(function, s) for function in functions)}]"
        for s, functions in following(model).items()
    )
    return "\n".join([head, *parts, f"const WAYS = {{\n{follow}\n}};"]).replace("</", "<\\/")


def _function(made: Routine) -> str:
    arguments = ", ".join((*made.arguments, *made.results))
    return f"function {made.name}({arguments}) {{\n" + "\n".join(made.body) + "\n}"


def _places(model: Model) -> Routine:
    """Place and force of each part along body axes: x, y, z of the first, then of the next."""
    function = model.expression("places")
    arguments = [(name, ca.SX.sym(name, function.numel_in(k))) for k, name in enumerate("xup")]
    place, force = function(*(value for _, value in arguments))
    results = (("place", ca.vec(place.T)), ("force", ca.vec(force.T)))
    return routine("places", "", arguments, results, JAVASCRIPT)


def following(model: Model) -> dict[str, list[ca.Function]]:
    """Of every parameter that is reached from those of a model: functions by which it follows."""
    found: dict[str, list[ca.Function]] = {}
    wanted = [*model.parameters, *(s for s in model.states if s in PARAMETERS)]
    while wanted:
        s = wanted.pop()
        if s not in found:
            found[s] = list(_ways(model, s))
            wanted += [a for function in found[s] for a in function.name_in()]
    return found


def _ways(model: Model, s: str) -> Iterator[ca.Function]:
    """As `parameters.parameters_of` finds the value of a parameter."""
    own = f"{s}_follows"
    if model.name not in PACKS and own in model.functions:
        yield model.build(own)
    q = model.quantities.get(s)
    if s in PARAMETERS and (q is None or q.unit == PARAMETERS[s].unit):
        yield from map(build, ways(s))


def _way(function: ca.Function, s: str) -> str:
    """Names of what a parameter follows from, and how: ``[names, a => value]``."""
    inputs = function.name_in()
    arguments = [ca.SX.sym(name) for name in inputs]
    result = function.call(arguments)[function.name_out().index(s)]
    program = read(arguments, [result], [[text] for text in names("a", len(inputs))])
    body = " ".join(statements(program, JAVASCRIPT))
    value = written(program.results[0][0], JAVASCRIPT)
    return f"[{json.dumps(inputs)}, (a) => {{ {body} return {value}; }}]"
