// Steady rolling, the linear model there, and its eigenvalues.

/** What is held while rolling steadily: the speed, and the heading unless somebody steers. */
const HELD = MODEL.dynamic.includes(OFFSET) ? [SPEED] : [SPEED, HEADING];
/** The states that are solved for. */
const CORE = MODEL.dynamic.filter((s) => !HELD.includes(s)).map(state);

/** Derivatives of the rates of the core states by themselves, row by row. */
const jacobianOf = (() => {
  const dx = new Float64Array(NX), du = new Float64Array(NU), dp = new Float64Array(NP);
  const moved = new Float64Array(NX), seen = new Float64Array(NY), n = CORE.length;
  return (x, u, p, A) => {
    for (let j = 0; j < n; ++j) {
      dx[CORE[j]] = 1;
      along(x, u, p, dx, du, dp, moved, seen);
      dx[CORE[j]] = 0;
      for (let i = 0; i < n; ++i) A[i * n + j] = moved[CORE[i]];
    }
    return A;
  };
})();

/** Solve A d = b by elimination with full pivoting; what nothing determines stays zero. */
function solved(A, b, n) {
  const M = Float64Array.from(A), right = Float64Array.from(b), d = new Float64Array(n);
  const rows = [], columns = [], usedRow = new Uint8Array(n), usedColumn = new Uint8Array(n);
  let largest = 0;
  for (let step = 0; step < n; ++step) {
    let best = 0, row = -1, column = -1;
    for (let i = 0; i < n; ++i) {
      if (usedRow[i]) continue;
      for (let j = 0; j < n; ++j) {
        if (usedColumn[j] || !(Math.abs(M[i * n + j]) > best)) continue;
        best = Math.abs(M[i * n + j]);
        row = i;
        column = j;
      }
    }
    largest = Math.max(largest, best);
    if (!(best > 1e-13 * largest)) break;
    usedRow[row] = usedColumn[column] = 1;
    rows.push(row);
    columns.push(column);
    for (let i = 0; i < n; ++i) {
      if (usedRow[i] || !M[i * n + column]) continue;
      const factor = M[i * n + column] / M[row * n + column];
      for (let j = 0; j < n; ++j) M[i * n + j] -= factor * M[row * n + j];
      right[i] -= factor * right[row];
    }
  }
  for (let k = rows.length - 1; k >= 0; --k) {
    let sum = right[rows[k]];
    for (let l = k + 1; l < rows.length; ++l) sum -= M[rows[k] * n + columns[l]] * d[columns[l]];
    d[columns[k]] = sum / M[rows[k] * n + columns[k]];
  }
  return d;
}

const rateOf = new Float64Array(NX);

/** Size of the rates of the core states. */
function unrest(x, u, p) {
  rates(x, u, p, rateOf);
  return Math.hypot(...CORE.map((i) => rateOf[i]));
}

/**
 * Move x to where the rates of the core states vanish; whether that succeeded. With `pace` in s it
 * is implicit steps in time, longer and longer, which lead to where the motion itself would settle;
 * without it is Newton's method from a place near by.
 */
function steady(x, u, p, pace = Infinity, most = 40) {
  const n = CORE.length, A = new Float64Array(n * n), trial = Float64Array.from(x);
  let now = unrest(x, u, p);
  for (let count = 0; count < most && now > 1e-11; ++count) {
    jacobianOf(x, u, p, A);
    for (let k = 0; k < n; ++k) A[k * n + k] -= 1 / pace;
    unrest(x, u, p);
    const d = solved(A, CORE.map((i) => -rateOf[i]), n);
    if (!d.every(Number.isFinite)) return false;
    for (let k = 0; k < n; ++k) trial[CORE[k]] = x[CORE[k]] + d[k];
    const next = unrest(trial, u, p);
    const near = now < 1e-7;
    if (!(next < (pace < Infinity ? 2 : near ? 1 : 10) * now)) {
      if (near) break; // as near as rounding lets it come
      if (pace === Infinity) return false;
      pace /= 4;
      if (pace < 1e-6) return false;
      continue;
    }
    pace *= Math.min(4, Math.max(0.5, (1.2 * now) / next));
    x.set(trial);
    now = next;
  }
  return unrest(x, u, p) < 1e-7;
}

/** Steady rolling of the design on the page, beside which others are sought. */
let anchor = null;

/**
 * Steady rolling of a design with its speed and heading held, and the linear model there.
 * It is sought near `seed` first, then from rest. `ok` is false if there is none, or a parameter
 * cannot be; `problems` says why.
 */
function operatingPoint(design, seed = anchor) {
  const { p, known, problems } = parametersOf(design);
  const u = inputsOf(design), x = straight(known), point = { ok: false, problems, p, known, u, x };
  if (problems.length) return point;
  if (seed) {
    for (const i of CORE) x[i] = seed[i];
    point.ok = steady(x, u, p) && holds(point);
  }
  if (!point.ok) {
    x.set(straight(known));
    point.ok = (!DATA.rest || atRest(x, p)) && steady(x, u, p, 0.05, 100) && holds(point);
  }
  if (!point.ok) problems.push("there is no steady roll at this speed");
  return point;
}

/**
 * Find the eigenvalues at an operating point, and whether it is one to which a roll comes: what
 * has nothing to do with turning must be stable, or it is a balance that nobody sees.
 */
function holds(point) {
  const n = CORE.length, A = jacobianOf(point.x, point.u, point.p, new Float64Array(n * n));
  const all = CORE.map((_, i) => i);
  const live = all.filter((i) => all.some((j) => A[i * n + j]) && all.some((j) => A[j * n + i]));
  const lateral = [MODEL.roles.lateral_velocity, MODEL.roles.yaw_rate].map((s) => CORE.indexOf(state(s ?? "")));
  point.roots = [];
  let good = true;
  for (const block of blocks(A, n, live)) {
    const m = block.length, B = new Float64Array(m * m);
    block.forEach((i, k) => block.forEach((j, l) => (B[k * m + l] = A[i * n + j])));
    const found = eigenvalues(B, m);
    good &&= block.some((i) => lateral.includes(i)) || found.every(({ re }) => re <= 1e-9);
    point.roots.push(...found);
  }
  point.roots.sort((a, b) => b.re - a.re || b.im - a.im);
  return good;
}

/** Sets of states that have to do with each other. */
function blocks(A, n, live) {
  const left = new Set(live), found = [];
  while (left.size) {
    const block = [], queue = [left.values().next().value];
    left.delete(queue[0]);
    while (queue.length) {
      const i = queue.pop();
      block.push(i);
      for (const j of [...left]) {
        if (A[i * n + j] || A[j * n + i]) {
          left.delete(j);
          queue.push(j);
        }
      }
    }
    found.push(block.sort((a, b) => a - b));
  }
  return found;
}

/** How fast the slowest deviation decays at a point, 1/s; NaN without a steady roll. */
const decayAt = (point) => (point.ok && point.roots.length ? -point.roots[0].re : NaN);
const decayOf = (design) => decayAt(operatingPoint(design));
