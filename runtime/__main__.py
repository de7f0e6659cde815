"""``groundroll`` and ``python -m groundroll``: the command line, which Ctrl-C ends at any time."""

import sys


def main() -> int:
    """Run the command line and return its exit code."""
    try:
        from groundroll.cli import main as run

        return run()
    except KeyboardInterrupt:
        print("groundroll: interrupted", file=sys.stderr)
        return 130


if __name__ == "__main__":
    sys.exit(main())
