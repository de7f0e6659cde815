"""What is installed works: from a wheel and from an sdist, with and without a C compiler."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tarfile
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
def site(source: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the package as a wheel built from the sdist puts it there."""
    wheels = tmp_path_factory.mktemp("wheels")
    pip("wheel", "--no-deps", "--no-build-isolation", "--wheel-dir", str(wheels), str(source))
    (wheel,) = wheels.glob("*.whl")
    folder = tmp_path_factory.mktemp("site")
    pip("install", "--no-deps", "--target", str(folder), str(wheel))
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
