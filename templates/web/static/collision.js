// @ts-check
// The collision on its page.

import { at } from "./plot.js";
import { Frame, arrow, draw_velocity, greatest, picture } from "./scene.js";
import { Simulator, move, one, plotted, told } from "./simulator.js";

/** @typedef {import("./simulator.js").Amount} Amount */
/** @typedef {import("./plot.js").Curve} Curve */
/**
 * @typedef {object} Own
 * @property {[number, number]} track
 * @property {{ name: string, radius: number }[]} bodies
 * @property {Amount[][]} table
 * @property {{ force: Curve[] } | null} contact
 * @property {Curve[]} velocities
 */
/** @typedef {import("./simulator.js").Shown & Own} Collision */

/** The greatest speed that can be set, in m/s, as a share of the window. */
const FASTEST = { speed: 10, share: 0.3 };
/** The longest arrow of a momentum, as a share of the window. */
const LONGEST = 0.22;
/** Below the rail, in px: arrows of momentum, one below the other, and the centre of mass. */
const LANES = [14, 26, 38];
const CENTRE = 8;
/** From a cart to its name, and to its arrow, in px. */
const NAME = 8;
const ABOVE = 34;

const root = one(document, "[data-simulator]", HTMLElement);
const svg = picture(root);
const frame = new Frame(svg, { left: 30, right: 30, above: 66, below: 62 });

/** @param {Collision} shown */
function filled({ track, bodies, table, contact }) {
  const tallest = 1.7 * Math.max(...bodies.map(({ radius }) => radius));
  frame.show(track, [-tallest, 0], () => simulator.redraw());
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
 * How high a cart is with its wheels.
 * @param {number} radius
 */
function high(radius) {
  return 1.5 * radius + 0.01;
}

/**
 * A cart of that size.
 * @param {number} place
 * @param {number} radius
 */
function draw_cart(place, radius) {
  const cart = one(root, `[data-at="${place}"]`, SVGGElement);
  const box = cart.querySelector("rect");
  const [height, wheel] = [1.3 * radius, 0.01 + 0.2 * radius];
  for (const [key, value] of Object.entries({ x: -radius, y: -height - wheel, width: 2 * radius, height })) {
    box?.setAttribute(key, String(value));
  }
  for (const [side, circle] of cart.querySelectorAll(".grip:not(.tip) circle").entries()) {
    circle.setAttribute("cx", String((side - 0.5) * radius));
    circle.setAttribute("cy", String(-wheel));
    circle.setAttribute("r", String(wheel));
  }
}

/** How long an arrow is for each m/s. */
function pace() {
  return (FASTEST.share * frame.width) / FASTEST.speed;
}

/**
 * @param {Collision} shown
 * @param {number} time
 */
function moved({ places, compared, bodies, velocities, bars }, time) {
  const u = frame.unit;
  const momenta = bars[0]?.curves ?? [];
  const force = (LONGEST * frame.width) / greatest(momenta);
  /** @param {number} place */
  const across = (place) => `translate(${place} 0)`;
  move(root, "at", places.slice(0, 2), time, across);
  move(root, "ghost", compared?.places ?? [], time, across);
  for (const [place, curve] of places.entries()) {
    const group = one(svg, `[data-at="${place}"]`, SVGGElement);
    const body = bodies[place];
    const [top, lane] = [body ? -high(body.radius) - ABOVE * u : (CENTRE + 40) * u, (LANES[place] ?? 0) * u];
    if (!body) group.setAttribute("transform", `translate(${at(curve.points, time)} 0)`);
    const velocity = at(velocities[place]?.points ?? [], time) * pace();
    draw_velocity(group, [0, top], [velocity, 0], u);
    group.querySelector(".momentum")?.setAttribute("d", arrow([0, lane], [at(momenta[place]?.points ?? [], time) * force, 0], u));
    if (body) group.querySelector("text")?.setAttribute("y", String(-high(body.radius) - NAME * u));
    group.querySelector(".mark")?.setAttribute("transform", `translate(0 ${(CENTRE - 4) * u}) scale(${u})`);
  }
  const said = places.map(({ name, points }) => `${name} at ${told(at(points, time))} m`);
  return `${told(time)} s: ${said.join(", ")}`;
}

/**
 * @param {string} name
 * @returns {[number, number]}
 */
function scale(name) {
  return name.startsWith("v") ? [1 / pace(), 0] : [1, 0];
}

/** @type {Simulator<Collision>} */
const simulator = new Simulator(root, { filled, moved, scale });
