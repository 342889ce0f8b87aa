// @ts-check
// The collision in the plane on its page.

import { add, at } from "./plot.js";
import { Frame, arrow, draw_velocity, greatest, picture } from "./scene.js";
import { Simulator, one, told } from "./simulator.js";

/** @typedef {import("./simulator.js").Amount} Amount */
/** @typedef {import("./plot.js").Curve} Curve */
/**
 * @typedef {object} Own
 * @property {[[number, number], [number, number]]} table
 * @property {{ name: string, radius: number, angle: Amount | null }[]} bodies
 * @property {{ time: Amount } | null} meeting
 * @property {Curve[]} heights
 * @property {[Curve[], Curve[]]} velocities
 */
/** @typedef {import("./simulator.js").Shown & Own} Discs */

/** The greatest speed that can be set, in m/s, as a share of the window. */
const FASTEST = { speed: 10, share: 0.35 };
/** The longest arrow of a momentum, as a share of the window. */
const LONGEST = 0.15;

const root = one(document, "[data-simulator]", HTMLElement);
const svg = picture(root);
const frame = new Frame(svg, { left: 24, right: 24, above: 26, below: 30 });

/** How long an arrow is for each m/s. */
function pace() {
  return (FASTEST.share * frame.width) / FASTEST.speed;
}

/** @param {Discs} shown */
function filled(shown) {
  const { table: [across, [low, high]], bodies } = shown;
  frame.show(across, [-high, -low], () => simulator.redraw());
  for (const [place, { angle }] of bodies.entries()) {
    const cell = root.querySelector(`[data-angle="${place}"]`);
    if (cell) cell.textContent = angle?.text ?? "–";
  }
  draw_paths(shown);
}

/**
 * The paths, and the line of impact with both discs where they touch.
 * @param {Discs} shown
 */
function draw_paths({ places, heights, meeting, bodies }) {
  const home = one(svg, "[data-paths]", SVGGElement);
  home.replaceChildren();
  for (const [place, { points, role }] of places.entries()) {
    const up = heights[place]?.points ?? [];
    const times = [...new Set([...points, ...up].map(([time]) => time))].sort((one, other) => one - other);
    const d = times.map((time, count) => `${count ? "L" : "M"}${at(points, time)} ${-at(up, time)}`).join("");
    add("path", { class: `path ${role}`, d }, home);
  }
  if (!meeting) return;
  const [a, b] = bodies.map((_, place) => {
    const point = [at(places[place]?.points ?? [], meeting.time.value), -at(heights[place]?.points ?? [], meeting.time.value)];
    add("circle", { class: `touching body-${place}`, cx: point[0] ?? 0, cy: point[1] ?? 0, r: bodies[place]?.radius ?? 0 }, home);
    return point;
  });
  if (!a || !b) return;
  /** @param {number} part @param {number} side */
  const beyond = (part, side) => (side > 0 ? (b[part] ?? 0) : (a[part] ?? 0)) + side * 0.6 * ((b[part] ?? 0) - (a[part] ?? 0));
  add("line", { class: "line-of-impact", x1: beyond(0, -1), y1: beyond(1, -1), x2: beyond(0, 1), y2: beyond(1, 1) }, home);
}

/**
 * @param {Discs} shown
 * @param {number} time
 */
function moved({ places, heights, bodies, velocities, bars }, time) {
  const u = frame.unit;
  const [along, up] = [bars[0]?.curves ?? [], bars[1]?.curves ?? []];
  const force = (LONGEST * frame.width) / greatest([...along, ...up]);
  for (const [place, curve] of places.entries()) {
    const group = one(svg, `[data-at="${place}"]`, SVGGElement);
    group.setAttribute("transform", `translate(${at(curve.points, time)} ${-at(heights[place]?.points ?? [], time)})`);
    /** @param {Curve[]} right @param {Curve[]} upwards @param {number} factor @returns {[number, number]} */
    const vector = (right, upwards, factor) => [
      at(right[place]?.points ?? [], time) * factor,
      -at(upwards[place]?.points ?? [], time) * factor,
    ];
    const velocity = vector(velocities[0], velocities[1], pace());
    draw_velocity(group, [0, 0], velocity, u);
    group.querySelector(".momentum")?.setAttribute("d", arrow([0, 0], vector(along, up, force), u));
    const body = bodies[place];
    if (body) group.querySelector("text")?.setAttribute("y", String(-body.radius - 7 * u));
    group.querySelector(".mark")?.setAttribute("transform", `scale(${u})`);
  }
  const said = places.map(({ name, points }, place) => `${name} at (${told(at(points, time))}, ${told(at(heights[place]?.points ?? [], time))}) m`);
  return `${told(time)} s: ${said.join(", ")}`;
}

/**
 * A's centre lies half the impact parameter below the middle, that of B above it.
 * @param {string} name
 * @param {Element} part
 * @returns {[number, number]}
 */
function scale(name, part) {
  if (name.startsWith("v")) return [1 / pace(), 0];
  return [0, part.closest('[data-at="0"]') ? 2 : -2];
}

/** @param {Discs} shown */
function curves({ places, heights }) {
  return { places, heights };
}

/** @type {Simulator<Discs>} */
const simulator = new Simulator(root, { filled, moved, scale, curves });
