"""Files that appear whole or not at all."""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from groundroll.base.errors import GroundrollError


@contextmanager
def whole(target: Path, last: Sequence[str]) -> Iterator[Path]:
    """A folder to write into, whose files are moved to `target` when all is done.

    If the block is left by an exception, `target` stays as it was. While files are being moved,
    those that tell a reader that the folder is whole are missing: those of an earlier time are
    removed first, and the new ones come last. Other files in `target` are left alone.

    Parameters
    ----------
    target : Path
        Folder, made if needed.
    last : sequence of str
        Names of the files that tell, in the order in which they are moved.

    Raises
    ------
    GroundrollError
        If the folder cannot be written to.
    """
    existed = target.is_dir()
    try:
        target.mkdir(parents=True, exist_ok=True)
        scratch = Path(tempfile.mkdtemp(prefix=".unfinished-", dir=target))
    except OSError as problem:
        raise _unwritable(target, problem) from problem
    try:
        yield scratch
        _move(scratch, target, last)
    except OSError as problem:
        raise _unwritable(target, problem) from problem
    finally:
        shutil.rmtree(scratch, ignore_errors=True)
        if not existed and not any(target.iterdir()):
            target.rmdir()


def _move(scratch: Path, target: Path, last: Sequence[str]) -> None:
    names = sorted(str(p.relative_to(scratch)) for p in scratch.rglob("*") if p.is_file())
    for name in reversed(last):
        (target / name).unlink(missing_ok=True)
    for name in [*(n for n in names if n not in last), *last]:
        (target / name).parent.mkdir(parents=True, exist_ok=True)
        os.replace(scratch / name, target / name)


def _unwritable(target: Path, problem: OSError) -> GroundrollError:
    return GroundrollError(f"cannot write the study to {target}: {problem.strerror}")
