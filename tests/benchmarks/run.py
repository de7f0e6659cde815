"""groundroll, the limit of the machine and other tools, side by side: `make bench`.

Each peer runs in its own environment, or as a program of the system, and is left out, as missing,
where there is none; `--install` makes the environments. The table and the picture go to `results/`.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
#: Peer -> what to install.
PEERS = {
    "heyoka": ["heyoka", "numpy"],
    "scipy": ["scipy", "numba", "numpy"],
    "jax": ["jax[cpu]", "diffrax", "numpy"],
    "numbalsoda": ["numbalsoda", "numba", "numpy"],
    "casadi": ["casadi", "numpy"],
}
#: Peer -> its program, of the system.
PROGRAMS = {"octave": "octave-cli"}
JOBS = {
    "E10000": "10,000 trajectories, final state at 5 s",
    "E100000": "100,000 trajectories, final state at 5 s",
    "S": "one trajectory, 501 outputs",
    "L": "1,000,000 linearisations, into arrays that are there",
    "N": "1,000,000 linearisations, into new arrays",
}
_SHORT = {"E10000": "10,000 trajectories", "S": "One trajectory, 501 outputs"}
Row = dict[str, Any]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--venvs", type=Path, default=HERE.parents[1] / "build" / "bench-venvs")
    parser.add_argument("--install", action="store_true", help="make the peers' environments")
    parser.add_argument("--out", type=Path, default=HERE / "results")
    parser.add_argument("--only", nargs="*", default=[*PEERS, *PROGRAMS], help="which peers")
    options = parser.parse_args()
    if options.install:
        install(options.venvs, options.only)
    with tempfile.TemporaryDirectory() as folder:
        build = [sys.executable, str(HERE / "build.py"), folder]
        subprocess.run(build, check=True)
        rows, missing = collect(Path(folder), options.venvs, options.only)
    options.out.mkdir(parents=True, exist_ok=True)
    text = "\n".join(json.dumps(row) for row in rows)
    (options.out / "results.jsonl").write_text(f"{text}\n")
    (options.out / "results.md").write_text(report(rows, missing))
    picture(rows, options.out / "results.svg")
    print(f"wrote {options.out}/results.md")


def install(venvs: Path, peers: list[str]) -> None:
    for name in peers:
        if name in PEERS and not (venvs / name).exists():
            subprocess.run([sys.executable, "-m", "venv", str(venvs / name)], check=True)
            command = [str(python(venvs, name)), "-m", "pip", "install", "-q", *PEERS[name]]
            if subprocess.run(command, check=False).returncode:
                print(f"{name} cannot be installed here", file=sys.stderr)


def python(venvs: Path, name: str) -> Path | None:
    """What runs a peer's script, if the peer is there."""
    if name in PROGRAMS:
        return Path(sys.executable) if shutil.which(PROGRAMS[name]) else None
    found = venvs / name / "bin" / "python"
    return found if found.exists() else None


def collect(folder: Path, venvs: Path, peers: list[str]) -> tuple[list[Row], dict[str, str]]:
    """Rows of every tool that is there, and why the others are not."""
    rows = list(run([sys.executable, str(HERE / "ours.py"), str(folder)]))
    if not rows:
        sys.exit("groundroll itself did not run")
    missing = {}
    for name in peers:
        interpreter = python(venvs, name)
        if interpreter is None:
            missing[name] = "not installed"
        elif found := list(run([str(interpreter), str(HERE / f"peer_{name}.py"), str(folder)])):
            rows += found
        else:
            missing[name] = "installed, but it does not run here"
    return rows, missing


def run(command: list[str]) -> Iterator[Row]:
    environment = {
        **os.environ,
        "OMP_NUM_THREADS": "1",
        "XLA_FLAGS": "--xla_cpu_multi_thread_eigen=false",
    }
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment) as process:
        assert process.stdout is not None
        for line in process.stdout:
            if line.startswith("{"):
                row = json.loads(line)
                print(
                    f"{row['tool']:12} {row['job']:8} {row['variant']:28} {row['ratio']:9.2f}",
                    flush=True,
                )
                yield row


# --- What comes of it -----------------------------------------------------------------------


def machine() -> str:
    model = platform.processor() or platform.machine()
    info = Path("/proc/cpuinfo")
    if info.exists():
        lines = info.read_text().splitlines()
        model = next((x.split(":")[1].strip() for x in lines if x.startswith("model name")), model)
        flags = next((x for x in lines if x.startswith("flags")), "")
        model += ", AVX-512" if "avx512f" in flags else ", AVX2" if "avx2" in flags else ""
    compiler = subprocess.run(["gcc", "--version"], capture_output=True, text=True, check=False)
    gcc = compiler.stdout.splitlines()[0] if compiler.stdout else "no gcc"
    return f"{model}, {os.cpu_count()} processors, {gcc}, Python {platform.python_version()}"


def report(rows: list[Row], missing: dict[str, str]) -> str:
    """Markdown: for each job and error the tools by their ratio to the limit."""
    versions = sorted({f"{row['tool']} {row['version']}" for row in rows})
    lines = [
        "# Benchmark",
        "",
        f"{machine()}. {'; '.join(versions)}.",
        "",
        "Ratio: time over that of hand-written C for exactly this model (`limit.c`), which knows",
        "the answer; median of samples that alternate with it. Error: measured against 80-bit",
        "arithmetic, worst over trajectories and states. Every tool has the coarsest tolerance (of",
        "two a decade) with which it meets the error; *tol = error* is groundroll given the error",
        "that is wanted, without knowing the answer.",
        "",
    ]
    for job, title in JOBS.items():
        for target in sorted({row["target"] for row in rows if row["job"] == job}, reverse=True):
            bound = "" if job in ("L", "N") else f", error below {target:g}"
            columns = ("tool", "threads", "setting", "error", "time", "ratio")
            lines += [f"## {title}{bound}", "", f"| {' | '.join(columns)} |"]
            lines.append("|---" * len(columns) + "|")
            same = [r for r in rows if r["job"] == job and r["target"] == target]
            for row in sorted(same, key=lambda r: (r["threads"], r["ratio"])):
                error = "–" if row["error"] is None else f"{row['error']:.1e}"
                name = f"{row['tool']}, {row['variant']}"
                name = f"**{name}**" if row["tool"] == "groundroll" else name
                lines.append(
                    f"| {name} | {row['threads']} | {row['setting']} | {error}"
                    f" | {duration(row['seconds'])} | {digits(row['ratio'])} |"
                )
            lines.append("")
    lines += [f"Missing: {name} ({why})." for name, why in missing.items()]
    return "\n".join([*lines, ""])


def digits(number: float) -> str:
    """Three of them, and no exponent."""
    return f"{float(f'{number:.3g}'):g}"


def duration(seconds: float) -> str:
    for unit, size in (("s", 1.0), ("ms", 1e-3)):
        if seconds >= size:
            return f"{digits(seconds / size)} {unit}"
    return f"{seconds * 1e6:.3g} µs"


def picture(rows: list[Row], path: Path) -> None:
    """The best of each tool for each job, on one thread, as ratio to the limit."""
    import matplotlib as mpl

    mpl.use("Agg")
    from matplotlib import pyplot

    from groundroll.view.plots import COLOURS, INK, style

    jobs = [(job, target) for job in ("E10000", "S") for target in (1e-6, 1e-9)]
    with style():
        figure, axes = pyplot.subplots(2, 2, figsize=(8.4, 6.0), sharex=True)
        for ax, (job, target) in zip(axes.flat, jobs, strict=True):
            best: dict[str, float] = {}
            for row in rows:
                if (row["job"], row["target"], row["threads"]) == (job, target, 1):
                    name = row["tool"]
                    if name == "groundroll" and row["variant"] != "tuned":
                        name = "groundroll, tol = error"
                    best[name] = min(best.get(name, float("inf")), row["ratio"])
            names = sorted(best, key=lambda n: -best[n])
            ours = [COLOURS[0] if n.startswith("groundroll") else "#B8B8B8" for n in names]
            values = [best[n] for n in names]
            ax.barh(names, values, color=ours, edgecolor=INK, linewidth=0.5)
            for k, value in enumerate(values):
                ax.annotate(digits(value), (value, k), (3, 0), textcoords="offset points",
                            va="center", fontsize=7.5)  # fmt: skip
            ax.axvline(1.0, color=INK, linewidth=0.9)
            ax.set_xscale("log")
            ax.margins(x=0.25)
            ax.set_title(f"{_SHORT[job]}, error ≤ {target:g}")
        for ax in axes[1]:
            ax.set_xlabel("time / hand-written C, one thread")
        figure.savefig(path)
        figure.savefig(path.with_suffix(".png"), dpi=110)


if __name__ == "__main__":
    main()
