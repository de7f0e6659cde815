// The roll seen from above, as it goes on in time, and what becomes of it.
const RUNWAY = innerWidth < 760 ? { wide: 420, high: 260 } : { wide: 900, high: 260 };
let rolled = null; // the roll that is drawn
let playing = false, playedAt = 0, shownTime = 0;
const QUIET = matchMedia("(prefers-reduced-motion: reduce)").matches;

function buildRunway() {
  const view = $("runway");
  set(view, { viewBox: `0 0 ${RUNWAY.wide} ${RUNWAY.high}` });
  shape(view, "rect", { class: "grass", width: RUNWAY.wide, height: RUNWAY.high });
  shape(view, "rect", { class: "asphalt", id: "asphalt", x: 0, width: RUNWAY.wide });
  shape(view, "path", { class: "centerline", id: "centerline" });
  shape(view, "g", { id: "ghosts" });
  shape(view, "path", { class: "track", id: "track" });
  shape(view, "path", { class: "happens", id: "happens" });
  const plane = shape(view, "g", { id: "plane" });
  shape(plane, "path", { class: "airframe" });
  shape(plane, "path", { class: "wheels" });
  shape(view, "path", { class: "force", id: "forces" });
  shape(view, "g", { id: "runway-ticks" });
  $("play").addEventListener("click", () => play(!playing));
  $("time").addEventListener("input", () => {
    play(false);
    showTime(Number($("time").value) * rolled.duration);
  });
}

/** Whether the model knows where it goes. */
const HAS_PATH = [DISTANCE, OFFSET, HEADING].every((s) => s && state(s) >= 0);

/** Half the width of the runway, m. */
function halfWidth() {
  const width = resolved(design.given).value("runway_width");
  return width > 0 ? width / 2 : DATA.limits.half_width;
}

/** Show a roll that has been computed. */
function drawRoll(roll) {
  rolled = roll;
  const fate = fateOf(roll), x = roll.at(Math.max(0, roll.kept - 1), new Float64Array(NX));
  const stopped = MODEL.events.findIndex(({ name }) => name === "stopped");
  const head = fate ? `${sentence(fate.text)} after ${brief(fate.t, 3)}\u202fs`
    : stopped >= 0 && roll.first[stopped] < Infinity ? `Stops after ${brief(roll.first[stopped], 3)}\u202fs` : "Ends well";
  const where = HAS_PATH
    ? `; after ${brief(roll.end, 3)}\u202fs ${withUnit(OFFSET, x[state(OFFSET)], 3)} across, heading ${withUnit(HEADING, x[state(HEADING)], 3)}`
    : "";
  $("fate").textContent = `${head}${where}.`;
  $("fate").className = fate ? "bad" : "good";
  $("fate").dataset.fate = fate?.name ?? "";
  if (HAS_PATH) drawPath(roll, fate);
  showTime(Math.min(shownTime, roll.duration));
}

/** A text with a capital in front. */
const sentence = (text) => text.charAt(0).toUpperCase() + text.slice(1);

/** From the ground to the picture; across, metres may be drawn larger than along. */
function groundOf(roll) {
  const X = [], Y = [], x = new Float64Array(NX);
  for (let k = 0; k < roll.kept; ++k) {
    roll.at(k, x);
    X.push(x[state(DISTANCE)]);
    Y.push(x[state(OFFSET)]);
  }
  const { wide, high } = RUNWAY, half = Math.min(200, Math.max(halfWidth() * 1.25, ...Y.map((y) => Math.abs(y) * 1.1)));
  const [low, top] = [Math.min(...X), Math.max(...X)], reach = Math.max(top - low, 20) * 1.16;
  const along = wide / reach, across = high / (2 * half), first = low - 0.07 * reach;
  return { X, Y, at: (a, b) => [(a - first) * along, high / 2 + b * across], along, across, half };
}

function drawPath(roll, fate) {
  const ground = groundOf(roll), edge = halfWidth(), { wide } = RUNWAY;
  roll.ground = ground;
  const [, top] = ground.at(0, -edge), [, bottom] = ground.at(0, edge);
  set($("asphalt"), { y: top, height: bottom - top });
  set($("centerline"), { d: `M0 ${RUNWAY.high / 2}H${wide}` });
  set($("track"), { d: lines(ground.X.map((a, k) => ground.at(a, ground.Y[k]))) });
  const marks = $("runway-ticks");
  marks.replaceChildren();
  const s = DISTANCE, [unit, factor] = shownIn(s);
  const from = ground.X[0] * factor, to = Math.max(...ground.X) * factor;
  for (const value of ticks(Math.min(from, to), to, RUNWAY.wide / 150)) {
    const [px] = ground.at(value / factor, 0);
    shape(marks, "path", { d: `M${px} ${RUNWAY.high}v-6` });
    shape(marks, "text", { x: px + 4, y: RUNWAY.high - 4 }, `${brief(value)} ${unit}`);
  }
  const ratio = ground.across / ground.along;
  shape(marks, "text", { x: wide - 8, y: 16, "text-anchor": "end" }, ratio > 1.05 || ratio < 0.95 ? `across ${brief(ratio, 2)} times as large as along` : "to scale");
  const place = placesOf(design), k = fate ? nearest(roll, fate.t) : -1;
  const at = k >= 0 ? ground.at(ground.X[k], ground.Y[k]) : null;
  set($("happens"), { d: at ? `M${at[0] - 7} ${at[1] - 7}l14 14m0 -14l-14 14` : "" });
  roll.outline = outlineOf(place);
  const ghosts = $("ghosts");
  const count = 8;
  while (ghosts.childNodes.length < count) shape(ghosts, "path", { class: "ghost" });
  for (let n = 0; n < count; ++n) {
    const sample = Math.round(((roll.kept - 1) * n) / (count - 1));
    set(ghosts.childNodes[n], { d: roll.outline.body, transform: poseOf(roll, sample) });
  }
  const plane = $("plane").childNodes;
  set(plane[0], { d: roll.outline.body });
  set(plane[1], { d: roll.outline.wheels });
}

/** The aircraft in its own axes, px, nose to the right: it is drawn larger than to scale. */
function outlineOf(place) {
  const size = lengthOf(place), scale = 34 / size;
  const body = airframe(place).map((part) => lines(part.map(([x, y]) => [x * 34, y * 34]), true)).join("");
  const wheels = wheelsOf(place)
    .map(([x, y]) => [x * scale, y * scale])
    .map(([x, y]) => lines([[x - 2.6, y - 1.1], [x + 2.6, y - 1.1], [x + 2.6, y + 1.1], [x - 2.6, y + 1.1]], true))
    .join("");
  return { body, wheels, scale };
}

const nearest = (roll, t) => Math.min(roll.kept - 1, Math.max(0, Math.round((t / roll.duration) * (roll.samples - 1))));

/** Where the aircraft is in the picture at a sample, and how it points. */
function poseOf(roll, k) {
  const { ground } = roll, psi = roll.series[k * NX + state(HEADING)];
  const [x, y] = ground.at(ground.X[k], ground.Y[k]);
  const turned = (Math.atan2(ground.across * Math.sin(psi), ground.along * Math.cos(psi)) * 180) / Math.PI;
  return `translate(${x.toFixed(2)} ${y.toFixed(2)}) rotate(${turned.toFixed(2)})`;
}

/** Show the aircraft at a time of the roll. */
function showTime(t) {
  shownTime = t;
  if (!rolled) return;
  const k = nearest(rolled, t), x = rolled.at(k, new Float64Array(NX));
  $("time").value = t / rolled.duration;
  const speed = state(SPEED) >= 0 ? `, ${withUnit(SPEED, x[state(SPEED)], 3)}` : "";
  $("clock").textContent = `${brief(rolled.time(k), 3)}\u202fs${speed}`;
  if (!HAS_PATH || !rolled.ground) return;
  set($("plane"), { transform: poseOf(rolled, k) });
  drawForces(rolled, k, x);
}

/** Side forces of the parts as arrows, in proportion to the weight. */
function drawForces(roll, k, x) {
  const n = MODEL.places.length, place = new Float64Array(3 * n), force = new Float64Array(3 * n);
  places(x, roll.u, roll.p, place, force);
  const { scale } = roll.outline, arrows = [];
  const largest = Math.max(1e-9, ...MODEL.places.map((_, i) => Math.abs(force[3 * i + 1])), (roll.strongest ??= strongest(roll)));
  for (let i = 0; i < n; ++i) {
    const [px, py] = [place[3 * i] * scale, place[3 * i + 1] * scale], long = (force[3 * i + 1] / largest) * 46;
    if (Math.abs(long) < 2) continue;
    const tip = py + long, head = Math.sign(long) * 5;
    arrows.push(`M${px} ${py}V${tip}M${px - 3} ${tip - head}L${px} ${tip}L${px + 3} ${tip - head}`);
  }
  set($("forces"), { d: arrows.join(""), transform: poseOf(roll, k) });
}

/** The largest side force of any part in a roll, N. */
function strongest(roll) {
  const n = MODEL.places.length, place = new Float64Array(3 * n), force = new Float64Array(3 * n), x = new Float64Array(NX);
  let found = 0;
  for (let k = 0; k < roll.kept; k += 5) {
    places(roll.at(k, x), roll.u, roll.p, place, force);
    for (let i = 0; i < n; ++i) found = Math.max(found, Math.abs(force[3 * i + 1]) || 0);
  }
  return found;
}

function play(on) {
  playing = on && !!rolled;
  $("play").textContent = playing ? "Pause" : "Play";
  if (!playing) return;
  if (shownTime >= rolled.end - 1e-9) shownTime = 0;
  playedAt = performance.now();
  requestAnimationFrame(tick);
}

function tick(now) {
  if (!playing) return;
  const t = shownTime + Math.max(0, now - playedAt) / 1000;
  playedAt = now;
  showTime(Math.min(t, rolled.end));
  if (t >= rolled.end) play(false);
  else requestAnimationFrame(tick);
}
