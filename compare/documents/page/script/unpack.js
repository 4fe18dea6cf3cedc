// Whole numbers as the program packs them (packed.hpp): base64 of Rice's code, of what is left after a guess.

function bytes_of(text) {
  const raw = atob(text), bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; ++i) bytes[i] = raw.charCodeAt(i);
  return bytes;
}

/** Reads bits, the highest of a byte first. */
function bit_reader(bytes) {
  let at = 0;
  const bit = () => {
    const value = (bytes[at >> 3] >> (7 - (at & 7))) & 1;
    ++at;
    return value;
  };
  const bits = (count) => {
    let value = 0;
    for (let k = 0; k < count; ++k) value = value * 2 + bit();
    return value;
  };
  const ones = (most) => {
    let count = 0;
    while (count < most && bit()) ++count;
    return count;
  };
  return {bits, ones};
}

/** So many frames of so many numbers each; each frame is told by how it differs from the way the two before it went on. */
function unpacked(text, frames, length) {
  const block = 32, most_ones = 20, {bits, ones} = bit_reader(bytes_of(text)), all = [];
  for (let f = 0; f < frames; ++f) {
    const frame = new Int32Array(length), one = all[f - 1], two = all[f - 2];
    let width = 0;
    for (let i = 0; i < length; ++i) {
      if (i % block === 0) width = bits(5);
      const high = ones(most_ones), code = high === most_ones ? bits(32) : high * 2 ** width + bits(width);
      const rest = code % 2 ? -(code + 1) / 2 : code / 2;
      frame[i] = rest + (one ? 2 * one[i] - (two ? two[i] : 0) : 0);
    }
    all.push(frame);
  }
  return all;
}

