"""Texts and bytes with mistakes in them."""

from __future__ import annotations

import numpy as np

#: What is put into texts.
TOKENS = (
    *("", " ", "\n", "\t", "\r\n", "\0", "\ufeff", "\u2212", "\u00b0", "\u200b", "é", "\U0001f6e9"),
    *("=", "[", "]", "[[", "{", "}", '"', "'", '"""', "#", ".", ",", ";", "_", "\\", "$"),
    *(
        "nan",
        "inf",
        "-inf",
        "true",
        "1e400",
        "1e-400",
        "-0",
        "0x1f",
        "1_0",
        "07",
        "+3",
        "1e5",
        "10",
    ),
    *("9" * 400, "[" * 300, "a." * 300, "1979-05-27", "1.5 m", "-3 kt", "2 deg", "4 dB", "5 degC"),
    *("1 kg^9^9^9", "3 m**2**2", "17 ft 2 in", "1,5", "1 000", "value", "source", "estimate"),
    *("[main_tires]", "[parameters]", "table", "size", "<svg onload=x>", "\x1b[31m", "=1+1"),
)


def pick(rng: np.random.Generator, options: object) -> object:
    """One of some options."""
    return options[int(rng.integers(len(options)))]  # type: ignore[index,arg-type]


def text(rng: np.random.Generator, plain: str, most: int = 4) -> str:
    """A text with at most so many mistakes."""
    for _ in range(int(rng.integers(most + 1))):
        at = int(rng.integers(len(plain) + 1))
        kind = int(rng.integers(6))
        if kind == 0:
            plain = plain[:at] + str(pick(rng, TOKENS)) + plain[at:]
        elif kind == 1:
            plain = plain[:at] + plain[at + int(rng.integers(1, 9)) :]
        elif kind == 2:
            plain = plain[:at] + chr(int(rng.integers(1, 0x250))) + plain[at + 1 :]
        else:
            lines = plain.split("\n")
            n, m = (int(rng.integers(len(lines))) for _ in range(2))
            if kind == 3:
                lines[n], lines[m] = lines[m], lines[n]
            elif kind == 4:
                lines.insert(m, lines[n])
            else:
                del lines[n]
            plain = "\n".join(lines)
    return plain


def data(rng: np.random.Generator, plain: bytes, most: int = 4) -> bytes:
    """Bytes with at least one mistake, at most so many."""
    changed = bytearray(plain)
    for _ in range(int(rng.integers(1, most + 1))):
        at = int(rng.integers(len(changed) or 1))
        kind = int(rng.integers(5))
        if kind == 0 and changed:
            changed[at] ^= 1 << int(rng.integers(8))
        elif kind == 1:
            del changed[at:]
        elif kind == 2:
            del changed[at : at + int(rng.integers(1, 99))]
        elif kind == 3:
            changed[at:at] = rng.bytes(int(rng.integers(1, 99)))
        else:
            changed[at : at + 8] = rng.bytes(8)
    return bytes(changed)
