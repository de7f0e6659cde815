// The map of stability over two quantities, with the design as a point in it.
const MAP = { nx: 64, ny: 48, left: 64, bottom: 44, top: 10, right: 12 };
let mapped = null; // { x, y, low, high, values } of what is drawn

/** How the map is coloured: blue is stable, orange is not, the stronger the further from zero. */
function colourOf(decay) {
  if (Number.isNaN(decay)) return "#bbbbbb";
  const share = Math.abs(decay) / (Math.abs(decay) + 1.5);
  const [r, g, b] = decay > 0 ? [0, 114, 178] : [213, 94, 0];
  const mixed = [r, g, b].map((c) => Math.round(245 + (c - 245) * (0.15 + 0.75 * share)));
  return `rgb(${mixed.join(",")})`;
}

function buildMap() {
  for (const key of ["x", "y"]) {
    const select = $(`map-${key}`);
    for (const { symbol } of DATA.sliders) {
      select.append(element("option", { value: symbol }, plain(QUANTITIES[symbol].name)));
    }
    select.addEventListener("change", () => {
      mapAxes[key] = select.value;
      changed();
    });
  }
  const canvas = $("map");
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    goTo(event);
  });
  canvas.addEventListener("pointermove", (event) => event.buttons && goTo(event));
  canvas.addEventListener("keydown", (event) => {
    const by = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (!by) return;
    event.preventDefault();
    ["x", "y"].forEach((key, k) => {
      const s = mapAxes[key], { low, high } = SLIDERS.get(s);
      if (by[k]) change(s, allowed(s, valueOf(design, s) + (by[k] * (high - low)) / 100));
    });
  });
  new ResizeObserver(() => paintMap()).observe(canvas);
}

/** Let the design go where the pointer is. */
function goTo(event) {
  const box = $("map").getBoundingClientRect(), { left, right, top, bottom } = MAP;
  const shares = {
    x: (event.clientX - box.left - left) / (box.width - left - right),
    y: 1 - (event.clientY - box.top - top) / (box.height - top - bottom),
  };
  for (const key of ["x", "y"]) {
    const s = mapAxes[key], { low, high } = SLIDERS.get(s), share = Math.min(1, Math.max(0, shares[key]));
    change(s, allowed(s, low + share * (high - low)));
  }
}

/** What the map depends on: all of the design but its place in the map. */
function mapKey() {
  const rest = copied(design);
  for (const s of Object.values(mapAxes)) delete rest.given[s];
  return JSON.stringify([mapAxes, rest.given, rest.inputs]);
}

/** Compute the map, coarsely first. */
function* mapTask() {
  const { nx, ny } = MAP, [x, y] = [mapAxes.x, mapAxes.y], trial = copied(design);
  const ends = [SLIDERS.get(x), SLIDERS.get(y)];
  const values = new Float64Array(nx * ny), known = new Uint8Array(nx * ny);
  let seed = anchor;
  mapped = { key: mapKey(), x, y, ends, values };
  for (const stride of [8, 4, 2, 1]) {
    for (let j = 0; j < ny; j += stride) {
      for (let i = 0; i < nx; i += stride) {
        if (!known[j * nx + i]) {
          put(trial, x, ends[0].low + ((ends[0].high - ends[0].low) * i) / (nx - 1));
          put(trial, y, ends[1].low + ((ends[1].high - ends[1].low) * j) / (ny - 1));
          const point = operatingPoint(trial, seed), value = decayAt(point);
          if (point.ok) seed = point.x; // the next is not far from it
          for (let b = j; b < Math.min(ny, j + stride); ++b) {
            values.fill(value, b * nx + i, b * nx + Math.min(nx, i + stride));
          }
          known[j * nx + i] = 1;
          yield;
        }
      }
    }
    mapped.stride = stride;
    mapped.picture = null;
    paintMap();
    yield;
  }
}

/** The cells of the map as a picture of its own, which is kept until they change. */
function pictureOf({ values }) {
  const { nx, ny } = MAP, scale = 8;
  const canvas = element("canvas", { width: nx * scale, height: ny * scale });
  const g = canvas.getContext("2d");
  for (let j = 0; j < ny; ++j) {
    for (let i = 0; i < nx; ++i) {
      const value = values[j * nx + i];
      g.fillStyle = colourOf(value);
      g.fillRect(i * scale, (ny - 1 - j) * scale, scale, scale);
      if (value > 0) continue; // hatched, for whoever sees no colours
      g.strokeStyle = "rgba(90, 35, 0, 0.45)";
      g.beginPath();
      g.moveTo(i * scale, (ny - j) * scale);
      g.lineTo((i + 1) * scale, (ny - 1 - j) * scale);
      g.stroke();
    }
  }
  return canvas;
}

/** Pieces of the line on which the map is zero, in cells. */
function* boundary({ values }) {
  const { nx, ny } = MAP;
  for (let j = 0; j < ny - 1; ++j) {
    for (let i = 0; i < nx - 1; ++i) {
      const corner = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
      const value = corner.map(([a, b]) => values[b * nx + a]);
      if (value.some(Number.isNaN)) continue;
      const cuts = [];
      for (let k = 0; k < 4; ++k) {
        const [a, b] = [value[k], value[(k + 1) % 4]], [p, q] = [corner[k], corner[(k + 1) % 4]];
        if (a > 0 !== b > 0) cuts.push(p.map((c, n) => c + ((q[n] - c) * a) / (a - b)));
      }
      if (cuts.length >= 2) yield [cuts[0], cuts[1]];
      if (cuts.length === 4) yield [cuts[2], cuts[3]];
    }
  }
}

function paintMap() {
  const canvas = $("map"), ratio = Math.min(3, window.devicePixelRatio || 1);
  const [wide, high] = [canvas.clientWidth, canvas.clientHeight];
  if (!mapped || !wide || !high) return;
  if (canvas.width !== Math.round(wide * ratio) || canvas.height !== Math.round(high * ratio)) {
    [canvas.width, canvas.height] = [Math.round(wide * ratio), Math.round(high * ratio)];
  }
  const g = canvas.getContext("2d"), { left, right, top, bottom, nx, ny } = MAP;
  g.setTransform(ratio, 0, 0, ratio, 0, 0);
  g.fillStyle = "#fff";
  g.fillRect(0, 0, wide, high);
  const [w, h] = [wide - left - right, high - top - bottom];
  mapped.picture ??= pictureOf(mapped);
  g.imageSmoothingEnabled = false;
  g.drawImage(mapped.picture, left, top, w, h);
  const cell = ([i, j]) => [left + ((i + 0.5) / nx) * w, top + h - ((j + 0.5) / ny) * h];
  if (mapped.stride === 1) {
    g.strokeStyle = "#111";
    g.lineWidth = 2;
    g.beginPath();
    for (const [a, b] of boundary(mapped)) {
      g.moveTo(...cell(a));
      g.lineTo(...cell(b));
    }
    g.stroke();
  }
  g.font = "12px system-ui, sans-serif";
  axis(g, 0, left, top + h, w);
  axis(g, 1, left, top + h, h);
  paintPoint(g, left, top, w, h);
}

/** Ticks, numbers and the name of an axis. */
function axis(g, which, left, low, length) {
  const s = [mapped.x, mapped.y][which], ends = mapped.ends[which], [unit, factor] = shownIn(s);
  const title = `${plain(QUANTITIES[s].name)}${unit ? ` [${printed(unit)}]` : ""}`;
  g.fillStyle = g.strokeStyle = "#444";
  g.lineWidth = 1;
  const shown = [ends.low * factor, ends.high * factor].sort((a, b) => a - b);
  for (const value of ticks(...shown)) {
    const share = (value / factor - ends.low) / (ends.high - ends.low) * length;
    g.beginPath();
    g.textAlign = which ? "right" : "center";
    if (which) {
      g.moveTo(left - 4, low - share);
      g.lineTo(left, low - share);
      g.fillText(brief(value), left - 7, low - share + 4);
    } else {
      g.moveTo(left + share, low);
      g.lineTo(left + share, low + 4);
      g.fillText(brief(value), left + share, low + 16);
    }
    g.stroke();
  }
  g.save();
  g.textAlign = "center";
  g.translate(which ? 13 : left + length / 2, which ? low - length / 2 : low + 36);
  if (which) g.rotate(-Math.PI / 2);
  g.fillText(title, 0, 0);
  g.restore();
}

function paintPoint(g, left, top, w, h) {
  const known = resolved(design.given);
  const share = [mapped.x, mapped.y].map((s, k) => {
    const { low, high } = mapped.ends[k];
    return (valueOf(design, s, known) - low) / (high - low);
  });
  const [x, y] = [left + share[0] * w, top + h - share[1] * h];
  if (!(share[0] >= -0.01 && share[0] <= 1.01 && share[1] >= -0.01 && share[1] <= 1.01)) return;
  for (const [colour, width] of [["#fff", 5], ["#111", 2]]) {
    g.strokeStyle = colour;
    g.lineWidth = width;
    g.beginPath();
    g.arc(x, y, 8, 0, 2 * Math.PI);
    g.moveTo(x - 14, y);
    g.lineTo(x + 14, y);
    g.moveTo(x, y - 14);
    g.lineTo(x, y + 14);
    g.stroke();
  }
}
