// @ts-check
// What is wider than the page scrolls by itself, and can then be reached by keyboard.

/** Makes what scrolls a stop of the tab key, and nothing else. */
export function reach() {
  for (const own of document.querySelectorAll(".equation, .table")) {
    if (own.scrollWidth > own.clientWidth) own.setAttribute("tabindex", "0");
    else own.removeAttribute("tabindex");
  }
}

new ResizeObserver(reach).observe(document.body);
reach();
