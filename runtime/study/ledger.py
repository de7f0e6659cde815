"""Every printed cell beside the computed value, with a verdict."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal
from functools import partial
from itertools import permutations
from typing import Any

from groundroll.aircraft.aircraft import Aircraft
from groundroll.base.units import from_si
from groundroll.model.names import QUANTITIES

from .cases import Case, case, tire_fit, tire_fit_in_pounds
from .sources import Column, Coverage, Table, Tolerance, errata, setup, tables

VERDICTS = ("agrees", "explained", "differs")


@dataclass(frozen=True)
class Cell:
    """A printed value beside the computed one.

    Attributes
    ----------
    table : str
        Number of the table.
    row : str
        Trial number or symbol.
    trial : int or None
        Trial number.
    model : str
        ``"linear"``, ``"nonlinear"`` or, of parameters, empty.
    quantity, label, unit : str
        What it is, for programs and for people, and the unit of both values.
    as_printed : str
        The digits of the print; ``"N/A"`` where it has none.
    printed, computed : float or None
        None where there is no value: unstable, or no overshoot.
    verdict : str
        ``"agrees"``, ``"explained"`` by an erratum, or ``"differs"``.
    erratum : int or None
        Number of the erratum that explains it.
    see : int or None
        Number of an erratum that speaks of the cell although it agrees.
    reproduced : float or None
        Where the erratum says how the print came about: what that gives.
    """

    table: str
    row: str
    trial: int | None
    model: str
    quantity: str
    label: str
    unit: str
    as_printed: str
    printed: float | None
    computed: float | None
    verdict: str
    erratum: int | None = None
    see: int | None = None
    reproduced: float | None = None


def ledger(numbers: Sequence[str] | None = None) -> tuple[Cell, ...]:
    """All cells of the tables, or of some, in the order of the thesis."""
    chosen = tables() if numbers is None else {n: tables()[n] for n in numbers}
    return tuple(cell for table in chosen.values() for cell in _KINDS[table.kind](table))


def count(cells: Sequence[Cell]) -> dict[str, int]:
    """Number of cells for each verdict."""
    found = Counter(cell.verdict for cell in cells)
    return {verdict: found[verdict] for verdict in VERDICTS}


def judge(
    as_printed: str,
    computed: float,
    tolerance: Tolerance,
    *,
    last_digit: float | None = None,
    none_means: float | None = None,
) -> bool:
    """Whether a computed value agrees with the print.

    Parameters
    ----------
    as_printed : str
        The printed digits; empty for N/A.
    computed : float
        NaN where there is no value.
    tolerance : Tolerance
        How far is too far.
    last_digit : float, optional
        Worth of the last printed digit, if the text does not show it.
    none_means : float, optional
        Value that a printed N/A may stand for.
    """
    if not as_printed:
        return math.isnan(computed) or (
            none_means is not None and tolerance.allows(none_means, computed, 0.0)
        )
    if math.isnan(computed):
        return False
    step = worth(as_printed) if last_digit is None else last_digit
    return tolerance.allows(float(as_printed), computed, step)


def worth(as_printed: str) -> float:
    """Worth of the last printed digit: 0.001 for ``"441.630"``."""
    return float(Decimal(1).scaleb(-decimals(as_printed)))


def decimals(as_printed: str) -> int:
    """Digits after the decimal point, an exponent included: 3 for ``"441.630"``."""
    return -int(Decimal(as_printed).as_tuple().exponent)


def _of_trials(table: Table) -> Iterator[Cell]:
    for row in table.rows:
        subject = case(int(row["trial"]), table.model)
        values = _values(table, subject, row)
        for column in table.columns:
            as_printed = row[column.key]
            agrees = judge(
                as_printed,
                values[column.key],
                column.tolerance,
                last_digit=_last_digit(row, column),
                none_means=_NONE_MEANS.get(column.quantity),
            )
            reading = {name: partial(read, subject) for name, read in _CASE_READINGS.items()}
            yield _cell(
                table, row["trial"], column, as_printed, values[column.key], agrees, reading
            )


def _of_symbols(table: Table, value: Callable[[str, str], float]) -> Iterator[Cell]:
    for row in table.rows:
        symbol, as_printed, unit = (
            row["symbol"],
            row.get("printed", row.get("value", "")),
            row["unit"],
        )
        label = table.labels.get(symbol, symbol)
        column = Column(symbol, _full_name(table, symbol), label, unit, table.tolerance)
        computed = value(symbol, unit)
        agrees = judge(as_printed, computed, table.tolerance)
        reading = {name: partial(read, symbol, unit) for name, read in _TIRE_READINGS.items()}
        yield _cell(table, symbol, column, as_printed, computed, agrees, reading)


def _of_aircraft(table: Table) -> Iterator[Cell]:
    plane = Aircraft.load(setup().aircraft).replace(**table.changes)

    def value(symbol: str, unit: str) -> float:
        own = table.symbols.get(symbol, symbol)
        return table.multiples.get(symbol, 1) * _in_unit(float(plane[own]), own, unit)

    return _of_symbols(table, value)


def _of_tire_fit(table: Table) -> Iterator[Cell]:
    def value(symbol: str, unit: str) -> float:
        return _in_unit(tire_fit().parameters[symbol], symbol, unit)

    return _of_symbols(table, value)


_KINDS: Mapping[str, Callable[[Table], Iterator[Cell]]] = {
    "trials": _of_trials,
    "aircraft": _of_aircraft,
    "tire-fit": _of_tire_fit,
}

#: "Since there are no oscillations, the peak overshoot is 0 %" (Section 4.5.6, of a printed N/A).
_NONE_MEANS = {"overshoot": 0.0}

#: How the print came about, by the name that an erratum gives it.
_CASE_READINGS: Mapping[str, Callable[[Case], float]] = {
    "entry_before_last": Case.entry_before_last,
}
_TIRE_READINGS: Mapping[str, Callable[[str, str], float]] = {
    "fit_in_pounds": lambda symbol, unit: _in_unit(
        tire_fit_in_pounds().parameters[symbol], symbol, unit
    ),
}


def _cell(
    table: Table,
    row: str,
    column: Column,
    as_printed: str,
    computed: float,
    agrees: bool,
    readings: Mapping[str, Callable[[], float]],
) -> Cell:
    erratum, cover = _covering(table.number, row, column.quantity)
    reproduced = readings[cover.reading]() if cover and cover.reading else None
    explained = cover is not None and _explains(
        cover, row, column, as_printed, computed, reproduced
    )
    verdict = "agrees" if agrees else "explained" if explained else "differs"
    return Cell(
        table=table.number,
        row=row,
        trial=int(row) if row.isdigit() else None,
        model=table.model,
        quantity=column.quantity,
        label=column.label,
        unit=column.unit,
        as_printed=as_printed or "N/A",
        printed=float(as_printed) if as_printed else None,
        computed=None if math.isnan(computed) else computed,
        verdict=verdict,
        erratum=erratum if verdict == "explained" else None,
        see=erratum if verdict == "agrees" else None,
        reproduced=reproduced if verdict == "explained" else None,
    )


def _covering(table: str, row: str, quantity: str) -> tuple[int | None, Coverage | None]:
    """The erratum that speaks of a cell, and what it says of it."""
    for erratum in errata().values():
        cover = erratum.coverage(table, row, quantity)
        if cover is not None:
            return erratum.number, cover
    return None, None


def _explains(
    cover: Coverage,
    row: str,
    column: Column,
    as_printed: str,
    computed: float,
    reproduced: float | None,
) -> bool:
    """Whether an erratum has the computed value right, and its reading gives the print."""
    is_right = judge(cover.right[row], computed, Tolerance(digits=1))
    return is_right and (reproduced is None or judge(as_printed, reproduced, column.tolerance))


def _values(table: Table, subject: Case, row: Mapping[str, str]) -> dict[str, float]:
    """Computed values by the columns of a table."""
    pair = _matched_eigenvalues(subject, row) if "eig1_re" in row else ()
    parts = dict(zip(_EIGENVALUES, pair, strict=True)) if pair else {}
    return {
        column.key: parts[column.key]
        if column.key in parts
        else _QUANTITIES[column.quantity](subject, column.unit)
        for column in table.columns
    }


_EIGENVALUES = ("eig1_re", "eig1_im", "eig2_re", "eig2_im")


def _matched_eigenvalues(subject: Case, row: Mapping[str, str]) -> tuple[float, ...]:
    """Real and imaginary parts in the order that the row prints them in."""
    printed = [float(row[key]) for key in _EIGENVALUES]
    orders = [
        tuple(float(part) for value in order for part in (value.real, value.imag))
        for order in permutations(subject.linearization.eigenvalues)
    ]
    return min(orders, key=lambda parts: math.dist(parts, printed))


def _last_digit(row: Mapping[str, str], column: Column) -> float | None:
    """An eigenvalue printed as a bare 0 is meant as exactly as the rest of its row."""
    if column.key in _EIGENVALUES and row[column.key] == "0":
        return min(worth(row[key]) for key in _EIGENVALUES)
    return worth(row[column.key]) if row[column.key] else None


def _parameter(symbol: str) -> Callable[[Case, str], float]:
    return lambda subject, unit: _in_unit(float(subject.plane[symbol]), symbol, unit)


def _metric(name: str, factor: float = 1.0) -> Callable[[Case, str], float]:
    return lambda subject, unit: factor * float(getattr(subject.metrics, name))


def _rotation(subject: Case, unit: str) -> float:
    return _in_unit(float(subject.metrics.rotation), "theta", unit)


def _tail_wheel_stiffness(subject: Case, unit: str) -> float:
    """From its curve over load, at the share of the static load that the trial stands for."""
    static = subject.plane.replace(f=None)["F_tail_load"]
    load = (subject.trial.tail_load or 0.0) * static
    return _in_unit(float(subject.plane.replace(Ct=None, F_tail_load=load)["Ct"]), "Ct", unit)


_QUANTITIES: Mapping[str, Callable[[Case, str], float]] = {
    "main_gear_arm": _parameter("a"),
    "tail_arm": _parameter("b"),
    "cg_station": _parameter("x_cg"),
    "cornering_stiffness": _parameter("C_alpha"),
    "tail_wheel_stiffness": _tail_wheel_stiffness,
    "steady_displacement": _metric("displacement"),
    "steady_rotation": _rotation,
    "time_constant": lambda subject, unit: subject.time_constant(),
    "settling_time": _metric("settling_time"),
    "rise_time": _metric("rise_time"),
    "overshoot": _metric("overshoot", 100.0),
}


def _in_unit(value: float, symbol: str, unit: str) -> float:
    own = QUANTITIES[symbol].unit
    return value if unit == own else from_si(value, own, unit)


def _full_name(table: Table, symbol: str) -> str:
    own = table.symbols.get(symbol, symbol)
    return QUANTITIES[own].name if own in QUANTITIES else symbol


def rows(cells: Sequence[Cell]) -> list[dict[str, Any]]:
    """The cells as plain rows, numbers to eight significant digits."""
    return [
        {
            "table": cell.table,
            "trial": cell.trial,
            "row": cell.row,
            "model": cell.model or None,
            "quantity": cell.quantity,
            "unit": cell.unit,
            "printed": cell.printed,
            "as_printed": cell.as_printed,
            "computed": _rounded(cell.computed),
            "verdict": cell.verdict,
            "erratum": cell.erratum,
            "see": cell.see,
            "reproduced": _rounded(cell.reproduced),
        }
        for cell in cells
    ]


def _rounded(value: float | None) -> float | None:
    """To eight significant digits; what is only rounding noise becomes zero."""
    if value is None:
        return None
    return 0.0 if abs(value) < 1e-12 else float(f"{value:.8g}")
