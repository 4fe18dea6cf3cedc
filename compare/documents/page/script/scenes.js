// What is seen in three dimensions at a depth: atoms with their longest bonds, a membrane with its stress or state.

/** The numbers of two neighbouring depths and the weight of the second; both are the same where the depth itself is there. */
function around(depths, depth) {
  const last = depths.length - 1;
  let k = depths.findIndex((each) => each >= depth - 0.005);
  if (k < 0) return {before: last, after: last, weight: 0};
  if (k === 0 || Math.abs(depths[k] - depth) <= 0.005) return {before: k, after: k, weight: 0};
  return {before: k - 1, after: k, weight: (depth - depths[k - 1]) / (depths[k] - depths[k - 1])};
}

/** How far the farthest of the flat places is from the axis, Å. */
function radius_of(flat, quantum) {
  const count = flat.length / 3;
  let largest = 0;
  for (let i = 0; i < count; ++i) largest = Math.max(largest, Math.hypot(flat[i], flat[count + i]));
  return largest * quantum;
}

const mixed = (a, b, weight, i) => a[i] + weight * (b[i] - a[i]);

/** Places in Å, x, y, z one after another, of quantised ones that come component by component. */
function places_at(flat, frames, {before, after, weight}, quantum) {
  const count = flat.length / 3, points = new Float32Array(3 * count), a = frames[before], b = frames[after];
  for (let i = 0; i < count; ++i)
    for (let c = 0; c < 3; ++c) points[3 * i + c] = quantum * (flat[c * count + i] + mixed(a, b, weight, c * count + i));
  return points;
}

/** Pairs of atoms that are neighbours in the flat sheet: no farther apart than 1.3 times what most nearest ones are. */
function bonds_of(flat, quantum) {
  const count = flat.length / 3, cell = 3 / quantum, cells = new Map(), key = (x, y) => x * 65536 + y;
  for (let i = 0; i < count; ++i) {
    const k = key(Math.floor(flat[i] / cell), Math.floor(flat[count + i] / cell));
    if (!cells.has(k)) cells.set(k, []);
    cells.get(k).push(i);
  }
  const pairs = [];
  for (let i = 0; i < count; ++i)
    for (let dx = -1; dx <= 1; ++dx)
      for (let dy = -1; dy <= 1; ++dy)
        for (const j of cells.get(key(Math.floor(flat[i] / cell) + dx, Math.floor(flat[count + i] / cell) + dy)) ?? [])
          if (j > i) pairs.push([i, j, Math.hypot(flat[i] - flat[j], flat[count + i] - flat[count + j])]);
  const least = new Float32Array(count).fill(Infinity);
  for (const [i, j, length] of pairs) least[i] = Math.min(least[i], length), least[j] = Math.min(least[j], length);
  const usual = least.sort()[Math.floor(count / 2)];
  return pairs.filter(([, , length]) => length < 1.3 * usual);
}

/** The longest bond of each atom. */
function longest_bonds(points, bonds) {
  const longest = new Float32Array(points.length / 3);
  for (const [i, j] of bonds) {
    const length = Math.hypot(points[3 * i] - points[3 * j], points[3 * i + 1] - points[3 * j + 1], points[3 * i + 2] - points[3 * j + 2]);
    if (length > longest[i]) longest[i] = length;
    if (length > longest[j]) longest[j] = length;
  }
  return longest;
}

/** Lowest value of the flat sheet and all but the largest thousandth of the deepest one. */
function bond_range(atoms, flat, frames, bonds) {
  const of = (frame) => longest_bonds(places_at(flat, frames, {before: frame, after: frame, weight: 0}, atoms.quantum), bonds);
  const first = of(0).slice(0, atoms.free).sort(), last = of(frames.length - 1).slice(0, atoms.free).sort();
  return [first[0], Math.max(last[Math.floor(0.999 * (last.length - 1))], first[0] + 0.01)];
}

const to_colour = (value, low, high) => Math.max(0, Math.min(255, Math.round((255 * (value - low)) / (high - low))));

function atoms_scene(atoms, scale) {
  const [flat] = unpacked(atoms.flat, 1, 3 * atoms.count), frames = unpacked(atoms.frames, atoms.depth.length, 3 * atoms.count);
  const bonds = bonds_of(flat, atoms.quantum), [low, high] = bond_range(atoms, flat, frames, bonds), palette = palette_of(scale);
  let points, longest, colours;
  return {
    title: "atoms",
    fields: ["longest bond"],
    radius: radius_of(flat, atoms.quantum),
    bar: () => ({low: shown(low, 4), high: "≥ " + shown(high, 4), unit: "Å", scale}),
    go_to(depth) {
      points = places_at(flat, frames, around(atoms.depth, depth), atoms.quantum);
      longest = longest_bonds(points, bonds);
      colours = Uint8Array.from(longest, (length) => to_colour(length, low, high));
      return "";
    },
    draw: (picture, camera) => draw_spheres(picture, points, colours, 0.8, palette, camera),
    words: (i) => `atom ${i + 1}: longest bond ${longest[i].toFixed(3)} Å, height ${shown(points[3 * i + 2], 4)} Å`,
    summary: () => `longest bond ${longest.subarray(0, atoms.free).reduce((a, b) => Math.max(a, b)).toFixed(3)} Å`,
  };
}

/** Where the corners' places begin; their numbers come as differences from triangle to triangle, corner by corner. */
function corners_of(membrane) {
  const [steps] = unpacked(membrane.corners, 1, 3 * membrane.triangles), count = membrane.triangles, corners = new Int32Array(3 * count);
  for (let c = 0; c < 3; ++c)
    for (let t = 0, n = 0; t < count; ++t) corners[3 * t + c] = 3 * (n += steps[c * count + t]);
  return corners;
}

function mirrored(points, sx, sy) {
  const image = Float32Array.from(points);
  for (let i = 0; i < image.length; i += 3) image[i] *= sx, image[i + 1] *= sy;
  return image;
}

const states = ["taut", "wrinkled", "slack"];

function membrane_scene(membrane, scale, state_colours) {
  const [flat] = unpacked(membrane.flat, 1, 3 * membrane.nodes), count = membrane.depth.length, {low, high, unit} = membrane.stress;
  const frames = unpacked(membrane.frames, count, 3 * membrane.nodes), corners = corners_of(membrane);
  const stress = unpacked(membrane.stress.values, count, membrane.triangles), state = unpacked(membrane.state, count, membrane.triangles);
  const palettes = [palette_of(scale), palette_of(state_colours)], mirrors = membrane.mirrored ? [[1, 1], [-1, 1], [1, -1], [-1, -1]] : [[1, 1]];
  let points, values, shown_states, field = 0;
  const colour = (t) => (field === 0 ? Math.round(values[t]) : Math.round((255 * shown_states[t]) / 2));
  return {
    title: `membrane, ${membrane.name}`,
    fields: ["larger principal force", "state"],
    radius: radius_of(flat, membrane.quantum),
    choose: (chosen) => (field = chosen),
    bar: () => (field === 0 ? {low: shown(low, 3), high: (membrane.stress.clipped ? "≥ " : "") + shown(high, 3), unit, scale}
                            : {names: states, colours: state_colours}),
    go_to(depth) {
      const at = around(membrane.depth, depth), {before, after, weight} = at;
      points = places_at(flat, frames, at, membrane.quantum);
      values = Float32Array.from(stress[0], (_, t) => mixed(stress[before], stress[after], weight, t));
      shown_states = state[weight < 0.5 ? before : after];
      const ends = membrane.depth[count - 1];
      if (depth > ends + 0.005) return `its deepest kept shape, ${shown(ends, 4)} Å, is shown`;
      return before === after ? "" : `in between its shapes at ${shown(membrane.depth[before], 4)} and ${shown(membrane.depth[after], 4)} Å`;
    },
    draw(picture, camera) {
      for (const [sx, sy] of mirrors) {
        const places = projected(mirrored(points, sx, sy), camera), three = [0, 0, 0];
        for (let t = 0; t < membrane.triangles; ++t) {
          for (let c = 0; c < 3; ++c) three[c] = corners[3 * t + c];
          draw_triangle(picture, places, three, colour(t), t, palettes[field], camera.scale);
        }
      }
    },
    words: (t) => `larger principal force ${shown(low + (values[t] / 255) * (high - low), 3)} ${unit}, ${states[shown_states[t]]}`,
    summary: () => `larger principal force up to ${shown(low + (values.reduce((a, b) => Math.max(a, b)) / 255) * (high - low), 3)} ${unit}`,
  };
}

