// A chart in place of a figure: its panels, and a legend whose entries switch curves.

/** Names of the legend with a curve, bars or zone that stands for each. */
function legend_of(plot) {
  const entries = new Map();
  for (const panel of plot.panels) {
    for (const bars of panel.bars) entries.set(bars.name, {bars, ...entries.get(bars.name)});
    for (const curve of panel.curves) if (curve.legend && curve.name) entries.set(curve.name, {curve, ...entries.get(curve.name)});
    for (const zone of panel.zones) if (zone.name) entries.set(zone.name, {zone, ...entries.get(zone.name)});
  }
  return entries;
}

function sample_of({curve, bars, zone}) {
  const sample = drawn("svg", {width: 30, height: 12, "aria-hidden": "true"});
  if (curve) {
    const y = {place: () => 6};
    const points = curve.line ? {x: [0, 15, 30], y: [0, 0, 0]} : {x: [15], y: [0]};
    const high = curve.high && {high: [1, 1, 1], x: [0, 15, 30], y: [0, 0, 0]};
    sample.append(curve_drawing({...curve, ...points, ...high}, {place: (at) => at}, high ? {place: (at) => 11 - 10 * at} : y));
  } else {
    sample.append(drawn("rect", {x: 6, y: 1, width: 18, height: 10,
                                 style: `fill:${tint((bars ?? zone).colour)};fill-opacity:${bars ? 0.85 : 0.3}`}));
  }
  return sample;
}

/** The largest row is as high as is pleasant, the others by their shares of it. */
function height_of(plot, index, width) {
  const whole = Math.min(430, Math.max(260, 0.62 * width)), row = Math.floor(index / plot.columns);
  const share = plot.shares.length ? plot.shares[row] / Math.max(...plot.shares) : 1;
  return Math.round(Math.max(190, whole * share));
}

/** The numbers of the panels, row by row; below one another those that share an axis stay together. */
function order_of(plot, columns) {
  const numbers = plot.panels.map((_, i) => i), column = (i) => i % plot.columns;
  return columns < plot.columns ? numbers.sort((a, b) => column(a) - column(b) || a - b) : numbers;
}

function panel_svg(plot, index, width) {
  const panel = plot.panels[index], count = plot.panels.length, height = height_of(plot, index, width);
  const slanted = panel.x.categories.length > 0;
  const margin = Math.max(0, ...plot.panels.flatMap(({labels}) => labels.map(({text}) => 7.5 * text.length + 8)));  // axes of one length
  const right = width - 12 - margin, titles = title_lines(panel.title, right - 62).length;
  const box = {left: 62, right, top: titles ? 14 + 16 * titles : 12, bottom: height - (slanted ? 68 : 46)};
  const x = scale_of(panel, "x", box.left, box.right), y = scale_of(panel, "y", box.bottom, box.top);
  const label = `${panel.title ? panel.title + ": " : ""}${panel.y.text} against ${panel.x.text}${count > 1 ? `, panel ${index + 1}` : ""}; ` +
                "arrow keys go through its points";
  const svg = drawn("svg", {viewBox: `0 0 ${width} ${height}`, tabindex: 0, role: "application", "aria-label": label});
  const clip = `clip-${Math.random().toString(36).slice(2)}`;
  svg.append(drawn("clipPath", {id: clip}, drawn("rect", {x: box.left, y: box.top - 6, width: box.right - box.left + 6,
                                                          height: box.bottom - box.top + 12})));
  svg.append(...panel.zones.map((zone) => zone_drawing(zone, box, x, y)), ...axis_drawings(panel, box, x, y),
             ...panel.marks.map((mark) => across_drawing(mark, box, x, y)),
             drawn("g", {"clip-path": `url(#${clip})`}, ...bar_drawings(panel, x, y),
                   ...panel.curves.map((curve) => curve_drawing(curve, x, y))),
             ...label_drawings(panel, x, y));
  return {svg, targets: targets_of(panel, x, y)};
}

function apply_legend(chart, hidden) {
  for (const part of chart.querySelectorAll("[data-name]")) part.style.display = hidden.has(part.dataset.name) ? "none" : "";
}

function legend_list(plot, chart, hidden) {
  const list = element("ul", {class: "legend", "aria-label": "curves: press to hide or show"});
  for (const [name, entry] of legend_of(plot)) {
    const button = element("button", {type: "button", "aria-pressed": "true"}, sample_of(entry), name);
    button.addEventListener("click", () => {
      if (!hidden.delete(name)) hidden.add(name);
      button.setAttribute("aria-pressed", String(!hidden.has(name)));
      apply_legend(chart, hidden);
    });
    list.append(element("li", {}, button));
  }
  return list;
}

/** The chart, as wide as its figure lets it be: drawn again when that changes. */
function add_chart(figure, plot) {
  const hidden = new Set(), panels = element("div", {class: "panels"}), tip = element("div", {class: "tip", role: "status"});
  const chart = element("div", {class: "live chart"}, ...(plot.title ? [element("div", {class: "title"}, plot.title)] : []), panels, tip);
  chart.append(legend_list(plot, chart, hidden));
  let drawn_width = 0;
  const draw = () => {
    const width = chart.clientWidth;
    if (!width || width === drawn_width) return;
    drawn_width = width;
    const columns = Math.max(1, Math.min(plot.columns, Math.floor(width / 360)));
    panels.style.gridTemplateColumns = `repeat(${columns}, minmax(0, 1fr))`;
    tip.replaceChildren();
    panels.replaceChildren(...order_of(plot, columns).map((i) => {
      const {svg, targets} = panel_svg(plot, i, Math.floor((width - 16 * (columns - 1)) / columns));
      make_askable(svg, chart, tip, targets, (name) => !hidden.has(name));
      return svg;
    }));
    apply_legend(chart, hidden);
  };
  figure.prepend(chart);
  figure.classList.add("is-live");
  draw();
  new ResizeObserver(draw).observe(chart);
}

