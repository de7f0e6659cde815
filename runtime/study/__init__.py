"""The study: every table and figure of Brott's thesis, computed and set beside the print.

It ends with what the thesis leads up to: where the wheels of its aircraft should stand.

`sources` reads the data files (printed tables, trials and their readings, errata, figures),
`cases` makes the runs, `ledger` judges each printed cell, `figures` draws, `report` writes for
people, `output` lets files appear whole or not at all.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path

from groundroll.base.progress import Progress, counted

__all__ = ["Summary", "run"]

REPORT, LEDGER = "report.html", "ledger.json"


@dataclass(frozen=True)
class Summary:
    """What a study found and where it is.

    Attributes
    ----------
    folder : Path
        Where everything was written.
    agrees, explained, differs : int
        Number of printed cells by verdict.
    figures : int
        Number of figures.
    """

    folder: Path
    agrees: int
    explained: int
    differs: int
    figures: int

    @property
    def report(self) -> Path:
        """The HTML report."""
        return self.folder / REPORT

    @property
    def ledger(self) -> Path:
        """The ledger as JSON."""
        return self.folder / LEDGER

    def __str__(self) -> str:
        total = self.agrees + self.explained + self.differs
        return (
            f"{total} printed cells: {self.agrees} agree, {self.explained} are explained by an"
            f" erratum, {self.differs} differ; {self.figures} figures\n{self.report}"
        )


def run(out: str | Path, progress: Progress = None) -> Summary:
    """Compute every table and figure of the thesis and write them with the verdicts.

    Parameters
    ----------
    out : str or Path
        Folder for ``report.html``, ``ledger.json``, ``ledger.csv``, ``tables.md`` and
        ``figures/``; made if needed. It is as before unless the study is completed.
    progress : callable or bool, optional
        Called with the numbers of steps done and in all; True draws a bar on a terminal.

    Returns
    -------
    Summary
        Counts of the verdicts, and where to look.

    Raises
    ------
    GroundrollError
        If the folder cannot be written to.
    """
    from groundroll.placement.worked import steps, worked_study

    from . import figures, report
    from .figure_svg import as_svg
    from .ledger import Cell, count, ledger, rows
    from .output import whole
    from .provenance import provenance
    from .sources import figures as specs
    from .sources import tables

    folder, total = Path(out), len(tables()) + len(specs()) + steps() + 1
    with (
        whole(folder, last=(LEDGER, REPORT)) as scratch,
        counted(progress, "steps", total) as done,
    ):
        cells: list[Cell] = []
        for number in tables():
            cells += ledger([number])
            done.add()

        drawings = {}
        (scratch / "figures").mkdir()
        for number, spec in specs().items():
            drawings[number] = figures.svg(spec)
            _write(scratch / "figures" / f"{file_name(number)}.svg", drawings[number])
            done.add()

        placement = worked_study(done.add)
        for name, figure in placement.figures().items():
            drawings[name] = as_svg(figure, name, name.replace("-", " "))
            _write(scratch / "figures" / f"{name}.svg", drawings[name])

        counts = count(cells)
        contents = {"provenance": provenance(), "counts": counts, "rows": rows(cells)}
        _write(scratch / "ledger.csv", report.as_csv(cells))
        _write(scratch / "tables.md", report.markdown(cells))
        _write(scratch / LEDGER, json.dumps(contents, ensure_ascii=False, indent=1) + "\n")
        _write(scratch / REPORT, report.html(cells, drawings, placement))
        done.add()
    return Summary(folder, **counts, figures=len(specs()))


def file_name(number: str) -> str:
    """File name of a figure, without its suffix, such that names sort like numbers."""
    chapter, _, index = number.partition(".")
    return f"figure-{chapter}-{int(index):02d}"


def _write(path: Path, text: str) -> None:
    path.write_text(text, encoding="utf-8", newline="\n")
