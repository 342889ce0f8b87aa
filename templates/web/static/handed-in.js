// @ts-check
// A sheet of a course: under each field stands how its text is read, and what is typed is saved while one goes on.

import { read_live } from "./reading.js";

/** How long after the last key everything is saved, in ms. */
const REST = 2000;

/**
 * Sends fields to an address of the sheet.
 * @param {string} address
 * @param {URLSearchParams} fields
 * @param {AbortSignal} [signal]
 * @returns {Promise<any>} nothing where the server refuses
 */
async function send(address, fields, signal) {
  const response = await fetch(address, { method: "POST", body: fields, signal });
  return response.ok ? response.json() : undefined;
}

/**
 * @param {HTMLFormElement} form
 */
function live(form) {
  const here = form.dataset.here ?? "";
  const saved = form.querySelector("[data-saved]");
  let rest = 0;
  const save = async () => {
    const fields = new URLSearchParams();
    for (const [name, value] of new FormData(form)) if (typeof value === "string") fields.append(name, value);
    fields.set("do", "script");
    const said = await send(`${here}/draft`, fields).catch(() => undefined);
    if (!(saved instanceof HTMLElement)) return;
    saved.textContent = said ? `Saved, not handed in: ${said.saved}` : "Not saved: the server cannot be reached.";
    saved.dataset.state = said ? "saved" : "lost";
  };
  form.addEventListener("input", () => {
    clearTimeout(rest);
    rest = setTimeout(save, REST);
  });
  form.addEventListener("submit", () => clearTimeout(rest));
  read_live(form, (part, text, signal) => {
    const reading = send(`${here}/read`, new URLSearchParams({ part, text }), signal);
    return reading.catch(() => undefined);
  });
}

for (const form of document.querySelectorAll("form.answers")) {
  if (form instanceof HTMLFormElement) live(form);
}
document.documentElement.dataset.state = "ready";
