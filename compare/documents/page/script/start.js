// One function around all scripts of the page: they share names with each other and with nothing else.
(() => {
"use strict";

const data = JSON.parse(document.getElementById("data").textContent || "{}");

/** An HTML element with properties, attributes and children. */
function element(name, settings = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(settings)) {
    if (key in made && typeof value !== "string") made[key] = value;
    else made.setAttribute(key, value);
  }
  made.append(...children);
  return made;
}

/** The same in SVG. */
function drawn(name, attributes = {}, ...children) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

/** A number with so many digits, without the noise of its last ones, with a real minus sign. */
function shown(value, digits = 5) {
  if (value === null || !Number.isFinite(value)) return "–";
  return String(Number(value.toPrecision(digits))).replace("-", "−");
}

/** What is to be done whenever the colours change. */
const when_colours_change = [];

