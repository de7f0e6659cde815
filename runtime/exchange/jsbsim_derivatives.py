"""Aerodynamic derivatives in JSBSim's functions, where they are constants or simple tables."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from xml.etree import ElementTree as ET

import numpy as np

from groundroll.base.arrays import FloatArray
from groundroll.base.errors import GroundrollError
from groundroll.base.units import to_si

from .jsbsim_xml import number, words


@dataclass(frozen=True)
class Derivative:
    """Part of a derivative: its symbol, value by radians, where from, whether it is exact."""

    symbol: str
    value: float
    source: str
    exact: bool


@dataclass(frozen=True)
class Table:
    """What a table is by, its points where all else is as in the roll, whether there is else."""

    by: str
    x: FloatArray
    y: FloatArray
    is_plain: bool


class NotSimpleError(GroundrollError):
    """A function that no derivative stands for."""


@dataclass
class _Product:
    """The factors of a function: constants, a table, a variable, and what is none of these."""

    constant: float = 1.0
    exact: bool = True
    tables: list[Table] = field(default_factory=list)
    variables: list[str] = field(default_factory=list)
    others: list[str] = field(default_factory=list)


def derivatives(
    axis: str, function: ET.Element, where: Mapping[str, float]
) -> Iterator[Derivative]:
    """The derivatives that a function of an axis stands for.

    Parameters
    ----------
    axis : str
    function : Element
    where : mapping of str to float
        Properties that are not zero in the ground roll.

    Raises
    ------
    NotSimpleError
        If there are none, saying why.
    """
    known, name = words(), function.get("name", "a function")
    factors = function.find("product")
    if axis not in known["axis"] or factors is None:
        raise NotSimpleError(f"{name}: no product along an axis of lift, drag, side or moment")
    found = _product(factors, name, where)
    if found.constant == 0:
        return
    if len(found.tables) > 1 or len(found.variables) > 1:
        raise NotSimpleError(f"{name}: a product of several tables or variables")
    table = found.tables[0] if found.tables else None
    is_curve = table is not None and not found.variables
    by = table.by if table and is_curve else "".join(found.variables)
    if by and by not in known["variable"]:
        raise NotSimpleError(f"{name}: a table in {by}")
    variable, unit = known["variable"].get(by, ("", "1"))
    _refuse_others(axis, variable, found, name)
    if table and is_curve:
        yield from _of_table(axis, name, variable, _per_radian(unit), found, table)
        return
    value = found.constant * _per_radian(unit)
    if table:
        value *= float(np.interp(where.get(table.by, 0.0), table.x, table.y))
    yield Derivative(_symbol(axis, variable, name), value, name, found.exact and not table)


def _product(factors: ET.Element, name: str, where: Mapping[str, float]) -> _Product:
    known, found = words(), _Product()
    for factor in factors:
        text = (factor.text or "").strip()
        if factor.tag == "table":
            found.tables.append(_table(factor, name, where))
        elif factor.tag == "value":
            found.constant *= number(factor, name)
        elif factor.tag == "property" and text in known["variable"]:
            found.variables.append(text)
        elif factor.tag == "property" and text.startswith(known["ground"]["prefix"]):
            found.exact = False
        elif factor.tag == "property" and text in known["same"]:
            found.others.append(known["same"][text])
            found.exact = False
        elif factor.tag != "description":
            found.others.append(text if factor.tag == "property" else f"<{factor.tag}>")
    return found


def _refuse_others(axis: str, variable: str, found: _Product, name: str) -> None:
    """Refuse a product that has other factors than make a coefficient a force or moment."""
    known = words()
    wanted = [*known["reference"][axis], *filter(None, [known["rate"].get(variable)])]
    odd = [f for f in found.others if f not in wanted]
    odd += [f"no {f}" for f in wanted if f not in found.others]
    if odd:
        raise NotSimpleError(f"{name}: {', '.join(odd)}")


def _of_table(
    axis: str, name: str, variable: str, per_radian: float, found: _Product, table: Table
) -> Iterator[Derivative]:
    """Slope and value at zero of a table in what a derivative is by; of lift, its maximum."""
    x, y, exact = table.x, found.constant * table.y, found.exact and table.is_plain
    known = words()["axis"][axis]
    if variable in known:
        ends = _around_zero(x)
        rise = np.diff(np.interp(ends, x, y))[0]
        slope = float(rise / (ends[1] - ends[0]))
        straight = np.allclose(y, np.interp(0.0, x, y) + slope * x, atol=1e-9 * abs(y).max())
        source = name if straight else f"{name}, slope at zero of its table"
        yield Derivative(known[variable], slope * per_radian, source, exact and bool(straight))
    at_zero = float(np.interp(0.0, x, y))
    if "" in known and variable == "alpha":
        yield Derivative(known[""], at_zero, f"{name}, its table at zero", exact)
    elif variable not in known:
        raise NotSimpleError(f"{name}: by {variable}, of which the model knows nothing")
    if axis == "LIFT" and variable == "alpha":
        yield Derivative("CL_max", float(y.max()), f"{name}, the maximum of its table", exact)


def _around_zero(x: FloatArray) -> FloatArray:
    """The points of a table on either side of zero, of those that it has."""
    after = min(max(int(np.searchsorted(x, 0.0, side="right")), 1), len(x) - 1)
    before = min(max(int(np.searchsorted(x, 0.0, side="left")) - 1, 0), len(x) - 2)
    return x[[before, after]]


def _symbol(axis: str, variable: str, name: str) -> str:
    known = words()["axis"][axis]
    if variable not in known:
        raise NotSimpleError(f"{name}: by {variable}, of which the model knows nothing")
    return str(known[variable])


def _per_radian(unit: str) -> float:
    return 1.0 if unit != "deg" else 1.0 / to_si("1 deg", "rad", "angle")


def _table(table: ET.Element, name: str, where: Mapping[str, float]) -> Table:
    variables = [
        (e.get("lookup", "row"), (e.text or "").strip()) for e in table.iter("independentVar")
    ]
    data = table.findall("tableData")
    if len(data) != 1 or not 1 <= len(variables) <= 2:
        raise NotSimpleError(f"{name}: a table in more than two variables, or none of its own")
    rows = [line.split("#")[0].split() for line in (data[0].text or "").splitlines()]
    try:
        numbers = [[float(cell) for cell in row] for row in rows if row]
    except ValueError:
        raise NotSimpleError(f"{name}: a table that holds no numbers") from None
    plain, along = len(variables) == 1, dict(variables)
    body = numbers if plain else numbers[1:]
    columns = [0.0] if plain else numbers[0] if numbers else []
    if len(body) < 2 or any(len(row) != 1 + len(columns) for row in body):
        raise NotSimpleError(f"{name}: a table without rows of one length")
    x, across = np.array([row[0] for row in body]), where.get(along.get("column", ""), 0.0)
    if not (np.diff(x) > 0).all() or not (np.diff(columns) > 0).all():
        raise NotSimpleError(f"{name}: a table that does not ascend")
    y = np.array([np.interp(across, columns, row[1:]) for row in body])
    if not np.isfinite([*x, *y]).all():
        raise NotSimpleError(f"{name}: a table that holds no numbers")
    return Table(along.get("row", variables[0][1]), x, y, plain)
