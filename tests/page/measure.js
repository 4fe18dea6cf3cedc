// What the test asks of a page, as functions of its window.
Object.assign(window, (() => {
  const seen = (e) => {
    const box = e.getBoundingClientRect(), style = getComputedStyle(e);
    return box.width > 0 && box.height > 0 && style.visibility !== "hidden";
  };
  const outline = (e) => `${e.localName}.${e.getAttribute("class") ?? ""}: ${(e.textContent ?? "").trim().slice(0, 40)}`;
  const rgb = (text) => (text.match(/[\d.]+/g) ?? []).map(Number);
  const luminance = ([r, g, b]) => {
    const [R, G, B] = [r, g, b].map((v) => (v / 255 <= 0.03928 ? v / 255 / 12.92 : ((v / 255 + 0.055) / 1.055) ** 2.4));
    return 0.2126 * R + 0.7152 * G + 0.0722 * B;
  };
  const contrast = (a, b) => (Math.max(luminance(a), luminance(b)) + 0.05) / (Math.min(luminance(a), luminance(b)) + 0.05);

  /** The nearest colour behind an element. */
  const behind = (e) => {
    for (; e; e = e.parentElement) {
      const colour = rgb(getComputedStyle(e).backgroundColor);
      if (colour.length === 3 || colour[3] > 0.99) return colour;
    }
    return [255, 255, 255];
  };

  /** Elements with words of their own. */
  const worded = () => [...document.querySelectorAll("body *:not(script):not(.static *)")].filter(
    (e) => seen(e) && [...e.childNodes].some((n) => n.nodeType === 3 && n.textContent.trim()));

  /** Texts with less than 4.5 : 1 (WCAG 2.2, 1.4.3). */
  const low_contrast = () => worded().filter((e) => {
    const style = getComputedStyle(e), ink = rgb(e.namespaceURI.endsWith("svg") ? style.fill : style.color);
    return contrast(ink, behind(e)) < 4.5;
  }).map(outline);

  const name_of = (e) => e.getAttribute("aria-label") || e.textContent.trim() || e.alt || [...(e.labels ?? [])].map((l) => l.textContent).join(" ").trim();

  /** What can be operated, or is a picture, and says nothing of itself (4.1.2, 1.1.1). */
  const without_names = () => [...document.querySelectorAll("button, select, input, a, [tabindex], img, [role=application], summary")]
    .filter((e) => seen(e) && !name_of(e)).map(outline);

  /** Things to press that are less than 24 pixels high or wide (2.5.8); a link in a line of text is none. */
  const small_targets = () => [...document.querySelectorAll("button, select, input, summary")].filter(seen).filter((e) => {
    const box = e.getBoundingClientRect();
    return box.width < 23.9 || box.height < 23.9;
  }).map(outline);

  /** One first heading, no level left out, one main part, a language, no id twice, header cells that say of what they are. */
  const bad_structure = () => {
    const faults = [], levels = [...document.querySelectorAll("h1, h2, h3, h4")].filter(seen).map((h) => Number(h.localName[1]));
    if (levels.filter((level) => level === 1).length !== 1) faults.push("not one h1");
    levels.forEach((level, i) => i && level > levels[i - 1] + 1 && faults.push(`h${level} after h${levels[i - 1]}`));
    if (document.querySelectorAll("main").length !== 1) faults.push("not one main");
    if (!document.documentElement.lang) faults.push("no language");
    const ids = [...document.querySelectorAll("[id]")].map((e) => e.id);
    if (new Set(ids).size !== ids.length) faults.push("an id twice");
    if ([...document.querySelectorAll("th")].some((e) => !e.scope)) faults.push("a header cell without scope");
    if ([...document.querySelectorAll("[tabindex]")].some((e) => e.tabIndex > 0)) faults.push("an order of its own");
    return faults;
  };

  const smallest_letters = () => Math.min(...worded().map((e) => {
    const scale = e.ownerSVGElement ? e.ownerSVGElement.getScreenCTM().a : 1;
    return parseFloat(getComputedStyle(e).fontSize) * scale;
  }));

  /** Pairs of labels of one chart that lie on one another, or leave the screen. */
  const overlapping_letters = () => [...document.querySelectorAll(".panels svg")].flatMap((svg) => {
    const labels = [...svg.querySelectorAll("text:not([transform])")].filter(seen), boxes = labels.map((e) => e.getBoundingClientRect());
    const faults = labels.filter((_, i) => boxes[i].left < -1 || boxes[i].right > innerWidth + 1).map((e) => "outside: " + e.textContent);
    boxes.forEach((a, i) => boxes.slice(i + 1).forEach((b, k) => {
      const wide = Math.min(a.right, b.right) - Math.max(a.left, b.left), high = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
      if (wide > 1 && high > 4) faults.push(`${labels[i].textContent} | ${labels[i + 1 + k].textContent}`);
    }));
    return faults;
  });

  /** The middle of the first element that the selector finds. */
  const place = (selector) => {
    const box = document.querySelector(selector).getBoundingClientRect();
    return [box.left + box.width / 2, box.top + box.height / 2];
  };

  /** Where on the screen a curve of the first chart is, after a part of its length. */
  const curve_point = (name, part) => {
    const path = [...document.querySelectorAll(".panels [data-name]")].find((e) => e.dataset.name === name).querySelector("path");
    const at = path.getPointAtLength(part * path.getTotalLength()), m = path.getScreenCTM();
    return [m.a * at.x + m.e, m.d * at.y + m.f];
  };

  /** How many pixels are drawn, and how many rows have some. */
  const drawn_pixels = (canvas) => {
    const {data, width, height} = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height), rows = new Set();
    let count = 0;
    for (let i = 3; i < data.length; i += 4) if (data[i]) ++count, rows.add(Math.floor(i / 4 / width));
    return {count, height: rows.size / height};
  };

  const until = async (what) => {
    for (let i = 0; i < 300 && !what(); ++i) await new Promise((done) => setTimeout(done, 20));
    if (!what()) throw new Error("it did not happen: " + what);
  };

  return {low_contrast, without_names, small_targets, bad_structure, smallest_letters, overlapping_letters, place, curve_point,
          drawn_pixels, until};
})());
