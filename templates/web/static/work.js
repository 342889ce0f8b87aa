// @ts-check
// The work of a practice sheet: each line is judged by the engine soon after it is typed.

import { call, Refused } from "./engine.js";

/** How long after the last key the lines are judged, in ms. */
const PAUSE = 500;

/**
 * A line with what is found of it.
 * @param {{ text: string, verdict: string, message: string }} line
 */
function item(line) {
  const item = document.createElement("li");
  item.dataset.verdict = line.verdict;
  const parts = [
    ["written", line.text],
    ["found", line.message],
  ];
  for (const [kind, text] of parts) {
    const part = document.createElement("span");
    part.className = kind;
    part.textContent = text;
    item.append(part, " ");
  }
  return item;
}

/** @param {HTMLFormElement} form */
function live(form) {
  const work = form.elements.namedItem("work");
  const lines = form.querySelector("[data-lines]");
  if (!(work instanceof HTMLTextAreaElement && lines instanceof HTMLElement)) return;
  const variant = JSON.parse(form.dataset.variant ?? "{}");
  /** @type {AbortController | undefined} */
  let asked;
  let timer = 0;
  const judge = async () => {
    asked?.abort();
    asked = new AbortController();
    const decimal = /** @type {HTMLSelectElement} */ (form.elements.namedItem("decimal")).value || "either";
    try {
      const judged = await call("work", { ...variant, work: work.value, decimal }, asked.signal);
      lines.replaceChildren(...judged.lines.map(item));
      lines.dataset.state = "judged";
    } catch (error) {
      if (!(error instanceof Refused || error instanceof DOMException)) throw error;
    }
  };
  work.addEventListener("input", () => {
    lines.dataset.state = "waiting";
    clearTimeout(timer);
    timer = setTimeout(judge, PAUSE);
  });
}

for (const form of document.querySelectorAll("form.answers")) {
  if (form instanceof HTMLFormElement) live(form);
}
