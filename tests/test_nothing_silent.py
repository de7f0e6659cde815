"""Nothing silent, nothing hanging: odd surroundings are answered, or refused in words."""

import os
import stat
import subprocess
import sys
import threading
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from clouds import CLOUDS

import groundroll as gr
from groundroll.base.errors import GroundrollError
from groundroll.base.files import complete
from groundroll.generated import kernels
from groundroll.model.models import as_model
from groundroll.model.names import parameter_symbols
from groundroll.stability.polynomials import roots


def write(path: Path, text: str = "new") -> None:
    with complete(path) as draft:
        draft.write_text(text)


# --- Threads --------------------------------------------------------------------------------


@pytest.mark.parametrize("threads", [3, 100_000, 10**12, 2**63, 10**30])
def test_more_threads_than_help_are_not_made(threads: int):
    plane = gr.Aircraft.load("brott")
    v0 = np.linspace(0.0, 0.1, 5)
    few, many = (gr.ensemble(plane, t=0.5, v0=v0, threads=n) for n in (1, threads))
    assert (few["v"] == many["v"]).all()
    speeds = np.linspace(5.0, 60.0, 1000)
    few, many = (gr.sweep(plane, threads=n, speed=speeds) for n in (1, threads))
    assert (few["re_1"] == many["re_1"]).all()


def test_threads_are_bounded_by_processors_and_by_work(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(kernels, "processors", lambda: 8)
    cases = ((1, 9), (4, 9), (99, 9), (99, 3), (4, 0))
    assert [kernels.useful_threads(*case) for case in cases] == [1, 4, 8, 3, 1]


# --- Writing --------------------------------------------------------------------------------


def test_a_new_file_has_the_usual_mode_and_an_old_one_keeps_its_own(tmp_path: Path):
    new, old, plain = tmp_path / "new", tmp_path / "old", tmp_path / "plain"
    plain.write_text("as usual")
    write(new)
    assert new.stat().st_mode == plain.stat().st_mode
    old.write_text("old")
    old.chmod(0o600)
    write(old)
    assert old.read_text() == "new"
    assert stat.S_IMODE(old.stat().st_mode) == 0o600
    assert sorted(p.name for p in tmp_path.iterdir()) == ["new", "old", "plain"]


def test_an_ordinary_file_is_replaced_all_at_once(tmp_path: Path):
    path = tmp_path / "file"
    path.write_text("old")
    with path.open() as reader:
        write(path)
        assert reader.read() == "old"
    with pytest.raises(UnicodeEncodeError):
        write(path, "half \ud800")
    assert path.read_text() == "new"
    assert [p.name for p in tmp_path.iterdir()] == ["file"]


def test_links_are_followed(tmp_path: Path):
    (tmp_path / "there").mkdir()
    real, link, chain = tmp_path / "there" / "real", tmp_path / "link", tmp_path / "chain"
    link.symlink_to("there/real")
    chain.symlink_to(link)
    write(chain)
    assert chain.is_symlink()
    assert link.is_symlink()
    assert real.read_text() == "new"
    loop = tmp_path / "loop"
    loop.symlink_to(loop)
    with pytest.raises(GroundrollError, match=r"cannot write .*loop: "):
        write(loop)


def test_a_device_stays_a_device(tmp_path: Path):
    before = os.stat(os.devnull)
    write(Path(os.devnull))
    link = tmp_path / "nowhere.csv"
    link.symlink_to(os.devnull)
    write(link)
    after = os.stat(os.devnull)
    assert stat.S_ISCHR(after.st_mode)
    assert (after.st_ino, after.st_mode) == (before.st_ino, before.st_mode)
    assert link.is_symlink()


def test_a_full_device_is_an_error_in_words():
    if not Path("/dev/full").exists():
        pytest.skip("there is no /dev/full")
    with pytest.raises(GroundrollError, match=r"cannot write /dev/full: No space left"):
        write(Path("/dev/full"))


def test_a_pipe_gets_what_was_written(tmp_path: Path):
    pipe = tmp_path / "pipe.csv"
    os.mkfifo(pipe)
    got: list[str] = []
    reader = threading.Thread(target=lambda: got.append(pipe.read_text()))
    reader.start()
    write(pipe)
    reader.join(timeout=10)
    assert got == ["new"]
    assert stat.S_ISFIFO(pipe.stat().st_mode)


def test_a_folder_is_refused_in_words(tmp_path: Path):
    with pytest.raises(GroundrollError, match=r"cannot write .*: it is a folder"):
        write(tmp_path)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("option", ["--out >(cat)", "--out /dev/stdout", "--format csv"])
def test_a_shell_may_take_what_is_written(option: str, tmp_path: Path):
    command = f"{sys.executable} -m groundroll linearize brott --format csv {option} | cat"
    run = subprocess.run(
        ["bash", "-c", command], capture_output=True, text=True, cwd=tmp_path, check=True
    )
    assert run.stdout.startswith("quantity,row,column,value\n"), run.stderr


# --- Numbers beyond all measure -------------------------------------------------------------

ASKED: dict[str, Callable[[gr.Aircraft], Any]] = {
    "check": gr.check,
    "speed window": gr.speed_window,
    "margins": gr.margins,
    "gear limit": lambda plane: gr.gear_limit(plane, loads="follow"),
    "gear envelope": lambda plane: gr.gear_envelope(plane, loads="follow"),
    "linearize": gr.linearize,
    "trim": gr.trim,
    "sweep": gr.sweep,
}


@pytest.mark.parametrize("what", ASKED)
def test_numbers_beyond_all_measure_are_answered_or_refused(what: str):
    plane = gr.Aircraft.load("brott")
    for s in parameter_symbols():
        for value in (1e300, -1e300, 1e-300):
            with suppress(GroundrollError):  # anything else is a failure, warnings among it
                repr(ASKED[what](plane.replace(**{s: value})))


def test_check_says_that_it_cannot_say_where_the_model_is_stable():
    found = gr.check(gr.Aircraft.load("brott").replace(m=1e300))
    assert any("cannot be computed: numbers so large" in note for note in found.notes)


def test_a_leading_coefficient_that_is_nothing_beside_the_others_is_dropped():
    with_tiny = np.array([[2.0], [-1.0], [1e-305]])
    assert roots(with_tiny)[0, 0] == 2.0
    with pytest.raises(GroundrollError, match="the roots of a polynomial cannot be computed"):
        roots(np.array([[1.0], [np.inf]]))


@pytest.mark.parametrize("changes", [{"a": 1.5, "Ct": 100.0}, {"a": 0.9, "Ct": 0.0}])
def test_at_a_critical_speed_nothing_decays_and_nothing_grows(changes: dict[str, float]):
    plane = gr.Aircraft.load("cessna-170").replace(**changes)
    window = gr.speed_window(plane)
    speeds = np.array([u for u in (window.low, window.high) if 0 < u < np.inf])
    assert speeds.size
    margins = gr.margins(plane, speed=speeds)
    for found in (
        margins,
        gr.linearize(plane, "linear", speed=speeds),
        gr.sweep(plane, ["decay_rate", "damping_ratio"], speed=speeds),
    ):
        read = getattr if not isinstance(found, gr.Sweep) else gr.Sweep.__getitem__
        decay = read(found, "decay_rate")
        assert (decay == 0).all()
        assert not np.signbit(decay).any()
        assert (read(found, "damping_ratio") == np.inf).all()
    assert (margins.time_to_half == np.inf).all()
    assert (margins.time_to_double == np.inf).all()
    beside = gr.margins(plane, speed=speeds[:, None] * [1 - 1e-9, 1 + 1e-9])
    assert (np.sign(beside.decay_rate[-1]) == [-1, 1]).all()


# --- One bad run among many -----------------------------------------------------------------


def test_an_aircraft_that_grows_without_bound_leaves_the_others_alone():
    plane, bad = gr.Aircraft.load("brott"), 77
    a = np.linspace(-0.3, 0.3, 500)
    options = {"speed": 60.0, "v0": 1.0, "t": 60.0, "samples": 7}
    sound = gr.simulate(plane.replace(a=a, Ct=1000.0), "linear", **options)
    a[bad] = 3.0
    with pytest.warns(RuntimeWarning, match=r"^run 77 of 500: .* at t = .* s; NaN from there on$"):
        run = gr.simulate(plane.replace(a=a, Ct=1000.0), "linear", **options)
    lost = np.arange(500) == bad
    assert ((run.status != 0) == lost).all()
    assert run["psi"][~lost].tobytes() == sound["psi"][~lost].tobytes()
    known = np.isfinite(run["psi"][bad])
    assert (known == (run.t <= run.end[bad])).all()
    assert 1 <= known.sum() < 7
    assert "1 step limit: the motion grows or changes too fast" in repr(
        gr.ensemble(plane, 60.0, "linear", a=a, Ct=1000.0, speed=60.0, v0=1.0, Y0=0.0)
    )


def test_whatever_has_a_finite_answer_gets_it():
    """Light or slow ones spin thousands of times around."""
    cloud = CLOUDS["any aircraft, large-slip, 20 s"]
    plane, start = cloud.drawn(np.random.default_rng(1), 500)
    ens = gr.ensemble(plane, 20.0, extremes=["psi"], **start)
    assert ens.ok.all()
    assert ens.largest["psi"].max() > 1e4


@pytest.mark.parametrize("speed", [1e-6, 1e-3, 0.1])
@pytest.mark.parametrize("model", ["linear", "nonlinear", "rollout", "landing_roll"])
def test_hardly_any_speed_is_an_answer_or_an_error_in_words(model: str, speed: float):
    plane, words = gr.Aircraft.load("cessna-170"), "too fast to be followed"
    if speed == 1e-6 and "u" not in as_model(model).states:  # all is over in microseconds
        with pytest.raises(GroundrollError, match=words):
            gr.simulate(plane, model, speed=speed, v0=0.1, t=2.0, samples=5)
        assert words in repr(gr.ensemble(plane, 2.0, model, speed=speed, v0=0.1))
        return
    run = gr.simulate(plane, model, speed=speed, v0=0.1, t=2.0, samples=5)
    assert np.isfinite(run["v"]).all()
    assert abs(run["v"][-1]) < 0.01
