"""What an aircraft file may say: pydantic models made from the generated table of quantities.

The table, `names.QUANTITIES`, is the only schema: it has the names, units and signs of
everything an aircraft may be given. pydantic finds all mistakes and their places; what is left
is to put them into words. Whether the data agree is for `consistency`, file or not.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from difflib import get_close_matches
from functools import cache, reduce
from operator import getitem
from pathlib import Path
from typing import Annotated, Any, Generic, TypeVar

import pydantic
from pydantic import BeforeValidator, Field, FiniteFloat, PlainValidator
from pydantic_core import ErrorDetails, PydanticCustomError

from .aircraft import Source, parameter_symbols
from .aircraft_file import Place, packaged_files
from .errors import GroundrollError, UnexpectedError
from .names import QUANTITIES
from .units import expected, to_si

T = TypeVar("T")

#: What an aircraft may be given, by symbol and by name.
_KNOWN = {name: QUANTITIES[s] for s in parameter_symbols() for name in (s, QUANTITIES[s].name)}

#: Sign of a quantity -> its bound, and that in words.
_SIGNS = {
    ">0": (Field(gt=0), "a positive number"),
    ">=0": (Field(ge=0), "zero or a positive number"),
    "": (Field(), "a finite number"),
}


class Entry(pydantic.BaseModel, Generic[T], extra="forbid", strict=True):
    """A value with where it comes from, or just the value: ``mass = "1650 lb"``."""

    value: T
    source: str = ""
    estimate: bool = False

    @pydantic.model_validator(mode="before")
    @classmethod
    def _fields(cls, content: Any) -> Any:
        return content if isinstance(content, dict) else {"value": content}


@cache
def _number(unit: str, sign: str) -> type[Entry[float]]:
    """An entry whose value is a number in a unit that fits."""

    def si(value: Any) -> Any:
        return to_si(value, unit, "value") if isinstance(value, str) else value

    return Entry[Annotated[FiniteFloat, BeforeValidator(si), _SIGNS[sign][0]]]


def _fitted(value: Any, info: pydantic.ValidationInfo) -> Mapping[str, float]:
    """Tire parameters fitted to a table beside the aircraft file, or to a packaged one."""
    from .tire_fit import fit_tire

    path, packaged = Path(str(info.context)), packaged_files(".csv")
    beside = path.parent / str(value)
    table = beside if beside.is_file() else packaged.get(str(value).removesuffix(".csv"))
    if not isinstance(value, str) or table is None:
        wanted = f"a CSV file beside {path.name}, or a packaged one: {', '.join(packaged)}"
        raise UnexpectedError("table", repr(value), wanted)
    try:
        return fit_tire(table).parameters
    except GroundrollError as problem:
        found = f"{value!r}: {problem}"
        raise UnexpectedError("table", found, "a table that can be fitted") from None


def _group(content: Any) -> Any:
    """A table may have any name; what is none has a name that is misspelt."""
    if not isinstance(content, dict) or "value" in content:
        raise PydanticCustomError("unknown_key", "an unknown key")
    return content


_fields: dict[str, Any] = {name: (_number(q.unit, q.sign), None) for name, q in _KNOWN.items()}
_Quantities: Any = pydantic.create_model("_Quantities", **_fields)


class Table(_Quantities):  # type: ignore[misc]
    """Quantities by symbol or name, and further tables of them."""

    model_config = pydantic.ConfigDict(extra="allow", str_strip_whitespace=True)
    __pydantic_extra__: dict[str, Annotated[Table, BeforeValidator(_group)]]


class Tires(Table):
    """The main tires, which measured forces in a CSV file may describe."""

    table: Entry[Annotated[Mapping[str, float], PlainValidator(_fitted)]] | None = None


class File(Table):
    """The whole of an aircraft file."""

    title: str = ""
    description: str = ""
    source: str = ""
    main_tires: Tires | None = None


def validate(data: dict[str, Any], path: Path) -> tuple[File, list[tuple[Place, str, str]]]:
    """An aircraft file as far as it is right, and what is wrong with the rest of it.

    Parameters
    ----------
    data : dict
        What is in the file; entries with mistakes are taken out.
    path : Path
        Where it is, for the files beside it.

    Returns
    -------
    file : File
    mistakes : list of (place, found, expected)
    """
    try:
        return File.model_validate(data, context=path), []
    except pydantic.ValidationError as problem:
        errors = problem.errors(include_url=False)
    mistakes = [_mistake(error, data) for error in errors]
    # pydantic keeps nothing of a file with a mistake, and the rest may have others
    for (*tables, name), _, _ in mistakes:
        reduce(getitem, tables, data).pop(name, None)
    return File.model_validate(data, context=path), mistakes


def entries(
    table: Table, data: Mapping[str, Any], place: Place = ()
) -> Iterator[tuple[Place, str, float, Source]]:
    """Place, symbol, value and source of everything in a table with this content."""
    for name, content in table:
        here = (*place, name)
        if isinstance(content, Table):
            yield from entries(content, data[name], here)
        elif isinstance(content, Entry):
            written = _written(data[name], "value")
            if q := _KNOWN.get(name):
                source = Source(content.source, content.estimate, str(written).strip())
                yield here, q.symbol, content.value, source
            else:
                text = "; ".join(filter(None, (f"fitted to {written}", content.source)))
                for symbol, value in content.value.items():
                    yield here, symbol, value, Source(text, content.estimate)


def _written(entry: Any, field: str) -> Any:
    """A field of an entry; without fields an entry is its value."""
    return entry.get(field) if isinstance(entry, dict) else entry


def _mistake(error: ErrorDetails, data: Any) -> tuple[Place, str, str]:
    """Place of an entry, what was found there, and what was expected."""
    kind, place = error["type"], tuple(map(str, error["loc"]))
    if kind == "unknown_key":
        return place, "an unknown key", _nearest(place)
    if len(place) == 1:
        return place, repr(data[place[0]]), "a text" if kind == "string_type" else "a table"
    *entry, field = place
    if kind == "value_error":
        return tuple(entry), error["ctx"]["error"].found, error["ctx"]["error"].expected
    found = repr(_written(reduce(getitem, entry, data), field))
    near = get_close_matches(field, Entry.model_fields, n=1) or Entry.model_fields
    q = _KNOWN.get(entry[-1])
    wanted = expected(q.unit) if q else "a file name, such as 'tire.csv'"
    possible = _SIGNS[q.sign][1] if q else error["msg"]
    words = {
        "extra_forbidden": (f"an unknown field {field!r}", ", ".join(near)),
        "missing": ("no value", f"value = {wanted}"),
        "float_type": (found, wanted),
        "string_type": (f"source = {found}", "a text"),
        "bool_type": (f"estimate = {found}", "true or false"),
    }
    return tuple(entry), *words.get(kind, (found, possible))


def _nearest(place: Place) -> str:
    """The keys most like one that is unknown."""
    known = File.model_fields if len(place) == 1 else Table.model_fields
    near = get_close_matches(place[-1], known, n=3, cutoff=0.6)
    if place[-1] == "table":
        near = ["main_tires.table"]
    return " or ".join(near) or "one of those that `groundroll new` writes"
