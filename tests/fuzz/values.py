"""Values as people and programs give them, each with what it means."""

from __future__ import annotations

import datetime
from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np

from . import mutation, truth

#: What means nothing as a number, and must be refused.
ODD: tuple[Any, ...] = (
    *(True, np.bool_(1), b"1", 1j, np.array([1j]), "abc", "", " ", "1 furlong per", "5 dB", "1,5"),
    *(float("nan"), float("inf"), -float("inf"), 10**400, -(10**400), "nan", "inf", "1e999", "--1"),
    *({}, {"a": 1}, set(), object(), object, [[1.0], [1.0, 2.0]], [1.0, None], [True, 30.0]),
    *(datetime.date(2020, 1, 1), np.datetime64("2020"), np.timedelta64(5, "s"), "1 kg^9^9^9^9"),
    *(np.ma.masked_array([1.0, 2.0], [0, 1]), np.array(["x", "y"]), np.array([1.0, "a"], object)),
    *("9" * 5000, "\0", "1" + " " * 3000, [[[[[[1j]]]]]], np.zeros(2, [("a", float)]), "1 m 2"),
    *(range(10**14), np.broadcast_to(1.0, 10**13), "4 degC", "3 N/dB", "1e5 e", "0x10", "1_0"),
)


def number(rng: np.random.Generator, low: float, high: float, unit: str) -> tuple[Any, Any]:
    """A value, and what it is in the SI unit: an array, or None if it means nothing."""
    if rng.random() < 0.12:
        odd = ODD[int(rng.integers(len(ODD)))]
        return odd, None
    x = float(f"{rng.uniform(low, high):.6g}")
    kind = int(rng.integers(10))
    if kind < 3:
        written = str(mutation.pick(rng, truth.WRITTEN.get(unit, (unit,))))
        text = f"{x:.6g}" if unit == "1" else f"{x:.6g} {written}"
        size = 1.0 if unit == "1" else truth.value(f"1 {written}", unit)
        if size is None:
            raise ValueError(f"no truth of {written}")
        scaled = f"{x / size:.9g}" + text[len(f"{x:.6g}") :]
        return scaled, np.asarray(truth.value(scaled, unit))
    if kind == 3:
        two = rng.uniform(low, high, 2)
        return mutation.pick(rng, (two, two.tolist(), tuple(two))), two  # type: ignore[arg-type]
    if kind == 4:
        whole = round(x)
        if low <= whole <= high:
            exact = (whole, np.int16(whole), Fraction(whole), np.array(whole), f"{whole}")
            return mutation.pick(rng, exact), np.asarray(float(whole))
    if kind == 5:
        return np.float32(x), np.asarray(float(np.float32(x)))
    if kind == 6:
        return Decimal(repr(x)), np.asarray(x)
    return x, np.asarray(x)


def same(found: Any, expected: Any) -> bool:
    """Whether numbers are others, but for rounding on the way through units."""
    return bool(np.allclose(np.asarray(found, float), expected, rtol=1e-9, atol=1e-300))


def shown(given: dict[str, Any]) -> str:
    """Arguments in words."""
    try:
        return ", ".join(f"{name}={value!r:.200}" for name, value in given.items())
    except Exception:
        return ", ".join(f"{name}: {type(value).__name__}" for name, value in given.items())
