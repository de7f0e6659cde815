"""The gallery of models in the documentation is what its models are now."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from every import NAMES
from PIL import Image

DOCS = Path(__file__).parents[1] / "docs"
sys.path.insert(0, str(DOCS))

import gallery  # noqa: E402


def test_every_model_has_a_page() -> None:
    assert set(gallery.GALLERY) == set(NAMES)
    files = {path.name for path in (DOCS / "models").iterdir()}
    wanted = {f"{name}.{kind}" for name in gallery.GALLERY for kind in ("md", "png")}
    assert files == wanted | {"index.md"}


@pytest.mark.parametrize("name", gallery.GALLERY)
def test_a_page_is_what_the_gallery_writes(name: str, tmp_path: Path) -> None:
    text = (DOCS / "models" / f"{name}.md").read_text(encoding="utf-8")
    assert text == gallery.page(name), "run docs/gallery.py"
    gallery.draw(name, tmp_path / "now.png")
    kept, made = DOCS / "models" / f"{name}.png", tmp_path / "now.png"
    with Image.open(kept) as shown, Image.open(made) as now:
        assert shown.size == now.size


def test_the_list_is_what_the_gallery_writes() -> None:
    assert (DOCS / "models" / "index.md").read_text(encoding="utf-8") == gallery.index()
