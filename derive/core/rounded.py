"""Corners rounded in a stated width, so that derivatives are there and are continuous.

Outside of its width a rounded function is the function itself.
"""

from __future__ import annotations

import sympy as sp


def ramp(x: sp.Expr, width: sp.Expr) -> sp.Expr:
    """The larger of `x` and 0: exactly that outside of 0 < x < width, and never negative.

    The polynomial between has the slope and the curvature of its neighbours at both ends.
    """
    part = sp.Max(0, sp.Min(1, x / width))
    return width * part**3 * (6 - 8 * part + 3 * part**2) + sp.Max(0, x - width)


def step(x: sp.Expr, width: sp.Expr) -> sp.Expr:
    """1 where `x` is above `width`, 0 below zero, and a polynomial as smooth as `ramp` between."""
    part = sp.Max(0, sp.Min(1, x / width))
    return part**3 * (10 - 15 * part + 6 * part**2)


def clipped(x: sp.Expr, limit: sp.Expr, width: sp.Expr) -> sp.Expr:
    """`x` between -limit and limit: exactly that but within half the width of a limit.

    Odd in `x`, and never beyond a limit.
    """
    hard = sp.Max(-limit - width / 2, sp.Min(limit + width / 2, x))
    above, below = (sp.Max(0, (y - limit) / width + sp.Rational(1, 2)) for y in (hard, -hard))
    return hard - width * (above**3 * (1 - above / 2) - below**3 * (1 - below / 2))
