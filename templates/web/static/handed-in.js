// @ts-check
// A sheet of a course: under each field stands how its text is read, what is typed is saved while one goes on, and beside the button
// stands what it hands in.

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
 * Says beside the button which answers of a form are new.
 * @param {HTMLFormElement} form
 */
function say_new(form) {
  const typed = new FormData(form);
  for (const line of form.querySelectorAll("[data-new]")) {
    if (!(line instanceof HTMLElement)) continue;
    const text = String(typed.get(line.dataset.new ?? "") ?? "").trim();
    line.hidden = text === "" || text === line.dataset.handedIn?.trim();
    const shown = line.querySelector("[data-typed]");
    if (shown) shown.textContent = text;
  }
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
    saved.textContent = said ? `Saved, not submitted: ${said.saved}` : "Not saved: the time for answers is over, or the server cannot be reached.";
    saved.dataset.state = said ? "saved" : "lost";
  };
  form.addEventListener("input", () => {
    say_new(form);
    clearTimeout(rest);
    rest = setTimeout(save, REST);
  });
  form.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" || !(event.target instanceof HTMLInputElement)) return;
    // Enter reads and saves, as it does without this script by the first button of the form; it hands in nothing.
    event.preventDefault();
    clearTimeout(rest);
    void save();
  });
  // What a browser fills in when one comes back is new, too.
  say_new(form);
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
