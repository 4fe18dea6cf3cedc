// From values to places on a panel, and the ticks of an axis.

/** Lowest and highest value along an axis: as given, else of all that is drawn with a little room. */
function range_of(panel, along) {
  const axis = panel[along];
  if (axis.categories.length) return [-0.6, axis.categories.length - 0.4];
  let low = Infinity, high = -Infinity;
  const take = (value) => {
    if (value === null || (axis.logarithmic && value <= 0)) return;
    low = Math.min(low, value), high = Math.max(high, value);
  };
  for (const curve of panel.curves) {
    curve[along].forEach(take);
    if (along === "y" && curve.high) curve.high.forEach(take);
  }
  if (along === "y")
    for (const stack of stacks_of(panel)) for (const bar of stack) take(bar.low), take(bar.high);
  for (const mark of panel.marks) if (mark.along === along) take(mark.at);
  if (!(low <= high)) [low, high] = [0, 1];
  if (low === high) [low, high] = [low - 0.5, high + 0.5];
  if (axis.logarithmic) [low, high] = [low / 1.15, high * 1.15];
  else if (along === "y") [low, high] = [low - 0.05 * (high - low), high + 0.05 * (high - low)];
  return [axis.low ?? low, axis.high ?? high];
}

/** Per category its bars from low to high: positive shares upwards from 0, negative ones downwards. */
function stacks_of(panel) {
  return panel.x.categories.map((_, i) => {
    let up = 0, down = 0;
    return panel.bars.map((bars) => {
      const value = bars.y[i] ?? 0, from = value < 0 ? down : up;
      if (value < 0) down += value;
      else up += value;
      return {name: bars.name, colour: bars.colour, value: bars.y[i], low: Math.min(from, from + value),
              high: Math.max(from, from + value)};
    });
  });
}

/** Some `count` multiples of 1, 2 or 5 times a power of ten, three at least. */
function even_ticks(low, high, count) {
  const power = 10 ** Math.floor(Math.log10((high - low) / count)), steps = [10, 5, 2, 1, 0.5, 0.2, 0.1].map((times) => times * power);
  const multiples = (step) => {
    const ticks = [];
    for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) ticks.push(k * step);
    return ticks;
  };
  const coarse = steps.findLast((step) => step >= (1 - 1e-9) * ((high - low) / count));
  return multiples(steps.slice(steps.indexOf(coarse)).find((step) => multiples(step).length >= 3));
}

function logarithmic_ticks(low, high, count) {
  for (const multiples of [[1, 2, 3, 4, 5, 6, 8], [1, 2, 5], [1, 3], [1]]) {
    const ticks = [];
    for (let power = Math.floor(Math.log10(low)); 10 ** power <= high; ++power)
      for (const times of multiples)
        if (times * 10 ** power >= low && times * 10 ** power <= high) ticks.push(times * 10 ** power);
    if (ticks.length <= 2 * count || multiples.length === 1) return ticks;
  }
  return [];
}

/** An axis laid over the pixels from `start` to `end`: the place of a value, ticks with their names. */
function scale_of(panel, along, start, end) {
  const axis = panel[along], [low, high] = range_of(panel, along);
  const bent = axis.logarithmic ? Math.log10 : (value) => value;
  const slope = (end - start) / (bent(high) - bent(low));
  const place = (value) => start + (bent(value) - bent(low)) * slope;
  const count = Math.max(3, Math.abs(end - start) / (along === "x" ? 70 : 45));
  let ticks;
  if (axis.categories.length) ticks = axis.categories.map((name, i) => ({at: i, name}));
  else
    ticks = (axis.logarithmic ? logarithmic_ticks : even_ticks)(low, high, count).map((at) => ({at, name: shown(at, 8)}));
  return {place, ticks, low, high};
}

