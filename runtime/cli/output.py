"""What a command has found, for people or for programs."""

from __future__ import annotations

import csv
import io
import json
import math
import os
import re
import shutil
import sys
import textwrap
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from groundroll.base.wording import number as number
from groundroll.base.wording import visible

if TYPE_CHECKING:
    from groundroll.results.results import Result

FORMATS = ("table", "csv", "json")
#: Not a format to print but a file with the result itself, of one of these kinds.
KEPT, KEPT_IN = "kept", (".npz", ".nc")

#: How a formula begins, and a number, with or without a unit, that does too.
_FORMULA = ("=", "+", "-", "@", "\t", "\r")
_PLAIN = re.compile(
    r"[+-](?:inf|nan|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)(?: (?:1/)?[^\W\d][\w^*/ .]*)?"
)

#: Beyond this width a line is hard to read; narrower terminals wrap the last column.
_WIDEST = 120


@dataclass(frozen=True)
class Output:
    """One result in three forms.

    Attributes
    ----------
    text : str
        For people.
    rows : iterable of sequences
        For a spreadsheet; the first row is the header. Read only if they are wanted.
    data : mapping
        For programs, SI units with radians.
    result : Result, optional
        The result itself, if it can be kept.
    """

    text: str
    rows: Iterable[Sequence[Any]]
    data: Mapping[str, Any]
    result: Result | None = None


def emit(output: Output, form: str, out: Path | None) -> None:
    """Write an output in a format to a file, or to stdout."""
    if out is None:
        show(_content(output, form))
        return
    if form == KEPT:
        assert output.result is not None
        output.result.save(out)
    else:
        write(out, _content(output, form))
    say(f"wrote {out}")


def show(text: str) -> None:
    """Write to stdout, or say why that cannot be."""
    from groundroll.base.errors import GroundrollError

    if sys.stdout is None:
        raise GroundrollError("cannot write the result: stdout is closed; --out writes a file")
    try:
        click.echo(text, nl=False)
    except BrokenPipeError:
        raise
    except OSError as problem:
        drop_stdout()
        raise GroundrollError(f"cannot write the result: {problem.strerror}") from problem


def drop_stdout() -> None:
    """Let what is left for stdout vanish, where it cannot go and Python would try again."""
    with suppress(OSError, ValueError, AttributeError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _content(output: Output, form: str) -> str:
    return {"table": _text, "csv": _csv, "json": _json}[form](output)


def write(path: Path, content: str) -> None:
    """Write a text file, or say why not."""
    from groundroll.base.files import complete

    with complete(path) as draft:
        draft.write_text(content, encoding="utf-8", errors="backslashreplace", newline="")


def say(message: str) -> None:
    """Tell people something on stderr; stdout is for results."""
    with suppress(OSError):  # there is nobody left to tell
        click.echo(visible(message), err=True)


def table(header: Sequence[str], rows: Sequence[Sequence[str]], right: Sequence[int] = ()) -> str:
    """Aligned columns, those in `right` to the right.

    On a terminal that is too narrow headers are stacked and the last column is wrapped.
    """
    cells = [*_stacked(header, rows), *(list(row) for row in rows)]
    widths = [max(len(row[k]) for row in cells) for k in range(len(header))]
    before = sum(widths[:-1]) + 2 * len(widths[:-1]) + 2
    room = max(_width() - before, 12)
    lines = []
    for row in cells:
        parts = [
            cell.rjust(width) if k in right else cell.ljust(width)
            for k, (cell, width) in enumerate(zip(row, widths, strict=True))
        ]
        first, *rest = textwrap.wrap(
            row[-1], room, break_long_words=False, break_on_hyphens=False
        ) or [""]
        last = first if len(header) - 1 not in right else parts[-1]
        lines.append(("  " + "  ".join([*parts[:-1], last])).rstrip())
        lines += [" " * before + line for line in rest]
    return "\n".join(lines)


def _stacked(header: Sequence[str], rows: Sequence[Sequence[str]]) -> list[list[str]]:
    """The lines of a header: several if the words of one take too much width."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)] or [0] * len(header)
    needed = sum(2 + max(pair) for pair in zip(widths, map(len, header), strict=True))
    if needed <= _width():
        return [list(header)]
    cells = [
        textwrap.wrap(cell, max(width, 1), break_long_words=False, break_on_hyphens=False)
        for cell, width in zip(header, widths, strict=True)
    ]
    deepest = max(map(len, cells))
    padded = [[""] * (deepest - len(lines)) + lines for lines in cells]
    return [list(line) for line in zip(*padded, strict=True)]


def filled(text: str) -> str:
    """A text wrapped to the terminal."""
    return textwrap.fill(
        " ".join(text.split()), _width(), break_long_words=False, break_on_hyphens=False
    )


def hanging(text: str) -> str:
    """Lines wrapped to the terminal, each continued further to the right."""
    return "\n".join(
        textwrap.fill(
            line,
            _width(),
            subsequent_indent="      ",
            break_long_words=False,
            break_on_hyphens=False,
        )
        for line in text.splitlines()
    )


def paragraph(text: str, mark: str = "-") -> str:
    """A text wrapped to the terminal, as an item of a list."""
    first = f"  {mark} "
    return textwrap.fill(
        text,
        _width(),
        initial_indent=first,
        subsequent_indent=" " * len(first),
        break_long_words=False,
        break_on_hyphens=False,
    )


def shown(value: Any, unit: str) -> tuple[float, str]:
    """A value with its unit as people read it: degrees for radians, nothing for a pure number."""
    from groundroll.base.units import from_si

    wanted = unit.replace("rad", "deg")
    factor = 1.0 if wanted == unit else from_si(1.0, unit, wanted)
    return float(value) * factor, "" if unit == "1" else wanted


def _width() -> int:
    """Columns to write to: of the terminal, or without one as many as it takes."""
    if sys.stdout is None or not sys.stdout.isatty():
        return 10_000
    return min(shutil.get_terminal_size().columns, _WIDEST)


def _text(output: Output) -> str:
    return visible(output.text.rstrip("\n")) + "\n"


def _csv(output: Output) -> str:
    buffer = io.StringIO()
    rows = ([_cell(value) for value in row] for row in output.rows)
    csv.writer(buffer, lineterminator="\n").writerows(rows)
    return buffer.getvalue()


def _cell(value: Any) -> Any:
    """A cell that no spreadsheet takes for a formula: a text that looks like one gets a quote."""
    if not isinstance(value, str):
        return value
    text = visible(value)
    return f"'{text}" if text.startswith(_FORMULA) and not _PLAIN.fullmatch(text) else text


def _json(output: Output) -> str:
    return json.dumps(plain(output.data), indent=2, allow_nan=False) + "\n"


def plain(value: Any) -> Any:
    """What JSON can hold: arrays as lists, complex numbers as [re, im], no number as null."""
    if isinstance(value, Mapping):
        return {str(key): plain(item) for key, item in value.items()}
    if hasattr(value, "tolist"):
        return plain(value.tolist())
    if isinstance(value, (list, tuple)):
        return [plain(item) for item in value]
    if isinstance(value, complex):
        return [plain(value.real), plain(value.imag)]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value
