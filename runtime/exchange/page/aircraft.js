// The aircraft from above and from the side, whose wheels can be dragged.
const WIDE = 640, PLAN = 410, SIDE = 150;
const HANDLES = []; // { place, node, axes }, the CG with place -1
let frameOf = null; // what is in the picture, m
let movers = null;
let drawn = null; // places as they are drawn

/** Places of the parts in a design, x, y, z each, m from the CG. */
function placesOf(trial) {
  const { p, known } = parametersOf(trial), place = new Float64Array(3 * MODEL.places.length);
  const x = straight(known);
  if (DATA.rest) atRest(x, p);
  places(x, new Float64Array(NU), p, place, new Float64Array(place.length));
  return place;
}

/** What each slider does to places: derivatives by its value, m/m. */
function moversOf(trial) {
  const base = placesOf(trial), effect = new Map(), known = resolved(trial.given);
  for (const s of SLIDERS.keys()) {
    if (QUANTITIES[s].unit !== "m" || s in trial.start || s in trial.inputs) continue;
    const other = copied(trial), by = 1e-4;
    other.given[s] = known.value(s) + by;
    const moved = placesOf(other).map((x, i) => (x - base[i]) / by);
    if (moved.some((x) => Math.abs(x) > 0.3)) effect.set(s, moved);
  }
  const count = MODEL.places.length, all = [...Array(count).keys()];
  const drawn = all.filter((i) => MODEL.places[i].kind !== "force"), first = drawn[0] ?? 0;
  const shifts = (moved) => drawn.every((i) => Math.abs(moved[3 * i] / moved[3 * first] - 1) < 0.05);
  const cg = [...effect.keys()].find((s) => s in trial.given && drawn.length > 1 && shifts(effect.get(s))) ?? null;
  const best = (i, axis) => {
    const cost = (s) => {
      const moved = effect.get(s);
      const others = all.filter((k) => k !== i && Math.abs(moved[3 * k + axis]) > 0.3).length;
      return others + (s in trial.given ? 0 : 0.5) + (SLIDERS.get(s).group ? 0 : 0.4);
    };
    const able = [...effect.keys()].filter((s) => s !== cg && Math.abs(effect.get(s)[3 * i + axis]) > 0.3);
    return able.sort((a, b) => cost(a) - cost(b))[0] ?? null;
  };
  return { effect, cg, first, of: all.map((i) => [0, 1, 2].map((axis) => best(i, axis))) };
}

/** How far the datum of the picture is ahead of the CG, so that what does not move stands still. */
function datum() {
  return movers.cg ? -movers.effect.get(movers.cg)[3 * movers.first] * resolved(design.given).value(movers.cg) : 0;
}

function buildAircraft() {
  for (const [id, high] of [["plan", PLAN], ["side", SIDE]]) {
    set($(id), { viewBox: `0 0 ${WIDE} ${high}` });
    $(id).addEventListener("keydown", keyed);
  }
  reframe();
}

/** Choose what is in the picture, for the design as it is now. */
function reframe() {
  movers = moversOf(design);
  const place = placesOf(design), d = datum(), size = lengthOf(place);
  const xs = airframe(place).flat().map(([x]) => x * size + d), ys = airframe(place).flat().map(([, y]) => y * size);
  const [low, high] = [Math.min(...xs) - 0.06 * size, Math.max(...xs) + 0.06 * size];
  const wide = Math.max(...ys) * 1.04;
  const scale = Math.min(WIDE / (high - low), PLAN / (2 * wide));
  frameOf = { middle: (low + high) / 2, scale, size };
  for (const id of ["plan", "side"]) $(id).replaceChildren();
  HANDLES.length = 0;
  const plan = $("plan"), side = $("side");
  shape(plan, "path", { class: "airframe", id: "plan-airframe" });
  shape(side, "path", { class: "airframe", id: "side-airframe" });
  shape(side, "path", { class: "ground", id: "side-ground" });
  shape(plan, "path", { class: "wheels", id: "plan-wheels" });
  shape(side, "path", { class: "wheels", id: "side-wheels" });
  shape(plan, "path", { class: "axis", id: "plan-axis" });
  MODEL.places.forEach(({ name, kind }, i) => {
    if (kind === "force") return;
    addHandle(plan, i, [0, 1], kind, plain(name));
    addHandle(side, i, [0, 2], kind, plain(name));
  });
  addHandle(plan, -1, [0, 1], "cg", "center of gravity");
  addHandle(side, -1, [0, 2], "cg", "center of gravity");
}

/** Something to drag, if there is anything that moves it. */
function addHandle(view, place, axes, kind, name) {
  const moves = axes.map((axis) => moverOf(place, axis));
  const group = shape(view, "g", { class: `handle ${kind}` });
  shape(group, "circle", { class: "hit", r: 17 });
  if (kind === "cg") {
    shape(group, "circle", { class: "mark", r: 8 });
    shape(group, "path", { class: "quarters", d: "M0 0V-8A8 8 0 0 1 8 0ZM0 0V8A8 8 0 0 1 -8 0Z" });
  } else shape(group, "circle", { class: "mark", r: 5.5 });
  shape(group, "title", {}, name);
  HANDLES.push({ place, axes, group, view });
  if (!moves.some(Boolean)) {
    group.classList.add("fixed");
    return;
  }
  set(group, { tabindex: 0, role: "slider", "aria-label": `${name}: drag, or arrow keys` });
  group.dataset.handle = HANDLES.length - 1;
  group.addEventListener("pointerdown", dragged);
}

/** The slider that moves a place along an axis; for the CG whatever moves all places. */
function moverOf(place, axis) {
  if (place >= 0) return movers.of[place][axis];
  return axis === 0 ? movers.cg : null;
}

/** By how much the picture of a handle moves along an axis with its slider. */
function gain(place, axis) {
  const s = moverOf(place, axis);
  return place >= 0 ? movers.effect.get(s)[3 * place + axis] : -movers.effect.get(s)[3 * movers.first];
}

/** Where a handle is, m in the picture's axes. */
function placeOf({ place, axes }) {
  if (place < 0) return [datum(), 0];
  return [drawn[3 * place] + datum(), drawn[3 * place + axes[1]]];
}

/** Move what a handle stands for by metres along its two axes. */
function moveBy({ place, axes }, from, by) {
  axes.forEach((axis, k) => {
    const s = moverOf(place, axis);
    if (!s || !by[k]) return;
    const value = allowed(s, from[s] + by[k] / gain(place, axis));
    if (Number.isFinite(value)) change(s, value);
  });
}

/** Values of the sliders that a handle moves. */
function valuesOf({ place, axes }) {
  const known = resolved(design.given), found = {};
  for (const axis of axes) {
    const s = moverOf(place, axis);
    if (s) found[s] = known.value(s);
  }
  return found;
}

function dragged(event) {
  const handle = HANDLES[event.currentTarget.dataset.handle], node = event.currentTarget;
  event.preventDefault();
  node.focus();
  node.setPointerCapture(event.pointerId);
  const from = valuesOf(handle), start = pointed(handle.view, event);
  const move = (e) => {
    const now = pointed(handle.view, e);
    moveBy(handle, from, [(now[0] - start[0]) / frameOf.scale, (now[1] - start[1]) / frameOf.scale]);
  };
  const end = () => {
    node.removeEventListener("pointermove", move);
    node.removeEventListener("pointerup", end);
    node.removeEventListener("pointercancel", end);
  };
  node.addEventListener("pointermove", move);
  node.addEventListener("pointerup", end);
  node.addEventListener("pointercancel", end);
}

/** A place of the pointer in a picture. */
function pointed(view, event) {
  const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(view.getScreenCTM().inverse());
  return [point.x, point.y];
}

function keyed(event) {
  const step = event.shiftKey ? 0.1 : 0.01;
  const by = { ArrowRight: [step, 0], ArrowLeft: [-step, 0], ArrowDown: [0, step], ArrowUp: [0, -step] }[event.key];
  const index = event.target.dataset?.handle;
  if (!by || index === undefined) return;
  event.preventDefault();
  moveBy(HANDLES[index], valuesOf(HANDLES[index]), by);
}

function drawAircraft() {
  drawn = placesOf(design);
  if (!drawn.every(Number.isFinite)) return;
  const { scale, middle } = frameOf, d = datum(), size = lengthOf(drawn);
  const at = ([x, y]) => [WIDE / 2 + (x - middle) * scale, PLAN / 2 + y * scale];
  const outline = airframe(drawn).map((part) => lines(part.map(([x, y]) => at([x * size + d, y * size])), true));
  set($("plan-airframe"), { d: outline.join("") });
  const tire = (x, y, long, wide) => lines([[x - long, y - wide], [x + long, y - wide], [x + long, y + wide], [x - long, y + wide]], true);
  set($("plan-wheels"), {
    d: wheelsOf(drawn).map(([x, y]) => tire(...at([x + d, y]), 0.068 * size * scale, 0.026 * size * scale)).join(""),
  });
  set($("plan-axis"), { d: lines([at([middle - WIDE, 0]), at([middle + WIDE, 0])]) });
  drawSide(d, size);
  for (const handle of HANDLES) {
    const [x, y] = placeOf(handle);
    const middleY = handle.view.id === "plan" ? PLAN / 2 : sideLevel();
    const level = handle.view.id === "side" && handle.place >= 0 ? onSide(handle.place, size) : y;
    const where = [WIDE / 2 + (x - middle) * scale, middleY + level * scale];
    set(handle.group, { transform: `translate(${where[0].toFixed(2)} ${where[1].toFixed(2)})` });
    if (handle.group.hasAttribute("tabindex")) {
      const said = Object.keys(valuesOf(handle)).map((s) => `${plain(QUANTITIES[s].name)} ${withUnit(s, resolved(design.given).value(s))}`);
      set(handle.group, { "aria-valuetext": said.join(", "), "aria-valuenow": x.toFixed(3) });
    }
  }
}

/** Height of the CG in the picture from the side. */
const sideLevel = () => SIDE * 0.46;

/** Depth below the CG at which a place is drawn from the side, m; a level model knows no depths. */
function onSide(i, size) {
  const level = MODEL.places.every((_, k) => Math.abs(drawn[3 * k + 2]) < 1e-9);
  if (!level) return drawn[3 * i + 2];
  const height = resolved(design.given).value("h_cg");
  return MODEL.places[i].kind === "wheel" ? (Number.isFinite(height) ? height : 0.22 * size) : -0.1 * size;
}

/** A typical airframe from the side, [ahead, down] in lengths from the CG to the tail. */
const FROM_SIDE = [
  [[0.56, -0.02], [0.5, -0.07], [0.33, -0.08], [0.2, -0.19], [-0.12, -0.19], [-0.3, -0.09], [-0.86, -0.05],
   [-0.98, -0.27], [-1.07, -0.27], [-1.09, 0.0], [-0.9, 0.02], [-0.1, 0.1], [0.4, 0.1], [0.54, 0.06]],
];

function drawSide(d, size) {
  const { scale, middle } = frameOf;
  const at = ([x, z]) => [WIDE / 2 + (x - middle) * scale, sideLevel() + z * scale];
  const box = airframe(drawn)[0].map(([x]) => x);
  const [front, back] = [Math.max(...box), Math.min(...box)];
  const body = HAS_FIN ? FROM_SIDE : [[[front, 0.05], [front - 0.3, -0.1], [back, -0.1], [back, 0.12], [front, 0.12]]];
  set($("side-airframe"), { d: body.map((part) => lines(part.map(([x, z]) => at([x * size + d, z * size])), true)).join("") });
  const wheels = MODEL.places.map((_, i) => i).filter((i) => MODEL.places[i].kind === "wheel");
  const radius = 0.052 * size;
  const touch = wheels.map((i) => [drawn[3 * i] + d, onSide(i, size)]);
  const circle = ([x, z]) => {
    const [cx, cy] = at([x, z - radius]), r = radius * scale;
    return `M${cx - r} ${cy}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0Z`;
  };
  set($("side-wheels"), { d: touch.map(circle).join("") });
  const sorted = touch.slice().sort((a, b) => a[0] - b[0]);
  if (sorted.length < 2) return;
  const [[x1, z1], [x2, z2]] = [sorted[0], sorted.at(-1)];
  const slope = x2 > x1 ? (z2 - z1) / (x2 - x1) : 0;
  const far = WIDE / scale;
  set($("side-ground"), { d: lines([at([x1 - far, z1 - slope * far]), at([x1 + far, z1 + slope * far])]) });
}
