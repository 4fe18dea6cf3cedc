// What a panel consists of: grid, axes, zones, bars, bands, curves.

const greys = {"#000000": "var(--ink)", "#555555": "var(--curve-dark)", "#999999": "var(--curve-grey)", "#dddddd": "var(--pale)",
               "#ffffff": "var(--paper)", "#0072B2": "var(--curve-blue)"};

/** The plot's colour, in the dark one that is seen there. */
const tint = (colour) => greys[colour] ?? colour;

function marker_path(kind, x, y, size) {
  const s = size.toFixed(2), at = `M${x.toFixed(1)},${y.toFixed(1)}`;
  if (kind === "square") return `${at}m-${s},-${s}h${2 * s}v${2 * s}h-${2 * s}z`;
  if (kind === "triangle") return `${at}m0,-${1.2 * s}l${1.1 * s},${1.9 * s}h-${2.2 * s}z`;
  if (kind === "diamond") return `${at}m0,-${1.3 * s}l${1.3 * s},${1.3 * s}l-${1.3 * s},${1.3 * s}l-${1.3 * s},-${1.3 * s}z`;
  return `${at}m-${s},0a${s},${s} 0 1 0 ${2 * s},0a${s},${s} 0 1 0 -${2 * s},0z`;
}

/** A line through places; a value that is not known, or has no place, parts it. */
function line_path(xs, ys, strokes) {
  let path = "", down = false;
  xs.forEach((x, i) => {
    const known = Number.isFinite(x) && Number.isFinite(ys[i]);
    if (known) path += `${down && !(strokes && i % 2 === 0) ? "L" : "M"}${x.toFixed(1)},${ys[i].toFixed(1)}`;
    down = known;
  });
  return path;
}

function places(values, scale) {
  return values.map((value) => (value === null ? NaN : scale.place(value)));
}

function curve_drawing(curve, x, y) {
  const group = drawn("g", {"data-name": curve.name}), xs = places(curve.x, x), ys = places(curve.y, y), colour = tint(curve.colour);
  if (curve.high) {
    const there = line_path(xs, places(curve.high, y)), back = line_path([...xs].reverse(), [...ys].reverse());
    group.append(drawn("path", {d: there + back.replace("M", "L") + "z", style: `fill:${colour};fill-opacity:.35`}));
    return group;
  }
  if (curve.line)
    group.append(drawn("path", {d: line_path(xs, ys, curve.strokes), fill: "none", "stroke-dasharray": curve.line.dash || "none",
                                "stroke-width": curve.line.width, style: `stroke:${colour}`}));
  if (curve.points) {
    const {marker, size, open} = curve.points;
    const path = xs.map((at, i) => (Number.isFinite(at + ys[i]) ? marker_path(marker, at, ys[i], 1 + 3.4 * size) : "")).join("");
    group.append(drawn("path", {d: path, "stroke-width": 1.2, style: `stroke:${colour};fill:${open ? "var(--paper)" : colour}`}));
  }
  return group;
}

function zone_drawing(zone, box, x, y) {
  const scale = zone.along === "x" ? x : y, group = drawn("g", {"data-name": zone.name});
  const inside = (at) => scale.place(Math.min(Math.max(at ?? Infinity, scale.low), scale.high));
  const a = inside(zone.from), b = inside(zone.to), colour = tint(zone.colour);
  const across = zone.along === "x" ? {x: Math.min(a, b), y: box.top, width: Math.abs(b - a), height: box.bottom - box.top}
                                    : {x: box.left, y: Math.min(a, b), width: box.right - box.left, height: Math.abs(b - a)};
  group.append(drawn("rect", {...across, style: `fill:${colour};fill-opacity:.14`}));
  if (zone.edge) group.append(across_drawing({along: zone.along, at: zone.from, dash: "7 4", colour: zone.colour}, box, x, y));
  return group;
}

/** A thin line across the panel; nothing where it is outside. */
function across_drawing(mark, box, x, y) {
  const scale = mark.along === "x" ? x : y, at = scale.place(mark.at);
  if (!(mark.at >= scale.low && mark.at <= scale.high)) return drawn("g");
  const ends = mark.along === "x" ? {x1: at, x2: at, y1: box.top, y2: box.bottom} : {x1: box.left, x2: box.right, y1: at, y2: at};
  return drawn("line", {...ends, "stroke-dasharray": mark.dash || "none", style: `stroke:${tint(mark.colour)}`});
}

function bar_drawings(panel, x, y) {
  const half = 0.35 * Math.abs(x.place(1) - x.place(0));
  return stacks_of(panel).flatMap((stack, i) => stack.map((bar) =>
    drawn("g", {"data-name": bar.name},
          drawn("rect", {x: x.place(i) - half, width: 2 * half, y: y.place(bar.high), height: y.place(bar.low) - y.place(bar.high),
                         style: `fill:${tint(bar.colour)};fill-opacity:.85`}))));
}

/** A title in lines that are hardly longer than the panel is wide. */
function title_lines(title, width) {
  const lines = [];
  for (const word of title.split(" ").filter((each) => each)) {
    const longer = lines.length ? `${lines[lines.length - 1]} ${word}` : word;
    if (lines.length && 7.6 * longer.length <= width) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}

/** Words to the right of their places, upwards as far apart as letters are high. */
function label_drawings(panel, x, y) {
  const labels = panel.labels.map((label) => ({...label, left: x.place(label.x), middle: y.place(label.y)}));
  labels.sort((a, b) => b.middle - a.middle);
  labels.forEach((label, i) => i && (label.middle = Math.min(label.middle, labels[i - 1].middle - 16)));
  return labels.map(({text, left, middle, colour}) =>
    drawn("g", {}, drawn("circle", {cx: left + 8, cy: middle, r: 3, style: `fill:${tint(colour)}`}),
          drawn("text", {x: left + 14, y: middle + 4.5}, text)));
}

function axis_drawings(panel, box, x, y) {
  const parts = [], text = (words, settings) => parts.push(drawn("text", settings, words));
  const slanted = panel.x.categories.length > 0;
  for (const {at, name} of x.ticks) {
    const place = x.place(at);
    parts.push(drawn("line", {x1: place, x2: place, y1: box.top, y2: box.bottom, style: "stroke:var(--grid)"}));
    if (slanted) text(name, {transform: `translate(${place + 4},${box.bottom + 14})rotate(-40)`, "text-anchor": "end"});
    else text(name, {x: place, y: box.bottom + 17, "text-anchor": "middle"});
  }
  for (const {at, name} of y.ticks) {
    const place = y.place(at);
    parts.push(drawn("line", {x1: box.left, x2: box.right, y1: place, y2: place, style: "stroke:var(--grid)"}));
    text(name, {x: box.left - 6, y: place + 4.5, "text-anchor": "end"});
  }
  parts.push(drawn("path", {d: `M${box.left},${box.top}V${box.bottom}H${box.right}`, fill: "none", style: "stroke:var(--ink)"}));
  text(panel.x.text, {x: (box.left + box.right) / 2, y: box.bottom + (slanted ? 58 : 36), "text-anchor": "middle"});
  text(panel.y.text, {transform: `translate(14,${(box.top + box.bottom) / 2})rotate(-90)`, "text-anchor": "middle"});
  const lines = title_lines(panel.title, box.right - box.left);
  lines.forEach((words, i) => text(words, {class: "name", x: box.left, y: box.top - 8 - 16 * (lines.length - 1 - i)}));
  return parts;
}

