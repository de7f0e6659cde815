"""The elementary functions of the kernels, against arithmetic of many digits."""

from __future__ import annotations

import ctypes
import math
import subprocess

import mpmath as mp
import numpy as np
import pytest

from groundroll.derive.simd.lanes import elementary

#: Largest error in units of the last place.
ULPS = {"atan": 2.5, "sin": 2.5, "cos": 2.5, "tan": 4.0}
POINTS = 4000


@pytest.fixture(scope="module")
def library(tmp_path_factory: pytest.TempPathFactory) -> ctypes.CDLL:
    """Every function over an array."""
    folder = tmp_path_factory.mktemp("elementary")
    text = "#include <math.h>\n#include <stdint.h>\n#include <string.h>\n"
    text += f"#define INLINE static inline __attribute__((always_inline))\n{elementary()}"
    for name in ULPS:
        text += (
            f"void many_{name}(int n, const double *x, double *y)\n"
            f"{{ for (int i = 0; i < n; ++i) y[i] = lane_{name}(x[i]); }}\n"
        )
    source, target = folder / "elementary.c", folder / "elementary.so"
    source.write_text(text)
    flags = ["-O3", "-march=native", "-fPIC", "-shared", "-std=gnu11"]
    subprocess.run(["cc", *flags, str(source), "-o", str(target), "-lm"], check=True)
    return ctypes.CDLL(str(target))


def apply(library: ctypes.CDLL, name: str, x: np.ndarray) -> np.ndarray:
    y = np.empty_like(x)
    pointers = (ctypes.c_void_p(a.ctypes.data) for a in (x, y))
    getattr(library, f"many_{name}")(x.size, *pointers)
    return y


def points(top: float) -> np.ndarray:
    """Of every magnitude up to the top, of both signs, and close to where paths part."""
    rng = np.random.default_rng(5)
    sizes = 10.0 ** rng.uniform(-12, math.log10(top), POINTS)
    borders = [math.tan(math.pi / 8), 1 / math.tan(math.pi / 8), 1.0, math.pi / 2, math.pi]
    near = np.array([b * (1 + k * 2.0**-52) for b in borders for k in range(-3, 4)])
    return np.concatenate([sizes * rng.choice([-1.0, 1.0], POINTS), near, -near])


@pytest.mark.parametrize("name", ULPS)
def test_errors_are_a_few_units_of_the_last_place(library: ctypes.CDLL, name: str):
    x = points(1e15 if name == "atan" else 1e5)
    found = apply(library, name, x)
    with mp.workdps(60):
        exact = [getattr(mp, name)(mp.mpf(float(value))) for value in x]
        errors = [
            abs(mp.mpf(float(y)) - e) / mp.mpf(math.ulp(float(e)))
            for y, e in zip(found, exact, strict=True)
        ]
    assert max(errors) < ULPS[name]


@pytest.mark.parametrize("name", ULPS)
def test_what_is_no_number_stays_none(library: ctypes.CDLL, name: str):
    assert np.isnan(apply(library, name, np.array([np.nan]))).all()
    if name != "atan":
        assert np.isnan(apply(library, name, np.array([np.inf, -np.inf, 2e6]))).all()


def test_the_angle_of_infinity_is_a_right_one(library: ctypes.CDLL):
    found = apply(library, "atan", np.array([np.inf, -np.inf, 0.0, -0.0]))
    assert found.tolist() == [math.pi / 2, -math.pi / 2, 0.0, 0.0]
    assert np.signbit(found).tolist() == [False, True, False, True]
