"""A figure as SVG: the same bytes each time, no two figures with an id in common."""

from __future__ import annotations

import io
import re
from typing import Any
from xml.sax.saxutils import escape

from matplotlib.figure import Figure

from groundroll.view.plots import style


def as_svg(figure: Figure, number: str, name: str) -> str:
    """A figure as an SVG element with a name; its ids begin with its number."""
    target = io.StringIO()
    with style(), _salted(number):
        figure.savefig(target, format="svg", metadata=_NO_METADATA)
    return _tidied(target.getvalue(), number, name)


_NO_METADATA: dict[str, Any] = dict.fromkeys(("Creator", "Date", "Format", "Type"))


def _salted(number: str) -> Any:
    import matplotlib as mpl

    settings: Any = {"svg.hashsalt": f"groundroll {number}"}
    return mpl.rc_context(settings)


def _tidied(text: str, number: str, name: str) -> str:
    """Only the svg element: ids with the figure's number, coordinates to hundredths, a title."""
    body = text[text.index("<svg") :]
    prefix = f"f{number.replace('.', '-')}-"
    body = re.sub(r'(\bid="|href="#|url\(#)', rf"\g<1>{prefix}", body)
    body = re.sub(r"\s*<metadata>.*?</metadata>", "", body, flags=re.DOTALL)
    body = re.sub(r"<!--.*?-->\s*", "", body, flags=re.DOTALL)
    body = re.sub(r'\b(d|x|y)="([^"]*)"', _rounded, body)
    head, rest = body.split(">", 1)
    rest = re.sub(r"\s*<defs>\s*<style.*?</style>\s*</defs>", "", rest, count=1, flags=re.DOTALL)
    return f'{head} role="img" style="{_JOINS}">\n <title>{escape(name)}</title>{rest.rstrip()}\n'


#: On the svg element instead of in a style sheet, which would reach beyond it in a page.
_JOINS = "stroke-linejoin: round; stroke-linecap: butt"


def _rounded(match: re.Match[str]) -> str:
    def short(number: re.Match[str]) -> str:
        return f"{float(number[0]):.2f}".rstrip("0").rstrip(".")

    shortened = re.sub(r"-?\d+\.\d+", short, match[2])
    return f'{match[1]}="{" ".join(shortened.split())}"'
