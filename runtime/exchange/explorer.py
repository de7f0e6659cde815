"""The explorer: one page of a model and an aircraft, to play with in any browser."""

from __future__ import annotations

import html
import json
import re
from importlib.metadata import version
from pathlib import Path
from typing import Any

from groundroll.aircraft.aircraft import Aircraft
from groundroll.base.errors import GroundrollError
from groundroll.base.files import as_path, complete
from groundroll.model.models import ModelLike

from .page_facts import facts
from .page_functions import functions_text
from .subject import Subject, subject

_PAGE = Path(__file__).parent / "page"
#: The program of the page, in this order.
_PARTS = (
    *("model", "eigenvalues", "linear", "motion", "tasks", "limits", "units", "design", "drawing"),
    *("aircraft", "modes", "map", "runway", "controls", "page"),
)
#: Bytes that a page may have: it should go into any mail.
MOST = 500_000


def explore(
    plane: Aircraft, out: str | Path, model: ModelLike = "nonlinear", **values: Any
) -> Path:
    """Write a page to play with an aircraft: one file that opens anywhere, without a network.

    It has the aircraft with wheels to drag, sliders, eigenvalues, a map of stability, how far each
    quantity may go, and the roll. Its functions are those of the model, as JavaScript.

    Parameters
    ----------
    plane : Aircraft
        One aircraft: none of its parameters may be an array.
    out : str or Path
        Where to.
    model : str or Model
    **values : float or str
        By symbol or full name, as for `groundroll.simulate`: where inputs, other parameters and
        initial states (``v0``) stand at first.

    Returns
    -------
    Path
        What was written.

    Raises
    ------
    GroundrollError
        For an unknown name or value, a parameter that is missing, a model too large for a page, or
        a place that cannot be written to. Nothing is left half-written.
    """
    path = as_path(out)
    text = page(subject(plane, model, values, "explore"))
    with complete(path) as draft:
        draft.write_bytes(text)
    return path


def page(case: Subject) -> bytes:
    """The page as it is written."""
    pieces = {
        "@GENERATOR@": html.escape(f"groundroll {version('groundroll')}"),
        "@STYLE@": _part("page.css"),
        "@DATA@": json.dumps(facts(case), allow_nan=False).replace("<", "\\u003c"),
        "@FUNCTIONS@": functions_text(case.model),
        "@PROGRAM@": "\n".join(_part(f"{name}.js") for name in _PARTS),
    }
    # all at once: a description may hold a mark
    found = re.sub("@[A-Z]+@", lambda mark: pieces[mark[0]], _part("page.html")).encode()
    if len(found) > MOST:
        raise GroundrollError(
            f"the model {case.model.name} is too large for a page: it would have"
            f" {len(found) // 1000} kB, {len(found) - MOST:,} bytes more than the"
            f" {MOST // 1000} kB that a page may have"
        )
    return found


def _part(name: str) -> str:
    return (_PAGE / name).read_text(encoding="utf-8")
