"""How quick the explorer is: work in each frame while a wheel is dragged, and rolls in a frame.

A frame of 60 a second has 16.7 ms; the page should need less than half of it, and the planar model
should have time for 20 rolls of 10 s in it.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

import groundroll as gr

sys.path.insert(0, str(Path(__file__).parent.parent))
from browser import CHROMIUM, browser, opened

FRAME = 1000 / 60
#: Aircraft by model.
PAGES = {"nonlinear": "brott", "rollout": "cessna-170", "landing_roll": "cessna-170"}
#: Time of one roll at the tolerance that is used while something is dragged, ms.
ROLL = """() => {
    const times = [];
    for (let k = 0; k < 40; ++k) {
        const begun = performance.now();
        const roll = groundroll.rollOf(groundroll.design, {tolerance: 1e-6});
        while (!roll.done) roll.advance(1000);
        times.push(performance.now() - begun);
    }
    return times.sort((a, b) => a - b)[20];
}"""


def measured(chromium: Any, model: str, plane: str, folder: Path) -> tuple[float, float, float]:
    """Median and 95th percentile of the work in a frame, and the time of a roll, ms."""
    path = gr.explore(gr.Aircraft.load(plane), folder / f"{model}.html", model)
    with opened(chromium, path) as page:
        page.wait_for_timeout(1500)
        roll = page.evaluate(ROLL)
        box = page.locator("#plan .handle.wheel .mark").first.bounding_box()
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        page.mouse.move(x, y)
        page.mouse.down()
        work = []
        for k in range(120):
            page.mouse.move(x + 15 * np.sin(k / 10), y)
            work.append(page.evaluate("groundroll.lastWork"))
        page.mouse.up()
    return float(np.median(work)), float(np.quantile(work, 0.95)), roll


#: What must hold: work in a frame, ms; rolls of the planar model in a frame.
MOST_WORK, LEAST_ROLLS = 8.0, 20.0


def main() -> None:
    """Print one line for each model; fail if a page is too slow."""
    missed = []
    if not CHROMIUM:
        print("there is no chromium here")
        return
    with tempfile.TemporaryDirectory() as folder, browser() as chromium:
        for model, plane in PAGES.items():
            middle, most, roll = measured(chromium, model, plane, Path(folder))
            print(
                f"{model}: {middle:.1f} ms of work in a frame while dragging (95 %: {most:.1f}),"
                f" {roll:.2f} ms a roll, {FRAME / roll:.0f} rolls in a frame"
            )
            if middle > MOST_WORK:
                missed.append(f"{model} works {middle:.1f} ms in a frame, over {MOST_WORK} ms")
            if model == "nonlinear" and FRAME / roll < LEAST_ROLLS:
                missed.append(f"{FRAME / roll:.0f} rolls in a frame, under {LEAST_ROLLS:.0f}")
    if missed:
        raise SystemExit("; ".join(missed))


if __name__ == "__main__":
    main()
