"""Command lines with right words and wrong ones, run in this process in an empty folder."""

from __future__ import annotations

import contextlib
import csv
import io
import json
import math
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

import groundroll as gr
from groundroll import cli
from groundroll.base.errors import GroundrollError

from . import judges, mutation, truth
from .harness import Case

_AIRCRAFT = ("brott", "brott-physical", "cessna-170", "cessna-172p")
_ODD = (
    *("", " ", "--", "-", "x", "1e400", "nan", "inf", "-inf", "1 furlong per", "5 dB", "5:", ":5"),
    *("1:2:3:4", "2:1", "1:1", f"0:1:{10**14}", "0:1:1", "0:1:x", "a=", "=1", "a=b=c", "v0"),
    *("9" * 400, "a" * 300, "../../x", "/dev/null", ".", "none.toml", "\x1b[31m", "é", "\udcff"),
    *("-1", "0", "1", "10", "1,5", "1_0", "0x10", "true", "None", "[]", "1 kg^9^9", "linear"),
)
#: Options of each command with the unit of their value, or what they take.
_OPTIONS: dict[str, dict[str, Any]] = {
    "simulate": {
        "--v0": "m/s",
        "--r0": "rad/s",
        "--y0": "m",
        "--psi0": "rad",
        "--t": "t",
        "--speed": "speed",
        "--disturbance": "N",
        "--samples": ("2", "5", "50"),
        "--gust": ("step", "one_minus_cosine"),
        "--tol": ("1e-6", "1e-9"),
    },
    "linearize": {"--v": "m/s", "--r": "rad/s", "--speed": "speed", "--disturbance": "N"},
    "trim": {"--speed": "speed", "--disturbance": "N"},
    "check": {"--strict": ()},
    "ensemble": {
        "--v0": "m/s",
        "--t": "t",
        "--speed": "speed",
        "--threads": ("1", "9999999"),
        "--vary": ("speed=10:20:3", "r0=0:0.1:2", "a=0 m:0.5 m:3", "m=1000 kg:1200 kg:2"),
        "--limits": ("psi=1 deg", "v=0.1"),
        "--extremes": ("v", "psi"),
        "--random": ("3",),
    },
    "map": {
        "--x": ("speed=10:30:3", "a=0:1:4"),
        "--y": ("Ct=0:5000:3", "b=3 m:12 ft:2"),
        "--of": ("decay_rate", "damping_ratio", "static_margin"),
    },
    "info": {},
    "new": {"--like": _AIRCRAFT, "--force": ()},
}
_SET = ("mass=1650 lb", "a=0.5", "Ct=", "main_gear_arm=20 in", "u=30", "Izz=1000 kg m^2")
_RANGES = {"m/s": (-1, 1), "rad/s": (-0.2, 0.2), "m": (-1, 1), "rad": (-0.1, 0.1), "N": (-300, 300)}


class Said(NamedTuple):
    """What a command said and left."""

    code: int
    out: str
    err: str
    files: tuple[str, ...]


def lines(rng: np.random.Generator, model: str, folder: Path) -> Case:
    """A command line."""
    command = str(mutation.pick(rng, tuple(_OPTIONS)))
    words, given = _words(rng, command, model)
    is_plain = True
    for _ in range(int(rng.integers(3)) if rng.random() < 0.5 else 0):
        is_plain = False
        at = int(rng.integers(len(words) + 1))
        kind = int(rng.integers(4))
        odd = str(mutation.pick(rng, _ODD))
        if kind == 0:
            words.insert(at, odd)
        elif kind == 1 and words:
            words[at % len(words)] = odd
        elif kind == 2 and words:
            del words[at % len(words)]
        else:
            words.insert(at, str(mutation.pick(rng, ("--format", "--out", "--set", "--nonsense"))))

    def judge(said: Said) -> str | None:
        return _judged(words, command, model if is_plain else None, given, said)

    return Case(f"groundroll {words!r}", lambda: _said(words, folder), judge)


def _words(
    rng: np.random.Generator, command: str, model: str
) -> tuple[list[str], dict[str, float]]:
    words, given = [command], {}
    if command == "new":
        words.append("mine.toml")
    elif command != "info":
        words.append(str(mutation.pick(rng, _AIRCRAFT)))
    if command in ("simulate", "linearize", "trim", "ensemble"):
        words += ["--model", model]
    required = ("--x", "--y") if command == "map" else ()
    for option, kind in _OPTIONS[command].items():
        if option not in required and rng.random() < 0.6:
            continue
        words.append(option)
        if isinstance(kind, str):
            low, high, unit = _range(kind)
            written = str(mutation.pick(rng, truth.WRITTEN.get(unit, (unit,))))
            size = truth.value(f"1 {written}", unit) or 1.0
            text = f"{rng.uniform(low, high) / size:.6g} {written}"
            given[option] = float(truth.value(text, unit) or 0.0)
            words.append(text)
        elif kind:
            words.append(str(mutation.pick(rng, kind)))
    if command not in ("info", "new") and rng.random() < 0.3:
        words += ["--set", str(mutation.pick(rng, _SET))]
    if command != "new":
        words += ["--format", str(mutation.pick(rng, ("json", "json", "csv", "table")))]
        if rng.random() < 0.2:
            words += ["--out", str(mutation.pick(rng, ("out.json", "out.csv", "kept.npz", "x")))]
    if command in ("simulate", "ensemble", "map"):
        words.append("--no-plot")
    return words, given


def _range(kind: str) -> tuple[float, float, str]:
    if kind == "t":
        return 0.005, 0.02, "s"
    if kind == "speed":
        return 5.0, 50.0, "m/s"
    return *_RANGES[kind], kind


def _said(words: list[str], folder: Path) -> Said:
    before = Path.cwd()
    out, err = io.StringIO(), io.StringIO()
    os.chdir(folder)
    try:
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            try:
                code = cli.main(words)
            except SystemExit as ended:
                code = int(ended.code or 0)
        files = tuple(sorted(os.listdir(".")))
        is_answer = words[:1] == ["check"] and "--strict" in words and code == 1
        if code and not (is_answer and (out.getvalue() or files)):
            refused = err.getvalue()
            if not refused.strip() or "Traceback" in refused or code not in (1, 2):
                raise AssertionError(f"code {code}: {refused!r}")
            raise GroundrollError(refused)
        return Said(code, out.getvalue(), err.getvalue(), files)
    finally:
        os.chdir(before)


def _judged(
    words: list[str], command: str, model: str | None, given: dict[str, float], said: Said
) -> str | None:
    """Whether what is said is what a call gives, in a form that can be read."""
    if {"\x1b", "\x9b"} & set(said.out + said.err):
        return "a terminal would obey this"
    if model is None or "--out" in words:
        odd = [f for f in said.files if f not in ("out.json", "out.csv", "kept.npz", "x")]
        return f"left behind: {odd}" if odd and model and command != "new" else None
    if "json" not in words:
        if "csv" in words:
            widths = {len(row) for row in csv.reader(io.StringIO(said.out))}
            return "" if len(widths) == 1 else f"rows of widths {widths}"
        return "" if said.out.strip() or command == "new" else "nothing was said"
    data = json.loads(said.out, parse_constant=_no_constant)
    judge = _JUDGES.get(command)
    if judge is None or "--set" in words or "--gust" in words:
        return _finite(data)
    return _finite(data) or judge(words[1], model, given, data)


def _no_constant(text: str) -> float:
    raise ValueError(f"{text} is no JSON")


def _finite(data: Any) -> str:
    return "" if isinstance(data, dict) and data else "nothing was said"


def _linearize(name: str, model: str, given: dict[str, float], data: Any) -> str:
    plane = gr.Aircraft.load(name)
    if "--speed" in given:
        plane = plane.replace(u=given["--speed"])
    at = {key[2:]: v for key, v in given.items() if key in ("--v", "--r", "--disturbance")}
    lin = gr.linearize(plane, model, **at)
    wrong = judges.linearization(lin, {})
    if wrong:
        return wrong
    for matrix in ("A", "B"):
        right = getattr(lin, matrix)
        found, noise = (
            np.array(data[matrix], float).reshape(right.shape),
            1e-12 * np.abs(right).max(),
        )
        if not np.allclose(found, right, 1e-9, noise):
            return f"{matrix}: {data[matrix]}"
    return ""


def _trim(name: str, model: str, given: dict[str, float], data: Any) -> str:
    options = {key[2:]: v for key, v in given.items()}
    found = gr.trim(gr.Aircraft.load(name), model, **options)
    wrong = judges.turns(found)
    shown = [x for x in _numbers(data) if math.isfinite(x)]
    lacking = [v for v in found["v"][: int(found.count)] if not np.isclose(shown, v, 1e-9).any()]
    return wrong or (f"{lacking} are not shown" if lacking else "")


def _numbers(data: Any) -> list[float]:
    if isinstance(data, dict):
        return [x for item in data.values() for x in _numbers(item)]
    if isinstance(data, list):
        return [x for item in data for x in _numbers(item)]
    return [float(data)] if isinstance(data, int | float) else []


def _simulate(name: str, model: str, given: dict[str, float], data: Any) -> str | None:
    call = {key[2:]: v for key, v in given.items()}
    v = np.array(data["v"], float)
    run = gr.simulate(gr.Aircraft.load(name), model, samples=v.size, **call)
    return judges.trajectory(run, 1e-9) or ("" if np.allclose(run["v"], v, 1e-4, 1e-7) else "v")


_JUDGES: dict[str, Callable[[str, str, dict[str, float], Any], str | None]] = {
    "linearize": _linearize,
    "trim": _trim,
    "simulate": _simulate,
}
