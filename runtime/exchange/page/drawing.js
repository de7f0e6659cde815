// Making elements, and what pictures share.
const $ = (id) => document.getElementById(id);

/** An element of HTML with text and attributes. */
function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

/** An element of SVG in another. */
function shape(parent, tag, attributes = {}, text = "") {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  set(made, attributes);
  if (text) made.textContent = text;
  parent.append(made);
  return made;
}

function set(node, attributes) {
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
}

/** Points as a path: M x y L x y ... */
const lines = (points, closed = false) =>
  points.map(([x, y], k) => `${k ? "L" : "M"}${x.toFixed(2)} ${y.toFixed(2)}`).join("") + (closed ? "Z" : "");

/** Round numbers between two ends, about `count` of them. */
function ticks(low, high, count = 5) {
  const raw = (high - low) / count;
  if (!(raw > 0)) return [low];
  const size = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].find((n) => n * size >= raw) * size;
  const found = [];
  for (let k = Math.ceil(low / step); k * step <= high + 1e-9 * step; ++k) found.push(k * step);
  return found;
}

/** Length of the aircraft from its CG to its tail, or of what takes its place, m. */
function lengthOf(place) {
  const fin = MODEL.places.findIndex(({ kind }) => kind === "fin");
  if (fin >= 0 && place[3 * fin] < 0) return -place[3 * fin];
  const reach = MODEL.places.map((_, i) => Math.abs(place[3 * i]));
  return Math.max(0.5, ...reach);
}
const HAS_FIN = MODEL.places.some(({ kind }) => kind === "fin");

/** The airframe from above in its own lengths, [ahead, right]: a typical light aircraft, or a box. */
function airframe(place) {
  if (HAS_FIN) {
    return Object.values(DATA.airframe).map((half) => [
      ...half,
      ...half.map(([x, y]) => [x, -y]).reverse(),
    ]);
  }
  const wheels = MODEL.places.map((_, i) => i).filter((i) => MODEL.places[i].kind === "wheel");
  const used = wheels.length ? wheels : MODEL.places.map((_, i) => i);
  const size = lengthOf(place);
  const xs = used.map((i) => place[3 * i] / size), ys = used.map((i) => Math.abs(place[3 * i + 1]) / size);
  const [front, back] = [Math.max(0.3, ...xs) + 0.35, Math.min(-0.3, ...xs) - 0.35];
  const wide = Math.max(0.35, ...ys) * 1.02;
  return [[[front, -wide * 0.8], [front, wide * 0.8], [front - 0.15, wide], [back, wide], [back, -wide], [front - 0.15, -wide]]];
}

/** Where wheels are drawn, [ahead, right] in m: one that stands for a pair is drawn as two. */
function wheelsOf(place) {
  const wheels = MODEL.places.map((_, i) => i).filter((i) => MODEL.places[i].kind === "wheel");
  const size = lengthOf(place), found = [];
  const single = HAS_FIN && wheels.every((i) => Math.abs(place[3 * i + 1]) < 1e-6);
  const main = single && wheels.reduce((a, b) => (Math.abs(place[3 * a]) <= Math.abs(place[3 * b]) ? a : b), wheels[0]);
  for (const i of wheels) {
    const [x, y] = [place[3 * i], place[3 * i + 1]];
    if (i === main) found.push([x, -0.27 * size], [x, 0.27 * size]);
    else found.push([x, y]);
  }
  return found;
}
