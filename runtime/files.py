"""Files that appear only when they are complete."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from .errors import GroundrollError


@contextmanager
def complete(path: Path) -> Iterator[Path]:
    """A file to write to, of the same name, that takes the place of `path` if all goes well.

    Raises
    ------
    GroundrollError
        If the folder is not there or cannot be written to.
    """
    try:
        with tempfile.TemporaryDirectory(dir=path.parent, prefix=".unfinished-") as folder:
            draft = Path(folder) / path.name
            yield draft
            os.replace(draft, path)
    except OSError as problem:
        raise GroundrollError(f"cannot write {path}: {problem.strerror}") from problem
