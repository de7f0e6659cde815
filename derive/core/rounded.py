"""Corners rounded in a stated width, so that derivatives are there and are continuous.

Outside of its width a rounded function is the function itself, or differs from it by the square
of the width over the distance: what stands at each.
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
    """`x` between -limit and limit, odd in both.

    Smaller in size than either of them. It falls short of `limit` by half the width where `x` has
    just reached it, and of `x` by width^2 x / (2 limit^2) where `x` is small.
    """
    above, below = sp.sqrt((x + limit) ** 2 + width**2), sp.sqrt((x - limit) ** 2 + width**2)
    return (above - below) / 2
