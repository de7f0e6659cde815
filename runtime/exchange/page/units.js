// Numbers for people: units, rounding, and what they type.
const UNIT_SETS = ["file", "metric", "US"];
let unitSet = 0;

/** Name and size of the unit in which a quantity is shown. */
const shownIn = (s) => DATA.units[s]?.[unitSet] ?? [QUANTITIES[s]?.unit ?? "", 1];

/** A unit as it is printed. */
const printed = (unit) => unit.replace(/\^(-?\d)/g, (_, n) => [...n].map((c) => (c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c])).join(""));

/** A number in few digits. */
function brief(value, digits = 4) {
  if (!Number.isFinite(value)) return Number.isNaN(value) ? "none" : value > 0 ? "∞" : "−∞";
  if (value === 0) return "0";
  const text = Number(value.toPrecision(digits));
  const size = Math.abs(text);
  const plainly = size >= 1e-4 && size < 1e6 ? String(text) : text.toExponential();
  return plainly.replace("-", "−");
}

/** A value of a quantity with its unit. */
function withUnit(s, value, digits = 4) {
  const [unit, factor] = shownIn(s);
  const space = unit && unit !== "%" ? "\u202f" : "";
  return `${brief(value * factor, digits)}${space}${printed(unit)}`;
}

/** The SI value that a text means for a quantity, NaN if none: a number, and a unit that is known. */
function typed(s, text) {
  const match = /^\s*([+\-−]?[\d.]+(?:e[+-]?\d+)?)\s*(.*)$/i.exec(text);
  if (!match) return NaN;
  const number = Number(match[1].replace("−", "-")), unit = match[2].trim();
  const si = [QUANTITIES[s].unit === "1" ? "" : QUANTITIES[s].unit, 1];
  const known = [shownIn(s), ...(DATA.units[s] ?? []), si];
  const found = unit ? known.find(([name]) => name === unit || printed(name) === unit) : known[0];
  return found ? number / found[1] : NaN;
}
