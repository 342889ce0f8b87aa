// @ts-check
// Bars beside a scene: amounts of each body as they are at the time, and as text.

import { add, at } from "./plot.js";
import { told } from "./told.js";

/** @typedef {{ title: string, unit: string, most: number, curves: import("./plot.js").Curve[] }} Bar */

/** What is smaller than this share of the greatest is rounding. */
const NOTHING = 1e-9;

/** The figures of a number. */
const FIGURES = 3;

/** All bars of a scene. */
export class Bars {
  #home;
  /** @type {((time: number) => void)[]} */
  #rows = [];

  /** @param {HTMLElement} home */
  constructor(home) {
    this.#home = home;
  }

  /** @param {Bar[]} bars */
  set(bars) {
    this.#rows = [];
    this.#home.replaceChildren(...bars.map((bar) => this.#table(bar)));
  }

  /** @param {number} time */
  show(time) {
    for (const row of this.#rows) row(time);
  }

  /** @param {Bar} bar */
  #table({ title, unit, most, curves }) {
    const table = document.createElement("table");
    table.createCaption().textContent = `${title} in ${unit}`;
    const has_sign = curves.some(({ points }) => points.some(([, value]) => value < -NOTHING * most));
    for (const { name, role, points } of curves) {
      const row = table.insertRow();
      const head = document.createElement("th");
      head.scope = "row";
      head.textContent = name;
      row.append(head);
      const look = { class: "bar", viewBox: has_sign ? "-1 0 2 1" : "0 0 1 1", preserveAspectRatio: "none", "aria-hidden": "true" };
      const svg = add("svg", look, row.insertCell());
      const line = add("line", { class: role, x1: 0, y1: 0.5, y2: 0.5 }, svg);
      add("line", { class: "zero", x1: 0, x2: 0, y1: 0, y2: 1 }, svg);
      const number = row.insertCell();
      this.#rows.push((time) => {
        const value = at(points, time);
        line.setAttribute("x2", String(most > 0 ? value / most : 0));
        number.textContent = told(value, FIGURES, most);
      });
    }
    return table;
  }
}
