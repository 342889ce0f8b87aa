// @ts-check
// The controls of a simulator: numbers with their sliders, presets, and what may be left out.

import { Refused } from "./engine.js";

/** The form with the controls. */
export class Controls {
  #form;
  #changed;

  /**
   * @param {HTMLFormElement} form
   * @param {() => void} changed what happens when a value has
   */
  constructor(form, changed) {
    this.#form = form;
    this.#changed = changed;
    this.#listen();
  }

  /**
   * The number and the slider of a control.
   * @param {string} name
   */
  of(name) {
    const [field, slider] = [this.#form.elements.namedItem(name), this.#form.querySelector(`[data-for="${name}"]`)];
    return field instanceof HTMLInputElement && slider instanceof HTMLInputElement ? { field, slider } : undefined;
  }

  #listen() {
    const form = this.#form;
    form.dataset.live = "";
    form.addEventListener("submit", (event) => event.preventDefault());
    form.addEventListener("input", ({ target }) => {
      if (target instanceof HTMLInputElement) this.#pair(target);
      this.#changed();
    });
    for (const box of form.querySelectorAll("input[data-switch]")) {
      if (!(box instanceof HTMLInputElement)) continue;
      const control = this.of(box.dataset.switch ?? "");
      if (!control) continue;
      this.#switch(control.field.name);
      box.addEventListener("input", (event) => {
        event.stopPropagation();
        control.field.value = box.checked ? control.slider.value : "";
        this.#changed();
      });
    }
    for (const link of form.querySelectorAll("a[data-preset]")) {
      link.addEventListener("click", (event) => {
        event.preventDefault();
        this.#choose(link.getAttribute("data-preset") ?? "");
      });
    }
  }

  /**
   * A slider follows its number, and a number its slider.
   * @param {HTMLInputElement} moved
   */
  #pair(moved) {
    const slid = moved.dataset.for;
    const other = slid ? this.#form.elements.namedItem(slid) : this.#form.querySelector(`[data-for="${moved.name}"]`);
    if (other instanceof HTMLInputElement && moved.value !== "") other.value = moved.value;
    this.#switch(slid ?? moved.name);
  }

  /**
   * The box of a control that may be left out says whether it is.
   * @param {string} name
   */
  #switch(name) {
    const [box, field] = [this.#form.querySelector(`[data-switch="${name}"]`), this.#form.elements.namedItem(name)];
    if (box instanceof HTMLInputElement && field instanceof HTMLInputElement) box.checked = field.value !== "";
  }

  /**
   * Sets what a preset says, and everything else as the page opens.
   * @param {string} preset
   */
  #choose(preset) {
    const values = new URLSearchParams(preset);
    for (const slider of this.#form.querySelectorAll("input[data-for]")) {
      if (!(slider instanceof HTMLInputElement)) continue;
      const name = slider.dataset.for ?? "";
      const field = this.#form.elements.namedItem(name);
      const value = values.get(name) ?? slider.dataset.usual ?? slider.value;
      if (value !== "") slider.value = value;
      if (field instanceof HTMLInputElement) field.value = value === "" ? "" : slider.value;
      this.#switch(name);
    }
    this.#changed();
  }

  /** The fields that say something, as they stand in an address. */
  fields() {
    const fields = new URLSearchParams();
    for (const [name, value] of new FormData(this.#form)) fields.set(name, String(value));
    // A control that may be left out is, where its field is empty.
    for (const field of this.#form.querySelectorAll("input[data-optional]")) {
      if (field instanceof HTMLInputElement && field.value === "") fields.delete(field.name);
    }
    if (!fields.get("method")) for (const name of ["method", "step"]) fields.delete(name);
    return fields;
  }

  /**
   * An empty field is not the usual value, which nobody typed.
   * @param {URLSearchParams} fields
   */
  refuse_empty(fields) {
    const empty = [...fields].find(([name, text]) => name !== "method" && text === "")?.[0];
    if (!empty) return;
    const label = this.#form.querySelector(`label[for="${empty}"]`)?.firstChild?.textContent;
    throw new Refused({ kind: "invalid", message: `The field “${label}” holds no number`, help: "type one" });
  }
}
