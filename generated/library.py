# Generated from derive/ (digest f81e774fc1366460) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`.
"""Compiled functions by name: compiled on first use, cached by content, loaded as externals.

Set ``GROUNDROLL_CACHE`` to choose the cache folder and ``CC`` to choose the C compiler. Without
a compiler the same functions run in CasADi's virtual machine: the same numbers, slower.
"""

from __future__ import annotations

import atexit
import difflib
import hashlib
import importlib
import os
import shlex
import shutil
import subprocess
import sys
import tempfile
import warnings
from collections.abc import Sequence
from functools import cache
from pathlib import Path

import casadi as ca

from .names import DIGEST, FUNCTIONS

#: Contraction is off so that compiled code and virtual machine agree to the last bit or nearly so.
FLAGS = ("-O2", "-march=native", "-ffp-contract=off", "-fPIC", "-shared")
#: Folder of the C files.
SOURCES = Path(__file__).resolve().parent / "c"


class StaleError(RuntimeError):
    """C code and Python code come from different equations."""


class NoCompilerError(RuntimeError):
    """No C compiler that does what is asked; the message says what was tried."""


@cache
def load(name: str) -> ca.Function:
    """A generated function, compiled if there is a C compiler.

    Parameters
    ----------
    name : str
        One of `groundroll.generated.FUNCTIONS`, e.g. ``"nonlinear_rk45"``.

    Raises
    ------
    KeyError
        If there is no such function; the message names the nearest.
    StaleError
        If the C code does not belong to these equations.
    """
    source = SOURCES / f"{_entry(name)[2]}.c"
    try:
        return ca.external(name, str(compiled(source)))
    except NoCompilerError as problem:
        say_once(
            "compiler", f"{problem}; using CasADi's virtual machine, which is several times slower"
        )
        return build(name)


def build(name: str) -> ca.Function:
    """The function `name` in CasADi's virtual machine, from its Python source.

    Raises
    ------
    KeyError
        If there is no such function; the message names the nearest.
    """
    module, builder, _ = _entry(name)
    function: ca.Function = getattr(importlib.import_module(f".{module}", __package__), builder)()
    return function


def compiled(source: Path, flags: tuple[str, ...] = FLAGS) -> Path:
    """Path of the shared library of a C file, compiled now if it is not in the cache.

    The name of the library holds a hash of source, flags, compiler and processor, so a library
    is never rebuilt under a path that a running process may have loaded.

    Raises
    ------
    StaleError
        If the C code does not belong to these equations.
    NoCompilerError
        If it cannot be compiled, or not with these flags.
    """
    text = source.read_bytes()
    if DIGEST.encode() not in text[:400]:
        raise StaleError(f"{source} was not generated with this package; run `make derive`")
    compiler, target = _compiler(flags)
    key = hashlib.sha256(b"\0".join([text, " ".join(flags).encode(), target.encode()])).hexdigest()[
        :20
    ]
    library = _cache_folder() / f"{source.stem}-{key}.so"
    if not library.exists():
        _compile(compiler, flags, source, library)
    elif not _is_intact(library):
        warnings.warn(f"{library} is damaged; compiling it again", stacklevel=3)
        _compile(compiler, flags, source, library)
    return library


def _entry(name: str) -> tuple[str, str, str]:
    if name not in FUNCTIONS:
        near = difflib.get_close_matches(name, FUNCTIONS, n=3) or sorted(FUNCTIONS)
        raise KeyError(f"no generated function {name!r}; there is {', '.join(near)}")
    return FUNCTIONS[name]


@cache
def _compiler(flags: tuple[str, ...]) -> tuple[tuple[str, ...], str]:
    """Command of the C compiler, and its version and target processor as it describes them."""
    program, *options = shlex.split(os.environ.get("CC") or "cc")
    path = shutil.which(program)
    if path is None:
        raise NoCompilerError(f"no C compiler ({program} is not on the PATH; set CC)")
    command = (path, *options)
    return command, _run([*command, *flags, "-dM", "-E", "-x", "c", os.devnull])


def _run(command: Sequence[str]) -> str:
    """What a command prints; `NoCompilerError` if it fails."""
    try:
        result = subprocess.run(command, capture_output=True, text=True, check=False)
    except OSError as problem:
        raise NoCompilerError(f"{command[0]} cannot be run: {problem.strerror}") from problem
    if result.returncode != 0:
        raise NoCompilerError(f"{command[0]} failed: {result.stderr.strip()}")
    return result.stdout


def _compile(compiler: Sequence[str], flags: tuple[str, ...], source: Path, library: Path) -> None:
    """Compile beside the target and move into place, so that nobody sees half a library.

    Whoever sits at a terminal is told, because it may take seconds; over a line of patience.
    """
    if sys.stderr is not None and sys.stderr.isatty():
        print(f"\rcompiling {source.stem}, once for this machine", file=sys.stderr)
    with tempfile.TemporaryDirectory(dir=library.parent, prefix="build-") as folder:
        product = Path(folder) / library.name
        _run([*compiler, *flags, str(source), "-o", str(product), "-lm"])
        seal = _seal(product)
        seal.write_text(hashlib.sha256(product.read_bytes()).hexdigest())
        os.replace(seal, _seal(library))
        os.replace(product, library)


def _seal(library: Path) -> Path:
    return library.with_suffix(".sha256")


def _is_intact(library: Path) -> bool:
    try:
        return _seal(library).read_text() == hashlib.sha256(library.read_bytes()).hexdigest()
    except OSError:
        return False


@cache
def _cache_folder() -> Path:
    """The user's cache folder, or a temporary one for this process if that can't be written."""
    base = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    folder = Path(os.environ.get("GROUNDROLL_CACHE") or Path(base) / "groundroll").resolve()
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            return folder
    except OSError as problem:
        temporary = tempfile.mkdtemp(prefix="groundroll-")
        atexit.register(shutil.rmtree, temporary, ignore_errors=True)
        say_once(
            "cache",
            f"cannot write to the cache folder {folder} ({problem.strerror}); compiling for this"
            " process only. Set GROUNDROLL_CACHE to a folder that can be written",
        )
        return Path(temporary)


def say_once(topic: str, message: str) -> None:
    """Warn, but of each topic only once."""
    if topic not in _SAID:
        _SAID.add(topic)
        warnings.warn(message, RuntimeWarning, stacklevel=4)


_SAID: set[str] = set()
