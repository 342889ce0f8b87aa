// @ts-check
// A sheet of a course: under each field stands how its text is read, and what is typed is saved while one goes on.

/** How long after the last key an answer is read, in ms. */
const PAUSE = 300;
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
  for (const field of form.querySelectorAll("input[data-part]:not([readonly])")) {
    if (!(field instanceof HTMLInputElement)) continue;
    const said = form.querySelector(`[data-reading="${CSS.escape(field.dataset.part ?? "")}"]`);
    if (!(said instanceof HTMLElement)) continue;
    /** @type {AbortController | undefined} */
    let asked;
    let timer = 0;
    const read = async () => {
      asked?.abort();
      asked = new AbortController();
      const fields = new URLSearchParams({ part: field.dataset.part ?? "", text: field.value });
      const reading = await send(`${here}/read`, fields, asked.signal).catch(() => undefined);
      if (!reading) return;
      said.textContent = reading.understood ? `Read as ${reading.understood}.` : (reading.unreadable ?? "");
      said.classList.toggle("unreadable", Boolean(reading.unreadable));
      said.dataset.state = "read";
    };
    field.addEventListener("input", () => {
      said.dataset.state = "waiting";
      clearTimeout(timer);
      timer = setTimeout(read, PAUSE);
    });
  }
}

for (const form of document.querySelectorAll("form.answers")) {
  if (form instanceof HTMLFormElement) live(form);
}
document.documentElement.dataset.state = "ready";
