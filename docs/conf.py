"""Sphinx configuration: `make docs` builds with warnings as errors."""

import html
import tomllib
from pathlib import Path
from typing import Any

from docutils.nodes import SkipNode
from latex2mathml.converter import convert

project = "groundroll"
author = "The groundroll authors"
copyright = author
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
html_math_renderer = "mathml"
myst_enable_extensions = ["dollarmath"]
html_theme = "furo"
html_title = "groundroll"
html_static_path = ["_static"]
html_css_files = ["formulas.css"]
html_extra_path = ["_pages"]
autodoc_typehints = "none"  # the docstrings say more: unit, shape, sign
autodoc_member_order = "bysource"
napoleon_google_docstring = False
napoleon_use_ivar = True
exclude_patterns = ["_build", "_pages", "_explorers.md", "examples"]


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


def _explorers(folder: Path) -> None:
    """A page to play with for each packaged aircraft."""
    import groundroll as gr
    from groundroll.aircraft.aircraft import packaged

    folder.mkdir(parents=True, exist_ok=True)
    lines = []
    for name in packaged():
        plane = gr.Aircraft.load(name)
        model = "nonlinear" if name.startswith("brott") else "landing_roll"  # no span is printed
        gr.explore(plane, folder / f"{name}.html", model)
        lines.append(f'- <a href="explorer/{name}.html">{html.escape(plane.title)}</a>')
    (Path(__file__).parent / "_explorers.md").write_text("\n".join([*lines, ""]), encoding="utf-8")


def _escape(
    app: object, what: str, name: str, obj: object, options: object, lines: list[str]
) -> None:
    """Docstrings are written to be read as they are: |x| and (*shape, n) mean just that."""
    lines[:] = [line.replace("|", r"\|").replace("*shape", r"\*shape") for line in lines]


def _inline(page: Any, node: Any) -> None:
    """A formula as MathML, which browsers draw themselves: nothing is fetched, no script runs."""
    page.body.append(convert(node.astext(), display="inline"))
    raise SkipNode


def _block(page: Any, node: Any) -> None:
    page.body.append(f'<div class="math">{convert(node.astext(), display="block")}</div>')
    raise SkipNode


def setup(app: Any) -> None:
    """Write the pages that come from data."""
    app.add_html_math_renderer(
        "mathml", inline_renderers=(_inline, None), block_renderers=(_block, None)
    )
    (Path(__file__).parent / "errata.md").write_text(_errata_page(), encoding="utf-8")
    _explorers(Path(__file__).parent / "_pages" / "explorer")
    app.connect("autodoc-process-docstring", _escape, priority=400)
