"""Inputs over time, as the stored runs write them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

#: A number, or a mapping with `type`: "step", "1-cos" or "linear".
Signal = float | Mapping[str, Any]


def value(signal: Signal, t: float) -> float:
    """The signal at a time; a step has its new value from its time on."""
    if not isinstance(signal, Mapping):
        return float(signal)
    match signal["type"]:
        case "step":
            return float(signal["value"] if t >= signal["t0"] else signal.get("before", 0.0))
        case "1-cos":
            phase = (t - signal["t0"]) / signal["T"]
            inside = 0.0 <= phase <= 1.0
            return float(
                signal.get("base", 0.0)
                + inside * signal["peak"] / 2 * (1 - np.cos(2 * np.pi * phase))
            )
        case "linear":
            return float(np.interp(t, signal["t"], signal["v"]))
    raise ValueError(f"unknown signal {signal['type']!r}")


def corners(signal: Signal) -> tuple[float, ...]:
    """The times at which the signal is not smooth, where an integration must start anew."""
    if not isinstance(signal, Mapping):
        return ()
    match signal["type"]:
        case "step":
            return (signal["t0"],)
        case "1-cos":
            return (signal["t0"], signal["t0"] + signal["T"])
    return tuple(signal["t"])
