"""How far something is: told the same way everywhere, drawn only for people, clean to leave."""

from __future__ import annotations

import io
import re
import signal
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager, redirect_stderr, suppress
from pathlib import Path

import numpy as np
import pytest

import groundroll as gr
from groundroll import cli
from groundroll.base import bar
from groundroll.base.progress import Count, Progress, counted

PLANE = gr.Aircraft.load("brott-physical")
CESSNA = gr.Aircraft.load("cessna-170")
GRID = ("speed", np.linspace(15.0, 40.0, 201)), ("impulse", np.linspace(0.0, 3000.0, 100))

#: What takes longer than a moment, and whether it knows how long.
WORK: dict[str, tuple[Callable[..., object], bool]] = {
    "ensemble": (lambda p: gr.ensemble(PLANE, 1.0, v0=np.ones(50), chunk=7, progress=p), True),
    "one threshold": (lambda p: gr.survival(PLANE, progress=p), True),
    "many": (lambda p: gr.survival(PLANE, speed=np.linspace(9.0, 40.0, 280), progress=p), True),
    "none": (lambda p: gr.survival(PLANE.replace(Ct=0.0, a=1.0, b=3.5), progress=p), True),
    "all": (lambda p: gr.survival(PLANE, largest=50.0, progress=p), True),
    "basin": (lambda p: gr.basin(PLANE, *GRID, progress=p), True),
    "place": (lambda p: gr.place_gear(CESSNA, progress=p), False),
    "no better damping": (
        lambda p: gr.place_gear(CESSNA, None, None, "damping_ratio", progress=p),
        False,
    ),
    "front": (lambda p: gr.place_gear(CESSNA).pareto("wheelbase", 3, p), True),
}


@pytest.mark.parametrize("name", WORK)
def test_progress_never_goes_back_and_ends_once(name: str):
    work, known = WORK[name]
    seen: list[tuple[int, int | None]] = []
    work(lambda *told: seen.append(told))
    *before, (done, total) = seen
    assert done == total > 0
    assert before
    assert all((total is not None) == known for _, total in before)
    shares = [done / (total or np.inf) for done, total in before]
    assert shares == sorted(shares)
    assert all(share < 1 for share in shares)
    assert [done for done, _ in seen] == sorted(done for done, _ in seen)


def test_what_cannot_be_met_is_counted_too():
    seen: list[object] = []
    limits = gr.Limits(nose_over=("60 deg", "70 deg"), tail_wheel_load=(0.3, 0.4))
    with pytest.raises(gr.InfeasibleError):
        gr.place_gear(CESSNA, limits=limits, progress=lambda *told: seen.append(told))
    assert len(seen) > 10
    assert seen[-1] == (len(seen), None)  # it was not done


# --- On a terminal ---------------------------------------------------------------------------


class Terminal(io.StringIO):
    """Remembers what is written, and knows what a screen would show of it."""

    def isatty(self) -> bool:
        return True

    @property
    def screen(self) -> list[str]:
        lines, row, column = [""], 0, 0
        for token in re.findall(r"\033\[[?\d]*[a-zA-Z]|.", self.getvalue(), re.DOTALL):
            if token == "\r":
                column = 0
            elif token == "\n":
                row, column = row + 1, 0
                lines += [""] * (row + 1 - len(lines))
            elif token == "\033[A":
                row -= 1
            elif token == "\033[K":
                lines[row] = lines[row][:column]
            elif not token.startswith("\033"):
                lines[row] = lines[row][:column].ljust(column) + token + lines[row][column + 1 :]
                column += 1
        return [line.rstrip() for line in lines if line.strip()]


@contextmanager
def on_terminal(moment: float = 0.0) -> Iterator[Terminal]:
    """A terminal, and how long a moment lasts."""
    with pytest.MonkeyPatch.context() as patch, redirect_stderr(Terminal()) as terminal:
        patch.setattr(bar, "_MOMENT", moment)
        yield terminal


def test_people_see_a_bar_that_is_wiped_out():
    seen = []
    with on_terminal() as terminal:
        with counted(True, "kicks", 4) as done:
            for _ in range(4):
                done.add()
                seen += terminal.screen
        assert [re.sub(r"[#-]+", "", line) for line in seen] == [
            f"kicks  []  {share:>4}" for share in ("25%", "50%", "75%", "100%")
        ]
        assert terminal.screen == []


def test_a_total_may_fall_and_the_bar_follows():
    with on_terminal() as terminal, counted(True, "kicks", 10) as done:
        done.add()
        assert "10%" in terminal.screen[0]
        done.left(3)
        done.add()
        assert "50%" in terminal.screen[0]


def test_what_has_no_total_is_counted():
    with on_terminal() as terminal:
        with counted(True, "steps") as done:
            done.add(3)
            assert terminal.screen == ["3 steps ..."]
        assert terminal.screen == []


def test_who_tells_nothing_asks_for_patience():
    with on_terminal() as terminal:
        with bar.bar():
            for timer in threading.enumerate():
                if isinstance(timer, threading.Timer):
                    timer.join()
            assert terminal.screen == ["computing ..."]
        assert terminal.screen == []


def test_an_interrupted_bar_leaves_nothing_behind():
    def work() -> None:
        with counted(True, "kicks", 4) as done:
            done.add()
            raise KeyboardInterrupt

    with on_terminal() as terminal:
        with pytest.raises(KeyboardInterrupt):
            work()
        assert terminal.screen == []
        cursor = [terminal.getvalue().rindex(f"\033[?25{state}") for state in "lh"]
        assert cursor == sorted(cursor)  # hidden, and shown again


def test_what_is_quick_shows_nothing():
    with on_terminal(moment=3600.0) as terminal:
        gr.survival(PLANE, progress=True)
    assert terminal.getvalue() == ""


@pytest.mark.parametrize("progress", [True, False, None])
def test_elsewhere_nothing_is_written(capsys: pytest.CaptureFixture[str], progress: Progress):
    gr.survival(PLANE, progress=progress)
    gr.place_gear(CESSNA, progress=progress)
    assert capsys.readouterr() == ("", "")


# --- Ctrl-C ----------------------------------------------------------------------------------

SLOW = {
    "ensemble": "ensemble brott --v0 0:1:9",
    "survival": "survival brott-physical",
    "basin": "survival brott-physical --largest 9",
    "place": "place cessna-170",
    "study": "study",
}


@pytest.mark.parametrize("name", SLOW)
def test_an_interruption_leaves_no_trace(
    name: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
):
    def interrupted(self: Count, more: int = 1) -> None:
        if name != "basin" or more > 100:
            raise KeyboardInterrupt

    monkeypatch.setattr(Count, "add", interrupted)
    monkeypatch.chdir(tmp_path)
    where = [] if name == "basin" else ["--out", "out"]
    assert cli.main([*SLOW[name].split(), *where]) == 130
    out, err = capsys.readouterr()
    assert err.strip() == "groundroll: interrupted"
    assert (out != "") == (name == "basin")  # the table was done before the picture
    assert list(tmp_path.iterdir()) == []


def test_the_solver_does_not_take_ctrl_c_for_a_bad_start(capfd: pytest.CaptureFixture[str]):
    """A signal within IPOPT; were it to come too early or late it would be the same."""

    def press(done: int, total: int | None) -> None:
        if done == 1:
            signal.setitimer(signal.ITIMER_REAL, 0.02)

    before = signal.signal(signal.SIGALRM, signal.default_int_handler)
    try:
        with pytest.raises(KeyboardInterrupt):
            gr.place_gear(CESSNA, objective="displacement", progress=press)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert capfd.readouterr() == ("", "")


def test_an_interruption_that_foreign_code_swallows_is_noticed():
    def work() -> None:
        with counted(None, "kicks", 4) as done:
            with suppress(KeyboardInterrupt):
                signal.raise_signal(signal.SIGINT)
            seen.append("went on")
            done.add()
            seen.append("and on")

    seen: list[str] = []
    with pytest.raises(KeyboardInterrupt):
        work()
    assert seen == ["went on"]


def test_an_interruption_in_a_destructor_is_quiet(capfd: pytest.CaptureFixture[str]):
    class Last:
        def __del__(self) -> None:
            signal.raise_signal(signal.SIGINT)

    def work() -> None:
        with counted(None, "kicks"):
            del last[:]

    last = [Last()]
    with pytest.raises(KeyboardInterrupt):
        work()
    assert capfd.readouterr() == ("", "")


def test_an_interruption_that_became_another_error_is_one():
    def work() -> None:
        with counted(None, "kicks"), suppress(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)
        raise AssertionError("it went on")

    def fail() -> None:
        with counted(None, "kicks"):
            try:
                signal.raise_signal(signal.SIGINT)
            except KeyboardInterrupt:
                raise RuntimeError("Error in Function::call") from None

    for each in (work, fail):
        with pytest.raises(KeyboardInterrupt):
            each()
    with pytest.raises(RuntimeError), counted(None, "kicks"):
        raise RuntimeError("nobody pressed anything")


def test_work_in_a_thread_leaves_signals_alone():
    before = signal.getsignal(signal.SIGINT)
    with ThreadPoolExecutor(1) as executor:
        found = executor.submit(gr.survival, PLANE, progress=True).result()
    assert found.impulse > 0
    assert signal.getsignal(signal.SIGINT) is before
