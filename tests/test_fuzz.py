"""A small dose of the attacks of `tests/fuzz` on every surface, and what they must notice."""

from __future__ import annotations

import time
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from fuzz.dose import block
from fuzz.harness import BAD, MODELS, VERDICTS, Case, attempt

from groundroll.base.errors import GroundrollError

#: Inputs of each surface: about ten seconds of each.
DOSES = {"files": 300, "calls": 120, "lines": 60, "results": 80}
SEED = 20261125


@pytest.mark.parametrize("surface", DOSES)
def test_every_input_is_answered_rightly_or_refused_in_words(surface: str):
    tally = block(surface, SEED, range(DOSES[surface]))
    assert not tally.bad, "\n".join(tally.bad)
    assert tally.counts.total() == DOSES[surface]
    for verdict in ("refused", "answered"):  # else the attack is none, or never gets through
        assert tally.counts[verdict] > DOSES[surface] / 8, str(tally)


def test_every_model_is_attacked():
    assert {"linear", "nonlinear", "rollout", "landing_roll"} <= set(MODELS)


def refuses(folder: Path) -> None:
    raise GroundrollError("no")


def refuses_without_a_word(folder: Path) -> None:
    raise GroundrollError(" ")


def refuses_and_leaves(folder: Path) -> None:
    (folder / "half").touch()
    raise GroundrollError("no")


def warns(folder: Path) -> None:
    warnings.warn("divide by zero encountered in log", RuntimeWarning, stacklevel=1)


@pytest.mark.parametrize(
    ("run", "judged", "verdict"),
    [
        (lambda folder: 1, "", "answered"),
        (lambda folder: 1, None, "not judged"),
        (lambda folder: 1, "2 is right", "wrong"),
        (refuses, "", "refused"),
        (refuses_without_a_word, "", "exception"),
        (refuses_and_leaves, "", "left behind"),
        (warns, "", "exception"),
        (lambda folder: {}["x"], "", "exception"),
        (lambda folder: time.sleep(9), "", "hang"),
        (lambda folder: [0 for _ in iter(int, 1)], "", "hang"),
    ],
)
def test_an_attack_notices(
    run: Callable[[Path], Any], judged: str | None, verdict: str, tmp_path: Path
):
    def surface(rng: np.random.Generator, model: str, folder: Path) -> Case:
        return Case("an input", lambda: run(folder), lambda answer: judged)

    tally = attempt("any", surface, 1, 7, tmp_path, limit=0.1)
    assert dict(tally.counts) == {verdict: 1}
    assert [case.split(":")[:2] for case in tally.bad] == [["any", "1"]] * (verdict in BAD)
    assert verdict in VERDICTS
    assert list(tmp_path.iterdir()) == []
