// @ts-check
// What all simulators share: controls, the engine's answer in its places, and time.

import { keep } from "./address.js";
import { Announcer } from "./announcer.js";
import { Bars } from "./bars.js";
import { call, Refused } from "./engine.js";
import { Clock } from "./clock.js";
import { Controls } from "./controls.js";
import { grip } from "./drag.js";
import { Plot, at } from "./plot.js";
import { reach } from "./reach.js";
import { fill_screen } from "./scene.js";
import { table } from "./told.js";

/** @typedef {import("./plot.js").Curve} Curve */
/** @typedef {{ value: number, text: string }} Amount */
/** @typedef {{ what: string, amount: Amount }} Row */
/** @typedef {{ until: number, words: string }} Phase */
/**
 * @typedef {object} Compared
 * @property {string} name
 * @property {string | null} refused
 * @property {Curve[]} places
 * @property {Curve[]} drifts
 */
/**
 * What the engine says to all.
 * @typedef {object} Shown
 * @property {Phase[]} phases
 * @property {number} end
 * @property {Curve[]} places
 * @property {import("./bars.js").Bar[]} bars
 * @property {{ set: [string, string][], solved: { solution: string } | null, reason: string | null }} problem
 * @property {Compared | null} [compared]
 */

/** Milliseconds from the last change to the address: browsers refuse too many addresses. */
const ADDRESSED = 300;

/**
 * What stands at a path such as "bodies.0.after".
 * @param {any} value
 * @param {string} path
 * @returns {any}
 */
function found(value, path) {
  return path.split(".").reduce((inner, key) => inner?.[key], value);
}

/**
 * A number at the present time, with the sign that prose has.
 * @param {number} value
 */
export function told(value) {
  const text = value.toFixed(2);
  return (Number(text) === 0 ? text.replace("-", "") : text).replace("-", "\u2212");
}

/**
 * A row of a table.
 * @param {string} head
 * @param {string[]} cells
 */
export function row(head, cells) {
  const made = document.createElement("tr");
  const first = document.createElement("th");
  first.scope = "row";
  first.textContent = head;
  made.append(first);
  for (const text of cells) made.insertCell().textContent = text;
  return made;
}

/**
 * A plot where the page has a place for it.
 * @param {Element} root
 * @param {string} name
 * @param {Curve[]} curves
 */
export function plotted(root, name, curves) {
  const svg = one(root, `[data-plot="${name}"]`, SVGSVGElement);
  const { title = "", up = "", across = "" } = svg.dataset;
  return new Plot(svg, { title, across, up, curves });
}

/**
 * An element that the page has.
 * @template {Element} Kind
 * @param {ParentNode} root
 * @param {string} selector
 * @param {{ new (): Kind }} kind
 * @returns {Kind}
 */
export function one(root, selector, kind) {
  const element = root.querySelector(selector);
  if (!(element instanceof kind)) throw new Error(`the page has no ${selector}`);
  return element;
}

/**
 * A simulator on its page.
 * @template {Shown} Response
 */
export class Simulator {
  /** @type {Response | undefined} */
  shown;
  #root;
  #controls;
  #own;
  #bars;
  /** @type {(() => void)[]} what tells the grips their values */
  #grips;
  /** @type {Clock | undefined} */
  #clock;
  /** @type {Map<string, Plot>} */
  #plots = new Map();
  #asking = false;
  #again = false;
  #addressed = 0;
  /** @type {Announcer | undefined} what bodies do, aloud */
  #voice;

  /**
   * @param {HTMLElement} root
   * @param {object} own
   * @param {(shown: Response) => void} own.filled writes what this simulator alone has
   * @param {(shown: Response, time: number) => string} own.moved draws a time and says what is the case then
   * @param {(name: string, part: Element) => [number, number]} own.scale by how much a control grows for each unit of the scene to the
   *   right, and downwards
   * @param {(shown: Response) => Record<string, Curve[]>} [own.curves] the curves of the plots that run with the time
   */
  constructor(root, own) {
    this.#root = root;
    this.#own = own;
    this.#controls = new Controls(one(root, "form.controls", HTMLFormElement), () => void this.#ask());
    const home = root.querySelector("[data-bars]");
    this.#bars = home instanceof HTMLElement ? new Bars(home) : undefined;
    this.#grips = [...root.querySelectorAll("[data-grip]")].flatMap((part) => this.#grip(part));
    this.#listen();
    fill_screen(root);
    void this.#ask();
  }

  #listen() {
    for (const button of this.#root.querySelectorAll("button[data-do]")) {
      button.addEventListener("click", () => {
        const clock = this.#clock;
        if (!clock) return;
        const what = button.getAttribute("data-do");
        if (what === "step") clock.step();
        else if (what === "reset") clock.reset();
        else if (clock.playing) clock.pause();
        else clock.play();
      });
    }
    this.#root.querySelector("[data-rate]")?.addEventListener("change", () => this.#rate());
    const time = this.#root.querySelector("input[data-time]");
    time?.addEventListener("input", () => {
      if (time instanceof HTMLInputElement) this.#clock?.seek(Number(time.value));
    });
  }

  /**
   * Makes a part of the scene movable.
   * @param {Element} part
   */
  #grip(part) {
    const name = part.getAttribute("data-grip") ?? "";
    const [control, svg] = [this.#controls.of(name), part.closest("svg")];
    if (!(part instanceof SVGElement && svg && control)) return [];
    const scale = () => this.#own.scale(name, part);
    return [grip({ part, svg, ...control, scale, begin: () => this.#clock?.reset() })];
  }

  /** Draws the present time again. */
  redraw() {
    if (this.#clock) this.#tick(this.#clock.time);
  }

  #rate() {
    const chosen = this.#root.querySelector("select[data-rate]");
    if (this.#clock && chosen instanceof HTMLSelectElement) this.#clock.rate = Number(chosen.value);
  }

  /** Asks for the values of now. While an answer is under way nothing else is asked; the newest values come next. */
  async #ask() {
    if (this.#asking) {
      this.#again = true;
      return;
    }
    this.#asking = true;
    this.#root.dataset.state = "asking";
    do {
      this.#again = false;
      await this.#once(this.#controls.fields());
    } while (this.#again);
    this.#asking = false;
  }

  /** @param {URLSearchParams} fields */
  async #once(fields) {
    const values = Object.fromEntries(
      [...fields].filter(([name]) => name !== "method" && name !== "step").map(([name, text]) => [name, Number(text)]),
    );
    const step = fields.get("step");
    const refused = one(this.#root, "[data-refused]", HTMLElement);
    let state = "shown";
    try {
      this.#controls.refuse_empty(fields);
      const request = { values, method: fields.get("method"), step: step ? Number(step) : null };
      this.#show(await call(this.#root.dataset.simulator ?? "", request));
      refused.hidden = true;
    } catch (error) {
      if (!(error instanceof Refused)) throw error;
      refused.textContent = `${error.message}${error.help ? `: ${error.help}` : ""}.`;
      refused.hidden = false;
      state = "refused";
    }
    if (this.#again) return;
    clearTimeout(this.#addressed);
    this.#addressed = setTimeout(() => keep(`?${fields}`), ADDRESSED);
    this.#root.dataset.shown = String(fields);
    this.#root.dataset.state = state;
  }

  /** @param {Response} shown */
  #show(shown) {
    const root = this.#root;
    // Served without results, the page has no place for them.
    if (!root.querySelector(".results")) return location.reload();
    this.shown = shown;
    for (const place of root.querySelectorAll("[data-show]")) {
      const value = found(shown, place.getAttribute("data-show") ?? "");
      place.textContent = typeof value === "string" ? value : (value?.text ?? "");
    }
    for (const bar of root.querySelectorAll("[data-bar]")) {
      bar.setAttribute("x2", String(found(shown, bar.getAttribute("data-bar") ?? "") ?? 0));
    }
    for (const table of root.querySelectorAll("[data-rows]")) {
      /** @type {Row[]} */
      const rows = found(shown, table.getAttribute("data-rows") ?? "") ?? [];
      table.replaceChildren(...rows.map(({ what, amount }) => row(what, [amount.text])));
    }
    this.#show_method(shown);
    this.#show_problem(shown);
    this.#own.filled(shown);
    reach();
    const wrong = shown.compared?.places ?? [];
    const curves = this.#own.curves?.(shown) ?? { places: [...shown.places, ...wrong] };
    for (const [name, drawn] of Object.entries(curves)) this.#plot(name, drawn);
    this.#ghosts(wrong);
    this.#bars?.set(shown.bars);
    for (const tell of this.#grips) tell();
    this.#restart(shown);
  }

  /** @param {Response} shown */
  #show_method({ compared }) {
    const home = this.#root.querySelector("[data-compared]");
    if (home instanceof HTMLElement) home.hidden = !compared;
    if (!compared) return;
    const refused = one(this.#root, "[data-method-refused]", HTMLElement);
    refused.hidden = !compared.refused;
    refused.textContent = compared.refused ? `It refuses this scene: ${compared.refused}.` : "";
    this.#plot("drifts", compared.drifts);
    const { title = "", up = "", across = "" } = one(this.#root, '[data-plot="drifts"]', SVGSVGElement).dataset;
    one(this.#root, "[data-drifts]", HTMLElement).replaceChildren(table({ title, up, across, curves: compared.drifts }));
  }

  /** @param {Response} shown */
  #show_problem({ problem }) {
    one(this.#root, "[data-solution]", HTMLElement).innerHTML = problem.solved?.solution ?? "";
    one(this.#root, "[data-problem]", HTMLElement).hidden = Boolean(problem.reason);
    one(this.#root, "[data-no-problem]", HTMLElement).hidden = !problem.reason;
    const own = new URLSearchParams(problem.set.map(([name, text]) => [`set.${name}`, text]));
    for (const link of this.#root.querySelectorAll("a[data-with]")) {
      link.setAttribute("href", `${link.getAttribute("data-with")}?${own}`);
    }
  }

  /**
   * @param {string} name
   * @param {Curve[]} curves
   */
  #plot(name, curves) {
    const plot = this.#plots.get(name);
    if (plot) return plot.set(curves);
    this.#plots.set(name, plotted(this.#root, name, curves));
  }

  /**
   * The bodies where the method has them: outlines of those that are there.
   * @param {Curve[]} wrong
   */
  #ghosts(wrong) {
    const ghosts = wrong.flatMap((_, place) => {
      const copy = this.#root.querySelector(`[data-at="${place}"]`)?.cloneNode(true);
      if (!(copy instanceof SVGElement)) return [];
      delete copy.dataset.at;
      copy.dataset.ghost = String(place);
      for (const own of copy.querySelectorAll("text, title, .arrow, .tip")) own.remove();
      for (const own of copy.querySelectorAll("[data-grip]")) {
        for (const { name } of [...own.attributes]) own.removeAttribute(name);
      }
      return [copy];
    });
    this.#root.querySelector("[data-ghosts]")?.replaceChildren(...ghosts);
  }

  /** @param {Response} shown */
  #restart(shown) {
    this.#clock?.pause();
    const time = one(this.#root, "input[data-time]", HTMLInputElement);
    time.max = String(shown.end);
    this.#clock = new Clock({ end: shown.end, tick: (now) => this.#tick(now) });
    this.#rate();
    this.#clock.reset();
  }

  /** @param {number} now */
  #tick(now) {
    const shown = this.shown;
    if (!shown) return;
    const playing = this.#clock?.playing ?? false;
    for (const plot of this.#plots.values()) plot.show(now);
    this.#bars?.show(now);
    const words = shown.phases.find(({ until }) => now <= until)?.words ?? shown.phases.at(-1)?.words ?? "";
    one(this.#root, "[data-state-words]", HTMLElement).textContent = words;
    one(this.#root, "[data-now]", HTMLElement).textContent = this.#own.moved(shown, now);
    const time = one(this.#root, "input[data-time]", HTMLInputElement);
    time.value = String(now);
    time.setAttribute("aria-valuetext", `${told(now)} s`);
    one(this.#root, '[data-do="play"]', HTMLButtonElement).textContent = playing ? "Pause" : "Play";
    this.#root.dataset.playing = String(playing);
    this.#voice ??= new Announcer(one(this.#root, "[data-announced]", HTMLElement));
    this.#voice.say(words);
  }
}

/**
 * Moves what stands for the curves' bodies.
 * @param {Element} root
 * @param {string} selector "at" for the exact ones, "ghost" for those of a method
 * @param {Curve[]} curves
 * @param {number} time
 * @param {(place: number) => string} transform
 */
export function move(root, selector, curves, time, transform) {
  for (const [index, curve] of curves.entries()) {
    const place = at(curve.points, time);
    root.querySelector(`[data-${selector}="${index}"]`)?.setAttribute("transform", transform(place));
  }
}
