"""Every block of code in the README and in the documentation runs as it stands."""

from __future__ import annotations

import re
import shlex
import subprocess
from pathlib import Path

import matplotlib as mpl
import pytest

from groundroll.cli import main

ROOT = Path(__file__).parent.parent
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
BLOCK = re.compile(r"^```(python|console|c|toml)\n(.*?)^```", re.MULTILINE | re.DOTALL)
#: The first line of a block that is a file of the reader's.
FILE = re.compile(r"# (\w+\.(?:py|toml))\n")


def blocks(page: Path) -> list[tuple[str, str]]:
    return BLOCK.findall(page.read_text(encoding="utf-8"))


def exit_code(arguments: list[str]) -> object:
    try:
        main(arguments)
    except SystemExit as finished:
        return finished.code or 0
    return 0


def test_there_are_blocks_to_run() -> None:
    assert sum(len(blocks(page)) for page in PAGES) > 10


@pytest.mark.parametrize("page", [p for p in PAGES if blocks(p)], ids=lambda p: p.stem)
def test_code_of_a_page_runs(page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """In the order of the page and in one namespace, as a reader would type it."""
    monkeypatch.chdir(tmp_path)
    mpl.use("Agg")
    namespace: dict[str, object] = {}
    for language, code in blocks(page):
        if file := FILE.match(code):
            Path(file[1]).write_text(code, encoding="utf-8")
        elif language == "toml":
            continue  # a piece of a file
        elif language == "python":
            exec(compile(code, page.name, "exec"), namespace)
        elif language == "c":
            Path("roll.c").write_text(code, encoding="utf-8")
        else:
            for line in code.splitlines():
                program, *arguments = shlex.split(line.removeprefix("$ "))
                if program == "groundroll":
                    assert exit_code(arguments) == 0, line
                else:
                    assert program in ("cc", "make", "./roll", "./plane/roll"), line
                    subprocess.run([program, *arguments], check=True)


FORMULA = re.compile(r"\$\$(.+?)\$\$|(?<![\\$])\$([^$\n]+?)\$", re.DOTALL)
SHEETS = sorted((ROOT / "generated").glob("*/EQUATIONS.md"))


@pytest.mark.parametrize("page", [*PAGES, *SHEETS], ids=lambda p: f"{p.parent.name}-{p.stem}")
def test_formulas_become_what_a_browser_draws_by_itself(page: Path) -> None:
    """As docs/conf.py does; what it does not know it leaves as it is."""
    convert = pytest.importorskip("latex2mathml.converter").convert
    for match in FORMULA.finditer(page.read_text(encoding="utf-8")):
        assert "\\" not in convert(match[1] or match[2]), match[0]


def test_pages_fetch_nothing() -> None:
    settings = (ROOT / "docs" / "conf.py").read_text(encoding="utf-8")
    styles = [path.read_text(encoding="utf-8") for path in (ROOT / "docs/_static").iterdir()]
    assert not [text for text in (settings, *styles) if "mathjax" in text or "http" in text]
