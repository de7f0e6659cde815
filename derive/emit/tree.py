"""The whole of `generated/`: the packs that ship, and the library that loads packs."""

from __future__ import annotations

from pathlib import Path

from .catalogue import packs
from .pack import pack_files, provenance

HERE = Path(__file__).resolve().parent
#: Support code that goes along as it stands.
SHIPPED = tuple(
    f"{name}.py"
    for name in (
        *("__init__", "compiler", "integrators", "intervals", "kernels", "library", "packs"),
        "version",
    )
)


def files() -> dict[str, str]:
    """Text of every generated file by its path within `generated/`."""
    texts = {name: f"# {provenance()}\n{(HERE / 'shipped' / name).read_text()}" for name in SHIPPED}
    for pack in packs():
        texts |= {f"{pack.name}/{path}": text for path, text in pack_files(pack).items()}
    return texts
