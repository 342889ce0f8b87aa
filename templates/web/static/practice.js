// @ts-check
// Live reading: under each field stands how its text is read, before it is marked.

import { call, Refused } from "./engine.js";

/** How long after the last key an answer is read, in ms. */
const PAUSE = 300;

/**
 * @param {HTMLFormElement} form
 */
function read_live(form) {
  const variant = JSON.parse(form.dataset.variant ?? "{}");
  for (const field of form.querySelectorAll("input[data-part]")) {
    if (!(field instanceof HTMLInputElement)) continue;
    const said = form.querySelector(`[data-reading="${CSS.escape(field.dataset.part ?? "")}"]`);
    if (!(said instanceof HTMLElement)) continue;
    /** @type {AbortController | undefined} */
    let asked;
    let timer = 0;
    const read = async () => {
      asked?.abort();
      asked = new AbortController();
      const decimal = /** @type {HTMLSelectElement} */ (form.elements.namedItem("decimal")).value || "either";
      const request = { ...variant, part: field.dataset.part, text: field.value, decimal };
      try {
        const { understood, unreadable } = await call("read", request, asked.signal);
        said.textContent = understood ? `Read as ${understood}.` : (unreadable ?? "");
        said.classList.toggle("unreadable", Boolean(unreadable));
        said.dataset.state = "read";
      } catch (error) {
        if (error instanceof Refused) said.textContent = "";
        else if (!(error instanceof DOMException)) throw error;
      }
    };
    field.addEventListener("input", () => {
      said.dataset.state = "waiting";
      clearTimeout(timer);
      timer = setTimeout(read, PAUSE);
    });
  }
}

for (const form of document.querySelectorAll("form.answers")) {
  if (form instanceof HTMLFormElement) read_live(form);
}
document.documentElement.dataset.state = "ready";
