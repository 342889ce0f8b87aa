// @ts-check
// A practice sheet: what is typed is read by the engine.

import { keep } from "./address.js";
import { call, Refused } from "./engine.js";
import { read_live } from "./reading.js";

/**
 * @param {HTMLFormElement} form
 */
function live(form) {
  const variant = JSON.parse(form.dataset.variant ?? "{}");
  // Whoever keeps the address keeps the numbers.
  const address = form.dataset.address;
  if (address && !location.search) keep(address);
  read_live(form, async (part, text, signal) => {
    const decimal = /** @type {HTMLSelectElement} */ (form.elements.namedItem("decimal")).value || "either";
    try {
      return await call("read", { ...variant, part, text, decimal }, signal);
    } catch (error) {
      if (error instanceof Refused) return {};
      if (error instanceof DOMException) return undefined;
      throw error;
    }
  });
}

for (const form of document.querySelectorAll("form.answers")) {
  if (form instanceof HTMLFormElement) live(form);
}
document.documentElement.dataset.state = "ready";
