"""`python -m groundroll.derive`: write `generated/`, or check that it is up to date."""

from __future__ import annotations

import argparse
import difflib
import sys
from pathlib import Path

from .emit.pack import write
from .emit.tree import HERE, files


def main() -> int:
    """Entry point; returns the exit code."""
    parser = argparse.ArgumentParser(prog="python -m groundroll.derive", description=__doc__)
    parser.add_argument("--check", action="store_true", help="compare instead of writing")
    parser.add_argument("--out", type=Path, default=HERE.parent.parent / "generated")
    options = parser.parse_args()
    if options.check:
        return check(options.out)
    write(options.out, files())
    return 0


def check(folder: Path) -> int:
    """Print how `folder` differs from what would be generated; 1 if it does."""
    fresh = files()
    there = {
        path.relative_to(folder).as_posix(): path.read_text()
        for path in sorted(folder.rglob("*"))
        if path.suffix in (".py", ".c", ".md", ".json")
    }
    differing = [n for n in sorted({*fresh, *there}) if fresh.get(n) != there.get(n)]
    for name in differing:
        old, new = there.get(name, ""), fresh.get(name, "")
        lines = difflib.unified_diff(old.splitlines(), new.splitlines(), name, f"{name} (fresh)")
        print("\n".join(list(lines)[:40]))
    if differing:
        print(f"{', '.join(differing)}: not what derive/ makes; run `make derive`", file=sys.stderr)
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
