// Eigenvalues in their plane, and what they say in words.
const MODES = { wide: 300, high: 240 };

/** A place on a stretched axis, so that slow and fast modes go into one picture. */
const stretched = (x) => Math.asinh(x / 0.4) / Math.asinh(200 / 0.4);

function buildModes() {
  const view = $("modes"), { wide, high } = MODES;
  set(view, { viewBox: `0 0 ${wide} ${high}` });
  shape(view, "rect", { class: "stable-half", x: 0, y: 0, width: wide * 0.7, height: high });
  shape(view, "rect", { class: "unstable-half", x: wide * 0.7, y: 0, width: wide * 0.3, height: high });
  for (const x of [-100, -10, -1, 1, 10]) {
    const at = modeAt({ re: x, im: 0 })[0];
    shape(view, "path", { class: "tick", d: `M${at} ${high / 2 - 3}v6` });
    shape(view, "text", { x: at, y: high / 2 + 14, "text-anchor": "middle" }, brief(x));
  }
  for (const y of [-10, -1, 1, 10]) {
    const at = modeAt({ re: 0, im: y })[1];
    shape(view, "path", { class: "tick", d: `M${wide * 0.7 - 3} ${at}h6` });
    shape(view, "text", { x: wide * 0.7 + 6, y: at + 3 }, brief(y));
  }
  shape(view, "path", { class: "axes", d: `M0 ${high / 2}H${wide}M${wide * 0.7} 0V${high}` });
  shape(view, "text", { x: 6, y: 14 }, "stable");
  shape(view, "text", { x: wide - 6, y: 14, "text-anchor": "end" }, "unstable");
  shape(view, "g", { id: "roots" });
}

function modeAt({ re, im }) {
  const { wide, high } = MODES, across = wide * 0.7;
  const x = across + stretched(re) * (re < 0 ? across : wide - across) * (re < 0 ? 0.97 : 0.97);
  return [Math.min(wide - 5, Math.max(5, x)), high / 2 - stretched(im) * high * 0.5];
}

function drawModes(point, roots) {
  const group = $("roots");
  while (group.childNodes.length > roots.length) group.lastChild.remove();
  roots.forEach((root, k) => {
    const node = group.childNodes[k] ?? shape(group, "path");
    const [x, y] = modeAt(root);
    const isBad = root.re > 0;
    set(node, {
      class: isBad ? "root bad" : "root",
      d: isBad ? `M${x - 5} ${y - 5}l10 10m0 -10l-10 10` : `M${x - 5} ${y}a5 5 0 1 0 10 0a5 5 0 1 0 -10 0`,
    });
  });
  const slowest = roots[0] ?? { re: NaN, im: 0 };
  const rows = point.ok
    ? [
        ["Slowest mode", `${brief(slowest.re)}${slowest.im ? ` ± ${brief(Math.abs(slowest.im))} i` : ""} 1/s`],
        slowest.re > 0 ? ["Doubles in", `${brief(Math.LN2 / slowest.re)} s`] : ["Halves in", `${brief(-Math.LN2 / slowest.re)} s`],
        ["Damping ratio", slowest.im ? brief(-slowest.re / Math.hypot(slowest.re, slowest.im)) : "no oscillation"],
      ]
    : point.problems.map((problem) => ["Not computed", problem]);
  fill($("mode-table"), rows);
}

/** A table of two columns. */
function fill(table, rows) {
  table.replaceChildren(
    ...rows.map(([head, text]) => element("tr", {}, element("th", { scope: "row" }, head), element("td", {}, text))),
  );
}
