"""What an aircraft file may say: pydantic models made from the generated table of quantities.

The table, `names.QUANTITIES`, is the only schema: it has the names, units and signs of
everything an aircraft may be given. pydantic finds all mistakes and their places; what is left
is to put them into words. Whether the data agree is for `consistency`, file or not.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from difflib import get_close_matches
from functools import cache, reduce
from operator import getitem
from pathlib import Path
from typing import Annotated, Any, Generic, TypeVar

import pydantic
from pydantic import BeforeValidator, Field, FiniteFloat, PlainValidator
from pydantic_core import ErrorDetails, PydanticCustomError

from groundroll.base.errors import MOST_MISTAKES, GroundrollError, UnexpectedError, shown
from groundroll.base.units import expected, to_si
from groundroll.model.names import QUANTITIES, parameter_symbols
from groundroll.tires.data import packaged_tables
from groundroll.tires.size import Implied, friction_on, of_main_tires, of_tail_tire

from .source import Place, Source

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


def _fitted(value: Any, info: pydantic.ValidationInfo) -> tuple[Implied, ...]:
    """Tire parameters fitted to a table beside the aircraft file, or to a packaged one."""
    from groundroll.tires.fit import fit_tire

    path, packaged = Path(str(info.context)), packaged_tables()
    beside = path.parent / str(value)
    file = beside if beside.is_file() else packaged.get(str(value).removesuffix(".csv"))
    if not isinstance(value, str) or file is None:
        wanted = f"a CSV file beside {path.name}, or a packaged one: {', '.join(packaged)}"
        raise UnexpectedError("table", shown(value), wanted)
    try:
        parameters = fit_tire(file).parameters
        return tuple(Implied(s, x, f"fitted to {value}") for s, x in parameters.items())
    except GroundrollError as problem:
        found = f"{shown(value)}: {problem}"
        raise UnexpectedError("table", found, "a table that can be fitted") from None


def _sized(of: Callable[[str], Iterable[Implied]]) -> Callable[[Any], tuple[Implied, ...]]:
    """What the size of a tire says."""

    def implied(value: Any) -> tuple[Implied, ...]:
        if not isinstance(value, str):
            raise UnexpectedError("size", repr(value), "a size in quotes, such as '6.00-6'")
        return tuple(of(value))

    return implied


def _surface(value: Any) -> str:
    friction_on(value if isinstance(value, str) else repr(value))
    return str(value)


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


_Implied = tuple[Implied, ...]
_Pressure: Any = _number("N/m^2", ">0")


class Tires(Table):
    """The main tires, which measured forces in a CSV file may describe, or size and pressure."""

    table: Entry[Annotated[_Implied, PlainValidator(_fitted)]] | None = None
    size: Entry[Annotated[_Implied, PlainValidator(_sized(of_main_tires))]] | None = None
    pressure: _Pressure | None = None
    rated_pressure: _Pressure | None = None


class TailWheel(Table):
    """The tail wheel, which the size and the pressure of its tire may describe."""

    size: Entry[Annotated[_Implied, PlainValidator(_sized(of_tail_tire))]] | None = None
    pressure: _Pressure | None = None


class Runway(Table):
    """The runway, whose surface scales the friction of the main tires."""

    surface: Entry[Annotated[str, PlainValidator(_surface)]] | None = None


#: What to write for an entry that is no number.
_EXAMPLES = {
    "table": "a file name, such as 'tire.csv'",
    "size": "a size, such as '6.00-6'",
    "surface": "a surface, such as 'wet'",
}

#: The tables that know more than quantities.
_TABLES = {"main_tires": Tires, "tail_wheel": TailWheel, "runway": Runway}

#: Quantities that have another name where it is plain what they are of.
_SHORT = {
    ("main_tires", "pressure"): "p_tire",
    ("main_tires", "rated_pressure"): "p_rated",
    ("tail_wheel", "pressure"): "p_tail",
}


class File(Table):
    """The whole of an aircraft file."""

    title: str = ""
    description: str = ""
    source: str = ""
    parameters: dict[str, Entry[float | str]] = Field(default_factory=dict)
    main_tires: Tires | None = None
    tail_wheel: TailWheel | None = None
    runway: Runway | None = None


def validate(data: dict[str, Any], path: Path) -> tuple[File, list[tuple[Place, str, str]], int]:
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
    more : int
        How many there are beside these.
    """
    try:
        return File.model_validate(data, context=path), [], 0
    except pydantic.ValidationError as problem:
        errors = problem.errors(include_url=False)
    mistakes = [_mistake(error, data) for error in errors[:MOST_MISTAKES]]
    # pydantic keeps nothing of a file with a mistake, and the rest may have others
    for *tables, name in map(_place, errors):
        reduce(getitem, tables, data).pop(name, None)
    return File.model_validate(data, context=path), mistakes, len(errors) - len(mistakes)


def entries(
    table: Table, data: Mapping[str, Any], place: Place = ()
) -> Iterator[tuple[Place, str, float, Source]]:
    """Place, symbol, value and source of everything in a table with this content."""
    for name, content in table:
        if name == "parameters" and not place:
            continue  # of a model of the user's own
        here = (*place, name)
        if isinstance(content, Table):
            yield from entries(content, data[name], here)
        elif isinstance(content, Entry) and (q := _quantity(here)):
            written = str(_written(data[name], "value")).strip()
            yield here, q.symbol, content.value, Source(content.source, content.estimate, written)
        elif isinstance(content, Entry) and name == "table":
            for each in content.value:
                text = "; ".join(filter(None, (each.text, content.source)))
                yield here, each.symbol, each.value, Source(text, content.estimate)


def implied(file: File) -> Iterator[tuple[Place, str, float, Source]]:
    """The same of what sizes of tires say, which holds where nothing else is said."""
    for name, table in (("main_tires", file.main_tires), ("tail_wheel", file.tail_wheel)):
        if table is not None and table.size is not None:
            for each in table.size.value:
                yield (name, "size"), each.symbol, each.value, Source(each.text, estimate=True)


def surface(file: File) -> str:
    """The surface of the runway, empty if none is named."""
    entry = file.runway and file.runway.surface
    return entry.value if entry else ""


def _quantity(place: Place) -> Any:
    """The quantity of that name in that table, if it is one."""
    return QUANTITIES[_SHORT[place]] if place in _SHORT else _KNOWN.get(place[-1])


def _written(entry: Any, field: str) -> Any:
    """A field of an entry; without fields an entry is its value."""
    return entry.get(field) if isinstance(entry, dict) else entry


def _place(error: ErrorDetails) -> Place:
    """Where the entry with a mistake stands."""
    whole = tuple(map(str, error["loc"]))
    return whole if error["type"] == "unknown_key" or len(whole) == 1 else whole[:-1]


def _mistake(error: ErrorDetails, data: Any) -> tuple[Place, str, str]:
    """Place of an entry, what was found there, and what was expected."""
    kind, place = error["type"], _place(error)
    if kind == "unknown_key":
        return place, "an unknown key", _nearest(place)
    if len(error["loc"]) == 1:
        return place, shown(data[place[0]]), "a text" if kind == "string_type" else "a table"
    entry, field = place, str(error["loc"][-1])
    if kind == "value_error":
        return entry, error["ctx"]["error"].found, error["ctx"]["error"].expected
    found = shown(_written(reduce(getitem, entry, data), field))
    near = get_close_matches(field, Entry.model_fields, n=1) or Entry.model_fields
    q = _quantity(tuple(entry))
    wanted = expected(q.unit) if q else _EXAMPLES.get(entry[-1], "a text")
    possible = _SIGNS[q.sign][1] if q else error["msg"]
    words = {
        "extra_forbidden": (f"an unknown field {field!r}", ", ".join(near)),
        "missing": ("no value", f"value = {wanted}"),
        "float_type": (found, wanted),
        "string_type": (f"source = {found}", "a text"),
        "bool_type": (f"estimate = {found}", "true or false"),
    }
    return entry, *words.get(kind, (found, possible))


def _nearest(place: Place) -> str:
    """The keys most like one that is unknown."""
    table = File if len(place) == 1 else _TABLES.get(place[0], Table)
    near = get_close_matches(place[-1], table.model_fields, n=3, cutoff=0.6)
    if place[-1] == "table":
        near = ["main_tires.table"]
    return " or ".join(near) or "one of those that `groundroll new` writes"
