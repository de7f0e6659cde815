"""Stability derivatives as AVL prints them (command ``ST`` of the menu ``OPER``)."""

from __future__ import annotations

import math
import re
import tomllib
from pathlib import Path

from groundroll.aircraft.surfaces import held
from groundroll.base.errors import GroundrollError
from groundroll.base.files import text_of
from groundroll.model.names import PARAMETERS

from .taken import Found, Taken

#: ``CLa =   4.97``, with primes in some names; a number that is too large is stars.
_ENTRY = re.compile(r"([A-Za-z][\w']*)\s*=\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[EeDd][-+]?\d+)?|\*+|\S+)")
#: ``elevator     d02`` above a column of control derivatives.
_CONTROL = re.compile(r"([A-Za-z]\w*)\s+d(\d+)")
_HEADING = "Stability-axis derivatives"
_GEOMETRIC = "Geometric axis orientation"


def read_avl(path: Path) -> Found:
    """The derivatives in a file of AVL; those of controls by their names there.

    Raises
    ------
    GroundrollError
        If the file cannot be read or is no such file.
    """
    text = text_of(path, 2**20, "latin-1")
    if _HEADING not in text:
        raise GroundrollError(
            f"{path} is no .st file of AVL: found no {_HEADING!r}; write it with ST in OPER"
        )
    if _GEOMETRIC in text:
        raise GroundrollError(
            f"{path}: found {_GEOMETRIC!r}, in which signs are other ones; expected the standard"
            " one, X forward and Z down"
        )
    found = Found("", f"AVL, {path.name}")
    entries = _entries(path, text)
    known = tomllib.loads((Path(__file__).parent / "avl.toml").read_text(encoding="utf-8"))
    source = f"AVL, {path.name}"
    for name, s in known["by_radian"].items():
        if name in entries:
            found.take(Taken(s, entries[name], PARAMETERS[s].unit, f"{source}, {name}"))
        else:
            found.left.append(f"{source}: no {name}")
    alpha = math.radians(entries["Alpha"]) if "Alpha" in entries else None
    for total in known["total"]:
        if alpha is None or not {total["name"], total["slope"]} <= set(entries):
            found.left.append(f"{source}: {total['name']} at no angle of attack")
            continue
        value = float(f"{entries[total['name']] - alpha * entries[total['slope']]:.10g}")
        at = f"{source}, {total['name']} less {total['slope']} times Alpha"
        found.take(Taken(total["symbol"], value, "1", at))
    for control, number in _CONTROL.findall(text.partition(_HEADING)[2]):
        symbols = known["control"].get(control.lower())
        if symbols is None:
            found.left.append(f"{source}: control {control}, of which the model knows nothing")
            continue
        for coefficient, s in symbols.items():
            name = f"{coefficient}d{number}"
            if name in entries:
                found.take(Taken(s, entries[name], "1/deg", f"{source}, {name}: {control}"))
    surfaces = held(found.taken)
    found.take(*(Taken(s, 0.0, "1", f"the derivatives hold the {n}") for s, n in surfaces.items()))
    return found


def _entries(path: Path, text: str) -> dict[str, float]:
    """Every number by its name, the first of each."""
    found: dict[str, float] = {}
    for at, line in enumerate(text.splitlines(), 1):
        for name, written in _ENTRY.findall(line):
            plain = name.replace("'", "")
            try:
                value = float(written.upper().replace("D", "E"))
            except ValueError:
                if _is_known(plain):
                    raise GroundrollError(
                        f"{path}, line {at}: {name}: found {written!r}; expected a number"
                    ) from None
                continue
            if not math.isfinite(value):
                raise GroundrollError(f"{path}, line {at}: {name}: found {written!r}; not finite")
            found.setdefault(plain, value)
    return found


def _is_known(name: str) -> bool:
    """Whether it has the name of a coefficient."""
    return re.fullmatch(r"C[LYDlmn](?:[abpqr]|tot|d\d+)|Alpha", name) is not None
