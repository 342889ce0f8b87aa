// @ts-check
// Parts of a scene that are dragged with the pointer or moved with the arrow keys: each sets a control of the page.

/** How many steps a page key goes. */
const PAGE = 10;

/**
 * @typedef {object} Grip
 * @property {SVGElement} part what is held
 * @property {SVGSVGElement} svg the picture in which it is
 * @property {HTMLInputElement} field the number that it sets
 * @property {HTMLInputElement} slider with its limits and its step
 * @property {() => [number, number]} scale by how much the number grows for each unit of the picture to the right, and downwards
 * @property {() => void} begin what happens when it is taken
 */

/**
 * Makes a part of a picture movable. The result tells it the value of its control.
 * @param {Grip} grip
 */
export function grip({ part, svg, field, slider, scale, begin }) {
  const [min, max, step] = [slider.min, slider.max, slider.step].map(Number);
  const limits = { min: min ?? 0, max: max ?? 1, step: step || 1 };
  part.setAttribute("tabindex", "0");
  part.setAttribute("role", "slider");
  part.setAttribute("aria-valuemin", String(limits.min));
  part.setAttribute("aria-valuemax", String(limits.max));

  /** @param {number} value */
  const set = (value) => {
    const near = limits.step * Math.round(Math.min(Math.max(value, limits.min), limits.max) / limits.step);
    field.value = String(Number(near.toFixed(6)));
    field.dispatchEvent(new Event("input", { bubbles: true }));
  };

  /** @param {PointerEvent} event @param {DOMMatrix} seen */
  const place = (event, seen) => new DOMPoint(event.clientX, event.clientY).matrixTransform(seen);

  part.addEventListener("pointerdown", (event) => {
    const seen = svg.getScreenCTM()?.inverse();
    if (!seen || event.button !== 0) return;
    event.preventDefault();
    part.focus({ preventScroll: true });
    begin();
    part.setPointerCapture(event.pointerId);
    svg.dataset.held = "";
    const [from, first, [across, down]] = [place(event, seen), Number(field.value), scale()];
    const move = (/** @type {PointerEvent} */ event) => {
      const to = place(event, seen);
      set(first + across * (to.x - from.x) + down * (to.y - from.y));
    };
    const leave = () => {
      part.removeEventListener("pointermove", move);
      delete svg.dataset.held;
      // The window follows now.
      field.dispatchEvent(new Event("input", { bubbles: true }));
    };
    part.addEventListener("pointermove", move);
    part.addEventListener("lostpointercapture", leave, { once: true });
  });

  part.addEventListener("keydown", (event) => {
    const value = Number(field.value);
    /** @type {Record<string, number>} */
    const keys = {
      ArrowRight: value + limits.step,
      ArrowUp: value + limits.step,
      ArrowLeft: value - limits.step,
      ArrowDown: value - limits.step,
      PageUp: value + PAGE * limits.step,
      PageDown: value - PAGE * limits.step,
      Home: limits.min,
      End: limits.max,
    };
    const wanted = keys[event.key];
    if (wanted === undefined) return;
    event.preventDefault();
    begin();
    set(wanted);
  });

  return () => {
    part.setAttribute("aria-valuenow", field.value);
    part.setAttribute("aria-valuetext", `${field.value} ${part.getAttribute("data-unit") ?? ""}`.trim());
  };
}
