// @ts-check
// The picture of a scene in motion: bodies, walls, traces and the centre of mass, where the record has them.

import { add, at } from "./plot.js";

/**
 * @typedef {{ time: number, masses: number[], positions: number[][], velocities: number[][], momenta: number[][],
 *   mass_centre: number[], momentum: number[], impulse_from_outside: number[], kinetic_energy: number,
 *   potential_energy: number, energy_lost: number, work: number, energy_balance: number }} Moment
 * @typedef {{ name: string, called: string, mass: number, radius: number }} Body
 * @typedef {{ letter: string, positive: string | null, height: boolean, on_page: [number, number] }} Direction
 * @typedef {{ name: string, normal: number[], offset: number, velocity: number }} Wall
 * @typedef {{ stage: number, kind: string, pivot: { at: number[], cord: boolean, arm?: number, name: string | null } | null, mass_not_told: string[], notes: string[], directions: Direction[], bodies: Body[], walls: Wall[],
 *   impacts: { time: number }[], moments: Moment[] }} Film
 * @typedef {[number, number]} Pair to the right, and upwards or downwards
 */

/** Sizes in px: free space, bodies without a radius by their mass, a lane, the most for a radius and for a speed. */
const MARGIN = 26;
const LARGE = 13;
const SMALL = 4.5;
const LANE = 44;
const WIDEST = 40;
const FASTEST = 64;
const WIDTH = 640;
const HATCH = 9;
/** The roles of bodies. */
const BODIES = 6;

let count = 0;

/** @param {Pair[]} points */
function path(points) {
  return points.map(([x, y], place) => `${place ? "L" : "M"}${x.toFixed(1)} ${y.toFixed(1)}`).join("");
}

/** A length of 1, 2 or 5 and a power of ten, at most so long. @param {number} most */
function round(most) {
  const ten = 10 ** Math.floor(Math.log10(most));
  return ([5, 2].find((factor) => factor * ten <= most) ?? 1) * ten;
}

/** A length with its unit. @param {number} metres */
function metres(metres) {
  if (metres >= 1e9) return `${metres / 1e9} million km`;
  if (metres >= 1000) return `${metres / 1000} km`;
  if (metres >= 1) return `${metres} m`;
  return metres >= 0.01 ? `${Math.round(metres * 100)} cm` : `${Number((metres * 1000).toPrecision(1))} mm`;
}

/** The picture of one film in a figure. */
export class Stage {
  #film;
  #svg;
  #time = 0;
  #width = 0;
  /** Places on the page in m, by the time: of each body, then of the centre of mass. @type {[[number, number][], [number, number][]][]} */
  #tracks;
  #speeds;
  #fastest;
  /** @type {(time: number) => void} */
  #shown = () => {};

  /**
   * @param {HTMLElement} figure
   * @param {Film} film
   */
  constructor(figure, film) {
    this.#film = film;
    const each = film.bodies.map((_, body) => body);
    /** @param {(moment: Moment) => number[]} vector */
    const tracked = (vector) => {
      const pairs = film.moments.map((moment) => this.#page(vector(moment)));
      /** @param {0 | 1} part @returns {[number, number][]} */
      const along = (part) => pairs.map((pair, place) => [film.moments[place]?.time ?? 0, pair[part]]);
      return /** @type {[[number, number][], [number, number][]]} */ ([along(0), along(1)]);
    };
    this.#tracks = [...each.map((body) => tracked((own) => own.positions[body] ?? [])), tracked((own) => own.mass_centre)];
    this.#speeds = each.map((body) => tracked((own) => own.velocities[body] ?? []));
    this.#fastest = Math.max(1e-300, ...film.moments.flatMap((own) => own.velocities.map((one) => Math.hypot(...this.#page(one)))));
    this.#svg = add("svg", { class: "plot motion", role: "img" }, figure);
    const bodies = film.bodies.map(({ called }) => called).join(", ");
    this.#svg.setAttribute("aria-label", `${film.kind}: ${bodies} in motion; the table below tells their places`);
    figure.replaceChildren(this.#svg);
    new ResizeObserver(() => {
      if (Math.abs(this.#svg.clientWidth - this.#width) >= 1) this.#draw();
    }).observe(this.#svg);
    this.#draw();
  }

  /** @param {number} time */
  show(time) {
    this.#time = time;
    this.#shown(time);
  }

  /** A vector of the scene on the page, upwards positive. @param {number[]} vector @returns {Pair} */
  #page(vector) {
    const { directions } = this.#film;
    const part = (/** @type {0 | 1} */ own) => directions.reduce((sum, { on_page }, axis) => sum + on_page[own] * (vector[axis] ?? 0), 0);
    return [part(0), part(1)];
  }

  #draw() {
    const { directions, bodies, walls, pivot, moments } = this.#film;
    const svg = this.#svg;
    const width = (this.#width = svg.clientWidth || WIDTH);
    svg.replaceChildren();
    const line = directions.length === 1;
    const upright = line && Math.abs(directions[0]?.on_page[1] ?? 0) > 0;
    const particles = bodies.every(({ radius }) => radius === 0);
    const lanes = line && particles && bodies.length > 1 ? bodies.length + 1 : 1;
    const heaviest = Math.max(...bodies.map(({ mass }) => mass));
    const widest = Math.max(...bodies.map(({ radius }) => radius));

    const reach = (/** @type {0 | 1} */ part) => {
      const all = this.#tracks.flatMap((track) => track[part].map(([, value]) => value));
      for (const { normal, offset, velocity } of walls.filter((wall) => wall.velocity !== 0)) {
        const faces = [moments[0], moments[moments.length - 1]].map((own) => offset + velocity * (own?.time ?? 0));
        all.push(...faces.map((face) => face * this.#page(normal)[part]));
      }
      if (pivot) all.push(this.#page(pivot.at)[part]);
      const least = all.reduce((one, other) => Math.min(one, other), Infinity) - (line && upright === (part === 0) ? 0 : widest);
      const most = all.reduce((one, other) => Math.max(one, other), -Infinity) + (line && upright === (part === 0) ? 0 : widest);
      return { least, most, size: most - least };
    };
    const [x, y] = [reach(0), reach(1)];
    const edge = particles ? MARGIN + LARGE : MARGIN;
    const tall = upright ? 280 : Math.min(420, 0.8 * width);
    const free = [x.size > 0 ? (width - 2 * edge) / x.size : Infinity, y.size > 0 ? (tall - 2 * edge) / y.size : Infinity];
    const scale = Math.min(...free, widest > 0 ? WIDEST / widest : Infinity, 1e300);
    const across = line && !upright;
    const height = across ? (lanes > 1 ? lanes * LANE + 34 : 2 * widest * scale + 110) : Math.max(y.size * scale + 2 * edge + 18, 150);
    // Where the scene's origin is, and how far apart lanes are.
    const left = (width - x.size * scale) / 2 - x.least * scale;
    const top = across ? (height - 16) / 2 : height - 18 - (height - 18 - y.size * scale) / 2 + y.least * scale;
    /** @param {number} lane @returns {Pair} */
    const shift = (lane) => {
      const own = (lane - (lanes - 1) / 2) * LANE;
      return lanes === 1 ? [0, 0] : across ? [0, own] : [own, 0];
    };
    /** @param {Pair} pair @param {number} [lane] @returns {Pair} */
    const put = ([right, up], lane = 0) => {
      const [more, down] = shift(lane);
      return [left + right * scale + more, top - up * scale + down];
    };
    /** @param {Body} body */
    const size = ({ radius, mass }) => (radius > 0 ? Math.max(radius * scale, 3) : Math.max(LARGE * Math.cbrt(mass / heaviest), SMALL));
    svg.setAttribute("viewBox", `0 0 ${width} ${height.toFixed(1)}`);
    Object.assign(svg.dataset, { scale: String(scale), left: String(left), top: String(top) });

    const clip = `stage-${++count}`;
    add("rect", { width, height }, add("clipPath", { id: clip }, svg));
    const back = add("g", { "clip-path": `url(#${clip})` }, svg);
    const faces = walls.map((wall) => {
      const [right, up] = this.#page(wall.normal);
      // A particle is drawn with a size, so what it touches is drawn so much farther away.
      const behind = particles ? Math.max(...bodies.map(size)) : 0;
      const group = add("g", { class: "wall" }, back);
      const long = width + height;
      const strokes = [];
      for (let place = -long; place < long; place += 12) {
        const [px, py] = [-up * place, -right * place];
        strokes.push(`M${px.toFixed(1)} ${py.toFixed(1)}l${(-HATCH * (right + up)).toFixed(1)} ${(HATCH * (up - right)).toFixed(1)}`);
      }
      add("path", { class: "hatch", d: strokes.join("") }, group);
      add("path", { class: "face", d: `M${-up * long} ${-right * long}L${up * long} ${right * long}` }, group);
      return (/** @type {number} */ time) => {
        const face = wall.offset + wall.velocity * time;
        const [px, py] = put([right * face, up * face]);
        group.setAttribute("transform", `translate(${(px - behind * right).toFixed(2)} ${(py + behind * up).toFixed(2)})`);
      };
    });
    for (let lane = 0; line && lane < lanes; lane += 1) {
      const [start, end] = [put([x.least, y.least], lane), put([x.most, y.most], lane)];
      add("path", { class: "guide", d: path([start, end]) }, back);
    }

    const together = this.#tracks.length - 1;
    const traces = line
      ? []
      : this.#tracks.map(([right, up], own) => {
          const all = right.map(([, value], place) => put([value, up[place]?.[1] ?? 0]));
          const role = own === together ? "centre" : `body-${own % BODIES}`;
          if (own === together && bodies.length < 2) return () => {};
          add("path", { class: `trace later ${role}`, d: path(all) }, back);
          const past = add("path", { class: `trace ${role}` }, back);
          return (/** @type {number} */ time) => {
            const gone = right.filter(([own]) => own <= time).length;
            past.setAttribute("d", path([...all.slice(0, gone), put([at(right, time), at(up, time)])]));
          };
        });

    /** The pivot, and a cord from it to each body. @type {SVGElement[]} */
    const cords = [];
    if (pivot) {
      const [px, py] = put(this.#page(pivot.at));
      for (const own of bodies.keys()) {
        if (pivot.cord || pivot.arm === own) cords[own] = add("line", { class: pivot.cord ? "cord" : "arm", x1: px, y1: py }, svg);
      }
      add("circle", { class: "pivot", cx: px, cy: py, r: 3 }, svg);
      add("text", { class: "tick", x: px + 8, y: py + 4 }, svg).textContent = pivot.name ?? "";
    }
    const centre = bodies.length > 1 ? add("path", { class: "mass-centre centre", d: "M-6 0H6M0 -6V6" }, svg) : undefined;
    const drawn = bodies.map((body, own) => {
      const [right, up] = this.#tracks[own] ?? [[], []];
      const [faster, higher] = this.#speeds[own] ?? [[], []];
      const group = add("g", { class: `body body-${own % BODIES}`, "data-body": body.name }, svg);
      const radius = size(body);
      add("circle", { r: radius.toFixed(2) }, group);
      const above = lanes > 1 || own % 2 === 0;
      // A letter stands in its body where there is room, a word beside it.
      const inside = body.name.length === 1 && radius >= 8;
      const name = inside
        ? { x: 0, y: 4, "text-anchor": "middle" }
        : upright
        ? { x: lanes > 1 ? 0 : own % 2 ? -radius - 8 : radius + 8, y: lanes > 1 ? -radius - 6 : 4, "text-anchor": lanes > 1 ? "middle" : own % 2 ? "end" : "start" }
        : { x: 0, y: above ? -radius - 7 : radius + 16, "text-anchor": "middle" };
      add("text", { class: "name", ...name }, group).textContent = body.name;
      const arrow = add("path", { class: "arrow" }, group);
      return (/** @type {number} */ time) => {
        const [px, py] = put([at(right, time), at(up, time)], own);
        group.setAttribute("transform", `translate(${px.toFixed(2)} ${py.toFixed(2)})`);
        cords[own]?.setAttribute("x2", px.toFixed(2));
        cords[own]?.setAttribute("y2", py.toFixed(2));
        const [vx, vy] = [at(faster, time) / this.#fastest, -at(higher, time) / this.#fastest];
        const long = Math.hypot(vx, vy) * FASTEST;
        const [ex, ey] = long > 0 ? [(vx * FASTEST) / long, (vy * FASTEST) / long] : [0, 0];
        const [tx, ty] = [(radius + long) * ex, (radius + long) * ey];
        const head = Math.min(7, long);
        const barb = (/** @type {number} */ side) => `M${tx} ${ty}l${-head * ex - side * head * 0.45 * ey} ${-head * ey + side * head * 0.45 * ex}`;
        arrow.setAttribute("d", long > 1 ? `M${radius * ex} ${radius * ey}L${tx} ${ty}${barb(1)}${barb(-1)}` : "");
      };
    });

    const bar = round((width / 4) / scale);
    const foot = height - 6;
    if (Number.isFinite(bar) && bar > 0) {
      const long = bar * scale;
      add("path", { class: "axis bar", d: `M${width - long - 8} ${foot - 6}v6h${long}v-6` }, svg);
      add("text", { class: "tick", x: width - long - 14, y: foot, "text-anchor": "end" }, svg).textContent = metres(bar);
    }
    add("text", { class: "tick", x: 0, y: foot }, svg).textContent = !centre
      ? "→ velocity"
      : width < 420
        ? "+ centre of mass"
        : "→ velocity  ·  + centre of mass";

    this.#shown = (time) => {
      for (const show of [...faces, ...traces, ...drawn]) show(time);
      const [right, up] = this.#tracks[together] ?? [[], []];
      const [px, py] = put([at(right, time), at(up, time)], lanes - 1);
      centre?.setAttribute("transform", `translate(${px.toFixed(2)} ${py.toFixed(2)})`);
    };
    this.#shown(this.#time);
  }
}
