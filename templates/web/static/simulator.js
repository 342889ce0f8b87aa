// @ts-check
// What both simulators share: controls, the engine's answer in its places, and time.

import { keep } from "./address.js";
import { Announcer } from "./announcer.js";
import { call, Refused } from "./engine.js";
import { Clock } from "./clock.js";
import { Plot, at } from "./plot.js";
import { reach } from "./reach.js";
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
 * What the engine says to both.
 * @typedef {object} Shown
 * @property {Phase[]} phases
 * @property {number} end
 * @property {[number, number]} track
 * @property {Curve[]} places
 * @property {{ set: [string, string][], solved: { solution: string } | null, reason: string | null }} problem
 * @property {Compared | null} compared
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
  return value.toFixed(2).replace("-", "\u2212");
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
  #form;
  #filled;
  #moved;
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
   * @param {{ filled: (shown: Response) => void, moved: (shown: Response, time: number) => string }} own
   *   `filled` writes what this simulator alone has, `moved` draws a time and says what is the case then
   */
  constructor(root, { filled, moved }) {
    this.#root = root;
    this.#filled = filled;
    this.#moved = moved;
    this.#form = one(root, "form.controls", HTMLFormElement);
    this.#listen();
    void this.#ask();
  }

  #listen() {
    const form = this.#form;
    form.dataset.live = "";
    form.addEventListener("submit", (event) => event.preventDefault());
    form.addEventListener("input", ({ target }) => {
      if (target instanceof HTMLInputElement) this.#pair(target);
      void this.#ask();
    });
    for (const link of form.querySelectorAll("a[data-preset]")) {
      link.addEventListener("click", (event) => {
        event.preventDefault();
        this.#choose(link.getAttribute("data-preset") ?? "");
      });
    }
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

  #rate() {
    const chosen = this.#root.querySelector("select[data-rate]");
    if (this.#clock && chosen instanceof HTMLSelectElement) this.#clock.rate = Number(chosen.value);
  }

  /**
   * A slider follows its number, and a number its slider.
   * @param {HTMLInputElement} moved
   */
  #pair(moved) {
    const slid = moved.dataset.for;
    const other = slid ? this.#form.elements.namedItem(slid) : this.#form.querySelector(`[data-for="${moved.name}"]`);
    if (other instanceof HTMLInputElement) other.value = moved.value;
  }

  /**
   * Sets what a preset says, and everything else as the page opens.
   * @param {string} preset
   */
  #choose(preset) {
    const values = new URLSearchParams(preset);
    for (const slider of this.#form.querySelectorAll("input[data-for]")) {
      if (!(slider instanceof HTMLInputElement)) continue;
      slider.value = values.get(slider.dataset.for ?? "") ?? slider.dataset.usual ?? slider.value;
      this.#pair(slider);
    }
    void this.#ask();
  }

  /** The fields that say something, as they stand in an address. */
  #fields() {
    const fields = new URLSearchParams();
    for (const [name, value] of new FormData(this.#form)) fields.set(name, String(value));
    if (!fields.get("method")) for (const name of ["method", "step"]) fields.delete(name);
    return fields;
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
      await this.#once(this.#fields());
    } while (this.#again);
    this.#asking = false;
  }

  /**
   * An empty field is not the usual value, which nobody typed.
   * @param {URLSearchParams} fields
   */
  #refuse_empty(fields) {
    const empty = [...fields].find(([name, text]) => name !== "method" && text === "")?.[0];
    if (!empty) return;
    const label = this.#form.querySelector(`label[for="${empty}"]`)?.firstChild?.textContent;
    throw new Refused({ kind: "invalid", message: `The field “${label}” holds no number`, help: "type one" });
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
      this.#refuse_empty(fields);
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
    this.#filled(shown);
    reach();
    const wrong = shown.compared?.places ?? [];
    this.#plot("places", [...shown.places, ...wrong]);
    this.#ghosts(wrong);
    this.#restart(shown);
  }

  /** @param {Response} shown */
  #show_method({ compared }) {
    one(this.#root, "[data-compared]", HTMLElement).hidden = !compared;
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
      copy.querySelector("text")?.remove();
      return [copy];
    });
    one(this.#root, "[data-ghosts]", SVGElement).replaceChildren(...ghosts);
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
    const words = shown.phases.find(({ until }) => now <= until)?.words ?? shown.phases.at(-1)?.words ?? "";
    one(this.#root, "[data-state-words]", HTMLElement).textContent = words;
    one(this.#root, "[data-now]", HTMLElement).textContent = this.#moved(shown, now);
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
