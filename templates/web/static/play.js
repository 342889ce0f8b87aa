// @ts-check
// A scene played: the bodies where the record has them, with plots, stage by stage.

import { Announcer } from "./announcer.js";
import { call, Refused } from "./engine.js";
import { Clock } from "./clock.js";
import { Plot, at } from "./plot.js";
import { Stage } from "./stage.js";
import { told, table } from "./told.js";

/**
 * @typedef {import("./stage.js").Film} Film
 * @typedef {import("./stage.js").Moment} Moment
 * @typedef {import("./plot.js").Curve} Curve
 * @typedef {import("./plot.js").Contents} Contents
 */

/** How long a stage takes on the page, in s, where that is not how long it takes. */
const LONG = 6;
/** The shortest and the longest stage that is shown as fast as it happens, in s. */
const AS_IT_IS = [2.5, 16];
/** The steps of the slider. */
const MARKS = 240;
/** The colours of bodies. */
const BODIES = 6;

/**
 * The curves of one quantity of all bodies, and of all together.
 * @param {Film} film
 * @param {(moment: Moment, body: number) => number} own
 * @param {Curve[]} more
 * @returns {Curve[]}
 */
function each(film, own, more) {
  const curves = film.bodies.map(({ called }, body) => ({
    name: called,
    role: `body-${body % BODIES}`,
    points: over(film, (moment) => own(moment, body)),
  }));
  return film.bodies.length > 1 ? [...curves, ...more] : curves;
}

/**
 * @param {Film} film
 * @param {(moment: Moment) => number} value
 * @returns {[number, number][]}
 */
function over(film, value) {
  return film.moments.map((moment) => [moment.time, value(moment)]);
}

/**
 * The plots of a film: place, velocity and momentum along each axis, and the energies.
 * @param {Film} film
 * @returns {Contents[]}
 */
function plots(film) {
  const across = "time in s";
  /** @type {Contents[][]} */
  const along = film.directions.map(({ letter, positive, height }, axis) => {
    const sense = positive ? ` (positive ${positive})` : "";
    /** @param {number[][]} vectors @param {number} body */
    const part = (vectors, body) => vectors[body]?.[axis] ?? NaN;
    /** @param {string} name @param {(moment: Moment) => number[]} vector */
    const total = (name, vector) => ({
      name,
      role: "centre",
      dashed: true,
      points: over(film, (moment) => vector(moment)[axis] ?? NaN),
    });
    const momenta = each(film, (moment, body) => part(moment.momenta, body), [total("all together", (own) => own.momentum)]);
    const outside = over(film, (moment) => moment.impulse_from_outside[axis] ?? 0);
    if (outside.some(([, value]) => value !== 0)) {
      momenta.push({ name: "impulse from outside", role: "outside", dashed: true, points: outside });
    }
    return [
      {
        title: `${height ? "Height" : "Position"} ${letter}${sense}`,
        across,
        up: `${letter} in m`,
        curves: each(film, (moment, body) => part(moment.positions, body), [
          total("centre of mass", (own) => own.mass_centre),
        ]),
      },
      {
        title: `Velocity along ${letter}`,
        across,
        up: "v in m/s",
        curves: each(film, (moment, body) => part(moment.velocities, body), []),
      },
      { title: `Momentum along ${letter}`, across, up: "p in N s", curves: momenta },
    ];
  });
  // The axes side by side, quantity by quantity.
  const all = [0, 1, 2].flatMap((quantity) => along.flatMap((own) => own[quantity] ?? []));
  return [...all, { title: "Energy", across, up: "E in J", curves: energies(film) }];
}

/**
 * @param {Film} film
 * @returns {Curve[]}
 */
function energies(film) {
  /** @type {[string, string, (moment: Moment) => number][]} */
  const kinds = [
    ["kinetic", "kinetic", (moment) => moment.kinetic_energy],
    ["potential", "potential", (moment) => moment.potential_energy],
    ["lost in impacts", "lost", (moment) => moment.energy_lost],
    ["work of other forces", "work", (moment) => moment.work],
  ];
  const largest = Math.max(...film.moments.map((own) => Math.abs(own.kinetic_energy) + Math.abs(own.potential_energy)));
  // A wall that moves gives energy as well as taking it: what it gave is not lost, and below zero.
  if (film.walls.some(({ velocity }) => velocity !== 0) && film.moments.some((own) => own.energy_lost < -1e-9 * largest)) {
    kinds[2] = ["given by the moving wall", "lost", (moment) => -moment.energy_lost];
  }
  const curves = kinds.map(([name, role, value]) => ({ name, role, points: over(film, value) }));
  // A sum that is nothing but rounding is no energy.
  const shown = curves.filter(({ role, points }) => role === "kinetic" || points.some(([, own]) => Math.abs(own) > 1e-9 * largest));
  if (shown.length > 1) {
    const points = over(film, (moment) => moment.energy_balance);
    return [...shown, { name: "balance", role: "total", dashed: true, points }];
  }
  return shown;
}

/**
 * How fast a film is shown, in s of the scene for a second of the reader's: 1, 2 or 5 and a power of ten.
 * @param {number} length
 */
function pace(length) {
  if (length >= (AS_IT_IS[0] ?? 0) && length <= (AS_IT_IS[1] ?? 0)) return 1;
  const rough = length / LONG;
  const ten = 10 ** Math.floor(Math.log10(rough));
  return ([5, 2].find((factor) => factor * ten <= rough) ?? 1) * ten;
}

/** @param {number} rate */
function paced(rate) {
  if (Math.abs(rate - 1) < 1e-9) return "as fast as it happens";
  const times = (rate > 1 ? rate : 1 / rate).toLocaleString("en", { maximumSignificantDigits: 2 });
  return rate > 1 ? `${times} times as fast as it happens` : `${times} times slower than it happens`;
}

/**
 * @template {keyof HTMLElementTagNameMap} Name
 * @param {Name} name
 * @param {Record<string, string>} attributes
 * @param {(Node | string)[]} children
 */
function make(name, attributes, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

/** The player of one scene. */
class Player {
  #films;
  #place = 0;
  /** @type {Clock} */
  #clock;
  #slow = 1;
  #voice;
  #played = false;
  /** @type {(time: number) => void} */
  #draw = () => {};

  /**
   * @param {HTMLElement} home
   * @param {Film[]} films
   */
  constructor(home, films) {
    this.#films = films;
    this.home = home;
    this.stages = make("div", { class: "stages", role: "group", "aria-label": "Stages" });
    for (const [place, film] of films.entries()) {
      const button = make("button", { type: "button" }, `${film.stage} ${film.kind}`);
      button.addEventListener("click", () => this.open(place));
      this.stages.append(button);
    }
    this.picture = make("figure", { class: "picture" });
    this.playing = this.#button("Play", "main", () => (this.#clock.playing ? this.#stop() : this.#go()));
    const back = this.#button("Back", "", () => this.#move(() => this.#clock.step(-1)), "Back one step");
    const step = this.#button("Step", "", () => this.#move(() => this.#clock.step()));
    const reset = this.#button("Reset", "", () => this.#move(() => this.#clock.reset()));
    this.speed = make("select", {});
    for (const [value, name] of [["1", "full"], ["0.5", "half"], ["0.2", "a fifth"], ["0.1", "a tenth"]]) {
      this.speed.append(make("option", { value: value ?? "" }, name ?? ""));
    }
    this.speed.addEventListener("change", () => {
      this.#slow = Number(this.speed.value);
      this.#rate();
    });
    this.slider = make("input", { type: "range", min: "0", max: String(MARKS), "aria-label": "Time" });
    const set = () => this.#clock.seek((Number(this.slider.value) / MARKS) * this.#clock.end);
    this.slider.addEventListener("input", () => this.#move(set));
    this.now = make("output", { class: "now" });
    this.paced = make("p", { class: "paced" });
    this.notes = make("p", { class: "notes" });
    this.values = make("div", { class: "values scroll", tabindex: "0", role: "region", "aria-label": "Values now" });
    this.said = make("p", { class: "said", "aria-live": "polite" });
    this.#voice = new Announcer(this.said);
    this.plots = make("div", { class: "plots" });
    const controls = make("div", { class: "controls" }, this.playing, back, step, reset, make("label", {}, "Speed ", this.speed));
    const time = make("div", { class: "time" }, this.slider, this.now);
    if (films.length > 1) home.append(this.stages);
    home.append(this.picture, time, controls, this.said, this.paced, this.notes, this.values, this.plots);
    home.hidden = false;
    this.#clock = new Clock({ end: 0, tick: () => {} });
    this.open(0);
  }

  /**
   * @param {string} text
   * @param {string} look
   * @param {() => void} act
   * @param {string} [name]
   */
  #button(text, look, act, name) {
    const button = make("button", { type: "button", class: look, ...(name ? { "aria-label": name } : {}) }, text);
    button.addEventListener("click", act);
    return button;
  }

  /**
   * Shows a stage from its start.
   * @param {number} place
   */
  open(place) {
    const film = this.#films[place];
    const [first, last] = [film?.moments[0], film?.moments[film.moments.length - 1]];
    if (!film || !first || !last) return;
    this.#played = false;
    this.#clock.pause();
    this.#place = place;
    for (const [own, button] of [...this.stages.children].entries()) {
      button.setAttribute("aria-pressed", String(own === place));
    }
    const stage = new Stage(this.picture, film);
    this.notes.textContent = film.notes.join(" ");
    const drawn = plots(film).map((contents) => {
      const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
      const details = make("details", {}, make("summary", {}, "As a table"));
      details.addEventListener("toggle", () => details.childElementCount > 1 || details.append(table(contents)), { once: true });
      this.plots.append(make("div", { class: "plotted" }, svg, details));
      return { svg, contents };
    });
    this.plots.replaceChildren(...[...this.plots.children].slice(-drawn.length));
    const shown = drawn.map(({ svg, contents }) => new Plot(svg, contents));
    const end = last.time - first.time;
    const values = this.#readings(film);
    this.#draw = (time) => {
      const own = first.time + time;
      stage.show(own);
      for (const plot of shown) plot.show(own);
      values(own);
      this.slider.value = String(Math.round((time / end) * MARKS));
      this.now.textContent = `t = ${told(own, 3, end)} s`;
      this.slider.setAttribute("aria-valuetext", `${told(own, 3, end)} s`);
      this.home.dataset.time = String(own);
    };
    this.#clock = new Clock({ end, tick: (time) => this.#tick(time) });
    this.#rate();
    this.home.dataset.film = String(place);
    this.#tick(0);
  }

  /**
   * The values of all bodies as a table that follows the time.
   * @param {Film} film
   */
  #readings(film) {
    const letters = film.directions.map(({ letter }) => letter);
    /** @param {(Node | string)[]} children */
    const head = (...children) => make("th", { scope: "col" }, ...children);
    const row = make("tr", {}, head("body"), head("mass in kg"), ...letters.map((own) => head(`${own} in m`)));
    for (const own of letters) row.append(letters.length > 1 ? head("v", make("sub", {}, own), " in m/s") : head("v in m/s"));
    const body = make("tbody", {});
    /** @type {[HTMLElement, [number, number][], number][]} */
    const cells = [];
    for (const [own, { name: letter, called }] of film.bodies.entries()) {
      const name = make("th", { scope: "row", class: `body-${own % BODIES}` }, make("span", { class: "swatch" }), called);
      const line = make("tr", {}, name);
      /** @type {((moment: Moment) => number)[]} */
      const all = [
        (moment) => moment.masses[own] ?? NaN,
        ...letters.map((_, axis) => (/** @type {Moment} */ moment) => moment.positions[own]?.[axis] ?? NaN),
        ...letters.map((_, axis) => (/** @type {Moment} */ moment) => moment.velocities[own]?.[axis] ?? NaN),
      ];
      if (film.mass_not_told.includes(letter)) {
        all.shift();
        line.append(make("td", {}, "not given"));
      }
      for (const value of all) {
        const points = over(film, value);
        const cell = make("td", {});
        cells.push([cell, points, Math.max(...points.map(([, size]) => Math.abs(size)))]);
        line.append(cell);
      }
      body.append(line);
    }
    this.values.replaceChildren(make("table", {}, make("thead", {}, row), body));
    return (/** @type {number} */ time) => {
      for (const [cell, points, largest] of cells) cell.textContent = told(at(points, time), 4, largest);
    };
  }

  #rate() {
    const rate = pace(this.#clock.end) * this.#slow;
    this.#clock.rate = rate;
    this.paced.textContent = `Shown ${paced(rate)}.`;
  }

  #go() {
    this.#played = true;
    this.#clock.play();
  }

  #stop() {
    this.#move(() => this.#clock.pause());
  }

  /** @param {() => void} act */
  #move(act) {
    this.#played = false;
    act();
  }

  /** @param {number} time */
  #tick(time) {
    const { playing, end } = this.#clock;
    this.#draw(time);
    const ended = time >= end;
    const state = playing ? "playing" : ended ? "ended" : "paused";
    if (this.home.dataset.state !== state) {
      this.home.dataset.state = state;
      this.playing.textContent = playing ? "Pause" : ended ? "Play again" : "Play";
    }
    this.#say(state);
    if (ended && this.#played && this.#place + 1 < this.#films.length) {
      this.open(this.#place + 1);
      if (!matchMedia("(prefers-reduced-motion: reduce)").matches) this.#go();
    }
  }

  /**
   * Says the state aloud, not more often than once a second, and the latest.
   * @param {"playing" | "paused" | "ended"} state
   */
  #say(state) {
    const film = this.#films[this.#place];
    const stage = this.#films.length > 1 ? `Stage ${film?.stage}, ${film?.kind}: ` : "";
    const words = {
      playing: `${stage}playing.`,
      paused: `${stage}paused at ${this.now.textContent}.`,
      ended: `${stage}at its end, ${this.now.textContent}.`,
    };
    this.#voice.say(words[state]);
  }
}

/** @param {HTMLElement} article */
async function play(article) {
  const home = article.querySelector("section.film");
  if (!(home instanceof HTMLElement)) return;
  try {
    const record = await call("simulate", { ...JSON.parse(article.dataset.variant ?? "{}"), together: true });
    new Player(home, record.stages);
  } catch (error) {
    if (!(error instanceof Refused)) throw error;
    home.textContent = error.message;
    home.hidden = false;
  }
}

const articles = [...document.querySelectorAll("article.play")].filter((own) => own instanceof HTMLElement);
Promise.all(articles.map(play)).then(() => {
  document.documentElement.dataset.state = "ready";
});
