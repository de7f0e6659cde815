// What the page knows: facts of the model and of the aircraft, and the functions made from them.
const DATA = JSON.parse(document.getElementById("data").textContent);
const MODEL = DATA.model;
const QUANTITIES = DATA.quantities;
const NX = MODEL.states.length, NU = MODEL.inputs.length;
const NP = MODEL.parameters.length, NY = MODEL.outputs.length;
const SPEED = MODEL.roles.speed, HEADING = MODEL.roles.heading, OFFSET = MODEL.roles.offset;
const DISTANCE = MODEL.roles.distance;

/** Index of a state, or -1. */
const state = (s) => MODEL.states.indexOf(s);

/** A copy of what describes an aircraft and its roll: given, inputs, start (SI, by symbol). */
const copied = (design) => ({
  given: { ...design.given },
  inputs: { ...design.inputs },
  start: { ...design.start },
  duration: design.duration,
});

/** Value of a slider in a design; parameters that follow come from `known`, what `resolved` gave. */
function valueOf(design, s, known = resolved(design.given)) {
  if (s in design.inputs) return design.inputs[s];
  if (s.endsWith("0") && s in design.start) return design.start[s];
  return known.value(s);
}

/** Give a quantity of a design a value. */
function put(design, s, value) {
  if (s in design.inputs) design.inputs[s] = value;
  else if (s in design.start) design.start[s] = value;
  else design.given[s] = value;
}

/**
 * What follows from what is given, as the command line has it: the first way that gives a number.
 * `value(s)` is NaN where nothing gives it.
 */
function resolved(given) {
  const known = new Map(), open = new Set();
  function value(s) {
    if (s in given) return given[s];
    if (known.has(s)) return known.get(s);
    if (open.has(s)) return NaN;
    let found = NaN;
    open.add(s);
    for (const [names, way] of WAYS[s] ?? []) {
      const values = names.map(value);
      if (values.some(Number.isNaN)) continue;
      found = way(values);
      if (!Number.isNaN(found)) break;
    }
    open.delete(s);
    known.set(s, found);
    return found;
  }
  return { value };
}

/** Parameters in the order of the model, and what is wrong with them in words. */
function parametersOf(design) {
  const known = resolved(design.given), p = new Float64Array(NP), problems = [];
  MODEL.parameters.forEach((s, k) => {
    p[k] = known.value(s);
    const { name, sign } = QUANTITIES[s];
    if (!Number.isFinite(p[k])) problems.push(`${plain(name)} cannot be computed`);
    else if (sign === ">0" && !(p[k] > 0)) problems.push(`${plain(name)} must be positive`);
    else if (sign === ">=0" && !(p[k] >= 0)) problems.push(`${plain(name)} must not be negative`);
  });
  return { p, known, problems };
}

/** A name in words. */
const plain = (name) => name.replaceAll("_", " ").replace(/\bcg\b/g, "CG");

const inputsOf = (design) => Float64Array.from(MODEL.inputs, (s) => design.inputs[s]);

/** States of straight rolling at the speed of a design: the rest is zero. */
function straight(known) {
  const x = new Float64Array(NX);
  if (state(SPEED) >= 0) x[state(SPEED)] = known.value(SPEED);
  return x;
}

/** Everything that can be moved, by symbol: {symbol, group, low, high, hard}. */
const SLIDERS = new Map(DATA.sliders.map((slider) => [slider.symbol, slider]));

/** What the map is drawn over at first, and now. */
const DEFAULT_AXES = (() => {
  const shown = DATA.sliders.filter(({ group, symbol }) => group && symbol !== SPEED);
  const fallback = DATA.sliders[1]?.symbol ?? DATA.sliders[0]?.symbol;
  return { x: shown[0]?.symbol ?? fallback, y: SLIDERS.has(SPEED) ? SPEED : shown[1]?.symbol ?? fallback };
})();
const mapAxes = { ...DEFAULT_AXES };

/** A value that a slider may have: within hard ends, and of the sign that the quantity has. */
function allowed(s, value) {
  const { low, high, hard } = SLIDERS.get(s), { sign } = QUANTITIES[s];
  if (hard) return Math.min(high, Math.max(low, value));
  if (sign === ">0") return Math.max(value, 1e-6 * Math.max(Math.abs(low), Math.abs(high)));
  return sign === ">=0" ? Math.max(value, 0) : value;
}
