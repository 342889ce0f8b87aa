// @ts-check
// Numbers as people read them, and the points of a plot as a table.

import { at } from "./plot.js";

/** The rows of a table. */
const ROWS = 20;

/**
 * A number with so many figures. One that is nothing beside `scale` is 0.
 * @param {number} value
 * @param {number} figures
 * @param {number} [scale] the largest of its kind: nothing is told more finely than to so many figures of it
 */
export function told(value, figures, scale = Math.abs(value)) {
  if (!Number.isFinite(value)) return "–";
  if (scale === 0) return "0";
  const order = Math.floor(Math.log10(scale));
  if (order > 6 || order < -4) {
    if (Math.abs(value) < scale * 10 ** -figures) return "0";
    const [digits, power] = value.toExponential(figures - 1).split("e");
    return `${digits}·10${raised(Number(power))}`.replace(/^-/, "\u2212");
  }
  const text = value.toFixed(Math.max(0, figures - 1 - order));
  return (Number(text) === 0 ? text.replace("-", "") : text).replace("-", "\u2212");
}

/** @param {number} power */
function raised(power) {
  return String(power).replace("-", "⁻").replace(/\d/g, (digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(digit)] ?? "");
}

/**
 * The curves of a plot at evenly spaced instants.
 * @param {import("./plot.js").Contents} contents
 */
export function table({ title, across, up, curves }) {
  const own = document.createElement("table");
  own.createCaption().textContent = `${title}, ${up}`;
  const head = own.createTHead().insertRow();
  for (const text of [across, ...curves.map(({ name }) => name)]) {
    const cell = document.createElement("th");
    cell.scope = "col";
    cell.textContent = text;
    head.append(cell);
  }
  const times = curves[0]?.points.map(([time]) => time) ?? [];
  const [first, last] = [times[0] ?? 0, times[times.length - 1] ?? 0];
  const largest = curves.map(({ points }) => Math.max(...points.map(([, value]) => Math.abs(value))));
  const body = own.createTBody();
  for (let row = 0; row <= ROWS; row += 1) {
    const time = first + ((last - first) * row) / ROWS;
    const line = body.insertRow();
    line.insertCell().textContent = told(time, 3, last - first);
    for (const [place, { points }] of curves.entries()) line.insertCell().textContent = told(at(points, time), 4, largest[place]);
  }
  const scroll = document.createElement("div");
  scroll.className = "scroll";
  scroll.tabIndex = 0;
  scroll.setAttribute("role", "region");
  scroll.setAttribute("aria-label", `${title} as a table`);
  scroll.append(own);
  return scroll;
}
