// @ts-check
// Live preview: beside a problem file stands what it makes, whenever its author pauses.

/** How long after the last key the file is read, in ms. */
const PAUSE = 1000;

const button = document.querySelector("button[data-preview]");
const shown = document.querySelector("#preview");
const form = button?.closest("form");
const text = form?.querySelector("textarea");

if (button instanceof HTMLButtonElement && shown && form && text) {
  /** @type {AbortController | undefined} */
  let asked;
  let timer = 0;

  /** Shows what the server makes of the file as it stands. Its faults are part of the page that it sends. */
  const preview = async () => {
    asked?.abort();
    asked = new AbortController();
    shown.setAttribute("aria-busy", "true");
    try {
      const response = await fetch(button.formAction, { method: "POST", body: new FormData(form), signal: asked.signal });
      const page = new DOMParser().parseFromString(await response.text(), "text/html");
      const made = page.querySelector("#preview");
      // A page that says why nothing can be shown has none: what is there stays, and the button shows that page.
      if (made) shown.replaceChildren(...made.childNodes);
    } catch (error) {
      if (error instanceof DOMException && error.name === "AbortError") return;
    }
    shown.removeAttribute("aria-busy");
  };

  text.addEventListener("input", () => {
    clearTimeout(timer);
    timer = window.setTimeout(preview, PAUSE);
  });
}
