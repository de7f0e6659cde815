"""A folder that nobody may write to, also where the tests run as root, who may write anywhere."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

_NOBODY = 65534


@contextmanager
def read_only_folder() -> Iterator[Path]:
    """A folder that is empty and read-only, for a process without privileges."""
    with tempfile.TemporaryDirectory(prefix="groundroll-locked-") as made:
        folder = Path(made)
        folder.chmod(0o555)
        root = os.geteuid() == 0
        if root:
            os.seteuid(_NOBODY)
        try:
            yield folder
        finally:
            if root:
                os.seteuid(0)
            assert list(folder.iterdir()) == []
            folder.chmod(0o755)
