"""Stand-in for the generated `names.py`, so that `library.py` can be read and checked here."""

DIGEST = ""

#: Name of a function -> module, builder, C file.
FUNCTIONS: dict[str, tuple[str, str, str]] = {}
