// @ts-check
// Line plots as SVG, drawn as time runs.

/**
 * A curve. Its role is a class that the style sheet knows: body-0, body-1, ..., centre, exact, other, kinetic, ...
 * @typedef {{ name: string, role: string, points: [number, number][], dashed?: boolean }} Curve
 */

/**
 * A plot. The axes say their units: "time in s".
 * @typedef {{ title: string, across: string, up: string, curves: Curve[] }} Contents
 */

/** @typedef {{ least: number, most: number, step: number, power: number }} Range `power`: the power of ten in the label */

const SVG = "http://www.w3.org/2000/svg";
/** Sizes in px: a line of text, a letter on average, the end of a curve, the plot between its axes where the page does not say. */
const LINE = 18;
const LETTER = 6.5;
const DOT = 3.5;
const HEIGHT = 150;
/** The width before the page is laid out. */
const WIDTH = 360;
/** The distance of ticks that is aimed at. */
const APART = { across: 58, up: 30 };

let count = 0;

/**
 * An element of a picture.
 * @param {string} name
 * @param {Record<string, string | number>} attributes
 * @param {Element} parent
 */
export function add(name, attributes, parent) {
  const element = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
  parent.append(element);
  return element;
}

/**
 * The range of some values with round ticks.
 * @param {number[]} values
 * @param {number} ticks about how many
 * @param {boolean} room whether the curve keeps off the edges, and a zero nearby is shown
 * @returns {Range}
 */
function range(values, ticks, room) {
  const known = values.filter(Number.isFinite);
  let least = known.reduce((one, other) => Math.min(one, other), Infinity);
  let most = known.reduce((one, other) => Math.max(one, other), -Infinity);
  if (!known.length) [least, most] = [0, 1];
  const size = Math.max(Math.abs(least), Math.abs(most));
  // What differs by rounding alone is level.
  const level = most - least <= 1e-9 * size;
  if (room && (level || 2 * least < most)) least = Math.min(least, 0);
  if (room && (level || 2 * most > least)) most = Math.max(most, 0);
  if (most <= least) [least, most] = [least - 1, most + 1];
  const edge = room ? (most - least) * 0.06 : 0;
  if (least !== 0) least -= edge;
  if (most !== 0) most += edge;
  const rough = (most - least) / Math.max(ticks, 2);
  const ten = 10 ** Math.floor(Math.log10(rough));
  const step = ([1, 2, 5].find((factor) => factor * ten >= rough * (1 - 1e-9)) ?? 10) * ten;
  const order = Math.floor(Math.log10(Math.max(Math.abs(least), Math.abs(most))));
  return { least, most, step, power: order > 4 || order < -2 ? 3 * Math.floor(order / 3) : 0 };
}

/**
 * The ticks of a range with what stands at them.
 * @param {Range} range
 * @returns {[number, string][]}
 */
function ticks({ least, most, step, power }) {
  const scale = 10 ** power;
  const digits = Math.max(0, -Math.floor(Math.log10(step / scale) + 1e-9));
  const first = Math.ceil(least / step - 1e-9);
  const last = Math.floor(most / step + 1e-9);
  return Array.from({ length: last - first + 1 }, (_, place) => {
    const value = (first + place) * step;
    return [value, (value / scale).toFixed(digits).replace("-", "\u2212")];
  });
}

/**
 * A label with the power of ten that its ticks leave out: "r in 10⁶ m".
 * @param {string} label
 * @param {Range} range
 */
function label(label, { power }) {
  if (power === 0) return label;
  const raised = String(power).replace("-", "⁻").replace(/\d/g, (digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(digit)] ?? "");
  return label.replace(/ in (.*)$/, ` in 10${raised} $1`);
}

/**
 * Where a curve is at a time, between two of its points on the line that joins them; at a jump, after it.
 * @param {[number, number][]} points
 * @param {number} time
 */
export function at(points, time) {
  let [low, high] = [0, points.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((points[middle]?.[0] ?? NaN) <= time) low = middle + 1;
    else high = middle;
  }
  const [before, after] = [points[low - 1], points[low]];
  if (!before || !after) return (before ?? after)?.[1] ?? NaN;
  return before[1] + ((time - before[0]) / (after[0] - before[0])) * (after[1] - before[1]);
}

/** A plot in an element of the page; it fills the width of the element and finds its own height. */
export class Plot {
  #svg;
  #contents;
  #time = 0;
  #width = 0;
  /** @type {(time: number) => void} */
  #shown = () => {};

  /**
   * @param {SVGSVGElement} svg
   * @param {Contents} contents
   */
  constructor(svg, contents) {
    this.#svg = svg;
    this.#contents = contents;
    svg.setAttribute("role", "img");
    svg.setAttribute("aria-label", `${contents.title}: ${contents.up} against ${contents.across}`);
    svg.classList.add("plot");
    new ResizeObserver(() => {
      if (Math.abs(svg.clientWidth - this.#width) >= 1) this.#draw();
    }).observe(svg);
    this.#draw();
  }

  /**
   * Other curves on the same axes.
   * @param {Curve[]} curves
   */
  set(curves) {
    this.#contents = { ...this.#contents, curves };
    this.#draw();
  }

  /**
   * Draws the curves up to a time. What comes later is faint.
   * @param {number} time
   */
  show(time) {
    this.#time = time;
    this.#shown(time);
  }

  #draw() {
    const svg = this.#svg;
    const { title, curves } = this.#contents;
    const width = (this.#width = svg.clientWidth || WIDTH);
    svg.replaceChildren();
    add("text", { class: "title", x: 0, y: 13 }, svg).textContent = title;
    const top = this.#legend(width) + 2 * LINE;
    const tall = Number(svg.dataset.tall ?? HEIGHT);
    const bottom = top + tall;
    const values = [0, 1].map((part) => curves.flatMap(({ points }) => points.map((point) => point[part] ?? NaN)));
    const up = range(values[1] ?? [], tall / APART.up, true);
    const marks = ticks(up);
    const left = Math.max(...marks.map(([, text]) => text.length), 1) * (LETTER + 0.5) + 8;
    const right = width - 12;
    const across = range(values[0] ?? [], (right - left) / APART.across, false);
    /** @param {number} value */
    const x = (value) => left + ((value - across.least) / (across.most - across.least)) * (right - left);
    /** @param {number} value */
    const y = (value) => bottom - ((value - up.least) / (up.most - up.least)) * tall;

    for (const [value, text] of marks) {
      add("line", { class: value === 0 ? "axis" : "grid", x1: left, x2: right, y1: y(value), y2: y(value) }, svg);
      add("text", { class: "tick", x: left - 6, y: y(value) + 4, "text-anchor": "end" }, svg).textContent = text;
    }
    add("line", { class: "axis", x1: left, x2: left, y1: top, y2: bottom }, svg);
    for (const [value, text] of ticks(across)) {
      add("line", { class: "axis", x1: x(value), x2: x(value), y1: bottom, y2: bottom + 4 }, svg);
      add("text", { class: "tick", x: x(value), y: bottom + 17, "text-anchor": "middle" }, svg).textContent = text;
    }
    add("line", { class: "axis", x1: left, x2: right, y1: bottom, y2: bottom }, svg);
    const names = this.#contents;
    add("text", { class: "label", x: 0, y: top - 10 }, svg).textContent = label(names.up, up);
    const foot = bottom + 17 + LINE;
    add("text", { class: "label", x: right, y: foot, "text-anchor": "end" }, svg).textContent = label(names.across, across);
    svg.setAttribute("viewBox", `0 0 ${width} ${foot + 5}`);

    const clip = add("clipPath", { id: `plot-${++count}` }, svg);
    const past = add("rect", { x: left, y: top - DOT, height: tall + 2 * DOT }, clip);
    const [later, sooner] = ["later", "sooner"].map((name) => add("g", { class: name }, svg));
    sooner?.setAttribute("clip-path", `url(#plot-${count})`);
    for (const { points, role, dashed } of curves) {
      let gap = true;
      const drawn = points.map((point) => {
        const known = point.every(Number.isFinite);
        const command = !known ? "" : `${gap ? "M" : "L"}${x(point[0]).toFixed(1)} ${y(point[1]).toFixed(1)}`;
        gap = !known;
        return command;
      });
      const look = { class: `curve ${role}${dashed ? " dashed" : ""}`, d: drawn.join("") };
      for (const group of [later, sooner]) if (group) add("path", look, group);
    }
    const dots = curves.map(({ role }) => add("circle", { class: `dot ${role}`, r: DOT }, svg));
    this.#shown = (time) => {
      past.setAttribute("width", String(Math.min(Math.max(x(time) - left, 0), right - left)));
      for (const [place, { points }] of curves.entries()) {
        const value = at(points, time);
        const first = points[0]?.[0] ?? NaN;
        const last = points[points.length - 1]?.[0] ?? NaN;
        const dot = dots[place];
        dot?.setAttribute("cx", x(Math.min(Math.max(time, first), last)).toFixed(1));
        dot?.setAttribute("cy", Number.isFinite(value) ? y(value).toFixed(1) : "-9");
      }
    };
    this.#shown(this.#time);
  }

  /**
   * The names of the curves in as many lines as they take.
   * @param {number} width
   * @returns {number} where the legend ends
   */
  #legend(width) {
    let [x, y] = [0, LINE + 13];
    const { curves } = this.#contents;
    if (curves.length < 2) return LINE;
    for (const { name, role, dashed } of curves) {
      const long = 24 + name.length * LETTER;
      if (x > 0 && x + long > width) [x, y] = [0, y + LINE];
      add("line", { class: `curve ${role}${dashed ? " dashed" : ""}`, x1: x, x2: x + 18, y1: y - 4, y2: y - 4 }, this.#svg);
      add("text", { class: "name", x: x + 24, y }, this.#svg).textContent = name;
      x += long + 14;
    }
    return y + 5;
  }
}
