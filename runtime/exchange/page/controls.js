// Sliders, their numbers, and how far they may go.
const ROWS = new Map(); // symbol -> { row, range, number, unit, band, note }

function buildControls() {
  const groups = new Map();
  for (const { group } of DATA.sliders) if (!groups.has(group)) groups.set(group, null);
  for (const title of groups.keys()) {
    const list = element("div", { class: "rows" });
    groups.set(title, list);
    if (title) $("controls").append(element("fieldset", {}, element("legend", {}, title), list));
    else $("more-rows").append(list);
  }
  for (const slider of DATA.sliders) groups.get(slider.group).append(rowOf(slider));
  $("more").hidden = !groups.has("");
  $("find").addEventListener("input", () => {
    const wanted = $("find").value.toLowerCase();
    for (const { symbol, group } of DATA.sliders) {
      if (!group) ROWS.get(symbol).row.hidden = !ROWS.get(symbol).row.textContent.toLowerCase().includes(wanted);
    }
  });
}

function rowOf({ symbol: s, low, high, whole }) {
  const id = `slider-${s}`, { name, meaning } = QUANTITIES[s];
  const row = element("div", { class: "row", title: meaning });
  const range = element("input", { type: "range", id, min: low, max: high, step: whole ? 1 : (high - low) / 400 });
  const number = element("input", { type: "text", inputmode: "text", autocomplete: "off", "aria-label": `${plain(name)}, number with unit` });
  const band = element("div", { class: "band", "aria-hidden": "true" });
  const note = element("span", { class: "note", id: `note-${s}` });
  range.setAttribute("aria-describedby", note.id);
  const follow = element("button", { type: "button", class: "follow", title: "Undo this change" }, "undo");
  row.append(element("label", { for: id }, sentence(plain(name))), number, follow, range, band, note);
  range.addEventListener("input", () => change(s, allowed(s, Number(range.value))));
  number.addEventListener("change", () => {
    const value = typed(s, number.value);
    number.classList.toggle("wrong", !Number.isFinite(value));
    if (Number.isFinite(value)) change(s, allowed(s, value));
  });
  follow.addEventListener("click", () => {
    for (const group of ["given", "inputs", "start"]) {
      if (s in ORIGINAL[group]) design[group][s] = ORIGINAL[group][s];
      else if (group === "given") delete design.given[s];
    }
    changed();
  });
  ROWS.set(s, { row, range, number, band, note, follow });
  return row;
}

/** Show the numbers of the design. */
function drawControls(known) {
  for (const s of ROWS.keys()) {
    const { row, range, number, follow } = ROWS.get(s), value = valueOf(design, s, known);
    if (document.activeElement !== range) range.value = value;
    range.setAttribute("aria-valuetext", withUnit(s, value));
    if (document.activeElement !== number) {
      number.value = Number.isFinite(value) ? withUnit(s, value, 5) : "";
      number.classList.remove("wrong");
    }
    const group = s in design.inputs ? "inputs" : s in design.start ? "start" : "given";
    const isChanged = !isOriginal(group, s);
    row.classList.toggle("changed", isChanged);
    row.classList.toggle("follows", group === "given" && !(s in design.given));
    follow.hidden = !isChanged;
  }
}

/** Paint where a slider may go. */
function drawBand(s, result) {
  const { band, note } = ROWS.get(s), { low, high } = SLIDERS.get(s);
  const share = (value) => `${(((value - low) / (high - low)) * 100).toFixed(2)}%`;
  band.replaceChildren(
    ...result.pieces.map(({ from, to, good }) => {
      const piece = element("i", { class: good ? "good" : "bad" });
      piece.style.left = share(from);
      piece.style.right = `calc(100% - ${share(to)})`;
      return piece;
    }),
  );
  note.textContent = limitInWords(s, result);
}

/** Which sliders are seen, the one that is being moved last. */
function seenSliders() {
  const open = $("more").open;
  return DATA.sliders.filter(({ symbol, group }) => group || (open && !ROWS.get(symbol).row.hidden)).map(({ symbol }) => symbol);
}
