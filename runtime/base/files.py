"""Files that appear only when they are complete, and reading that comes to an end."""

from __future__ import annotations

import errno
import os
import shutil
import stat
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from importlib import resources
from pathlib import Path
from typing import Any

from .errors import GroundrollError, shown

#: Where a path stands for what a process has opened, whatever that is.
_OPENED = "/proc/"


def as_path(value: Any) -> Path:
    """A path; `GroundrollError` if it is none."""
    try:
        return Path(value)
    except TypeError:
        raise GroundrollError(f"a path must be a text, not {shown(value)}") from None


def packaged(room: str, suffix: str) -> dict[str, Path]:
    """Files with a suffix that come with a room of the package, by name without it."""
    folder = resources.files("groundroll") / room
    files = sorted(Path(str(p)) for p in folder.iterdir() if p.name.endswith(suffix))
    return {p.name.removesuffix(suffix): p for p in files}


def text_of(path: Path, most: int = 2**18, otherwise: str = "") -> str:
    """The text of an ordinary file of at most so many bytes.

    Parameters
    ----------
    path : Path
        The file.
    most : int
        Its largest size.
    otherwise : str, optional
        An encoding for what is not in UTF-8, as spreadsheets write it.

    Raises
    ------
    GroundrollError
        If there is none, or it is anything else: a folder, a pipe that might never end, too large
        to be written by people, or not in UTF-8.
    """
    try:
        about = path.stat()
        if not stat.S_ISREG(about.st_mode):
            kind = "a folder" if stat.S_ISDIR(about.st_mode) else "no ordinary file"
            raise GroundrollError(f"cannot read {path}: it is {kind}")
        if about.st_size > most:
            sizes = f"it has {about.st_size:_} bytes, and no more than {most:_} are read"
            raise GroundrollError(f"cannot read {path}: {sizes}")
        content = path.read_bytes()
        return _decoded(content, otherwise)
    except OSError as problem:
        raise GroundrollError(f"cannot read {path}: {problem.strerror}") from problem
    except UnicodeDecodeError as problem:
        raise GroundrollError(f"{path} is not a text file (UTF-8): {problem}") from problem
    except ValueError as problem:
        if isinstance(problem, GroundrollError):
            raise
        raise GroundrollError(f"cannot read {shown(str(path))}: {problem}") from problem


def _decoded(content: bytes, otherwise: str) -> str:
    try:
        return content.decode("utf-8-sig").replace("\r\n", "\n").replace("\r", "\n")
    except UnicodeDecodeError:
        if not otherwise or b"\0" in content:
            raise
        return content.decode(otherwise, errors="replace")


@contextmanager
def complete(path: Path) -> Iterator[Path]:
    """A file to write to, of the same name, that takes the place of `path` if all goes well.

    Links are followed, and a file that is replaced keeps its mode and, where that is allowed, its
    owner. Into what is no ordinary file (a device, a pipe, ``>(...)`` of a shell) what was written
    is copied once it is complete.

    Raises
    ------
    GroundrollError
        If the folder is not there or cannot be written to, or the path is that of a folder.
    """
    try:
        target = _followed(path)
        before = target.stat() if target.exists() else None
        if before and stat.S_ISDIR(before.st_mode):
            raise IsADirectoryError(0, "it is a folder")
        through = before and not (stat.S_ISREG(before.st_mode) and not _is_opened(target))
        place = None if through else target.parent
        with tempfile.TemporaryDirectory(dir=place, prefix=".unfinished-") as folder:
            draft = Path(folder) / path.name
            yield draft
            if through:
                with draft.open("rb") as source, target.open("wb") as sink:
                    shutil.copyfileobj(source, sink)
                return
            if before:
                _take_over(draft, before)
            os.replace(draft, target)
    except OSError as problem:
        raise GroundrollError(f"cannot write {path}: {problem.strerror or problem}") from problem


@contextmanager
def complete_folder(path: Path) -> Iterator[Path]:
    """A folder to fill, whose files go into the folder `path` if all goes well; others stay there.

    Raises
    ------
    GroundrollError
        If what is above it is not there or cannot be written to, or the path is that of a file.
    """
    try:
        with tempfile.TemporaryDirectory(dir=path.parent, prefix=".unfinished-") as folder:
            draft = Path(folder) / path.name
            draft.mkdir()
            yield draft
            path.mkdir(exist_ok=True)
            if not os.access(path, os.W_OK | os.X_OK):
                raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
            for made in sorted(draft.rglob("*")):
                target = path / made.relative_to(draft)
                target.mkdir(exist_ok=True) if made.is_dir() else os.replace(made, target)
    except OSError as problem:
        raise GroundrollError(f"cannot write {path}: {problem.strerror or problem}") from problem


def _followed(path: Path) -> Path:
    """What a path leads to through links; for what a process has opened, the way to it."""
    for _ in range(40):
        if not path.is_symlink() or _is_opened(path):
            return path
        path = path.parent / os.readlink(path)
    raise OSError(0, "too many links")


def _is_opened(path: Path) -> bool:
    return os.path.realpath(path.parent).startswith(_OPENED)


def _take_over(draft: Path, before: os.stat_result) -> None:
    """Give a file the owner and the mode of the one whose place it takes."""
    with suppress(AttributeError, PermissionError):
        os.chown(draft, before.st_uid, before.st_gid)
    draft.chmod(stat.S_IMODE(before.st_mode))
