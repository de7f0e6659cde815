"""A symbol with a unit and a meaning; what an equation is written with.

Units are SI with radians. A `Quantity` *is* a SymPy symbol, so equations are written with it
directly and every expression knows the units of its leaves.
"""

from __future__ import annotations

from typing import Any

import sympy as sp

#: From where to where; None where there is no end.
Range = tuple[float | None, float | None]


class Quantity(sp.Symbol):  # type: ignore[misc]
    """A real symbol with a unit and a meaning.

    Parameters
    ----------
    symbol : str
        Symbol used in equations and in generated code, e.g. ``"r"``.
    name : str
        The field's full name, e.g. ``"yaw_rate"``.
    unit : str
        SI unit, e.g. ``"kg m^2"``; ``"1"`` for a pure number.
    meaning : str
        One line for people, with the sign convention where there is one.
    latex : str, optional
        Symbol in LaTeX; SymPy's own rendering of `symbol` if omitted.
    sign : str, optional
        ``">0"`` or ``">=0"`` for what cannot be otherwise (a mass, an area).
    kind : str
        ``"state"``, ``"input"`` or ``"parameter"`` for what equations may use without defining it
        (write `State`, `Input`, `Parameter`); a plain quantity is defined by an equation.
    within : tuple of float or None, optional
        Between what an input can be moved, SI; None where there is no end.
    """

    __slots__ = ("full_name", "kind", "latex", "meaning", "sign", "unit", "within")

    full_name: str
    unit: str
    meaning: str
    latex: str
    sign: str
    kind: str
    within: Range

    def __new__(
        cls,
        symbol: str,
        name: str,
        unit: str,
        meaning: str,
        latex: str = "",
        sign: str = "",
        kind: str = "",
        within: Range = (None, None),
    ) -> Quantity:
        assumption = {">0": {"positive": True}, ">=0": {"nonnegative": True}, "": {}}[sign]
        obj: Quantity = sp.Symbol.__xnew__(cls, symbol, real=True, **assumption)
        obj.full_name = name
        obj.unit = unit
        obj.meaning = meaning
        obj.latex = latex or sp.latex(sp.Symbol(symbol))
        obj.sign = sign
        obj.kind = kind
        obj.within = within
        return obj

    def _hashable_content(self) -> tuple[Any, ...]:
        # two quantities of one symbol are the same only if they say the same
        return (*super()._hashable_content(), self.full_name, self.unit, self.meaning, self.kind)

    def __getnewargs_ex__(self) -> tuple[tuple[Any, ...], dict[str, Any]]:
        words = (self.full_name, self.unit, self.meaning, self.latex, self.sign, self.kind)
        return (self.name, *words, self.within), {}

    def _latex(self, printer: Any) -> str:
        return self.latex

    def of(self, part: str) -> Quantity:
        """The same quantity of one part: ``alpha.of("left")`` is ``alpha_left``.

        An empty name gives the quantity itself.
        """
        if not part:
            return self
        return Quantity(
            f"{self.name}_{part}",
            f"{self.full_name}_{part}",
            self.unit,
            f"{self.meaning}, {part.replace('_', ' ')}",
            rf"{{{self.latex}}}_{{\mathrm{{{part.replace('_', ' ')}}}}}",
            self.sign,
            self.kind,
            self.within,
        )


class Constant(sp.NumberSymbol):  # type: ignore[misc]
    """A positive number with a unit: what a formula holds that nobody gives.

    Parameters
    ----------
    value : float
    unit : str
        SI unit, e.g. ``"m"``.
    """

    __slots__ = ("unit", "value")

    is_real = True
    is_positive = True
    is_irrational = None

    value: float
    unit: str

    def __new__(cls, value: float, unit: str) -> Constant:
        obj: Constant = sp.AtomicExpr.__new__(cls)
        obj.value = float(value)
        obj.unit = unit
        return obj

    def _hashable_content(self) -> tuple[Any, ...]:
        return (self.value, self.unit)

    def __getnewargs__(self) -> tuple[float, str]:
        return (self.value, self.unit)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Constant) and self._hashable_content() == other._hashable_content()

    __hash__ = sp.AtomicExpr.__hash__

    def _as_mpf_val(self, prec: int) -> Any:
        return sp.Float(self.value)._as_mpf_val(prec)

    def _sympystr(self, printer: Any) -> str:
        return f"{self.value!r} {self.unit}"

    def _latex(self, printer: Any) -> str:
        return rf"{sp.latex(sp.Float(f'{self.value:g}'))}\,\mathrm{{{self.unit}}}"

    def _casadi(self, printer: Any) -> str:
        return repr(self.value)


def State(symbol: str, name: str, unit: str, meaning: str, latex: str = "") -> Quantity:
    """A quantity that has a rate."""
    return Quantity(symbol, name, unit, meaning, latex, kind="state")


def Input(
    symbol: str,
    name: str,
    unit: str,
    meaning: str,
    latex: str = "",
    within: Range = (None, None),
) -> Quantity:
    """What acts from outside and may change over time; zero if nobody gives it."""
    return Quantity(symbol, name, unit, meaning, latex, kind="input", within=within)


def Parameter(
    symbol: str, name: str, unit: str, meaning: str, latex: str = "", sign: str = ""
) -> Quantity:
    """A number of the aircraft, constant during a run."""
    return Quantity(symbol, name, unit, meaning, latex, sign, "parameter")
