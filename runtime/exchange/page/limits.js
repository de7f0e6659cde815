// How far each slider may go before the aircraft is unstable, or its roll ends badly.
const LIMITS = new Map(); // symbol -> { kind, edges: [{at, good}], ...}
const PROBES = 33;

/** Whether a design is good when a slider has a value: by its roll for what acts, else stability. */
function judged(trial, s) {
  if (s in design.inputs || s in design.start) return endsWell(trial) ? 1 : -1;
  return decayOf(trial);
}

/** Find the bands of a slider, a probe at a time: pieces of its range that are good or bad. */
function* bandsOf(s, { low, high }) {
  const trial = copied(design), values = [];
  const probe = (value) => {
    put(trial, s, value);
    return judged(trial, s);
  };
  const acts = s in design.inputs || s in design.start, count = acts ? 17 : PROBES;
  for (let k = 0; k < count; ++k) {
    const value = low + ((high - low) * k) / (count - 1);
    values.push([value, probe(value)]);
    yield;
  }
  const pieces = [], good = (x) => x > 0;
  let from = low;
  for (let k = 1; k < values.length; ++k) {
    const before = good(values[k - 1][1]);
    if (good(values[k][1]) === before) continue;
    let [a, b] = [values[k - 1][0], values[k][0]];
    const most = acts ? 10 : 60;
    for (let n = 0; n < most && Math.abs(b - a) > 1e-13 * Math.abs(b + a); ++n) {
      const middle = (a + b) / 2;
      if (good(probe(middle)) === before) a = middle;
      else b = middle;
      yield;
    }
    pieces.push({ from, to: b, good: before });
    from = b;
  }
  pieces.push({ from, to: high, good: good(values.at(-1)[1]) });
  return { pieces, acts };
}

/** What the bands of a slider say, in words; empty if it may go anywhere. */
function limitInWords(s, { pieces, acts }) {
  if (pieces.length === 1) return ""; // the band says it
  return pieces
    .filter((piece) => !piece.good)
    .map(({ from, to }, k, all) => {
      const [first, last] = [from === pieces[0].from, to === pieces.at(-1).to];
      if (first) return `below ${withUnit(s, to)}`;
      if (last) return `above ${withUnit(s, from)}`;
      return `from ${withUnit(s, from)} to ${withUnit(s, to)}`;
    })
    .join(" and ")
    .replace(/^/, `${acts ? "ends badly" : "unstable"} `);
}

/** All sliders in turn, those that are seen. */
function* allBands(shown, found) {
  LIMITS.clear();
  for (const s of shown) {
    const result = yield* bandsOf(s, SLIDERS.get(s));
    LIMITS.set(s, result);
    found(s, result);
    yield;
  }
}
