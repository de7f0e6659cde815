"""A real browser for the tests of the explorer: Chromium without a window."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
needs_browser = pytest.mark.skipif(not CHROMIUM, reason="there is no chromium here")


@contextmanager
def browser() -> Iterator[Any]:
    """Chromium, which may not run as root in a sandbox of its own."""
    from playwright.sync_api import sync_playwright

    sandbox = ["--no-sandbox"] if hasattr(os, "geteuid") and os.geteuid() == 0 else []
    with sync_playwright() as tool:
        opened = tool.chromium.launch(executable_path=CHROMIUM, args=sandbox)
        yield opened
        opened.close()


@contextmanager
def opened(chromium: Any, path: Path, fragment: str = "", **settings: Any) -> Iterator[Any]:
    """A page in a window of its own, that asks for nothing and complains of nothing."""
    size = {"width": 1400, "height": 900}
    context = chromium.new_context(**{"viewport": size, "reduced_motion": "reduce", **settings})
    page = context.new_page()
    asked: list[str] = []
    said: list[str] = []
    context.on("request", lambda request: asked.append(request.url))
    page.on("console", lambda message: said.append(f"{message.type}: {message.text}"))
    page.on("pageerror", lambda error: said.append(str(error)))
    address = f"{path.resolve().as_uri()}{fragment}"
    page.goto(address)
    until(page, "groundroll.rolled !== null")
    yield page
    context.close()
    assert [url for url in asked if not url.startswith((address.split("#")[0], "data:"))] == []
    assert said == []


def until(page: Any, condition: str) -> None:
    """Wait until a condition holds; the page lets nobody compile one."""
    for _ in range(1200):
        if page.evaluate(condition):
            return
        page.wait_for_timeout(50)
    raise AssertionError(f"never: {condition}")


def settled(page: Any) -> None:
    """Wait until the page has computed everything."""
    page.wait_for_selector("html[data-settled]", timeout=120_000, state="attached")
