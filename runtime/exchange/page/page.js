// Everything together: a change, what is computed of it at once, and what a little later.
let changedAt = 0, settled = 0, rollAgain = false;

/** Give a quantity another value. */
function change(s, value) {
  put(design, s, value);
  changed();
}

/** The design is another: compute and draw it anew in the next frame. */
function changed() {
  changedAt = performance.now();
  soon(update);
}

function update() {
  const known = resolved(design.given);
  drawControls(known);
  drawAircraft();
  const point = operatingPoint(design), roots = point.ok ? point.roots : [];
  anchor = point.ok ? point.x : null;
  drawModes(point, roots);
  const verdict = $("verdict"), good = point.ok && roots.every(({ re }) => re <= 0);
  verdict.textContent = point.ok ? (good ? "Stable" : "Unstable") : "No steady roll";
  verdict.className = good ? "good" : "bad";
  $("speed").textContent = SPEED ? `at ${withUnit(SPEED, known.value(SPEED))}` : "";
  $("problem").textContent = point.problems.join("; ");
  paintMap();
  if (SHARES.has("roll")) rollAgain = true; // let it be seen, however fast the design changes
  else begin("roll", rollTask(1e-6));
  if (mapKey() !== mapped?.key) begin("map", mapTask());
  begin("settle", settleTask());
  delete document.documentElement.dataset.settled;
}

/** Compute the roll in pieces, then show it. */
function* rollTask(tolerance) {
  do {
    rollAgain = false;
    const roll = rollOf(design, { tolerance });
    while (roll && !roll.advance(40)) yield;
    if (roll) drawRoll(roll);
    else $("fate").textContent = "";
    yield;
  } while (rollAgain);
}

/** What can wait until nothing moves: the address, the roll in full, limits. */
function* settleTask() {
  while (performance.now() - changedAt < 250) yield;
  const text = fragment();
  history.replaceState(null, "", text ? `#${text}` : location.pathname + location.search);
  $("changed").textContent = text ? "changed" : "as in the file";
  yield* rollTask(1e-9);
  if (!QUIET && !playing && settled++ === 0) play(true);
  yield* allBands(seenSliders(), drawBand);
  document.documentElement.dataset.settled = "true";
}

function buildActions() {
  const units = $("units");
  for (const name of UNIT_SETS) units.append(element("option", { value: name }, name === "file" ? "as in the file" : name));
  units.addEventListener("change", () => {
    unitSet = UNIT_SETS.indexOf(units.value);
    changed();
  });
  const surface = $("surface");
  surface.append(element("option", { value: "" }, "of the file"));
  for (const name of Object.keys(DATA.surfaces)) surface.append(element("option", { value: name }, plain(name)));
  surface.parentElement.hidden = !DATA.friction.length;
  surface.addEventListener("change", () => {
    const factor = DATA.surfaces[surface.value];
    for (const s of DATA.friction) {
      const before = ORIGINAL.given[s];
      if (factor === undefined) {
        if (before === undefined) delete design.given[s];
        else design.given[s] = before;
      } else design.given[s] = s.startsWith("surface") ? factor : factor * before;
    }
    changed();
  });
  $("reset").addEventListener("click", () => {
    design = copied(ORIGINAL);
    surface.value = "";
    reframe();
    changed();
  });
  $("print").addEventListener("click", () => window.print());
  $("toml").addEventListener("click", () => offer("An aircraft file of this design", toml()));
  $("link").addEventListener("click", () => {
    const text = fragment();
    offer("The address of this design", `${location.href.split("#")[0]}${text ? `#${text}` : ""}`);
  });
  $("copy").addEventListener("click", async () => {
    const area = $("offered");
    area.select();
    try {
      await navigator.clipboard.writeText(area.value);
      $("copy").textContent = "Copied";
    } catch {
      $("copy").textContent = document.execCommand("copy") ? "Copied" : "Press Ctrl+C";
    }
  });
  $("close").addEventListener("click", () => $("dialog").close());
  $("duration").addEventListener("change", () => {
    const value = Number($("duration").value);
    if (value >= 1 && value <= 60) design.duration = value;
    changed();
  });
  $("more").addEventListener("toggle", changed);
  addEventListener("hashchange", () => arrive());
}

/** Show a text to be copied. */
function offer(title, text) {
  $("offer-title").textContent = title;
  $("offered").value = text;
  $("copy").textContent = "Copy";
  $("dialog").showModal();
  $("offered").select();
}

/** Take the design from the address. */
function arrive() {
  takeFragment(location.hash.slice(1));
  for (const key of ["x", "y"]) $(`map-${key}`).value = mapAxes[key];
  $("units").value = UNIT_SETS[unitSet];
  $("duration").value = design.duration;
  reframe();
  changed();
}

/** For tests, and for whoever looks behind the page. */
window.groundroll = {
  DATA, rates, outputs, along, places, resolved, parametersOf, operatingPoint, eigenvalues,
  decayOf, rollOf, fateOf, startOf, bandsOf, toml, fragment, typed, change, LIMITS,
  get design() { return design; },
  get rolled() { return rolled; },
  get mapped() { return mapped; },
  get lastWork() { return lastWork; },
  get busy() { return SHARES.size > 0; },
};

document.title = `${DATA.title}: explorer`;
$("title").textContent = DATA.title;
$("description").textContent = DATA.description;
$("about").textContent = `${MODEL.name}: ${MODEL.summary}`;
$("held").textContent = HELD.filter(Boolean).map((s) => plain(QUANTITIES[s].name)).join(" and ");
$("runway-figure").hidden = !HAS_PATH;
buildControls();
buildActions();
buildAircraft();
buildModes();
buildMap();
buildRunway();
arrive();
