// Values under the pointer, and by keys for those who have none.

/** All points that can be pointed at: of curves (bands apart) and bars, with their places and what is to be said. */
function targets_of(panel, x, y) {
  const targets = [], said = (axis, value) => `${axis.label} ${shown(value)}${axis.unit ? " " + axis.unit : ""}`;
  const category = (value) => (panel.x.categories.length ? `${panel.x.label} ${panel.x.categories[Math.round(value)] ?? ""}` : said(panel.x, value));
  for (const curve of panel.curves) {
    if (curve.high || curve.strokes) continue;
    curve.x.forEach((value, i) => {
      const place = {x: x.place(value), y: y.place(curve.y[i])};
      if (value === null || curve.y[i] === null || !Number.isFinite(place.x + place.y)) return;
      targets.push({...place, name: curve.name, colour: curve.colour, words: [category(value), said(panel.y, curve.y[i])]});
    });
  }
  stacks_of(panel).forEach((stack, i) => {
    for (const bar of stack)
      if (bar.value !== null)
        targets.push({x: x.place(i), y: y.place((bar.low + bar.high) / 2), name: bar.name, colour: bar.colour,
                      words: [category(i), said(panel.y, bar.value)]});
  });
  return targets;
}

/** Beside a place, inside the chart. */
function put_tip(tip, chart, svg, target) {
  const outer = chart.getBoundingClientRect(), inner = svg.getBoundingClientRect();
  const left = inner.left - outer.left + target.x, top = inner.top - outer.top + target.y;
  tip.style.left = `${Math.max(0, Math.min(left + 12, outer.width - tip.offsetWidth - 2))}px`;
  tip.style.top = `${top > tip.offsetHeight + 14 ? top - tip.offsetHeight - 10 : top + 14}px`;
}

/** Lets a panel be asked; `is_shown` says of a curve's name whether it is to be seen. */
function make_askable(svg, chart, tip, targets, is_shown) {
  const ring = drawn("circle", {r: 6, fill: "none", "stroke-width": 2, style: "stroke:var(--ink)", visibility: "hidden"});
  let current = -1;
  svg.append(ring);
  const show = (index) => {
    current = index;
    const target = targets[index];
    ring.setAttribute("visibility", target ? "visible" : "hidden");
    tip.replaceChildren();
    if (!target) return;
    ring.setAttribute("cx", target.x), ring.setAttribute("cy", target.y);
    tip.append(element("b", {}, target.name), element("br"), ...target.words.flatMap((words, i) => (i ? [element("br"), words] : [words])));
    put_tip(tip, chart, svg, target);
  };
  const nearest = (event) => {
    const box = svg.getBoundingClientRect(), px = event.clientX - box.left, py = event.clientY - box.top;
    let best = -1, least = 60 ** 2;
    targets.forEach((target, i) => {
      const distance = (target.x - px) ** 2 + (target.y - py) ** 2;
      if (distance < least && is_shown(target.name)) [best, least] = [i, distance];
    });
    return best;
  };
  const step = (by, same_curve) => {
    const other = (i) => is_shown(targets[i].name) && (current < 0 || (targets[i].name === targets[current].name) === same_curve);
    for (let k = 1; k <= targets.length; ++k) {
      const i = (((current < 0 ? 0 : current + by * k) % targets.length) + targets.length) % targets.length;
      if (other(i)) return show(i);
    }
  };
  svg.addEventListener("pointermove", (event) => show(nearest(event)));
  svg.addEventListener("pointerdown", (event) => show(nearest(event)));
  svg.addEventListener("pointerleave", () => show(-1));
  svg.addEventListener("blur", () => show(-1));
  svg.addEventListener("keydown", (event) => {
    const moves = {ArrowRight: [1, true], ArrowLeft: [-1, true], ArrowDown: [1, false], ArrowUp: [-1, false]};
    if (event.key === "Escape") show(-1);
    else if (moves[event.key]) step(...moves[event.key]), event.preventDefault();
  });
}

