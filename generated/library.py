# Generated from derive/ with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`.
"""Compiled functions by name: compiled on first use, cached by content, loaded as externals.

Set ``GROUNDROLL_CACHE`` to choose the cache folder and ``CC`` to choose the C compiler. Without
a compiler the same functions run in CasADi's virtual machine: the same numbers, slower.
"""

from __future__ import annotations

import atexit
import errno
import hashlib
import os
import shutil
import sys
import tempfile
import time
import warnings
from collections.abc import Sequence
from functools import cache
from pathlib import Path

from .compiler import NoCompilerError, compiler, make

#: Contraction is off so that compiled code and virtual machine agree to the last bit or nearly so.
FLAGS = ("-O2", "-march=native", "-ffp-contract=off", "-fPIC", "-shared")
#: Seconds after which a folder that somebody compiled in was left behind by a killed process.
_LEFT = 3600.0


class StaleError(RuntimeError):
    """C code and Python code come from different equations."""


def compiled(source: Path, digest: str, flags: tuple[str, ...] = FLAGS, *, symbol: str) -> Path:
    """Path of the shared library of a C file, compiled now if it is not in the cache.

    The name of the library holds a hash of source, flags, compiler, processor and C library, so a
    library is never rebuilt under a path that a running process may have loaded. It is in the cache
    only once a process has loaded it and found the function `symbol`.

    Raises
    ------
    StaleError
        If the C code does not belong to these equations.
    NoCompilerError
        If it cannot be compiled, or not with these flags, or what was compiled cannot be loaded.
    """
    text = source.read_bytes()
    if digest.encode() not in text[:400]:
        raise StaleError(
            f"{source} does not belong to the equations of its pack; run `make derive`, or"
            " `groundroll derive` for a model of your own"
        )
    command, target = compiler(flags)
    parts = (text, *(part.encode() for part in (" ".join(flags), target)))
    key = hashlib.sha256(b"\0".join(parts)).hexdigest()[:20]
    library = _cache_folder() / f"{source.parent.parent.name}-{source.stem}-{key}.so"
    if not library.exists():
        _compile(command, flags, source, library, symbol)
    elif not _is_intact(library):
        warnings.warn(f"{library} is damaged; compiling it again", stacklevel=3)
        _compile(command, flags, source, library, symbol)
    return library


def _compile(
    command: Sequence[str], flags: tuple[str, ...], source: Path, library: Path, symbol: str
) -> None:
    """Compile beside the target and move into place, so that nobody sees half a library.

    Whoever sits at a terminal is told, because it may take seconds; over a line of patience.
    """
    if sys.stderr is not None and sys.stderr.isatty():
        what = f"{source.parent.parent.name} {source.stem}"
        print(f"\rcompiling {what}, once for this machine", file=sys.stderr)
    _clean(library.parent)
    try:
        with tempfile.TemporaryDirectory(dir=library.parent, prefix="build-") as folder:
            product = Path(folder) / library.name
            make(command, flags, source, product, symbol)
            seal = _seal(product)
            seal.write_text(hashlib.sha256(product.read_bytes()).hexdigest())
            os.replace(seal, _seal(library))
            os.replace(product, library)
    except OSError as problem:  # the disk is full
        raise NoCompilerError(f"{library} cannot be written: {problem.strerror}") from problem


def _clean(folder: Path) -> None:
    """Remove what killed processes have left."""
    for left in folder.glob("build-*"):
        try:
            if time.time() - left.stat().st_mtime > _LEFT:
                shutil.rmtree(left, ignore_errors=True)
        except OSError:
            continue  # it has just been removed


def _seal(library: Path) -> Path:
    return library.with_suffix(".sha256")


def _is_intact(library: Path) -> bool:
    try:
        return _seal(library).read_text() == hashlib.sha256(library.read_bytes()).hexdigest()
    except OSError:
        return False


@cache
def _cache_folder() -> Path:
    """The user's cache folder, or a temporary one for this process if that can't be used."""
    folder: Path | str = "of a user without a home"
    try:
        base = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
        folder = Path(os.environ.get("GROUNDROLL_CACHE") or Path(base) / "groundroll").resolve()
        for each in (*reversed(folder.parents), folder):
            if not each.exists():
                each.mkdir(mode=0o700, exist_ok=True)
        _refuse_unfit(folder)
        with tempfile.TemporaryFile(dir=folder):
            return folder
    except (OSError, RuntimeError) as problem:  # RuntimeError: no home, or a loop of links
        why = getattr(problem, "strerror", None) or problem
    temporary = _temporary_folder()
    say_once(
        "cache",
        f"cannot use the cache folder {folder} ({why}); compiling for this process only. Set"
        " GROUNDROLL_CACHE to a folder that only you can write to",
    )
    return temporary


def _temporary_folder() -> Path:
    """A folder that goes with this process."""
    try:
        temporary = Path(tempfile.mkdtemp(prefix="groundroll-"))
        atexit.register(shutil.rmtree, temporary, ignore_errors=True)
        _refuse_unfit(temporary)
    except OSError as problem:
        raise NoCompilerError(f"no folder to compile in ({problem.strerror})") from problem
    return temporary


def _refuse_unfit(folder: Path) -> None:
    """Raise OSError if what is in a folder may be another's, or cannot be loaded."""
    about = folder.stat()
    if hasattr(os, "geteuid") and about.st_uid != os.geteuid():
        raise PermissionError(errno.EPERM, "it belongs to another user")
    if hasattr(os, "geteuid") and about.st_mode & 0o022:
        raise PermissionError(errno.EPERM, "others can write to it; chmod 700 makes it yours")
    if hasattr(os, "ST_NOEXEC") and os.statvfs(folder).f_flag & os.ST_NOEXEC:
        raise PermissionError(errno.EPERM, "nothing in it can be loaded: it is mounted noexec")


def say_slower(problem: Exception) -> None:
    """Warn that functions are not compiled."""
    message = f"{problem}; using CasADi's virtual machine, which is several times slower"
    say_once("compiler", message)


def say_once(topic: str, message: str) -> None:
    """Warn, but of each topic only once."""
    if topic not in _SAID:
        _SAID.add(topic)
        warnings.warn(message, RuntimeWarning, stacklevel=4)


_SAID: set[str] = set()
