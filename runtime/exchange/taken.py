"""What is taken from another program's file: quantities with their source, and what is left."""

from __future__ import annotations

from dataclasses import dataclass, field

from groundroll.aircraft.template import quoted, section_of
from groundroll.base.units import to_si
from groundroll.model.names import PARAMETERS


@dataclass(frozen=True)
class Taken:
    """A quantity as an aircraft file says it.

    Attributes
    ----------
    symbol : str
    value : float
        In `unit`.
    unit : str
        A unit that fits the quantity; ``"1"`` for a pure number.
    source : str
        Where it stands, or how it follows.
    estimate : bool
        Whether it is only near what the file says.
    """

    symbol: str
    value: float
    unit: str
    source: str
    estimate: bool = False

    @property
    def text(self) -> str:
        """Number and unit."""
        return f"{self.value:.12g}" + (f" {self.unit}" if self.unit != "1" else "")

    @property
    def si(self) -> float:
        """In SI units with radians."""
        return to_si(self.text, PARAMETERS[self.symbol].unit, self.symbol)


@dataclass
class Found:
    """What is found in a file.

    Attributes
    ----------
    title, source : str
        Of the aircraft.
    taken : dict of str to Taken
        By symbol.
    left : list of str
        What could not be taken, in words.
    """

    title: str
    source: str
    taken: dict[str, Taken] = field(default_factory=dict)
    left: list[str] = field(default_factory=list)

    def take(self, *many: Taken) -> None:
        """Take quantities; what a quantity cannot be is left."""
        for each in many:
            sign = PARAMETERS[each.symbol].sign
            if (sign == ">0" and each.si <= 0) or (sign == ">=0" and each.si < 0):
                wanted = "positive" if sign == ">0" else "zero or positive"
                name = PARAMETERS[each.symbol].name
                self.left.append(f"{name}: {each.text} ({each.source}); it must be {wanted}")
            else:
                self.taken[each.symbol] = each

    def toml(self) -> str:
        """An aircraft file of it, what was left in its head."""
        sections: dict[str, list[str]] = {}
        for s in sorted(self.taken, key=list(PARAMETERS).index):
            title, name = section_of(s)
            sections.setdefault(title, []).append(_line(name, self.taken[s]))
        head = [f"title = {quoted(self.title)}", f"source = {quoted(self.source)}"]
        comments = [f"# - {quoted(text)[1:-1]}" for text in self.left]
        if comments:
            head = ["# Not taken:", *comments, "", *head]
        parts = (["", f"[{title}]", *lines] for title, lines in sections.items())
        return "\n".join([*head, *(line for part in parts for line in part), ""])


def _line(name: str, each: Taken) -> str:
    value = each.text if each.unit == "1" else quoted(each.text)
    fields = [f"value = {value}"]
    if each.estimate:
        fields.append("estimate = true")
    return f"{name} = {{ {', '.join([*fields, f'source = {quoted(each.source)}'])} }}"
