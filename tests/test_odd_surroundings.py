"""The command line where things are odd: a code and words, nothing left behind, nothing obeyed."""

import csv
import io
import json
import os
import signal
import subprocess
import sys
import time
import tomllib
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import groundroll as gr
from groundroll import cli
from groundroll.aircraft.source import Source
from groundroll.aircraft.template import template
from groundroll.base.errors import GroundrollError
from groundroll.base.files import complete
from groundroll.base.interruption import ended, interruptible
from groundroll.cli.output import Output, emit
from groundroll.view.runway import runway_view

ESCAPE = "\x1b[31mred\x9b0m"


def shell(line: str, folder: Path, **more: str) -> subprocess.CompletedProcess[str]:
    """What a shell makes of a line in which G is the command."""
    program = f'G() {{ {sys.executable} -m groundroll "$@"; }}\n{line}'
    return subprocess.run(
        ["bash", "-c", program],
        capture_output=True,
        text=True,
        cwd=folder,
        env={**os.environ, **more},
        check=False,
    )


# --- Streams, backends, encodings -------------------------------------------------------------


@pytest.mark.parametrize(
    ("line", "code", "words"),
    [
        ("G info > /dev/full", 1, "cannot write the result: No space left on device"),
        ("G --help > /dev/full", 1, "No space left on device"),
        ("G info >&-", 1, "cannot write the result: stdout is closed; --out writes a file"),
        ("G nosuch 2>&-", 2, ""),
        ("G linearize brott --out x.csv >&- 2>&-; test -s x.csv", 0, ""),
    ],
)
def test_streams_that_take_nothing(line: str, code: int, words: str, tmp_path: Path):
    found = shell(line, tmp_path)
    assert (found.returncode, found.stdout) == (code, "")
    assert words in found.stderr
    assert "Traceback" not in found.stderr
    assert "Exception ignored" not in found.stderr


def test_a_backend_that_does_not_exist_is_of_no_matter(tmp_path: Path):
    line = "G simulate brott --v0 0.1 --plot x.png"
    found = shell(line, tmp_path, MPLBACKEND="bogus")
    assert found.returncode == 0, found.stderr
    assert (tmp_path / "x.png").stat().st_size > 1000


def test_what_an_encoding_lacks_is_written_as_in_python(tmp_path: Path):
    (tmp_path / "plane.toml").write_text('title = "Möwe"\nsource = "…"\n[a]\nvalue = 0.1\n')
    for words in ("check plane.toml", "check plane.toml --format json"):
        found = shell(f"G {words}", tmp_path, PYTHONIOENCODING="ascii")
        assert found.returncode in (0, 1)
        assert "Traceback" not in found.stderr


# --- Ended from outside -----------------------------------------------------------------------


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
def test_what_is_ended_leaves_nothing_behind(number: signal.Signals, tmp_path: Path):
    def write() -> None:
        with interruptible(), complete(tmp_path / "file") as draft:
            draft.write_text("half")
            os.kill(os.getpid(), number)
            while True:  # until it arrives
                time.sleep(0.001)

    with ended() as by, pytest.raises(KeyboardInterrupt):
        write()
    assert by == [number]
    assert list(tmp_path.iterdir()) == []
    assert signal.getsignal(number) is signal.SIG_DFL


def test_what_is_ended_has_its_code(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
):
    from groundroll.cli import info

    monkeypatch.setattr(info.command, "callback", lambda **_: signal.raise_signal(signal.SIGTERM))
    assert cli.main(["info"]) == 143
    assert capsys.readouterr().err.strip() == "groundroll: ended"


def test_ctrl_c_while_it_is_imported_is_told_in_a_word(tmp_path: Path):
    """The first import of the command line is interrupted, as somebody impatient does."""
    (tmp_path / "sitecustomize.py").write_text(
        "import sys\n"
        "class Impatient:\n"
        "    def find_spec(self, name, path=None, target=None):\n"
        "        if name == 'groundroll.cli':\n"
        "            raise KeyboardInterrupt\n"
        "sys.meta_path.insert(0, Impatient())\n"
    )
    found = shell("G info", tmp_path, PYTHONPATH=str(tmp_path))
    assert (found.returncode, found.stdout) == (130, "")
    assert found.stderr == "groundroll: interrupted\n"


# --- What a text may hold ---------------------------------------------------------------------


def plane(text: str) -> gr.Aircraft:
    given = gr.Aircraft.load("brott")
    sources = {**given.sources, "m": Source(text, entry=text)}
    return gr.Aircraft(text, given.given, text, text, sources, text)


@pytest.mark.parametrize("text", ["<svg onload=alert(1)>", "<b>", '"><script>x</script>'])
def test_a_notebook_shows_texts_and_runs_none(text: str):
    page = plane(text)._repr_html_()
    assert text not in page
    assert "<script" not in page
    assert page.count("<svg") == 0


def test_drawings_of_ours_are_drawn():
    page = gr.simulate(gr.Aircraft.load("brott"), v0=0.1, t=1.0, samples=11)._repr_html_()
    assert page.count("<svg") > 3


def test_a_terminal_obeys_nothing_that_a_text_says(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
):
    monkeypatch.chdir(tmp_path)
    assert "\x1b" not in repr(plane(ESCAPE))
    assert r"\x1b[31mred\x9b0m" in repr(plane(ESCAPE))
    given = gr.Aircraft.load("brott").given["m"]
    title = json.dumps(ESCAPE)
    content = f"title = {title}\nsource = {title}\nmass = {{value={given}, source={title}}}\n"
    (tmp_path / "odd\x1b[31m.toml").write_text(content)
    for form in ("table", "csv", "json"):
        for name in ("odd\x1b[31m.toml", "no\x1b[31m.toml", "\x1b[31m"):
            cli.main(["check", name, "--format", form])
            shown = "".join(capsys.readouterr())
            assert shown
            assert not {"\x1b", "\x9b"} & set(shown)


@pytest.mark.parametrize(
    ("text", "cell"),
    [
        *((formula, f"'{formula}") for formula in ("=1+1", "+1+cmd|' /C calc'!A0", "@SUM(1)")),
        *((formula, f"'{formula}") for formula in ("-@x", "-2+3", "\t=1", "-1 (A1)", "+A1")),
        *((text, text) for text in ("-1.5", "+2e-3", "-1.2 N*m", "-inf", "-3 1/s", "a=b", "")),
    ],
)
def test_no_cell_is_a_formula(text: str, cell: str, capsys: pytest.CaptureFixture[str]):
    emit(Output("", [["name"], [text], [-1.5]], {}), "csv", None)
    (_, (first,), (number,)) = csv.reader(io.StringIO(capsys.readouterr().out))
    assert (first, number) == (cell, "-1.5") or (not text and first == "")


@pytest.mark.parametrize(
    "name",
    ['my "plane"', "back\\slash", "new\nline", "tab\t", "\x7f", "$x", "\udcff", "é", "'''", "#"],
)
def test_a_new_file_is_toml_whatever_its_name(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.chdir(tmp_path)
    assert cli.main(["new", f"{name}.toml"]) == 0
    data = tomllib.loads(Path(f"{name}.toml").read_text())
    assert data["title"] == name.replace("\udcff", "?")
    assert gr.Aircraft.load(f"{name}.toml").title == data["title"].strip()
    assert tomllib.loads(template(name, f"{name}.toml"))["title"] == data["title"]


def test_a_name_in_a_picture_is_no_formula():
    run = gr.simulate(plane(r"$\frac$ a$b_"), v0=0.1, t=1.0, samples=11)
    ax = runway_view([run, run])
    ax.figure.canvas.draw()
    assert r"\$\frac\$ a\$b_" in ax.get_legend().get_texts()[0].get_text()


# --- Arguments --------------------------------------------------------------------------------


LONG = "a" * 300


@pytest.mark.parametrize(
    ("words", "code", "message"),
    [
        (["check", f"{LONG}.toml"], 1, "File name too long"),
        (["new", f"{LONG}.toml"], 1, "File name too long"),
        (["info", f"{LONG}.npz"], 1, "there is no such file"),
        (["new", "x.toml", "--like", "none.toml"], 1, "cannot read none.toml"),
        (["new", "x.toml", "--like", "folder.toml"], 1, "it is a folder"),
        (["new", "x.toml", "--like", "."], 1, "unknown aircraft '.'"),
        (["check", "pipe.toml"], 1, "it is no ordinary file"),
        (["fit-tire", "pipe.csv"], 1, "it is no ordinary file"),
        (["simulate", "brott", "--speed", "1e400"], 1, "must be finite"),
        (["map", "brott", "--x", f"a=0:1:{10**14}", "--y", "u=1:2"], 2, "not enough memory"),
        (["ensemble", "brott", "--v0", f"0:1:{10**14}"], 2, "not enough memory"),
    ],
)
def test_odd_arguments_are_refused_in_words(
    words: list[str],
    code: int,
    message: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "folder.toml").mkdir()
    for name in ("pipe.toml", "pipe.csv"):
        os.mkfifo(tmp_path / name)
    before = sorted(tmp_path.iterdir())
    assert cli.main(words) == code
    assert message in capsys.readouterr().err
    assert sorted(tmp_path.iterdir()) == before


P = gr.Aircraft.load("brott")


@pytest.mark.parametrize(
    "call",
    [
        lambda: gr.Aircraft.load(5),
        lambda: gr.Aircraft.load("x\0.toml"),
        lambda: gr.Aircraft("x", {5: 5}),
        lambda: gr.Aircraft("x", {"nonsense": 5}),
        lambda: gr.simulate(P, 5),
        lambda: gr.simulate(P, []),
        lambda: gr.simulate(P, v0=10**400),
        lambda: gr.simulate(P, v0=range(10**14)),
        lambda: gr.simulate(P, disturbance=np.broadcast_to(1.0, 10**12)),
        lambda: gr.ensemble(P, names=[5]),
        lambda: gr.ensemble(P, names=5),
        lambda: gr.ensemble(P, until=np.broadcast_to(1.0, 10**13)),
        lambda: gr.sweep(P, range(10**14)),
        lambda: gr.ensemble(P, extremes=[[]]),
        lambda: gr.ensemble(P, limits={5: 5}),
        lambda: gr.sweep(P, 5),
        lambda: gr.sweep(P, speed=np.broadcast_to(np.int64(10), 10**12)),
        lambda: gr.Result.load(5),
        lambda: gr.Result.load(f"{LONG}.npz"),
        lambda: gr.TireData.load(5),
        lambda: gr.fit_tire(5),
        lambda: gr.simulate(P, tire=5),
        lambda: gr.margins(5),
        lambda: gr.place_gear(P, 5),
        lambda: gr.trim(P, within=5),
        lambda: gr.trim(P, "rollout", slip=True),
        lambda: gr.trim(P, "nonlinear", starts="x"),
        lambda: gr.runway_view(5),
        lambda: gr.runway_view([5]),
        lambda: gr.pole_map(5),
    ],
)
def test_odd_values_are_refused_in_words(call: Callable[[], object]):
    with pytest.raises(GroundrollError):
        call()


def test_an_aircraft_is_given_by_symbol_or_by_name():
    assert float(gr.Aircraft("x", {"speed": 5})["u"]) == 5.0


# --- Files ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("a = " + "9" * 5000, "not valid TOML: Exceeds the limit"),
        ("mass = 0x" + "f" * 5000, "found what is too long to show"),
        ("a = " + "[" * 5000, "nested too deeply"),
        (".".join("a" * 5000) + " = 1", "mistake"),
        (" " * 3000 + "#\na b = 1", "not valid TOML"),
        ("".join(f"k{n} = 1\n" for n in range(20_000)), "20000 mistakes"),
        ("#" * 10**6, "no more than 262_144 are read"),
    ],
)
def test_odd_aircraft_files_are_refused_in_words(content: str, words: str, tmp_path: Path):
    path = tmp_path / "odd.toml"
    path.write_text(content)
    with pytest.raises(GroundrollError, match=words) as found:
        gr.Aircraft.load(path)
    assert len(str(found.value)) < 20_000


def test_of_many_mistakes_in_a_table_the_first_are_listed(tmp_path: Path):
    path = tmp_path / "odd.csv"
    path.write_text("slip_angle_deg,1,2\n" + "x,y,z\n" * 100_000)
    with pytest.raises(GroundrollError, match="300000 mistakes") as found:
        gr.TireData.load(path)
    assert len(str(found.value).splitlines()) == 52
    path.write_text("slip_angle_deg,1,2\n" + "1,2,3\n" * 10**6)
    with pytest.raises(GroundrollError, match="no more than 1_048_576 are read"):
        gr.TireData.load(path)
