// A roll over time: Dormand and Prince's pair of order 5(4) with its interpolation between steps.
const STAGES = [
  [1 / 5],
  [3 / 40, 9 / 40],
  [44 / 45, -56 / 15, 32 / 9],
  [19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729],
  [9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656],
  [35 / 384, 0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84],
];
const ERROR = [71 / 57600, 0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40];
const DENSE = [
  -12715105075 / 11282082432, 0, 87487479700 / 32700410799, -10690763975 / 1880347072,
  701980252875 / 199316789632, -1453857185 / 822651844, 69997945 / 29380423,
];
const MOST_STEPS = 20000;

/**
 * A roll that is computed in pieces, so that the page stays quick.
 *
 * `advance(steps)` computes some more of it; `done` says whether that was the last, `lost` whether
 * the motion left the numbers. `at(k, x)` puts the states of sample k into x. `first` has for each
 * event of the model when it happens, in s, infinite if never.
 */
class Roll {
  constructor(x0, u, p, { duration, samples = 301, tolerance = 1e-7 }) {
    Object.assign(this, { u, p, duration, tolerance, samples, t: 0, step: 1e-3, steps: 0 });
    this.done = this.lost = false;
    this.x = Float64Array.from(x0);
    this.series = new Float64Array(samples * NX).fill(NaN);
    this.kept = 0;
    this.first = MODEL.events.map(() => Infinity);
    this.k = Array.from({ length: 7 }, () => new Float64Array(NX));
    this.y = new Float64Array(NX);
    this.r = Array.from({ length: 5 }, () => new Float64Array(NX));
    this.seen = new Float64Array(NY);
    rates(this.x, u, p, this.k[0]);
    this.watched = this.events(this.x, new Float64Array(MODEL.events.length));
    this.watched.forEach((value, i) => value >= 0 && (this.first[i] = 0));
    this.keep(0);
  }

  get end() {
    return this.lost ? this.t : this.duration;
  }

  time(k) {
    return (this.duration * k) / (this.samples - 1);
  }

  at(k, x) {
    x.set(this.series.subarray(k * NX, k * NX + NX));
    return x;
  }

  advance(steps) {
    for (let n = 0; n < steps && !this.done; ++n) this.attempt();
    return this.done;
  }

  attempt() {
    const { x, y, k, u, p } = this, left = this.duration - this.t;
    const last = this.step >= left, h = last ? left : this.step;
    for (let s = 1; s < 7; ++s) {
      const a = STAGES[s - 1];
      for (let i = 0; i < NX; ++i) {
        let sum = 0;
        for (let j = 0; j < s; ++j) sum += a[j] * k[j][i];
        y[i] = x[i] + h * sum;
      }
      rates(y, u, p, k[s]);
    }
    let worst = 0;
    for (let i = 0; i < NX; ++i) {
      let e = 0;
      for (let j = 0; j < 7; ++j) e += ERROR[j] * k[j][i];
      const scale = this.tolerance * (0.01 + Math.max(Math.abs(x[i]), Math.abs(y[i])));
      const error = Math.abs(h * e) / scale;
      if (!(error <= worst)) worst = error;
    }
    if (!(worst < Infinity)) worst = Infinity;
    const factor = worst > 0 ? 0.9 * worst ** -0.2 : 5;
    if (worst <= 1) this.accept(h, last ? this.duration : this.t + h);
    if (!(last && worst <= 1 && factor > 1)) this.step = h * Math.min(5, Math.max(0.2, factor));
    if (this.t >= this.duration) this.done = true;
    else if (this.t + this.step <= this.t || ++this.steps > MOST_STEPS) this.done = this.lost = true;
  }

  /** Go to the end of a step; note what happened on the way. */
  accept(h, end) {
    const { x, y, k, r } = this;
    for (let i = 0; i < NX; ++i) {
      const d = y[i] - x[i], b = h * k[0][i] - d;
      let dense = 0;
      for (let j = 0; j < 7; ++j) dense += DENSE[j] * k[j][i];
      [r[0][i], r[1][i], r[2][i], r[3][i], r[4][i]] = [x[i], d, b, d - h * k[6][i] - b, h * dense];
    }
    this.look(h, end);
    while (this.kept < this.samples && this.time(this.kept) <= end) {
      this.between((this.time(this.kept) - this.t) / h, this.series, this.kept * NX);
      ++this.kept;
    }
    x.set(y);
    k[0].set(k[6]);
    this.t = end;
  }

  keep(k) {
    this.series.set(this.x, k * NX);
    this.kept = k + 1;
  }

  /** States at a share of the step. */
  between(share, into, first = 0) {
    const { r } = this, rest = 1 - share;
    for (let i = 0; i < NX; ++i) {
      const late = r[3][i] + rest * r[4][i];
      into[first + i] = r[0][i] + share * (r[1][i] + rest * (r[2][i] + share * late));
    }
    return into;
  }

  /** What is not below zero once an event has happened. */
  events(x, into) {
    outputs(x, this.u, this.p, this.seen);
    MODEL.events.forEach((event, i) => {
      into[i] = (event.rising ? 1 : -1) * this.seen[event.output];
    });
    return into;
  }

  /** Find the first time of events in this step, looked for at quarters of it. */
  look(h, end) {
    if (!MODEL.events.length) return;
    const place = new Float64Array(NX), here = new Float64Array(MODEL.events.length);
    for (let quarter = 1; quarter <= 4; ++quarter) {
      this.events(this.between(quarter / 4, place), here);
      for (let i = 0; i < here.length; ++i) {
        if (this.first[i] < Infinity || !(here[i] >= 0)) continue;
        let [low, high] = [(quarter - 1) / 4, quarter / 4];
        for (let n = 0; n < 40; ++n) {
          const middle = (low + high) / 2, values = new Float64Array(here.length);
          this.events(this.between(middle, place), values);
          if (values[i] >= 0) high = middle;
          else low = middle;
        }
        this.first[i] = this.t + high * (end - this.t);
      }
    }
  }
}

/** How a design's roll starts: straight, at rest on its legs if it has some, then kicked. */
function startOf(design) {
  const { p, known, problems } = parametersOf(design), x = straight(known);
  const ok = !problems.length && (!DATA.rest || atRest(x, p));
  for (const [s, value] of Object.entries(design.start)) x[state(s.slice(0, -1))] += value;
  return { ok, x, p, u: inputsOf(design) };
}

/** Depth and pitch at which the body rests on its legs without air, and no velocity across. */
function atRest(x, p) {
  const { depth, pitch, heave, pitching, density, creep, wheels, sunk } = DATA.rest;
  const still = Float64Array.from(p), y = new Float64Array(NX), u = new Float64Array(NU);
  if (density >= 0) still[density] = 0;
  y[state(SPEED)] = creep;
  const unknown = [depth, pitch].map(state), rows = [heave, pitching].map(state);
  const d = new Float64Array(NX), du = new Float64Array(NU), dp = new Float64Array(NP);
  const f = new Float64Array(NX), seen = new Float64Array(NY);
  const moved = unknown.map(() => new Float64Array(NX)), shown = unknown.map(() => new Float64Array(NY));
  const derive = () =>
    unknown.forEach((i, k) => {
      d[i] = 1;
      along(y, u, still, d, du, dp, moved[k], shown[k]);
      d[i] = 0;
    });
  const go = (slopes, values, most) => {
    const step = nearestStep(slopes, values);
    step.forEach((by, k) => (y[unknown[k]] -= Math.min(most, Math.max(-most, by))));
    return Math.max(...step.map(Math.abs));
  };
  for (let count = 0; count < 5; ++count) { // straight lines through the wheels first
    outputs(y, u, still, seen);
    derive();
    go(shown.map((each) => wheels.map((i) => each[i])), wheels.map((i) => seen[i] - sunk), Infinity);
  }
  let size = Infinity;
  for (let count = 0; count < 100 && !(size < 1e-12); ++count) {
    rates(y, u, still, f);
    derive();
    size = go(moved.map((each) => rows.map((i) => each[i])), rows.map((i) => f[i]), 0.05);
    if (!Number.isFinite(size)) return false;
  }
  for (const i of unknown) x[i] = y[i];
  const z = state(depth), w = state(heave), rise = [0, 1].map((value) => {
    x[w] = value;
    rates(x, u, p, f);
    return f[z];
  });
  x[w] = rise[0] / (rise[0] - rise[1]);
  return size < 1e-9;
}

/** The step in two unknowns that comes nearest to making values zero (least squares). */
function nearestStep([a, b], values) {
  const dot = (p, q) => p.reduce((sum, value, i) => sum + value * q[i], 0);
  const [aa, ab, bb, av, bv] = [dot(a, a), dot(a, b), dot(b, b), dot(a, values), dot(b, values)];
  const det = aa * bb - ab * ab;
  return [(av * bb - bv * ab) / det, (bv * aa - av * ab) / det];
}

/** A roll of a design, not yet computed; null if there is none. */
function rollOf(design, options = {}) {
  const start = startOf(design);
  if (!start.ok) return null;
  return new Roll(start.x, start.u, start.p, { duration: design.duration, ...options });
}

/** The first bad thing that happens in a roll, {name, text, t}; null if nothing does. */
function fateOf(roll) {
  const found = [];
  MODEL.events.forEach((event, i) => {
    // what holds before it rolls is none of its fate: a tricycle's CG is always ahead of its main wheels
    if (event.bad && roll.first[i] > 0 && roll.first[i] <= roll.end) {
      found.push({ name: event.name, text: event.text, t: roll.first[i] });
    }
  });
  const x = new Float64Array(NX), { heading, half_width } = DATA.limits;
  const watch = [[HEADING, heading, "ground loop", "it turns too far"]];
  if (!MODEL.events.some((event) => event.name === "ran_off")) {
    watch.push([OFFSET, half_width, "leaves the runway", "the CG leaves the runway at its side"]);
  }
  for (const [s, limit, name, text] of MODEL.events.length ? watch.slice(1) : watch) {
    if (state(s) < 0) continue;
    for (let k = 0; k < roll.kept; ++k) {
      if (Math.abs(roll.at(k, x)[state(s)]) >= limit) {
        found.push({ name, text, t: roll.time(k) });
        break;
      }
    }
  }
  if (roll.lost) found.push({ name: "lost", text: "the motion grows without bound", t: roll.t });
  return found.sort((a, b) => a.t - b.t)[0] ?? null;
}

/** Whether a design's roll ends well. */
function endsWell(design) {
  const roll = rollOf(design, { samples: 101, tolerance: 1e-5 });
  if (!roll) return false;
  while (!roll.done) roll.advance(1000);
  return fateOf(roll) === null;
}
