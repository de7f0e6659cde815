"""``modelDescription.xml`` of a component, in versions 2.0 and 3.0 of FMI."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from importlib.metadata import version
from xml.etree import ElementTree as ET

from groundroll.base.units import exponents, from_si, kind
from groundroll.base.wording import encodable, visible

from .fmi_variables import Variable
from .subject import Subject

#: What both kinds of component can do.
_ABLE = {"canGetAndSetFMUState": "true", "canSerializeFMUState": "true"}
_STEPS = {"canHandleVariableCommunicationStepSize": "true"}
#: A roll of so long, s, in so many samples.
_EXPERIMENT = {"startTime": "0", "stopTime": "5", "stepSize": "0.01", "tolerance": "1e-10"}


def description(
    subject: Subject, variables: Sequence[Variable], fmi: str, identifier: str, token: str
) -> bytes:
    """The description as an XML file.

    Parameters
    ----------
    subject : Subject
    variables : sequence of Variable
    fmi : str
        ``"2.0"`` or ``"3.0"``.
    identifier : str
        Name of the compiled library.
    token : str
        By which library and description know that they belong together.
    """
    root = ET.Element("fmiModelDescription", _head(subject, variables, fmi, token))
    is_2 = fmi == "2.0"
    able = {_spelt(name, is_2): value for name, value in _ABLE.items()}
    able[f"providesDirectionalDerivative{'' if is_2 else 's'}"] = "true"
    for interface, more in (("ModelExchange", {}), ("CoSimulation", _STEPS)):
        element = ET.SubElement(root, interface, {"modelIdentifier": identifier, **more, **able})
        if is_2:
            ET.SubElement(ET.SubElement(element, "SourceFiles"), "File", name="all.c")
    _units(root, variables)
    _types(root, variables, is_2)
    categories = ET.SubElement(root, "LogCategories")
    ET.SubElement(categories, "Category", name="logStatusError", description="What cannot be done")
    ET.SubElement(root, "DefaultExperiment", _EXPERIMENT)
    listed = [v for v in variables if not (is_2 and v.causality == "independent")]
    _model_variables(root, listed, is_2)
    _structure(root, listed, is_2)
    return xml(root)


def xml(root: ET.Element) -> bytes:
    """An XML file."""
    ET.indent(root)
    head, text = '<?xml version="1.0" encoding="UTF-8"?>', ET.tostring(root, "unicode")
    return f"{head}\n{text}\n".encode()


def _spelt(name: str, is_2: bool) -> str:
    return name.replace("FMUState", "FMUstate") if is_2 else name


def _head(subject: Subject, variables: Sequence[Variable], fmi: str, token: str) -> dict[str, str]:
    is_2, plain = fmi == "2.0", all(v.name.isascii() for v in variables)
    return {
        "fmiVersion": fmi,
        "modelName": subject.model.name,
        "guid" if is_2 else "instantiationToken": token,
        "description": _text(f"{subject.title}. {subject.model.summary}"),
        "generationTool": f"groundroll {version('groundroll')}",
        "variableNamingConvention": "structured" if plain else "flat",
        **({"numberOfEventIndicators": "0"} if is_2 else {}),
    }


def _text(text: str) -> str:
    """A text that XML can hold."""
    return " ".join(visible(encodable(text)).split())


def _number(value: float) -> str:
    return repr(float(value))


# --- Units and types ---------------------------------------------------------------------------


def _units(root: ET.Element, variables: Iterable[Variable]) -> None:
    """Every unit with what it is made of, and what else it is shown in."""
    shown: dict[str, dict[str, None]] = {}
    for v in variables:
        others = shown.setdefault(v.unit, {})
        if v.shown_in:
            others[v.shown_in] = None
    definitions = ET.SubElement(root, "UnitDefinitions")
    for unit, others in shown.items():
        element = ET.SubElement(definitions, "Unit", name=unit)
        powers = {name: str(power) for name, power in exponents(unit).items()}
        ET.SubElement(element, "BaseUnit", powers)
        for other in others:
            factor = _number(from_si(1.0, unit, other))
            ET.SubElement(element, "DisplayUnit", name=other, factor=factor)


def _types(root: ET.Element, variables: Iterable[Variable], is_2: bool) -> None:
    definitions = ET.SubElement(root, "TypeDefinitions")
    for unit in dict.fromkeys(v.unit for v in variables):
        words = {"quantity": _type(unit), "unit": unit}
        if is_2:
            ET.SubElement(ET.SubElement(definitions, "SimpleType", name=_type(unit)), "Real", words)
        else:
            ET.SubElement(definitions, "Float64Type", {"name": _type(unit), **words})


def _type(unit: str) -> str:
    """Name of the type of a quantity: what it is, or its unit."""
    words = kind(unit).partition(" ")[2]
    return "".join(word.capitalize() for word in words.split()) or f"Quantity[{unit}]"


# --- Variables ---------------------------------------------------------------------------------


def _model_variables(root: ET.Element, variables: Sequence[Variable], is_2: bool) -> None:
    place = {v.reference: k for k, v in enumerate(variables, 1)}
    parent = ET.SubElement(root, "ModelVariables")
    for v in variables:
        about = {
            "name": _text(v.name),
            "valueReference": str(v.reference),
            "description": _text(v.description),
            "causality": v.causality,
            "variability": v.variability,
            "initial": v.initial,
        }
        number = {"declaredType": _type(v.unit), "unit": v.unit, "displayUnit": v.shown_in}
        if v.least is not None:
            number["min"] = _number(v.least)
        if v.start is not None:
            number["start"] = _number(v.start)
        if v.derivative is not None:
            number["derivative"] = str(place[v.derivative] if is_2 else v.derivative)
        about, number = ({k: x for k, x in each.items() if x} for each in (about, number))
        if is_2:
            ET.SubElement(ET.SubElement(parent, "ScalarVariable", about), "Real", number)
        else:
            ET.SubElement(parent, "Float64", about | number)


def _structure(root: ET.Element, variables: Sequence[Variable], is_2: bool) -> None:
    """Which variables are outputs, derivatives, and computed at the start, and from what."""
    place = {v.reference: k for k, v in enumerate(variables, 1)}
    outputs = [v for v in variables if v.causality == "output"]
    rates = [v for v in variables if v.derivative is not None]
    computed = [v for v in (*outputs, *rates) if v.initial == "calculated"]
    structure = ET.SubElement(root, "ModelStructure")
    groups = (
        ("Outputs", "Output", outputs, True),
        ("Derivatives", "ContinuousStateDerivative", rates, True),
        ("InitialUnknowns", "InitialUnknown", computed, False),
    )
    for title, single, group, tells in groups:
        parent = ET.SubElement(structure, title) if is_2 and group else structure
        for v in sorted(group, key=lambda v: v.reference):
            about = (
                {"index": str(place[v.reference])} if is_2 else {"valueReference": str(v.reference)}
            )
            if tells:
                known = (place[r] if is_2 else r for r in v.depends)
                about["dependencies"] = " ".join(map(str, known))
            ET.SubElement(parent, "Unknown" if is_2 else single, about)
