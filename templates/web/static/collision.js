// @ts-check
// The collision on its page.

import { at } from "./plot.js";
import { Simulator, move, one, plotted, told } from "./simulator.js";

/** @typedef {import("./simulator.js").Amount} Amount */
/** @typedef {import("./plot.js").Curve} Curve */
/** @typedef {{ bodies: { name: string, radius: number }[], table: Amount[][], contact: { force: Curve[] } | null }} Own */
/** @typedef {import("./simulator.js").Shown & Own} Collision */

const root = one(document, "[data-simulator]", HTMLElement);

/** @param {Collision} shown */
function filled({ track: [low, high], bodies, table, contact }) {
  const svg = one(root, "[data-track]", SVGSVGElement);
  const tallest = 1.3 * Math.max(...bodies.map(({ radius }) => radius));
  svg.setAttribute("viewBox", `${low} ${-tallest - 0.5} ${high - low} ${tallest + 0.85}`);
  for (const [place, { radius }] of bodies.entries()) draw_cart(place, radius);
  const rows = table.map((cells) => {
    const made = document.createElement("tr");
    for (const { text } of cells) made.insertCell().textContent = text;
    return made;
  });
  one(root, '[data-cells="table"]', HTMLTableSectionElement).replaceChildren(...rows);
  one(root, "[data-magnified]", HTMLElement).hidden = !contact;
  if (contact) magnify(contact.force);
}

/** @type {import("./plot.js").Plot | undefined} */
let magnified;

/**
 * The force of the contact, all of it at once.
 * @param {Curve[]} force
 */
function magnify(force) {
  if (magnified) magnified.set(force);
  else magnified = plotted(root, "contact", force);
  magnified.show(Infinity);
}

/**
 * A cart of that size.
 * @param {number} place
 * @param {number} radius
 */
function draw_cart(place, radius) {
  const cart = one(root, `[data-at="${place}"]`, SVGGElement);
  const [box, name] = [cart.querySelector("rect"), cart.querySelector("text")];
  const [height, wheel] = [1.3 * radius, 0.01 + 0.2 * radius];
  for (const [key, value] of Object.entries({ x: -radius, y: -height - wheel, width: 2 * radius, height })) {
    box?.setAttribute(key, String(value));
  }
  name?.setAttribute("y", String(-height - wheel - 0.1));
  for (const [side, circle] of cart.querySelectorAll("circle").entries()) {
    circle.setAttribute("cx", String((side - 0.5) * radius));
    circle.setAttribute("cy", String(-wheel));
    circle.setAttribute("r", String(wheel));
  }
}

/**
 * @param {Collision} shown
 * @param {number} time
 */
function moved({ places, compared }, time) {
  /** @param {number} place */
  const across = (place) => `translate(${place} 0)`;
  move(root, "at", places, time, across);
  move(root, "ghost", compared?.places ?? [], time, across);
  const said = places.map(({ name, points }) => `${name} at ${told(at(points, time))} m`);
  return `${told(time)} s: ${said.join(", ")}`;
}

new Simulator(root, { filled, moved });
