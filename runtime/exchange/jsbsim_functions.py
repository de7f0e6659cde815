"""What the air does to an aircraft, as functions of a JSBSim file, from a model's own equations."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from xml.etree import ElementTree as ET

import casadi as ca

from groundroll.base.errors import GroundrollError

from .program import Operation, Program, Value, read
from .subject import Subject

FOOT, POUND_FORCE, SLUG = 0.3048, 4.4482216152605, 14.593902937206364

#: State or parameter of the model -> property of JSBSim and by what it is multiplied.
_FLOWN = {
    "u": ("velocities/u-aero-fps", FOOT),
    "v": ("velocities/v-aero-fps", FOOT),
    "w": ("velocities/w-aero-fps", FOOT),
    "p": ("velocities/p-rad_sec", 1.0),
    "q": ("velocities/q-rad_sec", 1.0),
    "r": ("velocities/r-rad_sec", 1.0),
    "rho": ("atmosphere/rho-slugs_ft3", SLUG / FOOT**3),
}
#: The same of inputs; those that are no property of JSBSim's are properties of the file's own.
INPUTS = {
    "pedal": ("fcs/rudder-cmd-norm", -1.0),
    "rudder": ("fcs/rudder-pos-rad", 1.0),
    "aileron": ("fcs/left-aileron-pos-rad", 1.0),
    "elevator": ("fcs/elevator-pos-rad", 1.0),
    "thrust": ("groundroll/thrust-N", 1.0),
    "F_disturbance": ("groundroll/disturbance-N", 1.0),
}
#: Sums of forces and moments of the model, and the axes of JSBSim with their units.
_AXES = {
    "sum_Fx": ("X", POUND_FORCE),
    "sum_F": ("Y", POUND_FORCE),
    "sum_Fz": ("Z", POUND_FORCE),
    "sum_Mx": ("ROLL", POUND_FORCE * FOOT),
    "sum_My": ("PITCH", POUND_FORCE * FOOT),
    "sum_M": ("YAW", POUND_FORCE * FOOT),
}
#: So high above the runway, m, no wheel touches it.
_ALOFT = 1000.0

#: Operations of CasADi that JSBSim has, too.
_SAME = {
    ca.OP_ADD: "sum",
    ca.OP_SUB: "difference",
    ca.OP_MUL: "product",
    ca.OP_DIV: "quotient",
    ca.OP_SQRT: "sqrt",
    ca.OP_EXP: "exp",
    ca.OP_LOG: "ln",
    ca.OP_POW: "pow",
    ca.OP_CONSTPOW: "pow",
    ca.OP_SIN: "sin",
    ca.OP_COS: "cos",
    ca.OP_TAN: "tan",
    ca.OP_ASIN: "asin",
    ca.OP_ACOS: "acos",
    ca.OP_ATAN: "atan",
    ca.OP_ATAN2: "atan2",
    ca.OP_FABS: "abs",
    ca.OP_SIGN: "sign",
    ca.OP_FMIN: "min",
    ca.OP_FMAX: "max",
    ca.OP_LT: "lt",
    ca.OP_LE: "le",
    ca.OP_EQ: "eq",
    ca.OP_NE: "nt",
    ca.OP_AND: "and",
    ca.OP_OR: "or",
    ca.OP_NOT: "not",
}


def aerodynamics(subject: Subject) -> ET.Element:
    """The section of the file: forces and moments of the air and of what pushes, at the CG.

    They are what the model sums where no wheel touches the ground and nothing has a weight.
    """
    model, parameters = subject.model, {**subject.parameters, "g": 0.0}
    flown = {s: ca.SX.sym(s) for s in (*_FLOWN, *INPUTS)}

    def given(symbols: tuple[str, ...], others: Mapping[str, float]) -> ca.SX:
        return ca.vertcat(*(flown[s] if s in flown else others.get(s, 0.0) for s in symbols))

    shown = model.expression("outputs")(
        given(model.states, {"Z": -_ALOFT}),
        given(model.inputs, {}),
        given(model.parameters, parameters),
    )
    symbols = [*_AXES, *(s for s in model.outputs if s not in _AXES)]
    results = [shown[model.outputs.index(s)] for s in symbols]
    program = read([ca.vertcat(*flown.values())], results, [list(flown)])
    sums, others = program.results[: len(_AXES)], program.results[len(_AXES) :]
    names = {value: s for s, (value,) in zip(symbols[len(_AXES) :], others, strict=True)}
    return _Written(program, {k: s for k, s in names.items() if isinstance(k, int)}).section(
        {axis: value for axis, (value,) in zip(_AXES.values(), sums, strict=True)}
    )


@dataclass(frozen=True)
class _Written:
    """A program as functions of JSBSim: each operation that is used twice has a property.

    Attributes
    ----------
    program : Program
    outputs : mapping of int to str
        What the model calls the result of an operation.
    """

    program: Program
    outputs: Mapping[int, str]

    def section(self, axes: Mapping[tuple[str, float], Value]) -> ET.Element:
        """The functions and the axes."""
        needed = self._needed([value for value in axes.values() if isinstance(value, int)])
        uses = Counter(v for k in needed for v in self._taken(k))
        uses.update(axes.values())
        names = {
            k: f"groundroll/{self.outputs.get(k, f'part-{k}')}"
            for k in needed
            if uses[k] > 1 or k in self.outputs
        }
        root = ET.Element("aerodynamics")
        for s, (target, factor) in {**_FLOWN, **INPUTS}.items():
            if uses[s]:
                self._function(root, f"groundroll/{s}", _scaled(_leaf(target), factor))
        for k in sorted(names):
            self._function(root, names[k], self._operation(k, names))
        for (axis, unit), value in axes.items():
            at = ET.SubElement(root, "axis", name=axis)
            body = _scaled(self._value(value, names), 1 / unit)
            self._function(at, f"groundroll/{axis.lower()}", body)
        return root

    @staticmethod
    def _function(parent: ET.Element, name: str, body: ET.Element) -> None:
        ET.SubElement(parent, "function", name=name).append(body)

    def _needed(self, ends: list[int]) -> set[int]:
        found: set[int] = set()
        while ends:
            k = ends.pop()
            if k not in found:
                found.add(k)
                ends += [v for v in self.program.operations[k].values if isinstance(v, int)]
        return found

    def _taken(self, k: int) -> list[Value]:
        """What an operation takes; a square takes it twice."""
        code, values = self.program.operations[k]
        return [*values, *values] if code == ca.OP_SQ else list(values)

    def _value(self, value: Value, names: Mapping[int, str]) -> ET.Element:
        if isinstance(value, float):
            return _number(value)
        if isinstance(value, str):
            return _leaf(f"groundroll/{value}")
        return _leaf(names[value]) if value in names else self._operation(value, names)

    def _operation(self, k: int, names: Mapping[int, str]) -> ET.Element:
        operation = self.program.operations[k]
        tag, values = _form(operation)
        found = ET.Element(tag)
        found.extend([self._value(v, names) for v in values])
        return found


def _form(operation: Operation) -> tuple[str, tuple[Value, ...]]:
    """What JSBSim calls an operation, and what it is done to."""
    code, values = operation
    if code in _SAME:
        return _SAME[code], values
    others: dict[int, tuple[str, tuple[Value, ...]]] = {
        ca.OP_SQ: ("product", (*values, *values)),
        ca.OP_TWICE: ("product", (2.0, *values)),
        ca.OP_NEG: ("product", (-1.0, *values)),
        ca.OP_INV: ("quotient", (1.0, *values)),
        ca.OP_IF_ELSE_ZERO: ("ifthen", (*values, 0.0)),
    }
    if code not in others:
        raise GroundrollError(f"the model uses operation {code} of CasADi, which JSBSim lacks")
    return others[code]


def _leaf(target: str) -> ET.Element:
    found = ET.Element("property")
    found.text = target
    return found


def _number(value: float) -> ET.Element:
    found = ET.Element("value")
    found.text = repr(value)
    return found


def _scaled(body: ET.Element, factor: float) -> ET.Element:
    found = ET.Element("product")
    found.extend([body, _number(factor)])
    return found
