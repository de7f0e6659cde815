"""What is installed works: from a wheel and from an sdist, with and without a C compiler."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tarfile
import venv
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
USE = """
import warnings
warnings.simplefilter("ignore", RuntimeWarning)
import groundroll as gr
assert "site" in gr.__file__, gr.__file__
run = gr.simulate(gr.Aircraft.load("brott"), v0=0.1, t=1.0, samples=11)
print(f"{run['y'][-1]:.12f}")
"""


def pip(*arguments: str) -> None:
    command = [sys.executable, "-m", "pip", "--disable-pip-version-check", *arguments]
    subprocess.run(command, check=True, capture_output=True)


@pytest.fixture(scope="module")
def source(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An sdist of the tracked files, unpacked."""
    folder = tmp_path_factory.mktemp("source")
    tracked = subprocess.run(
        ["git", "ls-files", "-z"], cwd=ROOT, check=True, capture_output=True, text=True
    ).stdout
    for name in filter(None, tracked.split("\0")):
        if (ROOT / name).is_file():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, folder / name)
    build = "import setuptools.build_meta as b; print(b.build_sdist('dist'))"
    made = subprocess.run(
        [sys.executable, "-c", build], cwd=folder, check=True, capture_output=True, text=True
    )
    with tarfile.open(folder / "dist" / made.stdout.split()[-1]) as archive:
        archive.extractall(folder / "unpacked", filter="data")
    (unpacked,) = (folder / "unpacked").iterdir()
    return unpacked


@pytest.fixture(scope="module")
def wheel(source: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A wheel built from the sdist."""
    wheels = tmp_path_factory.mktemp("wheels")
    pip("wheel", "--no-deps", "--no-build-isolation", "--wheel-dir", str(wheels), str(source))
    (made,) = wheels.glob("*.whl")
    return made


@pytest.fixture(scope="module")
def site(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the package as the wheel puts it there."""
    folder = tmp_path_factory.mktemp("site")
    pip("install", "--no-deps", "--target", str(folder), str(wheel))
    return folder


@pytest.fixture(scope="module")
def environment(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An environment that holds the wheel and what this one has, but for the checkout."""
    folder = tmp_path_factory.mktemp("environment")
    venv.create(folder, with_pip=False)
    (home,) = folder.glob("lib/python*/site-packages")
    dependencies = [path for path in sys.path if path.endswith("site-packages")]
    (home / "dependencies.pth").write_text("\n".join(dependencies))
    python = ("--python", str(folder / "bin" / "python"))
    pip(*python, "install", "--no-deps", "--no-index", "--ignore-installed", str(wheel))
    return folder


def use(site: Path, folder: Path, **environment: str) -> str:
    """Run a simulation with the installed package, the dependencies being those of this one."""
    variables = {**os.environ, "PYTHONPATH": str(site), "GROUNDROLL_CACHE": str(folder / "cache")}
    command = [sys.executable, "-c", USE]
    result = subprocess.run(
        command,
        cwd=folder,
        env={**variables, **environment},
        capture_output=True,
        text=True,
        check=False,
    )
    assert result.returncode == 0, result.stderr
    return result.stdout


def test_a_wheel_carries_all_it_needs(site: Path, tmp_path: Path) -> None:
    compiled = use(site, tmp_path)
    assert list((tmp_path / "cache").glob("nonlinear-*.so"))
    assert use(site, tmp_path / "..", CC="no-such-compiler") == compiled


@pytest.mark.parametrize(
    "name",
    [
        *(
            "py.typed",
            "__init__.pyi",
            "aircraft/fleet/brott.toml",
            "tires/goodyear-6.00-6.csv",
            "study/report.html.j2",
        ),
        *("generated/nonlinear/c/rk45.c", "generated/nonlinear/EQUATIONS.md"),
        *("generated/nonlinear/facts.json", "generated/nonlinear/model.py"),
        *("derive/core/model.py", "derive/emit/simd/ensemble.c"),
    ],
)
def test_data_is_installed(site: Path, name: str) -> None:
    assert (site / "groundroll" / name).is_file()


# --- A model of one's own, without a checkout -----------------------------------------------------

CAR = """
m = 1500.0
Izz = 2500.0
g = 9.81

[parameters]
l_front = "1.2 m"
l_rear = "1.6 m"
width = "1.5 m"
C_front = "120 kN/rad"
C_rear = "150 kN/rad"
grip = 0.9
wheel_load = "3.6 kN"
"""


def test_a_model_of_ones_own_needs_the_wheel_and_no_checkout(
    environment: Path, tmp_path: Path
) -> None:
    shutil.copy(Path(__file__).parent / "models" / "four_wheels.py", tmp_path / "mine.py")
    (tmp_path / "car.toml").write_text(CAR)
    variables = {k: x for k, x in os.environ.items() if not k.startswith("PYTHON")}
    variables["GROUNDROLL_CACHE"] = str(tmp_path / "cache")

    def run(program: str, *words: str) -> str:
        done = subprocess.run(
            [environment / "bin" / program, *words],
            cwd=tmp_path,
            env=variables,
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == 0, done.stderr
        return done.stdout

    home = run("python", "-c", "import groundroll; print(groundroll.__file__)")
    assert Path(home.strip()).is_relative_to(environment)
    run("groundroll", "derive", "mine.py", "--out", "mine/")
    written = {p.relative_to(tmp_path / "mine").as_posix() for p in tmp_path.rglob("mine/**/*")}
    assert {"facts.json", "EQUATIONS.md", "model.py", "c/rk45.c"} <= written
    words = ("car.toml", "--model", "mine/", "--input", "steering=3 deg")
    told = run("groundroll", "simulate", *words, "--start", "u=72 km/h", "--plot", "run.png")
    assert "car, four_wheels model, 20 m/s" in told
    assert (tmp_path / "run.png").is_file()
    assert list((tmp_path / "cache").glob("*four_wheels*.so")) or list(tmp_path.rglob("*.so"))
    kept = run("groundroll", "linearize", *words, "--at", "u=72 km/h", "--out", "lin.npz")
    assert kept == ""
    script = "import groundroll as gr; print(gr.Linearization.load('lin.npz').inputs)"
    assert run("python", "-c", script).strip() == "('steering', 'brake_left', 'brake_right')"
