"""The C compiler, whatever the user calls one, and whether what it makes can be loaded."""

from __future__ import annotations

import ctypes
import os
import shlex
import shutil
import signal
import subprocess
import sys
import threading
from collections.abc import Sequence
from functools import cache
from pathlib import Path

#: Seconds that a compiler may take to name its target and to compile; bytes that it may print.
_SHORT, _LONG, _MOST = 30.0, 900.0, 2**20
#: What another process does to a new library, because half a one may end whoever loads it.
_TRIAL = "import ctypes, sys; getattr(ctypes.CDLL(sys.argv[1]), sys.argv[2])"


class NoCompilerError(RuntimeError):
    """No C compiler makes what is asked, or nobody can load it; the message says what was tried."""


@cache
def compiler(flags: tuple[str, ...]) -> tuple[tuple[str, ...], str]:
    """Command of the C compiler, and its version, target and C library as they describe themselves.

    Raises
    ------
    NoCompilerError
        If there is none, or it does not know these flags.
    """
    wanted = os.environ.get("CC", "").strip() or "cc"
    try:
        program, *options = shlex.split(wanted)
    except ValueError as problem:
        raise NoCompilerError(f"CC is {wanted!r}, which is no command ({problem})") from problem
    path = shutil.which(program)
    if path is None:
        raise NoCompilerError(f"no C compiler ({program} is not on the PATH; set CC)")
    command = (path, *options)
    printed = _run([*command, *flags, "-dM", "-E", "-x", "c", os.devnull], _SHORT)
    macros = [line for line in printed.splitlines() if line.startswith("#")]
    return command, "\n".join([*macros, _c_library()])


def make(
    command: Sequence[str], flags: Sequence[str], source: Path, product: Path, symbol: str
) -> None:
    """Compile a C file into a library that has been loaded and has the function `symbol`.

    Raises
    ------
    NoCompilerError
        If any of that fails.
    """
    _run([*command, *flags, str(source), "-o", str(product), "-lm"], _LONG)
    _try(command[0], product, symbol)


def opened(library: Path, symbol: str) -> ctypes.CDLL:
    """A library in this process; `NoCompilerError` if that fails or it has no such function."""
    try:
        found = ctypes.CDLL(str(library))
        getattr(found, symbol)
    except (OSError, AttributeError) as problem:
        raise NoCompilerError(f"{library} cannot be loaded: {problem}") from problem
    return found


def _c_library() -> str:
    """Name and version of the C library that this Python uses, where there is a way to know."""
    try:
        return os.confstr("CS_GNU_LIBC_VERSION") or ""
    except (AttributeError, ValueError, OSError):
        return sys.platform


def _run(command: Sequence[str], patience: float) -> str:
    """What a command prints; `NoCompilerError` if it fails, or goes on for ever."""
    try:
        process = subprocess.Popen(
            command,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )
    except OSError as problem:
        raise NoCompilerError(f"{command[0]} cannot be run: {problem.strerror}") from problem
    timer = threading.Timer(patience, _kill, [process])
    timer.start()
    with process:
        try:
            assert process.stdout is not None
            printed = process.stdout.read(_MOST)
            if len(printed) < _MOST:
                process.wait()
        finally:
            ended, late = process.returncode == 0, not timer.is_alive()
            timer.cancel()
            _kill(process)
    text = printed.decode(errors="replace").strip()
    if not ended:
        why = text[:2000] or (f"not done after {patience:g} s" if late else "it said nothing")
        raise NoCompilerError(f"{command[0]} failed: {why}")
    return text


def _kill(process: subprocess.Popen[bytes]) -> None:
    """End a process and whatever it has started."""
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except (AttributeError, OSError):
        process.kill()


def _try(compiler: str, product: Path, symbol: str) -> None:
    """Let another process load what a compiler made."""
    if not product.is_file():
        raise NoCompilerError(f"{compiler} made no library, though it did not complain")
    try:
        if "python" in Path(sys.executable or "").name:
            _run([sys.executable, "-I", "-S", "-c", _TRIAL, str(product), symbol], _SHORT)
        else:  # embedded in another program
            opened(product, symbol)
    except NoCompilerError as problem:
        why = str(problem).splitlines()[-1]
        raise NoCompilerError(
            f"{compiler} made a library that cannot be loaded: {why}"
        ) from problem
