"""The compiler and the cache: whatever they are, there is an answer, and one warning at most."""

import hashlib
import os
import re
import shutil
import stat
import subprocess
import sys
from pathlib import Path

import pytest

from groundroll import generated
from groundroll.generated import compiler, library

#: Prints two functions from two C files: how each is evaluated, and its value.
USE = """
from groundroll.generated import load
for name, arguments in (("magic_formula", [1, .8, 1.2, 1, .4]), ("f_follows", [4, 5])):
    function = load(name)
    print(function.class_name(), *[float(x).hex() for x in function.call(arguments)])
"""


def use(folder: Path, script: str = USE, **environment: str) -> tuple[list[str], list[str]]:
    """What a fresh interpreter with this cache folder prints, and how it warns."""
    run = subprocess.run(
        [sys.executable, "-W", "always", "-c", script],
        env={**os.environ, "GROUNDROLL_CACHE": str(folder), **environment},
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stderr
    return run.stdout.splitlines(), re.findall(r"Warning: (.*)", run.stderr)


def interpreted(lines: list[str]) -> list[str]:
    return [line.replace("External", "SXFunction") for line in lines]


@pytest.fixture(scope="module")
def filled(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, list[str]]:
    """A cache folder that holds two libraries, and what they print."""
    folder = tmp_path_factory.mktemp("cache") / "not" / "yet" / "there"
    printed, warned = use(folder)
    assert [line.split()[0] for line in printed] == ["External", "External"]
    assert warned == []
    return folder, printed


def test_the_cache_holds_each_library_once_and_nothing_else(filled: tuple[Path, list[str]]):
    folder, printed = filled
    before = {path.name: path.stat().st_mtime_ns for path in folder.iterdir()}
    assert use(folder) == (printed, [])
    assert {path.name: path.stat().st_mtime_ns for path in folder.iterdir()} == before
    assert sorted(re.sub(r"-\w{20}", "", name) for name in before) == [
        *(f"aircraft-{name}" for name in ("loads.sha256", "loads.so", "tire.sha256", "tire.so"))
    ]


@pytest.mark.parametrize("damage", ["garbage", "cut short", "empty", "seal gone"])
def test_a_damaged_library_is_compiled_again(
    damage: str, filled: tuple[Path, list[str]], tmp_path: Path
):
    folder, printed = filled
    copy = tmp_path / "cache"
    copy.mkdir()
    for path in folder.iterdir():
        (copy / path.name).write_bytes(path.read_bytes())
    (victim,) = copy.glob("aircraft-tire-*.so")
    good = victim.read_bytes()
    if damage == "seal gone":
        victim.with_suffix(".sha256").unlink()
    else:
        bad = {"garbage": b"not a library", "cut short": good[: len(good) // 2], "empty": b""}
        victim.write_bytes(bad[damage])

    again, warned = use(copy)
    assert again == printed
    assert warned == [f"{victim} is damaged; compiling it again"]
    assert use(copy) == (printed, [])


def test_two_processes_may_compile_at_once(filled: tuple[Path, list[str]], tmp_path: Path):
    _, printed = filled
    command = [sys.executable, "-W", "error", "-c", USE]
    environment = {**os.environ, "GROUNDROLL_CACHE": str(tmp_path / "cache")}
    both = [
        subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, text=True)
        for _ in range(2)
    ]
    assert [process.communicate()[0].splitlines() for process in both] == [printed, printed]


def test_a_cache_folder_that_cannot_be_written_is_done_without(
    filled: tuple[Path, list[str]], tmp_path: Path
):
    _, printed = filled
    temporary, file = tmp_path / "temporary", tmp_path / "file"
    temporary.mkdir()
    file.write_text("a folder cannot be made below a file, not even by root")
    again, warned = use(file / "cache", TMPDIR=str(temporary))
    assert again == printed
    assert len(warned) == 1
    assert f"cannot use the cache folder {file / 'cache'} (Not a directory)" in warned[0]
    assert "Set GROUNDROLL_CACHE" in warned[0]
    assert list(temporary.iterdir()) == []  # what it made instead is gone


@pytest.mark.parametrize("wanted", ["cc", "no-such-compiler"])
def test_without_a_compiler_the_virtual_machine_gives_the_same_numbers(
    wanted: str, filled: tuple[Path, list[str]], tmp_path: Path
):
    _, printed = filled
    again, warned = use(tmp_path / "cache", PATH=str(tmp_path), CC=wanted)
    assert again == interpreted(printed)
    assert len(warned) == 1
    assert f"no C compiler ({wanted} is not on the PATH; set CC)" in warned[0]
    assert "CasADi's virtual machine" in warned[0]


def fake_compiler(path: Path, text: str) -> Path:
    path.write_text(text)
    path.chmod(0o755)
    return path


def test_a_compiler_that_does_not_work_is_done_without(
    filled: tuple[Path, list[str]], tmp_path: Path
):
    broken = fake_compiler(tmp_path / "broken", "#!/bin/sh\necho no licence >&2\nexit 1\n")
    again, warned = use(tmp_path / "cache", CC=str(broken))
    assert again == interpreted(filled[1])
    assert len(warned) == 1
    assert f"{broken} failed: no licence" in warned[0]


def test_a_compiler_that_fails_on_every_file_is_complained_about_once(
    filled: tuple[Path, list[str]], tmp_path: Path
):
    script = '#!/bin/sh\ncase "$*" in *-E*) exit 0;; esac\necho disk full >&2\nexit 1\n'
    full = fake_compiler(tmp_path / "full", script)
    again, warned = use(tmp_path / "cache", CC=str(full))
    assert again == interpreted(filled[1])
    assert len(warned) == 1


def test_a_compiler_that_cannot_be_run_is_done_without(
    filled: tuple[Path, list[str]], tmp_path: Path
):
    garbage = fake_compiler(tmp_path / "garbage", "\x7fnot a program")
    again, warned = use(tmp_path / "cache", CC=str(garbage))
    assert again == interpreted(filled[1])
    assert len(warned) == 1


#: What `CC` may be, what is said of it, and whether it is a script to write.
ODD = {
    "makes nothing": ("#!/bin/sh\n", "made no library, though it did not complain"),
    "latin-1": ("#!/bin/sh\nprintf 'na\\357ve \\344' >&2\nexit 1\n", "failed: na"),
    "waits for input": ("#!/bin/sh\ncat\nexit 3\n", "failed: it said nothing"),
    "prints without end": ("#!/bin/sh\nexec yes\n", "failed: y"),
    "garbage": (
        "#!/bin/sh\nfor last; do before=$out; out=$last; done\n"
        'case "$*" in *-E*) ;; *) printf rubbish > "$before";; esac\n',
        "made a library that cannot be loaded: OSError",
    ),
    "another library": (
        "#!/bin/sh\nfor last; do before=$out; out=$last; done\n"
        'case "$*" in *-E*) ;; *) echo "int x;" | cc -shared -fPIC -x c - -o "$before";; esac\n',
        "undefined symbol",
    ),
}


@pytest.mark.parametrize("kind", ODD)
def test_an_odd_compiler_is_done_without(kind: str, filled: tuple[Path, list[str]], tmp_path: Path):
    script, said = ODD[kind]
    odd = fake_compiler(tmp_path / "odd", script)
    again, warned = use(tmp_path / "cache", CC=str(odd))
    assert again == interpreted(filled[1])
    assert len(warned) == 1
    assert said in warned[0]
    assert list(tmp_path.glob("cache/*")) == []


@pytest.mark.parametrize(
    ("wanted", "said"),
    [("true", "made no library"), ("gcc '", "which is no command"), ("/", "is not on the PATH")],
)
def test_an_odd_name_of_a_compiler_is_done_without(
    wanted: str, said: str, filled: tuple[Path, list[str]], tmp_path: Path
):
    again, warned = use(tmp_path / "cache", CC=wanted)
    assert again == interpreted(filled[1])
    assert len(warned) == 1
    assert said in warned[0]


def test_a_blank_name_of_a_compiler_is_none(filled: tuple[Path, list[str]], tmp_path: Path):
    assert use(tmp_path / "cache", CC="  ") == (filled[1], [])


def test_a_compiler_that_takes_for_ever_is_ended(tmp_path: Path):
    slow = fake_compiler(tmp_path / "slow", "#!/bin/sh\nsleep 1000\n")
    with pytest.raises(compiler.NoCompilerError, match=r"slow failed: not done after 0\.2 s"):
        compiler._run([str(slow)], 0.2)


def test_a_sealed_library_that_cannot_be_loaded_here_is_done_without(
    filled: tuple[Path, list[str]], tmp_path: Path
):
    """As in a cache that another machine has filled."""
    copy = shutil.copytree(filled[0], tmp_path / "cache")
    for path in copy.glob("*.so"):
        path.write_bytes(b"of another machine")
        seal = hashlib.sha256(path.read_bytes()).hexdigest()
        path.with_suffix(".sha256").write_text(seal)
    again, warned = use(copy)
    assert again == interpreted(filled[1])
    assert len(warned) == 1
    assert "cannot be loaded" in warned[0]
    assert "CasADi's virtual machine" in warned[0]


# --- The cache is the user's own ------------------------------------------------------------


def test_the_cache_is_closed_to_others_whatever_the_umask(tmp_path: Path):
    folder = tmp_path / "not" / "yet" / "there"
    use(folder, f"import os; os.umask(0)\n{USE}")
    assert [stat.S_IMODE(p.stat().st_mode) for p in (folder, *folder.parents[:2])] == [0o700] * 3


@pytest.mark.parametrize("mode", [0o777, 0o720])
def test_a_cache_that_others_can_write_to_is_not_used(
    mode: int, filled: tuple[Path, list[str]], tmp_path: Path
):
    copy = shutil.copytree(filled[0], tmp_path / "cache")
    copy.chmod(mode)
    for path in copy.glob("*.so"):
        path.write_bytes(b"planted")
        path.with_suffix(".sha256").write_text(hashlib.sha256(b"planted").hexdigest())
    again, warned = use(copy)
    assert again == filled[1]
    assert len(warned) == 1
    assert f"{copy} (others can write to it; chmod 700 makes it yours)" in warned[0]


def test_a_cache_of_somebody_else_is_not_used(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(os, "geteuid", lambda: tmp_path.stat().st_uid + 1)
    with pytest.raises(PermissionError, match="it belongs to another user"):
        library._refuse_unfit(tmp_path)


def test_a_folder_mounted_noexec_is_not_used(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    about = os.statvfs(tmp_path)
    fields = [*about[:8], about.f_flag | os.ST_NOEXEC, *about[9:]]
    monkeypatch.setattr(os, "statvfs", lambda path: os.statvfs_result(fields))
    with pytest.raises(PermissionError, match="it is mounted noexec"):
        library._refuse_unfit(tmp_path)


def test_without_a_home_it_compiles_for_the_process(filled: tuple[Path, list[str]]):
    homeless = "import pathlib\ndef no(): raise RuntimeError('no home')\npathlib.Path.home = no"
    again, warned = use(Path(), f"{homeless}\n{USE}", GROUNDROLL_CACHE="", XDG_CACHE_HOME="")
    assert again == filled[1]
    assert len(warned) == 1
    assert "of a user without a home" in warned[0]


def test_what_killed_builds_have_left_is_removed(tmp_path: Path):
    folder = tmp_path / "cache"
    folder.mkdir(mode=0o700)
    (folder / "build-now").mkdir()
    (folder / "build-long-ago").mkdir()
    os.utime(folder / "build-long-ago", (0, 0))
    use(folder)
    assert sorted(p.name for p in folder.glob("build-*")) == ["build-now"]


def test_whoever_sits_at_a_terminal_hears_of_compilation(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
):
    pack = generated.PACKS["aircraft"]
    function = next(name for name, (*_, c_file) in pack.functions.items() if c_file == "kick")

    def compiled() -> Path:
        return library.compiled(pack.folder / "c" / "kick.c", pack.digest, symbol=function)

    monkeypatch.setattr(library, "_cache_folder", lambda: tmp_path)
    compiled()
    assert capsys.readouterr().err == ""
    for file in tmp_path.iterdir():
        file.unlink()
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    assert compiled() == compiled()
    assert capsys.readouterr().err == "\rcompiling aircraft kick, once for this machine\n"
