// @ts-check
// The bouncing ball on its page, with another beside it.

import { add, at } from "./plot.js";
import { Frame, arrow, draw_velocity, greatest, picture } from "./scene.js";
import { Simulator, one, row, told } from "./simulator.js";

/** @typedef {import("./simulator.js").Amount} Amount */
/** @typedef {import("./plot.js").Curve} Curve */
/** @typedef {{ number: number, time: Amount, after: Amount, height: Amount, share: Amount }} Bounce */
/**
 * @typedef {object} Own
 * @property {[number, number]} track
 * @property {Bounce[]} bounces
 * @property {{ bounce: Bounce } | null} looked_at
 * @property {object | null} sums
 * @property {string | null} no_sums
 * @property {Curve} velocity
 * @property {Curve[]} velocities
 * @property {{ bounces: Bounce[], rests: Amount | null } | null} second
 */
/** @typedef {import("./simulator.js").Shown & Own} Restitution */

/** The radius of a ball, how far two are from the middle at most, and the longest arrow, in px. */
const RADIUS = 15;
const ASIDE = 44;
const LONGEST = 90;
/** Half of the width that a scene takes, in px. */
const HALF = 70;

const root = one(document, "[data-simulator]", HTMLElement);
const svg = picture(root);
const frame = new Frame(svg, { left: HALF, right: HALF, above: 2 * RADIUS + 14, below: 30 });

/** @param {Restitution} shown */
function filled(shown) {
  const { track: [, height], bounces, looked_at, sums, no_sums, second } = shown;
  frame.show([-0.0001, 0.0001], [-height, 0], () => {
    draw_peaks(shown);
    simulator.redraw();
  });
  draw_peaks(shown);
  const rows = bounces.map(({ number, time, after, height, share }) => {
    const beside = second ? [second.bounces[number]?.height.text ?? "–"] : [];
    const made = row(String(number), [time.text, after.text, height.text, share.text, ...beside]);
    made.classList.toggle("chosen", number === looked_at?.bounce.number);
    return made;
  });
  one(root, "[data-bounces]", HTMLTableSectionElement).replaceChildren(...rows);
  one(root, "[data-looked-at]", HTMLElement).hidden = !looked_at;
  one(root, "[data-sums]", HTMLElement).hidden = !sums;
  one(root, "[data-no-sums]", HTMLElement).hidden = !no_sums;
  for (const place of root.querySelectorAll("[data-second]")) if (place instanceof HTMLElement || place instanceof SVGElement) {
    place.toggleAttribute("hidden", !second);
  }
}

/**
 * Where a ball is, to the right of the middle.
 * @param {number} ball
 * @param {boolean} two
 */
function aside(ball, two) {
  return two ? (2 * ball - 1) * Math.min(ASIDE * frame.unit, frame.width / 4) : 0;
}

/**
 * The heights that are reached after each bounce.
 * @param {Restitution} shown
 */
function draw_peaks({ bounces, second }) {
  const home = one(svg, "[data-peaks]", SVGGElement);
  home.replaceChildren();
  for (const [ball, all] of [bounces, second?.bounces ?? []].entries()) {
    const [middle, half] = [aside(ball, Boolean(second)), 1.5 * RADIUS * frame.unit];
    for (const { height } of all) {
      const y = -height.value;
      add("line", { class: `peak body-${ball}`, x1: middle - half, x2: middle + half, y1: y, y2: y }, home);
    }
  }
}

/**
 * @param {Restitution} shown
 * @param {number} time
 */
function moved({ places, velocity, velocities, bounces, compared, second, bars }, time) {
  const u = frame.unit;
  const radius = RADIUS * u;
  const balls = second ? [places[0], places[2]] : [places[0]];
  const [fastest, largest] = [greatest(velocities), greatest(bars[0]?.curves ?? [])];
  for (const [ball, curve] of balls.entries()) {
    const group = one(svg, `[data-at="${ball}"]`, SVGGElement);
    group.setAttribute("transform", `translate(${aside(ball, Boolean(second))} ${-at(curve?.points ?? [], time)})`);
    for (const circle of group.querySelectorAll("circle")) {
      circle.setAttribute("cy", String(-radius));
      circle.setAttribute("r", String(radius));
    }
    /** @param {Curve | undefined} of @param {number} most */
    const down = (of, most) => (-at(of?.points ?? [], time) / most) * LONGEST * u;
    draw_velocity(group, [0, -radius], [0, down(velocities[ball], fastest)], u);
    group.querySelector(".momentum")?.setAttribute("d", arrow([1.5 * radius, -radius], [0, down(bars[0]?.curves[ball], largest)], u));
    const name = group.querySelector("text");
    name?.setAttribute("y", String(-radius + 5 * u));
    name?.toggleAttribute("hidden", !second);
  }
  const wrong = compared?.places[0];
  svg.querySelector('[data-ghost="0"]')?.setAttribute(
    "transform",
    `translate(${aside(0, Boolean(second))} ${-at(wrong?.points ?? [], time)})`,
  );
  const height = at(places[0]?.points ?? [], time);
  const done = bounces.filter((bounce) => bounce.number > 0 && bounce.time.value <= time).length;
  const count = `${done} ${done === 1 ? "bounce" : "bounces"}`;
  const beside = second ? `; B: height ${told(at(places[2]?.points ?? [], time))} m` : "";
  return `${told(time)} s: height ${told(height)} m, velocity ${told(at(velocity.points, time))} m/s, ${count}${beside}`;
}

/** @returns {[number, number]} */
function scale() {
  return [0, -1];
}

/** @type {Simulator<Restitution>} */
const simulator = new Simulator(root, { filled, moved, scale });
