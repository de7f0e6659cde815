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

/**
 * Eigenvalues of a real matrix, given row by row: balanced, reduced to Hessenberg form by
 * elimination, then shifted QR steps (EISPACK's balanc, elmhes and hqr).
 */
function eigenvalues(matrix, n) {
  const A = Float64Array.from(matrix), at = (i, j) => A[i * n + j], found = [];
  if (!A.every(Number.isFinite)) return Array.from({ length: n }, () => ({ re: NaN, im: NaN }));
  balance(A, n);
  hessenberg(A, n);
  let norm = 0;
  for (let i = 0; i < n; ++i) for (let j = Math.max(i - 1, 0); j < n; ++j) norm += Math.abs(at(i, j));
  let end = n - 1, shift = 0, count = 0;
  while (end >= 0) {
    let low = end;
    for (; low > 0; --low) {
      const scale = Math.abs(at(low - 1, low - 1)) + Math.abs(at(low, low)) || norm;
      if (Math.abs(at(low, low - 1)) <= 2e-16 * scale) break;
    }
    let x = at(end, end);
    if (low === end) {
      found.push({ re: x + shift, im: 0 });
      --end;
      count = 0;
      continue;
    }
    let y = at(end - 1, end - 1), w = at(end, end - 1) * at(end - 1, end);
    if (low === end - 1) {
      const half = 0.5 * (y - x), disc = half * half + w, root = Math.sqrt(Math.abs(disc));
      x += shift;
      if (disc >= 0) {
        const z = half + (half < 0 ? -root : root);
        found.push({ re: x + z, im: 0 }, { re: z ? x - w / z : x + z, im: 0 });
      } else {
        found.push({ re: x + half, im: root }, { re: x + half, im: -root });
      }
      end -= 2;
      count = 0;
      continue;
    }
    if (++count > 60) return Array.from({ length: n }, () => ({ re: NaN, im: NaN }));
    if (count % 10 === 0) {
      shift += x;
      for (let i = 0; i <= end; ++i) A[i * n + i] -= x;
      const s = Math.abs(at(end, end - 1)) + Math.abs(at(end - 1, end - 2));
      [x, y, w] = [0.75 * s, 0.75 * s, -0.4375 * s * s];
    }
    doubleStep(A, n, low, end, x, y, w);
  }
  return found.sort((a, b) => b.re - a.re || b.im - a.im);
}

/** Scale rows and columns by powers of two until they are alike. */
function balance(A, n) {
  for (let done = false; !done; ) {
    done = true;
    for (let i = 0; i < n; ++i) {
      let column = 0, row = 0;
      for (let j = 0; j < n; ++j) {
        if (j === i) continue;
        column += Math.abs(A[j * n + i]);
        row += Math.abs(A[i * n + j]);
      }
      if (!column || !row) continue;
      const factor = 2 ** Math.round(Math.log2(row / column) / 2);
      if ((column * factor + row / factor) < 0.95 * (column + row)) {
        done = false;
        for (let j = 0; j < n; ++j) A[i * n + j] /= factor;
        for (let j = 0; j < n; ++j) A[j * n + i] *= factor;
      }
    }
  }
}

function hessenberg(A, n) {
  for (let m = 1; m < n - 1; ++m) {
    let pivot = m;
    for (let i = m; i < n; ++i) {
      if (Math.abs(A[i * n + m - 1]) > Math.abs(A[pivot * n + m - 1])) pivot = i;
    }
    if (pivot !== m) {
      for (let j = m - 1; j < n; ++j) [A[pivot * n + j], A[m * n + j]] = [A[m * n + j], A[pivot * n + j]];
      for (let j = 0; j < n; ++j) [A[j * n + pivot], A[j * n + m]] = [A[j * n + m], A[j * n + pivot]];
    }
    const x = A[m * n + m - 1];
    if (!x) continue;
    for (let i = m + 1; i < n; ++i) {
      const y = A[i * n + m - 1] / x;
      if (!y) continue;
      A[i * n + m - 1] = 0;
      for (let j = m; j < n; ++j) A[i * n + j] -= y * A[m * n + j];
      for (let j = 0; j < n; ++j) A[j * n + m] += y * A[j * n + i];
    }
  }
}

/** A double QR step of Francis between the rows `low` and `end`. */
function doubleStep(A, n, low, end, x, y, w) {
  const at = (i, j) => A[i * n + j];
  let p = 0, q = 0, r = 0, m = end - 2;
  for (; m >= low; --m) {
    const z = at(m, m), a = x - z, b = y - z;
    p = (a * b - w) / at(m + 1, m) + at(m, m + 1);
    q = at(m + 1, m + 1) - z - a - b;
    r = at(m + 2, m + 1);
    const s = Math.abs(p) + Math.abs(q) + Math.abs(r);
    [p, q, r] = [p / s, q / s, r / s];
    if (m === low) break;
    const u = Math.abs(at(m, m - 1)) * (Math.abs(q) + Math.abs(r));
    const v = Math.abs(p) * (Math.abs(at(m - 1, m - 1)) + Math.abs(z) + Math.abs(at(m + 1, m + 1)));
    if (u <= 1e-16 * v) break;
  }
  for (let i = m + 2; i <= end; ++i) {
    A[i * n + i - 2] = 0;
    if (i > m + 2) A[i * n + i - 3] = 0;
  }
  for (let k = m; k < end; ++k) {
    let scale = 1;
    const last = k === end - 1;
    if (k > m) {
      [p, q, r] = [at(k, k - 1), at(k + 1, k - 1), last ? 0 : at(k + 2, k - 1)];
      scale = Math.abs(p) + Math.abs(q) + Math.abs(r);
      if (!scale) continue;
      [p, q, r] = [p / scale, q / scale, r / scale];
    }
    const s = (p < 0 ? -1 : 1) * Math.hypot(p, q, r);
    if (!s) continue;
    if (k > m) A[k * n + k - 1] = -s * scale;
    else if (low !== m) A[k * n + k - 1] = -at(k, k - 1);
    p += s;
    const a = p / s, b = q / s, c = r / s;
    [q, r] = [q / p, r / p];
    for (let j = k; j <= end; ++j) {
      let t = at(k, j) + q * at(k + 1, j);
      if (!last) {
        t += r * at(k + 2, j);
        A[(k + 2) * n + j] -= t * c;
      }
      A[(k + 1) * n + j] -= t * b;
      A[k * n + j] -= t * a;
    }
    for (let i = low; i <= Math.min(end, k + 3); ++i) {
      let t = a * at(i, k) + b * at(i, k + 1);
      if (!last) {
        t += c * at(i, k + 2);
        A[i * n + k + 2] -= t * r;
      }
      A[i * n + k + 1] -= t * q;
      A[i * n + k] -= t;
    }
  }
}
