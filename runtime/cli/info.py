"""``groundroll info``."""

from __future__ import annotations

import platform
import warnings
from collections.abc import Mapping
from importlib.metadata import version
from pathlib import Path
from typing import Any

import click

from . import options
from .output import Output, emit, paragraph, table


@click.command(name="info", epilog=options.example("groundroll info --format json"))
@click.argument("file", type=click.Path(dir_okay=False, path_type=Path), required=False)
@options.output
def command(file: Path | None, form: str, out: Path | None) -> None:
    """Versions, packaged aircraft and tires, models, and whether the code is compiled.

    Of a FILE that was kept with --out (.npz, .nc): what it holds, of which aircraft, and what
    that was computed with.
    """
    if file is not None:
        emit(_kept(file), form, out)
        return
    data = _data()
    emit(Output(_text(data), _rows(data), data), form, out)


def _kept(file: Path) -> Output:
    """What is in a file, also if other equations than those installed made it."""
    from groundroll.results.results import restored
    from groundroll.results.store import read

    record = read(file, other_equations=True)
    result = restored(record)
    made = dict(record.provenance)
    model, equations, now = made.pop("model"), made.pop("equations"), record.model.digest
    same = "as they are now" if equations == now else f"now they are others, {now}"
    versions = ", ".join(f"{name} {number}" for name, number in made.items())
    made_from = f"equations of the model {model}: {equations}, {same}"
    text = f"{result!r}\n\n{record.aircraft!r}\n\n{versions}\n{made_from}"
    parts: dict[str, Mapping[str, Any]] = {
        "about": record.about,
        "inputs": {name: column.values for name, (_, _, column) in record.inputs.items()},
        "arrays": {name: column.sizes for name, column in record.results.items()},
        "provenance": record.provenance,
    }
    rows = [["part", "name", "value"], ["file", record.kind, str(file)]]
    for part, values in parts.items():
        rows += [[part, name, _short(value)] for name, value in values.items()]
    head = {"file": str(file), "kind": record.kind, "aircraft": record.aircraft.name}
    return Output(text, rows, {**head, **parts})


def _short(value: Any) -> str:
    """A value in one cell: of an array its shape."""
    if getattr(value, "ndim", 0):
        return " x ".join(map(str, value.shape))
    return " x ".join(map(str, value.values())) if isinstance(value, dict) else str(value)


#: What a model is told by.
_GROUPS = ("states", "dynamic", "inputs", "parameters", "outputs")


def _data() -> dict[str, Any]:
    from groundroll.aircraft.aircraft import Aircraft, packaged
    from groundroll.model.names import DIGEST, MODELS
    from groundroll.tires.data import packaged_tables

    return {
        "versions": {name: version(name) for name in ("groundroll", "casadi", "numpy")}
        | {"python": platform.python_version()},
        "equations": DIGEST,
        "code": _code(),
        "aircraft": {name: Aircraft.load(name).title for name in packaged()},
        "tires": sorted(packaged_tables()),
        "models": {name: {g: getattr(m, g) for g in _GROUPS} for name, m in MODELS.items()},
    }


def _code() -> str:
    """Where the compiled functions are, or why there are none."""
    from groundroll import generated

    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        function = generated.load("linear_rhs")
    if said:
        return str(said[0].message)
    return f"compiled ({function.class_name()})"


def _text(data: dict[str, Any]) -> str:
    versions = ", ".join(f"{name} {number}" for name, number in data["versions"].items())
    models = [
        [name, ", ".join(model["states"]), ", ".join(model["inputs"]), ", ".join(model["outputs"])]
        for name, model in data["models"].items()
    ]
    return "\n\n".join(
        (
            f"{versions}\nequations {data['equations']}, {data['code']}",
            "Aircraft\n" + table(["name", "title"], [[*row] for row in data["aircraft"].items()]),
            "\n".join(["Tire tables", *map(paragraph, data["tires"])]),
            "Models\n" + table(["tire", "states", "inputs", "outputs"], models),
        )
    )


def _rows(data: dict[str, Any]) -> list[list[Any]]:
    rows = [["version", *item] for item in data["versions"].items()]
    rows += [["equations", "digest", data["equations"]], ["code", "", data["code"]]]
    rows += [["aircraft", *item] for item in data["aircraft"].items()]
    rows += [["tire", name, ""] for name in data["tires"]]
    return [["kind", "name", "value"], *rows]
