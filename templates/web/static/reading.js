// @ts-check
// Live reading: under a field stands how its text is read, before it is marked.

/** How long after the last key an answer is read, in ms. */
const PAUSE = 300;

/**
 * Shows how a text was read: a formula as mathematics, anything else in words, and what was typed as code.
 * @param {HTMLElement} said
 * @param {{ understood?: string, unreadable?: string, math?: string }} reading
 */
function show(said, { understood, unreadable, math }) {
  if (math) {
    const set = document.createElement("template");
    // The engine wrote it, and escaped whatever it holds.
    set.innerHTML = math;
    said.replaceChildren("Read as ", set.content);
  } else if (understood) {
    said.replaceChildren(`Read as ${understood}.`);
  } else {
    said.replaceChildren(...(unreadable ?? "").split("`").map(as_code));
  }
}

/**
 * What stands between backticks, set as code.
 * @param {string} text
 * @param {number} place
 */
function as_code(text, place) {
  if (place % 2 === 0) return text;
  const code = document.createElement("code");
  code.textContent = text;
  return code;
}

/**
 * Shows under each field of a form how its text is read.
 * @param {HTMLFormElement} form
 * @param {(part: string, text: string, signal: AbortSignal) => Promise<{ understood?: string, unreadable?: string, math?: string } | undefined>} ask
 *   nothing where what stands there is to stay
 */
export function read_live(form, ask) {
  for (const field of form.querySelectorAll("input[data-part]:not([readonly])")) {
    if (!(field instanceof HTMLInputElement)) continue;
    const part = field.dataset.part ?? "";
    const said = form.querySelector(`[data-reading="${CSS.escape(part)}"]`);
    if (!(said instanceof HTMLElement)) continue;
    /** @type {AbortController | undefined} */
    let asked;
    let timer = 0;
    const read = async () => {
      asked?.abort();
      asked = new AbortController();
      const reading = await ask(part, field.value, asked.signal);
      if (!reading) return;
      show(said, reading);
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
