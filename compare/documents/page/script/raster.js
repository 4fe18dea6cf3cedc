// A small renderer: spheres and triangles into the pixels of a canvas, the nearest in front. It needs no graphics processor.

const shades = 64;

/** 256 colours from the stops "#rrggbb", each in all shades, as pixels of a canvas. */
function palette_of(stops) {
  const parts = stops.map((stop) => [1, 3, 5].map((i) => parseInt(stop.slice(i, i + 2), 16)));
  const table = new Uint32Array(256 * shades);
  for (let c = 0; c < 256; ++c) {
    const at = (c / 255) * (parts.length - 1), k = Math.min(Math.floor(at), parts.length - 2);
    for (let s = 0; s < shades; ++s) {
      const light = 0.45 + (0.55 * s) / (shades - 1);
      const [r, g, b] = [0, 1, 2].map((i) => Math.round(light * (parts[k][i] + (at - k) * (parts[k + 1][i] - parts[k][i]))));
      table[c * shades + s] = (255 << 24) | (b << 16) | (g << 8) | r;
    }
  }
  return table;
}

/** Where the eye is: right, up and towards the eye as rows, pixels for an Å, the middle of the picture. */
function camera_of({turn, height, nearness}, size, radius, middle) {
  const [s, c, S, C] = [Math.sin(turn), Math.cos(turn), Math.sin(height), Math.cos(height)];
  return {rows: [c, s, 0, -s * S, c * S, C, s * C, -c * C, S], scale: (0.47 * size * nearness) / radius, half: size / 2, middle};
}

/** Pixels of a canvas with what is drawn there (-1: nothing) and how near it is. */
function empty_picture(size) {
  return {size, pixels: new Uint32Array(size * size), near: new Float32Array(size * size).fill(-Infinity),
          index: new Int32Array(size * size).fill(-1)};
}

/** Places of points (x, y, z one after another) on the picture: x and y in pixels, nearness in Å. */
function projected(points, camera) {
  const {rows: m, scale, half, middle} = camera, result = new Float32Array(points.length);
  for (let i = 0; i < points.length; i += 3) {
    const x = points[i], y = points[i + 1], z = points[i + 2] - middle;
    result[i] = half + scale * (m[0] * x + m[1] * y + m[2] * z);
    result[i + 1] = half - scale * (m[3] * x + m[4] * y + m[5] * z);
    result[i + 2] = m[6] * x + m[7] * y + m[8] * z;
  }
  return result;
}

/** What of a sphere is seen: offsets in pixels, how much nearer than the middle (in radii), shade. */
function stamp_of(radius) {
  const stamp = [], r = Math.ceil(radius);
  for (let dy = -r; dy <= r; ++dy)
    for (let dx = -r; dx <= r; ++dx) {
      const rest = 1 - (dx * dx + dy * dy) / (radius * radius);
      if (rest < 0) continue;
      const nz = Math.sqrt(rest), light = Math.max(0, (-0.4 * dx - 0.5 * dy) / radius + 0.77 * nz);
      stamp.push({dx, dy, nearer: nz, shade: Math.min(shades - 1, Math.round(light * (shades - 1)))});
    }
  return stamp.length ? stamp : [{dx: 0, dy: 0, nearer: 1, shade: shades - 1}];
}

/** Spheres of a radius in Å; colours are numbers up to 255 of the palette. */
function draw_spheres(picture, points, colours, radius, palette, camera) {
  const {size, pixels, near, index} = picture, places = projected(points, camera);
  const stamp = stamp_of(Math.max(0.8, radius * camera.scale));
  for (let i = 0; i < colours.length; ++i) {
    const x = Math.round(places[3 * i]), y = Math.round(places[3 * i + 1]), depth = places[3 * i + 2];
    for (const {dx, dy, nearer, shade} of stamp) {
      const px = x + dx, py = y + dy;
      if (px < 0 || py < 0 || px >= size || py >= size) continue;
      const at = py * size + px, here = depth + nearer * radius;
      if (here <= near[at]) continue;
      near[at] = here, index[at] = i, pixels[at] = palette[colours[i] * shades + shade];
    }
  }
}

/** One triangle over three places (their first index in `places`): shaded by its slope, filled row by row. */
function draw_triangle(picture, places, [a, b, c], colour, number, palette, scale) {
  const {size, pixels, near, index} = picture;
  const ax = places[a], ay = places[a + 1], az = places[a + 2], bx = places[b] - ax, by = places[b + 1] - ay, bz = places[b + 2] - az;
  const cx = places[c] - ax, cy = places[c + 1] - ay, cz = places[c + 2] - az, area = bx * cy - cx * by;
  if (Math.abs(area) < 1e-6) return;
  const zx = (bz * cy - cz * by) / area, zy = (cz * bx - bz * cx) / area, nx = -zx * scale, ny = -zy * scale;
  const light = Math.max(0, (-0.4 * nx - 0.5 * ny + 0.77) / Math.sqrt(nx * nx + ny * ny + 1));
  const pixel = palette[colour * shades + Math.min(shades - 1, Math.round(light * (shades - 1)))];
  const top = Math.max(0, Math.ceil(ay + Math.min(0, by, cy) - 0.5)), end = Math.min(size - 1, Math.floor(ay + Math.max(0, by, cy) + 0.5));
  for (let y = top; y <= end; ++y) {
    // The row's stretch inside; half a pixel more to each side closes the seams between neighbours.
    let left = Infinity, right = -Infinity;
    const cross = (x1, y1, x2, y2) => {
      const from = Math.max(Math.min(y1, y2), y - ay - 0.5), to = Math.min(Math.max(y1, y2), y - ay + 0.5);
      if (from > to) return;
      for (const at of [from, to]) {
        const x = y1 === y2 ? x1 : x1 + ((at - y1) * (x2 - x1)) / (y2 - y1);
        left = Math.min(left, x), right = Math.max(right, x);
      }
      if (y1 === y2) left = Math.min(left, x2), right = Math.max(right, x2);
    };
    cross(0, 0, bx, by);
    cross(bx, by, cx, cy);
    cross(cx, cy, 0, 0);
    const last = Math.min(size - 1, Math.floor(ax + right + 0.5));
    for (let x = Math.max(0, Math.ceil(ax + left - 0.5)); x <= last; ++x) {
      const at = y * size + x, here = az + zx * (x - ax) + zy * (y - ay);
      if (here <= near[at]) continue;
      near[at] = here, index[at] = number, pixels[at] = pixel;
    }
  }
}

