// Eigenvalues of a real matrix.

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
