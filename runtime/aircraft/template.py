"""A commented aircraft file to fill in, written from the table of quantities."""

from __future__ import annotations

import json
import shlex
from collections.abc import Iterable

from groundroll.base.wording import encodable
from groundroll.model.names import QUANTITIES, parameter_symbols
from groundroll.tires.size import surfaces

from .aircraft import FOLLOWS

#: Sections of an aircraft file: what goes in, and what to know about it.
_SECTIONS = {
    "airframe": (("m", "Izz", "Ap", "CL_gamma"), ""),
    "stations": (
        ("x_cg", "x_forward", "x_aft", "x_main", "x_tail", "x_nose", "h_cg"),
        "Behind any one datum, as on a weight-and-balance sheet; negative is ahead of it.\n"
        "A tricycle has its main gear behind the CG, a nose_wheel_station, from which the loads\n"
        "follow, and no tail wheel: tail_wheel_stiffness = 0.",
    ),
    "main_tires": (
        ("B3", "C3", "B5", "C5", "B1", "C1", "D1", "E1", "C_alpha"),
        "By measured forces (a CSV file beside this one, or a packaged one such as\n"
        "goodyear-6.00-6.csv), or by size and pressure, from which the rest follows as an\n"
        "estimate, or by parameters, or, if the linear tire will do, by stiffness.",
    ),
    "tail_wheel": (
        ("Ct", "K1", "K2", "K3", "K4"),
        "Stiffness, or the coefficients K of a polynomial from which it follows with the load,\n"
        "or size and pressure of its tire, from which it follows as an estimate.",
    ),
    "runway": (("u", "u_lift", "rho", "g"), "Tires are those of a dry runway if none is named."),
}

#: What is no quantity, or has a shorter name: value and meaning.
_WORDS = {
    "main_tires": (
        ("table", "?.csv", "measured forces"),
        ("size", "?", "such as 6.00-6, 8.00x4, 15x6.00-6, 380x150-5"),
        ("pressure", "? psi", "pressure in them"),
    ),
    "tail_wheel": (
        ("size", "?", "such as 2.80/2.50-4"),
        ("pressure", "? psi", "pressure in its tire"),
    ),
    "runway": (("surface", "?", f"one of {', '.join(surfaces())}"),),
}

#: What is the same for most, so that it stands there already.
_STANDARD = {
    "rho": ("1.225 kg/m^3", "ISO 2533, sea level"),
    "g": ("9.80665 m/s^2", "standard gravity"),
}

#: What stands there by another name, or comes with the size of a tire.
_OTHER_NAMES = frozenset(("p_tire", "p_tail", "C_z", "C_N"))

_REST = "follows"
_REST_TEXT = "What follows from the rest. Give it only if the rest is not known, or to override it."

_HEAD = """\
# {comment}: an aircraft file of groundroll.
#
# Take the # away from the lines that you know. A value is a number with a unit of your choice,
#     mass = "1650 lb"
# or with where it comes from, and whether it is only an estimate:
#     mass = {{ value = "1650 lb", source = "weighing of 3 May", estimate = false }}
# A bare number is in the unit beside the question mark. Then: groundroll check {file}

title = {title}
description = \"\"\"
\"\"\"
source = "" # the document that most numbers are from
"""


def template(name: str, file: str) -> str:
    """The text of an aircraft file with every key, commented out but for what is standard.

    Parameters
    ----------
    name : str
        Name of the aircraft.
    file : str
        Name of the file, for its instructions.
    """
    placed = {s for symbols, _ in _SECTIONS.values() for s in symbols}
    rest = [s for s in parameter_symbols() if s not in placed and s not in _OTHER_NAMES]
    title, command = quoted(name), quoted(shlex.quote(file))[1:-1]
    parts = [_HEAD.format(title=title, comment=title[1:-1], file=command)]
    parts += [_section(title, symbols, text) for title, (symbols, text) in _SECTIONS.items()]
    return "\n".join([*parts, _section(_REST, rest, _REST_TEXT)])


def section_of(s: str) -> tuple[str, str]:
    """In which table of an aircraft file a parameter stands, and under which name."""
    places = (title for title, (symbols, _) in _SECTIONS.items() if s in symbols)
    return next(places, _REST), QUANTITIES[s].name


def quoted(text: str) -> str:
    """A text as TOML writes it, on one line."""
    return json.dumps(encodable(text), ensure_ascii=False).replace("\x7f", "\\u007f")


def _section(title: str, symbols: Iterable[str], text: str) -> str:
    lines = [f"[{title}]", *(f"# {line}" for line in text.splitlines())]
    lines += [_line(key, value, "", text) for key, value, text in _WORDS.get(title, ())]
    for s in filter(parameter_symbols().__contains__, symbols):
        q = QUANTITIES[s]
        if s in _STANDARD:
            lines.append(_line(q.name, *_STANDARD[s], q.meaning).removeprefix("#"))
            continue
        value = "?" if q.unit == "1" else f"? {q.unit}"
        also = "; follows if not given" if s in FOLLOWS and title != _REST else ""
        lines.append(_line(q.name, value, "", f"{q.meaning}{also}"))
    return "\n".join(lines) + "\n"


def _line(key: str, value: str, source: str, meaning: str) -> str:
    return f'#{key} = {{ value = "{value}", source = "{source}" }} # {meaning}'
