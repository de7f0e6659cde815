"""Build the hand-written limit and the reference; find the limit's step counts by the reference."""

from __future__ import annotations

import ctypes
import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import common
import numpy as np

HERE = Path(__file__).resolve().parent
NUMBERS = json.loads((HERE.parents[1] / "derive" / "simd" / "coefficients.json").read_text())
STAGES, DENSE = 12, 16
COMMAND = ["gcc", "-march=native", "-fopenmp", "-fPIC", "-shared", "-std=gnu11", "-w"]
LIMIT_FLAGS = ["-Ofast", "-mprefer-vector-width=512"]


def total(row: list[float], term: str) -> str:
    """Sum of coefficients times a term, without the zeros."""
    return " + ".join(f"{c!r} * {term.format(j=j)}" for j, c in enumerate(row) if c)


def horner(coefficients: list[float]) -> str:
    text = repr(coefficients[-1])
    for c in reversed(coefficients[:-1]):
        text = f"({c!r} + s2 * {text})"
    return text


def constants() -> str:
    """``constants.h``: the tableau as code, the polynomial of atan, the aircraft."""
    table = NUMBERS["dop853"]
    A, B, D = table["A"], table["B"], table["D"]
    stages, single = [], []
    for s in range(1, STAGES):
        sums = [f"s{x}[k] = {x}[k] + h * ({total(A[s], f'k{x}[{{j}}][k]')});" for x in "vr"]
        stages.append(f"EACH {{ {' '.join(sums)} }} rates(p, sv, sr, kv[{s}], kr[{s}]);")
        single.append(f"w = x + h * ({total(A[s], 'f[{j}]')}); f[{s}] = s_rates(&p, w);")
    single.append(f"w = x + h * ({total(B, 'f[{j}]')}); f[12] = s_rates(&p, w);")
    dense = [
        f"z = x + h * ({total(A[s], 'f[{j}]')}); f[{s}] = s_rates(&p, z);"
        for s in range(STAGES + 1, DENSE)
    ]
    dense += [
        "d[0] = w - x;",
        "d[1] = h * f[0] - d[0];",
        "d[2] = 2 * d[0] - h * (f[12] + f[0]);",
        *(f"d[{3 + n}] = h * ({total(row, 'f[{j}]')});" for n, row in enumerate(D)),
    ]
    quadrature = [sum(B[s] * A[s][j] for s in range(j + 1, STAGES)) for j in range(STAGES)]
    atan = NUMBERS["atan"]["coefficients"]
    rows = ["{" + ", ".join(map(repr, [*A[s], 0.0][: max(1, s)])) + "}" for s in range(STAGES)]
    eighth = NUMBERS["tan_pi_8"]
    lines = {
        "STAGES": " ".join(stages),
        "LAST_SUM(K)": f"({total(B, 'K[{j}][k]')})",
        "QUADRATURE_SUM(K)": f"({total(quadrature, 'K[{j}][k]')})",
        "WEIGHT_SUM": repr(sum(B)),
        "SINGLE_STAGES": " ".join(single),
        "SINGLE_DENSE": " ".join(dense),
        "ATAN_POLYNOMIAL": f"{horner(atan[0::2])} + s * {horner(atan[1::2])}",
        "TAN_PI_8": repr(eighth),
        "COT_PI_8": repr(1 / eighth),
        "T_END": repr(common.T_END),
        **{name: repr(value) for name, value in common.CONSTANTS.items()},
    }
    text = "".join(f"#define {name} {value}\n" for name, value in lines.items())
    text += f"static const double A_TABLE[12][12] = {{{', '.join(rows)}}};\n"
    return text + f"static const double B_TABLE[12] = {{{', '.join(map(repr, B))}}};\n"


def compile_c(name: str, flags: list[str], folder: Path) -> Path:
    library = folder / f"{name}.so"
    command = [*COMMAND, *flags, f"-I{folder}", str(HERE / f"{name}.c"), "-o", str(library), "-lm"]
    subprocess.run(command, check=True)
    return library


def pointer(array: np.ndarray) -> ctypes.c_void_p:
    return ctypes.c_void_p(array.ctypes.data)


def references(folder: Path, reference: ctypes.CDLL) -> None:
    """Final states and ranges of all trajectories, and one over time, in 80 bits."""
    D, N = ctypes.c_double, ctypes.c_int64
    columns = common.draw(common.MOST)
    final, scale = np.empty((common.MOST, 4)), np.empty((common.MOST, 4))
    reference.reference_ensemble(
        N(common.MOST), *map(pointer, columns), N(250), pointer(final), pointer(scale)
    )
    one, most = np.empty((common.TIMES.size, 4)), np.empty(4)
    start = (D(common.SINGLE[k]) for k in ("a", "Ct", "u", "v0"))
    reference.reference_single(*start, N(common.TIMES.size), N(2), pointer(one), pointer(most))
    np.savez(folder / "reference.npz", final=final, scale=scale, single=one)


def tune(folder: Path) -> None:
    """Fewest steps of the limit that meet each error."""
    found: dict[str, Any] = {}
    limit = common.Limit(folder, {})
    confirmed = common.ensemble_error(folder, limit.ensemble(common.MOST, 600)())
    if confirmed > 1e-11:
        sys.exit(f"limit and reference differ by {confirmed:.1e}")
    for target in common.TARGETS:
        for n in (10_000, 100_000):
            steps = 5
            while common.ensemble_error(folder, limit.ensemble(n, steps)()) > target:
                steps += 1
            found[f"E{n}/{target:g}"] = steps
        ways = ((steps, 1 + g / 100) for steps in range(5, 100) for g in range(31))
        fits = (w for w in ways if common.single_error(folder, limit.single(*w)()) <= target)
        found[f"S/{target:g}"] = next(fits)
    (folder / "limits.json").write_text(json.dumps(found, indent=1) + "\n")
    print(f"limit: {found}, limit and reference agree to {confirmed:.1e}")


def main() -> None:
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "constants.h").write_text(constants())
    compile_c("limit", LIMIT_FLAGS, folder)
    reference = ctypes.CDLL(str(compile_c("reference", ["-O2"], folder)))
    os.environ.setdefault("OMP_NUM_THREADS", str(len(os.sched_getaffinity(0))))
    references(folder, reference)
    tune(folder)


if __name__ == "__main__":
    main()
