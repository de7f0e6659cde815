"""Sphinx configuration: `make docs` builds with warnings as errors."""

import tomllib
from pathlib import Path
from typing import Any

project = "groundroll"
author = "The groundroll authors"
copyright = author
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "sphinx.ext.mathjax"]
myst_enable_extensions = ["dollarmath"]
html_theme = "furo"
html_title = "groundroll"
autodoc_typehints = "none"  # the docstrings say more: unit, shape, sign
autodoc_member_order = "bysource"
napoleon_google_docstring = False
napoleon_use_ivar = True
exclude_patterns = ["_build", "examples"]


def _errata_page() -> str:
    """The errata of the thesis as a page; the study's data file is their only home."""
    data = Path(__file__).parent.parent / "runtime" / "study" / "data" / "errata.toml"
    lines = [
        "# Errata of the thesis",
        "",
        "Where the print contradicts itself, its own data or its own program, and what we rest",
        "that on. The numbers are those in the study's ledger.",
        "",
    ]
    for entry in tomllib.loads(data.read_text(encoding="utf-8"))["erratum"]:
        lines += [f"## {entry['number']}. {entry['where']}", ""]
        for label in ("printed", "right", "evidence"):
            lines += [f"**{label.capitalize()}.** {entry[label]}", ""]
    return "\n".join(lines)


def _escape(
    app: object, what: str, name: str, obj: object, options: object, lines: list[str]
) -> None:
    """Docstrings are written to be read as they are: |x| and (*shape, n) mean just that."""
    lines[:] = [line.replace("|", r"\|").replace("*shape", r"\*shape") for line in lines]


def setup(app: Any) -> None:
    """Write the pages that come from data."""
    (Path(__file__).parent / "errata.md").write_text(_errata_page(), encoding="utf-8")
    app.connect("autodoc-process-docstring", _escape, priority=400)
