// The sheet in three dimensions: atoms and membrane side by side, turned together, at the depth of the slider.

function colour_bar({low, high, unit, scale, names, colours}) {
  if (names)
    return names.flatMap((name, i) => [element("span", {class: "swatch", style: `background:${colours[i]}`}), element("span", {}, name)]);
  const strip = element("canvas", {width: 256, height: 1, "aria-hidden": "true"}), context = strip.getContext("2d");
  const colour = context.createLinearGradient(0, 0, 256, 0);
  scale.forEach((stop, i) => colour.addColorStop(i / (scale.length - 1), stop));
  context.fillStyle = colour;
  context.fillRect(0, 0, 256, 1);
  return [element("span", {}, low), strip, element("span", {}, `${high} ${unit}`)];
}

/** A canvas with heading, choice of what colours say, and bar. Its `paint` draws the scene as the camera's place says. */
function view_of(scene, radius, place, repaint) {
  const canvas = element("canvas", {tabindex: 0, role: "application"}), bar = element("div", {class: "bar"}), note = element("span", {class: "soft"});
  const said = element("p", {class: "soft said", role: "status"});
  const heading = element("div", {class: "title"}, scene.title), box = element("div", {class: "view"}, heading, canvas, bar, said);
  let picture = null;
  const fill_bar = () => bar.replaceChildren(...choice, ...colour_bar(scene.bar()), note);
  const choice = scene.fields.length < 2 ? [element("span", {}, scene.fields[0])] : [element("select", {"aria-label": `colour of the ${scene.title}`},
    ...scene.fields.map((name, i) => element("option", {value: String(i)}, name)))];
  choice[0].addEventListener("change", () => {
    scene.choose(Number(choice[0].value));
    fill_bar();
    repaint();
  });
  fill_bar();
  const paint = () => {
    const size = Math.max(64, Math.min(1000, Math.round(2 * canvas.clientWidth))), start = performance.now();
    if (canvas.width !== size) canvas.width = canvas.height = size;
    picture = empty_picture(size);
    scene.draw(picture, camera_of(place, size, radius, place.middle));
    canvas.getContext("2d").putImageData(new ImageData(new Uint8ClampedArray(picture.pixels.buffer), size, size), 0, 0);
    canvas.dataset.milliseconds = (performance.now() - start).toFixed(1);
  };
  canvas.addEventListener("pointermove", (event) => {
    if (!picture || event.buttons) return;
    const factor = picture.size / canvas.clientWidth, x = Math.floor(event.offsetX * factor), y = Math.floor(event.offsetY * factor);
    const index = picture.index[y * picture.size + x] ?? -1;
    said.textContent = index < 0 ? scene.summary() : scene.words(index);
  });
  canvas.addEventListener("pointerleave", () => (said.textContent = scene.summary()));
  const go_to = (depth, words) => {
    note.textContent = scene.go_to(depth);
    said.textContent = scene.summary();
    canvas.setAttribute("aria-label", `${scene.title} in three dimensions, depth ${words}: ${scene.summary()}; arrow keys turn, plus and minus bring nearer`);
  };
  return {box, canvas, paint, go_to};
}

/** Turning by the pointer and by keys, of all views at once. */
function let_turn(canvas, place, repaint) {
  const turn_by = (x, y) => {
    place.turn += x;
    place.height = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, place.height + y));
    repaint();
  };
  let last = null;
  canvas.addEventListener("pointerdown", (event) => {
    last = event;
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    if (!last || !event.buttons) return;
    turn_by(-0.008 * (event.clientX - last.clientX), 0.008 * (event.clientY - last.clientY));
    last = event;
  });
  canvas.addEventListener("pointerup", () => (last = null));
  canvas.addEventListener("pointercancel", () => (last = null));
  canvas.addEventListener("keydown", (event) => {
    const moves = {ArrowLeft: [0.1, 0], ArrowRight: [-0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1]};
    if (moves[event.key]) turn_by(...moves[event.key]);
    else if ("+-=".includes(event.key)) place.nearness *= event.key === "-" ? 0.8 : 1.25, repaint();
    else return;
    event.preventDefault();
  });
}

function turning_buttons(place, repaint) {
  const button = (name, act) => {
    const made = element("button", {type: "button"}, name);
    made.addEventListener("click", () => (act(), repaint()));
    return made;
  };
  return [button("from above", () => ((place.turn = 0), (place.height = Math.PI / 2))),
          button("from the side", () => ((place.turn = 0), (place.height = 0))),
          button("aslant", () => ((place.turn = 0.5), (place.height = 0.6))),
          button("nearer", () => (place.nearness *= 1.25)), button("farther", () => (place.nearness *= 0.8))];
}

/** Controls and views of one load. */
function load_views(load, scale, state_colours) {
  const scenes = [];
  if (load.atoms) scenes.push(atoms_scene(load.atoms, scale));
  if (load.membrane) scenes.push(membrane_scene(load.membrane, scale, state_colours));
  const {depth: depths, force: forces, every} = load.atoms ?? load.membrane, deepest = depths[depths.length - 1];
  const place = {turn: 0.5, height: 0.6, nearness: 1, middle: -deepest / 2}, radius = Math.max(...scenes.map((scene) => scene.radius));
  const under_force = forces.some((force) => force !== 0);  // a pressure's is not kept
  let waiting = false;
  const repaint = () => {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      views.forEach((view) => view.paint());
    });
  };
  const views = scenes.map((scene) => view_of(scene, radius, place, repaint));
  const slider = element("input", {type: "range", min: "0", max: String(depths.length - 1), step: "1", value: String(depths.length - 1)});
  const output = element("output", {});
  const go = () => {
    const i = Number(slider.value), words = `${shown(depths[i], 4)} Å` + (under_force ? `, ${shown(forces[i], 4)} eV/Å` : "");
    output.textContent = words;
    slider.setAttribute("aria-valuetext", words);
    views.forEach((view) => view.go_to(depths[i], words));
    repaint();
  };
  slider.addEventListener("input", go);
  views.forEach((view) => let_turn(view.canvas, place, repaint));
  const box = element("div", {}, element("div", {class: "controls"}, element("label", {class: "depth"}, "depth", slider, output),
                                         ...turning_buttons(place, repaint)),
                      element("div", {class: "views"}, ...views.map((view) => view.box)));
  if (every > 1) box.append(element("p", {class: "soft"}, `One of ${every} computed depths is in this page; all are in run.h5.`));
  new ResizeObserver(repaint).observe(box);
  go();
  return box;
}

/** In the place of a figure: a choice of the load where there are several, made when it comes into sight. */
function add_sheets(figure, sheets) {
  const live = element("div", {class: "live sheets"}), place = element("div", {});
  const choice = element("select", {}, ...sheets.loads.map(({load}, i) => element("option", {value: String(i)}, `${load}`)));
  const made = new Map();
  const show = () => {
    const i = Number(choice.value);
    if (!made.has(i)) made.set(i, load_views(sheets.loads[i], sheets.scale, sheets.states));
    place.replaceChildren(made.get(i));
  };
  choice.value = String(sheets.shown ?? 0);
  choice.addEventListener("change", show);
  if (sheets.loads.length > 1) live.append(element("div", {class: "controls"}, element("label", {}, "load", choice)));
  live.append(place);
  figure.prepend(live);
  figure.classList.add("is-live");
  const watcher = new IntersectionObserver((entries) => {
    if (!entries.some((entry) => entry.isIntersecting)) return;
    watcher.disconnect();
    show();
  }, {rootMargin: "300px"});
  watcher.observe(figure);
}

