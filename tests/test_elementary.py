"""The elementary functions of the kernels, against arithmetic of many digits."""

from __future__ import annotations

import ctypes
import math
import subprocess

import mpmath as mp
import numpy as np
import pytest

from groundroll.derive.emit.simd.lanes import elementary

#: Largest error in units of the last place, and the arguments for which it holds.
ULPS = {
    "atan": (2.5, (-1e15, 1e15)),
    "sin": (2.5, (-1e5, 1e5)),
    "cos": (2.5, (-1e5, 1e5)),
    "tan": (4.0, (-1e5, 1e5)),
    "asin": (4.0, (-1.0, 1.0)),
    "acos": (4.0, (-1.0, 1.0)),
    "exp": (1.0, (-708.0, 709.7)),
    "expm1": (2.0, (-1e3, 709.7)),
    "log": (1.0, (0.0, 1e308)),
    "log1p": (2.0, (-1.0, 1e308)),
    "sinh": (2.5, (-710.0, 710.0)),
    "cosh": (2.5, (-710.0, 710.0)),
    "tanh": (2.5, (-1e3, 1e3)),
    "asinh": (4.0, (-1e308, 1e308)),
    "acosh": (4.0, (1.0, 1e308)),
    "atanh": (4.0, (-1.0, 1.0)),
}
#: Functions of two arguments: their error, and the ends of both.
PAIRS = {
    "atan2": (3.5, (-1e9, 1e9), (-1e9, 1e9)),
    "hypot": (1.5, (-1e9, 1e9), (-1e9, 1e9)),
    "pow": (6.0, (0.02, 50.0), (-1.0, 1.0)),
}
POINTS = 4000


@pytest.fixture(scope="module")
def library(tmp_path_factory: pytest.TempPathFactory) -> ctypes.CDLL:
    """Every function over an array."""
    folder = tmp_path_factory.mktemp("elementary")
    headers = ("float", "math", "stdint", "string")
    text = "".join(f"#include <{name}.h>\n" for name in headers)
    text += f"#define INLINE static inline __attribute__((always_inline))\n{elementary()}"
    for name in ULPS:
        text += (
            f"void many_{name}(int n, const double *x, double *y)\n"
            f"{{ for (int i = 0; i < n; ++i) y[i] = lane_{name}(x[i]); }}\n"
        )
    for name in PAIRS:
        text += (
            f"void many_{name}(int n, const double *x, const double *z, double *y)\n"
            f"{{ for (int i = 0; i < n; ++i) y[i] = lane_{name}(x[i], z[i]); }}\n"
        )
    source, target = folder / "elementary.c", folder / "elementary.so"
    source.write_text(text)
    flags = ["-O3", "-march=native", "-fPIC", "-shared", "-std=gnu11"]
    subprocess.run(["cc", *flags, str(source), "-o", str(target), "-lm"], check=True)
    return ctypes.CDLL(str(target))


def apply(library: ctypes.CDLL, name: str, *arguments: np.ndarray) -> np.ndarray:
    y = np.empty_like(arguments[0])
    pointers = (ctypes.c_void_p(a.ctypes.data) for a in (*arguments, y))
    getattr(library, f"many_{name}")(y.size, *pointers)
    return y


def points(bottom: float, top: float, seed: int = 5) -> np.ndarray:
    """Of every magnitude up to the top, of both signs, and close to where paths part."""
    rng = np.random.default_rng(seed)
    sizes = 10.0 ** rng.uniform(-12, math.log10(max(-bottom, top)), POINTS)
    borders = [math.tan(math.pi / 8), 1 / math.tan(math.pi / 8), 0.5, 1.0, math.sqrt(2), 2.0]
    borders += [math.log(2) / 2, math.log(2), math.pi / 2, math.pi, 20.0, 40.0, 1e9]
    near = np.array([b * (1 + k * 2.0**-52) for b in borders for k in range(-3, 4)])
    around = np.concatenate([1 + sizes[sizes < 1], 1 - sizes[sizes < 1]])
    every = np.concatenate([sizes * rng.choice([-1.0, 1.0], POINTS), near, -near, around, -around])
    return rng.permutation(every[(every > bottom) & (every < top)])


def ulps(name: str, found: np.ndarray, *arguments: np.ndarray) -> float:
    """Largest error in units of the last place, by arithmetic of many digits."""
    exact = {"pow": mp.power, "atan2": mp.atan2, "hypot": mp.hypot}.get(name) or getattr(mp, name)
    with mp.workdps(60):
        errors = (
            abs(mp.mpf(y) - (e := exact(*map(mp.mpf, values)))) / mp.mpf(math.ulp(float(e)))
            for y, *values in zip(found.tolist(), *(a.tolist() for a in arguments), strict=True)
        )
        return float(max(errors))


@pytest.mark.parametrize("name", ULPS)
def test_errors_are_a_few_units_of_the_last_place(library: ctypes.CDLL, name: str):
    most, ends = ULPS[name]
    x = points(*ends)
    assert ulps(name, apply(library, name, x), x) < most


@pytest.mark.parametrize("name", PAIRS)
def test_errors_of_two_arguments_are_as_small(library: ctypes.CDLL, name: str):
    most, *ends = PAIRS[name]
    x, z = (points(*each, seed)[:POINTS] for seed, each in enumerate(ends))
    assert ulps(name, apply(library, name, x, z), x, z) < most


def test_the_error_of_a_power_is_that_of_its_exponent(library: ctypes.CDLL):
    rng = np.random.default_rng(2)
    x, z = 10.0 ** rng.uniform(-9, 9, POINTS), rng.uniform(-15, 15, POINTS)
    found = apply(library, "pow", x, z)
    with mp.workdps(60):
        for y, a, b in zip(found.tolist(), x.tolist(), z.tolist(), strict=True):
            exact = mp.power(mp.mpf(a), mp.mpf(b))
            assert abs(y / exact - 1) < (2 + abs(b * math.log(a))) * 2.0**-52


@pytest.mark.parametrize("name", ULPS)
def test_what_is_no_number_stays_none(library: ctypes.CDLL, name: str):
    nan = np.array([np.nan])
    assert np.isnan(apply(library, name, nan)).all()
    if name in ("sin", "cos", "tan"):
        assert np.isnan(apply(library, name, np.array([np.inf, -np.inf, 2e6]))).all()
    if name in ("asin", "acos", "atanh"):
        assert np.isnan(apply(library, name, np.array([1.5, -1.5, np.inf]))).all()
    if name in ("log", "log1p", "acosh"):
        assert np.isnan(apply(library, name, np.array([-1.5, -np.inf]))).all()


@pytest.mark.parametrize("name", PAIRS)
def test_no_number_in_either_argument_gives_none(library: ctypes.CDLL, name: str):
    x, z = np.array([np.nan, 2.0, np.nan]), np.array([2.0, np.nan, np.nan])
    assert np.isnan(apply(library, name, x, z)).all()


#: Values at the ends, as C has them.
ENDS = {
    "exp": {800.0: np.inf, -800.0: 0.0, np.inf: np.inf, -np.inf: 0.0, 0.0: 1.0},
    "expm1": {800.0: np.inf, -np.inf: -1.0, 0.0: 0.0},
    "log": {0.0: -np.inf, np.inf: np.inf, 1.0: 0.0, 5e-324: math.log(5e-324)},
    "log1p": {-1.0: -np.inf, np.inf: np.inf, 0.0: 0.0},
    "tanh": {np.inf: 1.0, -np.inf: -1.0, 0.0: 0.0},
    "sinh": {np.inf: np.inf, -np.inf: -np.inf},
    "cosh": {np.inf: np.inf, -np.inf: np.inf, 0.0: 1.0},
    "asinh": {np.inf: np.inf, -np.inf: -np.inf, 0.0: 0.0},
    "acosh": {1.0: 0.0, np.inf: np.inf},
    "atanh": {1.0: np.inf, -1.0: -np.inf},
    "asin": {1.0: math.pi / 2, -1.0: -math.pi / 2},
    "acos": {1.0: 0.0, -1.0: math.pi},
}


@pytest.mark.parametrize("name", ENDS)
def test_ends_are_those_of_c(library: ctypes.CDLL, name: str):
    x = np.array(list(ENDS[name]))
    assert apply(library, name, x).tolist() == list(ENDS[name].values())


def test_powers_and_angles_at_their_ends_are_those_of_c(library: ctypes.CDLL):
    for name, values in (
        ("pow", [0.0, 1.0, -2.0, -2.0, 3.0, np.inf, -8.0]),
        ("atan2", [0.0, -0.0, 1.0, -1.0, np.inf, -np.inf]),
    ):
        pairs = [(x, z) for x in values for z in (0.0, -0.0, 3.0, 2.0, -1.0, np.inf)]
        x, z = np.array(pairs).T.copy()
        with np.errstate(all="ignore"):
            exact = (np.power if name == "pow" else np.arctan2)(x, z)
        keep = np.isfinite(z) | (name == "atan2") | (x > 1)
        found = apply(library, name, x, z)
        np.testing.assert_allclose(found[keep], exact[keep], rtol=1e-15)
        assert (np.signbit(found) == np.signbit(exact))[keep & (exact != np.inf)].all()


def test_the_angle_of_infinity_is_a_right_one(library: ctypes.CDLL):
    found = apply(library, "atan", np.array([np.inf, -np.inf, 0.0, -0.0]))
    assert found.tolist() == [math.pi / 2, -math.pi / 2, 0.0, 0.0]
    assert np.signbit(found).tolist() == [False, True, False, True]
