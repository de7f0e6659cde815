"""Stand-in for the generated `names.py`, so that the other modules can be checked here."""

from typing import NamedTuple


class Signature(NamedTuple):
    """Order of the vectors of a model."""

    states: tuple[str, ...]
    dynamic: tuple[str, ...]
    inputs: tuple[str, ...]
    parameters: tuple[str, ...]
    outputs: tuple[str, ...]


class Kernel(NamedTuple):
    """Some states of a model; C files ..._ensemble and ..._trajectory integrate them."""

    model: str
    states: tuple[str, ...]


DIGEST = ""

MODELS: dict[str, Signature] = {}

#: Name of a function -> module, builder, C file.
FUNCTIONS: dict[str, tuple[str, str, str]] = {}

#: How the names of a kernel's C files begin -> what it carries.
KERNELS: dict[str, Kernel] = {}

#: Name of a function that has a kernel for many points -> C file.
SWEEPS: dict[str, str] = {}
