"""One version, wherever it stands."""

from __future__ import annotations

import re
import subprocess
import sys
import tomllib
from datetime import date
from pathlib import Path

import groundroll as gr

ROOT = Path(__file__).parent.parent
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
HEADINGS = re.findall(r"^## (.*)$", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), re.M)


def latest() -> tuple[str, str]:
    """Version and date of the newest release in the changelog."""
    found = re.fullmatch(r"\[(\d+\.\d+\.\d+)\] - (\S+)", HEADINGS[1])
    assert found, HEADINGS[1]
    return found[1], date.fromisoformat(found[2]).isoformat()


def test_the_package_has_the_version_of_the_project():
    assert gr.__version__ == PROJECT["version"]
    command = [sys.executable, "-m", "groundroll", "--version"]
    shown = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    assert PROJECT["version"] in shown


def test_the_changelog_begins_with_what_is_not_released_and_this_version():
    assert HEADINGS[0] == "[Unreleased]"
    assert latest()[0] == PROJECT["version"]


def test_the_citation_is_of_this_version():
    text = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    version, day = latest()
    assert f"\nversion: {version}\n" in text
    assert f"\ndate-released: {day}\n" in text
