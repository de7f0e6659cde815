// The design on the page: kept in the address, and written as an aircraft file.
const ORIGINAL = DATA.design;
let design = copied(ORIGINAL);

/** Whether a design still has the value of the aircraft that the page was made of. */
const isOriginal = (group, s) => design[group][s] === ORIGINAL[group][s];

/** What differs from the aircraft of the page, as the fragment of an address. */
function fragment() {
  const parts = new URLSearchParams();
  for (const group of ["given", "inputs", "start"]) {
    for (const s of new Set([...Object.keys(ORIGINAL[group]), ...Object.keys(design[group])])) {
      if (!isOriginal(group, s)) parts.set(s, design[group][s] ?? "follows");
    }
  }
  if (design.duration !== ORIGINAL.duration) parts.set("duration", design.duration);
  if (unitSet) parts.set("units", UNIT_SETS[unitSet]);
  for (const [key, s] of Object.entries(mapAxes)) {
    if (s !== DEFAULT_AXES[key]) parts.set(`map_${key}`, s);
  }
  return parts.toString();
}

/** Take a design from the fragment of an address; what it does not know is passed over. */
function takeFragment(text) {
  const fresh = copied(ORIGINAL), axes = { ...DEFAULT_AXES };
  let units = 0;
  for (const [s, value] of new URLSearchParams(text)) {
    const number = Number(value);
    if (s === "units") units = Math.max(0, UNIT_SETS.indexOf(value));
    else if (s === "map_x" || s === "map_y") {
      if (SLIDERS.has(value)) axes[s.slice(4)] = value;
    } else if (value === "follows") delete fresh.given[s];
    else if (!value || !Number.isFinite(number)) continue;
    else if (s === "duration") fresh.duration = Math.min(60, Math.max(1, number));
    else if (SLIDERS.has(s)) put(fresh, s, number);
  }
  design = fresh;
  unitSet = units;
  Object.assign(mapAxes, axes);
}

/** A text as TOML writes it, on one line. */
const quoted = (text) =>
  JSON.stringify(text).replace(/[\x7f\u2028\u2029]/g, (c) => `\\u${c.charCodeAt(0).toString(16).padStart(4, "0")}`);

/** A number as TOML writes a float: the shortest that reads back as the same. */
function tomlNumber(value) {
  const text = String(value);
  return /[.e]/.test(text) ? text.replace("e+", "e") : `${text}.0`;
}

/** The design as an aircraft file, which the command line reads to the same numbers. */
function toml() {
  const tables = new Map();
  for (const [s, value] of Object.entries(design.given)) {
    const isOwn = DATA.own.includes(s) || !DATA.sections[s];
    const [table, key] = isOwn ? ["parameters", QUANTITIES[s].name] : DATA.sections[s];
    if (!tables.has(table)) tables.set(table, []);
    tables.get(table).push(`${key} = ${entry(s, value)}`);
  }
  const changed = Object.keys(ORIGINAL.given).some((s) => !isOriginal("given", s));
  const name = changed ? `${DATA.title}, changed` : DATA.title;
  const acting = [...Object.entries(design.inputs), ...Object.entries(design.start)];
  const sets = acting.filter(([, value]) => value).map(([s, value]) => ` --set ${s}=${value}`);
  const head = [
    `# From the explorer of groundroll, model ${MODEL.name}.`,
    ...(sets.length ? [`# On the page it rolls with${sets.join("")}`] : []),
    "",
    `title = ${quoted(name)}`,
  ];
  if (DATA.description) head.push(`description = ${quoted(DATA.description)}`);
  const body = [...tables].map(([table, lines]) => `\n[${table}]\n${lines.join("\n")}`);
  return `${head.join("\n")}\n${body.join("\n")}\n`;
}

/** The value of a quantity in the file, with what is said of it while it is not changed. */
function entry(s, value) {
  const unit = QUANTITIES[s].unit;
  if (!isOriginal("given", s)) return `${tomlNumber(value)} # ${unit}; set in the explorer`;
  const known = DATA.entries[s];
  if (!known) return tomlNumber(value);
  const written = known.value && !Number.isFinite(Number(known.value)) ? quoted(known.value) : tomlNumber(value);
  const parts = [`value = ${written}`];
  if (known.source) parts.push(`source = ${quoted(known.source)}`);
  if (known.estimate) parts.push("estimate = true");
  return parts.length > 1 ? `{ ${parts.join(", ")} }` : written;
}
