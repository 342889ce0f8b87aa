// @ts-check
// The bouncing ball on its page.

import { at } from "./plot.js";
import { Simulator, move, one, row, told } from "./simulator.js";

/** @typedef {import("./simulator.js").Amount} Amount */
/** @typedef {{ number: number, time: Amount, after: Amount, height: Amount, share: Amount }} Bounce */
/**
 * @typedef {object} Own
 * @property {Bounce[]} bounces
 * @property {{ bounce: Bounce } | null} looked_at
 * @property {object | null} sums
 * @property {string | null} no_sums
 * @property {import("./plot.js").Curve} velocity
 */
/** @typedef {import("./simulator.js").Shown & Own} Restitution */

const root = one(document, "[data-simulator]", HTMLElement);

/** @param {Restitution} shown */
function filled({ track: [, height], bounces, looked_at, sums, no_sums }) {
  const svg = one(root, "[data-ball]", SVGSVGElement);
  svg.setAttribute("viewBox", [-0.2, -1.22, 0.4, 1.23].map((part) => part * height).join(" "));
  const ball = one(svg, "[data-at] circle", SVGCircleElement);
  ball.setAttribute("cy", String(-0.08 * height));
  ball.setAttribute("r", String(0.08 * height));
  const rows = bounces.map(({ number, time, after, height, share }) => {
    const made = row(String(number), [time.text, after.text, height.text, share.text]);
    made.classList.toggle("chosen", number === looked_at?.bounce.number);
    return made;
  });
  one(root, "[data-bounces]", HTMLTableSectionElement).replaceChildren(...rows);
  one(root, "[data-looked-at]", HTMLElement).hidden = !looked_at;
  one(root, "[data-sums]", HTMLElement).hidden = !sums;
  one(root, "[data-no-sums]", HTMLElement).hidden = !no_sums;
}

/**
 * @param {Restitution} shown
 * @param {number} time
 */
function moved({ places, velocity, bounces, compared }, time) {
  /** @param {number} place */
  const upwards = (place) => `translate(0 ${-place})`;
  move(root, "at", places.slice(0, 1), time, upwards);
  move(root, "ghost", compared?.places ?? [], time, upwards);
  const height = at(places[0]?.points ?? [], time);
  const done = bounces.filter((bounce) => bounce.number > 0 && bounce.time.value <= time).length;
  const count = `${done} ${done === 1 ? "bounce" : "bounces"}`;
  return `${told(time)} s: height ${told(height)} m, velocity ${told(at(velocity.points, time))} m/s, ${count}`;
}

new Simulator(root, { filled, moved });
